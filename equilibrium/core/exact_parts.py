"""Where floats end without an answer: parts of the tree and states of contacts, decided exactly.

Each is a linear program in the motion and a force at each contact: it gives a point, or the leaf
that closes it. The friction cones are linear conditions. For a "no" the round cones lie inside
polygons, and a corner that sticks out is cut off as often as it takes; for a "yes" they are
polygons inside. So what is decided on a boundary, where a float proves nothing, is decided if the
friction there has a rational direction.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.float_filter import Floats
from equilibrium.core.contact_law import ContactState, LinearQuestion, Side, State
from equilibrium.core.contact_program import ContactProgram
from equilibrium.core.contacts import FloatContacts
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.effort import Effort
from equilibrium.model.rows import ContactRow
from equilibrium.model.solution import Leaf, Solution

from .cones import Node, Pyramids, RoundCones, Slip, State as TreeState, slip_sides
from .states import StateBalance, States, rational_direction

#: Sides of the polygons at first.
_FIRST_SIDES = 8
#: How often corners that stick out are cut off.
_MAX_CUTS = 3
#: Denominators of half-angle tangents: of directions near the friction, and of cuts.
_NEAR_DENOMINATOR = 64
_CUT_DENOMINATOR = 2**20
#: Motions and forces that balance leaves open are multiples of one over this.
_OPEN_DENOMINATOR = 2**10
#: Steps of the rows of a contact, for each unknown.
_ROW_STEPS = 200
#: Up to this sine of the angle a slip is along a direction.
_SAME_DIRECTION_SINE = 1e-6


class ExactParts:
    """The exact programs of one question.

    Args:
        effort: that is left; `TimeoutError` is raised when none is.
    """

    def __init__(
        self,
        contacts: FloatContacts,
        wrench: RationalVector,
        effort: Effort,
        max_displacement: Fraction | None = None,
    ) -> None:
        self.rows, self.effort = contacts.rows, effort
        # Adhesion is a part of the load here.
        rows = replace(
            self.rows, contacts=tuple(c._replace(adhesion=Fraction(0)) for c in self.rows)
        )
        self.question = LinearQuestion(rows, wrench, max_displacement=max_displacement)
        self.base = pyramid_edges(_FIRST_SIDES)

    def part(self, states: Sequence[TreeState], towards: Floats) -> Solution | Leaf:
        """Return a leaf, or a point that obeys the relaxed law, or nearly.

        Args:
            towards: (m, 2), directions of friction that are likely to matter.
        """
        around = [[*self.base, *_near(*pair)] for pair in towards.tolist()]
        for _ in range(_MAX_CUTS):
            outcome = self._solve(list(map(_outside, self.rows, states, around)))
            if not isinstance(outcome, Solution):
                return outcome
            cut = False
            for contact, force, directions in zip(self.rows, outcome.forces, around, strict=True):
                normal, *friction = force
                if dot(friction, friction) > (contact.friction * normal) ** 2:
                    x, y = map(float, _scaled(friction))
                    cutting = rational_direction(x, y, _CUT_DENOMINATOR, 1.0)
                    new = {cutting, *_near(x, y)} - set(directions)
                    directions += [pair for pair in new if pair is not None]
                    cut = cut or bool(new)
            if not cut:
                break
        return outcome

    def equilibrium(self, states: States) -> Solution | None:
        """Return an equilibrium of given states, if there is one whose slips are rational."""

        def stick(i: int, mu: Fraction) -> State:
            corners = [*self.base, *_near(*states.ratio[i].tolist())]
            return ContactState.of("stick", 2, _inside(mu, corners))

        outcome = self._solve(self._decided(states, stick))
        return outcome if isinstance(outcome, Solution) else None

    def balanced(self, balance: StateBalance, motions: Iterable[Floats]) -> Iterator[Solution]:
        """Yield motions and forces that balance in given states with rational slips.

        Contacts that stick have shares of their limits, but for pillars. What the equations leave
        open is that of the motions, rounded.
        """
        states, pillars = balance.states, {i for i, _ in balance.pillars}

        def stick(i: int, _: Fraction) -> State:
            share = None if i in pillars else states.shares[i]
            return ContactState.of("stick", 2)._replace(share=share)

        program = ContactProgram(self.question, tuple(self._decided(states, stick)))
        forces = [float(states.forces[i, 1 + j]) for _, i, j in program.unknowns]
        for motion in motions:
            near = [round(_OPEN_DENOMINATOR * x) for x in (*motion.tolist(), *forces)]
            point = program.completed([Fraction(x, _OPEN_DENOMINATOR) for x in near])
            if point is None:
                return
            yield program.at(program.values(point))

    def _decided(self, states: States, stick: Callable[[int, Fraction], State]) -> list[State]:
        """Return the conditions of given states, with those of contacts that stick."""
        decided: list[State] = []
        for i, contact in enumerate(self.rows):
            share, mu = states.shares[i], contact.friction
            if not states.touching[i]:
                decided.append("detached")
            elif states.slipping[i] and share is not None and mu:
                along = tuple(-x for x in share)
                decided.append(ContactState("attached", slip_sides((along,)), share=share))
            elif mu:
                decided.append(stick(i, mu))
            else:
                decided.append("attached")
        return decided

    def _solve(self, states: Sequence[State]) -> Solution | Leaf:
        """Return the motion and all forces of a program, or the leaf that shows there are none."""
        m = len(states)
        self.effort.check(_ROW_STEPS * m * (self.rows.n + (1 + self.rows.tangents) * m))
        program = ContactProgram(self.question, tuple(states), self.effort)
        return program.solution() or self._leaf(program.leaf())

    @staticmethod
    def _leaf(leaf: Any) -> Leaf:
        """Return a leaf without contacts that have no multipliers."""
        moved = {i: row for i, row in leaf.displacements.items() if any(row)}
        rows = {i: row for i, row in leaf.multipliers.items() if any(row) or i in moved}
        return Leaf(leaf.motion, rows, moved)


class PyramidParts(ExactParts):
    """The same with pyramids, of which states and their programs are the law itself."""

    def __init__(
        self,
        contacts: FloatContacts,
        wrench: RationalVector,
        effort: Effort,
        cones: Pyramids,
        max_displacement: Fraction | None = None,
    ) -> None:
        super().__init__(contacts, wrench, effort, max_displacement)
        self.cones = cones

    def part(self, states: Sequence[TreeState], towards: Floats) -> Solution | Leaf:
        """Return a leaf, or a point that obeys the relaxed law."""
        pairs = zip(self.rows, states, strict=True)
        in_conditions = self.cones.in_conditions
        return self._solve([in_conditions(contact.friction, state) for contact, state in pairs])

    def holds(self, states: Sequence[TreeState]) -> Solution | None:
        """Return an equilibrium with all states decided, if there is one."""
        outcome = self.part(states, np.zeros((0, 0)))
        return outcome if isinstance(outcome, Solution) else None

    def near(self, normal: Floats, slips: Floats) -> Node:
        """Return the states of normal forces and slips in floats, 0 where there is none."""
        return tuple(
            "detached"
            if not force > 0
            else "attached"
            if not contact.friction
            else self._slip(slip)
            if slip.any()
            else "stick"
            for contact, force, slip in zip(self.rows, normal.tolist(), slips, strict=True)
        )

    def _slip(self, slip: Floats) -> Slip:
        """Return the slip in a direction: along the normal of a side, or between two."""
        for part in self.cones.all:
            ends = np.array(part.ends, dtype=float)
            if len(slip) == 1:
                if ends[0, 0] * slip[0] > 0:
                    return part
                continue
            sines = (ends[:, 0] * slip[1] - ends[:, 1] * slip[0]) / np.hypot(*slip)
            if (ends @ slip > 0).all() and (
                abs(sines[0]) < _SAME_DIRECTION_SINE if len(ends) == 1 else sines[0] > 0 > sines[1]
            ):
                return part
        raise AssertionError("the sectors of a pyramid cover all directions")


def _near(x: float, y: float) -> list[RationalVector]:
    """Return the simple unit vector near a direction, if there is one."""
    direction = rational_direction(x, y, _NEAR_DENOMINATOR, 1.0) if x or y else None
    return [] if direction is None else [direction]


def _scaled(vector: Sequence[Fraction]) -> list[Fraction]:
    """Return a vector with numbers that floats have."""
    size = max(map(abs, vector))
    return [x / size for x in vector]


def _outside(contact: ContactRow, state: TreeState, directions: Sequence[RationalVector]) -> State:
    """Return a state with conditions that all forces in the cone fulfil."""
    around = [(False, (contact.friction, -x, -y)) for x, y in directions]
    return RoundCones().in_conditions(contact.friction, state, around)


def _inside(mu: Fraction, corners: Sequence[RationalVector]) -> tuple[Side, ...]:
    """Return the conditions of the polygon of some unit vectors."""
    order = sorted(set(corners), key=lambda pair: np.arctan2(float(pair[1]), float(pair[0])))
    return tuple(
        (False, (mu * (a * d - b * c), b - d, c - a))
        for (a, b), (c, d) in pairwise([*order, order[0]])
    )
