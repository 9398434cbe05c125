"""The subcommand ``equilibrium solve``: by the full model, as printed, or by other methods too.

Of a file of many grasps all questions are answered, in floats where these prove it.
"""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arrangement.console import terminal
from arrangement.console.options import values
from arrangement.numbers import budget
from arrangement.numbers.deadline import Deadline
from equilibrium.model.errors import GraspError

from .arguments import (
    add_applied,
    add_command,
    add_cone,
    add_displacement,
    add_on_body,
    applied,
    bodies_of,
    force_given,
    grasp_of,
    show,
)
from .goes_with import ASSEMBLY, FULL_MODEL, GRASP, MANY, check_options

if TYPE_CHECKING:
    from equilibrium.decide.verdict import Verdict

#: The names of `decide.as_printed.OPTIONS`, kept here so that ``--help`` loads no solver.
AS_PRINTED = (
    "detachment",
    "preload",
    "signs",
    "cell-check",
    "all-stick",
    "coincident-planes",
    "single-solution",
)


def add_command_solve(commands: Any) -> None:
    """Add solve."""
    text = "decide stability: whether a grasp, or an assembly of bodies, resists a wrench"
    answers = ("resisted", "not resisted", "undecided")
    parser: Any = add_command(commands, "solve", _solve, text, *answers, heading="common")
    parser.usual = "--weight 1"
    loads = add_applied(parser)
    parser.strays[r"[^-].*\.(csv|npz)"] = "--wrenches FILE for loads"
    add_on_body(loads)
    text = (
        "for many grasps: the loads, a .csv with the columns f_x, f_y, tau (in space f_x to tau_z) "
        "and, if each grasp has its own loads, grasp; or a .npz with an array wrenches"
    )
    loads.add_argument("--wrenches", metavar="FILE", help=text)
    text = "many grasps (a .npz of arrays, or a .csv with a column grasp)"
    many = parser.add_argument_group(text)
    text = "write the answers, as .csv or .npz (default: stdout)"
    many.add_argument("-o", "--output", metavar="OUT", help=text)
    terminal.add_worker_options(many, shard=False)
    text = "write the certificate; with --robust the proof for all grasps, if there is one"
    parser.add_argument("--certificate", metavar="OUT.json", help=text)
    text = "stop after SECONDS with exit code 2, in space 3"
    parser.add_argument("--time-limit", metavar="SECONDS", type=values.seconds_argument, help=text)
    add_cone(parser)
    add_displacement(parser)
    text = (
        "decide whether the verdict holds for all grasps within degrees=2 (of normals), length=Q "
        "(of points), friction=5%%, stiffness=Q, preload=Q; exit code 0 proved, 1 no, 3 undecided"
    )
    parser.add_argument("--robust", nargs="+", type=_bound, metavar="NAME=Q", help=text)
    text = "search longer for a smaller proof that the load is not resisted"
    parser.add_argument("--shorten", action="store_true", help=text)
    text = "list all equilibria also of more than 20 contacts and of an assembly"
    parser.add_argument("--all", action="store_true", help=text)
    other = parser.add_mutually_exclusive_group()
    text = "compare with other methods, such as weak or wrench-space (no name: all)"
    other.add_argument("--methods", nargs="*", metavar="NAME", help=text)
    text = f"follow the text as printed in the paper: {', '.join(AS_PRINTED)}"
    style: dict[str, Any] = {"nargs": "+", "action": "extend", "default": [], "metavar": "OPTION"}
    other.add_argument("--as-printed", choices=AS_PRINTED, help=text, **style)


def _bound(text: str) -> tuple[str, str]:
    name, equals, value = text.partition("=")
    if not equals:
        raise argparse.ArgumentTypeError(f"{text[:60]!r}; expected NAME=Q such as degrees=2")
    return name, value


def _solve(arguments: argparse.Namespace) -> int:
    form, answer = FULL_MODEL, _by_full_model
    if arguments.methods is not None:
        form, answer = "--methods", _by_methods
    elif arguments.as_printed:
        form, answer = "--as-printed", _as_printed
    if arguments.wrenches is not None or _has_many(arguments.grasp):
        check_options(arguments, "solve", MANY, form)
        return _many(arguments)
    bodies = bodies_of(arguments)
    check_options(arguments, "solve", GRASP if bodies is None else ASSEMBLY, form)
    if bodies is not None:
        return answer(arguments, bodies.assembly, bodies.wrenches(arguments.on))
    grasp = grasp_of(arguments)
    return answer(arguments, grasp, applied(arguments, grasp))


def _many(arguments: argparse.Namespace) -> int:
    """Decide the questions of a file of many grasps."""
    from equilibrium.decide.many_grasps import tables
    from equilibrium.decide.many_grasps.check import check_as_written

    many = tables.read_grasps(arguments.grasp)
    if arguments.wrenches is not None:
        many = many.with_loads_of(arguments.wrenches)
    elif load := force_given(arguments, many.dimension) or arguments.wrench:
        many = many.with_loads([load])
    if not many.has_loads:
        raise GraspError("the grasps have no loads; give --wrenches FILE or --wrench F_X F_Y TAU")
    if arguments.preload is not None:
        many = many.with_preload(arguments.preload)
    for note in many.notes():
        print(f"note: {note}", file=sys.stderr)
    budget.allow(math.inf)  # it reports its progress
    checked = check_as_written(many.source, many.loads, jobs=arguments.jobs, dask=arguments.dask)
    if arguments.output is not None:
        tables.write_answers(arguments.output, many, checked)
    yes = None if checked.undecided.any() else True
    if (checked.asked & ~checked.resisted & ~checked.undecided).any():
        yes = False
    document: dict[str, Any] = {"grasps": many.names} | tables.answers_lists(checked)
    document |= {"as_rounded": True} if many.rounded else {}
    lines = tables.answers_csv(many, checked).splitlines()
    return show(arguments, document, [checked.summary] if arguments.output else lines, yes)


def _has_many(path: str) -> bool:
    """Return whether a path is that of a file of many grasps, by its ending or its columns."""
    from equilibrium.grasps.inputs.csv_file import names_in

    ending = Path(path).suffix.lower()
    return ending == ".npz" or (ending == ".csv" and "grasp" in names_in(path))


def _by_methods(arguments: argparse.Namespace, subject: Any, load: Any) -> int:
    """Print the verdict of the full model and of other methods."""
    from equilibrium.decide.solver import solve
    from equilibrium.grasps.inputs.documents import question_document
    from equilibrium.methods.compare import compare
    from equilibrium.model.grasp import Grasp

    if isinstance(subject, Grasp):
        question_document(subject, load, "compare")
    comparison = compare(subject, load, methods=arguments.methods or None, pyramid=arguments.cone)
    lines, document = list(comparison.lines()), comparison.to_dict()
    yes = comparison.answers[0].accepts
    if subject.data_error is not None:
        rounding = solve(subject, load, pyramid=arguments.cone).within_error()
        document["within_error"] = rounding.to_dict()
        lines += rounding.lines()
        yes = yes if rounding.turned is None else None
    return show(arguments, document, lines, yes, comparison.grasp)


def _as_printed(arguments: argparse.Namespace, subject: Any, load: Any) -> int:
    """Print the verdict that follows from the text of the paper as printed."""
    from equilibrium.decide.solver import solve
    from equilibrium.decide.verdict_text import piece_lines

    verdict = solve(subject, load, as_printed=arguments.as_printed)
    lines = piece_lines(verdict.equilibria, subject)
    return show(arguments, verdict.to_dict(), lines, verdict.stable, subject)


def _by_full_model(arguments: argparse.Namespace, subject: Any, load: Any) -> int:
    """Print the verdict, and what it is within the error of the data or within bounds."""
    from equilibrium.decide.solver import solve
    from equilibrium.decide.verdict_text import with_rounding

    deadline, path = Deadline(arguments.time_limit), arguments.certificate
    verdict = solve(
        subject,
        load,
        time_limit=arguments.time_limit,
        shorten=arguments.shorten,
        pyramid=arguments.cone,
        max_displacement=arguments.max_displacement,
    )
    if path is not None and verdict.certificate is not None:
        verdict.certificate.save(path)
    every = arguments.all or None
    document, lines = verdict.to_dict(every), verdict.lines(every, path)
    if arguments.robust is not None:
        yes = _robustly(arguments, verdict, document, lines, deadline)
    else:
        lines, yes = with_rounding(verdict, lines)
    if isinstance(document.get("equilibria"), dict):  # of an assembly: they are not known
        yes = None
    return show(arguments, document, lines, yes, subject)


def _robustly(
    arguments: argparse.Namespace,
    verdict: Verdict,
    document: dict[str, Any],
    lines: list[str],
    deadline: Deadline,
) -> bool | None:
    """Decide whether a verdict holds within bounds; add this to its document and lines."""
    from equilibrium.certificate.uncertain import Bounds
    from equilibrium.decide.robustness import robust

    bounds = dict(arguments.robust)
    if len(bounds) < len(arguments.robust):
        raise GraspError("--robust has one bound twice; give each once")
    robustness = robust(verdict, Bounds(**bounds), deadline)
    document["robust"] = robustness.to_dict()
    lines += robustness.lines()
    if arguments.certificate is not None and robustness.certificate is not None:
        robustness.certificate.save(arguments.certificate)
        lines.append("the certificate written is the proof for all of them")
    return True if robustness else None if robustness.turned is None else False
