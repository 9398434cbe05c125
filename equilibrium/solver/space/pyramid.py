"""The decision in space with friction pyramids: states split, exact linear programs, no floats.

With a polygon in place of the disc the law is piecewise linear. A contact that slips does so along
the normal of a side of the polygon, with friction anywhere on the opposite side, or between two
such normals, with friction at the opposite corner. With all states decided the relaxation of a node
is the law, so the search ends.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

from arrangement.exact import RationalVector, dot, to_text
from arrangement.linprog import Infeasible, Program
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp

from .equilibria import SpatialSolution
from .tree import Open


class Slip(NamedTuple):
    """Directions of slip: along the only one, or between two; and the edges friction may use."""

    ends: tuple[RationalVector, ...]
    edges: tuple[RationalVector, ...]


_State: TypeAlias = str | Slip


class PyramidSearch:
    """The search for one question.

    Args:
        edges: of the pyramids, in the frames of tangents.
        deadline: of `time.monotonic`.
    """

    def __init__(
        self,
        grasp: Grasp,
        wrench: RationalVector,
        edges: Sequence[RationalVector],
        deadline: float,
    ) -> None:
        self.grasp, self.wrench, self.edges, self.deadline = grasp, wrench, edges, deadline
        self.size = 6 + 3 * len(grasp)
        self.normals = [
            tuple(x + y for x, y in zip(*pair, strict=True))
            for pair in pairwise((*edges, edges[0]))
        ]
        self.slips = []
        for j, normal in enumerate(self.normals):
            k = (j + 1) % len(edges)
            self.slips.append(Slip((normal,), (edges[j], edges[k])))
            self.slips.append(Slip((normal, self.normals[k]), (edges[k],)))

    def decide(self) -> SpatialSolution | Any | Open:
        """Return an equilibrium, a tree that refutes all, or what is open when the time is over."""
        top: list[Any] = [None]
        waiting: list[tuple[list[_State], list[Any], int]]
        waiting = [(["undecided"] * len(self.grasp), top, 0)]
        nodes = 0
        while waiting:
            states, parent, position = waiting.pop()
            try:
                found = _Node(self, states).solve()
            except TimeoutError:
                return Open(f"the time is over after {nodes} nodes", 1.0)
            nodes += 1
            if not isinstance(found, tuple):
                parent[position] = found
                continue
            worst = self._worst(states, found)
            if worst is None:
                return self._solution(found)
            split: list[_State] = ["detached", "attached"]
            key = "attachment"
            if states[worst] == "attached":
                split, key = ["stick", *self.slips], "faces"
            children: list[Any] = [None] * len(split)
            parent[position] = {"contact": worst, key: children}
            parts = [[*states[:worst], state, *states[worst + 1 :]] for state in split]
            waiting += reversed([(part, children, k) for k, part in enumerate(parts)])
        return _named(top[0])

    def _worst(self, states: Sequence[_State], point: RationalVector) -> int | None:
        """Return the contact that is furthest from the law at a point; None if all obey it."""
        worst, most = None, Fraction(0)
        for i, (contact, state) in enumerate(zip(self.grasp, states, strict=True)):
            if state not in ("undecided", "attached"):
                continue
            normal, *friction = point[6 + 3 * i : 9 + 3 * i]
            along = dot(contact.normal_wrench, point[:6])
            value = normal - max(Fraction(0), contact.preload - contact.stiffness * along)
            slip = [dot(row, point[:6]) for row in contact.tangential_wrenches]
            reach = max(dot(edge, slip) for edge in self.edges)
            value += contact.friction * normal * reach + dot(friction, slip)
            if value > most:
                worst, most = i, value
        return worst

    def _solution(self, point: RationalVector) -> SpatialSolution:
        forces = (point[6 + 3 * i : 9 + 3 * i] for i in range(len(self.grasp)))
        return SpatialSolution(point[:6], tuple(forces))


class _Node:
    """The linear program of one node; for each row that is no cone's, what it adds to a leaf."""

    def __init__(self, search: PyramidSearch, states: Sequence[_State]) -> None:
        self.search, self.m = search, len(states)
        self.equal: list[RationalVector] = []
        self.least: list[RationalVector] = []
        #: Contact and (alpha, h) of one of each row.
        self.parts: dict[tuple[bool, int], tuple[int, tuple[Fraction | int, ...]]] = {}
        rows = [[Fraction(0)] * search.size + [w] for w in search.wrench]
        for i, contact in enumerate(search.grasp):
            wrenches = (contact.normal_wrench, *contact.tangential_wrenches)
            for j, wrench in enumerate(wrenches):
                for row, x in zip(rows, wrench, strict=True):
                    row[6 + 3 * i + j] = x
        self.equal += map(tuple, rows)
        for i, (contact, state) in enumerate(zip(search.grasp, states, strict=True)):
            self._add_contact(i, contact, state)

    def _row(self, i: int, motion: Sequence[Fraction], force: Sequence[Any], constant: Any) -> Any:
        row = [*motion, *[Fraction(0)] * (3 * self.m), Fraction(constant)]
        row[6 + 3 * i : 9 + 3 * i] = map(Fraction, force)
        return tuple(row)

    def _add(
        self, equal: bool, row: RationalVector, i: int, part: tuple[Fraction | int, ...]
    ) -> None:
        rows = self.equal if equal else self.least
        self.parts[equal, len(rows)] = (i, part)
        rows.append(row)

    def _add_contact(self, i: int, contact: Contact, state: _State) -> None:
        if time.monotonic() > self.search.deadline:
            raise TimeoutError
        zero = [Fraction(0)] * 6
        gap = [contact.stiffness * x for x in contact.normal_wrench]
        if state == "detached":
            self._add(False, self._row(i, gap, (0, 0, 0), -contact.preload), i, (1, 0, 0))
            self.equal += [self._row(i, zero, [j == k for j in range(3)], 0) for k in range(3)]
            return
        row = self._row(i, gap, (1, 0, 0), -contact.preload)
        self._add(state != "undecided", row, i, (1, 0, 0))
        self.least.append(self._row(i, zero, (1, 0, 0), 0))
        mu, one, other = contact.friction, *contact.tangential_wrenches
        for normal, edge in zip(self.search.normals, self.search.edges, strict=True):
            limit = mu * dot(normal, edge)
            self.least.append(self._row(i, zero, (limit, *(-x for x in normal)), 0))
        if state == "stick":
            self._add(True, self._row(i, one, (0, 0, 0), 0), i, (0, -1, 0))
            self._add(True, self._row(i, other, (0, 0, 0), 0), i, (0, 0, -1))
        if not isinstance(state, Slip):
            return
        if len(state.ends) == 1:
            ((x, y),) = state.ends
            sides = [(False, (x, y)), (True, (-y, x))]
            # On the side of the polygon that is opposite.
            face = (mu * dot(state.ends[0], state.edges[0]), x, y)
            self.equal.append(self._row(i, zero, face, 0))
        else:
            (x, y), (v, w) = state.ends
            sides = [(False, (-y, x)), (False, (w, -v))]
            (corner,) = state.edges
            for j in range(2):
                force = (mu * corner[j], j == 0, j == 1)
                self.equal.append(self._row(i, zero, force, 0))
        for equal, (x, y) in sides:
            moved = [x * s + y * t for s, t in zip(one, other, strict=True)]
            self._add(equal, self._row(i, moved, (0, 0, 0), 0), i, (0, -x, -y))

    def solve(self) -> RationalVector | Any:
        """Return a point, or the leaf that shows that there is none."""
        found = Program(self.search.size, self.least, self.equal, self.search.deadline).point()
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


def _named(node: Any) -> Any:
    """Return a tree in the form of certificates."""
    if "attachment" in node:
        detached, attached = map(_named, node["attachment"])
        return {**node, "attachment": {"detached": detached, "attached": attached}}
    return {**node, "faces": list(map(_named, node["faces"]))} if "faces" in node else node
