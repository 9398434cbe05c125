"""Exactly unit rational vectors near a given direction.

The rational points of the unit circle are ``((1 - u^2) / (1 + u^2), 2u / (1 + u^2))`` with u the
tangent of half the angle, and those of the unit sphere are ``(1 - u^2 - v^2, 2u, 2v)`` over
``1 + u^2 + v^2``. A direction that already has a rational length is returned exactly.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

from arrangement.console.number_form import table
from arrangement.numbers.exact import (
    RationalVector,
    dot,
    exact_root,
    from_float,
    rational_vector,
    shown,
    without_denominators,
)
from arrangement.numbers.linear.rank import cross

from .errors import GraspError

#: Directions whose unit vectors are remembered.
_CACHED = 256


class UnitNormal(NamedTuple):
    """An exactly unit vector, and the error made.

    Attributes:
        normal: rational, its length exactly 1.
        angle_error: the tangent of the signed angle (radians, counter-clockwise) from the wanted
            direction to `normal`, an exact rational. As ``|angle| <= |tan(angle)|`` below a
            right angle, its absolute value is an upper bound of the angle itself. In space it
            is a rational at or above the tangent, at least 0.
    """

    normal: RationalVector
    angle_error: Fraction

    def _repr_html_(self) -> str:
        return table(self, self._fields)


def unit_normal(direction: Iterable[Any], tolerance: Any = Fraction(1, 10**6)) -> UnitNormal:
    """Return an exactly unit rational vector within an angle of a direction, and the error.

    The direction need not have length 1. Converting is the purpose here, so finite floats are
    accepted as well as rationals; they stand for the binary fractions that they are.

    Args:
        direction: two numbers, or three in space, not all zero.
        tolerance: the largest accepted tangent of the angle error, ``0 < tolerance <= 1``.

    Returns:
        The unit vector of the smallest half-angle denominator that halving bounds finds within
        the tolerance; error 0 whenever the direction has a rational length.

    Raises:
        GraspError: a zero direction, or a tolerance out of range.

    >>> unit_normal([3, 4])
    UnitNormal(normal=(Fraction(3, 5), Fraction(4, 5)), angle_error=Fraction(0, 1))
    >>> unit_normal([1, 1], "1/100").normal
    (Fraction(119, 169), Fraction(120, 169))
    """
    wanted = rational_vector(direction, "direction", from_float)
    bound = from_float(tolerance, "tolerance")
    if len(wanted) not in (2, 3) or not any(wanted):
        raise GraspError(
            f"direction is {shown(direction)}; give two or three numbers, not all zero"
        )
    if not 0 < bound <= 1:
        raise GraspError(
            f"tolerance is {shown(tolerance)}; it must be above 0 and at most 1 (radians)"
        )
    return _nearest(wanted, bound)


@lru_cache(maxsize=_CACHED)
def _nearest(wanted: RationalVector, bound: Fraction) -> UnitNormal:
    """Return what `unit_normal` does; conversions want it of a direction twice."""
    length = exact_root(dot(wanted, wanted))
    if length is not None:
        return UnitNormal(tuple(x / length for x in wanted), Fraction(0))
    # Directions in space are in integers, of which the tangents need no length.
    whole = without_denominators(wanted)
    limit, scale = 1, max(10**20, math.ceil(10 / bound))
    while True:
        if len(wanted) == 2:
            normal = _near(wanted, limit)
            error = _tangent(wanted, normal)
            if error is not None and abs(error) <= bound:
                return UnitNormal(normal, error)
        else:
            along, unit = _near_in_space(whole, limit)
            error = _tangent_in_space(whole, along, scale)
            if error is not None and error <= bound:
                return UnitNormal(tuple(Fraction(x, unit) for x in along), error)
        limit *= 2


def of_half_tangent(u: Any) -> tuple[Any, Any]:
    """Return cosine and sine of an angle from the tangent of its half, a number or a function."""
    square = u * u
    return (1 - square) / (1 + square), 2 * u / (1 + square)


def angle_error(wanted: RationalVector, unit: RationalVector) -> Fraction:
    """Return the error of `UnitNormal`, for a unit vector that was made in another way.

    Raises:
        GraspError: the two are at a right angle or more.
    """
    if len(wanted) == 3 and not any(cross(wanted, unit)):
        return Fraction(0)
    error = (_tangent if len(wanted) == 2 else _tangent_in_space)(wanted, unit)
    if error is None:
        raise GraspError(f"{shown(wanted)} and {shown(unit)} are not near each other")
    return error


def _near(v: RationalVector, limit: int) -> RationalVector:
    """Return the unit vector whose half-angle tangent is v's with denominator at most limit.

    The octant of v is folded onto angles in (0, pi/4] first, so that the half-angle tangent is
    in (0, 1/2) and the same limit means the same fineness in every quadrant.
    """
    large, small = max(abs(v[0]), abs(v[1])), min(abs(v[0]), abs(v[1]))
    slope = small / large
    # The tangent of half the angle, to well within ``1 / limit^2``.
    half = slope / (1 + _root(1 + slope * slope, limit))
    cosine, sine = of_half_tangent(half.limit_denominator(limit))
    if abs(v[0]) < abs(v[1]):
        cosine, sine = sine, cosine
    return (cosine if v[0] > 0 else -cosine, sine if v[1] > 0 else -sine)


def _near_in_space(v: Sequence[int], limit: int) -> tuple[list[int], int]:
    """Return a vector of integers, and its length, near the direction of v.

    Its half-angle tangents are those of v with a common denominator of at most limit. They belong
    to the largest coordinate, which goes first and is made positive: both are at most
    1 / (1 + sqrt(2)) then. Of the denominators up to 2^14 the best is taken.
    """
    first = max(range(3), key=lambda j: abs(v[j]))
    others = [j for j in range(3) if j != first]
    square, digits = dot(v, v), 4 * limit.bit_length() + 16
    # Tangents are ``x / (|first| + |v|)``, here with a root rounded down.
    bottom = (abs(v[first]) << digits) + math.isqrt(square << (2 * digits))
    tops = [v[j] << digits for j in others]
    unit = limit
    if limit <= 2**14:
        import numpy as np

        few, pair = np.arange(max(limit // 2, 1), limit + 1), np.array([[x / bottom] for x in tops])
        unit = int(few[np.abs(pair - np.rint(pair * few) / few).max(axis=0).argmin()])
    halves = [(2 * x * unit + bottom) // (2 * bottom) for x in tops]
    squares = sum(x * x for x in halves)
    vector = [(1 if v[first] > 0 else -1) * (unit * unit - squares)] * 3
    for j, x in zip(others, halves, strict=True):
        vector[j] = 2 * x * unit
    return vector, unit * unit + squares


def _root(square: Fraction, limit: int) -> Fraction:
    """Return a square root, rounded down, to well within ``1 / limit^2``."""
    digits = 4 * limit.bit_length() + 16 + square.denominator.bit_length()
    scaled = square * (1 << (2 * digits))
    return Fraction(math.isqrt(scaled.numerator // scaled.denominator), 1 << digits)


def _tangent_in_space(
    wanted: Sequence[Any], unit: Sequence[Any], scale: int = 10**20
) -> Fraction | None:
    """Return the tangent of the angle, rounded up to a multiple of 1 / scale.

    None at a right angle or beyond.
    """
    cosine = dot(wanted, unit)
    if cosine <= 0:
        return None
    sines = cross(wanted, unit)
    scaled = dot(sines, sines) * scale**2 // (cosine * cosine)
    return Fraction(math.isqrt(scaled) + 1, scale)


def _tangent(wanted: RationalVector, unit: RationalVector) -> Fraction | None:
    """Return the tangent of the angle from wanted to unit; None at a right angle or beyond."""
    cosine = wanted[0] * unit[0] + wanted[1] * unit[1]
    sine = wanted[0] * unit[1] - wanted[1] * unit[0]
    return sine / cosine if cosine > 0 else None
