"""The engine for planes in R^3: the same faces as the general engine, and proven witnesses."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st

from arrangement import Arrangement, InputError
from arrangement.counts import f_vector
from arrangement.enumeration.affine_space import SpaceFaces, predicates, space_faces, witnesses
from arrangement.exact import sign
from arrangement.linear import determinant
from tests.arrangement.strategies import arrangements

NEAR = Fraction(1, 10**30)
HUGE = st.integers(-(2**300), 2**300)


def rows(signs: np.ndarray) -> list[tuple[int, ...]]:
    return [tuple(row) for row in signs.tolist()]


def assert_same_as_the_general_engine(planes: Arrangement) -> SpaceFaces:
    made = space_faces(planes)
    for dimension, signs in ((1, made.edges), (2, made.facets), (3, made.regions)):
        found = rows(made.plane_signs(signs))
        assert len(found) == len(set(found))
        assert set(found) == {face.signs for face in planes.faces(dimension)}
    assert made.f_vector == planes.f_vector
    assert_witnesses(made)
    return made


def assert_witnesses(made: SpaceFaces) -> None:
    points = made.witnesses()
    regions = rows(made.plane_signs(made.regions))
    assert [made.arrangement.signs_at(point) for point in points] == regions
    for row, point in zip(made.integer_witnesses().tolist(), points, strict=True):
        assert row[3] > 0
        assert point == tuple(Fraction(x, row[3]) for x in row[:3])


@st.composite
def degenerate(draw: st.DrawFn) -> Arrangement:
    """Planes through few directions and few points, moved by nothing or by a hair."""
    entry = st.integers(-1, 1)
    normal = st.tuples(entry, entry, entry).filter(any)
    pool = draw(st.lists(normal, min_size=1, max_size=4))
    chosen = draw(st.lists(st.sampled_from(pool), min_size=1, max_size=7))
    scales = st.sampled_from([1, -1, 3])
    normals, offsets = [], []
    for direction in chosen:
        scale, hair = draw(scales), draw(st.sampled_from([0, 0, NEAR, -NEAR]))
        normals.append([scale * x + hair * draw(entry) for x in direction])
        offsets.append(draw(entry) + draw(st.sampled_from([0, 0, NEAR])))
    return Arrangement(normals, offsets)


@st.composite
def huge(draw: st.DrawFn) -> Arrangement:
    """Planes with entries of up to 300 bits; the last ones are combinations of the first."""
    count = draw(st.integers(2, 4))
    given_rows = draw(st.lists(st.tuples(HUGE, HUGE, HUGE, HUGE), min_size=count, max_size=count))
    small = st.integers(-2, 2)
    for _ in range(draw(st.integers(0, 3))):
        weights = draw(st.lists(small, min_size=count, max_size=count))
        columns = zip(*given_rows[:count], strict=True)
        given_rows.append(
            tuple(sum(w * x for w, x in zip(weights, col, strict=True)) for col in columns)
        )
    kept = [row for row in given_rows if any(row[:3])]
    return Arrangement([row[:3] for row in kept], [row[3] for row in kept], dimension=3)


@settings(max_examples=150, deadline=None)
@given(arrangements(dimensions=(3, 3), planes=(0, 8)))
def test_faces_equal_those_of_the_general_engine(planes):
    assert_same_as_the_general_engine(planes)


@settings(max_examples=100, deadline=None)
@given(degenerate())
def test_faces_are_right_where_planes_nearly_coincide(planes):
    assert_same_as_the_general_engine(planes)


@settings(max_examples=60, deadline=None)
@given(huge())
def test_faces_are_right_for_entries_of_hundreds_of_bits(planes):
    assert_same_as_the_general_engine(planes)


@settings(max_examples=60, deadline=None)
@given(arrangements(dimensions=(3, 3), planes=(1, 7)), st.integers(0, 2**32))
def test_any_float_proposal_leads_to_the_same_faces(planes, seed):
    """Parameters drawn at random: only the determinants are left to find the order."""
    assume(planes.rank == 3)
    expected = space_faces(planes)
    generator = np.random.default_rng(seed)

    def hostile(table, i, j, triple, slopes):
        return np.where(triple == 0, np.inf, generator.normal(size=triple.shape))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("arrangement.enumeration.affine_space.lines._parameters", hostile)
        found = space_faces(planes)
        for name in ("edges", "facets", "regions"):
            assert set(rows(getattr(found, name))) == set(rows(getattr(expected, name)))
        assert found.f_vector == expected.f_vector
        assert_witnesses(found)


def random_planes(source: Random, count: int, central: int, bound: int) -> Arrangement:
    normals = [[source.randint(-bound, bound) for _ in range(3)] for _ in range(count)]
    offsets = [0] * central + [source.randint(1, bound) for _ in range(count - central)]
    return Arrangement([n if any(n) else [1, 0, 0] for n in normals], offsets)


@pytest.mark.parametrize(
    ("count", "central", "bound"),
    [(30, 15, 2**70), (30, 15, 9), (20, 0, 3), (24, 24, 4), (40, 20, 2), (70, 60, 50)],
)
def test_many_planes_have_the_number_of_faces_of_zaslavsky(count, central, bound):
    planes = random_planes(Random(count * bound), count, central, bound)
    made = space_faces(planes)
    assert made.f_vector == f_vector(planes)
    assert made.f_vector[1:] == (len(made.edges), len(made.facets), len(made.regions))
    facets = made.facets
    assert ((facets == 0).sum(axis=1) == 1).all()
    assert (made.regions != 0).all()


@settings(max_examples=60, deadline=None)
@given(arrangements(dimensions=(3, 3), planes=(1, 9)))
def test_both_sides_of_a_facet_are_regions(planes):
    made = space_faces(planes)
    regions = set(rows(made.regions))
    for side in (1, -1):
        assert set(rows(np.where(made.facets == 0, side, made.facets))) <= regions


@pytest.mark.parametrize("bound", [6, 2**80])
def test_every_witness_of_many_regions_lies_in_its_region(bound):
    assert_witnesses(space_faces(random_planes(Random(bound), 18, 9, bound)))


GRID = Arrangement(
    [[int(i == j) for j in range(3)] for i in range(3) for _ in range(3)], [0, 1, 2] * 3
)


def test_grid_of_cubes_has_known_faces():
    """Three planes in each direction: 3 vertices, 4 pieces on every axis line."""
    assert space_faces(GRID).f_vector == (27, 3 * 9 * 4, 3 * 3 * 16, 64)


@pytest.mark.parametrize(
    ("normals", "offsets", "expected"),
    [
        ([], None, (0, 0, 0, 1)),
        ([[0, 0, 2]], [5], (0, 0, 1, 2)),
        ([[0, 0, 2], [0, 0, -1], [0, 0, 1]], [4, -2, 3], (0, 0, 2, 3)),
        ([[1, 0, 0], [0, 1, 0], [1, 1, 0]], None, (0, 1, 6, 6)),
        ([[1, 0, 0], [0, 1, 0], [1, 1, 0]], [0, 0, 1], (0, 3, 9, 7)),
    ],
)
def test_planes_of_low_rank_have_no_vertices(normals, offsets, expected):
    planes = Arrangement(normals, offsets, dimension=3)
    assert assert_same_as_the_general_engine(planes).f_vector == expected


@pytest.fixture
def exact_work(monkeypatch):
    """Count the determinants that integers decide."""
    counted = []
    original = predicates.minors

    def counting(left, right):
        if left.dtype == object:
            counted.append(left[..., 0].size)
        return original(left, right)

    monkeypatch.setattr(predicates, "minors", counting)
    return counted


def hair_apart(exponent: int) -> Arrangement:
    normals = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [1, 2, 3]]
    hair = Fraction(1, 10**exponent)
    close = [[x + hair * (k + 1) for k, x in enumerate(normal)] for normal in normals]
    return Arrangement(normals + close, [0, 0, 0, 0, 0, hair, 0, 0, 0, hair])


def test_integers_decide_what_floats_cannot(exact_work, monkeypatch):
    """Planes 10^-30 apart have equal floats; counting shows that the exact paths are taken."""
    sorted_again, exact_points = [], []
    exact_order, exact_point = predicates.PlaneTable.exact_parameters, witnesses.exact_point
    monkeypatch.setattr(
        predicates.PlaneTable,
        "exact_parameters",
        lambda *args: sorted_again.append(1) or exact_order(*args),
    )
    monkeypatch.setattr(
        witnesses, "exact_point", lambda *args: exact_points.append(1) or exact_point(*args)
    )
    assert_same_as_the_general_engine(hair_apart(30))
    assert sum(exact_work) > 100
    assert sorted_again
    assert exact_points


def test_no_integers_are_needed_for_planes_through_the_origin_and_generic_ones(exact_work):
    """The crossings of all lines of central planes coincide; no determinant of them is in doubt."""
    planes = random_planes(Random(5), 16, 8, 2**40)
    made = space_faces(planes)
    assert made.f_vector == f_vector(planes)
    parallel_to_itself = 3 * len(planes)
    assert sum(exact_work) == parallel_to_itself


def test_entries_that_no_float_can_hold_are_decided_by_integers():
    """10^400 and 1 in one row: one of them would overflow or vanish."""
    far = 10**400
    planes = Arrangement(
        [[far, 1, 0], [far, 0, 1], [1, far, 0], [far, 1, 1], [0, 1, far], [1, 1, 1]],
        [1, far, 0, 0, far**2, -far],
    )
    made = assert_same_as_the_general_engine(planes)
    assert made.integer_witnesses().dtype == object


def test_different_rows_with_one_key_stay_different(monkeypatch):
    """More than 64 classes need two words; here their mixed keys are made to collide."""
    planes = random_planes(Random(3), 66, 66, 40)
    expected = space_faces(planes)
    monkeypatch.setattr(
        "arrangement.enumeration.affine_space.packing._keys", lambda rows: rows[:, 0] & np.uint64(7)
    )
    found = space_faces(planes)
    assert found.f_vector == expected.f_vector == f_vector(planes)
    assert set(rows(found.regions)) == set(rows(expected.regions))
    assert set(rows(found.facets)) == set(rows(expected.facets))


def test_arrays_are_read_only_and_equal_input_gives_equal_output():
    made, again = space_faces(GRID), space_faces(GRID)
    for name in ("edges", "facets", "regions"):
        array = getattr(made, name)
        assert array.dtype == np.int8
        assert np.array_equal(array, getattr(again, name))
        with pytest.raises(ValueError, match="read-only"):
            array[0, 0] = 1
    with pytest.raises(ValueError, match="read-only"):
        made.integer_witnesses()[0, 0] = 1
    assert made.witnesses() == again.witnesses()


@pytest.mark.parametrize("dimension", [1, 2, 4])
def test_other_dimensions_are_refused(dimension):
    with pytest.raises(InputError, match=rf"R\^{dimension}"):
        space_faces(Arrangement([], dimension=dimension))


@settings(max_examples=50, deadline=None)
@given(st.lists(st.integers(-(2**40), 2**40), min_size=4, max_size=4).filter(lambda r: any(r[:3])))
def test_a_plane_scaled_by_a_power_of_two_keeps_its_floats(row):
    first, _ = predicates.scaled_floats([tuple(row), (2**70, 1, 0, 0)])
    second, _ = predicates.scaled_floats([tuple(x << 900 for x in row), (2**70, 1, 0, 0)])
    assert np.array_equal(first, second)


@pytest.mark.parametrize("bound", [4_400, 4_405, 6_000, 8_000, 9_700])
def test_dependent_rows_with_entries_up_to_ten_thousand_have_determinant_zero(bound):
    """Above 4402 floats no longer hold all products: a bound that is too large shows here."""
    source = Random(f"dependent {bound}")
    for _ in range(250):
        rows = dependent_rows(source, bound)
        table = predicates.PlaneTable(rows)
        signs = table.quadruples(
            np.array([0]),
            np.array([1]),
            np.array([[2, 2]]),
            np.array([[3, 4]]),
            np.ones((1, 2), bool),
        )
        assert signs.tolist() == [[0, sign(determinant([*rows[:3], rows[4]]))]]


def dependent_rows(source, bound):
    """Return three rows with large entries, their combination a + b - c, and one beside it."""
    while True:
        a, b, c = (
            [source.choice((-1, 1)) * source.randint(bound // 2, bound) for _ in range(4)]
            for _ in range(3)
        )
        last = [x + y - z for x, y, z in zip(a, b, c, strict=True)]
        if max(map(abs, last)) < bound:
            beside = [*last[:3], last[3] + source.choice((-1, 1))]
            return [tuple(row) for row in (a, b, c, last, beside)]
