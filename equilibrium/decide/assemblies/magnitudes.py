"""For which magnitudes and which frictions an assembly has equilibria, and all of these.

Each complete choice of contact states allows one closed interval of magnitudes t, by two exact
programs. The union over all choices is found in a tree of states: a node is closed if its
relaxation allows no t, or none that is not known to be resisted. Where its first or last solution
obeys the law, the states of that give an interval at once. An assembly is in equilibrium where
all its parts are.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any, NamedTuple, TypeAlias

from arrangement.console.number_form import counted
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, to_text
from arrangement.numbers.linear.intervals import (
    Interval,
    common,
    intersection,
    union,
    where_positive,
)
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram, Node
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.effort import STEPS, Effort
from equilibrium.model.errors import UndecidedError
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from equilibrium.model.subject import Subject, no_load
from equilibrium.plane.states.equilibrium import maximal

from .parts import AssemblyPart, parts_of, with_root_as_ground

#: States of each part.
Survivors: TypeAlias = tuple[Node, ...]
#: Nodes of the tree of one part.
MAX_NODES = 4000
_ALL: tuple[Interval, ...] = ((Fraction(0), None),)


def magnitudes_by_states(
    subject: Subject,
    base: Any,
    along: Any,
    chosen: frozenset[int] | None = None,
    **changes: Any,
) -> tuple[Interval, ...]:
    """Return all t >= 0 for which an assembly, or a grasp in the plane, resists ``base + t along``.

    Args:
        chosen: places of the contacts that `preload_slope` is about; None for all.
        changes: preload_slope, max_displacement; see `LinearQuestion`.

    Returns:
        disjoint, closed, increasing.

    Raises:
        UndecidedError: a part takes more nodes or steps than the limits allow.
    """
    intervals = _ALL
    if isinstance(subject, Assembly):
        floating = (parts_of(subject, wrenches)[1] for wrenches in (base, along))
        for (_, total), (_, slope) in zip(*floating, strict=True):
            pairs = zip(slope, total, strict=True)
            still = where_positive([(s * x, s * y) for x, y in pairs for s in (1, -1)])
            intervals = common(intervals, () if still is None else (still,))
    for _, question in part_questions(subject, base, along, chosen, **changes):
        if intervals:
            intervals = common(intervals, _magnitudes(question))
    return intervals


def surviving_states(
    assembly: Assembly,
    wrenches: Wrenches,
    frictions: Interval,
    known: Survivors = (),
    chosen: frozenset[int] | None = None,
    max_displacement: Fraction | None = None,
) -> Survivors | None:
    """Return states of each part that a range of friction coefficients does not refute.

    Each contact may have its own coefficient anywhere in the range. None if no states of some part
    are left: no coefficient of the range resists the wrenches.

    Args:
        known: of a wider range; they are tried first.
        chosen: places of the contacts with these coefficients, the others have their own; None
            for all.

    Raises:
        UndecidedError: a part takes more nodes or steps than the limits allow.
    """
    survivors = []
    changes = {"frictions": frictions, "max_displacement": max_displacement}
    pairs = part_questions(assembly, wrenches, no_load(assembly), chosen, **changes)
    questions = [question for _, question in pairs]
    if any(any(total) for _, total in parts_of(assembly, wrenches)[1]):
        return None
    for ranged, first in zip(questions, known or [None] * len(questions), strict=True):
        if first is not None and ContactProgram(ranged, first).feasible:
            survivors.append(first)
        elif (states := _survivor(ranged)) is not None:
            survivors.append(states)
        else:
            return None
    return tuple(survivors)


class PartEquilibrium(NamedTuple):
    """All equilibria of one part with one choice of contact states: a convex polyhedron.

    Attributes:
        contacts: their numbers in the assembly.
        states: of these contacts; the conditions are closed.
        forces: (normal, tangential) on body_a at each of them, of one of the equilibria.
        unique: whether all of them have these forces.
    """

    contacts: tuple[int, ...]
    states: Node
    forces: tuple[RationalVector, ...]
    unique: bool

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {
            "contacts": list(self.contacts),
            "states": list(self.states),
            "forces": [list(map(to_text, force)) for force in self.forces],
            "forces_determined": self.unique,
        }


def part_equilibria(
    assembly: Assembly, wrenches: Wrenches, max_displacement: Fraction | None = None
) -> tuple[tuple[PartEquilibrium, ...], ...]:
    """Return the equilibria of each part; those of different parts combine freely.

    Returns:
        for each part the maximal sets of equilibria with one choice of states. Sets may touch; none
        lies in another.

    Raises:
        UndecidedError: a part has too many choices of states.
    """
    equilibria = []
    still = no_load(assembly)
    questions = part_questions(assembly, wrenches, still, max_displacement=max_displacement)
    for part, question in questions:
        assert part is not None
        with _limited(question) as tree:
            kept = maximal(list(complete_programs(tree)))
        sets = []
        for program in kept:
            solution = program.solution()
            assert solution is not None
            states, unique = program.states, program.has_one_solution
            sets.append(PartEquilibrium(part.contacts, states, solution.forces, unique))
        equilibria.append(tuple(sets))
    return tuple(equilibria)


def complete_programs(tree: StateTree) -> Iterator[ContactProgram]:
    """Yield the programs of all complete choices of states that have a solution."""
    for program in tree:
        start = program.start()
        if start is not None and program.is_complete:
            yield program
        elif start is not None:
            tree.waiting += program.split(start.violations)


def part_questions(
    subject: Subject,
    base: Any,
    along: Any,
    chosen: frozenset[int] | None = None,
    **changes: Any,
) -> Iterator[tuple[AssemblyPart | None, LinearQuestion]]:
    """Yield each part with its question, those of few contacts first; one without for a grasp.

    Args:
        changes: what else the questions have, see `LinearQuestion`.
    """
    if isinstance(subject, Grasp):
        shares = tuple(contact.share for contact in subject)
        options = {"chosen": chosen, "shares": shares, **changes}
        yield None, LinearQuestion(ContactRows.of_grasp(subject), base, along, **options)
        return
    both = zip(*(parts_of(subject, wrenches)[0] for wrenches in (base, along)), strict=True)
    for part, slope in sorted(both, key=lambda pair: len(pair[0].contacts)):
        load, change = (
            tuple(x for name in part.bodies for x in one.wrenches[name]) for one in (part, slope)
        )
        places = enumerate(part.contacts)
        own = None if chosen is None else frozenset(k for k, i in places if i in chosen)
        rows = with_root_as_ground(subject, part).rows
        yield part, LinearQuestion(rows, load, change, chosen=own, **changes)


class StateTree:
    """The nodes of a tree of contact states, depth first, within the limits on their number.

    Iteration raises TimeoutError where a limit is reached.

    Args:
        effort, max_nodes: the limits; if omitted, the usual ones.

    Attributes:
        waiting: states that are still to be looked at.
        nodes: those that were.
    """

    def __init__(
        self,
        question: LinearQuestion,
        effort: Effort | None = None,
        max_nodes: float | None = None,
    ) -> None:
        self.question = question
        self.effort = effort or Effort.usual(STEPS[3])
        self.max_nodes = MAX_NODES * budget.times() if max_nodes is None else max_nodes
        self.nodes = 0
        self.waiting: list[Node] = [("undecided",) * len(question.rows)]

    def __iter__(self) -> Iterator[ContactProgram]:
        while self.waiting:
            if self.nodes >= self.max_nodes:
                raise TimeoutError
            self.nodes += 1
            yield ContactProgram(self.question, self.waiting.pop(), self.effort)


@contextmanager
def _limited(question: LinearQuestion) -> Iterator[StateTree]:
    """Give a tree, whose limits leave the question undecided.

    Raises:
        UndecidedError: one is passed.
    """
    tree = StateTree(question)
    try:
        yield tree
    except TimeoutError as late:
        contacts, more = counted(len(question.rows), "contact"), math.ceil(2 * budget.times())
        limit = f", {late}" if late.args else ""
        raise UndecidedError(
            f"after {counted(tree.nodes, 'node')}{limit}, the tree of a part with {contacts} is "
            f"not closed; {budget.raised_limit(more)} allows more"
        ) from None


def _magnitudes(question: LinearQuestion) -> tuple[Interval, ...]:
    """Return all t >= 0 with an equilibrium of one part."""
    intervals: tuple[Interval, ...] = ()
    with _limited(question) as tree:
        for program in tree:
            ends = program.ends()
            if not ends or _covers(intervals, part := (ends[0].t, ends[-1].t)):
                continue
            if program.is_complete:
                intervals = union([*intervals, part])
                continue
            for end in ends:
                if end.is_lawful:
                    own = ContactProgram(question, end.states, tree.effort).ends()
                    intervals = union([*intervals, (own[0].t, own[-1].t)])
            if not _covers(intervals, part):
                # Where an end is resisted, what it violates says nothing about the other.
                open_ = [end for end in ends if not _covers(intervals, (end.t, end.t))] or ends
                tree.waiting += program.split(max((end.violations for end in open_), key=max))
    return intervals


def _survivor(question: LinearQuestion) -> Node | None:
    """Return states whose program has a solution; None if there are none."""
    with _limited(question) as tree:
        for program in tree:
            start = program.start() if program.feasible else None
            if start is None:
                continue
            if program.is_complete:
                return program.states
            if start.is_lawful:
                return start.states
            tree.waiting += program.split(start.violations)
    return None


def _covers(intervals: tuple[Interval, ...], part: Interval) -> bool:
    return any(intersection(part, interval) == part for interval in intervals)
