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
from typing import NamedTuple, TypeAlias

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
    works = [applied((felt.contact for felt in felt_contacts), wrench)]
    for i, ((contact, _), share) in enumerate(
        zip(felt_contacts, enclosure.friction, strict=True), 1
    ):
        _, *tangents = contact.wrenches
        if share and any(dot(t, motion) for motion in enclosure.basis for t in tangents):
            return f"contact {i} sticks, and a motion of the basis moves it"
        if share and dot(share, share) > 1:
            return f"contact {i} sticks, and has a friction above its limit"
        if share is not None:
            # Without friction a motion along the tangents does not matter.
            works += contact.wrenches if contact.friction else contact.wrenches[:1]
    for i, _ in enclosure.pillars:
        if not enclosure.friction[i]:
            return f"contact {i + 1} is a pillar and does not stick"
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
        value, *_ = _balance(felt_contacts, works[0], enclosure, centre, max_displacement, 0)
        _, *derivatives = _balance(
            felt_contacts, works[0], enclosure, box, max_displacement, len(box)
        )
    except BrokenLaw as broken:
        return str(broken)
    away = [x.plus(m.negative()) for x, m in zip(box, centre, strict=True)]
    for j, row in enumerate(enclosure.inverse):
        inverse = list(map(interval, row))
        rest = [
            interval(int(j == k)).plus(product(inverse, column).negative())
            for k, column in enumerate(derivatives)
        ]
        step = product(inverse, value).negative()
        image = total((centre[j], step, product(rest, away)))
        if not box[j].low < image.low <= image.high < box[j].high:
            return f"the enclosure is not mapped into itself in coordinate {j + 1}"
    return ""


class Felt(NamedTuple):
    """A contact, and how far each unknown moves it along the wrenches of unit forces."""

    contact: LawRow
    slopes: list[list[Interval]]


def felt_by(grasp: Grasp, basis: Sequence[RationalVector]) -> list[Felt]:
    """Return what each contact feels of a basis of motions."""
    return [Felt(row, [_slopes(x, basis) for x in row.wrenches]) for row in law_rows(grasp)]


class BrokenLaw(Exception):
    """A condition of the law that does not hold all over a box."""


#: A number that depends on the unknowns: an interval of its values, then of its derivatives.
Row: TypeAlias = Sequence[Interval]


def _times(row: Row, factor: Fraction | int) -> list[Interval]:
    scale = interval(factor)
    return [x.times(scale) for x in row]


def _balance(
    contacts: Sequence[Felt],
    wrench: RationalVector,
    enclosure: Enclosure,
    box: Sequence[Interval],
    max_displacement: Fraction | None,
    unknowns: int,
) -> list[list[Interval]]:
    """Return the sum of all wrenches over a box, then its derivatives by the unknowns.

    Args:
        unknowns: by which derivatives are taken: all, or 0.

    Raises:
        BrokenLaw: a condition does not hold all over the box.
    """

    def linear(slopes: Row, constant: Fraction) -> Row:
        return [product(slopes, box).plus(interval(constant)), *slopes[:unknowns]]

    # Rows of forces, and a wrench of each: the load is a constant force of 1.
    forces: list[Row] = [[interval(1), *[Interval(0, 0)] * unknowns]]
    wrenches: list[Sequence[Fraction]] = [wrench]
    for i, ((contact, slopes), share) in enumerate(zip(contacts, enclosure.friction, strict=True)):
        moved = [linear(row, Fraction(0)) for row in slopes]
        if max_displacement is not None:
            most = interval(max_displacement).low
            if any(not -most <= x.low <= x.high <= most for x, *_ in moved):
                raise BrokenLaw(f"contact {i + 1}: its point may move by more than counts")
        normal = _times(moved[0], -contact.stiffness)
        normal[0] = normal[0].plus(interval(contact.preload))
        if share is None:
            if normal[0].high > 0:
                raise BrokenLaw(f"contact {i + 1} is not detached all over the enclosure")
            continue
        if normal[0].low < 0:
            raise BrokenLaw(f"contact {i + 1} is not attached all over the enclosure")
        rubs: list[Row] = []
        if contact.friction and share:
            rubs = _sticking(i, _times(normal, contact.friction), share, enclosure, box)
        elif contact.friction:
            (limit, *limits), units = _times(normal, -contact.friction), unit_slip(i, moved[1:])
            for u, *row in units:
                pairs = zip(limits, row, strict=True)
                rubs.append([limit.times(u), *(limit.times(y).plus(u.times(x)) for x, y in pairs)])
        forces += normal, *rubs
        wrenches += contact.wrenches[: 1 + len(rubs)]
    for *motion, x in enclosure.idle:
        forces.append(linear(_slopes(motion, enclosure.basis), -x))
        wrenches.append(motion)
    matrix = [list(map(interval, entries)) for entries in zip(*wrenches, strict=True)]
    return [[product(row, column) for row in matrix] for column in zip(*forces, strict=True)]


def _slopes(row: Sequence[Fraction], basis: Sequence[RationalVector]) -> list[Interval]:
    """Return how far a contact moves along a unit wrench, with each of the n unknowns."""
    slopes = [interval(dot(row, motion)) for motion in basis]
    return slopes + [Interval(0, 0)] * (len(row) - len(slopes))


def _sticking(
    i: int, limit: Row, share: RationalVector, enclosure: Enclosure, box: Sequence[Interval]
) -> list[Row]:
    """Return the friction forces of a contact that sticks."""
    forces: list[Row] = [_times(limit, x) for x in share]
    for k, (pillar, j) in enumerate(enclosure.pillars, len(enclosure.basis)):
        if pillar == i:
            unit = (interval(int(k == other)) for other in range(len(limit) - 1))
            pairs = zip(forces[j], (box[k], *unit), strict=True)
            forces[j] = [x.plus(y) for x, y in pairs]
    squares = total(value.square() for value, *_ in forces)
    if any(pillar == i for pillar, _ in enclosure.pillars) and squares.high > limit[0].square().low:
        raise BrokenLaw(f"contact {i + 1} has a friction above its limit")
    return forces


def unit_slip(i: int, slip: Sequence[Row]) -> list[Row]:
    """Return ``s / |s|``, whose derivative is that of s without its part along s, over |s|."""
    values, *columns = zip(*slip, strict=True)
    square = total(x.square() for x in values)
    if square.low <= 0:
        raise BrokenLaw(f"contact {i + 1} does not slip all over the enclosure")
    root = square.inverse_root()
    units = [x.times(root) for x in values]
    along = [product(units, column) for column in columns]
    return [
        [u, *(x.plus(u.times(y).negative()).times(root) for x, y in zip(row, along, strict=True))]
        for u, (_, *row) in zip(units, slip, strict=True)
    ]
