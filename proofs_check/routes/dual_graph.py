"""The dual graph of an arrangement, from given sign vectors, and from covectors.

Vertices are regions, edges are facets, faces are rays (of a rank 3 arrangement). The first
builder takes the faces that an engine found; the second composes cocircuits read off the
chirotope. The graph functions of this module are its own, so that they can stand against networkx.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

from arrangement import counts
from arrangement.planes.planes import Planes

Signs = tuple[int, ...]
Edge = frozenset[Signs]


@dataclass(frozen=True)
class DualGraph:
    """Regions, the pairs of them on both sides of a facet, and the boundary of each ray.

    Attributes:
        vertices: sign vectors of the regions.
        edges: the two regions beside each facet.
        faces: for each covector of the lowest level above the origin, the edges around it.
    """

    vertices: frozenset[Signs]
    edges: frozenset[Edge]
    faces: tuple[frozenset[Edge], ...]

    @cached_property
    def neighbours(self) -> dict[Signs, set[Signs]]:
        """The adjacent regions of every region."""
        nearest: dict[Signs, set[Signs]] = {vertex: set() for vertex in self.vertices}
        for edge in self.edges:
            a, b = edge
            nearest[a].add(b)
            nearest[b].add(a)
        return nearest


def from_signs(regions: list[Signs], facets: list[Signs], lines: list[Signs]) -> DualGraph:
    """Return the dual graph of the faces of R^3 with these sign vectors."""
    lines_below = _flags(lines, facets)
    edges = {f: frozenset(beside) for f, beside in _flags(facets, regions).items()}
    around = tuple(frozenset(edges[f] for f in above) for above in lines_below.values())
    return DualGraph(frozenset(regions), frozenset(edges.values()), around)


def from_covectors(planes: Planes) -> DualGraph:
    """Return the dual graph from the covectors, whose ranks are read off their zero sets."""
    vectors = counts.covectors(planes)
    levels: dict[int, list[Signs]] = {0: [], 1: [], 2: [], 3: []}
    for signs in vectors:
        zero = [planes.integer_planes[i][:-1] for i, s in enumerate(signs) if s == 0]
        levels[_rank(zero)].append(signs)
    return from_signs(levels[0], levels[1], levels[2])


def _flags(small: list[Signs], large: list[Signs]) -> dict[Signs, list[Signs]]:
    """Return for each covector those that it is a face of: equal wherever it is not zero."""
    larger = [(_bits(signs), signs) for signs in large]
    return {s: [signs for b, signs in larger if not a & ~b] for s in small for a in [_bits(s)]}


def _bits(signs: Signs) -> int:
    """Return a number with a bit for each plane that the covector is above, and one for below."""
    return sum(1 << 2 * k + (sign < 0) for k, sign in enumerate(signs) if sign)


def _rank(vectors: list[tuple[int, ...]]) -> int:
    """Return the rank of vectors in Z^3 by cross products and one triple product."""
    first = next((v for v in vectors if any(v)), None)
    if first is None:
        return 0
    cross = next((c for c in (_cross(first, v) for v in vectors) if any(c)), None)
    if cross is None:
        return 1
    return 3 if any(sum(a * b for a, b in zip(cross, v, strict=True)) for v in vectors) else 2


def _cross(u: tuple[int, ...], v: tuple[int, ...]) -> tuple[int, ...]:
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def distances(graph: DualGraph, start: Signs, removed: Iterable[Signs] = ()) -> dict[Signs, int]:
    """Return the number of edges on a shortest way from one region to each that is reached."""
    neighbours = graph.neighbours
    distance, length = {start: 0}, 0
    level, closed = {start}, {start, *removed}
    while level:
        length += 1
        level = set[Signs]().union(*(neighbours[here] for here in level)) - closed
        closed |= level
        distance |= dict.fromkeys(level, length)
    return distance


def is_sphere(graph: DualGraph) -> bool:
    """Return whether the faces close up to a sphere; then the graph is planar.

    Every edge in exactly two faces, the faces around every vertex in one cycle, every face one
    cycle, the graph connected, and V - E + F = 2.
    """
    incident: dict[Edge, list[int]] = {edge: [] for edge in graph.edges}
    for k, face in enumerate(graph.faces):
        for edge in face:
            incident[edge].append(k)
    if not graph.vertices or any(len(faces) != 2 for faces in incident.values()):
        return False
    if len(distances(graph, next(iter(graph.vertices)))) < len(graph.vertices):
        return False
    around_faces = all(_is_cycle([tuple(edge) for edge in face]) for face in graph.faces)
    around_vertices = all(
        _is_cycle([tuple(incident[edge]) for edge in graph.edges if vertex in edge])
        for vertex in graph.vertices
    )
    euler = len(graph.vertices) - len(graph.edges) + len(graph.faces)
    return around_faces and around_vertices and euler == 2


def _is_cycle(pairs: list[tuple[object, ...]]) -> bool:
    """Return whether pairs, taken as edges, form one single cycle."""
    neighbours: dict[object, list[object]] = {}
    for a, b in pairs:
        neighbours.setdefault(a, []).append(b)
        neighbours.setdefault(b, []).append(a)
    if not pairs or any(len(ends) != 2 for ends in neighbours.values()):
        return False
    start = next(iter(neighbours))
    previous, here, steps = start, neighbours[start][0], 1
    while here != start:
        one, other = neighbours[here]
        previous, here = here, (other if one == previous else one)
        steps += 1
    return steps == len(neighbours)


def is_three_connected(graph: DualGraph) -> bool:
    """Return whether the graph has over three vertices and no two of them separate it.

    Without any one vertex the rest must be connected and have no cut vertex. O(V E).
    """
    if len(graph.vertices) < 4:
        return False
    return not any(_has_cut_vertex(graph, vertex) for vertex in graph.vertices)


def _has_cut_vertex(graph: DualGraph, removed: Signs) -> bool:
    """Return whether the graph without one vertex is not connected, or one more cuts it.

    Depth first from some vertex, with the earliest vertex reached from below each one.
    Source: R. Tarjan, SIAM Journal on Computing 1 (1972).
    """
    start = next(vertex for vertex in graph.vertices if vertex != removed)
    number, low = {start: 0}, {start: 0}
    path = [(start, iter(graph.neighbours[start] - {removed}))]
    branches = 0
    while path:
        here, ahead = path[-1]
        there = next(ahead, None)
        if there is None:
            path.pop()
            if path:
                above = path[-1][0]
                low[above] = min(low[above], low[here])
                branches += above == start
                if above != start and low[here] >= number[above]:
                    return True
        elif there in number:
            low[here] = min(low[here], number[there])
        else:
            number[there] = low[there] = len(number)
            path.append((there, iter(graph.neighbours[there] - {removed})))
    return branches > 1 or len(number) < len(graph.vertices) - 1


def minimum_cycle_lengths(graph: DualGraph) -> tuple[int, ...]:
    """Return the sorted lengths of the cycles of a minimum cycle basis, by Horton's algorithm.

    Candidates: for a vertex v and an edge xy, a shortest way v to x, the edge, and a shortest way
    back. Shortest candidates that are independent modulo 2 form a minimum basis.
    Source: J. Horton, SIAM Journal on Computing 16 (1987).
    """
    index = {edge: 1 << k for k, edge in enumerate(sorted(graph.edges, key=sorted))}
    candidates: set[tuple[int, int]] = set()
    for vertex in graph.vertices:
        ways = _shortest_ways(graph, vertex, index)
        for edge, bit in index.items():
            a, b = edge
            if a in ways and b in ways:
                cycle = ways[a] ^ ways[b] ^ bit
                candidates.add((cycle.bit_count(), cycle))
    pivots: dict[int, int] = {}
    lengths = []
    for length, cycle in sorted(candidates):
        rest = cycle
        while rest and rest.bit_length() in pivots:
            rest ^= pivots[rest.bit_length()]
        if rest:
            pivots[rest.bit_length()] = rest
            lengths.append(length)
    return tuple(lengths)


def _shortest_ways(graph: DualGraph, start: Signs, index: dict[Edge, int]) -> dict[Signs, int]:
    """Return one shortest way to every vertex, as a set of edges."""
    neighbours = graph.neighbours
    ways = {start: 0}
    waiting = deque([start])
    while waiting:
        here = waiting.popleft()
        for there in sorted(neighbours[here]):
            if there not in ways:
                ways[there] = ways[here] | index[frozenset((here, there))]
                waiting.append(there)
    return ways
