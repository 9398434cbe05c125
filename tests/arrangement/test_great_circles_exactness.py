"""Exactness: hostile float proposals, cuts at 0 and pi, overflow, long and close entries."""

import random
from itertools import permutations

import numpy as np
import pytest

from arrangement import Arrangement
from arrangement.counts import region_count
from arrangement.enumeration.great_circles import incidence, predicates, sphere_arrangement
from arrangement.enumeration.great_circles.predicates import (
    ExactSigns,
    FilteredSigns,
    along_rows,
    integer_array,
    turns,
)
from arrangement.numbers.float_filter import error_bound, signs_of
from arrangement.numbers.linear.rank import cross, triple_product
from tests.arrangement.test_great_circles import B3, GENERIC, NEAR_PENCIL, PENCIL

Normals = list[tuple[int, ...]]


def sorted_as(normals: Normals, dtype: type) -> incidence.Crossings:
    return incidence.sort_crossings(np.array(normals, dtype=dtype))


def assert_same_crossings(normals: Normals) -> None:
    fast, slow = sorted_as(normals, np.int64), sorted_as(normals, object)
    assert np.array_equal(fast.tied, slow.tied)
    place = np.cumsum(~fast.tied, axis=1).tolist()
    for fast_row, slow_row, places in zip(fast.order, slow.order, place, strict=True):
        assert set(zip(places, fast_row, strict=True)) == set(zip(places, slow_row, strict=True))


def assert_same_incidence(normals: Normals, monkeypatch: pytest.MonkeyPatch, **patches) -> None:
    """Check that the half-edges stay the same with some of `ExactSigns` or `crossings` replaced."""
    expected = vars(sphere_arrangement(Arrangement(normals)).incidence)
    for name, value in patches.items():
        monkeypatch.setattr(incidence if name.isupper() else ExactSigns, name, value)
    found = vars(sphere_arrangement(Arrangement(normals)).incidence)
    for name, array in expected.items():
        assert np.array_equal(array, found[name]), name


def farey(largest: int, count: int) -> Normals:
    """Planes whose crossings with (1, 0, 0) have slopes as close as entries of this size allow."""
    y, z, rows = largest - 1, largest, [(1, 0, 0)]
    for _ in range(count):
        inverse = pow(y, -1, z)  # y' / z' with y z' - y' z = 1, z' < z
        rows += [(3, y, z), (5, y, z)]
        y, z = (y * inverse - 1) // z, inverse
        if z < 3:
            break
    return rows


CLOSE = [B3, GENERIC, NEAR_PENCIL, PENCIL, farey(131_071, 9), farey(1_154_009, 9)]


@pytest.mark.parametrize("normals", CLOSE)
@pytest.mark.parametrize("seed", range(3))
def test_any_unreliable_slopes_lead_to_the_same_arrangement(normals, seed, monkeypatch):
    generator = np.random.default_rng(seed)
    true_slopes = ExactSigns.slopes

    def hostile(self, block):
        slopes, backward = true_slopes(self, block)
        return generator.permuted(
            np.tile(np.arange(len(slopes.T) * 1.0), (len(slopes), 1)), axis=1
        ), backward

    assert_same_incidence(normals, monkeypatch, slopes=hostile, reliable=False)


@pytest.mark.parametrize("normals", CLOSE)
def test_reliable_slopes_may_be_wrong_by_four_units_of_roundoff(normals, monkeypatch):
    generator = np.random.default_rng(4)
    true_slopes = ExactSigns.slopes

    def shaken(self, block):
        slopes, backward = true_slopes(self, block)
        return slopes * (1 + generator.choice([-4, 4], slopes.shape) * 2.0**-53), backward

    assert_same_incidence(normals, monkeypatch, slopes=shaken)


@pytest.mark.parametrize("normals", CLOSE)
@pytest.mark.parametrize("bits", [12, 20, 40, 51])
def test_slopes_with_few_bits_left_lead_to_the_same_arrangement(normals, bits, monkeypatch):
    assert_same_incidence(normals, monkeypatch, LEAST_BITS=bits)


@pytest.mark.parametrize("normals", CLOSE)
def test_blocks_of_one_circle_lead_to_the_same_arrangement(normals, monkeypatch):
    assert_same_incidence(normals, monkeypatch, BLOCK=1)


def test_one_circle_has_no_crossing_and_two_have_one():
    orders = [sorted_as(B3[:count], np.int64).order for count in range(3)]
    assert [order.shape for order in orders] == [(0, 0), (1, 0), (2, 1)]
    assert orders[2].tolist() == [[1], [0]]
    assert set(sorted_as(B3, np.int64).turn.flat) == {1, -1}


def test_entries_are_taken_along_rows_of_any_length():
    values, columns = np.arange(10).reshape(2, 5), np.array([[4, 0, 3], [1, 1, 2]])
    assert along_rows(values, columns).tolist() == [[4, 0, 3], [6, 6, 7]]


def test_bounds_are_those_of_their_derivations():
    """Roundings of entries, products and sums; two slopes that are each wrong by up to 4 steps."""
    assert FilteredSigns.error == error_bound(3 + 2 + 3)
    assert 2**incidence.LEAST_BITS > 2 * 4 >= 2 ** (incidence.LEAST_BITS - 1)


def test_angular_cut_at_zero_and_pi_is_decided_exactly():
    """Crossings at the ends of the half circle, and others a hair away on both sides."""
    tiny = 10**6
    normals = [(0, 0, 1), (1, 0, 0), (0, 1, 0)]
    normals += [(tiny, sign, 0) for sign in (1, -1)] + [(tiny - 1, sign, 0) for sign in (1, -1)]
    normals += [(tiny, sign, 1) for sign in (1, -1)] + [(1, sign * tiny, 0) for sign in (1, -1)]
    assert_same_crossings(normals)
    planes = Arrangement(normals)
    made = sphere_arrangement(planes)
    made.validate()
    assert made.region_count == region_count(planes)
    scaled = [tuple(x * 10**30 + (x != 0) for x in normal) for normal in normals]
    far = sphere_arrangement(Arrangement(scaled))
    far.validate()
    assert far.region_count == region_count(Arrangement(scaled))


def test_degenerate_vertices_do_not_overflow_int64():
    """Products of four entries near 10^6 would pass 2^63; only products of three are formed."""
    u, w = (1000, 999, -998), (-997, 1001, 995)
    axis = np.cross(u, w).tolist()
    pencil = [tuple(500 * a + t * b for a, b in zip(u, w, strict=True)) for t in range(-99, 100, 9)]
    others = [(999_983, -999_979, 999_961), (-999_959, 3, 999_953), (7, 999_931, 999_917)]
    normals = [*pencil, *others]
    assert integer_array(normals).dtype == np.int64
    assert any((24 * max(map(abs, normal)) ** 4) > 2**63 for normal in normals)
    planes = Arrangement(normals)
    made = sphere_arrangement(planes)
    made.validate()
    assert made.region_count == region_count(planes)
    poles = [v for v in range(made.vertex_count) if not any(np.cross(made.ray(v), axis))]
    assert [len(made.incidence.circles_at(pole)) for pole in poles] == [len(pencil)] * 2


def test_int64_is_used_up_to_its_proven_bound_and_not_beyond():
    largest = max(b for b in range(1_150_000, 1_160_000) if 6 * b**3 < 2**63)
    extreme = [(largest, largest, -largest), (largest, -largest, largest)]
    assert integer_array(extreme).dtype == np.int64
    assert integer_array([(largest + 1, 0, 0)]).dtype == object
    # Slopes are made of floats as long as their numerators are exact in them.
    for size, dtype in ((2**17, np.float64), (2**17 + 1, np.int64)):
        assert ExactSigns(integer_array([(-size, 1, 0), (0, 1, 0)]))._columns.dtype == dtype


@pytest.mark.parametrize("seed", range(3))
def test_crossings_equal_in_int64_and_python_integers(seed):
    generator = random.Random(seed)
    largest = 1_154_000
    normals = [
        (
            generator.randint(largest - 3, largest),
            *generator.choices([-largest, largest - 1, 7], k=2),
        )
        for _ in range(25)
    ]
    normals = list(dict.fromkeys(normals))
    assert integer_array(normals).dtype == np.int64
    assert_same_crossings(normals)


def test_thirty_digit_entries_are_exact():
    generator = random.Random(30)
    digits = 10**30
    normals = [tuple(generator.randint(-digits, digits) for _ in range(3)) for _ in range(40)]
    made = sphere_arrangement(Arrangement(normals))
    made.validate()
    assert made.rays.dtype == object
    assert made.region_count == 40 * 39 + 2
    for region in generator.sample(range(made.region_count), 20):
        bits = np.unpackbits(made.packed_region_signs[region], count=40)
        assert [1 if bit else -1 for bit in bits] == list(made.region_signs(region))


@pytest.mark.parametrize("scale", [10**9, 10**30, 10**400])
def test_differences_of_one_part_in_a_scale_are_seen(scale):
    """Planes as close as 1 / scale: three through one line, then one of them moved by a hair."""
    pencil = [(scale, 1, 0), (scale, 2, 0), (scale, 3, 0), (0, 0, 1), (0, 1, 5)]
    moved = [*pencil[:2], (scale, 3, 1), *pencil[3:]]
    for normals, vertices in ((pencil, 16), (moved, 20)):
        made = sphere_arrangement(Arrangement(normals))
        made.validate()
        assert made.region_count == region_count(Arrangement(normals))
        assert made.vertex_count == vertices


@pytest.mark.parametrize("power", range(299, 311))
def test_slopes_at_the_ends_of_floats_stay_below_that_of_a_circle_with_itself(power):
    huge = 10**power
    planes = Arrangement([[-3, -4, 0], [-8 * huge, 6 * huge, -1], [0, 0, 1]])
    assert sphere_arrangement(planes).region_count == 8


def test_minors_of_1_beyond_int64_are_seen():
    """Floats lose them; numbers of 30 and of 22 bits leave them far from 0."""
    s, t = 3_000_000, 2_900_000
    unimodular = [(s + 1, s, t), (s + 2, s + 1, t + 1), (s, s - 1, t)]
    for normals in (farey(2**30 - 1, 4), unimodular):
        assert integer_array(normals).dtype == object
        signs, circles = FilteredSigns(integer_array(normals)), range(len(normals))
        _, backward = signs.slopes(slice(0, None))
        for i, j, k in permutations(circles, 3):
            assert backward[i, j] == (cross(normals[i], normals[j]) < (0, 0, 0))
            (found,) = signs.determinants(*np.array([[i], [j], [k]]))
            assert found == np.sign(triple_product(normals[i], normals[j], normals[k]))


def test_the_error_of_a_determinant_counts_all_six_products(monkeypatch):
    sizes = []
    monkeypatch.setattr(predicates, "certified_signs", lambda _, size, *others: sizes.append(size))
    signs = FilteredSigns(np.array([(1, 1, 1), (1, 2, 3), (3, 1, 2)], object))
    signs.determinants(*np.array([[0], [1], [2]]))
    assert sizes == [25 / (2 * 4 * 4)]


def test_turns_are_lexicographic_signs():
    x, y, z = np.array([[0, 0, 0], [0, 0, -5], [0, 2, -5], [-1, 9, 9], [3, -1, 0]]).T
    assert turns((x, y, z)).tolist() == [0, -1, 1, -1, 1]
    assert signs_of(np.array([10**40, 0, -(10**40)], dtype=object)).tolist() == [1, 0, -1]
