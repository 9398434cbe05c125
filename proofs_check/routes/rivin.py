"""Certificates on inscribed polyhedra, checked afresh on the graph of the covectors.

Rivin's criterion, for a planar 3-connected graph: it is that of a convex polyhedron with all
vertices on a sphere exactly when its edges have weights, each strictly between 0 and 1/2, that sum
to 1 around every vertex and to more than 1 over every cycle of the planar dual that is not a face
of it. Source: I. Rivin, Annals of Mathematics 143 (1996).

The planar dual of the graph of regions is the arrangement itself: its vertices are rays, and the
cycle around a region is the face of that region. Here cycles are listed outright, up to the weight
1 that is in question. The checker in `arrangement.duals.inscribed` uses flows instead.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from heapq import heappop, heappush

from .dual_graph import DualGraph, Edge, Signs, distances, is_sphere, is_three_connected


def is_polyhedral(graph: DualGraph) -> bool:
    """Return whether the graph is planar, by its faces, and 3-connected."""
    return is_sphere(graph) and is_three_connected(graph)


def weights_fit(graph: DualGraph, weights: Mapping[Edge, Fraction]) -> bool:
    """Return whether weights satisfy the criterion."""
    if set(weights) != graph.edges or not all(0 < w < Fraction(1, 2) for w in weights.values()):
        return False
    around = {v: frozenset(e for e in graph.edges if v in e) for v in graph.vertices}
    if any(sum(weights[edge] for edge in star) != 1 for star in around.values()):
        return False
    stars = set(around.values())
    return all(cycle in stars for cycle in _light_cycles(graph, weights))


def multipliers_fit(
    graph: DualGraph,
    at_vertices: Mapping[Signs, Fraction],
    below: Mapping[Edge, Fraction],
    above: Mapping[Edge, Fraction],
    cuts: list[tuple[frozenset[Signs], Fraction]],
) -> bool:
    """Return whether multipliers make the conditions on weights w contradict.

    ``sum y_v (w(v) - 1) + sum a_e w_e + sum b_e (1/2 - w_e) + sum c_S (w(S) - 1)`` must have no w
    left and a negative constant, or 0 with a positive multiplier of a strict inequality.
    """
    strict = [*below.values(), *above.values(), *(c for _, c in cuts)]
    if any(x < 0 for x in strict) or not all(_is_cut(graph, side) for side, _ in cuts):
        return False
    rest = {edge: sum((at_vertices[v] for v in edge), Fraction(0)) for edge in graph.edges}
    for edge in rest:
        rest[edge] += below.get(edge, Fraction(0)) - above.get(edge, Fraction(0))
        rest[edge] += sum((c for side, c in cuts if len(edge & side) == 1), Fraction(0))
    constant = sum(above.values(), Fraction(0)) / 2 - sum(at_vertices.values(), Fraction(0))
    constant -= sum((c for _, c in cuts), Fraction(0))
    known = set(below) | set(above) <= graph.edges
    return known and not any(rest.values()) and (constant < 0 or (constant == 0 and any(strict)))


def is_large_independent_set(graph: DualGraph, chosen: frozenset[Signs]) -> bool:
    """Return whether over half of the vertices are given, and no edge joins two of them.

    Then no weights exist: around these vertices they sum to their number, and in all to V / 2.
    """
    independent = not any(edge <= chosen for edge in graph.edges)
    return chosen <= graph.vertices and independent and 2 * len(chosen) > len(graph.vertices)


def _is_cut(graph: DualGraph, side: frozenset[Signs]) -> bool:
    """Return whether both sides are connected and have two vertices or more."""
    other = graph.vertices - side
    parts = ((side, other), (other, side))
    return side <= graph.vertices and all(
        len(part) > 1 and len(distances(graph, next(iter(part)), rest)) == len(part)
        for part, rest in parts
    )


@dataclass(frozen=True)
class _Step:
    """From one ray to another across an edge; `weight` is a whole number."""

    to: int
    edge: Edge
    weight: int


def _light_cycles(graph: DualGraph, weights: Mapping[Edge, Fraction]) -> Iterator[frozenset[Edge]]:
    """Yield the simple cycles of the planar dual whose weight is at most 1, as sets of edges.

    Each is found from its first edge. A way is given up when even the shortest return is too long.
    """
    unit = math.lcm(*(weight.denominator for weight in weights.values()))
    ends: dict[Edge, list[int]] = {edge: [] for edge in graph.edges}
    for k, face in enumerate(graph.faces):
        for edge in face:
            ends[edge].append(k)
    steps: list[list[_Step]] = [[] for _ in graph.faces]
    for edge in sorted(graph.edges, key=sorted):
        a, b = ends[edge]
        back = _shortest(steps, a)
        whole = int(weights[edge] * unit)
        yield from _ways(steps, back, [b], [edge], a, unit - whole)
        steps[a].append(_Step(b, edge, whole))
        steps[b].append(_Step(a, edge, whole))


def _ways(
    steps: list[list[_Step]],
    back: dict[int, int],
    rays: list[int],
    edges: list[Edge],
    end: int,
    left: int,
) -> Iterator[frozenset[Edge]]:
    """Continue a simple way to its end over the steps known so far, with `left` to spend."""
    if rays[-1] == end:
        yield frozenset(edges)
        return
    for step in steps[rays[-1]]:
        if step.to not in rays and step.weight + back.get(step.to, left + 1) <= left:
            ahead = left - step.weight
            yield from _ways(steps, back, [*rays, step.to], [*edges, step.edge], end, ahead)


def _shortest(steps: list[list[_Step]], start: int) -> dict[int, int]:
    """Return the smallest weight of a way to each ray that is reached (Dijkstra)."""
    distance: dict[int, int] = {}
    waiting = [(0, start)]
    while waiting:
        length, here = heappop(waiting)
        if here not in distance:
            distance[here] = length
            for step in steps[here]:
                heappush(waiting, (length + step.weight, step.to))
    return distance
