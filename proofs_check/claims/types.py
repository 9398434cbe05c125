"""The census itself: as many types as published, all of them different."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from itertools import combinations

import networkx as nx

from arrangement.arrangement import Arrangement
from arrangement.library.census import PUBLISHED, PUBLISHED_SIMPLE, census
from proofs_check.routes.dual_graph import DualGraph, Edge, Signs, from_covectors
from proofs_check.statement import Case, Claim, Route, exhaustive


@dataclass(frozen=True)
class Listed:
    """The types that the census lists for a number of planes."""

    planes: int

    def arrangements(self) -> Iterator[Arrangement]:
        """Yield new arrangements of the list that have rank 3 and that many distinct planes."""
        for found in census(self.planes):
            fresh = Arrangement(found.normals)
            if fresh.rank == 3 and len(fresh.distinct) == self.planes:
                yield fresh


def _by_codes(listed: Listed) -> tuple[int, int]:
    """All and simple types, told apart by the smallest code of the dual as a map on the sphere."""
    codes = {}
    for planes in listed.arrangements():
        graph = from_covectors(planes)
        codes[_code(graph)] = all(len(face) == 4 for face in graph.faces)
    return len(codes), sum(codes.values())


def _by_isomorphism(listed: Listed) -> tuple[int, int]:
    """The same, by tests for isomorphic graphs (networkx) among graphs of equal hash."""
    kept: dict[str, list[tuple[nx.Graph, bool]]] = {}
    for planes in listed.arrangements():
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


def _code(graph: DualGraph) -> tuple[int, ...]:
    """Return a text of a 3-connected planar graph: equal exactly for isomorphic ones.

    Such a graph has one embedding in the sphere up to reflection (Whitney). From a directed edge
    and a sense of turning, vertices are numbered breadth first, and every rotation is written down.
    The smallest text over all starts at vertices of the rarest kind is the code.
    """
    turn = _rotations(graph)
    kinds = {v: _kind(graph, v) for v in graph.vertices}
    number: dict[tuple[int, ...], int] = {}
    for kind in kinds.values():
        number[kind] = number.get(kind, 0) + 1
    rarest = min(number, key=lambda kind: (number[kind], kind))
    starts = [(v, w) for v, kind in kinds.items() if kind == rarest for w in turn[v]]
    return min(_walk(turn, v, w, sense) for v, w in starts for sense in (1, -1))


def _kind(graph: DualGraph, vertex: Signs) -> tuple[int, ...]:
    """The sizes of the faces around a vertex."""
    return tuple(sorted(len(f) for f in graph.faces if any(vertex in edge for edge in f)))


def _rotations(graph: DualGraph) -> dict[Signs, list[Signs]]:
    """Return the neighbours of every vertex in their order around it, all in one sense."""
    left = _left_sides(graph)
    turns = {}
    for v in graph.vertices:
        after = {}
        for w in graph.neighbours[v]:
            face = graph.faces[left[v, w]]
            edges: list[Edge] = [e for e in face if v in e and w not in e]
            (other,) = edges[0] - {v}
            after[w] = other
        order = [min(after)]
        while after[order[-1]] != order[0]:
            order.append(after[order[-1]])
        turns[v] = order
    return turns


def _left_sides(graph: DualGraph) -> dict[tuple[Signs, Signs], int]:
    """Return the face on the left of every directed edge, for one orientation of the sphere."""
    faces_of: dict[Edge, list[int]] = {edge: [] for edge in graph.edges}
    for k, face in enumerate(graph.faces):
        for edge in face:
            faces_of[edge].append(k)
    left: dict[tuple[Signs, Signs], int] = {}
    first = next(iter(graph.faces[0]))
    waiting = [(0, tuple(first))]
    done = set()
    while waiting:
        k, (a, b) = waiting.pop()
        if k in done:
            continue
        done.add(k)
        start = (a, b)
        while True:
            left[a, b] = k
            one, other = faces_of[frozenset((a, b))]
            waiting.append((other if one == k else one, (b, a)))
            (c,) = next(e for e in graph.faces[k] if b in e and a not in e) - {b}
            a, b = b, c
            if (a, b) == start:
                break
    return left


def _walk(turn: dict[Signs, list[Signs]], v: Signs, w: Signs, sense: int) -> tuple[int, ...]:
    """Return the code from one start: for every vertex in order the numbers around it."""
    number = {v: 0}
    queue = [(v, w)]
    code: list[int] = []
    for here, first in queue:
        around = turn[here]
        at = around.index(first)
        for k in range(len(around)):
            there = around[(at + sense * k) % len(around)]
            if there not in number:
                number[there] = len(number)
                queue.append((there, here))
            code.append(number[there])
        code.append(-1)
    return tuple(code)


def _cases(counts: range, _rng: random.Random) -> Iterator[Case]:
    for m in counts:
        yield Case(f"m = {m}", Listed(m), {"planes_count": m})


CLAIMS = (
    Claim(
        id="census-types",
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
        judge=lambda listed, found: (
            found == (PUBLISHED[listed.planes], PUBLISHED_SIMPLE[listed.planes])
            and len(census(listed.planes)) == found[0]
        ),
        sources=exhaustive(
            "the list for m = 3 to 7; a list with as many different types as exist is complete",
            partial(_cases, range(3, 8)),
        ),
        meaning="Claims that hold on the list hold for every arrangement of that many planes.",
    ),
)
