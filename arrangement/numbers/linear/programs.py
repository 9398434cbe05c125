"""Exact linear programs, each answer with its certificate.

The form is: minimise ``c . x`` over free x in R^n with ``a . x + b >= 0`` for every inequality row
``(a, b)`` and ``e . x + f = 0`` for every equality row ``(e, f)``: the constant stands last.

Method: a dictionary of the rows over integers with one common denominator (exact divisions, no
gcd). Equalities and free variables are pivoted away first; then the dual simplex method with a
zero objective finds a feasible point, and the primal one improves it, both with Bland's rule, so
that degenerate input ends too. Sizes here are small (tens of rows). The worst case is
exponential, as for every known simplex rule; the certificates make each answer checkable.
"""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.errors import ArrangementError
from arrangement.numbers.exact import IntegerVector, RationalVector, fast_integers, primitive

Row: TypeAlias = Sequence[Fraction | int]


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


class Program:
    """A system of conditions, and the minima of as many objectives as are asked for.

    Each minimisation starts where the last one ended. Values, and whether there is a solution, do
    not depend on that; where many points are optimal, which one is returned does.

    Args:
        n: the number of variables.
        inequalities: rows of n + 1 rationals, constant last, each ``>= 0``.
        equalities: rows of n + 1 rationals, constant last, each ``= 0``.
        deadline: on the clock `time.monotonic`.

    Raises:
        ArrangementError: a row has the wrong length.
        TimeoutError: the deadline has passed.
    """

    def __init__(
        self,
        n: int,
        inequalities: Sequence[Row],
        equalities: Sequence[Row] = (),
        deadline: float = math.inf,
    ) -> None:
        for row in (*inequalities, *equalities):
            if len(row) != n + 1:
                raise ArrangementError(f"a row has {len(row)} entries; {n} variables need {n + 1}")
        self._dictionary = _Dictionary(n, inequalities, equalities, deadline)
        conflict = self._dictionary.eliminate_equalities()
        if conflict is None:
            self._dictionary.eliminate_variables()
            conflict = self._dictionary.make_feasible()
        self._conflict = conflict

    @property
    def feasible(self) -> bool:
        """Whether a point satisfies all rows; of long numbers the proof may take much longer."""
        return self._conflict is None

    def point(self) -> RationalVector | Infeasible:
        """Return a point that satisfies all rows, or the proof that there is none."""
        if self._conflict is not None:
            return self._dictionary.infeasible(self._conflict)
        return self._dictionary.point()

    def minimize(self, objective: Row) -> Optimal | Infeasible | Unbounded:
        """Minimise ``objective . x`` exactly.

        Raises:
            ArrangementError: the objective has the wrong length.
        """
        if self._conflict is not None:
            return self._dictionary.infeasible(self._conflict)
        self._dictionary.set_cost(objective)
        return self._dictionary.optimize() or self._dictionary.optimal()

    def least(self, objective: Row) -> Fraction | None:
        """Return the least value of ``objective . x``; None if there is none.

        Raises:
            ArrangementError: the objective has the wrong length.
        """
        if self._conflict is not None:
            return None
        self._dictionary.set_cost(objective)
        return None if self._dictionary.optimize() else self._dictionary.value()


def minimize(
    objective: Row, inequalities: Sequence[Row], equalities: Sequence[Row] = ()
) -> Optimal | Infeasible | Unbounded:
    """Minimise ``objective . x`` exactly; see `Program`.

    >>> minimize([1, 1], [[1, 0, -2], [0, 1, 3]]).value
    Fraction(-1, 1)
    """
    return Program(len(objective), inequalities, equalities).minimize(objective)


def feasible_point(
    n: int, inequalities: Sequence[Row], equalities: Sequence[Row] = ()
) -> RationalVector | Infeasible:
    """Return a point of R^n that satisfies all rows, or the proof that there is none."""
    return Program(n, inequalities, equalities).point()


class _Dictionary:
    """Every symbol outside the basis is a column; every other one is a row over the columns.

    Symbols are numbered: variables ``0..n-1``, then inequality slacks, then equality slacks. Row r
    reads ``symbol_r = (sum_j row[j] * column_j + row[-1]) / denominator``. Points are counted in
    `unit`: so constants with long denominators leave the other entries short.
    """

    def __init__(
        self, n: int, inequalities: Sequence[Row], equalities: Sequence[Row], deadline: float
    ) -> None:
        self.variables, self.deadline = n, deadline
        self.first_equality = n + len(inequalities)
        constraints = [*inequalities, *equalities]
        integers = list(map(self._whole, constraints))
        self.scales = [_scale(row, whole) for row, whole in zip(constraints, integers, strict=True)]
        ends = [Fraction(row[-1]) / t for row, t in zip(constraints, self.scales, strict=True)]
        self.unit = math.lcm(*(end.denominator for end in ends))
        rows = [[*w, int(end * self.unit)] for w, end in zip(integers, ends, strict=True)]
        self.rows = fast_integers(rows)
        self.symbols = list(range(n, n + len(self.rows)))
        self.columns = list(range(n))
        self.cost = [0] * (n + 1)
        self.cost_scale = Fraction(1)
        self.denominator = 1

    def _whole(self, row: Row) -> IntegerVector:
        self._keep_to_time()
        return primitive(row[:-1])

    def _keep_to_time(self) -> None:
        if time.monotonic() > self.deadline:
            raise TimeoutError("the time is over")

    def set_cost(self, objective: Row) -> None:
        """Write an objective as a row over the present columns."""
        n = self.variables
        if len(objective) != n:
            raise ArrangementError(f"the objective has {len(objective)} entries; expected {n}")
        weights = primitive([Fraction(x) for x in objective])
        self.cost_scale = _scale(objective, weights)
        self.cost = [0] * (self.variables + 1)
        for c, symbol in enumerate(self.columns):
            if self.is_variable(symbol):
                self.cost[c] = weights[symbol] * self.denominator
        for row, symbol in zip(self.rows, self.symbols, strict=True):
            if self.is_variable(symbol) and weights[symbol]:
                weight = weights[symbol]
                self.cost = [x + weight * y for x, y in zip(self.cost, row, strict=True)]

    def pivot(self, r: int, c: int) -> None:
        """Exchange row r and column c."""
        self._keep_to_time()
        pivot_row = self.rows[r]
        p, d = pivot_row[c], self.denominator
        flip = 1 if p > 0 else -1
        for row in (*self.rows, self.cost):
            if row is pivot_row:
                continue
            factor = row[c]
            row[:] = [flip * (p * a - factor * b) // d for a, b in zip(row, pivot_row, strict=True)]
            row[c] = flip * factor
        pivot_row[:] = [-flip * b for b in pivot_row]
        pivot_row[c] = flip * d
        self.denominator = flip * p
        self.symbols[r], self.columns[c] = self.columns[c], self.symbols[r]

    def is_variable(self, symbol: int) -> bool:
        return symbol < self.variables

    def is_slack(self, symbol: int) -> bool:
        return self.variables <= symbol < self.first_equality

    def eliminate_equalities(self) -> int | None:
        """Make every equality a column, fixed at zero; return a row that contradicts, if any."""
        for r, symbol in enumerate(self.symbols):
            if symbol < self.first_equality:
                continue
            row = self.rows[r]
            usable = (j for j, s in enumerate(self.columns) if row[j] and self.is_variable(s))
            column = next(usable, None)
            if column is not None:
                self.pivot(r, column)
            elif row[-1]:
                return r
        return None

    def eliminate_variables(self) -> None:
        """Make rows of all variables that occur in some inequality; the others stay at zero."""
        for c, symbol in enumerate(self.columns):
            if not self.is_variable(symbol):
                continue
            usable = (r for r, s in enumerate(self.symbols) if self.rows[r][c] and self.is_slack(s))
            row = next(usable, None)
            if row is not None:
                self.pivot(row, c)

    def make_feasible(self) -> int | None:
        """Dual simplex with zero objective; return a row that can never be >= 0, if any."""
        while True:
            negative = [
                (s, r)
                for r, s in enumerate(self.symbols)
                if self.is_slack(s) and self.rows[r][-1] < 0
            ]
            if not negative:
                return None
            r = min(negative)[1]
            rising = [
                (s, c)
                for c, s in enumerate(self.columns)
                if self.is_slack(s) and self.rows[r][c] > 0
            ]
            if not rising:
                return r
            self.pivot(r, min(rising)[1])

    def optimize(self) -> Unbounded | None:
        """Primal simplex from a feasible dictionary, to the end or to a ray without end."""
        while True:
            for c, symbol in enumerate(self.columns):
                if self.is_variable(symbol) and self.cost[c]:
                    return self.unbounded(c, -1 if self.cost[c] > 0 else 1)
            falling = [
                (s, c) for c, s in enumerate(self.columns) if self.is_slack(s) and self.cost[c] < 0
            ]
            if not falling:
                return None
            c = min(falling)[1]
            row = self.blocking_row(c)
            if row is None:
                return self.unbounded(c, 1)
            self.pivot(row, c)

    def blocking_row(self, c: int) -> int | None:
        """Return the row that first reaches zero as column c grows (ties by symbol number)."""
        blocking = None
        for r, symbol in enumerate(self.symbols):
            row = self.rows[r]
            if self.is_slack(symbol) and row[c] < 0:
                if blocking is not None:
                    best = self.rows[blocking]
                    later = best[-1] * row[c] - row[-1] * best[c]
                    if later > 0 or (later == 0 and symbol > self.symbols[blocking]):
                        continue
                blocking = r
        return blocking

    def point(self) -> RationalVector:
        """Return the variables with every column at zero."""
        values = [Fraction(0)] * self.variables
        for row, symbol in zip(self.rows, self.symbols, strict=True):
            if self.is_variable(symbol):
                values[symbol] = _quotient(row[-1], self.denominator * self.unit)
        return tuple(values)

    def unbounded(self, c: int, direction: int) -> Unbounded:
        """Return the point, and the change of the variables as column c moves."""
        ray = [Fraction(0)] * self.variables
        if self.is_variable(self.columns[c]):
            ray[self.columns[c]] = Fraction(direction)
        for row, symbol in zip(self.rows, self.symbols, strict=True):
            if self.is_variable(symbol):
                ray[symbol] = _quotient(direction * row[c], self.denominator)
        return Unbounded(self.point(), tuple(ray))

    def optimal(self) -> Optimal:
        scale = self.cost_scale / int(self.denominator)
        terms = {s: int(x) * scale for s, x in zip(self.columns, self.cost, strict=False)}
        return Optimal(self.point(), self.value(), *self.multipliers(terms))

    def value(self) -> Fraction:
        """Return the value of the objective with every column at zero."""
        return self.cost_scale * _quotient(self.cost[-1], self.denominator * self.unit)

    def infeasible(self, r: int) -> Infeasible:
        """Read the Farkas certificate off a row that cannot hold."""
        row = self.rows[r]
        scale = _quotient(self.unit, abs(row[-1]))
        flip = 1 if row[-1] < 0 else -1  # only an equality row may have a positive constant
        terms = {s: -flip * int(x) * scale for s, x in zip(self.columns, row, strict=False)}
        terms[self.symbols[r]] = flip * int(self.denominator) * scale
        return Infeasible(*self.multipliers(terms))

    def multipliers(self, terms: dict[int, Fraction]) -> tuple[RationalVector, RationalVector]:
        """Return multipliers of the given rows from those of rows with coprime coefficients."""
        values = [
            terms.get(self.variables + i, Fraction(0)) / scale
            for i, scale in enumerate(self.scales)
        ]
        split = self.first_equality - self.variables
        return tuple(values[:split]), tuple(values[split:])


def _quotient(x: Any, y: Any) -> Fraction:
    """Return the fraction of two integers of any kind."""
    return Fraction(int(x), int(y))


def _scale(row: Row, integers: Sequence[int]) -> Fraction:
    """Return t > 0 with ``row = t * integers`` but for the constant."""
    for x, whole in zip(row, integers, strict=False):
        if whole:
            return Fraction(x) / whole
    return Fraction(1)
