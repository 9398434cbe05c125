"""What a format is: names, endings, a reader, a writer, and what is lost in it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.exact import IntegerVector

#: What makes the arrangements that a text stands for, one each.
Makers = Sequence[Callable[[], Arrangement]]


@dataclass(frozen=True)
class Format:
    """A language in which arrangements are written.

    Attributes:
        name: on the command line.
        what: one line.
        endings: of files that are written in it.
        recognises: whether a text is in it; the first format of the table that says so reads it.
        entries: the arrangements that a text holds; None where it is only written.
        write: the text of an arrangement; None where it is only read.
        loses: what the text of this arrangement does not say, in words; empty for nothing.
    """

    name: str
    what: str
    endings: tuple[str, ...] = ()
    recognises: Callable[[str], bool] = lambda _: False
    entries: Callable[[str], Makers] | None = None
    write: Callable[[Arrangement], str] | None = None
    loses: Callable[[Arrangement], str] = lambda _: ""


def one(read: Callable[[str], Arrangement]) -> Callable[[str], Makers]:
    """Return the entries of a format whose texts hold one arrangement."""
    return lambda text: [lambda: read(text)]


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
