"""How numbers of data are rounded: to the simplest within the error, or to others within it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random
from typing import Any

from arrangement.numbers.exact import (
    RationalVector,
    dot,
    from_float,
    shown,
    simplest_between,
    to_text,
)
from arrangement.numbers.linear.rank import cross
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.unit_normal import UnitNormal, angle_error, unit_normal


@dataclass(frozen=True)
class Rounding:
    """How numbers are rounded.

    Attributes:
        snap: largest change of a coordinate that nothing is known of; 0 leaves them.
        error: within which incidences are kept, a length.
        angle: the same for directions (tangents).
        seed: None takes the simplest numbers, others random ones within the error.
        keep: whether incidences are kept.
        key: of the random numbers.
        found_within: how well incidences hold, as a share of the errors.
    """

    snap: Fraction
    error: Fraction
    angle: Fraction
    seed: int | None = None
    keep: bool = True
    key: str = ""
    found_within: float = 0.5

    def number(self, low: Fraction, high: Fraction, key: str, bound: Fraction) -> Fraction:
        """Return a number within a bound of all from low to high, the same for each key."""
        if self.seed is not None:
            middle = (low + high) / 2 + self._share(key) * bound * 3 / 8
            low, high, bound = middle, middle, bound / 16
        return simplest_between(high - bound, low + bound)

    def normal(
        self,
        direction: RationalVector,
        aim: RationalVector,
        key: str,
        far: float = 0.0,
        square: Sequence[RationalVector] = (),
    ) -> UnitNormal:
        """Return a unit normal along an aim, finer where an incidence is far away.

        Its error is that from the direction given. In space it is at right angles to one unit
        vector or two.
        """
        bound = min(self.angle, self.error / (8 * Fraction(far))) if far else self.angle
        if self.seed is not None:
            size = max(map(abs, aim)) * bound / 2
            aim = tuple(x + self._share(f"{key} {j}") * size for j, x in enumerate(aim))
            bound /= 4
        if len(square) == 2:
            along = cross(*square)
            unit = along if dot(along, aim) > 0 else tuple(-x for x in along)
        elif square:
            axes = Contact([0, 0, 0], square[0], 0).tangents
            shares = unit_normal([dot(axis, aim) for axis in axes], bound).normal
            unit = tuple(dot(shares, column) for column in zip(*axes, strict=True))
        else:
            unit = unit_normal(aim, bound).normal
        return UnitNormal(unit, angle_error(direction, unit))

    def _share(self, key: str) -> Fraction:
        return Fraction(Random(f"{self.seed} {self.key} {key}").randint(-16, 16), 16)


def rounding(snap: Any, error: Any, angle: Any, as_given: bool) -> Rounding:
    """Return how numbers are rounded, from what a user gives."""
    names = ("tolerance", "tolerance", "angle_tolerance")
    limits = list(zip(names, (snap, error, angle), strict=True))
    bounds = [from_float(x, name) for name, x in limits]
    for (name, x), bound in zip(limits, bounds, strict=True):
        if bound < 0:
            raise GraspError(f"{name} is {shown(x)}; it must be at least 0")
    return Rounding(bounds[0], bounds[1], bounds[2], keep=not as_given)


def equal_numbers(values: Sequence[Fraction], bound: Fraction, how: Rounding) -> list[Fraction]:
    """Return numbers near the given ones; those of equal size within a bound stay equal in size."""
    numbers = list(values)
    order = sorted(range(len(values)), key=lambda i: abs(values[i])) if bound else []
    start = 0
    while start < len(order):
        low, end = abs(values[order[start]]), start + 1
        while how.keep and end < len(order) and abs(values[order[end]]) - low <= bound:
            end += 1
        key = to_text(round(low / bound)) if how.keep else f"number {order[start]}"
        size = how.number(low, abs(values[order[end - 1]]), key, bound)
        for i in order[start:end]:
            numbers[i] = -size if values[i] < 0 else size
        start = end
    return numbers
