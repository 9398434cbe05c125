"""The cyclic order of crossings on every great circle: floats propose, exact signs dispose.

The positive crossings of circle i with the others lie on a half-open half circle, so their
angles lie in an interval of length pi with one end left out, and grow with their slopes. If in a
proposed order no angle exceeds the next, the order is right. For two neighbours j and k that is
certain

* if their slopes as floats differ by more than the error of both, or else
* if ``det(n_i, n_j, n_k) turn_ij turn_ik >= 0``; then equality holds exactly when the crossings
  coincide.

What is sorted are the slopes with other circle and turn written into their last bits, which takes
a third of the time of an indirect sort. Cut to units of ``2^s`` steps of a float, with s at least
`LEAST_BITS`, a float loses less than one unit; and a reliable slope (`ExactSigns`) is within 4
steps of its float. So two of them stand in the order of their units where these differ by two or
more: the floats are then more than one unit apart, 16 steps at least. A circle whose proposal fails
is sorted again by exact determinants.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cmp_to_key
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arrangement.numbers.exact import IntegerVector
from arrangement.numbers.float_filter import Signs
from arrangement.numbers.linear.rank import triple_product

from .predicates import ExactSigns, FilteredSigns, Indices, Integers

#: Entries handled at once: temporary arrays this small stay in the cache and are used again.
BLOCK = 1 << 14
#: The least number of last bits of a slope that are overwritten.
LEAST_BITS = 4
#: The slope of a circle with itself, so that it comes last.
_OWN = 2.0**1001


@dataclass(frozen=True, slots=True)
class Crossings:
    """The positive crossings of each of c circles, in counterclockwise order about its normal.

    Attributes:
        order: (c, c - 1); row i lists the other circles.
        turn: (c, c - 1); ``turn_ij`` of `predicates` for the circle j at the same place of `order`.
        tied: (c, c - 1); whether the crossing is the same point as the one before it in the row.
    """

    order: NDArray[np.int32]
    turn: Signs
    tied: NDArray[np.bool_]


def sort_crossings(normals: Integers) -> Crossings:
    """Return the certified order of crossings on each circle.

    Args:
        normals: (c, 3) distinct positive integer vectors, no two parallel; their dtype must obey
            the bound in `predicates`.

    Complexity: O(c^2 log c) time; O(c^2) memory for the result and O(c) for what is temporary.
    """
    count = len(normals)
    shape = (count, max(count - 1, 0))
    result = Crossings(np.empty(shape, np.int32), np.empty(shape, np.int8), np.zeros(shape, bool))
    if not count:
        return result
    signs = FilteredSigns(normals) if normals.dtype == object else ExactSigns(normals)
    step = max(1, BLOCK // count)
    for start in range(0, count, step):
        _sort_block(signs, slice(start, min(start + step, count)), result)
    return result


def _sort_block(signs: ExactSigns, block: slice, crossings: Crossings) -> None:
    """Fill the rows of `found` for a block of circles."""
    slopes, backward = signs.slopes(block)
    count = slopes.shape[1]
    own = np.arange(block.start, block.stop)
    slopes[own - block.start, own] = _OWN
    slopes += 0.0  # one zero, not two
    written = 1 + (count - 1).bit_length()
    bits = max(LEAST_BITS, written)
    keys = slopes.view(np.int64)
    keys &= -1 << bits
    keys |= 2 * np.arange(count)
    keys |= backward
    slopes.sort(axis=1)
    keys = keys[:, :-1]
    last = keys.astype(np.int32) & np.int32((1 << written) - 1)
    order, turn, tied = crossings.order[block], crossings.turn[block], crossings.tied[block]
    order[...] = last >> 1
    turn[...] = 1 - 2 * (last & 1)
    near = np.abs(np.diff(keys >> bits, axis=1)) < 2 if signs.reliable else ~tied[:, 1:]
    rows, columns = np.divmod(np.flatnonzero(near), count - 2)
    ascents = _ascents(signs, own, order, turn, rows, columns)
    if wrong := sorted(set(rows[ascents < 0].tolist())):
        normals = signs.normals.tolist()
        for row in wrong:
            _sort_exactly(normals, block.start + row, order[row], turn[row])
        ascents = _ascents(signs, own, order, turn, rows, columns)
    tied[rows, columns + 1] = ascents == 0


def _ascents(
    signs: ExactSigns,
    own: Indices,
    order: NDArray[np.int32],
    turn: Signs,
    rows: Indices,
    columns: Indices,
) -> Signs:
    """Return ``sign det(n_i, n_j, n_k) turn_ij turn_ik`` for neighbours j and k at some places."""
    here, there = (rows, columns), (rows, columns + 1)
    return signs.determinants(own[rows], order[here], order[there]) * turn[here] * turn[there]


def _sort_exactly(
    normals: list[IntegerVector], circle: int, order: NDArray[np.int32], turn: Signs
) -> None:
    """Sort a row of `Crossings` in place by exact determinants."""

    def compare(left: tuple[int, int], right: tuple[int, int]) -> Any:
        (j, turn_j), (k, turn_k) = left, right
        return triple_product(normals[circle], normals[k], normals[j]) * turn_j * turn_k

    row = sorted(zip(order.tolist(), turn.tolist(), strict=True), key=cmp_to_key(compare))
    order[...], turn[...] = np.array(row).T
