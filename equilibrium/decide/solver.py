"""The complete decision: does a grasp hold a wrench passively, and in which ways.

In the plane a search finds an equilibrium or a tree of virtual motions; `state_choices` finds all
equilibria. In space the search may end without either.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cached_property, lru_cache, partial
from itertools import chain, repeat
from typing import TYPE_CHECKING, Any, TypeAlias, cast, overload

import numpy as np

from arrangement.console.number_form import ReprMixin
from arrangement.console.progress import watched
from arrangement.console.workers import done, due
from arrangement.library.arguments import entries
from arrangement.numbers import budget
from arrangement.numbers.exact import Rational, RationalVector, vector_text
from equilibrium.core.contacts import FloatContacts, are_moderate, nearest
from equilibrium.model.assembly import Assembly
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.displacement import read_displacement
from equilibrium.model.effort import STEPS, Effort
from equilibrium.model.errors import EquilibriumError, GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Open, Outcome, Solution, Tree
from equilibrium.plane.coplanar import decide_in_plane

from . import NOT_RESISTED, RESISTED, UNDECIDED
from .as_printed import PrintedVerdict, solve_as_printed
from .planar import PlanarEngine
from .state_choices import StateChoices
from .verdict import Verdict

if TYPE_CHECKING:
    # Questions in the plane start without the search in space.
    from equilibrium.core.memory import Memory, OpenTree
    from equilibrium.core.reach import Reach
    from equilibrium.core.tree import SpatialSearch
    from equilibrium.decide.assemblies.verdict import AssemblyVerdict


@overload
def solve(
    grasp: Grasp,
    wrench: Iterable[Rational],
    *,
    as_printed: None = None,
    time_limit: float | None = None,
    shorten: bool = False,
    nodes: int | None = None,
    pyramid: int | None = None,
    max_displacement: Rational | None = None,
) -> Verdict: ...


@overload
def solve(
    grasp: Grasp, wrench: Iterable[Rational], *, as_printed: Collection[str]
) -> PrintedVerdict: ...


@overload
def solve(
    grasp: Assembly,
    wrench: Mapping[str, Iterable[Rational]],
    *,
    time_limit: float | None = None,
    nodes: int | None = None,
    max_displacement: Rational | None = None,
) -> AssemblyVerdict: ...


def solve(
    grasp: Grasp | Assembly,
    wrench: Iterable[Rational] | Mapping[str, Iterable[Rational]],
    *,
    as_printed: Collection[str] | None = None,
    time_limit: float | None = None,
    shorten: bool = False,
    nodes: int | None = None,
    pyramid: int | None = None,
    max_displacement: Rational | None = None,
) -> Verdict | PrintedVerdict | AssemblyVerdict:
    """Decide exactly whether a grasp resists a wrench; the verdict finds all ways when asked.

    Args:
        grasp: contacts in the object frame; or an assembly of several bodies, which takes
            time_limit, nodes and max_displacement alone, see
            `equilibrium.decide.assemblies.solver`.
        wrench: applied, ``(f_x, f_y, tau)``, the torque about the origin; in space
            ``(f_x, f_y, f_z, tau_x, tau_y, tau_z)``; for an assembly one for each body, by name.
        as_printed: follow the printed text of the paper in these points, and the full model in all
            others; see `equilibrium.decide.as_printed.OPTIONS`. A `PrintedVerdict` is returned, in
            the plane alone, without a certificate; no other option goes with it.
        time_limit: in seconds, by a clock on the wall; `Verdict.warnings` and
            `Verdict.within_error` end then, too. Without one the work is limited, to the same
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
    others: dict[str, object] = {"pyramid": pyramid, "shorten": shorten or None}
    limits = {"time_limit": time_limit, "nodes": nodes, "max_displacement": max_displacement}
    if isinstance(grasp, Assembly):
        _take_none("an assembly", others | {"as_printed": as_printed})
        from .assemblies.solver import solve_assembly

        return solve_assembly(grasp, cast("Mapping[str, Any]", wrench), **cast("Any", limits))
    if as_printed is not None:
        _take_none("as_printed", limits | others)
        return solve_as_printed(grasp, wrench, as_printed)
    solver = Solver(grasp, max_displacement, pyramid)
    return solver.solve(wrench, time_limit=time_limit, shorten=shorten, nodes=nodes)


def _take_none(form: str, options: Mapping[str, object]) -> None:
    for name, value in options.items():
        if value is not None:
            raise GraspError(f"{form} takes no {name}; omit one of the two")


def solve_many(
    grasp: Grasp,
    wrenches: Iterable[Iterable[Rational]],
    *,
    jobs: int = 1,
    dask: str | None = None,
    pyramid: int | None = None,
    max_displacement: Rational | None = None,
) -> Iterator[Verdict]:
    """Yield the verdict of each wrench on one grasp, in order.

    In the plane, where contacts are few, the choices of contact states are tried first: that gives
    the same verdicts, a thousand of eight contacts in seconds, and maybe another one of several
    equilibria. The checker has accepted each equilibrium. The proof that nothing balances a wrench
    is searched for, and checked, when it is asked for.

    In space what one proof leaves for the next is kept for as many wrenches as one process takes at
    once, so answers do not depend on the number of processes.

    Args:
        jobs: processes of this machine, at most: few wrenches are decided sooner by one.
        dask: address of a Dask scheduler whose workers decide.
        pyramid, max_displacement: see `solve`.

    >>> from equilibrium.grasps.files import read_grasp
    >>> grasp = read_grasp("paper-three-contacts-preload-1")
    >>> [verdict.stable for verdict in solve_many(grasp, [[0, 1, 0], [0, 2, 0]])]
    [True, False]
    """
    return Solver(grasp, max_displacement, pyramid).solve_many(wrenches, jobs=jobs, dask=dask)


#: Wrenches that a process takes at once, with one memory in space.
WRENCHES_PER_TASK = 100
#: Steps (see `Effort`) in which a process starts, with room for what it shares the machine with.
_START_STEPS = 6_000_000
#: Steps that one of many wrenches takes for each contact: by all choices of states, else in the
#: plane, and in space.
_STEPS_BY_STATES, _STEPS_PER_CONTACT = 1000, {2: 5000, 3: 20_000}
#: Up to so many contacts of many wrenches all choices of contact states are tried.
MAX_CONTACTS_FOR_ALL_STATES = 12


class Solver(ReprMixin):
    """A grasp prepared for many wrenches: what one question computes serves the next.

    `equilibrium.ResistedSet` is its public form. With a largest displacement only equilibria within
    it count; see the function `solve`.
    """

    repr_fields = ("grasp",)

    def __init__(
        self, grasp: Grasp, max_displacement: Rational | None = None, pyramid: int | None = None
    ) -> None:
        self.grasp, self.max_displacement = grasp, read_displacement(max_displacement)
        self.pyramid = pyramid
        self._edges = None if pyramid is None else pyramid_edges(pyramid, grasp.dimension)

    @property
    def no_wrench(self) -> RationalVector:
        """The wrench 0."""
        return (Fraction(0),) * self.grasp.wrench_size

    def for_grasp(self, grasp: Grasp) -> Solver:
        """Return the solver of another grasp, with the same cones and largest displacement."""
        return Solver(grasp, self.max_displacement, self.pyramid)

    def within(self, max_displacement: Fraction) -> Solver:
        """Return the solver with another largest displacement."""
        return Solver(self.grasp, max_displacement, self.pyramid)

    @cached_property
    def _planar(self) -> PlanarEngine:
        return PlanarEngine(self.grasp, self.max_displacement)

    @property
    def choices(self) -> StateChoices:
        """In the plane all choices of contact states."""
        return self._planar.choices

    @cached_property
    def _memory(self) -> Memory:
        """What proofs in space leave for other wrenches."""
        return _new_memory()

    def solve(
        self,
        wrench: Iterable[Rational],
        *,
        time_limit: float | None = None,
        shorten: bool = False,
        nodes: int | None = None,
    ) -> Verdict:
        """Decide one wrench; see the function `solve`."""
        if time_limit is None:
            return self.decide(wrench, self._usual_effort(), shorten=shorten, nodes=nodes)
        effort = Effort(seconds=time_limit)
        verdict = self.decide(wrench, effort, shorten=shorten, nodes=nodes)
        return replace(verdict, _deadline=effort)

    def decide(
        self,
        wrench: Iterable[Rational],
        effort: Effort,
        *,
        shorten: bool = False,
        nodes: int | None = None,
        memory: Memory | None = None,
    ) -> Verdict:
        """Decide one wrench with the effort that is left; see the function `solve`.

        Args:
            memory: in space, of other wrenches; by default that of this solver.
        """
        applied = self.grasp.read_wrench(wrench)
        if self.grasp.dimension == 3:
            return self._proved(applied, self._search(applied, effort, nodes, memory).decide())
        outcome = self._planar.outcome(applied, effort, shorten=shorten)
        return self._verdict(applied, outcome).accepted()

    def solve_many(
        self, wrenches: Iterable[Iterable[Rational]], *, jobs: int = 1, dask: str | None = None
    ) -> Iterator[Verdict]:
        """Yield the verdict of each wrench, in order; see the function `solve_many`."""
        rows = entries(wrenches, "wrenches", "wrenches")
        applied = [self.grasp.read_wrench(wrench) for wrench in rows]
        starts = range(0, len(applied), WRENCHES_PER_TASK)
        tasks = [applied[k : k + WRENCHES_PER_TASK] for k in starts]
        due(len(tasks), (1, 1), jobs)
        jobs = self._processes(len(applied), len(tasks), jobs)
        if jobs == 1 and dask is None:
            memories = chain.from_iterable(repeat(_new_memory(), len(task)) for task in tasks)
            return map(self._one_of_many, watched(applied, "wrenches"), memories)
        return self._by_workers(tasks, jobs, dask)

    def _processes(self, wrenches: int, tasks: int, jobs: int) -> int:
        """Return 1 where other processes save less work than they take to start."""
        each = (
            _STEPS_BY_STATES if self._has_few_contacts else _STEPS_PER_CONTACT[self.grasp.dimension]
        )
        saved = wrenches * len(self.grasp) * each * (1 - math.ceil(tasks / jobs) / max(1, tasks))
        return jobs if saved > _START_STEPS else 1

    def find_refutation(self, wrench: RationalVector) -> Tree | None:
        """Search for the tree that proves what the choices of contact states have shown."""
        verdict = self.solve(wrench)
        if verdict.stable:
            raise EquilibriumError(
                f"the wrench {vector_text(wrench)} has an equilibrium, but no choice of contact "
                "states has one. This is an internal error; please report it"
            )
        return verdict.tree

    def reach(
        self, refused: RationalVector, resisted: RationalVector, nodes: int, near: float
    ) -> Reach:
        """Return how near resisted loads come to one that is not; see `equilibrium.core.reach`."""
        from equilibrium.core.reach import reach

        change = np.array([nearest(x - y) for x, y in zip(resisted, refused, strict=True)])
        return reach(self._search(refused, Effort()), change, nodes, near)

    def close(self, wrench: RationalVector, tree: OpenTree, nodes: int) -> Verdict:
        """Decide a wrench in space by a tree that is open, and maybe this many further nodes."""
        return self._proved(wrench, self._search(wrench, Effort()).close(tree, nodes))

    def _usual_effort(self) -> Effort:
        return Effort.usual(STEPS[self.grasp.dimension])

    def _search(
        self,
        wrench: RationalVector,
        effort: Effort,
        nodes: int | None = None,
        memory: Memory | None = None,
    ) -> SpatialSearch:
        from equilibrium.core.cones import Pyramids
        from equilibrium.core.tree import SETTINGS, SpatialSearch

        def accept(solution: Solution) -> bool:
            return not self._verdict(wrench, solution).problem

        rows = ContactRows.of_grasp(self.grasp)
        load = rows.total_load(wrench)
        question = self.grasp, load, effort, self.max_displacement
        return SpatialSearch(
            FloatContacts(rows),
            load,
            accept,
            effort,
            nodes=SETTINGS.max_nodes if nodes is None else nodes,
            max_displacement=self.max_displacement,
            cones=None if self._edges is None else Pyramids(self._edges),
            memory=memory or self._memory,
            in_plane=partial(decide_in_plane, *question) if self._edges is None else None,
        )

    def _verdict(self, wrench: RationalVector, outcome: Outcome | None) -> Verdict:
        """Return the verdict of an outcome; None: not resisted, and the tree is not known yet."""
        solution = outcome if isinstance(outcome, Solution) else None
        if isinstance(outcome, Open):
            answer, reason, residual = UNDECIDED, outcome.reason, outcome.residual
        else:
            answer, reason, residual = RESISTED if solution else NOT_RESISTED, "", 0.0
        tree = outcome if isinstance(outcome, dict | list) else None
        bound, pyramid = self.max_displacement, self.pyramid
        question = self.grasp, wrench
        return Verdict(*question, answer, solution, tree, self, bound, pyramid, reason, residual)

    def _proved(self, wrench: RationalVector, outcome: Outcome) -> Verdict:
        """Return the verdict of a search in space, which has accepted equilibria already."""
        verdict = self._verdict(wrench, outcome)
        return verdict.accepted() if isinstance(outcome, dict | list) else verdict

    def _by_workers(
        self, tasks: list[list[RationalVector]], jobs: int, dask: str | None
    ) -> Iterator[Verdict]:
        job = (self.grasp, self.max_displacement, self.pyramid), tasks, budget.times()
        early: dict[int, list[Outcome | None]] = {}
        answered = done(_outcomes, job, range(len(tasks)), jobs, dask)
        results = iter(watched(answered, "parts of wrenches", len(tasks)))
        for number, task in enumerate(tasks):
            while number not in early:
                at, outcomes = next(results)
                early[at] = outcomes
            yield from map(self._verdict, task, early.pop(number))

    @property
    def _has_few_contacts(self) -> bool:
        return self.grasp.dimension == 2 and len(self.grasp) <= MAX_CONTACTS_FOR_ALL_STATES

    def _one_of_many(self, wrench: RationalVector, memory: Memory) -> Verdict:
        """Decide by the choices of contact states, if they are few and none is left open."""
        if not self._has_few_contacts or not are_moderate(wrench):
            return self.decide(wrench, self._usual_effort(), memory=memory)
        piece = self.choices.first_equilibrium(wrench)
        if piece is not None:
            solution = Solution(piece.motion, piece.forces)
            return self._verdict(wrench, solution).accepted()
        missed = self.choices.may_be_missed(wrench)
        return self.solve(wrench) if missed else self._verdict(wrench, None)


def _new_memory() -> Memory:
    from equilibrium.core.memory import Memory

    return Memory()


def prepare(grasp: Grasp | Solver) -> Solver:
    """Return the solver of a planar grasp; a solver is returned as it is.

    Raises:
        GraspError: the grasp is in space.
    """
    solver = grasp if isinstance(grasp, Solver) else Solver(grasp)
    solver.grasp.require_plane()
    return solver


#: What a worker needs: grasp, largest displacement and pyramid; all tasks; and the scale of limits.
Job: TypeAlias = tuple[tuple[Grasp, Fraction | None, int | None], list[list[RationalVector]], float]

#: The solver of a process.
_solver = lru_cache(maxsize=1)(Solver)


def _outcomes(job: Job, number: int) -> tuple[int, list[Outcome | None]]:
    """Return the number of a task, and the outcomes of its wrenches."""
    question, tasks, times = job
    solver, memory = _solver(*question), _new_memory()
    with budget.limit(times):
        return number, [solver._one_of_many(wrench, memory).outcome for wrench in tasks[number]]
