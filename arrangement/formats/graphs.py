"""Graphs of an arrangement as DOT and GraphML, and its dual polyhedron as OFF; written only.

The dual graph has the regions with their signs, and the planes between them on its edges; the
intersection lattice has the flats with their planes, and edges upwards. The dual polyhedron has
integer vertices, which OFF holds exactly.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from arrangement import counts
from arrangement.arrangement import Arrangement

from .form import Format

if TYPE_CHECKING:
    import networkx as nx

_SYMBOLS = {1: "+", 0: "0", -1: "-"}


def _dual(arrangement: Arrangement) -> nx.Graph[int]:
    import networkx as nx

    regions = arrangement.region_graph()
    number = {region: k for k, region in enumerate(regions)}
    graph: nx.Graph[int] = nx.Graph()
    for region, k in number.items():
        graph.add_node(k, label="".join(_SYMBOLS[sign] for sign in region.signs))
    for one, other, planes in regions.edges(data="planes"):
        graph.add_edge(number[one], number[other], label=" ".join(map(str, planes)))
    return graph


def _lattice(arrangement: Arrangement) -> nx.Graph[int]:
    import networkx as nx

    lattice = counts.intersection_lattice(arrangement)
    graph: nx.DiGraph[int] = nx.DiGraph()
    first = 0
    for level, covers in zip(lattice.flats, lattice.covers, strict=True):
        for k, flat in enumerate(level):
            planes = " ".join(map(str, flat.planes))
            graph.add_node(first + k, label=planes, rank=flat.rank)
        for k, above in enumerate(covers):
            graph.add_edges_from((first + k, first + len(level) + j) for j in above)
        first += len(level)
    return graph


def _dot(graph: nx.Graph[int]) -> str:
    kind, edge = ("digraph", "->") if graph.is_directed() else ("graph", "--")
    lines = [f"  {k}{_attributes(data)};" for k, data in graph.nodes(data=True)]
    lines += [f"  {j} {edge} {k}{_attributes(data)};" for j, k, data in graph.edges(data=True)]
    return f"{kind} {{\n" + "\n".join(lines) + "\n}\n"


def _attributes(data: dict[str, object]) -> str:
    """Return what DOT says of a node or an edge; ranks are for GraphML."""
    return f' [label="{data["label"]}"]' if "label" in data else ""


def _graphml(graph: nx.Graph[int]) -> str:
    import networkx as nx

    return '<?xml version="1.0" encoding="UTF-8"?>\n' + "\n".join(nx.generate_graphml(graph)) + "\n"


def _off(arrangement: Arrangement) -> str:
    from arrangement.polyhedra.dual import dual_polyhedron

    dual = dual_polyhedron(arrangement)
    vertices, edges, faces = dual.f_vector
    rows = [*dual.integer_vertices, *((len(face), *face) for face in dual.faces)]
    lines = ["OFF", f"{vertices} {faces} {edges}", *(" ".join(map(str, row)) for row in rows)]
    return "\n".join(lines) + "\n"


def _writer(
    graph: Callable[[Arrangement], nx.Graph[int]], text: Callable[[nx.Graph[int]], str]
) -> Callable[[Arrangement], str]:
    return lambda arrangement: text(graph(arrangement))


_LOST = "the planes themselves; it cannot be read back"
FORMATS = (
    Format("off", "the dual polyhedron, exact", (".off",), write=_off, loses=lambda _: _LOST),
    *(
        Format(name, what, endings, write=_writer(graph, text), loses=lambda _: _LOST)
        for name, what, endings, graph, text in (
            ("dot", "the dual graph for Graphviz", (".dot", ".gv"), _dual, _dot),
            ("graphml", "the dual graph", (".graphml",), _dual, _graphml),
            ("lattice-dot", "the intersection lattice for Graphviz", (), _lattice, _dot),
            ("lattice-graphml", "the intersection lattice", (), _lattice, _graphml),
        )
    ),
)
