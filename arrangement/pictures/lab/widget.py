"""A lab in a notebook: a widget that gives its state back to Python, or the page alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from importlib.resources import files
from typing import Any

from arrangement.console.plugins import InlinePage
from arrangement.errors import MissingExtraError, extra


def lab_widget(page: str, reads: Mapping[str, Callable[[str], Any]]) -> Any:
    """Return a lab for a notebook; without anywidget it is shown, and gives nothing back.

    Args:
        page: the lab.
        reads: attributes of the widget, each with what returns its value from the state of the page
            (what a link has after ``#``), which is empty until something is changed.
    """
    try:
        widget = _widget()
    except MissingExtraError:
        return InlinePage(page)
    return widget(reads, page=page)


@cache
def _widget() -> Any:
    with extra("notebook"):
        import anywidget
        import traitlets

    base: Any = anywidget.AnyWidget

    class Lab(base):  # type: ignore[misc]
        """A lab; `state` follows the page."""

        _esm = files(__package__).joinpath("templates", "widget.js").read_text("utf-8")
        page = traitlets.Unicode().tag(sync=True)
        state = traitlets.Unicode().tag(sync=True)

        def __init__(self, reads: Mapping[str, Callable[[str], Any]], **traits: Any) -> None:
            self._reads = reads
            super().__init__(**traits)

        def __getattr__(self, name: str) -> Any:
            if name == "_reads" or name not in self._reads:
                raise AttributeError(name)
            return self._reads[name](self.state)

    return Lab
