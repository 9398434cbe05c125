"""The numbers of the contacts of a grasp in space, exact and in floating point."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import cached_property

import numpy as np

from arrangement.exact import RationalVector
from arrangement.float_filter import Floats
from equilibrium.model.grasp import Grasp
from equilibrium.solver.float_contacts import nearest


class SpatialContacts:
    """The numbers of the contacts, each rounded once.

    Attributes:
        normal: (m, 6); tangents: (m, 2, 6); spring: (m, 7), the rows ``(preload, -stiffness N)``.
        stiffness, preload, friction: (m,).
        length: a typical distance of the contacts from the origin.
    """

    def __init__(self, grasp: Grasp) -> None:
        self.grasp, m = grasp, len(grasp)
        self.normal = _floats([c.normal_wrench for c in grasp], (m, 6))
        self.tangents = _floats([row for c in grasp for row in c.tangential_wrenches], (m, 2, 6))
        values = [(c.stiffness, c.preload, c.friction) for c in grasp]
        self.stiffness, self.preload, self.friction = _floats(values, (m, 3)).T
        self.spring = np.column_stack([self.preload, -self.stiffness[:, None] * self.normal])
        points = _floats([c.point for c in grasp], (m, 3))
        self.length = float(np.median(np.linalg.norm(points, axis=1))) if m else 1.0
        if not self.length > 0:
            self.length = 1.0

    @cached_property
    def springs(self) -> list[RationalVector]:
        """The exact rows ``(preload, -stiffness N)``."""
        return [(c.preload, *(-c.stiffness * x for x in c.normal_wrench)) for c in self.grasp]


def _floats(rows: Iterable[Iterable[Fraction]], shape: tuple[int, ...]) -> Floats:
    return np.array([[nearest(x) for x in row] for row in rows], dtype=float).reshape(shape)
