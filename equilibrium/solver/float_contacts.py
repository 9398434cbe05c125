"""The numbers of all contacts of a grasp in floating point."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import cached_property

import numpy as np

from equilibrium.model.grasp import Grasp

#: Larger numbers are cut off.
_LARGEST = 1e60
#: Where all numbers but 0 are in this range, nothing underflows or overflows on the way.
_SMALL, _LARGE = 1e-30, 1e30


def nearest(x: Fraction) -> float:
    """Return the nearest float of moderate size."""
    try:
        return min(max(float(x), -_LARGEST), _LARGEST)
    except OverflowError:
        return _LARGEST if x > 0 else -_LARGEST


def are_moderate(numbers: Iterable[Fraction]) -> bool:
    """Return whether bounds of rounding errors may be trusted: no number is tiny or huge."""
    return all(not x or _SMALL <= abs(nearest(x)) <= _LARGE for x in numbers)


class FloatContacts:
    """The numbers of the contacts, each rounded once.

    Attributes:
        spring: (m, 4), the row ``(preload, -stiffness N)``.
        normal, tangent: (m, 3); pull: friction times T.
        length: a typical distance of the contacts from the origin.
    """

    def __init__(self, grasp: Grasp) -> None:
        self.grasp, m = grasp, len(grasp)
        self._exact = [
            (*c.normal_wrench, *c.tangential_wrench, c.stiffness, c.preload, c.friction)
            for c in grasp
        ]
        table = np.array([[nearest(x) for x in row] for row in self._exact]).reshape(m, 9)
        self.normal, self.tangent = table[:, :3], table[:, 3:6]
        self.stiffness, self.preload, self.friction = table[:, 6:].T
        self.spring = np.column_stack([self.preload, -self.stiffness[:, None] * self.normal])
        self.pull = self.friction[:, None] * self.tangent
        points = np.array([[nearest(x) for x in c.point] for c in grasp]).reshape(m, 2)
        self.length = float(np.median(np.hypot(*points.T))) if m else 1.0
        if not self.length > 0:
            self.length = 1.0

    @cached_property
    def moderate(self) -> bool:
        """Whether bounds of rounding errors may be trusted; see `are_moderate`."""
        return all(map(are_moderate, self._exact))
