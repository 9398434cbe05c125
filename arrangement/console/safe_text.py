"""Text that any terminal and any reader of text files can take, whatever file it came from.

Control characters, bidirectional marks and stray bytes are escaped; where the encoding of the
output lacks a sign, it is written in ASCII. Messages that cannot be written change no exit code.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from typing import Any, TextIO, cast
from unicodedata import category

#: Categories of Unicode: controls, formats (bidirectional marks), surrogates, separators of lines.
_UNSAFE = {"Cc", "Cf", "Cs", "Cn", "Co", "Zl", "Zp"}
#: What a message repeats of a long value: a quoted text, or a word.
_LONG = re.compile(r"'[^']{200,}'|\"[^\"]{200,}\"|\S{200,}")
_ASCII = {"≈": "~", "−": "-", "±": "+-", "×": "x", "≤": "<=", "≥": ">=", "…": "..."}


def printable(text: str, keep: str = "") -> str:
    r"""Return text in which unsafe characters are escaped, but for those of `keep`.

    >>> printable("a\x1b[1m\u202eb\n")
    'a\\x1b[1m\\u202eb\\n'
    """
    if text.isascii() and text.isprintable():
        return text
    return "".join(c if c in keep or category(c) not in _UNSAFE else ascii(c)[1:-1] for c in text)


def error_text(message: str) -> str:
    """Return a message as `printable`, with what it repeats of a user's long words shortened.

    >>> len(error_text("cannot read " + "x" * 5000))
    67
    """
    return printable(_LONG.sub(lambda word: f"{word[0][:40]}...{word[0][-12:]}", message))


def one_line(text: str) -> str:
    """Return text without line breaks, as `printable`."""
    return printable(" ".join(text.splitlines()))


def safe_lines(text: str) -> str:
    """Return a text of several lines, as `printable`."""
    return printable(text, "\n\t")


def encodable(text: str, encoding: str) -> str:
    """Return text that an encoding has every sign of; others are replaced or escaped.

    >>> encodable("≈0.5 m²", "ascii")
    '~0.5 m\\\\xb2'
    """
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        plain = "".join(_ASCII.get(c, c) for c in text)
        return plain.encode(encoding, "backslashreplace").decode(encoding)
    return text


class _Stream:
    """A stream that passes on to another one.

    Attributes:
        stream: where the text goes.
    """

    def __init__(self, stream: TextIO) -> None:
        self.stream = stream

    def __getattr__(self, name: str) -> Any:
        return getattr(self.stream, name)


class _Answers(_Stream):
    """A stream that is written to as `safe_lines` and `encodable` say."""

    def write(self, text: str) -> int:
        return self.stream.write(encodable(safe_lines(text), self.stream.encoding or "utf-8"))


@contextmanager
def safe_stdout() -> Iterator[None]:
    """Print safely and completely inside, on every terminal and in every file."""
    with redirect_stdout(cast(TextIO, _Answers(sys.stdout))):
        yield


class _Messages(_Stream):
    """A stream that may be full or closed: what cannot be written to it is lost."""

    def write(self, text: str) -> int:
        try:
            self.stream.write(text)
        except OSError:
            discard(self.stream)
        return len(text)

    def flush(self) -> None:
        try:
            self.stream.flush()
        except OSError:
            discard(self.stream)


def discard(stream: TextIO) -> None:
    """Send what is still buffered nowhere, so that the interpreter does not complain at exit."""
    try:
        descriptor = stream.fileno()
    except (OSError, ValueError):
        return
    devnull = os.open(os.devnull, os.O_WRONLY)
    os.dup2(devnull, descriptor)
    os.close(devnull)


@contextmanager
def safe_stderr() -> Iterator[None]:
    """Print messages inside; a stderr that cannot be written does not end the program."""
    with redirect_stderr(cast(TextIO, _Messages(sys.stderr))):
        yield
