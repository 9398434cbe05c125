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

from equilibrium.decide.verdict import Solver
from equilibrium.methods.contact_laws.printed_model import solve_literal
from proofs_check.instances import paper_tables as printed
from proofs_check.instances.domains import domain
from proofs_check.instances.grasps import (
    grasp_of,
    listed_states,
    paper_question,
    smallest_questions,
)
from proofs_check.routes import oracle
from proofs_check.routes.oracle import Interval, Question, Reading
from proofs_check.statements.statement import Case, Claim, Route, Verdict, View, exhaustive

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
    Claim,
    sources=exhaustive("the 17 questions of the two tables", _table_cases),
    expected=Verdict.REFUTED,
)


def _search(contacts: range, **options: Any) -> Callable[[], Iterator[Case]]:
    return lambda: smallest_questions(contacts, WRENCHES, **options)


def _deviation_claim(name: str, locator: str, what: str, formula: str, meaning: str) -> Claim:
    """One deviation alone: it should change no verdict of the model."""
    return _on_tables(
        id=f"printed-{name}",
        formula=formula,
        locator=locator,
        statement=f"{what}, every verdict is that of the model which the result tables follow.",
        quantity="(verdict with the deviation, verdict of the model)",
        routes=(
            Route("elimination over all choices of states", partial(_deviation_pair, [name])),
            Route("the solver and its literal reading", partial(_pair_by_solver, [name])),
        ),
        judge=_equal,
        search=_search(range(1, 3)),
        meaning=meaning,
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
        hypotheses=("preload term and signs corrected", "all-stick state added"),
        quantity="(verdict of Algorithm 2, verdict of the model)",
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


CLAIMS = (
    _on_tables(
        id="printed-equations",
        formula=r"c_n = -k N \cdot d \ge 0, \quad T \cdot d \gt 0 \Rightarrow c_t = \mu c_n",
        locator="Eqs. 1-7",
        statement="With the equations as printed (no detachment, no preload term, printed signs), "
        "the verdicts of both result tables come out.",
        quantity="verdict",
        routes=(
            Route("elimination over all choices of states", partial(_by_oracle, DEVIATIONS)),
            Route("the solver's literal reading", partial(_by_literal, DEVIATIONS)),
        ),
        judge=lambda question, value: value == _PRINTED[question].stable,
        explain=_explain_printed,
        meaning="The tables were computed with other equations than the printed ones.",
        rows=True,
    ),
    _deviation_claim(
        "detachment",
        "Eqs. 2 and 4",
        "With the spring equation as an equality, so that no contact can let go",
        r"c_n = q - k N \cdot d \ge 0",
        "The four-contact grasp turns under (0, 0, +-3) and two contacts let go; the printed "
        "equations forbid that.",
    ),
    _deviation_claim(
        "preload",
        "Eq. 4",
        "With no preload term in the spring equation",
        r"c_n = \max(0, -k N \cdot d)",
        "Both tables use a preload that no printed equation has.",
    ),
    _deviation_claim(
        "signs",
        "Eqs. 1, 4 and 6",
        "With the signs of balance, springs and friction taken together in one frame",
        r"T \cdot d \gt 0 \; \Rightarrow \; c_t = \mu c_n",
        "Eqs. 1 and 4 agree when normals point outwards; then Eq. 6 has friction act along the "
        "motion of the table's rows.",
    ),
    Claim(
        id="constraint-count",
        formula=r"3 + m + (m - l)",
        locator="Section V-A",
        statement="The system of a slip state with l slipping contacts has 3 + m + (m - l) "
        "equations from balance, springs and slip, and m - l more from sticking.",
        quantity="number of equations",
        routes=(
            Route("writing the system down and counting rows", _counted),
            Route("adding up one equation for each contact and kind", _added),
        ),
        judge=lambda case, count: count == 3 + case[0] + 2 * (case[0] - case[1]),
        sources=exhaustive("all l <= m <= 6", partial(_constraint_cases, 6)),
        expected=Verdict.REFUTED,
        search=partial(_constraint_cases, 2),
        meaning="A slip of the pen: l is first the number of slipping contacts and then of "
        "sticking ones. There are 3 + m + l and m - l, in all 3 + 2m, as many as unknowns.",
    ),
    _algorithm_2("cell-check", "detachment")(
        id="algorithm-2-sound",
        formula=r"\text{Algorithm 2 says stable} \; \Rightarrow \; \exists (d, c)",
        domain=domain("question"),
        locator="Algorithm 2",
        statement="A grasp that Algorithm 2 calls stable has an equilibrium.",
        judge=lambda question, pair: pair != ("Yes", "No"),
        meaning="Algorithm 2 never checks that the motion it finds slips as its slip state says; "
        "then friction may push the object along.",
    ),
    _algorithm_2("cell-check", "detachment")(
        id="algorithm-2-complete",
        formula=r"\text{Algorithm 2 says unstable} \; \Rightarrow \; \neg \exists (d, c)",
        locator="Algorithm 2; Section V-B",
        statement="If Algorithm 2 finds no solution, the grasp has no equilibrium.",
        judge=lambda question, pair: pair != ("No", "Yes"),
        meaning="Relative to its own equations the algorithm is complete; relative to contacts "
        "that can let go it is not.",
    ),
    _algorithm_2("all-stick")(
        id="all-stick-listed",
        formula=r"\exists (d, c) \; \Rightarrow \; \exists (d, c) \text{ in a listed state}",
        domain=domain("question"),
        locator="Algorithm 2; Section IV-B",
        statement="The states that Steps 1 to 3 list are enough: if a grasp has an equilibrium, "
        "one is found in a listed state.",
        hypotheses=("equations corrected", "cell checked", "coincident planes merged"),
        quantity="(verdict over the listed states, verdict of the model)",
        judge=_equal,
        search=lambda: smallest_questions(range(3, 4), WRENCHES[:1], preloads=(1,)),
        meaning="With preload the object often just stays, and d = 0 is in no listed state "
        "once three tangential planes are independent.",
    ),
    _on_tables(
        id="single-solution",
        views=tuple(
            View("grasp", f"Equilibrium {k} of the two.", {"wrench": (-1, 0, 0), "piece": k})
            for k in (1, 2)
        ),
        formula=r"|\{c_n : (d, c) \text{ is an equilibrium under } w\}| \le 1",
        domain=domain("question"),
        locator="Section II",
        statement="Compliance reduces the solutions to at most a single one: the normal forces "
        "of an equilibrium are determined by grasp and wrench.",
        hypotheses=("the corrected model",),
        quantity="exact set of values of every normal force over all equilibria",
        routes=(
            Route("elimination over 4^m states", oracle.normal_forces),
            Route("ranges over the solver's pieces", _normal_forces_solved),
        ),
        judge=_single,
        search=_search(range(1, 3), preloads=(1,)),
        meaning="An algorithm that stops at the first solution may report other forces than "
        "the ones that arise; the verdict on stability is not touched.",
    ),
)
