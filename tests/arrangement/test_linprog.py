"""Exact linear programs: every answer proves itself, and elimination agrees."""

from fractions import Fraction
from itertools import combinations, permutations
from math import prod
from random import Random
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from arrangement.errors import ArrangementError
from arrangement.numbers.fields import NumberField
from arrangement.numbers.linear import programs
from arrangement.numbers.linear.float_dictionary import FloatDictionary
from arrangement.numbers.linear.programs import (
    Infeasible,
    Optimal,
    Unbounded,
    feasible_point,
    minimize,
)
from arrangement.numbers.linear.rank import determinant, gauss_jordan, rank
from proofs_check.routes.oracle import project

Rows = list[tuple[Fraction, ...]]
Problem = tuple[list[Fraction], Rows, Rows]

ENTRIES = st.one_of(st.integers(-2, 2).map(Fraction), st.fractions(-3, 3, max_denominator=3))


@st.composite
def problems(draw: st.DrawFn, unknowns: int = 4, most: int = 6, equal: int = 3) -> Problem:
    n = draw(st.integers(1, unknowns))
    row = st.lists(ENTRIES, min_size=n + 1, max_size=n + 1).map(tuple)
    objective = draw(st.lists(ENTRIES, min_size=n, max_size=n))
    inequalities = draw(st.lists(row, max_size=most))
    equalities = draw(st.lists(row, max_size=equal))
    return objective, inequalities, equalities


def at(row: Any, point: Any) -> Any:
    return sum(a * x for a, x in zip(row[:-1], point, strict=True)) + row[-1]


def combination(multipliers: Any, rows: Rows, n: int) -> list[Any]:
    return [sum(y * row[j] for y, row in zip(multipliers, rows, strict=True)) for j in range(n + 1)]


def check(problem: Problem, answer: Optimal | Infeasible | Unbounded) -> None:
    """Re-check an answer by its certificate, from the definitions alone."""
    objective, inequalities, equalities = problem
    n = len(objective)
    if isinstance(answer, (Optimal, Unbounded)):
        assert all(at(row, answer.point) >= 0 for row in inequalities)
        assert all(at(row, answer.point) == 0 for row in equalities)
    if isinstance(answer, Unbounded):
        assert all(at((*row[:-1], 0), answer.ray) >= 0 for row in inequalities)
        assert all(at((*row[:-1], 0), answer.ray) == 0 for row in equalities)
        assert at((*objective, 0), answer.ray) < 0
        return
    y, z = answer.inequality_multipliers, answer.equality_multipliers
    assert all(value >= 0 for value in y)
    left = combination(y, inequalities, n)
    right = combination(z, equalities, n)
    total = [a + b for a, b in zip(left, right, strict=True)]
    if isinstance(answer, Infeasible):
        assert total == [0] * n + [-1]
    else:
        assert total == [*objective, -answer.value]
        assert at((*objective, 0), answer.point) == answer.value


def by_elimination(problem: Problem) -> Any:
    """Return the optimal value, or the name of what else there is, without pivots or duality.

    SymPy 1.14's simplex is not an oracle: with y - z = 0 and y - z = 1 it finds an optimum.
    """
    objective, inequalities, equalities = problem
    bound = tuple(-c for c in objective)  # value - c.x >= 0
    rows, flat = (
        [(*row[:-1], Fraction(0), row[-1]) for row in given] for given in (inequalities, equalities)
    )
    rows.append((*bound, Fraction(1), Fraction(0)))
    left = project(flat, rows, keep=len(objective))
    if left is None:
        return "infeasible"
    # the value is bounded from below only: nothing keeps it from being too large
    assert all(row[-2] > 0 for row in left)
    return max((Fraction(-row[-1], row[-2]) for row in left), default="unbounded")


def answered(problem: Problem, short: float) -> Optimal | Infeasible | Unbounded:
    """Return the answer where programs of less work than so much are left to exact pivots."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(programs, "_SHORT", short)
        return minimize(*problem)


POWERS = st.lists(st.integers(-400, 400).map(lambda k: Fraction(10) ** k), min_size=9, max_size=9)


@given(problems(), POWERS, POWERS)
def test_guesses_of_programs_in_odd_units_are_proved(problem, units, factors):
    objective, inequalities, equalities = problem
    scaled = (
        [c * u for c, u in zip(objective, units, strict=False)],
        *(
            [
                tuple(f * x * u for x, u in zip(row, (*units[: len(row) - 1], 1), strict=True))
                for row, f in zip(rows, factors, strict=False)
            ]
            for rows in (inequalities, equalities)
        ),
    )
    answer, expected = answered(scaled, -1), answered(problem, np.inf)
    check(scaled, answer)
    assert type(answer) is type(expected)
    assert getattr(answer, "value", None) == getattr(expected, "value", None)


@given(problems(), st.none() | st.integers(-1, 9), st.none() | st.integers(-1, 9))
def test_wrong_guesses_change_no_answer(problem, start, end):
    wrong = (
        x if x is None else min(x, len(problem[1]) + len(problem[2]) - 1) for x in (start, end)
    )
    with pytest.MonkeyPatch.context() as patch:
        for name, guess in zip(("start", "minimize"), wrong, strict=True):
            patch.setattr(FloatDictionary, name, lambda *_, guess=guess: guess)
        answer = answered(problem, -1)
    expected = answered(problem, np.inf)
    check(problem, answer)
    assert type(answer) is type(expected)
    assert getattr(answer, "value", None) == getattr(expected, "value", None)


def test_long_programs_need_no_pivots(monkeypatch):
    """Twelve random rows of five variables with 200 digits: the guess is right each time."""
    source, size = Random(1), 10**200
    rows = [[Fraction(source.randint(-size, size), size) for _ in range(6)] for _ in range(12)]
    problem = ([Fraction(1)] * 5, [(*row[:-1], abs(row[-1])) for row in rows], [])
    expected = answered(problem, np.inf)
    monkeypatch.delattr(programs, "Dictionary")
    assert minimize(*problem) == expected


@settings(max_examples=50)
@given(problems(unknowns=3, most=4, equal=2))
def test_answers_prove_themselves_and_are_those_of_elimination(problem):
    answer = minimize(*problem)
    check(problem, answer)
    expected = by_elimination(problem)
    if isinstance(answer, Optimal):
        assert answer.value == expected
    else:
        assert expected == type(answer).__name__.lower()


@given(problems(most=10))
def test_a_feasible_point_exists_or_is_refuted(problem):
    objective, inequalities, equalities = problem
    n = len(objective)
    answer = feasible_point(n, inequalities, equalities)
    if isinstance(answer, Infeasible):
        check(problem, answer)
    else:
        assert all(at(row, answer) >= 0 for row in inequalities)
        assert all(at(row, answer) == 0 for row in equalities)


@given(problems(), st.integers(10**29, 10**30))
def test_thirty_digit_scalings_of_rows_change_no_verdict(problem, scale):
    objective, inequalities, equalities = problem
    scaled = (
        objective,
        [tuple(scale * a for a in row) for row in inequalities],
        [tuple(Fraction(a, scale) for a in row) for row in equalities],
    )
    answer = minimize(*scaled)
    check(scaled, answer)
    assert type(answer) is type(minimize(*problem))


def test_cycling_examples_end():
    """Beale 1955: the textbook rule cycles here; the optimum is -1/20."""
    quarter = Fraction(1, 4)
    objective = [Fraction(-3, 4), Fraction(150), Fraction(-1, 50), Fraction(6)]
    rows: Rows = [
        (-quarter, Fraction(60), Fraction(1, 25), Fraction(-9), Fraction(0)),
        (Fraction(-1, 2), Fraction(90), Fraction(1, 50), Fraction(-3), Fraction(0)),
        (Fraction(0), Fraction(0), Fraction(-1), Fraction(0), Fraction(1)),
        *(tuple(Fraction(int(i == j)) for j in range(5)) for i in range(4)),
    ]
    answer = minimize(objective, rows)
    check((objective, rows, []), answer)
    assert isinstance(answer, Optimal)
    assert answer.value == Fraction(-1, 20)


def test_a_row_of_the_wrong_length_is_refused():
    with pytest.raises(ArrangementError, match="need 3"):
        minimize([1, 1], [[1, 0]])


def test_a_hair_decides():
    """x <= 1 and x >= 1 + 10^-30 contradict each other; with 1 they meet."""
    tiny = Fraction(1, 10**30)
    upper = (Fraction(-1), Fraction(1))
    assert feasible_point(1, [upper, (Fraction(1), Fraction(-1))]) == (Fraction(1),)
    assert isinstance(feasible_point(1, [upper, (Fraction(1), -1 - tiny)]), Infeasible)


@given(st.data(), st.integers(1, 4))
def test_float_guess_is_near_the_exact_answer(data, n):
    """The greatest last coordinate in a cone cut off by a cube, and the rows that bound it."""
    row = st.lists(st.integers(-3, 3), min_size=n, max_size=n)
    cone = [(*entries, 0) for entries in data.draw(st.lists(row, max_size=8))]
    cube = [(*(s * (j == k) for j in range(n)), 1) for k in range(n) for s in (1, -1)]
    rows = [*cube, *cone]
    program = FloatDictionary.of_integers(rows, n + 1, 0)
    assert program.start() == -1
    objective = [0] * (n - 1) + [-1]
    assert program.minimize(objective) == -1
    tight = np.array([rows[k] for k in program.tight], dtype=float)
    point = np.linalg.solve(tight[:, :-1], -tight[:, -1])
    exact = minimize(objective, rows)
    assert point[-1] == pytest.approx(-exact.value, abs=1e-8)
    assert (np.array(rows) @ [*point, 1]).min() > -1e-8


@given(st.data(), st.integers(1, 4), st.integers(1, 4))
def test_signed_variables_of_a_float_guess_are_columns(data, signed, free):
    """As with a row for each of them; the point obeys all rows."""
    n = signed + free
    row = st.lists(st.integers(-3, 3), min_size=n + 1, max_size=n + 1)
    rows = np.array(data.draw(st.lists(row, min_size=1, max_size=6)), dtype=float)
    program = FloatDictionary(rows.copy(), signed=signed)
    whole = np.concatenate([rows, np.eye(n, n + 1)[:signed]])
    assert (program.start() == -1) == (FloatDictionary(whole.copy()).start() == -1)
    if FloatDictionary(whole.copy()).start() == -1:
        assert (whole @ [*program.point, 1]).min() > -1e-7


@pytest.mark.parametrize("bits", [3, 2000])
def test_elimination_leaves_one_pivot_per_column(bits):
    source = Random(bits)
    one, other = ([source.getrandbits(bits) + 1 for _ in range(5)] for _ in range(2))
    rows = [one, other, [a - b for a, b in zip(one, other, strict=True)], [0] * 5]
    reduced, pivots, scale = gauss_jordan(rows)
    assert [[row[j] for j in pivots] for row in reduced[:2]] == [[scale, 0], [0, scale]]
    assert reduced[2:] == [[0] * 5] * 2
    assert rank([*rows, *reduced]) == len(pivots) == 2


@pytest.mark.parametrize("irrational", [False, True], ids=["integers", "a field"])
@pytest.mark.parametrize("size", [1, 2, 3, 4, 6])
def test_elimination_keeps_its_laws(size, irrational):
    """Also where rows are exchanged, and on both sides of the size from which FLINT eliminates."""
    source, root = Random(size), NumberField([-2, 0, 1], [1, 2]).generator if irrational else 1
    for _ in range(6 if irrational else 25):
        drawn = [[source.choice((0, 0, -1, 2, 3)) for _ in range(size)] for _ in range(size)]
        rows = [[x * source.choice((1, root)) for x in row] for row in drawn]
        assert determinant(rows) == sum(
            (-1) ** sum(a > b for a, b in combinations(order, 2))
            * prod(rows[i][j] for i, j in enumerate(order))
            for order in permutations(range(size))
        )
        reduced, pivots, scale = gauss_jordan(rows)
        assert [[row[j] for j in pivots] for row in reduced[: len(pivots)]] == [
            [scale * (i == j) for j in range(len(pivots))] for i in range(len(pivots))
        ]
        assert not any(map(any, reduced[len(pivots) :]))
        assert rank(rows) == rank([*rows, *reduced]) == len(pivots)


def test_rank_of_tall_matrices_is_not_that_of_a_sample_alone():
    rows = [(1, 0, 1), (0, 1, 1)] * 20
    assert rank(rows) == 2
    assert rank([*rows[:33], (1, 1, 1), *rows]) == 3
