"""The methods side by side: which forces each of them accepts, in one plane with the same axes."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.draw.output import require_matplotlib
from arrangement.progress import watched
from equilibrium.methods.regions import FORCES, METHODS, MOST_FOR_ALL_CHOICES, method_region
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench

from .legend import Legend
from .row import read_extent, row_of_panels
from .slices import paint_plain
from .style import SHADE, number, vector
from .window import joint_window

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Short titles that fit above a small panel.
TITLES = {
    "complete": "complete model",
    "cones": "springs and cones only",
    "wrench-space-L1": "wrench space, L1",
    "wrench-space-Linf": "wrench space, L∞",
    "weak": "weakly stable",
    "frictionless": "frictionless stable",
    "linear-compliance": "linear compliance",
    "frictionless-slip": "frictionless slip",
}


def draw_compare(
    grasp: Grasp,
    *,
    wrench: Iterable[Any] | None = None,
    methods: Iterable[str] | None = None,
    extent: Any = None,
    width: float = 180.0,
) -> Figure:
    """Draw the forces that each method accepts, as exact polygons: small multiples in one plane.

    Args:
        grasp: contacts; springs and preload count where a method knows of them.
        wrench: marked in every panel: a disc where the method accepts it, a cross where it does
            not; the plane has its torque.
        methods: keys of `equilibrium.methods.regions.METHODS`; left out, all (without the one that
            tries 3^m choices when the contacts are too many for it).
        extent: half the side of each panel, about the origin; left out, all borders are shown.
        width: of the figure, in millimetres.

    Raises:
        GraspError: an unknown method or none, too many contacts, an extent that is not above 0.
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    applied = None if wrench is None else read_wrench(wrench)
    torque = Fraction(0) if applied is None else applied[2]
    half = read_extent(extent)
    names = _names(grasp, methods)
    regions = [
        method_region(name, grasp, FORCES, (0, 0, torque)) for name in watched(names, "methods")
    ]
    marked = [] if applied is None else [applied[:2]]
    window = joint_window(regions, marked, half)
    legend = Legend(width)
    legend.key(SHADE, f"accepted forces at torque {number(torque)}")
    legend.key("border", "acceptance ends")
    if half is None:
        legend.key("fade", "without end")
    if applied is not None:
        legend.key("wrench-points", f"w = {vector(applied)}, accepted or not")
    figure, panels = row_of_panels(
        len(names), width, window, legend, grasp, columns=max(1, int(width / 44))
    )
    for panel, name, region in zip(panels, names, regions, strict=True):
        paint_plain(panel, TITLES[name], region, marked, fades=half is None)
    return figure


def _names(grasp: Grasp, methods: Iterable[str] | None) -> list[str]:
    if methods is None:
        few = len(grasp) <= MOST_FOR_ALL_CHOICES
        return [name for name in METHODS if few or name != "frictionless-slip"]
    names = list(methods)
    if not names:
        raise GraspError(f"no method is given; known are {', '.join(METHODS)}")
    return names
