"""The dual graph of four planes in general position, and its two classes of vertices."""

import networkx as nx
from _flat import flat
from matplotlib.figure import Figure

from arrangement import dual_polyhedron, read_arrangement
from arrangement.draw.output import save_figure


def make():
    dual = dual_polyhedron(read_arrangement("four-generic-planes"))
    graph = dual.graph()
    places = flat(graph, list(dual.faces[0]))
    classes = nx.bipartite.color(graph)
    many = {node for node in graph if classes[node] == (sum(classes.values()) > 7)}
    figure = Figure(figsize=(3.5, 3.5))
    axes = figure.add_axes((0, 0, 1, 1))
    for edge in graph.edges:
        axes.plot(*places[list(edge)].T, color="black", lw=0.8, zorder=1)
    for node, place in enumerate(places):
        fill = "black" if node in many else "white"
        axes.plot(*place, "o", ms=6, mfc=fill, mec="black", zorder=2)
    axes.set(xlim=(-0.8, 0.8), ylim=(-0.8, 0.8), aspect="equal")
    axes.set_axis_off()
    return figure


save_figure("two-classes.svg", make)
