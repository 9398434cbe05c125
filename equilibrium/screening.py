"""Many small systems at once in floating point, each answer proven by an error bound.

The conditions of one choice of states, when its sticking contacts lie on at most two tangential
planes, are ``A z = b`` with A square, and inequalities. The unknowns z are d and, for each of these
planes, the sum C of the tangential forces of the contacts that stick on it. For an approximate
inverse R of A with ``|I - R A| <= beta < 1`` (largest row sum), A is regular, and its only solution
is within ``|R (b - A z')| / (1 - beta)`` of any approximate one z'. Both are bounded with the
rounding errors of their own computation, in any order of summation [Higham2002], [Rump2010]. A
condition that is negative everywhere so near proves that no equilibrium has these states. What the
bound does not decide is left to exact arithmetic.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.exact import RationalVector

from .cells import DETACHED, Codes, contact_codes
from .grasp import Grasp

Floats: TypeAlias = npt.NDArray[np.float64]
Integers: TypeAlias = npt.NDArray[np.int64]

#: The conditions that a choice of states may violate, by contact. The last two: the friction limit
#: of all contacts that stick on one tangential plane, less or plus their force along the tangent
#: of the first of them.
CONDITIONS = ("normal", "slip", "friction-", "friction+")
UNDECIDED = -1

_UNIT = 2.0**-53
#: Other numbers than 0 outside this range are left to exact arithmetic, so that nothing underflows.
_SMALL, _LARGE = 1e-30, 1e30
#: Above the rounding errors of a bound's own computation.
_MARGIN, _TINY = 1.01, 1e-200
_ROWS = 8192


class _OutOfRange(Exception):
    """A number that floating point should not see."""


@lru_cache(maxsize=8)
def screen_of(grasp: Grasp) -> Screen:
    """Return the screen of a grasp; kept for the next wrench."""
    return Screen(grasp)


class Screen:
    """The systems of all contact states of one grasp, ready for any wrench.

    Attributes:
        codes: see `cells.contact_codes`.
    """

    def __init__(self, grasp: Grasp) -> None:
        self.codes = contact_codes(grasp)
        self._batches: list[_Batch] = []
        try:
            contacts = _Contacts(grasp)
        except _OutOfRange:
            return
        for planes, rows, classes in _by_sticking_planes(contacts, self.codes):
            for start in range(0, len(rows), _ROWS):
                part = slice(start, start + _ROWS)
                batch = _Batch(contacts, self.codes[rows[part]], rows[part], classes[part], planes)
                self._batches.append(batch)

    def violations(self, wrench: RationalVector) -> Integers:
        """Return a violated condition for each choice of states, or `UNDECIDED`.

        The condition ``kind * contacts + contact`` is the one with that kind of `CONDITIONS`.
        """
        found = np.full(len(self.codes), UNDECIDED, dtype=np.int64)
        try:
            applied = _floats([wrench])[0]
        except _OutOfRange:
            return found
        for batch in self._batches:
            found[batch.rows] = batch.violations(applied)
        return found


def _floats(rows: Iterable[Sequence[Fraction]]) -> Floats:
    """Return the nearest floats."""
    try:
        numbers = np.array([[float(x) for x in row] for row in rows])
    except OverflowError:
        raise _OutOfRange from None
    size = np.abs(numbers)
    outside = (size > _LARGE) | (size < _SMALL)
    if np.any(outside) and any(
        x != 0
        for row, out in zip(rows, outside, strict=True)
        for x, o in zip(row, out, strict=True)
        if o
    ):
        raise _OutOfRange
    return numbers


class _Contacts:
    """The data of the contacts, rounded to the nearest floats (relative error `_UNIT` each)."""

    def __init__(self, grasp: Grasp) -> None:
        m = len(grasp)
        along = _floats([(*c.normal_wrench, *c.tangential_wrench) for c in grasp]).reshape(m, 6)
        numbers = _floats([(c.stiffness, c.preload, c.friction) for c in grasp]).reshape(m, 3)
        stiffness, self.preload, self.friction = numbers.T
        self.normal, self.tangent = along[:, :3], along[:, 3:]
        self.spring = stiffness[:, None] * self.normal
        planes = grasp.tangential_arrangement()
        self.class_of = np.array(planes.class_of, dtype=np.int64)
        self.orientation = np.array(planes.orientation, dtype=np.float64)
        first = [members[0] for members in planes.distinct]
        self.plane = self.tangent[first].reshape(-1, 3)

    @cached_property
    def stiffness_terms(self) -> tuple[Floats, Floats]:
        """``k N N'`` and ``k mu T N'`` of each contact, as rows of 9."""
        m = len(self.normal)
        pulled = self.friction[:, None] * self.tangent
        return tuple(  # type: ignore[return-value]
            (v[:, :, None] * self.spring[:, None, :]).reshape(m, 9) for v in (self.normal, pulled)
        )

    @cached_property
    def preload_terms(self) -> tuple[Floats, Floats]:
        """``q N`` and ``q mu T`` of each contact."""
        loaded = self.preload[:, None]
        return loaded * self.normal, loaded * self.friction[:, None] * self.tangent

    @property
    def relative_error(self) -> float:
        """Of a sum over the contacts of any of these terms, relative to the sum of their sizes."""
        return 2 * (2 * len(self.normal) + 16) * _UNIT


def _by_sticking_planes(
    contacts: _Contacts, codes: Codes
) -> Iterator[tuple[int, Integers, Integers]]:
    """Yield the choices with 0, 1 and 2 tangential planes on which contacts stick.

    Each with the number of planes, the rows of the choices, and the planes (choices, number).
    """
    present = np.zeros((len(codes), len(contacts.plane)), dtype=bool)
    for contact, plane in enumerate(contacts.class_of.tolist()):
        present[:, plane] |= codes[:, contact] == 0
    number = present.sum(axis=1)
    for planes in range(3):
        rows = np.flatnonzero(number == planes)
        if len(rows):
            yield planes, rows, np.nonzero(present[rows])[1].reshape(len(rows), planes)


@dataclass
class _Solutions:
    """Approximate solutions with a bound of their errors: motions, forces C, bound per row."""

    motion: Floats
    forces: Floats
    error: Floats


class _Batch:
    """Choices of states with equally many tangential planes on which contacts stick."""

    def __init__(
        self, contacts: _Contacts, codes: Codes, rows: Integers, classes: Integers, planes: int
    ) -> None:
        self.contacts, self.codes, self.rows, self.classes = contacts, codes, rows, classes
        self.size = 3 + planes
        self.attached = (codes != DETACHED).astype(np.float64)
        self.slip = np.where(codes == DETACHED, 0, codes).astype(np.float64)
        self._build()
        self._invert()

    def _build(self) -> None:
        count, data = len(self.codes), self.contacts
        towards, along = data.stiffness_terms
        self.matrix = np.zeros((count, self.size, self.size))
        self.matrix[:, :3, :3] = (self.attached @ towards - self.slip @ along).reshape(count, 3, 3)
        for j in range(self.size - 3):
            plane = data.plane[self.classes[:, j]]
            self.matrix[:, :3, 3 + j], self.matrix[:, 3 + j, :3] = -plane, plane
        self.matrix_error = np.zeros((self.size, self.size))
        total = np.abs(towards).sum(axis=0) + np.abs(along).sum(axis=0)
        self.matrix_error[:3, :3] = data.relative_error * total.reshape(3, 3)
        towards, along = data.preload_terms
        self.load = self.attached @ towards - self.slip @ along
        total = np.abs(towards).sum(axis=0) + np.abs(along).sum(axis=0)
        self.load_error = data.relative_error * total

    def _invert(self) -> None:
        """Compute R and beta; where A is singular in floating point, beta is above 1."""
        with np.errstate(all="ignore"):
            regular = np.abs(np.linalg.det(self.matrix)) > 0
            unit = np.eye(self.size)
            self.inverse = np.linalg.inv(np.where(regular[:, None, None], self.matrix, unit))
            size = np.abs(self.inverse)
            # Entries of A have a relative error of 2 units, the product one of size + 2.
            slack = self.matrix_error + (2 * self.size + 8) * _UNIT * np.abs(self.matrix)
            residual = np.abs(unit - self.inverse @ self.matrix) + size @ slack
            beta = _MARGIN * residual.sum(axis=2).max(axis=1) + 1e-12
        self.beta = np.where(regular & (beta < 0.5), beta, np.inf)

    def _solve(self, wrench: Floats) -> _Solutions:
        count = len(self.codes)
        given = np.zeros((count, self.size, 1))
        given[:, :3, 0] = self.load + wrench
        z = self.inverse @ given
        size = np.abs(z)
        bound = np.abs(given - self.matrix @ z) + self.matrix_error @ size
        bound += (2 * self.size + 10) * _UNIT * (np.abs(given) + np.abs(self.matrix) @ size)
        bound[:, :3, 0] += self.load_error + 4 * _UNIT * np.abs(wrench)
        spread = (np.abs(self.inverse) @ bound)[:, :, 0].max(axis=1)
        error = _MARGIN * spread / (1 - self.beta) + _TINY
        error = np.where(self.beta < 1, error, np.inf)
        return _Solutions(z[:, :3, 0], z[:, 3:, 0], error)

    def violations(self, wrench: Floats) -> Integers:
        """Return the condition that fails most surely in each choice, or `UNDECIDED`.

        Springs first, slip and friction only where they leave a choice open.
        """
        data, m = self.contacts, self.codes.shape[1]
        if m == 0:
            return np.full(len(self.codes), UNDECIDED)
        with np.errstate(all="ignore"):
            found = self._solve(wrench)
            reach = found.error + 12 * _UNIT * np.abs(found.motion).max(axis=1)
            normal = data.preload - found.motion @ data.spring.T
            doubt = _MARGIN * np.outer(reach, np.abs(data.spring).sum(axis=1))
            doubt += 12 * _MARGIN * _UNIT * data.preload
            table = np.where(self.attached > 0, normal, -normal) + doubt
            violated = _worst(table)
            open_rows = np.flatnonzero(violated == UNDECIDED)
            if len(open_rows):
                left = _Solutions(
                    found.motion[open_rows], found.forces[open_rows], found.error[open_rows]
                )
                moved = left.motion @ data.tangent.T
                unsure = _MARGIN * np.outer(reach[open_rows], np.abs(data.tangent).sum(axis=1))
                slip = self.slip[open_rows]
                highest = [np.where(slip != 0, moved * slip + unsure, np.inf)]
                if self.size > 3:
                    highest += self._friction(left, open_rows, normal[open_rows], doubt[open_rows])
                worst = _worst(np.concatenate(highest, axis=1))
                violated[open_rows] = np.where(worst == UNDECIDED, UNDECIDED, m + worst)
        return violated

    def _friction(
        self, found: _Solutions, chosen: Integers, normal: Floats, doubt: Floats
    ) -> list[Floats]:
        """Return upper bounds of the friction conditions, at the first sticking contacts."""
        data, codes, m = self.contacts, self.codes[chosen], self.codes.shape[1]
        lower, upper = np.full((2, len(codes), m), np.inf)
        rows = np.arange(len(codes))
        for j in range(self.size - 3):
            sticking = (codes == 0) & (data.class_of == self.classes[chosen, j][:, None])
            share = sticking * data.friction
            limit = (share * normal).sum(axis=1)
            unsure = (share * (doubt + 2 * (m + 4) * _UNIT * np.abs(normal))).sum(axis=1)
            first = sticking.argmax(axis=1)
            force = found.forces[:, j] * data.orientation[first]
            unsure = _MARGIN * (unsure + found.error + 4 * _UNIT * np.abs(force))
            lower[rows, first] = limit - force + unsure
            upper[rows, first] = limit + force + unsure
        return [lower, upper]


def _worst(bounds: Floats) -> Integers:
    """Return the column of the least upper bound in each row if it is negative."""
    worst = np.argmin(bounds, axis=1)
    fails = np.take_along_axis(bounds, worst[:, None], axis=1)[:, 0] < 0
    return np.where(fails, worst, UNDECIDED)
