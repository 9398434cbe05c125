"""The figure in three parts of [HaasHeger2018]: wrench-space slice, no preload, preload 1."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.draw.output import require_matplotlib
from arrangement.exact import RationalVector
from equilibrium.methods.regions import FORCES, method_region
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.wrench_sets import Region, resistible_region

from .legend import Legend
from .panel import Panel
from .row import read_extent, row_of_panels
from .style import SHADE, number, vector
from .window import joint_window

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw_slice(
    grasp: Grasp,
    *,
    wrench: Iterable[Any] | None = None,
    extent: Any = None,
    width: float = 180.0,
) -> Figure:
    """Draw the resisted forces three times in the same plane, with the same axes.

    (a) The slice of the Grasp Wrench Space with normal forces that sum to at most 1: it knows
    neither springs nor preload. (b) The exact set without preload. (c) The same with preload 1 at
    every contact. The preloads of the grasp itself do not count. The border is drawn only where
    resistance ends; what reaches the edge has no end, and fades.

    Args:
        grasp: contacts.
        wrench: marked in every part; the plane has its torque.
        extent: half the side of each part, about the origin; left out, all borders are shown.
        width: of the figure, in millimetres.

    Raises:
        GraspError: an extent that is not above 0.
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    applied = None if wrench is None else read_wrench(wrench)
    torque = Fraction(0) if applied is None else applied[2]
    half = read_extent(extent)
    parts = slices(grasp, torque)
    marked = [] if applied is None else [applied[:2]]
    window = joint_window([region for _, region in parts], marked, half)
    legend = Legend(width)
    legend.key(SHADE, f"resisted forces at torque {number(torque)}")
    legend.key("border", "resistance ends")
    if half is None:
        legend.key("fade", "without end")
    if applied is not None:
        legend.key("wrench-points", f"w = {vector(applied)}")
    figure, panels = row_of_panels(3, width, window, legend, grasp)
    for panel, (title, region) in zip(panels, parts, strict=True):
        paint_plain(panel, title, region, marked, fades=half is None)
    return figure


def slices(grasp: Grasp, torque: Fraction) -> list[tuple[str, Region]]:
    """Return title and region of the three parts."""
    origin = (0, 0, torque)
    return [
        ("(a) Grasp Wrench Space, L1", method_region("wrench-space-L1", grasp, FORCES, origin)),
        ("(b) no preload", resistible_region(grasp.with_preload(0), FORCES, origin)),
        ("(c) preload 1", resistible_region(grasp.with_preload(1), FORCES, origin)),
    ]


def paint_plain(
    panel: Panel,
    title: str,
    region: Region,
    marked: Iterable[RationalVector],
    *,
    fades: bool,
) -> None:
    """Fill one panel with a region in one colour."""
    panel.title(title)
    panel.region(region, by_states=False)
    if fades:
        panel.fade()
    for point in marked:
        panel.wrench(point, region.contains(point))
