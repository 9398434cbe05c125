"""Regions that can be asked: double description against the engines, counts and formulas."""

import json
from collections import Counter
from fractions import Fraction
from itertools import combinations, pairwise
from math import comb, factorial
from pathlib import Path

import networkx as nx
import pytest
import sympy
from hypothesis import assume, given, strategies as st
from scipy.spatial import ConvexHull
from sympy.functions.combinatorial.numbers import stirling

from arrangement import Arrangement, Face, InputError, counts, families
from arrangement.enumeration.choose import ENGINES
from arrangement.numbers.exact import dot

from .strategies import arrangements

T = sympy.Symbol("t")
TRIANGLE = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])
SHI = counts.essentialization(families.shi(4))


def below(one: Face, other: Face) -> bool:
    """Whether a face lies in the closure of another one, by their signs."""
    return all(a in (0, b) for a, b in zip(one.signs, other.signs, strict=True))


@given(
    arrangements(dimensions=(1, 3), planes=(0, 5)) | arrangements(dimensions=(4, 5), planes=(0, 4))
)
def test_the_closure_of_a_face_has_the_faces_that_the_signs_say(planes):
    everything = tuple(planes.faces())
    for face in everything:
        within = [other for other in everything if below(other, face)]
        assert sorted(face.faces(), key=hash) == sorted(within, key=hash)
        dimensions = [other.dimension for other in within]
        assert face.f_vector == tuple(dimensions.count(k) for k in range(face.dimension + 1))
        assert set(face.facets) == {f for f in within if f.dimension == face.dimension - 1}
        assert len(face.lines) == planes.dimension - planes.rank
        corners = {f.witness for f in within if f.dimension == 0}
        assert set(face.vertices) == corners
        assert all(f.contains(f.witness) and face.contains(f.witness, closed=True) for f in within)
        assert face.contains(face.witness)
        assert planes.face_at(face.witness) == face


def test_closed_face_alone_contains_its_boundary():
    inside, *boundary, beyond = [(1, 1), (0, 1), (2, 2), (0, 4), (-1, 1)]
    region = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 4]).region_at(inside)
    assert region.contains(inside)
    assert [region.contains(point) for point in (*boundary, beyond)] == [False] * 4
    assert all(region.contains(point, closed=True) for point in (inside, *boundary))
    assert not region.contains(beyond, closed=True)


@given(arrangements(dimensions=(1, 3), planes=(0, 6)))
def test_bounded_regions_are_as_many_as_zaslavsky_says(planes):
    bounded = planes.bounded_regions()
    assert len(bounded) == counts.bounded_region_count(planes)
    assert {region for region in planes.regions() if region.is_bounded} == set(bounded)
    for region in bounded:
        assert not region.rays
        assert not region.lines
        assert sum((-1) ** k * f for k, f in enumerate(region.f_vector)) == 1


@given(arrangements(dimensions=(2, 2), planes=(2, 6)))
def test_corners_of_a_region_of_the_plane_are_counter_clockwise(planes):
    for region in planes.regions():
        corners = region.vertices
        assert set(corners) == {face.witness for face in region.faces() if face.dimension == 0}
        turns = list(pairwise([*corners, *corners[:1]] if region.is_bounded else corners))
        for (a, b), (c, d) in turns:  # the region is on the left of each side
            x, y = region.witness
            assert (c - a) * (y - b) > (d - b) * (x - a)
        if region.is_bounded:
            area = sum((a * d - b * c for (a, b), (c, d) in turns), Fraction(0)) / 2
            assert area == region.volume


@given(arrangements(dimensions=(2, 4), planes=(0, 4)))
def test_the_regions_in_a_box_fill_it(planes):
    d = planes.dimension
    axes = [tuple(int(i == j) for j in range(d)) for i in range(d)]
    boxed = Arrangement(
        [*axes, *axes, *planes.normals], [-1] * d + [Fraction(3, 2)] * d + list(planes.offsets)
    )
    inside = [r for r in boxed.bounded_regions() if r.signs[: 2 * d] == (1,) * d + (-1,) * d]
    assert sum(region.volume for region in inside) == Fraction(5, 2) ** d
    for region in inside:
        hull = ConvexHull([[float(x) for x in vertex] for vertex in region.vertices])
        assert float(region.volume) == pytest.approx(hull.volume)


@given(arrangements(dimensions=(1, 3), planes=(1, 5)), st.data())
def test_composition_is_that_of_sign_vectors(planes, data):
    faces = planes.faces()
    one, other = (faces[data.draw(st.integers(0, len(faces) - 1))] for _ in range(2))
    composed = one.compose(other)
    assert composed.signs == tuple(a or b for a, b in zip(one.signs, other.signs, strict=True))
    assert composed in faces.of_dimension(composed.dimension)
    assert (*composed.signs, *(() if planes.is_central else (1,))) in counts.covectors(planes)
    assert one.separating(other) == tuple(
        i for i, (a, b) in enumerate(zip(one.signs, other.signs, strict=True)) if {a, b} == {1, -1}
    )


@given(arrangements(dimensions=(1, 3), planes=(1, 4)), st.data())
def test_the_inequalities_hold_on_the_face_and_nowhere_else(planes, data):
    symbols = sympy.symbols("u v w")[: planes.dimension]
    faces = planes.faces()
    face = faces[data.draw(st.integers(0, len(faces) - 1))]
    condition = sympy.lambdify(symbols, sympy.And(*face.inequalities(symbols)), "math")
    for other in faces:
        assert bool(condition(*other.witness)) == (other == face)


@given(arrangements(dimensions=(1, 4), planes=(0, 6)))
def test_the_region_graph_is_that_of_the_sign_vectors(planes):
    graph = planes.region_graph()
    assert set(graph) == set(planes.regions())
    edges = {frozenset(edge) for edge in graph.edges}
    for one, other in combinations(graph, 2):
        across = one.separating(other)
        classes = {planes.class_of[plane] for plane in across}
        assert (frozenset((one, other)) in edges) == (len(classes) == 1)
        if len(classes) == 1:
            assert graph.edges[one, other]["planes"] == across


@given(arrangements(dimensions=(1, 3), planes=(0, 6)), st.data())
def test_distances_are_those_in_the_graph(planes, data):
    regions = planes.regions()
    base = regions[data.draw(st.integers(0, len(regions) - 1))]
    graph, poset = planes.region_graph(), planes.poset_of_regions(base)
    steps = nx.single_source_shortest_path_length(graph, base)
    assert dict(poset.nodes(data="rank")) == steps
    sizes = list(steps.values())
    expected = sum(sizes.count(k) * T**k for k in set(sizes))
    assert planes.distance_enumerator(base) == sympy.Poly(expected, T, domain=sympy.ZZ)
    assert {region: base.distance(region) for region in poset} == steps
    separations = {region: set(base.separating(region)) for region in poset}
    for one, other in combinations(poset, 2):
        if nx.has_path(poset, one, other):
            assert separations[one] < separations[other]


@pytest.mark.parametrize(
    ("planes", "degrees"),
    [
        (families.braid(4), (2, 3, 4)),
        (families.type_b(3), (2, 4, 6)),
        (families.type_d(4), (2, 4, 4, 6)),
        (families.coordinate(5), (2, 2, 2, 2, 2)),
    ],
)
def test_mirrors_have_the_length_polynomial_of_their_group(planes, degrees):
    """Solomon's product over the degrees of the group, from any base: all regions look alike."""
    product = sympy.prod(sum(T**k for k in range(degree)) for degree in degrees)
    for base in planes.regions()[:3]:
        assert planes.distance_enumerator(base).as_expr() == sympy.expand(product)
    assert planes.is_simplicial
    assert planes.p_vector == {planes.rank: len(planes.regions())}


@given(arrangements(dimensions=(1, 3), planes=(0, 6)))
def test_facets_of_regions_are_counted_alike(planes):
    sizes = [len(region.facets) for region in planes.regions()]
    assert planes.p_vector == {k: sizes.count(k) for k in sorted(set(sizes))}
    simplicial = [region for region in planes.regions() if region.is_simplicial]
    assert set(planes.simplicial_regions()) == set(simplicial)
    assert planes.is_simplicial == (len(simplicial) == len(sizes))
    if planes.is_central:
        assert planes.is_simplicial == (set(sizes) == {planes.rank})


#: The lines of the best Kobon arrangement of eleven, with 32 triangles (T. Honma).
KOBON = Arrangement(
    [
        (-29, -5), (-62, -30), (-11, -10), (-95, -150), (-45, -150), (0, -5),
        (3, -10), (19, -30), (165, -150), (31, -15), (145, -25),
    ],
    [5, "-79/5", -10, 8, -83, 1, "-2/15", 30, 104, 13, 7],
)  # fmt: skip


def test_triangles_of_the_best_kobon_arrangement_are_32():
    assert KOBON.bounded_p_vector == {3: 32, 5: 5, 6: 8}
    assert KOBON.p_vector == {2: 8, 3: 36, 4: 6, 5: 8, 6: 9}
    triangles = KOBON.simplicial_regions()
    assert len(triangles) == 32
    for region in triangles:
        assert len(region.vertices) == 3
        assert region.is_bounded
        assert region.is_simplicial
    assert not KOBON.is_simplicial


@given(arrangements(dimensions=(1, 3), planes=(0, 6)))
def test_relatively_bounded_regions_match_zaslavsky(planes):
    relatively = planes.bounded_regions(relative=True)
    assert len(relatively) == counts.bounded_region_count(planes, relative=True)
    assert {region for region in planes.regions() if not region.rays} == set(relatively)
    assert sum(planes.bounded_p_vector.values()) == len(planes.bounded_regions())


@given(arrangements(dimensions=(1, 3), planes=(0, 6)))
def test_simplicial_faces_stay_so_when_the_origin_moves(planes):
    by = [Fraction(2), Fraction(-1, 3), Fraction(5)][: planes.dimension]
    offsets = [
        b + sum(x * y for x, y in zip(n, by, strict=True))
        for n, b in zip(planes.normals, planes.offsets, strict=True)
    ]
    moved = Arrangement(planes.normals, offsets, dimension=planes.dimension)
    for region in planes.regions():
        at = [x + y for x, y in zip(region.witness, by, strict=True)]
        assert moved.region_at(at).is_simplicial == region.is_simplicial


@given(arrangements(dimensions=(3, 3), planes=(3, 8), central=True))
def test_points_and_polygons_of_the_projective_plane(planes):
    """Pairs of lines meet once, points are half the rays; Melchior's identity."""
    assume(planes.rank == 3)
    points, polygons, m = counts.t_vector(planes), planes.p_vector, len(planes.distinct)
    assert sum(t * j * (j - 1) for j, t in points.items()) == m * (m - 1)
    assert 2 * sum(points.values()) == planes.faces().f_vector[1]
    excess = sum(t * (3 - j) for j, t in points.items()) - 3
    assert 2 * excess == sum(p * (k - 3) for k, p in polygons.items())
    assert planes.is_simplicial == (excess == 0)


def test_every_engine_gives_faces_that_answer():
    answers: set[tuple[object, ...]] = set()
    for engine in ENGINES:
        regions = SHI.faces(3, engine=engine) if ENGINES[engine].ranks(SHI) else ()
        answers.update(
            (r.signs, r.is_bounded, r.vertices, r.rays, r.f_vector, r.inequalities())
            for r in regions
        )
    assert len(answers) == 125
    assert sum(answer[1] is True for answer in answers) == 27


def test_faces_are_equal_as_sets_and_say_so_briefly():
    region = TRIANGLE.region_at([2, 2])
    assert region == TRIANGLE.region_at([3, 5])
    assert region in set(TRIANGLE.regions())
    assert region != Arrangement([[1, 0], [0, 1], [1, 1]]).region_at([2, 2])
    assert repr(TRIANGLE.face_at([0, 2])) == "<Face: 0++, dimension 1>"
    assert repr(Arrangement([], dimension=2).faces()[0]) == "<Face: dimension 2>"
    assert len(repr(families.generic(60).regions()[0])) < 70


def test_a_choice_of_faces_is_a_sequence_again():
    faces = SHI.faces()
    some = faces.where(faces.signs[:, 0] == 0)
    assert some[:] == tuple(face for face in faces if face.signs[0] == 0)
    assert sum(some.f_vector) == len(some) < len(faces)
    for wrong in ([True], faces.signs[:, 0]):
        with pytest.raises(InputError, match="one truth value for each"):
            faces.where(wrong)


def test_wrong_questions_are_explained():
    region = TRIANGLE.region_at([2, 2])
    other = families.coordinate(2).regions()[0]
    edge = TRIANGLE.face_at([0, 2])
    with pytest.raises(InputError, match=r"\(0, 1/2\) lies on the planes \[0\]"):
        TRIANGLE.region_at([0, "1/2"])
    with pytest.raises(InputError, match="3 coordinates; this space has 2"):
        TRIANGLE.face_at([0, 1, 2])
    with pytest.raises(InputError, match="float"):
        region.contains([0.5, 1])
    for wrong in (region, edge):
        with pytest.raises(InputError, match="only bounded regions have a volume"):
            _ = wrong.volume
    with pytest.raises(InputError, match="is not a face of these planes"):
        region.compose(other)
    for base in (other, edge, "++"):
        with pytest.raises(InputError, match="give a region of these planes"):
            TRIANGLE.poset_of_regions(base)


def test_rays_lie_on_the_walls():
    for region in SHI.regions():
        for ray in region.rays:
            values = [dot(plane[:-1], ray) for plane in SHI.integer_planes]
            assert all(v * s >= 0 for v, s in zip(values, region.signs, strict=True))


@given(arrangements(dimensions=(1, 3), planes=(0, 6)))
def test_levels_of_regions_are_counted_by_three_routes(planes):
    levels = Counter(region.level for region in planes.regions())
    assert planes.level_vector == counts.level_vector(planes) == dict(sorted(levels.items()))
    assert levels[0] == counts.bounded_region_count(planes)
    least = planes.dimension - planes.rank
    assert levels[least] == counts.bounded_region_count(planes, relative=True)


def power(series: list[Fraction], exponent: int) -> list[Fraction]:
    """The power of a power series, cut off."""
    found = [Fraction(int(k == 0)) for k in range(len(series))]
    for _ in range(exponent):
        found = [
            sum((found[i] * series[k - i] for i in range(k + 1)), Fraction(0))
            for k in range(len(series))
        ]
    return found


#: Regions of level l of the arrangements in R^n: Y. Chen, S. Wang, J. Yang, C. Zhao, Regions of
#: level l of Catalan/semiorder-type arrangements, arXiv:2410.10198 (first two); by the exponential
#: formula from the counts of all regions (R. Stanley, PNAS 93, 1996) the others.
LEVELS = {
    "catalan": lambda n, k: factorial(n) * k * comb(2 * n - k, n) // (2 * n - k),
    "semiorder": lambda n, k: sum(
        (-1) ** (n - j) * stirling(n, j) * factorial(j) * k * comb(2 * j - k, j) // (2 * j - k)
        for j in range(k, n + 1)
    ),
    "shi": lambda n, k: (
        k * sum((-1) ** j * comb(k - 1, j) * (n - 1 - j) ** (n - 1) for j in range(k))
    ),
    "linial": lambda n, k: (
        k
        * sum(
            (-1) ** j * comb(k - 1, j) * comb(n, i) * (i - 1 - j) ** (n - 1)
            for j in range(k)
            for i in range(n + 1)
        )
        // 2**n
    ),
}


@pytest.mark.parametrize("name", LEVELS)
@pytest.mark.parametrize("n", [2, 3, 4, pytest.param(5, marks=pytest.mark.slow)])
def test_levels_of_deformations_have_published_numbers(name, n):
    planes = getattr(families, name)(n)
    expected = {k: LEVELS[name](n, k) for k in range(1, n + 1)}
    assert counts.level_vector(planes) == {k: number for k, number in expected.items() if number}
    assert planes.level_vector == counts.level_vector(planes)
    sizes = [Fraction(getattr(families, name)(k).region_count(), factorial(k)) for k in range(1, n)]
    whole = [Fraction(1), *sizes, Fraction(planes.region_count(), factorial(n))]
    bounded = [Fraction(0)]  # 1 - 1 / whole
    for k in range(1, n + 1):
        bounded.append(whole[k] - sum(bounded[i] * whole[k - i] for i in range(1, k)))
    assert all(factorial(n) * power(bounded, k)[n] == expected[k] for k in expected)


def kobon(m: int) -> Arrangement:
    """The best known arrangement of a number of lines."""
    if m == len(KOBON):
        return KOBON
    rows = json.loads((Path(__file__).parent / "kobon.json").read_text(encoding="utf-8"))[str(m)]
    normals = [(y2 - y1, x1 - x2) for x1, y1, x2, y2 in rows]
    pairs = zip(normals, rows, strict=True)
    return Arrangement(normals, [a * x + b * y for (a, b), (x, y, *_) in pairs])


def triangles(lines: Arrangement) -> int:
    """Triangles that no other line cuts, by the signs of determinants alone."""
    rows = lines.integer_planes
    found = 0
    for chosen in combinations(range(len(rows)), 3):
        corners = []
        for i, j in combinations(chosen, 2):
            (a, b, c), (d, e, f) = rows[i], rows[j]
            w = a * e - b * d
            corners.append([w * x for x in (c * e - b * f, a * f - c * d, w)])
        if all(corner[2] for corner in corners):
            others = (row for i, row in enumerate(rows) if i not in chosen)
            values = ([a * x + b * y - c * w for x, y, w in corners] for a, b, c in others)
            found += all(min(value) >= 0 or max(value) <= 0 for value in values)
    return found


@pytest.mark.parametrize(("m", "expected"), [(11, 32), (16, 72), (21, 133), (27, 225), (33, 341)])
def test_best_known_arrangements_of_lines_have_their_triangles(m, expected):
    lines = kobon(m)
    assert len(lines) == m
    assert lines.bounded_p_vector[3] == triangles(lines) == expected <= m * (m - 2) // 3
