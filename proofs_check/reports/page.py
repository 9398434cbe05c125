"""The report as one HTML page, made from the JSON record of a run and only that.

The page asks for nothing from outside. Its script searches and filters; without it all is there.
A record may come from a file that someone else wrote: every text in it is escaped, and pictures
are drawn afresh from its instances.
"""

from __future__ import annotations

import html
import json
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from typing import Any

from arrangement.draw.html_page import BASE_STYLE, Template, framed
from arrangement.errors import InputError

from .formula import mathml
from .pictures import WITHOUT, available, pictures
from .text import numbered, remark, value_text, verdict

Record = Mapping[str, Any]

#: Verdict -> its class, its sign, and what is said of one and of several.
KINDS = {
    "holds": ("holds", "✓", ("holds", "hold")),
    "holds under a hypothesis": (
        "hypothesis", "◐", ("holds under a hypothesis", "hold under a hypothesis")
    ),
    "refuted": ("refuted", "✗", ("is refuted", "are refuted")),
    None: ("open", "?", ("has no verdict", "have no verdict")),
}  # fmt: skip
#: Cases that a page lists of one claim, and how long a value may be in its tables.
MOST_CASES, LONGEST = 250, 90
_STYLE: Template = ("proofs_check.reports", "report.css")
_SCRIPT: Template = ("proofs_check.reports", "report.js")


def html_page(record: Record) -> str:
    """Return one complete page: an overview, then a card for each claim."""
    results = record["results"]
    sections = [(name, list(group)) for name, group in groupby(results, _section)]
    cards = [
        f"{_heading(name, k)}{''.join(map(_card, group))}"
        for k, (name, group) in enumerate(sections)
    ]
    body = (
        f'<header class="top">{_top(record)}</header>\n<div class="columns">\n'
        f'<nav aria-label="contents"><details open><summary>Contents</summary>'
        f"{''.join(_contents(name, group, k) for k, (name, group) in enumerate(sections))}"
        f"</details></nav>\n<main>{_controls(results)}{''.join(cards)}\n{_about(record)}</main></div>"
    )
    title = record.get("title") or "Verdicts"
    return framed(title, body, [BASE_STYLE, _STYLE], [_SCRIPT], "; style-src-attr 'unsafe-inline'")


def _section(result: Record) -> str:
    return result.get("section") or ""


Kind = tuple[str, str, tuple[str, str]]


def _kind(result: Record) -> Kind:
    return KINDS.get(result["verdict"], KINDS[None])


def _top(record: Record) -> str:
    results = record["results"]
    cases = sum(len(result["records"]) for result in results)
    counted = Counter(_kind(result) for result in results)
    parts = [(kind, counted[kind]) for kind in KINDS.values() if counted[kind]]
    bar = "".join(
        f'<span class="{css}" style="flex-grow:{number}"><b>{number}</b></span>'
        for (css, _, _), number in parts
    )
    legend = "".join(
        f'<li class="{css}"><i>{sign}</i> {number} {said[number > 1]}</li>'
        for (css, sign, said), number in parts
    )
    title = record.get("title") or "Verdicts"
    routes = "Each value is computed by two routes that share no code. " * all(
        len(result["routes"]) > 1 for result in results
    )
    differing = [result["id"] for result in results if not result["as_expected"]]
    other = f"Not as expected: {', '.join(differing)}." if differing else ""
    return (
        f'<p class="eyebrow">Verdicts{" on" * bool(record.get("title"))}</p>'
        f"<h1>{_e(title)}</h1><p>{_e(record.get('about') or '')}</p>"
        f'<div class="bar" role="img" aria-label="{_e(_said(parts))}">{bar}</div>'
        f'<ul class="legend">{legend}</ul>'
        f'<p class="lead">{numbered(len(results), "claim")}, {cases:,} cases. '
        f"{routes}{_e(other)}</p>"
        f"{_facts(record)}"
    )


def _said(parts: Iterable[tuple[Kind, int]]) -> str:
    return ", ".join(f"{number} {said[number > 1]}" for (_, _, said), number in parts)


def _facts(record: Record) -> str:
    """Return versions, commit, date, seed and the command that repeats the run."""
    facts = [("seed", str(record["seed"]))]
    if record.get("date"):
        facts.insert(0, ("date", record["date"]))
    for entry in record["environments"]:
        facts.append(("commit", entry["commit"] or "unknown"))
        versions = ", ".join(f"{name} {number}" for name, number in entry["versions"].items())
        facts.append(("with", f"Python {entry['python']}, {versions}"))
    listed = "".join(f"<dt>{name}</dt><dd>{_e(text)}</dd>" for name, text in facts)
    command = record.get("command")
    repeat = f'<p class="repeat">To repeat: <code>{_e(command)}</code></p>' if command else ""
    return f"{repeat}<dl>{listed}</dl>"


def _controls(results: Sequence[Record]) -> str:
    """Return the search and the filters, which the script shows."""
    found = set(map(_kind, results))
    buttons = "".join(
        f'<button type="button" data-verdict="{css}" aria-pressed="true"><i>{sign}</i> '
        f"{css}</button>"
        for css, sign, said in KINDS.values()
        if (css, sign, said) in found
    )
    return (
        '<div class="controls screen" hidden><input type="search" id="search" '
        'placeholder="search claims" aria-label="search claims">'
        f'{buttons}<button type="button" id="theme">colours: auto</button>'
        '<output id="shown"></output></div>'
    )


def _contents(name: str, results: Sequence[Record], k: int) -> str:
    heading = f'<h2><a href="#section-{k}">{_e(name)}</a></h2>' if name else ""
    entries = "".join(
        f'<li class="{css}"><i>{sign}</i><a href="#{_anchor(result)}">{_e(result["id"])}</a></li>'
        for result in results
        for css, sign, _ in [_kind(result)]
    )
    return f"{heading}<ul>{entries}</ul>"


def _heading(name: str, k: int) -> str:
    return f'\n<h2 class="section" id="section-{k}">{_e(name)}</h2>' if name else ""


def _anchor(result: Record) -> str:
    return html.escape(result["id"].replace(" ", "-"))


def _card(result: Record) -> str:
    css, sign, _ = _kind(result)
    wrong = " unexpected" * (not result["as_expected"])
    parts = [
        f'\n<article class="{css}{wrong}" id="{_anchor(result)}" data-verdict="{css}">',
        f'<header><h3><a href="#{_anchor(result)}">{_e(result["id"])}</a></h3>'
        f'<span class="where">{_e(result["locator"])}</span>'
        f'<span class="chip"><i>{sign}</i> {_e(verdict(result))}</span></header>',
        f'<p class="statement">{_e(result["statement"])}</p>',
        _formula(result.get("formula") or ""),
        _lines("Hypothesis", result["hypotheses"]),
        _lines("Holds when", filter(None, [result.get("saving_hypothesis")])),
        f'<div class="figures">{"".join(_figures(result))}</div>',
        _routes(result),
        _lines("Meaning", filter(None, [result["meaning"]])),
        _lines("Evidence", result["evidence"].split("; ")),
        _cases(result),
        _repeat(result),
        _sources(result),
        "</article>",
    ]
    return "\n".join(filter(None, parts))


def _formula(text: str) -> str:
    if not text:
        return ""
    try:
        return f'<div class="formula">{mathml(text)}</div>'
    except InputError:
        return f'<div class="formula"><code>{_e(text)}</code></div>'


def _lines(name: str, texts: Iterable[str]) -> str:
    entries = [f"<p>{_e(text)}</p>" for text in texts]
    return f'<div class="fact"><h4>{name}</h4>{"".join(entries)}</div>' if entries else ""


def _figures(result: Record) -> Iterator[str]:
    instance = (result.get("counterexample") or {}).get("instance")
    if (instance or result.get("views")) and not available():
        yield f'<p class="hint">{_e(WITHOUT)}</p>'
        return
    for svg, caption in pictures(result):
        words = caption or f"Counterexample: {result['counterexample']['label']}"
        broad = ' class="broad"' * (float(svg.partition('width="')[2].partition("pt")[0]) > 400)
        yield f"<figure{broad}>{svg}<figcaption>{_e(words)}</figcaption></figure>"


def _routes(result: Record) -> str:
    """Return the routes side by side, with their values on what decides."""
    cases = result["records"]
    shown = [result["counterexample"]] if result.get("counterexample") else []
    if cases and not shown and not result["rows"]:
        shown = [cases[k] for k in sorted({0, len(cases) // 2, len(cases) - 1})]
    if not shown:
        return ""
    quantity = result.get("quantity") or "value"
    names = "".join(f"<th>{_e(name)}</th>" for name in result["routes"])
    rows = "".join(f"<tr>{_case(case)}</tr>" for case in shown)
    return (
        f'<div class="fact"><h4>{_e(quantity)}, by {numbered(len(result["routes"]), "route")}</h4>'
        f'<div class="wide"><table class="routes"><thead><tr><th>case</th>{names}<th></th><th></th>'
        f"</tr></thead><tbody>{rows}</tbody></table></div></div>"
    )


def _case(case: Record) -> str:
    sign = "✓" if case["holds"] else "✗"
    values = (value_text(value, LONGEST) for value in case["values"])
    cells = (value_text(case["label"], LONGEST), *values, sign, remark(case))
    return "".join(f"<td>{_e(cell)}</td>" for cell in cells)


def _cases(result: Record) -> str:
    """Return the table of a result and all of its cases, folded."""
    folded = ""
    if table := result.get("table"):
        head = "".join(f"<th>{_e(name)}</th>" for name in table["columns"])
        rows = "".join(
            f"<tr>{''.join(f'<td>{_e(value_text(cell))}</td>' for cell in row)}</tr>"
            for row in table["rows"]
        )
        folded = _folded("Numbers", head, rows, unfold=not result["records"])
    cases = result["records"]
    if len(cases) > 3 or (result.get("counterexample") and cases):
        names = "".join(f"<th>{_e(name)}</th>" for name in ("case", *result["routes"], "", ""))
        rows = "".join(f"<tr>{_case(case)}</tr>" for case in cases[:MOST_CASES])
        beyond = len(cases) - MOST_CASES
        rest = f", the first {MOST_CASES} of them; the JSON record has all" * (beyond > 0)
        title = f"All {numbered(len(cases), 'case')}{rest}"
        folded += _folded(title, names, rows, unfold=result["rows"] and len(cases) <= 20)
    return folded


def _folded(title: str, head: str, rows: str, *, unfold: bool) -> str:
    return (
        f"<details{' open' * bool(unfold)}><summary>{_e(title)}</summary>"
        f'<div class="wide"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>'
        "</div></details>"
    )


def python_lines(result: Record) -> str:
    """Return three lines of Python that decide the claim again."""
    given, name = result.get("file"), json.dumps(result["id"])
    source, found = ("load", f"load({json.dumps(given)})") if given else ("registry", "registry()")
    seed = f", {result['seed']}" if result.get("seed") else ""
    return (
        f"from proofs_check import evaluate, {source}\n"
        f"result = evaluate({found}[{name}]{seed})\n"
        "print(result.verdict.value, result.evidence.counterexample, sep='\\n')"
    )


def _repeat(result: Record) -> str:
    lines = python_lines(result)
    return f"<details><summary>In Python</summary><pre><code>{_e(lines)}</code></pre></details>"


def _sources(result: Record) -> str:
    """Return which pages of the sources have lesson and proof; the page is read far from them."""
    entries = []
    if result.get("section") and not result.get("file"):
        entries.append(f"Lesson: docs/lessons/10-paper-and-truth.rst, {_e(result['id'])}")
    if result.get("proof"):
        section, words = result["proof"]
        entries.append(f"Proof: docs/proofs.rst, {_e(section)}: {_e(words)}")
    if result.get("milliseconds") is not None:
        entries.append(f'<span class="time">{result["milliseconds"]} ms</span>')
    return f"<footer>{' · '.join(entries)}</footer>" if entries else ""


def _about(record: Record) -> str:
    return (
        '<footer class="end"><p>A claim <b>holds</b> when no case contradicts it, <b>holds under a '
        "hypothesis</b> when every case that contradicts it is outside the hypothesis, and is "
        "<b>refuted</b> by one counterexample. <i>Proof</i>: for every size, with the proof named; "
        "<i>all cases</i>: every instance of the stated finite domain; <i>samples</i>: only on "
        "these.</p></footer>"
    )


def _e(text: str) -> str:
    return html.escape(str(text))
