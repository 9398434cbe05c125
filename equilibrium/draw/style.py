"""What all pictures of the package share: colours, marks, numbers as text, figures in millimetres.

The colours are those of Okabe and Ito or lie between them in lightness, so that they stay apart
for colour-blind eyes and, by lightness, in grey.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.draw.output import require_matplotlib
from arrangement.errors import InputError
from arrangement.exact import to_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BLACK, GREY, PALE = "#000000", "#767676", "#f2f2f2"
BLUE, VERMILION, GREEN, ORANGE, SKY = "#0072b2", "#d55e00", "#009e73", "#e69f00", "#56b4e9"
#: Light to dark, by the number of sticking contacts: 0, 1, 2, 3 and more.
FILLS = ("#fdf0c0", "#b9dfd3", "#7fb9d8", "#8a7fb5")
#: The fill, half transparent, and the edge of friction cones; the rim of polar maps.
CONE_FILL, CONE_EDGE, RIM = "#e69f0059", "#b87f00", "#9a9a9a"
#: One colour for a region without states.
SHADE = "#c9d8e6"
#: The state of a contact in one character, for labels.
SYMBOLS = {"stick": "●", "slip+": "+", "slip-": "−", "detached": "○"}
FONT = 7.0
_MILLIMETRES = 25.4


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure of a size in millimetres.

    Raises:
        InputError: a width that no page has.
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    if not 20 <= width <= 1000:
        raise InputError(f"the width is {width} mm; give 20 to 1000")
    from matplotlib.figure import Figure

    return Figure(figsize=(width / _MILLIMETRES, height / _MILLIMETRES))


def points(millimetres: float) -> float:
    """Return a length in printer's points."""
    return millimetres * 72 / _MILLIMETRES


def rounded(value: Fraction | int) -> float:
    """Return the nearest float; numbers beyond its range become infinite."""
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def number(value: Fraction | int) -> str:
    """Return a number as a label: exact where that is short, else rounded with a sign that says so.

    >>> number(Fraction(-1, 2)), number(Fraction(10**20 + 1, 3))
    ('−1/2', '≈3.333e+19')
    """
    text = to_text(value)
    if len(text) > 7:
        near = rounded(value)
        short = f"{near:.4g}" if near and math.isfinite(near) else _power(value)
        text = short if "^" not in short and Fraction(short) == value else f"≈{short}"
    return text.replace("-", "−")


def vector(values: Iterable[Fraction | int]) -> str:
    """Return a vector as a label."""
    return f"({', '.join(map(number, values))})"


def _power(value: Fraction | int) -> str:
    """Return a number far out of the range of floats as a power of ten."""
    bits = abs(value.numerator).bit_length() - value.denominator.bit_length()
    return f"{'-' if value < 0 else ''}10^{round(bits * math.log10(2))}"


def nice(value: float) -> Fraction:
    """Return the largest of 1, 2, 5 times a power of ten that is at most a positive value."""
    power = math.floor(math.log10(value))
    for exponent in (power, power - 1):
        unit = Fraction(10) ** exponent
        for factor in (5, 2, 1):
            if float(factor * unit) <= value * (1 + 1e-12):
                return factor * unit
    return Fraction(10) ** power


def bare(axes: Any, low: tuple[float, float], high: tuple[float, float]) -> None:
    """Prepare axes without ticks, of equal scale, for a box of coordinates."""
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    axes.set_axis_off()
