"""A motion in space as a screw: an axis and a pitch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from arrangement.draw.items import Floats
from arrangement.exact import dot
from arrangement.linear import cross


@dataclass(frozen=True)
class Screw:
    """A motion as a turn about an axis and a shift along it.

    Attributes:
        axis: unit vector; of a pure shift, its direction.
        point: on the axis, nearest to the middle of the picture; None for a shift.
        pitch: shift along the axis for each radian; None for a shift.
    """

    axis: Floats
    point: Floats | None
    pitch: float | None

    @classmethod
    def of(cls, motion: Sequence[float | Fraction]) -> Screw | None:
        """Return the screw of a motion ``(v, omega)``; None if it is 0. Lengths as in the grasp.

        >>> Screw.of((0, 0, 2, 0, 0, 1)).pitch
        2.0
        """
        exact = [Fraction(x) for x in motion]
        largest = max(map(abs, exact))
        if not largest:
            return None
        v, omega = (tuple(x / largest for x in part) for part in (exact[:3], exact[3:]))
        square = dot(omega, omega)
        if square < Fraction(1, 10**18):
            return cls(_unit(v), None, None)
        point = np.array([float(x / square) for x in cross(omega, v)])
        return cls(_unit(omega), point, float(dot(v, omega) / square))


def _unit(vector: Sequence[Fraction]) -> Floats:
    found = np.array([float(x) for x in vector])
    return found / float(np.linalg.norm(found))
