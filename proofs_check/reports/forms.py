"""Markdown, an HTML page and a LaTeX table, each made from the JSON record of a run and only that.

A record may come from a file that someone else wrote: every text in it is escaped for the form
that it goes into. The HTML page asks for nothing from outside and runs no script.
"""

from __future__ import annotations

import html
import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from arrangement.errors import InputError

from .pictures import picture
from .text import overview, remark, verdict

Record = Mapping[str, Any]

_STYLE = """
body{font:15px/1.45 system-ui,sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse;margin:1em 0}td,th{border:1px solid #ccc;padding:.3em .6em;
text-align:left;vertical-align:top}th{background:#f4f4f4}section{border-top:1px solid #ccc}
.holds{color:#1b6e34}.refuted{color:#b3261e}.unexpected{background:#fff3cd}
code{overflow-wrap:anywhere}figure{margin:1em 0}
"""


def markdown(record: Record) -> str:
    """Return the verdict table, then each claim with its tables, as Markdown."""
    lines = ["# Verdicts", "", *_markdown_table(*_overview(record))]
    for result in record["results"]:
        lines += ["", f"## {_markdown_text(result['id'])}", ""]
        for name, text in _facts(result):
            lines.append(f"- {name}: {_markdown_text(text)}")
        for columns, rows in _tables(result):
            lines += ["", *_markdown_table(columns, rows)]
        lines += _markdown_instance(result)
    return "\n".join([*lines, "", *map(_markdown_text, _footer(record)), ""])


def _markdown_instance(result: Record) -> list[str]:
    instance = (result.get("counterexample") or {}).get("instance")
    return ["", "```json", json.dumps(instance), "```"] if instance else []


def _markdown_table(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    cells = [[_markdown_text(cell) for cell in row] for row in (columns, *rows)]
    table = [cells[0], ["---"] * len(columns), *cells[1:]]
    return [f"| {' | '.join(row)} |" for row in table]


def _markdown_text(text: str) -> str:
    """Return text for one line of Markdown: no line breaks, no column ends, no raw HTML."""
    escaped = " ".join(text.split()).replace("\\", "\\\\").replace("|", "\\|")
    return escaped.replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_").replace("`", "\\`")


def html_page(record: Record) -> str:
    """Return one complete HTML page, with small pictures of the counterexamples."""
    parts = [
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width,initial-scale=1">',
        "<title>Verdicts</title>",
        f"<style>{_STYLE}</style></head><body><h1>Verdicts</h1>",
        _html_table(*_overview(record), [_css(result) for result in record["results"]]),
    ]
    for result in record["results"]:
        parts.append(f'<section id="{html.escape(result["id"])}"><h2>{_e(result["id"])}</h2><ul>')
        parts += [f"<li>{_e(name)}: {_e(text)}</li>" for name, text in _facts(result)]
        parts.append("</ul>")
        parts += [_html_table(columns, rows) for columns, rows in _tables(result)]
        parts.append(_figure(result))
        parts.append("</section>")
    parts += [f"<p>{_e(line)}</p>" for line in _footer(record) if line]
    return "\n".join([*parts, "</body></html>", ""])


def _figure(result: Record) -> str:
    instance = (result.get("counterexample") or {}).get("instance")
    if not instance:
        return ""
    code = f"<figcaption><code>{_e(json.dumps(instance))}</code></figcaption>"
    return f"<figure>{picture(instance)}{code}</figure>"


def _css(result: Record) -> str:
    name = "refuted" if result["verdict"] == "refuted" else "holds" if result["verdict"] else ""
    return name if result["as_expected"] else f"{name} unexpected"


def _html_table(
    columns: Sequence[str], rows: Iterable[Sequence[str]], classes: Sequence[str] = ()
) -> str:
    head = "".join(f"<th>{_e(name)}</th>" for name in columns)
    lines = [f"<table><thead><tr>{head}</tr></thead><tbody>"]
    for k, row in enumerate(rows):
        kind = f' class="{classes[k]}"' if classes else ""
        lines.append(f"<tr{kind}>{''.join(f'<td>{_e(cell)}</td>' for cell in row)}</tr>")
    return "\n".join([*lines, "</tbody></table>"])


def _e(text: str) -> str:
    return html.escape(text)


_LATEX = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "%": r"\%",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
}


def latex(record: Record) -> str:
    r"""Return the verdict table for ``\input`` in a document that loads the package longtable."""
    columns, rows = _overview(record)
    lines = [
        r"% needs \usepackage{longtable}",
        r"\begin{longtable}{p{0.2\linewidth}p{0.16\linewidth}p{0.14\linewidth}p{0.38\linewidth}}",
        r"\hline",
        " & ".join(columns) + r" \\ \hline\endhead",
    ]
    lines += [" & ".join(map(_latex_text, row)) + r" \\" for row in rows]
    return "\n".join([*lines, r"\hline", r"\end{longtable}", ""])


def _latex_text(text: str) -> str:
    return "".join(_LATEX.get(c, c) for c in " ".join(text.split()))


def _overview(record: Record) -> tuple[list[str], list[list[str]]]:
    rows = [[r["id"], r["locator"], verdict(r), r["evidence"]] for r in record["results"]]
    return ["claim", "locator", "verdict", "evidence"], rows


def _facts(result: Record) -> list[tuple[str, str]]:
    """Return what a claim says and how it was checked, as names and texts."""
    listed = [
        ("statement", result["statement"]),
        ("locator", result["locator"]),
        *(("hypothesis", text) for text in result["hypotheses"]),
        ("verdict", verdict(result)),
        ("evidence", result["evidence"]),
        *((f"route {i}", name) for i, name in enumerate(result["routes"], 1)),
        ("holds when", result.get("saving_hypothesis") or ""),
        ("meaning", result["meaning"]),
    ]
    if result.get("milliseconds") is not None:
        listed.append(("time", f"{result['milliseconds']} ms"))
    return [(name, text) for name, text in listed if text]


def _tables(result: Record) -> list[tuple[list[str], list[list[str]]]]:
    """Return the tables of a result: its own, and its cases where the claim asks for them."""
    found = []
    table = result.get("table")
    if table:
        found.append((table["columns"], [[_cell(c) for c in row] for row in table["rows"]]))
    if result.get("rows") and result["records"]:
        names = ["case", *result["routes"], "holds", "remark"]
        found.append((names, [_case(entry) for entry in result["records"]]))
    return found


def _case(entry: Record) -> list[str]:
    holds = "yes" if entry["holds"] else "no"
    return [entry["label"], *(_cell(value) for value in entry["values"]), holds, remark(entry)]


def _cell(value: Any) -> str:
    if isinstance(value, list):
        return f"({', '.join(_cell(item) for item in value)})"
    return value if isinstance(value, str) else json.dumps(value)


def _footer(record: Record) -> list[str]:
    lines = []
    for entry in record["environments"]:
        versions = ", ".join(f"{name} {number}" for name, number in entry["versions"].items())
        lines.append(f"Python {entry['python']}, {versions}, commit {entry['commit'] or 'unknown'}")
    good = "every verdict is as expected" if record["as_expected"] else "some verdict differs"
    return [f"Seed {record['seed']}; {good}.", "", *lines]


FORMS: dict[str, Callable[[Record], str]] = {
    ".json": lambda record: json.dumps(record, indent=1) + "\n",
    ".md": markdown,
    ".html": html_page,
    ".htm": html_page,
    ".tex": latex,
    ".txt": lambda record: overview(record) + "\n",
}


def form(ending: str) -> Callable[[Record], str]:
    """Return what makes the form that the ending of a file name says.

    Raises:
        InputError: no form has this ending.
    """
    if ending.lower() in FORMS:
        return FORMS[ending.lower()]
    raise InputError(f"a report ends with {', '.join(FORMS)}; got {ending!r}")
