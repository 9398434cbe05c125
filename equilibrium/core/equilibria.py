"""Equilibria in space near motions in floats: exact ones, and boxes that may hold one.

The states of contacts are read off a motion of the smoothed balance. Where all friction forces are
known shares of their limits (no contact slips, or along rational directions), balance is linear and
solved exactly. Else a small box is put around what Newton's method finds (`enclosures`). Both are
proposals, which `equilibrium.certificate` checks.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.model.effort import Effort
from equilibrium.model.solution import Solution

from .cones import Node, Pyramids, lengths
from .continuation import Continuation
from .enclosures import enclosures
from .exact_parts import ExactParts, PyramidParts
from .relaxation import Point, Relaxation
from .states import StateBalance, States, rubbing_states


@dataclass(frozen=True)
class EquilibriumSettings:
    """What bounds and steers the search for equilibria near motions in floats."""

    #: Larger frictions are huge: a path is followed first with this one in their place.
    huge_friction: float = 100.0
    #: Forces of a relaxation, in its units, up to which a contact is detached, or does not slip.
    force_tolerance: float = 1e-6
    #: The same at fixed points of Tresca friction, and how close to a limit friction may be.
    tresca_tolerance: float = 1e-5
    #: Motions that agree to one over this lead to the same equilibrium, mostly.
    same_motion_denominator: int = 8
    #: Steps that are counted for one sharpness of a path, see `Effort`.
    path_steps: int = 40_000
    #: Steps that are counted for the proposals of one choice of states.
    proposal_steps: int = 20_000
    #: The same for each contact.
    proposal_steps_per_contact: int = 5000


SETTINGS = EquilibriumSettings()


class EquilibriumSearch:
    """Accepted equilibria of one question, from motions in floats and from visited states.

    Args:
        relaxation: of the question; its contacts and cones are used.
        accept: whether a proposal is proved to be an equilibrium.
        effort: that is left; `TimeoutError` is raised when none is.

    Attributes:
        smooth: the smoothed balance.
        exact: the exact programs.
        residual: of the motion that is closest to an equilibrium, as a share of the forces.
    """

    def __init__(
        self,
        relaxation: Relaxation,
        wrench: RationalVector,
        accept: Callable[[Solution], bool],
        effort: Effort,
        max_displacement: Fraction | None,
    ) -> None:
        contacts, cones = relaxation.contacts, relaxation.cones
        self.relaxation, self.contacts, self.wrench = relaxation, contacts, wrench
        self.accept, self.effort = accept, effort
        self.smooth = relaxation.smooth
        #: The last as given; before it one of smaller frictions, if some are huge.
        self._paths = [(contacts, self.smooth)]
        if contacts.friction.max(initial=0.0) > SETTINGS.huge_friction:
            less = copy.copy(contacts)
            less.friction = np.minimum(contacts.friction, SETTINGS.huge_friction)
            self._paths.insert(0, (less, Continuation(less, wrench, cones)))
        self.exact: ExactParts | PyramidParts
        if isinstance(cones, Pyramids):
            self.exact = PyramidParts(contacts, wrench, effort, cones, max_displacement)
        else:
            self.exact = ExactParts(contacts, wrench, effort, max_displacement)
        self.residual = 1.0
        #: States whose equilibria were looked for near a motion, the latest last.
        self._visited: list[States] = []
        self._tried: set[object] = set()

    def near_motion(self, motion: Floats, sharpness: float) -> Solution | None:
        """Return an equilibrium that the smoothed balance leads to from a motion."""
        for contacts, path in self._paths:
            for end, eps in path.path(motion, sharpness):
                self.effort.check(SETTINGS.path_steps)
                if isinstance(self.exact, PyramidParts):
                    solution = self._at_smooth_pyramids(self.exact, end, eps)
                else:
                    force, share, _ = path.balance.forces(end, eps)
                    states = States(contacts, force[:, 0], np.nan_to_num(share))
                    solution = self._with_states(end, states)
                    solution = solution or self._rubbing(end, states.forces, states.slipping)
                if solution is not None:
                    return solution
        self.residual = min(self.residual, self.smooth.reached / (self.smooth.size or 1.0))
        return None

    def with_states_of(self, point: Point) -> Solution | None:
        """Return an equilibrium with the states of a relaxation that nearly obeys the law."""
        normal, none = point.forces[:, 0], SETTINGS.force_tolerance
        normal = np.where(normal * np.maximum(1.0, self.contacts.friction) > none, normal, 0.0)
        if isinstance(self.exact, PyramidParts):
            slips = self.relaxation.slips(point.motion)
            still = self.relaxation.stiffness * lengths(slips) <= none
            slips = np.where(still[:, None], 0.0, slips)
            return self._of_pyramids(self.exact, self.exact.near(normal, slips))
        limits = np.maximum(self.contacts.friction * normal, 1e-12)
        states = States(self.contacts, normal, point.forces[:, 1:] / limits[:, None])
        motion = point.motion * self.relaxation.scale
        near = self._with_states(motion, states)
        return near or self._rubbing(motion, point.forces * self.relaxation.force, states.slipping)

    def at_fixed_limits(self) -> Solution | Node | None:
        """Return an equilibrium with the states at a fixed point of Tresca friction, if reached.

        If there is none, but contacts close to a change of state, return states with these open.
        """
        if not isinstance(self.exact, PyramidParts) or self.contacts.rows.tangents != 1:
            return None
        point = self.relaxation.at_fixed_limits()
        if point is None:
            return None
        r, near, friction = self.relaxation, SETTINGS.tresca_tolerance, self.contacts.friction
        spring = r.spring_forces(point.motion)
        normal = np.where(spring > near, point.forces[:, 0], 0.0)
        slips = r.slips(point.motion)
        still = r.stiffness * lengths(slips) <= near
        sticks = np.abs(point.forces[:, 1]) < friction * normal - near
        states = self.exact.near(normal, np.where(still[:, None], 0.0, slips))
        self.effort.check(SETTINGS.proposal_steps * len(states))
        solution = self._of_pyramids(self.exact, states)
        open_ = [
            "undecided" if grazes else "attached" if state == "stick" and not sure else state
            for state, grazes, sure in zip(states, np.abs(spring) <= near, sticks, strict=True)
        ]
        return solution or (None if tuple(open_) == states else tuple(open_))

    def in_visited_states(self) -> Solution | None:
        """Return an equilibrium, by exact programs, of states visited since the last call."""
        visited, self._visited = self._visited, []
        for states in reversed(visited):
            if states.kind in self._tried:
                continue
            self._tried.add(states.kind)
            solution = self.exact.equilibrium(states)
            if solution is not None and self.accept(solution):
                return solution
        return None

    def _with_states(self, motion: Floats, states: States) -> Solution | None:
        """Return an accepted equilibrium of given states near a motion."""
        self._visited.append(states)
        each = SETTINGS.proposal_steps_per_contact
        self.effort.check(SETTINGS.proposal_steps + each * len(self.contacts.rows))
        return next(filter(self.accept, self._proposals(motion, states)), None)

    def _proposals(self, motion: Floats, states: States) -> Iterator[Solution]:
        """Yield equilibria of given states near a motion; none where they were tried before."""
        size = float(np.abs(motion).max()) or 1.0
        steps = np.rint(SETTINGS.same_motion_denominator * motion / size).astype(int)
        key = states.key, states.rational, tuple(steps.tolist())
        if key in self._tried:
            return
        self._tried.add(key)
        balance = StateBalance(self.contacts, self.wrench, states)
        if states.rational:
            # The simplest motion first, of those that balance leaves open.
            yield from self.exact.balanced(balance, [np.zeros(len(motion)), motion])
        if any(states.slipping):
            yield from enclosures(balance, motion)

    def _rubbing(self, motion: Floats, forces: Floats, slipping: Sequence[bool]) -> Solution | None:
        """Return an equilibrium where contacts of huge friction slip that seem to stick."""
        rubbing = rubbing_states(self.contacts, motion, forces, slipping, self.relaxation.force)
        return self._with_states(*rubbing) if rubbing else None

    def _at_smooth_pyramids(self, exact: PyramidParts, end: Floats, eps: float) -> Solution | None:
        """Return an equilibrium of the states of pyramids at a motion of the smooth balance."""
        c = self.contacts
        normal = np.maximum(0.0, c.spring_forces(end))
        slips = exact.cones.directions(c.slips(end), eps)
        return self._of_pyramids(exact, exact.near(normal, slips))

    def _of_pyramids(self, exact: PyramidParts, states: Node) -> Solution | None:
        """Return the equilibrium of decided states, at their first occurrence."""
        solution = None if states in self._tried else exact.holds(states)
        self._tried.add(states)
        return solution if solution is not None and self.accept(solution) else None
