"""The symbols of legends, by kind."""

from __future__ import annotations

from typing import Any

import numpy as np

from arrangement.drawing.colours import BLACK, BLUE, GREY, VERMILION
from arrangement.drawing.scene.measuring import POINTS
from arrangement.drawing.scene.scene import Legend, Scene, Symbol
from arrangement.numbers.exact import RationalVector
from arrangement.pictures.region_labels import HALF, WIDTH, canvas, stroke, swatch
from equilibrium.model.grasp import Grasp

from .grasp.shapes import arc, arrow, mark
from .style import CONE_EDGE, CONE_FILL, RIM, wrench_text

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


def symbol(kind: str) -> Symbol:
    """Return a symbol.

    Args:
        kind: a name, or a fill ``#rrggbb``, followed by a word when it is hatched.
    """
    scene, ahead = canvas(), np.array([1.0, 0.0])
    start, middle, end = np.zeros(2), WIDTH / 2 * ahead, WIDTH * ahead
    if kind in _LINES:
        return stroke(**_LINES[kind])
    if kind in _ARROWS:
        arrow(scene, start, end, **_ARROWS[kind])
    elif kind in MARKS:
        _mark(scene, kind, WIDTH / 2)
    elif kind == "wrench-points":
        _mark(scene, "resisted", WIDTH / 4)
        _mark(scene, "refused", 3 * WIDTH / 4)
    elif kind in _STATES:
        mark(scene, _STATES[kind], middle, ahead)
    elif kind == "cone":
        rim = arc(start, 5.0 * POINTS, -0.3, 0.6)
        scene.polygon([start, *rim], fc=CONE_FILL, ec=CONE_EDGE, lw=0.5)
    elif kind == "fade":
        for k in range(11):
            x, grey = k * WIDTH / 11, f"{0.62 + 0.38 * k / 11:.3f}"
            scene.line([(x, 0), (x + WIDTH / 11, 0)], ec=grey, lw=6, capstyle="butt")
    else:
        fill, _, hatched = kind.partition(" ")
        scene.items += swatch(fill)[0]
        for k in range(5 if hatched else 0):
            x = (0.3 + 1.1 * k) * POINTS
            scene.line([(x, -HALF), (x + 0.8 * POINTS, HALF)], ec="#7d7d7d", lw=0.35)
    return scene.items, WIDTH


def explain_grasp(legend: Legend, grasp: Grasp, wrench: RationalVector, forces: bool) -> None:
    """Say what stands for friction, preloads, a wrench and contact forces, as far as there are."""
    shown = {
        ("cone", "friction cone"): any(c.friction for c in grasp),
        ("preload", "preload"): any(c.preload for c in grasp),
        ("wrench", wrench_text(wrench, grasp.units)): any(wrench),
        ("force", "contact force"): forces,
    }
    for (kind, text), is_shown in shown.items():
        if is_shown:
            legend.key(symbol(kind), text)


def bar(length: float) -> Symbol:
    """Return a bar of scale of a length in points."""
    scene, tick, style = canvas(), 0.7 * POINTS, {"ec": BLACK, "lw": 0.8}
    scene.line([(0, 0), (length, 0)], gid="scale", **style)
    for x in (0, length):
        scene.line([(x, -tick), (x, tick)], **style)
    return scene.items, length


def _mark(scene: Scene, kind: str, x: float) -> None:
    sign, size, style = MARKS[kind]
    scene.mark((x, 0), sign, size, **style)
