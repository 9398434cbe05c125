"""Entries of planes and points: rational numbers, and irrational ones of one real field."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

from .exact import rational, rational_vector
from .real import Irrational, field_of


def entry(value: Any, name: str) -> Any:
    """Return a number as `exact.rational` does; one of a field, and SymPy's, as they are."""
    if isinstance(value, Irrational) or _is_irrational(value):
        return value
    return rational(value, name)


def real_vector(values: Any, name: str, field: Any = None) -> tuple[Any, ...]:
    """Return a vector of exact numbers; those of SymPy in `field` if there is one."""
    return in_one_field([rational_vector(values, name, entry)], field)[0]


def in_one_field(rows: Iterable[Sequence[Any]], field: Any = None) -> list[tuple[Any, ...]]:
    """Return rows of what `entry` gives, with SymPy's irrational numbers as those of one field.

    Args:
        field: one that has all numbers; if omitted, that of the other entries, or one that all of
            them generate.

    Raises:
        InputError: a number that is not real and algebraic; numbers of two different fields; a
            field of a degree above `fields.MAX_DEGREE`.
    """
    listed = list(map(tuple, rows))
    irrational = [x for row in listed for x in row if not isinstance(x, (int, Fraction))]
    known = field_of(x for x in irrational if isinstance(x, Irrational)) or field
    of_sympy = [x for x in irrational if not isinstance(x, Irrational)]
    if not of_sympy:
        return listed
    from .fields import ValuesInField

    values = ValuesInField(known, of_sympy)
    return [tuple(values.of(x) if _is_irrational(x) else x for x in row) for row in listed]


def _is_irrational(value: Any) -> bool:
    """Return whether a value is a number of SymPy, but none of its rationals and floats."""
    if isinstance(value, (int, Fraction, str)) or not getattr(value, "is_number", False):
        return False
    return not getattr(value, "is_Rational", True) and not getattr(value, "is_Float", True)
