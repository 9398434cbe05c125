"""A plain matrix, or plain equations; ``#`` for remarks.

Equations are linear, one a line; `arrangement.planes.equation_text` reads them, and names before
them, as in ``a: x = 0``.

A matrix has a normal a line, numbers with spaces or commas between.

The offset of ``n . x = b`` stands last, behind a bar: ``1 0 | 2``. Brackets around lines are passed
over, so what Sage, NumPy and polymake print is read too.
"""

from __future__ import annotations

import re

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.documents import rational_planes, with_all_faults
from arrangement.numbers.exact import shown
from arrangement.planes.equation_text import equation_text, is_equation, planes_of_text

_REMARK = re.compile(r"#.*")
#: A first line with the names of columns.
_HEAD = re.compile(r"\s*\"?[A-Za-z_].*[,;\t].*")
_MATRIX = re.compile(r"(?=[^0-9]*[0-9])[-+0-9./eE,;|()\[\]\s]+")
#: A number or a list of JSON, where there would be one row here.
_VALUE = re.compile(r"\[[^[(]*|[-+0-9./eE]+")
#: Between two rows of one line.
_BETWEEN = re.compile(r"[\])][\s,;]*[\[(]")
#: A row without numbers.
_EMPTY = re.compile(r"[\])]\s*,\s*,|[\[(]\s*[\])]")


def _equations(text: str) -> list[str]:
    plain = _REMARK.sub("", text).replace("\u2212", "-").replace("==", "=")
    return [line.strip() for line in re.split(r"[\n;]", plain) if line.strip()]


def recognises_equations(text: str) -> bool:
    """Return whether the first line has an equality sign, or every line is a linear form.

    What is not linear is refused when it is read.
    """
    lines = _equations(text)
    if not lines or lines[0][0] in '{["<':
        return False
    return bool(re.search("[=<>]", lines[0])) or all(map(is_equation, lines))


def read_equations(text: str) -> Arrangement:
    """Read a plane from each line."""
    normals, offsets, _, names = planes_of_text(_equations(text))
    return Arrangement(normals, offsets, names=names)


def write_equations(arrangement: Arrangement) -> str:
    """Write an equation on each line."""
    planes = rational_planes(arrangement)
    return "".join(f"{equation_text(plane[:-1], plane[-1])}\n" for plane in planes)


def recognises(text: str) -> bool:
    """Return whether a text has numbers alone, and is not a value of JSON."""
    plain = _REMARK.sub("", text).strip()
    return _MATRIX.fullmatch(plain) is not None and _VALUE.fullmatch(plain) is None


def numbers(line: str) -> list[str]:
    """Return the numbers of a line, as they are written."""
    plain = line.strip().lstrip("()[]").rstrip("()[],;")
    marks = set(plain) & set("()[],;")
    if not marks:
        return plain.split() or [""]
    if marks == set(",;"):
        raise InputError(
            f"the line {shown(line)} has commas and semicolons; write decimals with a point, and "
            "one normal a line"
        )
    if marks - set(",;"):
        raise InputError(f"the line {shown(line)} has brackets inside; write one normal a line")
    return re.split(r"\s*[\s,;]\s*", plain.strip())


def read(text: str) -> Arrangement:
    """Read a normal from each line."""
    plain = _REMARK.sub("", text)
    if empty := _EMPTY.search(plain):
        raise InputError(
            f"a normal is empty, at {shown(empty[0])}; all normals need one entry for each "
            "coordinate"
        )
    plain = _BETWEEN.sub("\n", plain)
    if head := _HEAD.match(plain):
        raise InputError(
            f"the first line, {shown(head[0].strip())}, is not one that is known: a,b,c (lines "
            "ax + by = c), name,a,b,c, a,b,c,d (planes), x,y (corners), x1,y1,x2,y2 (segments), "
            "x,y,normal_x,normal_y,friction (contacts), or numbers alone (normals)"
        )
    if not set(plain) & set("()[],;|"):
        return with_all_faults(list(filter(None, map(str.split, plain.splitlines()))))
    lines = [line for line in plain.splitlines() if line.strip(" \t()[],;")]
    parts = [line.partition("|") for line in lines]
    rows = [numbers(normal) for normal, _, _ in parts]
    if not any(bar for _, bar, _ in parts):
        return with_all_faults(rows)
    offsets = [numbers(offset)[0] if bar else "0" for _, bar, offset in parts]
    for (_, _, offset), line in zip(parts, lines, strict=True):
        if len(numbers(offset)) > 1:
            raise InputError(
                f"the line {shown(line)} has several offsets; write one behind the bar"
            )
    return with_all_faults(rows, offsets)


def write(arrangement: Arrangement) -> str:
    """Write a normal on each line."""
    if not len(arrangement):
        raise InputError("there is no plane, and a matrix of no rows has no dimension; write json")
    lines = [(" ".join(map(str, p[:-1])), p[-1]) for p in rational_planes(arrangement)]
    if arrangement.is_central:
        return "".join(f"{normal}\n" for normal, _ in lines)
    return "".join(f"{normal} | {offset}\n" for normal, offset in lines)
