"""What packages above this one announce in entry points: files, tables, instances, displays.

So a value finds what draws it, and a reader its formats, without an import of what lies above.
"""

from __future__ import annotations

import html
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


class InlinePage:
    """An HTML page, complete in itself, that a notebook shows in a frame of its cell."""

    def __init__(self, text: str) -> None:
        self.text = text

    def _repr_html_(self) -> str:
        return (
            f'<iframe srcdoc="{html.escape(self.text)}" sandbox="allow-scripts allow-downloads" '
            'style="width: 100%; height: 48rem; border: 0"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<InlinePage of {len(self.text)} characters, which a notebook shows>"


def inline_page(name: str, value: object) -> InlinePage:
    """Return the page that the function of this name in ``displays`` makes of a value."""
    text = display(name, value)
    if text is None:
        raise LookupError(f"nothing in slipstates.displays is called {name}")
    return InlinePage(text)
