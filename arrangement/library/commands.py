"""The commands of the library: make members of families, list classes, convert formats.

The options of ``make`` are the parameters of the functions of the families. What takes time to
import is imported when a command runs, so that ``--help`` of the others answers at once.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING

from arrangement.console import terminal
from arrangement.console.options import values
from arrangement.console.options.signature import USUAL_SYNTAX, Option, options_of
from arrangement.console.progress import note, watched
from arrangement.console.writing import document_text, write_or_print
from arrangement.errors import InputError
from arrangement.hints import summary
from arrangement.library.files.json_files import descriptions

if TYPE_CHECKING:
    from arrangement.arrangement import Arrangement

    from .files.table import Entries


def family_descriptions() -> dict[str, str]:
    """Return a line on each family: its options, and what it is."""
    return {
        name: f"{' '.join(map(_usage, options_of(made).values()))}: {_summary(made)}"
        for name, made in _families().items()
    }


def add_families(parser: argparse.ArgumentParser) -> None:
    """Add a subcommand for each family, with its parameters as options."""
    families = parser.add_subparsers(required=True, metavar="FAMILY", dest="family")
    for name, made in _families().items():
        family = families.add_parser(name, help=_summary(made), description=_summary(made))
        for option in options_of(made).values():
            changes = {} if option.syntax.words == 0 else {"metavar": _metavar(option)}
            if not option.required and option.default is not False:
                changes["help"] = f"{option.help} (default {option.default})".strip()
            option.add_to(family, **changes)
        family.add_argument(
            "--limit",
            type=values.times_argument,
            default=argparse.SUPPRESS,
            metavar="N",
            help="scale the default limits by N",
        )
        family.add_argument("-o", "--output", metavar="PATH", help="a file (default: print it)")


def make(arguments: argparse.Namespace) -> int:
    """Write the member that the options ask for, in file form with one plane a line."""
    family = _families()[arguments.family]
    members = {name: getattr(arguments, name) for name in options_of(family)}
    values = ", ".join(f"{key} = {value}" for key, value in members.items())
    made = family(**members).to_dict()
    made["description"] = f"{arguments.family}, {values}" if values else arguments.family
    write_or_print(arguments.output, document_text(made))
    return terminal.YES


def _families() -> Mapping[str, Callable[..., Arrangement]]:
    from .families import FAMILIES

    return FAMILIES


def _usage(option: Option) -> str:
    text = f"--{option.flag}" if option.syntax.words == 0 else f"--{option.flag} {_metavar(option)}"
    return text if option.required else f"[{text}]"


def _metavar(option: Option) -> str:
    """Return what stands for a value: N for the usual types, in a family with the option --n."""
    usual = option.syntax in USUAL_SYNTAX.values()
    return option.name.upper() if usual else str(option.syntax.metavar)


def _summary(family: Callable[..., Arrangement]) -> str:
    """Return the first paragraph of the docstring, without its verb."""
    return summary(family).removeprefix("Return ")


def add_list_options(parser: argparse.ArgumentParser) -> None:
    """Add what ``list`` can list besides the built-in arrangements."""
    parser.add_argument("--families", action="store_true", help="list the families of `make`")
    parser.add_argument(
        "--classes",
        type=values.integer_argument,
        metavar="M",
        help="count the isomorphism classes of M hyperplanes of rank 3, 3 to 9",
    )
    parser.add_argument(
        "--verified",
        action="store_true",
        help="with --classes: also count their regions with the formally verified program",
    )
    parser.add_argument(
        "--from",
        dest="source",
        metavar="FORMAT",
        help="format of FILE (default: detected from the text)",
    )


def list_known(arguments: argparse.Namespace) -> int:
    """List built-in arrangements, families, isomorphism classes, or those of a file."""
    if (arguments.file is not None) + arguments.families + (arguments.classes is not None) > 1:
        raise InputError("FILE, --families and --classes list different things; give one")
    if arguments.verified and arguments.classes is None:
        raise InputError("--verified counts the regions of all classes; give --classes M")
    if arguments.file is not None:
        return list_file(arguments)
    if arguments.classes is not None:
        return list_classes(arguments)
    if arguments.families:
        return terminal.print_names(family_descriptions(), arguments.json)
    return terminal.print_names(descriptions("planes"), arguments.json)


def list_classes(arguments: argparse.Namespace) -> int:
    """Print the numbers of isomorphism classes by number of regions."""
    from .census import MOST_PLANES, PUBLISHED, PUBLISHED_SIMPLE
    from .census.tables import compare_counts, table

    planes = arguments.classes
    if not 3 <= planes <= MOST_PLANES:
        raise InputError(f"--classes is {planes}; expected 3 to {MOST_PLANES} hyperplanes")
    content = table(planes)
    counted, alike = compare_counts(planes) if arguments.verified else (0, 0)
    code = terminal.YES if counted == alike else terminal.NO
    if arguments.json:
        record = asdict(content)
        points = [{"t": row, "types": number} for row, number in content.by_points.items()]
        proved = {"proved": {"types": counted, "alike": alike}} if arguments.verified else {}
        terminal.print_json({**record, "by_points": points, **proved})
        return code
    print(f"classes          {content.types:,} (published {PUBLISHED[planes]:,})")
    print(f"simple           {content.simple:,} (published {PUBLISHED_SIMPLE[planes]:,})")
    print(f"simplicial       {content.simplicial}")
    print(f"SHA-256          {content.digest}")
    if arguments.verified:
        print(f"verified program rays, facets and regions of {counted:,} classes: {alike:,} equal")
    print("regions          classes")
    for regions, number in content.by_regions.items():
        print(f"{regions:>7}  {number:>13,}")
    print(f"points           {len(content.by_points)} t-vectors; --json lists them")
    return code


def add_convert_options(parser: argparse.ArgumentParser) -> None:
    """Add from what and to what ``convert`` converts."""
    parser.add_argument(
        "--from",
        dest="source",
        metavar="FORMAT",
        help="format of FILE, such as christ or chirotope (default: detected)",
    )
    parser.add_argument(
        "--number",
        type=values.count_argument,
        metavar="K",
        help="use arrangement number K of the file, counted from 1",
    )
    parser.add_argument(
        "-o", "--output", metavar="PATH", help="file to write (default: stdout; needs --to)"
    )
    parser.add_argument(
        "--to",
        metavar="FORMAT",
        help="format to write, such as sage (default: by the suffix of PATH)",
    )


def convert(arguments: argparse.Namespace) -> int:
    """Write an arrangement in another format, to a file or to stdout, and report what is lost."""
    from .files.table import format_named, format_of_file, read_with_rest, text_in_format

    if arguments.to is None and arguments.output is None:
        raise InputError("convert needs a target: give -o PATH, or --to FORMAT")
    by_ending = arguments.to is None
    form = format_of_file(arguments.output) if by_ending else format_named(arguments.to)
    if arguments.source is None and arguments.number is None:
        arrangement, rest = read_with_rest(arguments.file)
    else:
        entries, rest = _entries(arguments), ""
        number = arguments.number
        arrangement = entries.only() if number is None else entries[number]
    text, lost = text_in_format(arrangement, form), form.loses(arrangement)
    names = "names of planes" if arrangement.names and form.name != "json" else ""
    lost = "; ".join(filter(None, (rest and f"{rest} of the file", names, lost)))
    if arguments.output or not arguments.json:
        write_or_print(arguments.output, text)
    if arguments.json:
        where = {"output": arguments.output} if arguments.output else {"text": text}
        terminal.print_json({**where, "format": form.name, "lost": lost})
    elif lost:
        note(f"lost in {form.name}: {lost}")
    return terminal.YES


def list_file(arguments: argparse.Namespace) -> int:
    """Print the arrangements of a file, each with its isomorphism class."""
    from .census import identify

    entries = _entries(arguments)
    for number in watched(range(1, len(entries) + 1), "arrangements", len(entries)):
        planes = entries[number]
        name = identify(planes).label or "-"
        row = {"number": number, "planes": len(planes), "central": planes.is_central, "type": name}
        if arguments.json:
            terminal.print_json(row)
        else:
            kind = "planes through 0" if planes.is_central else "lines"
            print(f"{number:>6}  {len(planes)} {kind}  type {name}")
    return terminal.YES


def _entries(arguments: argparse.Namespace) -> Entries:
    from .files.table import entries_of

    return entries_of(arguments.file, arguments.source)
