"""For which magnitudes and which frictions an assembly has an equilibrium, part by part.

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
from dataclasses import replace
from fractions import Fraction
from typing import TypeAlias

from arrangement.console.number_form import counted
from arrangement.errors import OutOfReachError
from arrangement.numbers import budget
from arrangement.numbers.linear.intervals import (
    Interval,
    common,
    intersection,
    union,
    where_positive,
)
from equilibrium.decide.solver import STEPS
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.effort import Effort

from .contact_program import ContactProgram, LinearQuestion, Node
from .parts import parts_of, with_root_as_ground

#: States of each part.
Survivors: TypeAlias = tuple[Node, ...]
#: Nodes of the tree of one part.
MAX_NODES = 4000
_ALL: tuple[Interval, ...] = ((Fraction(0), None),)


def assembly_magnitudes(
    assembly: Assembly,
    base: Wrenches,
    along: Wrenches,
    *,
    preload_slope: Fraction = Fraction(0),
    max_displacement: Fraction | None = None,
) -> tuple[Interval, ...]:
    """Return all t >= 0 for which an assembly resists ``base + t along``, exactly.

    Args:
        preload_slope: what each unit of t adds to every preload.

    Returns:
        disjoint, closed, increasing.

    Raises:
        OutOfReachError: a part takes more nodes or steps than the limits allow.
    """
    found = _ALL
    moves = zip(*(parts_of(assembly, wrenches)[1] for wrenches in (base, along)), strict=True)
    for (_, total), (_, slope) in moves:
        rows = [(sign * x, sign * y) for x, y in zip(slope, total, strict=True) for sign in (1, -1)]
        still = where_positive(rows)
        found = common(found, () if still is None else (still,))
    for question in _questions(assembly, base, along):
        if found:
            changed = replace(
                question, preload_slope=preload_slope, max_displacement=max_displacement
            )
            found = common(found, _magnitudes(changed))
    return found


def surviving_states(
    assembly: Assembly,
    wrenches: Wrenches,
    frictions: Interval,
    known: Survivors = (),
    max_displacement: Fraction | None = None,
) -> Survivors | None:
    """Return states of each part that a range of friction coefficients does not refute.

    Each contact may have its own coefficient anywhere in the range. None if no states of some part
    are left: no coefficient of the range resists the wrenches.

    Args:
        known: of a wider range; they are tried first.
    """
    found = []
    questions = list(_questions(assembly, wrenches, assembly.read_wrenches({})))
    if any(any(total) for _, total in parts_of(assembly, wrenches)[1]):
        return None
    for question, first in zip(questions, known or [None] * len(questions), strict=True):
        ranged = replace(question, frictions=frictions, max_displacement=max_displacement)
        if first is not None and ContactProgram(ranged, first).feasible:
            found.append(first)
        elif (states := _survivor(ranged)) is not None:
            found.append(states)
        else:
            return None
    return tuple(found)


def _questions(assembly: Assembly, base: Wrenches, along: Wrenches) -> Iterator[LinearQuestion]:
    """Yield the question of each part, those of few contacts first."""
    both = zip(*(parts_of(assembly, wrenches)[0] for wrenches in (base, along)), strict=True)
    for part, slope in sorted(both, key=lambda pair: len(pair[0].contacts)):
        load, change = (
            tuple(x for name in part.bodies for x in one.wrenches[name]) for one in (part, slope)
        )
        yield LinearQuestion(with_root_as_ground(assembly, part).rows, load, change)


class _Tree:
    """The nodes of a tree of contact states, depth first, within the limits on their number.

    Attributes:
        waiting: states that are still to be looked at.
    """

    def __init__(self, question: LinearQuestion) -> None:
        self.question = question
        self.effort = Effort(STEPS[3] * budget.times())
        self.waiting: list[Node] = [("undecided",) * len(question.rows)]

    def __iter__(self) -> Iterator[ContactProgram]:
        most = math.ceil(MAX_NODES * budget.times())
        for _ in range(most):
            if not self.waiting:
                return
            yield ContactProgram(self.question, self.waiting.pop(), self.effort)
        if self.waiting:
            raise TimeoutError(f"limit of {most:,} nodes")


@contextmanager
def _limited(question: LinearQuestion) -> Iterator[_Tree]:
    """Give a tree, whose limits are errors.

    Raises:
        OutOfReachError: one is passed.
    """
    try:
        yield _Tree(question)
    except TimeoutError as late:
        contacts, more = counted(len(question.rows), "contact"), math.ceil(2 * budget.times())
        raise OutOfReachError(
            f"undecided: {late} for {contacts} in one part; --limit {more} allows more"
        ) from None


def _magnitudes(question: LinearQuestion) -> tuple[Interval, ...]:
    """Return all t >= 0 with an equilibrium of one part."""
    found: tuple[Interval, ...] = ()
    with _limited(question) as tree:
        for program in tree:
            ends = program.ends()
            if not ends or _covers(found, part := (ends[0].t, ends[-1].t)):
                continue
            if program.is_complete:
                found = union([*found, part])
                continue
            for end in ends:
                if end.is_lawful:
                    own = ContactProgram(question, end.states, tree.effort).ends()
                    found = union([*found, (own[0].t, own[-1].t)])
            if not _covers(found, part):
                tree.waiting += program.split(max((end.violations for end in ends), key=max))
    return found


def _survivor(question: LinearQuestion) -> Node | None:
    """Return states whose program has a solution; None if there are none."""
    with _limited(question) as tree:
        for program in tree:
            start = program.start()
            if start is None:
                continue
            if program.is_complete:
                return program.states
            if start.is_lawful:
                return start.states
            tree.waiting += program.split(start.violations)
    return None


def _covers(found: tuple[Interval, ...], part: Interval) -> bool:
    return any(intersection(part, one) == part for one in found)
