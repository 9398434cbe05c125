"""Where floats end without an answer: parts of the tree and states of contacts, decided exactly.

Each is a linear program. For a "no" the round cones lie inside polygons, and a corner that sticks
out is cut off as often as it takes; for a "yes" they are polygons inside. So what is decided on a
border, where a float proves nothing, is decided if the friction there has a rational direction.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.float_filter import Floats
from equilibrium.model.contact import pyramid_edges
from equilibrium.plane.contacts import SpatialContacts

from .equilibria import SpatialSolution
from .relaxation import State
from .state_program import ConeRow, Ends, StateProgram
from .states import States, rational_direction

#: Sides of the polygons at first; how often corners are cut off; denominators of directions.
_SIDES, _CUTS, _SIMPLE, _LONG = 8, 3, 64, 2**20
#: What is taken off the least product of a middle direction with the arc of a sector.
_LESS = Fraction(1, 2**40)


class ExactParts:
    """The exact programs of one question.

    Args:
        deadline: of `time.monotonic`; `TimeoutError` is raised then.
    """

    def __init__(self, contacts: SpatialContacts, wrench: RationalVector, deadline: float) -> None:
        self.grasp, self.wrench, self.deadline = contacts.grasp, wrench, deadline
        self.base = pyramid_edges(_SIDES)

    def part(self, states: Sequence[State], towards: Floats) -> SpatialSolution | dict[str, Any]:
        """Return a leaf, or a point that obeys the relaxed law, or nearly.

        Args:
            towards: (m, 2), directions of friction that are likely to matter.
        """
        around = [[*self.base, *_near(*pair)] for pair in towards.tolist()]
        for _ in range(_CUTS):
            cones = [
                _outside(contact.friction, state, directions)
                for contact, state, directions in zip(self.grasp, states, around, strict=True)
            ]
            found = self._solve(states, cones)
            if not isinstance(found, SpatialSolution):
                return found
            cut = False
            for contact, force, directions in zip(self.grasp, found.forces, around, strict=True):
                normal, *friction = force
                if dot(friction, friction) > (contact.friction * normal) ** 2:
                    x, y = map(float, _scaled(friction))
                    new = {rational_direction(x, y, _LONG, 1.0), *_near(x, y)} - set(directions)
                    directions += [pair for pair in new if pair is not None]
                    cut = cut or bool(new)
            if not cut:
                break
        return found

    def equilibrium(self, states: States) -> SpatialSolution | None:
        """Return an equilibrium of given states, if there is one whose slips are rational."""
        ends: list[Ends] = []
        cones: list[list[ConeRow]] = []
        for i, contact in enumerate(self.grasp):
            share, mu = states.shares[i], contact.friction
            if not states.touching[i]:
                ends.append("detached")
                cones.append([])
            elif states.slipping[i] and share is not None and mu:
                ends.append((tuple(-x for x in share),))
                cones.append([(True, (-mu * share[j], j == 0, j == 1)) for j in range(2)])
            else:
                ends.append("stick" if mu else "attached")
                cones.append(_inside(mu, [*self.base, *_near(*states.ratio[i].tolist())]))
        found = self._solve(ends, cones)
        return found if isinstance(found, SpatialSolution) else None

    def _solve(
        self, states: Sequence[Ends], cones: Sequence[Sequence[ConeRow]]
    ) -> SpatialSolution | dict[str, Any]:
        found: Any = StateProgram(self.grasp, self.wrench, states, cones, self.deadline).solve()
        if not isinstance(found, tuple):
            leaf: dict[str, Any] = found
            return leaf
        forces = tuple(found[6 + 3 * i : 9 + 3 * i] for i in range(len(self.grasp)))
        return SpatialSolution(found[:6], forces)


def _near(x: float, y: float) -> list[RationalVector]:
    """Return the simple unit vector near a direction, if there is one."""
    found = rational_direction(x, y, _SIMPLE, 1.0) if x or y else None
    return [] if found is None else [found]


def _scaled(vector: Sequence[Fraction]) -> list[Fraction]:
    """Return a vector with numbers that floats have."""
    size = max(map(abs, vector))
    return [x / size for x in vector]


_NO_FRICTION: list[ConeRow] = [(True, (0, 1, 0)), (True, (0, 0, 1))]


def _outside(mu: Fraction, state: State, directions: Sequence[RationalVector]) -> list[ConeRow]:
    """Return conditions that all forces in the cone fulfil, and in a sector all of its slips."""
    if state == "detached":
        return []
    if not mu:
        return _NO_FRICTION
    rows: list[ConeRow] = [(False, (mu, -x, -y)) for x, y in directions]
    if isinstance(state, tuple):
        ends = np.array(state, dtype=float)
        ends /= np.hypot(ends[:, 0], ends[:, 1])[:, None]
        middle = [Fraction(x) for x in ends.sum(axis=0).tolist()]
        # Along the middle the arc is at least as long as at one of its ends.
        low = Fraction(float((ends @ ends.sum(axis=0)).min())) - _LESS
        rows.append((False, (-mu * low, *(-x for x in middle))))
    return rows


def _inside(mu: Fraction, corners: Sequence[RationalVector]) -> list[ConeRow]:
    """Return the conditions of the polygon of some unit vectors."""
    if not mu:
        return _NO_FRICTION
    order = sorted(set(corners), key=lambda pair: np.arctan2(float(pair[1]), float(pair[0])))
    rows: list[ConeRow] = []
    for (a, b), (c, d) in pairwise([*order, order[0]]):
        rows.append((False, (mu * (a * d - b * c), b - d, c - a)))
    return rows
