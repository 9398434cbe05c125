"""The search for one planar grasp, prepared for many wrenches."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cached_property

from arrangement.errors import OutOfReachError
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector
from equilibrium.core.contacts import IntegerContacts
from equilibrium.model.effort import Effort
from equilibrium.model.errors import TimeLimitError
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Solution, Tree
from equilibrium.plane.search.motion_regions import resistance
from equilibrium.plane.search.units import SearchUnits

from .state_choices import StateChoices


class PlanarEngine:
    """Finds an equilibrium, or the tree of virtual motions that refutes all."""

    def __init__(self, grasp: Grasp, max_displacement: Fraction | None = None) -> None:
        self.grasp, self.max_displacement = grasp, max_displacement
        self._scaled: dict[Fraction | None, IntegerContacts] = {}

    @cached_property
    def choices(self) -> StateChoices:
        """All choices of contact states."""
        return StateChoices(self.grasp, self.max_displacement)

    def outcome(
        self, wrench: RationalVector, effort: Effort, *, shorten: bool = False
    ) -> Solution | Tree:
        """Search in units that keep numbers small; see the function `equilibrium.solve`.

        Raises:
            TimeLimitError: the time has passed without an answer.
            OutOfReachError: the steps have led to no answer.
        """
        load = self.grasp.total_load(wrench)
        units = SearchUnits.of(self.grasp, load)
        # Without preload no number of the contacts depends on the unit of force, with it that is
        # the grasp's own; so all wrenches share them but for the largest displacement.
        bound = units.displacement(self.max_displacement)
        scaled = self._scaled.get(bound)
        if scaled is None:
            scaled = IntegerContacts(units.grasp(self.grasp), bound)
            self._scaled = {bound: scaled}
        try:
            outcome: Solution | Tree = resistance(scaled, units.wrench(load), effort, shorten)
        except TimeoutError as late:
            if effort.spent <= effort.steps:
                raise TimeLimitError(f"undecided: {late}; give more time, or none") from None
            more = budget.raised_limit(math.ceil(2 * budget.times()))
            raise OutOfReachError(f"undecided: {late}; {more} allows more") from None
        if isinstance(outcome, Solution):
            return units.solution_back(outcome)
        tree: Tree = units.tree_back(outcome)
        return tree
