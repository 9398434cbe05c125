"""The registry of what can be drawn of an arrangement: one line each."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from arrangement.drawing.colours import DrawnRegion as DrawnRegion
from arrangement.drawing.output import save_figure as save_figure
from arrangement.drawing.registry import Drawings
from arrangement.planes.planes import Planes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DRAWINGS = Drawings(
    "arrangement.pictures",
    views={
        "sphere": "sphere.sphere:draw_sphere",
        "planes": "space.planes:draw_planes",
        "cells": "space.cells:draw_cells",
        "lines": "diagrams.lines:draw_lines",
        "stereographic": "sphere.stereographic:draw_stereographic",
        "gnomonic": "sphere.gnomonic:draw_gnomonic",
        "dual": "duals.dual:draw_dual",
        "graph": "duals.graph:draw_graph",
        "lattice": "diagrams.lattice:draw_lattice",
    },
    models={"dual": "duals.solids:dual_model", "cells": "space.cells:cells_model"},
    pages={"arrangement": "page.page:arrangement_page", "cells": "space.cells:cells_page"},
)


def drawings_of(planes: Planes) -> Drawings:
    """Return what can be drawn of planes, what suits them best as the first."""
    from .parts.essential import suited

    kinds: dict[str, Any] = {}
    for kind in ("views", "models", "pages"):
        known = getattr(DRAWINGS, kind)
        kinds[kind] = {name: known[name] for name in suited(known, planes)}
    return replace(DRAWINGS, **kinds)


def draw(planes: Planes, view: str | None = None, **options: Any) -> Figure:
    """Draw planes as a figure; arguments and errors are those of `Drawings.draw`."""
    return drawings_of(planes).draw(planes, view, **options)


def write_drawing(planes: Planes, *args: Any, **options: Any) -> dict[str, str]:
    """Draw planes into a file; if no view is named, the one that suits them best.

    Arguments and errors are those of `Drawings.write`.
    """
    return drawings_of(planes).write(planes, *args, **options)
