"""Sizes of texts, of polygons and of the sheet."""

from __future__ import annotations

import textwrap
from functools import lru_cache
from typing import Any

import numpy as np

from arrangement.drawing.output import millimetres, require_matplotlib
from arrangement.errors import InputError

from .items import Floats

#: Millimetres to points.
POINTS = 72 / 25.4
#: Resolution at which text is measured; pictures are saved with the same.
DPI = 300
#: Size of letters, in points.
FONT = 7.0
#: Least distance between two labels, and of a label from the border; in points.
GAP = 0.8

#: Characters as wide as others; those after which the next one stands at the same distance always.
_ALIKE = str.maketrans("123456789\u2007\u2212\u25cb", "0" * 10 + "+\u25cf")
_ALONE = frozenset("0+\u25cf\u200a")


def measure(text: str, size: float = FONT, rotation: float = 0.0) -> tuple[float, float]:
    """Return the width and height of a text in the fonts that are set now, in points."""
    settings = require_matplotlib().rcParams
    text = text.translate(_ALIKE)
    if _ALONE.issuperset(text):
        text = "".join(sorted(text))
    return _measured(text, size, rotation, (*settings["font.family"], *settings["font.sans-serif"]))


@lru_cache(maxsize=8192)
def _measured(
    text: str, size: float, rotation: float, _fonts: tuple[str, ...]
) -> tuple[float, float]:
    from matplotlib.text import Text

    renderer, figure = _measuring()
    label = Text(0, 0, text, size=size, rotation=rotation, linespacing=1.0)
    label.set_figure(figure)
    extent = label.get_window_extent(renderer)
    return extent.width * 72 / DPI, extent.height * 72 / DPI


@lru_cache(maxsize=1)
def _measuring() -> Any:
    from matplotlib.backends import backend_agg
    from matplotlib.figure import Figure

    renderer: Any = backend_agg.RendererAgg
    return renderer(10, 10, DPI), Figure(dpi=DPI)


def wrapped(text: str, room: float, size: float = FONT) -> list[str]:
    """Return a text in lines that fit a width in points, as far as its words do."""
    lines = [text]
    for width in range(len(text), 8, -1):
        if max(measure(line, size)[0] for line in lines) <= room:
            break
        lines = textwrap.wrap(text, width)
    return lines


def area(corners: Floats) -> float:
    """Return the area of a polygon; of fewer than three corners, 0."""
    if len(corners) < 3:
        return 0.0
    x, y = corners.T
    return abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2


class NarrowError(InputError):
    """The sheet is too narrow for what it shows."""


def checked_width(width: object, least: float = 40.0) -> float:
    """Return a width in millimetres, or refuse it."""
    length = millimetres(width, "the width")
    if length < least:
        raise NarrowError(f"the width is {length:.4g}; give at least {least:g} millimetres")
    return length
