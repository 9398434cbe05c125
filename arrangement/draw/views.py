"""The registry of what can be drawn of an arrangement: one line each."""

from __future__ import annotations

from .registry import Drawings

DRAWINGS = Drawings(
    "arrangement.draw",
    views={
        "sphere": "sphere:draw_sphere",
        "planes": "planes:draw_planes",
        "stereographic": "stereographic:draw_stereographic",
        "gnomonic": "gnomonic:draw_gnomonic",
        "dual": "dual:draw_dual",
        "graph": "graph:draw_graph",
        "lattice": "lattice:draw_lattice",
    },
    models={"dual": "models:dual_model", "cells": "models:cells_model"},
    pages={"arrangement": "page:arrangement_page"},
)
write_drawing = DRAWINGS.write
