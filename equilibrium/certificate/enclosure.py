"""Equilibria in space that have no rational numbers, proved by intervals with rational ends.

Where states are given, balance is six equations in six unknowns: y, of the motion ``d = B y`` for a
basis B of motions by which no sticking contact slips, and forces z of some sticking contacts
("pillars"). With ``c_n = q - k N . d`` and friction

* ``-mu c_n s / |s|`` with s = T d where a contact slips,
* ``mu c_n r`` with a given r where it sticks, and z along a tangent if it is a pillar there,

let F be the sum of all wrenches. The test of Krawczyk: if for a box X with centre m and any matrix
Y ``K = m - Y F(m) + (I - Y F'(X)) (X - m)`` lies inside X, then F has exactly one zero in X. There
all conditions of the law hold, if they hold for all of X. Intervals have integer ends over 2^192
and are rounded outwards.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from arrangement.exact import RationalVector, dot
from equilibrium.model.grasp import Grasp

from .reading import Enclosure
from .space import frame

_BITS = 192
_ONE = 1 << _BITS


class Interval(NamedTuple):
    """All numbers from `low` to `high`, both over 2^192."""

    low: int
    high: int

    def plus(self, other: Interval) -> Interval:
        """Return an interval of all sums."""
        return Interval(self.low + other.low, self.high + other.high)

    def times(self, other: Interval) -> Interval:
        """Return an interval of all products."""
        a, b = self
        c, d = other
        products = (a * c, a * d, b * c, b * d)
        return Interval(min(products) >> _BITS, -(-max(products) >> _BITS))

    def square(self) -> Interval:
        """Return an interval of all squares."""
        low, high = sorted(map(abs, self))
        return Interval(
            0 if self.low < 0 < self.high else low * low >> _BITS, -(-high * high >> _BITS)
        )

    def negative(self) -> Interval:
        """Return all negatives."""
        return Interval(-self.high, -self.low)

    def inverse_root(self) -> Interval:
        """Return an interval of ``1 / sqrt(x)``; all x must be above 0."""
        low, high = (x << _BITS for x in self)
        return Interval(_ONE * _ONE // (math.isqrt(high) + 1), _ONE * _ONE // math.isqrt(low) + 1)


def interval(x: Fraction | int) -> Interval:
    """Return a number as an interval."""
    scaled = Fraction(x) * _ONE
    return Interval(math.floor(scaled), math.ceil(scaled))


def total(parts: Iterable[Interval]) -> Interval:
    """Return the sum of intervals."""
    low, high = 0, 0
    for part in parts:
        low, high = low + part.low, high + part.high
    return Interval(low, high)


def product(row: Iterable[Interval], column: Iterable[Interval]) -> Interval:
    """Return the scalar product of intervals."""
    return total(x.times(y) for x, y in zip(row, column, strict=True))


def enclosure_problem(grasp: Grasp, wrench: RationalVector, given: Enclosure) -> str:
    """Return why an enclosure shows no equilibrium, or nothing."""
    for i, (contact, friction) in enumerate(zip(grasp, given.friction, strict=True)):
        _, *tangents = frame(contact)
        if friction and any(dot(t, motion) for motion in given.basis for t in tangents):
            return f"contact {i + 1} sticks, and a motion of the basis moves it"
        if friction and dot(friction, friction) > 1:
            return f"contact {i + 1} sticks, and has a friction above its limit"
    for i, _ in given.pillars:
        if not given.friction[i]:
            return f"contact {i + 1} is a pillar and does not stick"
    if any(r <= 0 for r in given.radius):
        return "a radius of the enclosure is not above 0"
    box = [
        Interval(interval(m - r).low, interval(m + r).high)
        for m, r in zip(given.centre, given.radius, strict=True)
    ]
    try:
        value, _ = _balance(grasp, wrench, given, [interval(m) for m in given.centre])
        _, derivative = _balance(grasp, wrench, given, box)
    except _BrokenLaw as broken:
        return str(broken)
    inverse = [[interval(x) for x in row] for row in given.inverse]
    away = [x.plus(interval(m).negative()) for x, m in zip(box, given.centre, strict=True)]
    for j, row in enumerate(inverse):
        rest = [
            interval(int(j == k)).plus(product(row, column).negative())
            for k, column in enumerate(zip(*derivative, strict=True))
        ]
        step = product(row, value).negative()
        found = total((interval(given.centre[j]), step, product(rest, away)))
        if not box[j].low < found.low <= found.high < box[j].high:
            return f"the enclosure is not mapped into itself in coordinate {j + 1}"
    return ""


class _BrokenLaw(Exception):
    """A condition of the law that does not hold all over a box."""


def _balance(
    grasp: Grasp, wrench: RationalVector, given: Enclosure, box: Sequence[Interval]
) -> tuple[list[Interval], list[list[Interval]]]:
    """Return the sum of all wrenches over a box, and its derivative, (6, 6)."""
    size = len(given.basis)
    value = [interval(w) for w in wrench]
    derivative = [[Interval(0, 0)] * 6 for _ in range(6)]
    basis = [[interval(x) for x in motion] for motion in given.basis]

    def add(row: RationalVector, force: Interval, slopes: Sequence[Interval]) -> None:
        for j, x in enumerate(row):
            if x:
                along = interval(x)
                value[j] = value[j].plus(along.times(force))
                for k, slope in enumerate(slopes):
                    derivative[j][k] = derivative[j][k].plus(along.times(slope))

    for i, (contact, friction) in enumerate(zip(grasp, given.friction, strict=True)):
        normal, *tangents = frame(contact)
        moved = [
            [product(map(interval, row), motion) for motion in basis] for row in (normal, *tangents)
        ]
        by, *shifts = moved
        stiffness, limit = interval(-contact.stiffness), interval(contact.friction)
        slopes = [*(stiffness.times(x) for x in by), *[Interval(0, 0)] * (6 - size)]
        spring = interval(contact.preload).plus(product(slopes, box))
        if friction is None:
            if spring.high > 0:
                raise _BrokenLaw(f"contact {i + 1} is not detached all over the enclosure")
            continue
        if spring.low < 0:
            raise _BrokenLaw(f"contact {i + 1} is not attached all over the enclosure")
        add(normal, spring, slopes)
        rub, rubs = limit.times(spring), [limit.times(x) for x in slopes]
        if friction:
            forces = [
                (rub.times(interval(r)), [x.times(interval(r)) for x in rubs]) for r in friction
            ]
            for k, (pillar, tangent) in enumerate(given.pillars, size):
                if pillar == i:
                    force, changes = forces[tangent]
                    changes[k] = changes[k].plus(interval(1))
                    forces[tangent] = force.plus(box[k]), changes
            pillared = any(pillar == i for pillar, _ in given.pillars)
            if pillared and total(force.square() for force, _ in forces).high > rub.square().low:
                raise _BrokenLaw(f"contact {i + 1} has a friction above its limit")
        else:
            zeros = [Interval(0, 0)] * (6 - size)
            changes = [[*row, *zeros] for row in shifts]
            slip = [product(row, box) for row in changes]
            square = total(s.square() for s in slip)
            if square.low <= 0:
                raise _BrokenLaw(f"contact {i + 1} does not slip all over the enclosure")
            root = square.inverse_root()
            unit = [s.times(root) for s in slip]
            # The derivative of s / |s| is that of s without its part along s, over |s|.
            along = [product(unit, column) for column in zip(*changes, strict=True)]
            forces = []
            for u, row in zip(unit, changes, strict=True):
                turns = [
                    x.plus(u.times(y).negative()).times(root)
                    for x, y in zip(row, along, strict=True)
                ]
                slope = [
                    x.times(u).plus(rub.times(t)).negative()
                    for x, t in zip(rubs, turns, strict=True)
                ]
                forces.append((rub.times(u).negative(), slope))
        for tangent, (force, slope) in zip(tangents, forces, strict=True):
            add(tangent, force, slope)
    return value, derivative
