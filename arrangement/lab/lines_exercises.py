"""The exercises of the arrangement lab: those that come with it, and how own ones are checked."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path
from typing import Any

from arrangement.errors import InputError
from arrangement.exact import shown

from .exercises import read_exercises
from .lines_input import MAX_PLANES, read_start

#: What `lab.count` returns, and goals may ask for.
COUNTS = (
    *("planes", "distinct_planes", "dimension", "rank", "f_vector", "regions", "bounded_regions"),
    *("characteristic_polynomial", "t_vector", "p_vector", "simple", "simplicial", "triangles"),
    "type",
)
#: Planes that may have to stay, by number.
FIXED = tuple(str(k) for k in range(1, MAX_PLANES + 1))


def line_exercises(path: str | Path | None = None) -> list[dict[str, Any]]:
    """Return the exercises of a file, or those that come with the lab.

    A goal is ``{"counts": {...}}`` with values of `lab.count`; ``{"meet": [[1, 2, 3]]}`` with lists
    of lines that go through one point each; or ``{"closes": {"meet": [...], "then": [...]}}``,
    whose last list of lines is found to meet by itself.

    Raises:
        InputError: the file holds no exercises; the message says which, and why.
    """
    own = files(__package__).joinpath("lines_exercises.json")
    return read_exercises(own if path is None else path, _GOALS, FIXED, read_start)


def _check_counts(value: Any) -> None:
    unknown = sorted(set(value) - set(COUNTS)) if isinstance(value, dict) else ["no object"]
    if unknown or not value:
        raise InputError(f"has {shown(unknown)}; give values of: {', '.join(COUNTS)}")


def _check_meet(value: Any) -> None:
    lists = value if isinstance(value, list) else [None]
    if not value or not all(_is_list_of_planes(one) for one in lists):
        raise InputError(f"is {shown(value)}; give lists of three plane numbers or more")


def _check_closes(value: Any) -> None:
    if not isinstance(value, dict) or set(value) != {"meet", "then"}:
        raise InputError(f'is {shown(value)}; give "meet", lists of planes, and "then", one list')
    _check_meet(value["meet"])
    _check_meet([value["then"]])


def _is_list_of_planes(one: Any) -> bool:
    return (
        isinstance(one, list)
        and len(set(map(str, one))) == len(one) >= 3
        and all(type(k) is int and 1 <= k <= MAX_PLANES for k in one)
    )


_GOALS = {"counts": _check_counts, "meet": _check_meet, "closes": _check_closes}
