"""Small exact linear algebra on integer vectors: rank, and subspaces cut by one plane at a time.

The enumerators have many tiny matrices, where building SymPy's costs more than the arithmetic:
they take 7 to 13 times as long to `cut` a space of dimension 4 in R^6, 14 times for the `rank` of
ten rows of length 3. To certify the faces of 30 planes of R^3, with a rank for each set of zeros,
takes 2.4 times as long in all.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from fractions import Fraction
from typing import Any, TypeVar

from arrangement.numbers import budget
from arrangement.numbers.exact import (
    IntegerVector,
    dot,
    fast_integers,
    largest,
    primitive,
    reduced,
    without_denominators,
)

_Item = TypeVar("_Item")
#: Of a matrix with more entries a basis is guessed modulo `PRIME`, and proved.
_MAX_ENTRIES_UNGUESSED = 2000
PRIME = 2**26 - 5
#: This many products of numbers below the prime are subtracted before they are reduced: they, and
#: what they are subtracted from, stay below 2^62.
_LAZY = 2**9


def rank(rows: Sequence[Sequence[int]]) -> int:
    """Return the rank of integer row vectors, by fraction-free elimination.

    Rows that are independent modulo a prime are independent; that they span the others is checked.
    """
    if len(rows) and len(rows) * len(rows[0]) > _MAX_ENTRIES_UNGUESSED and largest(rows) < math.inf:
        if len(rows) < len(rows[0]):
            rows = list(zip(*rows, strict=True))
        width = len(rows[0])
        if len(rows) > 2 * width and rank(spread(rows, 2 * width)) == width:
            return width
        chosen = _independent(rows)
        if len(chosen) == min(width, len(rows)):
            return len(chosen)
        ask_elimination([rows[i] for i in chosen], width)
        left = unit_vectors(width)
        for i in chosen:
            left = cut(left, [dot(rows[i], vector) for vector in left])
        if not any(dot(row, vector) for vector in left for row in rows):
            return len(chosen)
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


def spread(rows: Sequence[_Item], few: int) -> Sequence[_Item]:
    """Return at most a given number of the rows, at equal distances."""
    return rows[:: max(1, -(-len(rows) // few))]


def spanning(rows: Sequence[IntegerVector]) -> Sequence[IntegerVector]:
    """Return rows that span all of them: few, where there are many rows of integers."""
    if (
        not len(rows)
        or len(rows) * len(rows[0]) <= _MAX_ENTRIES_UNGUESSED
        or largest(rows) == math.inf
    ):
        return rows
    chosen = _independent(rows)
    return [rows[i] for i in chosen] if rank(rows) == len(chosen) else rows


def _independent(rows: Sequence[Sequence[int]]) -> list[int]:
    """Return which rows are independent of those before, modulo a prime."""
    return echelon(list(zip(*rows, strict=True)), reduced=False)[1]


def echelon(rows: Sequence[Sequence[int]], *, reduced: bool = True) -> tuple[Any, list[int]]:
    """Return the reduced echelon form of integer rows modulo a prime, and its pivot columns.

    These columns are independent over the integers too, but there may be more that are.

    Args:
        reduced: if not, what stands above the pivots stays: a third of the work.
    """
    import numpy as np

    budget.check_cost(
        f"elimination in a matrix of {len(rows)} rows",
        steps=len(rows) * len(rows[0]) * min(len(rows), len(rows[0])) / 50,
    )
    if largest(rows) < 2**63:
        left = np.array(rows, dtype=np.int64) % PRIME
    else:
        left = np.array([[x % PRIME for x in row] for row in rows], dtype=np.int64)
    pivots: list[int] = []
    while len(pivots) < len(left):
        done, column = len(pivots), pivots[-1] + 1 if pivots else 0
        if not (left[done:, column : column + 1] % PRIME).any():
            left %= PRIME
            rest = left[done:, column:].any(axis=0)
            if not rest.any():
                break
            column += int(rest.argmax())
        entries = left[:, column] % PRIME
        swap = done + int((entries[done:] != 0).argmax())
        left[[done, swap]], entries[[done, swap]] = left[[swap, done]], entries[[swap, done]]
        # what stands before the pivot is 0
        row = left[done, column:] % PRIME * pow(int(entries[done]), -1, PRIME) % PRIME
        left[done, column:], entries[done] = row, 0
        below = 0 if reduced else done
        changed = below + np.flatnonzero(entries[below:])
        left[changed, column:] -= entries[changed, None] * row
        pivots.append(column)
        if not len(pivots) % _LAZY:
            left %= PRIME
    return left[: len(pivots)] % PRIME, pivots


def ask_elimination(rows: Sequence[Sequence[Any]], width: int) -> None:
    """Refuse to eliminate in a matrix that is too large for it; few entries stay few."""
    if len(rows) * width <= _MAX_ENTRIES_UNGUESSED:
        return
    filled = sum(1 for row in rows for x in row if x)
    order = min(width, len(rows))
    digits = 1 + order * int(largest(rows)).bit_length() / 2000 if largest(rows) < math.inf else 20
    budget.check_cost(
        f"elimination in a matrix of {len(rows)} rows with {width} entries",
        "leave out planes or coordinates",
        steps=6 * digits * filled**2 * order / max(1, len(rows) * width),
    )


def _eliminated(row: Sequence[int], pivot_row: Sequence[int], column: int) -> IntegerVector:
    """Return the combination of two rows whose entry in `column` is zero."""
    factor, pivot = row[column], pivot_row[column]
    if factor == 0:
        return tuple(row)
    return reduced([pivot * a - factor * b for a, b in zip(row, pivot_row, strict=True)])


def cycle_edges(corners: Sequence[_Item]) -> Iterator[tuple[_Item, _Item]]:
    """Return the directed edges of a polygon.

    >>> list(cycle_edges("abc"))
    [('a', 'b'), ('b', 'c'), ('c', 'a')]
    """
    return zip(corners, (*corners[1:], *corners[:1]), strict=True)


def loop_around(directed: Collection[tuple[_Item, _Item]]) -> list[_Item]:
    """Return the boundary of faces given by their directed edges; empty if it is not one cycle.

    It begins with its least corner.
    """
    following: dict[Any, Any] = {a: b for a, b in directed if (b, a) not in directed}
    loop = [min(following)]
    while following[loop[-1]] != loop[0] and len(loop) < len(following):
        loop.append(following[loop[-1]])
    return loop if following[loop[-1]] == loop[0] else []


def difference(left: Sequence[Any], right: Sequence[Any]) -> tuple[Any, ...]:
    """Return the difference of two exact vectors."""
    return tuple([x - y for x, y in zip(left, right, strict=True)])


def cross(left: Sequence[Any], right: Sequence[Any]) -> tuple[Any, Any, Any]:
    """Return the cross product of two exact vectors of R^3; zero if they are parallel."""
    a, b, c = left
    x, y, z = right
    return b * z - c * y, c * x - a * z, a * y - b * x


def triple_product(a: Sequence[Any], b: Sequence[Any], c: Sequence[Any]) -> Any:
    """Return ``a . (b x c)``, the determinant of three exact vectors of R^3."""
    return dot(a, cross(b, c))


def plane_through(a: IntegerVector, b: IntegerVector, c: IntegerVector) -> IntegerVector:
    """Return h with ``h . p = det[a; b; c; p]`` for homogeneous points of R^3.

    It is positive on the side from which a, b, c run clockwise.
    """
    without = [[[*row[:k], *row[k + 1 :]] for row in (a, b, c)] for k in range(4)]
    return tuple((1 if k % 2 else -1) * triple_product(*rows) for k, rows in enumerate(without))


def determinant(rows: Sequence[Sequence[int]]) -> int:
    """Return the determinant of a square integer matrix by Bareiss' fraction-free elimination.

    Every division is exact, and every intermediate number is a minor of the matrix. A chirotope
    takes many tiny determinants: SymPy's take 1.3 to 2.2 times as long in all.
    Source: E. Bareiss, Math. Comp. 22 (1968).

    >>> determinant([[2, 1], [1, 3]])
    5
    """
    matrix = [list(row) for row in rows]
    size, sign, previous = len(matrix), 1, 1
    for k in range(size):
        swap = next((i for i in range(k, size) if matrix[i][k]), None)
        if swap is None:
            return 0
        if swap != k:
            matrix[k], matrix[swap] = matrix[swap], matrix[k]
            sign = -sign
        pivot = matrix[k][k]
        for row in matrix[k + 1 :]:
            factor = row[k]
            for j in range(k + 1, size):
                row[j] = (row[j] * pivot - factor * matrix[k][j]) // previous
        previous = pivot
    return sign * previous


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


def gauss_jordan(
    matrix: Sequence[Sequence[Fraction | int]], *, by_flint: bool = False
) -> tuple[list[list[int]], list[int], int]:
    """Return the reduced rows times a common scale, the pivot columns, and the scale.

    Row i of the result has its pivot, of the value `scale`, in column ``pivots[i]``; rows beyond
    the pivots are zero. Rows of the input are scaled to integers first, which changes no solution.

    Args:
        by_flint: use FLINT for short integers, too: three times as fast from five rows on, if the
            tenth of a second of its import does not matter.
    """
    if by_flint:
        rows: list[list[Any]] = [list(without_denominators(row)) for row in matrix]
    else:
        rows = fast_integers([primitive(row) for row in matrix])
    pivots: list[int] = []
    if rows and rows[0] and (by_flint or not isinstance(rows[0][0], int)):
        from flint import fmpz_mat

        whole, common, count = fmpz_mat(rows).rref()
        rows = [list(map(int, row)) for row in whole.tolist()]
        pivots = [next(j for j, x in enumerate(row) if x) for row in rows[:count]]
        return rows, pivots, int(common)
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
