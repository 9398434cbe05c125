"""Bounds of grasps near a given one, and how far the wrenches of a contact change within them.

A contact within bounds has its normal turned by an angle of at most t, each coordinate of its point
moved, and friction, stiffness, preload and adhesion changed by a share. Adhesion pulls along the
turned normal.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.console.number_form import JsonMixin
from arrangement.numbers.exact import RationalVector, dot, rational, shown
from equilibrium.model.contact import VALUES, Contact
from equilibrium.model.errors import GraspError

#: At least the square roots of 2, 3 and 6: how far a shift of each coordinate of a point by 1 moves
#: it along a unit vector, by dimension; along both tangents in space.
_SHIFTS = {2: (Fraction(3, 2), Fraction(3, 2)), 3: (Fraction(7, 4), Fraction(5, 2))}
#: The names of bounds, and how large each may be.
LARGEST: dict[str, Fraction | int] = {
    "degrees": 45,
    "length": 10**9,
    **dict.fromkeys(VALUES, Fraction(99, 100)),
}


@dataclass(frozen=True, repr=False)
class Bounds(JsonMixin):
    """How far grasps may be from one that is given.

    Attributes:
        degrees: of each normal, up to 45.
        length: of each coordinate of a point.
        friction, stiffness, preload, adhesion: shares of the values, below 1.

    >>> Bounds(degrees=2, friction="5%").friction
    Fraction(1, 20)
    """

    json_fields = tuple(LARGEST)

    degrees: Fraction
    length: Fraction
    friction: Fraction
    stiffness: Fraction
    preload: Fraction
    adhesion: Fraction

    def __init__(self, **bounds: Any) -> None:
        for name, most in LARGEST.items():
            value = bounds.pop(name, 0)
            percent = isinstance(value, str) and value.endswith("%")
            bound = rational(value.removesuffix("%") if percent else value, name)
            bound /= 100 if percent else 1
            if not 0 <= bound <= most:
                share = ", a share of the value as 0.05 or 5%" if name in VALUES else ""
                raise GraspError(
                    f"{name} is {shown(value)}; give a number from 0 to {float(most):.12g}{share}"
                )
            object.__setattr__(self, name, bound)
        if bounds:
            raise GraspError(
                f"{shown(min(bounds))} is not a bound; expected one of {', '.join(LARGEST)}"
            )

    @property
    def angle(self) -> Fraction:
        """A little more than `degrees` in radians."""
        return self.degrees * Fraction(355, 113 * 180)

    def times(self, share: Fraction) -> Bounds:
        """Return bounds that are a share of these, from 0 to 1."""
        return Bounds(**{name: share * getattr(self, name) for name in LARGEST})

    def __str__(self) -> str:
        angle, length = (f"{float(x):g}" for x in (self.degrees, self.length))
        unit = "degree" if self.degrees == 1 else "degrees"
        words = [f"normals within {angle} {unit}"] if self.degrees else []
        words += [f"points within {length}"] if self.length else []
        for name in VALUES:
            if share := getattr(self, name):
                words.append(f"{name} within {float(100 * share):g} per cent")
        return ", ".join(words) or "no change"


class Along(NamedTuple):
    """How far a motion moves a contact along its normal and its tangents.

    Attributes:
        normal, tangents: of the given contact.
        normal_error, tangent_error: at least the changes of these numbers within the bounds, of the
            second the length of the vector of changes.
    """

    normal: Fraction
    tangents: RationalVector
    normal_error: Fraction
    tangent_error: Fraction

    @property
    def slip(self) -> Fraction:
        """At least the length of the displacement along the tangents, within the bounds."""
        return length(self.tangents) + self.tangent_error


class Uncertain:
    """A contact within bounds."""

    def __init__(self, contact: Contact, bounds: Bounds) -> None:
        self.contact, self.bounds = contact, bounds

    def along(self, motion: Sequence[Fraction]) -> Along:
        """Return how far a motion moves the contact; between bodies a relative one.

        The normal turns by an angle of sine s towards a unit tangent u, and the tangents with it:
        ``n' = n + s u - (1 - cos) n`` and ``t' = t - s (t . u) n - (1 - cos) (t . u) u``. A point
        that is shifted by x moves by ``omega x x`` more.
        """
        contact, turn = self.contact, self.bounds.angle
        normal = Fraction(dot(contact.normal_wrench, motion))
        tangents = tuple(Fraction(dot(row, motion)) for row in contact.tangential_wrenches)
        slip, lost = length(tangents), turn * turn / 2
        arm = self.bounds.length * sum(map(abs, motion[contact.dimension :]))
        along, across = (arm * x for x in _SHIFTS[contact.dimension])
        return Along(
            normal,
            tangents,
            turn * slip + lost * abs(normal) + along,
            turn * abs(normal) + lost * slip + across,
        )

    def ends(self, name: str) -> tuple[Fraction, Fraction]:
        """Return the least and the largest of the values of this name."""
        value, share = getattr(self.contact, name), getattr(self.bounds, name)
        return value * (1 - share), value * (1 + share)


def length(vector: Sequence[Fraction]) -> Fraction:
    """Return at least the length of a vector, of one entry exactly."""
    return abs(vector[0]) if len(vector) == 1 else root(sum((x * x for x in vector), Fraction(0)))


def root(square: Fraction) -> Fraction:
    """Return at least the square root of a number that is not negative, nearly that."""
    if not square:
        return square
    top, below = square.numerator * square.denominator, square.denominator
    return Fraction(math.isqrt(top << 120) + 1, below << 60)
