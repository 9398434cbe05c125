"""The subcommands ``equilibrium make ...``: grasp files from other data.

Each prints a grasp file on stdout or writes it with ``-o``, and says on stderr what had to be
rounded; with ``--json`` one object with the grasp and the errors is printed.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any

from arrangement.console import terminal
from arrangement.console.options import values
from arrangement.console.options.signature import options_of
from arrangement.console.writing import write_text_atomically

from .arguments import (
    add_as_given,
    add_command,
    add_count,
    add_number,
    show,
    tell_rounding,
)

if TYPE_CHECKING:
    from equilibrium.grasps.inputs import Conversion
    from equilibrium.model.grasp import Grasp

#: The kinds of make. Their options are the parameters of `equilibrium.grasps.textbook`, which is
#: imported when one of them is parsed.
_MAKERS = {
    "stack": "put blocks on each other, the topmost pushed",
    "arch": "build a round arch of voussoirs",
    "ramp": "put a block on a ramp",
    "wedge": "put a wedge under a block at a smooth wall",
    "wall": "build a wall of bricks in running bond",
    "cylinders": "put a cylinder on two others",
    "ladder": "lean a ladder on a block",
    "tongs": "lift a block with the jaws of tongs",
}


def add_commands(commands: Any) -> None:
    """Add make csv, floats, polygon, shapes, circle, mesh and random, and textbook assemblies."""
    text = "make a grasp file: convert data, contacts at random, or a textbook assembly"
    make = terminal.add_command(commands, "make", text, heading="more")
    kinds = make.add_subparsers(required=True, metavar="KIND")

    text = "read a contact a line: [body_a, body_b,] x, y, normal_x, normal_y (or angle), ..."
    lines = _add(kinds, "csv", text, "read_csv")
    lines.add_argument("file", metavar="FILE.csv")

    text = "snap measured or simulated data in floats"
    floats = _add(kinds, "floats", text, "read_float_data", options=("tolerance",))
    text = "a JSON, .csv or .npz file, or - for stdin (JSON)"
    floats.add_argument("file", metavar="DATA", help=text)
    text = "largest change of a coordinate or value"
    add_number(floats, "--tolerance", Fraction(1, 10**6), text)
    text = "corners of the object, for pictures"
    for parser in (lines, floats):
        parser.add_argument("--outline", nargs="+", metavar="X,Y", help=text)

    text = "put contacts on the boundary of a polygon (JSON)"
    polygon = _add(kinds, "polygon", text, "read_polygon")
    polygon.add_argument("file", metavar="FILE.json", help="a path, or - for stdin")

    text = "find the contacts of discs, spheres, polygons and walls that touch, and of threads"
    shapes = add_command(kinds, "shapes", _shapes, text, grasp=False, numbers=False, heading="")
    shapes.add_argument("file", metavar="FILE", help="a JSON or .csv file, or - for stdin (JSON)")
    add_number(shapes, "--friction", None, "of all contacts, but of pairs that have their own", "Q")
    add_number(shapes, "--gap", None, "discs touch what is this close to them", "LENGTH")
    text = "largest error of a normal that has no exact unit form"
    add_number(shapes, "--angle-tolerance", Fraction(1, 10**6), text, "RADIANS")
    text = (
        "numbers have a letter, which stays in the file: find contacts inside its range, as t=1..2"
    )
    shapes.add_argument("--parameter", metavar="LETTER=FROM..TO", help=text)
    shapes.add_argument("-o", "--output", metavar="OUT.json", help="write the file here")

    text = "put contacts on a circle, normals to its centre"
    options = ("radius", "preload")
    circle = _add(kinds, "circle", text, "on_circle", ("angles", "friction"), options)
    circle.add_argument("--angles", nargs="+", type=float, metavar="DEGREES", required=True)
    add_number(circle, "--radius", 1, "of the circle")
    circle.add_argument("--friction", metavar="Q", type=values.rational_argument, required=True)
    add_number(circle, "--preload", 0, "of every contact")

    text = "contacts on the surface of an STL, OBJ, PLY or GLB file"
    chosen = ("at", "random", "seed", "facing", "smooth", "max_distance", "preload")
    mesh: Any = _add(kinds, "mesh", text, "on_mesh", ("file", "friction"), chosen)
    mesh.add_argument("file", metavar="FILE", help="a closed surface; lengths as they are in it")
    mesh.usual = "--random 4"
    number = values.rational_argument
    text = "points; each contact is at the nearest place of the surface"
    style: dict[str, Any] = {"action": _CollectPoints, "default": [], "metavar": "X Y Z"}
    mesh.add_argument("--at", nargs="+", type=number, help=text, **style)
    add_count(mesh, "--random", 0, "of contacts drawn at random")
    add_count(mesh, "--seed", 0, "of the random numbers", "SEED")
    text = "draw where the outward normal is within 45 degrees of this direction"
    mesh.add_argument("--facing", nargs=3, type=number, metavar=("X", "Y", "Z"), help=text)
    text = "normals that change evenly over each facet, instead of its own"
    mesh.add_argument("--smooth", action="store_true", help=text)
    text = "refuse points that are farther from the surface than this share of its size"
    add_number(mesh, "--max-distance", Fraction(1, 20), text)
    mesh.add_argument("--friction", metavar="Q", type=number, required=True)
    add_number(mesh, "--preload", 0, "of every contact")

    text = "put contacts around an object at random, the same for each seed"
    randoms = add_command(kinds, "random", _random, text, grasp=False, numbers=False, heading="")
    randoms.add_argument("--contacts", type=values.count_argument, required=True, metavar="M")
    add_count(randoms, "--seed", 0, "of the random numbers", "SEED")
    randoms.add_argument("--space", action="store_true", help="in space instead of the plane")
    _add_output(randoms)
    _add_makers(kinds)


class _CollectPoints(argparse._AppendAction):
    """Collects points from their coordinates, three numbers each, however often it is given."""

    def __call__(self, parser: Any, namespace: Any, values: Any, option: Any = None) -> None:
        if len(values) % 3:
            parser.error(f"{option} has {len(values)} numbers; give three for each point")
        points = [tuple(values[i : i + 3]) for i in range(0, len(values), 3)]
        setattr(namespace, self.dest, [*getattr(namespace, self.dest), *points])


def _add(
    kinds: Any,
    name: str,
    text: str,
    reader: str,
    given: Sequence[str] = ("file",),
    options: Sequence[str] = (),
) -> argparse.ArgumentParser:
    """Add a kind of input whose conversion rounds.

    Args:
        reader: the function of `equilibrium.grasps.inputs`.
        given, options: the arguments that it takes, without and with their names.
    """
    parser = add_command(kinds, name, _converted, text, grasp=False, numbers=False, heading="")
    rounds = ("angle_tolerance", "as_given") if name != "circle" else ("angle_tolerance",)
    parser.set_defaults(reader=reader, given=given, options=(*options, *rounds))
    if name != "circle":
        add_as_given(parser)
    text = "largest error of a normal that has no exact unit form"
    add_number(parser, "--angle-tolerance", Fraction(1, 10**6), text, "RADIANS")
    _add_output(parser)
    return parser


def _add_output(parser: argparse.ArgumentParser) -> None:
    text = "what the numbers mean, as in: mm N"
    parser.add_argument("--units", nargs=2, metavar=("LENGTH", "FORCE"), help=text)
    parser.add_argument("-o", "--output", metavar="OUT.json", help="write the grasp file here")


def _random(arguments: argparse.Namespace) -> int:
    from equilibrium.grasps.inputs import random_grasp, star_outline

    grasp = random_grasp(arguments.contacts, arguments.seed, dimension=2 + arguments.space)
    if not arguments.space:
        grasp = grasp.with_outline(star_outline(grasp))
    return _give(arguments, {"grasp": _labelled(grasp, arguments).to_dict()})


def _labelled(grasp: Grasp, arguments: argparse.Namespace) -> Grasp:
    if corners := getattr(arguments, "outline", None):
        from equilibrium.model.outline import Polygon

        grasp = grasp.with_outline(Polygon(corner.split(",") for corner in corners))
    return grasp.with_units(*arguments.units) if arguments.units else grasp


def _converted(arguments: argparse.Namespace) -> int:
    from equilibrium import inputs
    from equilibrium.model.labels import Units

    options = {name: getattr(arguments, name) for name in arguments.options}
    read = getattr(inputs, arguments.reader)
    sources = [getattr(arguments, name) for name in arguments.given]
    bodies = inputs.read_bodies(*sources, **options) if read is inputs.read_csv else None
    conversion: Conversion = read(*sources, **options) if bodies is None else bodies[1]
    document = conversion.to_dict()
    if bodies is None:
        document["grasp"] = _labelled(conversion.grasp, arguments).to_dict()
    else:
        units = Units(*arguments.units) if arguments.units else None
        del document["grasp"]
        document["assembly"] = replace(bodies[0], units=units).to_dict()
    if not arguments.json:
        tell_rounding(conversion)
    return _give(arguments, document)


def _shapes(arguments: argparse.Namespace) -> int:
    """Print or write the assembly or grasp of shapes that touch."""
    from equilibrium.grasps.inputs import read_shapes
    from equilibrium.grasps.inputs.shapes_letter import shapes_with_letter
    from equilibrium.model.assembly import Assembly

    if arguments.parameter is not None:
        kind = "assembly"
        made, remarks = shapes_with_letter(
            arguments.file, arguments.parameter, arguments.friction, arguments.gap
        )
    else:
        names = ("friction", "gap", "angle_tolerance")
        read = read_shapes(arguments.file, **{name: getattr(arguments, name) for name in names})
        kind = "assembly" if isinstance(read.subject, Assembly) else "grasp"
        made, remarks = read.to_dict(), read.remarks
    for remark in () if arguments.json else remarks:
        print(f"note: {remark}", file=sys.stderr)
    return _give(arguments, {kind: made, **({"remarks": remarks} if remarks else {})})


def _give(arguments: argparse.Namespace, document: dict[str, Any]) -> int:
    """Print or write the file of the grasp or assembly of a document."""
    text = json.dumps(document.get("grasp") or document["assembly"], indent=2)
    if arguments.output is not None:
        write_text_atomically(arguments.output, f"{text}\n")
    return show(arguments, document, [text] if arguments.output is None else [])


def _add_makers(kinds: Any) -> None:
    """Add the kinds of make that are assemblies."""
    for name, text in _MAKERS.items():
        parser: Any = add_command(kinds, name, _make, text, grasp=False, numbers=False, heading="")
        parser.set_defaults(maker=name)
        parser.lazy_options = partial(_add_parameters, parser, name)
        parser.add_argument("-o", "--output", metavar="OUT.json", help="write the file here")


def _add_parameters(parser: argparse.ArgumentParser, maker: str) -> None:
    from equilibrium.grasps.textbook import TEXTBOOK

    for option in options_of(TEXTBOOK[maker]).values():
        option.add_to(parser, help=f"{option.help} (default: {option.default})")


def _make(arguments: argparse.Namespace) -> int:
    """Print or write a textbook assembly."""
    from equilibrium.grasps.textbook import TEXTBOOK

    made = TEXTBOOK[arguments.maker]
    assembly, wrenches = made(**{name: getattr(arguments, name) for name in options_of(made)})
    if arguments.output is not None:
        assembly.save(arguments.output, wrenches)
    document = assembly.to_dict(wrenches)
    lines = [json.dumps(document, indent=1)] if arguments.output is None else []
    return show(arguments, document, lines)
