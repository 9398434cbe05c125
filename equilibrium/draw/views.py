"""The registry of what can be drawn of a grasp: one line each."""

from __future__ import annotations

from arrangement.draw.registry import Drawings

DRAWINGS = Drawings(
    "equilibrium.draw",
    views={
        "grasp": "grasp:draw_grasp",
        "resist": "resist:draw_resist",
        "slice": "slices:draw_slice",
        "polar": "polar:draw_polar",
        "compare": "compare:draw_compare",
        "methods": "methods:draw_methods",
        "proof": "proof:draw_proof",
        "wrench-set": "wrench_set:draw_wrench_set",
    },
    models={"wrench-set": "wrench_page:wrench_set_model"},
    pages={
        "resist": "page:resist_page",
        "proof": "proof_page:proof_page",
        "wrench-set": "wrench_page:wrench_set_page",
    },
)
write_drawing = DRAWINGS.write
