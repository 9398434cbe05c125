"""The engine for planes of rank 3: the same faces as the general engine, with exact points."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest
import sympy
from hypothesis import assume, given, settings, strategies as st

from arrangement import Arrangement
from arrangement.counts import f_vector
from arrangement.enumeration import affine_space
from arrangement.enumeration.affine_space import PlaneTable, scaled_floats
from arrangement.enumeration.choose import enumerate_faces
from arrangement.enumeration.sequence import FaceSequence
from arrangement.numbers.float_filter import EXACT, SMALLEST, UNIT, certain, error_bound, scale_rows
from tests.arrangement.strategies import arrangements
from tests.arrangement.test_engines import same_faces

NEAR = Fraction(1, 10**30)
HUGE = st.integers(-(2**300), 2**300)
#: The largest entry with ``24 B^4 <= 2^53``.
LARGEST = 4401


def rows(signs: np.ndarray) -> list[tuple[int, ...]]:
    return [tuple(row) for row in signs.tolist()]


def space_faces(planes: Arrangement) -> FaceSequence:
    """Return the faces by the engine under test; below rank 3 by the one that is chosen then."""
    return enumerate_faces(planes, "affine-space" if planes.rank == 3 else None)


def assert_same_as_the_general_engine(planes: Arrangement) -> FaceSequence:
    made = space_faces(planes)
    same_faces(made, enumerate_faces(planes, "any-dimension"), planes)
    assert_points(planes, made)
    return made


def assert_points(planes: Arrangement, made: FaceSequence) -> None:
    for row, signs, face in zip(made.points.tolist(), rows(made.signs), made, strict=True):
        assert row[-1] > 0
        point = tuple(Fraction(x, row[-1]) for x in row[:-1])
        assert planes.signs_at(point) == planes.signs_at(face.witness) == signs == face.signs
        assert point == face.witness or planes.is_central


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


@given(arrangements(dimensions=(3, 3), planes=(0, 8)))
def test_faces_equal_those_of_the_general_engine(planes):
    assert_same_as_the_general_engine(planes)


@pytest.mark.parametrize("sign", [1, -1])
def test_central_planes_of_rank_four_have_the_same_faces(sign):
    """The first plane is taken to infinity, with one that coincides with it."""
    normals = [[sign, 0, 0, 1], [-sign, 1, 0, 0], [2 * sign, 0, 0, 2], [0, 0, 1, 0], [0, 0, 0, 1]]
    planes = Arrangement(normals)
    made, expected = enumerate_faces(planes), enumerate_faces(planes, "any-dimension")
    assert made.engine == "affine-space"
    assert sorted(rows(made.signs)) == sorted(rows(expected.signs))
    assert (np.sign(made.points[:, :4] @ np.array(normals).T) == made.signs).all()


@given(degenerate())
def test_faces_are_right_where_planes_nearly_coincide(planes):
    assert_same_as_the_general_engine(planes)


@given(huge())
def test_faces_are_right_for_entries_of_hundreds_of_bits(planes):
    assert_same_as_the_general_engine(planes)


@given(arrangements(dimensions=(3, 3), planes=(1, 7)), st.integers(0, 2**32))
def test_any_float_proposal_leads_to_the_same_faces(planes, seed):
    """Parameters drawn at random: only the determinants are left to find the order."""
    assume(planes.rank == 3)
    expected = space_faces(planes)
    generator = np.random.default_rng(seed)

    def hostile(table, i, j, triple, slopes):
        return np.where(triple == 0, np.inf, generator.normal(size=triple.shape))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("arrangement.enumeration.affine_space._parameters", hostile)
        found = space_faces(planes)
        assert set(rows(found.signs)) == set(rows(expected.signs))
        assert found.f_vector == expected.f_vector
        assert_points(planes, found)


def random_planes(source: Random, count: int, central: int, bound: int) -> Arrangement:
    normals = [[source.randint(-bound, bound) for _ in range(3)] for _ in range(count)]
    offsets = [0] * central + [source.randint(1, bound) for _ in range(count - central)]
    return Arrangement([n if any(n) else [1, 0, 0] for n in normals], offsets)


@pytest.mark.parametrize(
    ("count", "central", "bound"),
    [(12, 6, 6), (12, 6, 2**18), (12, 6, 2**20), (12, 6, 2**80), (14, 0, 3), (16, 8, 2)],
)
def test_many_faces_have_points_and_the_number_of_zaslavsky(count, central, bound):
    """Up to 48 B^3 < 2^63 sums stay in int64; beyond, they are Python integers."""
    planes = random_planes(Random(count * bound), count, central, bound)
    made = space_faces(planes)
    assert_points(planes, made)
    assert made.f_vector == f_vector(planes)
    assert made.f_vector == tuple(len(made.of_dimension(k).signs) for k in range(4))
    largest = max(abs(x) for plane in planes.integer_planes for x in plane)
    assert (made.points.dtype == np.int64) == (48 * largest**3 < 2**63)


@pytest.fixture
def exact_work(monkeypatch):
    """Count the determinants that integers decide."""
    counted = []
    original = affine_space.minors

    def counting(left, right):
        if left.dtype == object:
            counted.append(left[..., 0].size)
        return original(left, right)

    monkeypatch.setattr(affine_space, "minors", counting)
    return counted


def hair_apart(exponent: int) -> Arrangement:
    normals = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [1, 2, 3]]
    hair = Fraction(1, 10**exponent)
    close = [[x + hair * (k + 1) for k, x in enumerate(normal)] for normal in normals]
    return Arrangement(normals + close, [0, 0, 0, 0, 0, hair, 0, 0, 0, hair])


def test_integers_decide_what_floats_cannot(exact_work, monkeypatch):
    """Planes 10^-30 apart have equal floats; counting shows that the exact paths are taken."""
    sorted_again = []
    exact_order = PlaneTable.exact_parameters
    monkeypatch.setattr(
        PlaneTable, "exact_parameters", lambda *args: sorted_again.append(1) or exact_order(*args)
    )
    assert_same_as_the_general_engine(hair_apart(30))
    assert sum(exact_work) > 100
    assert sorted_again


def test_central_and_generic_planes_need_no_integers(exact_work):
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
    assert made.points.dtype == object


def test_different_rows_with_one_key_stay_different(monkeypatch):
    """More than 64 classes need two words; here their mixed keys are made to collide."""
    planes = random_planes(Random(3), 66, 66, 40)
    expected = space_faces(planes)
    monkeypatch.setattr("arrangement.numbers.packing._keys", lambda rows: rows[:, 0] & np.uint64(7))
    found = space_faces(planes)
    assert found.f_vector == expected.f_vector == f_vector(planes)
    assert set(rows(found.signs)) == set(rows(expected.signs))


@given(st.lists(st.integers(-(2**40), 2**40), min_size=4, max_size=4).filter(lambda r: any(r[:3])))
def test_a_plane_scaled_by_a_power_of_two_keeps_its_floats(row):
    first, _ = scaled_floats([tuple(row), (2**70, 1, 0, 0)])
    second, _ = scaled_floats([tuple(x << 900 for x in row), (2**70, 1, 0, 0)])
    assert np.array_equal(first, second)


def test_unit_is_the_unit_roundoff():
    assert np.finfo(np.float64).eps / 2 == UNIT
    assert float(EXACT) + 1 == EXACT
    assert np.finfo(np.float64).tiny < SMALLEST**4 * UNIT


@settings(max_examples=60)
@given(st.lists(st.tuples(*[st.integers(-(2**80), 2**80)] * 2), min_size=1, max_size=6))
def test_a_certain_sign_is_the_true_sign(pairs):
    left, right = (np.array([float(x) for x in row]) for row in zip(*pairs, strict=True))
    exact = sum(x * y for x, y in pairs)
    value, size = left @ right, np.abs(left) @ np.abs(right)
    bound = error_bound(2 + 1 + len(pairs))
    assert abs(Fraction(float(value)) - exact) <= Fraction(bound) * Fraction(float(size))
    if certain(value, size, bound):
        assert np.sign(value) == (exact > 0) - (exact < 0)


def test_rows_with_too_small_entries_are_named():
    floats, usable = scale_rows([(2**201, 1), (2**200, 3), (2**900, 0), (0, 0)])
    assert usable.tolist() == [False, True, True, True]
    assert np.abs(floats).max() < 1


def dependent_rows(random: Random, size: int) -> list[tuple[int, ...]]:
    """Return four rows ``a, b, c, a + b - c`` with entries of about `size`, of either sign."""
    columns = []
    while len(columns) < 4:
        a, b, c = (random.choice((1, -1)) * random.randint(size // 2, size) for _ in range(3))
        if abs(a + b - c) <= size:
            columns.append((a, b, c, a + b - c))
    return list(zip(*columns, strict=True))


def wrong_signs(size: int, cases: int = 100) -> int:
    """Return how many signs of 4 x 4 determinants differ from the exact ones."""
    random, wrong = Random(size), 0
    for _ in range(cases):
        rows = dependent_rows(random, size)
        rows[3] = (*rows[3][:3], rows[3][3] + random.choice((0, 0, 1)))
        table = PlaneTable(rows)
        i, j = np.array([0]), np.array([1])
        k, l = np.array([[2]]), np.array([[3]])  # noqa: E741
        found = table.quadruples(i, j, k, l, np.ones((1, 1), bool))[0, 0]
        exact = int(sympy.Matrix(rows).det())
        wrong += int(found) != (exact > 0) - (exact < 0)
    return wrong


@pytest.mark.parametrize("size", [LARGEST, LARGEST + 1, 10**4, 10**5, 10**20])
def test_dependent_planes_have_exact_signs(size):
    assert wrong_signs(size) == 0


def test_the_bound_on_small_integers_ends_where_the_proof_does():
    assert 24 * LARGEST**4 <= EXACT < 24 * (LARGEST + 1) ** 4
    assert scaled_floats([(LARGEST, 1, 0, 0)])[1] == 0.0
    assert scaled_floats([(LARGEST + 1, 1, 0, 0)])[1] == affine_space.ERROR == 2.0**-49


def test_with_looser_bounds_signs_are_wrong(monkeypatch):
    """The same planes tell: they have wrong signs where floats are trusted too far."""
    monkeypatch.setattr(affine_space, "EXACT", 24 * 10**16)
    assert wrong_signs(10**4) > 0
    monkeypatch.undo()
    monkeypatch.setattr(affine_space, "ERROR", UNIT / 2)
    assert wrong_signs(10**20) > 0
