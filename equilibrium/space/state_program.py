"""The exact linear program of one choice of states in space: a point, or the leaf that closes it.

Unknowns are the motion and a force at each contact. The friction cones are linear conditions that
whoever asks gives: pyramids, or polygons inside or around round cones.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.numbers.exact import RationalVector, to_text
from arrangement.numbers.linear.programs import Infeasible, Program
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp

#: "undecided", "detached", "attached", "stick", or directions of slip: one, or a sector's two.
Ends: TypeAlias = str | tuple[Sequence[Fraction | int], ...]
#: Whether a combination of normal force and friction is 0, or at least 0.
ConeRow: TypeAlias = tuple[bool, tuple[Any, ...]]


class StateProgram:
    """The program of one node; for each row that is no cone's, what it adds to a leaf.

    Args:
        cones: of each contact, the conditions on its forces besides that the normal one is at
            least 0; without friction there are none.
        deadline: of `time.process_time`.
    """

    def __init__(
        self,
        grasp: Grasp,
        wrench: RationalVector,
        states: Sequence[Ends],
        cones: Sequence[Sequence[ConeRow]],
        deadline: float,
    ) -> None:
        self.deadline = deadline
        # A detached contact has no unknown, one without friction only its normal force.
        self.places, self.size = list[slice](), 6
        for contact, state in zip(grasp, states, strict=True):
            count = 0 if state == "detached" else 3 if contact.friction else 1
            self.places.append(slice(self.size, self.size + count))
            self.size += count
        self.equal: list[RationalVector] = []
        self.least: list[RationalVector] = []
        #: Contact and (alpha, h) of one of each row.
        self.parts: dict[tuple[bool, int], tuple[int, tuple[Any, ...]]] = {}
        rows = [[Fraction(0)] * self.size + [w] for w in wrench]
        for i, contact in enumerate(grasp):
            wrenches = (contact.normal_wrench, *contact.tangential_wrenches)
            columns = range(self.size)[self.places[i]]
            for j, unit in zip(columns, wrenches, strict=False):
                for row, x in zip(rows, unit, strict=True):
                    row[j] = x
        self.equal += map(tuple, rows)
        for i, (contact, state, cone) in enumerate(zip(grasp, states, cones, strict=True)):
            self._add_contact(i, contact, state, cone)

    def _row(self, i: int, motion: Sequence[Fraction], force: Sequence[Any], constant: Any) -> Any:
        place = self.places[i]
        row = [*motion, *[Fraction(0)] * (self.size - 6), Fraction(constant)]
        row[place] = map(Fraction, force[: place.stop - place.start])
        return tuple(row)

    def _add(self, equal: bool, row: RationalVector, i: int, part: tuple[Any, ...]) -> None:
        rows = self.equal if equal else self.least
        self.parts[equal, len(rows)] = (i, part)
        rows.append(row)

    def _add_contact(self, i: int, contact: Contact, state: Ends, cone: Sequence[ConeRow]) -> None:
        if time.process_time() > self.deadline:
            raise TimeoutError("the time is over")
        zero = [Fraction(0)] * 6
        gap = [contact.stiffness * x for x in contact.normal_wrench]
        if state == "detached":
            self._add(False, self._row(i, gap, (0, 0, 0), -contact.preload), i, (1, 0, 0))
            return
        row = self._row(i, gap, (1, 0, 0), -contact.preload)
        self._add(state != "undecided", row, i, (1, 0, 0))
        self.least.append(self._row(i, zero, (1, 0, 0), 0))
        for equal, force in cone:
            (self.equal if equal else self.least).append(self._row(i, zero, force, 0))
        one, other = contact.tangential_wrenches
        if isinstance(state, tuple):
            if len(state) == 1:
                ((x, y),) = state
                sides: list[tuple[bool, tuple[Any, Any]]] = [(False, (x, y)), (True, (-y, x))]
            else:
                (x, y), (v, w) = state
                sides = [(False, (-y, x)), (False, (w, -v))]
        else:
            sides = [(True, (1, 0)), (True, (0, 1))] if state == "stick" else []
        for equal, (x, y) in sides:
            moved = [x * s + y * t for s, t in zip(one, other, strict=True)]
            self._add(equal, self._row(i, moved, (0, 0, 0), 0), i, (0, -x, -y))

    def solve(self) -> tuple[RationalVector, tuple[RationalVector, ...]] | Any:
        """Return the motion and all forces, three each, or the leaf that shows there are none."""
        found = Program(self.size, self.least, self.equal, self.deadline).point()
        if not isinstance(found, Infeasible):
            forces = (found[place] for place in self.places)
            return found[:6], tuple((*force, *[Fraction(0)] * (3 - len(force))) for force in forces)
        motion = [to_text(-x) for x in found.equality_multipliers[:6]]
        given: dict[int, list[Fraction]] = {}
        for (equal, k), (i, part) in self.parts.items():
            factor = (found.equality_multipliers if equal else found.inequality_multipliers)[k]
            if factor:
                row = given.setdefault(i, [Fraction(0)] * 3)
                given[i] = [x + factor * y for x, y in zip(row, part, strict=True)]
        rows = {str(i): [to_text(x) for x in row] for i, row in given.items()}
        return {"virtual_motion": motion, "multipliers": rows}
