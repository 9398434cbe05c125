"""The report of ``equilibrium info``: data, closure, verdict and margin, as lines and as a page."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import number, vector
from arrangement.console.writing import write_text_atomically
from arrangement.errors import OutOfReachError
from arrangement.numbers.exact import RationalVector
from equilibrium.model.contact import pyramid_words
from equilibrium.model.labels import AS_ROUNDED, ROUNDED

from .arguments import show

if TYPE_CHECKING:
    from arrangement.numbers.linear.intervals import Interval
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
    verdict: Verdict | None = None
    factors: Sequence[Interval] = ()
    if wrench is not None:
        verdict, factors, more = _load(grasp, wrench, document)
        yes = verdict.stable if verdict.decided and not verdict.depends else None
        rows += more
    rows += [("remark", remark) for remark in arguments.remarks]
    if arguments.output is not None:
        from equilibrium.pictures.report_page import report_page

        described = [(line[:17].strip(), line[17:]) for line in lines]
        page = report_page(grasp, [*described, *rows], verdict, factors, arguments.remarks)
        write_text_atomically(arguments.output, page)
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


def _load(
    grasp: Grasp, load: RationalVector, document: dict[str, Any]
) -> tuple[Verdict, Sequence[Interval], Rows]:
    """Return the verdict on a load, its factors, and both as rows; add them to the document."""
    from equilibrium.wrench_sets import ResistedSet
    from equilibrium.wrench_sets.text import end_lines, factors_text

    resisted = ResistedSet(grasp)
    verdict: Verdict = resisted.solve(load)
    document |= {"wrench": load, "verdict": verdict.verdict}
    said = verdict.lines()
    if verdict.rounding is not None:
        document["within_error"] = verdict.rounding.to_dict()
        said.insert(0, verdict.rounding.words)
    intervals: Sequence[Interval] = ()
    rows = [("load", vector(load)), ("verdict", "\n".join(said))]
    if grasp.dimension == 2 and any(load):
        factors = resisted.margin(load)
        intervals = factors.intervals
        least = factors.preloads.least
        gives, ends = end_lines(resisted, factors.magnitudes)
        document |= {**factors.magnitudes.to_dict(), **gives, "least_preload": least}
        force = f" {grasp.units.force}" if grasp.units else ""
        margin = factors_text(factors.intervals)
        preload = "none is enough" if least is None else f"{number(least)}{force}"
        if grasp.data_error is not None:
            margin, preload = f"{margin}, {AS_ROUNDED}", f"{preload}, {ROUNDED}"
        rows += [("margin", "\n".join([margin, *ends])), ("least preload", preload)]
    return verdict, intervals, rows
