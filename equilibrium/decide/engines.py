"""The searches behind a verdict: in the plane, in space, and of several bodies.

An engine is a subject with its limits, prepared for many loads. What it ends with is not checked
yet, but for equilibria in space, which the search accepts by the checker's law.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from fractions import Fraction
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

from arrangement.errors import OutOfReachError
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector
from equilibrium.certificate.checker import proof_report
from equilibrium.core.contact_law import states_of
from equilibrium.core.contacts import FloatContacts, IntegerContacts
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.effort import Effort
from equilibrium.model.errors import TimeLimitError
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Open, Outcome, Refutation, Solution, Tree
from equilibrium.model.subject import LoadCase
from equilibrium.plane.coplanar import decide_in_plane
from equilibrium.plane.search.motion_regions import resistance
from equilibrium.plane.search.units import SearchUnits

from .short_leaves import with_short_leaves
from .state_choices import StateChoices

if TYPE_CHECKING:
    # Questions in the plane start without the search in space.
    from equilibrium.core.memory import Memory
    from equilibrium.core.tree import SpatialSearch


class Engine(ABC):
    """The search for one grasp or assembly."""

    #: Whether the equilibria that it finds are checked already.
    checks_equilibria = False

    @abstractmethod
    def outcome(
        self,
        load: RationalVector,
        effort: Effort,
        *,
        shorten: bool = False,
        nodes: int | None = None,
        memory: Memory | None = None,
    ) -> Solution | Refutation | Open:
        """Search for an equilibrium and for a proof that there is none.

        Args:
            load: of an assembly the wrenches on its bodies in a row.
            shorten: look longer for a smaller proof.
            nodes: of a tree in space, or of several bodies.
            memory: what proofs in space leave for other loads; by default that of this engine.

        Raises:
            TimeLimitError: in the plane, the time has passed without an answer.
            OutOfReachError: in the plane, the steps have led to no answer.
        """

    @abstractmethod
    def states(self, solution: Solution) -> tuple[str, ...]:
        """Return the state of each contact in an equilibrium."""

    @abstractmethod
    def equilibria(self, load: RationalVector) -> tuple[Any, ...]:
        """Return all equilibria.

        Raises:
            GraspError: the grasp is in space.
            UndecidedError: a part of an assembly has too many choices of contact states.
        """


class PlanarEngine(Engine):
    """The search in the space of planar motions, which always ends."""

    def __init__(self, grasp: Grasp, max_displacement: Fraction | None = None) -> None:
        self.grasp, self.max_displacement = grasp, max_displacement
        self._scaled: dict[Fraction | None, IntegerContacts] = {}

    @cached_property
    def choices(self) -> StateChoices:
        """All choices of contact states."""
        return StateChoices(self.grasp, self.max_displacement)

    def outcome(
        self, load: RationalVector, effort: Effort, *, shorten: bool = False, **_: Any
    ) -> Solution | Refutation:
        """Search in units that keep numbers small."""
        total = self.grasp.total_load(load)
        units = SearchUnits.of(self.grasp, total)
        # Without preload no number of the contacts depends on the unit of force, with it that is
        # the grasp's own; so all wrenches share them but for the largest displacement.
        bound = units.displacement(self.max_displacement)
        scaled = self._scaled.get(bound)
        if scaled is None:
            scaled = IntegerContacts(units.rows(self.grasp), bound)
            self._scaled = {bound: scaled}
        try:
            outcome: Solution | Tree = resistance(scaled, units.wrench(total), effort, shorten)
        except TimeoutError as late:
            if effort.spent <= effort.steps:
                raise TimeLimitError(f"undecided: {late}; give more time, or none") from None
            more = budget.raised_limit(math.ceil(2 * budget.times()))
            raise OutOfReachError(f"undecided: {late}; {more} allows more") from None
        if isinstance(outcome, Solution):
            return units.solution_back(outcome)
        tree = units.tree_back(outcome)
        return Refutation(with_short_leaves(tree, self.grasp, load, self.max_displacement))

    def states(self, solution: Solution) -> tuple[str, ...]:
        """Return the state of each contact in an equilibrium."""
        return states_of(self.grasp, solution.motion, solution.forces)

    def equilibria(self, load: RationalVector) -> tuple[Any, ...]:
        """Return the maximal pieces of the set of all solutions."""
        return self.choices.equilibria(load)


class SpatialEngine(Engine):
    """The search in a tree of contact states, with round cones or pyramids."""

    checks_equilibria = True

    def __init__(
        self,
        grasp: Grasp,
        max_displacement: Fraction | None = None,
        pyramid: int | None = None,
    ) -> None:
        self.grasp, self.max_displacement, self.pyramid = grasp, max_displacement, pyramid
        self._edges = () if pyramid is None else pyramid_edges(pyramid)

    @cached_property
    def _contacts(self) -> FloatContacts:
        """The contacts in floats, which all loads share."""
        return FloatContacts(ContactRows.of_grasp(self.grasp))

    @cached_property
    def _memory(self) -> Memory:
        """What proofs leave for other loads."""
        return new_memory()

    def outcome(
        self,
        load: RationalVector,
        effort: Effort,
        *,
        nodes: int | None = None,
        memory: Memory | None = None,
        **_: Any,
    ) -> Solution | Refutation | Open:
        """Search until a limit is reached."""
        return answered(self.search(load, effort, nodes, memory).decide())

    def search(
        self,
        wrench: RationalVector,
        effort: Effort,
        nodes: int | None = None,
        memory: Memory | None = None,
    ) -> SpatialSearch:
        """Return the search for one wrench."""
        from equilibrium.core.cones import Pyramids

        load = self._contacts.rows.total_load(wrench)
        question = self.grasp, load, effort, self.max_displacement
        return tree_search(
            LoadCase(self.grasp, wrench, self.max_displacement, self.pyramid),
            self._contacts,
            effort,
            nodes,
            cones=Pyramids(self._edges) if self._edges else None,
            memory=self._memory if memory is None else memory,
            in_plane=None if self._edges else partial(decide_in_plane, *question),
        )

    def states(self, solution: Solution) -> tuple[str, ...]:
        """Return the state of each contact in an equilibrium."""
        if solution.box is not None:
            shares = solution.box.friction
            return tuple("detached" if x is None else "stick" if x else "slip" for x in shares)
        return states_of(self.grasp, solution.motion, solution.forces)

    def equilibria(self, load: RationalVector) -> tuple[Any, ...]:
        """Refuse: in space not all equilibria are listed."""
        self.grasp.require_plane()
        return ()


def new_memory() -> Memory:
    """Return an empty memory of proofs in space."""
    from equilibrium.core.memory import Memory

    return Memory()


def tree_search(
    case: LoadCase, contacts: FloatContacts, effort: Effort, nodes: int | None, **options: Any
) -> SpatialSearch:
    """Return the search in a tree of contact states, whose equilibria the checker accepts."""
    from equilibrium.core.tree import SpatialSearch

    def accept(solution: Solution) -> bool:
        return bool(proof_report(case, solution))

    load, most = contacts.rows.total_load(case.load), case.max_displacement
    return SpatialSearch(contacts, load, accept, effort, nodes, most, **options)


def answered(outcome: Outcome) -> Solution | Refutation | Open:
    """Return what a search in a tree of states ends with, a tree as a refutation."""
    return outcome if isinstance(outcome, Solution | Open) else Refutation(outcome)
