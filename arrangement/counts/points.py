"""Characteristic polynomials by counting points over finite fields: no flat is ever computed.

For a prime q of good reduction, chi(q) is the number of points of F_q^d on none of the planes, read
modulo q [CrapoRota1970], [Athanasiadis1996]. As chi has degree d and begins with t^d, d such
numbers determine it.

Reduction is good when planes meet modulo q as they do over the rationals. With the vectors (n, b)
of the planes and infinity (0, ..., 0, 1), that is: every basis of their span stays independent.
Then so does every independent set, which some basis contains, and no set becomes independent.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations, count, islice
from math import comb, gcd
from typing import TYPE_CHECKING

import numpy as np

from arrangement.errors import InputError
from arrangement.exact import IntegerVector, shown
from arrangement.linear import determinant, rank
from arrangement.planes import Planes

if TYPE_CHECKING:
    import sympy

#: Sets of planes that are tested, and pairs of a line and a plane, at most.
MAX_SETS, MAX_PAIRS = 10**6, 10**10
_CHUNK = 1 << 20


def by_points(arrangement: Planes, primes: Iterable[int] | None = None) -> sympy.Poly:
    """Return the characteristic polynomial from numbers of points over finite fields.

    It shares nothing with `characteristic_polynomial`, and suits few planes in low dimension.

    Args:
        primes: d or more different primes of good reduction; if omitted, the smallest d.

    Raises:
        InputError: a number that is no prime, a prime of bad reduction, too few primes, or planes
            that are too many.

    Complexity: C(m + 1, r) determinants for m planes of rank r (of the cone, if affine), and
    q^(d-1) m log m operations for each prime q.

    Source: [CrapoRota1970], section 16; [Athanasiadis1996], theorem 2.2.

    >>> from arrangement.library import families
    >>> by_points(families.shi(3), [5, 7, 11])
    Poly(t**3 - 6*t**2 + 9*t, t, domain='ZZ')
    """
    import sympy

    t = sympy.Symbol("t")
    d = arrangement.dimension
    needed = max(1, d)
    minors = list(_minors(arrangement))
    if primes is None:
        good = (q for q in map(int, map(sympy.prime, count(1))) if all(g % q for g, _ in minors))
        chosen = list(islice(good, needed))
    else:
        chosen = sorted({_checked(q, minors) for q in primes})
    if len(chosen) < needed:
        raise InputError(f"there are {len(chosen)} different primes; give at least {needed}")
    values = {q: points_off(arrangement, q) - q**d for q in chosen}
    rest = sympy.Poly(sympy.interpolate(list(values.items()), t), t)
    return sympy.Poly(rest + sympy.Poly(t**d, t), t, domain=sympy.ZZ)


def points_off(arrangement: Planes, prime: int) -> int:
    """Return the number of points of F_q^d on none of the planes, whatever the reduction.

    Along each line in the last direction, the points on planes are counted.

    Raises:
        InputError: a number that is no prime, or too large.

    >>> from arrangement import Arrangement
    >>> points_off(Arrangement([[1, 0], [0, 1], [1, 1]]), 5)
    12
    """
    d = arrangement.dimension
    _check_prime(prime)
    if arrangement.field is not None:
        raise InputError(
            f"the planes have entries in {arrangement.field!r}; points over finite fields are "
            "counted for rational planes, so use characteristic_polynomial"
        )
    if not d:
        return 1
    if prime ** (d - 1) * max(1, len(arrangement)) > MAX_PAIRS or d * prime**2 >= 1 << 63:
        raise InputError(
            f"{len(arrangement)} planes modulo {prime} in dimension {d} take too many steps; "
            "use characteristic_polynomial"
        )
    planes = np.array([[x % prime for x in row] for row in arrangement.integer_planes])
    planes = planes.reshape(-1, d + 1)
    along, across = planes[planes[:, d - 1] == 0], planes[planes[:, d - 1] != 0]
    scale = np.array([pow(int(x), -1, prime) for x in across[:, d - 1]], dtype=np.int64)
    across = across * scale[:, None] % prime
    powers = prime ** np.arange(d - 1)
    step = max(1, _CHUNK // max(1, len(planes)))
    found = 0
    for first in range(0, prime ** (d - 1), step):
        numbers = np.arange(first, min(first + step, prime ** (d - 1)))
        points = numbers[:, None] // powers % prime
        on = ((points @ along[:, : d - 1].T - along[:, d]) % prime == 0).any(axis=1)
        points = points[~on]
        hit = np.sort((across[:, d] - points @ across[:, : d - 1].T) % prime, axis=1)
        different = (hit[:, 1:] != hit[:, :-1]).sum() + (len(hit) if len(across) else 0)
        found += prime * len(points) - int(different)
    return found


def _minors(arrangement: Planes) -> Iterator[tuple[int, tuple[int, ...]]]:
    """Yield for each basis, as indices of planes, the divisor of all its minors of full order."""
    rows: list[IntegerVector] = [arrangement.integer_planes[p[0]] for p in arrangement.distinct]
    if not arrangement.is_central:
        rows.append((0,) * arrangement.dimension + (1,))
    order = rank(rows)
    if arrangement.field is not None:
        raise InputError(
            f"the planes have entries in {arrangement.field!r}; points over finite fields are "
            "counted for rational planes, so use characteristic_polynomial"
        )
    if comb(len(rows), order) > MAX_SETS:
        raise InputError(
            f"{len(arrangement)} planes of rank {arrangement.rank} have over {MAX_SETS} bases to "
            "test; use characteristic_polynomial"
        )
    columns = [c for c in range(arrangement.dimension + 1) if any(row[c] for row in rows)]
    for chosen in combinations(range(len(rows)), order):
        divisor = 0
        for kept in combinations(columns, order):
            divisor = gcd(divisor, determinant([[rows[i][c] for c in kept] for i in chosen]))
            if divisor == 1:
                break
        if divisor > 1:
            yield (
                divisor,
                tuple(arrangement.distinct[i][0] for i in chosen if i < len(arrangement.distinct)),
            )


def _checked(q: int, minors: list[tuple[int, tuple[int, ...]]]) -> int:
    """Return a prime of good reduction, or refuse the number."""
    _check_prime(q)
    for divisor, planes in minors:
        if divisor % q == 0:
            raise InputError(
                f"{q} is a prime of bad reduction: modulo {q} the planes {list(planes)} meet "
                "otherwise than over the rationals; leave it out"
            )
    return q


def _check_prime(q: int) -> None:
    from sympy import isprime

    if type(q) is not int or not isprime(q):
        raise InputError(f"{shown(q)} is no prime; give prime numbers")
