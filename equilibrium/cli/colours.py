"""Verdicts in colour: on a terminal, unless the variable NO_COLOR is set."""

from __future__ import annotations

import os
import re
import sys

_GREEN, _CYAN, _YELLOW, _RED = 32, 36, 33, 31
_COLOURS = {
    "resisted": _GREEN,
    "valid": _GREEN,
    "yes": _GREEN,
    "undecided": _YELLOW,
    "depends on the rounding": _YELLOW,
    "not resisted": _RED,
    "not valid": _RED,
    "no": _RED,
}
#: What a verdict on a claim is worth; it stands in a column.
_STRENGTHS = {
    "proved": _GREEN,
    "holds in all cases": _CYAN,
    "no counterexample found": _YELLOW,
    "refuted": _RED,
}
_WORDS = "|".join(sorted(_COLOURS, key=len, reverse=True))
#: A verdict that begins a line, after the mark of a row if there is one.
_FIRST = re.compile(rf"(?:[!=?]? +)?\b({_WORDS})\b(?! for| forces)")


def print_verdict(text: str, verdict: str = "") -> None:
    """Print text with its verdict in colour.

    Args:
        verdict: a column of a line, which ends with it or has a remark after it, such as a number
            in parentheses or a hypothesis; the words at the start of the text if omitted.
    """
    column = re.compile(rf"(?m)  ({re.escape(verdict)})(?= \(| under |$)")
    match = column.search(text) if verdict else _FIRST.match(text)
    if match is None or not _use_colours():
        print(text)
        return
    start, stop = match.span(1)
    print(text[:start], end="")
    _control((_COLOURS | _STRENGTHS)[match[1]])
    print(text[start:stop], end="")
    _control(0)
    print(text[stop:])


def _use_colours() -> bool:
    dumb = os.environ.get("TERM") == "dumb" or (os.name == "nt" and "WT_SESSION" not in os.environ)
    return sys.stdout.isatty() and not dumb and not os.environ.get("NO_COLOR")


def _control(code: int) -> None:
    """Write a control sequence past `safe_text`, which escapes all that is printed."""
    stream = getattr(sys.stdout, "stream", sys.stdout)
    stream.write(f"\x1b[{code}m")
