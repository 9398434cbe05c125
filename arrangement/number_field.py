"""One real number field: exact numbers beside the rationals, with their signs.

A field is Q(a) for a real root a of an irreducible polynomial, told from the other roots by an
interval with rational ends. Inside, a is an algebraic integer, and a number is an integer vector
over the powers of a with one common denominator. What comes out rational is a Python integer or a
`Fraction`: so an `AlgebraicNumber` is irrational, never 0, and has one form.

Signs: the sum of coefficients times powers of a in floats, where a bound of its error allows;
else in integers, with a to so many digits that the sum exceeds its error. It is not 0, so this
ends.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property, total_ordering
from operator import mul
from typing import TYPE_CHECKING, Any, TypeAlias, cast

from .errors import InputError
from .exact import IntegerVector, RationalVector, rational_vector, shown, to_text

if TYPE_CHECKING:
    from sympy.polys.domains import AlgebraicField

#: Largest degree of a field: a product takes as many steps as its square.
MAX_DEGREE = 16
#: Bits of the powers of the generator at first, and below the last one of a float.
_BITS, _MORE_BITS = 128, 64
#: Powers below this size could lose digits in products of floats.
_SMALLEST = 2.0**-200
_UNIT = 2.0**-53

#: A rational number, or an irrational one of a field.
Real: TypeAlias = "int | Fraction | AlgebraicNumber"


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
            interval without a root, which is no real embedding, or with more than one.

    >>> golden = NumberField([-1, -1, 1], [1, 2])
    >>> golden, golden.root, golden.root * golden.root - golden.root
    (Q(a) with a^2 - 5 = 0, a = 2.23607..., 1/2 + 1/2*a, 1)
    """

    minimal_polynomial: IntegerVector
    root: AlgebraicNumber

    def __init__(self, polynomial: Any, interval: Any) -> None:
        given = rational_vector(polynomial, "the minimal polynomial")
        ends = rational_vector(interval, "the interval")
        low, high = _checked(given, ends)
        n = len(given) - 1
        monic = [x / given[-1] for x in given]
        scale = _integral_multiple(monic)
        integers = [int(x * scale ** (n - k)) for k, x in enumerate(monic)]
        start, factor = Fraction(0), Fraction(1, scale)  # the root is start + factor * generator
        if n == 2:
            square = integers[1] ** 2 - 4 * integers[0]
            part = _square_part(square)
            start, factor = Fraction(-integers[1], 2 * scale), Fraction(part, 2 * scale)
            if high <= start or (low < start and _value(monic, high) < 0):
                factor = -factor
            integers = [-square // part**2, 0, 1]
            self._low, self._high = Fraction(0), Fraction(1 - integers[0])
        else:
            self._low, self._high = low * scale, high * scale
        self.minimal_polynomial = tuple(integers)
        self._rising = _value(integers, self._high) > 0
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
        return self._made(self._reduced(whole + [0] * (self.degree - len(whole))), scale)

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
            if _polynomial(self.minimal_polynomial).count_roots(*map(_sympy, ends)) == 1:
                return ends
            j, bits = j + 1, bits + 1

    @cached_property
    def index(self) -> int:
        """How many real roots of the minimal polynomial are smaller than the generator."""
        if self.degree == 2:
            return 1
        below = _polynomial(self.minimal_polynomial).count_roots(None, _sympy(self._low))
        return int(below)

    def interval(self, bits: int = 10) -> tuple[Fraction, Fraction]:
        """Return an isolating interval of the generator, of length at most 2^-bits."""
        while (self._high - self._low) * (1 << bits) > 1:
            middle = (self._low + self._high) / 2
            if (_value(self.minimal_polynomial, middle) > 0) == self._rising:
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

        return QQ.alg_field_from_poly(_polynomial(self.minimal_polynomial), "a", self.index)

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
        return f"Q(a) with {_sum(terms)} = 0, a = {float(self.generator):.6g}..."

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
        *lower, _ = self.minimal_polynomial
        n = self.degree
        bound = 2 * max(abs(c) ** (1 / (n - k)) for k, c in enumerate(lower) if c)
        if n == 2:
            bound = math.sqrt(-lower[0])
        return tuple(math.ceil((bound * (1 + 1e-9)) ** k) for k in range(n))

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

    def _made(self, coefficients: IntegerVector, denominator: int) -> Real:
        """Return a number in its one form."""
        if not any(coefficients[1:]):
            value = Fraction(coefficients[0], denominator)
            return value.numerator if value.denominator == 1 else value
        if denominator != 1:
            divisor = math.gcd(denominator, *coefficients)
            if divisor != 1:
                coefficients = tuple([x // divisor for x in coefficients])
                denominator //= divisor
        return AlgebraicNumber(self, coefficients, denominator)

    def _product(self, left: IntegerVector, right: IntegerVector) -> IntegerVector:
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

    def _inverse(self, coefficients: IntegerVector) -> Real:
        """Return 1 over a number, from the equations for its coefficients."""
        if len(coefficients) == 2:
            a, b = coefficients
            norm = a * a + b * b * self.minimal_polynomial[0]
            return self._made((a, -b) if norm > 0 else (-a, b), abs(norm))
        found = self._inverses.get(coefficients)
        if found is None:
            columns, column = [], coefficients
            for _ in range(self.degree):
                columns.append(column)
                column = self._reduced((0, *column))
            found = self.number(_solution([*zip(*columns, strict=True)]))
            self._inverses[coefficients] = found
        return found

    @cached_property
    def _floats(self) -> tuple[float, ...]:
        """The powers of the generator; infinite where floats cannot be trusted with them."""
        powers = [p / (1 << _BITS) for p in self._scaled(_BITS)]
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
            products = list(map(mul, coefficients, self._floats))
            value = sum(products)
            if abs(value) > (len(products) + 6) * _UNIT * sum(map(abs, products)):
                return 1 if value > 0 else -1
        except OverflowError:
            pass
        total, _ = self._enclosed(coefficients, 0)
        return 1 if total > 0 else -1

    def _enclosed(self, coefficients: IntegerVector, bits: int) -> tuple[int, int]:
        """Return v, k so that v / 2^k is an irrational number but for 2^-bits of its size."""
        error, k = 2 * sum(map(abs, coefficients)), _BITS
        while True:
            total = sum(map(mul, coefficients, self._scaled(k)))
            if abs(total) >> bits > error:
                return total, k
            k *= 2


@total_ordering
class AlgebraicNumber:
    """An irrational number of a field; sums, products and quotients with rational numbers too.

    With a float they are floats, as those of a `Fraction` are.

    ``//`` is the exact quotient, as it is wherever the package divides integers.

    Attributes:
        field: the field.
        coefficients: integers, of the powers of the generator.
        denominator: of all of them.
    """

    __slots__ = ("_sign", "coefficients", "denominator", "field")

    def __init__(self, field: NumberField, coefficients: IntegerVector, denominator: int) -> None:
        self.field, self.coefficients, self.denominator = field, coefficients, denominator
        self._sign = 0

    @property
    def numerator(self) -> AlgebraicNumber:
        """The number times its denominator."""
        return self if self.denominator == 1 else AlgebraicNumber(self.field, self.coefficients, 1)

    @property
    def content(self) -> int:
        """The greatest common divisor of the coefficients."""
        return math.gcd(*self.coefficients)

    def rational_coefficients(self) -> RationalVector:
        """Return the coefficients as fractions."""
        return tuple(Fraction(c, self.denominator) for c in self.coefficients)

    def sign(self) -> int:
        """Return -1 or 1."""
        if not self._sign:
            self._sign = self.field.sign(self.coefficients)
        return self._sign

    def size(self) -> int:
        """Return a bound of the size of the number and of all its conjugates."""
        return -(-self.field.size(self.coefficients) // self.denominator)

    def bit_length(self) -> int:
        """Return the number of bits of the integer part, as of an integer."""
        total, k = self.field._enclosed(self.coefficients, _MORE_BITS)
        return (abs(total) // self.denominator >> k).bit_length()

    def residue(self, prime: int, root: int) -> int:
        """Return the number modulo a prime, with a root of the minimal polynomial for a."""
        found = 0
        for c in reversed(self.coefficients):
            found = (found * root + c) % prime
        return found * pow(self.denominator, -1, prime) % prime

    def __float__(self) -> float:
        total, k = self.field._enclosed(self.coefficients, _MORE_BITS)
        return total / (self.denominator << k)

    def __bool__(self) -> bool:
        return True

    def __hash__(self) -> int:
        return hash((self.coefficients, self.denominator))

    def __eq__(self, other: object) -> bool:
        if isinstance(other, AlgebraicNumber):
            same = self.coefficients == other.coefficients
            return same and self.denominator == other.denominator and self.field == other.field
        return False if isinstance(other, (int, Fraction)) else NotImplemented

    def __lt__(self, other: Any) -> bool:
        if type(other) is int and not other:
            return self.sign() < 0
        difference = self - (Fraction(other) if isinstance(other, float) else other)
        if isinstance(difference, AlgebraicNumber):
            return difference.sign() < 0
        return bool(difference < 0)

    def __gt__(self, other: Any) -> bool:
        return self.sign() > 0 if type(other) is int and not other else not self <= other

    def __neg__(self) -> AlgebraicNumber:
        return AlgebraicNumber(self.field, tuple([-c for c in self.coefficients]), self.denominator)

    def __pos__(self) -> AlgebraicNumber:
        return self

    def __abs__(self) -> AlgebraicNumber:
        return self if self.sign() > 0 else -self

    def __add__(self, other: Any) -> Any:
        field, left, p = self.field, self.coefficients, self.denominator
        if isinstance(other, AlgebraicNumber):
            if other.field is not field:
                _check_same(field, other.field)
            right, q = other.coefficients, other.denominator
            if p == q == 1:
                found = tuple([x + y for x, y in zip(left, right, strict=True)])
                return field._made(found, 1)
            sums = tuple([x * q + y * p for x, y in zip(left, right, strict=True)])
            return field._made(sums, p * q)
        if isinstance(other, int):
            return AlgebraicNumber(field, (left[0] + other * p, *left[1:]), p)
        if isinstance(other, Fraction):
            return field.number([Fraction(left[0], p) + other, *self.rational_coefficients()[1:]])
        return float(self) + other if isinstance(other, float) else NotImplemented

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        return self + -other if isinstance(other, _REALS) else NotImplemented

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        field, left, p = self.field, self.coefficients, self.denominator
        if isinstance(other, AlgebraicNumber):
            if other.field is not field:
                _check_same(field, other.field)
            return field._made(field._product(left, other.coefficients), p * other.denominator)
        if isinstance(other, (int, Fraction)):
            factor = other.numerator
            return field._made(tuple([x * factor for x in left]), p * other.denominator)
        return float(self) * other if isinstance(other, float) else NotImplemented

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if isinstance(other, AlgebraicNumber):
            return self * (1 / other)
        if isinstance(other, (int, Fraction)):
            return self * (1 / Fraction(other))
        return float(self) / other if isinstance(other, float) else NotImplemented

    def __rtruediv__(self, other: Any) -> Any:
        if isinstance(other, float):
            return other / float(self)
        return self.field._inverse(self.coefficients) * (other * self.denominator)

    __floordiv__, __rfloordiv__ = __truediv__, __rtruediv__

    def __pow__(self, exponent: int) -> Real:
        found: Real = 1
        for _ in range(exponent):
            found = found * self
        return found

    def __repr__(self) -> str:
        """Return the sum of the powers of the generator ``a``."""
        return _sum(enumerate(self.rational_coefficients()))


def rational_near(value: Real) -> Fraction:
    """Return a rational number as it is, and the float that is nearest to an irrational one."""
    return Fraction(float(value) if isinstance(value, AlgebraicNumber) else value)


def written(value: Real) -> str | list[str]:
    """Return the file form of a number: a text, or the texts of its coefficients."""
    if isinstance(value, AlgebraicNumber):
        return [to_text(c) for c in value.rational_coefficients()]
    return to_text(value)


_REALS = (int, Fraction, AlgebraicNumber, float)


def field_of(values: Any) -> NumberField | None:
    """Return the field of numbers, or None if all are rational.

    Raises:
        InputError: numbers of two different fields.
    """
    found = None
    for value in values:
        if isinstance(value, AlgebraicNumber):
            if found is None:
                found = value.field
            elif value.field is not found:
                _check_same(found, value.field)
    return found


def _sum(terms: Iterable[tuple[int, Any]]) -> str:
    """Return coefficients times powers of a, as text."""
    text = ""
    for power, c in terms:
        if c:
            factor = "" if power and abs(c) == 1 else to_text(abs(c)) + "*" * bool(power)
            sign = ("-" if c < 0 else "") if not text else " - " if c < 0 else " + "
            text += sign + factor + "a" * bool(power) + f"^{power}" * (power > 1)
    return text


def _check_same(one: NumberField, other: NumberField) -> None:
    if one != other:
        raise InputError(
            f"numbers of two different fields, {one!r} and {other!r}; give all of them as numbers "
            "of one field that has both, or as SymPy numbers"
        )


def _checked(given: RationalVector, ends: RationalVector) -> tuple[Fraction, Fraction]:
    """Return the ends of the interval, if it isolates a root of an irreducible polynomial."""
    n = len(given) - 1
    text = shown([to_text(x) for x in given])
    if not 2 <= n <= MAX_DEGREE or not given[-1]:
        raise InputError(
            f"the minimal polynomial is {text}; its coefficients stand from the constant term up, "
            f"the last one is not 0, and its degree is 2 to {MAX_DEGREE}"
        )
    if len(ends) != 2 or ends[0] >= ends[1]:
        raise InputError(
            f"the interval is {shown([to_text(x) for x in ends])}; give its two ends, the lower "
            "one first"
        )
    polynomial = None
    if n == 2:
        square = (given[1] ** 2 - 4 * given[0] * given[2]) / given[2] ** 2
        irreducible = square < 0 or any(
            math.isqrt(x) ** 2 != x for x in (square.numerator, square.denominator)
        )
    else:
        polynomial = _polynomial(given)
        irreducible = polynomial.is_irreducible
    if not irreducible:
        raise InputError(
            f"the minimal polynomial {text} is reducible over Q; give the factor that has the root"
        )
    low, high = ends
    if n == 2:
        middle = -given[1] / given[2] / 2
        outside = [_value(given, x) * given[2] > 0 for x in ends]
        both = all(outside) and low < middle < high and square > 0
        roots = outside[0] != outside[1] or 2 * both
        real = square > 0
    else:
        assert polynomial is not None
        roots = polynomial.count_roots(_sympy(low), _sympy(high))
        real = polynomial.count_roots() > 0
    if int(roots) != 1:
        none = "no real root there" if real else "no real root at all, so no real embedding"
        raise InputError(
            f"the minimal polynomial {text} has {int(roots) or none} "
            f"{'roots ' if roots else ''}between {to_text(low)} and {to_text(high)}; give an "
            "interval with exactly one"
        )
    return low, high


def _integral_multiple(monic: Sequence[Fraction]) -> int:
    """Return a positive integer that makes roots algebraic integers, the least if it is small."""
    n, enough = len(monic) - 1, math.lcm(*(x.denominator for x in monic))
    for scale in range(1, min(enough, 1000)):
        if all((x * scale ** (n - k)).denominator == 1 for k, x in enumerate(monic)):
            return scale
    return enough


def _square_part(number: int) -> int:
    """Return the largest s with s^2 dividing a positive number; 1 for numbers beyond factoring."""
    if number.bit_length() > 100:
        return 1
    found, p = 1, 2
    while p * p * p <= number:  # what is left then has at most two prime factors
        while number % (p * p) == 0:
            number //= p * p
            found *= p
        if number % p == 0:
            number //= p
        p += 1
        if p > 10**5:
            return found
    root = math.isqrt(number)
    return found * root if root * root == number else found


def _value(polynomial: Sequence[Fraction | int], x: Fraction) -> Fraction:
    found = Fraction(0)
    for c in reversed(polynomial):
        found = found * x + c
    return found


def _solution(matrix: Sequence[Sequence[int]]) -> list[Fraction]:
    """Return x with ``matrix x = (1, 0, ..., 0)``, by elimination."""
    n = len(matrix)
    rows = [[Fraction(x) for x in row] + [Fraction(i == 0)] for i, row in enumerate(matrix)]
    for j in range(n):
        pivot = next(i for i in range(j, n) if rows[i][j])
        rows[j], rows[pivot] = rows[pivot], rows[j]
        top = rows[j] = [x / rows[j][j] for x in rows[j]]
        for i in range(n):
            if i != j and (factor := rows[i][j]):
                rows[i] = [x - factor * y for x, y in zip(rows[i], top, strict=True)]
    return [row[-1] for row in rows]


def _sympy(value: Fraction) -> Any:
    import sympy

    return sympy.Rational(value.numerator, value.denominator)


def _polynomial(coefficients: Sequence[Fraction | int]) -> Any:
    """Return a SymPy polynomial from its coefficients, from the constant term up."""
    import sympy

    terms = [_sympy(Fraction(c)) for c in reversed(coefficients)]
    return sympy.Poly(terms, sympy.Symbol("x"), domain=sympy.QQ)
