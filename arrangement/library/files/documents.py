"""What a format of files is, and the own one: documents of arrangements, with a JSON Schema.

An arrangement::

    {"schema_version": 1, "planes": [["0", "1", "-1"], ["1", "0", "0"]], "offsets": ["0", "2"]}

with optional ``offsets``, ``dimension`` (needed only when there are no planes), ``names`` (one for
each plane, "" for none) and ``description``. Irrational entries are in a ``field``, and are lists
of the coefficients of the powers 1, a, a^2, ... of the root that it names (here the golden
ratio)::

    {"schema_version": 1, "planes": [["1", ["0", "1"]]],
     "field": {"minimal_polynomial": ["-1", "-1", "1"], "interval": ["1", "2"]}}

A convex polygon in R^2 is the arrangement of its sides, with it on the positive side of each::

    {"schema_version": 1, "polygon": [["0", "0"], ["1", "0"], ["0", "1"]]}

Segments in R^2 are a document of their own (`read_segments`), for each its two ends::

    {"schema_version": 1, "segments": [[["0", "0"], ["1", "0"]], [["0", "0"], ["1/2", "2"]]]}

A table with the columns ``x,y`` is such a polygon, one with ``x1,y1,x2,y2`` has segments, one with
``a,b,c`` lines ax + by = c, with ``a,b,c,d`` planes ax + by + cz = d; ``name`` may come first.

Packages above this one add further kinds of document that stand for an arrangement
(`arrangement.console.plugins`).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

from arrangement.arrangement import Arrangement
from arrangement.console.plugins import import_object, registry_entries
from arrangement.errors import InputError
from arrangement.library.files.json_files import (
    check_all,
    check_document,
    check_keys,
    check_list,
    kind_of,
    parse_json,
)
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, bit_size, rational, rational_vector, shown
from arrangement.planes.polygon import convex_polygon
from arrangement.segments import Segments

if TYPE_CHECKING:
    from arrangement.numbers.fields import NumberField

_Read: TypeAlias = Callable[[Mapping[str, Any]], Arrangement | Segments]
#: Of a document of the kind "planes"; the first two are needed.
KEYS = ("schema_version", "planes", "offsets", "dimension", "names", "description", "field")

_FORM = 'Normals n and offsets b of n . x = b are "planes": [[1, 0], [1, 1]], "offsets": [0, 1]'


def arrangement_of(document: Any, name: str) -> Arrangement:
    """Return the arrangement that a document called `name` stands for.

    Raises:
        InputError: for anything that is not exactly a valid document.
    """
    made = figure_of(document, name)
    if isinstance(made, Segments):
        raise InputError(f"{name} holds segments; read_segments, or arrangement count, takes them")
    return made


def figure_of(document: Any, name: str) -> Arrangement | Segments:
    """Return what a document called `name` stands for."""
    own: dict[str, _Read] = {"planes": _planes, "polygon": _polygon, "segments": _segments}
    others = registry_entries("documents")
    try:
        fields = check_document(document, [*own, *others], name)
    except InputError as error:
        if not isinstance(document, dict) or document.keys() & {*own, *others}:
            raise
        raise InputError(f"{error}. {_FORM}") from None
    kind = next(key for key in (*own, *others) if key in fields)
    made: Arrangement | Segments = (own.get(kind) or import_object(others[kind]))(fields)
    return made


def document_of_table(text: str, name: str) -> dict[str, Any] | None:
    """Return the document of a table with one of the headers above; None for another.

    Raises:
        InputError: a row that has not one entry for each column.
    """
    lines = [line for line in map(str.strip, text.splitlines()) if line and line[0] != "#"]
    head, *rows = [re.split(r"\s*[,;\t]\s*", line) for line in lines] or [[]]
    columns = [column.lower() for column in head]
    plain = columns[columns[:2] == ["name", "a"] :]
    if plain not in ([*"xy"], ["x1", "y1", "x2", "y2"], [*"abc"], [*"abcd"]):
        return None
    for row in rows:
        if len(row) != len(columns):
            raise InputError(
                f"{name}: {shown(','.join(row))} is not {','.join(columns)}; write numbers with "
                "commas between, and points in lines of a file or as 0,0; 4,0; 0,4"
            )
    if plain[0] == "a":
        first = len(columns) - len(plain)
        names = {"names": [row[0] for row in rows]} if first else {}
        planes = [row[first:-1] for row in rows]
        return {
            "schema_version": 1,
            "planes": planes,
            "offsets": [row[-1] for row in rows],
            **names,
        }
    if len(columns) == 2:
        return {"schema_version": 1, "polygon": rows}
    return {"schema_version": 1, "segments": [[row[:2], row[2:]] for row in rows]}


def _planes(document: Mapping[str, Any]) -> Arrangement:
    check_keys(document, KEYS[:2], KEYS[2:], "the arrangement")
    numbers = _reader(document)
    planes = check_list(document["planes"], "planes")
    lengths = (len(row) for row in planes if isinstance(row, (list, tuple)))
    budget.check_size(max(lengths, default=0), "coordinates", "planes")
    return with_all_faults(
        [numbers(row, f"planes[{i}]") for i, row in enumerate(planes)],
        numbers(document["offsets"], "offsets") if "offsets" in document else None,
        dimension=_dimension(document["dimension"]) if "dimension" in document else None,
        names=check_list(document.get("names", []), "names"),
    )


def with_all_faults(
    normals: Sequence[Any], offsets: Sequence[Any] | None = None, **more: Any
) -> Arrangement:
    """Return an arrangement; the error names all entries that are not numbers, not only one."""
    try:
        return Arrangement(normals, offsets, **more)
    except InputError:
        rows = {f"of normal {i}": row for i, row in enumerate(normals, 1)}
        check_all(
            *(
                partial(rational, entry, f"entry {k} {where}")
                for where, row in (rows | {"of the offsets": offsets or ()}).items()
                for k, entry in enumerate(row, 1)
                if isinstance(entry, str)
            )
        )
        raise


def _polygon(document: Mapping[str, Any]) -> Arrangement:
    check_keys(document, ("schema_version", "polygon"), KEYS[5:], "the polygon")
    numbers = _reader(document)
    corners = check_list(document["polygon"], "polygon")
    sides = convex_polygon([numbers(p, f"polygon[{i}]") for i, p in enumerate(corners)])
    return Arrangement(sides.normals, sides.offsets)


def _segments(document: Mapping[str, Any]) -> Segments:
    check_keys(document, ("schema_version", "segments"), KEYS[4:], "the segments")
    numbers = _reader(document)
    pairs = check_list(document["segments"], "segments")
    ends = [
        [
            numbers(p, f"segments[{i}][{k}]")
            for k, p in enumerate(check_list(pair, f"segments[{i}]"))
        ]
        for i, pair in enumerate(pairs)
    ]
    return Segments(ends, check_list(document.get("names", []), "names"))


def _reader(document: Mapping[str, Any]) -> Callable[[Any, str], list[Any]]:
    """Return what reads a list of numbers, which may be of the field of the document."""
    field = _field(document["field"]) if "field" in document else None

    def numbers(value: Any, where: str) -> list[Any]:
        entries = check_list(value, where)
        if set(map(type, entries)).isdisjoint((list, tuple)):
            return entries
        return [
            _of_field(x, field, f"{where}[{i}]") if isinstance(x, (list, tuple)) else x
            for i, x in enumerate(entries)
        ]

    return numbers


def _field(value: Any) -> NumberField:
    from arrangement.numbers.fields import NumberField

    keys = ("minimal_polynomial", "interval")
    check_keys(value, keys, (), "the field")
    return NumberField(*(check_list(value[key], key) for key in keys))


def _of_field(value: Any, field: NumberField | None, where: str) -> Any:
    """Return the number with these coefficients of the powers of the root."""
    if field is None:
        raise InputError(
            f'{where} is a list, which is a number of a field; add the key "field" with a minimal '
            "polynomial and an interval, or write a rational number"
        )
    number: Any = 0
    if not 0 < len(value) <= field.degree:
        raise InputError(
            f"{where} has {len(value)} coefficients; a number of this field has 1 to {field.degree}"
        )
    coefficients = rational_vector(value, where)
    budget.spend(sum(bit_size(c) for c in coefficients) ** 1.5 / 500)
    for c in reversed(coefficients):
        number = number * field.root + c
    return number


def _dimension(value: Any) -> int:
    most = budget.max_size("coordinates")
    if type(value) is not int or not 0 <= value <= most:
        raise InputError(f"dimension is {kind_of(value)}; expected an integer from 0 to {most}")
    return value


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
    """Parse a JSON object, which may have floats where they are ignored."""
    data = parse_json(text, "the file", floats=float)
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
