"""Linear programs: their rows over integers, their answers, and what a guess of tight rows gives.

A guess needs one or two small systems, where exact pivots would write all rows anew each time.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    dot,
    fast_integers,
    largest,
    primitive,
)

Row: TypeAlias = Sequence[Fraction | int]
#: Integers over a common one above 0.
Numbers: TypeAlias = tuple[list[int], int]
#: Multipliers of rows by their numbers, over a common integer above 0.
Terms: TypeAlias = tuple[dict[int, int], int]


@dataclass(frozen=True, slots=True)
class Optimal:
    """A minimiser with its proof.

    ``c . x - value = sum y_i (a_i . x + b_i) + sum z_j (e_j . x + f_j)`` for all x, with y >= 0
    and ``y_i = 0`` wherever ``a_i . point + b_i > 0``.
    """

    point: RationalVector
    value: Fraction
    inequality_multipliers: RationalVector
    equality_multipliers: RationalVector


@dataclass(frozen=True, slots=True)
class Infeasible:
    """A Farkas certificate: ``sum y_i (a_i . x + b_i) + sum z_j (e_j . x + f_j) = -1``, y >= 0."""

    inequality_multipliers: RationalVector
    equality_multipliers: RationalVector


@dataclass(frozen=True, slots=True)
class Unbounded:
    """A feasible point, and a direction that stays feasible and lowers ``c . x`` for ever."""

    point: RationalVector
    ray: RationalVector


class Rows:
    """The rows of a program over integers, equalities last; points are counted in `unit`.

    So constants with long denominators leave the other entries short.

    Args:
        n: the number of variables.
        deadline: looked at before each step that may take long.

    Attributes:
        scales: what the given rows are divided by.
    """

    def __init__(
        self, n: int, inequalities: Sequence[Row], equalities: Sequence[Row], deadline: Deadline
    ) -> None:
        self.variables, self.deadline = n, deadline
        self.first_equality = len(inequalities)
        given = [*inequalities, *equalities]
        integers = list(map(self._whole, given))
        self.scales = [scale_of(row, whole) for row, whole in zip(given, integers, strict=True)]
        ends = [Fraction(row[-1]) / t for row, t in zip(given, self.scales, strict=True)]
        self.unit = math.lcm(*(end.denominator for end in ends))
        #: Integers of one kind, see `fast_integers`.
        self.integers = fast_integers(
            [
                [*w, end.numerator * (self.unit // end.denominator)]
                for w, end in zip(integers, ends, strict=True)
            ]
        )

    @property
    def work(self) -> float:
        """The entries that exact pivots of all variables write; long numbers count more often."""
        bits = int(largest(self.integers)).bit_length()
        return self.variables**2 * len(self.integers) * (1 + bits / 30)

    def _whole(self, row: Row) -> IntegerVector:
        self.deadline.check(10 * len(row))
        return primitive(row[:-1])

    def point(self, tight: Sequence[int]) -> Numbers | None:
        """Return where rows are tight as integers over a common one, if all rows hold there.

        Args:
            tight: n rows, or n + j for the variable j at 0.
        """
        found = self._solved([self._row(k) for k in tight])
        if found is None:
            return None
        numbers, common = found
        at = [*numbers, common]
        for k, row in enumerate(self.integers):
            value = dot(row, at)
            if value < 0 or (value and k >= self.first_equality):
                return None
        return found

    def rational(self, found: Numbers) -> RationalVector:
        """Return a point in the units of the given rows."""
        numbers, common = found
        return tuple(Fraction(int(x), int(common) * self.unit) for x in numbers)

    def multipliers(self, target: Sequence[int], tight: Sequence[int]) -> Terms | None:
        """Return the multipliers of tight rows that give a row of n coefficients, if they do.

        Those of inequalities are at least 0.
        """
        columns = zip(*(self._row(k)[:-1] for k in tight), strict=True)
        found = self._solved([[*c, -x] for c, x in zip(columns, target, strict=True)])
        if found is None:
            return None
        numbers, common = found
        terms = {k: x for k, x in zip(tight, numbers, strict=True) if x}
        for k, x in terms.items():
            if k >= len(self.integers) or (x < 0 and k < self.first_equality):
                return None
        return terms, common

    def ray(self, objective: Sequence[int], symbol: int, tight: Sequence[int]) -> Numbers | None:
        """Return the direction in which one tight row rises, if it lowers an objective for ever."""
        rows = [[*self._row(k)[:-1], -int(k == symbol)] for k in tight]
        found = self._solved(rows)
        if found is None:
            return None
        numbers, common = found
        if symbol >= len(self.integers) and dot(objective, numbers) > 0:
            numbers = [-x for x in numbers]
        changes = [dot(row[:-1], numbers) for row in self.integers]
        falls = dot(objective, numbers) < 0 and min(changes, default=0) >= 0
        return (numbers, common) if falls and not any(changes[self.first_equality :]) else None

    def refutation(self, row: int, tight: Sequence[int]) -> Terms | None:
        """Return multipliers of a row and of tight ones whose sum is below 0, if there are some."""
        for flip in (1, -1) if row >= self.first_equality else (1,):
            found = self.multipliers([-flip * x for x in self.integers[row][:-1]], tight)
            if found is not None:
                terms, common = found
                terms[row] = terms.get(row, 0) + flip * common
                if self._sum(terms) < 0:
                    return found
        return None

    def infeasible(self, found: Terms) -> tuple[RationalVector, RationalVector]:
        """Return the multipliers of given rows with the sum -1."""
        terms, total = found[0], -self._sum(found[0])
        return self.given({k: Fraction(int(x) * self.unit, int(total)) for k, x in terms.items()})

    def _sum(self, terms: dict[int, int]) -> int:
        return sum(x * self.integers[k][-1] for k, x in terms.items())

    def given(self, terms: dict[int, Fraction]) -> tuple[RationalVector, RationalVector]:
        """Return multipliers of the given rows from those of the integer rows."""
        values = [terms.get(k, Fraction(0)) / scale for k, scale in enumerate(self.scales)]
        return tuple(values[: self.first_equality]), tuple(values[self.first_equality :])

    def _row(self, k: int) -> list[int]:
        count = len(self.integers)
        if k < count:
            return self.integers[k]
        return [int(k - count == j) for j in range(self.variables + 1)]

    def _solved(self, rows: list[list[int]]) -> Numbers | None:
        """Return the solution of n rows, constant last, over a common integer above 0."""
        from flint import fmpz_mat

        n = len(rows)
        self.deadline.check(n**3 / 2)
        if n != self.variables:
            return None
        if not n:
            return [], 1
        reduced, common, rank = fmpz_mat(rows).rref()
        if rank < n or reduced[n - 1, n - 1] == 0:
            return None
        flip = -1 if common > 0 else 1
        numbers: list[Any] = [flip * reduced[j, n] for j in range(n)]
        size: Any = abs(common)
        if not self.integers or isinstance(self.integers[0][0], int):
            return list(map(int, numbers)), int(size)
        return numbers, size


def scale_of(row: Row, integers: Sequence[Any]) -> Fraction:
    """Return t > 0 with ``row = t * integers`` but for the constant."""
    for x, whole in zip(row, integers, strict=False):
        if whole:
            return Fraction(Fraction(x) / whole)
    return Fraction(1)
