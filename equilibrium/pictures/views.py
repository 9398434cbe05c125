"""The registry of what can be drawn of a grasp: one line each."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from arrangement.drawing.registry import Drawings, ViewEntry
from arrangement.numbers import budget
from equilibrium.model.grasp import Grasp

if TYPE_CHECKING:
    from arrangement.drawing.path_artist import Drawing


def _in_plane(grasp: Grasp) -> bool:
    return grasp.dimension == 2


def _in_space(grasp: Grasp) -> bool:
    return grasp.dimension == 3


DRAWINGS = Drawings(
    "equilibrium.pictures",
    views={
        "grasp": ViewEntry("grasp:draw_grasp"),
        "resist": ViewEntry("forces:draw_resist", _in_plane),
        "slice": ViewEntry("forces:draw_slice"),
        "polar": ViewEntry("forces:draw_polar", _in_plane),
        "compare": ViewEntry("forces:draw_compare", _in_plane),
        "methods": ViewEntry("forces:draw_methods"),
        "proof": ViewEntry("proof:draw_proof"),
        "wrench-set": ViewEntry("wrench_set:draw_wrench_set", _in_plane),
    },
    models={
        "wrench-set": ViewEntry("wrench_set:wrench_set_model", _in_plane),
        "grasp": ViewEntry("space_grasp:grasp_model", _in_space),
    },
    pages={
        "resist": ViewEntry("lab.page:resist_page", _in_plane),
        "proof": ViewEntry("proof:proof_page", _in_plane),
        "wrench-set": ViewEntry("wrench_set:wrench_set_page", _in_plane),
        "grasp": ViewEntry("space_grasp:grasp_page", _in_space),
    },
)

#: What can be drawn of an assembly, or of the verdict on one.
OF_ASSEMBLIES = Drawings(
    "equilibrium.pictures",
    views={"assembly": ViewEntry("assemblies:draw_assembly")},
    models={},
    pages={},
)


def drawings_of(grasp: Grasp) -> Drawings:
    """Return what can be drawn of a grasp, in the plane or in space."""
    budget.check_size(len(grasp), "contacts in a picture")
    return DRAWINGS.fitting(grasp)


def draw(grasp: Grasp, view: str | None = None, **options: Any) -> Drawing:
    """Draw a grasp as a figure; arguments and errors are those of `Drawings.draw`."""
    return drawings_of(grasp).draw(grasp, view, **options)


def write_drawing(grasp: Grasp, *args: Any, **options: Any) -> dict[str, Any]:
    """Draw a grasp into a file; arguments and errors are those of `Drawings.write`."""
    return drawings_of(grasp).write(grasp, *args, **options)
