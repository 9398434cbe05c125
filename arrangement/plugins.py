"""What packages above this one announce in entry points: files, instances, and displays.

So a value finds what draws it, and a reader its formats, without an import of what lies above.
"""

from __future__ import annotations

from typing import Any


def announced(group: str) -> Any:
    """Return the entry points of the group ``slipstates.<group>``."""
    from importlib.metadata import entry_points

    return entry_points(group=f"slipstates.{group}")


def display(name: str, value: object) -> str | None:
    """Return what a notebook shows of a value, by the function of this name in ``displays``.

    None where there is none, or where that function shows nothing.
    """
    found = announced("displays").select(name=name)
    return next((point.load()(value) for point in found), None)
