"""The subcommand ``equilibrium draw``; `equilibrium.cli` adds it."""

from __future__ import annotations

import argparse
from typing import Any

from .arguments import add_command, add_force, force_given, read


def add_commands(commands: Any) -> None:
    """Add draw."""
    text = "a picture of a grasp, of what it resists, or of the methods side by side"
    draw: Any = add_command(commands, "draw", _draw, text, numbers=False)
    draw.later = lambda: _add_options(draw)


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
