"""Arrangements of graphs, signed or not; a graph comes from networkx, as pairs, or as text.

Pairs such as (1, 2) are edges; the vertices are those that they name, in order. In text an edge is
what vanishes on its plane: ``1-2`` is x_1 - x_2 = 0. In a signed graph ``1+2`` is x_1 + x_2 = 0 and
a vertex alone, ``1``, is x_1 = 0. Commas separate edges; the vertices are 1, 2, ..., up to the
largest number. Coordinates are in the order of the vertices, planes of the edges.
"""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterable
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from arrangement.arrangement import Arrangement
from arrangement.console.options.signature import Syntax
from arrangement.errors import InputError
from arrangement.numbers.arguments import entries, is_listed
from arrangement.numbers.exact import shown

if TYPE_CHECKING:
    import networkx as nx

    Graph: TypeAlias = nx.Graph | str | Iterable[tuple[Any, Any]]
else:  # networkx takes time to import
    Graph = Annotated[Any, Syntax(metavar="EDGES")]

_EDGE = re.compile(r"([1-9][0-9]{0,2})(?:([-+])([1-9][0-9]{0,2}))?", re.ASCII)


def graphical(graph: Graph) -> Arrangement:
    """Return x_u = x_v for every edge uv of a graph, coordinates and planes in the graph's order.

    Args:
        graph: edges such as 1-2,2-3; in a signed graph also 1+2 and 1.

    Known counts: chi is the chromatic polynomial; as many regions as acyclic orientations.
    Parallel edges give coincident planes.
    Source: C. Greene, T. Zaslavsky, Trans. AMS 280 (1983); R. Stanley, Discrete Mathematics 5
    (1973).

    Raises:
        InputError: for a directed graph, a loop, a graph without vertices, or text that is none.

    >>> graphical("1-2,2-3").integer_planes
    ((1, -1, 0, 0), (0, 1, -1, 0))
    >>> graphical([(1, 2), (2, 3), (3, 1)]).region_count()
    6
    """
    normals, dimension = edge_differences(graph)
    return Arrangement(normals, dimension=dimension)


def bigraphical(graph: Graph) -> Arrangement:
    """Return x_u - x_v = a and x_v - x_u = b for every edge uv of a graph, all a and b generic.

    They are different powers of two, one for each plane, so that no signed sum of them vanishes.
    With a = b = 1 the planes are those of `semiorder`, with 1 and 0 those of `shi`.

    Args:
        graph: edges such as 1-2,2-3; in a signed graph also 1+2 and 1.

    Known counts: for a connected graph on n vertices with Tutte polynomial T, 2^(n-1) T(3/2, 1)
    regions and chi(t) = (-2)^(n-1) t T(1 - t/2, 1); any a and b give at most as many regions.
    Source: S. Hopkins, D. Perkinson, Transactions of the American Mathematical Society 368 (2016).

    >>> bigraphical("1-2,2-3,3-4,1-4").f_vector[-1]
    65
    """
    normals, dimension = edge_differences(graph)
    both = [[sign * x for x in row] for row in normals for sign in (1, -1)]
    return Arrangement(both, [2**k for k in range(len(both))], dimension=dimension)


def signed_graphical(graph: Graph) -> Arrangement:
    """Return x_u = s x_v for every edge uv of sign s, and x_u = 0 for every loop or half-edge.

    In a graph of networkx the sign is the attribute ``sign`` of the edge, 1 if there is none.

    Args:
        graph: edges such as 1-2,2-3; in a signed graph also 1+2 and 1.

    Known counts: chi is the chromatic polynomial of the signed graph. All edges of both signs on n
    vertices and k half-edges, between D_n and B_n: 2^(n-1) (n-1)! (n + k) regions and
    chi(t) = (t - 1)(t - 3) ... (t - 2n + 3)(t - n - k + 1).
    Source: T. Zaslavsky, American Mathematical Monthly 88 (1981); Discrete Mathematics 39 (1982).

    Raises:
        InputError: for a directed graph, a sign that is not 1 or -1, a graph without vertices, or
            text that is none.

    >>> signed_graphical("1-2,1+2,1").f_vector[-1]
    6
    """
    checked = _check_edges(graph)
    place = {node: i for i, node in enumerate(checked.nodes)}
    normals = []
    for tail, head, sign in checked.edges(data="sign", default=1):
        if sign not in (1, -1):
            raise InputError(f"the edge {tail!r}, {head!r} has the sign {sign!r}; give 1 or -1")
        row = [0] * len(place)
        row[place[head]] = -sign
        row[place[tail]] = 1
        normals.append(row)
    return Arrangement(normals, dimension=len(place))


def edge_differences(graph: Graph) -> tuple[list[list[int]], int]:
    """Return e_u - e_v for every edge uv, u the earlier vertex, and the number of vertices."""
    checked = _check_edges(graph)
    place = {node: i for i, node in enumerate(checked.nodes)}
    normals = []
    for edge in checked.edges():
        tail, head = sorted(map(place.__getitem__, edge))
        if tail == head:
            raise InputError(
                f"the graph has a loop at {edge[0]!r}, which gives no plane; remove it"
            )
        normals.append([int(k == tail) - int(k == head) for k in range(len(place))])
    if any(sign == -1 for *_, sign in checked.edges(data="sign")):
        raise InputError("the graph has negative edges; use signed_graphical, or leave them out")
    return normals, len(place)


def _check_edges(graph: Graph) -> nx.Graph:
    read: Any = _read(graph) if isinstance(graph, str) else graph
    if is_listed(graph) and not hasattr(graph, "edges"):
        read = _of_pairs(entries(graph, "graph", "edges"))
    if not (hasattr(read, "is_directed") and hasattr(read, "edges")) or isinstance(read, type):
        raise InputError(
            f"the graph is {shown(graph)}; give a graph of networkx, edges such as [(1, 2), "
            "(2, 3)], or a text such as 1-2,2-3"
        )
    if read.is_directed():
        raise InputError("the graph is directed; give graph.to_undirected()")
    if not len(read):
        raise InputError("the graph has no vertices; give at least one")
    return read


def _of_pairs(edges: tuple[Any, ...]) -> nx.Graph:
    """Return the graph of edges as pairs of vertices."""
    import networkx as nx

    pairs = [entries(edge, f"graph[{i}]", "two vertices") for i, edge in enumerate(edges)]
    for i, pair in enumerate(pairs):
        if len(pair) != 2 or not all(isinstance(node, Hashable) for node in pair):
            raise InputError(f"graph[{i}] is {shown(edges[i])}; give two vertices, such as (1, 2)")
    multigraph = nx.MultiGraph()
    nodes = dict.fromkeys(node for pair in pairs for node in pair)
    try:
        multigraph.add_nodes_from(sorted(nodes))
    except TypeError:  # they have no order
        multigraph.add_nodes_from(nodes)
    multigraph.add_edges_from(pairs)
    return multigraph


def _read(text: str) -> nx.Graph:
    """Read the edges of a graph, as the head of this module says."""
    import networkx as nx

    edges = [_EDGE.fullmatch(word.strip()) for word in text.split(",")]
    multigraph = nx.MultiGraph()
    for edge in edges:
        if edge is None:
            raise InputError(
                f"the graph is {shown(text)}; write its edges as 1-2,2-3 for x1 = x2 and x2 = x3, "
                "and in a signed graph 1+2 for x1 = -x2 and 1 for x1 = 0"
            )
    multigraph.add_nodes_from(
        range(1, 1 + max(int(x) for e in edges if e for x in e.group(1, 3) if x))
    )
    for edge in edges:
        if edge:
            multigraph.add_edge(
                int(edge[1]), int(edge[3] or edge[1]), sign=-1 if edge[2] == "+" else 1
            )
    return multigraph
