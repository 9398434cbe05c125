"""The registry of what can be drawn of an arrangement: one line each."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from arrangement.planes import Planes

from .registry import Drawings

DRAWINGS = Drawings(
    "arrangement.draw",
    views={
        "sphere": "sphere:draw_sphere",
        "planes": "planes:draw_planes",
        "cells": "cells:draw_cells",
        "lines": "lines:draw_lines",
        "stereographic": "stereographic:draw_stereographic",
        "gnomonic": "gnomonic:draw_gnomonic",
        "dual": "dual:draw_dual",
        "graph": "graph:draw_graph",
        "lattice": "lattice:draw_lattice",
    },
    models={"dual": "models:dual_model", "cells": "models:cells_model"},
    pages={"arrangement": "page:arrangement_page", "cells": "cells:cells_page"},
)


def drawings_of(planes: Planes) -> Drawings:
    """Return what can be drawn of planes, what suits them best as the first."""
    from .essential import suited

    kinds: dict[str, Any] = {}
    for kind in ("views", "models", "pages"):
        known = getattr(DRAWINGS, kind)
        kinds[kind] = {name: known[name] for name in suited(known, planes)}
    return replace(DRAWINGS, **kinds)


def write_drawing(planes: Planes, *args: Any, **options: Any) -> dict[str, str]:
    """Draw planes into a file; if no view is named, the one that suits them best.

    Arguments and errors are those of `Drawings.write`.
    """
    return drawings_of(planes).write(planes, *args, **options)
