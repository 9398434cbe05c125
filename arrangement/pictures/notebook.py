"""What a notebook shows of an arrangement: its great circles, or a short table of counts."""

from __future__ import annotations

from html import escape

from arrangement.arrangement import Arrangement
from arrangement.drawing.output import require_matplotlib, svg_text
from arrangement.errors import MissingExtraError
from arrangement.numbers import budget

from .sphere.sphere import draw_sphere

#: Faces are counted for a table only where that takes no time worth noticing.
MOST_PLANES, MOST_DIMENSIONS = 10, 4


def arrangement_svg(arrangement: Arrangement) -> str | None:
    """Return the great circles as SVG text; None where there is no such picture."""
    if not _has_picture(arrangement):
        return None
    return svg_text(lambda: draw_sphere(arrangement))


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
    return len(arrangement.distinct) <= budget.most("great circles in a picture")
