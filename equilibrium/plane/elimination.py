"""Fraction-free Gauss-Jordan elimination: one common denominator, exact divisions, on integers."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from arrangement.numbers.exact import primitive


def gauss_jordan(
    matrix: Sequence[Sequence[Fraction | int]],
) -> tuple[list[list[int]], list[int], int]:
    """Return the reduced rows times a common scale, the pivot columns, and the scale.

    Row i of the result has its pivot, of the value `scale`, in column ``pivots[i]``; rows beyond
    the pivots are zero. Rows of the input are scaled to integers first, which changes no solution.
    """
    rows = [list(primitive(row)) for row in matrix]
    pivots: list[int] = []
    scale = 1
    for column in range(len(rows[0]) if rows else 0):
        done = len(pivots)
        found = next((i for i in range(done, len(rows)) if rows[i][column]), None)
        if found is None:
            continue
        rows[done], rows[found] = rows[found], rows[done]
        top = rows[done]
        pivot = top[column]
        for i, row in enumerate(rows):
            if i != done:
                factor = row[column]
                rows[i] = [(pivot * a - factor * b) // scale for a, b in zip(row, top, strict=True)]
        scale = pivot
        pivots.append(column)
    return rows, pivots, scale
