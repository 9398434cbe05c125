"""Fields of real numbers with one generator, and their numbers, for irrational entries.

A field is Q(a) for a real root a of an irreducible polynomial, distinguished from the other roots
by an interval with rational ends. Inside, a is an algebraic integer, and a number is an integer
vector over the powers of a with one common denominator. What comes out rational is a Python integer
or a `Fraction`: so an `AlgebraicNumber` is irrational, never 0, and has one form.

Signs: the sum of coefficients times powers of a in floats, where a bound of its error allows;
else in integers, with a with enough digits that the sum exceeds its error. It is not 0, so this
ends.

Irrational numbers of SymPy are taken apart down to what SymPy alone knows, such as ``sqrt(5)`` or
``cos(2*pi/7)``; these get a field through their minimal polynomials, and the rest is arithmetic of
fields. Nothing is evaluated in floats but to isolate the roots of a polynomial, between which
rational numbers lie.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property, total_ordering
from operator import mul
from typing import TYPE_CHECKING, Any, TypeAlias, cast

from arrangement.errors import InputError
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    common_divisor,
    quotient,
    rational_vector,
    shown,
    sum_of_powers,
    to_text,
)
from arrangement.numbers.real import Irrational, check_same_field

if TYPE_CHECKING:
    import sympy
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
    whatever it was made from; of an integer beyond 100 bits only powers of 4 are taken out. Other
    fields keep what they were made from, times an integer. Fields are equal when these generators
    are.

    Args:
        polynomial: rational coefficients, from the constant term up; irreducible over Q.
        interval: its two ends, rational.

    Attributes:
        minimal_polynomial: of the generator: integers, from the constant term up, the last one 1.
        root: the root that was given, as a number of the field.

    Raises:
        InputError: a polynomial that is reducible, or of degree 1, or above `MAX_DEGREE`, or with
            coefficients above `MAX_DIGITS`, as given or as stored; an interval without a root,
            which is not a real embedding, or with more than one.

    >>> golden = NumberField([-1, -1, 1], [1, 2])
    >>> golden, golden.root, golden.root * golden.root - golden.root
    (Q(a) with a^2 - 5 = 0, a = 2.23607..., 1/2 + 1/2*a, 1)
    """

    minimal_polynomial: IntegerVector
    root: AlgebraicNumber

    def __init__(self, polynomial: Any, interval: Any) -> None:
        coefficients = rational_vector(polynomial, "the minimal polynomial")
        ends = rational_vector(interval, "the interval")
        low, high = checked_ends(coefficients, ends)
        n = len(coefficients) - 1
        monic = [x / coefficients[-1] for x in coefficients]
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
        check_digits(integers, "the minimal polynomial of a multiple that is an algebraic integer")
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
        return self.canonical(self._reduce(whole + [0] * (self.degree - len(whole))), scale)

    def isolating_interval(self) -> tuple[Fraction, Fraction]:
        """Return the longest ``[k / 2^j, (k + 1) / 2^j]``, j >= 0, with only this root inside."""
        j, bits = 0, 64
        while True:
            below, above = (math.floor(end * (1 << j)) for end in self.interval(bits))
            if below != above:  # the two ends lie on both sides of an end of the wanted interval
                bits *= 2
                continue
            ends = Fraction(below, 1 << j), Fraction(below + 1, 1 << j)
            if count_roots(self.minimal_polynomial, *ends) == 1:
                return ends
            j, bits = j + 1, bits + 1

    @cached_property
    def index(self) -> int:
        """How many real roots of the minimal polynomial are smaller than the generator."""
        return count_roots(self.minimal_polynomial, None, self._low)

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
            factors = [f for f, _ in polynomial.factor_list()[1] if f.degree() == 1]
            self._roots[prime] = int(-factors[0].TC()) % prime if factors else None
        return self._roots[prime]

    @cached_property
    def _roots(self) -> dict[int, int | None]:
        return {}

    @cached_property
    def domain(self) -> AlgebraicField:
        """The same field as a domain of SymPy."""
        from sympy import QQ, Poly, Symbol

        polynomial = Poly(self.minimal_polynomial[::-1], Symbol("x"), domain=QQ)
        return QQ.alg_field_from_poly(polynomial, "a", self.index)

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
        *lower, _ = self.minimal_polynomial
        n = self.degree
        if n == 2:
            return 1, math.isqrt(-lower[0]) + 1
        from flint import fmpz

        bound = 2 * max(int(fmpz(abs(c)).root(n - k)) + 1 for k, c in enumerate(lower) if c)
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

    def _reduce(self, coefficients: Sequence[int]) -> IntegerVector:
        """Return a sum of powers up to 2n - 2 as one of powers up to n - 1."""
        n = self.degree
        reduced = list(coefficients[:n])
        for top, row in zip(coefficients[n:], self._tails, strict=False):
            if top:
                reduced = [x + top * y for x, y in zip(reduced, row, strict=True)]
        return tuple(reduced)

    def canonical(self, coefficients: IntegerVector, denominator: int) -> Real:
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
        total = [0] * (2 * n - 1)
        for i, x in enumerate(left):
            if x:
                for j, y in enumerate(right, i):
                    total[j] += x * y
        return self._reduce(total)

    def inverse(self, coefficients: IntegerVector) -> Real:
        """Return 1 over a number."""
        if len(coefficients) == 2:
            a, b = coefficients
            norm = a * a + b * b * self.minimal_polynomial[0]
            return self.canonical((a, -b) if norm > 0 else (-a, b), abs(norm))
        number = self._inverses.get(coefficients)
        if number is None:
            inverse = _polynomial(coefficients).xgcd(_polynomial(self.minimal_polynomial))[1]
            powers = [inverse[k] for k in range(self.degree)]
            number = self.number([Fraction(int(c.p), int(c.q)) for c in powers])
            self._inverses[coefficients] = number
        return number

    @cached_property
    def float_powers(self) -> tuple[float, ...]:
        """The powers of the generator; infinite where floats cannot be trusted with them."""
        unit = 1 << _BITS
        powers = [p / unit if abs(p) < _LARGEST * unit else math.inf for p in self._scale(_BITS)]
        return tuple(p if abs(p) >= _SMALLEST else math.inf for p in powers)

    def _scale(self, bits: int) -> tuple[int, ...]:
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
        total, _ = self.enclosure(coefficients, 0)
        return 1 if total > 0 else -1

    def enclosure(self, coefficients: IntegerVector, bits: int) -> tuple[int, int]:
        """Return v, k so that v / 2^k is an irrational number but for 2^-bits of its size."""
        error, k = 2 * sum(map(abs, coefficients)), _BITS
        while True:
            total = sum(map(mul, coefficients, self._scale(k)))
            if abs(total) >> bits > error:
                return total, k
            k *= 2


#: Largest degree of a field: a product takes as many steps as its square.
MAX_DEGREE = 16
#: Of a coefficient of a minimal polynomial.
MAX_DIGITS = 100


def checked_ends(terms: RationalVector, ends: RationalVector) -> tuple[Fraction, Fraction]:
    """Return the ends of the interval, if it isolates a root of an irreducible polynomial."""
    n = len(terms) - 1
    text = shown([to_text(x) for x in terms])
    if not 2 <= n <= MAX_DEGREE or not terms[-1]:
        raise InputError(
            f"the minimal polynomial is {text}; its coefficients stand from the constant term up, "
            f"the last one is not 0, and its degree is 2 to {MAX_DEGREE}"
        )
    check_digits(terms, "the minimal polynomial")
    if len(ends) != 2 or ends[0] >= ends[1]:
        raise InputError(
            f"the interval is {shown([to_text(x) for x in ends])}; give its two ends, the lower "
            "one first"
        )
    factors = _polynomial(terms).factor()[1]
    if [power for _, power in factors] != [1]:
        raise InputError(
            f"the minimal polynomial {text} is reducible over Q; give the factor that has the root"
        )
    low, high = ends
    if (roots := count_roots(terms, low, high)) != 1:
        real = count_roots(terms) > 0
        none = "no real root there" if real else "no real root at all, so no real embedding"
        raise InputError(
            f"the minimal polynomial {text} has {roots or none} "
            f"{'roots ' if roots else ''}between {to_text(low)} and {to_text(high)}; give an "
            "interval with exactly one"
        )
    return low, high


def check_digits(terms: Sequence[Fraction | int], what: str) -> None:
    """Refuse a polynomial with longer coefficients than `MAX_DIGITS`."""
    if any(max(abs(x.numerator), x.denominator) >= 10**MAX_DIGITS for x in terms):
        raise InputError(
            f"{what} is {shown([to_text(x) for x in terms])}; its coefficients may have up to "
            f"{MAX_DIGITS} digits"
        )


def integral_multiple(monic: Sequence[Fraction]) -> int:
    """Return a positive integer that makes roots algebraic integers, the least if it is small."""
    n, enough = len(monic) - 1, math.lcm(*(x.denominator for x in monic))
    for scale in range(1, min(enough, 1000)):
        if all((x * scale ** (n - k)).denominator == 1 for k, x in enumerate(monic)):
            return scale
    return enough


def square_part(number: int) -> int:
    """Return the largest s with s^2 dividing a positive number, or its power of 2 if long.

    A number is long if it has more than 100 bits without its factors 4. So 4 times a number has
    twice its s, and what is stored of a field is stored the same when it is read again.
    """
    twos = ((number & -number).bit_length() - 1) // 2
    rest = number >> (2 * twos)
    if rest.bit_length() > 100:
        return 1 << twos
    from flint import fmpz

    part: int = math.prod(int(p) ** (power // 2) for p, power in fmpz(rest).factor())
    return part << twos


def value_at(polynomial: Sequence[Fraction | int], x: Fraction) -> Fraction:
    """Return the value of a polynomial at a rational number."""
    value = Fraction(0)
    for c in reversed(polynomial):
        value = value * x + c
    return value


def count_roots(
    polynomial: Sequence[Fraction | int], low: Fraction | None = None, high: Fraction | None = None
) -> int:
    """Return the number of real roots in a closed interval; None for an end that is unbounded."""
    from .functions import Span, signs_on

    bound = 1 + max(abs(Fraction(c) / polynomial[-1]) for c in polynomial)  # Cauchy's
    ends = -bound if low is None else low, bound if high is None else high
    return len(signs_on(_polynomial(polynomial), Span(*ends))[1])


def _polynomial(coefficients: Sequence[Fraction | int]) -> Any:
    """Return a polynomial of FLINT from its coefficients, from the constant term up."""
    from flint import fmpq, fmpq_poly

    return fmpq_poly([fmpq(c.numerator, c.denominator) for c in coefficients])


#: A rational number, or an irrational one of a field.
Real: TypeAlias = "int | Fraction | AlgebraicNumber"


@total_ordering
class AlgebraicNumber(Irrational):
    """An irrational number of a field; sums, products and quotients with rational numbers too.

    With a float they are floats, as those of a `Fraction` are.

    ``//`` is the exact quotient, as it is wherever the package divides integers.
    """

    __slots__ = ("_sign",)

    def __init__(self, field: Any, coefficients: IntegerVector, denominator: int) -> None:
        self.field, self.coefficients, self.denominator = field, coefficients, denominator
        self._sign = 0

    @property
    def numerator(self) -> AlgebraicNumber:
        """The number times its denominator."""
        return self if self.denominator == 1 else AlgebraicNumber(self.field, self.coefficients, 1)

    @property
    def content(self) -> int:
        """The greatest common divisor of the coefficients."""
        return common_divisor(*self.coefficients)

    def sign(self) -> int:
        """Return -1 or 1."""
        if not self._sign:
            self._sign = self.field.sign(self.coefficients)
        return self._sign

    def size(self) -> int:
        """Return a bound of the size of the number and of all its conjugates."""
        return -(-int(self.field.size(self.coefficients)) // self.denominator)

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
                check_same_field(field, other.field)
            right, q = other.coefficients, other.denominator
            if p == q == 1:
                total = tuple([x + y for x, y in zip(left, right, strict=True)])
                return field.canonical(total, 1)
            sums = tuple([x * q + y * p for x, y in zip(left, right, strict=True)])
            return field.canonical(sums, p * q)
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
                check_same_field(field, other.field)
            return field.canonical(field.product(left, other.coefficients), p * other.denominator)
        if isinstance(other, (int, Fraction)):
            factor = other.numerator
            return field.canonical(tuple([x * factor for x in left]), p * other.denominator)
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
        return self.field.inverse(self.coefficients) * (other * self.denominator)

    __floordiv__, __rfloordiv__ = __truediv__, __rtruediv__

    def __pow__(self, exponent: int) -> Real:
        power: Real = 1
        for _ in range(exponent):
            power = power * self
        return power

    def __repr__(self) -> str:
        """Return the sum of the powers of the generator ``a``."""
        return sum_of_powers(enumerate(self.rational_coefficients()))


_REALS = (int, Fraction, AlgebraicNumber, float)


#: Digits to which SymPy's numbers are placed between rational ends.
_DIGITS = 60


class ValuesInField:
    """The values of SymPy's numbers in one field."""

    def __init__(self, field: NumberField | None, numbers: Sequence[sympy.Expr]) -> None:
        import sympy

        self._field = field
        self._known: dict[sympy.Expr, Real] = {}
        atoms = sorted(
            {atom for number in numbers for atom in _atoms(number)},
            key=lambda atom: (-_minimal_polynomial(atom).degree(), sympy.default_sort_key(atom)),
        )
        for i, atom in enumerate(atoms):
            root = self._root(atom)
            if root is not None:
                self._known[atom] = root
            elif field is None:
                self._enlarge(atoms[: i + 1])
            else:
                raise InputError(
                    f"{shown(atom)} is not in the field {field!r} of the other numbers; give all "
                    "of them as numbers of one field that has both, or as SymPy numbers"
                )

    def of(self, number: sympy.Expr) -> Real:
        """Return the value of a number, from those of its atoms."""
        value = self._known.get(number)
        if value is None:
            value = self._known[number] = self._compute(number)
        return value

    def _compute(self, number: Any) -> Real:
        value: Any
        if number.is_Rational:
            return Fraction(int(number.p), int(number.q))
        if number.is_Pow:
            base = self.of(number.base)
            if not base:
                raise InputError(f"{shown(number)} divides by zero")
            value = 1
            for _ in range(abs(int(number.exp))):
                value = value * base
            value = value if number.exp > 0 else quotient(1, value)
        else:
            value = 0 if number.is_Add else 1
            for part in number.args:
                value = value + self.of(part) if number.is_Add else value * self.of(part)
        return cast("Real", value)

    def _root(self, atom: sympy.Expr) -> Real | None:
        """Return an atom as a number of the present field, if it is one."""
        import sympy

        polynomial = _minimal_polynomial(atom)
        low, high = _isolate(atom, polynomial)
        if self._field is None:
            self._field = NumberField(_coefficients(polynomial), (low, high))
            return self._field.root
        if self._field.degree % polynomial.degree():
            return None
        domain = self._field.domain
        factors = sympy.Poly(polynomial, domain=domain).factor_list()[1]
        for factor, _ in factors:
            if factor.degree() == 1:
                top, rest = factor.rep.to_list()
                root = self._field.of_domain(-rest / top)
                if low < root < high:
                    return root
        return None

    def _enlarge(self, atoms: Sequence[sympy.Expr]) -> None:
        """Replace the field by one that a sum of multiples of all these atoms generates."""
        assert self._field is not None
        largest = self._field.degree * _minimal_polynomial(atoms[-1]).degree()
        for multiple in range(1, largest * largest):
            total = sum(multiple**i * atom for i, atom in enumerate(atoms))
            self._field = None
            self._root(total)
            roots = {atom: self._root(atom) for atom in atoms}
            if None not in roots.values():
                self._known.update(roots)
                return
        raise AssertionError("some sum of multiples generates the field")


def _atoms(number: sympy.Expr) -> Iterable[sympy.Expr]:
    """Yield what sums, products and integer powers make a number of."""
    if number.is_Add or number.is_Mul or (number.is_Pow and number.exp.is_Integer):
        for part in number.args if not number.is_Pow else number.args[:1]:
            yield from _atoms(part)
    elif not number.is_Rational:
        yield number


def _minimal_polynomial(number: Any) -> sympy.Poly:
    """Return the minimal polynomial over Q of a real algebraic number."""
    import sympy
    from sympy.polys.polyerrors import NotAlgebraic

    if number.has(sympy.Float):
        raise InputError(
            f"{shown(number)} has a float, which is not exact; write Rational(1, 10) for 0.1"
        )
    try:
        polynomial = sympy.minimal_polynomial(number, sympy.Symbol("x"), polys=True)
    except (NotAlgebraic, NotImplementedError):
        raise InputError(
            f"{shown(number)} is not known to be algebraic; give numbers such as sqrt(5), "
            "cos(2*pi/7) or CRootOf"
        ) from None
    if polynomial.degree() > MAX_DEGREE:
        raise InputError(
            f"the entries generate a field of degree {polynomial.degree()} or more, with "
            f"{shown(number)}; at most {MAX_DEGREE} is possible"
        )
    if number.is_real is False or not polynomial.count_roots():
        raise InputError(f"{shown(number)} is not real; give real algebraic numbers")
    return polynomial


def _isolate(number: Any, polynomial: sympy.Poly) -> tuple[Fraction, Fraction]:
    """Return rational ends between which the number is the only root of its polynomial."""
    import sympy

    value = sympy.Rational(number.evalf(_DIGITS))
    if not value.is_real:
        raise InputError(f"{shown(number)} is not real; give real algebraic numbers")
    for power in (8, 16, 32, 64):
        width = sympy.Rational(1, 2**power)
        if polynomial.count_roots(value - width, value + width) == 1:
            low, high = value - width, value + width
            return Fraction(int(low.p), int(low.q)), Fraction(int(high.p), int(high.q))
    raise InputError(f"{shown(number)} is too near to its conjugates; give a field with a root")


def _coefficients(polynomial: sympy.Poly) -> list[Fraction]:
    return [Fraction(int(c.p), int(c.q)) for c in reversed(polynomial.all_coeffs())]
