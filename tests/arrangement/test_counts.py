"""Characteristic polynomial, Whitney numbers, face counts: known values, oracles and properties."""

import math
from itertools import product as iter_product
from random import Random

import numpy as np
import pytest
import sympy
from hypothesis import assume, given, settings
from sympy import sqrt

from arrangement import Arrangement, InputError, OutOfReachError, counts, families
from arrangement.counts import low_rank as lowrank, points, ratio_groups, whitney
from arrangement.counts.configuration import configuration

from . import oracle
from .oracle import T
from .strategies import arrangements


@given(arrangements(dimensions=(1, 5), planes=(0, 7)))
def test_subset_expansion_agrees(planes):
    assert counts.characteristic_polynomial(planes) == oracle.by_subsets(planes)


@settings(max_examples=40)
@given(arrangements(dimensions=(1, 5), planes=(0, 9)))
def test_low_rank_route_agrees_with_the_lattice(planes):
    config = configuration(planes)
    assume(config.rank <= lowrank.MAX_RANK)
    lattice = counts.intersection_lattice(planes)
    assert lowrank.whitney_matrix(config) == lattice.whitney_matrix


def test_near_degenerate_huge_planes_are_told_apart():
    huge = 10**30
    pencil = [[1, t * huge, 0] for t in range(4)]
    assert counts.f_vector(Arrangement([*pencil, [0, 0, 1]])) == (1, 10, 24, 16)
    # the last plane misses the common line of the pencil's planes by a hair
    off = Arrangement([*pencil, [1, 4 * huge, 1], [0, 0, 1]])
    on = Arrangement([*pencil, [1, 4 * huge, 0], [0, 0, 1]])
    assert counts.region_count(on) == 20
    assert counts.region_count(off) == 26


@pytest.mark.parametrize(("rank", "limit"), [(3, 2_147_483_647), (4, 1_154_107)])
def test_int64_is_used_up_to_the_bound_only(rank, limit):
    # sums of 2 or 6 products of rank - 1 entries must stay below 2^63
    products = {3: 2, 4: 6}[rank]
    assert products * limit ** (rank - 1) < 2**63 <= products * (limit + 1) ** (rank - 1)
    rows = [[int(i == j) for j in range(rank)] for i in range(rank)]
    for largest, expected in ((limit, np.dtype(np.int64)), (limit + 1, np.dtype(object))):
        planes = Arrangement([*rows, [largest] + [1] * (rank - 1)])
        assert lowrank._matrix(configuration(planes)).dtype == expected


@pytest.mark.parametrize(("rank", "limit"), [(3, 2_147_483_647), (4, 1_154_107)])
def test_counts_at_the_int64_bound_equal_those_beyond(rank, limit):
    signs = [(1, *rest) for rest in iter_product((1, -1), repeat=rank - 1)]
    rows = [[(limit - k) * s for k, s in enumerate(row)] for row in signs]
    axes = [[int(i == j) for j in range(rank)] for i in range(rank)]
    # the same planes in coordinates stretched by 10^20: entries far beyond the bound
    stretched = [[x * 10 ** (20 * j) for j, x in enumerate(row)] for row in rows + axes]
    near, beyond = configuration(Arrangement(rows + axes)), configuration(Arrangement(stretched))
    assert lowrank._matrix(near).dtype == np.int64
    assert lowrank._matrix(beyond).dtype == object
    assert lowrank.whitney_matrix(near) == lowrank.whitney_matrix(beyond)


@given(arrangements(dimensions=(1, 4), planes=(0, 8)))
def test_no_arrangement_exceeds_the_fukuda_bound(planes):
    n, d = len(planes.distinct), planes.dimension
    assert all(f <= counts.fukuda_bound(n, d, k) for k, f in enumerate(counts.f_vector(planes)))


@pytest.mark.parametrize(("n", "d"), [(n, d) for d in range(1, 5) for n in range(9)])
def test_simple_affine_arrangements_attain_the_bound(n, d):
    # t^d on the moment curve: no d + 1 of these planes share a point (Vandermonde)
    planes = Arrangement(
        [[t**k for k in range(d)] for t in range(1, n + 1)],
        [t**d for t in range(1, n + 1)],
        dimension=d,
    )
    bound = tuple(counts.fukuda_bound(n, d, k) for k in range(d + 1))
    assert counts.f_vector(planes) == bound


@pytest.mark.parametrize(("n", "d", "k"), [(-1, 3, 0), (3, 0, 0), (3, 2, 3), (3, 2, -1)])
def test_fukuda_bound_refuses_nonsense(n, d, k):
    with pytest.raises(InputError, match="give n >= 0"):
        counts.fukuda_bound(n, d, k)


def test_relative_bounded_regions_ignore_common_directions():
    strip = Arrangement([[1, 0], [1, 0]], [0, 1])
    assert counts.bounded_region_count(strip) == 0
    assert counts.bounded_region_count(strip, relative=True) == 1


def test_bounded_regions_of_a_triangle_and_of_its_prism():
    triangle = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])
    prism = Arrangement([[1, 0, 0], [0, 1, 0], [1, 1, 0]], [0, 0, 1])
    assert counts.bounded_region_count(triangle) == 1
    assert counts.bounded_region_count(triangle, relative=True) == 1
    assert counts.bounded_region_count(prism) == 0
    assert counts.bounded_region_count(prism, relative=True) == 1


def test_symmetric_planes_count_as_set_partitions(monkeypatch):
    """Flats are partitions of six things, faces ordered ones: Stirling numbers. No lattice."""
    monkeypatch.setattr(whitney, "intersection_lattice", None)
    planes = families.braid(6)
    first, second = (1, -15, 85, -225, 274, -120), (1, 15, 65, 90, 31, 1)
    assert counts.whitney_numbers(planes) == (first, second)
    assert counts.first_whitney_numbers(planes, time_limit=1000) == first
    faces = [math.factorial(6 - k) * number for k, number in enumerate(second)]
    assert counts.f_vector(planes) == (0, *reversed(faces))


def test_whitney_numbers_of_few_and_of_generic_planes():
    assert counts.whitney_numbers(families.braid(4)) == ((1, -6, 11, -6), (1, 6, 7, 1))
    found = counts.whitney_numbers(families.generic(8, 5, affine=True))
    assert found.second == tuple(math.comb(8, k) for k in range(6))
    assert found.first == tuple((-1) ** k * math.comb(8, k) for k in range(6))


def test_work_is_split_without_changing_the_sums(monkeypatch):
    planes = Arrangement(
        [row for row in np.ndindex(3, 3, 3) if any(row)],
        [sum(row) % 3 for row in np.ndindex(3, 3, 3) if any(row)],
    )
    whole = counts.doubly_indexed_whitney_numbers(planes)
    for entries in (64, 8):
        monkeypatch.setattr(ratio_groups, "_CHUNK", entries)
        assert counts.doubly_indexed_whitney_numbers(planes) == whole


def test_stretched_rank_4_planes_have_the_same_counts():
    rows = families.type_b(4).normals
    stretched = Arrangement([(x * sqrt(2), *rest) for x, *rest in rows])
    found = lowrank.whitney_matrix(configuration(stretched))
    assert found == lowrank.whitney_matrix(configuration(Arrangement(rows)))


def test_each_pair_of_columns_has_the_two_others():
    for pair, rest in zip(ratio_groups._COLUMN_PAIRS, ratio_groups._COLUMN_REST, strict=True):
        assert sorted([*pair, *rest]) == [0, 1, 2, 3]
    assert len({tuple(sorted(pair)) for pair in ratio_groups._COLUMN_PAIRS}) == 6


@pytest.mark.parametrize("root", [1, sqrt(2)])
def test_comparisons_of_flats_with_planes_are_foreseen(root, monkeypatch):
    """At most m^2 / 2 flats of rank 2, and in rank 4 each of them with all planes, if many.

    In rank 3 the slopes of later planes are sorted at each plane.

    Irrational numbers take ten times as long.
    """
    asked = []

    def check_cost(what, *_, **takes):
        if "flats of rank" in what:
            asked.append(takes)

    monkeypatch.setattr(lowrank.budget, "check_cost", check_cost)
    rational = root == 1
    factor = 2.5 if rational else 10 * 3.03 * 2.5

    def foreseen(m, rank):
        rows = [[root, *(t**k for k in range(1, rank))] for t in range(1, m + 1)]
        config = configuration(Arrangement(rows))
        del asked[:]
        lowrank.whitney_matrix(config)
        return asked

    def takes(comparisons, numbers):
        steps = pytest.approx(comparisons * factor, rel=0.04)
        return {"steps": steps, "bytes": pytest.approx(numbers, rel=0.05)}

    sorted_slopes = {"long_steps": pytest.approx(400 / 35)}
    assert foreseen(20, 3) == [sorted_slopes if rational else takes(200, 130 * 400)]
    assert foreseen(16, 4) == [takes(128, 130 * 256)]
    assert foreseen(20, 4) == [takes(20 * (190 if rational else 200), 0), takes(200, 130 * 400)]


@pytest.mark.parametrize("affine", [False, True])
def test_rank_2_flats_known_from_a_small_sample(affine):
    rows = [(1, *row) for row in np.ndindex(3, 2, 3)][:14]
    rows = [(1, -1, 0, 0), *rows, (0, 1, 1, 1)]
    planes = Arrangement([row[:3] for row in rows], [row[3] for row in rows])
    config = configuration(planes if affine else Arrangement(rows))
    assert (len(config.vectors), config.rank) == (16, 4)
    lines = len(lowrank.rank_two_groups(config).row)
    assert lowrank._about_rank_two(config) == pytest.approx(lines)


@pytest.mark.parametrize(
    "planes",
    [
        families.coxeter("F4"),
        families.random_degenerate(9, 3, seed=5, affine=True),
        Arrangement([], dimension=2),
        Arrangement([[1, 0], [-2, 0]]),
        families.h3(),
        families.simplicial(15, 5),
        Arrangement([[sqrt(2), 1], [1, sqrt(2)], [1, 0]], [0, sqrt(2), 5]),
    ],
    ids=str,
)
def test_points_over_finite_fields_give_the_polynomial(planes):
    assert counts.by_points(planes) == counts.characteristic_polynomial(planes)


@given(arrangements(dimensions=(1, 3), planes=(0, 6)))
def test_points_of_random_planes(planes):
    assert counts.by_points(planes) == oracle.by_subsets(planes)
    for q in range(1, 7):
        assert counts.points_off(planes, q) == oracle.points_by_hand(planes, q)


@pytest.mark.parametrize(
    ("planes", "expected"),
    [
        # Kamiya, Takemura, Terao 2008, examples: (q - 1)(q - 3) for odd q, (q - 2)^2 for even q
        (families.type_b(2), {1: (T - 1) * (T - 3), 2: (T - 2) ** 2}),
        (families.braid(4), {1: T * (T - 1) * (T - 2) * (T - 3)}),
        (families.type_b(3), {1: (T - 1) * (T - 3) * (T - 5), 2: (T - 2) * (T - 3) * (T - 4)}),
        (Arrangement([], dimension=2), {1: T**2}),
        (Arrangement([[2, 3], [1, 0], [4, 9]]), None),
        (families.coxeter("G2"), None),
    ],
)
def test_quasi_polynomial_counts_points_modulo_every_number(planes, expected):
    found = counts.characteristic_quasi_polynomial(planes)
    period = max(found)
    if expected:
        assert {g: sympy.expand(f.as_expr() - expected[g]) for g, f in found.items()} == (
            dict.fromkeys(expected, 0)
        )
    assert found[1] == counts.characteristic_polynomial(planes)
    for q in range(1, 14):
        assert found[math.gcd(q, period)].eval(q) == oracle.points_by_hand(planes, q)


@pytest.mark.parametrize("planes", [families.type_b(2), families.type_d(3), "random"])
def test_quasi_polynomial_from_sets_equals_that_from_points(planes, monkeypatch):
    if planes == "random":
        planes = Arrangement([[2, 4, 3], [3, 0, 2], [1, 2, 0], [0, 3, 5]])
    costs = {"sets": 1, "points": math.inf}
    found = {}
    for way, cost in costs.items():
        monkeypatch.setattr(points, "_points_steps", lambda *_, cost=cost: 1e300 / cost)
        monkeypatch.setattr(points, "_DIVISORS_STEPS", 1)
        quasi = counts.characteristic_quasi_polynomial(planes)
        found[way] = {g: quasi[g] for g in quasi if g < 40}
        assert ("_sets" in vars(quasi)) == (way == "sets")
    assert found["sets"] == found["points"]


def test_quasi_polynomial_of_a_long_period_needs_no_list_of_divisors():
    source = Random(1)
    planes = Arrangement([[source.randint(-99, 99) for _ in range(3)] for _ in range(7)])
    quasi = counts.characteristic_quasi_polynomial(planes)
    assert quasi[1] == counts.characteristic_polynomial(planes)
    assert all(quasi(q) == counts.points_off(planes, q) for q in range(1, 30))
    assert quasi(quasi.period + 1) == quasi[1].eval(quasi.period + 1)
    assert len(quasi) > 10**17
    with pytest.raises(OutOfReachError, match=r"polynomials of .*look up those that you need"):
        list(quasi)
    for key in (0, -1, quasi.period + 1, "1"):
        with pytest.raises(KeyError):
            quasi[key]
    with pytest.raises(InputError, match="q is 0; give an integer"):
        quasi(0)
    long = Arrangement([[10**40 + 7, 3], [1, 10**41 + 3], [10**30 + 1, 10**20 + 9]])
    with pytest.raises(OutOfReachError, match="divisors of the period"):
        len(counts.characteristic_quasi_polynomial(long))


def test_planes_without_a_quasi_polynomial_are_refused():
    for planes in (families.shi(3), families.h3()):
        with pytest.raises(InputError, match="rational planes through the origin"):
            counts.characteristic_quasi_polynomial(planes)
    for q in (0, -3, "5", True):
        with pytest.raises(InputError, match="give an integer, at least 1"):
            counts.points_off(families.shi(2), q)


def test_primes_of_bad_reduction_are_refused():
    planes = Arrangement([[1, 0], [0, 1], [1, 1], [1, -1]])
    with pytest.raises(InputError, match=r"bad reduction: modulo 2 the planes \[2, 3\]"):
        counts.by_points(planes, [2, 5])
    for number in (4, "7"):
        with pytest.raises(InputError, match=r"[47]'? is not a prime"):
            counts.by_points(planes, [3, number])
    with pytest.raises(InputError, match="give at least 2"):
        counts.by_points(planes, [3, 3])
    with pytest.raises(InputError, match=r"too many steps|too large for words"):
        counts.points_off(planes, 2**61 - 1)
    assert counts.by_points(planes, [3, 5]) == counts.characteristic_polynomial(planes)
    with pytest.raises(InputError, match="no image modulo 7"):
        counts.by_points(families.h3(), [7, 11, 19])
    with pytest.raises(InputError, match="bad reduction: modulo 2"):
        counts.by_points(families.simplicial(17, 8), [2, 7, 17])


def test_a_space_of_one_point_has_it_off_no_plane():
    nothing = Arrangement([], dimension=0)
    assert counts.points_off(nothing, 3) == 1
    assert counts.by_points(nothing, [3]) == counts.by_points(nothing) == sympy.Poly(1, T)


@pytest.mark.parametrize("entries", [1, 30])
def test_points_are_counted_in_portions(entries, monkeypatch):
    monkeypatch.setattr(points, "_CHUNK", entries)
    for planes in (families.shi(3), families.random_integer(4, 3, bound=2, seed=1)):
        assert counts.points_off(planes, 7) == oracle.points_by_hand(planes, 7)


def test_primes_are_taken_up_to_words_of_64_bits():
    pair = Arrangement([[1], [1]], [0, 5])
    last = sympy.prevprime(math.isqrt(2**63))
    assert counts.points_off(pair, last) == last - 2
    with pytest.raises(InputError, match="too large for words of 64 bits in dimension 1"):
        counts.points_off(pair, sympy.nextprime(last))
    with pytest.raises(InputError, match="too large for words of 64 bits in dimension 2"):
        counts.points_off(families.generic(3, 2), sympy.nextprime(2**31))


def test_a_prime_is_good_if_it_leaves_each_basis_one_minor():
    """On a line of a plane: the minors are 2 and 3, so none of them decides alone."""
    for row in ([2, 3], [3, 2], [0, 2, 3]):
        planes = Arrangement([row])
        chi = counts.characteristic_polynomial(planes)
        assert counts.by_points(planes, [2, 3, 5]) == chi
    square = Arrangement([[1, 0], [0, 1]], [0, 1])
    assert counts.by_points(square, [2, 3]) == counts.characteristic_polynomial(square)
    parallel = Arrangement([[1, 0], [1, 2]], [0, 1])
    with pytest.raises(InputError, match=r"modulo 2 the planes \[0, 1\] meet"):
        counts.by_points(parallel, [2, 3])
    with pytest.raises(InputError, match=r"modulo 5 the planes \[0, 1\] meet"):
        counts.by_points(Arrangement([[1, 0], [1, 0]], [0, 5]), [3, 5])


def test_points_and_bases_are_foreseen(monkeypatch):
    """Steps: lines of the space times planes, times rank cubed."""
    asked = []
    monkeypatch.setattr(
        points.budget, "check_cost", lambda what, *_, **takes: asked.append((what, takes))
    )

    def steps(planes, word):
        del asked[:]
        counts.by_points(planes, [5, 7, 11])
        return [takes["steps"] for what, takes in asked if word in what]

    assert steps(families.generic(4, 3), "points of (Z/5)^3") == [pytest.approx(5**2 * 4 / 10)]
    assert steps(Arrangement([], dimension=2), "points of (Z/11)^2") == [pytest.approx(11 / 10)]
    assert steps(families.generic(4, 3), "bases of 4") == [pytest.approx(4 * 5**3 * 4)]
    affine = families.generic(4, 2, affine=True)
    assert steps(affine, "bases of 4") == [pytest.approx(10 * 5**3 * 4)]


@pytest.mark.parametrize("affine", [False, True])
def test_slopes_that_share_no_hash_need_no_sort(affine, monkeypatch):
    """Rows of any length, with and without equal slopes, 0 with either sign, and infinite ones."""
    source = Random(f"slopes {affine}")
    for entries in (3, 40, 10**6):
        parts = [
            np.array([[source.randint(-entries, entries) for _ in range(300)] for _ in range(5)])
            for _ in range(2)
        ]
        sorted_sums = ratio_groups.equal_slopes(parts, affine)
        with monkeypatch.context() as patch:
            patch.setattr(ratio_groups, "_MIN_HASHED", 0)
            assert ratio_groups.equal_slopes(parts, affine) == sorted_sums
            # Where all share a hash all are sorted.
            patch.setattr(ratio_groups, "_HASH_FACTOR", np.uint64(0))
            assert ratio_groups.equal_slopes(parts, affine) == sorted_sums


@pytest.mark.parametrize("size", [1, 3, 4871, 4872, 10**6, 2 * 10**9, 10**12])
@pytest.mark.parametrize("affine", [False, True])
def test_flats_of_rank_two_by_slopes_are_those_by_exact_groups(size, affine):
    draw = Random(size + affine)
    for m in (3, 5, 9, 14):
        rows = [[draw.randint(-size, size) for _ in range(3)] for _ in range(m)]
        rows += [[x + y for x, y in zip(*draw.sample(rows, 2), strict=True)] for _ in range(m // 2)]
        normals = [row[:2] if affine else row for row in rows]
        kept = [k for k, normal in enumerate(normals) if any(normal)]
        offsets = [rows[k][2] for k in kept] if affine else None
        config = configuration(Arrangement([normals[k] for k in kept], offsets))
        if config.rank == 3:
            groups = lowrank.rank_two_groups(config)
            planes = int(groups.size.sum()) + len(groups.row)
            assert lowrank._rank_two_sums(config) == (len(groups.row), planes)
