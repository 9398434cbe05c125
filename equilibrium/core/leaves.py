"""Leaves of a tree in space: a dual ray in floats, made exact and tested.

The virtual motion and the multipliers are rounded to integers; a few multipliers, those with most
room, are then solved for, so that what depends on the motion cancels exactly.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from arrangement.numbers.exact import IntegerVector, RationalVector, dot, to_text
from arrangement.numbers.linear.rank import gauss_jordan
from equilibrium.core.contacts import FloatContacts, nearest

from .cones import Cones, Node, State
from .relaxation import Ray

#: Numbers are rounded to multiples of one over the first, multipliers below the second left out.
_ROUNDINGS = ((2**10, 1e-6), (2**20, 1e-6), (2**34, 1e-9), (2**48, 1e-12))
#: As many multipliers as a motion has numbers, those with most room, and this many more, mostly
#: do for what has to cancel.
_MORE_MULTIPLIERS = 3


class _WholeContact(NamedTuple):
    """A contact in integers: wrenches of the frame times `unit`.

    Attributes:
        columns: what alpha, h and the numbers of displacements add to what depends on the motion,
            times a number for all.
        preload: times a number for all.
    """

    frame: tuple[IntegerVector, ...]
    unit: int
    columns: tuple[IntegerVector, ...]
    preload: int
    friction: Fraction
    at: tuple[int, ...]
    short: tuple[IntegerVector, ...]


class _Numbers(NamedTuple):
    """The coprime integers of a leaf: alpha and h, and those of displacements."""

    motion: Sequence[int]
    given: dict[int, list[int]]
    pins: dict[int, list[int]]


class ExactLeaf(NamedTuple):
    """A leaf in its form of certificates, and its integers."""

    node: Any
    numbers: _Numbers


class Leaves:
    """The leaves of one question.

    Attributes:
        unit: of works.
        size: numbers of a frame: the normal, and the tangents.
        found: by states.
        ends: below the node of states, how many leaves of other loads refute this one, or do not.
    """

    def __init__(
        self,
        contacts: FloatContacts,
        wrench: RationalVector,
        cones: Cones,
        max_displacement: Fraction | None = None,
    ) -> None:
        self.contacts, self.cones = contacts, cones
        self.floats = np.array([nearest(x) for x in wrench])
        self.size = 1 + contacts.rows.tangents
        self.found: dict[Node, ExactLeaf] = {}
        self.ends: dict[Node, tuple[int, int]] = {}
        rows = contacts.rows
        bound = max_displacement or Fraction(0)
        given = [*wrench, bound, *(c.preload for c in rows)]
        unit = self.unit = math.lcm(*(x.denominator for x in given))
        self.load, self.bound = integers_over(wrench, unit), int(bound * unit)
        frames = [(c.normal_wrench, *c.tangential_wrenches) for c in rows]
        units = [math.lcm(*(x.denominator for row in frame for x in row)) for frame in frames]
        pairs = list(zip(rows, units, strict=True))
        self.motions = math.lcm(*(c.stiffness.denominator * unit for c, unit in pairs))
        self.each = []
        for (c, own), frame in zip(pairs, frames, strict=True):
            whole = tuple(integers_over(row, own) for row in frame)
            more = [self.motions // own] * (2 * self.size - 1)
            factors = int(-c.stiffness * (self.motions // own)), *more
            columns = [
                tuple(factor * x for x in row)
                for factor, row in zip(factors, (*whole, *whole), strict=True)
            ]
            preload = int(c.preload * unit)
            at = tuple(j for j in range(len(whole[0])) if any(row[j] for row in whole))
            short = tuple(tuple(row[j] for j in at) for row in whole)
            self.each.append(
                _WholeContact(whole, own, tuple(columns), preload, c.friction, at, short)
            )
        # Turns are multiples of one over the length: the unit of length makes no difference.
        arm = 2.0 ** round(math.log2(contacts.length))
        self._arms, self._unit = contacts.arms(arm), max(1.0, arm)
        self._steps = [int(x) for x in contacts.arms(max(1.0, 1 / arm), max(1.0, arm)).tolist()]
        self._sizes = contacts.arms(contacts.length)
        self._frames = np.concatenate([contacts.tangents, contacts.normal[:, None]], axis=1)

    def leaf(self, states: Node, ray: Ray) -> Any | None:
        """Return a leaf near a dual ray, or None where rounding finds none."""
        largest = float(np.abs(ray.virtual * self._arms).max())
        if not 0 < largest < math.inf or not np.isfinite(ray.multipliers).all():
            return None
        kept, size = None, self.size
        for fine, nothing in _ROUNDINGS:
            if kept is None or not np.array_equal(kept, ray.sizes > nothing):
                kept = ray.sizes > nothing
                order = np.argsort(-ray.room[kept], kind="stable")
                places = np.argwhere(kept)[order].tolist()
                listed = ray.multipliers[kept][order].tolist()
                columns = [self.each[i].columns[j] for i, j in places]
                pinned = self._pinned(states, ray, kept, nothing)
            unit = fine / largest * self._unit
            motion = _rounded(pinned, [x * unit for x in ray.virtual.tolist()], self._steps)
            values, scale = cancelled(columns, [round(x * unit) for x in listed], len(motion))
            given: dict[int, list[int]] = {}
            pins: dict[int, list[int]] = {}
            for (i, j), value in zip(places, values, strict=True):
                (given if j < size else pins).setdefault(i, [0] * size)[j % size] = value
            own, common = _common(motion)
            rows = [*given.values(), *pins.values()]
            shared = math.gcd(*(scale * x for x in own), *(common * x for x in chain(*rows)))
            for row in rows:
                row[:] = [common * x // shared for x in row]
            found = _Numbers([scale * x // shared for x in own], given, pins)
            if self._holds(states, found):
                self.found[states] = ExactLeaf(_node(found), found)
                return self.found[states].node
        return None

    def _pinned(
        self, states: Sequence[State], ray: Ray, kept: Any, nothing: float
    ) -> list[IntegerVector]:
        """Return the wrenches of contacts that the virtual motion leaves where they are.

        The conditions of such a contact have no room, as of one on an axis of a rotation.
        """
        limit = max(nothing, 1e-9) * float(np.abs(ray.virtual * self._sizes).max())
        moved = np.abs(self._frames @ ray.virtual)
        still = (moved.max(axis=1) <= limit) & ~kept[:, 0]
        return [
            row
            for i in np.flatnonzero(still).tolist()
            if states[i] != "detached"
            for row in self.each[i].frame
        ]

    def refutes(self, leaf: ExactLeaf) -> bool:
        """Return whether a leaf of another load on the grasp refutes this one, in its states."""
        return bool(self._work(leaf.numbers) > 0)

    def _work(self, leaf: _Numbers) -> Any:
        """Return the least work on the virtual motion of the load and all that contacts may do."""
        return dot(self.load, leaf.motion) + self.rest(leaf)

    def rest(self, leaf: _Numbers) -> Any:
        """Return the least work of all but the load."""
        work: Any = -self.bound * sum(abs(x) for row in leaf.pins.values() for x in row)
        return work + sum(row[0] * self.each[i].preload for i, row in leaf.given.items())

    def holds(self, states: Node, leaf: ExactLeaf) -> bool:
        """Return whether a leaf closes other states, too; it is theirs then."""
        held = self._holds(states, leaf.numbers)
        if held:
            self.found[states] = leaf
        return held

    def _holds(self, states: Sequence[State], leaf: _Numbers) -> bool:
        """Return whether a leaf whose linear terms cancel shows what it has to."""
        if self._work(leaf) <= 0:
            return False
        for i, (contact, state) in enumerate(zip(self.each, states, strict=True)):
            alpha, *h = leaf.given.get(i, [0] * self.size)
            if alpha < 0 and state in ("undecided", "detached"):
                return False
            ends = self.cones.ends(state)
            if any(dot(h, end) > 0 for end in ends) or (any(h) and not ends and state != "stick"):
                return False
            if state == "detached":
                continue
            moved = [leaf.motion[j] for j in contact.at]
            a, *b = (dot(row, moved) for row in contact.short)
            room = a - alpha * contact.unit
            if not self.cones.below(room, contact.friction, b, state):
                return False
        return True


def integers_over(row: Sequence[Fraction], unit: int) -> IntegerVector:
    """Return a row times a common denominator."""
    return tuple([x.numerator * (unit // x.denominator) for x in row])


def _common(row: Sequence[Fraction | int]) -> tuple[list[int], int]:
    """Return integers and their common denominator."""
    unit = math.lcm(*(x.denominator for x in row))
    return [x.numerator * (unit // x.denominator) for x in row], unit


def cancelled(columns: Sequence[IntegerVector], values: list[int], n: int) -> tuple[list[int], int]:
    """Return multiples of columns near given ones that add up to 0, and the scale of both.

    Those that come first are changed.
    """
    whole = list(zip(*columns, strict=True)) or [()] * n
    for count in (n, n + _MORE_MULTIPLIERS, len(columns)):
        rows = [(*row[:count], dot(row[count:], values[count:])) for row in whole]
        reduced, pivots, scale = gauss_jordan(rows)
        if len(rows[0]) - 1 in pivots:
            continue
        sign = 1 if scale > 0 else -1
        found = [abs(scale) * value for value in values]
        free = [k for k in range(len(rows[0]) - 1) if k not in pivots]
        for row, pivot in zip(reduced, pivots, strict=False):
            found[pivot] = -sign * (row[-1] + sum(row[k] * values[k] for k in free))
        return found, abs(scale)
    raise AssertionError("nothing is left over where all columns are in use")


def _rounded(
    rows: list[IntegerVector], motion: list[float], steps: list[int]
) -> Sequence[Fraction | int]:
    """Return a motion of multiples of steps near a given one, on which all rows are exactly 0."""
    found: list[Fraction | int] = [
        step * round(x / step) for x, step in zip(motion, steps, strict=True)
    ]
    if not rows:
        return found
    # Pivots go to the entries that come first: the largest stay as they are.
    order = sorted(range(len(motion)), key=lambda j: abs(motion[j]))
    reduced, pivots, scale = gauss_jordan([[row[j] for j in order] for row in rows])
    for row, pivot in zip(reduced, pivots, strict=False):
        others = sum(row[k] * found[order[k]] for k in range(len(motion)) if k not in pivots)
        found[order[pivot]] = Fraction(-others) / scale
    return found


def _node(leaf: _Numbers) -> Any:
    """Return the form of a leaf."""
    motion, given, pins = leaf
    moved = list(map(to_text, motion))
    if not (given or pins):
        return moved
    rows = {
        str(i): list(map(to_text, row if any(row[1:]) else row[:1])) for i, row in given.items()
    }
    found: dict[str, Any] = {"virtual_motion": moved, "multipliers": rows}
    if pins:
        found["displacements"] = {str(i): list(map(to_text, row)) for i, row in pins.items()}
    return found
