"""Contacts from measured or simulated data in floats, by exact snapping."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from arrangement.exact import RationalVector
from equilibrium.errors import GraspError

from .conversion import DEFAULT_TOLERANCE, Conversion, assembled, for_each, snapped, unit_normals


def from_float_data(
    points: Iterable[Any],
    normals: Iterable[Any],
    friction: Any,
    *,
    stiffness: Any = 1,
    preload: Any = 0,
    tolerance: Any = DEFAULT_TOLERANCE,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
) -> Conversion:
    """Return an exact grasp near float data, with the errors made.

    Every number becomes the simplest rational within the tolerance, so that 0.1 means 1/10 and
    contacts that were meant to be aligned are aligned.

    Args:
        points: (m, 2) contact points.
        normals: (m, 2) directions into the object, of any length.
        friction, stiffness, preload: one for all or one for each contact.
        tolerance: largest change of a coordinate or value.
        angle_tolerance: largest tangent of the change of a normal's direction.

    Raises:
        GraspError: wrong shapes, zero normals, values out of range.

    >>> from_float_data([[0.1, 0.2]], [[0.0, 2.0]], 0.3).grasp.contacts[0].point
    (Fraction(1, 10), Fraction(1, 5))
    """
    places = [_place(point, tolerance, i) for i, point in enumerate(points)]
    directions = unit_normals(normals, angle_tolerance)
    if len(directions) != len(places):
        raise GraspError(f"{len(directions)} normals for {len(places)} points; give one for each")
    values: list[dict[str, Fraction]] = [{} for _ in places]
    worst = Fraction(0)
    for name, given in (("friction", friction), ("stiffness", stiffness), ("preload", preload)):
        for value, number in zip(values, for_each(given, len(places), name), strict=True):
            value[name], change = snapped(number, tolerance)
            worst = max(worst, abs(change))
    return assembled(places, directions, values, worst)


def _place(point: Any, tolerance: Any, index: int) -> tuple[RationalVector, Fraction]:
    """Return a snapped point and its largest change."""
    coordinates = [snapped(x, tolerance) for x in point]
    if len(coordinates) != 2:
        raise GraspError(f"points[{index}] has {len(coordinates)} coordinates; give two")
    return tuple(x for x, _ in coordinates), max(abs(change) for _, change in coordinates)
