"""Numbers of a field, with the operators of integers and fractions."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import total_ordering
from typing import Any, TypeAlias

from arrangement.numbers.exact import IntegerVector, common_divisor, to_text
from arrangement.numbers.real import Irrational, check_same_field

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
                found = tuple([x + y for x, y in zip(left, right, strict=True)])
                return field.made(found, 1)
            sums = tuple([x * q + y * p for x, y in zip(left, right, strict=True)])
            return field.made(sums, p * q)
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
            return field.made(field.product(left, other.coefficients), p * other.denominator)
        if isinstance(other, (int, Fraction)):
            factor = other.numerator
            return field.made(tuple([x * factor for x in left]), p * other.denominator)
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
        found: Real = 1
        for _ in range(exponent):
            found = found * self
        return found

    def __repr__(self) -> str:
        """Return the sum of the powers of the generator ``a``."""
        return sum_of_powers(enumerate(self.rational_coefficients()))


_REALS = (int, Fraction, AlgebraicNumber, float)


def sum_of_powers(terms: Iterable[tuple[int, Any]]) -> str:
    """Return coefficients times powers of a, as text."""
    text = ""
    for power, c in terms:
        if c:
            factor = "" if power and abs(c) == 1 else to_text(abs(c)) + "*" * bool(power)
            sign = ("-" if c < 0 else "") if not text else " - " if c < 0 else " + "
            text += sign + factor + "a" * bool(power) + f"^{power}" * (power > 1)
    return text
