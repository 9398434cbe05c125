"""Many small systems at once in floating point, each answer proven by an error bound.

The conditions of one choice of states, when its sticking contacts lie on at most two tangential
planes, are ``A z = b`` with A square, and inequalities. The unknowns z are d and, for each of these
planes, the sum C of the tangential forces of the contacts that stick on it. For an approximate
inverse R of A with ``|I - R A| <= beta < 1`` (largest row sum), A is regular, and its only solution
is within ``|R (b - A z')| / (1 - beta)`` of any approximate one z'. Both are bounded with the
rounding errors of their own computation, in any order of summation [Higham2002], [Rump2010]. A
condition that is negative everywhere so near proves that no equilibrium has these states. What the
bound does not decide is left to exact arithmetic.

Along ``base + t direction``, t > 0, the solution is ``z0 + t z1``: that of the base, and t times
that of the direction without preload. So each condition has an upper bound linear in t, the sum of
two bounds as above. Where no t > 0 satisfies all of them, no equilibrium has these states.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.console.progress import watched
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Booleans, Floats, error_bound
from equilibrium.core.contacts import FloatContacts, are_moderate, nearest
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows

from .contact_states import DETACHED, Codes

Integers: TypeAlias = npt.NDArray[np.int64]

#: Above the rounding errors of a bound's own computation: sums of positive numbers, a few hundred
#: roundings at most.
_MARGIN = 1.01
#: Above what underflow loses: nothing that matters is as small.
_UNDERFLOW = 1e-200
#: Of a preload less a scalar product of a motion and ``k N``: two rounded factors and their
#: product, the product with the motion, three sums; three to spare.
_FORCE_ERROR = error_bound(7 + 3)
#: Of a number that is rounded once, and once more when it is used.
_ROUNDED_ERROR = error_bound(2)
_BATCH_ROWS = 8192


class Screen:
    """The systems of all contact states of one grasp, ready for any wrench.

    Args:
        grasp: in the plane.
        codes: choices of contact states, as `contact_states.state_codes` returns them.
    """

    def __init__(self, grasp: Grasp, codes: Codes) -> None:
        self.contacts, self.codes = FloatContacts(ContactRows.of_grasp(grasp)), codes
        self._grasp = grasp
        self._batches: list[_Batch] = []
        if not self.contacts.moderate:
            return
        planes = grasp.tangential_arrangement()
        self.class_of = np.array(planes.class_of, dtype=np.int64)
        self.orientation = np.array(planes.orientation, dtype=np.float64)
        self.plane = self.contacts.tangent[list(planes.firsts)].reshape(-1, 3)
        parts = [
            (rows[start : start + _BATCH_ROWS], classes[start : start + _BATCH_ROWS])
            for rows, classes in self._by_sticking_planes()
            for start in range(0, len(rows), _BATCH_ROWS)
        ]
        for rows, classes in watched(parts, "batches of states"):
            self._batches.append(_Batch(self, rows, classes))

    def _by_sticking_planes(self) -> Iterator[tuple[Integers, Integers]]:
        """Yield the choices with 0, 1 and 2 tangential planes on which contacts stick.

        As the rows of the choices, and these planes (choices, number).
        """
        present = np.zeros((len(self.codes), len(self.plane)), dtype=bool)
        for contact, plane in enumerate(self.class_of.tolist()):
            present[:, plane] |= self.codes[:, contact] == 0
        number = present.sum(axis=1)
        for planes in range(3):
            rows = np.flatnonzero(number == planes)
            if len(rows):
                yield rows, np.nonzero(present[rows])[1].reshape(len(rows), planes)

    @cached_property
    def singular(self) -> Booleans:
        """The choices whose systems floats cannot solve, whatever the wrench."""
        singular = np.ones(len(self.codes), dtype=np.bool_)
        for batch in self._batches:
            singular[batch.rows] = ~(batch.beta < 1)
        return singular

    def possible(self, base: RationalVector, direction: RationalVector | None = None) -> Booleans:
        """Return for each choice of states whether the wrench ``base`` may have it.

        With a direction, whether ``base + t direction`` may have it for some t > 0. False is
        proven: no equilibrium with these states holds such a wrench.
        """
        possible = np.ones(len(self.codes), dtype=np.bool_)
        start = self._grasp.total_load(base)
        wrenches = [start] if direction is None else [start, direction]
        if all(map(are_moderate, wrenches)):
            floats = [np.array([nearest(x) for x in wrench]) for wrench in wrenches]
            for batch in watched(self._batches, "batches of states"):
                possible[batch.rows] = batch.possible(*floats)
        return possible


@dataclass(frozen=True)
class _Solutions:
    """Approximate solutions with a bound of their errors: motions, forces C, bound per row.

    Attributes:
        loaded: 1, or 0 if the preloads are left out.
    """

    motion: Floats
    forces: Floats
    error: Floats
    loaded: float

    @property
    def reach(self) -> Floats:
        """The error, with that of the product of a motion and three rounded numbers."""
        reach: Floats = self.error + _FORCE_ERROR * np.abs(self.motion).max(axis=1)
        return reach

    def at(self, rows: Integers) -> _Solutions:
        """Return those of some rows."""
        return _Solutions(self.motion[rows], self.forces[rows], self.error[rows], self.loaded)


class _Batch:
    """Choices of states with equally many tangential planes on which contacts stick."""

    def __init__(self, screen: Screen, rows: Integers, classes: Integers) -> None:
        self.screen, self.contacts = screen, screen.contacts
        self.codes, self.rows, self.classes = screen.codes[rows], rows, classes
        self.size = 3 + classes.shape[1]
        self._build()
        self._invert()

    def _build(self) -> None:
        """Add up the balances: the preloads, the matrix, and bounds of their errors."""
        c, (count, m) = self.contacts, self.codes.shape
        # Friction of contacts that stick is unknown.
        along, back, still = (
            (wrench[:, :, None] * c.spring[:, None, :]).reshape(m, 12)
            for wrench in (*c.edges, c.normal)
        )
        on = (self.codes == code for code in (1, -1, 0))
        parts = [x.astype(np.float64) @ y for x, y in zip(on, (along, back, still), strict=True)]
        sums = sum(parts, np.zeros(12)).reshape(count, 3, 4)
        # A term has at most four rounded factors, three products and a sum; three sums of m terms
        # are added: m + 11 roundings, taken four times. |N| + |mu T| is the larger edge.
        sizes = np.maximum(np.abs(along), np.abs(back)).sum(axis=0)
        errors = error_bound(4 * (m + 11) - 2) * sizes.reshape(3, 4)
        self.load, self.load_error = sums[:, :, 0], errors[:, 0]
        self.matrix = np.zeros((count, self.size, self.size))
        self.matrix[:, :3, :3] = -sums[:, :, 1:]
        self.matrix_error = np.zeros((self.size, self.size))
        self.matrix_error[:3, :3] = errors[:, 1:]
        for j in range(self.size - 3):
            plane = self.screen.plane[self.classes[:, j]]
            self.matrix[:, :3, 3 + j], self.matrix[:, 3 + j, :3] = -plane, plane

    def _invert(self) -> None:
        """Compute R and beta; where A is singular in floating point, beta is above 1."""
        with np.errstate(all="ignore"):
            regular = np.abs(np.linalg.det(self.matrix)) > 0
            unit = np.eye(self.size)
            self.inverse = np.linalg.inv(np.where(regular[:, None, None], self.matrix, unit))
            size = np.abs(self.inverse)
            # An entry is rounded and multiplied, then size sums with that of the unit matrix; one
            # to spare, and all of it twice.
            product = error_bound(2 * (self.size + 3))
            slack = self.matrix_error + product * np.abs(self.matrix)
            residual = np.abs(unit - self.inverse @ self.matrix) + size @ slack
            beta = _MARGIN * residual.sum(axis=2).max(axis=1) + 1e-12
        self.beta = np.where(regular & (beta < 0.5), beta, np.inf)

    def _solve(self, wrench: Floats, loaded: float = 1.0) -> _Solutions:
        """Solve for one wrench, with the preloads or (`loaded` 0) without."""
        right = np.zeros((len(self.codes), self.size, 1))
        right[:, :3, 0] = loaded * self.load + wrench
        z = self.inverse @ right
        size = np.abs(z)
        bound = np.abs(right - self.matrix @ z) + self.matrix_error @ size
        # As in `_invert`, and one more subtraction.
        product = error_bound(2 * (self.size + 4))
        bound += product * (np.abs(right) + np.abs(self.matrix) @ size)
        bound[:, :3, 0] += loaded * self.load_error + _ROUNDED_ERROR * np.abs(wrench)
        spread = (np.abs(self.inverse) @ bound)[:, :, 0].max(axis=1)
        error = _MARGIN * spread / (1 - self.beta) + _UNDERFLOW
        # Without any load and wrench the solution is 0, and nothing was rounded.
        error = np.where(bound.any(axis=(1, 2)), error, 0.0)
        error = np.where(self.beta < 1, error, np.inf)
        return _Solutions(z[:, :3, 0], z[:, 3:, 0], error, loaded)

    def possible(self, base: Floats, direction: Floats | None = None) -> Booleans:
        """Return whether all conditions of each choice may hold; see `Screen`."""
        with np.errstate(all="ignore"):
            solutions = [self._solve(base)]
            if direction is not None:
                solutions.append(self._solve(direction, 0.0))
            bounds = [self._springs(solution) for solution in solutions]
            possible = ~_surely_empty(*bounds)
            left = np.flatnonzero(possible)
            if len(left):
                bounds = [
                    np.hstack([springs[left], self._slips_and_friction(solution.at(left), left)])
                    for springs, solution in zip(bounds, solutions, strict=True)
                ]
                possible[left] = ~_surely_empty(*bounds)
        return possible

    def _springs(self, solutions: _Solutions) -> Floats:
        """Return upper bounds of the spring conditions, by contact."""
        normal, doubt = self._normal_forces(solutions)
        bounds: Floats = np.where(self.codes == DETACHED, -normal, normal) + doubt
        return bounds

    def _normal_forces(self, solutions: _Solutions) -> tuple[Floats, Floats]:
        """Return ``preload - stiffness N . d`` and a bound of its error, by contact."""
        spring, preload = self.contacts.spring[:, 1:], self.contacts.preload
        normal = solutions.loaded * preload + solutions.motion @ spring.T
        doubt = _MARGIN * np.outer(solutions.reach, np.abs(spring).sum(axis=1))
        return normal, doubt + solutions.loaded * (_MARGIN * _FORCE_ERROR * preload)

    def _slips_and_friction(self, solutions: _Solutions, rows: Integers) -> Floats:
        """Return upper bounds of the other conditions of some rows; infinite where none is."""
        data, codes = self.contacts, self.codes[rows]
        moved = solutions.motion @ data.tangent.T
        doubt = _MARGIN * np.outer(solutions.reach, np.abs(data.tangent).sum(axis=1))
        slips = (codes != 0) & (codes != DETACHED)
        bounds = [np.where(slips, moved * codes + doubt, np.inf)]
        if self.size > 3:
            bounds += self._friction(solutions, rows)
        return np.concatenate(bounds, axis=1)

    def _friction(self, solutions: _Solutions, chosen: Integers) -> list[Floats]:
        """Return upper bounds of the friction conditions, two for each sticking plane.

        They are the limit of all contacts that stick on it, less or plus their force along the
        tangent of the first of them; they stand in the column of this one.
        """
        screen, codes, m = self.screen, self.codes[chosen], self.codes.shape[1]
        normal, doubt = self._normal_forces(solutions)
        lower, upper = np.full((2, len(codes), m), np.inf)
        rows = np.arange(len(codes))
        for j in range(self.size - 3):
            sticking = (codes == 0) & (screen.class_of == self.classes[chosen, j][:, None])
            share = sticking * self.contacts.friction
            limit = (share * normal).sum(axis=1)
            unsure = (share * (doubt + error_bound(2 * (m + 3)) * np.abs(normal))).sum(axis=1)
            first = sticking.argmax(axis=1)
            force = solutions.forces[:, j] * screen.orientation[first]
            unsure = _MARGIN * (unsure + solutions.error + _ROUNDED_ERROR * np.abs(force))
            lower[rows, first] = limit - force + unsure
            upper[rows, first] = limit + force + unsure
        return [lower, upper]


def _surely_empty(at_zero: Floats, growth: Floats | float = 0.0) -> Booleans:
    """Return for each row whether no t > 0 has ``at_zero + t growth >= 0`` in every column.

    A column that is not finite says nothing. The ends are rounded by less than 10^-15 of their
    size; the largest and the smallest numbers are kept clear of the limits of the format.
    """
    known = np.isfinite(at_zero) & np.isfinite(growth)
    never = known & (at_zero <= 0) & (growth <= 0) & ((at_zero < 0) | (growth < 0))
    ends = at_zero / -growth
    low = np.where(known & (growth > 0) & (at_zero < 0), ends, 0.0).max(axis=1, initial=0.0)
    high = np.where(known & (growth < 0) & (at_zero > 0), ends, np.inf).min(axis=1, initial=np.inf)
    apart = np.minimum(low, 1e300) * (1 - 1e-15) > high * (1 + 1e-15) + 1e-290
    empty: Booleans = never.any(axis=1) | apart
    return empty
