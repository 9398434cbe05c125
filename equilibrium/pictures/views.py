"""The registry of what can be drawn of a grasp: one line each."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from arrangement.drawing.registry import Drawings
from arrangement.numbers import budget
from equilibrium.model.grasp import Grasp

if TYPE_CHECKING:
    from arrangement.drawing.path_artist import Drawing

DRAWINGS = Drawings(
    "equilibrium.pictures",
    views={
        "grasp": "grasp.grasp:draw_grasp",
        "resist": "wrenches.forces:draw_resist",
        "slice": "wrenches.forces:draw_slice",
        "polar": "wrenches.polar:draw_polar",
        "compare": "wrenches.forces:draw_compare",
        "methods": "wrenches.forces:draw_methods",
        "proof": "grasp.proof:draw_proof",
        "wrench-set": "wrenches.wrench_set:draw_wrench_set",
    },
    models={
        "wrench-set": "wrenches.wrench_page:wrench_set_model",
        "grasp": "space.space_page:grasp_model",
    },
    pages={
        "resist": "lab.page:resist_page",
        "proof": "grasp.proof_page:proof_page",
        "wrench-set": "wrenches.wrench_page:wrench_set_page",
        "grasp": "space.space_page:grasp_page",
    },
)
#: What is not drawn of grasps in the plane, and in space.
_NOT: dict[int, dict[str, tuple[str, ...]]] = {
    2: {"models": ("grasp",), "pages": ("grasp",)},
    3: {
        "views": ("resist", "polar", "compare", "wrench-set"),
        "models": ("wrench-set",),
        "pages": ("resist", "proof", "wrench-set"),
    },
}


def drawings_of(grasp: Grasp) -> Drawings:
    """Return what can be drawn of a grasp, in the plane or in space."""
    budget.keep(len(grasp), "contacts in a picture")
    kinds: dict[str, Any] = {
        kind: {name: f for name, f in getattr(DRAWINGS, kind).items() if name not in names}
        for kind, names in _NOT[grasp.dimension].items()
    }
    return replace(DRAWINGS, **kinds)


def draw(grasp: Grasp, view: str | None = None, **options: Any) -> Drawing:
    """Draw a grasp as a figure; arguments and errors are those of `Drawings.draw`."""
    return drawings_of(grasp).draw(grasp, view, **options)


def write_drawing(grasp: Grasp, *args: Any, **options: Any) -> dict[str, str]:
    """Draw a grasp into a file; arguments and errors are those of `Drawings.write`."""
    return drawings_of(grasp).write(grasp, *args, **options)
