"""The script that completes commands, options, files and built-in names in a shell.

It is made by shtab (the extra completion) from the parsers, and printed once: a Tab then starts no
Python.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NoReturn

from arrangement.errors import extra

if TYPE_CHECKING:
    from .parser import Parser

_SHELLS = ("bash", "zsh", "fish")
#: Metavars of what is a path.
_PATH = re.compile(r"FILE|PATH|FOLDER|DATA|STORE|GRASP|\.(json|csv|py|html)")


class PrintCompletion(argparse.Action):
    """Print the script for a shell, and end the program."""

    def __init__(self, option_strings: Sequence[str], dest: str, **options: Any) -> None:
        super().__init__(
            option_strings,
            argparse.SUPPRESS,
            choices=_SHELLS,
            metavar="SHELL",
            help=f"print the script that completes commands in {', '.join(_SHELLS)}",
        )

    def __call__(self, parser: Any, namespace: Any, values: Any, *_: Any) -> NoReturn:
        """Print it, and end the program."""
        print(completion_script(parser, values), flush=True)
        raise SystemExit(0)


def completion_script(program: Parser, shell: str) -> str:
    """Return the script of a program for a shell: bash, zsh or fish.

    Raises:
        MissingExtraError: shtab is not installed.
    """
    with extra("completion"):
        import shtab
    for parser in _parsers(program):
        for action in parser._actions:
            path = bool(_PATH.search(str(action.metavar or "")))
            if action.dest in parser.names:
                words = sorted(parser.names[action.dest]())
                name = f"_{re.sub('[^a-z]', '_', parser.prog)}_{action.dest}"
                action.complete = _words(name, words, path)  # type: ignore[attr-defined]
            elif path and action.nargs != 0 and action.choices is None:
                action.complete = shtab.FILE  # type: ignore[attr-defined]
    return str(shtab.complete(program, shell))


def _parsers(parser: Parser) -> Iterator[Parser]:
    """Yield a parser and those of its commands, with the options that they add late."""
    parser.add_lazy_options()
    yield parser
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                yield from _parsers(command)


def _words(name: str, words: Sequence[str], path: bool) -> dict[str, Any]:
    """Return, in the form of shtab, the completion of one of some words, or of a path as well."""
    listed = " ".join(words)
    bash = f'compgen -W "{listed}" -- "$1"' + '; compgen -f -- "$1"' * path
    zsh = f"compadd {listed}" + "; _files" * path
    fish = f"printf '%s\\n' {listed}"
    paths = "__fish_complete_path (commandline -ct); " * path
    return {
        "bash": name,
        "zsh": name,
        "fish": f"({paths}{fish})",
        "preamble": {
            "bash": f"{name}() {{ {bash}; }}",
            "zsh": f"{name}() {{ {zsh}; }}",
        },
    }
