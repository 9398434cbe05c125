"""Force closure with round cones, searched for in floats: forces or a motion, made exact.

All wrenches are balanced exactly when the wrenches of the contacts span space and contact forces
balance ``w = sum N_i``: these and the unit pushes along the normals are together strictly inside
the cones. One cone program looks for such forces, another for the motion that shows there are none;
what they find is rounded so that all that has to be exact is.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain

import numpy as np

from arrangement.numbers.exact import RationalVector, integers_over
from arrangement.numbers.float_filter import Floats
from equilibrium.core.cones import RoundCones
from equilibrium.core.contacts import FloatContacts
from equilibrium.core.exact_parts import ExactParts
from equilibrium.core.leaves import Leaves, cancelled
from equilibrium.core.relaxation import Point, Relaxation
from equilibrium.core.states import spanning_rows
from equilibrium.model.effort import Effort
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Solution

#: Forces are rounded to multiples of one over these.
_ROUNDINGS = (2**10, 2**20, 2**34, 2**48)
#: Room in the cones that a motion is looked for with: none where contacts are on its axis.
_ROOMS = (1.0, 0.0)


class ClosureSearch:
    """The search for one grasp in space; each result is to be checked.

    Args:
        load: the sum of the normal wrenches.
    """

    def __init__(self, grasp: Grasp, load: RationalVector) -> None:
        self._contacts, cones = FloatContacts(ContactRows.of_grasp(grasp)), RoundCones()
        self._load = load
        self._states = ("loose",) * len(grasp)
        self._relaxation = Relaxation(self._contacts, load, cones)
        self._leaves = Leaves(self._contacts, load, cones)

    def motion(self) -> RationalVector | None:
        """Return a motion on which no force in the cones does negative work, if one is found."""
        for room in _ROOMS:
            with np.errstate(all="ignore"):
                ray = self._relaxation.inner_ray(self._states, room)
                leaf = ray and self._leaves.leaf(self._states, ray)
            if leaf:
                return tuple(map(Fraction, leaf.motion))
        return None

    def boundary_motion(self) -> RationalVector | None:
        """Return such a motion on the boundary, if friction has simple directions there."""
        with np.errstate(all="ignore"):
            ray = self._relaxation.inner_ray(self._states, 0.0)
        if ray is None:
            return None
        exact = ExactParts(self._contacts, self._load, Effort())
        proof = exact.part(self._states, -(self._contacts.tangents @ ray.virtual))
        return None if isinstance(proof, Solution) else proof.motion

    def forces(self) -> Iterator[tuple[RationalVector, ...]]:
        """Yield balanced forces near those of the load and the pushes, from coarse to fine."""
        with np.errstate(all="ignore"):
            point = self._relaxation.solve(self._states)
        if not isinstance(point, Point) or not np.isfinite(point.forces).all():
            return
        forces = point.forces * self._relaxation.force
        forces[:, 0] += 1.0
        rows = self._contacts.rows
        places = [(i, j) for i, c in enumerate(rows) for j in range(3 if c.friction else 1)]
        frames = [(c.normal_wrench, *c.tangential_wrenches) for c in rows]
        unit = math.lcm(*(x.denominator for x in chain(*chain(*frames))))
        places = self._changed_first(places, forces)
        columns = [integers_over(frames[i][j], unit) for i, j in places]
        for fine in _ROUNDINGS:
            sizes = [round(float(forces[place]) * fine) for place in places]
            values, scale = cancelled(columns, sizes, rows.n)
            shares = [[Fraction(0)] * 3 for _ in rows]
            for (i, j), value in zip(places, values, strict=True):
                shares[i][j] = Fraction(value, fine * scale)
            yield tuple(map(tuple, shares))

    def _changed_first(
        self, places: Sequence[tuple[int, int]], forces: Floats
    ) -> list[tuple[int, int]]:
        """Return components of forces, first those that rounding errors are made up with."""
        c = self._contacts
        frames = np.concatenate([c.normal[:, None], c.tangents], axis=1) * c.arms(1 / c.length)
        # A component may change as much as there is room in the cone.
        room = forces[:, 0] - np.hypot(*forces[:, 1:].T) / np.where(c.friction, c.friction, 1.0)
        weight = np.column_stack([room, room * c.friction, room * c.friction])
        rows = np.array([frames[place] * weight[place] for place in places])
        first = spanning_rows(rows, c.rows.n)
        order = [*first, *(k for k in range(len(places)) if k not in first)]
        return [places[k] for k in order]
