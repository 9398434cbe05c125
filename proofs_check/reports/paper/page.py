"""All figures and tables of the paper as one HTML page and as single files, in one folder."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from arrangement.console.progress import watched
from arrangement.console.writing import make_folder, reason
from arrangement.drawing.output import LEGENDS, THEMES, own_settings
from arrangement.drawing.pages import BASE_STYLE, Template, html_document
from arrangement.drawing.scene import require_matplotlib
from arrangement.errors import InputError, extra
from arrangement.numbers.exact import shown
from proofs_check.reports.page import render, svg_for_page

from .figures import FIGURES
from .tables import TABLES, PaperTable, TableContent, Times, table_scene

with extra("report"):
    from markupsafe import Markup, escape

PAGE = "index.html"
SUFFIXES = (".svg", ".pdf", ".tex")
_STYLE: Template = ("proofs_check.reports.paper", "paper.css")


def file_names() -> list[str]:
    """Return the names of all files, the page first."""
    names = [*(figure.name for figure in FIGURES), *(table.name for table in TABLES)]
    return [PAGE, *(f"{name}{suffix}" for name in names for suffix in SUFFIXES)]


def write_paper(
    folder: str | os.PathLike[str],
    times: Times,
    about: Mapping[str, str],
) -> None:
    """Write every figure and table beside what the paper prints, all files or none.

    Args:
        folder: it is made. Files of an earlier run are replaced.
        times: the measured times of Table II.
        about: title and source of the paper, with the keys "title" and "about".

    Raises:
        InputError: the folder holds other files, or cannot be written.
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    target = Path(folder).resolve()
    _check_folder(target)
    make_folder(target.parent)
    try:
        # All files are made before one of them takes the place of an earlier one.
        with tempfile.TemporaryDirectory(prefix=".paper-", dir=target.parent) as place:
            new = Path(place)
            contents = {table.name: table.content(times) for table in TABLES}
            pictures = _write_pictures(new, contents)
            page = paper_page(pictures, contents, about)
            (new / PAGE).write_text(page, encoding="utf-8")
            target.mkdir(exist_ok=True)
            for path in new.iterdir():
                path.replace(target / path.name)
    except OSError as error:
        raise InputError(f"cannot write {shown(str(folder))}: {reason(error)}") from None


def _check_folder(target: Path) -> None:
    """Refuse a folder that holds what this command did not write."""
    if target.exists() and not target.is_dir():
        raise InputError(f"{shown(str(target))} is a file; name a folder")
    for path in sorted(target.iterdir()) if target.exists() else ():
        if path.name not in file_names():
            raise InputError(
                f"the folder {shown(str(target))} holds {shown(path.name)}, which is not a file of "
                "this command; name a new or an empty folder"
            )


def _write_pictures(folder: Path, contents: Mapping[str, TableContent]) -> dict[str, str]:
    """Write every figure and table in each format; return the SVG by name."""
    from arrangement.drawing.path_artist import finish, write_scene

    scenes = {}
    with own_settings():
        for figure in watched(FIGURES, "figures"):
            scenes[figure.name] = finish(figure.scene(), LEGENDS[0], THEMES[0])
        for name, content in contents.items():
            scenes[name] = finish(table_scene(content), LEGENDS[0], THEMES[0])
    for name, scene in scenes.items():
        for suffix in SUFFIXES:
            write_scene(folder / f"{name}{suffix}", lambda scene=scene: scene)  # type: ignore[misc]
    return {name: (folder / f"{name}.svg").read_text(encoding="utf-8") for name in scenes}


def paper_page(
    pictures: Mapping[str, str],
    contents: Mapping[str, TableContent],
    about: Mapping[str, str],
) -> str:
    """Return the page, from the SVG of every figure and the cells of every table."""
    body = render(
        (__package__, "paper.html"),
        {"cell": _cell},
        about=about,
        figures=[(part, Markup(svg_for_page(pictures[part.name], part.name))) for part in FIGURES],
        tables=[(part, contents[part.name]) for part in TABLES],
        suffixes=SUFFIXES,
    )
    policy = "; style-src-attr 'unsafe-inline'"
    return html_document("The paper, figure by figure", body, [BASE_STYLE, _STYLE], [], policy)


def _cell(text: str) -> Markup:
    """Return a cell; ``$f_1$`` has a lowered index."""
    if text.startswith("$"):
        letter, _, index = text.strip("$").partition("_")
        return Markup("<i>{}</i><sub>{}</sub>").format(letter, index)
    return Markup(escape(text))


def document(contents: Iterable[tuple[PaperTable, TableContent]], folder: str) -> dict[str, Any]:
    """Return a JSON form: the files, and the cells of the tables."""
    tables = {
        table.number: {
            "head": list(content.head),
            "rows": [{"by": row.by, "cells": list(row.cells)} for row in content.rows],
            "note": content.note,
        }
        for table, content in contents
    }
    return {"output": folder, "files": file_names(), "tables": tables}
