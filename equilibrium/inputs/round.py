"""Contacts on a circle, at rational points of it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from arrangement.exact import rational, rational_vector, shown
from equilibrium.model.errors import GraspError
from equilibrium.model.outline import Circle

from .conversion import DEFAULT_TOLERANCE, Conversion, assembled, contact_values, unit_normals


def on_circle(
    angles: int | Iterable[float],
    friction: Any,
    *,
    radius: Any = 1,
    centre: Iterable[Any] = (0, 0),
    stiffness: Any = 1,
    preload: Any = 0,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
) -> Conversion:
    """Return contacts on a circle, which is the outline, with normals to its centre.

    Each contact is a rational point of the circle near the wanted angle, and lies on the circle
    exactly. `point_errors` bound how far it is from the wanted place, up to the rounding of the
    sine and cosine (about 10^-16 of the radius).

    Args:
        angles: degrees, counter-clockwise from the x axis; or a number m of contacts, evenly
            spread from angle 0.
        friction, stiffness, preload: one for all or one for each contact.
        radius: above 0.
        centre: of the circle.

    >>> [c.normal for c in on_circle(2, 1).grasp]
    [(Fraction(-1, 1), Fraction(0, 1)), (Fraction(1, 1), Fraction(0, 1))]
    """
    if isinstance(angles, int):
        wanted = [360 * i / angles for i in range(angles)]
    else:
        wanted = [float(x) for x in angles]
    size, middle = rational(radius, "radius"), rational_vector(centre, "centre")
    if size <= 0 or len(middle) != 2:
        raise GraspError(
            f"radius is {shown(size)}, it must be above 0; a centre has two coordinates"
        )
    inward = unit_normals([_direction(angle) for angle in wanted], angle_tolerance)
    places = [
        (
            tuple(c - size * n for c, n in zip(middle, normal.normal, strict=True)),
            size * abs(normal.angle_error),
        )
        for normal in inward
    ]
    values = contact_values(len(places), friction, stiffness, preload)
    return assembled(places, inward, values, outline=Circle(middle, size))


def _direction(degrees: float) -> tuple[float, float]:
    """Return the inward direction at an angle, exact at multiples of 90 degrees."""
    if not math.isfinite(degrees):
        raise GraspError(f"an angle is {degrees}; give finite degrees")
    turns, rest = divmod(degrees, 90)
    x, y = math.cos(math.radians(rest)), math.sin(math.radians(rest))
    if rest == 0:
        x, y = 1.0, 0.0
    for _ in range(int(turns) % 4):
        x, y = -y, x
    return (-x, -y)
