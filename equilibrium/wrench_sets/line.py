"""Which magnitudes of a wrench along a direction a grasp resists: exact intervals.

With the contact states fixed, the wrench stands only in the constants of the balances. So along
``base + t direction`` every choice of states allows one closed interval of t. Their union over all
states is exact, and it need not be one interval that starts at 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import chain
from typing import Any

from arrangement.console.number_form import JsonMixin, ReprMixin
from arrangement.console.progress import watched
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.intervals import Interval, common, holds, texts, union
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.core.contact_rows import sum_row
from equilibrium.decide.assemblies.magnitudes import magnitudes_by_states
from equilibrium.decide.nearby import DEPENDS
from equilibrium.decide.robustness import MAX_ROUNDINGS, met_within_error, others
from equilibrium.decide.solver import Solver, prepare
from equilibrium.decide.verdict import Verdict
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.errors import GraspError, UndecidedError
from equilibrium.model.subject import Subject, by_body, read_load, rows_of
from equilibrium.plane.states.contact_states import Codes, states_of_code

#: All magnitudes.
ALL: Interval = (Fraction(0), None)


@dataclass(frozen=True, repr=False)
class Magnitudes(JsonMixin):
    """All t >= 0 with ``base + t direction`` resisted.

    Attributes:
        base, direction: wrenches ``(f_x, f_y, tau)``; of an assembly one for each body.
        intervals: disjoint, closed, increasing; an upper end None means unbounded.
    """

    json_fields = ("intervals",)

    base: RationalVector | Wrenches
    direction: RationalVector | Wrenches
    intervals: tuple[Interval, ...]

    @property
    def unlimited(self) -> bool:
        """Whether every magnitude above some value is resisted."""
        return bool(self.intervals) and self.intervals[-1][1] is None

    def contains(self, magnitude: Fraction) -> bool:
        """Return whether this magnitude is resisted."""
        return holds(self.intervals, magnitude)


def resisted_magnitudes(grasp: Subject | Solver, direction: Any, base: Any = None) -> Magnitudes:
    """Return the exact set of t >= 0 for which ``base + t direction`` is resisted.

    See `ResistedSet.along`; the grasp is in the plane.

    Complexity: two small systems for each choice of contact states, in floating point with a proven
    error bound; for those that this leaves possible two exact linear programs. Of an assembly by a
    tree of states. Source: [HaasHeger2018], the maps of resisted forces, without search.

    >>> from equilibrium import read_grasp
    >>> resisted_magnitudes(read_grasp("paper-three-contacts-preload-1"), [0, 1, 0]).intervals
    ((Fraction(0, 1), Fraction(1, 1)),)
    """
    solver = prepare(grasp)
    along = solver.read(direction)
    start = solver.no_wrench if base is None else solver.read(base)
    if along == solver.no_wrench:
        raise GraspError("direction is zero; give a wrench other than zero")
    find = _of_assembly if isinstance(solver.grasp, Assembly) else _of_grasp
    return Magnitudes(start, along, find(solver, start, along))


def _of_grasp(solver: Solver, base: RationalVector, along: RationalVector) -> tuple[Interval, ...]:
    solver.choices.check_cost()
    screen, bound = solver.choices.screen, solver.max_displacement
    question = LinearQuestion(rows_of(solver.grasp), base, along, max_displacement=bound)
    parts = magnitudes_with(question, screen.codes[screen.possible(base, along)])
    # The screen speaks of t > 0 only.
    if not any(low == 0 for low, _ in parts) and solver.solve(base).stable:
        parts.append((Fraction(0), Fraction(0)))
    return union(parts)


def magnitudes_with(question: LinearQuestion, codes: Codes) -> list[Interval]:
    """Return the magnitudes with a solution of each choice of contact states that has some."""
    choices = map(states_of_code, watched(codes.tolist(), "contact states"))
    intervals = (ContactProgram(question, states).magnitudes() for states in choices)
    return [part for part in intervals if part is not None]


def _of_assembly(solver: Solver, base: Wrenches, along: Wrenches) -> tuple[Interval, ...]:
    loaded = any(c.contact.preload or c.contact.adhesion for c in solver.grasp.contacts)
    if base == solver.no_wrench and not loaded and solver.max_displacement is None:
        # Without preload and adhesion the law scales: one verdict is that of all t > 0.
        verdict = solver.solve(along)
        if verdict.decided:
            return ((Fraction(0), None if verdict else Fraction(0)),)
    bound = solver.max_displacement
    return magnitudes_by_states(solver.grasp, base, along, max_displacement=bound)


@dataclass(frozen=True, repr=False)
class RoundedEnds(ReprMixin):
    """How far the ends of the resisted magnitudes move within the error of the data.

    Attributes:
        asked: the number of other grasps within the error whose magnitudes were computed.
        ends: for each end of each interval, in order, the least and the greatest value; None where
            the interval is unbounded.
        turned: the intervals of the first grasp that has another number of them, or of bounded
            ends; the search stops there.
    """

    asked: int
    ends: tuple[Interval | None, ...]
    turned: tuple[Interval, ...] | None = None

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        ends = [None if pair is None else texts(pair) for pair in self.ends]
        if self.turned is None:
            return {"asked": self.asked, "ends": ends}
        return {"asked": self.asked, "verdict": DEPENDS, "turned": list(map(texts, self.turned))}


def ends_within_error(solver: Solver, magnitudes: Magnitudes) -> RoundedEnds | None:
    """Return the ends for other grasps within the error of converted data; None for exact data.

    The grasps are those that test the verdict at the last end, and those that resist a load beyond
    it. A grasp that breaks incidences of the data can only shorten the intervals.
    """
    if solver.grasp.data_error is None:
        return None
    line = magnitudes.direction, magnitudes.base
    along, base = (read_load(solver.grasp, wrench) for wrench in line)

    def verdict_at(t: Fraction) -> Verdict:
        return solver.solve(by_body(solver.grasp, sum_row(base, along, t)))

    low, high = magnitudes.intervals[-1] if magnitudes.intervals else (Fraction(0), None)
    end = (low or Fraction(0)) + 1 if high is None else high
    verdict = verdict_at(end)
    ends, breaking = [[*chain(*magnitudes.intervals)]], range(0)
    asked = [*others(verdict)]
    if verdict.decided and verdict.stable:
        breaking = range(MAX_ROUNDINGS, 0 if solver.grasp.data_error.as_given else len(asked))
        asked += met_within_error(verdict_at(end + 1))
    for k, subject in enumerate(asked):
        try:
            other = resisted_magnitudes(Solver(subject, solver.max_displacement), *line).intervals
        except UndecidedError:
            continue
        if k in breaking:
            other = common(other, magnitudes.intervals)
        ends.append([*chain(*other)])
        if [end is None for end in ends[0]] != [end is None for end in ends[-1]]:
            return RoundedEnds(len(ends) - 1, (), other)
    columns: Any = zip(*ends, strict=True)
    pairs = (None if None in column else (min(column), max(column)) for column in columns)
    return RoundedEnds(len(ends) - 1, tuple(pairs))
