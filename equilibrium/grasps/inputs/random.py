"""Random grasps, the same for the same seed on every machine: integers only, no floats."""

from __future__ import annotations

import math
from fractions import Fraction
from random import Random
from typing import Any

from arrangement.numbers.arguments import at_least, whole
from arrangement.numbers.exact import RationalVector, shown
from arrangement.numbers.linear.rank import cycle_edges
from equilibrium.model.contact import WRENCH_SIZES, Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, ask_contacts
from equilibrium.model.outline import Polygon
from equilibrium.model.unit_normal import of_half_tangent

#: Denominator of the half-angle tangents, and of all other numbers.
_FINE = 64
#: The same in space, for the directions and distances of contacts.
_COARSE = 16


def random_grasp(
    contacts: int, seed: int = 0, *, preload: bool | None = None, dimension: int = 2
) -> Grasp:
    """Return contacts around an object with inward normals.

    A contact sits in a random direction from the origin, at a distance between 1/2 and 3/2; its
    normal points to the origin, turned by at most 45 degrees (41 in space). Friction is between
    1/10 and 1, stiffness between 1/2 and 2.

    Args:
        contacts: their number.
        seed: of the random numbers; different numbers of contacts give unrelated grasps.
        preload: True for random preloads up to 2 at all contacts, False for none; None for one of
            these by the parity of the seed, so half of the seeds have preload.
        dimension: 2 for a grasp in the plane, 3 in space.

    >>> random_grasp(3, seed=7) == random_grasp(3, seed=7)
    True
    >>> {contact.preload for contact in random_grasp(4, seed=2)}
    {Fraction(0, 1)}
    """
    contacts, seed = at_least(contacts, 0, "contacts"), whole(seed, "seed")
    if dimension not in _CONTACTS:
        raise GraspError(f"dimension is {shown(dimension)}; give 2, the plane, or 3, space")
    ask_contacts(contacts)
    source = Random(f"grasp {contacts} {seed}" + (" in space" if dimension == 3 else ""))
    loaded = bool(seed % 2) if preload is None else preload
    return Grasp(_CONTACTS[dimension](source, loaded) for _ in range(contacts))


def random_wrench(seed: int = 0, *, bound: int = 2, dimension: int = 2) -> RationalVector:
    """Return a wrench with entries spread evenly over the multiples of 1/64 up to a bound."""
    source = Random(f"wrench {seed}")
    entries = range(WRENCH_SIZES[dimension])
    return tuple(Fraction(source.randint(-_FINE * bound, _FINE * bound), _FINE) for _ in entries)


def _contact(source: Random, loaded: bool) -> Contact:
    direction = _unit(source)
    # tan(22.5 degrees) is 0.414: half-angle tangents up to 26/64 stay below 45 degrees.
    cosine, sine = of_half_tangent(Fraction(source.randint(-26, 26), _FINE))
    distance = Fraction(source.randint(_FINE // 2, 3 * _FINE // 2), _FINE)
    x, y = direction
    inward = (-(cosine * x - sine * y), -(sine * x + cosine * y))
    return Contact((distance * x, distance * y), inward, **_values(source, loaded))


def _values(source: Random, loaded: bool) -> dict[str, Any]:
    return {
        "friction": Fraction(source.randint(2, 20), 20),
        "stiffness": Fraction(source.randint(4, 16), 8),
        "preload": Fraction(source.randint(1, 2 * _FINE), _FINE) if loaded else Fraction(0),
    }


def _spatial_contact(source: Random, loaded: bool) -> Contact:
    side, turns = source.choice((1, -1)), source.randrange(3)
    halves = [source.randint(-6, 6), source.randint(-6, 6)]
    turned = [x + source.randint(-4, 4) for x in halves]
    out, inward = (_around_axis(u, v, side, turns) for u, v in (halves, turned))
    distance = Fraction(source.randint(_COARSE // 2, 3 * _COARSE // 2), _COARSE)
    return Contact([distance * x for x in out], [-x for x in inward], **_values(source, loaded))


_CONTACTS = {2: _contact, 3: _spatial_contact}


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
        if corners and all(a[0] * b[1] > a[1] * b[0] for a, b in cycle_edges(corners)):
            return Polygon(corners)
    return None


def _unit(source: Random) -> tuple[Fraction, Fraction]:
    """Return a rational point of the unit circle: a random quadrant, a random half-angle in it."""
    x, y = of_half_tangent(Fraction(source.randint(-26, 26), _FINE))
    for _ in range(source.randrange(4)):
        x, y = -y, x
    return x, y


def _around_axis(u: int, v: int, side: int, turns: int) -> RationalVector:
    """Return a rational point of the unit sphere around one of the six ends of the axes."""
    square = u * u + v * v
    scale = Fraction(side, _COARSE**2 + square)
    x, y, z = 2 * u * _COARSE * scale, 2 * v * _COARSE * scale, (_COARSE**2 - square) * scale
    for _ in range(turns):
        x, y, z = y, z, x
    return x, y, z
