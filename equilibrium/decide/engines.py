"""The searches behind a verdict: in the plane, in space, and of several bodies.

An engine is a subject with its limits, prepared for many loads. What it ends with is not checked
yet, but for equilibria in space, which the search accepts by the checker's law.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import replace
from fractions import Fraction
from functools import cache, cached_property, partial
from importlib import import_module
from typing import TYPE_CHECKING, Any

from arrangement.errors import MissingExtraError, OutOfReachError
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, dot
from equilibrium.certificate.checker import proof_report
from equilibrium.core.contacts import FloatContacts, IntegerContacts
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.effort import Effort
from equilibrium.model.errors import TimeLimitError
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Leaf, Open, Outcome, Refutation, Solution, Tree
from equilibrium.model.subject import LoadCase
from equilibrium.plane.coplanar import decide_in_plane
from equilibrium.plane.search.motion_regions import resistance
from equilibrium.plane.search.units import SearchUnits
from equilibrium.plane.states.contact_states import states_at

from .short_leaves import with_short_leaves
from .state_choices import StateChoices

if TYPE_CHECKING:
    # Questions in the plane start without the search in space.
    from equilibrium.core.memory import Memory
    from equilibrium.core.tree import SpatialSearch


#: With more contacts the space of motions is cut at once: there a tree of states grows faster.
_MAX_CONTACTS_TREE = 16
#: Nodes of a tree of states in the plane, before the space of motions is cut.
_MAX_NODES_TREE = 150


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
            memory: what proofs in space leave for other loads.

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
    """The search in the space of planar motions, which always ends.

    Attributes:
        splits_states: whether few contacts are tried by a tree of states before regions are cut.
            Leaves of regions hold for other numbers near, too, those of such a tree hardly.
    """

    splits_states = True

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
            scaled = IntegerContacts(units.grasp(self.grasp), bound)
            self._scaled = {bound: scaled}
        try:
            question = scaled, units.wrench(total), effort
            first = tree_of_states if self.splits_states else None
            outcome: Solution | Tree = resistance(*question, shorten, first)
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
        return states_at(self.grasp, solution.motion)

    def equilibria(self, load: RationalVector) -> tuple[Any, ...]:
        """Return the maximal pieces of the set of all solutions."""
        return self.choices.equilibria(load)


def tree_of_states(
    contacts: IntegerContacts, wrench: RationalVector, effort: Effort
) -> Solution | Tree | None:
    """Return an equilibrium or a proof in the plane by splits on the states of contacts alone.

    None for many contacts, for extreme numbers, where it takes too many nodes, and where Clarabel
    is not installed.
    """
    few = len(contacts) <= _MAX_CONTACTS_TREE and contacts.floats.moderate
    if not few or not has_clarabel():
        return None
    from equilibrium.core.cones import LineCones
    from equilibrium.core.memory import OpenTree
    from equilibrium.core.tree import SpatialSearch

    bound = contacts.max_displacement
    case = LoadCase(contacts.grasp, wrench, bound)

    def accept(solution: Solution) -> bool:
        return bool(proof_report(case, solution))

    question = contacts.floats, wrench, accept, effort
    search = SpatialSearch(*question, max_displacement=bound, cones=LineCones())
    outcome = search.close(OpenTree(search.root), _MAX_NODES_TREE)
    if isinstance(outcome, Open):
        return None
    return outcome if isinstance(outcome, Solution) else _with_zeros(outcome)


@cache
def has_clarabel() -> bool:
    """Return whether the solver of conic programs, an extra, is installed."""
    try:
        import_module("equilibrium.core.tree")
    except MissingExtraError:
        return False
    return True


def _with_zeros(node: Any, decided: frozenset[int] = frozenset()) -> Any:
    """Return a tree of states as one in a region, where multipliers of decided contacts are listed.

    Without any a contact there does all that it does in the region, see
    `equilibrium.certificate.leaf_rule`; in a tree of states it does nothing.
    """
    if isinstance(node, Leaf):
        zeros = dict.fromkeys(sorted(decided), (0, 0))
        return replace(node, multipliers={**zeros, **node.multipliers})
    kind, i = "slip" if "slip" in node else "attachment", node["contact"]
    children = {
        state: _with_zeros(child, decided if state == "detached" else decided | {i})
        for state, child in node[kind].items()
    }
    return {**node, kind: children}


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
        from equilibrium.core.tree import SETTINGS, SpatialSearch

        case = LoadCase(self.grasp, wrench, self.max_displacement, self.pyramid)

        def accept(solution: Solution) -> bool:
            return bool(proof_report(case, solution))

        load = self._contacts.rows.total_load(wrench)
        question = self.grasp, load, effort, self.max_displacement
        return SpatialSearch(
            self._contacts,
            load,
            accept,
            effort,
            nodes=SETTINGS.max_nodes if nodes is None else nodes,
            max_displacement=self.max_displacement,
            cones=Pyramids(self._edges) if self._edges else None,
            memory=new_memory() if memory is None else memory,
            in_plane=None if self._edges else partial(decide_in_plane, *question, tree_of_states),
        )

    def states(self, solution: Solution) -> tuple[str, ...]:
        """Return the state of each contact in an equilibrium."""
        if solution.box is not None:
            shares = solution.box.friction
            return tuple("detached" if x is None else "stick" if x else "slip" for x in shares)
        return tuple(
            "detached"
            if not force[0]
            else "slip"
            if any(dot(row, solution.motion) for row in contact.tangential_wrenches)
            else "stick"
            for contact, force in zip(self.grasp, solution.forces, strict=True)
        )

    def equilibria(self, load: RationalVector) -> tuple[Any, ...]:
        """Refuse: in space not all equilibria are listed."""
        self.grasp.require_plane()
        return ()


def new_memory() -> Memory:
    """Return an empty memory of proofs in space."""
    from equilibrium.core.memory import Memory

    return Memory()


def answered(outcome: Outcome) -> Solution | Refutation | Open:
    """Return what a search in a tree of states ends with, a tree as a refutation."""
    return outcome if isinstance(outcome, Solution | Open) else Refutation(outcome)
