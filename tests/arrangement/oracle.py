"""Brute force for arrangements: sign vectors, counts and ranks, by ways that no engine takes.

* `sign_vectors`: tried one by one, by Fourier-Motzkin elimination; any dimension, few planes.
* `by_subsets`, `points_by_hand`: the characteristic polynomial by subset sums, and its values by
  points over a finite field.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, product

import sympy
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from arrangement import Arrangement

Row = tuple[Fraction, ...]
T = sympy.Symbol("t")


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
    equal, positive = shadow(equal, positive, unknowns)
    return all(row[-1] == 0 for row in equal) and all(row[-1] > 0 for row in positive)


def shadow(equal: list[Row], positive: list[Row], unknowns: int) -> tuple[list[Row], list[Row]]:
    """Return what conditions on the first unknowns leave for the others (Fourier and Motzkin).

    It makes no difference whether the inequalities are strict.
    """
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
    return equal, positive


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


def by_subsets(planes: Arrangement) -> sympy.Poly:
    """Return chi by Whitney's theorem: sum of (-1)^|S| t^(d - rank S) over central subsets S."""
    terms = sympy.Poly(0, T, domain=sympy.ZZ)
    for normals, augmented in _subsets(planes):
        if rank(normals) == rank(augmented):
            power = planes.dimension - rank(normals)
            terms += (-1) ** len(normals) * sympy.Poly(T**power, T, domain=sympy.ZZ)
    return terms


def points_by_hand(planes: Arrangement, prime: int) -> int:
    """Return the number of points of F_p^d on none of the planes, one by one."""
    return sum(
        all(
            (sum(a * x for a, x in zip(plane, point, strict=False)) - plane[-1]) % prime
            for plane in planes.integer_planes
        )
        for point in product(range(prime), repeat=planes.dimension)
    )


def _subsets(
    planes: Arrangement,
) -> Iterator[tuple[list[tuple[Fraction, ...]], list[tuple[Fraction, ...]]]]:
    rows = [(n, (*n, b)) for n, b in zip(planes.normals, planes.offsets, strict=True)]
    for size in range(len(rows) + 1):
        for chosen in combinations(rows, size):
            yield [normal for normal, _ in chosen], [plane for _, plane in chosen]
