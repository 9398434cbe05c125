"""What is computed for a grasp once and serves every wrench: an object that the caller holds."""

from __future__ import annotations

from functools import cached_property

from arrangement.enumeration.affine_space import SpaceFaces, space_faces
from equilibrium.model.grasp import Grasp

from .contact_states import Codes, codes_of_faces, states_of_code
from .integer_contacts import IntegerContacts
from .interval_filter import Screen
from .state_system import States


def contact_states(grasp: Grasp) -> tuple[States, ...]:
    """Return choices of contact states that together admit every equilibrium, without repeats."""
    return PreparedGrasp(grasp).states


class PreparedGrasp:
    """A grasp with what the solver knows of it; each part is computed when first needed."""

    def __init__(self, grasp: Grasp) -> None:
        self.grasp = grasp

    @cached_property
    def integers(self) -> IntegerContacts:
        """The numbers of the contacts as integers, and as floats."""
        return IntegerContacts(self.grasp)

    @cached_property
    def faces(self) -> SpaceFaces:
        """The faces of the motion arrangement."""
        return space_faces(self.grasp.motion_arrangement())

    @cached_property
    def codes(self) -> Codes:
        """Choices of contact states that together admit every equilibrium, as an array."""
        return codes_of_faces(self.grasp, self.faces)

    @property
    def states(self) -> tuple[States, ...]:
        """Choices of contact states that together admit every equilibrium, without repeats."""
        return tuple(map(states_of_code, self.codes.tolist()))

    @cached_property
    def screen(self) -> Screen:
        """The systems of all these choices in floating point, with error bounds."""
        return Screen(self.integers.floats, self.codes)
