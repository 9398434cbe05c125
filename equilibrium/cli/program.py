"""The program ``equilibrium``: its commands, each with a module; list is here."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from arrangement.console import terminal
from arrangement.console.options.parser import Parser

from . import draw, info, inputs, resisted, solve, verify
from .arguments import add_command, built_in

#: Other words for commands and options, with what to write.
_SYNONYMS = {
    "example": "equilibrium list, which has the built-in grasps",
    "examples": "equilibrium list, which has the built-in grasps",
    "lesson": "equilibrium lab -o LAB.html; lessons are in the folder docs/lessons",
    "slides": "equilibrium lab -o LAB.html; slides are in the folder docs/slides",
    "play": "equilibrium lab -o LAB.html",
    **dict.fromkeys(
        ("exercise", "exercises", "quiz", "homework"),
        "equilibrium lab -o LAB.html; proofs-check grade slip-lab has its exercises",
    ),
    "explain": "equilibrium info GRASP LOAD -o PAGE.html",
    "holds": "equilibrium solve GRASP LOAD",
    **dict.fromkeys(("friction", "min-friction"), "equilibrium resisted GRASP LOAD --friction 1 2"),
    **dict.fromkeys(
        ("range", "tilt", "angle"), "equilibrium resisted GRASP LOAD --parameter t=0..1"
    ),
    "monte-carlo": "equilibrium solve GRASP LOAD --robust length=1/100 friction=5%",
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
    **dict.fromkeys(
        ("--angle", "--tilt"),
        "--force F_X F_Y, or a letter in the file and resisted --parameter t=0..1",
    ),
    "--stones": "equilibrium make arch --voussoirs N -o ARCH.json",
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
        for_files="equilibrium solve {} --weight 1",
        names=built_in,
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
    from arrangement.library.files.json_files import descriptions

    bodies = {
        name: f"(contact modes alone) {text}" for name, text in descriptions("normals").items()
    }
    return terminal.print_names(descriptions("contacts") | bodies, arguments.json)


if __name__ == "__main__":
    raise SystemExit(main())
