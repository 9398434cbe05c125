"""Arrows, cones and marks of contact states on a scene, and labels that keep apart."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from arrangement.draw.items import Floats
from arrangement.draw.measuring import FONT
from arrangement.draw.projections import joined
from arrangement.draw.scene import Scene


def arrow(scene: Scene, start: Floats, end: Floats, size: float = 1.5, **style: Any) -> None:
    """Draw an arrow, never so short that what is not zero cannot be seen.

    Args:
        size: of its head, and of its least length, in units of 2.5 points.
    """
    along = end - start
    along = along / float(np.linalg.norm(along))
    length = max(float(np.linalg.norm(end - start)), 2.5 * size)
    side = np.array([-along[1], along[0]])
    head = min(6.5 * size, 0.7 * length)
    wide, thin = 0.42 * head, min(0.8 * size, 0.1 * head)
    end = start + length * along
    neck = end - head * along
    corners = [
        start + thin * side, neck + thin * side, neck + wide * side, end,
        neck - wide * side, neck - thin * side, start - thin * side,
    ]  # fmt: skip
    scene.polygon(corners, joinstyle="miter", **style)


def arc(centre: Floats, radius: float, start: float, sweep: float) -> Floats:
    """Return a circular arc as control points (13, 2) of cubic curves; angles in radians."""
    angles = np.linspace(start, start + sweep, 5)
    handle = 4 / 3 * math.tan(sweep / 16)
    radial = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    tangent = np.stack([-radial[:, 1], radial[:, 0]], axis=1)
    return centre + radius * joined(radial, handle * tangent)


def turning_arrow(scene: Scene, centre: Floats, radius: float, way: int, **style: Any) -> None:
    """Draw an arc about a centre and its head; it turns counter-clockwise for `way` 1."""
    start, sweep = math.radians(-50), math.radians(250)
    curve = arc(centre, radius, start if way > 0 else math.pi - start, way * sweep)
    out = (curve[-1] - centre) / radius
    ahead = way * np.array([-out[1], out[0]])
    head = [curve[-1] + 4.5 * ahead, curve[-1] + 2.6 * out, curve[-1] - 2.6 * out]
    gid, colour, order = style["gid"], style["color"], style["zorder"]
    scene.curve(curve, fill=False, ec=colour, lw=1.5, gid=gid, zorder=order)
    scene.polygon(head, fc=colour, ec="none", gid=f"{gid}-head", zorder=order)


def wedge(
    scene: Scene, tip: Floats, axis: Floats, half_angle: float, radius: float, **style: Any
) -> None:
    """Draw a sector of a disc about an axis; a line when the angle is zero."""
    middle = math.atan2(axis[1], axis[0])
    edge = arc(tip, radius, middle - half_angle, 2 * half_angle)
    scene.curve(np.array([tip, tip, *edge[:1], *edge, *edge[-1:], tip, tip]), **style)


def mark(
    scene: Scene, state: str, place: Floats, tangent: Floats, size: float = 6.0, **style: Any
) -> None:
    """Draw the mark of a contact state; the triangle of a slip points where the object slips."""
    style = {"ec": "black", "lw": 0.8, **style}
    if state == "detached":
        scene.circle(place, 0.5 * size, fc="white", **style)
        return
    across = np.array([-tangent[1], tangent[0]])
    if state == "stick":
        corners = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
        square = [place + 0.45 * size * (a * tangent + b * across) for a, b in corners]
        scene.polygon(square, fc="black", **style)
        return
    ahead = tangent if state == "slip+" else -tangent
    base = [place - 0.5 * size * ahead + side * 0.62 * size * across for side in (1, -1)]
    scene.polygon([place + 0.8 * size * ahead, *base], fc="#bdbdbd", **style)


class Labels:
    """Places for labels that overlap neither each other nor what is drawn."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._boxes: list[Floats] = []
        self._points: list[Floats] = []

    def avoid(self, points: Iterable[Floats]) -> None:
        """Keep labels off these points."""
        self._points += list(points)

    def avoid_line(self, start: Floats, end: Floats) -> None:
        """Keep labels off a line."""
        self.avoid(start + s * (end - start) for s in np.linspace(0, 1, 24))

    def place(self, text: str, wanted: Sequence[Floats]) -> Floats:
        """Return the first wanted centre that is free, else the one that covers least."""
        half = np.array([self.scene.measure(text)[0] / 2 + 2, FONT / 2 + 1])
        covered = self._covered(np.array(wanted), half)
        best: Floats = wanted[int(np.argmin(covered))]
        self._boxes.append(np.array([best - half, best + half]))
        return best

    def _covered(self, places: Floats, half: Floats) -> Floats:
        """Return how much of boxes is taken: the area of labels counts most, then points."""
        low, high = (places - half)[:, None], (places + half)[:, None]
        boxes = np.array(self._boxes).reshape(-1, 2, 2)
        shared = np.minimum(high, boxes[:, 1]) - np.maximum(low, boxes[:, 0])
        points = np.array(self._points).reshape(-1, 2)
        inside = ((points > low) & (points < high)).all(axis=2)
        taken: Floats = 1000 * np.maximum(shared, 0).prod(axis=2).sum(axis=1) + inside.sum(axis=1)
        return taken
