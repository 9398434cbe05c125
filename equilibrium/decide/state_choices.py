"""All choices of contact states of a planar grasp: each is a linear system, and all are tried.

This decides without the search of `equilibrium.plane.search`, where contacts are few, and finds all
equilibria.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property

from arrangement.console.progress import watched
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector
from equilibrium.model.grasp import Grasp
from equilibrium.plane.states.contact_states import Codes, state_codes, states_at, states_of_code
from equilibrium.plane.states.equilibrium import Equilibrium, equilibrium_of, maximal
from equilibrium.plane.states.interval_filter import Screen
from equilibrium.plane.states.state_system import SingularStates, States, state_system

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
        pieces = (self._equilibrium(states, wrench) for states in tried)
        return next((piece for piece in pieces if piece is not None), None)

    def may_be_missed(self, wrench: RationalVector) -> bool:
        """Return whether a choice that floats cannot solve may have an equilibrium."""
        return self._singular.may_hold(wrench)

    def equilibria(self, wrench: RationalVector) -> tuple[Equilibrium, ...]:
        """Return the maximal pieces of all solutions: every choice of contact states is decided.

        The states at a motion on the boundary of normal planes may be none of the choices; where
        they hold more of the solutions, theirs is the piece to report.
        """
        possible = self.codes[self.screen.possible(wrench)].tolist()
        tried = map(states_of_code, watched(possible, "contact states"))
        pieces = [piece for states in tried if (piece := self._equilibrium(states, wrench))]
        known = {piece.states for piece in pieces}
        for piece in pieces:
            states = states_at(self.grasp, piece.motion)
            if states not in known:
                known.add(states)
                further = self._equilibrium(states, wrench)
                if further:
                    pieces.append(further)
        return maximal(pieces)

    def _equilibrium(self, states: States, wrench: RationalVector) -> Equilibrium | None:
        bound = self.max_displacement
        return equilibrium_of(state_system(self.grasp, states, wrench, max_displacement=bound))

    @cached_property
    def _singular(self) -> SingularStates:
        rows = self.codes[self.screen.singular].tolist()
        return SingularStates(self.grasp, map(states_of_code, rows))
