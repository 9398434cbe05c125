"""Equilibria in space that have no rational numbers, proved by intervals with rational ends.

Where states are given, balance is n equations in n unknowns, six for a grasp: y, of the motion
``d = B y`` for a basis B of motions by which no sticking contact slips, and forces z of some
sticking contacts ("pillars"). With ``c_n = q - k N . d`` and friction

* ``-mu c_n s / |s|`` with s = T d where a contact slips,
* ``mu c_n r`` with a given r where it sticks, and z along a tangent if it is a pillar there,

let F be the sum of all wrenches, with the load and the constant pull of all adhesion. The test of
Krawczyk: if for a box X with centre m and any matrix Y ``K = m - Y F(m) + (I - Y F'(X)) (X - m)``
lies inside X, then F has exactly one zero in X. There all conditions of the law hold, if they hold
for all of X. Intervals have integer ends over 2^192 and are rounded outwards.

Motions that no attached contact feels (without friction it feels no slip), and on which the load
does no work (null-space motions, JSON "idle"), leave d open, and F misses them. Then F + sum v (v .
d - x) over null-space motions v with numbers x takes the place of F. Its zeros are zeros of F: its
products with null-space motions are those of the sum, so that is 0.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import chain
from typing import NamedTuple

from arrangement.numbers.exact import RationalVector, dot
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Enclosure

from .law import LawRow, applied, law_rows

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
        if not (a or b) or not (c or d):
            return Interval(0, 0)
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
    scaled, unit = x.numerator << _BITS, x.denominator
    return Interval(scaled // unit, -(-scaled // unit))


def total(parts: Iterable[Interval]) -> Interval:
    """Return the sum of intervals."""
    low, high = 0, 0
    for part in parts:
        low, high = low + part.low, high + part.high
    return Interval(low, high)


def product(row: Iterable[Interval], column: Iterable[Interval]) -> Interval:
    """Return the scalar product of intervals."""
    return total(x.times(y) for x, y in zip(row, column, strict=True))


def enclosure_problem(
    grasp: Grasp,
    wrench: RationalVector,
    enclosure: Enclosure,
    max_displacement: Fraction | None = None,
) -> str:
    """Return why an enclosure shows no equilibrium that counts, or nothing."""
    felt_contacts = felt_by(grasp, enclosure.basis)
    wrench = applied((felt.contact for felt in felt_contacts), wrench)
    for i, (felt, friction) in enumerate(zip(felt_contacts, enclosure.friction, strict=True)):
        _, *tangents = felt.contact.wrenches
        if friction and any(dot(t, motion) for motion in enclosure.basis for t in tangents):
            return f"contact {i + 1} sticks, and a motion of the basis moves it"
        if friction and dot(friction, friction) > 1:
            return f"contact {i + 1} sticks, and has a friction above its limit"
    for i, _ in enclosure.pillars:
        if not enclosure.friction[i]:
            return f"contact {i + 1} is a pillar and does not stick"
    pairs = zip(felt_contacts, enclosure.friction, strict=True)
    works = [wrench, *chain(*(felt.noticed for felt, friction in pairs if friction is not None))]
    if any(dot(row, motion) for *motion, _ in enclosure.idle for row in works):
        return "a null-space motion moves an attached contact, or the load does work on it"
    if any(r <= 0 for r in enclosure.radius):
        return "a radius of the enclosure is not above 0"
    box = [
        Interval(interval(m - r).low, interval(m + r).high)
        for m, r in zip(enclosure.centre, enclosure.radius, strict=True)
    ]
    centre = [interval(m) for m in enclosure.centre]
    try:
        value, _ = _balance(felt_contacts, wrench, enclosure, centre, max_displacement, 0)
        _, derivative = _balance(felt_contacts, wrench, enclosure, box, max_displacement, len(box))
    except BrokenLaw as broken:
        return str(broken)
    inverse = [[interval(x) for x in row] for row in enclosure.inverse]
    away = [x.plus(m.negative()) for x, m in zip(box, centre, strict=True)]
    for j, row in enumerate(inverse):
        rest = [
            interval(int(j == k)).plus(product(row, column).negative())
            for k, column in enumerate(zip(*derivative, strict=True))
        ]
        step = product(row, value).negative()
        image = total((centre[j], step, product(rest, away)))
        if not box[j].low < image.low <= image.high < box[j].high:
            return f"the enclosure is not mapped into itself in coordinate {j + 1}"
    return ""


class Felt(NamedTuple):
    """A contact, and how far each unknown moves it along the wrenches of unit forces."""

    contact: LawRow
    slopes: list[list[Interval]]

    @property
    def noticed(self) -> tuple[RationalVector, ...]:
        """The wrenches along which a motion matters: without friction the first alone."""
        wrenches = self.contact.wrenches
        return wrenches if self.contact.friction else wrenches[:1]


def felt_by(grasp: Grasp, basis: Sequence[RationalVector]) -> list[Felt]:
    """Return what each contact feels of a basis of motions."""
    return [Felt(row, [_slopes(x, basis) for x in row.wrenches]) for row in law_rows(grasp)]


class BrokenLaw(Exception):
    """A condition of the law that does not hold all over a box."""


class Linear(NamedTuple):
    """A number that depends on the unknowns: an interval of its values, and of its derivatives."""

    value: Interval
    slopes: list[Interval]

    def times(self, other: Linear) -> Linear:
        """Return the product."""
        slopes = [
            self.value.times(y).plus(other.value.times(x))
            for x, y in zip(self.slopes, other.slopes, strict=True)
        ]
        return Linear(self.value.times(other.value), slopes)

    def by(self, factor: Fraction | int) -> Linear:
        """Return a multiple."""
        scale = interval(factor)
        return Linear(self.value.times(scale), [x.times(scale) for x in self.slopes])

    def plus(self, other: Linear) -> Linear:
        """Return the sum."""
        slopes = [x.plus(y) for x, y in zip(self.slopes, other.slopes, strict=True)]
        return Linear(self.value.plus(other.value), slopes)


def _balance(
    contacts: Sequence[Felt],
    wrench: RationalVector,
    enclosure: Enclosure,
    box: Sequence[Interval],
    max_displacement: Fraction | None,
    unknowns: int,
) -> tuple[list[Interval], list[list[Interval]]]:
    """Return the sum of all wrenches over a box, and its derivative, (n, unknowns).

    Args:
        unknowns: by which derivatives are taken: all, or 0.

    Raises:
        BrokenLaw: a condition does not hold all over the box.
    """
    zeros = [Interval(0, 0)] * unknowns
    sums = [Linear(interval(w), zeros) for w in wrench]
    for i, ((contact, slopes), friction) in enumerate(
        zip(contacts, enclosure.friction, strict=True)
    ):
        moved = [Linear(product(row, box), row[:unknowns]) for row in slopes]
        if max_displacement is not None:
            most = interval(max_displacement).low
            if any(not -most <= x.value.low <= x.value.high <= most for x in moved):
                raise BrokenLaw(f"contact {i + 1}: its point may move by more than counts")
        normal = moved[0].by(-contact.stiffness)
        normal = normal.plus(Linear(interval(contact.preload), zeros))
        if friction is None:
            if normal.value.high > 0:
                raise BrokenLaw(f"contact {i + 1} is not detached all over the enclosure")
            continue
        if normal.value.low < 0:
            raise BrokenLaw(f"contact {i + 1} is not attached all over the enclosure")
        limit = normal.by(contact.friction)
        if not contact.friction:
            forces = [limit, limit]
        elif friction:
            forces = _sticking(i, limit, friction, enclosure, box)
        else:
            forces = [limit.times(x).by(-1) for x in unit_slip(i, moved[1:])]
        for force, row in zip((normal, *forces), contact.wrenches, strict=True):
            sums = [
                entry.plus(force.by(x)) if x else entry for entry, x in zip(sums, row, strict=True)
            ]
    for *motion, x in enclosure.idle:
        slopes_of = _slopes(tuple(motion), enclosure.basis)
        turned = Linear(product(slopes_of, box), slopes_of[:unknowns])
        turned = turned.plus(Linear(interval(-x), zeros))
        sums = [entry.plus(turned.by(x)) for entry, x in zip(sums, motion, strict=True)]
    return [entry.value for entry in sums], [entry.slopes for entry in sums]


def _slopes(row: RationalVector, basis: Sequence[RationalVector]) -> list[Interval]:
    """Return how far a contact moves along a unit wrench, with each of the n unknowns."""
    slopes = [interval(dot(row, motion)) for motion in basis]
    return slopes + [Interval(0, 0)] * (len(row) - len(slopes))


def _sticking(
    i: int, limit: Linear, share: RationalVector, enclosure: Enclosure, box: Sequence[Interval]
) -> list[Linear]:
    """Return the friction forces of a contact that sticks."""
    forces = [limit.by(x) for x in share]
    carried = [
        (k, j)
        for k, (pillar, j) in enumerate(enclosure.pillars, len(enclosure.basis))
        if pillar == i
    ]
    for k, j in carried:
        slopes = [interval(int(k == other)) for other in range(len(limit.slopes))]
        forces[j] = forces[j].plus(Linear(box[k], slopes))
    squares = total(force.value.square() for force in forces)
    if carried and squares.high > limit.value.square().low:
        raise BrokenLaw(f"contact {i + 1} has a friction above its limit")
    return forces


def unit_slip(i: int, slip: Sequence[Linear]) -> list[Linear]:
    """Return ``s / |s|``, whose derivative is that of s without its part along s, over |s|."""
    square = total(s.value.square() for s in slip)
    if square.low <= 0:
        raise BrokenLaw(f"contact {i + 1} does not slip all over the enclosure")
    root = square.inverse_root()
    units = [s.value.times(root) for s in slip]
    along = [product(units, column) for column in zip(*(s.slopes for s in slip), strict=True)]
    direction = []
    for u, s in zip(units, slip, strict=True):
        across = zip(s.slopes, along, strict=True)
        direction.append(Linear(u, [x.plus(u.times(y).negative()).times(root) for x, y in across]))
    return direction
