"""Isomorphism classes of lines of the plane: those of the projective plane with one at infinity.

Two arrangements of lines of R^2 are isomorphic if one becomes the other by relabelling and exchange
of sides, as far as sign vectors are concerned: if their cones are so, infinity going to infinity.
So they are the classes of m + 1 lines with an orbit of lines in each, which one at infinity stands
for; and m parallel lines, whose cone has rank 2.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.numbers.exact import shown

from .catalogue import MOST_PLANES, PUBLISHED, PUBLISHED_SIMPLE, census, chirotopes
from .chirotopes import canonical

#: The largest number of lines whose classes are in the census.
MOST_LINES = MOST_PLANES - 1
#: Classes of the projective plane whose symmetries are found at once.
_AT_ONCE = 500


def lines(m: int, *, simple: bool = False) -> Iterator[Arrangement]:
    """Yield one arrangement of each isomorphism class of m different lines of the plane R^2.

    There are 1, 2, 4, 9, 47, 791, 37830 for 1 to 7 lines, and 1, 1, 1, 1, 6, 43, 922, 38609 for 1
    to 8 in general position: any two meet, no three in a point.

    Args:
        m: 1 to 8.
        simple: only the classes in general position.

    Raises:
        InputError: another number of lines.

    Source: the counts, OEIS A241600 and A090338.

    >>> [sum(1 for _ in lines(m)) for m in range(1, 6)]
    [1, 2, 4, 9, 47]
    """
    if _number(m) == 1 or not simple:
        yield Arrangement([[1, 0]] * m, range(m))
    types = census(m + 1) if m > 1 else ()
    for place, infinity in _at_infinity(m, simple=simple):
        yield without_line(types[place], infinity)


def line_count(m: int, *, simple: bool = False) -> int:
    """Return the number of `lines`, from chirotopes alone.

    >>> line_count(4), line_count(6, simple=True)
    (9, 43)
    """
    return (_number(m) == 1 or not simple) + sum(1 for _ in _at_infinity(m, simple=simple))


def _number(m: int) -> int:
    if type(m) is not int or not 1 <= m <= MOST_LINES:
        raise InputError(f"m is {shown(m)}; the census has 1 to {MOST_LINES} lines of the plane")
    return m


def _at_infinity(m: int, *, simple: bool) -> Iterator[tuple[int, int]]:
    """Yield the places of the classes of m + 1 lines, each with a line of every orbit."""
    total = PUBLISHED.get(m + 1, 0)
    # In the order of numbers of regions: the simple ones come last.
    for start in range(total - PUBLISHED_SIMPLE[m + 1] if simple and total else 0, total, _AT_ONCE):
        orbits = canonical(chirotopes(m + 1, slice(start, start + _AT_ONCE)), m + 1).orbits
        for k, infinity in np.argwhere(orbits == np.arange(m + 1)).tolist():
            yield start + k, infinity


def without_line(planes: Arrangement, infinity: int) -> Arrangement:
    """Return the other lines of the projective plane, in coordinates with one at infinity."""
    rows: list[Any] = [plane[:-1] for plane in planes.integer_planes]
    far = rows.pop(infinity)
    last = next(k for k, x in enumerate(far) if x)
    one, two = (k for k in range(3) if k != last)
    normals = [[far[last] * row[k] - row[last] * far[k] for k in (one, two)] for row in rows]
    return Arrangement(normals, [-row[last] for row in rows])
