"""The table of formats, the one reader of files, and conversion."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.console.plugins import import_object, registry_entries
from arrangement.console.writing import document_text, write_text_atomically
from arrangement.errors import InputError
from arrangement.hints import hints_on_arguments
from arrangement.library.files.content import content_kind
from arrangement.library.files.documents import Format
from arrangement.library.files.json_files import Source, parse_json, read_text
from arrangement.numbers import budget
from arrangement.numbers.exact import shown
from arrangement.planes.equation_text import is_equation
from arrangement.segments import Segments
from arrangement.synonyms import FILES

from . import documents


def _of_others() -> Iterable[Format]:
    """Return the formats of other programs, unless that optional package is absent."""
    name = "arrangement.library.files.others"
    return import_module(name).formats() if find_spec(name) else ()


#: By name. On reading the first that recognises a text is taken; what none does is a document.
FORMATS: dict[str, Format] = {
    form.name: form
    for form in (
        Format(
            "json",
            (".json",),
            read=lambda text: documents.arrangement_of(parse_json(text, "it"), "it"),
            write=lambda arrangement: document_text(arrangement.to_dict()),
        ),
        *_of_others(),
    )
}
#: Points, in place of a file.
_CORNERS = re.compile(r"(?=[^,]*,)[-+0-9./,;()\[\]\s]+")
#: Normals, in place of a file.
_NORMALS = re.compile(r"\s*[\[(]\s*[\[(][-+0-9./,;()\[\]\s]+|\s*\[[^\[]*\]\s*,\s*\[.*\]\s*")
_ROWS = re.compile(r"(?=.*;)(?=.*[0-9][\s,]+[-+.]*[0-9])[-+0-9./,;|\s]+")
_OF_FLOATS = "Decimals in lines of a text file, as 0.5 1 | 0.25, are exact numbers"
_BY_ENDING = {ending: form for form in FORMATS.values() for ending in form.endings}


@hints_on_arguments(FILES)
def read_arrangement(source: Source) -> Arrangement:
    """Read an arrangement from a path, ``"-"`` (stdin), a built-in name or a mapping.

    Equations, as in ``"x = 0; x + y = 1"``, or normals, as in ``"[[1, 0], [1, 1]]"``, may stand in
    place of a path. Which of the formats a text is in is seen from the text. A grasp file (or name,
    or table of contacts) is accepted too, when the package that knows grasps is installed: its
    tangential planes are meant.

    Raises:
        InputError: for anything that is not exactly a valid text of one arrangement.

    >>> read_arrangement({"schema_version": 1, "planes": [["0", "1", "-1"], ["0", "-1", "-1"]]})
    <Arrangement: 2 planes (2 distinct) in R^3, rank 2, central>
    """
    if isinstance(source, Mapping):
        return documents.arrangement_of(dict(source), "the document")
    made: Arrangement = read_with_rest(source)[0]
    return made


def read_polygon(source: str) -> Arrangement:
    """Read the sides of a polygon as `read_arrangement` does, or from corners ``0,0; 4,0; 0,4``."""
    if not _CORNERS.fullmatch(source) or os.path.lexists(source):
        return read_arrangement(source)
    plain = re.sub(r"[\])]\s*,\s*[\[(]", ";", source).strip("()[]; ")
    points = re.split(r"[;\s]+", re.sub(r"\s*,\s*", ",", plain))
    table = documents.document_of_table("\n".join(["x,y", *points]), shown(source))
    return documents.arrangement_of(table, shown(source))


def read_segments(source: Source) -> Segments:
    """Read segments of the plane from a path, ``"-"`` (stdin) or a mapping.

    Raises:
        InputError: for anything that is not exactly a valid document of segments.

    >>> read_segments({"schema_version": 1, "segments": [[["0", "0"], ["1", "1/2"]]]})
    <Segments: 1 in R^2>
    """
    made = read_figure(source)
    if not isinstance(made, Segments):
        raise InputError(f"{shown(source)} holds {made!r}; read_arrangement takes it")
    return made


def read_figure(source: Source) -> Arrangement | Segments:
    """Read an arrangement as `read_arrangement` does, or segments."""
    if isinstance(source, Mapping):
        return documents.figure_of(dict(source), "the document")
    made: Arrangement | Segments = read_with_rest(source, documents.figure_of)[0]
    return made


def read_with_rest(
    source: str | os.PathLike[str], read: Callable[[Any, str], Any] = documents.arrangement_of
) -> tuple[Any, str]:
    """Read an arrangement, and name what else a document of another kind has.

    Args:
        read: from a document and its name in messages.
    """
    text, name = _text_of(source)
    form = _form_of(text, Path(source).suffix.lower())
    if (table := documents.document_of_table(text, name)) is not None:
        return read(table, name), ""
    if not form.recognises(text) and not text.lstrip().startswith(("{", "[")):
        tables = (import_object(place)(text) for place in registry_entries("tables").values())
        if (table := next((x for x in tables if x is not None), None)) is not None:
            return table, ""
    kind = "" if form.recognises(text) else content_kind(text)
    is_words = kind and not (re.search("[0-9]", text) and kind.startswith("a text"))
    other = form.name == "json" or (form.name == "matrix" and is_words)
    if other and text.strip() and text.lstrip()[0] not in '{["' and not name.endswith(".json'"):
        raise InputError(
            f"{name} is {kind}. It is in none of the formats that are read: "
            f"{_format_names('read')}; expected such as lines of equations (x + y = 1) or of "
            "normals (1 1, with an offset 1 1 | 1)"
        )
    if form.name == "json":
        document = parse_json(text, name, of_floats=_OF_FLOATS)
        return read(document, name), ", ".join(
            key for key in document if key not in (*documents.KEYS, "polygon")
        )
    return Entries(form, text, name).only(), ""


def _text_of(source: str | os.PathLike[str]) -> tuple[str, str]:
    """Return a text and its name for messages: of a file, or what stands in its place."""
    if not isinstance(source, str) or os.path.lexists(source):
        return read_text(source)
    if _NORMALS.fullmatch(source) or _ROWS.fullmatch(source):
        return source.replace(";", "\n"), shown(source)
    forms = source.replace(",", ";")
    is_text = re.search("[=<>]", source) or (
        ";" in forms and all(map(is_equation, forms.split(";")))
    )
    if is_text and Path(source).suffix.lower() not in _BY_ENDING:
        return forms, shown(source)
    return read_text(source)


def _format_names(what: str) -> str:
    return ", ".join(form.name for form in FORMATS.values() if getattr(form, what))


def _form_of(text: str, ending: str) -> Format:
    """Return the format of a text, by its content; where that says nothing, by its ending."""
    known = next((form for form in FORMATS.values() if form.recognises(text)), None)
    return known or _BY_ENDING.get(ending, FORMATS["json"])


def entries_of(source: str | os.PathLike[str], form: str | None = None) -> Entries:
    """Return the arrangements of a file of several.

    Args:
        source: a path, or ``"-"`` for standard input.
        form: the name of its format; if omitted, it is seen from the text.
    """
    text, name = read_text(source, "bytes of a file of many arrangements")
    reader = format_named(form) if form else _form_of(text, Path(source).suffix.lower())
    return Entries(reader, text, name)


class Entries:
    """The arrangements that a text holds; each is made when it is asked for."""

    def __init__(self, form: Format, text: str, name: str) -> None:
        if form.read is None:
            raise InputError(
                f"the format {form.name} is only written; {_format_names('read')} are read"
            )
        self._where = f"{name}, read as {form.name}"
        self._read, self._form = form.read, form.name
        try:
            self._texts = form.split(text)
        except InputError as error:
            raise InputError(f"{self._where}: {error}") from None

    def __len__(self) -> int:
        return len(self._texts)

    def __getitem__(self, number: int) -> Arrangement:
        """Return the arrangement with this number, from 1 on."""
        if not 1 <= number <= len(self):
            raise InputError(f"the number is {number}; {self._where} has 1 to {len(self)}")
        try:
            arrangement = self._read(self._texts[number - 1])
            budget.check_size(arrangement.dimension, "coordinates")
            return arrangement
        except InputError as error:
            which = f", entry {number}" if len(self) > 1 else ""
            raise InputError(f"{self._where}{which}: {error}") from None

    def only(self) -> Arrangement:
        """Return the one arrangement, or say how to choose one of several."""
        if len(self) != 1:
            raise InputError(
                f"{self._where}: there are {len(self)} arrangements; choose one with "
                f"arrangement convert FILE --from {self._form} --number 1 -o ONE.json"
            )
        return self[1]


def format_named(name: str) -> Format:
    """Return the format of this name."""
    if name not in FORMATS:
        raise InputError(f"there is no format {shown(name)}; expected one of {', '.join(FORMATS)}")
    return FORMATS[name]


def format_of_file(path: str) -> Format:
    """Return the format that the ending of a file's name means."""
    ending = Path(path).suffix.lower()
    if ending not in _BY_ENDING:
        raise InputError(
            f"the file name ends in {shown(ending)}; expected one of {', '.join(_BY_ENDING)}. "
            "`arrangement convert --to NAME` takes any ending; `arrangement draw` and, in Python, "
            "draw().write(path) make pictures"
        )
    return _BY_ENDING[ending]


def text_in_format(arrangement: Arrangement, form: Format) -> str:
    """Return the text of an arrangement in a format.

    Raises:
        InputError: the format is only read, or cannot hold this arrangement.
    """
    if form.write is None:
        raise InputError(
            f"the format {form.name} is only read; {_format_names('write')} are written"
        )
    try:
        return form.write(arrangement)
    except InputError as error:
        raise InputError(f"cannot write {form.name}: {error}") from None


def save(arrangement: Arrangement, path: str | os.PathLike[str]) -> None:
    """Write a file in the format that its ending means, whole or not at all.

    Raises:
        InputError: no format has this ending, or the format cannot hold this arrangement.
    """
    write_text_atomically(path, text_in_format(arrangement, format_of_file(os.fspath(path))))


def to_sage(arrangement: Arrangement) -> str:
    """Return the source text of SageMath for an arrangement; errors as for `text_in_format`."""
    return text_in_format(arrangement, format_named("sage"))


def to_polymake(arrangement: Arrangement) -> str:
    """Return the document of polymake for an arrangement; errors as for `text_in_format`."""
    return text_in_format(arrangement, format_named("polymake"))
