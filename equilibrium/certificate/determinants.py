"""Violated conditions checked by the signs of two determinants, many at once.

Let the equalities of a choice of states be ``A z + b = 0`` with A square, and one of its conditions
``a . z + c >= 0``. If ``det A`` is not zero there is one solution z, and the bordered determinant
of ``[[A, b], [a, c]]`` is ``det A (a . z + c)``. So opposite signs of the two prove that no
equilibrium has these states. The unknowns are d and, for each tangential plane on which contacts
stick, the sum of their tangential forces.

The signs are found in floating point where a bound of its error allows. Every entry is a sum over
contacts. Its error is at most a multiple of the sum S of the sizes of its terms; and that of a
determinant at most a multiple of the same polynomial with S and plus signs throughout
[Higham2002]. The rest is left to exact arithmetic. This is the checker's own way; the solver has
another.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.exact import RationalVector
from equilibrium.model.grasp import Contact, Grasp

from .coverage import DETACHED, Rows

Floats: TypeAlias = npt.NDArray[np.float64]
Integers: TypeAlias = npt.NDArray[np.int64]
Booleans: TypeAlias = npt.NDArray[np.bool_]

#: The kinds of conditions that a proof may name, with the number of a contact.
KINDS = ("normal", "slip", "friction-", "friction+")

_UNIT = 2.0**-53
_SMALL, _LARGE = 1e-30, 1e30
_CHUNK = 8192


def proven_violations(
    grasp: Grasp, wrench: RationalVector, states: Rows, kinds: Integers, contacts: Integers
) -> Booleans:
    """Return for which choices of states the named condition is proven to be violated.

    Args:
        states: rows of contact states (see `coverage.Rows`).
        kinds, contacts: for each row the number of a kind of `KINDS`, and of a contact. The kind
            has to fit the state of that contact.

    False means that floating point proves nothing, not that the claim is wrong.
    """
    proven = np.zeros(len(states), dtype=bool)
    table = _Table.of(grasp, wrench)
    if table is None:
        return proven
    planes = np.array(grasp.tangential_arrangement().class_of, dtype=np.int64)
    sticking = np.zeros((len(states), planes.max(initial=-1) + 1), dtype=bool)
    for contact, plane in enumerate(planes.tolist()):
        sticking[:, plane] |= states[:, contact] == 0
    number = sticking.sum(axis=1)
    for size in range(3):
        rows = np.flatnonzero(number == size)
        for start in range(0, len(rows), _CHUNK):
            part = rows[start : start + _CHUNK]
            groups = np.nonzero(sticking[part])[1].reshape(len(part), size)
            entries = table.bordered(states[part], planes, groups, kinds[part], contacts[part])
            proven[part] = _opposite(*entries, table.relative_error)
    return proven


class _Table:
    """The contacts and the wrench as floats, each within a relative error of one unit."""

    def __init__(self, numbers: Floats, grasp: Grasp) -> None:
        m = len(grasp)
        self.wrench = numbers[:3]
        data = numbers[3:].reshape(m, 9)
        self.normal, self.tangent = data[:, :3], data[:, 3:6]
        stiffness, preload, self.friction = data[:, 6], data[:, 7], data[:, 8]
        # The normal force of a touching contact is spring . (d, 1).
        self.spring = np.concatenate([-stiffness[:, None] * self.normal, preload[:, None]], axis=1)
        self.relative_error = (2 * m + 40) * _UNIT
        self.turned = np.array(grasp.tangential_arrangement().orientation, dtype=np.float64)

    @classmethod
    def of(cls, grasp: Grasp, wrench: RationalVector) -> _Table | None:
        """Return the table, or None when a number is too large or too small."""
        listed = [*wrench]
        for contact in grasp:
            listed += [*_arms(contact), contact.stiffness, contact.preload, contact.friction]
        try:
            numbers = np.array([float(x) for x in listed])
        except OverflowError:
            return None
        extreme = (np.abs(numbers) > _LARGE) | (np.abs(numbers) < _SMALL)
        if any(x for x, out in zip(listed, extreme.tolist(), strict=True) if out):
            return None
        return cls(numbers, grasp)

    def bordered(
        self, states: Rows, planes: Integers, groups: Integers, kinds: Integers, contacts: Integers
    ) -> tuple[Floats, Floats]:
        """Return the bordered matrices (rows, n + 1, n + 1), and the sizes S of their entries."""
        count, m = states.shape
        groups_size = groups.shape[1]
        n = 3 + groups_size
        signed, sized = np.zeros((2, count, n + 1, n + 1))
        touching = (states != DETACHED).astype(float)
        slip = np.where(states == DETACHED, 0, states).astype(float)
        friction = self.friction[:, None] * self.tangent
        for matrix, towards, across, spring, sign in (
            (signed, self.normal, friction, self.spring, -slip),
            (sized, np.abs(self.normal), np.abs(friction), np.abs(self.spring), np.abs(slip)),
        ):
            straight = (towards[:, :, None] * spring[:, None, :]).reshape(m, 12)
            pulled = (across[:, :, None] * spring[:, None, :]).reshape(m, 12)
            total = (touching @ straight + sign @ pulled).reshape(count, 3, 4)
            matrix[:, :3, :3], matrix[:, :3, n] = total[:, :, :3], total[:, :, 3]
        signed[:, :3, n] += self.wrench
        sized[:, :3, n] += np.abs(self.wrench)
        first = np.zeros(planes.max(initial=0) + 1, dtype=np.int64)
        first[planes[::-1]] = np.arange(m)[::-1]
        for j in range(groups_size):
            tangent = self.tangent[first[groups[:, j]]]
            signed[:, :3, 3 + j] = signed[:, 3 + j, :3] = tangent
            sized[:, :3, 3 + j] = sized[:, 3 + j, :3] = np.abs(tangent)
        self._last_row(signed, sized, states, planes, groups, kinds, contacts)
        return signed, sized

    def _last_row(
        self,
        signed: Floats,
        sized: Floats,
        states: Rows,
        planes: Integers,
        groups: Integers,
        kinds: Integers,
        contacts: Integers,
    ) -> None:
        """Fill in the row of the named condition."""
        columns = [0, 1, 2, signed.shape[1] - 1]
        for kind in np.unique(kinds).tolist():
            rows = np.flatnonzero(kinds == kind)
            at, code = contacts[rows], states[rows, contacts[rows]][:, None]
            if kind == 0:
                signed[rows[:, None], -1, columns] = self.spring[at] * np.where(code == 2, -1, 1)
                sized[rows[:, None], -1, columns] = np.abs(self.spring[at])
            elif kind == 1:
                signed[rows, -1, :3] = self.tangent[at] * code
                sized[rows, -1, :3] = np.abs(self.tangent[at])
            else:
                share = (states[rows] == 0) & (planes == planes[at][:, None])
                limit = self.friction[:, None] * self.spring
                signed[rows[:, None], -1, columns] = share @ limit
                sized[rows[:, None], -1, columns] = share @ np.abs(limit)
                side = self.turned[at] * (-1 if kind == 2 else 1)
                place = 3 + np.argmax(groups[rows] == planes[at][:, None], axis=1)
                signed[rows, -1, place], sized[rows, -1, place] = side, 1.0


def _arms(contact: Contact) -> tuple[Fraction, ...]:
    """Return the wrenches of a unit normal and a unit tangential force."""
    (px, py), (nx, ny) = contact.point, contact.normal
    return (nx, ny, px * ny - py * nx, -ny, nx, px * nx + py * ny)


def _opposite(signed: Floats, sized: Floats, relative_error: float) -> Booleans:
    """Return where the determinants of A and of the whole surely have opposite signs."""
    n = signed.shape[1] - 1
    inner, whole = _expanded(signed, -1)
    inner_size, whole_size = _expanded(sized, 1)
    # Each product has at most n + 1 entries, each rounding once more in product and sum.
    slack = 2 * (n + 1) * (relative_error + 8 * _UNIT)
    proven: Booleans = (
        (np.abs(inner) > slack * inner_size)
        & (np.abs(whole) > slack * whole_size)
        & ((inner > 0) != (whole > 0))
    )
    return proven


def _expanded(matrix: Floats, alternate: int) -> tuple[Floats, Floats]:
    """Return the determinants of the leading block and of the whole, by rows.

    With ``alternate = 1`` all products are added: the permanents.
    """
    size = matrix.shape[1]
    minors: dict[tuple[int, ...], Floats] = {(): np.ones(len(matrix))}
    for row in range(size):
        minors = {
            columns: _sum_over(minors, matrix[:, row], columns, alternate)
            for columns in combinations(range(size), row + 1)
        }
        if row == size - 2:
            leading = minors[tuple(range(size - 1))]
    return leading, minors[tuple(range(size))]


def _sum_over(
    minors: dict[tuple[int, ...], Floats], row: Floats, columns: Sequence[int], alternate: int
) -> Floats:
    """Expand a minor along its last row."""
    last = len(columns) - 1
    total = np.zeros(len(row))
    for place, column in enumerate(columns):
        rest = minors[(*columns[:place], *columns[place + 1 :])]
        total += alternate ** (last - place) * row[:, column] * rest
    return total
