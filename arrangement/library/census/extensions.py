"""All ways to add a pseudoline to an arrangement of pseudolines, without coordinates.

A one-element extension of an oriented matroid is given by a sign for each cocircuit, opposite at
opposite ones. Signs belong to an extension exactly when they do so on every contraction of rank 2
([LasVergnas1978]; [BjornerLasVergnasSturmfelsWhiteZiegler1999], theorem 7.1.8). In rank 3 these are
the lines: around each line the signs change once within the points of a half turn, with or without
a 0 at the change. (All 0 would be an element parallel to the line.) So lines are taken one after
another, and what agrees on their common points is joined.
"""

from __future__ import annotations

from functools import cmp_to_key

import numpy as np
from numpy.typing import NDArray

from .chirotopes import Signs, alternating, pairs


def extensions(signs: Signs, n: int) -> Signs:
    """Return all extensions of one chirotope by an element that is parallel to none.

    Args:
        signs: the chirotope's signs, (C(n, 3),).
        n: its number of elements.

    Returns:
        The signs of (i, j, new) for the pairs i < j, (K, C(n, 2)); of the two signs of the new
        element one is listed.
    """
    chi = alternating(signs[None], n)[0]
    point, side = _points(chi)
    found = np.zeros((1, point.max() + 1), dtype=np.int8)
    known = np.zeros(point.max() + 1, dtype=bool)
    for line in range(n):
        on, patterns = _along(chi, line, point, side)
        shared = known[on]
        fits = (found[:, None, on[shared]] == patterns[None, :, shared]).all(2)
        row, pattern = np.nonzero(fits)
        found = found[row]
        found[:, on] = patterns[pattern]
        known[on] = True
    i, j = pairs(n).T
    all_signs: Signs = found[:, point[i, j]] * side[i, j]
    first = all_signs[np.arange(len(all_signs)), (all_signs != 0).argmax(1)]
    listed: Signs = all_signs[first > 0]
    return listed


def _points(chi: Signs) -> tuple[NDArray[np.intp], Signs]:
    """Number the points where lines meet; give the cocircuit of (i, j) as a sign times theirs."""
    n = len(chi)
    point = np.full((n, n), -1, dtype=np.intp)
    side = np.zeros((n, n), dtype=np.int8)
    number = 0
    for i, j in pairs(n):
        if point[i, j] < 0:
            through = np.flatnonzero(chi[i, j] == 0)
            missing = np.flatnonzero(chi[i, j])[0]
            grid = np.ix_(through, through)
            point[grid] = number
            side[grid] = chi[i, j, missing] * chi[(*grid, missing)]
            number += 1
    return point, side


def _along(
    chi: Signs, line: int, point: NDArray[np.intp], side: Signs
) -> tuple[NDArray[np.intp], Signs]:
    """Return the points of a line in order, and every way that signs may go along them."""
    others = [j for j in range(len(chi)) if j != line]
    first_through = {point[line, j]: j for j in reversed(others)}
    base, *rest = first_through.values()
    turned = {j: int(chi[line, base, j]) for j in rest}

    def before(a: int, b: int) -> int:
        return -int(chi[line, a, b]) * turned[a] * turned[b]

    rest.sort(key=cmp_to_key(before))
    order = [base, *rest]
    sides = np.array([side[line, base], *(turned[j] * side[line, j] for j in rest)])
    size = len(order)
    change = np.arange(size)[:, None]
    plain = np.where(np.arange(size) < change, 1, -1)
    with_zero = np.where(np.arange(size) == change, 0, plain)
    patterns = np.concatenate([plain, -plain, with_zero, -with_zero]) * sides
    return point[line, order], patterns.astype(np.int8)
