"""The complete decision: does a grasp hold a wrench passively, and in which ways.

In the plane a search finds an equilibrium or a tree of virtual motions. All equilibria are found in
another way: each satisfies the conditions of one of `contact_states`, which are linear; one system
for each is solved. In space the search may end without either.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator
from fractions import Fraction
from functools import cached_property, lru_cache, partial
from typing import Any, overload

import numpy as np

from arrangement.console.number_form import ReprMixin
from arrangement.console.progress import watched
from arrangement.console.workers import done, due
from arrangement.errors import OutOfReachError
from arrangement.library.arguments import entries
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, vector_text
from equilibrium.certificate.checker import equilibrium_problem
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.displacement import read_displacement
from equilibrium.model.effort import Effort
from equilibrium.model.errors import (
    CertificateError,
    EquilibriumError,
    GraspError,
    TimeLimitError,
)
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Solution
from equilibrium.plane.contacts import FloatContacts, IntegerContacts, are_moderate, nearest
from equilibrium.plane.search.motion_regions import resistance
from equilibrium.plane.search.units import SearchUnits
from equilibrium.plane.states.contact_states import Codes, state_codes, states_at, states_of_code
from equilibrium.plane.states.equilibrium import Equilibrium, equilibrium_of, maximal
from equilibrium.plane.states.interval_filter import Screen
from equilibrium.plane.states.state_system import SingularStates, States, StateSystem, state_system

from . import NOT_RESISTED, RESISTED, UNDECIDED
from .as_printed import PrintedVerdict, solve_as_printed
from .verdict import Verdict


@overload
def solve(
    grasp: Grasp,
    wrench: Iterable[Any],
    *,
    as_printed: None = None,
    time_limit: float | None = None,
    shorten: bool = False,
    nodes: int | None = None,
    pyramid: int | None = None,
    max_displacement: Any = None,
) -> Verdict: ...


@overload
def solve(
    grasp: Grasp, wrench: Iterable[Any], *, as_printed: Collection[str]
) -> PrintedVerdict: ...


def solve(
    grasp: Grasp,
    wrench: Iterable[Any],
    *,
    as_printed: Collection[str] | None = None,
    time_limit: float | None = None,
    shorten: bool = False,
    nodes: int | None = None,
    pyramid: int | None = None,
    max_displacement: Any = None,
) -> Verdict | PrintedVerdict:
    """Decide exactly whether a grasp resists a wrench; the verdict finds all ways when asked.

    Args:
        grasp: contacts in the object frame.
        wrench: applied, ``(f_x, f_y, tau)``, the torque about the origin; in space
            ``(f_x, f_y, f_z, tau_x, tau_y, tau_z)``.
        as_printed: follow the printed text of the paper in these points, and the full model in all
            others; see `equilibrium.decide.as_printed.OPTIONS`. A `PrintedVerdict` is returned, in
            the plane alone, without a certificate; no other option goes with it.
        time_limit: in seconds, by a clock on the wall. Without one the work is limited, to the same
            steps on every machine (`STEPS`), times `arrangement.limit`. In space the verdict is
            undecided when a limit is reached.
        shorten: in the plane look longer for a smaller proof that nothing balances the wrench.
        nodes: in space, of a tree; when they do not do the verdict is undecided.
        pyramid: in space, edges of a friction pyramid in place of the round cone, see
            `pyramid_edges`; then every verdict is decided, exactly, if nodes and time do.
        max_displacement: only equilibria count that move each contact point by at most that along
            its normal and along its tangent, in space along each of the two; an exact number.

    Raises:
        TimeLimitError: in the plane, the time has passed without an answer.
        OutOfReachError: in the plane, that many steps have led to no answer.
        GraspError: a wrench of the wrong length, a pyramid in the plane or of no such number, or
            as_printed with an unknown point or with another option.

    The search is in floating point, each answer exact. In the plane it always ends: see
    "Completeness" in the documentation of proofs. On random grasps the time is nearly linear in the
    number of contacts.

    >>> from equilibrium.grasps.files import read_grasp
    >>> solve(read_grasp("paper-three-contacts-preload-1"), [0, 1, 0]).stable
    True
    >>> solve(read_grasp("two-opposed-fingers"), [0, "3/5", "4/5", 0, 0, 0]).verdict
    'resisted'
    >>> solve(read_grasp("single-contact"), [0, 0, 0], as_printed=["all-stick"]).options
    ('all-stick',)
    """
    if as_printed is not None:
        others = {"time_limit": time_limit, "nodes": nodes, "pyramid": pyramid}
        others |= {"shorten": shorten or None, "max_displacement": max_displacement}
        for name, value in others.items():
            if value is not None:
                raise GraspError(f"as_printed takes no {name}; omit one of the two")
        return solve_as_printed(grasp, wrench, as_printed)
    solver = Solver(grasp, max_displacement, pyramid)
    return solver.solve(wrench, time_limit=time_limit, shorten=shorten, nodes=nodes)


def solve_many(
    grasp: Grasp,
    wrenches: Iterable[Iterable[Any]],
    *,
    jobs: int = 1,
    dask: str | None = None,
    pyramid: int | None = None,
    max_displacement: Any = None,
) -> Iterator[Verdict]:
    """Yield the verdict of each wrench on one grasp, in order.

    In the plane, where contacts are few, the choices of contact states are tried first: that gives
    the same verdicts, a thousand of eight contacts in seconds, and maybe another one of several
    equilibria. The checker has accepted each equilibrium. The proof that nothing balances a wrench
    is searched for, and checked, when it is asked for.

    In space what one proof leaves for the next is kept for as many wrenches as one process takes at
    once, so answers do not depend on the number of processes.

    Args:
        jobs: processes of this machine.
        dask: address of a Dask scheduler whose workers decide.
        pyramid, max_displacement: see `solve`.

    >>> from equilibrium.grasps.files import read_grasp
    >>> grasp = read_grasp("paper-three-contacts-preload-1")
    >>> [verdict.stable for verdict in solve_many(grasp, [[0, 1, 0], [0, 2, 0]])]
    [True, False]
    """
    return Solver(grasp, max_displacement, pyramid).solve_many(wrenches, jobs=jobs, dask=dask)


#: Steps of one question in the plane and in space, see `Effort`: about 20 and 60 seconds.
STEPS = {2: 200_000_000, 3: 600_000_000}
#: How many wrenches a process takes at once; up to how many contacts all states are tried.
_PART, _FEW = 50, 12
#: Steps of the exact system of a choice of states, for each contact.
_EXACT = 700


class Solver(ReprMixin):
    """A grasp prepared for many wrenches: what one question computes serves the next.

    `equilibrium.ResistedSet` is its public form. With a largest displacement only equilibria within
    it count; see the function `solve`.
    """

    repr_fields = ("grasp",)

    def __init__(
        self,
        grasp: Grasp,
        max_displacement: Any = None,
        pyramid: int | None = None,
    ) -> None:
        self.grasp, self.max_displacement = grasp, read_displacement(max_displacement)
        self.pyramid = pyramid
        self._edges = None if pyramid is None else pyramid_edges(pyramid, grasp.dimension)
        self._scaled: dict[Fraction | None, IntegerContacts] = {}

    @cached_property
    def _in_space_before(self) -> Any:
        """What proofs in space leave for other wrenches."""
        return _memory()

    @cached_property
    def _codes(self) -> Codes:
        self.grasp.require_plane()
        return state_codes(self.grasp)

    @cached_property
    def screen(self) -> Screen:
        """The systems of all choices of contact states in floating point, with error bounds."""
        return Screen(self.grasp, self._codes)

    @property
    def states(self) -> tuple[States, ...]:
        """The choices of contact states; see `contact_states`."""
        return tuple(map(states_of_code, self._codes.tolist()))

    def check_cost(self, times: int = 1) -> None:
        """Refuse to try all choices of contact states so often where floats rule out none."""
        count, contacts = len(self._codes), len(self.grasp)
        if not self.screen.contacts.moderate:
            budget.check_cost(
                f"{count:,} choices of states of {contacts} contacts with huge or tiny numbers",
                "decide one load (solve)",
                long_steps=_EXACT * contacts * count * times,
            )

    def solve(
        self,
        wrench: Iterable[Any],
        *,
        time_limit: float | None = None,
        shorten: bool = False,
        nodes: int | None = None,
    ) -> Verdict:
        """Decide one wrench; see the function `solve`."""
        effort = self._usual() if time_limit is None else Effort(seconds=time_limit)
        return self.decide(wrench, effort, shorten=shorten, nodes=nodes)

    def _usual(self) -> Effort:
        return Effort(STEPS[self.grasp.dimension] * budget.times())

    def decide(
        self,
        wrench: Iterable[Any],
        effort: Effort,
        *,
        shorten: bool = False,
        nodes: int | None = None,
        memory: Any = None,
    ) -> Verdict:
        """Decide one wrench with the effort that is left; see the function `solve`.

        Args:
            memory: in space, of other wrenches; by default that of this solver.
        """
        applied = read_wrench(wrench, self.grasp.dimension)
        if self.grasp.dimension == 3:
            search = self._search(applied, effort, nodes, memory)
            return self._found(applied, search.decide())
        try:
            return self._in_plane(applied, effort, shorten)
        except TimeoutError as late:
            if effort.spent <= effort.steps:
                raise TimeLimitError(f"undecided: {late}; give more time, or none") from None
            more = math.ceil(2 * budget.times())
            raise OutOfReachError(f"undecided: {late}; --limit {more} allows more") from None

    def _in_plane(self, applied: RationalVector, effort: Effort, shorten: bool) -> Verdict:
        units = SearchUnits.of(self.grasp, applied)
        # Without preload no number of the contacts depends on the unit of force, with it that is
        # the grasp's own; so all wrenches share them but for the largest displacement.
        bound = units.displacement(self.max_displacement)
        scaled = self._scaled.get(bound)
        if scaled is None:
            scaled = IntegerContacts(units.grasp(self.grasp), bound)
            self._scaled = {bound: scaled}
        found = resistance(scaled, units.wrench(applied), effort, shorten)
        back = units.solution_back if isinstance(found, Solution) else units.tree_back
        return self._accepted(self._verdict(applied, back(found)))

    def _search(
        self,
        wrench: RationalVector,
        effort: Effort | None = None,
        nodes: int | None = None,
        memory: Any = None,
    ) -> Any:
        """Return the search for one wrench in space."""
        from equilibrium.space.cones import Pyramids
        from equilibrium.space.tree import SETTINGS, SpatialSearch

        cones = None if self._edges is None else Pyramids(self._edges)

        def accept(found: Solution) -> bool:
            return bool(self._verdict(wrench, found).verify())

        contacts = FloatContacts(ContactRows.of_grasp(self.grasp))
        most = SETTINGS.max_nodes if nodes is None else nodes
        how = effort, most, self.max_displacement, cones, memory or self._in_space_before
        return SpatialSearch(contacts, wrench, accept, *how)

    def _found(self, wrench: RationalVector, found: Any) -> Verdict:
        """Return the verdict of what a search in space found."""
        from equilibrium.space.tree import Open

        if isinstance(found, Open):
            return self._verdict(wrench, None, UNDECIDED, found.reason, found.residual)
        verdict = self._verdict(wrench, found)
        # An equilibrium has been accepted already.
        return verdict if isinstance(found, Solution) else self._accepted(verdict)

    def _accepted(self, verdict: Verdict) -> Verdict:
        """Return a verdict whose proof the checker accepts.

        Raises:
            EquilibriumError: it does not, which is an internal error.
        """
        found = verdict.solution
        try:
            if found is None:
                problem = verdict.verify().problem
            else:
                question, bound = (verdict.grasp, verdict.wrench), self.max_displacement
                shown = found.motion, found.forces
                problem = equilibrium_problem(*question, *shown, max_displacement=bound)
        except CertificateError as error:
            problem = str(error)
        if problem:
            raise EquilibriumError(
                f"the checker refuses the proof of the verdict on {vector_text(verdict.wrench)}: "
                f"{problem}. This is an internal error; please report it"
            )
        return verdict

    def reach(
        self, refused: RationalVector, resisted: RationalVector, nodes: int, near: float
    ) -> Any:
        """Return how near resisted loads come to one that is not; see `equilibrium.space.reach`."""
        from equilibrium.space.reach import reach

        change = np.array([nearest(x - y) for x, y in zip(resisted, refused, strict=True)])
        return reach(self._search(refused), change, nodes, near)

    def close(self, wrench: RationalVector, tree: Any, nodes: int) -> Verdict:
        """Decide a wrench in space by a tree that is open, and maybe this many further nodes."""
        return self._found(wrench, self._search(wrench).close(tree, nodes))

    def _verdict(
        self,
        wrench: RationalVector,
        found: Any,
        answer: str = NOT_RESISTED,
        reason: str = "",
        residual: float = 0.0,
    ) -> Verdict:
        """Return the verdict of an equilibrium, of a tree, or of neither."""
        held = found if isinstance(found, Solution) else None
        tree = None if held else found
        if found is None and answer == NOT_RESISTED:
            tree = partial(self._refutation, wrench)
        question = self.grasp, wrench, RESISTED if held else answer, held, tree
        how = self._equilibria, _again, self.max_displacement, self.pyramid
        return Verdict(*question, *how, reason, residual)

    def _refutation(self, wrench: RationalVector) -> Any:
        """Return the tree that proves what the choices of contact states have shown."""
        found = self.solve(wrench)
        if found.stable:
            raise EquilibriumError(
                f"the wrench {vector_text(wrench)} has an equilibrium, but no choice of contact "
                "states has one. This is an internal error; please report it"
            )
        return found.tree

    def solve_many(
        self, wrenches: Iterable[Iterable[Any]], *, jobs: int = 1, dask: str | None = None
    ) -> Iterator[Verdict]:
        """Yield the verdict of each wrench, in order; see the function `solve_many`."""
        given = entries(wrenches, "wrenches", "wrenches")
        listed = [read_wrench(wrench, self.grasp.dimension) for wrench in given]
        parts = [listed[k : k + _PART] for k in range(0, len(listed), _PART)]
        due(len(parts), (1, 1), jobs)
        return self._in_order(parts, jobs, dask)

    def _in_order(
        self, parts: list[list[RationalVector]], jobs: int, dask: str | None
    ) -> Iterator[Verdict]:
        if jobs == 1 and dask is None:
            memories = [memory for part in parts for memory in [_memory()] * len(part)]
            every = [wrench for part in parts for wrench in part]
            yield from map(self._one_of_many, watched(every, "wrenches"), memories)
            return
        plan = (self.grasp, self.max_displacement, self.pyramid), parts, budget.times()
        early: dict[int, list[Any]] = {}
        found = done(_answers, plan, range(len(parts)), jobs, dask)
        results = iter(watched(found, "parts of wrenches", len(parts)))
        for number, part in enumerate(parts):
            while number not in early:
                at, answers = next(results)
                early[at] = answers
            for wrench, answer in zip(part, early.pop(number), strict=True):
                yield self._verdict(wrench, *answer)

    def _one_of_many(self, wrench: RationalVector, memory: Any) -> Verdict:
        """Decide by the choices of contact states, if they are few and none is left open."""
        if self.grasp.dimension == 3 or len(self.grasp) > _FEW or not are_moderate(wrench):
            return self.decide(wrench, self._usual(), memory=memory)
        possible = self.screen.possible(wrench)
        for row in self._codes[possible & ~self.screen.singular].tolist():
            system = state_system(
                self.grasp, states_of_code(row), wrench, max_displacement=self.max_displacement
            )
            found = equilibrium_of(system)
            if found is not None:
                solution = Solution(found.motion, found.forces)
                return self._accepted(self._verdict(wrench, solution))
        return (
            self.solve(wrench) if self._singular.may_hold(wrench) else self._verdict(wrench, None)
        )

    def _system(self, states: States, wrench: RationalVector) -> StateSystem:
        bound = self.max_displacement
        return state_system(self.grasp, states, wrench, max_displacement=bound)

    @cached_property
    def _singular(self) -> SingularStates:
        rows = self._codes[self.screen.singular].tolist()
        return SingularStates(self.grasp, map(states_of_code, rows))

    def _equilibria(self, wrench: RationalVector) -> tuple[Equilibrium, ...]:
        """Return the maximal pieces of all solutions: every choice of contact states is decided.

        The states at a motion on the boundary of normal planes may be none of the choices; where
        they hold more of the solutions, theirs is the piece to report.
        """
        possible = self._codes[self.screen.possible(wrench)].tolist()

        def piece_of(states: States) -> Equilibrium | None:
            return equilibrium_of(
                state_system(self.grasp, states, wrench, max_displacement=self.max_displacement)
            )

        tried = map(states_of_code, watched(possible, "contact states"))
        pieces = [piece for piece in map(piece_of, tried) if piece]
        known = {piece.states for piece in pieces}
        for piece in pieces:
            states = states_at(self.grasp, piece.motion)
            if states not in known:
                known.add(states)
                further = piece_of(states)
                if further:
                    pieces.append(further)
        return maximal(pieces)


def _memory() -> Any:
    """Return what proofs in space leave for other wrenches, empty."""
    from equilibrium.space.memory import Memory

    return Memory()


def _again(grasp: Grasp, wrench: Iterable[Any], effort: Effort, **asked: Any) -> Verdict:
    """Decide another question with the effort that is left."""
    return Solver(grasp, **asked).decide(wrench, effort)


def prepare(grasp: Grasp | Solver) -> Solver:
    """Return the solver of a planar grasp; a solver is returned as it is.

    Raises:
        GraspError: the grasp is in space.
    """
    solver = grasp if isinstance(grasp, Solver) else Solver(grasp)
    solver.grasp.require_plane()
    return solver


@lru_cache(maxsize=1)
def _solver(grasp: Grasp, max_displacement: Fraction | None, pyramid: int | None) -> Solver:
    """Return the solver of a process."""
    return Solver(grasp, max_displacement, pyramid)


def _answers(plan: Any, number: int) -> tuple[int, list[Any]]:
    """Return the answers to a part of many wrenches, as `Solver._verdict` takes them."""
    question, parts, times = plan
    solver, memory = _solver(*question), _memory()
    with budget.limit(times):
        found = [solver._one_of_many(wrench, memory) for wrench in parts[number]]
    return number, [
        (v.solution or (None if callable(v._tree) else v._tree), v.verdict, v.reason, v.residual)
        for v in found
    ]
