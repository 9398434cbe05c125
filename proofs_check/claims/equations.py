"""Claims on the equations and algorithms as printed: where they differ from the tables.

The model of the tables has contacts that can detach, a preload term, friction against the motion,
and a check that the motion lies in the cell of its slip state. Each of these can be taken as
printed, alone or together.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Collection, Iterator, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

from arrangement.numbers.linear.programs import some_point
from arrangement.numbers.linear.rank import determinant, gauss_jordan
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.decide.solver import Solver, solve
from equilibrium.model.rows import ContactRows
from equilibrium.wrench_sets.line import resisted_magnitudes
from proofs_check.instances import printed
from proofs_check.instances.grasps import (
    grasp_case,
    grasp_of,
    listed_states,
    paper_question,
    smallest_questions,
)
from proofs_check.routes import oracle
from proofs_check.routes.oracle import Interval, Question, Reading, project
from proofs_check.statements.statement import Case, Claim

from .stated import stated

#: The deviations of the printed equations, by the names of
#: `equilibrium.decide.as_printed`.
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


_PRINTED = {
    paper_question(contacts, printed.read_vector(row.wrench)[0], row.preload): row
    for contacts, rows in (
        (printed.THREE_CONTACT_GRASP, printed.THREE_CONTACTS),
        (printed.FOUR_CONTACT_GRASP, printed.FOUR_CONTACTS),
    )
    for row in rows
}


def _table_cases(_rng: random.Random) -> Iterator[Case]:
    for question, row in _PRINTED.items():
        label = f"m={len(question.contacts)} w={row.wrench.replace(' ', '')} P={row.preload}"
        yield Case(f"{label} {row.stable}", question, question.to_dict())


_WORD = {True: "Yes", False: "No"}


def _by_oracle(options: Collection[str], question: Question) -> str:
    return _WORD[oracle.stable(question, _reading(options))]


def _by_literal(options: Collection[str], question: Question) -> str:
    return _WORD[solve(grasp_of(question), question.wrench, as_printed=options).stable]


def _explain_printed(question: Question, value: str) -> str:
    verdict = _PRINTED[question].stable
    if value == verdict:
        return ""
    alone = [name for name in DEVIATIONS if _by_oracle([name], question) != verdict]
    return f"enough alone: {', '.join(alone)}" if alone else "only several together do this"


Pair = tuple[str, str]


def _equal(_: Question, pair: Pair) -> bool:
    return pair[0] == pair[1]


def _listed_pair(options: Collection[str], question: Question) -> Pair:
    """Return the verdict of Algorithm 2 over the states of Steps 1 to 3, and that of the model."""
    states = listed_states(
        grasp_of(question),
        detachment="detachment" not in options,
        all_stick="all-stick" not in options,
    )
    stable = oracle.stable(question, _reading(options), states)
    return _WORD[stable], _by_oracle((), question)


def _pair_by_oracle(options: Collection[str], question: Question) -> Pair:
    return _by_oracle(options, question), _by_oracle((), question)


def _pair_by_solver(options: Collection[str], question: Question) -> Pair:
    model = Solver(grasp_of(question)).solve(question.wrench)
    return _by_literal(options, question), _WORD[model.stable]


def _normal_forces_solved(question: Question) -> tuple[tuple[Interval, ...], ...]:
    verdict = Solver(grasp_of(question)).solve(question.wrench)
    return tuple(
        oracle.union(piece.force_ranges[i][0] for piece in verdict.equilibria)
        for i in range(len(question.contacts))
    )


def _single(_question: Question, forces: tuple[tuple[Interval, ...], ...]) -> bool:
    """At most one value for every normal force."""
    return all(
        len(intervals) <= 1 and all(low == high for low, high in intervals) for intervals in forces
    )


def _count_equations(case: tuple[int, int]) -> int:
    """Count the equations of the system of l slipping contacts of m by writing them down."""
    m, slipping = case
    states = ("slip+",) * slipping + ("stick",) * (m - slipping)
    question = paper_question([(i, 0, 0, 1) for i in range(m)], (0, 0, 0), 1)
    equalities, _ = oracle.Systems(question).rows(states)
    return len(equalities) + m  # the oracle has put the m spring equations in already


def _add_equations(case: tuple[int, int]) -> int:
    """Balance, springs, friction at slipping contacts, no motion at sticking ones."""
    m, slipping = case
    return 3 + m + len(range(slipping)) + len(range(slipping, m))


def _constraint_cases(largest: int) -> Iterator[Case]:
    for m in range(1, largest + 1):
        for slipping in range(m + 1):
            yield Case(f"m = {m}, l = {slipping} slipping", (m, slipping), {"m": m, "l": slipping})


#: Of the slip states those that have a solution, and how many systems are singular.
_Solved = tuple[tuple[tuple[str, ...], ...], int]
_ATTACHED = Reading(detachment=False)


def _by_null_space(question: Question) -> _Solved:
    """Solve the linear system of each slip state; in the null space where it is singular."""
    posed, held, singular = ContactRows.of_grasp(grasp_of(question)), [], 0
    for states in oracle.all_states(question, _ATTACHED):
        system = ContactProgram(LinearQuestion(posed, question.wrench), states)
        rows, pivots, scale = gauss_jordan(system.equalities)
        free = [j for j in range(system.size) if j not in pivots]
        singular += bool(free)
        if system.size not in pivots and _legal_point(system, rows, pivots, scale, free):
            held.append(states)
    return tuple(held), singular


def _legal_point(
    system: ContactProgram,
    rows: Sequence[Sequence[int]],
    pivots: list[int],
    scale: int,
    free: list[int],
) -> bool:
    """Return whether some point of the null space, moved to a solution, is legal.

    Its coordinates are the free variables; a regular system has none, and one point to test.
    """
    columns = [*free, system.size]
    values = {
        p: [Fraction(-row[j], scale) for j in columns] for p, row in zip(pivots, rows, strict=False)
    }
    values |= {j: [Fraction(int(j == k)) for k in columns] for j in free}
    legal = []
    for row in system.inequalities:
        bound = [
            sum((a * values[j][k] for j, a in enumerate(row[:-1])), Fraction(0))
            for k in range(len(columns))
        ]
        bound[-1] += row[-1]
        legal.append(bound)
    if not free:
        return all(bound[-1] >= 0 for bound in legal)
    return some_point(len(free), legal) is not None


def _at_once(question: Question) -> _Solved:
    """Eliminate all variables from all conditions of each slip state at once."""
    systems, held, singular = oracle.Systems(question, _ATTACHED), [], 0
    for states in oracle.all_states(question, _ATTACHED):
        equalities, inequalities = systems.rows(states)
        singular += not determinant([_whole(row[:-1]) for row in equalities])
        if project(equalities, inequalities, keep=-1) is not None:
            held.append(states)
    return tuple(held), singular


def _whole(row: Sequence[Fraction | int]) -> list[int]:
    scale = 1
    for x in row:
        scale *= Fraction(x).denominator
    return [int(x * scale) for x in row]


def _null_space_cases(_rng: random.Random) -> Iterator[Case]:
    for contacts, rows in (
        (printed.THREE_CONTACT_GRASP, printed.THREE_CONTACTS),
        (printed.FOUR_CONTACT_GRASP, printed.FOUR_CONTACTS[1:7:2]),
    ):
        for row in rows:
            wrench = printed.read_vector(row.wrench)[0]
            question = paper_question(contacts, wrench, row.preload)
            yield grasp_case(question, f"m = {len(contacts)}, w = {row.wrench}, P = {row.preload}")


AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def _held_by_elimination(question: Question) -> tuple[Interval, ...]:
    """Return the held factors t >= 0, cut out of the set of all factors."""
    zero = Fraction(0)
    return tuple(
        (zero if low is None else max(low, zero), high)
        for low, high in oracle.resisted(question)
        if high is None or high >= 0
    )


def _axis_cases(_rng: random.Random) -> Iterator[Case]:
    for contacts in (printed.THREE_CONTACT_GRASP, printed.FOUR_CONTACT_GRASP):
        for preload in (0, 1):
            for axis in (*AXES, *(tuple(-x for x in axis) for axis in AXES)):
                question = paper_question(contacts, axis, preload)
                yield grasp_case(question, f"m = {len(contacts)}, P = {preload}, direction {axis}")


def _search(contacts: range, **options: Any) -> Callable[[], Iterator[Case]]:
    return lambda: smallest_questions(contacts, WRENCHES, **options)


_on_tables = partial(stated, cases=_table_cases)


def _deviation(id: str, *options: str, **checked: Any) -> Claim:
    """Return a claim on the verdicts with some points taken as printed, and those of the model."""
    checked = {"judge": _equal, "search": _search(range(1, 3)), **checked}
    return _on_tables(id, solver=partial(_pair_by_solver, options), **checked)


def _of_steps(id: str, *options: str, **checked: Any) -> Claim:
    """Return the same, with the states of contacts that Steps 1 to 3 list."""
    return _deviation(id, *options, steps=partial(_listed_pair, options), **checked)


CLAIMS = (
    _on_tables(
        "printed-equations",
        elimination=partial(_by_oracle, DEVIATIONS),
        solver=partial(_by_literal, DEVIATIONS),
        judge=lambda question, value: value == _PRINTED[question].stable,
        explain=_explain_printed,
    ),
    # One deviation alone: it should change no verdict of the model.
    *(
        _deviation(f"printed-{name}", name, elimination=partial(_pair_by_oracle, [name]))
        for name in DEVIATIONS
    ),
    stated(
        "constraint-count",
        writing=_count_equations,
        adding=_add_equations,
        judge=lambda case, count: count == 3 + case[0] + 2 * (case[0] - case[1]),
        cases=lambda _: _constraint_cases(6),
        search=partial(_constraint_cases, 2),
    ),
    _of_steps(
        "algorithm-2-sound",
        "cell-check",
        "detachment",
        judge=lambda question, pair: pair != ("Yes", "No"),
    ),
    _of_steps(
        "algorithm-2-complete",
        "cell-check",
        "detachment",
        judge=lambda question, pair: pair != ("No", "Yes"),
    ),
    _of_steps(
        "all-stick-listed",
        "all-stick",
        search=lambda: smallest_questions(range(3, 4), WRENCHES[:1], preloads=(1,)),
    ),
    _on_tables(
        "single-solution",
        elimination=oracle.normal_forces,
        solver=_normal_forces_solved,
        judge=_single,
        search=_search(range(1, 3), preloads=(1,)),
    ),
    stated(
        "binary-search",
        elimination=_held_by_elimination,
        solver=lambda question: resisted_magnitudes(grasp_of(question), question.wrench).intervals,
        judge=lambda question, held: len(held) <= 1 and all(low == 0 for low, _ in held),
        cases=_axis_cases,
        search=lambda: smallest_questions(range(3, 4), AXES, preloads=(1,)),
    ),
    stated(
        "algorithm-2-null-space",
        null_space=_by_null_space,
        elimination=_at_once,
        judge=lambda question, found: bool(found[0]) == oracle.stable(question, _ATTACHED),
        cases=_null_space_cases,
        explain=lambda question, found: (
            f"{found[1]} of {3 ** len(question.contacts)} systems are singular, "
            f"{len(found[0])} states have a solution"
        ),
    ),
)
