"""Contacts from measured or simulated data in floats, by exact snapping.

The JSON form of a file is ``{"schema_version": 1, "points": [[-0.1, 0], ...], "normals": [[1, 0],
...], "friction": 0.3}``, if wanted with ``stiffness``, ``preload`` and ``adhesion``; each of these
is one number for all contacts or a list. A grasp document with floats is read too. A CSV file has
the columns of `csv_file`, an NPZ file of NumPy the same as arrays. Numbers are decimals, also with
an exponent such as ``2.5e-3``, or ratios.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

from arrangement.hints import hints_on_arguments
from arrangement.library.files.json_files import Source, check_keys, check_list, read_text
from arrangement.numbers.arguments import entries
from arrangement.numbers.exact import (
    RationalVector,
    from_float,
    number_text,
    rational,
    rational_vector,
    shown,
)
from equilibrium.grasps.files import read_contacts
from equilibrium.grasps.npz_file import REQUIRED, is_npz, read_npz
from equilibrium.model.contact import VALUES
from equilibrium.model.errors import GraspError

from .conversion import (
    DEFAULT_TOLERANCE,
    Conversion,
    completed,
    contact_entries,
    contact_values,
    value_columns,
)
from .csv_file import Table, is_table, read_rows
from .incidences import check_number, converted, equal_numbers, rounding

#: No float is larger.
_LARGEST = Fraction(sys.float_info.max)
_DECIMAL = re.compile(r"[+-]?([0-9]{1,400}\.?[0-9]{0,400}|\.[0-9]{1,400})([eE][+-]?[0-9]{1,4})?")


@hints_on_arguments({})
def from_float_data(
    points: Iterable[Any],
    normals: Iterable[Any],
    friction: Any,
    *,
    stiffness: Any = None,
    preload: Any = 0,
    adhesion: Any = 0,
    tolerance: Any = DEFAULT_TOLERANCE,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
    as_given: bool = False,
) -> Conversion:
    """Return an exact grasp near float data, with the errors made.

    Every number becomes the simplest rational within the tolerance, so that 0.1 means 1/10. What
    contacts have in common within the tolerances they have exactly (`Conversion.kept`): normals
    that are parallel or meet, points on a circle or on a line along or across the normals, equal
    numbers.

    Args:
        points: (m, 2) contact points, (m, 3) in space.
        normals: (m, 2) or (m, 3) directions into the object, of any length.
        friction, stiffness, preload, adhesion: one for all or one for each contact; a stiffness
            that is not given is 1.
        tolerance: largest change of a coordinate, and of a friction, stiffness, preload or
            adhesion; where all of one of these are below 1, this share of the largest of them.
        angle_tolerance: largest tangent of the change of a normal's direction.
        as_given: round each number on its own.

    Raises:
        GraspError: wrong shapes, zero normals, values out of range, a stiffness or a
            whole grasp within the tolerance of 0.

    >>> from_float_data([[0.1, 0.2]], [[0.0, 2.0]], 0.3).grasp.contacts[0].point
    (Fraction(1, 10), Fraction(1, 5))
    """
    places = _vectors(points, "points", "points")
    for i, place in enumerate(places):
        if len(place) not in (2, 3):
            raise GraspError(f"points[{i}] has {len(place)} coordinates; give two or three")
    directions = _vectors(normals, "normals", "vectors")
    check_number(len(directions), len(places))
    bound = from_float(tolerance, "tolerance")
    how = rounding(bound, bound, angle_tolerance, as_given)
    size = max((abs(x) for place in places for x in place), default=Fraction(0))
    if bound / 10**6 < size <= bound:  # smaller ones are errors of floats
        raise GraspError(
            f"the largest coordinate is {number_text(size)}, which is 0 within the tolerance "
            f"{number_text(bound)}; give a smaller tolerance, or another unit of length"
        )
    values = friction, stiffness, preload, adhesion
    rows = contact_values(len(places), *values, read=_real)
    columns = {name: [entry[name] for entry in rows] for name in VALUES}
    sizes = (max(map(abs, column), default=0) for column in columns.values())
    snap, worst = bound * min([Fraction(1), *filter(None, sizes)]), Fraction(0)
    for name, column in columns.items():
        for i, x in enumerate(equal_numbers(column, snap, how)):
            if name == "stiffness" and x == 0 < column[i]:
                raise GraspError(
                    f"stiffness[{i}] is {number_text(column[i])}, which is 0 within the tolerance "
                    f"{number_text(snap)}; give a smaller tolerance, or 0"
                )
            worst, rows[i][name] = max(worst, abs(x - column[i])), x
    return converted(places, directions, rows, how, worst, snap)


def _real(value: Any, name: str) -> Fraction:
    """Return a number exactly that may be a float, by its size."""
    exact = from_float(value, name)
    if abs(exact) > _LARGEST:
        raise GraspError(
            f"{name} is {number_text(exact)}; expected a number up to 1.79e308, as floats are"
        )
    return exact


def _vectors(values: Any, name: str, kind: str) -> list[RationalVector]:
    listed = enumerate(entries(values, name, kind))
    return [rational_vector(x, f"{name}[{i}]", _real) for i, x in listed]


def read_float_data(
    source: Source,
    *,
    tolerance: Any = DEFAULT_TOLERANCE,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
    as_given: bool = False,
) -> Conversion:
    """Read float data from a CSV or NPZ file, by the ending of the path, or a JSON document.

    Raises:
        InputError: for anything that has not one of these forms; in a CSV file it names the line.
    """
    convert: Any = partial(
        from_float_data, tolerance=tolerance, angle_tolerance=angle_tolerance, as_given=as_given
    )
    if is_table(source):
        rows = Table(read_text(Path(source))[0]).contacts()
        return read_rows(rows, lambda x, y, values: convert(x, y, **value_columns(values)), _number)
    if is_npz(source):
        arrays = read_npz(source, (*REQUIRED, *VALUES[1:]), REQUIRED)
        if arrays["points"].ndim != 2:
            raise GraspError(
                f"{source} has points of shape {arrays['points'].shape}; expected (m, 2) or "
                "(m, 3). Arrays (G, m, 2) are many grasps, which `equilibrium solve` reads"
            )
        made: Conversion = convert(**{name: array.tolist() for name, array in arrays.items()})
        return made
    document = read_contacts(source, "points", floats=float)
    pads: list[Any] = []
    if "contacts" in document:
        listed, pads = contact_entries(document)
        check_keys(document, ("schema_version", "contacts"), ("description",), "the document")
        for i, entry in enumerate(listed):
            check_keys(entry, ("point", "normal", VALUES[0]), VALUES[1:], f"contacts[{i}]")
        vectors = {f"{key}s": [entry[key] for entry in listed] for key in ("point", "normal")}
        document = vectors | value_columns(listed)
    else:
        required = ("schema_version", "points", "normals", VALUES[0])
        check_keys(document, required, (*VALUES[1:], "description"), "the document")
    points, normals = (
        [
            [_plain(x, f"{key}[{i}]") for x in check_list(pair, f"{key}[{i}]")]
            for i, pair in enumerate(check_list(document[key], key))
        ]
        for key in ("points", "normals")
    )
    values = {
        key: [_plain(x, key) for x in value] if isinstance(value, list) else _plain(value, key)
        for key, value in document.items()
        if key in VALUES
    }
    conversion: Conversion = convert(points, normals, **values)
    return completed(conversion, pads) if pads else conversion


def _plain(value: Any, where: str) -> Any:
    """Return a JSON number or text; anything else is refused."""
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        raise GraspError(f"{where} is {shown(value)}; expected a number")
    return value


def _number(text: str, name: str) -> float | Fraction:
    """Return a decimal as the nearest float, anything else as `rational` reads it."""
    return float(text) if _DECIMAL.fullmatch(text) else rational(text, name)
