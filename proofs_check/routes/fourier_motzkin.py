"""Fourier-Motzkin elimination over integers: linear systems decided without any solver.

Source: A. Schrijver, Theory of Linear and Integer Programming (1986), section 12.2. Exponential in
the number of variables left after the equalities are used; here that is at most four.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import product
from typing import TypeAlias

#: Coefficients, then a constant: the linear form ``row . (x, 1)``.
Row: TypeAlias = tuple[Fraction, ...]
#: The same, as coprime integers.
Whole: TypeAlias = tuple[int, ...]


def project(
    equalities: Sequence[Sequence[Fraction | int]], inequalities: Sequence[Row], keep: int
) -> list[Whole] | None:
    """Eliminate all variables but number `keep` (-1 keeps none).

    Returns:
        The inequalities that remain, or None when there is no solution.
    """
    rows = [_whole(row) for row in inequalities]
    left = [_whole(row) for row in equalities]
    variables = range(len([*left, *rows][0]) - 1 if left or rows else 0)
    for j in variables:
        pivot = next((row for row in left if row[j]), None) if j != keep else None
        if pivot is not None:
            left = [_cancelled(row, pivot, j) for row in left if row is not pivot]
            rows = [_cancelled(row, pivot, j) for row in rows]
    rows += [way for row in left for way in (row, tuple([-x for x in row]))]
    for j in variables:
        if j != keep:
            rows = _eliminated(rows, j)
        if any(row[-1] < 0 and not any(row[:-1]) for row in rows):
            return None
    return [row for row in rows if any(row[:-1])]


def _eliminated(rows: Iterable[Whole], j: int) -> list[Whole]:
    """One step of Fourier-Motzkin elimination; equal rows are kept once."""
    groups: dict[int, list[Whole]] = {-1: [], 0: [], 1: []}
    for row in dict.fromkeys(rows):
        groups[(row[j] > 0) - (row[j] < 0)].append(row)
    pairs = (
        _reduced([a * -down[j] + b * up[j] for a, b in zip(up, down, strict=True)])
        for up, down in product(groups[1], groups[-1])
    )
    return list(dict.fromkeys([*groups[0], *pairs]))


def _cancelled(row: Whole, pivot: Whole, j: int) -> Whole:
    """Return a positive multiple of the row minus the multiple of an equality that cancels j."""
    if not row[j]:
        return row
    p, r = abs(pivot[j]), row[j] if pivot[j] > 0 else -row[j]
    return _reduced([a * p - b * r for a, b in zip(row, pivot, strict=True)])


def _whole(row: Sequence[Fraction | int]) -> Whole:
    """Return a positive multiple with coprime integer entries."""
    scale = math.lcm(*[x.denominator for x in row])
    return _reduced([x.numerator * (scale // x.denominator) for x in row])


def _reduced(row: Sequence[int]) -> Whole:
    divisor = math.gcd(*row)
    return tuple(row) if divisor <= 1 else tuple([x // divisor for x in row])
