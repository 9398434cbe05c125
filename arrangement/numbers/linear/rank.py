"""Small exact linear algebra on integer vectors: rank, elimination and determinants.

Large matrices and long integers are eliminated by FLINT. Small ones are eliminated here, without
fractions, as are those with irrational entries: most commands need no others, and FLINT's import
takes as long as some thousand of them.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from fractions import Fraction
from typing import Any, TypeVar

from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, dot, largest, reduced, without_denominators

_Item = TypeVar("_Item")
#: Elimination in matrices with fewer entries is not forecast.
_FEW_ENTRIES = 2000
#: FLINT is faster from five rows on.
_FLINT_ENTRIES = 36
_FLINT_SIZE = 2**250


def rank(rows: Sequence[Sequence[int]]) -> int:
    """Return the rank of a matrix, given by its rows.

    Of many rows a sample comes first: where its rank is the number of columns, that is the rank.
    """
    if not len(rows):
        return 0
    width = len(rows[0])
    sample = evenly_spaced(rows, 2 * width)
    if len(sample) < len(rows) and rank(sample) == width:
        return width
    ask_elimination(rows, width)
    matrix = None if len(rows) * width < _FLINT_ENTRIES else _flint_matrix(rows)
    return len(_eliminate(rows, reduced=False)[1]) if matrix is None else int(matrix.rank())


def _flint_matrix(rows: Sequence[Sequence[Any]]) -> Any:
    """Return a matrix of FLINT; None if an entry is irrational."""
    from flint import fmpz_mat

    try:
        return fmpz_mat(list(map(list, rows)))
    except TypeError:
        return None


def evenly_spaced(rows: Sequence[_Item], few: int) -> Sequence[_Item]:
    """Return at most a given number of the rows, at equal distances."""
    return rows[:: max(1, -(-len(rows) // few))]


def ask_elimination(rows: Sequence[Sequence[Any]], width: int) -> None:
    """Refuse to eliminate in a matrix that is too large for it; few entries stay few."""
    if len(rows) * width <= _FEW_ENTRIES:
        return
    filled = sum(1 for row in rows for x in row if x)
    order = min(width, len(rows))
    digits = 1 + order * int(largest(rows)).bit_length() / 2000 if largest(rows) < math.inf else 20
    budget.check_cost(
        f"elimination in a matrix of {len(rows)} rows with {width} entries",
        "leave out planes or coordinates",
        steps=6 * digits * filled**2 * order / max(1, len(rows) * width),
    )


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
    """Return the determinant of a square exact matrix.

    >>> determinant([[2, 1], [1, 3]])
    5
    """
    matrix = _flint_matrix(rows)
    if matrix is not None:
        return int(matrix.det())
    _, pivots, scale = _eliminate(rows, reduced=False)
    return scale if len(pivots) == len(rows) else 0


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


def gauss_jordan(matrix: Sequence[Sequence[Any]]) -> tuple[list[list[Any]], list[int], Any]:
    """Return the reduced rows times a common scale, the pivot columns, and the scale.

    Row i of the result has its pivot, of the value `scale`, in column ``pivots[i]``; rows beyond
    the pivots are zero. Rows of the input are scaled to integers first, which changes no solution.
    """
    rows: list[Any] = [without_denominators(row) for row in matrix]
    small = not rows or (len(rows) * len(rows[0]) < _FLINT_ENTRIES and largest(rows) < _FLINT_SIZE)
    whole = None if small else _flint_matrix(rows)
    if whole is None:
        return _eliminate(rows)
    whole, scale, count = whole.rref()
    rows = [list(map(int, row)) for row in whole.tolist()]
    return rows, [next(j for j, x in enumerate(row) if x) for row in rows[:count]], int(scale)


def null_space(rows: Sequence[Sequence[Any]], n: int) -> list[tuple[Fraction, ...]]:
    """Return a basis of the vectors of n entries at which all rows are 0."""
    reduced, pivots, scale = gauss_jordan([list(row) for row in rows])
    basis = []
    for j in range(n):
        if j not in pivots:
            vector = [Fraction(int(k == j)) for k in range(n)]
            for row, pivot in zip(reduced, pivots, strict=False):
                vector[pivot] = Fraction(-row[j], scale)
            basis.append(tuple(vector))
    return basis


def _eliminate(
    matrix: Sequence[Sequence[Any]], *, reduced: bool = True
) -> tuple[list[list[Any]], list[int], Any]:
    """Eliminate as `gauss_jordan` does; of an invertible matrix the scale is its determinant.

    Every division is exact, and every intermediate number is a minor of the matrix.
    Source: E. Bareiss, Math. Comp. 22 (1968).

    Args:
        reduced: if not, what stands above, below and left of the pivots stays.
    """
    rows: list[list[Any]] = [list(row) for row in matrix]
    pivots: list[int] = []
    scale: Any = 1
    for column in range(len(rows[0]) if rows else 0):
        done = len(pivots)
        swap = next((i for i in range(done, len(rows)) if rows[i][column]), None)
        if swap is None:
            continue
        if swap != done:
            rows[done], rows[swap] = rows[swap], [-x for x in rows[done]]
        pivot, first = rows[done][column], 0 if reduced else column + 1
        top = rows[done][first:]
        for i in range(0 if reduced else done + 1, len(rows)):
            if i != done:
                factor, pairs = rows[i][column], zip(rows[i][first:], top, strict=True)
                rows[i][first:] = (
                    [(pivot * a - factor * b) // scale for a, b in pairs]
                    if done
                    else [pivot * a - factor * b for a, b in pairs]
                )
        scale = pivot
        pivots.append(column)
    return rows, pivots, scale
