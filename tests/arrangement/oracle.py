"""Brute force for arrangements: sign vectors, counts and ranks, by ways that no engine takes.

* `sign_vectors`: tried one by one, by the elimination of the claims' second route; few planes.
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
from proofs_check.routes.oracle import project

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


def regions_inside(arrangement: Arrangement, sides: Arrangement) -> set[tuple[int, ...]]:
    """Return the sign vectors of the regions that meet the positive side of all of some planes."""
    joined = Arrangement(
        [*sides.normals, *arrangement.normals],
        [*sides.offsets, *arrangement.offsets],
        dimension=arrangement.dimension,
    )
    found = [(1,) * len(sides)] if realisable(joined, (1,) * len(sides)) else []
    for _ in range(len(arrangement)):
        longer = ((*prefix, sign) for prefix in found for sign in (-1, 1))
        found = [signs for signs in longer if realisable(joined, signs)]
    return {signs[len(sides) :] for signs in found}


def realisable(arrangement: Arrangement, signs: Sequence[int]) -> bool:
    """Decide whether some point has these signs for the first planes.

    It has coordinates ``x / h``; what is above 0 there is at least 1 for large multiples of both.
    """
    equal = []
    positive = [(*[0] * arrangement.dimension, 1, -1)]
    for sign, normal, offset in zip(signs, arrangement.normals, arrangement.offsets, strict=False):
        row = (*normal, -offset)
        if sign == 0:
            equal.append((*row, 0))
        else:
            positive.append((*(sign * x for x in row), -1))
    return project(equal, positive, keep=-1) is not None


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
