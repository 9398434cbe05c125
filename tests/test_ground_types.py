"""The suite says which arithmetic SymPy runs on; these tests hold that it is the one asked for."""

from __future__ import annotations

import os
from fractions import Fraction

import pytest
from sympy import QQ, ZZ
from sympy.external.gmpy import GROUND_TYPES

from arrangement import rational


def test_sympy_runs_on_the_ground_types_asked_for() -> None:
    asked = os.environ.get("SYMPY_GROUND_TYPES", "auto")
    if asked == "auto":
        pytest.skip("no ground types were asked for")
    assert asked == GROUND_TYPES


@pytest.mark.parametrize(
    ("element", "value"),
    [
        (ZZ(-7), Fraction(-7)),
        (ZZ(10**40), Fraction(10**40)),
        (QQ(7, -3), Fraction(-7, 3)),
        (QQ(10**40, 3), Fraction(10**40, 3)),
    ],
)
def test_elements_of_sympy_domains_are_read_exactly(element: object, value: Fraction) -> None:
    assert rational(element) == value
