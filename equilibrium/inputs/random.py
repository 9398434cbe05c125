"""Random grasps, the same for the same seed on every machine: integers only, no floats."""

from __future__ import annotations

import math
from fractions import Fraction
from random import Random

from arrangement.exact import RationalVector
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Contact, Grasp
from equilibrium.model.outline import Polygon

#: Denominator of the half-angle tangents, and of all other numbers.
_FINE = 64


def random_grasp(contacts: int, seed: int = 0, *, preload: bool | None = None) -> Grasp:
    """Return contacts around an object with inward normals.

    A contact sits in a random direction from the origin, at a distance between 1/2 and 3/2; its
    normal points to the origin, turned by at most 45 degrees. Friction is between 1/10 and 1,
    stiffness between 1/2 and 2.

    Args:
        contacts: their number.
        seed: of the random numbers; different numbers of contacts give unrelated grasps.
        preload: True for random preloads up to 2 at all contacts, False for none; None for one of
            these by the parity of the seed, so half of the seeds have preload.

    >>> random_grasp(3, seed=7) == random_grasp(3, seed=7)
    True
    >>> {contact.preload for contact in random_grasp(4, seed=2)}
    {Fraction(0, 1)}
    """
    if contacts < 0:
        raise GraspError(f"contacts is {contacts}; it must be at least 0")
    source = Random(f"grasp {contacts} {seed}")
    loaded = bool(seed % 2) if preload is None else preload
    return Grasp(_contact(source, loaded) for _ in range(contacts))


def random_wrench(seed: int = 0, *, bound: int = 2) -> RationalVector:
    """Return a wrench with entries spread evenly over the multiples of 1/64 up to a bound."""
    source = Random(f"wrench {seed}")
    return tuple(Fraction(source.randint(-_FINE * bound, _FINE * bound), _FINE) for _ in range(3))


def _contact(source: Random, loaded: bool) -> Contact:
    direction = _unit(source)
    # tan(22.5 degrees) is 0.414: half-angle tangents up to 26/64 stay below 45 degrees.
    cosine, sine = _from_half_angle(Fraction(source.randint(-26, 26), _FINE))
    distance = Fraction(source.randint(_FINE // 2, 3 * _FINE // 2), _FINE)
    x, y = direction
    inward = (-(cosine * x - sine * y), -(sine * x + cosine * y))
    return Contact(
        (distance * x, distance * y),
        inward,
        Fraction(source.randint(2, 20), 20),
        Fraction(source.randint(4, 16), 8),
        Fraction(source.randint(1, 2 * _FINE), _FINE) if loaded else 0,
    )


def star_outline(grasp: Grasp) -> Polygon | None:
    """Return a polygon that is star-shaped about the origin, with an edge at each contact.

    All these edges have one length, at most 1/2. None where there is no such polygon: two contacts
    lie in one direction, or none on one side of the origin.
    """
    order = sorted(grasp, key=lambda c: math.atan2(c.point[1], c.point[0]))
    for half in (Fraction(1, 2**k) for k in range(2, 8)):
        corners = [
            tuple(x + side * half * t for x, t in zip(c.point, c.tangent, strict=True))
            for c in order
            for side in (1, -1)
        ]
        turns = zip(corners, [*corners[1:], *corners[:1]], strict=True)
        if corners and all(a[0] * b[1] > a[1] * b[0] for a, b in turns):
            return Polygon(corners)
    return None


def _unit(source: Random) -> tuple[Fraction, Fraction]:
    """Return a rational point of the unit circle: a random quadrant, a random half-angle in it."""
    x, y = _from_half_angle(Fraction(source.randint(-26, 26), _FINE))
    for _ in range(source.randrange(4)):
        x, y = -y, x
    return x, y


def _from_half_angle(u: Fraction) -> tuple[Fraction, Fraction]:
    """Return cosine and sine of twice the angle whose tangent is u."""
    return (1 - u * u) / (1 + u * u), 2 * u / (1 + u * u)
