"""Points on the unit sphere, their exact hulls, and inscribed zonotopes."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, permutations, product

import pytest
from hypothesis import assume, given, settings, strategies as st

from arrangement import Arrangement, ArrangementError, InputError, dual_polyhedron
from arrangement.duals.inscribed import (
    hull as hull_module,
    inscribed_zonotope,
    representative_hull,
    sphere_hull,
    sphere_points,
)
from arrangement.duals.inscribed.hull import rational_direction
from arrangement.duals.zonohedron import DualPolyhedron
from arrangement.library.families import generic, type_b
from arrangement.numbers.exact import dot

from .test_dual import A3, SQUARE_AXES, rank_three, rank_three_only

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


@given(
    st.tuples(*[st.integers(-(10**40), 10**40)] * 3).filter(any),
    st.integers(4, 60),
)
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
def test_each_region_has_its_point_and_opposite_regions_opposite_ones(planes):
    dual = dual_polyhedron(rank_three_only(planes))
    points = sphere_points(dual)
    by_signs = {}
    for point, signs in zip(points, dual.signs.tolist(), strict=True):
        assert sum(x * x for x in point) == 1
        assert planes.signs_at(point) == tuple(signs)
        by_signs[tuple(signs)] = point
    for signs, point in by_signs.items():
        assert by_signs[tuple(-s for s in signs)] == tuple(-x for x in point)


def test_thin_regions_get_points_too():
    huge = 10**30
    planes = Arrangement([[1, 0, 0], [huge, 1, 0], [huge + 1, 1, 1], [0, 0, 1], [1, 1, huge]])
    dual = dual_polyhedron(planes)
    report = representative_hull(dual)
    assert len(report.hull.points) == len(dual.signs)


@pytest.mark.campaign
@settings(max_examples=20)
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
    assert representative_hull(b3, reflection_orbit(b3, (2, 3, 6), 7)).is_dual
    cube = dual_polyhedron(Arrangement(SQUARE_AXES))
    corners = {cube.arrangement.signs_at(p): p for p in box(2, 3, 6)}
    report = representative_hull(cube, [corners[tuple(s)] for s in cube.signs.tolist()])
    assert report.is_dual
    assert (len(report.hull.true_edges), len(report.hull.flat_edges)) == (12, 6)


@pytest.mark.parametrize("m", [4, 5, 6])
def test_representatives_of_generic_planes_do_not_span_the_dual(m):
    """The hull is convex with 3V - 6 edges; the dual has 2V - 4, and others."""
    report = representative_hull(dual_polyhedron(generic(m)))
    assert not report.is_dual
    assert len(report.hull.true_edges) > len(report.adjacencies)


def test_representatives_must_be_on_the_sphere_and_inside_their_regions():
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


#: A(13, 2) of Gruenbaum's catalogue, in coordinates with the symmetries of the cube.
B3_AND_DIAGONALS = Arrangement([*type_b(3).normals, (1, 1, 1), (1, 1, -1), (1, -1, 1), (1, -1, -1)])


@pytest.mark.parametrize(
    "planes", [Arrangement(SQUARE_AXES), Arrangement(A3), type_b(3), B3_AND_DIAGONALS]
)
def test_inscribed_zonotopes_have_their_vertices_in_their_regions(planes):
    answer = inscribed_zonotope(planes)
    answer.verify()
    assert answer.lengths is not None
    dual = dual_polyhedron(planes, answer.lengths)
    assert dual.is_inscribed
    for vertex, signs in zip(dual.vertices, dual.signs.tolist(), strict=True):
        assert planes.signs_at(vertex) == tuple(signs)


@settings(max_examples=20)
@given(rank_three)
def test_zonotopes_of_simplicial_arrangements_alone_are_inscribed(planes):
    """Manecke and Sanyal, Inscribable fans II."""
    answer = inscribed_zonotope(rank_three_only(planes))
    answer.verify()
    if answer.lengths is not None:
        v, e, _ = dual_polyhedron(planes).f_vector
        assert 2 * e == 3 * v


def test_changed_proofs_about_zonotopes_are_refused():
    yes = inscribed_zonotope(type_b(3))
    assert yes.lengths is not None
    lengths = (yes.lengths[0] + 1, *yes.lengths[1:])
    no = inscribed_zonotope(generic(5))
    assert no.multipliers is not None
    first = next(k for k, x in enumerate(no.multipliers) if x)
    reversed_ = tuple(-x for x in no.multipliers)
    shorter = no.multipliers[1:]
    for changed in (
        replace(yes, lengths=lengths),
        replace(yes, lengths=None),
        replace(no, multipliers=reversed_),
        replace(no, multipliers=shorter),
        replace(no, multipliers=(Fraction(0),) * len(no.multipliers)),
        replace(no, multipliers=tuple(x * (k != first) for k, x in enumerate(no.multipliers))),
    ):
        with pytest.raises(ArrangementError):
            changed.verify()
