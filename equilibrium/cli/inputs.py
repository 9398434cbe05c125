"""The subcommands ``equilibrium make ...``: grasp files from other data.

Each prints a grasp file on stdout, and what had to be rounded on stderr; with ``--json`` one object
with the grasp and the errors.
"""

from __future__ import annotations

import argparse
import json
import sys
from typing import TYPE_CHECKING, Any

from arrangement import terminal

if TYPE_CHECKING:
    from equilibrium.inputs import Conversion
    from equilibrium.model.grasp import Grasp


def add_commands(commands: Any) -> None:
    """Add make csv, make floats, make polygon, make circle and make random."""
    make = commands.add_parser("make", help="a grasp file from a CSV file, a polygon, a circle ...")
    kinds = make.add_subparsers(required=True, metavar="KIND")

    table = kinds.add_parser("csv", help="one contact a line; columns x, y, normal_x, ...")
    table.add_argument("file", metavar="FILE.csv")
    _finish(table, _csv)

    floats = kinds.add_parser("floats", help="measured or simulated data in floats, snapped")
    floats.add_argument("file", metavar="DATA", help="a JSON or .csv file, or - for stdin (JSON)")
    floats.add_argument(
        "--tolerance",
        type=terminal.rational_argument,
        default="1/1000000",
        metavar="Q",
        help="largest change of a coordinate or value (default: 1/1000000)",
    )
    _finish(floats, _floats)

    polygon = kinds.add_parser("polygon", help="places on the boundary of a polygon (JSON)")
    polygon.add_argument("file", metavar="FILE.json", help="a path, or - for stdin")
    _finish(polygon, _polygon)

    circle = kinds.add_parser("circle", help="contacts on a circle, normals to its centre")
    circle.add_argument("--angles", nargs="+", type=float, metavar="DEGREES", required=True)
    circle.add_argument("--radius", type=terminal.rational_argument, default=1)
    circle.add_argument("--friction", type=terminal.rational_argument, required=True)
    circle.add_argument("--preload", type=terminal.rational_argument, default=0)
    _finish(circle, _circle)

    randoms = kinds.add_parser("random", help="contacts around an object, the same for each seed")
    randoms.add_argument("--contacts", type=int, required=True, metavar="M")
    randoms.add_argument("--seed", type=int, default=0)
    randoms.set_defaults(command=_random)
    _add_units(randoms)
    terminal.add_json_option(randoms)


def _finish(parser: argparse.ArgumentParser, command: Any) -> None:
    parser.add_argument(
        "--angle-tolerance",
        type=terminal.rational_argument,
        default="1/1000000",
        metavar="RADIANS",
        help="largest error of a normal that has no exact unit form (default: 1/1000000)",
    )
    _add_units(parser)
    terminal.add_json_option(parser)
    parser.set_defaults(command=command)


def _add_units(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--units", nargs=2, metavar=("LENGTH", "FORCE"), help="what the numbers mean, as in: mm N"
    )


def _csv(arguments: argparse.Namespace) -> int:
    from equilibrium.inputs import read_csv

    return _show(read_csv(arguments.file, angle_tolerance=arguments.angle_tolerance), arguments)


def _floats(arguments: argparse.Namespace) -> int:
    from equilibrium.inputs import read_float_data

    found = read_float_data(
        arguments.file,
        tolerance=arguments.tolerance,
        angle_tolerance=arguments.angle_tolerance,
    )
    return _show(found, arguments)


def _polygon(arguments: argparse.Namespace) -> int:
    from equilibrium.inputs import read_polygon

    return _show(read_polygon(arguments.file, angle_tolerance=arguments.angle_tolerance), arguments)


def _circle(arguments: argparse.Namespace) -> int:
    from equilibrium.inputs import on_circle

    found = on_circle(
        arguments.angles,
        arguments.friction,
        radius=arguments.radius,
        preload=arguments.preload,
        angle_tolerance=arguments.angle_tolerance,
    )
    return _show(found, arguments)


def _random(arguments: argparse.Namespace) -> int:
    from equilibrium.inputs import random_grasp

    document = _labelled(random_grasp(arguments.contacts, arguments.seed), arguments).to_dict()
    if arguments.json:
        terminal.print_json({"grasp": document})
    else:
        print(json.dumps(document, indent=2))
    return terminal.YES


def _labelled(grasp: Grasp, arguments: argparse.Namespace) -> Grasp:
    return grasp.with_units(*arguments.units) if arguments.units else grasp


def _show(found: Conversion, arguments: argparse.Namespace) -> int:
    document = {**found.to_dict(), "grasp": _labelled(found.grasp, arguments).to_dict()}
    if arguments.json:
        terminal.print_json(document)
        return terminal.YES
    print(json.dumps(document["grasp"], indent=2))
    if not found.exact:
        point = float(max(map(abs, found.point_errors), default=0))
        angle = float(max(map(abs, found.angle_errors), default=0))
        value = f", values by {float(found.value_error):.2g}" if found.value_error else ""
        print(
            f"rounded: points by {point:.2g}, normals by {angle:.2g} radians{value}",
            file=sys.stderr,
        )
    return terminal.YES
