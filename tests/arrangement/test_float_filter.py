"""The float filter: what it calls certain is true, and no bound can be loosened unnoticed."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import numpy as np
import pytest
import sympy
from hypothesis import given, settings, strategies as st

from arrangement.enumeration.affine_space import predicates
from arrangement.enumeration.affine_space.predicates import PlaneTable, scaled_floats
from arrangement.numbers.float_filter import EXACT, SMALLEST, UNIT, certain, error_bound, scaled

#: The largest entry with ``24 B^4 <= 2^53``.
LARGEST = 4401


def test_unit_is_the_unit_roundoff() -> None:
    assert np.finfo(np.float64).eps / 2 == UNIT
    assert float(EXACT) + 1 == EXACT
    assert np.finfo(np.float64).tiny < SMALLEST**4 * UNIT


@settings(max_examples=200, deadline=None)
@given(st.lists(st.tuples(*[st.integers(-(2**80), 2**80)] * 2), min_size=1, max_size=6))
def test_a_certain_sign_is_the_true_sign(pairs: list[tuple[int, int]]) -> None:
    left, right = (np.array([float(x) for x in row]) for row in zip(*pairs, strict=True))
    exact = sum(x * y for x, y in pairs)
    value, size = left @ right, np.abs(left) @ np.abs(right)
    bound = error_bound(2 + 1 + len(pairs))
    assert abs(Fraction(float(value)) - exact) <= Fraction(bound) * Fraction(float(size))
    if certain(value, size, bound):
        assert np.sign(value) == (exact > 0) - (exact < 0)


def test_rows_with_too_small_entries_are_named() -> None:
    floats, usable = scaled([(2**201, 1), (2**200, 3), (2**900, 0), (0, 0)])
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


def wrong_signs(size: int, cases: int = 300) -> int:
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


@pytest.mark.parametrize("size", [LARGEST, LARGEST + 1, 10**4, 10**5, 10**8, 10**20])
def test_dependent_planes_and_their_neighbours_have_the_exact_signs(size: int) -> None:
    assert wrong_signs(size) == 0


def test_the_bound_on_small_integers_ends_where_the_proof_does() -> None:
    assert 24 * LARGEST**4 <= EXACT < 24 * (LARGEST + 1) ** 4
    assert scaled_floats([(LARGEST, 1, 0, 0)])[1] == 0.0
    assert scaled_floats([(LARGEST + 1, 1, 0, 0)])[1] == predicates.ERROR == 2.0**-49


def test_with_looser_bounds_signs_are_wrong(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same planes tell: they have wrong signs where floats are trusted too far."""
    monkeypatch.setattr(predicates, "EXACT", 24 * 10**16)
    assert wrong_signs(10**4) > 0
    monkeypatch.undo()
    monkeypatch.setattr(predicates, "ERROR", UNIT / 2)
    assert wrong_signs(10**20) > 0
