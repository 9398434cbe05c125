"""The cyclic order of crossings on every great circle: floats propose, determinants dispose.

The positive crossings of circle i with the others lie on a half-open half circle, so their
angles lie in an interval of length pi with one end left out. If each crossing and the next one
in a proposed order have ``det(n_i, n_j, n_k) turn_ij turn_ik >= 0``, then no angle exceeds the
next, and the order is right; equality holds exactly when the crossings coincide. So a proposed
order is certified by exact signs of neighbours alone, wherever a float put the cut at 0 and pi.
A circle whose proposal fails is sorted again by exact rational slopes.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cmp_to_key

import numpy as np
from numpy.typing import NDArray

from arrangement.errors import ArrangementError
from arrangement.float_filter import Signs, signs_of

from .predicates import (
    Components,
    ExactSigns,
    FilteredSigns,
    Integers,
    along_rows,
    cross_products,
    exact_slope_terms,
    slope_terms,
)

#: Entries handled at once: temporary arrays this small stay in the cache and are used again.
BLOCK = 1 << 14


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
    found = Crossings(np.empty(shape, np.int32), np.empty(shape, np.int8), np.zeros(shape, bool))
    if count < 2:
        return found
    signs = FilteredSigns(normals) if normals.dtype == object else ExactSigns(normals)
    step = max(1, BLOCK // count)
    for start in range(0, count, step):
        _sort_block(signs, slice(start, min(start + step, count)), found)
    return found


def _sort_block(signs: ExactSigns | FilteredSigns, block: slice, found: Crossings) -> None:
    """Fill the rows of `found` for a block of circles."""
    directions = cross_products(signs.numbers[block], signs.numbers)
    turn = signs.turns(directions, block)
    proposal = _proposal(signs.numbers[block], directions, turn)
    # Without NaN numpy sorts several numbers at a time, three times as fast.
    order = np.argsort(proposal, axis=1)
    own = np.arange(block.start, block.stop)[:, None]
    order = order[order != own].reshape(len(order), -1)
    ascents, sorted_turn = _ascents(signs, directions, turn, order, block)
    failed = np.nonzero((ascents < 0).any(axis=1))[0]
    if len(failed):
        exact = [tuple(row) for row in signs.normals.tolist()]
        order[failed] = [_exact_order(exact, block.start + int(row)) for row in failed]
        ascents, sorted_turn = _ascents(signs, directions, turn, order, block)
        if (ascents < 0).any():  # pragma: no cover - two exact methods would disagree
            raise ArrangementError(
                "slopes and determinants disagree on the order of crossings; report this input"
            )
    found.order[block], found.turn[block] = order, sorted_turn
    found.tied[block, 1:] = ascents == 0


def _proposal(normals: Integers, directions: Components, turn: Signs) -> NDArray[np.float64]:
    """Return float slopes of the positive crossings; vertical ones are infinite."""
    p, q = slope_terms(normals, directions)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        slopes: NDArray[np.float64] = p / q
        vertical = np.nonzero(q == 0)
        slopes[vertical] = signs_of(p[vertical]) * turn[vertical] * np.inf
    return np.nan_to_num(slopes, copy=False, nan=0.0, posinf=np.inf, neginf=-np.inf)


def _ascents(
    signs: ExactSigns | FilteredSigns,
    directions: Components,
    turn: Signs,
    order: NDArray[np.intp],
    block: slice,
) -> tuple[Signs, Signs]:
    """Return ``sign det(n_i, n_j, n_k) turn_ij turn_ik`` of neighbours, and the sorted turns."""
    sorted_turn = along_rows(turn, order)
    here, there = order[:, :-1], order[:, 1:]
    found = signs.determinants(directions, block, here, there)
    return found * sorted_turn[:, :-1] * sorted_turn[:, 1:], sorted_turn


def _exact_order(normals: list[tuple[int, ...]], circle: int) -> list[int]:
    """Return the other circles sorted by the exact slopes of their positive crossings."""
    slopes = {
        other: exact_slope_terms(normals[circle], normal)
        for other, normal in enumerate(normals)
        if other != circle
    }

    def compare(left: int, right: int) -> int:
        (p, q), (r, s) = slopes[left], slopes[right]
        return (p * s > r * q) - (p * s < r * q)

    return sorted(slopes, key=cmp_to_key(compare))
