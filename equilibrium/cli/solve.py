"""The subcommand ``equilibrium solve``: by the full model, as printed, or by other methods too.

Of a file of many grasps all questions are answered, in floats where these prove it.
"""

from __future__ import annotations

import argparse
import math
import re
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from arrangement.console import terminal
from arrangement.numbers import budget
from arrangement.numbers.deadline import Deadline
from equilibrium.model.errors import GraspError

from .arguments import (
    add_applied,
    add_command,
    add_cone,
    add_displacement,
    applied,
    force_given,
    grasp_of,
    seconds,
    show,
)
from .assemblies import add_on_body, assembly_document, assembly_question, solve_assembly
from .verdict_words import piece_lines, robustly, verdict_lines, with_rounding

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
#: Options of the verdict of the full model, which the other forms do not take.
_OF_THE_VERDICT = ("certificate", "time_limit", "max_displacement", "robust", "shorten", "all")
_WORDS = {True: "yes", False: "no", None: "-"}
#: What a mark of the comparison means, for those that it has.
_MARKS = {
    "-": "the method has no verdict on this wrench",
    "!": "another verdict than that of the full model",
}


def add_command_solve(commands: Any) -> None:
    """Add solve."""
    text = "decide whether a grasp, or an assembly of bodies, resists a wrench"
    answers = ("resisted", "not resisted", "undecided")
    parser = add_command(commands, "solve", _solve, text, *answers, heading="common")
    loads = add_applied(parser, required=False)
    add_on_body(loads)
    loads.add_argument(
        "--wrenches",
        metavar="FILE",
        help="of many grasps: the loads, a .csv with the columns f_x, f_y, tau (in space f_x to "
        "tau_z) and, if grasps have loads of their own, grasp; or a .npz with an array wrenches",
    )
    many = parser.add_argument_group(
        "many grasps (a .npz of arrays, or a .csv with a column grasp)"
    )
    many.add_argument(
        "-o", "--output", metavar="OUT", help="write the answers, as .csv or .npz (default: stdout)"
    )
    terminal.add_worker_options(many, shard=False)
    parser.add_argument(
        "--certificate",
        metavar="OUT.json",
        help="write the certificate; with --robust the proof for all grasps, if it holds",
    )
    parser.add_argument(
        "--time-limit",
        metavar="SECONDS",
        type=seconds,
        help="stop after SECONDS: exit code 2, in space 3",
    )
    add_cone(parser)
    add_displacement(parser)
    parser.add_argument(
        "--robust",
        nargs="+",
        type=_bound,
        metavar="NAME=Q",
        help="decide whether the verdict holds for all grasps within degrees=2 (of normals), "
        "length=Q (of points), friction=5%%, stiffness=Q, preload=Q; exit code 0 proved, 1 no, "
        "3 undecided",
    )
    parser.add_argument(
        "--shorten", action="store_true", help="search longer for a smaller proof of a no"
    )
    parser.add_argument(
        "--all",
        action="store_true",
        help="list all equilibria of more than 20 contacts, and of an assembly, too",
    )
    other = parser.add_mutually_exclusive_group()
    other.add_argument(
        "--methods",
        nargs="*",
        metavar="NAME",
        help="compare with other methods, such as weak or wrench-space (no name: all)",
    )
    other.add_argument(
        "--as-printed",
        nargs="+",
        action="extend",
        default=[],
        choices=AS_PRINTED,
        metavar="OPTION",
        help=f"follow the text as printed in the paper: {', '.join(AS_PRINTED)}",
    )


def _bound(text: str) -> tuple[str, str]:
    name, equals, value = text.partition("=")
    if not equals:
        raise argparse.ArgumentTypeError(f"{text[:60]!r}; expected NAME=Q such as degrees=2")
    return name, value


def _solve(arguments: argparse.Namespace) -> int:
    if arguments.wrenches is not None or _has_many(arguments.grasp):
        return _many(arguments)
    if arguments.output is not None or arguments.dask is not None or arguments.jobs != 1:
        raise GraspError("--output, --jobs and --dask are for many grasps; omit them")
    document = assembly_document(arguments)
    if document is None and arguments.on is not None:
        raise GraspError("--on is for an assembly; a grasp takes --wrench F_X F_Y TAU")
    if arguments.methods is not None:
        _refuse(arguments, "--methods", _OF_THE_VERDICT)
        return _by_methods(arguments, document)
    if document is not None:
        return solve_assembly(arguments, document)
    if arguments.as_printed:
        _refuse(arguments, "--as-printed", (*_OF_THE_VERDICT, "cone"))
        return _as_printed(arguments)
    return _by_full_model(arguments)


def _many(arguments: argparse.Namespace) -> int:
    """Decide the questions of a file of many grasps."""
    from equilibrium.decide.many_grasps import tables
    from equilibrium.decide.many_grasps.check import check_as_written

    alone = "on", "methods", "as_printed", "cone", "round_normals", "as_given"
    _refuse(arguments, "a file of many grasps", (*_OF_THE_VERDICT, *alone))
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
        tables.write_answers(arguments.output, many.names, checked)
    yes = None if checked.undecided.any() else True
    if (checked.asked & ~checked.resisted & ~checked.undecided).any():
        yes = False
    document: dict[str, Any] = {"grasps": many.names} | tables.answers_lists(checked)
    document |= {"as_rounded": True} if many.rounded else {}
    lines = tables.answers_csv(many.names, checked).splitlines()
    return show(arguments, document, [repr(checked)[1:-1]] if arguments.output else lines, yes)


#: Characters of a CSV file in which its header is looked for.
_HEAD = 2**16


def _has_many(path: str) -> bool:
    """Return whether a path is that of a file of many grasps, by its ending or its columns."""
    if not path.lower().endswith(".csv") or not Path(path).is_file():
        return path.lower().endswith(".npz")
    try:
        with Path(path).open(encoding="utf-8", errors="replace") as stream:
            lines = stream.read(_HEAD).splitlines()
    except OSError:
        return False  # what reads the grasp says why
    header = next((x for x in lines if x.strip() and not x.lstrip().startswith("#")), "")
    return "grasp" in re.split(r"[\s,;]+", header)


def _refuse(arguments: argparse.Namespace, form: str, options: tuple[str, ...]) -> None:
    """Refuse options that do not go with a form of the command."""
    for option in options:
        if getattr(arguments, option) not in (None, False, []):
            raise GraspError(f"{form} does not take --{option.replace('_', '-')}; omit one")


def _by_methods(arguments: argparse.Namespace, document: Mapping[str, Any] | None) -> int:
    """Print the verdict of the full model and of other methods."""
    from equilibrium.decide.solver import solve
    from equilibrium.grasps.inputs.documents import question_document
    from equilibrium.methods.compare import compare

    grasp: Any
    wrench: Any
    if document is not None:
        grasp, wrench = assembly_question(arguments, document)
    else:
        grasp = grasp_of(arguments)
        wrench = applied(arguments, grasp)
        question_document(grasp, wrench, "compare")
    comparison = compare(grasp, wrench, methods=arguments.methods or None, pyramid=arguments.cone)
    lines, document = list[str](), comparison.to_dict()
    yes = comparison.answers[0].accepts
    for answer in comparison.answers:
        mark = "!" if answer.method in comparison.disagreeing else " "
        lines.append(f"{mark} {_WORDS[answer.accepts]:<4}{answer.title:<60}{answer.remark}")
    marks = {line[0] for line in lines} | {line[2] for line in lines}
    lines += [f"{mark}  {text}" for mark, text in _MARKS.items() if mark in marks]
    if grasp.data_error is not None:
        rounding = solve(grasp, wrench, pyramid=arguments.cone).within_error()
        document["within_error"] = rounding.to_dict()
        lines += rounding.lines()
        yes = yes if rounding.turned is None else None
    return show(arguments, document, lines, yes, comparison.grasp)


def _as_printed(arguments: argparse.Namespace) -> int:
    """Print the verdict that follows from the text of the paper as printed."""
    from equilibrium.decide.solver import solve

    grasp = grasp_of(arguments)
    verdict = solve(grasp, applied(arguments, grasp), as_printed=arguments.as_printed)
    lines = piece_lines(verdict.equilibria, grasp)
    return show(arguments, verdict.to_dict(), lines, verdict.stable, grasp)


def _by_full_model(arguments: argparse.Namespace) -> int:
    """Print the verdict, and what it is within the error of the data or within bounds."""
    from equilibrium.decide.solver import solve

    grasp = grasp_of(arguments)
    wrench = applied(arguments, grasp)
    deadline = Deadline(arguments.time_limit)
    verdict = solve(
        grasp,
        wrench,
        time_limit=arguments.time_limit,
        shorten=arguments.shorten,
        pyramid=arguments.cone,
        max_displacement=arguments.max_displacement,
    )
    if arguments.certificate is not None and verdict.certificate is not None:
        verdict.certificate.save(arguments.certificate)
    every = arguments.all or None
    lines, document = (
        list(verdict_lines(verdict, every, arguments.certificate)),
        verdict.to_dict(every),
    )
    if arguments.robust is not None:
        yes = robustly(arguments, verdict, document, lines, deadline)
    else:
        lines, yes = with_rounding(verdict, lines)
    return show(arguments, document, lines, yes, verdict.grasp)
