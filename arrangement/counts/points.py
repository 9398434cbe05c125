"""Characteristic polynomials by counting points over finite fields: no flat is ever computed.

For a prime q of good reduction, chi(q) is the number of points of F_q^d on none of the planes, read
modulo q [CrapoRota1970], [Athanasiadis1996]. As chi has degree d and begins with t^d, d such
numbers determine it.

Reduction is good when planes meet modulo q as they do over the reals. With the vectors (n, b)
of the planes and infinity (0, ..., 0, 1), that is: every basis of their span stays independent.
Then so does every independent set, which some basis contains, and no set becomes independent.

Modulo any q, prime or not, the points of (Z/q)^d off rational central planes are counted by a
quasi-polynomial in q, which is chi where no minor has a divisor in common with q.

Entries in a field Q(a) are reduced modulo primes q at which the minimal polynomial of a has a root
in F_q, which stands for a: integral vectors are over Z[a], which F_q is then an image of.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations, count, islice
from math import comb, gcd, lcm
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.coefficients import Integers
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
    return _interpolated(arrangement, chosen)


def characteristic_quasi_polynomial(arrangement: Planes) -> dict[int, sympy.Poly]:
    """Return a polynomial for each divisor g of the period: it counts the points off the planes.

    There are f_g(q) points of (Z/q)^d on none of the planes, where g = gcd(q, period). The period,
    the largest key, is the least common multiple of the largest elementary divisors of the bases.
    f_1 is the characteristic polynomial.

    Raises:
        InputError: planes that miss the origin, or with irrational entries.
        OutOfReachError: too many bases or points.

    Source: H. Kamiya, A. Takemura, H. Terao, Periodicity of hyperplane arrangements with integral
    coefficients modulo positive integers, Journal of Algebraic Combinatorics 27 (2008).

    >>> from arrangement.library import families
    >>> found = characteristic_quasi_polynomial(families.type_b(2))
    >>> [(g, f.as_expr().factor()) for g, f in found.items()]
    [(1, (t - 3)*(t - 1)), (2, (t - 2)**2)]
    """
    from sympy import ZZ, divisors
    from sympy.polys.matrices import DM
    from sympy.polys.matrices.normalforms import invariant_factors

    if not arrangement.is_central or arrangement.field is not None:
        raise InputError(
            f"{arrangement!r} has no quasi-polynomial here; give rational planes through the origin"
        )
    period = 1
    for _, planes in _minors(arrangement):
        rows = [arrangement.integer_planes[i][:-1] for i in planes]
        period = lcm(period, int(invariant_factors(DM(rows, ZZ))[-1]))
    needed = max(1, arrangement.dimension)
    found: dict[int, sympy.Poly] = {}
    for g in map(int, divisors(period)):
        moduli = islice((q for q in count(g, g) if gcd(q, period) == g), needed)
        found[g] = _interpolated(arrangement, moduli)
    return found


def _interpolated(arrangement: Planes, moduli: Iterable[int]) -> sympy.Poly:
    """Return the polynomial of degree d, beginning with t^d, that counts points for d moduli."""
    import sympy

    t, d = sympy.Symbol("t"), arrangement.dimension
    values = {q: points_off(arrangement, q) - q**d for q in moduli}
    rest = sympy.Poly(sympy.interpolate(list(values.items()), t), t)
    return sympy.Poly(rest + sympy.Poly(t**d, t), t, domain=sympy.ZZ)


def points_off(arrangement: Planes, q: int) -> int:
    """Return the number of points of (Z/q)^d on none of the planes, whatever the reduction.

    Along each line in the last direction, the points on planes are counted.

    Args:
        q: an integer of at least 1; for entries in a field a prime.

    Raises:
        InputError: another number, or one that is too large, or has no image of the field.

    >>> from arrangement import Arrangement
    >>> lines = Arrangement([[1, 0], [0, 1], [1, 1]])
    >>> points_off(lines, 5), points_off(lines, 6)
    (12, 20)
    """
    d = arrangement.dimension
    if arrangement.field is not None:
        _check_prime(q, arrangement)
    elif type(q) is not int or q < 1:
        raise InputError(f"q is {shown(q)}; give an integer, at least 1")
    if not d:
        return 1
    if d * q**2 >= 1 << 63:
        raise InputError(f"{q} is too large for words of 64 bits in dimension {d}")
    planes = np.array(residues(arrangement.integer_planes, q), np.int64).reshape(-1, d + 1)
    along, across = planes[planes[:, d - 1] == 0], planes[planes[:, d - 1] != 0]
    divisors = np.gcd(across[:, d - 1], q)
    columns = len(along) + int(divisors.sum())
    budget.check_cost(
        f"the points of (Z/{q})^{d} off {len(arrangement)} planes",
        "use characteristic_polynomial",
        steps=budget.power(q, d - 1) * max(1, columns) / 10,
    )
    powers = q ** np.arange(d - 1)
    step = max(1, _CHUNK // max(1, columns))
    found = 0
    for first in range(0, q ** (d - 1), step):
        numbers = np.arange(first, min(first + step, q ** (d - 1)))
        points = numbers[:, None] // powers % q
        on = ((points @ along[:, : d - 1].T - along[:, d]) % q == 0).any(axis=1)
        points = points[~on]
        hits = [_hits(points, across[divisors == g], q, int(g)) for g in np.unique(divisors)]
        hit = np.sort(np.hstack([np.full((len(points), 1), q), *hits]), axis=1)
        found += q * len(points) - int((hit[:, 1:] != hit[:, :-1]).sum())
    return found


def _hits(points: Integers, planes: Integers, q: int, divisor: int) -> Integers:
    """Return where lines in the last direction meet planes: columns of numbers below q, or q.

    Args:
        planes: whose last coefficient has this greatest common divisor with q.
    """
    d, part = points.shape[1] + 1, q // divisor
    inverse = np.array([pow(int(x) // divisor, -1, part) for x in planes[:, d - 1]], dtype=np.int64)
    sums = (planes[:, d] - points @ planes[:, : d - 1].T) % q
    place = sums // divisor * inverse % part
    meets = sums % divisor == 0
    return np.hstack([np.where(meets, place + k * part, q) for k in range(divisor)])


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
