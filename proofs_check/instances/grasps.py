"""Grasps to check claims on: those of the paper, and small ones in order of size.

Questions on several bodies, with stability limits known by hand, are in ``bodies.json``. Each has
its answer; at a limit one holds with equality, and one fails by a billionth.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import cache, lru_cache
from importlib.resources import files
from itertools import combinations, product
from typing import Any, NamedTuple

from arrangement.arrangement import Arrangement
from arrangement.enumeration.paper_steps import published_enumeration
from equilibrium.model.grasp import Grasp
from proofs_check.routes.oracle import Question, Row
from proofs_check.statements.statement import Case

from . import printed

#: Unit normals along the axes.
AXES = ((1, 0), (0, 1), (-1, 0), (0, -1))
_SLIP = {1: "slip+", -1: "slip-", 0: "stick"}


def paper_question(
    contacts: Iterable[Sequence[int]],
    wrench: Sequence[Fraction | int | str],
    preload: Fraction | int | str,
    friction: Fraction = printed.FRICTION,
) -> Question:
    """Return a grasp of the paper under a wrench, with one preload at all contacts."""
    rest = (friction, Fraction(1), Fraction(preload))
    rows = tuple((*map(Fraction, contact), *rest) for contact in contacts)
    return Question(rows, tuple(Fraction(x) for x in wrench))


def grasp_of(question: Question) -> Grasp:
    """Return the grasp of a question in the types of the solver."""
    document = dict(question.to_dict())
    del document["wrench"]
    return Grasp.from_dict(document)


def listed_states(
    grasp: Grasp, *, detachment: bool, all_stick: bool
) -> tuple[tuple[str, ...], ...]:
    """Return the slip states of the published Steps 1 to 3, coincident planes merged.

    Args:
        grasp: its tangential planes are enumerated.
        detachment: let any of the contacts be detached instead.
        all_stick: add the state in which every contact sticks, if the steps leave it out.
    """
    signs = _published_states(grasp.tangential_arrangement())
    slips = [tuple(_SLIP[s] for s in state) for state in signs]
    if all_stick:
        slips.append(("stick",) * len(grasp))
    if detachment:
        choices = (product(*((state, "detached") for state in states)) for states in slips)
        slips = [states for chosen in choices for states in chosen]
    return tuple(dict.fromkeys(slips))


@lru_cache(maxsize=256)
def _published_states(planes: Arrangement) -> tuple[tuple[int, ...], ...]:
    return published_enumeration(planes, merge=True).distinct_states


def grasp_case(question: Question, label: str = "") -> Case:
    """Return a question as a case with its file form."""
    return Case(label or f"m = {len(question.contacts)}", question, question.to_dict())


def smallest_questions(
    contacts: range,
    wrenches: Sequence[Sequence[int]],
    *,
    frictions: Sequence[Fraction] = (Fraction(1),),
    preloads: Sequence[int] = (0, 1),
    reach: int = 1,
) -> Iterator[Case]:
    """Yield questions with few contacts first, then with small numbers first.

    Contacts at different points of the integer grid up to `reach`, with normals along the axes
    (at one point two contacts would be a corner); one friction coefficient and one preload for
    all contacts, stiffness 1.
    """
    grid = sorted(
        product(range(-reach, reach + 1), repeat=2), key=lambda p: (abs(p[0]) + abs(p[1]), p)
    )
    places = [(*point, *normal) for point in grid for normal in AXES]
    for m in contacts:
        for chosen in combinations(places, m):
            if len({place[:2] for place in chosen}) < m:
                continue
            for friction, preload, wrench in product(frictions, preloads, wrenches):
                rest: Row = (friction, Fraction(1), Fraction(preload))
                rows = tuple((*map(Fraction, place), *rest) for place in chosen)
                yield grasp_case(Question(rows, tuple(map(Fraction, wrench))))


class BodiesQuestion(NamedTuple):
    """One question.

    Attributes:
        case: what it is about, with how many questions were before it.
        document: bodies and contacts, as an assembly file has them.
        wrench: on bodies, by name.
        resisted: the answer by hand.
        example: motion and forces of an equilibrium, if there is one.
    """

    case: str
    document: dict[str, Any]
    wrench: dict[str, list[str]]
    resisted: bool
    example: dict[str, Any] | None


@cache
def textbook_questions() -> tuple[BodiesQuestion, ...]:
    """Return the questions, in seven cases."""
    text = files(__package__).joinpath("bodies.json").read_text(encoding="utf-8")
    return tuple(
        BodiesQuestion(
            f"{case['name']}-{k}",
            {"bodies": case["bodies"], "contacts": question["contacts"]},
            question["wrench"],
            question["resisted"],
            question.get("example"),
        )
        for case in json.loads(text)["cases"]
        for k, question in enumerate(case["questions"])
    )
