"""How values show themselves: one line for people, and in a notebook a table of their fields."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass
from enum import Enum
from fractions import Fraction
from functools import partial
from html import escape
from inspect import isroutine
from itertools import islice
from typing import Any, ClassVar

from arrangement.numbers.exact import number_text

#: Characters of a line, and items of a sequence in a line and in a table.
WIDTH, IN_LINE, IN_TABLE = 90, 4, 12


class Shown:
    """A value whose fields are shown: its dataclass has ``repr=False``, or a line of its own.

    Attributes:
        shown_fields: what is shown in a table, if not the fields of a dataclass.
    """

    __slots__ = ()
    shown_fields: ClassVar[tuple[str, ...]] = ()

    def __repr__(self) -> str:
        text = ", ".join(f"{name} {text}" for name, text in _rows(self, _names(self), IN_LINE))
        text = text if len(text) <= WIDTH else f"{text[: WIDTH - 3]}..."
        return f"<{type(self).__name__}: {text}>" if text else f"<{type(self).__name__}>"

    def _repr_html_(self) -> str | None:
        return table(self, _names(self))


def table(value: object, names: Iterable[str]) -> str:
    """Return attributes of a value as an HTML table, without those that are empty."""
    cells = "".join(
        f"<tr><th>{escape(name)}</th><td>{escape(text)}</td></tr>"
        for name, text in _rows(value, names, IN_TABLE)
    )
    return f"<table><caption>{type(value).__name__}</caption>{cells}</table>"


def _names(value: Shown) -> tuple[str, ...]:
    if value.shown_fields or not is_dataclass(value):
        return value.shown_fields
    return tuple(field.name for field in fields(value) if not field.name.startswith("_"))


def _rows(value: object, names: Iterable[str], most: int) -> Iterator[tuple[str, str]]:
    for name in names:
        entry = getattr(value, name)
        if not (entry is None or isroutine(entry) or isinstance(entry, partial) or _empty(entry)):
            yield name.replace("_", " "), _text(entry, most)


def _empty(value: Any) -> bool:
    return isinstance(value, (str, bytes, Sequence, Mapping)) and not value


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
