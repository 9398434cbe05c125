"""Grasps from CSV files: one contact a line, strictly read.

The first line names the columns: ``x``, ``y``, ``normal_x``, ``normal_y``, ``friction``, in space
also ``z`` and ``normal_z``, and, if wanted, ``stiffness``, ``preload`` and ``adhesion``, in any
order. They are separated by commas, semicolons or tabs; short names are ``nx``, ``ny``, ``nz``,
``mu``, ``k`` and ``q``. In the plane ``angle`` may replace the normal: its direction in degrees,
from the x axis towards the y axis. Engines print ``px``, ``py``, ``pz`` and ``force``, the normal
force. ``pad`` is that of `conversion.completed`. Empty lines and lines that begin with ``#`` are
skipped. Numbers are decimals or ratios, as ``-0.25``, ``7/3``. A normal may have any length; one of
irrational length is replaced by a near unit vector and the error reported.

A table of an assembly also has ``body_a``, into which the normal points, and ``body_b``; the ground
is an empty entry or the word ``ground``.
"""

from __future__ import annotations

import csv
import io
import os
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from arrangement.library.files.json_files import read_text
from arrangement.numbers.exact import rational, shown
from equilibrium.model.assembly import Assembly, BodyContact
from equilibrium.model.contact import VALUES
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import ask_contacts

from .conversion import DEFAULT_TOLERANCE, EXTRAS, Conversion, completed, direction_of
from .incidences import converted
from .rounding import Rounding, rounding

if TYPE_CHECKING:
    from arrangement import Arrangement

_REQUIRED = ("x", "y", "normal_x", "normal_y", VALUES[0])
_IN_SPACE = ("z", "normal_z")
_ANGLE = "angle"
BODIES = ("body_a", "body_b")
GROUND = ("", "ground")
_KNOWN = (*BODIES, *_REQUIRED, *_IN_SPACE, _ANGLE, *VALUES[1:], *EXTRAS)
_SHORT = {"nx": "normal_x", "ny": "normal_y", "nz": "normal_z"} | {
    "mu": "friction",
    "k": "stiffness",
    "q": "preload",
    "force": "preload",
    "px": "x",
    "py": "y",
    "pz": "z",
}
_SEPARATORS = (",", ";", "\t")
#: Line numbers, and entries by column.
Rows: TypeAlias = Iterable[tuple[int, dict[str, str]]]
#: Makes contacts of points, normals and values by name.
Convert: TypeAlias = Callable[[list[Any], list[Any], list[dict[str, Any]]], Conversion]


def read_csv(
    path: str | os.PathLike[str],
    *,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
    tolerance: Any = DEFAULT_TOLERANCE,
    as_given: bool = False,
) -> Conversion:
    """Read a grasp from a CSV file.

    Args:
        angle_tolerance: largest tangent of the change of a normal's direction.
        tolerance: where normals have to be rounded, how far points may move so that what contacts
            have in common (see `from_float_data`) stays.
        as_given: leave the points where they are.

    Raises:
        GraspError: names the line and the rule; also for a file that cannot be read, is longer
            than 4 MiB or is not UTF-8.
    """
    how = rounding(0, tolerance, angle_tolerance, as_given)
    return parse_csv(read_text(Path(path))[0], how)


def parse_csv(text: str, how: Rounding | None = None) -> Conversion:
    """Read a grasp from CSV text.

    >>> conversion = parse_csv("x,y,normal_x,normal_y,friction\\n-1,0,2,0,0.5\\n")
    >>> conversion.grasp.contacts[0].normal, conversion.exact
    ((Fraction(1, 1), Fraction(0, 1)), True)
    """
    return read_rows(contact_rows(text), exact_contacts(how))


def read_bodies(
    path: str | os.PathLike[str],
    *,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
    tolerance: Any = DEFAULT_TOLERANCE,
    as_given: bool = False,
) -> tuple[Assembly, Conversion] | None:
    """Read an assembly from a CSV file; None of a table without bodies.

    Args:
        angle_tolerance, tolerance, as_given: as in `read_csv`.

    Returns:
        The assembly, and its contacts as one grasp, with the errors.

    Raises:
        GraspError: as `read_csv`.
    """
    text = read_text(Path(path))[0]
    if not re.search(rf"\b{BODIES[0]}\b", next(_lines(text), "")):
        return None
    pairs: list[tuple[str, str | None]] = []
    how = rounding(0, tolerance, angle_tolerance, as_given)
    conversion = read_rows(contact_rows(text), exact_contacts(how), pairs=pairs)
    if len(conversion.grasp) != len(pairs):
        raise GraspError("pad is for one body; leave the column out")
    contacts = [BodyContact(*pair, c) for pair, c in zip(pairs, conversion.grasp, strict=True)]
    names = dict.fromkeys(name for pair in pairs for name in pair if name is not None)
    return Assembly(names, contacts, data_error=conversion.grasp.data_error), conversion


def _lines(text: str) -> Iterator[str]:
    """Yield the lines that are neither empty nor comments."""
    return (line for line in text.splitlines() if line.strip() and not line.startswith("#"))


def tangential_arrangement(text: str) -> Arrangement | None:
    """Return the tangential planes of a table of contacts; None for a text without its header.

    Raises:
        GraspError: as `parse_csv`, and where a normal had to be rounded.
    """
    if not re.search(r"\b(nx|normal_x)\b", next(_lines(text), "")):
        return None
    conversion = parse_csv(text)
    if not conversion.exact:
        raise GraspError(
            "the table has normals without an exact length; equilibrium make csv writes a document "
            "with rounded ones, and reports the change"
        )
    return conversion.grasp.tangential_arrangement()


def contact_rows(text: str) -> Rows:
    """Return the lines of a table of contacts."""
    ask_contacts(text.count("\n"))
    return table_rows(text, check_header)


def exact_contacts(how: Rounding | None = None) -> Convert:
    """Return what makes contacts of exact numbers; it rounds normals of irrational length."""
    used = how or rounding(0, DEFAULT_TOLERANCE, DEFAULT_TOLERANCE, False)

    def convert(points: list[Any], normals: list[Any], values: list[dict[str, Any]]) -> Conversion:
        return converted([(point, Fraction(0)) for point in points], normals, values, used)

    return convert


def read_rows(
    rows: Rows,
    convert: Convert,
    number: Callable[[str, str], Any] = rational,
    pairs: list[tuple[str, str | None]] | None = None,
) -> Conversion:
    """Return the contacts of some lines; errors name the line.

    Args:
        number: reads an entry of a column.
        pairs: is given the bodies of each contact; None refuses a table that has some.
    """
    lines, points, normals, values, extras = [], [], [], [], []
    for line, row in rows:
        if pairs is None and BODIES[0] in row:
            raise GraspError("the table has bodies; expected a grasp. `read_assembly` reads it")
        with _named(line):
            if pairs is not None:
                first, second = (row.pop(name) for name in BODIES)
                pairs.append((first, None if second in GROUND else second))
            exact = {key: rational(row.pop(key), key) for key in (_ANGLE, *EXTRAS) if key in row}
            entries = {name: number(entry, name) for name, entry in row.items()}
        if _ANGLE in exact:
            direction = direction_of(exact.pop(_ANGLE))
            entries |= zip(("normal_x", "normal_y"), direction, strict=True)
        axes = "xyz" if "z" in entries else "xy"
        lines.append(line)
        points.append([entries[x] for x in axes])
        normals.append([entries[f"normal_{x}"] for x in axes])
        values.append({name: entries[name] for name in VALUES if name in entries})
        extras.append(exact)
    try:
        return completed(convert(points, normals, values), extras)
    except ValueError:
        for line, point, normal, value in zip(lines, points, normals, values, strict=True):
            with _named(line):
                convert([point], [normal], [value])
        raise


@contextmanager
def _named(line: int) -> Iterator[None]:
    """Let errors name the line."""
    try:
        yield
    except ValueError as error:
        raise GraspError(f"line {line}: {str(error).removeprefix('normals[0]: ')}") from None


def table_rows(text: str, check: Callable[[list[str]], None]) -> Rows:
    """Yield line numbers and entries by column, whose names a function may refuse."""
    lines = ["" if line.lstrip().startswith("#") else line for line in io.StringIO(text)]
    first = next(filter(str.strip, lines), "")
    reader = csv.reader(lines, delimiter=max(_SEPARATORS, key=first.count), strict=True)
    try:
        rows = (row for row in reader if any(map(str.strip, row)))
        header = [_SHORT.get(name.strip(), name.strip()) for name in next(rows, [])]
        check(header)
        for row in rows:
            if len(row) != len(header):
                raise GraspError(
                    f"line {reader.line_num} has {len(row)} entries; the header has {len(header)}"
                )
            yield reader.line_num, dict(zip(header, (entry.strip() for entry in row), strict=True))
    except csv.Error as error:
        raise GraspError(f"line {reader.line_num}: {error}") from None


def check_header(header: list[str], keys: tuple[str, ...] = ()) -> None:
    """Refuse missing, unknown and repeated columns.

    Args:
        keys: that lines may have besides in a table of many grasps, which are of one body each.
    """
    in_space = any(name in header for name in _IN_SPACE)
    required: tuple[str, ...] = (*_REQUIRED, *_IN_SPACE) if in_space else _REQUIRED
    if _ANGLE in header:
        if both := [name for name in header if name.startswith("normal_")]:
            raise GraspError(f"the columns are {_ANGLE} and {both[0]}; keep one")
        required = ("x", "y", _ANGLE, VALUES[0])
    if any(name in header for name in BODIES):
        required = (*BODIES, *required)
    missing = [name for name in required if name not in header]
    if missing:
        where = ", for contacts in space" if in_space else f" (or {_ANGLE}, in degrees)"
        raise GraspError(
            f"the first line must name the columns {', '.join(required)}{where}; {missing[0]} is "
            "missing"
        )
    allowed = (*keys, *(x for x in _KNOWN if x not in BODIES)) if keys else _KNOWN
    for name in header:
        if name not in allowed:
            raise GraspError(
                f"the column {shown(name)} is unknown; expected one of {', '.join(allowed)}"
            )
        if header.count(name) > 1:
            raise GraspError(f"the column {name} appears twice; keep one")
