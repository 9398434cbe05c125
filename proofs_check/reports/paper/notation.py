"""The notation at a contact: its frame and cone, the motion of the object, a force as a wrench."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from arrangement.drawing.colours import BLACK, BLUE, GREY, PALE, VERMILION
from arrangement.drawing.layout import composed
from arrangement.drawing.scene import POINTS, Floats, Place, Scene, arrow, turning_arrow

GREEN = "#00735a"
_DASHES = (0, (5, 2.5))
_BODY = ((-1, -1), (1, -1), (1, 0.4), (0.2, 1.1), (-1, 1.1))


class _Sketch:
    """A scene in units of length, of which one is some millimetres."""

    def __init__(self, window: tuple[float, float, float, float], unit: float) -> None:
        left, right, low, high = window
        self.scene = Scene((right - left) * unit, (high - low) * unit)
        self._scale, self._corner = unit * POINTS, np.array([left, low])

    def at(self, place: Place) -> Floats:
        found: Floats = (np.array(place) - self._corner) * self._scale
        return found

    def polygon(self, corners: Sequence[Place], **style: Any) -> None:
        self.scene.polygon([self.at(corner) for corner in corners], **style)

    def line(self, *places: Place, **style: Any) -> None:
        self.scene.line([self.at(place) for place in places], **{"lw": 0.7, **style})

    def arrow(self, start: Place, way: Place, colour: str) -> None:
        ends = self.at(start), self.at(np.add(start, way))
        arrow(self.scene, *ends, 1.1, fc=colour, ec="none", zorder=5)

    def dot(self, place: Place) -> None:
        self.scene.circle(self.at(place), 1.7, fc=BLACK, ec="none", zorder=6, role="point")

    def text(self, place: Place, text: str, colour: str = BLACK) -> None:
        self.scene.text(self.at(place), text, 8.0, color=colour)

    def body(self) -> None:
        self.polygon(_BODY, fc=PALE, ec=BLACK, lw=0.9, zorder=0, gid="body")
        self.dot((0, 0))


def contact_notation() -> Scene:
    """Return a contact with its frame, forces and cone and the motion; a force with its torque."""
    titles = ["contact frame, friction cone, motion", "torque is force times lever arm"]
    return composed([_frame(), _torque()], 2, titles)


def _frame() -> Scene:
    sketch = _Sketch((-2.0, 1.9, -1.6, 1.75), 20)
    sketch.body()
    tip, edges = (-1, 0), ((0.35, 0.675), (0.35, -0.675))
    sketch.polygon((tip, *edges), fc=f"{BLUE}24", ec="none", zorder=1, gid="cone")
    for edge in edges:
        sketch.line(tip, edge, ec=BLUE, ls=_DASHES)
    wedge = ((-1.05, 0), (-1.75, 0.16), (-1.75, -0.16))
    sketch.polygon(wedge, fc=GREY, ec="none", zorder=0, gid="finger")
    sketch.arrow(tip, (0.85, 0), BLUE)
    sketch.arrow(tip, (0, 0.85), VERMILION)
    sketch.dot(tip)
    sketch.arrow((0, 0), (0.1, 0.68), GREEN)
    style = {"color": GREEN, "gid": "motion", "zorder": 5}
    turning_arrow(sketch.scene, sketch.at((0, 0)), 0.24 * 20 * POINTS, 1, **style)
    for k, name in enumerate(("$x$", "$y$")):
        way = np.eye(2)[k]
        sketch.arrow((1.15, -1.35), 0.45 * way, BLACK)
        sketch.text(np.array((1.15, -1.35)) + 0.58 * way, name)
    for place, text, colour in (
        ((-0.62, -0.4), "$n,\\; c_n$", BLUE),
        ((-1.3, 0.72), "$t,\\; c_t$", VERMILION),
        ((-1.17, -0.24), "$p$", BLACK),
        ((0.13, -0.38), "$O$", BLACK),
        ((-0.42, 0.84), "$d=(x,y,r)$", GREEN),
        ((-1.6, -0.36), "finger", GREY),
        ((0.66, -0.62), "slope $\\mu$", BLUE),
    ):
        sketch.text(place, text, colour)
    return sketch.scene


def _torque() -> Scene:
    """Return a force at a contact on the slanted side, and the distance of its line from O."""
    sketch = _Sketch((-1.9, 2.4, -1.6, 1.75), 20)
    sketch.body()
    point, force = np.array([0.6, 0.75]), np.array([-0.15, -0.95])
    sketch.line(point - 0.84 * force, point + 2.3 * force, ec=GREY, ls=_DASHES)
    sketch.arrow(point - force, force, GREEN)
    sketch.dot(point)
    torque = point[0] * force[1] - point[1] * force[0]
    foot = torque / (force @ force) * np.array([force[1], -force[0]])
    sketch.line((0, 0), foot, ec=BLACK, lw=1.0)
    for place, text, colour in (
        ((0.44, 0.66), "$p$", BLACK),
        ((0.9, 1.3), "$f$", GREEN),
        ((0.24, 0.13), "$\\ell$", BLACK),
        ((0.13, -0.17), "$O$", BLACK),
        ((1.68, 0.1), "$|p \\times f| = \\ell\\,|f|$", BLACK),
        ((0.85, -1.35), "line of action", GREY),
    ):
        sketch.text(place, text, colour)
    return sketch.scene
