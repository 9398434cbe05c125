"""The complete decision: does a grasp hold a wrench passively, and in which ways.

In the plane a search finds an equilibrium or a tree of virtual motions; `state_choices` finds all
equilibria. In space the search may end without either.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from itertools import chain, repeat
from typing import TYPE_CHECKING, Any, TypeAlias, overload

import numpy as np

from arrangement.console.number_form import ReprMixin
from arrangement.console.progress import watched
from arrangement.console.workers import part_numbers, run_parts
from arrangement.hints import hints_on_arguments
from arrangement.numbers import budget
from arrangement.numbers.arguments import entries
from arrangement.numbers.exact import Rational, RationalVector
from equilibrium.core.contacts import are_moderate, nearest
from equilibrium.model.assembly import Assembly
from equilibrium.model.displacement import read_displacement
from equilibrium.model.effort import STEPS, Effort
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Open, Refutation, Solution
from equilibrium.model.subject import LoadCase, Subject, by_body, check_subject, no_load, read_load
from equilibrium.model.synonyms import ARGUMENTS

from .as_printed import PrintedVerdict, solve_as_printed
from .engines import PlanarEngine, SpatialEngine, answered, new_memory
from .state_choices import StateChoices
from .verdict import Verdict, engine_of

if TYPE_CHECKING:
    # Questions in the plane start without the search in space.
    from equilibrium.core.memory import Memory, OpenTree
    from equilibrium.core.tree import Reach, SpatialSearch

#: A wrench; of an assembly one for each body, by name.
Load: TypeAlias = Iterable[Any] | Mapping[str, Iterable[Any]]


@overload
def solve(
    grasp: Subject,
    wrench: Load,
    *,
    as_printed: None = None,
    time_limit: float | None = None,
    shorten: bool = False,
    nodes: int | None = None,
    pyramid: int | None = None,
    max_displacement: Rational | None = None,
) -> Verdict: ...


@overload
def solve(grasp: Grasp, wrench: Load, *, as_printed: Collection[str]) -> PrintedVerdict: ...


@hints_on_arguments(ARGUMENTS)
def solve(
    grasp: Subject,
    wrench: Load,
    *,
    as_printed: Collection[str] | None = None,
    time_limit: float | None = None,
    shorten: bool = False,
    nodes: int | None = None,
    pyramid: int | None = None,
    max_displacement: Rational | None = None,
) -> Verdict | PrintedVerdict:
    """Decide exactly whether a grasp resists a wrench; the verdict finds all ways when asked.

    Args:
        grasp: contacts in the object frame; or an assembly of several bodies, which takes
            time_limit, nodes and max_displacement alone.
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

    >>> from equilibrium import read_grasp
    >>> solve(read_grasp("paper-three-contacts-preload-1"), [0, 1, 0]).stable
    True
    >>> solve(read_grasp("two-opposed-fingers"), [0, "3/5", "4/5", 0, 0, 0]).verdict
    'resisted'
    >>> solve(read_grasp("single-contact"), [0, 0, 0], as_printed=["all-stick"]).options
    ('all-stick',)
    """
    check_subject(grasp)
    unfit: dict[str, Any] = {"pyramid": pyramid, "shorten": shorten or None}
    form = "an assembly" if isinstance(grasp, Assembly) else "as_printed"
    if isinstance(grasp, Assembly):
        unfit["as_printed"] = as_printed
    elif as_printed is None:
        unfit = {}
    else:
        unfit |= {"time_limit": time_limit, "nodes": nodes, "max_displacement": max_displacement}
    for name, value in unfit.items():
        if value is not None:
            raise GraspError(f"{form} takes no {name}; omit one of the two")
    if as_printed is not None and not isinstance(grasp, Assembly):
        return solve_as_printed(grasp, wrench, as_printed)
    solver = Solver(grasp, max_displacement, pyramid)
    return solver.solve(wrench, time_limit=time_limit, shorten=shorten, nodes=nodes)


@hints_on_arguments(ARGUMENTS)
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

    >>> from equilibrium import read_grasp
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
    """A grasp or an assembly prepared for many loads: what one question computes serves the next.

    `equilibrium.ResistedSet` is its public form. With a largest displacement only equilibria within
    it count; see the function `solve`.
    """

    repr_fields = ("grasp",)

    def __init__(
        self, grasp: Subject, max_displacement: Rational | None = None, pyramid: int | None = None
    ) -> None:
        check_subject(grasp)
        self.max_displacement, self.pyramid = read_displacement(max_displacement), pyramid
        self.grasp: Any = grasp
        self.engine = engine_of(grasp, self.max_displacement, pyramid)

    @property
    def no_wrench(self) -> Any:
        """The wrench 0; of an assembly on each body."""
        return no_load(self.grasp)

    def read(self, load: Load) -> Any:
        """Return a wrench in exact numbers; of an assembly one for each body."""
        return by_body(self.grasp, read_load(self.grasp, load))

    @property
    def choices(self) -> StateChoices:
        """In the plane all choices of contact states."""
        assert isinstance(self.engine, PlanarEngine)
        return self.engine.choices

    def solve(
        self,
        wrench: Load,
        *,
        time_limit: float | None = None,
        shorten: bool = False,
        nodes: int | None = None,
        steps: float | None = None,
        memory: Memory | None = None,
    ) -> Verdict:
        """Decide one wrench; see the function `solve`.

        Args:
            steps: in place of the usual ones.
            memory: in space, of other wrenches; by default that of this solver.
        """
        if time_limit is not None:
            effort = Effort(seconds=time_limit)
        else:
            usual = STEPS[2 if isinstance(self.engine, PlanarEngine) else 3]
            effort = Effort.usual(usual) if steps is None else Effort(steps)
        load = read_load(self.grasp, wrench)
        outcome = self.engine.outcome(load, effort, shorten=shorten, nodes=nodes, memory=memory)
        verdict = self._verdict(load, outcome).accepted()
        return verdict if time_limit is None else replace(verdict, _deadline=effort)

    def solve_many(
        self, wrenches: Iterable[Iterable[Rational]], *, jobs: int = 1, dask: str | None = None
    ) -> Iterator[Verdict]:
        """Yield the verdict of each wrench, in order; see the function `solve_many`."""
        rows = entries(wrenches, "wrenches", "wrenches")
        applied = [self.grasp.read_wrench(wrench) for wrench in rows]
        starts = range(0, len(applied), WRENCHES_PER_TASK)
        tasks = [applied[k : k + WRENCHES_PER_TASK] for k in starts]
        part_numbers(len(tasks), (1, 1), jobs)
        jobs = self._processes(len(applied), len(tasks), jobs)
        if jobs == 1 and dask is None:
            memories = chain.from_iterable(repeat(new_memory(), len(task)) for task in tasks)
            return map(self._one_of_many, watched(applied, "wrenches"), memories)
        return self._by_workers(tasks, jobs, dask)

    def _processes(self, wrenches: int, tasks: int, jobs: int) -> int:
        """Return 1 where other processes save less work than they take to start."""
        each = (
            _STEPS_BY_STATES if self._has_few_contacts else _STEPS_PER_CONTACT[self.grasp.dimension]
        )
        saved = wrenches * len(self.grasp) * each * (1 - math.ceil(tasks / jobs) / max(1, tasks))
        return jobs if saved > _START_STEPS else 1

    def reach(
        self, refused: RationalVector, resisted: RationalVector, nodes: int, near: float
    ) -> Reach:
        """Return how near resisted loads come to one that is not; see `SpatialSearch.reach`."""
        change = np.array([nearest(x - y) for x, y in zip(resisted, refused, strict=True)])
        return self._search(refused).reach(change, nodes, near)

    def close(self, wrench: RationalVector, tree: OpenTree, nodes: int) -> Verdict:
        """Decide a wrench in space by a tree that is open, and maybe this many further nodes."""
        outcome = answered(self._search(wrench).close(tree, nodes))
        return self._verdict(wrench, outcome).accepted()

    def _search(self, wrench: RationalVector) -> SpatialSearch:
        assert isinstance(self.engine, SpatialEngine)
        return self.engine.search(wrench, Effort())

    def _verdict(self, load: RationalVector, outcome: Solution | Refutation | Open) -> Verdict:
        case = LoadCase(self.grasp, load, self.max_displacement, self.pyramid)
        return Verdict.of(case, self.engine, outcome)

    def _by_workers(
        self, tasks: list[list[RationalVector]], jobs: int, dask: str | None
    ) -> Iterator[Verdict]:
        job = (self.grasp, self.max_displacement, self.pyramid), tasks, budget.times()
        early: dict[int, list[Solution | Refutation | Open]] = {}
        answered = run_parts(_outcomes, job, range(len(tasks)), jobs, dask)
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
            return self.solve(wrench, memory=memory)
        piece = self.choices.first_equilibrium(wrench)
        if piece is not None:
            solution = Solution(piece.motion, piece.forces)
            return self._verdict(wrench, solution).accepted()
        missed = self.choices.may_be_missed(wrench)
        return self.solve(wrench) if missed else self._verdict(wrench, Refutation(None))


def prepare(grasp: Subject | Solver) -> Solver:
    """Return the solver of a planar grasp, or of an assembly; a solver is returned as it is.

    Raises:
        GraspError: the grasp is in space.
    """
    solver = grasp if isinstance(grasp, Solver) else Solver(grasp)
    if not isinstance(solver.grasp, Assembly):
        solver.grasp.require_plane()
    return solver


#: What a worker needs: grasp, largest displacement and pyramid; all tasks; and the scale of limits.
Job: TypeAlias = tuple[tuple[Grasp, Fraction | None, int | None], list[list[RationalVector]], float]

#: The solver of a process.
_solver = lru_cache(maxsize=1)(Solver)


def _outcomes(job: Job, number: int) -> tuple[int, list[Solution | Refutation | Open]]:
    """Return the number of a task, and the outcomes of its wrenches."""
    question, tasks, times = job
    solver, memory = _solver(*question), new_memory()
    with budget.limit(times):
        return number, [solver._one_of_many(wrench, memory).outcome for wrench in tasks[number]]
