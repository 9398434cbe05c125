"""The program ``equilibrium``: its commands, each with a module; list is here."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from arrangement.console import terminal
from arrangement.console.options.parser import Parser

from . import draw, info, inputs, resisted, solve, verify
from .arguments import add_command


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code."""
    return terminal.run(_parser(), argv)


def _parser() -> Parser:
    parser = terminal.command_parser(
        "equilibrium",
        "Decide passive stability of frictional grasps exactly, with certificates.",
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    solve.add_command_solve(commands)
    resisted.add_command_resisted(commands)
    draw.add_commands(commands)
    info.add_command_info(commands)
    verify.add_command_verify(commands)
    add_command(commands, "list", _list, "list the built-in grasps (examples)", grasp=False)
    inputs.add_commands(commands)
    draw.add_lab(commands)
    return parser


def _list(arguments: argparse.Namespace) -> int:
    from arrangement.library.files.json_files import descriptions

    bodies = {
        name: f"(contact modes alone) {text}" for name, text in descriptions("normals").items()
    }
    return terminal.print_names(descriptions("contacts") | bodies, arguments.json)


if __name__ == "__main__":
    raise SystemExit(main())
