"""Linear programs of the form of `programs` in floating point: a guess of the rows that are tight.

The method is that of `programs.Dictionary`, with the largest pivots instead of Bland's rule, and
with any cost above 0 in the search for a point, which then hardly ever comes back to where it was.
Nothing here is proved: whoever uses a guess solves for it exactly and checks, and does without
where there is none.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from arrangement.numbers.float_filter import Booleans, Floats

#: How far below 0 a row of size 1 may be.
_TOLERANCE = 1e-9
_MIN_PIVOT = 1e-9
#: Degenerate programs may cycle; most end after twice as many steps as there are variables.
_MAX_STEPS_PER_VARIABLE = 12
#: How often rows and columns are balanced in turn.
_MAX_BALANCINGS = 20
#: Bits of integers that are read.
_MANTISSA_BITS = 60
#: The largest exponent of floats here.
_MAX_EXPONENT = 1000
#: More than any exponent.
_HUGE = 2**40


class FloatDictionary:
    """Symbols are the rows, from 0, then the variables; columns are at 0.

    Args:
        rows: (k, n + 1), of a size of about 1, the constant last; the equalities last of all.
        equalities: their number.
        signed: how many variables, the first ones, are at least 0; not with equalities.
    """

    def __init__(self, rows: Floats, equalities: int = 0, signed: int = 0) -> None:
        k, n = len(rows), rows.shape[1] - 1
        self._k, self._first_equality = k + signed, k + signed - equalities
        self._max_steps = _MAX_STEPS_PER_VARIABLE * (n + 4)
        self._table, self._scale = rows, np.zeros(n + 1, int)
        self._rows, self._columns = np.arange(k), np.arange(k, k + n)
        self._fixed: list[int] = []

    @classmethod
    def of_integers(
        cls, rows: Sequence[Sequence[int]], width: int, equalities: int
    ) -> FloatDictionary:
        """Return the dictionary of rows of integers of any size, of `width` entries each."""
        table, scale = _balance(*_split(rows, width))
        dictionary = cls(table, equalities)
        dictionary._scale = scale
        return dictionary

    @property
    def tight(self) -> list[int]:
        """The symbols at 0: all n of them where the rows leave no direction free."""
        return [*self._fixed, *self._columns.tolist()]

    @property
    def point(self) -> Floats:
        """The variables where columns are at 0, if their rows were not scaled."""
        values = np.zeros(len(self._rows) + len(self._columns) + len(self._fixed))
        values[self._rows] = self._table[:, -1]
        return values[len(self._rows) :]

    def start(self) -> int | None:
        """Find a point; return -1, or a row that can never hold, or None without either."""
        self._eliminate(np.arange(self._k) >= self._first_equality)
        for r in np.flatnonzero((self._rows >= self._first_equality) & (self._rows < self._k)):
            if abs(self._table[r, -1]) > _TOLERANCE:
                return int(self._rows[r])
        self._eliminate(self._rows < self._first_equality)
        # Further variables do not matter.
        self._drop(self._columns >= self._k)
        n = len(self._columns)
        cost = np.append(1.0 + np.arange(n) * 0.6180339887 % 1.0, 0.0)
        self._table = np.concatenate([self._table, [cost]])
        column = self._feasible()
        self._table = self._table[:-1]
        return column

    def _eliminate(self, chosen: Booleans) -> None:
        """Make columns of chosen rows, the largest pivot first; fix those that are equalities."""
        rows = np.flatnonzero(chosen)
        while len(rows):
            free = np.flatnonzero(self._columns >= self._k)
            part = np.abs(self._table[np.ix_(rows, free)])
            if not part.size:
                return
            place, column = divmod(int(part.argmax()), len(free))
            if part[place, column] < _MIN_PIVOT:
                return
            r = int(rows[place])
            self._pivot(r, int(free[column]))
            rows = np.delete(rows, place)
            if self._columns[free[column]] >= self._first_equality:
                self._drop(np.arange(len(self._columns)) == free[column])

    def _drop(self, columns: Booleans) -> None:
        """Leave columns at 0 for good."""
        if not columns.any():
            return
        self._fixed += self._columns[columns].tolist()
        self._columns = self._columns[~columns]
        self._table = np.delete(self._table, np.flatnonzero(columns), axis=1)

    def _feasible(self) -> int | None:
        """Dual simplex method; the cost stands in the last row."""
        table = self._table
        for _ in range(self._max_steps):
            ends = np.where(self._rows < self._first_equality, table[:-1, -1], 0.0)
            r = int(ends.argmin()) if len(ends) else -1
            if r < 0 or ends[r] >= -_TOLERANCE:
                return -1
            usable = np.flatnonzero(table[r, :-1] > _MIN_PIVOT)
            if not len(usable):
                return int(self._rows[r])
            row = table[r, usable]
            ratio = table[-1, usable] / row
            # Of equal ones the largest pivot.
            c = int(usable[np.where(ratio <= ratio.min() + 1e-12, row, 0.0).argmax()])
            self._pivot(r, c)
        return None

    def minimize(self, objective: Sequence[int]) -> int | None:
        """Move to a least point; return -1 there, a tight symbol that may move on for ever, None.

        A symbol of a variable may move either way.
        """
        mantissas, exponents = _split([objective], len(objective))
        exponents += self._scale[:-1]
        weights = np.ldexp(mantissas, np.clip(exponents - exponents.max(), -_MAX_EXPONENT, 0))[0]
        for j in self._fixed:
            if j >= self._k and weights[j - self._k]:
                return j
        variables = self._rows >= self._k
        cost = weights[self._rows[variables] - self._k] @ self._table[variables]
        size = np.abs(cost).max() or 1.0
        self._table = np.concatenate([self._table, [cost / size]])
        column = self._least()
        self._table = self._table[:-1]
        return column

    def _least(self) -> int | None:
        """Primal simplex method; the cost stands in the last row."""
        table = self._table
        for _ in range(self._max_steps):
            if not len(self._columns):
                return -1
            c = int(table[-1, :-1].argmin())
            if table[-1, c] >= -_TOLERANCE:
                return -1
            column = table[:-1, c]
            falling = (self._rows < self._first_equality) & (column < -_MIN_PIVOT)
            if not falling.any():
                return int(self._columns[c])
            ends = np.maximum(table[:-1, -1], 0.0)
            ratio = np.where(falling, ends, np.inf) / np.where(falling, -column, 1.0)
            r = int(np.where(ratio <= ratio.min() + 1e-12, -column, 0.0).argmax())
            self._pivot(r, c)
        return None

    def _pivot(self, r: int, c: int) -> None:
        """Exchange row r and column c."""
        table = self._table
        p, row, column = table[r, c], table[r].copy(), table[:, c].copy()
        table -= (column / p)[:, None] * row
        table[:, c], table[r] = column / p, row / -p
        table[r, c] = 1 / p
        self._rows[r], self._columns[c] = self._columns[c], self._rows[r]


def _split(rows: Sequence[Sequence[int]], width: int) -> tuple[Floats, Any]:
    """Return integers of any size as floats of size 1/2 to 1, or 0, and exponents of 2."""
    cut = [[max(int(x).bit_length() - _MANTISSA_BITS, 0) for x in row] for row in rows]
    short = [
        [int(x) >> k for x, k in zip(*two, strict=True)] for two in zip(rows, cut, strict=True)
    ]
    mantissas, exponents = np.frexp(np.array(short, float).reshape(-1, width))
    return mantissas, exponents + np.array(cut, int).reshape(-1, width)


def _balance(mantissas: Floats, exponents: Any) -> tuple[Floats, Any]:
    """Return a matrix whose rows and columns are scaled towards 1, and the columns' exponents.

    Constants are a column like others: points have a unit of their own.
    """
    there = mantissas != 0
    sizes, shift = np.where(there, exponents, 0).astype(float), np.zeros(exponents.shape[1])
    for _ in range(_MAX_BALANCINGS):
        moved = 0.0
        for axis in (1, 0):
            count = np.maximum(there.sum(axis=axis, keepdims=True), 1)
            middle = np.rint(sizes.sum(axis=axis, keepdims=True) / count)
            sizes = np.where(there, sizes - middle, 0)
            shift -= 0 if axis else middle[0]
            moved = max(moved, float(np.abs(middle).max(initial=0)))
        if moved <= 1:
            break
    # At last no coefficient is above 1.
    high = np.where(there, sizes, -_HUGE)[:, :-1].max(axis=1, initial=-_HUGE, keepdims=True)
    sizes = np.clip(sizes - np.where(high > -_HUGE, high, 0), -_MAX_EXPONENT, _MAX_EXPONENT)
    return np.ldexp(mantissas, sizes.astype(int)), shift.astype(int)
