"""The dual of four planes: parallel edges cross one plane, a shortest path each of them once."""

from itertools import pairwise

import networkx as nx
import numpy as np
from _plane import dot, label, panels, save

from arrangement import read_arrangement

COLOURS = ("#0072b2", "#d55e00", "#00735a", "#aa4499")
EYE = np.array([0.42, -0.25, 0.87])


def make():
    dual = read_arrangement("cube-diagonals").dual()
    signs = np.array(dual.signs)
    points = np.array([[float(x) for x in vertex] for vertex in dual.vertices])
    eye = EYE / np.linalg.norm(EYE)
    across = np.cross([0.1, 1, 0], eye)
    across /= np.linalg.norm(across)
    flat = points @ np.stack([across, np.cross(eye, across)], axis=1) / 2.6
    graph = dual.graph()
    front = [set(face) for face in dual.faces if points[list(face)].sum(axis=0) @ eye > 0]
    seen = graph.edge_subgraph([e for e in graph.edges if any(set(e) <= face for face in front)])
    (start, end), *_ = (
        (a, b) for a in seen for b in seen if a < b and (signs[a] == -signs[b]).all()
    )
    path = nx.shortest_path(seen, start, end)
    on_path = {frozenset(edge) for edge in pairwise(path)}
    figure, (axes,) = panels([(-1.85, 1.85, -1.75, 1.75)], scale=24)
    for a, b in graph.edges:
        (plane,) = np.flatnonzero(signs[a] != signs[b])
        bold = frozenset((a, b)) in on_path
        style = {"lw": 3.2 if bold else 1.3, "zorder": 5 if bold else 3}
        if not seen.has_edge(a, b):
            style |= {"lw": 0.7, "ls": (0, (2, 3)), "zorder": 2}
        axes.plot(*flat[[a, b]].T, color=COLOURS[plane], **style)
    for n in seen:
        x, y = flat[n]
        dot(axes, x, y, size=16 if n in path else 8)
        text = "".join("0+−"[s] for s in signs[n])
        far = np.hypot(x, y)
        place = (x + 0.15, y - 0.27)
        if far > 1.1:
            place = (x * (1 + 0.24 / far), y * (1 + 0.14 / far))
        label(axes, *place, text, fontsize=6.5)
    return figure


save("partial-cube.svg", make)
