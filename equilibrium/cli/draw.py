"""The subcommands ``equilibrium draw`` and ``lab``; `equilibrium.cli` adds them."""

from __future__ import annotations

import argparse
from typing import Any

from arrangement.console import terminal
from equilibrium.cli.arguments import (
    add_applied,
    add_command,
    add_force,
    force_given,
    grasp_of,
    read,
)


def add_commands(commands: Any) -> None:
    """Add draw and lab."""
    text = "a picture of a grasp, of what it resists, or of the methods side by side"
    draw: Any = add_command(commands, "draw", _draw, text, numbers=False)
    draw.later = lambda: _add_options(draw)

    text = "a page in which contacts and load are dragged, with exact answers"
    lab = add_command(commands, "lab", _lab, text, optional=True, numbers=False)
    lab.add_argument("-o", "--output", metavar="PATH", required=True, help="the page (.html)")
    text = "at first: applied force (f_x, f_y) and torque tau"
    add_applied(lab, text=text, required=False)
    lab.add_argument("--title", metavar="TEXT", help="a heading")
    lab.add_argument(
        "--exercises", metavar="FILE", help="JSON with own exercises, in place of the twelve"
    )


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
    from arrangement.console.writing import write_text_atomically
    from equilibrium.pictures.lab.page import lab_page

    grasp = None if arguments.grasp is None else grasp_of(arguments)
    wrench = force_given(arguments) or arguments.wrench
    page = lab_page(grasp, wrench=wrench, title=arguments.title, exercises=arguments.exercises)
    write_text_atomically(arguments.output, page)
    if arguments.json:
        terminal.print_json({"output": arguments.output})
    return terminal.YES
