"""The subcommands ``equilibrium draw``, ``lab`` and ``export``; `equilibrium.cli` adds them."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from arrangement.console import terminal
from arrangement.console.progress import shown, watched
from arrangement.console.writing import make_folder, write_text_atomically
from equilibrium.cli.arguments import (
    add_applied,
    add_command,
    add_force,
    force_given,
    grasp_of,
    read,
)
from equilibrium.model.errors import GraspError


def add_commands(commands: Any) -> None:
    """Add draw, lab and export."""
    text = "draw a grasp, what it resists, or the methods side by side"
    draw: Any = add_command(commands, "draw", _draw, text, numbers=False)
    draw.later = lambda: _add_options(draw)

    text = "make a page in which contacts and load are dragged, with exact answers"
    lab = add_command(commands, "lab", _lab, text, optional=True, numbers=False)
    lab.add_argument("-o", "--output", metavar="PATH", required=True, help="the page (.html)")
    text = "at first: applied force (f_x, f_y) and torque tau"
    add_applied(lab, text=text, required=False)
    lab.add_argument("--title", metavar="TEXT", help="a heading")
    lab.add_argument(
        "--exercises", metavar="FILE", help="JSON with own exercises, in place of the twelve"
    )

    text = "write a scene for physics engines, with the exact loads at which the grasp slips"
    export = add_command(commands, "export", _export, text, optional=True, numbers=False)
    text = "the only direction of loads (default: along each axis)"
    add_applied(export, "--direction", text, required=False)
    ways = export.add_mutually_exclusive_group(required=True)
    text = "scene.xml for MuJoCo (MJCF), or scene.json for any engine, with proofs"
    ways.add_argument("-o", "--output", metavar="PATH", help=text)
    text = "write sixty scenes with their proofs here, instead of a grasp"
    ways.add_argument("--benchmark", metavar="FOLDER", help=text)


def _add_options(draw: argparse.ArgumentParser) -> None:
    from arrangement.drawing.command import add_options
    from equilibrium.pictures.views import DRAWINGS

    add_options(draw, DRAWINGS, own=("preload",))
    add_force(draw, draw.add_mutually_exclusive_group())


def _draw(arguments: argparse.Namespace) -> int:
    from arrangement.drawing.command import given_options, write
    from equilibrium.pictures.views import DRAWINGS, drawings_of

    grasp = read(arguments)
    if load := force_given(arguments, grasp.dimension):
        arguments.wrench = [*(arguments.wrench or ()), load]
    drawings = drawings_of(grasp)
    options = given_options(arguments, drawings, DRAWINGS)
    kind, name = drawings.target(arguments.output, arguments.view, arguments.model)
    if "preload" in options and "preload" not in drawings.options(kind, name):
        grasp = grasp.with_preload(options.pop("preload"))
    return write(arguments, drawings, grasp, options)


def _lab(arguments: argparse.Namespace) -> int:
    from equilibrium.pictures.lab.page import lab_page

    grasp = None if arguments.grasp is None else grasp_of(arguments)
    wrench = force_given(arguments) or arguments.wrench
    page = lab_page(grasp, wrench=wrench, title=arguments.title, exercises=arguments.exercises)
    write_text_atomically(arguments.output, page)
    return _written(arguments, arguments.output)


def _export(arguments: argparse.Namespace) -> int:
    from equilibrium.scenes import EngineScene, benchmark, document_text

    if arguments.benchmark is not None:
        if arguments.grasp is not None:
            raise GraspError("--benchmark takes no grasp; omit one of the two")
        folder = Path(arguments.benchmark)
        make_folder(folder)
        with shown():
            for name, scene in watched(benchmark(), "scenes", 60):
                write_text_atomically(folder / f"{name}.json", document_text(scene.document()))
        return _written(arguments, folder)
    if arguments.grasp is None:
        raise GraspError("no grasp is given; name one, or take --benchmark FOLDER")
    path = Path(arguments.output)
    if path.suffix not in (".xml", ".json"):
        raise GraspError(f"a scene is written as .xml or .json, and {path.name!r} is neither")
    grasp = grasp_of(arguments)
    given = force_given(arguments, grasp.dimension) or arguments.direction
    scene = EngineScene(grasp, None if given is None else [given])
    text = scene.mjcf() if path.suffix == ".xml" else document_text(scene.document())
    write_text_atomically(path, text)
    return _written(arguments, path)


def _written(arguments: argparse.Namespace, path: Any) -> int:
    if arguments.json:
        terminal.print_json({"output": str(path)})
    return terminal.YES
