"""The program ``arrangement``: count, enumerate, identify, convert, make and draw."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from importlib import import_module
from shlex import quote
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import vector
from arrangement.console.options import values
from arrangement.console.options.parser import Parser
from arrangement.numbers.exact import sign_text

from .console import terminal
from .errors import InputError, OutOfReachError, WaitingError
from .library.files import json_files
from .numbers import budget
from .numbers.exact import shown

if TYPE_CHECKING:
    from .arrangement import Arrangement
    from .enumeration.subdivision import Pieces
    from .segments import Segments

_Command = Callable[[argparse.Namespace], int]
_FILE = (
    "equations such as 'x = 0; x + y = 1', normals such as '[[1, 0], [1, 1]]', a built-in name, or "
    "a file (- for stdin) of an arrangement in any format of `arrangement convert`, or of a grasp"
)
_POLYGON = (
    "a polygon, given by corners such as '0,0; 4,0; 0,4' or by a file of lines with the polygon on "
    "their positive sides"
)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code."""
    return terminal.run(_parser(), argv)


def _parser() -> Parser:
    parser = terminal.command_parser(
        "arrangement",
        "Count, enumerate, identify and draw hyperplane arrangements, exactly.",
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    def add(
        name: str,
        function: _Command,
        help: str,
        *answers: str,
        file: str | None = "",
        heading: str = "common",
    ) -> Parser:
        """Add a command; it takes a FILE, and need not where `file` is "?"."""
        added: Parser = terminal.add_command(commands, name, help, *answers, heading=heading)
        if file is not None:
            added.add_argument("file", metavar="FILE", nargs=file or None, help=_FILE)
            added.names["file"] = json_files.instances
            added.strays[r"[^-].*=.*"] = "all equations as one argument: 'x = 0; y = 0'"
        terminal.add_common_options(added)
        added.set_defaults(command=function)
        return added

    text = "count regions (chambers) and faces; print the characteristic polynomial chi"
    _add_count(add("count", _count, text))
    faces = add(
        "faces",
        _faces,
        "enumerate faces, such as vertices and regions: sign vector, dimension, witness",
    )
    faces.add_argument(
        "--dimension", type=values.integer_argument, metavar="K", help="only faces of dimension K"
    )
    chosen = faces.add_mutually_exclusive_group()
    chosen.add_argument("--bounded", action="store_true", help="only the bounded regions")
    chosen.add_argument("--inside", metavar="POLYGON", help=f"only the faces inside {_POLYGON}")
    terminal.add_number_options(faces)
    add("identify", _identify, "find the isomorphism class of up to nine hyperplanes")
    draw = add("draw", _draw, "draw figures (plots) and pages; export 3D-printable models")
    draw.lazy_options = lambda: _later("drawing.command").add_options(
        draw, _later("pictures.views").DRAWINGS
    )

    library = _later("library.commands")
    text = "list built-in arrangements (examples), families, classes, or a file's arrangements"
    wrong = "the verified program counts otherwise"
    library.add_list_options(add("list", library.list_known, text, "done", wrong, file="?"))
    text = "make a member of a family, such as shi --type E6"
    make = add("make", library.make, text, file=None, heading="more")
    make.lazy_options = lambda: library.add_families(make)
    text = "convert between the formats of other programs"
    convert = add("convert", library.convert, text, heading="more")
    convert.usual = "--to sage"
    convert.strays[r"[^-].*\.\w+"] = "-o {}"
    convert.strays[r"[a-z][\w-]*"] = "--to {}"
    convert.words = {"--format": "--to"}
    library.add_convert_options(convert)
    text = "write an interactive page: lines and circles to drag and count, exercises (a quiz)"
    page = add("lab", _lab, text, file="?", heading="more")
    page.add_argument("-o", "--output", metavar="PAGE.html", required=True, help="the page")
    page.add_argument("--title", metavar="TEXT", help="heading of the page")
    page.add_argument(
        "--exercises", metavar="FILE", help="JSON file of exercises that replace the built-in ones"
    )
    return parser


def _add_count(count: argparse.ArgumentParser) -> None:
    count.add_argument(
        "--time-limit",
        type=values.seconds_argument,
        metavar="SECONDS",
        help="stop after SECONDS and print the coefficients found so far",
    )
    instead = count.add_mutually_exclusive_group()
    instead.add_argument(
        "--store", metavar="FOLDER", help="store partial results here; the same command resumes"
    )
    instead.add_argument(
        "--forecast", action="store_true", help="only estimate the work from a sample"
    )
    instead.add_argument(
        "--primes",
        type=_primes,
        metavar="P,Q,...",
        help="count points modulo these primes (the finite field method)",
    )
    instead.add_argument(
        "--verified",
        action="store_true",
        help="count with the formally verified program (built by `make formal`)",
    )
    instead.add_argument(
        "--inside",
        metavar="POLYGON",
        help=f"count the pieces of lines of R^2 inside and outside {_POLYGON}",
    )
    terminal.add_worker_options(count)


def _later(module: str) -> Any:
    """Import a module of this package when its options are asked for."""
    return import_module(f".{module}", __package__)


def _read(arguments: argparse.Namespace, name: str = "file") -> Arrangement:
    from .library.files.table import read_arrangement, read_polygon

    read = read_polygon if name == "inside" else read_arrangement
    return read(getattr(arguments, name))


def _count(arguments: argparse.Namespace) -> int:
    from .library.files.table import read_figure
    from .segments import Segments

    arrangement = read_figure(arguments.file)
    if isinstance(arrangement, Segments):
        return _count_segments(arrangement, arguments)
    if arguments.forecast:
        return _forecast(arrangement, arguments)
    if arguments.inside is not None:
        return _count_pieces(arrangement, arguments)
    try:
        numbers = _whitney_numbers(arrangement, arguments)
    except WaitingError as waiting:
        if arguments.shard == (1, 1):
            raise
        return _waiting(waiting, arguments)
    regions, relatively = sum(map(abs, numbers)), abs(sum(numbers))
    f_vector, engine = _f_vector(arrangement, regions, verified=arguments.verified)
    if arguments.json:
        terminal.print_json(
            {
                "planes": len(arrangement),
                "distinct_planes": len(arrangement.distinct),
                "rank": arrangement.rank,
                "f_vector": f_vector and list(f_vector),
                "states": f_vector and sum(f_vector),
                "engine": engine,
                "first_whitney_numbers": numbers,
                "regions": regions,
                "bounded_regions": relatively * (arrangement.rank == arrangement.dimension),
                "relatively_bounded_regions": relatively,
            }
        )
        return terminal.YES
    rows = {"planes": len(arrangement), "distinct planes": len(arrangement.distinct)}
    return _print_rows(
        {
            **rows,
            "rank": arrangement.rank,
            **({} if arrangement.field is None else {"coefficients in": repr(arrangement.field)}),
            **_polynomial_rows(arrangement, numbers),
            **({f"faces of dim {k}": n for k, n in enumerate(f_vector)} if f_vector else {}),
            **({"states": sum(f_vector)} if f_vector else {"faces": engine}),
            **({"counted by": "the verified program"} if arguments.verified else {}),
        }
    )


def _count_pieces(lines: Arrangement, arguments: argparse.Namespace) -> int:
    """Print what lines cut the inside of a polygon, its sides and the outside into."""
    cut = lines.pieces(_read(arguments, "inside"))
    if arguments.json:
        places = {place: pieces._asdict() for place, pieces in cut._asdict().items()}
        terminal.print_json({"lines": len(lines), **places})
        return terminal.YES
    rows: dict[str, object] = {"lines": len(lines)}
    if cut.inside.bounded_cells < cut.inside.cells:
        rows["inside"] = "unbounded: no polygon"
    for place, pieces in cut._asdict().items():
        rows |= {f"{place}: {name}": n for name, n in _piece_rows(pieces, place != "boundary")}
    return _print_rows(rows)


def _count_segments(segments: Segments, arguments: argparse.Namespace) -> int:
    """Print what the union of segments has, and what it leaves of the plane."""
    for name in ("forecast", "inside", "primes", "store", "time_limit", "verified"):
        if getattr(arguments, name):
            flag = name.replace("_", "-")
            raise InputError(f"--{flag} is for arrangements, and the file holds segments; omit it")
    pieces = segments.pieces()
    if arguments.json:
        terminal.print_json({"segments": len(segments), **pieces._asdict()})
        return terminal.YES
    return _print_rows({"segments": len(segments), **dict(_piece_rows(pieces))})


def _piece_rows(pieces: Pieces, cells: bool = True) -> list[tuple[str, int]]:
    rows = [("vertices", pieces.vertices), ("edges", pieces.edges)]
    if cells:
        rows.append(("cells", pieces.cells))
        if pieces.bounded_cells < pieces.cells:
            rows.append(("bounded cells", pieces.bounded_cells))
        rows += [(f"  of {k} edges", n) for k, n in pieces.cells_by_edges.items()]
    return rows


def _waiting(waiting: WaitingError, arguments: argparse.Namespace) -> int:
    """Report that a shard has done all that it can before others."""
    if arguments.json:
        terminal.print_json({"first_whitney_numbers": waiting.known, "complete": False})
    else:
        print(f"shard {'{}/{}'.format(*arguments.shard)} is done: {waiting}")
    return terminal.YES


def _polynomial_rows(arrangement: Arrangement, numbers: Sequence[int]) -> dict[str, object]:
    """Return chi, its factors, and the numbers of regions that follow from it."""
    from sympy import ZZ, Mul, ring

    from .counts.whitney import why_none_is_bounded

    zeros = [0] * (arrangement.dimension + 1 - len(numbers))
    chi = ring("t", ZZ)[0].from_list([*numbers, *zeros])
    relatively = abs(sum(numbers))
    rows: dict[str, object] = {
        "chi(t)": chi,
        "factors": Mul(*(factor.as_expr() ** power for factor, power in chi.factor_list()[1])),
        "regions": sum(map(abs, numbers)),
        "bounded regions": relatively,
    }
    if arrangement.rank < arrangement.dimension:
        reason = why_none_is_bounded(arrangement)
        rows["bounded regions"] = f"0 ({reason})" if reason else 0
        if relatively:
            rows["relatively bounded"] = f"{relatively} (in the span of the normals)"
    return rows


def _f_vector(
    arrangement: Arrangement, regions: int, *, verified: bool
) -> tuple[tuple[int, ...] | None, str]:
    """Return the numbers of faces with what counted them, or None with the reason."""
    if verified:
        from .planes.proved import proved_f_vector

        return proved_f_vector(arrangement), "none: counted by the verified program"
    from .counts import f_vector

    if regions > budget.FACES * budget.times() and not _counts_are_cheap(arrangement):
        times = math.ceil(1.2 * regions / budget.FACES)
        return None, f"not counted by dimension: {regions:,} regions; --limit {times} allows it"
    try:
        faces = arrangement.faces()
        return faces.f_vector, faces.engine
    except OutOfReachError as error:
        try:
            counted = error.f_vector or f_vector(arrangement)
        except OutOfReachError:
            return None, f"not counted by dimension: {error}"
        return counted, "none: counted by Zaslavsky's theorem, not enumerated"


def _counts_are_cheap(arrangement: Arrangement) -> bool:
    """Return whether faces are counted by formulas, however many there are."""
    from .counts.configuration import configuration, is_generic
    from .counts.low_rank import MAX_RANK

    return arrangement.rank <= MAX_RANK or is_generic(configuration(arrangement))


def _print_rows(rows: Mapping[str, object]) -> int:
    width = max(17, *(len(name) + 2 for name in rows))
    for name, value in rows.items():
        print(f"{name:<{width}}{value}")
    return terminal.YES


def _primes(text: str) -> list[int]:
    try:
        return [values.count_argument(word) for word in text.split(",")]
    except argparse.ArgumentTypeError:
        raise argparse.ArgumentTypeError(f"{shown(text)}; expected primes such as 5,7,11") from None


def _whitney_numbers(arrangement: Arrangement, arguments: argparse.Namespace) -> tuple[int, ...]:
    """Count in one process, or in parts if there is a folder for them or more than one process."""
    from contextlib import nullcontext
    from tempfile import TemporaryDirectory

    from .counts import by_points, first_whitney_numbers

    shared = arguments.shard != (1, 1) or arguments.dask is not None
    if shared and arguments.store is None:
        raise InputError("--shard and --dask need --store, a folder that all machines see")
    if arguments.verified:
        from .planes.proved import proved_whitney_numbers

        return proved_whitney_numbers(arrangement)
    if arguments.primes is not None:
        numbers = by_points(arrangement, arguments.primes).all_coeffs()
        return tuple(map(int, numbers[: arrangement.rank + 1]))
    if arguments.store is None and arguments.jobs == 1:
        return first_whitney_numbers(arrangement, time_limit=arguments.time_limit)
    from .counts.orbits.in_parts import first_whitney_numbers_in_parts

    kept = nullcontext(arguments.store) if arguments.store else TemporaryDirectory()
    with kept as folder:
        return first_whitney_numbers_in_parts(
            arrangement,
            folder,
            parts=None if arguments.store else 4 * arguments.jobs,
            jobs=arguments.jobs,
            shard=arguments.shard,
            dask=arguments.dask,
            time_limit=arguments.time_limit,
        )


def _forecast(arrangement: Arrangement, arguments: argparse.Namespace) -> int:
    from .counts.orbits.symmetric import forecast

    ranks = list(forecast(arrangement))
    total = sum(entry.steps for entry in ranks)
    if arguments.json:
        terminal.print_json({"ranks": [asdict(entry) for entry in ranks], "steps": total})
        return terminal.YES
    print("rank   orbits of flats             steps       memory")
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
    if arguments.bounded and arguments.dimension not in (None, arrangement.dimension):
        raise InputError("--bounded lists regions; omit --dimension")
    known = _counts_are_cheap(arrangement) and arguments.inside is None
    if known:
        _ask_to_print(_face_count(arrangement, arguments), arrangement)
    if arguments.bounded:
        faces = arrangement.bounded_regions()
    else:
        inside = None if arguments.inside is None else _read(arguments, "inside")
        faces = arrangement.faces(arguments.dimension, inside=inside)
    if not known:
        _ask_to_print(len(faces), arrangement)
    for face in faces:
        if arguments.json:
            terminal.print_json(
                {"signs": face.signs, "dimension": face.dimension, "witness": face.witness}
            )
        else:
            signs = sign_text(face.signs)
            print(f"{signs}  dim {face.dimension}  {vector(face.witness)}")
    return terminal.YES


def _face_count(arrangement: Arrangement, arguments: argparse.Namespace) -> int:
    """Count the faces that are to be printed without a list of them."""
    from .counts import bounded_region_count, f_vector

    if arguments.bounded:
        return bounded_region_count(arrangement)
    of_dimension = dict(enumerate(f_vector(arrangement)))
    if arguments.dimension is None:
        return sum(of_dimension.values())
    return of_dimension.get(arguments.dimension, 0)


def _ask_to_print(faces: int, arrangement: Arrangement) -> None:
    steps = faces * (200 + 20 * len(arrangement))
    budget.check_cost(f"{faces:,} faces, printed", "count them (arrangement count)", steps=steps)


def _identify(arguments: argparse.Namespace) -> int:
    from .library.census import MOST_PLANES, identify

    identification = identify(_read(arguments))
    if arguments.json:
        terminal.print_json(asdict(identification))
        return terminal.YES
    name = f"not in the catalogue; it has rank 3 and up to {MOST_PLANES} distinct planes"
    if identification.type is not None:
        name = ", ".join([identification.label, *identification.names])
    order = zip(identification.order or (), identification.sides or (), strict=True)
    rows = {
        "type": name,
        "Finschi-Fukuda": identification.finschi_fukuda
        and f"IC({len(identification.order)},3,{identification.finschi_fukuda})",
        "distinct planes": identification.planes,
        "rank": identification.rank,
        "f-vector": " ".join(map(str, identification.f_vector)),
        "points": ", ".join(
            f"t{k} = {number}" for k, number in (identification.t_vector or {}).items()
        ),
        "automorphisms": identification.automorphisms,
        "simple": "yes" if identification.is_simple else "no",
        "simplicial": "yes" if identification.is_simplicial else "no",
        "as in the list": " ".join(("-" if side < 0 else "+") + str(k) for k, side in order),
    }
    return _print_rows({k: value for k, value in rows.items() if value not in ("", None)})


def _draw(arguments: argparse.Namespace) -> int:
    from .console.progress import note
    from .drawing.command import given_options, write
    from .library.files.table import read_figure
    from .pictures.looks import read_names
    from .pictures.views import DRAWINGS, SEGMENTS
    from .segments import Segments

    figure = read_figure(arguments.file)
    if arguments.names is not None:
        figure, arguments.names = figure.named(read_names(arguments.names)), None
    drawings = SEGMENTS if isinstance(figure, Segments) else DRAWINGS.of(figure)
    code = write(arguments, drawings, figure, given_options(arguments, drawings, DRAWINGS))
    is_plane = not isinstance(figure, Segments) and figure.dimension == 2
    if is_plane and drawings.target(arguments.output, arguments.view)[0] == "page":
        lab = f"arrangement lab {quote(arguments.file)} -o {quote(arguments.output)}"
        note(f"the page shows the cells as prisms, in space; {lab!r} writes a page of lines")
    return code


def _lab(arguments: argparse.Namespace) -> int:
    from .console.writing import write_text_atomically
    from .pictures.lab.lines import lab_page

    planes = None if arguments.file is None else _read(arguments)
    page = lab_page(planes, title=arguments.title, exercises=arguments.exercises)
    write_text_atomically(arguments.output, page)
    if arguments.json:
        terminal.print_json({"output": arguments.output})
    return terminal.YES


if __name__ == "__main__":
    raise SystemExit(main())
