"""Finite unions of closed intervals of rationals, exactly.

An interval is ``(low, high)``; None stands for unbounded on that side.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import product, starmap
from typing import TypeAlias

from arrangement.numbers.exact import to_text

Interval: TypeAlias = tuple[Fraction | None, Fraction | None]

LINE: Interval = (None, None)


def texts(interval: Interval) -> list[str | None]:
    """Return the JSON form of an interval: texts, None for unbounded."""
    return [None if end is None else to_text(end) for end in interval]


def where_positive(rows: Iterable[tuple[Fraction | int, Fraction | int]]) -> Interval | None:
    """Return all t with ``slope t + constant >= 0`` for every row; None when there is none.

    >>> where_positive([(1, -2), (-1, 5)])
    (Fraction(2, 1), Fraction(5, 1))
    """
    # Ends as numerator and positive denominator: most are not ends in the end, and need no gcd.
    low: tuple[Fraction | int, Fraction | int] | None = None
    high: tuple[Fraction | int, Fraction | int] | None = None
    for slope, constant in rows:
        if slope > 0:
            if low is None or -constant * low[1] > low[0] * slope:
                low = -constant, slope
        elif slope < 0:
            if high is None or constant * high[1] < high[0] * -slope:
                high = constant, -slope
        elif constant < 0:
            return None
    if low is not None and high is not None and low[0] * high[1] > high[0] * low[1]:
        return None
    return low and Fraction(*low), high and Fraction(*high)


def union(intervals: Iterable[Interval]) -> tuple[Interval, ...]:
    """Return the union as disjoint closed intervals in increasing order.

    >>> union([(Fraction(1), None), (Fraction(0), Fraction(1))])
    ((Fraction(0, 1), None),)
    """
    merged: list[Interval] = []
    for low, high in sorted(intervals, key=lambda part: (part[0] is not None, part[0] or 0)):
        start, end = merged[-1] if merged else (low, high)
        if merged and (end is None or low is None or low <= end):
            merged[-1] = start, None if end is None or high is None else max(end, high)
        else:
            merged.append((low, high))
    return tuple(merged)


def holds(intervals: Iterable[Interval], value: Fraction) -> bool:
    """Return whether a value lies in one of the intervals."""
    return any(
        (low is None or low <= value) and (high is None or value <= high) for low, high in intervals
    )


def intersection(one: Interval, other: Interval) -> Interval | None:
    """Return the common part, possibly one point; None when there is none."""
    lows = [x for x in (one[0], other[0]) if x is not None]
    highs = [x for x in (one[1], other[1]) if x is not None]
    low, high = max(lows, default=None), min(highs, default=None)
    return None if low is not None and high is not None and low > high else (low, high)


def common(one: Iterable[Interval], other: Iterable[Interval]) -> tuple[Interval, ...]:
    """Return the common part of two unions.

    >>> common([(Fraction(0), Fraction(2)), (Fraction(3), None)], [(Fraction(1), Fraction(3))])
    ((Fraction(1, 1), Fraction(2, 1)), (Fraction(3, 1), Fraction(3, 1)))
    """
    parts = starmap(intersection, product(one, tuple(other)))
    return union(part for part in parts if part is not None)


def remainder(whole: Interval, removed: Sequence[Interval]) -> tuple[Interval, ...]:
    """Return the closures of the parts of positive length that are left of `whole`.

    >>> remainder((Fraction(0), None), [(Fraction(1), Fraction(2))])
    ((Fraction(0, 1), Fraction(1, 1)), (Fraction(2, 1), None))
    """
    parts: list[Interval] = []
    start = whole[0]
    for low, high in union(removed):
        if low is not None:
            part = intersection(whole, (start, low))
            if part is not None:
                parts.append(part)
        if high is None:
            return tuple(part for part in parts if is_long(part))
        start = high if start is None else max(start, high)
    last = intersection(whole, (start, None))
    return tuple(part for part in [*parts, last] if part is not None and is_long(part))


def is_long(interval: Interval) -> bool:
    """Return whether an interval is more than one point."""
    return None in interval or interval[0] != interval[1]
