"""What a format is: a name, endings of files, a reader, a writer, and what is lost in it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.json_files import kind_of, parse_json
from arrangement.numbers.exact import IntegerVector


@dataclass(frozen=True)
class Format:
    """A language in which arrangements are written.

    Attributes:
        recognises: whether a text is in it; the first format of the table that says so reads it.
        read: the arrangement of a text; None where it is only written.
        write: the text of an arrangement; None where it is only read.
        split: the texts of single arrangements, where a file holds several.
        loses: what the text of this arrangement does not say, in words; empty for nothing.
    """

    name: str
    endings: tuple[str, ...]
    recognises: Callable[[str], object] = lambda _: None
    read: Callable[[str], Arrangement] | None = None
    write: Callable[[Arrangement], str] | None = None
    split: Callable[[str], Sequence[str]] = lambda text: [text]
    loses: Callable[[Arrangement], str] = lambda _: ""


def json_object(text: str) -> dict[str, Any]:
    """Parse a JSON object, which may have floats where they are passed over."""
    data = parse_json(text, "the file", floats=True)
    if not isinstance(data, dict):
        raise InputError(f"the file holds {kind_of(data)}; expected a JSON object")
    return data


def rational_planes(arrangement: Arrangement) -> tuple[IntegerVector, ...]:
    """Return the planes as integers, the offset last.

    Raises:
        InputError: entries are irrational.
    """
    if arrangement.field is not None:
        raise InputError(
            f"entries are in {arrangement.field!r}, and this format holds rational ones; write json"
        )
    return arrangement.integer_planes
