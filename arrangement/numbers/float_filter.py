"""Signs that floating point proves, by one bound on the error of sums of products.

Let s be a sum of products, S the sum of their absolute values, and let each product take at most
n roundings: of its factors, of the product itself, and of the additions, in any order. Then the
computed value of s is wrong by at most ``g S`` with ``g = n u / (1 - n u)``, u = `UNIT`
[Higham2002], section 3.1. S itself is computed with as many roundings, to S' say, and is at most
``S' / (1 - g)``. So the error is at most ``n u / (1 - 2 n u) S'``. The product ``(n + 2) u S'`` is
larger, even rounded down by a factor ``1 - u``, because ``(n + 2) (1 - u) (1 - 2 n u) >= n`` for n
up to 2^25. That is `error_bound`. No product may underflow: see `SMALLEST`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from .exact import IntegerVector
from .real import field_of

Floats: TypeAlias = NDArray[np.float64]
Booleans: TypeAlias = NDArray[np.bool_]
Signs: TypeAlias = NDArray[np.int8]

#: The unit roundoff u of double precision: no operation has a larger relative error.
UNIT = 2.0**-53
#: Integers up to this size, and sums and products of them that stay within it, are exact.
EXACT = 2**53
#: Factors of this size at least: products of four are 2^-800 or more, their last digits 2^-853, and
#: what subtraction leaves of two products times another two is above 2^-1022.
SMALLEST = 2.0**-200


#: No sum exceeds twice the sum of its absolute products, so this bound decides nothing.
UNUSABLE = 2.0


def error_bound(roundings: int) -> float:
    """Return the bound of the error, relative to the computed sum of the absolute products."""
    return (roundings + 2) * UNIT


def certain(values: Any, sizes: Any, bound: float) -> Booleans:
    """Return where the sign of a computed sum of products is surely its true sign.

    Args:
        values, sizes: the computed sums of the products and of their absolute values.
        bound: see `error_bound`.
    """
    decided_signs: Booleans = np.abs(values) > bound * sizes
    return decided_signs


def signs_of(values: NDArray[Any]) -> Signs:
    """Return the sign of every entry as int8."""
    positive: Booleans = values > 0
    negative: Booleans = values < 0
    return positive.view(np.int8) - negative.view(np.int8)


def certified_signs(
    values: Floats,
    sizes: Floats,
    error: float,
    least: Floats | float,
    exact: Callable[[tuple[NDArray[np.intp], ...]], Any],
) -> Signs:
    """Return the signs of sums of products from their computed values.

    Args:
        values, sizes: as for `certain`.
        error: see `error_bound`.
        least: what is smaller than this, with its error, is 0.
        exact: from indices to exact values, for what is still open.
    """
    signs = signs_of(values)
    rest = ~certain(values, sizes, error)
    signs[rest] = 0
    at = np.nonzero(rest & (sizes > 0) & (np.abs(values) + error * sizes >= least))
    if len(at[0]):
        signs[at] = signs_of(exact(at))
    return signs


def least_sizes(rows: Sequence[IntegerVector]) -> Floats:
    """Return a number for each of the rows `scale_rows` scales, which keeps products from 0.

    Let a sum of products have at most 24 products of one entry each of the same rows. If it is not
    0 it is at least the product of the numbers of these rows: the norm of the sum, the product of
    its conjugates, is an integer then, and at least 1.
    """
    field = field_of(x for row in rows for x in row)
    power = 0 if field is None else field.degree - 1
    sizes_of = []
    for row in rows:
        conjugates = max((abs(x) if isinstance(x, int) else x.size() for x in row), default=0)
        bits = max(abs(x) for x in row).bit_length()
        exponent = -bits - power * math.log2(3 * conjugates or 1) - 1e-6
        sizes_of.append(2.0**exponent if exponent > -200 else 0.0)
    return np.array(sizes_of)


def scale_rows(rows: Sequence[IntegerVector]) -> tuple[Floats, Booleans]:
    """Return integer rows over powers of two, rounded, and which of them floats can hold.

    Entries are below 1 in size. In a row that floats can hold each has one rounding, and is 0 or
    not below `SMALLEST`.
    """
    if not rows:
        return np.empty((0, 0)), np.empty(0, np.bool_)
    scales = [1 << max(abs(x) for x in row).bit_length() for row in rows]
    floats = np.array(
        [[x / scale for x in row] for row, scale in zip(rows, scales, strict=True)], np.float64
    )
    present = np.array([[x != 0 for x in row] for row in rows])
    return floats, ((np.abs(floats) >= SMALLEST) | ~present).all(axis=1)
