"""Panels of one window side by side, in rows, above one legend."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.exact import rational
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

from .legend import Legend
from .panel import ABOVE, BELOW, LEFT, Panel
from .style import new_figure
from .window import Window

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Space in millimetres between panels, and right of the last.
GAP, RIGHT = 4.0, 3.0
FORCE_NAMES = ("force x", "force y")


def row_of_panels(
    number: int,
    width: float,
    window: Window,
    legend: Legend,
    grasp: Grasp,
    columns: int | None = None,
) -> tuple[Figure, list[Panel]]:
    """Return a figure with empty panels of planes of forces; only outer ones have rulers."""
    unit = grasp.units.force if grasp.units else ""
    columns = min(number, columns or number)
    rows = -(-number // columns)
    side = (width - LEFT - RIGHT - (columns - 1) * GAP) / columns
    height = rows * (side + ABOVE) + (rows - 1) * GAP / 2 + BELOW + legend.height
    figure = new_figure(width, height)
    panels = []
    for i in range(number):
        row, column = divmod(i, columns)
        x = LEFT + column * (side + GAP)
        y = height - (row + 1) * (side + ABOVE) - row * GAP / 2
        panel = Panel(
            figure, window, (x, y), side, (width, height), "" if number == 1 else f"{i + 1}-"
        )
        panel.rulers(FORCE_NAMES, unit, left=column == 0, below=i + columns >= number)
        panels.append(panel)
    legend.draw(figure)
    return figure, panels


def read_extent(extent: Any) -> Fraction | None:
    """Return half the side of a picture, if it is given.

    Raises:
        GraspError: it is not above 0.
    """
    half = None if extent is None else rational(extent, "extent")
    if half is not None and half <= 0:
        raise GraspError(f"extent is {half}; it must be above 0")
    return half
