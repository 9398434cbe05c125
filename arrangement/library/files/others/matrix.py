"""A plain matrix, or plain equations; ``#`` for remarks.

Equations are linear, one a line: ``2*x - y + 1 = 0``, ``x1 = 3/2 x2``. They are read by a small
grammar, never evaluated. Coordinates are x, y and then z where that occurs, else all names in their
order (x2 before x10); the positive side is where the left side is the larger one.

A matrix has a normal a line, numbers with spaces or commas between.

The offset of ``n . x = b`` stands last, behind a bar: ``1 0 | 2``. Brackets around lines are passed
over, so what Sage, NumPy and polymake print is read too.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from fractions import Fraction

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.documents import rational_planes
from arrangement.numbers.exact import rational, shown

_REMARK = re.compile(r"#.*")
_MATRIX = re.compile(r"(?=[^0-9]*[0-9])[-+0-9./eE,;|()\[\]\s]+")
#: A number or a list of JSON, where there would be one row here.
_VALUE = re.compile(r"\[[^[]*|[-+0-9./eE]+")
#: Between two rows of one line.
_BETWEEN = re.compile(r"[\])][\s,;]*[\[(]")
#: A line with one equality sign and at least one name.
_EQUATION = re.compile(r"(?=.*[A-Za-z])[\w\s.+*/-]+=[\w\s.+*/-]+")
#: A sign, a number, and a name; either of the two last may be missing.
_TERM = re.compile(
    r"\s*([+-]?)\s*(?:([0-9]+(?:\.[0-9]+)?(?:/[0-9]+)?)(?:\s*\*)?)?\s*([A-Za-z]\w*)?"
)


def _equations(text: str) -> list[str]:
    plain = _REMARK.sub("", text).replace("\u2212", "-")
    return [line.strip() for line in re.split(r"[\n;]", plain) if line.strip()]


def recognises_equations(text: str) -> bool:
    """Whether every line has one equality sign, and letters beside numbers and signs."""
    lines = _equations(text)
    return bool(lines) and all(map(_EQUATION.fullmatch, lines))


def _sums(side: str, line: str) -> Iterator[tuple[str, Fraction]]:
    """Yield the terms of a sum as name (none for a constant) and number."""
    at, first = 0, True
    if not side.strip():
        raise InputError(f"the equation {shown(line)} has an empty side; write 0 there")
    while at < len(side.rstrip()):
        term = _TERM.match(side, at)
        sign, number, name = term.groups() if term else ("", None, None)
        bare = number is None and name is None
        starred = side[at : term.end() if term else at].rstrip().endswith("*")
        if term is None or bare or starred or not (sign or first):
            raise InputError(
                f"the equation {shown(line)} is not linear near {shown(side[at:].strip())}; write "
                "such as 2*x - 1/2*y + 1 = 0"
            )
        value = rational(number or "1", "a coefficient")
        yield name or "", -value if sign == "-" else value
        at, first = term.end(), False


def read_equations(text: str) -> Arrangement:
    """Read a plane from each line."""
    rows = []
    for line in _equations(text):
        left, _, right = line.partition("=")
        row: Counter[str] = Counter()
        for sign, side in ((1, left), (-1, right)):
            for name, value in _sums(side, line):
                row[name] += sign * value  # type: ignore[assignment]
        rows.append(row)
    names = {name for row in rows for name in row} - {""}
    if names <= {*"xyz"}:
        names |= {*"xy"}
    ordered = sorted(names, key=lambda name: [*_natural(name)])
    return Arrangement(
        [[row[name] for name in ordered] for row in rows], [-row[""] for row in rows]
    )


def _natural(name: str) -> Iterator[tuple[int, str]]:
    """Yield the parts of a name such that x2 comes before x10."""
    for digits, letters in re.findall(r"([0-9]+)|([^0-9]+)", name):
        yield (int(digits), "") if digits else (-1, letters)


def write_equations(arrangement: Arrangement) -> str:
    """Write an equation on each line."""
    names = [f"x{k + 1}" for k in range(arrangement.dimension)]
    if arrangement.dimension <= 3:
        names = [*"xyz"][: arrangement.dimension]
    lines = []
    for *normal, offset in rational_planes(arrangement):
        terms = [
            f"{'-' if x < 0 else '+'} {f'{abs(x)}*' if abs(x) > 1 else ''}{name}"
            for x, name in zip(normal, names, strict=True)
            if x
        ]
        lines.append(f"{' '.join(terms).removeprefix('+ ')} = {offset}\n")
    return "".join(lines)


def recognises(text: str) -> bool:
    """Whether a text has numbers alone, and is no value of JSON."""
    plain = _REMARK.sub("", text).strip()
    return _MATRIX.fullmatch(plain) is not None and _VALUE.fullmatch(plain) is None


def numbers(line: str) -> list[str]:
    """Return the numbers of a line, as they are written."""
    plain = line.strip().strip("()[],;")
    marks = set(plain) & set("()[],;")
    if not marks:
        return plain.split() or [""]
    if marks - set(",;"):
        raise InputError(f"the line {shown(line)} has brackets inside; write one normal a line")
    return re.split(r"\s*[\s,;]\s*", plain.strip())


def read(text: str) -> Arrangement:
    """Read a normal from each line."""
    plain = _BETWEEN.sub("\n", _REMARK.sub("", text))
    if not set(plain) & set("()[],;|"):
        return Arrangement(list(filter(None, map(str.split, plain.splitlines()))))
    lines = [line for line in plain.splitlines() if line.strip(" \t()[],;")]
    parts = [line.partition("|") for line in lines]
    rows = [numbers(normal) for normal, _, _ in parts]
    if not any(bar for _, bar, _ in parts):
        return Arrangement(rows)
    offsets = [numbers(offset)[0] if bar else "0" for _, bar, offset in parts]
    for (_, _, offset), line in zip(parts, lines, strict=True):
        if len(numbers(offset)) > 1:
            raise InputError(
                f"the line {shown(line)} has several offsets; write one behind the bar"
            )
    return Arrangement(rows, offsets)


def write(arrangement: Arrangement) -> str:
    """Write a normal on each line."""
    if not len(arrangement):
        raise InputError("there is no plane, and a matrix of no rows has no dimension; write json")
    lines = [(" ".join(map(str, p[:-1])), p[-1]) for p in rational_planes(arrangement)]
    if arrangement.is_central:
        return "".join(f"{normal}\n" for normal, _ in lines)
    return "".join(f"{normal} | {offset}\n" for normal, offset in lines)
