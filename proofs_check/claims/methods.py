"""Claims on the methods that the paper compares with, on its two grasps."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from itertools import combinations, product
from math import hypot
from typing import Any

from equilibrium.decide.solver import Solver, solve
from equilibrium.methods.compare import predict
from equilibrium.methods.form_closure import form_closure
from equilibrium.methods.grasp_robustness import (
    RobustnessBound,
    contact_robustness,
    grasp_robustness,
)
from equilibrium.methods.weak_strong import weak_strong
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from proofs_check.instances import printed
from proofs_check.instances.grasps import grasp_case, grasp_of, paper_question, smallest_questions
from proofs_check.routes import oracle
from proofs_check.routes.oracle import Question, Row, Touch, project
from proofs_check.routes.rigid_loads import classes, immobile, within_bound
from proofs_check.statements.statement import Case, Claim

from .stated import stated

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
        entries = [*motion, *[Fraction(0)] * (size - 4), constant]
        entries[push] += forces.get("normal", 0)
        entries[push + 1] += forces.get("tangential", 0)
        return tuple(entries)

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


def _case(
    method: str,
    places: tuple[tuple[int, ...], ...],
    force: str,
    preload: int,
    says: str,
    friction: Fraction = printed.FRICTION,
) -> Case:
    question = paper_question(places, (0, force, 0), preload, friction)
    tipped = preload and len(places) == 3
    rest = _REST if tipped else (Fraction(0),) * len(places)
    verdicts = (says[0] == "y", says[1] == "y")
    label = f"{len(places)} contacts, w = (0, {force}, 0), P = {preload}"
    return Case(label, Asked(method, question, verdicts, rest), question.to_dict())


_THREE, _FOUR = printed.THREE_CONTACT_GRASP, printed.FOUR_CONTACT_GRASP


def _three(
    method: str, says: Mapping[str, str], preload: int = 0
) -> Callable[[random.Random], Iterator[Case]]:
    """What a method says of vertical forces on the three-contact grasp, and what is right."""
    return lambda _: (_case(method, _THREE, force, preload, say) for force, say in says.items())


def _cones(_rng: random.Random) -> Iterator[Case]:
    for friction, force, preload in product(
        (Fraction(1, 2), Fraction(2)), ("2", "-2", "100"), (0, 1)
    ):
        case = _case("cones", _FOUR, force, preload, "y?", friction)
        yield replace(case, label=f"{case.label}, friction {friction}")


def _method(id: str, **checked: Any) -> Claim:
    """Return a claim on what a method says, and on what is right."""
    checked = {"judge": lambda asked, verdicts: verdicts == asked.says, **checked}
    return stated(id, solver=_by_packages, elimination=_by_elimination, **checked)


_TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17))
#: Point and normal of contacts without friction that hold an object in every direction.
_CLOSED_IN_PLANE = (
    ((-1, "-1/2"), (1, 0)),
    ((1, "1/2"), (-1, 0)),
    (("-1/2", -1), (0, 1)),
    (("1/2", 1), (0, -1)),
)
_CLOSED_IN_SPACE = (
    ((-1, 0, -1), (1, 0, 0)),
    ((0, 1, -1), (0, 0, 1)),
    ((0, -1, 0), (0, 1, 0)),
    ((0, 1, -1), (0, -1, 0)),
    ((1, 1, 1), (-1, 0, 0)),
    ((-1, -1, -1), (0, 1, 0)),
    ((1, -1, 1), (0, 0, -1)),
)


def _closure_cases(dimension: int, rng: random.Random) -> Iterator[Case]:
    """Yield grasps of too few contacts, and one of enough with all that leave out one of them."""
    held = [Contact(p, n, 0) for p, n in (_CLOSED_IN_PLANE if dimension == 2 else _CLOSED_IN_SPACE)]
    for few in (held, *combinations(held, len(held) - 1)):
        grasp = Grasp(few)
        yield Case(f"{len(grasp)} contacts of the closed grasp", grasp, grasp.to_dict())
    for m in range(1, len(held)):
        for _ in range(8):
            grasp = Grasp(_random_contact(rng, dimension) for _ in range(m))
            yield Case(f"{m} random contacts", grasp, grasp.to_dict())


def _random_contact(rng: random.Random, dimension: int) -> Contact:
    a, b, c = rng.choice(_TRIPLES)
    values = [Fraction(rng.choice((1, -1)) * x, c) for x in (a, b)]
    normal = [*values, *[Fraction(0)] * (dimension - 2)]
    rng.shuffle(normal)
    return Contact([rng.randint(-5, 5) for _ in normal], normal, 0)


def _enough(grasp: Grasp, closed: bool) -> bool:
    """Closed exactly with all contacts of the closed grasp, one more than a motion has numbers."""
    return closed == (len(grasp) == 3 * grasp.dimension - 2)


#: Whether a load is strongly stable, and whether it does positive work in no virtual motion.
_Classes = tuple[bool, bool]


def _classes(question: Question) -> _Classes:
    stability = weak_strong(grasp_of(question), question.wrench)
    return stability.strong, stability.frictionless


def _loads(_rng: random.Random) -> Iterator[Case]:
    for name, places in (("three", _THREE), ("four", _FOUR)):
        for force in (-1, 0, 1):
            question = paper_question(places, (0, force, 0), 0)
            yield grasp_case(question, f"{name} contacts, w = (0, {force}, 0)")


#: The second is inside the friction cone of a contact with normal (1, 0), and does work along y.
_SIDEWAYS = ((-1, 0, 0), (-2, 1, 0), (1, 0, 0))


def _frictionless(rng: random.Random) -> Iterator[Case]:
    """Yield loads that normal forces alone balance, with several friction coefficients."""
    for m, mu in product((1, 2, 3), map(Fraction, ("0", "1/10", "1/2", "1", "5"))):
        places = [(*c.point, *c.normal) for c in (_random_contact(rng, 2) for _ in range(m))]
        rows = tuple((*map(Fraction, place), mu, Fraction(1), Fraction(0)) for place in places)
        touches = Question(rows, (Fraction(0),) * 3).touches
        pushes = [rng.randint(0, 3) for _ in touches]
        load = tuple(
            -sum((p * t.normal[k] for p, t in zip(pushes, touches, strict=True)), Fraction(0))
            for k in range(3)
        )
        yield grasp_case(Question(rows, load), f"m = {m}, friction {mu}")


@dataclass(frozen=True)
class Bounded:
    """A question, and which robustness bound is applied to its wrench."""

    question: Question
    bound: Callable[[Grasp], RobustnessBound | None]
    states: tuple[str, ...]


def _within_bound_and_stable(bounded: Bounded) -> tuple[bool, bool]:
    grasp, wrench = grasp_of(bounded.question), bounded.question.wrench
    bound = bounded.bound(grasp)
    return bound is not None and bound.covers(wrench), Solver(grasp).solve(wrench).stable


def _within_bound_by_minors(bounded: Bounded) -> tuple[bool, bool]:
    """Return the same, by cofactors and principal minors, with no friction at rest."""
    touches = bounded.question.touches
    wrench = bounded.question.wrench
    size = oracle.dot(wrench, wrench)
    covered = any(
        within_bound(touches, states, size)
        for states in product(bounded.states, repeat=len(touches))
    )
    return covered, oracle.stable(bounded.question)


def _jaws(
    bound: Callable[[Grasp], RobustnessBound | None], states: tuple[str, ...], rng: random.Random
) -> Iterator[Case]:
    """Yield pairs of opposed contacts under wrenches just below a bound, and twice as large.

    Their preloads balance without friction.
    """
    for _ in range(8):
        rows: list[Row] = []
        for _ in range(rng.choice((1, 2))):
            a, b, c = rng.choice(_TRIPLES)
            normal, reach = (Fraction(a, c), Fraction(b, c)), rng.randint(1, 3)
            shift = (rng.randint(-2, 2), rng.randint(-2, 2))
            rest = (Fraction(rng.randint(1, 12), 4), Fraction(rng.choice((1, 1, 4))))
            preload = Fraction(rng.randint(1, 2))
            for s in (1, -1):
                point = [x - s * reach * n for x, n in zip(shift, normal, strict=True)]
                rows.append((*point, *(s * n for n in normal), *rest, preload))
        limit = bound(grasp_of(Question(tuple(rows), (Fraction(0),) * 3)))
        for way in ((1, 0, 0), (0, -1, 0), (1, 2, 2)):
            size = Fraction(int(9999 * (limit.value if limit else 0.0) / hypot(*way)), 10000)
            for times in (1, 2):
                question = Question(tuple(rows), tuple(times * size * x for x in way))
                label = f"m = {len(rows)}, w along {way}, {'beyond' if times > 1 else 'within'}"
                yield Case(label, Bounded(question, bound, states), question.to_dict())


def _robust(
    id: str, bound: Callable[[Grasp], RobustnessBound | None], states: tuple[str, ...]
) -> Claim:
    """Return the claim that all wrenches within a bound are resisted in the full model."""
    return stated(
        id,
        method=_within_bound_and_stable,
        minors=_within_bound_by_minors,
        judge=lambda _, verdicts: verdicts[1] or not verdicts[0],
        cases=partial(_jaws, bound, states),
    )


CLAIMS = (
    _method(
        "method-grasp-wrench-space",
        cases=_three("wrench-space", {"1": "yn", "100": "yn", "-1": "yy", "-100": "yy"}),
    ),
    _method(
        "method-cones-only",
        judge=lambda asked, verdicts: verdicts[0],
        cases=_cones,
        covers=lambda asked: all(touch.friction > 1 for touch in asked.question.touches),
        explain=lambda asked, verdicts: f"corrected model: {'Yes' if verdicts[1] else 'No'}",
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
    *(
        stated(
            f"form-closure-in-{place}",
            linear_program=lambda grasp: form_closure(grasp).accepts is True,
            elimination=lambda grasp: immobile(c.normal_wrench for c in grasp),
            judge=_enough,
            cases=partial(_closure_cases, dimension),
        )
        for place, dimension in (("the-plane", 2), ("space", 3))
    ),
    stated(
        "strong-is-virtual-work",
        faces=_classes,
        elimination=classes,
        judge=lambda _, verdicts: verdicts[0] == verdicts[1],
        cases=_loads,
        search=lambda: smallest_questions(range(1, 3), _SIDEWAYS, preloads=(0,)),
    ),
    stated(
        "frictionless-implies-strong",
        faces=_classes,
        elimination=classes,
        judge=lambda _, verdicts: verdicts[0] or not verdicts[1],
        cases=_frictionless,
    ),
    _robust("pcr-is-safe", contact_robustness, ("stick",)),
    _robust("pgr-is-safe", grasp_robustness, ("stick", "slip", "detached")),
)
