"""Directions of a plane in exact counter-clockwise order, and sectors of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.numbers.exact import IntegerVector, to_text

_AXES: tuple[IntegerVector, ...] = ((1, 0), (0, 1), (-1, 0), (0, -1))


@dataclass(frozen=True)
class Sector:
    """The directions from `start` counter-clockwise to `end`.

    With equal ends it is this one direction, or, if the ends do not belong, all but this one.

    Attributes:
        has_start, has_end: whether the ends belong to it.
        whole: whether it is the whole turn; `start` and `end` mean nothing then.
    """

    start: IntegerVector
    end: IntegerVector
    has_start: bool = True
    has_end: bool = True
    whole: bool = False

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        ends = {"start": list(map(to_text, self.start)), "end": list(map(to_text, self.end))}
        flags = {"has_start": self.has_start, "has_end": self.has_end, "whole": self.whole}
        return {**ends, **flags}


def counter_clockwise(directions: Iterable[IntegerVector]) -> list[IntegerVector]:
    """Return primitive directions, none zero, without repeats, by angle from (1, 0).

    >>> counter_clockwise([(0, -1), (1, 1), (1, 0)])
    [(1, 0), (1, 1), (0, -1)]
    """
    return sorted(set(directions), key=_angle)


def sectors(
    ends: Iterable[IntegerVector], member: Callable[[IntegerVector], bool]
) -> tuple[Sector, ...]:
    """Return the set of directions with a property that changes at most at the given ends.

    Exact: each end and one direction between each two neighbours are asked.
    """
    corners = counter_clockwise([*ends, *_AXES])
    after = [*corners[1:], corners[0]]
    # With the axes among them, neighbours are at most a right angle apart.
    # Stops of even number are corners.
    pairs = zip(corners, after, strict=True)
    stops = [stop for a, b in pairs for stop in (a, (a[0] + b[0], a[1] + b[1]))]
    flags = [member(stop) for stop in stops]
    if all(flags):
        return (Sector((1, 0), (1, 0), whole=True),)
    runs = [(i, _run_end(flags, i)) for i in range(len(flags)) if flags[i] and not flags[i - 1]]
    return tuple(_sector(stops, first, last) for first, last in runs)


def _sector(stops: Sequence[IntegerVector], first: int, last: int) -> Sector:
    """Return the sector of a run of stops; a run that starts or ends between corners is open."""
    open_start, open_end = first % 2 == 1, last % 2 == 1
    start, end = stops[first - open_start], stops[(last + open_end) % len(stops)]
    return Sector(start, end, not open_start, not open_end)


def _run_end(flags: Sequence[bool], first: int) -> int:
    """Return the last index, cyclic, of the run of true flags that starts at `first`."""
    last = first
    while flags[(last + 1) % len(flags)]:
        last = (last + 1) % len(flags)
    return last


def _angle(direction: IntegerVector) -> tuple[int, Fraction]:
    """Return the number of the quadrant, and the tangent of the angle in it."""
    (x, y), quadrant = direction, 0
    while x <= 0 or y < 0:
        x, y, quadrant = y, -x, quadrant + 1
    return quadrant, Fraction(y, x)
