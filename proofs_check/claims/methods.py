"""Claims on the methods that the paper compares with, on its two grasps."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import Any

from equilibrium.decide.solver import solve
from equilibrium.methods.compare import predict
from proofs_check.routes.oracle import Touch

from .parts import *

System = tuple[list[Row], list[Row]]
#: At rest with preload 1 the contacts 1 and 3 carry friction (Table I, second row).
_REST = (Fraction(-1, 2), Fraction(0), Fraction(1, 2))


@dataclass(frozen=True)
class Asked:
    """A question put to a method, and what the paper says: the method's verdict and the right one.

    Attributes:
        method: a key of `equilibrium.methods.METHODS`.
        rest: tangential forces before the wrench is applied.
    """

    method: str
    question: Question
    says: tuple[bool, bool]
    rest: tuple[Fraction, ...]


def _by_packages(asked: Asked) -> tuple[bool | None, bool]:
    grasp = grasp_of(asked.question)
    wrench = asked.question.wrench
    return predict(asked.method, grasp, wrench), solve(grasp, wrench).stable


def _by_elimination(asked: Asked) -> tuple[bool, bool]:
    systems = (_system(asked, states) for states in _choices(asked))
    accepted = any(project(*system, keep=-1) is not None for system in systems)
    return accepted, oracle.stable(asked.question)


def _choices(asked: Asked) -> Iterator[tuple[str, ...]]:
    """Return the states of contacts that a method distinguishes."""
    states = {
        "wrench-space": ("force",),
        "cones": ("spring", "detached"),
        "linear-compliance": ("stick",),
        "frictionless-slip": ("stick", "slip", "detached"),
    }
    return product(states[asked.method], repeat=len(asked.question.contacts))


def _system(asked: Asked, states: tuple[str, ...]) -> System:
    """Conditions on the motion, then the normal and tangential force of each contact."""
    touches = asked.question.touches
    size = 3 + 2 * len(touches) + 1
    equalities = [[Fraction(0)] * (size - 1) + [asked.question.wrench[k]] for k in range(3)]
    inequalities: list[Row] = []
    for i, (touch, state) in enumerate(zip(touches, states, strict=True)):
        push, pull = 3 + 2 * i, 4 + 2 * i
        for k in range(3):
            equalities[k][push] = touch.normal[k]
            equalities[k][pull] = touch.tangential[k]
        more, rows = _contact(touch, state, asked.rest[i], push, size)
        equalities += [list(row) for row in more]
        inequalities += rows
    return [tuple(row) for row in equalities], inequalities


def _contact(touch: Touch, state: str, rest: Fraction, push: int, size: int) -> System:
    """Conditions of one contact; its forces are the variables `push` and `push` + 1."""

    def row(motion: Row, constant: Fraction, **forces: Fraction | int) -> Row:
        found = [*motion, *[Fraction(0)] * (size - 4), constant]
        found[push] += forces.get("normal", 0)
        found[push + 1] += forces.get("tangential", 0)
        return tuple(found)

    zero = Fraction(0)
    still = (zero,) * 3
    gap = tuple(touch.stiffness * x for x in touch.normal)
    if state == "detached":
        nothing = [row(still, zero, normal=1), row(still, zero, tangential=1)]
        return nothing, [row(gap, -touch.preload)]
    cone = [
        row(still, zero, normal=1),
        row(still, zero, normal=touch.friction, tangential=1),
        row(still, zero, normal=touch.friction, tangential=-1),
    ]
    if state == "force":
        return [], cone
    spring = row(gap, -touch.preload, normal=1)
    if state == "spring":
        return [spring], cone
    if state == "slip":
        return [spring, row(still, zero, tangential=1)], cone
    drag = tuple(touch.stiffness * x for x in touch.tangential)
    return [spring, row(drag, -rest, tangential=1)], cone


def _asked(
    method: str, places: tuple[tuple[int, ...], ...], force: str, preload: int, says: str
) -> Case:
    zero = Fraction(0)
    question = paper_question(places, (zero, Fraction(force), zero), preload)
    tipped = preload and len(places) == 3
    rest = _REST if tipped else (zero,) * len(places)
    verdicts = (says[0] == "y", says[1] == "y")
    label = f"{len(places)} contacts, w = (0, {force}, 0), P = {preload}"
    return Case(label, Asked(method, question, verdicts, rest), question.to_dict())


_THREE, _FOUR = printed.THREE_CONTACT_GRASP, printed.FOUR_CONTACT_GRASP


def _three(
    method: str, says: Mapping[str, str], preload: int = 0
) -> Callable[[random.Random], Iterator[Case]]:
    """What a method says of vertical forces on the three-contact grasp, and what is right."""
    return lambda _: (_asked(method, _THREE, force, preload, say) for force, say in says.items())


def _cones(_rng: random.Random) -> Iterator[Case]:
    for friction, force, preload in product(
        (Fraction(1, 2), Fraction(2)), ("2", "-2", "100"), (0, 1)
    ):
        case = _asked("cones", _FOUR, force, preload, "y?")
        rows = tuple((*row[:4], friction, *row[5:]) for row in case.subject.question.contacts)
        question = Question(rows, case.subject.question.wrench)
        asked = replace(case.subject, question=question)
        yield Case(f"{case.label}, friction {friction}", asked, question.to_dict())


def _method(id: str, **checked: Any) -> Claim:
    """Return a claim on what a method says, and on what is right."""
    checked = {"judge": lambda asked, found: found == asked.says, **checked}
    return stated(id, _by_packages, _by_elimination, **checked)


CLAIMS = (
    _method(
        "method-grasp-wrench-space",
        cases=_three("wrench-space", {"1": "yn", "100": "yn", "-1": "yy", "-100": "yy"}),
    ),
    _method(
        "method-cones-only",
        judge=lambda asked, found: found[0],
        cases=_cones,
        covers=lambda asked: all(touch.friction > 1 for touch in asked.question.touches),
        explain=lambda asked, found: f"corrected model: {'Yes' if found[1] else 'No'}",
    ),
    _method(
        "method-linear-compliance",
        cases=_three("linear-compliance", dict.fromkeys(("-1", "-2", "-100"), "ny")),
    ),
    _method(
        "method-frictionless-slip-down",
        cases=_three("frictionless-slip", dict.fromkeys(("0", "-1", "-2", "-100"), "yy")),
    ),
    _method(
        "method-frictionless-slip-up", cases=_three("frictionless-slip", {"1": "ny"}, preload=1)
    ),
)
