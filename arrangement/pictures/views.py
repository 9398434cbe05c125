"""All that can be drawn of an arrangement, a line each; and what notebooks show."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import DrawnRegion as DrawnRegion
from arrangement.drawing.output import image, save_figure as save_figure
from arrangement.drawing.views import Drawings, ViewEntry, compose as compose
from arrangement.pictures.coordinates import DUAL_MODEL, RANKS
from arrangement.planes.planes import Planes

#: Where each view is.
VIEWS = {
    "sphere": "globe:draw_sphere",
    "planes": "planes:draw_planes",
    "cells": "cells:draw_cells",
    "lines": "lines:draw_lines",
    "stereographic": "charts:draw_stereographic",
    "gnomonic": "charts:draw_gnomonic",
    "dual": "dual:draw_dual",
    "section": "planes:draw_section",
    "graph": "graph:draw_graph",
    "poset": "graph:draw_poset",
    "lattice": "lattice:draw_lattice",
}
#: The sphere has a panel of its own there, or is not wanted.
IN_PANELS = {"dual": {"sphere": False}}
MODELS = {
    "dual": ViewEntry("dual:dual_model", DUAL_MODEL),
    "cells": ViewEntry("cells:cells_model", RANKS["cells"]),
}
PAGES = {
    "arrangement": ViewEntry("lab.arrangement_page:arrangement_page", RANKS["sphere"]),
    "cells": ViewEntry("cells:cells_page", RANKS["cells"]),
}


def best_first(views: Mapping[str, ViewEntry], planes: Planes) -> dict[str, ViewEntry]:
    """Return views in the order in which they suit planes, those that cannot show them last."""
    first = "sphere" if planes.is_central else "cells"
    if planes.rank <= 2 and planes.dimension != 3:
        first = "lines"
    elif planes.rank == 4 and planes.is_central:
        first = "graph"
    elif planes.rank > 3:
        first = "lattice"

    def key(name: str) -> tuple[bool, bool]:
        return not views[name].shows(planes), name != first

    return {name: views[name] for name in sorted(views, key=key)}


DRAWINGS = Drawings(
    "arrangement.pictures",
    {name: ViewEntry(place, RANKS[name], IN_PANELS.get(name, {})) for name, place in VIEWS.items()},
    MODELS,
    PAGES,
    best_first,
)
#: What can be drawn of segments.
SEGMENTS = Drawings(
    "arrangement.pictures", {"segments": ViewEntry("segments:draw_segments")}, {}, {}
)


def write_drawing(planes: Planes, *args: Any, **options: Any) -> dict[str, Any]:
    """Draw planes into a file; if no view is named, the one that suits them best.

    Arguments and errors are those of `Drawings.write`.
    """
    return DRAWINGS.of(planes).write(planes, *args, **options)


#: Faces are counted for a table only where that takes no time worth noticing.
MOST_PLANES, MOST_DIMENSIONS = 10, 4


def arrangement_svg(arrangement: Arrangement) -> str | None:
    """Return the picture of `Arrangement.draw` as SVG text; None where there is none."""
    return DRAWINGS.svg(arrangement)


def arrangement_html(arrangement: Arrangement) -> str:
    """Return the picture, where there is one, and a table of counts."""
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
    table = f"<table><caption>Arrangement</caption>{cells}</table>"
    return f"<div>{image(arrangement_svg(arrangement), 'the arrangement')}{table}</div>"
