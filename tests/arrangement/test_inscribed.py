"""Inscribability: known graphs, an oracle with all cutsets, changed certificates refused."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, permutations, product
from typing import Any

import networkx as nx
import numpy as np
import pytest
from hypothesis import assume, given, strategies as st
from scipy.spatial import ConvexHull

from arrangement import Arrangement, ArrangementError, InputError
from arrangement.duals.inscribed import hull as hull_module
from arrangement.duals.inscribed.certificates import (
    FarkasCertificate,
    IndependentSetCertificate,
    PolyhedralGraph,
    WeightCertificate,
)
from arrangement.duals.inscribed.hull import (
    rational_direction,
    representative_hull,
    sphere_hull,
    sphere_points,
)
from arrangement.duals.inscribed.report import decide, inscribability
from arrangement.duals.zonohedron import DualPolyhedron, dual_polyhedron
from arrangement.library.families import generic, near_pencil, simplicial, type_b
from arrangement.numbers import budget
from arrangement.numbers.exact import dot
from arrangement.numbers.linear.programs import Optimal, minimize

from .test_dual import A3, CUBE_DIAGONALS, SQUARE_AXES, rank_three, rank_three_only


def polyhedral(graph: nx.Graph) -> PolyhedralGraph:
    relabelled = nx.convert_node_labels_to_integers(graph)
    return PolyhedralGraph.of(len(relabelled), relabelled.edges)


def truncated_cube() -> nx.Graph:
    """The cube with one corner cut off: vertex 0 becomes a triangle."""
    graph = nx.convert_node_labels_to_integers(nx.hypercube_graph(3))
    around = list(graph[0])
    graph.remove_node(0)
    corners = ["a", "b", "c"]
    graph.add_edges_from(combinations(corners, 2))
    graph.add_edges_from(zip(corners, around, strict=True))
    return graph


def kleetope(graph: nx.Graph) -> nx.Graph:
    """A pyramid on every face of a triangulated sphere."""
    planar, embedding = nx.check_planarity(graph)
    assert planar
    seen: set[Any] = set()
    faces = [embedding.traverse_face(u, v, seen) for u, v in embedding.edges if (u, v) not in seen]
    result = graph.copy()
    result.add_edges_from((("face", k), v) for k, face in enumerate(faces) for v in face)
    return result


def rhombic_dodecahedron() -> nx.Graph:
    return dual_polyhedron(Arrangement(CUBE_DIAGONALS)).graph()


# Yes: regular and Archimedean solids and pyramids have a circumsphere.
# No: Steinitz' examples (Gruenbaum, Convex polytopes, section 13.5) by an independent set with more
# than half of the vertices. The cut cube: the 7 old vertices are 3 + 4, so the three edges at
# the new triangle weigh 4 - 3 = 1, not more.
KNOWN = {
    "tetrahedron": (nx.tetrahedral_graph(), True),
    "octahedron": (nx.octahedral_graph(), True),
    "cube": (nx.hypercube_graph(3), True),
    "dodecahedron": (nx.dodecahedral_graph(), True),
    "icosahedron": (nx.icosahedral_graph(), True),
    "truncated tetrahedron": (nx.truncated_tetrahedron_graph(), True),
    "triangular prism": (nx.circular_ladder_graph(3), True),
    "pyramid": (nx.wheel_graph(6), True),
    "triakis octahedron": (kleetope(nx.octahedral_graph()), False),
    "pentakis dodecahedron's relative": (kleetope(nx.icosahedral_graph()), False),
    "rhombic dodecahedron": (rhombic_dodecahedron(), False),
    "cube with a corner cut": (truncated_cube(), False),
}


@pytest.mark.parametrize("name", KNOWN)
def test_known_graphs(name):
    graph, expected = KNOWN[name]
    certificate = decide(polyhedral(graph))
    certificate.verify()
    assert certificate.inscribable is expected


def all_cutsets(graph: PolyhedralGraph) -> Iterator[set[int]]:
    """Yield one side of every minimal cutset that is not a vertex star, by listing all sets."""
    network = graph.to_networkx()
    others = range(1, graph.vertex_count)
    for size in range(2, graph.vertex_count - 1):
        for chosen in combinations(others, size):
            rest = set(network) - set(chosen)
            if nx.is_connected(network.subgraph(chosen)) and nx.is_connected(
                network.subgraph(rest)
            ):
                yield set(chosen)


def largest_margin(graph: PolyhedralGraph) -> Fraction:
    """Maximise t in Rivin's conditions with slack t, exactly, with all cutsets written out."""
    edges = graph.edges
    rows: list[list[Any]] = [[0] * len(edges) + [-1, 1]]
    for e in range(len(edges)):
        unit = [int(k == e) for k in range(len(edges))]
        rows += [[*unit, -1, 0], [*(-x for x in unit), -1, Fraction(1, 2)]]
    rows += [[*(int((u in s) != (v in s)) for u, v in edges), -1, -1] for s in all_cutsets(graph)]
    sums = [[*(int(v in edge) for edge in edges), 0, -1] for v in range(graph.vertex_count)]
    answer = minimize([0] * len(edges) + [-1], rows, sums)
    return -answer.value if isinstance(answer, Optimal) else Fraction(-1)


@st.composite
def polyhedral_graphs(draw: st.DrawFn) -> PolyhedralGraph:
    """Draw a small polyhedral graph: a triangulated sphere or its dual, some edges left out."""
    seed = draw(st.integers(0, 10**6))
    source = np.random.default_rng(seed)
    directions = source.normal(size=(draw(st.integers(4, 7)), 3))
    simplices = ConvexHull(directions / np.linalg.norm(directions, axis=1)[:, None]).simplices
    graph = nx.Graph([pair for s in simplices.tolist() for pair in combinations(s, 2)])
    if draw(st.booleans()) and len(simplices) <= 8:
        pairs = combinations(range(len(simplices)), 2)
        graph = nx.Graph([(i, j) for i, j in pairs if len({*simplices[i]} & {*simplices[j]}) == 2])
    for edge in draw(st.lists(st.sampled_from(sorted(graph.edges)), max_size=6)):
        smaller = graph.copy()
        smaller.remove_edges_from([edge])
        if nx.node_connectivity(smaller) >= 3:
            graph = smaller
    return polyhedral(graph)


@given(polyhedral_graphs())
def test_answers_agree_with_all_cutsets_written_out(graph):
    assert decide(graph).inscribable == (largest_margin(graph) > 0)


def test_three_four_and_five_generic_planes():
    kinds = [inscribability(generic(m)).certificate.kind for m in (3, 4, 5)]
    assert kinds == ["weights", "parity", "Farkas"]


def test_six_planes_in_general_position_may_pass_or_not():
    passing = Arrangement([*SQUARE_AXES, [1, -1, 1], [-1, 3, -2], [-2, 1, 1]])
    assert passing.is_simple
    assert generic(6).is_simple
    for planes, expected in ((passing, True), (generic(6), False)):
        answer = inscribability(planes)
        answer.verify()
        assert answer.inscribable is expected


SIMPLICIAL = {
    "A3": Arrangement(A3),
    "B3": type_b(3),
    **{f"near-pencil {m}": near_pencil(m) for m in range(4, 9)},
    **{f"A{entry}": simplicial(*entry) for entry in ((6, 1), (7, 1), (8, 1), (10, 2), (13, 3))},
}


@pytest.mark.parametrize("name", SIMPLICIAL)
def test_equal_weights_inscribe_every_simplicial_arrangement(name):
    """Three edges at each vertex and no cutset of three edges but the stars: 1/3 everywhere.

    Three regions' boundaries that close up around more than one ray would be a triangle of arcs,
    and a circle that enters it must leave it through a side.
    """
    answer = inscribability(SIMPLICIAL[name])
    answer.verify()
    graph = answer.certificate.graph
    thirds = (Fraction(1, 3),) * len(graph.edges)
    WeightCertificate(graph, thirds).verify()
    with pytest.raises(ArrangementError):
        WeightCertificate(graph, (Fraction(1, 2), *thirds[1:])).verify()


@pytest.mark.parametrize(
    "graph",
    [
        *map(nx.complete_graph, (1, 2, 5)),
        nx.complete_bipartite_graph(3, 3),
        nx.cycle_graph(5),
        nx.path_graph(3),
        nx.complete_bipartite_graph(2, 5),
        nx.disjoint_union(nx.complete_graph(4), nx.complete_graph(4)),
        # Two tetrahedra without an edge, glued at its ends.
        nx.Graph([(2, 3), (4, 5), *product((0, 1), (2, 3, 4, 5))]),
    ],
)
def test_graphs_of_no_polyhedron_are_refused(graph):
    with pytest.raises(ArrangementError):
        decide(polyhedral(graph))


def test_graphs_must_be_simple():
    for edges in (
        [(0, 0)],
        [(0, 1), (1, 0)],
        [(0, 4)],
        [(-1, 0)],
        [(0, 1), (2, 4)],
        [(0, 1), (2, 2)],
    ):
        with pytest.raises(InputError):
            PolyhedralGraph.of(4, edges)


def test_an_answer_about_other_regions_is_refused():
    answer = inscribability(Arrangement(A3))
    other = inscribability(type_b(3))
    doubled = (answer.points[1], *answer.points[1:])
    exchanged = (answer.points[1], answer.points[0], *answer.points[2:])
    on_a_plane = ((Fraction(1), Fraction(1), Fraction(0)), *answer.points[1:])
    for wrong in (
        replace(answer, points=answer.points[1:]),
        replace(answer, points=doubled),
        replace(answer, points=exchanged),
        replace(answer, points=on_a_plane),
        replace(answer, certificate=other.certificate),
        replace(answer, arrangement=type_b(3)),
    ):
        with pytest.raises(ArrangementError):
            wrong.verify()


def test_equal_weights_with_a_light_cutset_are_refused():
    """Every vertex of the cut cube has sum 1; the edges at the triangle weigh 1, not more."""
    graph = polyhedral(truncated_cube())
    certificate = WeightCertificate(graph, (Fraction(1, 3),) * len(graph.edges))
    with pytest.raises(ArrangementError, match="cutset"):
        certificate.verify()


def test_light_uprights_of_a_prism_refused():
    graph = polyhedral(nx.circular_ladder_graph(6))
    weights = [Fraction(1, 6) if v - u == 6 else Fraction(5, 12) for u, v in graph.edges]
    with pytest.raises(ArrangementError, match="cutset"):
        WeightCertificate(graph, tuple(weights)).verify()


def test_weights_are_accepted_where_a_flow_has_to_turn_back():
    weights = {(0, 3): 5, (0, 5): 12, (0, 7): 10, (1, 2): 4, (1, 3): 10, (1, 4): 13, (2, 3): 12}
    weights |= {(2, 6): 11, (4, 5): 11, (4, 6): 3, (5, 7): 4, (6, 7): 13}
    graph = PolyhedralGraph.of(8, weights)
    WeightCertificate(graph, tuple(Fraction(w, 27) for w in weights.values())).verify()
    with pytest.raises(ArrangementError):
        WeightCertificate(graph, tuple(Fraction(w, 26) for w in weights.values())).verify()


def test_any_changed_weight_is_refused():
    certificate = inscribability(Arrangement(A3)).certificate
    assert isinstance(certificate, WeightCertificate)
    for e, weight in enumerate(certificate.weights):
        for other in (weight + Fraction(1, 10**30), -weight, Fraction(0), Fraction(1, 2)):
            weights = (*certificate.weights[:e], other, *certificate.weights[e + 1 :])
            with pytest.raises(ArrangementError):
                replace(certificate, weights=weights).verify()
    with pytest.raises(ArrangementError, match="each edge"):
        replace(certificate, weights=certificate.weights[1:]).verify()


def test_weights_of_exactly_0_or_a_half_refused():
    """A diagonal of the cube that weighs nothing; halves on two edges of the tetrahedron."""
    cube = nx.convert_node_labels_to_integers(nx.hypercube_graph(3))
    for graph, changed, weight, others in (
        (cube, {(0, 3)}, Fraction(0), Fraction(1, 3)),
        (nx.tetrahedral_graph(), {(0, 1), (2, 3)}, Fraction(1, 2), Fraction(1, 4)),
    ):
        graph.add_edges_from(changed)
        whole = polyhedral(graph)
        weights = tuple(weight if edge in changed else others for edge in whole.edges)
        with pytest.raises(ArrangementError, match=f"the weight {weight} of edge .* is not inside"):
            WeightCertificate(whole, weights).verify()


def farkas() -> FarkasCertificate:
    certificate = inscribability(generic(5)).certificate
    assert isinstance(certificate, FarkasCertificate)
    return certificate


def test_any_changed_multiplier_is_refused():
    certificate = farkas()
    tiny = Fraction(1, 10**30)
    y = certificate.vertex_multipliers
    changed = [
        replace(certificate, vertex_multipliers=(*y[:v], y[v] + tiny, *y[v + 1 :]))
        for v in range(len(y))
    ]
    edge = certificate.graph.edges[0]
    changed += [
        replace(certificate, lower_multipliers={edge: tiny}),
        replace(certificate, upper_multipliers={edge: tiny}),
        replace(certificate, lower_multipliers={(0, 0): tiny}),
        replace(certificate, vertex_multipliers=y[1:]),
        replace(certificate, vertex_multipliers=(Fraction(0),) * len(y), cuts=()),
        replace(certificate, cuts=()),
    ]
    for k, (side, c) in enumerate(certificate.cuts):
        others = [*certificate.cuts[:k], *certificate.cuts[k + 1 :]]
        everything = frozenset(range(certificate.graph.vertex_count))
        apart = frozenset({min(side), *sorted(everything - side)[:1]})
        for pair in (
            (side, c + tiny),
            (side, -c),
            (frozenset({min(side)}), c),
            (everything, c),
            (side | {10**6}, c),
            (apart, c),
        ):
            changed.append(replace(certificate, cuts=(*others, pair)))
    for wrong in changed:
        with pytest.raises(ArrangementError):
            wrong.verify()
    certificate.verify()


def test_negative_multiplier_refused():
    """-1 at both ends of an edge, +1 for the edge, would prove anything.

    So would edges that weigh more than 1/2, or the cutset around an edge that weighs less than 1.
    """
    graph = polyhedral(nx.tetrahedral_graph())
    ones = (Fraction(1),) * 4
    minus = dict.fromkeys(graph.edges, Fraction(-2))
    less, plus = tuple(-y for y in ones), dict.fromkeys(graph.edges, Fraction(2))
    edge, around = (*ones[:2], *[Fraction(0)] * 2), ((frozenset({0, 1}), Fraction(-1)),)
    for multipliers, message in (
        ((ones, minus, {}, ()), "negative"),
        ((less, {}, minus, ()), "negative"),
        ((edge, {}, {(0, 1): Fraction(2)}, around), "negative"),
        ((less, plus, {}, ()), "contradicts nothing"),
        (((Fraction(0),) * 4, {}, {}, ()), "contradicts nothing"),
    ):
        with pytest.raises(ArrangementError, match=message):
            FarkasCertificate(graph, *multipliers).verify()


def test_cutsets_must_be_minimal_and_no_vertex_stars():
    """The star of a vertex, taken as a cutset, would refute every graph."""
    tetrahedron = polyhedral(nx.tetrahedral_graph())
    minus = (Fraction(-1), Fraction(0), Fraction(0), Fraction(0))
    for star in (frozenset({0}), frozenset({1, 2, 3})):
        with pytest.raises(ArrangementError, match="single vertex"):
            FarkasCertificate(tetrahedron, minus, {}, {}, ((star, Fraction(1)),)).verify()
    graph = polyhedral(rhombic_dodecahedron())
    larger, smaller = sorted(nx.bipartite.sets(graph.to_networkx()), key=len, reverse=True)
    balance = {v: Fraction(1 if v in larger else -1) for v in larger | smaller}
    FarkasCertificate(graph, tuple(balance[v] for v in range(14)), {}, {}, ()).verify()
    # An edge that weighs more than 0 and less than 1/2, x times both, adds x/2 to -8 + 6.
    for times in (0, 4, 5):
        edge = {graph.edges[0]: Fraction(times)}
        bounded = FarkasCertificate(graph, tuple(balance[v] for v in range(14)), edge, edge, ())
        if times <= 4:
            bounded.verify()
        else:
            with pytest.raises(ArrangementError, match="the constant 1/2 contradicts nothing"):
                bounded.verify()
    apart = frozenset(sorted(larger)[:2])
    for v in apart:
        balance[v] -= 1
    wrong = FarkasCertificate(
        graph, tuple(balance[v] for v in range(14)), {}, {}, ((apart, Fraction(1)),)
    )
    with pytest.raises(ArrangementError, match="not minimal"):
        wrong.verify()


def test_independent_sets_are_checked():
    graph = polyhedral(rhombic_dodecahedron())
    certificate = decide(graph)
    assert isinstance(certificate, IndependentSetCertificate)
    assert len(certificate.vertices) == 8
    others = frozenset(range(14)) - certificate.vertices
    for wrong in (
        others,
        certificate.vertices | {min(others)},
        frozenset(sorted(certificate.vertices)[:7]),
        certificate.vertices | {14},
    ):
        with pytest.raises(ArrangementError):
            replace(certificate, vertices=wrong).verify()


Point = tuple[Fraction, ...]


def facets_by_brute_force(points: Sequence[Point]) -> set[frozenset[int]]:
    """Return the vertex sets of all facets: planes through three points with no point outside."""
    facets = set()
    for a, b, c in combinations(range(len(points)), 3):
        (p, q, r), (s, t, u) = (
            [x - y for x, y in zip(points[k], points[a], strict=True)] for k in (b, c)
        )
        normal = (q * u - r * t, r * s - p * u, p * t - q * s)
        heights = [dot(normal, x) - dot(normal, points[a]) for x in points]
        if all(h >= 0 for h in heights) or all(h <= 0 for h in heights):
            facets.add(frozenset(k for k, h in enumerate(heights) if h == 0))
    return facets


def edges_by_brute_force(points: Sequence[Point]) -> set[tuple[int, int]]:
    """Return the pairs of points that two facets share."""
    shared = (x & y for x, y in combinations(facets_by_brute_force(points), 2))
    return {(min(pair), max(pair)) for pair in shared if len(pair) == 2}


@given(st.tuples(*[st.integers(-(10**40), 10**40)] * 3).filter(any), st.integers(4, 60))
def test_rational_directions_are_on_the_sphere_near_and_odd(vector, bits):
    *point, length = rational_direction(vector, bits)
    assert dot(point, point) == length * length
    assert length > 0
    assert rational_direction(tuple(-x for x in vector), bits) == (*(-x for x in point), length)
    # cos^2 of the angle, exactly: each of two coordinates is rounded by at most 2^-(bits + 1)
    assert dot(point, vector) > 0
    cosine = Fraction(dot(point, vector) ** 2, length**2 * dot(vector, vector))
    assert 1 - cosine <= Fraction(16, 4**bits)


@given(rank_three)
def test_opposite_regions_have_opposite_points(planes):
    dual = dual_polyhedron(rank_three_only(planes))
    points = sphere_points(dual)
    by_signs = {}
    for point, signs in zip(points, dual.signs.tolist(), strict=True):
        assert sum(x * x for x in point) == 1
        assert planes.signs_at(point) == tuple(signs)
        by_signs[tuple(signs)] = point
    for signs, point in by_signs.items():
        assert by_signs[tuple(-s for s in signs)] == tuple(-x for x in point)


@pytest.mark.slow
@given(rank_three)
def test_hull_agrees_with_brute_force(planes):
    dual = dual_polyhedron(rank_three_only(planes))
    assume(len(dual.signs) <= 20)
    hull = representative_hull(dual).hull
    v = len(hull.points)
    assert hull.true_edges == edges_by_brute_force(hull.points)
    assert len(hull.edges) == 3 * v - 6
    assert len(hull.triangles) == 2 * v - 4


def box(a: int, b: int, c: int) -> list[Point]:
    """Return the corners of a box with a, b, c in the ratio of a Pythagorean quadruple."""
    length = {(2, 3, 6): 7, (1, 2, 2): 3}[a, b, c]
    return [
        (Fraction(x * a, length), Fraction(y * b, length), Fraction(z * c, length))
        for x, y, z in product((-1, 1), repeat=3)
    ]


@pytest.mark.parametrize("proposal", ["none", "wrong", "right"])
def test_a_bad_proposal_of_the_float_hull_changes_nothing(proposal, monkeypatch):
    points = [*box(2, 3, 6), *box(1, 2, 2)]
    right = hull_module._qhull

    def wrong(homogeneous):
        return [(a, c, b) for a, b, c in right(homogeneous)][1:]

    replacement = {"none": lambda _: [], "wrong": wrong, "right": right}[proposal]
    monkeypatch.setattr(hull_module, "_qhull", replacement)
    assert sphere_hull(points).true_edges == edges_by_brute_force(points)


def test_a_proposal_with_a_flipped_edge_is_refused():
    points = [hull_module._homogeneous(0, p) for p in sphere_points(dual_polyhedron(generic(4)))]
    triangles = hull_module._qhull(points)
    assert hull_module._flat_edges_if_hull(points, triangles) is not None
    a, b, c = triangles[0]
    (d,) = next({*t} - {a, b} for t in triangles if {a, b} < {*t} and c not in t)
    flipped = [t for t in triangles if not {a, b} <= {*t}] + [(a, d, c), (d, b, c)]
    assert hull_module._flat_edges_if_hull(points, flipped) is None


def test_a_surface_that_winds_twice_around_is_refused():
    """A pyramid over a pentagram, on both sides: closed, oriented and convex at every edge."""
    half_angles = [Fraction(0), Fraction(3, 4), Fraction(3), Fraction(-3), Fraction(-3, 4)]
    ring = [((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t), Fraction(0)) for t in half_angles]
    poles = [(Fraction(0), Fraction(0), Fraction(s)) for s in (1, -1)]
    points = [hull_module._homogeneous(k, p) for k, p in enumerate([*ring, *poles])]
    for step, accepted in ((1, True), (2, False)):
        sides = [(k, (k + step) % 5) for k in range(5)]
        triangles = [(a, b, 5) for a, b in sides] + [(b, a, 6) for a, b in sides]
        assert (hull_module._flat_edges_if_hull(points, triangles) is not None) is accepted


def reflection_orbit(dual: DualPolyhedron, point: tuple[int, ...], length: int) -> list[Point]:
    """Return the images of a point under all signed permutations, in the order of the regions."""
    images = {
        dual.arrangement.signs_at(image): tuple(Fraction(x, length) for x in image)
        for order in permutations(point)
        for signs in product((-1, 1), repeat=3)
        for image in [tuple(s * x for s, x in zip(signs, order, strict=True))]
    }
    return [images[tuple(signs)] for signs in dual.signs.tolist()]


def test_orbits_of_reflection_groups_are_inscribed_duals():
    b3 = dual_polyhedron(type_b(3))
    report = representative_hull(b3, reflection_orbit(b3, (2, 3, 6), 7))
    assert report.hull.true_edges == report.adjacencies
    cube = dual_polyhedron(Arrangement(SQUARE_AXES))
    corners = {cube.arrangement.signs_at(p): p for p in box(2, 3, 6)}
    report = representative_hull(cube, [corners[tuple(s)] for s in cube.signs.tolist()])
    assert report.hull.true_edges == report.adjacencies
    assert (len(report.hull.true_edges), len(report.hull.flat_edges)) == (12, 6)


def test_representatives_on_sphere_inside_regions():
    cube = dual_polyhedron(Arrangement(SQUARE_AXES))
    points = list(sphere_points(cube))
    with pytest.raises(InputError, match="not inside the region"):
        representative_hull(cube, [points[1], points[0], *points[2:]])
    with pytest.raises(InputError, match="unit sphere"):
        representative_hull(cube, [tuple(2 * x for x in points[0]), *points[1:]])
    with pytest.raises(InputError, match="7 points for 8"):
        representative_hull(cube, points[:7])


def test_hulls_without_the_origin_inside_are_refused():
    half = [p for p in [*box(2, 3, 6), *box(1, 2, 2)] if p[2] > 0]
    for points in (half, half[:4], half[:3]):
        with pytest.raises(InputError, match="origin"):
            sphere_hull(points)
    with pytest.raises(InputError, match="equal"):
        sphere_hull([*half, half[0]])


@given(st.integers(4, 8), st.floats(0, 1), st.integers(0, 10**6))
def test_polyhedral_graphs_are_planar_and_3_connected(vertices, share, seed):
    edges = round(vertices + share * (2 * vertices - 6))
    random_graph = nx.gnm_random_graph(vertices, edges, seed=seed)
    graph = PolyhedralGraph.of(vertices, random_graph.edges)
    expected = nx.check_planarity(random_graph)[0] and nx.node_connectivity(random_graph) >= 3
    assert expected == (not graph._not_polyhedral)


def test_search_counts_its_steps():
    graph = PolyhedralGraph.of(12, nx.icosahedral_graph().edges)
    decide.cache_clear()
    with budget.meter_steps(1000), pytest.raises(budget.WorkOver, match="without an answer"):
        decide(graph)
