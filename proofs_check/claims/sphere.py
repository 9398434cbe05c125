"""Claims on the dual with vertices on the unit sphere."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial
from itertools import combinations, product

import networkx as nx

from arrangement.arrangement import Arrangement
from arrangement.duals.inscribed.certificates import FarkasCertificate, WeightCertificate
from arrangement.duals.inscribed.hull import representative_hull
from arrangement.duals.inscribed.report import inscribability
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.numbers.exact import RationalVector, to_text
from proofs_check.instances.arrangements import census_cases, smallest_arrangements
from proofs_check.routes import rivin
from proofs_check.routes.dual_graph import from_covectors, from_signs
from proofs_check.routes.many_types import edges_have_weights, have_weights
from proofs_check.statements.statement import Case

from .stated import stated

_answer = lru_cache(maxsize=64)(inscribability)


def _inscribable(planes: Arrangement) -> bool:
    answer = _answer(planes)
    answer.verify()
    return answer.inscribable


def _checked_afresh(planes: Arrangement) -> bool:
    """Read the certificate as one on the graph of the covectors, and check it by own means."""
    answer = _answer(planes)
    names = [planes.signs_at(point) for point in answer.points]
    graph = from_covectors(planes)
    certificate = answer.certificate
    edges = [frozenset((names[u], names[v])) for u, v in certificate.graph.edges]
    same = set(names) == graph.vertices and set(edges) == graph.edges
    if isinstance(certificate, WeightCertificate):
        fits = rivin.weights_fit(graph, dict(zip(edges, certificate.weights, strict=True)))
    elif isinstance(certificate, FarkasCertificate):
        named = dict(zip(certificate.graph.edges, edges, strict=True))
        fits = rivin.multipliers_fit(
            graph,
            dict(zip(names, certificate.vertex_multipliers, strict=True)),
            {named[pair]: x for pair, x in certificate.lower_multipliers.items()},
            {named[pair]: x for pair, x in certificate.upper_multipliers.items()},
            [(frozenset(names[v] for v in side), c) for side, c in certificate.cuts],
        )
    else:
        fits = rivin.is_large_independent_set(
            graph, frozenset(names[v] for v in certificate.vertices)
        )
    if not (same and fits and rivin.is_polyhedral(graph)):
        raise ValueError("the certificate does not fit the graph of the covectors")
    return isinstance(certificate, WeightCertificate)


def _weights_by_hand(planes: Arrangement) -> bool:
    """Each region is the number whose bits are its positive signs."""
    return edges_have_weights(
        [
            [sum(1 << k for k, sign in enumerate(region) if sign > 0) for region in edge]
            for edge in from_covectors(planes).edges
        ]
    )


def _explain(planes: Arrangement, inscribable: bool) -> str:
    certificate = _answer(planes).certificate
    text = f"Rivin's criterion, {certificate.kind}"
    if certificate.kind == "parity":
        text = "classes of regions by parity are unequal (Steinitz)"
    return f"{'inscribable' if inscribable else 'not inscribable'}: {text}"


def _types(_rng: random.Random) -> Iterator[Case]:
    yield from census_cases(range(3, 7))
    yield from census_cases(range(7, 8), simple=True)


@dataclass(frozen=True)
class Chosen:
    """Planes with a point of the unit sphere for each region, in the order of the dual."""

    planes: Arrangement
    points: tuple[RationalVector, ...]


def _edge_counts_by_hull(chosen: Chosen) -> tuple[int, int]:
    """Adjacencies that are not edges of the hull, and edges of it that are not adjacencies."""
    graphs = representative_hull(dual_polyhedron(chosen.planes), chosen.points)
    return len(graphs.missing), len(graphs.hull.true_edges - graphs.adjacencies)


def _edge_counts_by_supports(chosen: Chosen) -> tuple[int, int]:
    """Return the same from all planes through three points that have no point on one side."""
    points = chosen.points
    facets = set()
    for a, b, c in combinations(points, 3):
        u = [y - x for x, y in zip(a, b, strict=True)]
        v = [y - x for x, y in zip(a, c, strict=True)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        level = sum(x * y for x, y in zip(n, a, strict=True))
        heights = [sum(x * y for x, y in zip(n, p, strict=True)) - level for p in points]
        if min(heights) >= 0 or max(heights) <= 0:
            facets.add(frozenset(k for k, height in enumerate(heights) if height == 0))
    signs = [chosen.planes.signs_at(point) for point in points]
    edges = {one & other for one, other in combinations(facets, 2) if len(one & other) == 2}
    near = {
        frozenset((i, j))
        for i, j in combinations(range(len(points)), 2)
        if sum(a != b for a, b in zip(signs[i], signs[j], strict=True)) == 1
    }
    return len(near - edges), len(edges - near)


def _cube_choices() -> Iterator[Case]:
    """Yield three perpendicular planes with points (+-1, +-2, +-2) / 3, permuted, in octants."""
    planes = Arrangement([(1, 0, 0), (0, 1, 0), (0, 0, 1)])
    octants = dual_polyhedron(planes).signs.tolist()
    ways = [tuple(Fraction(x, 3) for x in way) for way in ((1, 2, 2), (2, 1, 2), (2, 2, 1))]
    for choice in product(ways, repeat=len(octants)):
        points = tuple(
            tuple(s * x for s, x in zip(signs, way, strict=True))
            for signs, way in zip(octants, choice, strict=True)
        )
        yield _chosen_case(planes, points, "m = 3, points (1,2,2)/3, (2,1,2)/3, (2,2,1)/3 turned")


def _chosen_case(planes: Arrangement, points: tuple[RationalVector, ...], label: str) -> Case:
    listed = [[to_text(x) for x in point] for point in points]
    return Case(label, Chosen(planes, points), {**planes.to_dict(), "points": listed})


def _middle_points(_rng: random.Random) -> Iterator[Case]:
    for case in census_cases(range(3, 6)):
        dual = dual_polyhedron(case.subject)
        points = representative_hull(dual).hull.points
        yield _chosen_case(case.subject, points, f"{case.label}, points near the middles")


def _weights_by_flows(planes: Arrangement) -> bool:
    """Return the same by networkx: a largest flow, and whether what it leaves open is connected."""
    graph = from_signs(*([face.signs for face in planes.faces(k)] for k in (3, 2, 1)))
    net = nx.DiGraph()
    pairs = [sorted(edge, key=lambda region: region.count(1) % 2) for edge in graph.edges]
    for even, odd in pairs:
        net.add_edge("even", even, capacity=2)
        net.add_edge(even, odd, capacity=1)
        net.add_edge(odd, "odd", capacity=2)
    value, flow = nx.maximum_flow(net, "even", "odd")
    if value < len(graph.vertices) or net.out_degree("even") != net.in_degree("odd"):
        return False
    turned = [(b, a) if flow[a][b] else (a, b) for a, b in pairs]
    return bool(nx.is_strongly_connected(nx.DiGraph(turned)))


_smallest = partial(smallest_arrangements, range(3, 5), 1, distinct=True, rank=3)

CLAIMS = (
    stated(
        "sphere-dual-weights",
        cycles=_weights_by_hand,
        flow=_weights_by_flows,
        judge=lambda planes, exist: exist,
        many_types=have_weights,
        cases=_types,
        search=_smallest,
    ),
    stated(
        "sphere-dual-convex",
        criterion=_inscribable,
        covectors=_checked_afresh,
        judge=lambda planes, inscribable: inscribable,
        cases=_types,
        search=_smallest,
        explain=_explain,
    ),
    stated(
        "sphere-hull-edges",
        qhull=_edge_counts_by_hull,
        planes=_edge_counts_by_supports,
        judge=lambda chosen, found: found == (0, 0),
        cases=_middle_points,
        search=_cube_choices,
    ),
)
