"""The census itself: as many types as published, all of them different."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import combinations

import networkx as nx

from arrangement.arrangement import Arrangement
from arrangement.library.census import PUBLISHED, PUBLISHED_SIMPLE, census
from proofs_check.routes.dual_graph import DualGraph, Edge, Signs, from_covectors
from proofs_check.statements.statement import Case, Claim, Route, exhaustive


def _listed(m: int) -> Iterator[Arrangement]:
    """Yield new arrangements of the census that have rank 3 and m distinct planes."""
    for found in census(m):
        fresh = Arrangement(found.normals)
        if fresh.rank == 3 and len(fresh.distinct) == m:
            yield fresh


def _by_codes(m: int) -> tuple[int, int]:
    """All and simple types, told apart by the smallest code of the dual as a map on the sphere."""
    codes = {}
    for planes in _listed(m):
        graph = from_covectors(planes)
        codes[_code(graph)] = all(len(face) == 4 for face in graph.faces)
    return len(codes), sum(codes.values())


def _by_isomorphism(m: int) -> tuple[int, int]:
    """The same, by tests for isomorphic graphs (networkx) among graphs of equal hash."""
    kept: dict[str, list[tuple[nx.Graph, bool]]] = {}
    for planes in _listed(m):
        graph = nx.Graph([tuple(edge) for edge in _adjacent(planes)])
        nx.set_node_attributes(graph, dict(graph.degree), "degree")
        text = nx.weisfeiler_lehman_graph_hash(graph, node_attr="degree", iterations=4)
        group = kept.setdefault(text, [])
        if not any(nx.is_isomorphic(graph, other) for other, _ in group):
            group.append((graph, planes.is_simple))
    found = [simple for group in kept.values() for _, simple in group]
    return len(found), sum(found)


def _adjacent(planes: Arrangement) -> Iterator[tuple[Signs, Signs]]:
    regions = [face.signs for face in planes.faces(3)]
    for one, other in combinations(regions, 2):
        if sum(a != b for a, b in zip(one, other, strict=True)) == 1:
            yield one, other


#: A vertex, an edge and a face of a map, each on the border of the next.
Flag = tuple[Signs, Edge, int]


def _code(graph: DualGraph) -> tuple[int, ...]:
    """Return a text of a 3-connected planar graph: equal exactly for isomorphic ones.

    Such a graph has one embedding in the sphere up to reflection (Whitney). A flag has three
    neighbours, each with another vertex, edge or face. From one flag on, flags are numbered breadth
    first, and the numbers of all neighbours written down. The smallest text over all starts at
    vertices of the rarest kind is the code.
    """
    flags = _flags(graph)
    index = {flag: k for k, flag in enumerate(flags)}
    near = [[index[other] for other in others] for others in flags.values()]
    kinds = {v: _kind(graph, v) for v in graph.vertices}
    number = Counter(kinds.values())
    rarest = min(number, key=lambda kind: (number[kind], kind))
    return min(_walk(near, k) for (v, _, _), k in index.items() if kinds[v] == rarest)


def _kind(graph: DualGraph, vertex: Signs) -> tuple[int, ...]:
    """The sizes of the faces around a vertex."""
    return tuple(sorted(len(f) for f in graph.faces if any(vertex in edge for edge in f)))


def _flags(graph: DualGraph) -> dict[Flag, tuple[Flag, Flag, Flag]]:
    """Return every flag with its three neighbours."""
    faces_of: dict[Edge, set[int]] = {edge: set() for edge in graph.edges}
    for k, face in enumerate(graph.faces):
        for edge in face:
            faces_of[edge].add(k)
    found = {}
    for k, face in enumerate(graph.faces):
        for edge in face:
            (next_face,) = faces_of[edge] - {k}
            for v in edge:
                (vertex,) = edge - {v}
                (next_edge,) = (e for e in face if v in e and e != edge)
                found[v, edge, k] = ((vertex, edge, k), (v, next_edge, k), (v, edge, next_face))
    return found


def _walk(near: list[list[int]], start: int) -> tuple[int, ...]:
    """Return the code from one flag: for every flag in order the numbers of its neighbours."""
    number, queue = {start: 0}, [start]
    code: list[int] = []
    for here in queue:
        for there in near[here]:
            if there not in number:
                number[there] = len(number)
                queue.append(there)
            code.append(number[there])
    return tuple(code)


CLAIMS = (
    Claim(
        id="census-types",
        formula=r"(t(3), t(4), \ldots, t(7)) = (1, 2, 4, 17, 143)",
        locator="the list of types that other claims run over",
        statement="Up to relabelling and reorientation m distinct planes of rank 3 have 1, 2, 4, "
        "17, 143 types for m = 3, ..., 7 (1, 1, 1, 4, 11 in general position), and the list has "
        "each of them once.",
        hypotheses=("the numbers published by Finschi and Fukuda (2002)",),
        quantity="(different types in the list, simple ones)",
        routes=(
            Route("smallest codes of the duals as maps (covectors)", _by_codes),
            Route("isomorphism tests of networkx (enumerated faces)", _by_isomorphism),
        ),
        judge=lambda m, found: (
            found == (PUBLISHED[m], PUBLISHED_SIMPLE[m]) and len(census(m)) == found[0]
        ),
        sources=exhaustive(
            "the list for m = 3 to 7; a list with as many different types as exist is complete",
            lambda _: (Case(f"m = {m}", m, {"planes_count": m}) for m in range(3, 8)),
        ),
        meaning="Claims that hold on the list hold for every arrangement of that many planes.",
    ),
)
