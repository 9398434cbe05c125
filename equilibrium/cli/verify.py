"""The subcommand ``equilibrium verify``: a certificate, checked without the solver."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import counted
from arrangement.console.safe_text import printable
from equilibrium.model.contact import pyramid_words
from equilibrium.model.displacement import displacement_words, read_displacement
from equilibrium.model.errors import GraspError
from equilibrium.model.solution import numbering_words

from .arguments import (
    add_applied,
    add_command,
    add_cone,
    add_displacement,
    add_grasp,
    applied,
    bodies_of,
    force_given,
    grasp_of,
    has_load,
    show,
)
from .goes_with import ASSEMBLY, check_options

if TYPE_CHECKING:
    from equilibrium.certificate.report import Report

#: Lines of the question of a proof.
_MOST_LINES = 21


def add_command_verify(commands: Any) -> None:
    """Add verify."""
    text = "check a certificate without the solver"
    answers = ("valid", "not valid")
    parser = add_command(commands, "verify", _verify, text, *answers, grasp=False, numbers=False)
    parser.add_argument("certificate", metavar="CERT.json", help="a path, or - for stdin")
    text = "by the formally verified checker (built by `make formal`)"
    parser.add_argument("--verified", action="store_true", help=text)
    add_grasp(parser, "--grasp")
    add_applied(parser, text="with --grasp: the load of the proof")
    add_cone(parser)
    add_displacement(parser)


def _verify(arguments: argparse.Namespace) -> int:
    from equilibrium.certificate.reading import parameter_of
    from equilibrium.grasps.files import read_certificate

    check = _by_verified_checker if arguments.verified else _by_python_checker
    letter = ""
    if not arguments.verified:
        arguments.certificate = read_certificate(arguments.certificate)
        letter = parameter_of(arguments.certificate)
    question = _of_letter(arguments, letter) if letter else _question(arguments)
    report = check(arguments, question)
    document = report.to_dict()
    # The verified checker counts no leaves, and what came on stdin only it has read.
    unread = arguments.verified and arguments.certificate == "-"
    for name in ("leaves",) * arguments.verified + ("wrench", "grasp") * unread:
        del document[name]
    document["checker"] = "proved" if arguments.verified else "python"
    lines = list(_lines(report, "verified" if arguments.verified else "Python", known=not unread))
    subject = question[0] if question and not letter else None
    if words := numbering_words(getattr(subject, "groups", ())):
        lines.append(words)
    grasp = report.grasp if "grasp" in document else None
    return show(arguments, document, lines, bool(report), grasp)


def _by_python_checker(arguments: argparse.Namespace, question: Any) -> Report:
    from equilibrium.grasps.files import verify

    max_displacement = read_displacement(arguments.max_displacement)
    return verify(arguments.certificate, question, arguments.cone, max_displacement)


def _by_verified_checker(arguments: argparse.Namespace, question: Any) -> Report:
    from equilibrium.certificate.reading import read_case
    from equilibrium.certificate.report import Report
    from equilibrium.grasps.files import read_certificate, verify_proved
    from equilibrium.model.subject import LoadCase

    path, max_displacement = arguments.certificate, read_displacement(arguments.max_displacement)
    valid, kind = verify_proved(path)
    report = Report(kind, "" if valid else f"this does not prove {kind}")
    if path != "-":
        _, case = read_case(read_certificate(path))
        report = replace(report, case=LoadCase(case.subject, case.load))
        return report.asked(question, arguments.cone, max_displacement)
    if question is not None:
        raise GraspError("--verified compares no proof on stdin; give a file")
    return report


def _of_letter(arguments: argparse.Namespace, letter: str) -> Any:
    """Return the questions with a letter that the certificate has to be about, if stated."""
    from equilibrium.grasps.inputs.parameter import read_parametric

    if arguments.grasp is None:
        if has_load(arguments):
            raise GraspError("a question is a grasp and a wrench; give --grasp FILE and --wrench W")
        return None
    load = force_given(arguments) or arguments.wrench
    return read_parametric(arguments.grasp, letter, load)


def _question(arguments: argparse.Namespace) -> Any:
    """Return what the certificate has to be about, if that was stated."""
    loads = ("wrench", "force", "weight", "at")
    names = ("grasp", *loads, "preload", "cone", "max_displacement")
    grasp, *load = (getattr(arguments, name) is not None for name in names)
    bodies = bodies_of(arguments) if grasp else None
    if bodies is not None:
        check_options(arguments, "verify", ASSEMBLY)
        return bodies.assembly, bodies.wrenches()
    if grasp and any(load[:3]):
        wanted = grasp_of(arguments)
        return wanted, applied(arguments, wanted)
    if grasp or any(load) or arguments.round_normals:
        raise GraspError("a question is a grasp and a wrench; give --grasp FILE and --wrench W")
    return None


def _lines(report: Report, checker: str, *, known: bool) -> Iterator[str]:
    """Yield the answer, and the question if it is known."""
    proof = report.kind
    proof += f", {counted(report.leaves, 'leaf', 'leaves')}" * bool(report.leaves)
    proof += pyramid_words(report.pyramid, before=", with ")
    proof += displacement_words(report.max_displacement)
    proof += f", for all {report.bounds}" if report.bounds is not None else ""
    answer = f"valid: {proof}" if report else f"not valid: {printable(report.problem)}"
    yield f"{answer} (by the {checker} checker)"
    yield from report.question[: _MOST_LINES * known]
    more = len(report.question) - _MOST_LINES
    if more > 0:
        yield f"... and {counted(more, 'contact')} more; --json has all"
    if not report.compared:
        yield report.to_compare
