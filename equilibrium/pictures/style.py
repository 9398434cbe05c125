"""Symbols of legends by kind, colours, and numbers as labels."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Annotated, Any, TypeAlias

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.console.options.signature import Syntax
from arrangement.console.options.values import rational_argument
from arrangement.drawing.colours import BLACK, BLUE, GREY, PALETTE, VERMILION
from arrangement.drawing.labels import Labels, fixed_places
from arrangement.drawing.scene import POINTS, Floats, Legend, Scene, Symbol, arc, arrow
from arrangement.numbers.exact import RationalVector
from arrangement.pictures.names import HALF, WIDTH, canvas, stroke, swatch
from equilibrium.model.grasp import Grasp
from equilibrium.model.labels import Units

#: Three numbers, or six for a grasp in space.
Wrench: TypeAlias = Annotated[
    Iterable[Any], Syntax(rational_argument, ("FX", "FY", "TAU"), 3, flag="wrench", variadic=True)
]

#: What pages draw grasps with.
SKETCH_SCRIPT, SKETCH_STYLE = (("equilibrium.pictures", f"sketch.{end}") for end in ("js", "css"))
#: Light to dark, by the number of sticking contacts: 0, 1, 2, 3 and more.
FILLS = (*PALETTE[1:4], PALETTE[5])
#: The fill, half transparent, and the edge of friction cones; the rim of polar maps.
CONE_FILL, CONE_EDGE, RIM = "#e69f0059", "#b87f00", "#9a9a9a"
#: One colour for a region without states.
SHADE = "#c9d8e6"
#: The state of a contact in one character, for labels.
SYMBOLS = {"stick": "●", "slip+": "+", "slip-": "−", "detached": "○"}
_ONE = Fraction(1)


def nearest_float(value: Fraction | int) -> float:
    """Return the nearest float; numbers beyond its range become infinite."""
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def wrench_text(wrench: RationalVector, units: Units | None) -> str:
    """Return a wrench as a label, with its units where they are stated.

    >>> wrench_text((Fraction(0), Fraction(3), Fraction(1, 2)), Units("cm", "N"))
    'w = (0, 3) N, 1/2 N cm'
    """
    if units is None:
        return f"w = {LABEL.vector(wrench)}"
    k = (len(wrench) + 1) // 2
    torque = LABEL.number(wrench[2]) if k == 2 else LABEL.vector(wrench[k:])
    return f"w = {LABEL.vector(wrench[:k])} {units.force}, {torque} {units.torque}"


def name_wrench(
    labels: Labels, ends: Sequence[Floats], away: tuple[Floats, float] | None = None
) -> None:
    """Write w beside one of some points, farther from a place than a distance."""
    turns = math.pi / 4 * np.arange(8) + 0.4
    directions = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    centres = np.concatenate([end + out * directions for out in (9, 13, 18) for end in ends])
    if away is not None:
        centres = centres[np.linalg.norm(centres - away[0], axis=1) > away[1]]
    labels.write("w", fixed_places(centres), color=VERMILION, style="italic", weight="bold")


def ticks(middle: Fraction, half: Fraction, factor: Fraction = _ONE) -> Iterator[tuple[float, str]]:
    """Yield the places of round numbers on a ruler from -1 to 1, and the numbers over a factor.

    Beyond floats there are none.
    """
    near = nearest_float(half)
    if not near or not math.isfinite(near):
        return
    step = nice(0.6 * near)
    for i in range(math.ceil((middle - half) / step), math.floor((middle + half) / step) + 1):
        text = f"{float(i * step / factor):g}".replace("-", "−")
        yield float((i * step - middle) / half), text


def nice(value: float) -> Fraction:
    """Return the largest of 1, 2, 5 times a power of ten that is at most a positive value."""
    power = math.floor(math.log10(value))
    for exponent in (power, power - 1):
        unit = Fraction(10) ** exponent
        for factor in (5, 2, 1):
            if float(factor * unit) <= value * (1 + 1e-12):
                return factor * unit
    return Fraction(10) ** power


def nice_near(value: Fraction) -> Fraction:
    """Return such a number for a positive value, itself where it is beyond floats."""
    near = nearest_float(value)
    return nice(near) if near and math.isfinite(near) else value


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


def explain(legend: Legend, keys: Mapping[tuple[str, str], object]) -> None:
    """Explain symbols by kind and meaning, of what is shown."""
    for (kind, text), is_shown in keys.items():
        if is_shown:
            legend.key(symbol(kind), text)


def explain_grasp(legend: Legend, grasp: Grasp, wrench: RationalVector, forces: bool) -> None:
    """Explain the symbols of friction, preloads, a wrench and contact forces, if any."""
    stuck = any(c.adhesion for c in grasp)
    keys = {
        ("cone", "friction cone"): any(c.friction for c in grasp),
        ("preload", "preload"): any(c.preload for c in grasp),
        ("wrench", wrench_text(wrench, grasp.units)): any(wrench),
        ("force", "contact force with adhesion" if stuck else "contact force"): forces,
    }
    explain(legend, keys)


def explain_scale(legend: Legend, units: Units | None, force: Fraction, length: float) -> None:
    """Explain by a bar how long an arrow of a force is, in points; in space if seen aside."""
    unit = f" {units.force}" if units else ""
    legend.key(bar(length), f"force {LABEL.number(force)}{unit}")


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


def mark(scene: Scene, state: str, place: Floats, tangent: Floats, **style: Any) -> None:
    """Draw the mark of a contact state; the triangle of a slip points where the object slips."""
    size, style = 6.0, {"ec": "black", "lw": 0.8, **style}
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
