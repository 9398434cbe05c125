"""Rivin's criterion, and certificates for both answers that check themselves.

**Theorem** (Rivin). Let G be a planar, 3-connected graph. There is a convex polyhedron with graph
G and all vertices on a sphere if and only if the edges e of G have weights w(e) with

1. ``0 < w(e) < 1/2`` for every edge,
2. ``sum of w(e) over the edges at v = 1`` for every vertex v,
3. ``sum of w(e) over C > 1`` for every minimal cutset C that is not the set of edges at a vertex.

``2 pi w(e)`` is then the exterior dihedral angle at e of an ideal polyhedron of hyperbolic space. A
minimal cutset is the set of all edges between S and its complement, where both span connected
graphs; it is the set of edges at a vertex exactly if S or its complement is one vertex.

Sources: I. Rivin, A characterization of ideal polyhedra in hyperbolic 3-space, Annals of
Mathematics 143 (1996); C. Hodgson, I. Rivin, W. Smith, A characterization of convex hyperbolic
polyhedra and of convex polyhedra inscribed in the sphere, Bulletin of the AMS 27 (1992); in the
form above M. Dillencourt, W. Smith, Graph-theoretical conditions for inscribability and Delaunay
realizability, Discrete Mathematics 161 (1996).

The checks below share no code with the search. They use integers and rationals only.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from typing import TypeAlias

import networkx as nx

from arrangement.errors import ArrangementError, InputError
from arrangement.numbers.linear.rank import cycle_edges

Edge: TypeAlias = tuple[int, int]


@dataclass(frozen=True)
class PolyhedralGraph:
    """A simple graph on 0..n-1, its edges sorted as (smaller, larger).

    By Steinitz' theorem it is the graph of a convex polyhedron exactly if `require_polyhedral`
    passes.
    """

    vertex_count: int
    edges: tuple[Edge, ...]

    @classmethod
    def of(cls, vertex_count: int, edges: Iterable[Iterable[int]]) -> PolyhedralGraph:
        """Return the graph with edges in canonical order; refuse loops and repeated edges."""
        ordered = sorted((min(pair), max(pair)) for pair in (tuple(edge) for edge in edges))
        if len(set(ordered)) < len(ordered) or any(u == v for u, v in ordered):
            raise InputError("the graph has a loop or a repeated edge; it must be simple")
        if any(u < 0 or v >= vertex_count for u, v in ordered):
            raise InputError(f"an edge leaves the vertices 0 to {vertex_count - 1}")
        return cls(vertex_count, tuple(ordered))

    def to_networkx(self) -> nx.Graph:
        """Return the graph as networkx."""
        graph = nx.Graph()
        graph.add_nodes_from(range(self.vertex_count))
        graph.add_edges_from(self.edges)
        return graph

    @cached_property
    def neighbours(self) -> tuple[tuple[int, ...], ...]:
        """For each vertex the vertices next to it."""
        lists: list[list[int]] = [[] for _ in range(self.vertex_count)]
        for u, v in self.edges:
            lists[u].append(v)
            lists[v].append(u)
        return tuple(map(tuple, lists))

    def require_polyhedral(self) -> None:
        """Raise `ArrangementError` unless the graph is planar and 3-connected."""
        if self._not_polyhedral:
            raise ArrangementError(self._not_polyhedral)

    @cached_property
    def _not_polyhedral(self) -> str:
        """Why the graph is not planar or not 3-connected, or ""; a graph is looked at once."""
        graph = self.to_networkx()
        planar, embedding = nx.check_planarity(graph)
        if self.vertex_count < 4 or not planar:
            return "the graph is not planar, or has fewer than 4 vertices"
        if not nx.is_connected(graph):
            return "the graph is not connected"
        # A connected plane graph is 2-connected exactly if no vertex is twice on a face. Around a
        # vertex of a pair that separates such a graph there are two faces that hold both and no
        # edge between them. So it is 3-connected exactly if two faces have at most one vertex, or
        # two with the edge between them, in common.
        face_of: dict[Edge, int] = {}
        faces: list[list[int]] = []
        for u, v in embedding.edges:
            if (u, v) not in face_of:
                around = embedding.traverse_face(u, v)
                face_of.update(dict.fromkeys(cycle_edges(around), len(faces)))
                faces.append(around)
        if any(len(set(around)) < len(around) for around in faces):
            return "the graph is not 2-connected"
        beside: dict[frozenset[int], set[int]] = {
            frozenset((face_of[u, v], face_of[v, u])): {u, v} for u, v in self.edges
        }
        common: dict[frozenset[int], set[int]] = {}
        for v in range(self.vertex_count):
            for pair in combinations([face_of[v, u] for u in self.neighbours[v]], 2):
                common.setdefault(frozenset(pair), set()).add(v)
        for faces_of, shared in common.items():
            if len(shared) > 1 and shared != beside.get(faces_of):
                return f"the graph is not 3-connected: see vertex {min(shared)}"
        return ""


@dataclass(frozen=True)
class WeightCertificate:
    """Weights as in Rivin's theorem: the graph can be inscribed."""

    graph: PolyhedralGraph
    weights: tuple[Fraction, ...]

    inscribable = True
    kind = "weights"

    def verify(self) -> None:
        """Check all conditions; every cutset is covered by maximum flows.

        A cutset of condition 3 has a fixed vertex r on one side, with a neighbour of r, and an edge
        on the other one. Let a neighbour be on the side of r. Where every flow from this side to a
        vertex x with another neighbour of x can exceed 1, x is on this side too; so all are, one
        after another, and no cutset is left. So this neighbour is on the other side, with one of
        its own, and so is the second one; the others are beside r only if some flow to the
        neighbours before is at most 1.

        Raises:
            ArrangementError: the condition that fails.
        """
        self.graph.require_polyhedral()
        if len(self.weights) != len(self.graph.edges):
            raise ArrangementError("there is not one weight for each edge")
        for edge, weight in zip(self.graph.edges, self.weights, strict=True):
            # From 1/2 on the cutset around both ends would weigh at most 1 too.
            if not 0 < weight < Fraction(1, 2):
                raise ArrangementError(f"the weight {weight} of edge {edge} is not inside (0, 1/2)")
        unit = math.lcm(*(Fraction(weight).denominator for weight in self.weights))
        capacity: list[dict[int, int]] = [{} for _ in range(self.graph.vertex_count)]
        for (u, v), weight in zip(self.graph.edges, self.weights, strict=True):
            capacity[u][v] = capacity[v][u] = int(weight * unit)
        for v, around in enumerate(capacity):
            if sum(around.values()) != unit:
                raise ArrangementError(f"the weights at vertex {v} do not sum to 1")
        root = min(range(len(capacity)), key=lambda v: len(capacity[v]))
        first, *others = capacity[root]
        inside = {root, first}
        # Breadth first: what comes later is close to the vertices inside.
        for x in [v for _, v in nx.bfs_edges(self.graph.to_networkx(), root)]:
            if x != first:
                for y in capacity[x].keys() - inside:
                    self._require_flow(capacity, {x, y}, frozenset(inside), unit)
                inside.add(x)
        beyond = {first}
        for neighbour in others:
            here = frozenset((root, neighbour))
            more = capacity[first].keys() - here if len(beyond) == 1 else {first}
            for y in more:
                self._require_flow(capacity, beyond | {y}, here, unit)
            beyond.add(neighbour)

    def _require_flow(
        self, capacity: list[dict[int, int]], ends: set[int], others: frozenset[int], unit: int
    ) -> None:
        if not _flow_exceeds(capacity, ends, others, unit):
            raise ArrangementError(
                f"a cutset between vertices {sorted(ends)} and {sorted(others)} weighs at most 1"
            )


@dataclass(frozen=True)
class FarkasCertificate:
    """Multipliers that make the conditions of Rivin's theorem contradict: no polyhedron exists.

    With ``y`` for the vertices (any sign) and ``a, b, c >= 0`` for edges and cutsets, the sum

    ``sum_v y_v (w(at v) - 1) + sum_e a_e w(e) + sum_e b_e (1/2 - w(e)) + sum_S c_S (w(S) - 1)``

    has no term in w left and a constant <= 0. Conditions 1 to 3 make it positive (or zero if
    a, b and c are all zero; then the constant must be negative).

    Attributes:
        graph: the graph.
        vertex_multipliers: y, one for each vertex.
        lower_multipliers: a, for some edges.
        upper_multipliers: b, for some edges.
        cuts: pairs (S, c_S).
    """

    graph: PolyhedralGraph
    vertex_multipliers: tuple[Fraction, ...]
    lower_multipliers: Mapping[Edge, Fraction]
    upper_multipliers: Mapping[Edge, Fraction]
    cuts: tuple[tuple[frozenset[int], Fraction], ...]

    inscribable = False
    kind = "Farkas"

    def verify(self) -> None:
        """Check signs, cutsets and the identity.

        Raises:
            ArrangementError: what fails.
        """
        graph = self.graph
        graph.require_polyhedral()
        if len(self.vertex_multipliers) != graph.vertex_count:
            raise ArrangementError("there is not one multiplier for each vertex")
        if not {*self.lower_multipliers, *self.upper_multipliers}.issubset(graph.edges):
            raise ArrangementError("a multiplier belongs to no edge")
        for side, _ in self.cuts:
            self._check_cut(side)
        bounds = [*self.lower_multipliers.values(), *self.upper_multipliers.values()]
        positive = [*bounds, *(c for _, c in self.cuts)]
        if any(x < 0 for x in positive):
            raise ArrangementError("a multiplier of an inequality is negative")
        y = self.vertex_multipliers
        for u, v in graph.edges:
            term = y[u] + y[v] + self.lower_multipliers.get((u, v), Fraction(0))
            term -= self.upper_multipliers.get((u, v), Fraction(0))
            term += sum(c for side, c in self.cuts if (u in side) != (v in side))
            if term:
                raise ArrangementError(f"a multiple {term} of the weight of {(u, v)} remains")
        constant = -sum(y) + sum(self.upper_multipliers.values()) / Fraction(2)
        constant -= sum(c for _, c in self.cuts)
        if constant > 0 or (constant == 0 and not any(positive)):
            raise ArrangementError(f"the constant {constant} contradicts nothing")

    def _check_cut(self, side: frozenset[int]) -> None:
        """Both sides of a cutset have two vertices or more, and are connected."""
        network = self.graph.to_networkx()
        sides = side, frozenset(network) - side
        if not side.issubset(network) or min(map(len, sides)) < 2:
            raise ArrangementError("a cutset is that of a single vertex, or none")
        if not all(nx.is_connected(network.subgraph(part)) for part in sides):
            raise ArrangementError("a cutset is not minimal")


@dataclass(frozen=True)
class IndependentSetCertificate:
    """More than half of the vertices, no two of them adjacent: no inscribed polyhedron exists.

    Condition 2 summed over these vertices gives their number, for no edge is counted twice. All
    weights together are V/2, which is less. For a bipartite graph with unequal sides the larger
    side will do (Steinitz' argument; see B. Gruenbaum, Convex polytopes, section 13.5).
    """

    graph: PolyhedralGraph
    vertices: frozenset[int]

    inscribable = False
    kind = "parity"

    def verify(self) -> None:
        """Check that the set is independent and has more than half of the vertices.

        Raises:
            ArrangementError: what fails.
        """
        self.graph.require_polyhedral()
        if not self.vertices.issubset(range(self.graph.vertex_count)):
            raise ArrangementError("the set has vertices that the graph lacks")
        for u, v in self.graph.edges:
            if u in self.vertices and v in self.vertices:
                raise ArrangementError(f"the set has both ends of edge {(u, v)}")
        if 2 * len(self.vertices) <= self.graph.vertex_count:
            raise ArrangementError("the set has at most half of the vertices")


Certificate: TypeAlias = WeightCertificate | FarkasCertificate | IndependentSetCertificate


def _flow_exceeds(
    capacity: list[dict[int, int]], sources: set[int], sinks: frozenset[int], bound: int
) -> bool:
    """Whether a flow between two sets of vertices can exceed `bound` (shortest paths first)."""
    value = sum(room for u in sources for v, room in capacity[u].items() if v in sinks)
    residual: dict[int, dict[int, int]] = {
        u: {v: room for v, room in capacity[u].items() if v not in sinks} for u in sources
    }

    def leaving(u: int) -> dict[int, int]:
        if u not in residual:
            residual[u] = dict(capacity[u])
        return residual[u]

    while value <= bound:
        path = _augmenting_path(leaving, sources, sinks)
        if not path:
            return False
        amount = min(residual[u][v] for u, v in path)
        for u, v in path:
            residual[u][v] -= amount
            if v not in sinks:
                leaving(v)[u] += amount
        value += amount
    return True


def _augmenting_path(
    leaving: Callable[[int], dict[int, int]], sources: set[int], sinks: frozenset[int]
) -> list[Edge]:
    """Return the steps of a shortest path with room left, or none."""
    parent = {source: source for source in sources}
    queue = deque(sources)
    while queue:
        u = queue.popleft()
        for v, room in leaving(u).items():
            if room and v not in parent:
                parent[v] = u
                queue.append(v)
                if v in sinks:
                    path = []
                    while parent[v] != v:
                        path.append((parent[v], v))
                        v = parent[v]
                    return path
    return []
