"""Friction pyramids: cones over polygons with rational corners, inside the round cone."""

from __future__ import annotations

import math

from arrangement.numbers.exact import RationalVector, shown

from .errors import GraspError
from .unit_normal import unit_normal

#: Largest tangent of the angle between an edge and where a regular polygon has it.
_TOLERANCE = "1/1000"
_MOST = 64
#: Why a pyramid is refused in the plane.
FLAT = "in the plane the friction cone has two edges, and a pyramid is for grasps in space; omit it"


def pyramid_words(count: int | None, before: str = "") -> str:
    """Return what an answer for pyramids in place of round cones has to say; else nothing."""
    return "" if count is None else f"{before}friction pyramids of {count} edges"


def pyramid_edges(count: int) -> tuple[RationalVector, ...]:
    """Return unit vectors along the edges, in the frame of the two tangents of a contact.

    They go counter-clockwise from the first tangent by even angles, up to a thousandth: rational
    unit vectors are rarely regular. Opposite edges are exactly opposite.

    Raises:
        GraspError: the number is odd, below 4 or above 64.

    >>> [[str(x) for x in edge] for edge in pyramid_edges(4)]
    [['1', '0'], ['0', '1'], ['-1', '0'], ['0', '-1']]
    """
    if type(count) is not int or count % 2 or not 4 <= count <= _MOST:
        raise GraspError(
            f"a pyramid of {shown(count)} edges; give an even number from 4 to {_MOST}, so that "
            "opposite slips have opposite friction"
        )
    half = []
    for k in range(count // 2):
        angle = 2 * math.pi * k / count
        direction = (0.0, 1.0) if 4 * k == count else (math.cos(angle), math.sin(angle))
        half.append(unit_normal(direction, _TOLERANCE).normal)
    return (*half, *(tuple(-x for x in edge) for edge in half))
