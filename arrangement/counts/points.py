"""Characteristic polynomials by counting points over finite fields: no flat is ever computed.

For a prime q of good reduction, chi(q) is the number of points of F_q^d on none of the planes, read
modulo q [CrapoRota1970], [Athanasiadis1996]. As chi has degree d and begins with t^d, d such
numbers determine it.

Reduction is good when planes meet modulo q as they do over the reals. With the vectors (n, b)
of the planes and infinity (0, ..., 0, 1), that is: every basis of their span stays independent.
Then so does every independent set, which some basis contains, and no set becomes independent.

Entries in a field Q(a) are reduced modulo primes q at which the minimal polynomial of a has a root
in F_q, which stands for a: integral vectors are over Z[a], which F_q is then an image of.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations, count, islice
from math import comb, gcd
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, shown
from arrangement.numbers.linear.rank import determinant, rank
from arrangement.numbers.real import residues
from arrangement.planes.planes import Planes

if TYPE_CHECKING:
    import sympy

_CHUNK = 1 << 20


def by_points(arrangement: Planes, primes: Iterable[int] | None = None) -> sympy.Poly:
    """Return the characteristic polynomial from numbers of points over finite fields.

    It shares nothing with `characteristic_polynomial`, and suits few planes in low dimension.

    Args:
        primes: d or more different primes of good reduction; if omitted, the smallest d.

    Raises:
        InputError: a number that is not a prime, a prime of bad reduction or without an image of
            the field of the entries, too few primes, or planes that are too many.

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
        usable = (q for q in map(int, map(sympy.prime, count(1))) if _has_image(arrangement, q))
        good = (q for q in usable if not any(_vanish(g, q) for g, _ in minors))
        chosen = list(islice(good, needed))
    else:
        chosen = sorted({_checked(q, arrangement, minors) for q in primes})
    if len(chosen) < needed:
        raise InputError(f"there are {len(chosen)} different primes; give at least {needed}")
    values = {q: points_off(arrangement, q) - q**d for q in chosen}
    rest = sympy.Poly(sympy.interpolate(list(values.items()), t), t)
    return sympy.Poly(rest + sympy.Poly(t**d, t), t, domain=sympy.ZZ)


def points_off(arrangement: Planes, prime: int) -> int:
    """Return the number of points of F_q^d on none of the planes, whatever the reduction.

    Along each line in the last direction, the points on planes are counted.

    Raises:
        InputError: a number that is not a prime, or too large, or has no image of the field.

    >>> from arrangement import Arrangement
    >>> points_off(Arrangement([[1, 0], [0, 1], [1, 1]]), 5)
    12
    """
    d = arrangement.dimension
    _check_prime(prime, arrangement)
    if not d:
        return 1
    if d * prime**2 >= 1 << 63:
        raise InputError(f"{prime} is too large for words of 64 bits in dimension {d}")
    budget.check_cost(
        f"the points of F_{prime}^{d} off {len(arrangement)} planes",
        "use characteristic_polynomial",
        steps=budget.power(prime, d - 1) * max(1, len(arrangement)) / 10,
    )
    planes = np.array(residues(arrangement.integer_planes, prime)).reshape(-1, d + 1)
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


def _minors(arrangement: Planes) -> Iterator[tuple[list[Any], tuple[int, ...]]]:
    """Yield for each basis, as indices of planes, the minors of full order.

    Rational ones are given as their divisor, and bases left out where that is 1.
    """
    rows: list[IntegerVector] = [arrangement.integer_planes[p[0]] for p in arrangement.distinct]
    if not arrangement.is_central:
        rows.append((0,) * arrangement.dimension + (1,))
    order = rank(rows)
    budget.check_cost(
        f"a test of the bases of {len(arrangement)} planes of rank {arrangement.rank}",
        "use characteristic_polynomial",
        steps=4 * comb(len(rows), order) * (order + 2) ** 3,
    )
    columns = [c for c in range(arrangement.dimension + 1) if any(row[c] for row in rows)]
    for chosen in combinations(range(len(rows)), order):
        divisor, others = 0, []
        for kept in combinations(columns, order):
            minor: Any = determinant([[rows[i][c] for c in kept] for i in chosen])
            if isinstance(minor, int):
                divisor = gcd(divisor, minor)
            else:
                others.append(minor)
            if divisor == 1:
                break
        if divisor > 1 or others:
            planes = [arrangement.firsts[i] for i in chosen if i < len(arrangement.firsts)]
            yield [divisor, *others], tuple(planes)


def _vanish(minors: list[Any], q: int) -> bool:
    return not any(residues([minors], q)[0])


def _has_image(arrangement: Planes, q: int) -> bool:
    return arrangement.field is None or arrangement.field.root_modulo(q) is not None


def _checked(q: int, arrangement: Planes, minors: list[tuple[list[Any], tuple[int, ...]]]) -> int:
    """Return a prime of good reduction, or refuse the number."""
    _check_prime(q, arrangement)
    for divisors, planes in minors:
        if _vanish(divisors, q):
            raise InputError(
                f"{q} is a prime of bad reduction: modulo {q} the planes {list(planes)} meet "
                "otherwise than over the reals; leave it out"
            )
    return q


def _check_prime(q: int, arrangement: Planes) -> None:
    from sympy import isprime

    if type(q) is not int or not isprime(q):
        raise InputError(f"{shown(q)} is not a prime; give prime numbers")
    if not _has_image(arrangement, q):
        raise InputError(
            f"the entries in {arrangement.field!r} have no image modulo {q}: the polynomial has no "
            "root there; give other primes, or none"
        )
