"""Linear equations as text: ``2*x - y + 1 = 0``, ``x1 = 3/2 x2``, or a form, ``x - y``, that is 0.

They are read by a small grammar, never evaluated; a word behind a number needs a ``*``. Coordinates
are x, y and then z where that occurs, else all names in their order (x2 before x10); the positive
side is where the left side is the larger one, or the form is positive. A name of the plane may come
first, ``a: x = 0``.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, rational, shown, sum_text, to_text

#: A line with one equality sign and at least one name.
_EQUATION = re.compile(r"(?=.*[A-Za-z])[\w\s.+*/-]+=[\w\s.+*/-]+")
#: The name of a coordinate in a form without an equality sign; other words may be anything.
_COORDINATE = re.compile(r"[A-Za-z](?:_?[0-9]+)?", re.ASCII)
#: A number such as 1e5 or 1e-5, which is not a number times a coordinate e5, or e minus 5.
_DECIMAL_POWER = re.compile(r"(?<![\w.])[0-9]+(?:\.[0-9]+)?[eE][+-]?[0-9]+")
_NOT_FINITE = re.compile(r"\b(?:nan|inf|infinity)\b", re.IGNORECASE)
#: The name of a plane, and its equation.
_NAMED = re.compile(r"\s*(\w+)\s*:(.*)", re.DOTALL)
_NUMBER = r"[0-9]+(?:\.[0-9]+)?(?:/[0-9]+)?"
#: A sign; a number, in parentheses perhaps; a name; and what that is divided by.
_TERM = re.compile(
    rf"\s*([+-]?)\s*(?:({_NUMBER}|\({_NUMBER}\))\s*(\*?)\s*)?([A-Za-z]\w*)?\s*(?:/\s*([0-9]+)\s*)?"
)
_IRRATIONAL = re.compile(r"\b(?:sqrt|cbrt|root|pi)\b|[√π]")
_EXAMPLE = "2*x - 1/2*y + 1 = 0"
#: Digits of numbers that Python reads at once.
SHORT = 1000


def is_equation(line: str) -> bool:
    """Return whether a line has one equality sign and names, or is a linear form in coordinates."""
    line = _NAMED.sub(r"\2", line)
    if "=" in line:
        return _EQUATION.fullmatch(line) is not None
    if _DECIMAL_POWER.search(line):
        return False
    try:
        names = [name for name, _ in terms_of(line) if name]
    except InputError:
        return False
    return bool(names) and all(map(_COORDINATE.fullmatch, names))


def planes_of_text(
    lines: Iterable[str], coordinates: Sequence[str] | None = None
) -> tuple[list[RationalVector], list[Fraction], list[str], dict[int, str]]:
    """Return normals, offsets, the names of the coordinates, and those of planes by number.

    Args:
        lines: one equation each.
        coordinates: their names; if omitted, see the head of this module.

    Raises:
        InputError: the line, and the term that is not linear or has another name.
    """
    rows: list[Counter[str]] = []
    names: dict[int, str] = {}
    for i, text_line in enumerate(lines, 1):
        line = text_line.replace("\u2212", "-")
        if named := _NAMED.fullmatch(line):
            names[i], line = named.groups()
        if "=" not in line and not is_equation(line):
            raise InputError(
                f"{shown(line)} is not a linear form in coordinates such as x or x1; write such as "
                f"{_EXAMPLE}"
            )
        if power := _DECIMAL_POWER.search(line):
            raise InputError(
                f"the equation {shown(line)} has {power[0]}, a number or a coordinate; write the "
                "number without e, or a * before the coordinate"
            )
        if word := _NOT_FINITE.search(line):
            raise InputError(f"the equation {shown(line)} has {word[0]}; numbers are finite")
        left, _, right = line.partition("=")
        row: Counter[str] = Counter()
        for sign, side in ((1, left), (-1, right if "=" in line else "0")):
            if not side.strip():
                raise InputError(f"the equation {shown(line)} has an empty side; write 0 there")
            for name, value in terms_of(side, partial(_not_linear, line)):
                row[name] += sign * value  # type: ignore[assignment]
        rows.append(row)
    used = [name for row in rows for name in row if name]
    ordered = named_coordinates(used) if coordinates is None else list(coordinates)
    if others := sorted({*used} - {*ordered}):
        raise InputError(f"{others[0]} is not one of the coordinates {', '.join(ordered)}")
    budget.check_size(len(ordered), "coordinates")
    normals = [tuple(Fraction(row[name]) for name in ordered) for row in rows]
    return normals, [Fraction(-row[""]) for row in rows], ordered, names


def _not_linear(line: str, place: str) -> str:
    remedy = f"write such as {_EXAMPLE}"
    if _IRRATIONAL.search(line):
        remedy = 'irrational numbers are written in JSON with the key "field"'
    if re.search("[<>\u2264\u2265]", line):
        remedy = f"{remedy}, with = alone; what lies in a polygon is counted with --inside"
    return f"the equation {shown(line)} is not linear in rational numbers near {place}; {remedy}"


def named_coordinates(names: Iterable[str]) -> list[str]:
    """Return the coordinates that the names of some forms mean, in their order."""
    known = {*names}
    if known <= {*"xyz"}:
        known |= {*"xy"}
    return sorted(known, key=lambda name: [*_natural(name)])


def terms_of(
    text: str, message: Callable[[str], str] = str
) -> Iterator[tuple[str, Fraction | int]]:
    """Yield the terms of a linear form as name, empty for a constant, and number.

    Args:
        text: such as ``2*x - 1/2 y + (3/2)*z - w/2 + 1``.
        message: of the error, from the text at its place.

    Raises:
        InputError: it is not a sum of such terms.
    """
    at, length = 0, len(text)
    while at < length or not at:
        term = _TERM.match(text, at)
        sign, number, star, name, divisor = term.groups() if term else [None] * 5
        is_word = number and name and not star and not _COORDINATE.fullmatch(name)
        if term is None or is_word or not (name or (number and not star)) or (at and not sign):
            raise InputError(message(shown(text[at:].strip())))
        digits = number or "1"
        if divisor:
            digits = f"{digits}/{divisor}"
        if len(digits) < SHORT and digits.isdigit():
            size: Fraction | int = int(digits)
        else:
            size = rational(digits.strip("()"), f"a coefficient of {shown(text)}")
        yield name or "", -size if sign == "-" else size
        at = term.end()


def _natural(name: str) -> Iterator[tuple[int, str]]:
    """Yield the parts of a name such that x2 comes before x10."""
    for digits, letters in re.findall(r"([0-9]+)|([^0-9]+)", name):
        yield (int(digits), "") if digits else (-1, letters)


def equation_text(normal: Sequence[Any], offset: Any) -> str:
    """Return the equation of a plane: in x, y, z, or in x1, x2, ... beyond R^3.

    >>> equation_text([-1, 2], 3)
    '-x + 2*y = 3'
    """
    names = "xyz" if len(normal) <= 3 else [f"x{k + 1}" for k in range(len(normal))]
    return f"{sum_text(zip(normal, names, strict=False))} = {to_text(offset)}"
