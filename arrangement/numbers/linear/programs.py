"""Exact linear programs, each answer with its certificate.

The form is: minimise ``c . x`` over free x in R^n with ``a . x + b >= 0`` for every inequality row
``(a, b)`` and ``e . x + f = 0`` for every equality row ``(e, f)``: the constant stands last.

1. Floats guess which rows are tight; the point, and the multipliers or the ray, of these are solved
   for and checked over integers, once (`Rows`). A guess needs one or two small systems, where exact
   pivots would write all rows anew each time.
2. Where that fails exact pivots decide (`Dictionary`): rows over integers with one denominator,
   exact divisions, no gcd. Equalities and free variables are pivoted away first; then the dual
   simplex method with a zero objective finds a feasible point, and the primal one improves it, both
   with Bland's rule, so that degenerate input ends too.

Sizes here are small (tens of rows). The worst case is exponential, as for every known simplex rule;
the certificates make each answer checkable.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.errors import ArrangementError
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    dot,
    fast_integers,
    largest,
    primitive,
)
from arrangement.numbers.linear.float_dictionary import FloatDictionary

Row: TypeAlias = Sequence[Fraction | int]
#: Integers over a common one above 0.
Numbers: TypeAlias = tuple[list[int], int]
#: Multipliers of rows by their numbers, over a common integer above 0.
Terms: TypeAlias = tuple[dict[int, int], int]
#: Of less work than this exact pivots are as quick as a guess.
_SHORT = 2000


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
        rows = [*inequalities, *equalities]
        integers = list(map(self._whole, rows))
        self.scales = [scale_of(row, whole) for row, whole in zip(rows, integers, strict=True)]
        ends = [Fraction(row[-1]) / t for row, t in zip(rows, self.scales, strict=True)]
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
        solution = self._solve([self._row(k) for k in tight])
        if solution is None:
            return None
        numbers, common = solution
        at = [*numbers, common]
        for k, row in enumerate(self.integers):
            value = dot(row, at)
            if value < 0 or (value and k >= self.first_equality):
                return None
        return solution

    def rational(self, solution: Numbers) -> RationalVector:
        """Return a point in the units of the given rows."""
        numbers, common = solution
        return tuple(Fraction(int(x), int(common) * self.unit) for x in numbers)

    def multipliers(self, target: Sequence[int], tight: Sequence[int]) -> Terms | None:
        """Return the multipliers of tight rows that give a row of n coefficients, if they do.

        Those of inequalities are at least 0.
        """
        columns = zip(*(self._row(k)[:-1] for k in tight), strict=True)
        solution = self._solve([[*c, -x] for c, x in zip(columns, target, strict=True)])
        if solution is None:
            return None
        numbers, common = solution
        terms = {k: x for k, x in zip(tight, numbers, strict=True) if x}
        for k, x in terms.items():
            if k >= len(self.integers) or (x < 0 and k < self.first_equality):
                return None
        return terms, common

    def ray(self, objective: Sequence[int], symbol: int, tight: Sequence[int]) -> Numbers | None:
        """Return the direction in which one tight row rises, if it lowers an objective for ever."""
        rows = [[*self._row(k)[:-1], -int(k == symbol)] for k in tight]
        solution = self._solve(rows)
        if solution is None:
            return None
        numbers, common = solution
        if symbol >= len(self.integers) and dot(objective, numbers) > 0:
            numbers = [-x for x in numbers]
        changes = [dot(row[:-1], numbers) for row in self.integers]
        falls = dot(objective, numbers) < 0 and min(changes, default=0) >= 0
        return (numbers, common) if falls and not any(changes[self.first_equality :]) else None

    def refutation(self, row: int, tight: Sequence[int]) -> Terms | None:
        """Return multipliers of a row and of tight ones whose sum is below 0, if there are some."""
        for flip in (1, -1) if row >= self.first_equality else (1,):
            multipliers = self.multipliers([-flip * x for x in self.integers[row][:-1]], tight)
            if multipliers is not None:
                terms, common = multipliers
                terms[row] = terms.get(row, 0) + flip * common
                if self._sum(terms) < 0:
                    return multipliers
        return None

    def infeasible(self, found: Terms) -> tuple[RationalVector, RationalVector]:
        """Return the multipliers of given rows with the sum -1."""
        terms, total = found[0], -self._sum(found[0])
        return self.given({k: Fraction(int(x) * self.unit, int(total)) for k, x in terms.items()})

    def _sum(self, terms: dict[int, int]) -> int:
        return sum(x * self.integers[k][-1] for k, x in terms.items())

    def given(self, terms: dict[int, Fraction]) -> tuple[RationalVector, RationalVector]:
        """Return multipliers of the given rows from those of the integer rows."""
        values = [Fraction(0)] * len(self.scales)
        for k, x in terms.items():
            if x and k >= 0:
                values[k] = x / self.scales[k]
        return tuple(values[: self.first_equality]), tuple(values[self.first_equality :])

    def _row(self, k: int) -> list[int]:
        count = len(self.integers)
        if k < count:
            return self.integers[k]
        return [int(k - count == j) for j in range(self.variables + 1)]

    def _solve(self, rows: list[list[int]]) -> Numbers | None:
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
            return Fraction(1) if x == whole else Fraction(Fraction(x) / whole)
    return Fraction(1)


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


__all__ = (
    "Infeasible", "Optimal", "Program", "Row", "Unbounded", "feasible_point", "minimize",
    "some_point",
)  # fmt: skip


class Program:
    """A system of conditions, and the minima of as many objectives as are asked for.

    Each minimisation starts where the last one ended. Values, and whether there is a solution, do
    not depend on that; where many points are optimal, which one is returned does.

    Args:
        n: the number of variables.
        inequalities: rows of n + 1 rationals, constant last, each ``>= 0``.
        equalities: rows of n + 1 rationals, constant last, each ``= 0``.
        deadline: looked at before each pivot; None for no limit.

    Raises:
        ArrangementError: a row has the wrong length.
        TimeoutError: the deadline has passed.
    """

    def __init__(
        self,
        n: int,
        inequalities: Sequence[Row],
        equalities: Sequence[Row] = (),
        deadline: Deadline | None = None,
    ) -> None:
        for row in (*inequalities, *equalities):
            if len(row) != n + 1:
                raise ArrangementError(f"a row has {len(row)} entries; {n} variables need {n + 1}")
        self._rows = Rows(n, inequalities, equalities, deadline or Deadline())
        self._exact: Dictionary | None = None
        self._refuted: Terms | None = None
        #: The point that was reached, over a common integer.
        self._at: Numbers | None = None
        self._floats: FloatDictionary | None = None
        if self._rows.work > _SHORT:
            rows = self._rows.integers
            self._floats = FloatDictionary.of_integers(rows, n + 1, len(equalities))
            # Numbers in arrays are written a hundred times as fast, in about 2 n pivots.
            self._rows.deadline.check(n**2 * len(self._rows.integers) / 50)
            conflict = self._floats.start()
            if conflict == -1:
                self._at = self._rows.point(self._floats.tight)
            elif conflict is not None:
                self._refuted = self._rows.refutation(conflict, self._floats.tight)
        if self._at is None and self._refuted is None:
            self._exact = Dictionary(self._rows, self._tight)

    @property
    def feasible(self) -> bool:
        """Whether a point satisfies all rows; of long numbers the proof may take much longer."""
        if self._exact is not None:
            return self._exact.conflict is None
        return self._at is not None

    @property
    def _tight(self) -> list[int]:
        """The rows that floats guess to be tight."""
        return [] if self._floats is None else self._floats.tight

    def _infeasible(self) -> Infeasible:
        if self._refuted is not None:
            return Infeasible(*self._rows.infeasible(self._refuted))
        assert self._exact is not None
        return self._exact.infeasible()

    def point(self) -> RationalVector | Infeasible:
        """Return a point that satisfies all rows, or the proof that there is none."""
        if not self.feasible:
            return self._infeasible()
        if self._at is None:
            assert self._exact is not None
            return self._exact.point()
        return self._rows.rational(self._at)

    def minimize(self, objective: Row) -> Optimal | Infeasible | Unbounded:
        """Minimise ``objective . x`` exactly.

        Raises:
            ArrangementError: the objective has the wrong length.
        """
        if not self.feasible:
            return self._infeasible()
        weights, guess = self._guess(objective)
        if guess is None or self._at is None:
            exact = self._pivots(objective)
            return exact.optimize() or exact.optimal()
        point = self._rows.rational(self._at)
        numbers, common = guess
        if not isinstance(numbers, dict):
            return Unbounded(point, tuple(Fraction(int(x), int(common)) for x in numbers))
        scale = scale_of(objective, weights) / int(common)
        y, z = self._rows.given({k: int(x) * scale for k, x in numbers.items()})
        return Optimal(point, Fraction(dot(objective, point)), y, z)

    def least(self, objective: Row) -> Fraction | None:
        """Return the least value of ``objective . x``; None if there is none.

        Raises:
            ArrangementError: the objective has the wrong length.
        """
        if not self.feasible:
            return None
        weights, guess = self._guess(objective)
        if guess is None or self._at is None:
            exact = self._pivots(objective)
            return None if exact.optimize() else exact.value()
        if not isinstance(guess[0], dict):
            return None
        numbers, common = self._at
        size = scale_of(objective, weights) / (int(common) * self._rows.unit)
        return size * int(dot(weights, numbers))

    def _guess(self, objective: Row) -> tuple[IntegerVector, Terms | Numbers | None]:
        """Move to a least point that floats find, or one on a ray.

        Returns:
            The objective in integers; the multipliers that prove it least, or the ray, or None.
        """
        n = self._rows.variables
        if len(objective) != n:
            raise ArrangementError(f"the objective has {len(objective)} entries; expected {n}")
        weights = primitive(tuple(map(Fraction, objective)))
        if self._exact is not None or self._floats is None:
            return weights, None
        end = self._floats.minimize(weights)
        tight = self._floats.tight
        at = None if end is None else self._rows.point(tight)
        if end is None or at is None:
            return weights, None
        self._at = at
        if end == -1:
            return weights, self._rows.multipliers(weights, tight)
        return weights, self._rows.ray(weights, end, tight)

    def _pivots(self, objective: Row) -> Dictionary:
        """Return the exact dictionary with an objective."""
        if self._exact is None:
            self._exact = Dictionary(self._rows, self._tight)
        self._exact.set_cost(objective)
        return self._exact


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


def some_point(
    n: int, inequalities: Sequence[Row], equalities: Sequence[Row] = ()
) -> RationalVector | None:
    """Return a point of R^n that satisfies all rows; None, without a proof, if there is none."""
    program = Program(n, inequalities, equalities)
    point = program.point() if program.feasible else None
    return None if isinstance(point, Infeasible) else point
