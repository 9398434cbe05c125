"""Marks of contact states, and numbers as labels."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction

from arrangement.drawing.colours import PALETTE
from arrangement.numbers.exact import RationalVector, number_text
from equilibrium.model.units import Units

#: Light to dark, by the number of sticking contacts: 0, 1, 2, 3 and more.
FILLS = (*PALETTE[1:4], PALETTE[5])
#: The fill, half transparent, and the edge of friction cones; the rim of polar maps.
CONE_FILL, CONE_EDGE, RIM = "#e69f0059", "#b87f00", "#9a9a9a"
#: One colour for a region without states.
SHADE = "#c9d8e6"
#: The state of a contact in one character, for labels.
SYMBOLS = {"stick": "●", "slip+": "+", "slip-": "−", "detached": "○"}
_ONE = Fraction(1)


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
    return number_text(value, 4, 7).replace("-", "−")


def vector(values: Iterable[Fraction | int]) -> str:
    """Return a vector as a label."""
    return f"({', '.join(map(number, values))})"


def wrench_text(wrench: RationalVector, units: Units | None) -> str:
    """Return a wrench as a label, with its units where they are stated.

    >>> wrench_text((Fraction(0), Fraction(3), Fraction(1, 2)), Units("cm", "N"))
    'w = (0, 3) N, 1/2 N cm'
    """
    if units is None:
        return f"w = {vector(wrench)}"
    k = (len(wrench) + 1) // 2
    torque = number(wrench[2]) if k == 2 else vector(wrench[k:])
    return f"w = {vector(wrench[:k])} {units.force}, {torque} {units.torque}"


def ticks(middle: Fraction, half: Fraction, factor: Fraction = _ONE) -> Iterator[tuple[float, str]]:
    """Yield the places of round numbers on a ruler from -1 to 1, and the numbers over a factor."""
    step = nice(0.6 * float(half))
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
    near = rounded(value)
    return nice(near) if near and math.isfinite(near) else value
