"""How numbers, signs, counted things and whole values are written for people.

The options ``--exact`` and ``--digits`` of a command say how long its numbers may be. A value shows
itself in one line, and in a notebook as a table of its fields.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, fields, is_dataclass
from enum import Enum
from fractions import Fraction
from functools import partial
from inspect import isroutine
from itertools import islice
from typing import Any, ClassVar

from arrangement.hints import HintsMixin
from arrangement.numbers.exact import common_digits, number_text, to_text

#: Characters of a line, and items of a sequence in a line and in a table.
WIDTH, IN_LINE, IN_TABLE = 90, 4, 12


class ReprMixin(HintsMixin):
    """A value whose fields are shown: its dataclass has ``repr=False``, or a line of its own.

    Attributes:
        repr_fields: what is shown in a table, if not the fields of a dataclass.
    """

    __slots__ = ()
    repr_fields: ClassVar[tuple[str, ...]] = ()

    def __repr__(self) -> str:
        text = ", ".join(f"{name} {text}" for name, text in _rows(self, _names(self), IN_LINE))
        text = text if len(text) <= WIDTH else f"{text[: WIDTH - 3]}..."
        return f"<{type(self).__name__}: {text}>" if text else f"<{type(self).__name__}>"

    def _repr_html_(self) -> str | None:
        return table(self, _names(self))


class JsonMixin(ReprMixin):
    """A value with a JSON form: the attributes that `json_fields` names."""

    __slots__ = ()
    json_fields: ClassVar[tuple[str, ...]]

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; exact numbers are strings, null means unbounded (or none)."""
        return {name: _json_form(getattr(self, name)) for name in self.json_fields}


def _json_form(value: Any) -> Any:
    if isinstance(value, Fraction):
        return to_text(value)
    if isinstance(value, tuple):
        return [_json_form(entry) for entry in value]
    return value.to_dict() if hasattr(value, "to_dict") else value


def table(value: object, names: Iterable[str]) -> str:
    """Return attributes of a value as an HTML table, without those that are empty."""
    from html import escape

    cells = "".join(
        f"<tr><th>{escape(name)}</th><td>{escape(text)}</td></tr>"
        for name, text in _rows(value, names, IN_TABLE)
    )
    return f"<table><caption>{type(value).__name__}</caption>{cells}</table>"


def _names(value: ReprMixin) -> tuple[str, ...]:
    if value.repr_fields or not is_dataclass(value):
        return value.repr_fields
    return tuple(field.name for field in fields(value) if not field.name.startswith("_"))


def _rows(value: object, names: Iterable[str], most: int) -> Iterator[tuple[str, str]]:
    for name in names:
        entry = getattr(value, name)
        empty = isinstance(entry, (str, bytes, Sequence, Mapping)) and not entry
        if not (entry is None or empty or isroutine(entry) or isinstance(entry, partial)):
            yield name.replace("_", " "), _text(entry, most)


def _text(value: Any, most: int) -> str:
    if isinstance(value, Fraction) or type(value) is int:
        return number_text(value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (str, Enum)):
        return str(value.value) if isinstance(value, Enum) else value
    if hasattr(value, "shape"):  # an array
        return f"array of shape {value.shape}"
    if isinstance(value, Mapping):
        return f"{len(value)} entries"
    if isinstance(value, (tuple, list, frozenset, set)):
        if len(value) > most:
            return f"{len(value)} entries"
        return f"({', '.join(_text(entry, most) for entry in islice(value, most))})"
    text = repr(value)
    return text if len(text) <= WIDTH else f"{text[: WIDTH - 3]}..."


#: Significant digits of a number that is too long to be printed exactly.
DIGITS = 6


@dataclass(frozen=True)
class Form:
    """How numbers are written.

    Attributes:
        exact: every number exactly, however long.
        digits: of a number that is not written exactly.
        longest: characters up to which a number is.
        minus: the sign.
    """

    exact: bool = False
    digits: int = DIGITS
    longest: int = 12
    minus: str = "-"

    def number(self, value: Fraction | int) -> str:
        """Return a number as text.

        >>> LABEL.number(Fraction(-1, 2)), LABEL.number(Fraction(10**20 + 1, 3))
        ('−1/2', '≈3.333e+19')
        """
        if not self.exact:
            text = number_text(value, self.digits, self.longest)
        else:
            text = to_text(value) if isinstance(value, (int, Fraction)) else repr(value)
        return text.replace("-", self.minus)

    def vector(self, numbers: Iterable[Fraction | int]) -> str:
        """Return numbers in parentheses."""
        return f"({', '.join(map(self.number, numbers))})"

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
#: All digits; labels of pictures.
EXACT, LABEL = Form(exact=True), Form(digits=4, longest=7, minus="−")


def number(value: Fraction | int) -> str:
    """Return a number as the command that runs writes it."""
    return _form.get().number(value)


def vector(numbers: Iterable[Fraction | int]) -> str:
    """Return numbers in parentheses."""
    return _form.get().vector(numbers)


def near(value: float | Fraction, digits: int = DIGITS) -> str:
    """Return a number that is known to be rounded.

    >>> near(2 / 3, 2)
    '≈0.67'
    """
    return f"≈{float(value):.{digits}g}"


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
