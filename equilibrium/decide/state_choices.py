"""All choices of contact states of a planar grasp: each is a linear system, and all are tried.

This decides without the search of `equilibrium.plane.search`, where contacts are few, and finds all
equilibria.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from itertools import combinations

from arrangement.console.progress import watched
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive
from arrangement.numbers.linear.rank import cross, gauss_jordan, rank
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from equilibrium.plane.states.contact_states import (
    Codes,
    States,
    state_codes,
    states_at,
    states_of_code,
)
from equilibrium.plane.states.equilibrium import Equilibrium, equilibrium_of, maximal
from equilibrium.plane.states.interval_filter import Screen

#: Steps of the exact system of a choice of states, for each contact.
_STEPS_PER_CONTACT = 700


class StateChoices:
    """The choices of contact states of one grasp, prepared for many wrenches.

    Args:
        max_displacement: only equilibria within it count.
    """

    def __init__(self, grasp: Grasp, max_displacement: Fraction | None = None) -> None:
        grasp.require_plane()
        self.grasp, self.max_displacement = grasp, max_displacement

    @cached_property
    def codes(self) -> Codes:
        """The choices as numbers; see `contact_states`."""
        return state_codes(self.grasp)

    @property
    def states(self) -> tuple[States, ...]:
        """The choices in words."""
        return tuple(map(states_of_code, self.codes.tolist()))

    @cached_property
    def screen(self) -> Screen:
        """The systems of all choices in floating point, with error bounds."""
        return Screen(self.grasp, self.codes)

    def check_cost(self, times: int = 1) -> None:
        """Refuse to try all choices of contact states so often where floats rule out none."""
        count, contacts = len(self.codes), len(self.grasp)
        if not self.screen.contacts.moderate:
            budget.check_cost(
                f"{count:,} choices of states of {contacts} contacts with huge or tiny numbers",
                "decide one load (solve)",
                long_steps=_STEPS_PER_CONTACT * contacts * count * times,
            )

    def first_equilibrium(self, wrench: RationalVector) -> Equilibrium | None:
        """Return an equilibrium of the first choice that has one and that floats can solve."""
        possible = self.screen.possible(wrench) & ~self.screen.singular
        tried = map(states_of_code, self.codes[possible].tolist())
        question = self._unloaded.with_load(wrench)
        pieces = (equilibrium_of(question, states) for states in tried)
        return next((piece for piece in pieces if piece is not None), None)

    def may_be_missed(self, wrench: RationalVector) -> bool:
        """Return whether a choice that floats cannot solve may have an equilibrium; no is exact."""
        load = primitive((*wrench, Fraction(1)))
        for rows, are_zero in self._singular:
            values = [dot(row, load) for row in rows]
            if not any(values) if are_zero else min(values, default=0) >= 0:
                return True
        return False

    def equilibria(self, wrench: RationalVector) -> tuple[Equilibrium, ...]:
        """Return the maximal pieces of all solutions: every choice of contact states is decided.

        The states at a motion on the boundary of normal planes may be none of the choices; where
        they hold more of the solutions, theirs is the piece to report.
        """
        possible = self.codes[self.screen.possible(wrench)].tolist()
        tried = map(states_of_code, watched(possible, "contact states"))
        question = self._unloaded.with_load(wrench)
        pieces = [piece for states in tried if (piece := equilibrium_of(question, states))]
        known = {piece.states for piece in pieces}
        for piece in pieces:
            states = states_at(self.grasp, piece.motion)
            if states not in known:
                known.add(states)
                further = equilibrium_of(question, states)
                if further:
                    pieces.append(further)
        return maximal(pieces)

    @cached_property
    def _unloaded(self) -> LinearQuestion:
        rows, bound = ContactRows.of_grasp(self.grasp), self.max_displacement
        return LinearQuestion(rows, (Fraction(0),) * 3, max_displacement=bound)

    @cached_property
    def _singular(self) -> list[tuple[list[IntegerVector], bool]]:
        """Rows of loads that have states which floats cannot solve: at least 0, or all 0 there."""
        choices = map(states_of_code, self.codes[self.screen.singular].tolist())
        planes = ((states, _planes(self._unloaded, states)) for states in choices)
        return [(rows or _bounds(self.grasp, states), bool(rows)) for states, rows in planes]


def _planes(question: LinearQuestion, states: States) -> list[IntegerVector]:
    """Return rows that are 0 at all loads, with 1 last, that have these states."""
    program = ContactProgram(question, states)
    n = program.size
    # The balance is last.
    first = len(program.equalities) - 3
    rows = [
        [*row[:n], *(unit * (k == first + j) for j in range(3)), row[n]]
        for k, (row, unit) in enumerate(zip(program.equalities, program.units, strict=True))
    ]
    reduced, pivots, _ = gauss_jordan(rows)
    return [primitive(row[n:]) for row, pivot in zip(reduced, pivots, strict=False) if pivot >= n]


def _bounds(grasp: Grasp, states: States) -> list[IntegerVector]:
    """Return rows that are at least 0 at all loads, with 1 last, that have these states.

    There are some where the motion is 0: by the planes of two tangential wrenches.
    """
    sticking = [c for c, state in zip(grasp, states, strict=True) if state == "stick"]
    if rank([primitive(c.tangential_wrench) for c in sticking]) < 3:
        return []
    rows = []
    for first, second in combinations(sticking, 2):
        motion = cross(first.tangential_wrench, second.tangential_wrench)
        pull = sum(c.friction * c.preload * abs(dot(c.tangential_wrench, motion)) for c in sticking)
        push = sum(c.preload * dot(c.normal_wrench, motion) for c in sticking)
        push += dot(grasp.adhesion_wrench, motion)
        # The load, adhesion, preloads and at most all friction: no work is left over.
        rows += [primitive((*(s * x for x in motion), s * push + pull)) for s in (1, -1)]
    return rows
