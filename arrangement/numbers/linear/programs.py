"""Exact linear programs, each answer with its certificate.

The form is: minimise ``c . x`` over free x in R^n with ``a . x + b >= 0`` for every inequality row
``(a, b)`` and ``e . x + f = 0`` for every equality row ``(e, f)``: the constant stands last.

Method: floats guess which rows are tight; the point, and the multipliers or the ray, of these are
solved for and checked over integers, once. Where that fails exact pivots decide (`dictionary`).
Sizes here are small (tens of rows). The worst case is exponential, as for every known simplex rule;
the certificates make each answer checkable.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from arrangement.errors import ArrangementError
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive

from .dictionary import Dictionary
from .float_dictionary import FloatDictionary
from .program_rows import Infeasible, Numbers, Optimal, Row, Rows, Terms, Unbounded, scale_of

__all__ = (
    "Infeasible", "Optimal", "Program", "Row", "Unbounded", "feasible_point", "minimize",
    "some_point",
)  # fmt: skip

#: Of less work than this exact pivots are as quick as a guess.
_SHORT = 2000


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
        weights, found = self._guessed(objective)
        if found is None or self._at is None:
            exact = self._pivots(objective)
            return exact.optimize() or exact.optimal()
        point = self._rows.rational(self._at)
        numbers, common = found
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
        weights, found = self._guessed(objective)
        if found is None or self._at is None:
            exact = self._pivots(objective)
            return None if exact.optimize() else exact.value()
        if not isinstance(found[0], dict):
            return None
        numbers, common = self._at
        size = scale_of(objective, weights) / (int(common) * self._rows.unit)
        return size * int(dot(weights, numbers))

    def _guessed(self, objective: Row) -> tuple[IntegerVector, Terms | Numbers | None]:
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
