"""The decision in space with friction pyramids: states split, exact linear programs, no floats.

With a polygon in place of the disc the law is piecewise linear. A contact that slips does so along
the normal of a side of the polygon, with friction anywhere on the opposite side, or between two
such normals, with friction at the opposite corner. With all states decided the relaxation of a node
is the law, so the search ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from arrangement.numbers.exact import RationalVector, dot
from equilibrium.model.grasp import Grasp
from equilibrium.plane.contacts import SpatialContacts

from .balance import SpatialContinuation
from .equilibria import SpatialSolution
from .state_program import ConeRow, StateProgram
from .states import States, smooth_states
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
        try:
            near = self._near()
        except TimeoutError:
            return Open("the time is over after 0 nodes", 1.0)
        if near is not None:
            return near
        top: list[Any] = [None]
        waiting: list[tuple[list[_State], list[Any], int]]
        waiting = [(["undecided"] * len(self.grasp), top, 0)]
        nodes = 0
        while waiting:
            states, parent, position = waiting.pop()
            try:
                found = self._program(states).solve()
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

    def _near(self) -> SpatialSolution | None:
        """Return an equilibrium with states that a search with round cones suggests."""
        contacts = SpatialContacts(self.grasp)
        tried: set[object] = set()
        with np.errstate(all="ignore"):
            path = SpatialContinuation(contacts, self.wrench).path(np.zeros(6))
            for states in (smooth_states(contacts, *found) for found in path):
                if states.key not in tried:
                    tried.add(states.key)
                    parts = [self._part(states, i) for i in range(len(self.grasp))]
                    found = self._program(parts).solve()
                    if isinstance(found, tuple):
                        return self._solution(found)
        return None

    def _part(self, states: States, i: int) -> _State:
        """Return what a contact does according to states with round cones."""
        if not states.touching[i]:
            return "detached"
        if not states.slipping[i]:
            return "stick" if self.grasp.contacts[i].friction else "attached"
        slip = [Fraction(-float(x)) for x in states.ratio[i]]
        between = [part for part in self.slips if len(part.ends) == 2]
        return max(between, key=lambda part: dot(part.edges[0], slip))

    def _program(self, states: Sequence[_State]) -> StateProgram:
        """Return the program of a node."""
        cones = [
            [] if state == "detached" else self._cone(contact.friction, state)
            for contact, state in zip(self.grasp, states, strict=True)
        ]
        ends = [state.ends if isinstance(state, Slip) else state for state in states]
        return StateProgram(self.grasp, self.wrench, ends, cones, self.deadline)

    def _cone(self, mu: Fraction, state: _State) -> list[ConeRow]:
        """Return the conditions on the forces of a contact, (normal, friction)."""
        rows: list[ConeRow] = [
            (False, (mu * dot(normal, edge), *(-x for x in normal)))
            for normal, edge in zip(self.normals, self.edges, strict=True)
        ]
        if not isinstance(state, Slip):
            return rows
        if len(state.ends) == 1:
            # On the side of the polygon that is opposite.
            (end,) = state.ends
            return [*rows, (True, (mu * dot(end, state.edges[0]), *end))]
        (corner,) = state.edges
        return [*rows, *((True, (mu * corner[j], j == 0, j == 1)) for j in range(2))]

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


def _named(node: Any) -> Any:
    """Return a tree in the form of certificates."""
    if "attachment" in node:
        detached, attached = map(_named, node["attachment"])
        return {**node, "attachment": {"detached": detached, "attached": attached}}
    return {**node, "faces": list(map(_named, node["faces"]))} if "faces" in node else node
