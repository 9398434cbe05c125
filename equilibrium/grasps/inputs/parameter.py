"""Questions with one letter from files: JSON documents and tables of contacts."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from arrangement.library.files.json_files import Source, check_list, read_text
from equilibrium.grasps.files import decimal_text, read_contacts
from equilibrium.model.contact import VALUES
from equilibrium.model.errors import GraspError
from equilibrium.model.parameter import ParametricQuestion

from .conversion import PAD, with_usual_names
from .csv_file import BODIES, Table, is_table, pair_of

_RANGE = re.compile(r"\s*([A-Za-z]\w*)\s*=\s*(\S+?)\s*\.\.\s*(\S+?)\s*")


def read_range(text: str) -> tuple[str, str, str]:
    """Return letter and ends of text such as ``t=0..1``.

    Raises:
        GraspError: it has another form.
    """
    match = _RANGE.fullmatch(text)
    if match is None:
        raise GraspError(
            f"the parameter is {text[:60]!r}; expected a letter and its ends, as t=0..1"
        )
    return match[1], match[2], match[3]


def read_parametric(source: Source, letter: str = "t", wrench: Any = None) -> ParametricQuestion:
    """Read a question whose numbers may be expressions in a letter; see `question_document`."""
    return ParametricQuestion(question_document(source, wrench), letter)


def question_document(source: Source, wrench: Any = None) -> dict[str, Any]:
    """Read the document of a question whose numbers may be expressions.

    Args:
        source: a path, ``"-"`` (stdin), a built-in name or a mapping: a document of a grasp in the
            plane or of an assembly, whose wrench stands under the key "wrench"; or a path that ends
            with ``.csv``, a table of contacts, where angles and all numbers may have the letter.
        wrench: of a grasp, in place of that of its document; on its bodies of an assembly.

    Raises:
        InputError: for anything else.
    """
    if is_table(source):
        document = _of_table(Table(read_text(Path(source))[0]))
    else:
        document = dict(read_contacts(source, floats=decimal_text))
        contacts = check_list(document["contacts"], "contacts")
        document["contacts"] = [
            with_usual_names(entry, f"contacts[{i}]") for i, entry in enumerate(contacts)
        ]
    if wrench is not None:
        is_each = isinstance(wrench, Mapping)
        rows = {name: list(row) for name, row in wrench.items()} if is_each else list(wrench)
        document["wrench"] = rows
    if "wrench" not in document and "bodies" not in document:
        raise GraspError(
            'there is no wrench; give one, or write the key "wrench" into the document'
        )
    document.pop("description", None)
    return document


def _of_table(table: Table) -> dict[str, Any]:
    contacts, names = [], dict[str, None]()
    for line, row in table.contacts():
        if row.keys() & {"z", PAD}:
            raise GraspError(
                f"line {line}: a table with a letter has contacts in the plane, no pads; give "
                "a JSON document, whose points have a share"
            )
        entry: dict[str, Any] = {"point": [row["x"], row["y"]]}
        if "angle" not in row:
            entry["normal"] = [row["normal_x"], row["normal_y"]]
        entry |= {key: row[key] for key in ("angle", *VALUES) if key in row}
        if BODIES[0] in row:
            pair = pair_of(*(row[name] for name in BODIES))
            entry |= zip(BODIES, pair, strict=True)
            names |= dict.fromkeys(name for name in pair if name is not None)
        contacts.append(entry)
    return {"schema_version": 1, **({"bodies": list(names)} if names else {}), "contacts": contacts}
