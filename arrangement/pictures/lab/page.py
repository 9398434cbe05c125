"""Interactive pages, each one file: shared modules, then those of the page, in one script."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from arrangement.drawing.pages.html_page import BASE_SCRIPT, BASE_STYLE, POLYGON, Template, one_page

_OWN = "arrangement.pictures.lab"
#: Exact rationals, and exact linear algebra: they need no page.
RATIONAL: Template = (_OWN, "rational.js")
LINEAR: Template = (_OWN, "linear.js")
#: Fields of exact numbers.
FIELDS: Template = (_OWN, "fields.js")
SHARED: tuple[Template, ...] = (
    POLYGON,
    FIELDS,
    *(
        (_OWN, f"{name}.js")
        for name in ("window", "keep", "history", "links", "player", "exercises")
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
    """Return an interactive page, complete in itself.

    Args:
        title: of the window.
        body, styles, scripts: of the page; they come after the shared ones.
        data: what the script finds, as for `one_page`: ``title``, ``summary``, ``examples`` and
            ``exercises`` are lists and texts of the panels that all labs have.
        decides: what needs no page, if a worker runs it as well; with `RATIONAL` and `LINEAR`.
    """
    common: list[Template] = [BASE_STYLE, (_OWN, "lab.css")]
    every = [BASE_SCRIPT, *SHARED, *scripts]
    parts = [(_OWN, f"{name}.html") for name in ("header", "player", "exercises", "grid")]
    return one_page(title, body, [*common, *styles], every, data, worker=decides, parts=parts)
