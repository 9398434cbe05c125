"""The program ``equilibrium``: its commands, with verify and list; others have modules."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from arrangement.console import terminal
from arrangement.console.number_form import counted
from arrangement.console.options.parser import Parser
from arrangement.console.safe_text import printable
from equilibrium.model.contact import pyramid_words
from equilibrium.model.displacement import displacement_words, read_displacement

from . import draw, info, inputs, resisted, solve
from .arguments import (
    add_applied,
    add_command,
    add_cone,
    add_displacement,
    add_grasp,
    applied,
    grasp_of,
    show,
)
from .assemblies import asked_assembly, assembly_document

#: Lines of the question of a proof.
_MOST_LINES = 21
#: Names of earlier releases, and guesses, with what to write now.
_RENAMED = {
    "limit": "equilibrium resisted GRASP LOAD, or equilibrium resisted GRASP --smallest",
    "margin": "equilibrium resisted GRASP LOAD --margin",
    "region": "equilibrium resisted GRASP --slice U V",
    "polyhedra": "equilibrium resisted GRASP",
    "map": "equilibrium resisted GRASP --search",
    "compare": "equilibrium solve GRASP LOAD --methods",
    "wrench-space": "equilibrium info GRASP --force-closure",
    "force-closure": "equilibrium info GRASP --force-closure",
    "gws": "equilibrium info GRASP --force-closure",
    "modes": "equilibrium info GRASP --modes",
    "figure": "equilibrium draw GRASP --view slice -o FILE.json",
    "export": "equilibrium draw GRASP --model scene -o FILE.xml",
    "gaps": "proofs-check new NAME --example gaps",
    "survey": "proofs-check new NAME --example survey",
    "stability": "equilibrium resisted",
    "limits": "equilibrium resisted",
    "plot": "equilibrium draw",
    "show": "equilibrium draw",
    "check": "equilibrium verify",
    "convert": "equilibrium make",
    "--any-direction": "--smallest",
    "--direction": "--wrench",
    "--directions": "--rays",
    "--first": "--slice U V",
    "--second": "--slice U V",
    "--largest": "--max-magnitude",
    "--largest-turn": "--max-displacement",
    "--largest-force": "--max-displacement",
    "--length": "--torque-length",
    "--literal": "--as-printed",
    "--proved": "--verified",
    "--width": "--tolerance",
    "--within": "--max-distance",
}


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code."""
    return terminal.run(_parser(), argv)


def _parser() -> Parser:
    parser = terminal.command_parser(
        "equilibrium",
        "Decide passive stability of frictional grasps exactly, with certificates.",
        _RENAMED,
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    solve.add_command_solve(commands)
    resisted.add_command_resisted(commands)
    draw.add_commands(commands)
    info.add_command_info(commands)
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
        "--verified",
        action="store_true",
        help="by the formally verified checker (built by `make formal`)",
    )
    add_grasp(verify, "--grasp")
    add_applied(verify, text="what the proof has to be about, with --grasp", required=False)
    add_cone(verify)
    add_displacement(verify)
    add_command(commands, "list", _list, "list the built-in grasps", grasp=False)
    inputs.add_commands(commands)
    draw.add_lab(commands)
    return parser


def _list(arguments: argparse.Namespace) -> int:
    from arrangement.library.files.json_files import described

    bodies = {name: f"(contact modes alone) {text}" for name, text in described("normals").items()}
    return terminal.print_names(described("contacts") | bodies, arguments.json)


def _verify(arguments: argparse.Namespace) -> int:
    from equilibrium.certificate.checker import Report
    from equilibrium.certificate.reading import read_question
    from equilibrium.grasps.files import read_certificate, verify, verify_proved
    from equilibrium.model.errors import GraspError

    path, question, known = arguments.certificate, _asked(arguments), True
    max_displacement = read_displacement(arguments.max_displacement)
    if arguments.verified:
        if path != "-" and "assembly" in read_certificate(path):
            raise GraspError(
                "--verified checks certificates of one body, and this is one of an assembly; "
                "leave it out"
            )
        valid, kind = verify_proved(path)
        # What came on stdin only that program has read.
        known, problem = path != "-", "" if valid else f"this does not prove {kind}"
        if question is not None and not known:
            raise GraspError("--verified compares no proof on stdin; give a file")
        report = Report(kind, problem)
        if known:
            _, grasp, wrench = read_question(read_certificate(path))
            report = replace(report, grasp=grasp, wrench=wrench)
            report = report.asked(question, arguments.cone, max_displacement)
    else:
        report = verify(path, question, arguments.cone, max_displacement)
    # The verified checker counts no leaves; documents keep its name.
    name, left_out = ("proved", "leaves") if arguments.verified else ("python", "")
    document = {k: value for k, value in report.to_dict().items() if k != left_out}
    if not known:
        del document["wrench"], document["grasp"]
    proof = report.kind + f", {counted(report.leaves, 'leaf', 'leaves')}" * bool(report.leaves)
    proof += pyramid_words(report.pyramid, before=", with ") + displacement_words(
        report.max_displacement
    )
    proof += f", for all {report.bounds}" if report.bounds is not None else ""
    said = f"valid: {proof}" if report else f"not valid: {printable(report.problem)}"
    checker = "verified" if arguments.verified else "Python"
    lines = [f"{said} (by the {checker} checker)", *report.question[: _MOST_LINES * known]]
    more = len(report.question) - _MOST_LINES
    lines += [f"... and {counted(more, 'contact')} more; --json has all"] * (more > 0)
    if not report.compared:
        lines.append(report.to_compare)
    shown = {**document, "checker": name}
    return show(arguments, shown, lines, bool(report), report.grasp)


def _asked(arguments: argparse.Namespace) -> Any:
    """Return what a certificate has to be about, if that was given."""
    from equilibrium.model.errors import GraspError

    loads = ("wrench", "force", "weight", "at")
    names = ("grasp", *loads, "preload", "cone", "max_displacement")
    grasp, *load = (getattr(arguments, name) is not None for name in names)
    document = assembly_document(arguments) if grasp else None
    if document is not None:
        return asked_assembly(document)
    if grasp and any(load[:3]):
        wanted = grasp_of(arguments)
        return wanted, applied(arguments, wanted)
    if grasp or any(load) or arguments.round_normals:
        raise GraspError("a question is a grasp and a wrench; give --grasp FILE and --wrench W")
    return None


if __name__ == "__main__":
    raise SystemExit(main())
