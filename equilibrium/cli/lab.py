"""The subcommand ``equilibrium lab``; `equilibrium.cli` adds it."""

from __future__ import annotations

import argparse
from typing import Any

from arrangement.console import terminal

from .arguments import add_applied, add_command, force_given, grasp_of


def add_commands(commands: Any) -> None:
    """Add lab."""
    text = "a page in which contacts and load are dragged, with exact answers"
    lab = add_command(commands, "lab", _lab, text, optional=True, numbers=False)
    lab.add_argument("-o", "--output", metavar="PATH", required=True, help="the page (.html)")
    text = "at first: applied force (f_x, f_y) and torque tau"
    add_applied(lab, text=text, required=False)
    lab.add_argument("--title", metavar="TEXT", help="a heading")
    lab.add_argument(
        "--exercises", metavar="FILE", help="JSON with own exercises, in place of the twelve"
    )


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
