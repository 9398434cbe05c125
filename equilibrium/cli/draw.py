"""The subcommand ``equilibrium draw``; `equilibrium.cli` adds it."""

from __future__ import annotations

import argparse
from typing import Any

from arrangement import terminal

#: The options that go to the view, when they are given.
_OPTIONS = (
    "wrench",
    "wrenches",
    "outline",
    "piece",
    "extent",
    "directions",
    "methods",
    "width",
    "title",
)


def add_commands(commands: Any) -> None:
    """Add draw."""
    draw = commands.add_parser(
        "draw", help="a picture of a grasp, of what it resists, or of the methods side by side"
    )
    draw.add_argument("grasp", metavar="GRASP", help="a path, - for stdin, or a built-in name")
    draw.add_argument(
        "-o", "--output", required=True, metavar="PATH",
        help=".svg, .pdf, .png: a picture; .html: the interactive page of the resisted forces",
    )  # fmt: skip
    draw.add_argument(
        "--view",
        metavar="VIEW",
        help="grasp (the default), resist, slice (the paper's figure in three parts), polar, "
        "compare (accepted forces), methods (verdicts on wrenches)",
    )
    draw.add_argument(
        "--wrench",
        nargs=3,
        action="append",
        metavar=("X", "Y", "R"),
        type=terminal.rational_argument,
        help="applied force x, force y, torque about the origin; methods: one or more times",
    )
    draw.add_argument(
        "--preload",
        metavar="P",
        type=terminal.rational_argument,
        help="use this preload at every contact instead of the grasp's own",
    )
    draw.add_argument(
        "--outline",
        metavar="X,Y",
        nargs="+",
        help="grasp: the corners of the object; without them its outline is only indicative",
    )
    draw.add_argument("--piece", type=int, metavar="K", help="grasp: the K-th equilibrium, from 1")
    draw.add_argument(
        "--extent",
        metavar="Q",
        type=terminal.rational_argument,
        help="resist, slice, polar, compare: the largest force that is shown",
    )
    draw.add_argument("--directions", type=int, metavar="N", help="polar: how many (default: 72)")
    draw.add_argument("--methods", nargs="+", metavar="NAME", help="compare: only these methods")
    draw.add_argument(
        "--width",
        metavar="MM",
        type=terminal.rational_argument,
        help="of the picture (default: 88; slice and compare: 180)",
    )
    draw.add_argument("--title", metavar="TEXT", help="the heading of a page")
    terminal.add_json_option(draw)
    draw.set_defaults(command=_draw)


def _draw(arguments: argparse.Namespace) -> int:
    from equilibrium.draw.output import write_drawing
    from equilibrium.io.files import read_grasp
    from equilibrium.model.errors import GraspError

    grasp = read_grasp(arguments.grasp)
    if arguments.preload is not None:
        if arguments.view == "slice":
            raise GraspError("the view slice sets the preloads itself; leave --preload out")
        grasp = grasp.with_preload(arguments.preload)
    wrenches = arguments.wrench or []
    if arguments.view == "methods":
        arguments.wrenches, arguments.wrench = wrenches or None, None
    elif len(wrenches) > 1:
        raise GraspError(f"{len(wrenches)} wrenches; only the view methods takes more than one")
    else:
        arguments.wrenches, arguments.wrench = None, wrenches[0] if wrenches else None
    given = {name: getattr(arguments, name) for name in _OPTIONS}
    options = {name: value for name, value in given.items() if value is not None}
    if "outline" in options:
        options["outline"] = [corner.split(",") for corner in options["outline"]]
    if "width" in options:
        options["width"] = float(options["width"])
    written = write_drawing(grasp, arguments.output, arguments.view, **options)
    if arguments.json:
        terminal.print_json({"output": arguments.output, **written})
    return terminal.YES
