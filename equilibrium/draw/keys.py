"""The small symbols of a legend, by kind."""

from __future__ import annotations

from typing import Any

import numpy as np

from .shapes import arrow, mark, wedge
from .style import BLACK, BLUE, CONE_EDGE, CONE_FILL, GREY, RIM, VERMILION, points

#: Width of a symbol in millimetres.
WIDTH = 5.5

_ARROWS: dict[str, tuple[float, dict[str, Any]]] = {
    "force": (1.0, {"fc": BLACK, "ec": "none"}),
    "wrench": (1.5, {"fc": VERMILION, "ec": "none"}),
    "shift": (1.5, {"fc": BLUE, "ec": "none"}),
    "preload": (1.6, {"fc": "white", "ec": GREY, "lw": 0.7}),
}
_LINES: dict[str, dict[str, Any]] = {
    "motion": {"color": BLUE, "lw": 0.9, "ls": (0, (1, 1.5))},
    "border": {"color": BLACK, "lw": 1.3},
    "rim": {"color": RIM, "lw": 0.5},
    "claimed": {"color": VERMILION, "lw": 1.1, "ls": (0, (2, 1.2))},
    "missed": {"color": VERMILION, "lw": 1.1},
}
_RESISTED: dict[str, Any] = {"marker": "o", "ms": 5, "color": VERMILION}
_REFUSED: dict[str, Any] = {"marker": "x", "ms": 5, "mew": 1.6, "color": VERMILION}
#: Where along the symbol a point stands, and how it looks.
_POINTS: dict[str, list[tuple[float, dict[str, Any]]]] = {
    "resisted": [(2.75, _RESISTED)],
    "refused": [(2.75, _REFUSED)],
    "wrench-points": [(1.3, _RESISTED), (4.2, _REFUSED)],
    "accepted": [(2.75, {"marker": "o", "ms": 4.5, "color": BLACK})],
    "refusal": [(2.75, {"marker": "x", "ms": 4, "mew": 1.0, "color": BLACK})],
    "silence": [(2.75, {"marker": "_", "ms": 4.5, "mew": 0.8, "color": BLACK})],
    "dot": [(2.75, {"marker": "o", "ms": 2.2, "color": BLUE})],
    "cross": [(2.75, {"marker": "x", "ms": 4, "mew": 1.1, "color": VERMILION})],
}
_STATES = {"stick": "stick", "slip": "slip+", "detached": "detached"}


def draw_symbol(axes: Any, kind: str, left: float, y: float) -> None:
    """Draw a symbol in axes whose unit is a millimetre.

    Args:
        kind: a name, or a fill ``#rrggbb``, followed by a word when it is hatched.
    """
    unit, ahead = 1 / points(1.0), np.array([1.0, 0.0])
    start, end = np.array([left, y]), np.array([left + WIDTH, y])
    if kind in _ARROWS:
        factor, style = _ARROWS[kind]
        axes.add_patch(arrow(start, end, factor * unit, **style))
    elif kind in _LINES:
        axes.plot(*np.array([start, end]).T, **_LINES[kind])
    elif kind in _POINTS:
        for at, style in _POINTS[kind]:
            axes.plot([left + at], [y], **style)
    elif kind in _STATES:
        middle = (start + end) / 2
        axes.add_patch(mark(_STATES[kind], middle, ahead, 6.0 * unit, ec=BLACK, lw=0.8))
    elif kind == "cone":
        axes.add_patch(wedge(start, ahead, 0.3, 5.0, fc=CONE_FILL, ec=CONE_EDGE, lw=0.5))
    elif kind == "fade":
        _fade(axes, left, y)
    else:
        _swatch(axes, kind, left, y)


def _fade(axes: Any, left: float, y: float) -> None:
    steps = 11
    for k in range(steps):
        grey = f"{0.62 + 0.38 * k / steps:.3f}"
        ends = np.array([k, k + 1]) * WIDTH / steps + left
        axes.plot(ends, [y, y], color=grey, lw=6, solid_capstyle="butt")


def _swatch(axes: Any, kind: str, left: float, y: float) -> None:
    from matplotlib.patches import Rectangle

    fill, _, hatched = kind.partition(" ")
    axes.add_patch(Rectangle((left, y - 1.2), WIDTH, 2.4, fc=fill, ec=GREY, lw=0.4))
    for k in range(5 if hatched else 0):
        x = left + 0.3 + 1.1 * k
        axes.plot([x, x + 0.8], [y - 1.2, y + 1.2], color="#7d7d7d", lw=0.35)
