"""Deletion, restriction, localization, cone, essentialization."""

from fractions import Fraction

import pytest
import sympy
from hypothesis import given, strategies as st

from arrangement import Arrangement, InputError, counts
from arrangement.counts.operations import flat_chart
from arrangement.numbers.exact import dot

from .oracle import T
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
        (counts.addition, ([0, 0],), r"normals\[3\] is the zero vector"),
        (counts.addition, ([1, 2, 3],), "3 entries and the dimension is 2"),
        (counts.addition, ([1, 2], 0.5), "offset is the float"),
        (counts.restriction, (3,), "does not exist"),
        (counts.deletion, (-1,), "does not exist"),
        (counts.deletion, (True,), "does not exist"),
    ],
)
def test_impossible_operations_say_why(operation, arguments, message):
    planes = Arrangement([[1, 0], [1, 0], [0, 1]], [0, 1, 0])
    with pytest.raises(InputError, match=message):
        operation(planes, *arguments)


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
    assert both.has_same_planes(added)
