"""The program ``equilibrium``: its commands, each with a module; list is here."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from arrangement.console import terminal
from arrangement.console.options.parser import Parser
from arrangement.synonyms import EXERCISES, LECTURES

from . import draw, info, inputs, resisted, solve, verify
from .arguments import add_command, built_in

_QUESTION = "GRASP --wrench F_X F_Y TAU"
#: Other words for commands and options, with what to write.
_SYNONYMS = {
    **dict.fromkeys(("example", "examples", "names"), "equilibrium list"),
    **dict.fromkeys(LECTURES, "equilibrium lab -o LAB.html"),
    **dict.fromkeys(
        EXERCISES,
        "equilibrium lab -o LAB.html, a page with exercises, which proofs-check grade slip-lab "
        "lists",
    ),
    **dict.fromkeys(
        ("animate", "animation", "movie", "video", "film", "simulate"),
        "equilibrium lab -o LAB.html, where contacts and load are dragged, or of a grasp in space "
        "equilibrium draw GRASP -o FILM.gif",
    ),
    **dict.fromkeys(
        ("mesh", "stl"), "equilibrium make mesh FILE --friction 1/2 --at X Y Z -o GRASP.json"
    ),
    **dict.fromkeys(
        ("import", "load-mesh", "read", "new", "create"),
        "equilibrium make mesh FILE --friction 1/2 --random 4 -o GRASP.json, or of a table of "
        "contacts equilibrium make csv FILE -o GRASP.json",
    ),
    "generate": "equilibrium make random --contacts 3 -o GRASP.json",
    "--count": "--random N",
    **dict.fromkeys(("explain", "report"), f"equilibrium info {_QUESTION} -o PAGE.html"),
    **dict.fromkeys(
        ("analyse", "analyze", "decide", "forces", "holds", "run", "stable", "test", "equilibrium"),
        f"equilibrium solve {_QUESTION}",
    ),
    **dict.fromkeys(
        ("friction", "min-friction"),
        f"equilibrium resisted {_QUESTION} --friction 1 2",
    ),
    **dict.fromkeys(
        ("--friction", "--mu"),
        f"equilibrium resisted {_QUESTION} --friction 1 2, for the least that holds; or "
        "write the friction of contacts into their file",
    ),
    **dict.fromkeys(
        (
            *("range", "tilt", "angle", "sweep", "--param", "--range", "--solve-for", "--sweep"),
            *("--for", "--unknown", "--values", "--variable", "--vary"),
        ),
        f"equilibrium resisted {_QUESTION} --parameter t=0..1, with the letter t in the file",
    ),
    "sensitivity": f"equilibrium solve {_QUESTION} --robust length=1/100 friction=5%",
    "--uncertainty": "--robust length=1/100 friction=5%",
    "monte-carlo": f"equilibrium solve {_QUESTION} --robust length=1/100 friction=5%",
    "limit": f"equilibrium resisted {_QUESTION}, or equilibrium resisted GRASP --smallest",
    **dict.fromkeys(
        (
            *("limits", "load", "max", "max-force", "max-load", "maxforce", "maximum"),
            *("optimise", "optimize", "range-of-loads", "stability"),
        ),
        f"equilibrium resisted {_QUESTION}",
    ),
    **dict.fromkeys(("margin", "safety"), f"equilibrium resisted {_QUESTION} --margin"),
    **dict.fromkeys(
        ("region", "regions", "resisted-region", "wrench-set"),
        "equilibrium draw GRASP --view resist -o REGION.svg, or for its vertices equilibrium "
        "resisted GRASP --slice fx fy",
    ),
    "polyhedra": "equilibrium resisted GRASP",
    "map": "equilibrium resisted GRASP --search",
    "compare": f"equilibrium solve {_QUESTION} --methods",
    **dict.fromkeys(
        ("wrench-space", "force-closure", "gws", "quality", "epsilon", "closure"),
        "equilibrium info GRASP --force-closure",
    ),
    "modes": "equilibrium info GRASP --modes",
    **dict.fromkeys(("plot", "show", "figure"), f"equilibrium draw {_QUESTION} -o FIGURE.svg"),
    "export": "equilibrium draw GRASP --model scene -o FILE.xml",
    **dict.fromkeys(
        ("certify", "prove", "certificate"),
        f"equilibrium solve {_QUESTION} --certificate OUT.json",
    ),
    **dict.fromkeys(
        ("--angle", "--tilt"),
        "--force F_X F_Y, or a letter in the file and resisted --parameter t=0..1",
    ),
    "--stones": "equilibrium make arch --voussoirs N -o ARCH.json",
    "--forces": "--wrench F_X F_Y TAU, whose contact forces are printed and drawn",
    **dict.fromkeys(("--gravity", "--mass", "--g"), "--weight W, mass times gravity"),
    "--load": "--wrench F_X F_Y TAU, of an assembly --on BODY F_X F_Y TAU",
    "--max": "--margin",
    "--plot": f"equilibrium draw {_QUESTION} -o PATH",
    "check": f"equilibrium verify CERTIFICATE, or equilibrium solve {_QUESTION}",
    "convert": "equilibrium make",
    **dict.fromkeys(("--any-direction", "--all-directions"), "--smallest"),
    "--direction": "--wrench F_X F_Y TAU",
    **dict.fromkeys(("--torque", "--moment"), "--wrench F_X F_Y TAU"),
    "--directions": "--rays",
    "--largest": "--max-magnitude",
    "--length": "--torque-length",
    "--literal": "--as-printed",
    **dict.fromkeys(("--coq", "--formal", "--proved"), "--verified"),
    "--save": "--certificate OUT.json",
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
