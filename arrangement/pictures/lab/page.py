"""Interactive pages, each one file of shared modules and those of the page; and their exercises."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Collection, Iterable, Mapping
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, TypeAlias

from arrangement.drawing.pages import BASE_SCRIPT, BASE_STYLE, POLYGON, Template, one_page
from arrangement.errors import InputError
from arrangement.library.files.json_files import check_keys, check_list, read_document
from arrangement.numbers import budget
from arrangement.numbers.exact import shown, to_text

_OWN = "arrangement.pictures.lab"
#: Exact rationals, vectors and linear algebra: they need no page.
RATIONAL: Template = (_OWN, "rational.js")
VECTORS: Template = (_OWN, "vectors.js")
LINEAR: Template = (_OWN, "linear.js")
#: Fields of exact numbers.
FIELDS: Template = (_OWN, "fields.js")
SHARED: tuple[Template, ...] = (
    POLYGON,
    FIELDS,
    *(
        (_OWN, f"{name}.js")
        for name in ("window", "keep", "history", "links", "player", "exercises", "editor")
    ),
)


def lab(
    title: str,
    body: Template,
    styles: Iterable[Template],
    scripts: Iterable[Template],
    data: Mapping[str, Any],
    decides: Iterable[Template] = (),
) -> str:
    """Build a self-contained interactive page.

    Args:
        title: of the window.
        body, styles, scripts: of the page; they come after the shared ones.
        data: what the script finds, as for `one_page`: ``title``, ``summary``, ``examples`` and
            ``exercises`` are lists and texts of the panels that all labs have; ``own`` says whether
            the exercises came with a file.
        decides: what needs no page, if a worker runs it as well; with `RATIONAL`,
            `VECTORS` and `LINEAR`.
    """
    common: list[Template] = [BASE_STYLE, (_OWN, "lab.css")]
    every = [BASE_SCRIPT, *SHARED, *scripts]
    parts = [(_OWN, f"{name}.html") for name in ("header", "player", "exercises", "editor", "grid")]
    return one_page(title, body, [*common, *styles], every, data, worker=decides, parts=parts)


#: For each kind of goal what raises an InputError if its value is none.
Goals: TypeAlias = Mapping[str, Callable[[Any], object]]

_TEXTS = ("name", "task", "start")
_LONGEST = 2000


def read_exercises(
    source: str | Path | Traversable,
    goals: Goals,
    fixed: Collection[str],
    read_start: Callable[[str], object],
) -> list[dict[str, Any]]:
    """Return the exercises of a JSON file.

    The file holds ``{"schema_version": 1, "exercises": [...]}``. Each exercise has ``name``,
    ``task`` (texts), ``start`` (the part of a link after ``#``), ``goal`` (an object with one
    entry: its kind and what that kind takes), and may have ``hints`` (texts) and ``fixed`` (names
    of what must stay as it starts).

    Args:
        source: the file, by its path or as a part of a package.
        goals: what checks the value of each kind of goal.
        fixed: names that may stand in ``fixed``.
        read_start: what checks a start.

    Raises:
        InputError: no such form; the message names the exercise, the value and the rule.
    """
    if isinstance(source, (str, os.PathLike)):
        document = read_document(source, ("exercises",))
    else:
        document = read_document(json.loads(source.read_text("utf-8")), ("exercises",))
    check_keys(document, ("schema_version", "exercises"), ("description",), "the document")
    read = []
    for number, entry in enumerate(check_list(document["exercises"], "exercises"), 1):
        try:
            read.append(_exercise(entry, goals, fixed, read_start))
        except InputError as error:
            raise InputError(f"exercise {number}: {error}") from None
    if not read:
        raise InputError("exercises is an empty list; write one or more")
    return read


def _exercise(
    entry: Any, goals: Goals, fixed: Collection[str], read_start: Callable[[str], object]
) -> dict[str, Any]:
    check_keys(entry, (*_TEXTS, "goal"), ("hints", "fixed"), "it")
    for name in _TEXTS:
        text = entry[name]
        if not isinstance(text, str) or not 0 < len(text) <= _LONGEST:
            raise InputError(f'"{name}" must be a text of 1 to {_LONGEST} characters')
    lists = {name: check_list(entry.get(name, []), name) for name in ("hints", "fixed")}
    for name, texts in lists.items():
        if not all(isinstance(text, str) for text in texts):
            raise InputError(f'"{name}" must be a list of texts')
    strange = next((name for name in lists["fixed"] if name not in fixed), None)
    if strange is not None:
        raise InputError(f'"fixed" has {shown(strange)}; expected one of {", ".join(fixed)}')
    goal = entry["goal"]
    if not isinstance(goal, dict) or len(goal) != 1 or not set(goal) <= set(goals):
        raise InputError(f'"goal" must be an object with one of: {", ".join(goals)}')
    for where, check, value in (
        ("start", read_start, entry["start"]),
        *((f"goal {kind}", goals[kind], value) for kind, value in goal.items()),
    ):
        try:
            check(value)
            _check_digits(value)
        except InputError as error:
            raise InputError(f"{where}: {error}") from None
    return {**{name: entry[name] for name in _TEXTS}, **lists, "goal": goal}


def _check_digits(value: Any) -> None:
    """Refuse integers that are too long to be written on a page."""
    if isinstance(value, (dict, list)):
        for part in value.values() if isinstance(value, dict) else value:
            _check_digits(part)
    elif isinstance(value, int):
        budget.check_size(len(to_text(abs(value))), "digits of a number on a page", shown(value))
