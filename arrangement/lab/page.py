"""Interactive pages, each one file: shared modules, then those of the page, in one script."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from arrangement.draw.html_page import BASE_SCRIPT, BASE_STYLE, POLYGON, Template, one_page

_OWN = "arrangement.lab"
#: Exact rationals, and exact linear algebra: they need no page.
RATIONAL: Template = (_OWN, "rational.js")
LINEAR: Template = (_OWN, "linear.js")
SHARED: tuple[Template, ...] = (
    POLYGON,
    RATIONAL,
    LINEAR,
    *((_OWN, f"{name}.js") for name in ("background", "keep", "history", "fields", "links")),
    *((_OWN, f"{name}.js") for name in ("player", "exercises")),
)


def lab(
    title: str,
    body: Template,
    styles: Iterable[Template],
    scripts: Iterable[Template],
    data: Mapping[str, Any],
) -> str:
    """Return an interactive page, complete in itself.

    Args:
        title: of the window.
        body, styles, scripts: of the page; they come after the shared ones.
        data: what the script finds, as for `one_page`; ``exercises`` lists the exercises.
    """
    common: list[Template] = [BASE_STYLE, (_OWN, "lab.css")]
    return one_page(title, body, [*common, *styles], [BASE_SCRIPT, *SHARED, *scripts], data)
