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
            least 0.
        deadline: of `time.monotonic`.
    """

    def __init__(
        self,
        grasp: Grasp,
        wrench: RationalVector,
        states: Sequence[Ends],
        cones: Sequence[Sequence[ConeRow]],
        deadline: float,
    ) -> None:
        self.deadline, self.m, self.size = deadline, len(grasp), 6 + 3 * len(grasp)
        self.equal: list[RationalVector] = []
        self.least: list[RationalVector] = []
        #: Contact and (alpha, h) of one of each row.
        self.parts: dict[tuple[bool, int], tuple[int, tuple[Any, ...]]] = {}
        rows = [[Fraction(0)] * self.size + [w] for w in wrench]
        for i, contact in enumerate(grasp):
            wrenches = (contact.normal_wrench, *contact.tangential_wrenches)
            for j, unit in enumerate(wrenches):
                for row, x in zip(rows, unit, strict=True):
                    row[6 + 3 * i + j] = x
        self.equal += map(tuple, rows)
        for i, (contact, state, cone) in enumerate(zip(grasp, states, cones, strict=True)):
            self._add_contact(i, contact, state, cone)

    def _row(self, i: int, motion: Sequence[Fraction], force: Sequence[Any], constant: Any) -> Any:
        row = [*motion, *[Fraction(0)] * (3 * self.m), Fraction(constant)]
        row[6 + 3 * i : 9 + 3 * i] = map(Fraction, force)
        return tuple(row)

    def _add(self, equal: bool, row: RationalVector, i: int, part: tuple[Any, ...]) -> None:
        rows = self.equal if equal else self.least
        self.parts[equal, len(rows)] = (i, part)
        rows.append(row)

    def _add_contact(self, i: int, contact: Contact, state: Ends, cone: Sequence[ConeRow]) -> None:
        if time.monotonic() > self.deadline:
            raise TimeoutError("the time is over")
        zero = [Fraction(0)] * 6
        gap = [contact.stiffness * x for x in contact.normal_wrench]
        if state == "detached":
            self._add(False, self._row(i, gap, (0, 0, 0), -contact.preload), i, (1, 0, 0))
            self.equal += [self._row(i, zero, [j == k for j in range(3)], 0) for k in range(3)]
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

    def solve(self) -> RationalVector | Any:
        """Return a point, or the leaf that shows that there is none."""
        found = Program(self.size, self.least, self.equal, self.deadline).point()
        if not isinstance(found, Infeasible):
            return found
        motion = [to_text(-x) for x in found.equality_multipliers[:6]]
        given: dict[int, list[Fraction]] = {}
        for (equal, k), (i, part) in self.parts.items():
            factor = (found.equality_multipliers if equal else found.inequality_multipliers)[k]
            if factor:
                row = given.setdefault(i, [Fraction(0)] * 3)
                given[i] = [x + factor * y for x, y in zip(row, part, strict=True)]
        rows = {str(i): [to_text(x) for x in row] for i, row in given.items()}
        return {"virtual_motion": motion, "multipliers": rows}
