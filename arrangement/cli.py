"""The command ``arrangement``: count faces, list faces, draw them, list the built-in documents."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from typing import TYPE_CHECKING

from . import terminal
from .exact import to_text
from .io import files

if TYPE_CHECKING:
    from .arrangement import Arrangement
    from .planes import Face

#: The options of ``draw`` that go to the view, when they are given.
_DRAW_OPTIONS = (
    "colour", "direction", "width", "body", "centre", "radius", "lift", "explode", "size",
    "title", "whole", "hull", "moebius", "even",
)  # fmt: skip
_SYMBOLS = {1: "+", 0: "0", -1: "-"}


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code."""
    return terminal.run(_parser(), argv)


def _parser() -> terminal.Parser:
    parser = terminal.command_parser(
        "arrangement", "Exact arrangements of planes: faces of every dimension, with witnesses."
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    count = commands.add_parser("count", help="count planes and faces")
    _add_file(count)
    count.set_defaults(command=_count)

    faces = commands.add_parser("faces", help="list sign vectors with dimension and witness")
    _add_file(faces)
    faces.add_argument("--dimension", type=int, metavar="K", help="only faces of dimension K")
    faces.set_defaults(command=_faces)

    bounds = commands.add_parser(
        "bounds", help="count faces of generic planes against the published bounds"
    )
    bounds.add_argument("--largest", type=int, default=12, metavar="M", help="4 to 30 (default 12)")
    bounds.add_argument("-o", "--output", metavar="PATH", help="a picture: .svg, .pdf, .png")
    bounds.add_argument("--width", type=_length, metavar="MM", help="of the picture (default 180)")
    bounds.set_defaults(command=_bounds)

    names = commands.add_parser("list", help="list the built-in documents")
    names.set_defaults(command=_list)

    draw = commands.add_parser("draw", help="draw pictures and pages, or export models to hold")
    _add_file(draw)
    _add_draw_options(draw)
    draw.set_defaults(command=_draw)

    for command in (count, faces, bounds, names, draw):
        terminal.add_json_option(command)
    return parser


def _add_file(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file",
        metavar="FILE",
        help="an arrangement or a grasp: a path, - for standard input, or a built-in name",
    )


def _add_draw_options(draw: argparse.ArgumentParser) -> None:
    draw.add_argument(
        "-o", "--output", required=True, metavar="PATH",
        help=".svg, .pdf, .png: a picture; .stl, .glb, .obj: a model; .html: an interactive page",
    )  # fmt: skip
    draw.add_argument(
        "--view", metavar="VIEW",
        help="of a picture: sphere (the default), planes, stereographic, gnomonic, dual, graph, "
        "lattice",
    )  # fmt: skip
    draw.add_argument("--model", metavar="MODEL", help="dual (the default) or cells")
    draw.add_argument(
        "--colour", metavar="BY",
        help="sides, signs or none; view planes: planes, shade or none; model cells: also planes",
    )  # fmt: skip
    draw.add_argument(
        "--direction", nargs=3, type=terminal.rational_argument, metavar=("X", "Y", "Z"),
        help="towards the viewer, exact",
    )  # fmt: skip
    draw.add_argument("--width", type=_length, metavar="MM", help="of a picture (default 88)")
    draw.add_argument("--body", metavar="BODY", help="around planes and cells: ball or cube")
    draw.add_argument(
        "--centre", nargs=3, type=terminal.rational_argument, metavar=("X", "Y", "Z"),
        help="of the body, exact; left out, one that contains all vertices is taken",
    )  # fmt: skip
    draw.add_argument(
        "--radius", type=terminal.rational_argument, metavar="R",
        help="of the ball, or half the edge of the cube, exact",
    )  # fmt: skip
    draw.add_argument(
        "--lift", action="append", metavar="SIGNS",
        help="lift this cell out; write --lift=-+- with the equals sign; may be repeated",
    )  # fmt: skip
    draw.add_argument(
        "--explode", type=_length, metavar="FACTOR",
        help="move the cells of a model apart (default 1.3; 1 leaves them together)",
    )  # fmt: skip
    draw.add_argument("--size", type=_length, metavar="MM", help="of a model (default 60)")
    draw.add_argument(
        "--even", action="store_true", default=None,
        help="after a linear map that spreads the planes evenly and keeps all signs",
    )  # fmt: skip
    draw.add_argument(
        "--whole", action=argparse.BooleanOptionalAction, default=None,
        help="stereographic: both halves of the sphere, or one",
    )  # fmt: skip
    draw.add_argument(
        "--hull", action="store_true", default=None,
        help="dual: the hull of representatives on the sphere, differing edges marked",
    )  # fmt: skip
    draw.add_argument(
        "--moebius", action=argparse.BooleanOptionalAction, default=None,
        help="lattice: Moebius values under the names, or none",
    )  # fmt: skip
    draw.add_argument("--title", metavar="TEXT", help="the heading of a page")


def _length(text: str) -> float:
    """Read a length on paper or of a model, which is no exact number."""
    return float(terminal.rational_argument(text))


def _read(arguments: argparse.Namespace) -> Arrangement:
    from .io.arrangements import read_arrangement

    return read_arrangement(arguments.file)


def _count(arguments: argparse.Namespace) -> int:
    arrangement = _read(arguments)
    faces = arrangement.faces()
    counts = {
        "planes": len(arrangement),
        "distinct_planes": len(arrangement.distinct),
        "rank": arrangement.rank,
        "f_vector": list(faces.f_vector),
        "states": len(faces),
        "engine": faces.engine,
    }
    if arguments.json:
        terminal.print_json(counts)
        return terminal.YES
    print(f"planes           {counts['planes']}")
    print(f"distinct planes  {counts['distinct_planes']}")
    print(f"rank             {counts['rank']}")
    for dimension, number in enumerate(faces.f_vector):
        print(f"faces of dim {dimension}   {number}")
    print(f"states           {counts['states']}")
    return terminal.YES


def _faces(arguments: argparse.Namespace) -> int:
    arrangement = _read(arguments)
    for face in arrangement.iter_faces(arguments.dimension):
        if arguments.json:
            terminal.print_json(
                {"signs": face.signs, "dimension": face.dimension, "witness": face.witness}
            )
        else:
            print(_line(face))
    return terminal.YES


def _bounds(arguments: argparse.Namespace) -> int:
    from .draw.counts import check_largest, counts_table

    check_largest(arguments.largest)
    table = counts_table(arguments.largest)
    if arguments.output:
        from .draw import draw_counts, save_figure

        width = {} if arguments.width is None else {"width": arguments.width}
        save_figure(arguments.output, lambda: draw_counts(largest=arguments.largest, **width))
    if arguments.json:
        terminal.print_json({"counts": table})
        return terminal.YES
    print("m central planes in general position in R^3, by Zaslavsky's theorem; with the printed")
    print("m^2 - m + 2 regions and 4m^2 - 4m + 3 states, and the bound for planes off the origin")
    for row in table:
        print("  ".join(f"{name} {value}" for name, value in row.items()))
    return terminal.YES


def _line(face: Face) -> str:
    signs = "".join(_SYMBOLS[sign] for sign in face.signs)
    return f"{signs}  dim {face.dimension}  ({', '.join(to_text(x) for x in face.witness)})"


def _draw(arguments: argparse.Namespace) -> int:
    from .draw import write_drawing

    arrangement = _read(arguments)
    given = {name: getattr(arguments, name) for name in _DRAW_OPTIONS}
    options = {name: value for name, value in given.items() if value is not None}
    shows = write_drawing(arrangement, arguments.output, arguments.view, arguments.model, **options)
    if arguments.json:
        terminal.print_json({"output": arguments.output, **shows})
    return terminal.YES


def _list(arguments: argparse.Namespace) -> int:
    documents = {name: json.loads(path.read_bytes()) for name, path in files.instances().items()}
    described = {name: document.get("description", "") for name, document in documents.items()}
    if arguments.json:
        terminal.print_json(
            {"names": [{"name": name, "description": text} for name, text in described.items()]}
        )
        return terminal.YES
    width = max(map(len, described), default=0)
    for name, text in described.items():
        print(f"{name:<{width}}  {text}".rstrip())
    return terminal.YES


if __name__ == "__main__":
    raise SystemExit(main())
