"""Coordinate axes and the positive sides of planes, as arrows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from arrangement.drawing.registry import AxisNames
from arrangement.drawing.scene.items import Floats, Place
from arrangement.drawing.scene.scene import Scene
from arrangement.errors import InputError
from arrangement.numbers.exact import shown
from arrangement.planes.planes import Planes

from .painting import Key, Stage

#: How far an axis reaches, in radii of the body.
REACH = 1.2
INK = "#333333"


def drawn_axes(
    planes: Planes, axes: AxisNames | None, coordinates: str | None
) -> tuple[tuple[str, ...], str | None]:
    """Return the names of the axes, or nothing, and the coordinates in which planes are drawn.

    Args:
        planes: whose coordinates have names where they have a meaning.
        axes: such as ``"x,y,z"``; True for those names, or else these; or "none"; if omitted, those
            names, if there are any.
        coordinates: see `coordinates.in_coordinates`. Axes are those of the given ones.

    Raises:
        InputError: not three names, or axes asked for in other coordinates.
    """
    names = planes.axes
    if axes is True:
        names = names or ("x", "y", "z")
    elif axes is not None:
        names = tuple(name.strip() for name in axes.split(",")) if isinstance(axes, str) else ()
        if names == ("none",):
            return (), coordinates
        if len(names) != 3 or not all(0 < len(name) <= 12 for name in names):
            raise InputError(f"the axes are {shown(axes)}; give three names such as x,y,z, or none")
        if coordinates not in (None, "given"):
            raise InputError("axes are those of the given coordinates; leave out one of the two")
    if not names or coordinates not in (None, "given"):
        return (), coordinates
    return names, "given"


def arrow(scene: Scene, start: Place, end: Place, **style: Any) -> None:
    """Draw an arrow with a small full head; `ec` is the colour of both."""
    tail, tip = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    length = max(float(np.linalg.norm(tip - tail)), 1e-9)
    way = (tip - tail) / length
    across, size = np.array([-way[1], way[0]]), min(4.0, length)
    style = {"lw": 0.8, "ec": INK, "role": "axis", **style}
    head = np.array(
        [tip, tip - size * way + 0.35 * size * across, tip - size * way - 0.35 * size * across]
    )
    scene.line([tail, tip - 0.7 * size * way], **style)
    rest = {key: value for key, value in style.items() if key not in ("ec", "lw", "ls")}
    scene.polygon(head, **{**rest, "fc": style["ec"], "ec": "none"})


def within_reach(axes: Floats, half: float, most: float) -> float:
    """Return the radius of a body such that its axes, with names, stay in a square.

    Args:
        axes: (3, 3); the unit vectors of the coordinates, in the picture.
        half: half of the side of the square, in points.
        most: the radius without axes.
    """
    return min(most, (half - 9.0) / (REACH * float(np.abs(axes[:, :2]).max())))


class StagedAxes:
    """The three half-axes in a body, cut where planes and its surface meet them.

    Attributes:
        names: of the axes; there may be none.
        origin: (3,); in the axes of the picture, the body having its centre at 0 and radius 1.
        tips: (3, 3); the ends, or nothing.

    Raises:
        InputError: there are names, and the origin is not in the body.
    """

    def __init__(self, stage: Stage, names: Sequence[str]) -> None:
        self.stage, self.names = stage, names
        body = stage.cells.body
        place = np.array([float(-c / body.radius) for c in body.centre])
        self.origin = stage.axes @ place
        inside = float(np.abs(place).max()) if body.kind == "cube" else float(place @ place)
        if names and inside >= 1:
            raise InputError("the origin is not in the body; choose another body, or axes none")
        square = place**2 + 1 - place @ place
        # Where |place + t e_k| = 1 in a ball, and where the k-th coordinate is 1 in a cube.
        self._out = 1 - place if body.kind == "cube" else np.sqrt(np.maximum(0, square)) - place
        ways = stage.axes.T[: len(names)]
        self.tips = self.origin + (self._out[: len(names), None] + REACH - 1) * ways

    def pieces(self) -> Iterator[tuple[int, Key, Floats]]:
        """Yield when to paint a piece (see `Lifted.place`), its key, and its ends (2, 3)."""
        for way, out, tip in zip(self.stage.axes.T, self._out, self.tips, strict=False):
            cuts = [0.0, float(out)]
            for normal, offset in self.stage.planes:
                slope = float(normal @ way)
                if abs(slope) > 1e-12:
                    cuts.append((offset - float(normal @ self.origin)) / slope)
            inner = sorted(t for t in cuts if 0 <= t <= out)
            for start, stop in pairwise(inner):
                if stop - start > 1e-9:
                    ends = self.origin + np.array([[start], [stop]]) * way
                    yield 0, self.stage.key(self._sides(ends.mean(axis=0))), ends
            yield (2 if way[2] > 0 else -2), (), np.array([self.origin + out * way, tip])

    def _sides(self, point: Floats) -> list[int]:
        """Return the sides of a point, which may lie on planes, in floats."""
        heights = [float(normal @ point) - offset for normal, offset in self.stage.planes]
        return [0 if abs(h) < 1e-9 else 1 if h > 0 else -1 for h in heights]
