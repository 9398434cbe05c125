"""Characteristic polynomials by counting points over finite fields: no flat is ever computed.

For a prime q of good reduction, chi(q) is the number of points of F_q^d on none of the planes, read
modulo q [CrapoRota1970], [Athanasiadis1996]. As chi has degree d and begins with t^d, d such
numbers determine it.

Reduction is good when planes meet modulo q as they do over the reals. With the vectors (n, b)
of the planes and infinity (0, ..., 0, 1), that is: every basis of their span stays independent.
Then so does every independent set, which some basis contains, and no set becomes independent.

Modulo any q, prime or not, the points of (Z/q)^d off rational central planes are counted by a
quasi-polynomial in q, which is chi where no minor has a divisor in common with q. Each of its
polynomials is made by itself, in the cheaper of two ways:

1. From sets: where the planes of a set J, as rows, have the elementary divisors e_1, ..., e_r,
   their intersection has q^(d - r) gcd(e_1, q) ... gcd(e_r, q) points modulo q. Inclusion and
   exclusion over all J gives the points off the planes. Each e divides the period, so with g the
   greatest common divisor of q and the period, gcd(e, q) = gcd(e, g).
2. From points: d moduli with the same g, whose points are counted, determine a polynomial that
   begins with t^d.

Entries in a field Q(a) are reduced modulo primes q at which the minimal polynomial of a has a root
in F_q, which stands for a: integral vectors are over Z[a], which F_q is then an image of.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import combinations, count, islice, product
from math import comb, gcd, inf, lcm, prod
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
#: Sums below are exact in words of 64 bits.
_MAX_WORD = 1 << 63
#: Steps to the elementary divisors of one matrix.
_DIVISORS_STEPS = 10_000
#: Steps and bytes of one polynomial.
_POLYNOMIAL_STEPS = 2_000
_POLYNOMIAL_BYTES = 2_000


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
        chosen = sorted({_check_q(q, arrangement, minors) for q in primes})
    if len(chosen) < needed:
        raise InputError(f"there are {len(chosen)} different primes; give at least {needed}")
    return _interpolate(arrangement, chosen)


def characteristic_quasi_polynomial(arrangement: Planes) -> QuasiPolynomial:
    """Return the quasi-polynomial that counts the points of (Z/q)^d off the planes.

    Raises:
        InputError: planes that miss the origin, or with irrational entries.
        OutOfReachError: too many bases.

    Source: H. Kamiya, A. Takemura, H. Terao, Periodicity of hyperplane arrangements with integral
    coefficients modulo positive integers, Journal of Algebraic Combinatorics 27 (2008).

    >>> from arrangement.library import families
    >>> found = characteristic_quasi_polynomial(families.type_b(2))
    >>> [(g, f.as_expr().factor()) for g, f in found.items()]
    [(1, (t - 3)*(t - 1)), (2, (t - 2)**2)]
    """
    if not arrangement.is_central or arrangement.field is not None:
        raise InputError(
            f"{arrangement!r} has no quasi-polynomial here; give rational planes through the origin"
        )
    bases = ([arrangement.integer_planes[i][:-1] for i in b] for _, b in _minors(arrangement))
    return QuasiPolynomial(arrangement, {_elementary_divisors(rows)[-1] for rows in bases})


class QuasiPolynomial(Mapping[int, "sympy.Poly"]):
    """The numbers of points of (Z/q)^d off some planes: polynomials, by the divisors of the period.

    There are ``f[gcd(q, f.period)].eval(q)`` points, which is ``f(q)``; ``f[1]`` is the
    characteristic polynomial. A polynomial is made when it is looked up. A loop over the divisors
    factors the period first, which may have too many of them.

    Attributes:
        period: the least common multiple of the largest elementary divisors of the bases.
    """

    def __init__(self, arrangement: Planes, divisors: set[int]) -> None:
        self._arrangement = arrangement
        self._divisors = divisors
        self.period = lcm(*divisors)
        self._made: dict[int, sympy.Poly] = {}

    def __repr__(self) -> str:
        return f"<quasi-polynomial of {self._arrangement!r}, period {shown(self.period)}>"

    def __call__(self, q: int) -> int:
        """Return the number of points of (Z/q)^d off the planes.

        Raises:
            InputError: q is not an integer of at least 1.
            OutOfReachError: see `__getitem__`.
        """
        if type(q) is not int or q < 1:
            raise InputError(f"q is {shown(q)}; give an integer, at least 1")
        return int(self[gcd(q, self.period)].eval(q))

    def __getitem__(self, g: int) -> sympy.Poly:
        """Return the polynomial for all q with gcd(q, period) = g.

        Raises:
            KeyError: g does not divide the period.
            OutOfReachError: too many sets of planes, and too many points.
        """
        if type(g) is not int or g < 1 or self.period % g:
            raise KeyError(g)
        if g not in self._made:
            self._made[g] = self._polynomial(g)
        return self._made[g]

    def __len__(self) -> int:
        return prod(power + 1 for power in self._factors.values())

    def __iter__(self) -> Iterator[int]:
        """Iterate over the divisors of the period, in order.

        Raises:
            OutOfReachError: they are too many, or the period is too long to be factored.
        """
        number = len(self)
        budget.check_cost(
            f"the {budget.about(number)} polynomials of {self!r}",
            "look up those that you need, f[g] or f(q)",
            steps=_POLYNOMIAL_STEPS * number,
            bytes=_POLYNOMIAL_BYTES * number,
        )
        powers = ([p**k for k in range(n + 1)] for p, n in self._factors.items())
        return iter(sorted(map(prod, product(*powers))))

    @cached_property
    def _factors(self) -> dict[int, int]:
        """The primes of the period with their powers, from the short numbers that it is made of."""
        from sympy import factorint

        # Of a number with b bits the smallest prime is found in about 2^(b/4) steps of Pollard's
        # rho, each of which is some products and remainders.
        budget.check_cost(
            f"the divisors of the period of {self!r}",
            "look up the polynomials that you need, f[g] or f(q)",
            steps=sum(100 * budget.power(2, e.bit_length() / 4) for e in self._divisors),
        )
        exponents: dict[int, int] = {}
        for e in self._divisors:
            for p, n in factorint(e).items():
                exponents[int(p)] = max(n, exponents.get(int(p), 0))
        return exponents

    def _polynomial(self, g: int) -> sympy.Poly:
        d, m = self._arrangement.dimension, len(self._arrangement.distinct)
        moduli = list(islice((q for q in count(g, g) if gcd(q, self.period) == g), max(1, d)))
        by_points = sum(_points_steps(self._arrangement, q) for q in moduli)
        by_subsets = budget.power(2, m) * _DIVISORS_STEPS
        if "_sets" in vars(self) or by_subsets < by_points:
            return self._from_sets(g)
        return _interpolate(self._arrangement, moduli)

    def _from_sets(self, g: int) -> sympy.Poly:
        import sympy

        d, terms = self._arrangement.dimension, Counter[int]()
        budget.spend(10 * len(self._sets))
        for (order, divisors), number in self._sets.items():
            terms[d - order] += number * prod(gcd(e, g) for e in divisors)
        return sympy.Poly.from_dict(dict(terms), sympy.Symbol("t"), domain=sympy.ZZ)

    @cached_property
    def _sets(self) -> dict[tuple[int, tuple[int, ...]], int]:
        """The sets of planes of each rank and each list of elementary divisors above 1.

        Those of an even number of planes count 1, the others -1.
        """
        planes = self._arrangement.distinct_planes
        budget.check_cost(
            f"the sets of {len(planes)} planes",
            "use characteristic_polynomial, which is f[1]",
            steps=budget.power(2, len(planes)) * _DIVISORS_STEPS,
        )
        sets = Counter[tuple[int, tuple[int, ...]]]()
        for bits in range(1 << len(planes)):
            rows = [plane[:-1] for i, plane in enumerate(planes) if bits >> i & 1]
            divisors = [e for e in _elementary_divisors(rows) if e]
            kind = len(divisors), tuple(e for e in divisors if e > 1)
            sets[kind] += (-1) ** bits.bit_count()
        return {kind: number for kind, number in sets.items() if number}


def _elementary_divisors(rows: Sequence[IntegerVector]) -> list[int]:
    """Return the elementary divisors of an integer matrix, each a divisor of the next."""
    from sympy import ZZ
    from sympy.polys.matrices import DM
    from sympy.polys.matrices.normalforms import invariant_factors

    if not rows or not rows[0]:
        return []
    factors: Any = invariant_factors(DM([list(row) for row in rows], ZZ))
    return [int(e) for e in factors]


def _interpolate(arrangement: Planes, moduli: Iterable[int]) -> sympy.Poly:
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
    if d * q**2 >= _MAX_WORD:
        raise InputError(f"{q} is too large for words of 64 bits in dimension {d}")
    planes = np.array(residues(arrangement.integer_planes, q), np.int64).reshape(-1, d + 1)
    along, across = planes[planes[:, d - 1] == 0], planes[planes[:, d - 1] != 0]
    divisors = np.gcd(across[:, d - 1], q)
    columns = len(along) + int(divisors.sum())
    budget.check_cost(
        f"the points of (Z/{q})^{d} off {len(arrangement)} planes",
        "use characteristic_polynomial",
        steps=_steps(q, d, columns),
    )
    powers = q ** np.arange(d - 1)
    step = max(1, _CHUNK // max(1, columns))
    total = 0
    for first in range(0, q ** (d - 1), step):
        numbers = np.arange(first, min(first + step, q ** (d - 1)))
        points = numbers[:, None] // powers % q
        on = ((points @ along[:, : d - 1].T - along[:, d]) % q == 0).any(axis=1)
        points = points[~on]
        hits = [_hits(points, across[divisors == g], q, int(g)) for g in np.unique(divisors)]
        hit = np.sort(np.hstack([np.full((len(points), 1), q), *hits]), axis=1)
        total += q * len(points) - int((hit[:, 1:] != hit[:, :-1]).sum())
    return total


def _points_steps(arrangement: Planes, q: int) -> float:
    """Return about how many steps `points_off` takes for central planes.

    Infinity where q is too large for it.
    """
    d = arrangement.dimension
    if d * q**2 >= _MAX_WORD:
        return inf
    return _steps(q, d, sum(gcd(row[-2], q) if d else 1 for row in arrangement.integer_planes))


def _steps(q: int, d: int, columns: int) -> float:
    return budget.power(q, d - 1) * max(1, columns) / 10


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


def _check_q(q: int, arrangement: Planes, minors: list[tuple[list[Any], tuple[int, ...]]]) -> int:
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
