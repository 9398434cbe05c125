"""What one contact does within bounds: forms in its own uncertain numbers, in exact integers.

A contact within bounds has its normal turned by an angle of at most t, each coordinate of its point
moved, and friction, stiffness and preload changed by a share. Each is bounded by itself, so nothing
is lost but what its own numbers have in common beyond first order (`Affine`).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.console.number_form import Shown
from arrangement.numbers.exact import RationalVector, dot, rational, shown, to_text
from equilibrium.model.contact import VALUES, Contact, wrench_at
from equilibrium.model.errors import GraspError

#: All numbers are integers over two to this power.
BITS = 128
_ONE = 1 << BITS
#: The names of bounds, and how large each may be.
LARGEST: dict[str, Fraction | int] = {
    "degrees": 45,
    "length": 10**9,
    **dict.fromkeys(VALUES, Fraction(99, 100)),
}


@dataclass(frozen=True, repr=False)
class Bounds(Shown):
    """How far grasps may be from one that is given.

    Attributes:
        degrees: of each normal, up to 45.
        length: of each coordinate of a point.
        friction, stiffness, preload: shares of the values, below 1.

    >>> Bounds(degrees=2, friction="5%").friction
    Fraction(1, 20)
    """

    degrees: Fraction
    length: Fraction
    friction: Fraction
    stiffness: Fraction
    preload: Fraction

    def __init__(self, **given: Any) -> None:
        for name, most in LARGEST.items():
            value = given.pop(name, 0)
            percent = isinstance(value, str) and value.endswith("%")
            found = rational(value.removesuffix("%") if percent else value, name)
            found /= 100 if percent else 1
            if not 0 <= found <= most:
                share = ", a share of the value as 0.05 or 5%" if name in VALUES else ""
                raise GraspError(
                    f"{name} is {shown(value)}; give a number from 0 to {float(most):.12g}{share}"
                )
            object.__setattr__(self, name, found)
        if given:
            raise GraspError(f"{shown(min(given))} is no bound; known are {', '.join(LARGEST)}")

    @property
    def angle(self) -> Fraction:
        """A little more than `degrees` in radians."""
        return self.degrees * Fraction(355, 113 * 180)

    def times(self, share: Fraction) -> Bounds:
        """Return bounds that are a share of these, from 0 to 1."""
        return Bounds(**{name: share * getattr(self, name) for name in LARGEST})

    def to_dict(self) -> dict[str, str]:
        """Return the file form."""
        return {name: to_text(getattr(self, name)) for name in LARGEST}

    def __str__(self) -> str:
        angle, length = (f"{float(x):g}" for x in (self.degrees, self.length))
        words = [f"normals within {angle} degrees"] if self.degrees else []
        words += [f"points within {length}"] if self.length else []
        for name in VALUES:
            if share := getattr(self, name):
                words.append(f"{name} within {float(100 * share):g} per cent")
        return ", ".join(words) or "no change"


class Affine(NamedTuple):
    """All numbers ``centre + sum parts[k] x_k + rest z``, with x_k and z from -1 to 1.

    The x_k stand for one contact's own uncertain numbers: turns of the normal, coordinates of the
    point, friction, stiffness, preload. What is rounded off is in the rest.
    """

    centre: int
    parts: tuple[int, ...]
    rest: int = 0

    @property
    def radius(self) -> int:
        """The largest distance from the centre."""
        return sum(map(abs, self.parts)) + self.rest

    @property
    def low(self) -> int:
        """The least of the numbers."""
        return self.centre - self.radius

    @property
    def high(self) -> int:
        """The largest."""
        return self.centre + self.radius

    @property
    def size(self) -> int:
        """The largest absolute value."""
        return abs(self.centre) + self.radius

    def plus(self, other: Affine) -> Affine:
        """Return the sum."""
        parts = tuple(x + y for x, y in zip(self.parts, other.parts, strict=True))
        return Affine(self.centre + other.centre, parts, self.rest + other.rest)

    def negative(self) -> Affine:
        """Return all negatives."""
        return Affine(-self.centre, tuple(-x for x in self.parts), self.rest)

    def scaled(self, above: int, below: int = _ONE) -> Affine:
        """Return the multiples by a ratio."""
        centre, *parts = (x * above // below for x in (self.centre, *self.parts))
        return Affine(centre, tuple(parts), -(-self.rest * abs(above) // below) + len(parts) + 1)

    def times(self, other: Affine) -> Affine:
        """Return the product; what is of second order is in the rest."""
        a, b = self.centre, other.centre
        exact = [a * b, *(b * x + a * y for x, y in zip(self.parts, other.parts, strict=True))]
        rest = abs(b) * self.rest + abs(a) * other.rest + self.radius * other.radius
        centre, *parts = (x >> BITS for x in exact)
        lost = sum(1 for x in exact if x & (_ONE - 1))
        return Affine(centre, tuple(parts), -(-rest >> BITS) + lost)


def _form(number: int, centre: Fraction | int, parts: Mapping[int, Fraction | int]) -> Affine:
    """Return a form of so many parts, some of them given."""
    row = [0] * (number + 1)
    lost = 0
    for k, x in [(-1, centre), *parts.items()]:
        row[k], rest = divmod(x.numerator << BITS, x.denominator)
        lost += rest > 0
    return Affine(row.pop(), tuple(row), lost)


class Uncertain:
    """A contact within bounds."""

    def __init__(self, contact: Contact, bounds: Bounds) -> None:
        n, turn = contact.dimension, bounds.angle
        self.number = 2 * n + 2
        values = enumerate((getattr(contact, name) for name in VALUES), 2 * n - 1)
        self.friction, self.stiffness, self.preload = (
            _form(self.number, x, {k: x * getattr(bounds, name)})
            for name, (k, x) in zip(VALUES, values, strict=True)
        )
        self.turns = [_form(self.number, Fraction(0), {k: turn}) for k in range(n - 1)]
        #: At least ``1 - cos``.
        self.lost = _form(self.number, turn**2 / 2, {})
        # Wrenches along the axes, and how they change with each coordinate of the point; integers.
        units = [tuple(Fraction(j == k) for j in range(n)) for k in range(n * (bounds.length > 0))]
        axes = (contact.normal, *contact.tangents)
        rows = [[wrench_at(contact.point, axis)] for axis in axes]
        for row, axis in zip(rows, axes, strict=True):
            arms = (wrench_at(unit, axis)[n:] for unit in units)
            row += [(*[Fraction(0)] * n, *(bounds.length * x for x in arm)) for arm in arms]
        self.unit = math.lcm(*(x.denominator for row in rows for one in row for x in one))
        self.rows = [[[int(x * self.unit) for x in one] for one in row] for row in rows]

    def moved(self, motion: Sequence[int]) -> list[Affine]:
        """Return how far a motion moves the contact along its normal and tangents.

        The normal turns by an angle of sine s towards a unit tangent u, and the tangents with it:
        ``n' = n + s u - (1 - cos) n`` and ``t' = t - s (t . u) n - (1 - cos) (t . u) u``.
        """
        first, still = len(self.turns), []
        for row in self.rows:
            centre, *more = (Fraction(dot(one, motion), self.unit) for one in row)
            still.append(_form(self.number, centre, dict(enumerate(more, first))))
        normal, *slips = still

        def loose(form: Affine, size: int) -> Affine:
            return form._replace(rest=form.rest - (-size * self.lost.size >> BITS))

        along, across = loose(normal, normal.size), sum(slip.size for slip in slips)
        for turn, slip in zip(self.turns, slips, strict=True):
            along = along.plus(turn.times(slip))
        pairs = zip(self.turns, slips, strict=True)
        return [along, *(loose(t, across).plus(s.times(normal).negative()) for s, t in pairs)]

    def corner(self, motion: Sequence[int]) -> tuple[Affine, list[Affine]]:
        """Return spring force and slip at a homogeneous motion."""
        normal, *slips = self.moved(motion[1:])
        spring = self.preload.times(_form(self.number, motion[0], {}))
        return spring.plus(self.stiffness.times(normal).negative()), slips

    def at_rest(self, friction: RationalVector) -> list[Affine] | None:
        """Return a friction force at rest as forms; None where it may be above its limit."""
        limit = max(self.friction.low, 0) * max(self.preload.low, 0) >> BITS
        if dot(friction, friction) * _ONE**2 > limit**2:
            return None
        return [_form(self.number, x, {}) for x in friction]

    def rest_work(self, virtual: Sequence[int], friction: Sequence[Affine]) -> int:
        """Return at least what the contact does at rest."""
        normal, *across = self.moved(virtual)
        work = self.preload.times(normal)
        for force, way in zip(friction, across, strict=True):
            work = work.plus(force.times(way))
        return work.low

    def works(
        self, virtual: Sequence[int], corners: Sequence[tuple[Affine, list[Affine]]]
    ) -> list[int]:
        """Return at least what the contact does on a virtual motion, at each corner of a cell."""
        springs = [spring for spring, _ in corners]
        if all(e.high <= 0 for e in springs):
            return [0] * len(corners)
        normal, *across = self.moved(virtual)
        slips, attached = [slip for _, slip in corners], all(e.low >= 0 for e in springs)
        if attached and len(across) > 1 and (found := self._turned(normal, across, springs, slips)):
            return found
        if len(across) > 1:
            rubs = [Affine(_largest(across, slips), (0,) * self.number)]
        else:
            one, other = across[0], across[0].negative()
            rubs = [one] * any(s.high >= 0 for (s,) in slips)
            rubs += [other] * any(s.low <= 0 for (s,) in slips)
        factors = [normal.plus(self.friction.times(rub).negative()) for rub in rubs]
        least = min(x.low for x in factors)
        found = []
        for e in springs:
            if e.low >= 0:
                work = min(x.times(e).low for x in factors)
            else:
                work = min(least, 0) * max(e.high, 0) >> BITS
            found.append(work if attached else min(work, 0))
        return found

    def _turned(
        self,
        normal: Affine,
        across: Sequence[Affine],
        springs: Sequence[Affine],
        slips: Sequence[Sequence[Affine]],
    ) -> list[int]:
        """Return the work where slips turn less than in `_turning`; else nothing.

        With ``u . b <= g + h`` and a middle spring force f, ``e mu (g + h) <= e mu g + f mu h + mu
        |e - f| |h|``.
        """
        found = _turning(across, slips)
        if found is None:
            return []
        still, turns = found
        middle = sum(e.centre for e in springs) // len(springs)
        away = max(abs(e.centre - middle) + e.radius for e in springs)
        rest = -(-away * max(h.size for h in turns) * self.friction.size >> 2 * BITS)
        factor = normal.plus(self.friction.times(still).negative())
        pressed = self.friction.scaled(-middle)
        pairs = zip(springs, turns, strict=True)
        return [factor.times(e).plus(pressed.times(h)).low - rest for e, h in pairs]


def _turning(
    b: Sequence[Affine], slips: Sequence[Sequence[Affine]]
) -> tuple[Affine, list[Affine]] | None:
    """Return g, and h at each slip, so that ``u . b <= g + h`` for directions u of slips.

    For slips in the hull of the given, h is to be interpolated. Let v and t be unit vectors along
    and across the middle slip, of length r, and a slip ``s = |s| (v cos + t sin)``. Then ``u . b =
    b . v + (b . t) (s . t) / r - (b . v) (1 - cos) + (b . t) sin (1 - |s| / r)``. None where some
    slip may be a right angle away. v and t are rounded, at a cost below ``|b| 2^-90``.
    """
    ahead = [
        sum(form.centre for form in column) // len(slips) for column in zip(*slips, strict=True)
    ]
    middle = math.isqrt(sum(x * x for x in ahead))
    if middle < 1 << 100:
        return None
    x, y = ((x << BITS) // middle for x in ahead)

    def along(pair: Sequence[Affine], x: int, y: int) -> Affine:
        one, other = pair
        return one.scaled(x).plus(other.scaled(y))

    still, turn = along(b, x, y), along(b, -y, x)
    parts = [(along(slip, x, y), along(slip, -y, x)) for slip in slips]
    least = min(forth.low for forth, _ in parts)
    if least <= 0:
        return None
    tangent = max(-(-(side.size << BITS) // forth.low) for forth, side in parts) + (1 << 40)
    if tangent > _ONE:
        return None
    longest = max(_length((forth.size, side.size)) for forth, side in parts)
    uneven = -(-(max(longest - middle, middle - least) << BITS) // middle)
    rest = max(-still.low, 0) * tangent * tangent // 2 + turn.size * tangent * uneven
    rest = -(-rest >> 2 * BITS) + (_length(x.size for x in b) >> 90) + 1
    turns = [turn.times(side.scaled(_ONE, middle)) for _, side in parts]
    return still._replace(rest=still.rest + rest), turns


def _largest(b: Sequence[Affine], slips: Sequence[Sequence[Affine]]) -> int:
    """Return at least the largest ``u . b`` for directions u of slips in the cone of the given.

    With ``b . s_j <= g |s_j|`` and ``v . s_j >= c |s_j|`` for a unit vector v, a slip ``s = sum t_j
    s_j`` has ``|s| <= sum t_j |s_j| <= |s| / c``, and ``b . s <= g sum t_j |s_j|``.
    """
    whole = _length(x.size for x in b)
    ahead = [sum(form.centre for form in column) for column in zip(*slips, strict=True)]
    size, steepest, nearest = _length(map(abs, ahead)), -whole, _ONE
    for slip in slips:
        low = math.isqrt(sum(max(abs(x.centre) - x.radius, 0) ** 2 for x in slip))
        high = _length(x.size for x in slip)
        pairs = zip(slip, ahead, strict=True)
        before = sum(x.centre * y - x.radius * abs(y) for x, y in pairs)
        if not low or before <= 0:
            return whole
        work = sum(x.times(y).high for x, y in zip(b, slip, strict=True))
        steepest = max(steepest, -(-(work << BITS) // (low if work > 0 else high)))
        nearest = min(nearest, (before << BITS) // (high * size))
    if steepest > 0:
        steepest = -(-(steepest << BITS) // nearest) if nearest else whole
    return min(whole, steepest)


def _length(sizes: Iterable[int]) -> int:
    """Return at least the length of a vector whose entries are at most that large."""
    return math.isqrt(sum(x * x for x in sizes)) + 1
