"""The forms of a report, by the endings of files, each made from the JSON record of a run alone.

A record may come from a file that someone else wrote: every text in it is escaped for the form
that it goes into. Markdown is made here, the HTML page in `page`; a browser prints it as PDF.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from arrangement.console.safe_text import printable, safe_lines
from arrangement.errors import InputError

from .formula import is_formula
from .report import run_facts
from .text import (
    as_expected,
    cells,
    conclusion,
    facts,
    is_unexpected,
    left_out,
    overview,
    value_text,
)

Record = Mapping[str, Any]


def markdown(record: Record) -> str:
    """Return the verdict table, then each claim with its tables, as Markdown."""
    title = _markdown_text(record.get("title") or "Verdicts")
    rows = [[r["id"], r["locator"], conclusion(r), r["evidence"]] for r in record["results"]]
    head = ["claim", "locator", "verdict", "evidence"]
    lines = [f"# {title}", "", *_markdown_table(head, rows)]
    for result in record["results"]:
        lines += ["", f"## {_markdown_text(result['id'])}", ""]
        if is_formula(formula := result.get("formula") or ""):
            lines += [f"${formula}$", ""]
        for name, text in facts(result):
            lines.append(f"- {name}: {_markdown_text(text)}")
        for columns, rows in _tables(result):
            lines += ["", *_markdown_table(columns, rows)]
        if instance := (result.get("counterexample") or {}).get("instance"):
            lines += ["", "```json", json.dumps(instance), "```"]
    return "\n".join([*lines, "", *map(_markdown_text, _footer(record)), ""])


def _markdown_table(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    cells = [[_markdown_text(cell) for cell in row] for row in (columns, *rows)]
    table = [cells[0], ["---"] * len(columns), *cells[1:]]
    return [f"| {' | '.join(row)} |" for row in table]


def _markdown_text(text: str) -> str:
    """Return text for one line of Markdown: no line breaks, no column ends, no raw HTML."""
    escaped = printable(" ".join(text.split())).replace("\\", "\\\\").replace("|", "\\|")
    return escaped.replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_").replace("`", "\\`")


def _tables(result: Record) -> list[tuple[list[str], list[list[str]]]]:
    """Return the tables of a result: its own, and its cases where the claim asks for them."""
    tables = []
    table = result.get("table")
    if table:
        tables.append((table["columns"], [[value_text(c) for c in row] for row in table["rows"]]))
    if result.get("rows") and result["records"]:
        names = ["case", *result["routes"], "holds", "remark"]
        tables.append((names, [cells(case, ("yes", "no")) for case in result["records"]]))
    return tables


def _footer(record: Record) -> list[str]:
    seed = f"Seed {record['seed']}"
    if any(map(is_unexpected, record["results"])):
        seed += "; some verdict differs"
    elif words := as_expected("every verdict is", record["results"]):
        seed += f"; {words}"
    command = [("command", record["command"])] if record.get("command") else []
    made = [f"- {name}: {text}" for name, text in [*command, *run_facts(record)]]
    left = [line for text in left_out(record) for line in (text, "")]
    return [f"{seed}.", "", *left, *made]


def _html_page(record: Record) -> str:
    from .page import html_page

    return html_page(record)


FORMS: dict[str, Callable[[Record], str]] = {
    ".json": lambda record: json.dumps(record, indent=1) + "\n",
    ".md": markdown,
    ".html": _html_page,
    ".htm": _html_page,
    ".txt": lambda record: safe_lines(overview(record)) + "\n",
}


def form(ending: str) -> Callable[[Record], str]:
    """Return what makes the form that the ending of a file name says.

    Raises:
        InputError: no form has this ending.
        MissingExtraError: it needs a library that is not installed; claims are not run first.
    """
    if ending.lower() in (".pdf", ".tex"):
        raise InputError(
            f"a report is not written as {ending}; write .html and print it from a browser"
        )
    if ending.lower() not in FORMS:
        raise InputError(f"a report ends with {', '.join(FORMS)}; got {ending!r}")
    if FORMS[ending.lower()] is _html_page:
        from . import page  # noqa: F401
    return FORMS[ending.lower()]
