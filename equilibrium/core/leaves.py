"""Leaves of a tree in space: a dual ray in floats, made exact and tested.

The virtual motion and the multipliers are rounded to integers; a few multipliers, those with most
room, are then solved for, so that what depends on the motion cancels exactly. The conditions of a
contact are tested in floats with a bound on errors, exactly only where they are within it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from operator import mul
from typing import Any, NamedTuple

import numpy as np
from flint import fmpz_mat

from arrangement.numbers.exact import IntegerVector, RationalVector, dot, integers_over, over_unit
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.rank import gauss_jordan
from equilibrium.core.contacts import FloatContacts, nearest
from equilibrium.model.solution import Leaf

from .cones import Cones, Node, State
from .float_law import cone_edges, products
from .relaxation import Ray

#: Numbers are rounded to multiples of one over the first, multipliers below the second left out.
_ROUNDINGS = ((2**10, 1e-6), (2**20, 1e-6), (2**34, 1e-9), (2**48, 1e-12))
#: Relative error of sums in floats, with room.
SUM_ERROR = 1e-12
#: As many multipliers as a motion has numbers, those with most room, and this many more, mostly
#: do for what has to cancel.
_MORE_MULTIPLIERS = 3


class _WholeContact(NamedTuple):
    """A contact in integers: wrenches of the frame times `unit`.

    Attributes:
        columns: what alpha, h and the numbers of displacements add to what depends on the motion,
            each times a number of its own.
        factors: what makes these numbers one for all contacts.
        preload: times a number for all.
    """

    frame: tuple[IntegerVector, ...]
    unit: int
    columns: tuple[IntegerVector, ...]
    factors: tuple[int, ...]
    preload: int
    friction: Fraction
    at: tuple[int, ...]
    short: tuple[IntegerVector, ...]


class FloatLeaf(NamedTuple):
    """A leaf in floats, in the unit of its motion, whose largest number is about 1.

    Attributes:
        motion: (n,); work: of all but the load.
        room: (m,), the least works of normal forces of 1 less alpha; lifted: without friction.
        error: (m,), a bound on their errors.
        alpha: (m,); h, slip: (m, tangents), multipliers and b.
    """

    motion: Floats
    work: float
    room: Floats
    lifted: Floats
    error: Floats
    alpha: Floats
    h: Floats
    slip: Floats


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
        self.found: dict[Node, Leaf] = {}
        self.ends: dict[Node, tuple[int, int]] = {}
        rows = contacts.rows
        bound = max_displacement or Fraction(0)
        constants = [*wrench, bound, *(c.preload for c in rows)]
        unit = self.unit = math.lcm(*(x.denominator for x in constants))
        self.load, self.bound = integers_over(wrench, unit), int(bound * unit)
        frames = [(c.normal_wrench, *c.tangential_wrenches) for c in rows]
        units = [math.lcm(*(x.denominator for row in frame for x in row)) for frame in frames]
        pairs = list(zip(rows, units, strict=True))
        motions = math.lcm(*(c.stiffness.denominator * unit for c, unit in pairs))
        self.each = []
        for (c, own), frame in zip(pairs, frames, strict=True):
            whole = tuple(integers_over(row, own) for row in frame)
            spring = tuple(-c.stiffness.numerator * x for x in whole[0])
            more = [motions // own] * (2 * self.size - 1)
            factors = motions // (own * c.stiffness.denominator), *more
            preload = int(c.preload * unit)
            at = tuple(j for j in range(len(whole[0])) if any(row[j] for row in whole))
            short = tuple(tuple(row[j] for j in at) for row in whole)
            self.each.append(
                _WholeContact(
                    whole,
                    own,
                    (spring, *whole[1:], *whole),
                    factors,
                    preload,
                    c.friction,
                    at,
                    short,
                )
            )
        # Turns are multiples of one over the length: the unit of length makes no difference.
        arm = 2.0 ** round(math.log2(contacts.length))
        self._arms, self._unit = contacts.arms(arm), max(1.0, arm)
        self._steps = [int(x) for x in contacts.arms(max(1.0, 1 / arm), max(1.0, arm)).tolist()]
        self._sizes = contacts.arms(contacts.length)
        # No entry of a normal force's wrench is larger, with friction in any direction.
        _, self._reach = cone_edges(
            np.abs(contacts.normal), np.abs(contacts.tangents), contacts.friction
        )
        self._frictions = contacts.friction.tolist()
        # Bounds hold where nothing overflows or underflows on the way.
        self._error = SUM_ERROR if contacts.moderate else math.inf
        self._last: tuple[Leaf, FloatLeaf] | None = None

    def leaf(self, states: Node, ray: Ray) -> Leaf | None:
        """Return a leaf near a dual ray, or None where rounding finds none."""
        largest = float(np.abs(ray.virtual * self._arms).max())
        if not 0 < largest < math.inf or not np.isfinite(ray.multipliers).all():
            return None
        kept, size = None, self.size
        for fine, nothing in _ROUNDINGS:
            if kept is None or not np.array_equal(kept, ray.sizes > nothing):
                kept = ray.sizes > nothing
                flat = np.flatnonzero(kept)
                flat = flat[np.argsort(-ray.room.ravel()[flat], kind="stable")]
                listed = ray.multipliers.ravel()[flat].tolist()
                places = [divmod(k, 2 * size) for k in flat.tolist()]
                columns = [self.each[i].columns[j] for i, j in places]
                factors = [self.each[i].factors[j] for i, j in places]
                pinned = self._pinned(states, ray, kept, nothing)
            unit = fine / largest * self._unit
            rounded = _rounded(pinned, [x * unit for x in ray.virtual.tolist()], self._steps)
            motion, common = over_unit(rounded)
            scaled: list[Any] = [common * round(x * unit) for x in listed]
            weighed = [x * factor for x, factor in zip(scaled, factors, strict=True)]
            values, scale = cancelled(columns, weighed, len(motion))
            numbers = [
                Fraction(values[k], scale * factors[k]) if values[k] != scale * weighed[k] else x
                for k, x in enumerate(scaled)
            ]
            shared = math.gcd(*motion, *[x.numerator for x in numbers])
            if shared > 1:
                motion = [x // shared for x in motion]
                numbers = [Fraction(x) / shared for x in numbers]
            multipliers: dict[int, list[Any]] = {}
            pins: dict[int, list[Any]] = {}
            for (i, j), number in zip(places, numbers, strict=True):
                (multipliers if j < size else pins).setdefault(i, [0] * size)[j % size] = number
            leaf = Leaf(tuple(motion), multipliers, pins)
            if self.holds(states, leaf):
                return leaf
        return None

    def _pinned(
        self, states: Sequence[State], ray: Ray, kept: Any, nothing: float
    ) -> list[IntegerVector]:
        """Return the wrenches of contacts that the virtual motion leaves where they are.

        The conditions of such a contact have no room, as of one on an axis of a rotation.
        """
        if kept[:, 0].all():
            return []
        limit = max(nothing, 1e-9) * float(np.abs(ray.virtual * self._sizes).max())
        lifted, slip = products(self.contacts.normal, ray.virtual), self.contacts.slips(ray.virtual)
        still = (np.abs(lifted) <= limit) & (np.abs(slip) <= limit).all(axis=1) & ~kept[:, 0]
        return [
            row
            for i in np.flatnonzero(still).tolist()
            if states[i] != "detached"
            for row in self.each[i].frame
        ]

    def refutes(self, leaf: Leaf) -> bool:
        """Return whether a leaf of another load on the grasp refutes this one, in its states."""
        work = dot(self.load, leaf.motion)
        work -= self.bound * sum(abs(x) for row in leaf.displacements.values() for x in row)
        pushed = [(row[0], self.each[i].preload) for i, row in leaf.multipliers.items()]
        # In integers: fractions would take three times as long.
        unit = math.lcm(*[alpha.denominator for alpha, preload in pushed if preload])
        sizes = [
            alpha.numerator * (unit // alpha.denominator) * preload
            for alpha, preload in pushed
            if preload
        ]
        return bool(work * unit + sum(sizes) > 0)

    def holds(self, states: Node, leaf: Leaf) -> bool:
        """Return whether a leaf whose linear terms cancel closes states; it is theirs then."""
        held = self.refutes(leaf) and self._holds(states, leaf)
        if held:
            self.found[states] = leaf
        return held

    def _holds(self, states: Sequence[State], leaf: Leaf) -> bool:
        about, none, cones = self.in_floats(leaf), [0] * self.size, self.cones
        room, lifted, slip = about.room.tolist(), about.lifted.tolist(), about.slip.tolist()
        for i, (state, error) in enumerate(zip(states, about.error.tolist(), strict=True)):
            alpha, *h = leaf.multipliers.get(i, none)
            if alpha.numerator < 0 and state in ("undecided", "detached"):
                return False
            ends = cones.ends(state)
            if any(h) and state != "stick" and (not ends or any(dot(h, end) > 0 for end in ends)):
                return False
            if state == "detached":
                continue
            left = room[i]
            if ends:
                left = lifted[i] - self._frictions[i] * cones.largest(state, slip[i])
            # What is not finite is not sure.
            if left > error:
                continue
            if left < -error or not self._is_below(i, state, leaf):
                return False
        return True

    def _is_below(self, i: int, state: State, leaf: Leaf) -> bool:
        """Return, exactly, whether alpha is at most what a contact does on the virtual motion."""
        contact, alpha = self.each[i], Fraction(leaf.multipliers.get(i, (0,))[0])
        moved = [leaf.motion[j] * alpha.denominator for j in contact.at]
        a, *b = (dot(row, moved) for row in contact.short)
        room = a - alpha.numerator * contact.unit
        return self.cones.below(room, contact.friction, b, state)

    def in_floats(self, leaf: Leaf) -> FloatLeaf:
        """Return a leaf in floats."""
        if self._last is not None and self._last[0] is leaf:
            return self._last[1]
        unit = 1 << max(abs(x) for x in leaf.motion).bit_length()
        c, motion = self.contacts, np.array([x / unit for x in leaf.motion])
        rows = np.zeros((len(self.each), self.size))
        work = -ratio(self.bound, self.unit) * sum(
            abs(ratio(x, unit)) for row in leaf.displacements.values() for x in row
        )
        for i, row in leaf.multipliers.items():
            rows[i] = [ratio(x, unit) if x else 0.0 for x in row]
        alpha, slip = rows[:, 0], c.slips(motion)
        about = FloatLeaf(
            motion,
            work + float(alpha @ c.preload),
            c.least_works(motion, self.cones.support(slip)) - alpha,
            products(c.normal, motion) - alpha,
            self._error * (self._reach @ np.abs(motion) + np.abs(alpha)),
            alpha,
            rows[:, 1:],
            slip,
        )
        self._last = leaf, about
        return about


def ratio(x: Any, unit: int) -> float:
    """Return the float nearest to an exact number over another, cut off where it is too large."""
    try:
        return float(x.numerator / (x.denominator * unit))
    except OverflowError:
        return nearest(Fraction(x) / unit)


def cancelled(columns: Sequence[IntegerVector], values: list[int], n: int) -> tuple[list[int], int]:
    """Return multiples of columns near given ones that add up to 0, and the scale of both.

    Those that come first are changed.
    """
    whole = list(zip(*columns, strict=True)) or [()] * n
    for count in (n, n + _MORE_MULTIPLIERS, len(columns)):
        others = values[count:]
        rows = [[*row[:count], sum(map(mul, row[count:], others))] for row in whole]
        # The rows are integers, so none is scaled first, which would take most of the time.
        reduced, scale, rank = fmpz_mat(rows).rref()
        end, pivots = len(rows[0]) - 1, list[int]()
        for k in range(rank):
            first = pivots[-1] + 1 if pivots else 0
            while reduced[k, first] == 0:
                first += 1
            pivots.append(first)
        if end in pivots:
            continue
        size, sign = abs(int(scale)), 1 if scale > 0 else -1
        changed = [size * value for value in values]
        free = [j for j in range(end) if j not in pivots]
        for k, pivot in enumerate(pivots):
            moved = reduced[k, end]
            for j in free:
                moved += reduced[k, j] * values[j]
            changed[pivot] = -sign * int(moved)
        return changed, size
    raise AssertionError("nothing is left over where all columns are in use")


def _rounded(
    rows: list[IntegerVector], motion: list[float], steps: list[int]
) -> Sequence[Fraction | int]:
    """Return a motion of multiples of steps near a given one, on which all rows are exactly 0."""
    rounded: list[Fraction | int] = [
        step * round(x / step) for x, step in zip(motion, steps, strict=True)
    ]
    if not rows:
        return rounded
    # Pivots go to the entries that come first: the largest stay as they are.
    order = sorted(range(len(motion)), key=lambda j: abs(motion[j]))
    reduced, pivots, scale = gauss_jordan([[row[j] for j in order] for row in rows])
    for row, pivot in zip(reduced, pivots, strict=False):
        others = sum(row[k] * rounded[order[k]] for k in range(len(motion)) if k not in pivots)
        rounded[order[pivot]] = Fraction(-others) / scale
    return rounded
