"""Small exact linear algebra on integer vectors: rank, and subspaces cut by one plane at a time.

SymPy's domain matrices serve large single matrices; here there are many tiny ones, where the
cost of building a matrix object exceeds the arithmetic.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from .exact import IntegerVector


def reduced(vector: Sequence[int]) -> IntegerVector:
    """Divide an integer vector by the greatest common divisor of its entries."""
    divisor = math.gcd(*vector)
    return tuple(vector) if divisor <= 1 else tuple(x // divisor for x in vector)


def rank(rows: Sequence[Sequence[int]]) -> int:
    """Return the rank of integer row vectors, by fraction-free elimination."""
    remaining = [tuple(row) for row in rows if any(row)]
    found = 0
    while remaining:
        pivot_row = remaining.pop()
        found += 1
        column = next(j for j, x in enumerate(pivot_row) if x)
        remaining = [
            row for row in (_eliminated(row, pivot_row, column) for row in remaining) if any(row)
        ]
    return found


def _eliminated(row: Sequence[int], pivot_row: Sequence[int], column: int) -> IntegerVector:
    """Return the combination of two rows whose entry in `column` is zero."""
    factor, pivot = row[column], pivot_row[column]
    if factor == 0:
        return tuple(row)
    return reduced([pivot * a - factor * b for a, b in zip(row, pivot_row, strict=True)])


def unit_vectors(dimension: int) -> list[IntegerVector]:
    """Return the standard basis of R^dimension."""
    return [tuple(int(i == j) for j in range(dimension)) for i in range(dimension)]


def cut(basis: Sequence[IntegerVector], values: Sequence[int]) -> list[IntegerVector]:
    """Return a basis of the vectors of a subspace at which a linear form vanishes.

    Args:
        basis: k independent integer vectors.
        values: the values of the form at the basis vectors, not all zero.

    Returns:
        k - 1 independent primitive integer vectors.
    """
    pivot = next(j for j, value in enumerate(values) if value)
    base, top = basis[pivot], values[pivot]
    return [
        vector
        if values[j] == 0
        else reduced([top * a - values[j] * b for a, b in zip(vector, base, strict=True)])
        for j, vector in enumerate(basis)
        if j != pivot
    ]
