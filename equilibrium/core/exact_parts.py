"""Where floats end without an answer: parts of the tree and states of contacts, decided exactly.

Each is a linear program in the motion and a force at each contact: it gives a point, or the leaf
that closes it. The friction cones are linear conditions. For a "no" the round cones lie inside
polygons, and a corner that sticks out is cut off as often as it takes; for a "yes" they are
polygons inside. So what is decided on a boundary, where a float proves nothing, is decided if the
friction there has a rational direction.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np

from arrangement.numbers.exact import RationalVector, dot, to_text
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.programs import Infeasible, Program
from equilibrium.core.contacts import FloatContacts
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.effort import Effort
from equilibrium.model.rows import ContactRow, ContactRows
from equilibrium.model.solution import Solution

from .cones import Node, Pyramids, Slip, State
from .states import States, rational_direction

#: "undecided", "detached", "attached", "stick", or directions of slip: one, or a sector's two.
Ends: TypeAlias = str | tuple[Sequence[Fraction | int], ...]
#: Whether a combination of normal force and friction is 0, or at least 0.
ConeRow: TypeAlias = tuple[bool, tuple[Any, ...]]
#: Sides of the polygons at first.
_FIRST_SIDES = 8
#: How often corners that stick out are cut off.
_MAX_CUTS = 3
#: Denominators of half-angle tangents: of directions near the friction, and of cuts.
_NEAR_DENOMINATOR = 64
_CUT_DENOMINATOR = 2**20
#: What is taken off the least product of a middle direction with the arc of a sector.
_MIDDLE_ERROR = Fraction(1, 2**40)
#: Steps of the rows of a contact, for each unknown.
_ROW_STEPS = 200
#: Up to this sine of the angle a slip is along a direction.
_SAME_DIRECTION_SINE = 1e-6


class StateProgram:
    """The program of one node; for each row that is not a cone's, what it adds to a leaf.

    Args:
        cones: of each contact, the conditions on its forces besides that the normal one is at
            least 0; without friction there are none.
        effort: that is left.
    """

    def __init__(
        self,
        rows: ContactRows,
        wrench: RationalVector,
        states: Sequence[Ends],
        cones: Sequence[Sequence[ConeRow]],
        effort: Effort,
        max_displacement: Fraction | None = None,
    ) -> None:
        self.effort, self.max_displacement = effort, max_displacement
        # A detached contact has no unknown, one without friction only its normal force.
        self.n, self.frame = rows.n, 1 + rows.tangents
        self.places, self.size = list[slice](), self.n
        for contact, state in zip(rows, states, strict=True):
            count = 0 if state == "detached" else self.frame if contact.friction else 1
            self.places.append(slice(self.size, self.size + count))
            self.size += count
        self.equal: list[RationalVector] = []
        self.least: list[RationalVector] = []
        #: Contact and alpha, h, and what a leaf has of its displacements, of one of each row.
        self.parts: dict[tuple[bool, int], tuple[int, tuple[Any, ...]]] = {}
        balance = [[Fraction(0)] * self.size + [w] for w in wrench]
        for i, contact in enumerate(rows):
            wrenches = (contact.normal_wrench, *contact.tangential_wrenches)
            columns = range(self.size)[self.places[i]]
            for j, unit in zip(columns, wrenches, strict=False):
                for row, x in zip(balance, unit, strict=True):
                    row[j] = x
        self.equal += map(tuple, balance)
        for i, (contact, state, cone) in enumerate(zip(rows, states, cones, strict=True)):
            self._add_contact(i, contact, state, cone)

    def _row(self, i: int, motion: Sequence[Fraction], force: Sequence[Any], constant: Any) -> Any:
        place = self.places[i]
        row = [*motion, *[Fraction(0)] * (self.size - self.n), Fraction(constant)]
        row[place] = map(Fraction, force[: place.stop - place.start])
        return tuple(row)

    def _add(self, equal: bool, row: RationalVector, i: int, part: tuple[Any, ...]) -> None:
        rows = self.equal if equal else self.least
        self.parts[equal, len(rows)] = (i, part)
        rows.append(row)

    def _add_contact(
        self, i: int, contact: ContactRow, state: Ends, cone: Sequence[ConeRow]
    ) -> None:
        self.effort.check(_ROW_STEPS * self.size)
        zero, along = [Fraction(0)] * self.n, _units(self.frame - 1)
        none, first = (0,) * self.frame, (1, *[0] * (self.frame - 1))
        self._bound(i, contact)
        gap = [contact.stiffness * x for x in contact.normal_wrench]
        if state == "detached":
            self._add(False, self._row(i, gap, none, -contact.preload), i, first)
            return
        if state != "loose":
            row = self._row(i, gap, first, -contact.preload)
            self._add(state != "undecided", row, i, first)
        self.least.append(self._row(i, zero, first, 0))
        for equal, force in cone:
            (self.equal if equal else self.least).append(self._row(i, zero, force, 0))
        if isinstance(state, tuple):
            sides = _sides(state)
        else:
            sides = [(True, unit) for unit in along] if state == "stick" else []
        for equal, side in sides:
            moved = [dot(side, column) for column in zip(*contact.tangential_wrenches, strict=True)]
            self._add(equal, self._row(i, moved, none, 0), i, (0, *(-x for x in side)))

    def _bound(self, i: int, contact: ContactRow) -> None:
        """Add the conditions on the displacements of a contact point."""
        if self.max_displacement is None:
            return
        for j, row in enumerate((contact.normal_wrench, *contact.tangential_wrenches)):
            for sign in (1, -1):
                part = [0] * (2 * self.frame)
                part[self.frame + j] = sign
                moved = [-sign * x for x in row]
                whole = self._row(i, moved, (0,) * self.frame, self.max_displacement)
                self._add(False, whole, i, tuple(part))

    def solve(self) -> tuple[RationalVector, tuple[RationalVector, ...]] | Any:
        """Return the motion and all forces, or the leaf that shows there are none."""
        found = Program(self.size, self.least, self.equal, self.effort).point()
        if not isinstance(found, Infeasible):
            forces = (found[place] for place in self.places)
            missing = ((force, self.frame - len(force)) for force in forces)
            return found[: self.n], tuple((*f, *[Fraction(0)] * k) for f, k in missing)
        motion = [to_text(-x) for x in found.equality_multipliers[: self.n]]
        given: dict[int, list[Fraction]] = {}
        for (equal, k), (i, part) in self.parts.items():
            factor = (found.equality_multipliers if equal else found.inequality_multipliers)[k]
            if factor:
                row = given.setdefault(i, [Fraction(0)] * (2 * self.frame))
                whole = (*part, *[0] * (2 * self.frame - len(part)))
                given[i] = [x + factor * y for x, y in zip(row, whole, strict=True)]
        f = self.frame
        rows = {str(i): [to_text(x) for x in row[:f]] for i, row in given.items()}
        moved = {str(i): [to_text(x) for x in row[f:]] for i, row in given.items() if any(row[f:])}
        leaf: dict[str, Any] = {"virtual_motion": motion, "multipliers": rows}
        return {**leaf, "displacements": moved} if moved else leaf


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
        self.rows, self.wrench, self.effort = contacts.rows, wrench, effort
        self.max_displacement = max_displacement
        self.base = pyramid_edges(_FIRST_SIDES)

    def part(self, states: Sequence[State], towards: Floats) -> Solution | dict[str, Any]:
        """Return a leaf, or a point that obeys the relaxed law, or nearly.

        Args:
            towards: (m, 2), directions of friction that are likely to matter.
        """
        ends: list[Any] = list(states)
        around = [[*self.base, *_near(*pair)] for pair in towards.tolist()]
        for _ in range(_MAX_CUTS):
            cones = [
                _outside(contact.friction, state, directions)
                for contact, state, directions in zip(self.rows, states, around, strict=True)
            ]
            found = self._solve(ends, cones)
            if not isinstance(found, Solution):
                return found
            cut = False
            for contact, force, directions in zip(self.rows, found.forces, around, strict=True):
                normal, *friction = force
                if dot(friction, friction) > (contact.friction * normal) ** 2:
                    x, y = map(float, _scaled(friction))
                    cutting = rational_direction(x, y, _CUT_DENOMINATOR, 1.0)
                    new = {cutting, *_near(x, y)} - set(directions)
                    directions += [pair for pair in new if pair is not None]
                    cut = cut or bool(new)
            if not cut:
                break
        return found

    def equilibrium(self, states: States) -> Solution | None:
        """Return an equilibrium of given states, if there is one whose slips are rational."""
        ends: list[Ends] = []
        cones: list[list[ConeRow]] = []
        for i, contact in enumerate(self.rows):
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
        return found if isinstance(found, Solution) else None

    def _solve(
        self, states: Sequence[Ends], cones: Sequence[Sequence[ConeRow]]
    ) -> Solution | dict[str, Any]:
        question = self.rows, self.wrench, states, cones, self.effort, self.max_displacement
        found: Any = StateProgram(*question).solve()
        if not isinstance(found, tuple):
            leaf: dict[str, Any] = found
            return leaf
        return Solution(*found)


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

    def part(self, states: Sequence[State], towards: Floats) -> Solution | dict[str, Any]:
        """Return a leaf, or a point that obeys the relaxed law."""
        ends: list[Ends] = [s.ends if isinstance(s, Slip) else s for s in states]
        cones = [
            self._cone(contact.friction, state) if contact.friction else []
            for contact, state in zip(self.rows, states, strict=True)
        ]
        return self._solve(ends, cones)

    def holds(self, states: Sequence[State]) -> Solution | None:
        """Return an equilibrium with all states decided, if there is one."""
        found = self.part(states, np.zeros((0, 0)))
        return found if isinstance(found, Solution) else None

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

    def _cone(self, mu: Fraction, state: State) -> list[ConeRow]:
        """Return the conditions on the forces of a contact, (normal, friction)."""
        rows: list[ConeRow] = [
            (False, (mu * dot(normal, edge), *(-x for x in normal)))
            for normal, edge in zip(self.cones.normals, self.cones.edges, strict=True)
        ]
        if not isinstance(state, Slip):
            return rows
        if len(state.ends) == 1:
            # On the side of the polygon that is opposite.
            (end,) = state.ends
            return [*rows, (True, (mu * dot(end, state.edges[0]), *end))]
        (corner,) = state.edges
        return [*rows, *((True, (mu * corner[j], j == 0, j == 1)) for j in range(2))]


def _units(t: int) -> list[tuple[int, ...]]:
    """Return the axes of the tangents."""
    return [tuple(int(k == j) for k in range(t)) for j in range(t)]


def _sides(ends: tuple[Sequence[Any], ...]) -> list[tuple[bool, tuple[Any, ...]]]:
    """Return whether a product with the slip is 0, or at least 0, and its factor."""
    if len(ends) == 1:
        across = [(True, (-y, x)) for x, y in ends] if len(ends[0]) == 2 else []
        return [(False, tuple(ends[0])), *across]
    (x, y), (v, w) = ends
    return [(False, (-y, x)), (False, (w, -v))]


def _near(x: float, y: float) -> list[RationalVector]:
    """Return the simple unit vector near a direction, if there is one."""
    found = rational_direction(x, y, _NEAR_DENOMINATOR, 1.0) if x or y else None
    return [] if found is None else [found]


def _scaled(vector: Sequence[Fraction]) -> list[Fraction]:
    """Return a vector with numbers that floats have."""
    size = max(map(abs, vector))
    return [x / size for x in vector]


def _outside(mu: Fraction, state: State, directions: Sequence[RationalVector]) -> list[ConeRow]:
    """Return conditions that all forces in the cone fulfil, and in a sector all of its slips."""
    if state == "detached" or not mu:
        return []
    rows: list[ConeRow] = [(False, (mu, -x, -y)) for x, y in directions]
    if isinstance(state, tuple):
        ends = np.array(state, dtype=float)
        ends /= np.hypot(ends[:, 0], ends[:, 1])[:, None]
        middle = [Fraction(x) for x in ends.sum(axis=0).tolist()]
        # Along the middle the arc is at least as long as at one of its ends.
        low = Fraction(float((ends @ ends.sum(axis=0)).min())) - _MIDDLE_ERROR
        rows.append((False, (-mu * low, *(-x for x in middle))))
    return rows


def _inside(mu: Fraction, corners: Sequence[RationalVector]) -> list[ConeRow]:
    """Return the conditions of the polygon of some unit vectors."""
    if not mu:
        return []
    order = sorted(set(corners), key=lambda pair: np.arctan2(float(pair[1]), float(pair[0])))
    rows: list[ConeRow] = []
    for (a, b), (c, d) in pairwise([*order, order[0]]):
        rows.append((False, (mu * (a * d - b * c), b - d, c - a)))
    return rows
