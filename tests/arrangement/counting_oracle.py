"""Two independent ways to the characteristic polynomial: subset sums and points over a field."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, product

import numpy as np
import sympy

from arrangement import Arrangement

from .oracle import rank

T = sympy.Symbol("t")


def by_subsets(planes: Arrangement) -> sympy.Poly:
    """Return chi by Whitney's theorem: sum of (-1)^|S| t^(d - rank S) over central subsets S."""
    terms = sympy.Poly(0, T, domain=sympy.ZZ)
    for normals, augmented in _subsets(planes):
        if rank(normals) == rank(augmented):
            power = planes.dimension - rank(normals)
            terms += (-1) ** len(normals) * sympy.Poly(T**power, T, domain=sympy.ZZ)
    return terms


def points_off_all_planes(planes: Arrangement, prime: int) -> int:
    """Return the number of points of F_p^d on none of the planes.

    Equal to chi(p) when p is larger than every minor of the planes. Source: C. Athanasiadis,
    Characteristic polynomials of subspace arrangements and finite fields, Advances in
    Mathematics 122 (1996), theorem 2.2.
    """
    axes = [np.arange(prime, dtype=np.int64)] * planes.dimension
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, planes.dimension)
    free = np.ones(len(points), dtype=bool)
    for plane in planes.integer_planes:
        free &= (points @ np.array(plane[:-1]) - plane[-1]) % prime != 0
    return int(free.sum())


def points_by_hand(planes: Arrangement, prime: int) -> int:
    """Return the same number without numpy, for the check of the oracle itself."""
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
