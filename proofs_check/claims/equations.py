"""Claims on the equations and algorithms as printed: where they differ from the tables.

The model of the tables has contacts that can detach, a preload term, friction against the motion,
and a check that the motion lies in the cell of its slip state. Each of these can be taken as
printed, alone or together.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Collection, Iterator
from fractions import Fraction
from functools import partial
from typing import Any

from equilibrium.methods.contact_laws.printed_model import solve_literal
from equilibrium.wrench_sets import resisted_magnitudes
from proofs_check.routes.oracle import Interval, Reading

from .parts import *

#: The deviations of the printed equations, by the names of
#: `equilibrium.methods.contact_laws.printed_model`.
DEVIATIONS = ("detachment", "preload", "signs")
WRENCHES = ((0, 0, 0), (0, -1, 0), (0, 1, 0), (-1, 0, 0), (1, 0, 0), (0, 0, 1), (0, 0, -1))


def _reading(options: Collection[str]) -> Reading:
    """Return the model with the named points taken as printed."""
    return Reading(
        detachment="detachment" not in options,
        preload="preload" not in options,
        friction_opposes="signs" not in options,
        cell_check="cell-check" not in options,
    )


def _table_rows() -> Iterator[tuple[Question, printed.PrintedRow]]:
    for contacts, rows in (
        (printed.THREE_CONTACT_GRASP, printed.THREE_CONTACTS),
        (printed.FOUR_CONTACT_GRASP, printed.FOUR_CONTACTS),
    ):
        for row in rows:
            wrench, _ = printed.read_vector(row.wrench)
            yield paper_question(contacts, wrench, Fraction(row.preload)), row


_PRINTED = dict(_table_rows())


def _table_cases(_rng: random.Random) -> Iterator[Case]:
    for question, row in _PRINTED.items():
        label = f"m={len(question.contacts)} w={row.wrench.replace(' ', '')} P={row.preload}"
        yield Case(f"{label} {row.stable}", question, question.to_dict())


def _word(stable: bool) -> str:
    return "Yes" if stable else "No"


def _by_oracle(options: Collection[str], question: Question) -> str:
    return _word(oracle.stable(question, _reading(options)))


def _by_literal(options: Collection[str], question: Question) -> str:
    return _word(solve_literal(grasp_of(question), question.wrench, options).stable)


def _explain_printed(question: Question, value: str) -> str:
    verdict = _PRINTED[question].stable
    if value == verdict:
        return ""
    alone = [name for name in DEVIATIONS if _by_oracle([name], question) != verdict]
    return f"enough alone: {', '.join(alone)}" if alone else "only several together do this"


#: What the claims on the questions of the tables share; the printed equations fail all of them.
_on_tables = partial(
    stated,
    sources=exhaustive("the 17 questions of the two tables", _table_cases),
)


def _search(contacts: range, **options: Any) -> Callable[[], Iterator[Case]]:
    return lambda: smallest_questions(contacts, WRENCHES, **options)


def _deviation_claim(name: str) -> Claim:
    """One deviation alone: it should change no verdict of the model."""
    return _on_tables(
        id=f"printed-{name}",
        routes=(
            Route("elimination over all choices of states", partial(_deviation_pair, [name])),
            Route("the solver and its literal reading", partial(_pair_by_solver, [name])),
        ),
        judge=_equal,
        search=_search(range(1, 3)),
    )


Pair = tuple[str, str]


def _equal(_: Question, pair: Pair) -> bool:
    return pair[0] == pair[1]


def _listed_pair(options: Collection[str], question: Question) -> Pair:
    """The verdict of Algorithm 2 over the states of Steps 1 to 3, and that of the model."""
    states = listed_states(
        grasp_of(question),
        detachment="detachment" not in options,
        all_stick="all-stick" not in options,
    )
    found = oracle.stable(question, _reading(options), states)
    return _word(found), _by_oracle((), question)


def _deviation_pair(options: Collection[str], question: Question) -> Pair:
    return _by_oracle(options, question), _by_oracle((), question)


def _pair_by_solver(options: Collection[str], question: Question) -> Pair:
    model = Solver(grasp_of(question)).solve(question.wrench)
    return _by_literal(options, question), _word(model.stable)


def _algorithm_2(*options: str) -> partial[Claim]:
    """What the claims on Algorithm 2 with some points taken as printed share."""
    return partial(
        _on_tables,
        routes=(
            Route("elimination over the states of Steps 1 to 3", partial(_listed_pair, options)),
            Route("the solver and its literal reading", partial(_pair_by_solver, options)),
        ),
        search=_search(range(1, 3)),
    )


def _normal_forces_solved(question: Question) -> tuple[tuple[Interval, ...], ...]:
    verdict = Solver(grasp_of(question)).solve(question.wrench)
    return tuple(
        oracle.united(piece.force_ranges[i][0] for piece in verdict.equilibria)
        for i in range(len(question.contacts))
    )


def _single(_question: Question, forces: tuple[tuple[Interval, ...], ...]) -> bool:
    """At most one value for every normal force."""
    return all(len(found) <= 1 and all(low == high for low, high in found) for found in forces)


def _counted(case: tuple[int, int]) -> int:
    """Count the equations of the system of l slipping contacts of m by writing them down."""
    m, slipping = case
    states = ("slip+",) * slipping + ("stick",) * (m - slipping)
    question = paper_question([(i, 0, 0, 1) for i in range(m)], [Fraction(0)] * 3, 1)
    equalities, _ = oracle.Systems(question).rows(states)
    return len(equalities) + m  # the oracle has put the m spring equations in already


def _added(case: tuple[int, int]) -> int:
    """Balance, springs, friction at slipping contacts, no motion at sticking ones."""
    m, slipping = case
    return sum((3, m, *(1 for _ in range(slipping)), *(1 for _ in range(slipping, m))))


def _constraint_cases(largest: int, _rng: Any = None) -> Iterator[Case]:
    for m in range(1, largest + 1):
        for slipping in range(m + 1):
            yield Case(f"m = {m}, l = {slipping} slipping", (m, slipping), {"m": m, "l": slipping})


AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def _held_by_elimination(question: Question) -> tuple[Interval, ...]:
    """The held factors t >= 0, cut out of the set of all factors."""
    zero = Fraction(0)
    return tuple(
        (zero if low is None else max(low, zero), high)
        for low, high in oracle.resisted(question)
        if high is None or high >= 0
    )


def _held_by_limits(question: Question) -> tuple[Interval, ...]:
    return resisted_magnitudes(grasp_of(question), question.wrench).intervals


def _axis_cases(_rng: random.Random) -> Iterator[Case]:
    for contacts in (printed.THREE_CONTACT_GRASP, printed.FOUR_CONTACT_GRASP):
        for preload in (0, 1):
            for axis in (*AXES, *(tuple(-x for x in axis) for axis in AXES)):
                question = paper_question(contacts, list(map(Fraction, axis)), preload)
                yield grasp_case(question, f"m = {len(contacts)}, P = {preload}, direction {axis}")


CLAIMS = (
    _on_tables(
        id="printed-equations",
        routes=(
            Route("elimination over all choices of states", partial(_by_oracle, DEVIATIONS)),
            Route("the solver's literal reading", partial(_by_literal, DEVIATIONS)),
        ),
        judge=lambda question, value: value == _PRINTED[question].stable,
        explain=_explain_printed,
    ),
    *map(_deviation_claim, DEVIATIONS),
    stated(
        id="constraint-count",
        routes=(
            Route("writing the system down and counting rows", _counted),
            Route("adding up one equation for each contact and kind", _added),
        ),
        judge=lambda case, count: count == 3 + case[0] + 2 * (case[0] - case[1]),
        sources=exhaustive("all l <= m <= 6", partial(_constraint_cases, 6)),
        search=partial(_constraint_cases, 2),
    ),
    _algorithm_2("cell-check", "detachment")(
        id="algorithm-2-sound",
        judge=lambda question, pair: pair != ("Yes", "No"),
    ),
    _algorithm_2("cell-check", "detachment")(
        id="algorithm-2-complete",
        judge=lambda question, pair: pair != ("No", "Yes"),
    ),
    _algorithm_2("all-stick")(
        id="all-stick-listed",
        judge=_equal,
        search=lambda: smallest_questions(range(3, 4), WRENCHES[:1], preloads=(1,)),
    ),
    _on_tables(
        id="single-solution",
        routes=(
            Route("elimination over 4^m states", oracle.normal_forces),
            Route("ranges over the solver's pieces", _normal_forces_solved),
        ),
        judge=_single,
        search=_search(range(1, 3), preloads=(1,)),
    ),
    stated(
        id="binary-search",
        routes=(
            Route("elimination over 4^m states", _held_by_elimination),
            Route("closed forms from the solver's cells", _held_by_limits),
        ),
        judge=lambda question, held: len(held) <= 1 and all(low == 0 for low, _ in held),
        sources=exhaustive(
            "both grasps of the paper, both preloads, the six directions along the axes",
            _axis_cases,
        ),
        search=lambda: smallest_questions(range(3, 4), AXES, preloads=(1,)),
    ),
)
