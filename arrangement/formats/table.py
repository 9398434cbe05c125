"""The table of formats, the one reader of files, and conversion."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import cast

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.exact import shown
from arrangement.io.files import Source, parse_json, read_text
from arrangement.plugins import announced

from . import chirotope, christ, documents, graphs, macaulay2, matrix, oscar, polymake, sage
from .documents import arrangement_of
from .form import Format

#: By name. On reading the first that recognises a text is taken.
FORMATS: dict[str, Format] = {
    form.name: form
    for form in (
        documents.FORMAT,
        polymake.FORMAT,
        oscar.FORMAT,
        sage.FORMAT,
        macaulay2.FORMAT,
        chirotope.FORMAT,
        chirotope.TOPCOM,
        christ.FORMAT,
        matrix.FORMAT,
        *graphs.FORMATS,
    )
}
#: Largest file of many arrangements that is read.
MAX_IMPORT_BYTES = 64 * 2**20


def read_arrangement(source: Source) -> Arrangement:
    """Read an arrangement from a path, ``"-"`` (stdin), a built-in name or a mapping.

    Which of the formats a text is in is seen from the text. A grasp file (or name,
    or table of contacts) is accepted too, when the package that knows grasps is installed: its
    tangential planes are meant.

    Raises:
        InputError: for anything that is not exactly a valid text of one arrangement.

    >>> read_arrangement({"schema_version": 1, "planes": [["0", "1", "-1"], ["0", "-1", "-1"]]})
    <Arrangement: 2 planes (2 distinct) in R^3, rank 2, central>
    """
    if isinstance(source, Mapping):
        return arrangement_of(dict(source), "the document")
    text, name = read_text(source)
    form = next((form for form in FORMATS.values() if form.recognises(text)), None)
    if form is None:
        if not text.lstrip().startswith(("{", "[")):
            tables = (point.load()(text) for point in announced("tables"))
            if (found := next((x for x in tables if x is not None), None)) is not None:
                return cast(Arrangement, found)
        return arrangement_of(parse_json(text, name), name)
    return Entries(form, text, name).only()


class Entries:
    """The arrangements that a text holds; each is made when it is asked for."""

    def __init__(self, form: Format, text: str, name: str) -> None:
        if form.entries is None:
            known = ", ".join(form.name for form in FORMATS.values() if form.entries)
            raise InputError(f"the format {form.name} is only written; {known} are read")
        self._where = f"{name}, read as {form.name}"
        self._form = form.name
        try:
            self._makers = form.entries(text)
        except InputError as error:
            raise InputError(f"{self._where}: {error}") from None

    @classmethod
    def of_file(cls, form: str, source: str) -> Entries:
        """Read a file in the format of this name."""
        return cls(format_named(form), *read_text(source, MAX_IMPORT_BYTES))

    def __len__(self) -> int:
        return len(self._makers)

    def __getitem__(self, number: int) -> Arrangement:
        """Return the arrangement with this number, from 1 on."""
        if not 1 <= number <= len(self):
            raise InputError(f"the number is {number}; {self._where} has 1 to {len(self)}")
        try:
            return self._makers[number - 1]()
        except InputError as error:
            which = f", entry {number}" if len(self) > 1 else ""
            raise InputError(f"{self._where}{which}: {error}") from None

    def only(self) -> Arrangement:
        """Return the one arrangement, or say how to choose one of several."""
        if len(self) != 1:
            raise InputError(
                f"{self._where}: there are {len(self)} arrangements; choose one with "
                f"arrangement import {self._form} FILE --number 1 -o ONE.json"
            )
        return self[1]


def format_named(name: str) -> Format:
    """Return the format of this name."""
    if name not in FORMATS:
        raise InputError(f"there is no format {shown(name)}; known are {', '.join(FORMATS)}")
    return FORMATS[name]


def format_of_file(path: str) -> Format:
    """Return the format that the ending of a file's name means."""
    ending = Path(path).suffix.lower()
    for form in FORMATS.values():
        if ending in form.endings:
            return form
    known = ", ".join(e for form in FORMATS.values() for e in form.endings)
    raise InputError(
        f"the file name ends in {shown(ending)}; known are {known}. Or write --to NAME"
    )


def converted(arrangement: Arrangement, form: Format) -> str:
    """Return the text of an arrangement in a format.

    Raises:
        InputError: the format is only read, or cannot hold this arrangement.
    """
    if form.write is None:
        known = ", ".join(form.name for form in FORMATS.values() if form.write)
        raise InputError(f"the format {form.name} is only read; {known} are written")
    try:
        return form.write(arrangement)
    except InputError as error:
        raise InputError(f"cannot write {form.name}: {error}") from None
