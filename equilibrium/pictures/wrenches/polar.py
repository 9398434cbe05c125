"""The paper's map of resisted magnitudes over directions, by binary search, on the exact set."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from arrangement.drawing.colours import VERMILION
from arrangement.drawing.figure import picture
from arrangement.drawing.registry import Exact
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.scene import Legend, Scene
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, rational
from arrangement.numbers.linear.intervals import Interval
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.parts.panel import Panel, explain_borders, read_extent, row_of_panels
from equilibrium.pictures.parts.style import MARKS, RIM, SHADE, symbol
from equilibrium.pictures.parts.window import ROOM, Window, ends
from equilibrium.wrench_sets import Region
from equilibrium.wrench_sets.plane import resisted_region
from equilibrium.wrench_sets.search_map import Entry, search_map


@picture(20.0)
def draw_polar(
    grasp: Grasp,
    *,
    rays: int = 72,
    tolerance: Exact | None = None,
    extent: Exact | None = None,
    width: float = 88.0,
) -> Scene:
    """Draw what a binary search in each direction finds, on the exact set of resisted forces.

    Every direction has one mark, at the magnitude that the search returns, or at the rim when the
    largest magnitude tried is resisted ("unbounded"). A dot: the search is right. A cross: it
    errs, by more than its tolerance; a dashed line shows magnitudes that it wrongly claims, a full
    line resisted ones that it misses. The shaded set and its boundary are exact.

    Args:
        grasp: contacts.
        rays: how many, evenly spaced from f_x, counter-clockwise.
        tolerance: of the search; if omitted, a thousandth of the radius of the picture.
        extent: that radius; if omitted, it holds the largest preload and the ends of the boundary.
            The search tries magnitudes up to 1000 times as much.

    Raises:
        GraspError: a number that is out of range.
    """
    if rays < 1:
        raise GraspError(f"the number of rays is {rays}; give at least 1")
    budget.check_size(rays, "rays in a picture")
    region = resisted_region(grasp)
    radius = read_extent(extent) or _radius(grasp, region)
    step = radius / 1000 if tolerance is None else rational(tolerance, "tolerance")
    found = search_map(grasp, rays, step, 1000 * radius)
    window = Window((Fraction(0), Fraction(0)), radius)
    scene, (panel,) = row_of_panels(1, window, width, grasp)
    _describe(found.entries, region, scene.legend)
    panel.title(f"largest resisted force in {rays} directions", above=8.0)
    middle, half = panel.at((0, 0)), panel.side / 2
    panel.region(region, by_states=False, clip=(middle, half))
    scene.circle(middle, half, fill=False, ec=RIM, lw=0.5, gid="rim")
    for i, entry in enumerate(found.entries):
        _mark(panel, i, entry)
    return scene


def _radius(grasp: Grasp, region: Region) -> Fraction:
    """Return a radius that holds the ends of the boundary, with room; if 0 is all, the preloads."""
    needed = [*ends(region), (max((c.preload for c in grasp), default=Fraction(0)), Fraction(0))]
    largest = max(max(map(abs, point)) for point in needed)
    if not largest:
        return Fraction(1)
    norms = (math.hypot(*(float(x / largest) for x in point)) for point in needed)
    return largest * Fraction(math.ceil(20 * max(norms) * (1 + ROOM)), 20)


def _mark(panel: Panel, index: int, entry: Entry) -> None:
    scene, gid = panel.scene, panel.gid("direction", index)
    sign, size, style = MARKS["dot" if entry.agrees else "cross"]
    place = _at(panel, entry.direction, entry.found)
    scene.mark(place, sign, size, zorder=6, gid=gid, **style)
    kinds: tuple[tuple[str, tuple[Interval, ...], Any], ...] = (
        ("claimed", entry.wrongly_claimed, (0, (2, 1.2))),
        ("missed", entry.missed, "solid"),
    )
    for kind, parts, dashes in kinds if not entry.agrees else ():
        for k, part in enumerate(parts):
            line, gid = [_at(panel, entry.direction, end) for end in part], panel.gid(kind, index)
            scene.line(line, ec=VERMILION, lw=1.1, ls=dashes, zorder=5, gid=f"{gid}-{k + 1}")


def _at(panel: Panel, direction: RationalVector, magnitude: Fraction | None) -> Floats:
    """Return the place of a magnitude, on the rim when it lies beyond or is unbounded."""
    half = panel.window.half
    reach = half if magnitude is None else min(magnitude, half)
    return panel.at(panel.window.paper([reach * x for x in direction]))


def _describe(entries: Iterable[Entry], region: Region, legend: Legend) -> None:
    listed = list(entries)
    wrong = [entry for entry in listed if not entry.agrees]
    legend.line(f"the binary search is wrong in {len(wrong)} of {len(listed)} directions")
    legend.key(symbol(SHADE), "resisted (exact)")
    explain_borders(legend, [region], fades=False)
    if len(wrong) < len(listed):
        legend.key(symbol("dot"), "search is correct")
    if any(entry.found is None for entry in listed):
        legend.key(symbol("rim"), "rim: unbounded")
    if wrong:
        legend.key(symbol("cross"), "search is wrong")
    if any(entry.wrongly_claimed for entry in wrong):
        legend.key(symbol("claimed"), "wrongly claimed")
    if any(entry.missed for entry in wrong):
        legend.key(symbol("missed"), "missed")
