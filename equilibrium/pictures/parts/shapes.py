"""Arrows, cones and marks of contact states on a scene, and labels that keep apart."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from arrangement.drawing.colours import VERMILION
from arrangement.drawing.scene.labels import keep_off
from arrangement.drawing.scene.scene import FONT, Floats, Scene

#: How far from the wanted direction labels are tried: ahead and aside first, then behind.
_TURNS = (0, 0.5, -0.5, 1, -1, 1.6, -1.6, 2.3, -2.3, 3.1)


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
    """Places for labels that overlap neither each other nor what is drawn, on the sheet."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._boxes: list[Floats] = []
        self._lines: list[Floats] = []
        self._tree: Any = None

    def avoid(self, *lines: Any) -> None:
        """Keep labels off lines through points (k, 2)."""
        self._lines += map(np.asarray, lines)
        self._tree = None

    def place(self, text: str, wanted: Any) -> Floats:
        """Return the first wanted centre that is free, else the one that covers least."""
        import shapely

        half = np.array([self.scene.measure(text)[0] / 2 + 1, FONT / 2 + 0.5])
        centres = np.asarray(wanted)
        low, high = centres - half, centres + half
        others = np.array(self._boxes).reshape(-1, 2, 2)
        shared = np.minimum(high[:, None], others[:, 1]) - np.maximum(low[:, None], others[:, 0])
        paper = np.array([self.scene.width, self.scene.height])
        off = np.maximum(-low, 0).sum(axis=1) + np.maximum(high - paper, 0).sum(axis=1)
        self._tree = self._tree or keep_off(self._lines)
        rooms = shapely.box(*(low - 0.6).T, *(high + 0.6).T)
        met = np.bincount(self._tree.query(rooms, "intersects")[0], minlength=len(rooms))
        taken = met + 1000 * (np.maximum(shared, 0).prod(axis=2).sum(axis=1) + off)
        best = int(np.argmin(taken))
        self._boxes.append(np.array([low[best], high[best]]))
        found: Floats = centres[best]
        return found

    def beside(self, text: str, at: Floats, out: Floats, **style: Any) -> None:
        """Write a text near a point, in a direction if that is free."""
        start, half = math.atan2(out[1], out[0]), self.scene.measure(text)[0] / 2
        angles = start + np.array(_TURNS)
        ways = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        wider = np.stack([np.copysign(max(0.0, half - 3), ways[:, 0]), 0 * angles], axis=1)
        wanted = [
            at + reach * ways[part] + wider[part]
            for part in (slice(0, 7), slice(7, None))
            for reach in (8, 11, 15, 20, 26, 34)
        ]
        place = self.place(text, np.concatenate(wanted))
        self.scene.text(place, text, **{"halo": (1.5, "white"), "zorder": 7, **style})

    def name_wrench(self, ends: Sequence[Floats], away: tuple[Floats, float] | None = None) -> None:
        """Write w beside one of some points, farther from a place than a distance."""
        ways = [k * math.pi / 4 + 0.4 for k in range(8)]
        wanted = [
            end + reach * np.array([math.cos(k), math.sin(k)])
            for reach in (9, 13, 18)
            for end in ends
            for k in ways
        ]
        if away is not None:
            wanted = [at for at in wanted if np.linalg.norm(at - away[0]) > away[1]]
        look: dict[str, Any] = {"weight": "bold", "halo": (1.5, "white"), "zorder": 7}
        self.scene.text(self.place("w", wanted), "w", color=VERMILION, style="italic", **look)
