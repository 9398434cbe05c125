"""The small symbols of a legend, by kind."""

from __future__ import annotations

from typing import Any

import numpy as np

from arrangement.draw.colours import BLACK, BLUE, GREY, VERMILION
from arrangement.draw.scene import POINTS, Scene

from .shapes import arrow, mark, wedge
from .style import CONE_EDGE, CONE_FILL, RIM

#: Width of a symbol in points.
WIDTH = 5.5 * POINTS

_ARROWS: dict[str, dict[str, Any]] = {
    "force": {"fc": BLACK, "ec": "none", "size": 1.0},
    "wrench": {"fc": VERMILION, "ec": "none"},
    "shift": {"fc": BLUE, "ec": "none"},
    "preload": {"fc": "white", "ec": GREY, "lw": 0.7, "size": 1.6},
}
_LINES: dict[str, dict[str, Any]] = {
    "motion": {"ec": BLUE, "lw": 0.9, "ls": (0, (1, 1.5))},
    "border": {"ec": BLACK, "lw": 1.3},
    "rim": {"ec": RIM, "lw": 0.5},
    "claimed": {"ec": VERMILION, "lw": 1.1, "ls": (0, (2, 1.2))},
    "missed": {"ec": VERMILION, "lw": 1.1},
}
#: Signs, their sizes and styles, as pictures have them too.
MARKS: dict[str, tuple[str, float, dict[str, Any]]] = {
    "resisted": ("o", 5, {"color": VERMILION}),
    "refused": ("x", 5, {"mew": 1.6, "color": VERMILION}),
    "accepted": ("o", 4.5, {"color": BLACK}),
    "refusal": ("x", 4, {"mew": 1.0, "color": BLACK}),
    "silence": ("_", 5, {"mew": 0.8, "color": BLACK}),
    "dot": ("o", 2.2, {"color": BLUE}),
    "cross": ("x", 4, {"mew": 1.1, "color": VERMILION}),
}
_STATES = {"stick": "stick", "slip": "slip+", "detached": "detached"}


def draw_symbol(scene: Scene, kind: str, left: float, y: float) -> None:
    """Draw a symbol.

    Args:
        kind: a name, or a fill ``#rrggbb``, followed by a word when it is hatched.
    """
    ahead = np.array([1.0, 0.0])
    start, end = np.array([left, y]), np.array([left + WIDTH, y])
    if kind in _ARROWS:
        arrow(scene, start, end, **_ARROWS[kind])
    elif kind in _LINES:
        scene.line([start, end], **_LINES[kind])
    elif kind in MARKS:
        _mark(scene, kind, left + WIDTH / 2, y)
    elif kind == "wrench-points":
        _mark(scene, "resisted", left + WIDTH / 4, y)
        _mark(scene, "refused", left + 3 * WIDTH / 4, y)
    elif kind in _STATES:
        mark(scene, _STATES[kind], (start + end) / 2, ahead)
    elif kind == "cone":
        wedge(scene, start, ahead, 0.3, 5.0 * POINTS, fc=CONE_FILL, ec=CONE_EDGE, lw=0.5)
    elif kind == "fade":
        for k in range(11):
            x, grey = left + k * WIDTH / 11, f"{0.62 + 0.38 * k / 11:.3f}"
            scene.line([(x, y), (x + WIDTH / 11, y)], ec=grey, lw=6, capstyle="butt")
    else:
        _swatch(scene, kind, left, y)


def _mark(scene: Scene, kind: str, x: float, y: float) -> None:
    sign, size, style = MARKS[kind]
    scene.mark((x, y), sign, size, **style)


def _swatch(scene: Scene, kind: str, left: float, y: float) -> None:
    fill, _, hatched = kind.partition(" ")
    right, half = left + WIDTH, 1.2 * POINTS
    corners = [(left, y - half), (right, y - half), (right, y + half), (left, y + half)]
    scene.polygon(corners, fc=fill, ec=GREY, lw=0.4)
    for k in range(5 if hatched else 0):
        x = left + (0.3 + 1.1 * k) * POINTS
        scene.line([(x, y - half), (x + 0.8 * POINTS, y + half)], ec="#7d7d7d", lw=0.35)
