"""Claims on the wrenches that are held along one direction."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction

from equilibrium.wrench_sets import resisted_magnitudes
from proofs_check.instances import paper_tables as printed
from proofs_check.instances.grasps import grasp_case, grasp_of, paper_question, smallest_questions
from proofs_check.routes import oracle
from proofs_check.routes.oracle import Interval, Question
from proofs_check.statements.statement import Case, Claim, Route, Verdict, View, exhaustive

AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def _by_elimination(question: Question) -> tuple[Interval, ...]:
    """The held factors t >= 0, cut out of the set of all factors."""
    zero = Fraction(0)
    return tuple(
        (zero if low is None else max(low, zero), high)
        for low, high in oracle.resisted(question)
        if high is None or high >= 0
    )


def _by_limits(question: Question) -> tuple[Interval, ...]:
    return resisted_magnitudes(grasp_of(question), question.wrench).intervals


def _paper_cases(_rng: random.Random) -> Iterator[Case]:
    for contacts in (printed.THREE_CONTACT_GRASP, printed.FOUR_CONTACT_GRASP):
        for preload in (0, 1):
            for axis in (*AXES, *(tuple(-x for x in axis) for axis in AXES)):
                question = paper_question(contacts, list(map(Fraction, axis)), preload)
                yield grasp_case(question, f"m = {len(contacts)}, P = {preload}, direction {axis}")


CLAIMS = (
    Claim(
        id="binary-search",
        views=(
            View(
                "polar",
                "The search in 72 directions, on the exact set of resisted forces. In the notch it "
                "claims what is not resisted.",
            ),
        ),
        formula=r"\{t \ge 0 : t w \text{ is resisted}\} = [0, t_1]",
        locator="Section VI, Fig. 7",
        statement="Along any direction the held magnitudes are one interval that starts at 0, so "
        "that a binary search finds the largest one.",
        hypotheses=("the corrected model",),
        quantity="exact set of held magnitudes, as closed intervals",
        routes=(
            Route("elimination over 4^m states", _by_elimination),
            Route("closed forms from the solver's cells", _by_limits),
        ),
        judge=lambda question, held: len(held) <= 1 and all(low == 0 for low, _ in held),
        sources=exhaustive(
            "both grasps of the paper, both preloads, the six directions along the axes",
            _paper_cases,
        ),
        expected=Verdict.REFUTED,
        search=lambda: smallest_questions(range(3, 4), AXES, preloads=(1,)),
        meaning="It is true of the directions tried on the paper's grasps. In general a search "
        "that halves an interval can stop at the end of any of several intervals.",
    ),
)
