"""Arguments of functions that are not exact numbers, and the size of members of families."""

from __future__ import annotations

import math
from collections.abc import Iterable
from numbers import Integral
from typing import Any

from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import shown


def entries(values: Any, name: str, kind: str = "values") -> tuple[Any, ...]:
    """Return the entries of a sequence or array; refuse texts and what has none.

    >>> entries(range(3), "points")
    (0, 1, 2)
    """
    if not is_listed(values):
        raise InputError(f"{name} is {shown(values)}; give a sequence of {kind}")
    return tuple(values)


def is_listed(values: Any) -> bool:
    """Return whether this is a sequence or array of entries: no text, and no array of none."""
    listed = isinstance(values, Iterable) and not isinstance(values, (str, bytes))
    return listed and getattr(values, "ndim", 1) != 0


def whole(value: Any, name: str) -> int:
    """Return an integer argument, or refuse it."""
    if isinstance(value, bool) or not isinstance(value, Integral):
        raise InputError(f"{name} is {shown(value)}; give an integer")
    return int(value)


def at_least(value: Any, least: int, name: str) -> int:
    """Return an integer argument of at least this size, or refuse it."""
    number = whole(value, name)
    if number < least:
        raise InputError(f"{name} is {shown(number)}; it must be at least {least}")
    return number


def flag(value: Any, name: str) -> bool:
    """Return a Boolean argument, or refuse it."""
    if not isinstance(value, bool):
        raise InputError(f"{name} is {shown(value)}; give True or False")
    return value


def check_reach(planes: float, dimension: float, bits: float = 0) -> None:
    """Refuse a member that is out of reach, before any plane of it is made.

    Args:
        bits: of an entry, where they are many.
    """
    entries = planes * dimension if math.inf not in (planes, dimension) else math.inf
    budget.check_cost(
        f"{budget.about(planes)} planes in dimension {budget.about(dimension)}",
        "take a smaller member",
        steps=60 * planes + entries * (2 + bits**2 / 10_000 if bits < 1e100 else math.inf),
        bytes=350 * planes + entries * (90 + bits / 8),
    )
