"""Numbers of contacts in floats and integers."""

from fractions import Fraction

import pytest

from equilibrium.core.contacts import are_moderate, product, whole


@pytest.mark.parametrize("number", [Fraction(1, 10**300), Fraction(10**300), Fraction(10**400)])
def test_one_tiny_or_huge_number_is_not_moderate(number):
    assert are_moderate([Fraction(0), Fraction(-1, 3), Fraction(1)])
    assert not are_moderate([Fraction(1), number])
    assert not are_moderate([-number, Fraction(1)])


@pytest.mark.parametrize(("left", "right"), [(2**70, 0), (0, 2**70), (2**40, 2**40), (3, -5)])
def test_product_is_exact_beyond_machine_words(left, right):
    found = product(whole([left, left], (1, 2)), whole([right, right], (2, 1)))
    assert found.tolist() == [[2 * left * right]]
