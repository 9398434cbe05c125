"""The commands ``convert`` and ``import``: files of other programs, written and read."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TYPE_CHECKING

from arrangement.console import terminal
from arrangement.errors import InputError

if TYPE_CHECKING:
    from arrangement.arrangement import Arrangement


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
    from .table import read_with_rest

    if arguments.to is None and arguments.output is None:
        raise InputError("say where to or how: -o PATH, or --to FORMAT")
    return _give(arguments, lambda: read_with_rest(arguments.file))


def _import(arguments: argparse.Namespace) -> int:
    from arrangement.console.progress import watched
    from arrangement.counts import cone
    from arrangement.library.census import identify
    from arrangement.library.files.json_files import read_text

    from .table import Entries, format_named

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
    from arrangement.console.progress import note
    from arrangement.console.writing import write_or_print

    from .table import converted, format_named, format_of_file

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
