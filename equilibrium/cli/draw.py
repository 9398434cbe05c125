"""The subcommands ``equilibrium draw`` and ``lab``; `equilibrium.cli` adds them."""

from __future__ import annotations

import argparse
import json
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arrangement.console import terminal
from arrangement.console.number_form import counted
from arrangement.console.options.parser import Parser
from arrangement.console.writing import write_text_atomically
from arrangement.numbers.exact import shown
from equilibrium.model.errors import GraspError

from .arguments import (
    Bodies,
    add_applied,
    add_command,
    add_force,
    add_wrench,
    bodies_of,
    force_given,
    grasp_of,
    read,
    spanning_wrench,
)
from .goes_with import ASSEMBLY, check_options

if TYPE_CHECKING:
    from equilibrium.model.grasp import Grasp

#: Endings of data, and the model for physics engines, which are no pictures.
_DATA = (".json", ".xml")
_SCENE = "scene"


def add_commands(commands: Any) -> None:
    """Add draw."""
    text = "draw figures (plots) of a grasp, an assembly, resisted wrenches, a proof, or of methods"
    draw: Any = add_command(commands, "draw", _draw, text, numbers=False, heading="common")
    draw.lazy_options = lambda: _add_options(draw)


def add_lab(commands: Any) -> None:
    """Add lab."""
    text = "write an interactive page in which contacts and load are dragged, with exact answers"
    lab = add_command(commands, "lab", _lab, text, optional=True, numbers=False)
    lab.add_argument("-o", "--output", metavar="PAGE.html", required=True, help="the page")
    text = "initial force (f_x, f_y) and torque tau"
    add_applied(lab, text=text)
    lab.add_argument("--title", metavar="TEXT", help="heading of the page")
    lab.add_argument(
        "--exercises", metavar="FILE", help="JSON file of exercises that replace the built-in ones"
    )


def _add_options(draw: Parser) -> None:
    from arrangement.drawing.command import add_options
    from equilibrium.pictures.views import DRAWINGS

    more = {
        "output": "; .json: the data of --view slice; .xml (MuJoCo), .json: --model scene",
        "model": "; scene is for physics engines, with the exact loads at which the grasp slips",
    }
    add_options(draw, DRAWINGS, own=("preload",), common=("wrench",), more=more)
    add_force(draw, draw.add_mutually_exclusive_group())
    text = "show the values of a letter in the file, as in t=0..1, with which its load is resisted"
    draw.add_argument("--parameter", metavar="LETTER=FROM..TO", help=text)
    add_wrench(draw, "--origin", "for the .json data of --view slice: a wrench in its plane")


def _draw(arguments: argparse.Namespace) -> int:
    from arrangement.drawing.command import given_options, write
    from equilibrium.pictures.views import DRAWINGS

    if arguments.parameter is not None:
        return _draw_values(arguments)
    bodies = bodies_of(arguments)
    if bodies is not None:
        return _draw_assembly(arguments, bodies)
    grasp = read(arguments)
    if load := force_given(arguments, grasp.dimension):
        arguments.wrench = [*(arguments.wrench or ()), load]
    if arguments.model == _SCENE or Path(arguments.output).suffix.lower() in _DATA:
        return _write_data(arguments, grasp)
    if arguments.origin is not None:
        raise GraspError("--origin is for the data of a slice; write them with -o FILE.json")
    drawings = DRAWINGS.of(grasp)
    options = given_options(arguments, drawings, DRAWINGS)
    kind, name = drawings.target(arguments.output, arguments.view, arguments.model)
    if "preload" in options and "preload" not in drawings.options(kind, name):
        grasp = grasp.with_preload(options.pop("preload"))
    return write(arguments, drawings, grasp, options)


def _draw_assembly(arguments: argparse.Namespace, bodies: Bodies) -> int:
    """Draw an assembly, solved if its file has wrenches."""
    from arrangement.drawing.command import given_options, write
    from equilibrium.decide.solver import solve
    from equilibrium.pictures.views import DRAWINGS, OF_ASSEMBLIES

    check_options(arguments, "draw", ASSEMBLY)
    wrenches = bodies.wrenches(required=False)
    subject = solve(bodies.assembly, wrenches) if bodies.has_key else bodies.assembly
    options = given_options(arguments, OF_ASSEMBLIES, DRAWINGS)
    return write(arguments, OF_ASSEMBLIES, subject, options)


def _draw_values(arguments: argparse.Namespace) -> int:
    """Draw for which values of a letter the load of a file is resisted."""
    from arrangement.drawing.command import given_options, write
    from equilibrium.grasps.inputs.parameter import read_parametric, read_range
    from equilibrium.pictures.views import DRAWINGS, OF_VALUES
    from equilibrium.wrench_sets.parameter import resisted_values

    for name in ("origin", "round_normals", "as_given"):
        if getattr(arguments, name) not in (None, False):
            raise GraspError(f"--{name.replace('_', '-')} does not go with --parameter; omit it")
    loads = [load for load in (force_given(arguments), *(arguments.wrench or ())) if load]
    if len(loads) > 1:
        raise GraspError(f"--parameter takes one load; {len(loads)} are given")
    arguments.wrench = None
    letter, low, high = read_range(arguments.parameter)
    family = read_parametric(arguments.grasp, letter, *loads)
    options = given_options(arguments, OF_VALUES, DRAWINGS)
    return write(arguments, OF_VALUES, resisted_values(family, low, high), options)


def _write_data(arguments: argparse.Namespace, grasp: Grasp) -> int:
    """Write the data of the view slice, or a scene for physics engines."""
    kind, name = ("model", _SCENE) if arguments.model == _SCENE else ("view", arguments.view)
    suffix = Path(arguments.output).suffix.lower()
    if (name, suffix) not in {("slice", ".json"), (_SCENE, ".json"), (_SCENE, ".xml")}:
        raise GraspError(
            f"the output is {shown(arguments.output)}; expected .json of --view slice, .json or "
            ".xml of --model scene, or a picture, page or model"
        )
    takes = {"model": {"wrench", "preload"}, "view": {"slice", "origin"}}[kind]
    always = {"grasp", "output", "view", "model", "force", "weight", "at"}
    common = {"command", "json", "limit", "traceback", "round_normals", "as_given"}
    common |= {"remarks"}  # of the data
    for option, value in vars(arguments).items():
        if value not in (None, False, []) and option not in takes | always | common:
            raise GraspError(f"the data of the {kind} {name} take no --{option.replace('_', '-')}")
    if kind == "model":
        from equilibrium.scenes import EngineScene, document_text

        if arguments.preload is not None:
            grasp = grasp.with_preload(arguments.preload)
        scene = EngineScene(grasp, arguments.wrench)
        text = scene.mjcf() if suffix == ".xml" else document_text(scene.document())
    else:
        from equilibrium.methods import resistance_figure

        data = resistance_figure(grasp, _spans(arguments), arguments.origin or (0, 0, 0))
        units = {"units": grasp.units.to_dict()} if grasp.units else {}
        text = json.dumps({**data, **units}, allow_nan=False) + "\n"
    write_text_atomically(arguments.output, text)
    return _written(arguments, arguments.output, {kind: name})


def _spans(arguments: argparse.Namespace) -> list[tuple[Fraction, ...]]:
    """Return the two wrenches that span the plane of a slice."""
    words = arguments.slice or ["fx", "fy"]
    try:
        spans = list(map(spanning_wrench, words))
    except argparse.ArgumentTypeError as error:
        raise GraspError(f"--slice is {error}") from None
    if len(spans) != 2:
        raise GraspError(f"--slice has {counted(len(spans), 'wrench', 'wrenches')}; expected two")
    return spans


def _lab(arguments: argparse.Namespace) -> int:
    from equilibrium.pictures.lab.page import lab_page

    grasp = None if arguments.grasp is None else grasp_of(arguments)
    wrench = force_given(arguments) or arguments.wrench
    page = lab_page(grasp, wrench=wrench, title=arguments.title, exercises=arguments.exercises)
    write_text_atomically(arguments.output, page)
    return _written(arguments, arguments.output, {})


def _written(arguments: argparse.Namespace, path: str, more: dict[str, str]) -> int:
    if arguments.json:
        terminal.print_json({"output": path, **more})
    return terminal.YES
