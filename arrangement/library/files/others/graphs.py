"""Graphs of an arrangement as DOT and GraphML, and its dual polyhedron as OFF; written only.

The dual graph has the regions with their signs, and the planes between them on its edges; the
intersection lattice has the flats with their planes, and edges upwards. The dual polyhedron has
integer vertices, which OFF holds exactly.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from arrangement import counts
from arrangement.arrangement import Arrangement
from arrangement.numbers import budget
from arrangement.numbers.exact import sign_text

if TYPE_CHECKING:
    import networkx as nx


def dual(arrangement: Arrangement) -> nx.Graph[int]:
    """Return the dual graph with its labels."""
    import networkx as nx

    regions = arrangement.region_graph()
    number = {region: k for k, region in enumerate(regions)}
    graph: nx.Graph[int] = nx.Graph()
    for region, k in number.items():
        graph.add_node(k, label=sign_text(region.signs))
    for one, other, planes in regions.edges(data="planes"):
        graph.add_edge(number[one], number[other], label=" ".join(map(str, planes)))
    return graph


def lattice(arrangement: Arrangement) -> nx.Graph[int]:
    """Return the intersection lattice with its labels."""
    import networkx as nx

    flats = counts.intersection_lattice(arrangement)
    arrows = sum(len(above) for covers in flats.covers for above in covers)
    budget.check_cost(
        f"a graph of {arrows:,} covers of flats", "draw fewer planes", bytes=700 * arrows
    )
    graph: nx.DiGraph[int] = nx.DiGraph()
    first = 0
    for level, covers in zip(flats.flats, flats.covers, strict=True):
        for k, flat in enumerate(level):
            planes = " ".join(map(str, flat.planes))
            graph.add_node(first + k, label=planes, rank=flat.rank)
        for k, above in enumerate(covers):
            graph.add_edges_from((first + k, first + len(level) + j) for j in above)
        first += len(level)
    return graph


def dot(graph: nx.Graph[int]) -> str:
    """Write a graph for Graphviz."""
    kind, edge = ("digraph", "->") if graph.is_directed() else ("graph", "--")
    parts = [(str(k), data) for k, data in graph.nodes(data=True)]
    parts += [(f"{j} {edge} {k}", data) for j, k, data in graph.edges(data=True)]
    labels = (f' [label="{data["label"]}"]' if "label" in data else "" for _, data in parts)
    lines = [f"  {part}{label};" for (part, _), label in zip(parts, labels, strict=True)]
    return f"{kind} {{\n" + "\n".join(lines) + "\n}\n"


def graphml(graph: nx.Graph[int]) -> str:
    """Write a graph as GraphML."""
    import networkx as nx

    return '<?xml version="1.0" encoding="UTF-8"?>\n' + "\n".join(nx.generate_graphml(graph)) + "\n"


def off(arrangement: Arrangement) -> str:
    """Write the dual polyhedron."""
    from arrangement.duals.zonohedron import dual_polyhedron

    polyhedron = dual_polyhedron(arrangement)
    vertices, edges, faces = polyhedron.f_vector
    rows = [*polyhedron.integer_vertices, *((len(face), *face) for face in polyhedron.faces)]
    lines = ["OFF", f"{vertices} {faces} {edges}", *(" ".join(map(str, row)) for row in rows)]
    return "\n".join(lines) + "\n"
