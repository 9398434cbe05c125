"""Numbers come in exactly or not at all."""

import math
from decimal import Decimal
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
import sympy
from hypothesis import given, strategies as st

from arrangement import InputError, from_floats
from arrangement.numbers.exact import (
    common_digits,
    number_text,
    primitive,
    rational,
    shown,
    to_text,
)


@pytest.mark.ground_types
@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (7, Fraction(7)),
        (Fraction(7, 3), Fraction(7, 3)),
        ("7/3", Fraction(7, 3)),
        ("-14/6", Fraction(-7, 3)),
        ("+2", Fraction(2)),
        ("-0.25", Fraction(-1, 4)),
        ("-1e-3", Fraction(-1, 1000)),
        ("1.5E2", Fraction(150)),
        (".25e+1", Fraction(5, 2)),
        (".5", Fraction(1, 2)),
        ("-3.", Fraction(-3)),
        ("007", Fraction(7)),
        (sympy.Rational(7, 3), Fraction(7, 3)),
        (sympy.Integer(-4), Fraction(-4)),
        (sympy.Rational(1, 2), Fraction(1, 2)),
        (np.int64(5), Fraction(5)),
        (flint.fmpq(7, 3), Fraction(7, 3)),
        (flint.fmpz(10**30), Fraction(10**30)),
        (sympy.QQ(7, 3), Fraction(7, 3)),
        (sympy.ZZ(-3), Fraction(-3)),
    ],
)
def test_exact_numbers_of_every_kind_are_accepted(value, expected):
    number = rational(value)
    assert type(number) is Fraction
    assert number == expected
    assert type(number.numerator) is int


INEXACT: list[Any] = [True, np.True_, 0.5, np.float64(0.5), math.nan, math.inf, 1j, None, b"1", [1]]
INEXACT += [sympy.true, sympy.Float(0.5), sympy.pi, sympy.sqrt(2), sympy.nan, sympy.oo, sympy.zoo]


@pytest.mark.ground_types
@pytest.mark.parametrize("value", [*INEXACT, sympy.Symbol("x"), object()])
def test_what_is_not_an_exact_number_is_refused(value):
    with pytest.raises(InputError, match="friction"):
        rational(value, "friction")


#: Between bars.
BAD_TEXTS = " |1 | 1|1/ 2|1/0|1/-2|1//2|1/2/3|1.5/2|.|-|--1|1e|e5|1/2e3|1e+-5|1e0.5|1e10000"
BAD_TEXTS += "|1e999999999|0x10|1_000|nan|inf|2**3|1+1|１２|٣|1\n|__import__('os').system('false')|"


@pytest.mark.parametrize("text", [*BAD_TEXTS.split("|"), "9" * 100_001, "0." + "3" * 100_000])
def test_text_that_is_no_plain_number_is_refused(text):
    with pytest.raises(InputError) as caught:
        rational(text)
    assert len(str(caught.value)) < 300


def test_the_refusal_of_a_float_names_the_remedy():
    with pytest.raises(InputError, match="from_floats"):
        rational(0.1)


def test_floats_convert_to_the_binary_value_that_they_have():
    assert from_floats(0.1) == Fraction(3602879701896397, 2**55)
    assert from_floats(np.array([[0.5, -2.0]])) == ((Fraction(1, 2), Fraction(-2)),)
    assert from_floats([1, "1/3", 0.25]) == (Fraction(1), Fraction(1, 3), Fraction(1, 4))
    with pytest.raises(TypeError, match="1 positional argument"):
        from_floats([[1.0, 2.0]], [0.5])


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, [1.0, math.nan], "x", True])
def test_only_finite_floats_convert(value):
    with pytest.raises(InputError):
        from_floats(value)


@given(st.fractions())
def test_text_and_number_are_inverse(number):
    assert rational(to_text(number)) == number


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_conversion_of_a_float_is_exact(value):
    assert float(from_floats(value)) == value


@pytest.mark.parametrize("digits", [600, 1000, 4299, 4301, 20_000])
def test_integers_of_any_length_have_a_text(digits):
    number = (10**digits - 1) // 9 * 7
    assert to_text(number) == "7" * digits
    assert to_text(-number) == "-" + "7" * digits
    assert to_text(Fraction(1, 10**digits)) == "1/1" + "0" * digits


@given(st.fractions() | st.integers(), st.integers(1, 30), st.integers(-5000, 5000))
def test_displayed_number_is_exact_or_nearest(number, digits, power):
    number *= Fraction(10) ** power
    text = number_text(number, digits)
    near = Fraction(Decimal(text.removeprefix("≈"))) if "/" not in text else rational(text)
    if not text.startswith("≈"):
        assert near == number
        return
    assert len(to_text(number)) > 12
    assert near != number
    assert len(text) <= digits + 16
    size = Fraction(10) ** (Decimal(text[1:]).adjusted() - digits + 1)
    assert abs(near - number) <= size / 2


@given(st.fractions(), st.fractions(0, Fraction(1, 10**5)))
def test_common_digits_are_those_of_both_ends(low, length):
    high = low + length
    found = common_digits(low, high, 9)
    nearest = [
        [Fraction(f"{Decimal(x.numerator) / Decimal(x.denominator):.{k}e}") for x in (low, high)]
        for k in range(8, -1, -1)
    ]
    wanted = next((one for one, other in nearest if one == other), None)
    assert (None if found is None else Fraction(found)) == wanted


@given(st.lists(st.fractions(max_denominator=50), min_size=1, max_size=5))
def test_primitive_is_the_coprime_positive_multiple(vector):
    result = primitive(vector)
    assert all(type(x) is int for x in result)
    if not any(vector):
        assert not any(result)
        return
    assert math.gcd(*result) == 1
    position = next(i for i, x in enumerate(vector) if x)
    factor = result[position] / vector[position]
    assert factor > 0
    assert [factor * x for x in vector] == list(result)


def test_error_messages_stay_short_for_huge_values():
    nested: list[Any] = []
    for _ in range(100_000):
        nested = [nested]
    for value in (nested, 10**10_000, "x" * 10**6, list(range(10**5))):
        assert len(shown(value)) <= 60
