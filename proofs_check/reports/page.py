"""The report as one HTML page, made from the JSON record of a run and only that.

The page asks for nothing from outside. Its script searches and filters; without it all is there.
A record may come from a file that someone else wrote: the template escapes every text in it, and
pictures are drawn afresh from its instances.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any, TypeAlias

from arrangement.console.number_form import counted
from arrangement.console.safe_text import safe_lines
from arrangement.drawing.pages import BASE_STYLE, CARD_STYLE, Template, html_document
from arrangement.drawing.scene import require_matplotlib
from arrangement.drawing.views import Drawings
from arrangement.errors import InputError, MissingExtraError, extra
from arrangement.library.files.table import read_arrangement
from arrangement.pictures.views import DRAWINGS as OF_PLANES
from equilibrium.decide.solver import solve
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.views import DRAWINGS as OF_GRASPS
from proofs_check.reports.formula import mathml
from proofs_check.reports.report import run_facts
from proofs_check.reports.text import (
    also_tried,
    cells,
    conclusion,
    counts_by_strength,
    is_unexpected,
    left_out,
    strength,
    value_text,
)
from proofs_check.statements.statement import Strength

with extra("report"):
    from jinja2 import Environment, PackageLoader, StrictUndefined, UndefinedError
    from markupsafe import Markup

Record = Mapping[str, Any]


@dataclass(frozen=True)
class VerdictStyle:
    """How a page shows verdicts of one strength: their class, their sign and their words."""

    name: str
    sign: str
    words: str


KINDS = {
    worth: VerdictStyle(name, sign, worth.value if worth else "no verdict")
    for worth, name, sign in (
        (Strength.PROVED, "proved", "✓"),
        (Strength.ALL_CASES, "all-cases", "✓"),
        (Strength.SAMPLED, "sampled", "○"),
        (Strength.REFUTED, "refuted", "✗"),
        (None, "open", "?"),
    )
}
#: Cases that a page lists of one claim, how long a value may be in its tables, and the width in
#: points of a picture that takes a line of its own.
MOST_CASES, LONGEST, BROAD = 250, 90, 400
_STYLE: Template = ("proofs_check.reports", "report.css")
_SCRIPT: Template = ("proofs_check.reports", "report.js")


def html_page(record: Record) -> str:
    """Return one complete page: an overview, then a card for each claim.

    Raises:
        LookupError: the record is not complete.
    """
    try:
        body = _body(record)
    except UndefinedError as error:
        raise LookupError(str(error)) from None
    title = record.get("title") or "Verdicts"
    return safe_lines(
        html_document(
            title,
            body,
            [BASE_STYLE, CARD_STYLE, _STYLE],
            [_SCRIPT],
            "; style-src-attr 'unsafe-inline'",
        )
    )


def _body(record: Record) -> str:
    results = record["results"]
    kinds = [kind for kind in KINDS.values() if kind in set(map(_kind, results))]
    filters: dict[str, Callable[..., Any]] = {
        "anchor": lambda id: id.replace(" ", "-"),
        "formula": _formula,
        "counted": counted,
        "python": python_lines,
        "value": value_text,
        "conclusion": conclusion,
    }
    return render(
        (__package__, "report.html"),
        filters,
        record={"title": "", "about": "", "command": "", **record},
        sections=[
            (name, list(group))
            for name, group in groupby(results, lambda result: result.get("section") or "")
        ],
        counts=[(kind, *n) for kind, n in zip(kinds, counts_by_strength(results), strict=True)],
        number_of_cases=sum(len(result["records"]) for result in results),
        two_routes=all(len(result["routes"]) > 1 for result in results),
        is_unexpected=is_unexpected,
        differing=[result["id"] for result in results if is_unexpected(result)],
        facts=run_facts(record),
        most=MOST_CASES,
        also_tried=also_tried,
        cells=_cells,
        deciding=_deciding,
        figures=_figures,
        hint=_hint,
        left_out=left_out(record),
        kind_of=_kind,
        origins=_origins,
    )


def render(template: Template, filters: Mapping[str, Callable[..., Any]], **values: Any) -> str:
    """Return the body of a page, from a template that escapes every text in it.

    Raises:
        UndefinedError: the template names what is not there.
    """
    package, name = template
    pages = Environment(
        loader=PackageLoader(package),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    pages.filters |= filters
    return pages.get_template(name).render(**values)


def _kind(result: Record) -> VerdictStyle:
    return KINDS[strength(result)]


def _formula(text: str) -> Markup:
    try:
        return Markup(mathml(text))
    except InputError:
        return Markup("<code>{}</code>").format(text)


def _hint(result: Record) -> str:
    """Return what is said where pictures are missing, if there would be any."""
    instance = (result.get("counterexample") or {}).get("instance")
    return WITHOUT if (instance or result.get("views")) and not available() else ""


def _figures(result: Record) -> list[tuple[Markup, str, bool]]:
    """Return pictures, captions, and whether they are broad."""
    listed = []
    for svg, caption in pictures(result) if not _hint(result) else ():
        width = float(svg.partition('width="')[2].partition("pt")[0])
        listed.append((Markup(svg), caption, width > BROAD))
    return listed


def _deciding(result: Record) -> Sequence[Record]:
    """Return the cases whose values are shown beside each other: the counterexample, or three."""
    cases = result["records"]
    if result.get("counterexample"):
        return [result["counterexample"]]
    if not cases or result["rows"]:
        return []
    return [cases[k] for k in sorted({0, len(cases) // 2, len(cases) - 1})]


def _cells(case: Record) -> list[str]:
    return cells({**case, "label": value_text(case["label"], LONGEST)}, ("✓", "✗"), LONGEST)


def python_lines(result: Record) -> str:
    """Return three lines of Python that decide the claim again."""
    path, name = result.get("file"), json.dumps(result["id"])
    source, known = ("load", f"load({json.dumps(path)})") if path else ("registry", "registry()")
    seed = f", {result['seed']}" if result.get("seed") else ""
    return (
        f"from proofs_check import evaluate, {source}\n"
        f"result = evaluate({known}[{name}]{seed})\n"
        "print(result.verdict.value, result.evidence.counterexample, sep='\\n')"
    )


def _origins(result: Record) -> list[str]:
    """Return which pages of the sources have lesson and proof; the page is read far from them."""
    entries = []
    if result.get("section") and not result.get("file"):
        entries.append(f"Lessons 10 and 11 (docs/lessons): {result['id']}")
    if result.get("proof"):
        section, words = result["proof"]
        entries.append(f"Proof: docs/proofs.rst, {section}: {words}")
    return entries


#: What a page says where pictures are missing.
WITHOUT = "Pictures need matplotlib and shapely: pip install them, then make the report again."


def available() -> bool:
    """Return whether pictures can be drawn."""
    try:
        require_matplotlib()
    except MissingExtraError:
        return False
    return True


Drawn: TypeAlias = tuple[Drawings, Any, str, dict[str, Any], str]


def result_drawings(result: Record) -> Iterator[Drawn]:
    """Yield what the pictures of a result are: drawings, subject, view, its options, caption.

    Without views it is the counterexample: central planes with their dual; a grasp with its
    equilibrium, or with the proof that there is none.
    """
    counterexample = (result.get("counterexample") or {}).get("instance")
    for view in result.get("views") or [{"name": "", "caption": "", "options": {}}]:
        instance, name = view.get("instance") or counterexample or {}, view["name"]
        drawing: tuple[Drawings, Any, str, dict[str, Any]] | None = None
        if instance.get("planes"):
            known = {
                key: instance[key] for key in ("planes", "offsets", "field") if key in instance
            }
            planes = read_arrangement({"schema_version": 1, **known})
            if name or (planes.dimension == 3 and planes.is_central):
                drawing = (OF_PLANES, planes, name or "dual", view["options"])
        elif instance.get("contacts"):
            grasp = Grasp.from_dict({k: v for k, v in instance.items() if k != "wrench"})
            options = view["options"]
            if not name and "wrench" in instance:
                options = {"wrench": instance["wrench"]}
                name = "grasp" if solve(grasp, options["wrench"]).stable else "proof"
            drawing = (OF_GRASPS, grasp, name or "grasp", options)
        if drawing:
            label = (result.get("counterexample") or {}).get("label", "")
            yield (*drawing, view["caption"] or f"Counterexample: {label}")


def pictures(result: Record) -> Iterator[tuple[str, str]]:
    """Yield the pictures of a result as SVG for a page, and their captions."""
    for k, (drawings, subject, name, options, caption) in enumerate(result_drawings(result)):
        svg = drawings.svg(subject, name, **options)
        if svg is not None:
            yield svg_for_page(svg, f"{result['id']}-{k}"), caption


def svg_for_page(svg: str, name: str) -> str:
    """Return SVG that can stand in a page beside others: its names are its own."""
    opening, body = svg[svg.index("<svg") :].split(">", 1)
    opening = re.sub(r' (xmlns(:\w+)?|height|version)="[^"]*"', "", opening)
    body = re.sub(r"<metadata>.*?</metadata>|<style.*?</style>", "", body, flags=re.DOTALL)
    # Data of paths with two digits after the point, on fewer lines.
    body = re.sub(
        r' d="[^"]*"', lambda d: re.sub(r"(\.\d\d)\d+", r"\1", d[0]).replace("\n", ""), body
    )
    prefix = re.sub(r"[^a-z0-9-]", "", name)
    body = re.sub(r'( id="|url\(#|href="#)', rf"\g<1>{prefix}-", body)
    return f"{opening}>{body}"
