"""Argument checks that all families share."""

from __future__ import annotations

from arrangement.errors import InputError
from arrangement.exact import shown


def at_least(value: int, least: int, name: str) -> int:
    """Return an integer argument, or refuse it."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise InputError(f"{name} is {value!r}; give an integer")
    if value < least:
        raise InputError(f"{name} is {shown(value)}; it must be at least {least}")
    return value
