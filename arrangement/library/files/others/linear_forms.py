"""Linear forms as computer algebra systems print them: ``3*x + 2*y - 5/2*z - 7``.

Nothing is evaluated: a form is a sum of numbers, variables, and numbers times variables.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction

from arrangement.errors import InputError
from arrangement.numbers.exact import rational, shown

_NUMBER = r"[0-9]+(?:/[0-9]+)?"
_NAME = r"[A-Za-z]\w*"
_TERM = re.compile(
    rf"\s*([+-]?)\s*(?:({_NUMBER}|\({_NUMBER}\))(?:\s*\*\s*({_NAME}))?|({_NAME})(?:\s*/\s*([0-9]+))?)\s*",
    re.ASCII,
)


def read_form(text: str, names: Sequence[str]) -> list[Fraction | int]:
    """Return the coefficients of the named variables, and the constant last."""
    found: list[Fraction | int] = [0] * (len(names) + 1)
    place = 0
    while place < len(text) or not place:
        term = _TERM.match(text, place)
        if term is None or (place and not term[1]):
            raise InputError(
                f"{shown(text)} is no linear form such as 3*x + 2*y - 7 in {', '.join(names)}"
            )
        name = term[3] or term[4]
        if name and name not in names:
            raise InputError(
                f"{shown(text)} has {shown(name)}; the variables are {', '.join(names)}"
            )
        written = (term[2] or (f"1/{term[5]}" if term[5] else "1")).strip("()")
        size: Fraction | int = (
            int(written)
            if written.isdigit() and len(written) < 1000
            else rational(written, f"a coefficient of {shown(text)}")
        )
        found[names.index(name) if name else -1] += -size if term[1] == "-" else size
        place = term.end()
    return found


def form_text(plane: Sequence[int], names: Sequence[str]) -> str:
    """Return ``n . x - b`` of the plane (n, b)."""
    text = ""
    for size, name in zip((*plane[:-1], -plane[-1]), (*names, ""), strict=True):
        if size:
            sign = ("-" if size < 0 else "") if not text else (" - " if size < 0 else " + ")
            times = str(abs(size)) if abs(size) != 1 or not name else ""
            text += sign + "*".join(filter(None, (times, name)))
    return text


def without_remarks(text: str, mark: str) -> str:
    """Return a text without what stands behind the mark on each line."""
    return re.sub(rf"{re.escape(mark)}.*", "", text)


def inside(text: str, start: int, pair: str) -> str:
    """Return what stands between the bracket at `start` and the one that closes it."""
    depth = 0
    for mark in re.compile(f"[{re.escape(pair)}]").finditer(text, start):
        depth += 1 if mark[0] == pair[0] else -1
        if not depth:
            return text[start + 1 : mark.start()]
    raise InputError(f"a bracket {pair[0]} is never closed")


def split_outside(text: str, mark: str = ",") -> list[str]:
    """Split a text at the marks that stand in no bracket; a last empty part is left out."""
    parts, depth, begun = [], 0, 0
    for found in re.compile(rf"[][(){{}}{mark}]").finditer(text):
        depth += (found[0] in "([{") - (found[0] in ")]}")
        if found[0] == mark and not depth:
            parts.append(text[begun : found.start()])
            begun = found.end()
    parts.append(text[begun:])
    return [part.strip() for part in (parts if parts[-1].strip() else parts[:-1])]
