"""How numbers, signs and counted things are written for people.

The options ``--exact`` and ``--digits`` of a command say how long its numbers may be.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from fractions import Fraction

from arrangement.numbers.exact import common_digits, number_text, to_text

#: Significant digits of a number that is too long to be printed exactly.
DIGITS = 6


@dataclass(frozen=True)
class Form:
    """Whether every number is written exactly, or else with how many digits the long ones."""

    exact: bool = False
    digits: int = DIGITS

    @contextmanager
    def used(self) -> Iterator[None]:
        """Write numbers so inside."""
        token = _form.set(self)
        try:
            yield
        finally:
            _form.reset(token)


_USUAL = Form()
_form: ContextVar[Form] = ContextVar("_form", default=_USUAL)


def number(value: Fraction | int) -> str:
    """Return a number as the command that runs writes it."""
    form = _form.get()
    if not form.exact:
        return number_text(value, form.digits)
    return to_text(value) if isinstance(value, (int, Fraction)) else repr(value)


def vector(numbers: Iterable[Fraction | int]) -> str:
    """Return numbers in parentheses."""
    return f"({', '.join(map(number, numbers))})"


def sign_text(signs: Sequence[int], minus: str = "-") -> str:
    """Return a sign vector as text.

    >>> sign_text((1, 0, -1))
    '+0-'
    """
    return "".join("+" if sign > 0 else minus if sign < 0 else "0" for sign in signs)


def counted(number: int, one: str, many: str = "") -> str:
    """Return a number with its noun.

    >>> counted(1, "contact"), counted(3, "contact"), counted(2, "leaf", "leaves")
    ('1 contact', '3 contacts', '2 leaves')
    """
    return f"{number} {one if number == 1 else many or one + 's'}"


def bracket(low: Fraction, high: Fraction) -> str:
    """Return a number of which only bounds are known: the digits that are certain, and the ends."""
    form = _form.get()
    if form.exact:
        return f"between {to_text(low)} and {to_text(high)}"
    start, end = (number_text(x, form.digits + 3, longest=24) for x in (low, high))
    ends = f"between {start} and {end}"
    certain = common_digits(low, high, form.digits)
    return ends if certain is None else f"{certain} ({ends})"
