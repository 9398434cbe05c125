"""The command ``equilibrium``: solve a grasp, verify a certificate."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from arrangement.console import terminal
from arrangement.console.number_form import counted
from arrangement.console.safe_text import printable
from arrangement.numbers.deadline import Deadline
from equilibrium.model.contact import pyramid_words
from equilibrium.model.displacement import displacement_words, read_displacement

from . import draw, inputs, methods, wrench_sets
from .arguments import (
    add_applied,
    add_command,
    add_cone,
    add_displacement,
    add_grasp,
    applied,
    grasp_of,
    seconds,
    show,
)
from .verdict_words import piece_lines, verdict_lines

if TYPE_CHECKING:
    from arrangement.numbers.exact import RationalVector
    from equilibrium.decide.verdict import Verdict
    from equilibrium.model.grasp import Grasp

#: Lines of the question of a proof.
_MOST_LINES = 21
#: The names of `printed_model.OPTIONS`, kept here so that ``--help`` loads no solver.
LITERAL = (
    "detachment",
    "preload",
    "signs",
    "cell-check",
    "all-stick",
    "coincident-planes",
    "single-solution",
)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code."""
    return terminal.run(_parser(), argv)


def _parser() -> terminal.Parser:
    parser = terminal.command_parser(
        "equilibrium", "Exact passive equilibrium of grasps with friction, with proofs."
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    solve = add_command(
        commands,
        "solve",
        _solve,
        "decide whether a grasp resists a wrench",
        "resisted",
        "not resisted",
        "undecided",
    )
    add_applied(solve)
    solve.add_argument(
        "--certificate",
        metavar="OUT.json",
        help="write the certificate here; with --robust the proof for all, if it holds",
    )
    solve.add_argument(
        "--time-limit",
        metavar="SECONDS",
        type=seconds,
        help="give up then: exit code 2, in space 3",
    )
    add_cone(solve)
    add_displacement(solve)
    solve.add_argument(
        "--robust",
        nargs="+",
        type=_bound,
        metavar="NAME=Q",
        help="also: does the verdict hold for all grasps within degrees=2 (of normals), length=Q "
        "(of points), friction=5%%, stiffness=Q, preload=Q? The exit code tells this: 0 proved, "
        "1 no, 3 undecided",
    )
    solve.add_argument(
        "--shorten", action="store_true", help="look longer for a smaller proof of a no"
    )
    solve.add_argument(
        "--all", action="store_true", help="list all equilibria of more than 20 contacts, too"
    )
    solve.add_argument(
        "--literal",
        nargs="+",
        action="extend",
        default=[],
        choices=LITERAL,
        metavar="OPTION",
        help="follow the printed text in these points: " + ", ".join(LITERAL),
    )
    verify = add_command(
        commands,
        "verify",
        _verify,
        "check a certificate without the solver",
        "valid",
        "not valid",
        grasp=False,
        numbers=False,
    )
    verify.add_argument("certificate", metavar="CERT.json", help="a path, or - for stdin")
    verify.add_argument(
        "--proved",
        action="store_true",
        help="ask the checker that is proved in Coq (built by `make formal`)",
    )
    add_grasp(verify, "--grasp")
    add_applied(verify, text="what the proof has to be about, with --grasp", required=False)
    add_cone(verify)
    add_displacement(verify)
    add_command(commands, "list", _list, "list the built-in grasps", grasp=False)
    wrench_sets.add_commands(commands)
    methods.add_commands(commands)
    inputs.add_commands(commands)
    draw.add_commands(commands)
    return parser


def _bound(text: str) -> tuple[str, str]:
    name, equals, value = text.partition("=")
    if not equals:
        raise argparse.ArgumentTypeError(f"{text[:60]!r} is no bound; give NAME=Q as degrees=2")
    return name, value


def _list(arguments: argparse.Namespace) -> int:
    from arrangement.library.files.json_files import described

    bodies = {name: f"(modes alone) {text}" for name, text in described("normals").items()}
    return terminal.print_names(described("contacts") | bodies, arguments.json)


def _solve(arguments: argparse.Namespace) -> int:
    from equilibrium.decide.solver import solve
    from equilibrium.model.errors import GraspError

    if arguments.literal and arguments.certificate is not None:
        raise GraspError("a literal reading has no certificate; omit one of the two options")
    grasp = grasp_of(arguments)
    wrench = applied(arguments, grasp)
    if arguments.literal:
        if arguments.max_displacement is not None:
            raise GraspError("a literal reading bounds no displacement; omit one of the two")
        literal = solve(grasp, wrench, as_printed=arguments.literal)
        lines = piece_lines(literal.equilibria, grasp)
        return show(arguments, literal.to_dict(), lines, literal.stable, grasp)
    bound, deadline = arguments.max_displacement, Deadline(arguments.time_limit)
    asked = {"shorten": arguments.shorten, "pyramid": arguments.cone, "max_displacement": bound}
    found = solve(grasp, wrench, time_limit=arguments.time_limit, **asked)
    if arguments.certificate is not None and found.certificate is not None:
        found.certificate.save(arguments.certificate)
    every = arguments.all or None
    lines = verdict_lines(found, every, arguments.certificate)
    yes = found.stable if found.decided else None
    return _answer(arguments, found, found.to_dict(every), lines, yes, deadline)


def _answer(
    arguments: argparse.Namespace,
    found: Verdict,
    document: dict[str, Any],
    lines: Iterable[str],
    yes: bool | None,
    deadline: Deadline,
) -> int:
    """Print a verdict with what other grasps within the error or within bounds say."""
    from equilibrium.certificate.uncertain import Bounds
    from equilibrium.decide import robustness
    from equilibrium.model.errors import GraspError

    lines = list(lines)
    if found.grasp.data_error is not None and arguments.robust is None:
        again = found.within_error()
        if again.turned is not None:
            lines, yes = [*again.lines(), f"as it was rounded: {lines[0]}", *lines[1:]], None
        else:
            lines += again.lines()
    if arguments.robust is not None:
        bounds = dict(arguments.robust)
        if len(bounds) < len(arguments.robust):
            raise GraspError("--robust has one bound twice; give each once")
        robust = robustness.robust(found, Bounds(**bounds), deadline)
        document["robust"] = robust.to_dict()
        lines += robust.lines()
        if arguments.certificate is not None and robust.certificate is not None:
            robust.certificate.save(arguments.certificate)
            lines.append("the certificate written is the proof for all of them")
        yes = True if robust else None if robust.turned is None else False
    return show(arguments, document, lines, yes, found.grasp)


def _verify(arguments: argparse.Namespace) -> int:
    from equilibrium.certificate.checker import Report
    from equilibrium.certificate.reading import read_question
    from equilibrium.grasps.files import read_certificate, verify, verify_proved
    from equilibrium.model.errors import GraspError

    path, question, known = arguments.certificate, _asked(arguments), True
    max_displacement = read_displacement(arguments.max_displacement)
    if arguments.proved:
        valid, kind = verify_proved(path)
        # What came on stdin only that program has read.
        known, problem = path != "-", "" if valid else f"this does not prove {kind}"
        if question is not None and not known:
            raise GraspError("with --proved a proof on stdin is compared with nothing; give a file")
        report = Report(kind, problem)
        if known:
            _, grasp, wrench = read_question(read_certificate(path))
            report = replace(report, grasp=grasp, wrench=wrench)
            report = report.asked(question, arguments.cone, max_displacement)
    else:
        report = verify(path, question, arguments.cone, max_displacement)
    speaker, left_out = ("proved", "leaves") if arguments.proved else ("Python", "")
    document = {k: value for k, value in report.to_dict().items() if k != left_out}
    if not known:
        del document["wrench"], document["grasp"]
    proof = report.kind + f", {counted(report.leaves, 'leaf', 'leaves')}" * bool(report.leaves)
    proof += pyramid_words(report.pyramid, before=", with ") + displacement_words(
        report.max_displacement
    )
    proof += f", for all {report.bounds}" if report.bounds is not None else ""
    said = f"valid: {proof}" if report else f"not valid: {printable(report.problem)}"
    lines = [f"{said} (by the {speaker} checker)", *report.question[: _MOST_LINES * known]]
    more = len(report.grasp) + 1 - _MOST_LINES
    lines += [f"... and {counted(more, 'contact')} more; --json has all"] * (more > 0)
    if not report.compared:
        lines.append("compared with no question: --grasp FILE --wrench W say what it should prove")
    shown = {**document, "checker": speaker.lower()}
    return show(arguments, shown, lines, bool(report), report.grasp)


def _asked(arguments: argparse.Namespace) -> tuple[Grasp, RationalVector] | None:
    """Return what a certificate has to be about, if that was given."""
    from equilibrium.model.errors import GraspError

    loads = ("wrench", "force", "weight", "at")
    names = ("grasp", *loads, "preload", "cone", "max_displacement")
    grasp, *load = (getattr(arguments, name) is not None for name in names)
    if grasp and any(load[:3]):
        wanted = grasp_of(arguments)
        return wanted, applied(arguments, wanted)
    if grasp or any(load) or arguments.round_normals:
        raise GraspError("a question is a grasp and a wrench; give --grasp FILE and --wrench W")
    return None


if __name__ == "__main__":
    raise SystemExit(main())
