"""Small linear programs in floating point: a guess of the rows that hold with equality.

The form is that of `programs`, for one objective: the greatest value of the last variable. The dual
simplex method takes in the row that is violated most, so that rows may be added at any time and
the next solution starts from the last one. Nothing here is proved: whoever uses an answer checks
it exactly, and does without where there is none.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from arrangement.numbers.float_filter import Floats

#: Of rows whose largest coefficient is 1: how much one may be violated, and a pivot's least size.
_TOLERANCE, _PIVOT = 1e-10, 1e-9
#: Degenerate programs may cycle; most end after twice as many steps as there are variables.
_STEPS = 12


class FloatProgram:
    """The greatest last variable with ``rows . (x, 1) >= 0``.

    Args:
        rows: (k, n + 1), constant last.
        basis: of n independent rows; the last is ``constant - x_n``, and the others together
            with it are not an obstacle to a larger x_n: with the objective their multipliers are 0.

    Attributes:
        point: (n,), with equality in the rows of the basis.
    """

    def __init__(self, rows: Floats, basis: Sequence[int]) -> None:
        self._rows, self._sizes = _scaled(rows)
        self._basis = np.array(basis)
        self._restart()

    def _restart(self) -> None:
        chosen = self._rows[self._basis]
        self._inverse = np.linalg.inv(chosen[:, :-1])
        self._weights = np.maximum(-self._inverse[-1], 0.0)
        self.point: Floats = -self._inverse @ chosen[:, -1]

    def add(self, rows: Floats) -> None:
        """Take in further rows."""
        scaled, sizes = _scaled(rows)
        self._rows = np.concatenate([self._rows, scaled])
        self._sizes = np.concatenate([self._sizes, sizes])

    def multipliers(self) -> Floats:
        """Return (k,), at least 0: their sum of the rows is ``constant - x_n``."""
        found = np.zeros(len(self._rows))
        found[self._basis] = self._weights
        return found / self._sizes

    def solve(self) -> bool:
        """Move to the greatest last variable; return whether that ended well."""
        matrix, constants = self._rows[:, :-1], self._rows[:, -1]
        try:
            for _ in range(_STEPS * matrix.shape[1]):
                slack = matrix @ self.point + constants
                entering = int(slack.argmin())
                if slack[entering] >= -_TOLERANCE * (1.0 + float(np.abs(self.point).max())):
                    self._restart()
                    return bool(np.isfinite(self.point).all())
                if not self._exchange(entering):
                    return False
        except np.linalg.LinAlgError:
            pass
        return False

    def _exchange(self, entering: int) -> bool:
        """Take a row into the basis for one whose multiplier reaches 0 first, if there is one."""
        share = self._rows[entering, :-1] @ self._inverse
        usable = share > _PIVOT
        if not usable.any():
            return False
        ratio = np.where(usable, self._weights, np.inf) / np.where(usable, share, 1.0)
        least = float(ratio.min())
        # Of equal ones the largest pivot.
        leaving = int(np.where(ratio <= least + 1e-12, share, 0.0).argmax())
        column = self._inverse[:, leaving] / share[leaving]
        self._inverse -= np.outer(column, share)
        self._inverse[:, leaving] = column
        self._weights = np.maximum(self._weights - least * share, 0.0)
        self._weights[leaving] = least
        self._basis[leaving] = entering
        self.point = -self._inverse @ self._rows[self._basis, -1]
        return True


def _scaled(rows: Floats) -> tuple[Floats, Floats]:
    """Return rows with a largest coefficient of 1, and what they were divided by."""
    sizes = np.abs(rows[:, :-1]).max(axis=1)
    sizes = np.where(sizes > 0, sizes, 1.0)
    return rows / sizes[:, None], sizes
