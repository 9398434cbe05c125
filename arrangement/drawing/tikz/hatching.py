"""Hatching as lines and circles, with the signs and the distances that matplotlib has."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from arrangement.drawing.scene.items import Floats

#: Lines a x + b y = (k + c / 2) d, for each sign (a, b), d in points and c; so many signs stand so
#: many times closer.
_LINES = {
    "/": [((1, -1), 24.0, 0)],
    "\\": [((1, 1), 24.0, 0)],
    "-": [((0, 1), 12.0, 1)],
    "|": [((1, 0), 12.0, 1)],
    "x": [((1, -1), 24.0, 0), ((1, 1), 24.0, 0)],
    "+": [((0, 1), 12.0, 1), ((1, 0), 12.0, 1)],
}
#: Radius of circles as a share of their distance.
_CIRCLES = {".": 0.1, "o": 0.2, "O": 0.35}
#: The width of its lines, in points.
WIDTH = 0.35


def hatching(
    hatch: str, low: Floats, high: Floats, top: float
) -> tuple[list[tuple[Floats, Floats]], list[tuple[Floats, float]]]:
    """Return lines (start, end) and circles (centre, radius) that fill a box, and a little more.

    Args:
        hatch: equal signs, such as ``//``; dots are circles to be filled.
        low, high: corners of the box.
        top: the height of the sheet; its left upper corner is where hatching is counted from.
    """
    if hatch[0] in _CIRCLES:
        return [], list(_circles(low, high, 12 / len(hatch), _CIRCLES[hatch[0]], top))
    return list(_lines(hatch, low, high, top)), []


def _lines(hatch: str, low: Floats, high: Floats, top: float) -> Iterator[tuple[Floats, Floats]]:
    corners = np.array([low, (low[0], high[1]), (high[0], low[1]), high])
    middle, reach = (low + high) / 2, float(np.linalg.norm(high - low)) / 2
    for normal, step, shift in _LINES[hatch[0]]:
        across, apart = np.array(normal), step / len(hatch)
        along = reach * np.array([-across[1], across[0]]) / np.linalg.norm(across)
        zero = top * across[1] + shift * apart / 2
        heights = (corners @ across - zero) / apart
        for k in range(math.ceil(heights.min()), math.floor(heights.max()) + 1):
            missing = zero + k * apart - float(middle @ across)
            foot = middle + missing * across / float(across @ across)
            yield foot - along, foot + along


def _circles(
    low: Floats, high: Floats, apart: float, share: float, top: float
) -> Iterator[tuple[Floats, float]]:
    """Yield circles in rows, in every other row half-way between those of its neighbours."""
    for row in range(math.floor((top - high[1]) / apart), math.ceil((top - low[1]) / apart) + 1):
        shift = (row % 2) / 2
        first, last = math.floor(low[0] / apart - shift), math.ceil(high[0] / apart - shift)
        for k in range(first, last + 1):
            yield np.array([(k + shift) * apart, top - row * apart]), share * apart
