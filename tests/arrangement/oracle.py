"""Brute force: which sign vectors can be realised, by Fourier-Motzkin elimination.

Shares no code and no idea with the engine: sign vectors are tried one by one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from arrangement import Arrangement

Row = tuple[Fraction, ...]


def sign_vectors(arrangement: Arrangement) -> set[tuple[int, ...]]:
    """Return all sign vectors that occur, by trying all that extend a possible prefix."""
    return set(_extensions(arrangement, ()))


def _extensions(arrangement: Arrangement, prefix: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
    if not realisable(arrangement, prefix):
        return
    if len(prefix) == len(arrangement):
        yield prefix
        return
    for sign in (-1, 0, 1):
        yield from _extensions(arrangement, (*prefix, sign))


def realisable(arrangement: Arrangement, signs: Sequence[int]) -> bool:
    """Decide whether some point has these signs for the first planes."""
    equal, positive = [], []
    for sign, normal, offset in zip(signs, arrangement.normals, arrangement.offsets, strict=False):
        if sign == 0:
            equal.append((*normal, -offset))
        else:
            positive.append(tuple(sign * x for x in (*normal, -offset)))
    return satisfiable(equal, positive, arrangement.dimension)


def satisfiable(equal: list[Row], positive: list[Row], unknowns: int) -> bool:
    """Decide ``a . x + b = 0`` for rows of `equal` and ``a . x + b > 0`` for rows of `positive`."""
    for j in range(unknowns):
        pivot = next((row for row in equal if row[j]), None)
        if pivot is not None:
            equal = [_without(row, pivot, j) for row in equal if row is not pivot]
            positive = [_without(row, pivot, j) for row in positive]
            continue
        lower = [row for row in positive if row[j] > 0]
        upper = [row for row in positive if row[j] < 0]
        rest = [row for row in positive if row[j] == 0]
        pairs = (
            tuple(a / low[j] - b / high[j] for a, b in zip(low, high, strict=True))
            for low in lower
            for high in upper
        )
        positive = list({_scaled(row) for row in (*rest, *pairs)})
    return all(row[-1] == 0 for row in equal) and all(row[-1] > 0 for row in positive)


def _without(row: Row, pivot: Row, j: int) -> Row:
    factor = row[j] / pivot[j]
    return tuple(a - factor * b for a, b in zip(row, pivot, strict=True))


def _scaled(row: Row) -> Row:
    size = max(map(abs, row))
    return tuple(x / size for x in row) if size else row


def rank(rows: Sequence[Sequence[Fraction]]) -> int:
    """Return the rank of rational rows, by SymPy."""
    if not rows:
        return 0
    entries = [[QQ(x.numerator, x.denominator) for x in row] for row in rows]
    return int(DomainMatrix(entries, (len(rows), len(rows[0])), QQ).rank())
