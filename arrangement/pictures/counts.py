"""Exact numbers of faces against the published bounds, over the number of planes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.counts import f_vector, fukuda_bound
from arrangement.drawing.colours import BLACK
from arrangement.drawing.scene import Floats, Scene
from arrangement.drawing.views import picture
from arrangement.errors import InputError
from arrangement.library.families import braid, generic, near_pencil, pencil, type_b
from arrangement.numbers.exact import shown
from arrangement.pictures.names import stroke, vertex_symbol

#: Room in points left of a panel, below it, above it, and right of it.
_LEFT, _BELOW, _ABOVE, _RIGHT = 30.0, 26.0, 16.0, 8.0
_CURVE, _FAINT = "#cc6677", "#595959"
#: What is counted of central planes in general position in R^3: name, formula, dimension of the
#: faces (None: all faces), colour, marker.
_SERIES: tuple[tuple[str, Callable[[int], int], int | None, str, str], ...] = (
    ("states  4m² − 4m + 3", lambda m: 4 * m * m - 4 * m + 3, None, "#332288", "diamond"),
    ("facets  2m(m − 1)", lambda m: 2 * m * (m - 1), 2, "#117733", "square"),
    ("regions  m² − m + 2", lambda m: m * m - m + 2, 3, "#cc6677", "round"),
    ("rays  m(m − 1)", lambda m: m * (m - 1), 1, "#882255", "triangle"),
)
#: Families: name, planes for m, least m, marker, filled.
_FAMILIES: tuple[tuple[str, Callable[[int], Arrangement], int, str, bool], ...] = (
    ("general position", generic, 1, "round", True),
    ("near-pencil", near_pencil, 3, "square", False),
    ("pencil", pencil, 1, "triangle", False),
)


def check_largest(largest: int) -> None:
    """Refuse a number of planes that is out of range."""
    if type(largest) is not int or not 4 <= largest <= 30:
        raise InputError(f"the largest m is {shown(largest)}; give an integer from 4 to 30")


@picture(60.0)
def draw_counts(*, largest: int = 12, width: float = 180.0) -> Scene:
    """Draw numbers of faces over the number m of planes, with the bounds that the paper states.

    First panel: rays, facets, regions and all slip states of m central planes in general position
    in R^3, counted by Zaslavsky's theorem (marks), on the printed formulas (lines), and the bound
    of Fukuda and others on regions and on all faces of m planes in R^3, through the origin or not
    (dashed). The formulas hold from m = 3 on; for fewer planes the rank is smaller. Second panel:
    regions of named families against the bound m^2 - m + 2.

    Elements: the marks of each series and family have names such as ``generic-states-5`` and
    ``family-pencil-5``, by the number of planes.

    Args:
        largest: the largest m, from 4 to 30.
        width: of the figure, in millimetres; below 120 the panels stand one above the other.

    Raises:
        InputError: `largest` or `width` out of range.
    """
    check_largest(largest)
    beside = width >= 120
    height = 70.0
    scene = Scene(width, height if beside else 2 * height)
    w, h = (scene.width / 2, scene.height) if beside else (scene.width, scene.height / 2)
    second = (w, 0.0) if beside else (0.0, 0.0)
    _generic(_CountsPanel(scene, (0.0, scene.height - h), (w, h), "general position", largest))
    _families(_CountsPanel(scene, second, (w, h), "regions of families", largest))
    return scene


class _CountsPanel:
    """Axes: numbers of planes to the right, numbers of faces upwards."""

    def __init__(
        self,
        scene: Scene,
        corner: tuple[float, float],
        size: tuple[float, float],
        title: str,
        largest: int,
    ) -> None:
        self.scene, self.largest = scene, largest
        self.low = corner[0] + _LEFT, corner[1] + _BELOW
        self.size = size[0] - _LEFT - _RIGHT, size[1] - _BELOW - _ABOVE
        top = self.low[1] + self.size[1]
        scene.write((self.low[0], top + 6), title, anchor=(0.0, 0.0))
        scene.text((self.low[0] + self.size[0] / 2, self.low[1] - 20), "number of planes m")

    def scaled(self, upwards: Callable[[float], float], end: float, ticks: Sequence[int]) -> None:
        """Draw the axes, with a scale of numbers up to an end."""
        self.upwards, self.end = upwards, upwards(end)
        (left, low), (wide, high) = self.low, self.size
        corner = [(left, low + high), (left, low), (left + wide, low)]
        self.scene.line(corner, ec=BLACK, lw=0.5, role="axis", gid="axis")
        for m in range(1, self.largest + 1, 1 if self.largest <= 15 else 2):
            x = self.at(m, ticks[0])[0]
            self.scene.line([(x, low), (x, low - 2.5)], ec=BLACK, lw=0.5, role="axis")
            self.scene.text((x, low - 8), str(m), 6.5)
        for tick in ticks:
            y = self.at(1, tick)[1]
            self.scene.line([(left, y), (left - 2.5, y)], ec=BLACK, lw=0.5, role="axis")
            self.scene.text((left - 4.5, y), str(tick), 6.5, ha="right", va="center_baseline")

    def at(self, m: float, count: float) -> Floats:
        """Return the place of a count of m planes."""
        x = self.low[0] + self.size[0] * (m - 0.5) / self.largest
        return np.array([x, self.low[1] + self.size[1] * (self.upwards(count) + 0.02) / self.end])

    def curve(self, points: Iterable[tuple[int, int]], name: str, **style: Any) -> None:
        """Draw a line through counts."""
        self.scene.line([self.at(*point) for point in points], gid=name, role="line", **style)

    def marks(
        self, points: Iterable[tuple[int, int]], shape: str, name: str, text: str, fill: str
    ) -> None:
        """Mark counts, and explain the mark."""
        style = {"fc": fill, "ec": BLACK, "lw": 0.6, "role": "point"}
        for m, count in points:
            size = 1.4 if self.largest > 15 else 2.0
            self.scene.marker(self.at(m, count), size, shape, gid=f"{name}-{m}", zorder=3, **style)
        self.scene.legend.key(vertex_symbol(shape, **style), text)


def _generic(panel: _CountsPanel) -> None:
    numbers = range(1, panel.largest + 1)
    vectors = [f_vector(generic(m)) for m in numbers]
    every = [sum(fukuda_bound(m, 3, k) for k in range(4)) for m in numbers]
    tens = [10**k for k in range(len(str(every[-1])))]
    # Linear up to 1, as there may be no rays; then logarithmic.
    panel.scaled(lambda x: 0.4 * x if x < 1 else 0.4 + math.log10(x), 2 * every[-1], [0, *tens])
    for label, formula, k, colour, shape in _SERIES:
        name = label.split()[0]
        printed = [(m, formula(m)) for m in numbers[2:]]
        panel.curve(printed, f"printed-{name}", ec=colour, lw=0.8)
        counts = [sum(v) if k is None else v[k] for v in vectors]
        points = zip(numbers, counts, strict=True)
        panel.marks(points, shape, f"generic-{name}", label, colour)
    bounds = (
        ("faces", "bound on all faces, any planes", every, (5, 2)),
        (
            "regions",
            "bound on regions, any planes",
            [fukuda_bound(m, 3, 3) for m in numbers],
            (1.5, 1.5),
        ),
    )
    for name, text, values, dashes in bounds:
        style = {"ec": _FAINT, "lw": 0.8, "ls": (0, dashes)}
        panel.curve(zip(numbers, values, strict=True), f"bound-{name}", **style)
        panel.scene.legend.key(stroke(**style), text)


def _families(panel: _CountsPanel) -> None:
    numbers = range(1, panel.largest + 1)
    bound = [(m, m * m - m + 2) for m in numbers]
    end = 1.1 * bound[-1][1]
    if panel.largest > 15:
        panel.scaled(lambda x: math.log10(x), 1.5 * end, [1, 10, 100])
    else:
        step = max(k for k in (1, 2, 5, 10, 20, 50) if k <= end / 4)
        panel.scaled(float, end, range(0, round(end), step))
    panel.curve(bound, "bound-families", ec=_CURVE, lw=0.8)
    for name, family, least, shape, filled in _FAMILIES:
        points = ((m, f_vector(family(m))[3]) for m in range(least, panel.largest + 1))
        gid, fill = f"family-{name.replace(' ', '-')}", _CURVE if filled else "#ffffff"
        panel.marks(points, shape, gid, f"regions, {name}", fill)
    mirrors = [planes for planes in (braid(4), type_b(3)) if len(planes) <= panel.largest]
    points = ((len(planes), f_vector(planes)[-1]) for planes in mirrors)
    panel.marks(points, "star", "family-reflection", "regions, mirrors of A₃ and B₃", "#88ccee")
    panel.scene.legend.key(stroke(ec=_CURVE, lw=0.8), "bound m² − m + 2")
