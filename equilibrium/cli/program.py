"""The program ``equilibrium``: its commands, each with a module; list is here."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from arrangement.console import terminal
from arrangement.console.options.parser import Parser

from . import draw, info, inputs, resisted, solve, verify
from .arguments import add_command

#: Other words for commands and options, with what to write.
_SYNONYMS = {
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
    "stability": "equilibrium resisted",
    "limits": "equilibrium resisted",
    "plot": "equilibrium draw",
    "report": "equilibrium info GRASP LOAD -o PAGE.html",
    "stable": "equilibrium solve GRASP LOAD",
    "--forces": "--wrench F_X F_Y TAU",
    "--friction": "the friction of contacts into their file",
    "--gravity": "--weight",
    "--load": "--wrench",
    "--max": "--margin",
    "--mu": "the friction of contacts into their file",
    "--plot": "equilibrium draw GRASP LOAD -o PATH",
    "show": "equilibrium draw",
    "check": "equilibrium verify CERTIFICATE, or equilibrium solve GRASP LOAD",
    "convert": "equilibrium make",
    "--any-direction": "--smallest",
    "--direction": "--wrench",
    "--directions": "--rays",
    "--largest": "--max-magnitude",
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
        _SYNONYMS,
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
