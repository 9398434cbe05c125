"""One linear system with sign conditions, decided exactly: solution, refutation, or a continuum.

Fraction-free Gauss-Jordan elimination (one common denominator, exact divisions) on integers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

from arrangement import linprog
from arrangement.exact import RationalVector, dot

from .state_system import StateSystem


@dataclass(frozen=True, slots=True)
class Refutation:
    """A Farkas vector: multipliers with ``sum y (a . z + b) + sum x (e . z + f) = -1`` and y >= 0.

    Such a combination shows at a glance that no z satisfies all rows.
    """

    inequalities: RationalVector
    equalities: RationalVector


@dataclass(frozen=True, slots=True)
class Point:
    """The only solution of the system."""

    values: RationalVector


@dataclass(frozen=True, slots=True)
class Continuum:
    """The equalities alone have many solutions, and at least one satisfies the inequalities."""


Outcome: TypeAlias = "Refutation | Point | Continuum"


def decide(system: StateSystem) -> Outcome:
    """Decide a system exactly; the number of equalities equals the number of variables.

    Regular equalities leave one point to check. Inconsistent ones have a left null vector as
    refutation. Singular consistent ones go to the exact linear program.
    """
    rows, pivots, scale = gauss_jordan(system.equalities)
    n = system.size
    if n in pivots:
        return Refutation((Fraction(0),) * len(system.inequalities), _inconsistency(system))
    if len(pivots) < n:
        return _by_program(system)
    sign = -1 if scale < 0 else 1
    point = [*(-sign * row[n] for row in rows), sign * scale]
    for i, row in enumerate(system.inequalities):
        # In integers over the common denominator: no fraction is reduced on the way.
        if dot(_integers(row), point) < 0:
            margin = Fraction(dot(row, point)) / point[n]
            return _refuted_by(system, i, margin)
    return Point(tuple(Fraction(x, point[n]) for x in point[:n]))


def _by_program(system: StateSystem) -> Outcome:
    answer = system.program.point()
    if isinstance(answer, linprog.Infeasible):
        return Refutation(answer.inequality_multipliers, answer.equality_multipliers)
    return Continuum()


def _refuted_by(system: StateSystem, index: int, margin: Fraction) -> Refutation:
    """Return the Farkas vector of an inequality that fails by `margin` < 0 at the only point."""
    n = system.size
    failing = system.inequalities[index]
    transposed = [[*(row[j] for row in system.equalities), failing[j] / -margin] for j in range(n)]
    rows, _, scale = gauss_jordan(transposed)
    chosen = [Fraction(0)] * len(system.inequalities)
    chosen[index] = 1 / -margin
    return Refutation(tuple(chosen), tuple(Fraction(-row[n], scale) for row in rows))


def _inconsistency(system: StateSystem) -> RationalVector:
    """Return x with ``x E = 0`` and ``x . f = -1`` for inconsistent equalities ``E z + f = 0``."""
    n = system.size
    rows, pivots, scale = gauss_jordan([[row[j] for row in system.equalities] for j in range(n)])
    constants = [row[-1] for row in system.equalities]
    for free in (j for j in range(n) if j not in pivots):
        null = [Fraction(0)] * n
        null[free] = Fraction(1)
        for row, pivot in zip(rows, pivots, strict=False):
            null[pivot] = Fraction(-row[free], scale)
        product = dot(null, constants)
        if product:
            return tuple(x / -product for x in null)
    raise AssertionError("consistent equalities have no inconsistency")


def gauss_jordan(
    matrix: Sequence[Sequence[Fraction]],
) -> tuple[list[list[int]], list[int], int]:
    """Return the reduced rows times a common scale, the pivot columns, and the scale.

    Row i of the result has its pivot, of the value `scale`, in column ``pivots[i]``; rows beyond
    the pivots are zero. Rows of the input are scaled to integers first, which changes no solution.
    """
    rows = [_integers(row) for row in matrix]
    pivots: list[int] = []
    scale = 1
    for column in range(len(rows[0]) if rows else 0):
        done = len(pivots)
        found = next((i for i in range(done, len(rows)) if rows[i][column]), None)
        if found is None:
            continue
        rows[done], rows[found] = rows[found], rows[done]
        top = rows[done]
        pivot = top[column]
        for i, row in enumerate(rows):
            if i != done:
                factor = row[column]
                rows[i] = [(pivot * a - factor * b) // scale for a, b in zip(row, top, strict=True)]
        scale = pivot
        pivots.append(column)
    return rows, pivots, scale


def _integers(row: Sequence[Fraction]) -> list[int]:
    """Return a positive multiple of a row with integer entries."""
    scale = math.lcm(*(x.denominator for x in row))
    return [x.numerator * (scale // x.denominator) for x in row]
