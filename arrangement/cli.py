"""The command ``arrangement``: count, list and draw faces, make and list arrangements."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from importlib import import_module
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import sign_text, vector

from .console import terminal
from .errors import InputError, OutOfReachError
from .library.commands import add_format_commands
from .library.files import json_files
from .numbers import budget
from .numbers.exact import shown

if TYPE_CHECKING:
    from .arrangement import Arrangement

_Command = Callable[[argparse.Namespace], int]
_FILE = (
    "an arrangement or a grasp: a path, - for standard input, or a built-in name; in any format of "
    "`arrangement convert`"
)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code."""
    return terminal.run(_parser(), argv)


def _parser() -> terminal.Parser:
    parser = terminal.command_parser(
        "arrangement", "Exact arrangements of planes: faces of every dimension, with witnesses."
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    def add(name: str, function: _Command, help: str, *, file: str | None = "") -> terminal.Parser:
        """Add a command; it takes a FILE, and need not where `file` is "?"."""
        added: terminal.Parser = terminal.add_command(commands, name, help)
        if file is not None:
            added.add_argument("file", metavar="FILE", nargs=file or None, help=_FILE)
        terminal.add_common_options(added)
        added.set_defaults(command=function)
        return added

    proved = "count by the program that is proved in Coq (built by `make formal`)"
    count = add("count", _count, "count planes and faces")
    count.add_argument("--proved", action="store_true", help=proved)

    polynomial = add(
        "polynomial",
        _polynomial,
        "compute the characteristic polynomial and numbers of regions, listing none",
    )
    polynomial.add_argument(
        "--time-limit",
        type=terminal.length_argument,
        metavar="SECONDS",
        help="then stop, with the coefficients that are final",
    )
    ways = polynomial.add_mutually_exclusive_group()
    ways.add_argument(
        "--store", metavar="FOLDER", help="keeps what is done; the same command goes on with it"
    )
    ways.add_argument(
        "--forecast", action="store_true", help="only say how long it will take, from a sample"
    )
    ways.add_argument(
        "--primes", type=_primes, metavar="P,Q,...", help="count points modulo these primes instead"
    )
    ways.add_argument("--proved", action="store_true", help=proved)
    terminal.add_worker_options(polynomial)

    faces = add("faces", _faces, "list sign vectors with dimension and witness")
    faces.add_argument(
        "--dimension", type=terminal.integer_argument, metavar="K", help="only faces of dimension K"
    )
    terminal.add_number_options(faces)

    add(
        "identify",
        _identify,
        "say which combinatorial type it has, of those of at most nine planes",
    )

    types = terminal.add_command(
        commands, "census", "count or check all types of up to nine planes"
    )
    types.later = lambda: _later("library.commands").add_census(types)

    text = "count faces of generic planes against the published bounds"
    bounds = add("bounds", _bounds, text, file=None)
    bounds.add_argument(
        "--largest",
        type=terminal.integer_argument,
        default=12,
        metavar="M",
        help="4 to 30 (default 12)",
    )
    bounds.add_argument("-o", "--output", metavar="PATH", help="a picture: .svg, .pdf, .png")
    bounds.add_argument("--width", metavar="LENGTH", help="of the picture (default 180mm)")

    names = add("list", _list, "list the built-in arrangements", file=None)
    names.add_argument("--families", action="store_true", help="list what `make` can make")

    text = "make a member of a family, such as shi --type E6"
    make = add("make", _make, text, file=None)
    make.later = lambda: _later("library.commands").add_families(make)

    add_format_commands(add)

    draw = add("draw", _draw, "draw pictures and pages, or export models to hold")
    draw.later = lambda: _later("drawing.command").add_options(
        draw, _later("pictures.views").DRAWINGS
    )

    text = "make a page in which lines and great circles are dragged, counted at once"
    page = add("lab", _lab, text, file="?")
    page.add_argument("-o", "--output", metavar="PATH", required=True, help="the page (.html)")
    page.add_argument("--title", metavar="TEXT", help="a heading")
    page.add_argument(
        "--exercises", metavar="FILE", help="JSON with own exercises, in place of the built-in ones"
    )
    return parser


def _later(module: str) -> Any:
    """Import a module of this package when its options are asked for."""
    return import_module(f".{module}", __package__)


def _read(arguments: argparse.Namespace) -> Arrangement:
    from .library.files.table import read_arrangement

    return read_arrangement(arguments.file)


def _count(arguments: argparse.Namespace) -> int:
    arrangement = _read(arguments)
    if arguments.proved:
        from .planes.proved import proved_f_vector

        f_vector, engine = proved_f_vector(arrangement), "none: counted by the proved program"
    else:
        f_vector, engine = _listed(arrangement)
    counts: dict[str, object] = {
        "planes": len(arrangement),
        "distinct_planes": len(arrangement.distinct),
        "rank": arrangement.rank,
        "f_vector": list(f_vector),
        "states": sum(f_vector),
        "engine": engine,
    }
    if arguments.json:
        terminal.print_json(counts)
        return terminal.YES
    rows = {name.replace("_", " "): counts[name] for name in ("planes", "distinct_planes", "rank")}
    if arrangement.field is not None:
        rows["entries in"] = repr(arrangement.field)
    rows |= {f"faces of dim {k}": number for k, number in enumerate(f_vector)}
    rows["states"] = counts["states"]
    if arguments.proved:
        rows["counted by"] = "the proved program"
    return _print_rows(rows)


def _listed(arrangement: Arrangement) -> tuple[tuple[int, ...], str]:
    """Return the f-vector and the engine that listed the faces, if they can be listed."""
    try:
        faces = arrangement.faces()
        return faces.f_vector, faces.engine
    except OutOfReachError as error:
        if error.f_vector is None:
            raise
        return error.f_vector, "none: counted by Zaslavsky's theorem, not listed"


def _print_rows(rows: Mapping[str, object]) -> int:
    width = max(17, *(len(name) + 2 for name in rows))
    for name, value in rows.items():
        print(f"{name:<{width}}{value}")
    return terminal.YES


def _polynomial(arguments: argparse.Namespace) -> int:
    arrangement = _read(arguments)
    if arguments.forecast:
        return _forecast(arrangement, arguments)
    numbers = _whitney_numbers(arrangement, arguments)
    relatively = abs(sum(numbers))
    found = {
        "regions": sum(map(abs, numbers)),
        "bounded_regions": relatively if arrangement.rank == arrangement.dimension else 0,
        "relatively_bounded_regions": relatively,
    }
    if arguments.json:
        terminal.print_json({"first_whitney_numbers": numbers, **found})
        return terminal.YES
    from sympy import ZZ, Mul, ring

    from .counts.whitney import why_none_is_bounded

    zeros = [0] * (arrangement.dimension + 1 - len(numbers))
    chi = ring("t", ZZ)[0].from_list([*numbers, *zeros])
    factors = Mul(*(factor.as_expr() ** power for factor, power in chi.factor_list()[1]))
    rows = {"chi(t)": chi, "factors": factors}
    names = ("regions", "bounded regions", "relatively bounded")
    values: dict[str, object] = dict(zip(names, found.values(), strict=True))
    if reason := why_none_is_bounded(arrangement):
        values["bounded regions"] = f"0 ({reason})"
        values["relatively bounded"] = f"{relatively} (in the span of the normals)"
    speaker = {"counted by": "the proved program"} if arguments.proved else {}
    return _print_rows({**rows, **values, **speaker})


def _primes(text: str) -> list[int]:
    try:
        return [terminal.count_argument(word) for word in text.split(",")]
    except argparse.ArgumentTypeError:
        raise argparse.ArgumentTypeError(
            f"{shown(text)} is no list of primes; write 5,7,11"
        ) from None


def _whitney_numbers(arrangement: Arrangement, arguments: argparse.Namespace) -> tuple[int, ...]:
    """Count in one process, or in parts if there is a folder for them or more than one process."""
    from contextlib import nullcontext
    from tempfile import TemporaryDirectory

    from .counts import by_points, first_whitney_numbers
    from .counts.classes.in_parts import PARTS, first_whitney_numbers_in_parts

    shared = arguments.shard != (1, 1) or arguments.dask is not None
    if shared and arguments.store is None:
        raise InputError("--shard and --dask need --store, a folder that all machines see")
    if arguments.proved:
        from .planes.proved import proved_whitney_numbers

        return proved_whitney_numbers(arrangement)
    if arguments.primes is not None:
        numbers = by_points(arrangement, arguments.primes).all_coeffs()
        return tuple(map(int, numbers[: arrangement.rank + 1]))
    if arguments.store is None and arguments.jobs == 1:
        return first_whitney_numbers(arrangement, time_limit=arguments.time_limit)
    kept = nullcontext(arguments.store) if arguments.store else TemporaryDirectory()
    with kept as folder:
        return first_whitney_numbers_in_parts(
            arrangement,
            folder,
            parts=PARTS if arguments.store else 4 * arguments.jobs,
            jobs=arguments.jobs,
            shard=arguments.shard,
            dask=arguments.dask,
            time_limit=arguments.time_limit,
        )


def _forecast(arrangement: Arrangement, arguments: argparse.Namespace) -> int:
    from .counts.classes.symmetric import forecast

    ranks = list(forecast(arrangement))
    total = sum(entry.steps for entry in ranks)
    if arguments.json:
        terminal.print_json({"ranks": [asdict(entry) for entry in ranks], "steps": total})
        return terminal.YES
    print("rank   classes of flats            steps       memory")
    for entry in ranks:
        about = " " if entry.exact else "≈"
        print(
            f"{entry.rank:>4} {about}{entry.classes:>17,} {budget.about(entry.steps):>16}"
            f" {entry.megabytes:>9,.1f} MB"
        )
    print(
        f"in all {budget.about(total):>33}, from samples where the number of classes has the sign ≈"
    )
    return terminal.YES


def _faces(arguments: argparse.Namespace) -> int:
    arrangement = _read(arguments)
    if arrangement.field is not None and not arguments.json:
        print(f"points in {arrangement.field!r}")
    found = arrangement.faces(arguments.dimension)
    steps = len(found) * (200 + 20 * len(arrangement))
    budget.ask(f"{len(found):,} faces, printed", "count them (arrangement count)", steps=steps)
    for face in found:
        if arguments.json:
            terminal.print_json(
                {"signs": face.signs, "dimension": face.dimension, "witness": face.witness}
            )
        else:
            signs = sign_text(face.signs)
            print(f"{signs}  dim {face.dimension}  {vector(face.witness)}")
    return terminal.YES


def _identify(arguments: argparse.Namespace) -> int:
    from .library.census import MOST_PLANES, identify

    found = identify(_read(arguments))
    if arguments.json:
        terminal.print_json(asdict(found))
        return terminal.YES
    name = f"not in the catalogue; it has rank 3 and up to {MOST_PLANES} distinct planes"
    if found.type is not None:
        name = ", ".join([f"{found.planes}.{found.type}", *found.names])
    order = zip(found.order or (), found.sides or (), strict=True)
    rows = {
        "type": name,
        "Finschi-Fukuda": found.finschi_fukuda and f"IC({found.planes},3,{found.finschi_fukuda})",
        "distinct planes": found.planes,
        "rank": found.rank,
        "f-vector": " ".join(map(str, found.f_vector)),
        "points": ", ".join(f"t{k} = {number}" for k, number in (found.t_vector or {}).items()),
        "automorphisms": found.automorphisms,
        "simple": "yes" if found.is_simple else "no",
        "simplicial": "yes" if found.is_simplicial else "no",
        "as in the list": " ".join(("-" if side < 0 else "+") + str(k) for k, side in order),
    }
    return _print_rows({k: value for k, value in rows.items() if value not in ("", None)})


def _bounds(arguments: argparse.Namespace) -> int:
    from .pictures.diagrams.counts import check_largest, counts_table

    check_largest(arguments.largest)
    table = counts_table(arguments.largest)
    if arguments.output is not None:
        from .pictures.diagrams.counts import write_counts

        width = {} if arguments.width is None else {"width": arguments.width}
        write_counts(arguments.output, largest=arguments.largest, **width)
    if arguments.json:
        terminal.print_json({"counts": table})
        return terminal.YES
    print("m central planes in general position in R^3, by Zaslavsky's theorem; with the printed")
    print("m^2 - m + 2 regions and 4m^2 - 4m + 3 states, and the bound for planes off the origin")
    for row in table:
        print("  ".join(f"{name} {value}" for name, value in row.items()))
    return terminal.YES


def _draw(arguments: argparse.Namespace) -> int:
    from .drawing.command import given_options, write
    from .pictures.views import drawings_of

    arrangement = _read(arguments)
    drawings = drawings_of(arrangement)
    return write(arguments, drawings, arrangement, given_options(arguments, drawings))


def _lab(arguments: argparse.Namespace) -> int:
    from .console.writing import write_text_atomically
    from .pictures.lab.lines import lab_page

    planes = None if arguments.file is None else _read(arguments)
    page = lab_page(planes, title=arguments.title, exercises=arguments.exercises)
    write_text_atomically(arguments.output, page)
    if arguments.json:
        terminal.print_json({"output": arguments.output})
    return terminal.YES


def _make(arguments: argparse.Namespace) -> int:
    from .console.writing import write_or_print
    from .library.commands import document

    write_or_print(arguments.output, document(arguments))
    return terminal.YES


def _list(arguments: argparse.Namespace) -> int:
    if arguments.families:
        from .library.commands import described

        return terminal.print_names(described(), arguments.json)
    return terminal.print_names(json_files.described("planes"), arguments.json)


if __name__ == "__main__":
    raise SystemExit(main())
