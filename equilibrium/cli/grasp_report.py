"""The report of ``equilibrium info``: data, closure, verdict and margin, as lines and as a page."""

from __future__ import annotations

import argparse
import base64
from collections.abc import Sequence
from fractions import Fraction
from html import escape
from itertools import chain
from textwrap import wrap
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import number, vector
from arrangement.console.writing import write_text_atomically
from arrangement.errors import OutOfReachError
from arrangement.numbers.exact import RationalVector
from equilibrium.model.contact import pyramid_words
from equilibrium.model.labels import AS_ROUNDED, ROUNDED

from .arguments import factors_text, show

if TYPE_CHECKING:
    from equilibrium.decide.verdict import Verdict
    from equilibrium.model.grasp import Grasp

#: Title and text of each line of the report, in the order in which they are printed.
Rows = list[tuple[str, str]]


def give_report(
    arguments: argparse.Namespace,
    grasp: Grasp,
    wrench: RationalVector | None,
    document: dict[str, Any],
    lines: Sequence[str],
) -> int:
    """Print the report, and write it as a page where one is wanted; return the exit code.

    Args:
        wrench: the load to decide, if there is one.
        document, lines: the description of the grasp, which comes first.
    """
    rows: Rows = [("units", str(grasp.units) if grasp.units else "not stated")]
    if grasp.data_error is not None:
        rows.append(("rounding", "numbers were rounded to exact ones; see the data error"))
    rows += _closure(grasp, document)
    yes: bool | None = True
    if wrench is not None:
        yes, more = _load(grasp, wrench, document)
        rows += more
    rows += [("remark", remark) for remark in arguments.remarks]
    if arguments.output is not None:
        write_text_atomically(arguments.output, _page(grasp, wrench, lines, rows))
    printed = (
        f"{title if k == 0 else '':<16} {line}"
        for title, text in rows
        for k, line in enumerate(text.splitlines())
    )
    return show(arguments, document, [*lines, *printed], yes, grasp)


def _closure(grasp: Grasp, document: dict[str, Any]) -> Rows:
    """Return form closure, and epsilon of the Grasp Wrench Space, as rows; add them."""
    from equilibrium.methods.form_closure import form_closure
    from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace

    document["form_closure"] = form_closure(grasp).accepts is True
    rows = [("form closure", "yes" if document["form_closure"] else "no")]
    try:
        space = GraspWrenchSpace(grasp)
        document["epsilon_squared"] = space.epsilon_squared
        cones = pyramid_words(space.pyramid, before="; of ") if grasp.dimension == 3 else ""
        stuck = "; without adhesion" if any(grasp.adhesion_wrench) else ""
        rows.append(("epsilon", f"{space.epsilon:.6g} (L1, torques over 1{cones}{stuck})"))
    except OutOfReachError:
        rows.append(("epsilon", "not computed: too many contacts"))
    return rows


def _load(grasp: Grasp, load: RationalVector, document: dict[str, Any]) -> tuple[bool | None, Rows]:
    """Return the verdict on a load and its margin, as rows; add them to the document."""
    from equilibrium.wrench_sets import ResistedSet

    from .resisted import end_lines
    from .verdict_words import verdict_lines

    resisted = ResistedSet(grasp)
    verdict: Verdict = resisted.solve(load)
    document |= {"wrench": load, "verdict": verdict.verdict}
    said = list(verdict_lines(verdict))
    yes = verdict.stable if verdict.decided else None
    if verdict.rounding is not None:
        document["within_error"] = verdict.rounding.to_dict()
        said.insert(0, verdict.rounding.words)
        yes = None if verdict.depends else yes
    rows = [("load", vector(load)), ("verdict", "\n".join(said))]
    if grasp.dimension == 2 and any(load):
        factors = resisted.margin(load)
        least = factors.preloads.least
        gives, ends = end_lines(resisted, factors.magnitudes)
        document |= {**factors.magnitudes.to_dict(), **gives, "least_preload": least}
        force = f" {grasp.units.force}" if grasp.units else ""
        margin = factors_text(factors.intervals)
        preload = "none is enough" if least is None else f"{number(least)}{force}"
        if grasp.data_error is not None:
            margin, preload = f"{margin}, {AS_ROUNDED}", f"{preload}, {ROUNDED}"
        rows += [("margin", "\n".join([margin, *ends])), ("least preload", preload)]
    return yes, rows


def _page(
    grasp: Grasp, wrench: Sequence[Fraction] | None, described: Sequence[str], rows: Rows
) -> str:
    """Return the report as one HTML page, with the picture where matplotlib is installed."""
    from arrangement.drawing.pages.html_page import BASE_STYLE, framed
    from equilibrium.pictures.views import DRAWINGS

    options: dict[str, Any] = {} if wrench is None else {"wrench": wrench}
    picture = DRAWINGS.of(grasp).svg(grasp, "grasp", **options)
    lines = (f"<dt>{escape(title)}</dt><dd>{_lines(text)}</dd>" for title, text in rows)
    body = [
        "<h1>Grasp report</h1>",
        _lines("\n".join(described)),
        f"<dl>{''.join(lines)}</dl>",
    ]
    if picture is not None:
        data = base64.b64encode(picture.encode("utf-8")).decode("ascii")
        source = f"data:image/svg+xml;base64,{data}"
        body.append(f'<figure><img alt="the grasp" src="{source}"></figure>')
    return framed("Grasp report", "\n".join(body), [BASE_STYLE], [])


def _lines(text: str) -> str:
    """Return a text as HTML; several lines keep their indents, and long ones are wrapped."""
    if "\n" not in text:
        return escape(text)
    lines = (wrap(line, 96, subsequent_indent=" " * 8) for line in text.splitlines())
    return f"<pre>{escape(chr(10).join(chain.from_iterable(lines)))}</pre>"
