"""The paper's map of resistible magnitudes over directions, by binary search, on the exact set."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.draw.output import require_matplotlib
from arrangement.exact import RationalVector, rational
from arrangement.polyhedra.intervals import Interval
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.wrench_sets import Region, resistible_region, search_map
from equilibrium.wrench_sets.search_map import Entry

from .legend import Legend
from .panel import Panel
from .row import read_extent, row_of_panels
from .style import BLUE, RIM, SHADE, VERMILION
from .window import Window, joint_window

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MAX_DIRECTIONS = 720


def draw_polar(
    grasp: Grasp,
    *,
    directions: int = 72,
    tolerance: Any = None,
    extent: Any = None,
    width: float = 88.0,
) -> Figure:
    """Draw what a binary search in each direction finds, on the exact set of resisted forces.

    Every direction has one mark, at the magnitude that the search returns, or at the rim when the
    largest magnitude tried is resisted ("without limit"). A dot: the search is right. A cross: it
    errs, by more than its tolerance; a dashed line shows magnitudes that it wrongly claims, a full
    line resisted ones that it misses. The shaded set and its border are exact.

    Args:
        grasp: contacts.
        directions: how many, evenly spaced from force x, counter-clockwise.
        tolerance: of the search; left out, a thousandth of the radius of the picture.
        extent: that radius; left out, the whole border is shown. The search tries magnitudes up to
            1000 times as much.
        width: of the figure, in millimetres.

    Raises:
        GraspError: a number that is out of range.
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    if not 1 <= directions <= MAX_DIRECTIONS:
        raise GraspError(f"directions is {directions}; a picture shows 1 to {MAX_DIRECTIONS}")
    region = resistible_region(grasp)
    radius = read_extent(extent) or _radius(region)
    step = radius / 1000 if tolerance is None else rational(tolerance, "tolerance")
    found = search_map(grasp, directions, step, 1000 * radius)
    window = Window((Fraction(0), Fraction(0)), radius)
    legend = Legend(width)
    _describe(found.entries, region, legend)
    figure, (panel,) = row_of_panels(1, width, window, legend, grasp)
    panel.title(f"largest resisted force in {directions} directions", above=8.0)
    panel.region(region, by_states=False)
    _round(panel)
    for i, entry in enumerate(found.entries):
        _mark(panel, i, entry)
    return figure


def _radius(region: Region) -> Fraction:
    """Return a radius that holds the border: of the window that does, about the origin."""
    window = joint_window([region])
    return window.half + max(map(abs, window.centre))


def _round(panel: Panel) -> None:
    """Cut everything drawn so far to the disc, and draw its rim."""
    from matplotlib.patches import Circle

    disc = Circle((0, 0), 1, transform=panel.axes.transData)
    for artist in (*panel.axes.patches, *panel.axes.lines):
        if artist.get_clip_on():
            artist.set_clip_path(disc)
    panel.axes.add_patch(Circle((0, 0), 1, fill=False, ec=RIM, lw=0.5, gid="rim", clip_on=False))


def _mark(panel: Panel, index: int, entry: Entry) -> None:
    style = {"zorder": 6, "clip_on": False, "gid": panel.gid("direction", index)}
    place = _at(panel.window, entry.direction, entry.found)[:, None]
    if entry.agrees:
        panel.axes.plot(*place, "o", ms=2.2, color=BLUE, **style)
        return
    panel.axes.plot(*place, "x", ms=4, mew=1.1, color=VERMILION, **style)
    kinds: tuple[tuple[str, tuple[Interval, ...], Any], ...] = (
        ("claimed", entry.wrongly_claimed, (0, (2, 1.2))),
        ("missed", entry.missed, "solid"),
    )
    for kind, parts, dashes in kinds:
        for k, (low, high) in enumerate(parts):
            ends = [_at(panel.window, entry.direction, end) for end in (low, high)]
            panel.axes.plot(*np.array(ends).T, color=VERMILION, lw=1.1, ls=dashes, zorder=5,
                            gid=f"{panel.gid(kind, index)}-{k}")  # fmt: skip


def _at(window: Window, direction: RationalVector, magnitude: Fraction | None) -> Any:
    """Return the place of a magnitude, on the rim when it lies beyond or has no end."""
    reach = window.half if magnitude is None else min(magnitude, window.half)
    return window.paper([reach * x for x in direction])


def _describe(entries: Iterable[Entry], region: Region, legend: Legend) -> None:
    listed = list(entries)
    wrong = [entry for entry in listed if not entry.agrees]
    legend.line(f"the binary search errs in {len(wrong)} of {len(listed)} directions")
    legend.key(SHADE, "resisted (exact)")
    if region.outline.border or region.outline.whiskers:
        legend.key("border", "resistance ends")
    if len(wrong) < len(listed):
        legend.key("dot", "search is right")
    if any(entry.found is None for entry in listed):
        legend.key("rim", "rim: without limit")
    if wrong:
        legend.key("cross", "search errs")
    if any(entry.wrongly_claimed for entry in wrong):
        legend.key("claimed", "wrongly claimed")
    if any(entry.missed for entry in wrong):
        legend.key("missed", "missed")
