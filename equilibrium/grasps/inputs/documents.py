"""Grasps and assemblies from whatever names one: a document, a CSV file, a built-in name."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from arrangement.hints import hints_on_arguments
from arrangement.library.files.json_files import Source, check_keys, check_list
from arrangement.numbers import budget
from arrangement.numbers.exact import to_text
from arrangement.synonyms import FILES
from equilibrium.grasps.files import decimal_text, has_decimals, read_contacts
from equilibrium.model.assembly import Assembly
from equilibrium.model.contact import VALUES
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

from .conversion import (
    DEFAULT_TOLERANCE,
    Conversion,
    completed,
    contact_entries,
    unit_normals,
)
from .csv_file import BODIES, is_table, read_bodies, read_csv
from .incidences import converted, rounding


def question_document(grasp: Grasp, wrench: Any, taker: str) -> dict[str, Any]:
    """Return a grasp and a wrench as a document, for a taker that cannot do with long numbers.

    Raises:
        InputError: a number has more than 1000 digits.
    """
    load = [to_text(x) for x in grasp.read_wrench(wrench)]
    document = {"grasp": grasp.to_dict(), "wrench": load}
    longest = max(map(len, re.findall(r"[0-9]+", json.dumps(document))))
    budget.check_size(longest, "digits of a number on a page", taker)
    return document


def read_any(
    source: Source,
    *,
    round_normals: bool = False,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
    tolerance: Any = DEFAULT_TOLERANCE,
    as_given: bool = False,
) -> Conversion:
    """Read a grasp from a path, ``"-"`` (stdin), a built-in name or a mapping.

    Args:
        source: a table, by its ending ``.csv`` or its first line (see `csv_file`); others are
            documents, or lists of contacts as engines print them (`conversion.contact_entries`).
            A load in it, under the key "wrench", is for commands, and left out here.
        round_normals: replace normals of a document by near unit vectors; those of tables always
            are, and those of documents with decimals or angles.
        angle_tolerance, tolerance, as_given: as in `read_csv`, where normals are rounded.

    Raises:
        InputError: for anything that is not a grasp.

    >>> read_any("paper-three-contacts").exact
    True
    """
    if is_table(source):
        return read_csv(
            source, angle_tolerance=angle_tolerance, tolerance=tolerance, as_given=as_given
        )
    document = read_contacts(source, floats=decimal_text)
    listed = check_list(document["contacts"], "contacts")
    angles = any(isinstance(entry, Mapping) and "angle" in entry for entry in listed)
    contacts, pads = contact_entries(document)
    document = {key: value for key, value in document.items() if key != "wrench"}
    document["contacts"] = contacts
    if not (round_normals or angles or has_decimals(document)):
        return completed(Conversion(Grasp.from_dict(document), (), ()), pads)
    for i, contact in enumerate(contacts):
        check_keys(contact, ("normal",), contact, f"contacts[{i}]")
    directions = [contact["normal"] for contact in contacts]
    normals = unit_normals(directions, angle_tolerance)
    rounded = [
        {**contact, "normal": [to_text(x) for x in normal.normal]}
        for contact, normal in zip(contacts, normals, strict=True)
    ]
    grasp = Grasp.from_dict({**document, "contacts": rounded})
    whole = grasp.joined()
    conversion = converted(
        [contact.point for contact in whole],
        [directions[group.start] for group in grasp.groups],
        [{x: getattr(contact, x) for x in (*VALUES, "stiffness_given")} for contact in whole],
        rounding(0, tolerance, angle_tolerance, as_given),
        outline=grasp.outline,
    )
    conversion = replace(conversion, grasp=replace(conversion.grasp, units=grasp.units))
    return completed(conversion.of_points(grasp.spread(conversion.grasp), grasp.groups), pads)


@hints_on_arguments(FILES)
def read_grasp(source: Source) -> Grasp:
    """Read a grasp from a path, ``"-"`` (stdin), a built-in name or a mapping, as commands do.

    A file is a document, or a table with a contact on each line (`inputs.read_csv`). Numbers that
    have to be rounded, such as normals of irrational length, leave their bounds in
    `Grasp.data_error`, and verdicts speak of them; `inputs.read_any` returns each error.

    Raises:
        InputError: for anything that is not a grasp.

    >>> len(read_grasp("paper-three-contacts"))
    3
    """
    return read_any(source).grasp


def with_unit_normals(
    document: Mapping[str, Any], *, as_given: bool = False
) -> tuple[dict[str, Any], Conversion]:
    """Return the document of an assembly with near unit normals, and its contacts as one grasp.

    Raises:
        InputError: as `read_any`.
    """
    entries = check_list(document["contacts"], "contacts")
    for i, entry in enumerate(entries):
        check_keys(entry, BODIES, entry, f"contacts[{i}]")
    bare = [{key: x for key, x in row.items() if key not in BODIES} for row in entries]
    source = {"schema_version": 1, "contacts": bare}
    conversion = read_any(source, round_normals=True, as_given=as_given)
    contacts = [
        {**{key: row[key] for key in BODIES}, **contact.to_dict()}
        for row, contact in zip(entries, conversion.grasp, strict=True)
    ]
    error = conversion.grasp.data_error
    known = {} if error is None else {"data_error": error.to_dict()}
    return {**document, **known, "contacts": contacts}, conversion


@hints_on_arguments(FILES)
def read_assembly(source: Source) -> Assembly:
    """Read an assembly from a path, ``"-"`` (stdin) or a mapping; wrenches in it are left out.

    A table has a contact on each line, see `csv_file`.

    Raises:
        InputError: for anything that is not exactly a valid document or table.
    """
    if is_table(source):
        bodies = read_bodies(source)
        if bodies is None:
            raise GraspError(f"{source} has no columns body_a and body_b; expected an assembly")
        if not bodies[1].exact:
            raise GraspError(
                f"{source} has normals without an exact length; `equilibrium make csv` writes a "
                "document with rounded ones, and reports the change"
            )
        return bodies[0]
    return Assembly.from_dict(read_contacts(source))
