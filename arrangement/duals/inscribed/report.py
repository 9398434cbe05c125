"""Decide whether a polyhedron is inscribable: a search in floats, and an answer with its evidence.

The search maximises t with ``t <= w(e) <= 1/2 - t``, ``w(at v) = 1`` and ``w(C) >= 1 + t`` for the
cutsets found so far, by linear programs with cutting planes. If t > 0 and no other cutset is
violated, weights are rounded to an exact solution; if t <= 0, the dual solution is rounded to a
Farkas certificate. If rounding fails, the rows in question go to
`arrangement.numbers.linear.programs`. Whatever comes out has passed its own `verify`.

The formally verified checker can check the evidence too. Its theorems are about linear conditions:
given weights satisfy them, or no real weights do. That these conditions decide inscribability is
Rivin's theorem. It is not proved there, and neither is that the graph is planar and 3-connected.
"""

from __future__ import annotations

import heapq
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any, TypeAlias

import networkx as nx
import numpy as np

from arrangement.console.number_form import ReprMixin
from arrangement.counts import region_count
from arrangement.duals.inscribed.certificates import (
    Certificate,
    Edge,
    FarkasCertificate,
    IndependentSetCertificate,
    PolyhedralGraph,
    WeightCertificate,
)
from arrangement.duals.inscribed.hull import sphere_points
from arrangement.duals.zonohedron import DualPolyhedron, dual_polyhedron
from arrangement.errors import ArrangementError, extra
from arrangement.numbers.budget import spend
from arrangement.numbers.exact import RationalVector, to_text
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.programs import Optimal, minimize
from arrangement.numbers.linear.rank import cycle_edges
from arrangement.planes.planes import Planes
from arrangement.planes.proved import ask_proved

Side: TypeAlias = frozenset[int]
_TOLERANCE = 1e-9
#: Below this margin the answer is taken to be "no", and must then be proved.
_MARGIN = 1e-7
_DENOMINATORS = (6, 60, 2520, 1 << 16, 1 << 26, 1 << 36)


class DualDistances:
    """Light cutsets of a plane graph, as short cycles of its dual.

    A minimal cutset of a plane graph is a cycle of its dual graph. A cycle through the dual of
    edge uv is not a vertex star exactly if it leaves out another edge at u and another one at v. So
    the lightest cutset through uv is a shortest path between the two faces of uv, with uv and
    these two edges closed, for every choice of the two.
    """

    def __init__(self, graph: PolyhedralGraph) -> None:
        self.graph = graph
        self.index = {edge: e for e, edge in enumerate(graph.edges)}
        _, embedding = nx.check_planarity(graph.to_networkx())
        face_of: dict[Edge, int] = {}
        faces = 0
        for half_edge in embedding.edges:
            if half_edge not in face_of:
                face = embedding.traverse_face(*half_edge)
                face_of.update(dict.fromkeys(cycle_edges(face), faces))
                faces += 1
        self.sides = [(face_of[u, v], face_of[v, u]) for u, v in graph.edges]
        self.across: dict[int, list[tuple[int, int]]] = {}
        for e, (left, right) in enumerate(self.sides):
            self.across.setdefault(left, []).append((e, right))
            self.across.setdefault(right, []).append((e, left))

    def light_cuts(self, weights: Sequence[float], bound: float) -> Iterator[Side]:
        """Yield cutsets of condition 3 that weigh less than the bound (weights >= 0)."""
        lengths = [max(float(w), 0.0) for w in weights]
        self.least = self._distances(lengths)
        for e, (u, v) in enumerate(self.graph.edges):
            spend(50 * len(self.graph.neighbours[u]) * len(self.graph.neighbours[v]))
            for at_u in self._others(u, v):
                for at_v in self._others(v, u):
                    path = self._path(e, {e, at_u, at_v}, lengths, bound - lengths[e])
                    if path:
                        yield self._side(u, {e, *path})

    def _distances(self, lengths: Sequence[float]) -> list[list[float]]:
        """Return the least weight of ways between two faces, with all edges open."""
        with extra("search"):
            from scipy.sparse import csr_array
            from scipy.sparse.csgraph import dijkstra

        left, right = np.array(self.sides, np.int32).T  # scipy 1.14 takes no other indices
        shape = (len(self.across), len(self.across))
        # Without a length there would be no edge.
        table = csr_array((np.maximum(lengths, _TOLERANCE / 1000), (left, right)), shape=shape)
        distances: list[list[float]] = dijkstra(table, directed=False).tolist()
        return distances

    def _others(self, u: int, v: int) -> list[int]:
        return [self.index[min(u, x), max(u, x)] for x in self.graph.neighbours[u] if x != v]

    def _path(self, e: int, closed: set[int], lengths: list[float], bound: float) -> list[int]:
        """Return the edges crossed by a shortest way round edge e, if shorter than the bound."""
        start, goal = self.sides[e]
        least = self.least[goal]
        queue: list[tuple[float, int, int, int]] = [(0.0, start, -1, -1)]
        reached: dict[int, tuple[int, int]] = {}
        while queue:
            distance, face, crossed, before = heapq.heappop(queue)
            if face in reached:
                continue
            reached[face] = (crossed, before)
            if face == goal:
                path = []
                while reached[face][0] >= 0:
                    crossed, face = reached[face]
                    path.append(crossed)
                return path
            for edge, beyond in self.across[face]:
                if edge not in closed and beyond not in reached:
                    total = distance + lengths[edge]
                    if total + least[beyond] < bound:
                        heapq.heappush(queue, (total, beyond, edge, face))
        return []

    def _side(self, start: int, cut: set[int]) -> Side:
        """Return the vertices that `start` reaches without crossing the cutset, or the others.

        The side without vertex 0 stands for both.
        """
        part, stack = {start}, [start]
        while stack:
            u = stack.pop()
            for v in self.graph.neighbours[u]:
                if v not in part and self.index[min(u, v), max(u, v)] not in cut:
                    part.add(v)
                    stack.append(v)
        return frozenset(range(self.graph.vertex_count)) - part if 0 in part else frozenset(part)


@lru_cache(maxsize=64)
def decide(graph: PolyhedralGraph) -> Certificate:
    """Decide whether a polyhedral graph can be inscribed in a sphere; return a verified proof.

    Raises:
        ArrangementError: the graph is not planar and 3-connected, or (never seen) the search found
            neither weights nor a contradiction.

    Complexity: polynomial; one linear program for each round of cuts, E + 1 variables, and about
    E deg^2 bounded shortest-path searches to find cuts.
    """
    graph.require_polyhedral()
    network = graph.to_networkx()
    if nx.is_bipartite(network):
        larger = max(nx.bipartite.sets(network), key=len)
        if 2 * len(larger) > graph.vertex_count:
            certificate = IndependentSetCertificate(graph, frozenset(larger))
            certificate.verify()
            return certificate
    return _MarginProgram(graph).certificate()  # what it returns is verified


@dataclass(frozen=True, slots=True)
class _Optimum:
    """An optimum: weights, margin t, and multipliers in the order of `_MarginProgram.rows`."""

    weights: Floats
    margin: float
    multipliers: Floats
    vertex_multipliers: Floats


class _MarginProgram:
    """The linear program of one graph, with the cutsets found so far."""

    def __init__(self, graph: PolyhedralGraph) -> None:
        self.graph = graph
        self.cuts: list[Side] = []
        self.dual = DualDistances(graph)

    def certificate(self) -> Certificate:
        while True:
            solution = self.solve()
            if solution.margin <= _MARGIN:
                return self.refutation(solution)
            new = set(
                self.dual.light_cuts(solution.weights.tolist(), 1 + solution.margin - _TOLERANCE)
            )
            if not new - set(self.cuts):
                return self.weights(solution)
            self.cuts += sorted(new - set(self.cuts), key=sorted)

    def rows(self) -> list[tuple[dict[int, int], Fraction]]:
        """Return the inequalities ``row . w + constant >= t``: lower and upper bounds, cutsets."""
        count = len(self.graph.edges)
        lower = [({e: 1}, Fraction(0)) for e in range(count)]
        upper = [({e: -1}, Fraction(1, 2)) for e in range(count)]
        cuts = [
            (
                {e: 1 for e, (u, v) in enumerate(self.graph.edges) if (u in side) != (v in side)},
                Fraction(-1),
            )
            for side in self.cuts
        ]
        return [*lower, *upper, *cuts]

    def solve(self) -> _Optimum:
        """Maximise t in floating point."""
        with extra("search"):
            from scipy.optimize import linprog
            from scipy.sparse import csr_array

        rows, edges = self.rows(), self.graph.edges
        entries = [(i, e, -x) for i, (row, _) in enumerate(rows) for e, x in row.items()]
        entries += [(i, len(edges), 1) for i in range(len(rows))]
        spend(50 * len(entries))
        i, j, x = (np.array(column) for column in zip(*entries, strict=True))
        shape = (len(rows), len(edges) + 1)
        ends = [(v, e) for e, edge in enumerate(edges) for v in edge]
        vertex, edge = (np.array(column) for column in zip(*ends, strict=True))
        count = self.graph.vertex_count
        answer = linprog(
            [0.0] * len(edges) + [-1.0],
            csr_array((x.astype(float), (i, j)), shape=shape),
            [float(constant) for _, constant in rows],
            csr_array((np.ones(len(ends)), (vertex, edge)), shape=(count, len(edges) + 1)),
            [1.0] * count,
            [(None, None)] * len(edges) + [(None, 1.0)],
            method="highs-ds",
        )
        if answer.status != 0:
            raise ArrangementError(f"the float linear program ended with: {answer.message}")
        return _Optimum(
            answer.x[:-1], float(answer.x[-1]), -answer.ineqlin.marginals, -answer.eqlin.marginals
        )

    def weights(self, solution: _Optimum) -> WeightCertificate:
        """Round to weights that sum to 1 at every vertex exactly; take the first that verify."""
        for denominator in _DENOMINATORS:
            rounded = [Fraction(round(w * denominator), denominator) for w in solution.weights]
            exact = _balance(self.graph, rounded)
            if exact is not None and all(0 < w < Fraction(1, 2) for w in exact):
                certificate = WeightCertificate(self.graph, exact)
                try:
                    certificate.verify()
                except ArrangementError:
                    continue
                return certificate
        raise ArrangementError("the weights found are too close to the boundary to be rounded")

    def refutation(self, solution: _Optimum) -> FarkasCertificate:
        """Round the multipliers; if that fails, solve the rows in use exactly, then all rows."""
        for limit in (12, 100, 10**4, 10**6):
            multipliers = [Fraction(x).limit_denominator(limit) for x in solution.multipliers]
            vertices = [Fraction(x).limit_denominator(limit) for x in solution.vertex_multipliers]
            certificate = self.farkas(multipliers, vertices)
            if _verify(certificate):
                return certificate
        used = [i for i, x in enumerate(solution.multipliers) if x > _TOLERANCE]
        for chosen in (used, range(len(solution.multipliers))):
            multipliers, vertices = self.exact_multipliers(list(chosen))
            certificate = self.farkas(multipliers, vertices)
            if _verify(certificate):
                return certificate
        raise ArrangementError("the margin is positive but too small; no certificate was found")

    def farkas(self, multipliers: list[Fraction], vertices: list[Fraction]) -> FarkasCertificate:
        edges = self.graph.edges
        count = len(edges)
        positive = {i: x for i, x in enumerate(multipliers) if x}
        return FarkasCertificate(
            self.graph,
            tuple(vertices),
            {edges[i]: x for i, x in positive.items() if i < count},
            {edges[i - count]: x for i, x in positive.items() if count <= i < 2 * count},
            tuple((self.cuts[i - 2 * count], x) for i, x in positive.items() if i >= 2 * count),
        )

    def exact_multipliers(self, chosen: list[int]) -> tuple[list[Fraction], list[Fraction]]:
        """Maximise t over some of the rows exactly; an unbounded t gives zeros."""
        rows, count = self.rows(), len(self.graph.edges)
        inequalities: list[list[Fraction | int]] = []
        for i in chosen:
            row, constant = rows[i]
            inequalities.append([*(row.get(e, 0) for e in range(count)), -1, constant])
        equalities = [
            [*(int(v in edge) for edge in self.graph.edges), 0, -1]
            for v in range(self.graph.vertex_count)
        ]
        answer = minimize([0] * count + [-1], inequalities, equalities)
        multipliers = [Fraction(0)] * len(rows)
        if not isinstance(answer, Optimal):
            return multipliers, [Fraction(0)] * self.graph.vertex_count
        for i, x in zip(chosen, answer.inequality_multipliers, strict=True):
            multipliers[i] = x
        return multipliers, list(answer.equality_multipliers)


def _verify(certificate: FarkasCertificate) -> bool:
    try:
        certificate.verify()
    except ArrangementError:
        return False
    return True


def _balance(graph: PolyhedralGraph, weights: list[Fraction]) -> tuple[Fraction, ...] | None:
    """Change the weights of a spanning tree so that every vertex has sum 1, exactly.

    The tree is peeled from its leaves. A defect that remains at the root is split by an edge that
    closes an odd cycle, if there is one: adding x to it adds 2x or -2x to the defect.
    """
    index = {edge: e for e, edge in enumerate(graph.edges)}
    tree = list(nx.bfs_edges(graph.to_networkx(), 0))
    parent = {v: u for u, v in tree}
    depth = {0: 0}
    for u, v in tree:
        depth[v] = depth[u] + 1

    def peel() -> Fraction:
        missing = [Fraction(1)] * graph.vertex_count
        for e, (u, v) in enumerate(graph.edges):
            if parent.get(u) != v and parent.get(v) != u:
                missing[u] -= weights[e]
                missing[v] -= weights[e]
        for _, v in reversed(tree):
            u = parent[v]
            weights[index[min(u, v), max(u, v)]] = missing[v]
            missing[u] -= missing[v]
        return missing[0]

    defect = peel()
    if defect:
        odd = (e for e, (u, v) in enumerate(graph.edges) if (depth[u] - depth[v]) % 2 == 0)
        e = next(odd, None)
        if e is None:
            return None
        weights[e] += defect / 2 * (1 if depth[graph.edges[e][0]] % 2 == 0 else -1)
        if peel():
            return None
    return tuple(weights)


@dataclass(frozen=True, repr=False)
class Inscribability(ReprMixin):
    """Whether some convex polyhedron inscribed in a sphere has the graph of the dual; with proof.

    Attributes:
        arrangement: the planes.
        points: an exact point inside each region; region v is vertex v of the graph.
        certificate: weights, a Farkas certificate, or an independent set (see `certificates`).
    """

    arrangement: Planes
    points: tuple[RationalVector, ...]
    certificate: Certificate

    @property
    def inscribable(self) -> bool:
        """The answer."""
        return self.certificate.inscribable

    def __bool__(self) -> bool:
        return self.inscribable

    def verify(self, *, proved: bool = False) -> None:
        """Check that the graph is the adjacency graph of all regions, and then the certificate.

        The signs of the points show that the regions are distinct; their number, compared with
        Zaslavsky's theorem, that none is missing. Two regions are adjacent exactly if their signs
        differ in one class of coincident planes.

        Args:
            proved: let the program that is proved in Coq check the linear conditions, too.

        Raises:
            ArrangementError: what fails.
            InputError: `proved`, and the program is not built.
        """
        regions = {self.arrangement.signs_at(point): v for v, point in enumerate(self.points)}
        if any(0 in signs for signs in regions) or len(regions) < len(self.points):
            raise ArrangementError("a point is on a plane, or two points are in one region")
        if len(regions) != region_count(self.arrangement):
            raise ArrangementError("there is not one point for each region")
        edges = []
        for signs, v in regions.items():
            for members in self.arrangement.distinct:
                across = tuple(-s if i in members else s for i, s in enumerate(signs))
                if across in regions and v < regions[across]:
                    edges.append((v, regions[across]))
        if PolyhedralGraph.of(len(regions), edges) != self.certificate.graph:
            raise ArrangementError("the certificate is about another graph")
        self.certificate.verify()
        if proved and not proved_conditions(self.certificate):
            raise ArrangementError("the verified program refuses the certificate")


def inscribability(arrangement: Planes | DualPolyhedron) -> Inscribability:
    """Decide whether the dual's graph is that of a convex polyhedron inscribed in a sphere.

    "No" refutes the claim that points of the unit sphere can be chosen in the regions so that
    the dual with these vertices is convex. "Yes" gives an inscribed polyhedron with this graph; it
    says nothing about its vertices being in the regions (see `representative_hull`).

    Args:
        arrangement: central in R^3, of rank 3; or its dual polyhedron.

    Raises:
        InputError: another dimension or rank, or an affine arrangement.

    Complexity: see `decide`. Measured on two cores: 0.2 s for
    7 generic planes, 6 s for 15, 27 s for 21.
    Source: see `certificates`; the claim is [HaasHeger2018], section IV.A.

    >>> from arrangement import Arrangement
    >>> answer = inscribability(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]))
    >>> answer.inscribable, answer.certificate.kind
    (False, 'parity')
    """
    dual = arrangement if isinstance(arrangement, DualPolyhedron) else dual_polyhedron(arrangement)
    graph = PolyhedralGraph.of(len(dual.signs), dual.edges.tolist())
    return Inscribability(dual.arrangement, sphere_points(dual), decide(graph))


def proved_conditions(certificate: Certificate) -> bool:
    """Return whether the program accepts that weights satisfy Rivin's conditions, or that none do.

    Raises:
        InputError: the program is not built.
    """
    document = conditions_document(certificate)
    return ask_proved("-", text=json.dumps(document)) == ("accepted", document["certificate"])


def conditions_document(certificate: Certificate) -> dict[str, Any]:
    """Return a certificate as the program reads it; an independent set as multipliers."""
    if isinstance(certificate, IndependentSetCertificate):
        certificate = _of_vertices(certificate)
    graph, nothing = certificate.graph, Fraction(0)
    if isinstance(certificate, WeightCertificate):
        weights = map(to_text, certificate.weights)
        return {
            "schema_version": 1,
            "certificate": "weights",
            "vertices": graph.vertex_count,
            "edges": [[*e, weight] for e, weight in zip(graph.edges, weights, strict=True)],
        }
    bounds = certificate.lower_multipliers, certificate.upper_multipliers
    return {
        "schema_version": 1,
        "certificate": "no weights",
        "vertices": list(map(to_text, certificate.vertex_multipliers)),
        "edges": [[*e, *(to_text(given.get(e, nothing)) for given in bounds)] for e in graph.edges],
        "cutsets": [[sorted(side), to_text(factor)] for side, factor in certificate.cuts],
    }


def _of_vertices(certificate: IndependentSetCertificate) -> FarkasCertificate:
    """Return multipliers 1/2 in the set and -1/2 outside, and 1 for each edge outside."""
    graph, chosen = certificate.graph, certificate.vertices
    half = Fraction(1, 2)
    outside = {edge: Fraction(1) for edge in graph.edges if chosen.isdisjoint(edge)}
    factors = tuple(half if v in chosen else -half for v in range(graph.vertex_count))
    return FarkasCertificate(graph, factors, outside, {}, ())
