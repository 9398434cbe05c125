"""What can be drawn of an arrangement, and what notebooks show."""

from __future__ import annotations

from dataclasses import replace
from html import escape
from typing import TYPE_CHECKING, Any

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import DrawnRegion as DrawnRegion
from arrangement.drawing.figure import compose as compose
from arrangement.drawing.output import require_matplotlib, save_figure as save_figure
from arrangement.drawing.registry import KINDS, Drawings
from arrangement.errors import MissingExtraError
from arrangement.numbers import budget
from arrangement.planes.planes import Planes

from .parts.registry import MODELS, PAGES, VIEWS, suited

if TYPE_CHECKING:
    from arrangement.drawing.path_artist import Drawing

DRAWINGS = Drawings("arrangement.pictures", VIEWS, MODELS, PAGES)


def drawings_of(planes: Planes) -> Drawings:
    """Return what can be drawn of planes, what suits them best as the first."""
    kinds: dict[str, Any] = {f"{kind}s": suited(DRAWINGS.entries(kind), planes) for kind in KINDS}
    return replace(DRAWINGS, **kinds)


def draw(planes: Planes, view: str | None = None, **options: Any) -> Drawing:
    """Draw planes as a figure; arguments and errors are those of `Drawings.draw`."""
    return drawings_of(planes).draw(planes, view, **options)


def write_drawing(planes: Planes, *args: Any, **options: Any) -> dict[str, Any]:
    """Draw planes into a file; if no view is named, the one that suits them best.

    Arguments and errors are those of `Drawings.write`.
    """
    return drawings_of(planes).write(planes, *args, **options)


#: Faces are counted for a table only where that takes no time worth noticing.
MOST_PLANES, MOST_DIMENSIONS = 10, 4


def arrangement_svg(arrangement: Arrangement) -> str | None:
    """Return the great circles as SVG text; None where there is no such picture."""
    if not _has_picture(arrangement):
        return None
    return DRAWINGS.svg(arrangement, "sphere")


def arrangement_html(arrangement: Arrangement) -> str | None:
    """Return a table of counts; None where a picture is shown instead."""
    if _has_picture(arrangement):
        return None
    kind = "central" if arrangement.is_central else "affine"
    rows = [
        ("space", f"R<sup>{arrangement.dimension}</sup>"),
        ("planes", f"{len(arrangement)} ({len(arrangement.distinct)} distinct), {kind}"),
        ("rank", str(arrangement.rank)),
    ]
    if len(arrangement.distinct) <= MOST_PLANES and arrangement.dimension <= MOST_DIMENSIONS:
        counts = enumerate(arrangement.f_vector)
        rows += [(f"faces of dimension {k}", str(number)) for k, number in counts]
    cells = "".join(f"<tr><th>{escape(name)}</th><td>{text}</td></tr>" for name, text in rows)
    return f"<table><caption>Arrangement</caption>{cells}</table>"


def _has_picture(arrangement: Arrangement) -> bool:
    """Return whether there are great circles, few enough, and matplotlib to draw them."""
    if arrangement.dimension != 3 or not arrangement.is_central or arrangement.rank < 3:
        return False
    try:
        require_matplotlib()
    except MissingExtraError:
        return False
    return len(arrangement.distinct) <= budget.max_size("great circles in a picture")
