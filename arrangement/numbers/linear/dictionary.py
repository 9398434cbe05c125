"""Exact pivots: a linear program as a dictionary of rows over integers with one denominator.

Exact divisions, no gcd. Equalities and free variables are pivoted away first; then the dual simplex
method with a zero objective finds a feasible point, and the primal one improves it, both with
Bland's rule, so that degenerate input ends too.
"""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction
from typing import Any

from arrangement.numbers.exact import RationalVector, primitive

from .program_rows import Infeasible, Optimal, Row, Rows, Unbounded, scale_of


class Dictionary:
    """Every symbol outside the basis is a column; every other one is a row over the columns.

    Symbols are numbered: variables ``0..n-1``, then inequality slacks, then equality slacks. Row r
    reads ``symbol_r = (sum_j row[j] * column_j + row[-1]) / denominator``. Points are counted in
    the unit of the rows.

    Args:
        tight: rows that are likely to be tight; from a good guess there are few pivots to go.
    """

    def __init__(self, rows: Rows, tight: Collection[int] = ()) -> None:
        n = rows.variables
        self.given, self.variables = rows, n
        self.first_equality = n + rows.first_equality
        self.rows = [list(row) for row in rows.integers]
        self.symbols = list(range(n, n + len(self.rows)))
        self.columns = list(range(n))
        self.cost = [0] * (n + 1)
        self.cost_scale = Fraction(1)
        self.denominator = 1
        self.conflict = self.eliminate_equalities()
        if self.conflict is None:
            self.eliminate_variables({n + k for k in tight})
            self.conflict = self.make_feasible()

    def set_cost(self, objective: Row) -> None:
        """Write an objective as a row over the present columns."""
        weights = primitive([Fraction(x) for x in objective])
        self.cost_scale = scale_of(objective, weights)
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
        pivot_row = self.rows[r]
        self.given.deadline.check(_work(len(self.rows) * len(pivot_row), self.denominator))
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
        """Return whether it is a variable."""
        return symbol < self.variables

    def is_slack(self, symbol: int) -> bool:
        """Return whether it is that of an inequality."""
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

    def eliminate_variables(self, tight: Collection[int]) -> None:
        """Make rows of all variables that occur in some inequality; the others stay at zero.

        Inequalities that are likely to be tight become columns first.
        """
        for c, symbol in enumerate(self.columns):
            if not self.is_variable(symbol):
                continue
            usable = [r for r, s in enumerate(self.symbols) if self.rows[r][c] and self.is_slack(s)]
            if usable:
                self.pivot(min(usable, key=lambda r: self.symbols[r] not in tight), c)

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
        """Primal simplex from a feasible dictionary, to the end or to an unbounded ray."""
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
                values[symbol] = _quotient(row[-1], self.denominator * self.given.unit)
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
        """Return the point where optimising ended, with its proof."""
        scale = self.cost_scale / int(self.denominator)
        terms = {s: int(x) * scale for s, x in zip(self.columns, self.cost, strict=False)}
        return Optimal(self.point(), self.value(), *self.multipliers(terms))

    def value(self) -> Fraction:
        """Return the value of the objective with every column at zero."""
        return self.cost_scale * _quotient(self.cost[-1], self.denominator * self.given.unit)

    def infeasible(self) -> Infeasible:
        """Read the Farkas certificate off the row that cannot hold."""
        r = self.conflict
        assert r is not None
        row = self.rows[r]
        scale = _quotient(self.given.unit, abs(row[-1]))
        flip = 1 if row[-1] < 0 else -1  # only an equality row may have a positive constant
        terms = {s: -flip * int(x) * scale for s, x in zip(self.columns, row, strict=False)}
        terms[self.symbols[r]] = flip * int(self.denominator) * scale
        return Infeasible(*self.multipliers(terms))

    def multipliers(self, terms: dict[int, Fraction]) -> tuple[RationalVector, RationalVector]:
        """Return multipliers of the given rows from those of rows with coprime coefficients."""
        return self.given.given({s - self.variables: x for s, x in terms.items()})


def _work(entries: int, size: Any) -> float:
    """Return the work of writing this many entries; long numbers count more often."""
    return 10 * entries * (1 + int(size).bit_length() / 1000)


def _quotient(x: Any, y: Any) -> Fraction:
    """Return the fraction of two integers of any kind."""
    return Fraction(int(x), int(y))
