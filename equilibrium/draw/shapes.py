"""Arrows, cones and marks as patches, and labels that keep apart."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from arrangement.draw.output import require_matplotlib

from .body import Floats
from .style import FONT


def curve_patch(points: Floats, **style: Any) -> Any:
    """Return a path of cubic pieces; closed when it ends where it starts."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    codes: list[Any] = [Path.MOVETO] + [Path.CURVE4] * (len(points) - 1)
    if np.allclose(points[0], points[-1]):
        points = np.concatenate([points, points[:1]])
        codes.append(Path.CLOSEPOLY)
    return PathPatch(Path(points, codes), **style)


def arrow(start: Floats, end: Floats, unit: float, **style: Any) -> Any:
    """Return an arrow, at least 2.5 points long so that what is not zero can be seen.

    Args:
        unit: the length of one point (1/72 inch) in data coordinates.
    """
    from matplotlib.patches import Polygon

    along = end - start
    along = along / float(np.linalg.norm(along))
    length = max(float(np.linalg.norm(end - start)), 2.5 * unit)
    end = start + length * along
    side = np.array([-along[1], along[0]])
    head = min(6.5 * unit, 0.7 * length)
    wide, thin = 0.42 * head, min(0.8 * unit, 0.1 * head)
    neck = end - head * along
    corners = [
        start + thin * side, neck + thin * side, neck + wide * side, end,
        neck - wide * side, neck - thin * side, start - thin * side,
    ]  # fmt: skip
    return Polygon(np.array(corners), closed=True, joinstyle="miter", **style)


def turning_arrow(centre: Floats, radius: float, way: int, unit: float, **style: Any) -> list[Any]:
    """Return an arc about a centre and its head; it turns counter-clockwise for `way` 1."""
    from matplotlib.patches import Polygon

    start, sweep = math.radians(-50), math.radians(250)
    angles = np.linspace(start, start + sweep, 5)
    if way < 0:
        angles = math.pi - angles
    handle = 4 / 3 * math.tan((angles[1] - angles[0]) / 4)
    radial = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    tangent = np.stack([-radial[:, 1], radial[:, 0]], axis=1)
    control = np.empty((13, 2))
    control[0::3] = radial
    control[1::3] = radial[:-1] + handle * tangent[:-1]
    control[2::3] = radial[1:] - handle * tangent[1:]
    tip, out = centre + radius * radial[-1], radial[-1]
    ahead = tangent[-1] * way
    head = [tip + 4.5 * unit * ahead, tip + 2.6 * unit * out, tip - 2.6 * unit * out]
    gid, colour, order = style["gid"], style["color"], style["zorder"]
    arc = curve_patch(
        centre + radius * control, fill=False, ec=colour, lw=1.5, gid=gid, zorder=order
    )
    return [arc, Polygon(np.array(head), fc=colour, ec="none", gid=f"{gid}-head", zorder=order)]


def wedge(tip: Floats, axis: Floats, half_angle: float, radius: float, **style: Any) -> Any:
    """Return a sector of a disc about an axis; a line when the angle is zero."""
    middle = math.degrees(math.atan2(axis[1], axis[0]))
    spread = math.degrees(half_angle)
    if spread == 0:
        return curve_patch(np.array([tip, tip, tip + radius * axis, tip + radius * axis]), **style)
    from matplotlib.patches import Wedge

    return Wedge(tuple(tip), radius, middle - spread, middle + spread, **style)


def mark(state: str, place: Floats, tangent: Floats, size: float, **style: Any) -> Any:
    """Return the mark of a contact state; the triangle of a slip points where the object slips."""
    from matplotlib.patches import Circle, Polygon

    if state == "detached":
        return Circle(tuple(place), 0.5 * size, fc="white", **style)
    across = np.array([-tangent[1], tangent[0]])
    if state == "stick":
        corners = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
        square = [place + 0.45 * size * (a * tangent + b * across) for a, b in corners]
        return Polygon(np.array(square), closed=True, fc="black", **style)
    ahead = tangent if state == "slip+" else -tangent
    tips = [place + 0.8 * size * ahead, *(
        place - 0.5 * size * ahead + side * 0.62 * size * across for side in (1, -1)
    )]  # fmt: skip
    return Polygon(np.array(tips), closed=True, fc="#bdbdbd", **style)


def text_size(text: str, unit: float, font: float = FONT) -> tuple[float, float]:
    """Return width and height of a line of text in data coordinates."""
    settings = require_matplotlib().rcParams
    family = (*settings["font.family"], *settings["font.sans-serif"])
    return _text_width(text, font, family) * unit, font * unit


@lru_cache(maxsize=2048)
def _text_width(text: str, font: float, _family: tuple[str, ...]) -> float:
    """Return the width of a text in the fonts that are set now, in points."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    across = TextPath((0, 0), text, size=font, prop=FontProperties()).vertices[:, 0]
    return float(across.max() - across.min()) if len(across) else 0.0


class Labels:
    """Places for labels that overlap neither each other nor what is drawn.

    Args:
        unit: the length of one point (1/72 inch) in data coordinates.
    """

    def __init__(self, unit: float) -> None:
        self.unit = unit
        self._boxes: list[tuple[float, float, float, float]] = []
        self._points: list[Floats] = []

    def avoid(self, points: Iterable[Floats]) -> None:
        """Keep labels off these points."""
        self._points += list(points)

    def place(self, text: str, wanted: Sequence[Floats]) -> Floats:
        """Return the first wanted centre that is free, else the one with the least overlap."""
        wide, high = text_size(text, self.unit)
        half = np.array([wide / 2 + 2 * self.unit, high / 2 + self.unit])
        costs = [self._cost(centre, half) for centre in wanted]
        best = wanted[int(np.argmin(costs))]
        self._boxes.append((*(best - half), *(best + half)))
        return best

    def _cost(self, centre: Floats, half: Floats) -> float:
        (left, low), (right, high) = centre - half, centre + half
        cost = 0.0
        for a, b, c, d in self._boxes:
            across, up = min(right, c) - max(left, a), min(high, d) - max(low, b)
            cost += 1000 * across * up / self.unit**2 if across > 0 and up > 0 else 0
        if self._points:
            inside = np.abs(np.array(self._points) - centre) < half
            cost += float(inside.all(axis=1).sum())
        return cost
