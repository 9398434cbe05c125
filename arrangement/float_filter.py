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

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from .exact import IntegerVector

Floats: TypeAlias = NDArray[np.float64]
Booleans: TypeAlias = NDArray[np.bool_]

#: The unit roundoff u of double precision: no operation has a larger relative error.
UNIT = 2.0**-53
#: Integers up to this size, and sums and products of them that stay within it, are exact.
EXACT = 2**53
#: Factors of this size at least: products of four are 2^-800 or more, their last digits 2^-853, and
#: what subtraction leaves of two products times another two is above 2^-1022.
SMALLEST = 2.0**-200


def error_bound(roundings: int) -> float:
    """Return the bound of the error, relative to the computed sum of the absolute products."""
    return (roundings + 2) * UNIT


def certain(values: Any, sizes: Any, bound: float) -> Booleans:
    """Return where the sign of a computed sum of products is surely its true sign.

    Args:
        values, sizes: the computed sums of the products and of their absolute values.
        bound: see `error_bound`.
    """
    found: Booleans = np.abs(values) > bound * sizes
    return found


def scaled(rows: Sequence[IntegerVector]) -> tuple[Floats, Booleans]:
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
