"""The registry of what can be drawn of a grasp: one line each."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.drawing.views import Drawings, ViewEntry, able_to_show
from arrangement.numbers import budget
from equilibrium.model.grasp import Grasp

if TYPE_CHECKING:
    from equilibrium.wrench_sets.parameter import ResistedValues


def _in_plane(grasp: Grasp) -> bool:
    return grasp.dimension == 2


def _in_space(grasp: Grasp) -> bool:
    return grasp.dimension == 3


def _select(views: Mapping[str, ViewEntry], grasp: Grasp) -> dict[str, ViewEntry]:
    """Return what can be drawn of a grasp, in the plane or in space."""
    budget.check_size(len(grasp), "contacts in a picture")
    return able_to_show(views, grasp)


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
    select=_select,
)

#: What can be drawn of an assembly, or of the verdict on one.
OF_ASSEMBLIES = Drawings(
    "equilibrium.pictures",
    views={"assembly": ViewEntry("assemblies:draw_assembly")},
    models={},
    pages={},
)


def _along(answer: ResistedValues, count: int) -> Iterator[dict[str, Fraction]]:
    """Yield the values of a letter at which a movie shows the object."""
    low, high = answer.between.low, answer.between.high
    return ({"value": low + (high - low) * Fraction(k, count - 1)} for k in range(count))


#: What can be drawn of the values of a parameter.
OF_VALUES = Drawings(
    "equilibrium.pictures",
    views={"values": ViewEntry("parameter:draw_values", changes=_along)},
    models={},
    pages={},
)


def write_drawing(grasp: Grasp, *args: Any, **options: Any) -> dict[str, Any]:
    """Draw a grasp into a file; arguments and errors are those of `Drawings.write`."""
    return DRAWINGS.of(grasp).write(grasp, *args, **options)
