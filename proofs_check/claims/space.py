"""Claims on grasps in space."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import product
from random import Random
from typing import TypeAlias

from equilibrium.spatial_verdict import solve_in_space
from equilibrium.verdict import Solver
from proofs_check.instances.grasps import grasp_case, grasp_of, paper_question
from proofs_check.instances.paper_tables import FOUR_CONTACT_GRASP, THREE_CONTACT_GRASP
from proofs_check.routes.oracle import Question, stable
from proofs_check.statement import Case, Claim, Route, sampled

#: The verdicts in the plane and in space.
_Pair: TypeAlias = tuple[bool, bool]
_LOADS = tuple(
    tuple(map(Fraction, w)) for w in (("0", "1", "0"), ("0", "9/8", "0"), ("1", "1/2", "1/4"))
)


def _in_space(question: Question, pyramid: int | None) -> bool:
    x, y, torque = question.wrench
    wrench = (x, y, 0, 0, 0, torque)
    return solve_in_space(grasp_of(question).in_space(), wrench, pyramid=pyramid).stable


@lru_cache(maxsize=64)
def _by_states(question: Question) -> _Pair:
    return stable(question), _in_space(question, None)


@lru_cache(maxsize=64)
def _by_solver(question: Question) -> _Pair:
    return Solver(grasp_of(question)).solve(question.wrench).stable, _in_space(question, 4)


def _cases(source: Random) -> Iterator[Case]:
    del source
    for contacts, preload, load in product(
        (THREE_CONTACT_GRASP, FOUR_CONTACT_GRASP), (0, 1), _LOADS
    ):
        question = paper_question(contacts, load, preload)
        label = f"{len(contacts)} contacts, P = {preload}, w = ({', '.join(map(str, load))})"
        yield grasp_case(question, label)


CLAIMS = (
    Claim(
        id="planar-verdicts-embed",
        formula=r"(f_x, f_y, \tau) \iff (f_x, f_y, 0, 0, 0, \tau)",
        locator="our claim, on grasps in space",
        statement="The contacts of a planar grasp, put into the plane z = 0 of space with round "
        "friction cones, resist a wrench of that plane exactly when the planar grasp does.",
        hypotheses=(),
        quantity="verdicts in the plane and in space",
        routes=(
            Route("all states in the plane; sectors and enclosures in space", _by_states),
            Route("the planar solver; linear programs with pyramids in space", _by_solver),
        ),
        judge=lambda question, verdicts: verdicts[0] == verdicts[1],
        sources=sampled("the paper's contacts, without preload and with preload 1", _cases),
        explain=lambda question, verdicts: f"in the plane {verdicts[0]}, in space {verdicts[1]}",
        meaning="Nothing leaves the plane: forces along z balance, and friction that works against "
        "a slip out of the plane would not. The page on proofs has the proof.",
    ),
)
