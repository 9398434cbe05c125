"""Fields of real numbers with one generator, and their numbers.

A field is Q(a) for a real root a of an irreducible polynomial, distinguished from the other roots
by an interval with rational ends. Inside, a is an algebraic integer, and a number is an integer
vector over the powers of a with one common denominator. What comes out rational is a Python integer
or a `Fraction`: so an `AlgebraicNumber` is irrational, never 0, and has one form.

Signs: the sum of coefficients times powers of a in floats, where a bound of its error allows;
else in integers, with a with enough digits that the sum exceeds its error. It is not 0, so this
ends.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from operator import mul
from typing import TYPE_CHECKING, Any, cast

from arrangement.numbers.exact import IntegerVector, common_divisor, rational_vector, to_text

from .algebraic_number import AlgebraicNumber, Real, sum_of_powers
from .polynomials import (
    checked_ends,
    integral_multiple,
    square_part,
    to_polynomial,
    to_rational,
    value_at,
)

if TYPE_CHECKING:
    from sympy.polys.domains import AlgebraicField


#: Bits of the powers of the generator at first.
_BITS = 128
#: Smaller powers are known to fewer than 64 bits; larger ones are as good as rounded once.
_SMALLEST = 2.0 ** (64 - _BITS)
#: Larger ones could leave the range of floats in products.
_LARGEST = 2**200
_UNIT = 2.0**-53


class NumberField:
    """Q(a), where a is the only root of a polynomial in an interval.

    A quadratic field is stored as that of the square root of an integer without square factors,
    whatever it was made from; other fields keep what they were made from, times an integer. Fields
    are equal when these generators are.

    Args:
        polynomial: rational coefficients, from the constant term up; irreducible over Q.
        interval: its two ends, rational.

    Attributes:
        minimal_polynomial: of the generator: integers, from the constant term up, the last one 1.
        root: the root that was given, as a number of the field.

    Raises:
        InputError: a polynomial that is reducible, or of degree 1, or above `MAX_DEGREE`; an
            interval without a root, which is not a real embedding, or with more than one.

    >>> golden = NumberField([-1, -1, 1], [1, 2])
    >>> golden, golden.root, golden.root * golden.root - golden.root
    (Q(a) with a^2 - 5 = 0, a = 2.23607..., 1/2 + 1/2*a, 1)
    """

    minimal_polynomial: IntegerVector
    root: AlgebraicNumber

    def __init__(self, polynomial: Any, interval: Any) -> None:
        given = rational_vector(polynomial, "the minimal polynomial")
        ends = rational_vector(interval, "the interval")
        low, high = checked_ends(given, ends)
        n = len(given) - 1
        monic = [x / given[-1] for x in given]
        scale = integral_multiple(monic)
        integers = [int(x * scale ** (n - k)) for k, x in enumerate(monic)]
        start, factor = Fraction(0), Fraction(1, scale)  # the root is start + factor * generator
        if n == 2:  # then the root of the discriminant
            square = integers[1] ** 2 - 4 * integers[0]
            part = square_part(square)
            start, factor = Fraction(-integers[1], 2 * scale), Fraction(part, 2 * scale)
            if high <= start or (low < start and value_at(monic, high) < 0):
                factor = -factor
            integers = [-square // part**2, 0, 1]
            self._low, self._high = Fraction(0), Fraction(1 - integers[0])
        else:
            self._low, self._high = low * scale, high * scale
        self.minimal_polynomial = tuple(integers)
        self._rising = value_at(integers, self._high) > 0
        self._inverses: dict[IntegerVector, Real] = {}
        self.root = cast(AlgebraicNumber, self.number([start, factor]))

    @property
    def degree(self) -> int:
        """The dimension over Q."""
        return len(self.minimal_polynomial) - 1

    @property
    def generator(self) -> AlgebraicNumber:
        """The number a; every number is a sum of its powers with rational coefficients."""
        return AlgebraicNumber(self, (0, 1) + (0,) * (self.degree - 2), 1)

    def number(self, coefficients: Sequence[Fraction | int]) -> Real:
        """Return the sum of coefficients times powers 1, a, a^2, ... of the generator."""
        scale = math.lcm(*(x.denominator for x in coefficients))
        whole = [x.numerator * (scale // x.denominator) for x in coefficients]
        return self.made(self._reduced(whole + [0] * (self.degree - len(whole))), scale)

    def isolating_interval(self) -> tuple[Fraction, Fraction]:
        """Return the longest ``[k / 2^j, (k + 1) / 2^j]``, j >= 0, with only this root inside."""
        j, bits = 0, 64
        while True:
            below, above = (math.floor(end * (1 << j)) for end in self.interval(bits))
            if below != above:  # the two ends lie on both sides of an end of the wanted interval
                bits *= 2
                continue
            ends = Fraction(below, 1 << j), Fraction(below + 1, 1 << j)
            if self.degree == 2:
                return ends
            if to_polynomial(self.minimal_polynomial).count_roots(*map(to_rational, ends)) == 1:
                return ends
            j, bits = j + 1, bits + 1

    @cached_property
    def index(self) -> int:
        """How many real roots of the minimal polynomial are smaller than the generator."""
        if self.degree == 2:
            return 1
        below = to_polynomial(self.minimal_polynomial).count_roots(None, to_rational(self._low))
        return int(below)

    def interval(self, bits: int = 10) -> tuple[Fraction, Fraction]:
        """Return an isolating interval of the generator, of length at most 2^-bits."""
        while (self._high - self._low) * (1 << bits) > 1:
            middle = (self._low + self._high) / 2
            if (value_at(self.minimal_polynomial, middle) > 0) == self._rising:
                self._high = middle
            else:
                self._low = middle
        return self._low, self._high

    def root_modulo(self, prime: int) -> int | None:
        """Return a root of the minimal polynomial modulo a prime, if there is one."""
        if prime not in self._roots:
            import sympy

            terms = list(reversed(self.minimal_polynomial))
            polynomial = sympy.Poly(terms, sympy.Symbol("x"), modulus=prime)
            found = [f for f, _ in polynomial.factor_list()[1] if f.degree() == 1]
            self._roots[prime] = int(-found[0].TC()) % prime if found else None
        return self._roots[prime]

    @cached_property
    def _roots(self) -> dict[int, int | None]:
        return {}

    @cached_property
    def domain(self) -> AlgebraicField:
        """The same field as a domain of SymPy."""
        from sympy import QQ

        return QQ.alg_field_from_poly(to_polynomial(self.minimal_polynomial), "a", self.index)

    def of_domain(self, value: Any) -> Real:
        """Return a number of `domain` as one of the field."""
        terms = reversed(value.to_list())
        return self.number([Fraction(int(c.numerator), int(c.denominator)) for c in terms])

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        if not isinstance(other, NumberField):
            return NotImplemented
        same = self.minimal_polynomial == other.minimal_polynomial
        return same and self.index == other.index

    def __hash__(self) -> int:
        return hash(self.minimal_polynomial)

    def __repr__(self) -> str:
        terms = reversed(list(enumerate(self.minimal_polynomial)))
        return f"Q(a) with {sum_of_powers(terms)} = 0, a = {float(self.generator):.6g}..."

    def to_dict(self) -> dict[str, list[str]]:
        """Return the file form (see `arrangement.read_arrangement`)."""
        return {
            "minimal_polynomial": [to_text(c) for c in self.minimal_polynomial],
            "interval": [to_text(x) for x in self.isolating_interval()],
        }

    def __reduce__(self) -> tuple[Any, ...]:
        return NumberField, (self.minimal_polynomial, self.isolating_interval())

    def size(self, coefficients: Sequence[int]) -> int:
        """Return a bound of the size of a number, and of all its conjugates."""
        return sum(abs(c) * power for c, power in zip(coefficients, self._largest, strict=True))

    @cached_property
    def _largest(self) -> tuple[int, ...]:
        """Bounds of the sizes of the powers of all roots [Fujiwara1916]."""
        from sympy import integer_nthroot

        *lower, _ = self.minimal_polynomial
        n = self.degree
        if n == 2:
            return 1, math.isqrt(-lower[0]) + 1
        bound = 2 * max(integer_nthroot(abs(c), n - k)[0] + 1 for k, c in enumerate(lower) if c)
        return tuple(bound**k for k in range(n))

    @cached_property
    def _tails(self) -> list[IntegerVector]:
        """The powers n, n + 1, ..., 2n - 2 of the generator, over the lower ones."""
        *lower, _ = self.minimal_polynomial
        rows = [tuple(-c for c in lower)]
        while len(rows) < self.degree - 1:
            *rest, top = rows[-1]
            rows.append(tuple(x + top * y for x, y in zip((0, *rest), rows[0], strict=True)))
        return rows

    def _reduced(self, coefficients: Sequence[int]) -> IntegerVector:
        """Return a sum of powers up to 2n - 2 as one of powers up to n - 1."""
        n = self.degree
        found = list(coefficients[:n])
        for top, row in zip(coefficients[n:], self._tails, strict=False):
            if top:
                found = [x + top * y for x, y in zip(found, row, strict=True)]
        return tuple(found)

    def made(self, coefficients: IntegerVector, denominator: int) -> Real:
        """Return a number in its one form."""
        if not any(coefficients[1:]):
            value = Fraction(coefficients[0], denominator)
            return value.numerator if value.denominator == 1 else value
        if denominator != 1:
            divisor = common_divisor(denominator, *coefficients)
            if divisor != 1:
                coefficients = tuple([x // divisor for x in coefficients])
                denominator //= divisor
        return AlgebraicNumber(self, coefficients, denominator)

    def product(self, left: IntegerVector, right: IntegerVector) -> IntegerVector:
        """Return the coefficients of a product of two numbers."""
        n = len(left)
        if n == 2:
            (a, b), (c, d) = left, right
            return a * c - b * d * self.minimal_polynomial[0], a * d + b * c
        found = [0] * (2 * n - 1)
        for i, x in enumerate(left):
            if x:
                for j, y in enumerate(right, i):
                    found[j] += x * y
        return self._reduced(found)

    def inverse(self, coefficients: IntegerVector) -> Real:
        """Return 1 over a number."""
        if len(coefficients) == 2:
            a, b = coefficients
            norm = a * a + b * b * self.minimal_polynomial[0]
            return self.made((a, -b) if norm > 0 else (-a, b), abs(norm))
        found = self._inverses.get(coefficients)
        if found is None:
            found = self.of_domain(self.domain(list(coefficients[::-1])) ** -1)
            self._inverses[coefficients] = found
        return found

    @cached_property
    def float_powers(self) -> tuple[float, ...]:
        """The powers of the generator; infinite where floats cannot be trusted with them."""
        one = 1 << _BITS
        powers = [p / one if abs(p) < _LARGEST * one else math.inf for p in self._scaled(_BITS)]
        return tuple(p if abs(p) >= _SMALLEST else math.inf for p in powers)

    def _scaled(self, bits: int) -> tuple[int, ...]:
        """Return integers within 1 of the powers of the generator times 2^bits."""
        known = self._approximations.get(bits)
        if known is None:
            n = self.degree
            more = bits + 4 + n.bit_length() + n * self._largest[1].bit_length()
            low, _ = self.interval(more)
            whole = (low.numerator << more) // low.denominator
            power, powers = 1 << more, []
            for _ in range(n):
                powers.append(power >> (more - bits))
                power = power * whole >> more
            known = self._approximations[bits] = tuple(powers)
        return known

    @cached_property
    def _approximations(self) -> dict[int, tuple[int, ...]]:
        return {}

    def sign(self, coefficients: IntegerVector) -> int:
        """Return the sign of an irrational number."""
        try:
            # 3 roundings for each product, n - 1 for sums: see `float_filter`; the rest is spare.
            products = list(map(mul, coefficients, self.float_powers))
            value = sum(products)
            if abs(value) > (len(products) + 6) * _UNIT * sum(map(abs, products)):
                return 1 if value > 0 else -1
        except OverflowError:
            pass
        total, _ = self.enclosed(coefficients, 0)
        return 1 if total > 0 else -1

    def enclosed(self, coefficients: IntegerVector, bits: int) -> tuple[int, int]:
        """Return v, k so that v / 2^k is an irrational number but for 2^-bits of its size."""
        error, k = 2 * sum(map(abs, coefficients)), _BITS
        while True:
            total = sum(map(mul, coefficients, self._scaled(k)))
            if abs(total) >> bits > error:
                return total, k
            k *= 2
