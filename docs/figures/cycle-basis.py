"""The minimum cycle basis of a cube, one cycle in each panel, and its symmetric sum."""

import networkx as nx
import numpy as np
from matplotlib.figure import Figure

from arrangement import read_arrangement
from arrangement.drawing.output import save_figure
from arrangement.enumeration.paper_steps import published_enumeration

BLUE, VERMILION, GREY = "#0072b2", "#d55e00", "#767676"


def flat(graph, ring, turn=np.pi / 4):
    """Tutte's drawing: a face as a regular polygon, all else in the middle of its neighbours.

    Nodes are 0, ..., n - 1; `ring` lists those of the outer face in cyclic order.
    """
    places = np.zeros((len(graph), 2))
    angles = turn + 2 * np.pi * np.arange(len(ring)) / len(ring)
    places[ring] = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    inner = [node for node in graph if node not in ring]
    laplacian = nx.laplacian_matrix(graph, nodelist=range(len(graph))).toarray().astype(float)
    pull = -laplacian[np.ix_(inner, ring)] @ places[ring]
    places[inner] = np.linalg.solve(laplacian[np.ix_(inner, inner)], pull)
    return places


def text(signs):
    return "".join("0+−"[s] for s in signs)


def panel(axes, enumeration, places, number, size):
    cycle = enumeration.cycles[number]
    last = number == len(enumeration.cycles) - 1
    if not last:
        corners = nx.find_cycle(nx.Graph(cycle))
        axes.fill(*places[[a for a, _ in corners]].T, color="#b9dfd3", lw=0)
    for edge in enumeration.graph.edges:
        bold = tuple(sorted(edge)) in cycle
        colour = (VERMILION if last else BLUE) if bold else GREY
        axes.plot(*places[list(edge)].T, color=colour, lw=2.2 if bold else 0.7, zorder=2 + bold)
    axes.plot(*places.T, "o", color="black", ms=2.5, zorder=4)
    name = "symmetric sum" if last else f"cycle {number + 1}"
    axes.set_title(f"{name}: {text(enumeration.lines[number])}", size=size, pad=size / 2)
    axes.set(xlim=(-0.85, 0.85), ylim=(-0.85, 0.85), aspect="equal")
    axes.set_axis_off()


def make(size=7, inches=(5.4, 3.9)):
    enumeration = published_enumeration(read_arrangement("three-generic-planes"))
    outer = [region for region, _ in nx.find_cycle(nx.Graph(enumeration.cycles[-1]))]
    places = flat(enumeration.graph, outer)
    figure = Figure(figsize=inches)
    for number, axes in enumerate(figure.subplots(2, 3).flat):
        panel(axes, enumeration, places, number, size)
    figure.subplots_adjust(0.01, 0.01, 0.99, 0.93, wspace=0.05, hspace=0.2)
    return figure


save_figure("cycle-basis.svg", make)
save_figure("cycle-basis-slide.svg", lambda: make(18, (11.8, 5)))
