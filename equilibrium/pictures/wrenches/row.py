"""Panels of one window side by side, in rows."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from arrangement.drawing.registry import Exact, Wrench
from arrangement.drawing.scene.measuring import POINTS, checked_width
from arrangement.drawing.scene.scene import Legend, Scene
from arrangement.numbers.exact import RationalVector, rational, shown
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.pictures.keys import symbol
from equilibrium.wrench_sets import Region

from .panel import ABOVE, BELOW, LEFT, Panel
from .window import Window

#: Space in points between panels, and right of the last.
GAP, RIGHT = 4.0 * POINTS, 3.0 * POINTS
FORCE_NAMES = ("$f_x$", "$f_y$")


class PlaneQuestion:
    """What a picture of a plane of forces is asked: a wrench to be marked, and half its side.

    Raises:
        GraspError: no wrench, or an extent that is not above 0.
    """

    def __init__(self, wrench: Wrench | None, extent: Exact | None) -> None:
        self.wrench = None if wrench is None else read_wrench(wrench)
        self.half = read_extent(extent)

    @property
    def torque(self) -> Fraction:
        """The torque of the plane."""
        return Fraction(0) if self.wrench is None else self.wrench[2]

    @property
    def marked(self) -> list[RationalVector]:
        """The force to be marked, if there is one."""
        return [] if self.wrench is None else [self.wrench[:2]]


def row_of_panels(
    number: int,
    window: Window,
    width: float,
    grasp: Grasp,
    columns: int | None = None,
    names: Sequence[str] = FORCE_NAMES,
) -> tuple[Scene, list[Panel]]:
    """Return a scene with empty panels of planes of wrenches; only outer ones have rulers."""
    given, width = grasp.units, checked_width(width, 20.0)
    units = [(given.force if "f" in name else given.torque) if given else "" for name in names]
    columns = min(number, columns or number)
    rows = -(-number // columns)
    side = (width * POINTS - LEFT - RIGHT - (columns - 1) * GAP) / columns
    height = rows * (side + ABOVE) + (rows - 1) * GAP / 2 + BELOW
    scene = Scene(width, height / POINTS)
    panels = []
    for i in range(number):
        row, column = divmod(i, columns)
        x = LEFT + column * (side + GAP)
        y = height - (row + 1) * (side + ABOVE) - row * GAP / 2
        panel = Panel(scene, window, (x, y), side, "" if number == 1 else f"{i + 1}-")
        panel.rulers(names, units, left=column == 0, below=i + columns >= number)
        panels.append(panel)
    return scene, panels


def explain_borders(legend: Legend, regions: Sequence[Region], fades: bool) -> None:
    """Say what lines, points and faded edges of regions mean."""
    outlines = [region.outline for region in regions]
    if any(outline.border or outline.whiskers for outline in outlines):
        legend.key(symbol("border"), "resistance ends")
    if any(outline.points for outline in outlines):
        legend.key(symbol("accepted"), "resisted: this alone")
    if fades and not all(p.polyhedron.bounded for region in regions for p in region.polygons):
        legend.key(symbol("fade"), "without end")


def read_extent(extent: Exact | None) -> Fraction | None:
    """Return half the side of a picture, if it is given.

    Raises:
        GraspError: it is not above 0.
    """
    half = None if extent is None else rational(extent, "extent")
    if half is not None and half <= 0:
        raise GraspError(f"extent is {shown(half)}; it must be above 0")
    return half
