"""The commands of the library: families are made, the census is shown, formats are converted.

The options of ``make`` are the parameters of the functions of the families. What takes time to
import is imported when a command runs, so that ``--help`` of the others answers at once.
"""

from __future__ import annotations

import argparse
import inspect
import math
from collections.abc import Callable, Mapping
from dataclasses import asdict
from inspect import Parameter
from typing import TYPE_CHECKING

from arrangement.console import terminal
from arrangement.console.progress import note, watched
from arrangement.console.writing import document_text, write_or_print
from arrangement.errors import InputError
from arrangement.numbers.budget import limit

if TYPE_CHECKING:
    from arrangement.arrangement import Arrangement


def described() -> dict[str, str]:
    """Return a line on each family: its options, and what it is."""
    return {
        name: f"{' '.join(_usage(p) for p in _parameters(name))}: {_summary(name)}"
        for name in _families()
    }


def add_families(parser: argparse.ArgumentParser) -> None:
    """Add a subcommand for each family, with its parameters as options."""
    families = parser.add_subparsers(required=True, metavar="FAMILY", dest="family")
    for name in _families():
        made = families.add_parser(name, help=_summary(name), description=_summary(name))
        for parameter in _parameters(name):
            if parameter.annotation == "bool":
                made.add_argument(f"--{parameter.name}", action="store_true")
                continue
            needed = parameter.default is parameter.empty
            kinds = parameter.annotation.split(" | ")
            made.add_argument(
                f"--{parameter.name}",
                type=(_value if "int" in kinds else str) if "str" in kinds else int,
                required=needed,
                default=None if needed else parameter.default,
                metavar=_metavar(parameter),
                help=_help(parameter),
            )
        made.add_argument(
            "--limit", type=terminal.times_argument, default=argparse.SUPPRESS, metavar="TIMES"
        )
        made.add_argument("-o", "--output", metavar="PATH", help="a file (default: print it)")


def document(arguments: argparse.Namespace) -> str:
    """Return the member that the options ask for, in file form with one plane a line."""
    values = {p.name: getattr(arguments, p.name) for p in _parameters(arguments.family)}
    given = ", ".join(f"{key} = {value}" for key, value in values.items())
    made = _families()[arguments.family](**values).to_dict()
    made["description"] = f"{arguments.family}, {given}" if given else arguments.family
    return document_text(made)


def _families() -> Mapping[str, Callable[..., Arrangement]]:
    from .families import FAMILIES

    return FAMILIES


def _parameters(name: str) -> list[Parameter]:
    return list(inspect.signature(_families()[name]).parameters.values())


def _usage(parameter: Parameter) -> str:
    text = f"--{parameter.name}"
    if parameter.annotation != "bool":
        text += f" {_metavar(parameter)}"
    return text if parameter.default is parameter.empty else f"[{text}]"


def _metavar(parameter: Parameter) -> str:
    if "Graph" in parameter.annotation:
        return "N|TYPE|EDGES" if "int" in parameter.annotation else "EDGES"
    return parameter.name.upper()


def _help(parameter: Parameter) -> str:
    if "Graph" in parameter.annotation:
        if "int" in parameter.annotation:
            return "a number, a type such as E6, or edges such as 1-2,2-3"
        return "edges such as 1-2,2-3; in a signed graph also 1+2 and 1"
    return "" if parameter.default is parameter.empty else f"(default {parameter.default})"


def _summary(name: str) -> str:
    """Return the first sentence of the docstring, without its verb."""
    first = (inspect.getdoc(_families()[name]) or "").split("\n\n")[0].replace("\n", " ")
    return first.removeprefix("Return ").rstrip(".")


def _value(text: str) -> int | str:
    """Read a number n, or the name of a type, or a graph."""
    return int(text) if text.isascii() and text.isdigit() else text


def add_census(parser: argparse.ArgumentParser) -> None:
    """Add ``show`` and ``check``."""
    commands = parser.add_subparsers(required=True, metavar="WHAT")

    show = terminal.add_command(
        commands,
        "show",
        "say how many types have so many regions, or such points",
        "done",
        "the proved program counts otherwise",
    )
    show.add_argument("planes", type=terminal.integer_argument, metavar="M", help="3 to 9")
    show.add_argument(
        "--proved",
        action="store_true",
        help="count the regions of all types by the program that is proved in Coq, too",
    )
    show.set_defaults(command=_show)

    check = terminal.add_command(
        commands, "check", "check the list of nine planes without coordinates", "right", "wrong"
    )
    check.add_argument(
        "--sample",
        type=terminal.count_argument,
        default=20,
        metavar="N",
        help="types of eight planes to extend (default: 20)",
    )
    check.add_argument("--seed", type=terminal.count_argument, default=0, help="of their choice")
    check.add_argument(
        "--proved",
        action="store_true",
        help="check the proofs by the program that is proved in Coq (built by `make formal`)",
    )
    check.set_defaults(command=_check)

    for command in (show, check):
        terminal.add_common_options(command)
        command.set_defaults(long=True)


def _planes(arguments: argparse.Namespace, least: int) -> int:
    from .census import MOST_PLANES

    planes: int = arguments.planes
    if not least <= planes <= MOST_PLANES:
        raise InputError(f"M is {planes}; give {least} to {MOST_PLANES} planes")
    return planes


def _show(arguments: argparse.Namespace) -> int:
    from .census import PUBLISHED, PUBLISHED_SIMPLE
    from .census.tables import counted_alike, table

    planes = _planes(arguments, 3)
    found = table(planes)
    counted, alike = counted_alike(planes) if arguments.proved else (0, 0)
    code = terminal.YES if counted == alike else terminal.NO
    if arguments.json:
        record = asdict(found)
        points = [{"t": row, "types": number} for row, number in found.by_points.items()]
        proved = {"proved": {"types": counted, "alike": alike}} if arguments.proved else {}
        terminal.print_json({**record, "by_points": points, **proved})
        return code
    print(f"types            {found.types:,} (published {PUBLISHED[planes]:,})")
    print(f"simple           {found.simple:,} (published {PUBLISHED_SIMPLE[planes]:,})")
    print(f"simplicial       {found.simplicial}")
    print(f"SHA-256          {found.digest}")
    if arguments.proved:
        print(f"proved program   rays, facets and regions of {counted:,} types: {alike:,} alike")
    print("regions          types")
    for regions, number in found.by_regions.items():
        print(f"{regions:>7}  {number:>13,}")
    print(f"points           {len(found.by_points)} t-vectors; --json lists them")
    return code


def _check(arguments: argparse.Namespace) -> int:
    from .census import MOST_PLANES, PUBLISHED
    from .census.tables import check

    if not 0 <= arguments.sample <= PUBLISHED[MOST_PLANES - 1]:
        raise InputError(f"--sample is {arguments.sample}; give 0 to {PUBLISHED[MOST_PLANES - 1]}")
    with limit(math.inf):  # whoever asks for it waits, and is told how far it is
        found = check(arguments.sample, arguments.seed, proved=arguments.proved)
    speaker = "proved" if arguments.proved else "Python"
    if arguments.json:
        said = {**asdict(found), "checker": speaker.lower(), "holds": found.holds}
        terminal.print_json(said)
    else:
        words = "all different" if found.different else "NOT in order: some may be the same"
        print(f"the list's types are {words}")
        print(
            f"{found.proofs} types have no coordinates, by proofs that hold (by the {speaker} "
            "checker)"
        )
        print(
            f"{found.parents} types of eight planes have {found.extensions:,} extensions: "
            f"{found.listed:,} in the list, {found.without} without coordinates, "
            f"{found.extensions - found.listed - found.without} missing"
        )
    return terminal.YES if found.holds else terminal.NO


def add_format_commands(add: Callable[..., argparse.ArgumentParser]) -> None:
    """Add both, by a function of name, command and help."""
    convert = add("convert", _convert, "write it in the language of another program")
    imported = add("import", _import, "list a file of others, or take one out of it", file=None)
    imported.add_argument("format", metavar="FORMAT", help="such as christ or chirotope")
    imported.add_argument("file", metavar="FILE", help="a path, or - for standard input")
    imported.add_argument(
        "--number", type=terminal.count_argument, metavar="K", help="take this one, from 1 on"
    )
    for command, otherwise in ((convert, "print it; needs --to"), (imported, "print it")):
        command.add_argument("-o", "--output", metavar="PATH", help=f"(default: {otherwise})")
        command.add_argument(
            "--to", metavar="FORMAT", help="such as sage (default: what the ending of PATH says)"
        )


def _convert(arguments: argparse.Namespace) -> int:
    from .files.table import read_with_rest

    if arguments.to is None and arguments.output is None:
        raise InputError("say where to or how: -o PATH, or --to FORMAT")
    return _give(arguments, lambda: read_with_rest(arguments.file))


def _import(arguments: argparse.Namespace) -> int:
    from arrangement.counts import cone

    from .census import identify
    from .files.json_files import read_text
    from .files.table import Entries, format_named

    form = format_named(arguments.format)
    found = Entries(form, *read_text(arguments.file, "bytes of a file of many arrangements"))
    if arguments.number is not None or arguments.output is not None:
        number = arguments.number
        return _give(arguments, lambda: (found[number] if number is not None else found.only(), ""))
    for number in watched(range(1, len(found) + 1), "arrangements", len(found)):
        planes = found[number]
        known = identify(planes if planes.is_central else cone(planes))
        name = "-" if known.type is None else f"{known.planes}.{known.type}"
        row = {"number": number, "planes": len(planes), "central": planes.is_central, "type": name}
        if arguments.json:
            terminal.print_json(row)
        else:
            kind = "planes through 0" if planes.is_central else "lines"
            print(f"{number:>6}  {len(planes)} {kind}  type {name}")
    return terminal.YES


def _give(arguments: argparse.Namespace, read: Callable[[], tuple[Arrangement, str]]) -> int:
    """Write an arrangement to a file or print it, and say what is lost."""
    from .files.table import converted, format_named, format_of_file

    by_ending = arguments.to is None and arguments.output is not None
    form = format_of_file(arguments.output) if by_ending else format_named(arguments.to or "json")
    arrangement, rest = read()
    text, lost = converted(arrangement, form), form.loses(arrangement)
    lost = "; ".join(filter(None, (rest and f"{rest} of the file", lost)))
    if arguments.output or not arguments.json:
        write_or_print(arguments.output, text)
    if arguments.json:
        where = {"output": arguments.output} if arguments.output else {"text": text}
        terminal.print_json({**where, "format": form.name, "lost": lost})
    elif lost:
        note(f"lost in {form.name}: {lost}")
    return terminal.YES
