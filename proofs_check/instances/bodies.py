"""Textbook questions on several bodies, with borders known by hand, from ``bodies.json``.

Each has its answer; at a border one holds with equality, and one fails by a billionth.
"""

from __future__ import annotations

import json
from functools import cache
from importlib.resources import files
from typing import Any, NamedTuple


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
