"""Grasps from CSV files: one contact a line, strictly read.

The first line names the columns: ``x``, ``y``, ``normal_x``, ``normal_y``, ``friction``, in space
also ``z`` and ``normal_z``, and, if wanted, ``stiffness``, ``preload`` and ``adhesion``, in any
order. They are separated by commas, semicolons or tabs; usual names are read, too, such as ``nx``,
``mu``, ``k``, ``px`` and ``normal_force``, and so are units, as in ``x [m]``, ``x (m)``, ``x_mm``.
Units are labels: nothing is converted, so they have to fit together. In the plane ``angle`` may
replace the normal: its direction in degrees, from the x axis towards the y axis. ``pad`` is that of
`conversion.completed`. Empty lines and lines that begin with ``#`` are skipped. Numbers are
decimals or ratios, as ``-0.25``, ``7/3``; between semicolons or tabs also ``-0,25``. A normal may
have any length; one of irrational length is replaced by a near unit vector and the error reported.

A table of an assembly also has ``body_a``, into which the normal points, and ``body_b``; the ground
is an empty entry or the word ``ground``, ``fixed`` or ``world``, in ``body_b`` alone.
"""

from __future__ import annotations

import csv
import io
import os
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from difflib import get_close_matches
from functools import partial
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias, TypeGuard

from arrangement.errors import refusal
from arrangement.library.files.json_files import check_all, read_text
from arrangement.numbers.exact import rational, shown, to_text
from equilibrium.model.assembly import Assembly, BodyContact
from equilibrium.model.contact import VALUES
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, ask_contacts
from equilibrium.model.labels import Units

from .conversion import DEFAULT_TOLERANCE, PAD, USUAL, Conversion, completed, direction_of
from .incidences import converted, rounding

if TYPE_CHECKING:
    from arrangement import Arrangement

_REQUIRED = ("x", "y", "normal_x", "normal_y", VALUES[0])
_IN_SPACE = ("z", "normal_z")
_ANGLE = "angle"
BODIES = ("body_a", "body_b")
#: In small letters.
GROUND = ("", "ground", "fixed", "world")
_KNOWN = (*BODIES, *_REQUIRED, *_IN_SPACE, _ANGLE, *VALUES[1:], PAD)
#: Usual names of columns; those of coordinates and normals have the letter of an axis.
_USUAL = USUAL | {"normal": _ANGLE, "torque": "tau", "moment": "tau", "body": BODIES[0]}
_USUAL_AXES = {"": "p pos position point contact", "normal_": "n normal", "f_": "f force"}
_USUAL |= {
    f"{word}{bar}{axis}": f"{prefix}{axis}"
    for prefix, words in _USUAL_AXES.items()
    for word, bar, axis in product(words.split(), ("", "_"), "xyz")
}
#: A name, and a unit in brackets or, of those known, behind a bar.
_BRACKETED = re.compile(r"(.*?)\s*[\[(]\s*([^\])]*?)\s*[\])]")
_SUFFIXED = re.compile(
    r"(.+?)(?:_| in )(mm|cm|m|um|µm|in|ft|N|kN|deg|rad|degrees|radians)", re.IGNORECASE
)
_DEGREES = ("deg", "degree", "degrees", "°", "")
#: The last ones are those of tables of shapes.
_LENGTHS = ("x", "y", "z", "radius", "x2", "y2")
_FORCES = ("preload", "adhesion", "f_x", "f_y", "f_z", "weight")
#: The index of the only contact of a line.
_FIRST = r"(?<=\w)\[0\](?= )"
#: A decimal as in most languages.
_COMMA = re.compile(r"[+-]?[0-9]*,[0-9]+(?:[eE][+-]?[0-9]+)?")
_COMMA_FREE = re.compile(r"[-+0-9./eE]+")
_SEPARATORS = (",", ";", "\t")
#: Characters in which the first line of a file is looked for.
_HEAD_SIZE = 2**16
#: Line numbers, and entries by column.
Rows: TypeAlias = Iterable[tuple[int, dict[str, str]]]
#: Makes contacts of points, normals and values by name.
Convert: TypeAlias = Callable[[list[Any], list[Any], list[dict[str, Any]]], Conversion]
#: Rounds normals of irrational length.
_EXACT: Convert = partial(
    converted, how=rounding(0, DEFAULT_TOLERANCE, DEFAULT_TOLERANCE, as_given=False)
)


def is_table(source: object) -> TypeGuard[str | os.PathLike[str]]:
    """Return whether a source is the path of a table: by its ending, or else by its first line."""
    if not isinstance(source, (str, os.PathLike)):
        return False
    ending = Path(os.fsdecode(source)).suffix.lower()
    if ending in ("", ".csv", ".json", ".tsv"):
        return ending in (".csv", ".tsv")
    return {"x", "y"} <= names_in(source)


def names_in(path: str | os.PathLike[str]) -> set[str]:
    """Return the names of columns that the first line of a file seems to have; none of no file."""
    place = Path(os.fsdecode(path))
    if not place.is_file():
        return set()  # what comes through a pipe can be read once
    try:
        with place.open(encoding="utf-8", errors="replace") as stream:
            return _names(stream.read(_HEAD_SIZE))
    except OSError:
        return set()  # what reads the file says why


def _names(text: str) -> set[str]:
    lines = (line for line in text.splitlines() if line.strip() and line.lstrip()[0] != "#")
    first = next(lines, "").strip()
    entries = re.split(r"[,;\t]", first) if set(first) & {*_SEPARATORS} else first.split()
    return {column_of(entry.strip('" '))[0] for entry in entries}


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
    return parse_csv(read_text(Path(path))[0], partial(converted, how=how))


def parse_csv(text: str, convert: Convert = _EXACT) -> Conversion:
    """Read a grasp from CSV text.

    >>> conversion = parse_csv("x,y,normal_x,normal_y,friction\\n-1,0,2,0,0.5\\n")
    >>> conversion.grasp.contacts[0].normal, conversion.exact
    ((Fraction(1, 1), Fraction(0, 1)), True)
    """
    table = Table(text)
    conversion = read_rows(table.contacts(), convert)
    remarks = (*conversion.remarks, *table.remarks)
    grasp = replace(conversion.grasp, units=table.units)
    return replace(conversion, grasp=grasp, remarks=remarks)


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
    table = Table(read_text(Path(path))[0])
    if BODIES[0] not in table.names:
        return None
    pairs: list[tuple[str, str | None]] = []
    how = rounding(0, tolerance, angle_tolerance, as_given)
    conversion = read_rows(table.contacts(), partial(converted, how=how), pairs=pairs)
    if len(conversion.grasp) != len(pairs):
        raise GraspError("pad is for one body; leave the column out")
    contacts = [BodyContact(*pair, c) for pair, c in zip(pairs, conversion.grasp, strict=True)]
    names = dict.fromkeys(name for pair in pairs for name in pair if name is not None)
    error = conversion.grasp.data_error
    return Assembly(names, contacts, table.units, error), conversion


def tangential_arrangement(text: str) -> Arrangement | None:
    """Return the tangential planes of a table of contacts; None for a text without its header.

    Raises:
        GraspError: as `parse_csv`, and where a normal had to be rounded.
    """
    if not {"normal_x", _ANGLE} & _names(text):
        return None
    conversion = parse_csv(text)
    if not conversion.exact:
        raise GraspError(
            "the table has normals without an exact length; equilibrium make csv writes a document "
            "with rounded ones, and reports the change"
        )
    return conversion.grasp.tangential_arrangement()


def pair_of(first: str, second: str) -> tuple[str, str | None]:
    """Return the bodies of a contact, None for the ground as the second.

    Raises:
        GraspError: the first is the ground, into which no normal points.
    """
    if first.lower() in GROUND:
        raise GraspError(
            f"body_a is {shown(first)}, the ground; exchange it with body_b, and let the normal "
            "point into body_a, away from the ground"
        )
    return first, None if second.lower() in GROUND else second


def read_rows(
    rows: Rows,
    convert: Convert = _EXACT,
    number: Callable[[str, str], Any] = rational,
    pairs: list[tuple[str, str | None]] | None = None,
) -> Conversion:
    """Return the contacts of some lines; errors name the line.

    Args:
        number: reads an entry of a column.
        pairs: is given the bodies of each contact; None refuses a table that has some.
    """
    lines, points, normals, values, pads = [], [], [], [], []

    def take(line: int, row: dict[str, str]) -> None:
        with _named(line):
            if pairs is not None:
                pairs.append(pair_of(*(row.pop(name) for name in BODIES)))
            angle, pad = (rational(row.pop(key, 0), key) for key in (_ANGLE, PAD))
            entries = {name: number(entry, name) for name, entry in row.items()}
        axes = "xyz" if "z" in entries else "xy"
        normal = [entries[name] for x in axes if (name := f"normal_{x}") in entries]
        lines.append(line)
        points.append([entries[x] for x in axes])
        normals.append(normal or direction_of(angle))
        values.append({name: entries[name] for name in VALUES if name in entries})
        pads.append(pad)

    def check(line: int, point: Any, normal: Any, value: dict[str, Any]) -> None:
        with _named(line):
            convert([point], [normal], [value])

    taken = list(rows)
    if pairs is None and any(BODIES[0] in row for _, row in taken):
        raise GraspError("the table has bodies; expected a grasp. `read_assembly` reads it")
    check_all(*(partial(take, *row) for row in taken))
    try:
        return completed(convert(points, normals, values), pads)
    except ValueError:
        check_all(*map(partial, [check] * len(lines), lines, points, normals, values))
        raise


@contextmanager
def _named(line: int) -> Iterator[None]:
    """Let errors name the line."""
    try:
        yield
    except ValueError as error:
        message = str(error).removeprefix("normals[0]: ")
        raise GraspError(f"line {line}: {re.sub(_FIRST, '', message)}") from None


def column_of(entry: str) -> tuple[str, str | None]:
    """Return the name of a column, and its unit if the entry states one.

    >>> column_of("x [m]"), column_of("Normal (deg)"), column_of("ny")
    (('x', 'm'), ('angle', 'deg'), ('normal_y', None))
    """
    match = _BRACKETED.fullmatch(entry.strip()) or _SUFFIXED.fullmatch(entry.strip())
    name, unit = match.groups() if match else (entry.strip(), None)
    plain = re.sub(r"[\s_-]+", "_", name.lower())
    return _USUAL.get(plain, plain if match or plain in _KNOWN else name), unit


class Table:
    """The text of a table.

    Attributes:
        names: of its columns.
        remarks: on a unit that stands alone, once rows are read.

    Raises:
        GraspError: a quotation mark in the first line is not closed.
    """

    def __init__(self, text: str) -> None:
        lines = ["" if line.lstrip().startswith("#") else line for line in io.StringIO(text)]
        first = next(filter(str.strip, lines), "")
        if not set(first) & {*_SEPARATORS} and len(first.split()) > 1:
            lines = [",".join(line.split()) for line in lines]
            first = ",".join(first.split())
        self._length, self._separator = text.count("\n"), max(_SEPARATORS, key=first.count)
        self._reader = csv.reader(lines, delimiter=self._separator, strict=True)
        self._columns = [(entry, *column_of(entry)) for entry in self._next_entries() or []]
        self.names = [name for _, name, _ in self._columns]
        self.remarks: tuple[str, ...] = ()

    def _next_entries(self) -> list[str] | None:
        """Return the entries of the next line that has some; None at the end."""
        try:
            rows = ([entry.strip() for entry in row] for row in self._reader)
            return next(filter(any, rows), None)
        except csv.Error as error:
            raise GraspError(f"line {self._reader.line_num}: {error}") from None

    def rows(self, check: Callable[[list[str]], None]) -> Rows:
        """Yield line numbers and entries by column, whose names a function may refuse.

        Raises:
            GraspError: units that do not fit together or their columns, or a line that does not
                fit the first one.
        """
        check(self.names)
        known = self._stated_units()
        if len(known) == 1:
            ((kind, unit),) = known.items()
            self.remarks = (
                f"only the unit of {kind} is stated, {unit}, so answers have none; state those of "
                "length and force, as in x [mm] and preload [N]",
            )
        while (entries := self._next_entries()) is not None:
            if len(entries) != len(self.names):
                raise GraspError(
                    f"line {self._reader.line_num} has {len(entries)} entries; the header has "
                    f"{len(self.names)}"
                )
            if self._separator != ",":
                entries = [x.replace(",", ".") if _COMMA.fullmatch(x) else x for x in entries]
            yield self._reader.line_num, dict(zip(self.names, entries, strict=True))

    def contacts(self) -> Rows:
        """Return the lines of a table of contacts."""
        ask_contacts(self._length)
        return self.rows(check_header)

    @property
    def units(self) -> Units | None:
        """The units, if the first line states those of length and of force."""
        known = self._stated_units()
        return Units(**known) if len(known) == 2 else None

    def _stated_units(self) -> dict[str, str]:
        """Return the units of length and force that the first line states."""
        known: dict[str, str] = {}
        for _, name, unit in self._columns:
            if unit and _kind(name):
                known.setdefault(_kind(name), unit)
        for entry, name, unit in self._columns:
            due, kind = "", _kind(name)
            if unit and kind and unit != known[kind]:
                due = f", others in {known[kind]}; nothing is converted, so expected one unit of "
                due += kind
            elif name == _ANGLE and (unit or "").lower() not in _DEGREES:
                due = "; expected degrees"
            elif name.startswith("friction") and unit not in (None, "", "-", "1"):
                due = (
                    "; expected friction, a number without a unit: of a friction angle its tangent"
                )
            elif name == "stiffness" and unit and len(known) == 2:
                wanted = f"{known['force']}/{known['length']}"
                if unit.replace(" ", "") != wanted:
                    due = f"; expected {wanted}, as the others"
            if due:
                raise GraspError(f"the column {shown(entry)} is in {unit}{due}")
        return known


def check_header(header: list[str], keys: tuple[str, ...] = ()) -> None:
    """Refuse missing, unknown and repeated columns.

    Args:
        keys: that lines may have besides in a table of many grasps, which are of one body each.
    """
    in_space = any(name in header for name in _IN_SPACE)
    required: tuple[str, ...] = (*_REQUIRED, *_IN_SPACE * in_space)
    where = "for contacts in space" if in_space else f"or {_ANGLE}, in degrees, for the normal"
    if _ANGLE in header:
        if both := [name for name in header if name.startswith("normal_")]:
            raise GraspError(f"the columns are {_ANGLE} and {both[0]}; keep one")
        required, where = ("x", "y", _ANGLE, VALUES[0]), "with a direction in degrees"
    if any(name in header for name in BODIES):
        required = (*BODIES, *required)
    allowed = [*keys, *_KNOWN[len(BODIES) * bool(keys) :]]
    unknown = [name for name in header if name not in allowed]
    missing = [name for name in required if name not in header]
    if angles := [name for name in unknown if "friction" in name and "angle" in name]:
        raise GraspError(f"the column {shown(angles[0])} is unknown; write friction, its tangent")
    if missing:
        near = unknown if len(unknown) == 1 else get_close_matches(missing[0], unknown, 1, 0.5)
        meant = f"; write it for {shown(near[0])}, if that is meant" if near else ""
        if all(map(_COMMA_FREE.fullmatch, header)):
            meant = ", since the first line has numbers alone; put a line of names before it"
        raise GraspError(
            f"the column {missing[0]} is missing{meant}. The first line must name "
            f"{', '.join(required)} ({where})"
        )
    if unknown:
        mistake, it = f"the column {shown(unknown[0])} is unknown", "it"
        if unknown[1:]:
            mistake, it = f"the columns {', '.join(map(shown, unknown))} are unknown", "them"
        remedy = f"leave {it} out, or name {it} one of"
        raise GraspError(str(refusal(mistake, unknown[0], allowed, remedy)))
    for name in header:
        if header.count(name) > 1:
            raise GraspError(f"the column {name} appears twice; keep one")


def table_text(grasp: Grasp) -> str:
    """Return a grasp as a table, which `parse_csv` reads back.

    Raises:
        GraspError: it has a pad, a thread, an outline or a bound on errors, for which a table has
            no place.

    >>> from equilibrium import Contact
    >>> print(table_text(Grasp([Contact([1, 0], [-1, 0], "1/2")])), end="")
    x,y,normal_x,normal_y,friction,stiffness,preload,adhesion
    1,0,-1,0,1/2,1,0,0
    """
    is_there = {
        "an outline": grasp.outline is not None,
        "bounds on errors": grasp.data_error is not None,
        "a pad": len(grasp.groups) != len(grasp),
        "a thread": any(contact.thread for contact in grasp),
    }
    if lost := [name for name, value in is_there.items() if value]:
        raise GraspError(f"the grasp has {lost[0]}, for which a table has no place; write .json")
    stated = {} if grasp.units is None else grasp.units.to_dict()
    axes = "xyz"[: grasp.dimension]
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    names = [*axes, *(f"normal_{x}" for x in axes), *VALUES]
    units = [stated.get(_kind(name)) for name in names]
    table.writerow(f"{x} [{unit}]" if unit else x for x, unit in zip(names, units, strict=True))
    for contact in grasp:
        numbers = (*contact.point, *contact.normal, *(getattr(contact, x) for x in VALUES))
        table.writerow(map(to_text, numbers))
    return text.getvalue()


def _kind(name: str) -> str:
    """Return what a column measures, where it states units for the others."""
    return "length" if name in _LENGTHS else "force" if name in _FORCES else ""
