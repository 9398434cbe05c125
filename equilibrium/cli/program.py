"""The program ``equilibrium``: its commands, each with a module; list is here."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from arrangement.console import terminal
from arrangement.console.options.parser import Parser

from . import draw, info, inputs, resisted, solve, verify
from .arguments import add_command

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
    verify.add_command_verify(commands)
    add_command(commands, "list", _list, "list the built-in grasps", grasp=False)
    inputs.add_commands(commands)
    draw.add_lab(commands)
    return parser


def _list(arguments: argparse.Namespace) -> int:
    from arrangement.library.files.json_files import described

    bodies = {name: f"(contact modes alone) {text}" for name, text in described("normals").items()}
    return terminal.print_names(described("contacts") | bodies, arguments.json)


if __name__ == "__main__":
    raise SystemExit(main())
