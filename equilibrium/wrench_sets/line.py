"""Which magnitudes of a wrench along a direction a grasp resists, and which preloads: intervals.

With the contact states fixed, the wrench stands only in the constants of the balances. So along
``base + t direction`` every choice of states allows one closed interval of t. Their union over all
states is exact, and it need not be one interval that starts at 0.

Preloads are intervals, too. The equations are homogeneous in motion, forces, wrench and preload
together. So a grasp whose preloads are p times those of another resists w exactly when the other
one resists w / p, if no range bounds motions and forces. Here w is the load with all adhesion; that
is not scaled with the load where this is asked for factors.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any

from arrangement.console.number_form import LABEL, JsonMixin, ReprMixin
from arrangement.console.progress import watched
from arrangement.errors import OutOfReachError
from arrangement.numbers.exact import RationalVector, shown
from arrangement.numbers.linear.intervals import Interval, common, holds, texts, union
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.core.contact_rows import negated, sum_row
from equilibrium.decide.assemblies.ends import ends_of
from equilibrium.decide.assemblies.magnitudes import magnitudes_by_states, part_questions
from equilibrium.decide.nearby import DEPENDS
from equilibrium.decide.robustness import MAX_ROUNDINGS, met_within_error, others
from equilibrium.decide.solver import Solver, prepare
from equilibrium.decide.state_choices import StateChoices
from equilibrium.decide.verdict import Verdict
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.errors import GraspError, UndecidedError
from equilibrium.model.grasp import Grasp, chosen_contacts
from equilibrium.model.subject import Subject, by_body, read_load, rows_of
from equilibrium.plane.states.contact_states import Codes, states_of_code

from .friction import TOLERANCE, FrictionBracket, least_friction

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


@dataclass(frozen=True, repr=False)
class Margin(JsonMixin):
    """How a wrench may be scaled.

    Attributes:
        resisted: whether the wrench itself is resisted.
        intervals: all s >= 0 with s times the wrench resisted, disjoint, closed, increasing.
    """

    json_fields = ("resisted", "around", "nearest", "intervals")

    wrench: RationalVector | Wrenches
    resisted: bool
    intervals: tuple[Interval, ...]
    _solver: Solver = field(compare=False)

    def __bool__(self) -> bool:
        """Return whether the wrench itself is resisted."""
        return self.resisted

    @property
    def around(self) -> Interval | None:
        """The interval of factors around 1, its ends on the boundary; None if not resisted.

        Its upper end is the largest s with t times the wrench resisted for all t in [1, s]; None
        there means that no factor is too large.
        """
        return next((part for part in self.intervals if holds([part], Fraction(1))), None)

    @property
    def nearest(self) -> Fraction | None:
        """Of a wrench that is not resisted: the factor of a resisted one nearest to 1, if any."""
        ends = [end for part in self.intervals for end in part if end is not None]
        if self.resisted:
            return Fraction(1)
        return min(ends, key=lambda end: abs(end - 1), default=None)

    @property
    def magnitudes(self) -> Magnitudes:
        """The factors as magnitudes of the wrench."""
        return Magnitudes(self._solver.no_wrench, self.wrench, self.intervals)

    @cached_property
    def preloads(self) -> Preloads:
        """All uniform preloads with which the wrench is resisted, exactly."""
        if isinstance(self._solver.grasp, Assembly):
            return chosen_preloads(self._solver, [self.wrench])
        return sufficient_preloads(self._solver, self.wrench)

    def friction(
        self, tolerance: Any = TOLERANCE, contacts: Iterable[int] | None = None
    ) -> FrictionBracket:
        """Bracket the least friction coefficient, the same at all contacts that have friction.

        Contacts of friction 0 stay smooth.

        Args:
            tolerance: the wanted length of the bracket. It comes out longer where coefficients are
                resisted only on a range shorter than this, or just missed by less than this.
            contacts: numbers, from 1, of those that get the coefficient, smooth ones too; the
                others keep their own.

        Raises:
            GraspError: a tolerance below 2^-100, or no such contact.
            OutOfReachError: too many ranges of that length are neither refuted nor resisted.
        """
        return least_friction(self._solver, self.wrench, tolerance, contacts)


#: Up to this many contacts pictures state what gives at the limit of a load.
_MAX_CONTACTS_IN_WORDS = 12
#: How often a margin tries all states, about: for the wrench, for preloads, for friction.
_QUERIES = 6


def margin(grasp: Grasp | Solver, wrench: Any) -> Margin:
    """Return the exact factors by which a wrench may be scaled; see `ResistedSet.margin`.

    >>> from equilibrium import read_grasp
    >>> margin(read_grasp("paper-three-contacts-preload-1"), [0, "1/2", 0]).around
    (Fraction(0, 1), Fraction(2, 1))
    """
    solver = prepare(grasp)
    w = solver.read(wrench)
    if isinstance(solver.grasp, Grasp):
        solver.choices.check_cost(_QUERIES)
    if w != solver.no_wrench:
        factors = resisted_magnitudes(solver, w).intervals
    else:
        factors = (ALL,) if solver.solve(w).stable else ()
    return Margin(w, holds(factors, Fraction(1)), factors, solver)


def limit_words(solver: Solver, wrench: Any) -> list[str]:
    """Return at which multiples of a load, next to it, its resistance ends, and what gives there.

    Empty where that is not established, where one multiple alone is resisted, and of many contacts,
    for which it takes long.
    """
    if len(solver.grasp) > _MAX_CONTACTS_IN_WORDS or solver.read(wrench) == solver.no_wrench:
        return []
    try:
        factors = resisted_magnitudes(solver, wrench).intervals
    except (OutOfReachError, UndecidedError):
        return []
    near = min(factors, key=_distance, default=None)
    if near is None or near[0] == near[1]:
        return []
    giving = ends_of(solver.grasp, solver.no_wrench, wrench, [near], solver.max_displacement)
    return [
        f"{word} {LABEL.number(end)} times the load: {what.words}"
        for word, end, what in zip(("from", "up to"), near, *giving, strict=True)
        if end is not None and what is not None
    ]


def _distance(factors: Interval) -> Fraction:
    """Return how far 1 is from an interval of factors."""
    low, high = factors
    return max((low or Fraction(0)) - 1, Fraction(0) if high is None else 1 - high, Fraction(0))


@dataclass(frozen=True)
class Preloads(JsonMixin):
    """All p >= 0 for which some wrenches are resisted when preloads are p.

    Attributes:
        wrenches: resisted, each of them.
        contacts: numbers, from 1, of those whose preload is p, which a pad shares out; the others
            keep their own.
        intervals: disjoint, closed, increasing; an upper end None means unbounded.
    """

    json_fields = ("least", "intervals")

    wrenches: tuple[RationalVector | Wrenches, ...]
    contacts: tuple[int, ...]
    intervals: tuple[Interval, ...]

    @property
    def least(self) -> Fraction | None:
        """The least uniform preload; None when none is enough."""
        return self.intervals[0][0] if self.intervals else None


def sufficient_preloads(grasp: Grasp | Solver, wrench: Any) -> Preloads:
    """Return all uniform preloads with which a grasp resists a wrench, exactly.

    The preloads of the grasp itself are replaced. A larger preload is not always better, so the
    whole set is returned; its least element is `Preloads.least`.

    >>> from equilibrium import read_grasp
    >>> sufficient_preloads(read_grasp("paper-three-contacts"), [0, 3, 0]).least
    Fraction(3, 1)
    """
    solver = prepare(grasp)
    w, bound = solver.read(wrench), solver.max_displacement
    bare, loaded = (solver.grasp.with_preload(p) for p in (0, 1))
    held = Solver(bare, bound).solve(w).stable
    parts: list[Interval] = [(Fraction(0), Fraction(0))] if held else []
    # Without a range a preload of p resists a load, with the adhesion, where one of 1 resists the
    # load over p.
    screen, load = StateChoices(loaded).screen, bare.total_load(w)
    none = negated(bare.adhesion_wrench)
    possible = screen.possible(none, load) if any(load) else screen.possible(w)
    changes: Any = {"preload_slope": Fraction(1), "max_displacement": bound}
    ((_, question),) = part_questions(bare, w, solver.no_wrench, **changes)
    parts += magnitudes_with(question, screen.codes[possible])
    return Preloads((w,), tuple(bare.contact_numbers), union(parts))


def chosen_preloads(
    grasp: Grasp | Solver, wrenches: Iterable[Any], contacts: Iterable[int] | None = None
) -> Preloads:
    """Return all p >= 0 with which chosen contacts resist every wrench; see `ResistedSet.preloads`.

    Each chosen contact has the preload p, a pad in all. On each choice of contact states the p that
    resist a wrench are one interval, so a tree of states finds them all.

    >>> from equilibrium import read_grasp
    >>> grasp = read_grasp("paper-four-contacts-preload-1")
    >>> found = chosen_preloads(grasp, [[0, 3, 0], [0, -4, 0]], [1, 2, 3, 4])
    >>> found.least, chosen_preloads(grasp, [[0, 2, 0]], [2, 3]).least
    (Fraction(2, 1), Fraction(1, 1))
    """
    solver = prepare(grasp)
    every = solver.grasp.contact_numbers
    chosen = chosen_contacts(every if contacts is None else contacts, len(every))
    listed = tuple(wrenches)
    if not listed or not chosen:
        raise GraspError(
            f"contacts are {shown(list(chosen))} and wrenches {len(listed)}; expected at least one "
            f"wrench, and numbers of contacts from 1 to {len(every)}"
        )
    loads = tuple(map(solver.read, listed))
    bare, places = solver.grasp.with_preload(0, chosen), solver.grasp.points_of(chosen)
    changes: Any = {"preload_slope": Fraction(1), "max_displacement": solver.max_displacement}
    shared: tuple[Interval, ...] = (ALL,)
    for load in loads:
        sets = bare, load, solver.no_wrench, places
        shared = common(shared, magnitudes_by_states(*sets, **changes))
    return Preloads(loads, chosen, shared)
