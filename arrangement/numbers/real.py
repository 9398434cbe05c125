"""Irrational numbers of one field, as the rest of the package reads them.

Their arithmetic is that of `fields`, which is not imported before the first of them comes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

from arrangement.errors import InputError

from .exact import IntegerVector, RationalVector, to_text

#: Bits below the last one of a float.
_MORE_BITS = 64


class Irrational:
    """An irrational number of a field, as the rest of the package reads it.

    Attributes:
        field: the `fields.NumberField`.
        coefficients: integers, of the powers of its generator.
        denominator: of all of them.
    """

    __slots__ = ("coefficients", "denominator", "field")

    field: Any
    coefficients: IntegerVector
    denominator: int

    def rational_coefficients(self) -> RationalVector:
        """Return the coefficients as fractions."""
        return tuple(Fraction(c, self.denominator) for c in self.coefficients)

    def residue(self, prime: int, root: int) -> int:
        """Return the number modulo a prime, with a root of the minimal polynomial for a."""
        value = 0
        for c in reversed(self.coefficients):
            value = (value * root + c) % prime
        return value * pow(self.denominator, -1, prime) % prime

    def bit_length(self) -> int:
        """Return the number of bits of the integer part, as of an integer."""
        total, k = self._enclosed()
        return (abs(total) // self.denominator >> k).bit_length()

    def __float__(self) -> float:
        total, k = self._enclosed()
        return total / (self.denominator << k)

    def near(self, bits: int) -> Fraction:
        """Return a rational number that differs by 2^-bits of its size at most."""
        total, k = self._enclosed(bits)
        return Fraction(total, self.denominator << k)

    def _enclosed(self, bits: int = _MORE_BITS) -> tuple[int, int]:
        bounds: tuple[int, int] = self.field.enclosure(self.coefficients, bits)
        return bounds


def rational_near(value: int | Fraction | Irrational) -> Fraction:
    """Return a rational number as it is, and the float that is nearest to an irrational one."""
    return Fraction(float(value) if isinstance(value, Irrational) else value)


def written(value: int | Fraction | Irrational) -> str | list[str]:
    """Return the file form of a number: a text, or the texts of its coefficients."""
    if isinstance(value, Irrational):
        return [to_text(c) for c in value.rational_coefficients()]
    return to_text(value)


def field_of(values: Any) -> Any:
    """Return the `fields.NumberField` of numbers, or None if all are rational.

    Raises:
        InputError: numbers of two different fields.
    """
    field = None
    for value in values:
        if isinstance(value, Irrational):
            if field is None:
                field = value.field
            elif value.field is not field:
                check_same_field(field, value.field)
    return field


def residues(rows: Iterable[Sequence[Any]], prime: int) -> list[list[int]]:
    """Return integral vectors modulo a prime that has an image of their field, if they have one."""

    def residue(x: int | Irrational) -> int:
        if isinstance(x, int):
            return x % prime
        root = x.field.root_modulo(prime)
        assert root is not None
        return x.residue(prime, root)

    return [list(map(residue, row)) for row in rows]


def check_same_field(one: Any, other: Any) -> None:
    """Refuse numbers of two different fields."""
    if one != other:
        raise InputError(
            f"numbers of two different fields, {one!r} and {other!r}; give all of them as numbers "
            "of one field that has both, or as SymPy numbers"
        )
