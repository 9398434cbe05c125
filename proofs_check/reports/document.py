"""The report as a LaTeX document and as PDF, made from the JSON record of a run and only that.

A record may come from a file that someone else wrote: every text in it is escaped, formulas are
read first, and pictures are drawn afresh from its instances. pdflatex with the packages of
``texlive-latex-recommended`` and ``texlive-pictures`` compiles it.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from arrangement.console.number_form import counted
from arrangement.errors import MissingExtraError

from .page import MOST_CASES, WITHOUT, available, drawn
from .report import digest
from .tex_words import Tex, code, is_formula, prose, words
from .text import badge_text, remark, summary, value_text, verdict

Record = Mapping[str, Any]
Words = Callable[[str], Tex]
#: Cases listed of a claim that does not ask for all; letters of a value; letters across the page.
_CASES, _LONGEST, _LETTERS = 24, 300, 88
_PASSES = 5
_PDFLATEX = ("pdflatex", "-no-shell-escape", "-interaction=batchmode", "-halt-on-error")
#: Letters or digits without any sign between them, after which a long formula may break.
_RUN, _BREAK = re.compile(r"(?:[A-Za-z0-9] ?){30}"), r"\allowbreak "
#: What says that pdflatex is to run again.
_AGAIN = ("Rerun LaTeX", "Rerun to get", "Table widths have changed")


def latex(record: Record) -> str:
    """Return the report as a document that pdflatex compiles."""
    results = record["results"]
    pages = Environment(
        loader=PackageLoader(__package__),
        undefined=StrictUndefined,
        finalize=lambda value: value if isinstance(value, Tex) else words(str(value)),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        block_start_string="<%",
        block_end_string="%>",
        variable_start_string="<<",
        variable_end_string=">>",
        comment_start_string="<#",
        comment_end_string="#>",
    )
    pages.filters |= {"code": code, "displayed": _displayed, "prose": prose, "verdict": verdict}
    return pages.get_template("report.tex").render(
        record={"title": "", "about": "", **record},
        results=results,
        summary=summary(results),
        two_routes=all(len(result["routes"]) > 1 for result in results),
        overview=_overview(results),
        sections=[
            (name, list(group))
            for name, group in groupby(results, lambda result: result.get("section") or "")
        ],
        facts=_facts,
        tables=_tables,
        figures=_figures,
        ends=_ends(record),
        foot=f"seed {record['seed']}, {_versions(record)[0]}, SHA-256 {digest(record)[:16]}",
    )


def pdf(record: Record) -> bytes:
    """Return the document as PDF, the same bytes for the same record.

    Raises:
        MissingExtraError: pdflatex, or a package that it needs, is missing.
    """
    require_pdflatex()
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "report.tex").write_text(latex(record), encoding="utf-8")
        for _ in range(_PASSES):
            done = subprocess.run(
                [*_PDFLATEX, "report"],
                cwd=folder,
                env={**os.environ, "SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"},
                stdin=subprocess.DEVNULL,
                capture_output=True,
                check=False,
            )
            log = Path(folder, "report.log")
            told = log.read_text(encoding="latin-1") if log.exists() else ""
            if done.returncode:
                why = next((x[2:] for x in told.splitlines() if x.startswith("! ")), "no log")
                raise MissingExtraError(
                    f"pdflatex does not compile the report: {why}; write FILE.tex and compile it, "
                    f"{_DEBIAN}"
                )
            if not any(sign in told for sign in _AGAIN):
                break
        return Path(folder, "report.pdf").read_bytes()


_DEBIAN = (
    "with the packages texlive-latex-base, texlive-latex-recommended and texlive-pictures (Debian)"
)


def require_pdflatex() -> None:
    """Refuse when there is no pdflatex."""
    if shutil.which("pdflatex") is None:
        raise MissingExtraError(
            f"a report as PDF needs pdflatex, which is not here; install it {_DEBIAN}, or write "
            "FILE.tex"
        )


def _displayed(formula: str) -> Tex:
    if not is_formula(formula):
        return code(formula)
    return Tex(rf"\displayed{{{_RUN.sub(lambda run: run[0] + _BREAK, formula)}}}")


def _overview(results: Sequence[Record]) -> Tex:
    rows = [[r["id"], r["locator"], verdict(r), _cases(r)] for r in results]
    return _table(["claim", "where", "verdict", "checked"], rows, first=code)


def _cases(result: Record) -> str:
    table = result.get("table")
    if table and "checked" in table["columns"]:
        place = table["columns"].index("checked")
        return counted(sum(int(row[place]) for row in table["rows"]), "case")
    return counted(len(result["records"]), "case") if result["records"] else ""


def _facts(result: Record) -> Iterator[tuple[str, Tex]]:
    """Yield what a claim says and how it was checked, as names and texts."""
    yield "where", words(result["locator"])
    for text in result["hypotheses"]:
        yield "hypothesis", prose(text)
    if result.get("saving_hypothesis"):
        yield "holds when", prose(result["saving_hypothesis"])
    if result.get("quantity"):
        yield "computed", prose(result["quantity"])
    for i, name in enumerate(result["routes"], 1):
        yield f"route {i}", prose(name)
    for text in result["evidence"].split("; "):
        yield "evidence", prose(text)
    for badge in result.get("badges", []):
        yield "proved", words(badge_text(badge))
    if result["meaning"]:
        yield "meaning", prose(result["meaning"])


def _tables(result: Record) -> Iterator[Tex]:
    """Yield the numbers of each source, and the values of the routes beside each other."""
    if table := result.get("table"):
        yield _table(table["columns"], [[value_text(x) for x in row] for row in table["rows"]])
    cases, count = _chosen(result), len(result["records"])
    values = [x for case in cases for x in case["values"]]
    routes = range(1, len(result["routes"]) + 1)
    if len(routes) == 1 and all(isinstance(x, (bool, str)) for x in values):
        routes = range(0)  # a function that returns True or a reason: "holds" and "remark" say it
    rows = [
        [
            value_text(case["label"], _LONGEST),
            *(value_text(case["values"][k - 1], _LONGEST) for k in routes),
            "yes" if case["holds"] else "no",
            remark(case)[:_LONGEST],
        ]
        for case in cases
    ]
    heads = ["case", *(f"route {k}" for k in routes), "holds", "remark"]
    if not any(row[-1] for row in rows):
        rows, heads = [row[:-1] for row in rows], heads[:-1]
    if rows:
        yield _table(heads, rows)
    if len(cases) < count:
        yield words(f"({len(cases)} of {counted(count, 'case')}; the JSON record has all.)")


def _chosen(result: Record) -> list[Record]:
    """Return the cases to list: the counterexample first, then all or some, evenly spread."""
    records, smallest = result["records"], result.get("counterexample")
    count = min(MOST_CASES if result["rows"] else _CASES, len(records))
    places = [k * (len(records) - 1) // max(count - 1, 1) for k in range(count)]
    found = [records[k] for k in places]
    return [smallest, *found] if smallest and smallest not in found else found


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]], first: Words = prose) -> Tex:
    """Return a table: columns as wide as their texts, the widest ones as there is room."""
    lengths = [max(map(_length, column)) + 3.0 for column in zip(heads, *rows, strict=True)]
    left = float(_LETTERS)
    for done, k in enumerate(sorted(range(len(heads)), key=lengths.__getitem__)):
        lengths[k] = min(lengths[k], left / (len(heads) - done))
        left -= lengths[k]
    columns = "".join(f"L{{{length / _LETTERS:.3f}}}" for length in lengths)
    named = " & ".join(rf"\textbf{{{words(head)}}}" for head in heads)
    lines = [rf"{{\small\begin{{longtable}}[l]{{@{{}}{columns}@{{}}}}", r"\hline"]
    lines.append(rf"{named} \\ \hline\noalign{{\vskip2pt}}\endhead")
    for begin, *rest in rows:
        lines.append(rf"{' & '.join([first(begin), *map(prose, rest)])} \\")
    return Tex("\n".join([*lines, r"\hline", r"\end{longtable}}"]))


def _length(text: str) -> float:
    """Return how wide a text is, in letters."""
    return sum(1.6 if sign in "mw" or sign.isupper() else 1.0 for sign in text)


def _figures(result: Record) -> Iterator[tuple[Tex, str]]:
    """Yield pictures as TikZ with their captions; say so where they cannot be drawn."""
    if not available():
        if result.get("views") or (result.get("counterexample") or {}).get("instance"):
            yield words(WITHOUT), ""
        return
    for drawings, subject, name, options, caption in drawn(result):
        picture = drawings.tikz(subject, name, **options)
        if picture is not None:
            yield Tex(picture.partition("\n")[2].strip()), caption


def _versions(record: Record) -> list[str]:
    return [
        ", ".join(f"{name} {number}" for name, number in entry["versions"].items())
        for entry in record["environments"]
    ] or ["unknown versions"]


def _ends(record: Record) -> Iterator[tuple[str, Tex]]:
    yield "seed of the random instances", words(str(record["seed"]))
    for entry, versions in zip(record["environments"], _versions(record), strict=True):
        yield "versions", words(f"Python {entry['python']}, {versions}")
        yield "commit", code(entry["commit"] or "unknown")
    if record.get("date"):
        yield "date", words(record["date"])
    if record.get("command"):
        yield "to repeat", code(record["command"])
    yield "SHA-256 of statements, cases and values", code(digest(record))
