"""What is computed for a grasp once and serves every wrench: an object that the caller holds."""

from __future__ import annotations

from functools import cached_property

from arrangement.exact import RationalVector
from equilibrium.model.grasp import Grasp

from .contact_states import Codes, codes_of_faces, states_of_code
from .integer_contacts import IntegerContacts
from .interval_filter import Screen
from .refutations import Balances
from .state_system import States, StateSystem, loaded, state_system


def contact_states(grasp: Grasp) -> tuple[States, ...]:
    """Return choices of contact states that together admit every equilibrium, without repeats."""
    return PreparedGrasp(grasp).states


class PreparedGrasp:
    """A grasp with what the solver knows of it; each part is computed when first needed."""

    def __init__(self, grasp: Grasp) -> None:
        self.grasp = grasp
        self.balances = Balances(grasp)
        self._unloaded: dict[States, StateSystem] = {}

    @cached_property
    def integers(self) -> IntegerContacts:
        """The numbers of the contacts as integers, and as floats."""
        return IntegerContacts(self.grasp)

    @cached_property
    def codes(self) -> Codes:
        """Choices of contact states that together admit every equilibrium, as an array."""
        return codes_of_faces(self.grasp)

    @property
    def states(self) -> tuple[States, ...]:
        """Choices of contact states that together admit every equilibrium, without repeats."""
        return tuple(map(states_of_code, self.codes.tolist()))

    @cached_property
    def screen(self) -> Screen:
        """The systems of all these choices in floating point, with error bounds."""
        return Screen(self.grasp, self.codes)

    def system(self, states: States, wrench: RationalVector) -> StateSystem:
        """Return the exact linear system of a choice of states, for one wrench."""
        unloaded = self._unloaded.get(states)
        if unloaded is None:
            unloaded = self._unloaded[states] = state_system(self.grasp, states)
        return loaded(unloaded, wrench)
