"""Deletion, restriction, localization, cone, essentialization."""

from collections import Counter
from fractions import Fraction
from itertools import combinations
from random import Random

import pytest
import sympy
from hypothesis import given, strategies as st

from arrangement import Arrangement, InputError, counts
from arrangement.counts.configuration import (
    PRIME,
    configuration,
    flats_foreseen,
    is_generic,
    pivot_columns,
)
from arrangement.counts.operations import flat_chart
from arrangement.numbers.exact import dot

from .oracle import T, rank
from .strategies import RATIONALS, arrangements


@given(arrangements(dimensions=(1, 4), planes=(1, 6)), st.data())
def test_deletion_keeps_the_others_in_order(planes, data):
    gone = data.draw(st.sets(st.integers(0, len(planes) - 1)))
    kept = [p for i, p in enumerate(planes.integer_planes) if i not in gone]
    assert list(counts.deletion(planes, gone).integer_planes) == kept
    assert counts.deletion(planes, gone).dimension == planes.dimension


@given(arrangements(dimensions=(2, 4), planes=(1, 6)), st.data())
def test_restriction_sees_the_signs_of_the_flat(planes, data):
    chosen = data.draw(st.integers(0, len(planes) - 1))
    chart = flat_chart(planes, chosen)
    y = data.draw(st.lists(RATIONALS, min_size=len(chart.basis), max_size=len(chart.basis)))
    x = [
        start + sum((c * v[j] for c, v in zip(y, chart.basis, strict=True)), Fraction(0))
        for j, start in enumerate(chart.origin)
    ]
    everywhere = planes.signs_at(x)
    assert everywhere[chosen] == 0
    crossing = [
        sign
        for sign, plane in zip(everywhere, planes.integer_planes, strict=True)
        if any(dot(plane[:-1], v) for v in chart.basis)
    ]
    assert list(counts.restriction(planes, chosen).signs_at(y)) == crossing


@given(arrangements(dimensions=(1, 4), planes=(1, 6)))
def test_localization_is_the_flat_and_carries_its_moebius_value(planes):
    for flat, value in counts.moebius(planes).items():
        local = counts.localization(planes, flat.planes)
        assert local.integer_planes == tuple(planes.integer_planes[i] for i in flat.planes)
        assert counts.whitney_numbers(local).first[-1] == value


@given(arrangements(dimensions=(1, 4), planes=(1, 6)), st.data())
def test_cone_repeats_the_arrangement_at_height_one(planes, data):
    d = planes.dimension
    x = data.draw(st.lists(RATIONALS, min_size=d, max_size=d))
    cone = counts.cone(planes)
    assert cone.is_central
    assert cone.signs_at([*x, 1]) == (*planes.signs_at(x), 1)


@given(arrangements(dimensions=(1, 4), planes=(0, 6)))
def test_essentialization_has_full_rank_and_the_same_faces(planes):
    essential = counts.essentialization(planes)
    assert essential.dimension == essential.rank == planes.rank
    assert {f.signs for f in essential.faces()} == {f.signs for f in planes.faces()}
    shift = planes.dimension - planes.rank
    assert counts.f_vector(planes) == (0,) * shift + counts.f_vector(essential)


@pytest.mark.parametrize(
    ("operation", "arguments", "message"),
    [
        (counts.restriction, ([0, 1],), "no common point"),
        (counts.localization, ([0, 1],), "no common point"),
        (counts.union, (Arrangement([[1]]),), r"R\^2 and of R\^1 have no union"),
        (counts.addition, ([0, 0],), r"normal 4 is the zero vector"),
        (counts.addition, ([1, 2, 3],), "3 entries and the dimension is 2"),
        (counts.addition, ([1, 2], 0.5), "offset is the float"),
        (counts.restriction, (3,), "does not exist"),
        (counts.deletion, (-1,), "does not exist"),
        (counts.deletion, (True,), "does not exist"),
        (counts.deletion, ("x = 0",), "plane 'x = 0' does not exist"),
        (
            counts.restriction,
            tuple(Arrangement([[1, 0]], [7])),
            "plane <Hyperplane: x = 7> does not",
        ),
    ],
)
def test_impossible_operations_say_why(operation, arguments, message):
    planes = Arrangement([[1, 0], [1, 0], [0, 1]], [0, 1, 0])
    with pytest.raises(InputError, match=message):
        operation(planes, *arguments)


def test_planes_may_be_given_as_a_list():
    planes = Arrangement([[1, 0], [1, 0], [0, 1]], [0, 1, 0])
    assert planes.deletion([0, 2]) == planes.deletion(0, 2) == planes[1:2]
    assert planes.deletion(*planes[::2]) == counts.deletion(planes, planes[::2]) == planes[1:2]
    assert planes.restriction(planes[1]) == counts.restriction(planes, planes[1])
    assert planes.restriction(planes[1]) == planes.restriction(1)
    assert planes[:2].addition(planes[2]) == planes
    assert planes[:1].addition(planes[1]) == planes[:2]
    assert planes.restriction([0]) == planes.restriction(0)
    assert planes.localization([0, 2]) == planes.localization(0, 2)


@given(arrangements(dimensions=(1, 4), planes=(0, 5)))
def test_deletion_and_restriction_run_to_their_end(planes):
    """Down to spaces without planes, R^0 among them, they give the characteristic polynomial."""

    def chi(rest):
        if not len(rest):
            return sympy.Poly(T**rest.dimension, T, domain=sympy.ZZ)
        last = rest.distinct[-1]
        return chi(counts.deletion(rest, last)) - chi(counts.restriction(rest, last))

    assert chi(planes) == counts.characteristic_polynomial(planes)


@given(arrangements(dimensions=(2, 2), planes=(0, 5)), arrangements(dimensions=(2, 2)))
def test_a_union_has_the_planes_of_both_once(one, other):
    both = counts.union(one, other)
    assert both.integer_planes[: len(one)] == one.integer_planes
    assert both.has_same_planes(counts.union(other, one))
    added = one
    for normal, offset in zip(other.normals, other.offsets, strict=True):
        added = counts.addition(added, normal, offset)
    assert added.integer_planes == one.integer_planes + other.integer_planes
    assert counts.addition(one, [2, 4]).integer_planes[-1] == (1, 2, 0)
    assert both.has_same_planes(added)


def test_vectors_are_generic_when_no_largest_minor_is_0():
    source, found = Random(3), Counter()
    for _ in range(150):
        d, affine = source.randint(1, 4), source.random() < 0.4
        rows = [[source.randint(-4, 4) or 1 for _ in range(d + 1)] for _ in range(d + 2)]
        rows = rows[: source.randint(1, d + 2)]
        planes = Arrangement([row[:-1] for row in rows], [affine * row[-1] for row in rows])
        config = configuration(planes)
        vectors = [*config.vectors, *([config.infinity] if affine else [])]
        bases = combinations(vectors, config.rank)
        generic = all(rank(chosen) == config.rank for chosen in bases)
        assert is_generic(config) == generic
        found[generic, affine, len(vectors) - config.rank] += 1
    assert len(found) > 8


def test_minors_divisible_by_a_prime_are_computed_exactly():
    assert is_generic(configuration(Arrangement([[1, 0], [0, 1], [PRIME, 1]])))
    affine = Arrangement([[1, 0], [0, 1], [PRIME, 1]], [0, 0, 1])
    assert is_generic(configuration(affine))
    zero = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [PRIME, 1, 0]])
    assert not is_generic(configuration(zero))


def test_vectors_that_may_not_be_generic_are_not_said_to_be():
    # Modulo the prime the rank is smaller.
    assert not is_generic(configuration(Arrangement([[1, 0], [1, PRIME], [2, PRIME]])))
    root = sympy.sqrt(2)
    assert is_generic(configuration(Arrangement([[1, root], [root, 1]])))
    assert not is_generic(configuration(Arrangement([[1, root], [root, 1], [1, 0]])))
    assert not is_generic(configuration(Arrangement([[1, 0], [1, 0], [2, 1]], [0, 1, 0])))


def test_irrational_planes_have_factors():
    root = sympy.sqrt(2)
    planes = Arrangement([[1, root, 0, 0], [0, 0, 1, root], [root, 1, 0, 0], [1, 1, 0, 0]])
    assert [len(part) for part in counts.irreducible_factors(planes)] == [1, 3]


@pytest.mark.parametrize("times", [1, 4])
def test_columns_that_a_prime_divides_are_seen(times):
    rows = [(1, 0), (1, PRIME), (2, PRIME)] * times
    assert pivot_columns(rows, 2) == (0, 1)
    assert pivot_columns([(0, 2 * y, x, x + y) for x, y in rows], 4) == (1, 2)


def test_flats_are_foreseen_from_the_share_of_general_position():
    assert flats_foreseen(10, 3, 2, 45) == 120
    assert flats_foreseen(10, 2, 2, 20) == pytest.approx(20)
    assert flats_foreseen(10, 4, 2, 45 / 4) == pytest.approx(210 / 2**12)
    assert flats_foreseen(10, 4, 3, 120 / 2**6) == pytest.approx(210 / 2**12)
    assert flats_foreseen(7, 3, 1, 7) == flats_foreseen(7, 3, 0, 1) == 35
    assert flats_foreseen(8, 2, 1, 4) == pytest.approx(28 / 2**2)
    assert (flats_foreseen(1, 1, 2, 0), flats_foreseen(1, 2, 2, 0)) == (1, 0)
