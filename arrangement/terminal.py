"""What the three commands share: arguments, one JSON object a line, errors, exit codes.

Exit codes: 0 yes (or done), 1 no (or refuted), 2 bad input or output that cannot be written,
70 a fault of the program (``--traceback`` shows where).
Answers go to stdout, everything else to stderr. With ``--json``, stdout carries nothing but JSON.
Long loops show how far they are, on a terminal (`progress`).
This module imports no numerical library, so that ``--help`` answers at once.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any, NoReturn

from . import progress
from .errors import InputError, MissingExtraError
from .exact import rational, shown, to_text

YES = 0
NO = 1
_BAD_INPUT = 2
#: Neither yes nor no was proved.
UNDECIDED = 3
#: EX_SOFTWARE of sysexits.h: a fault must never look like a "no".
_FAULT = 70
#: What a shell reports for a program that SIGINT or SIGPIPE ended (128 + the signal's number).
_INTERRUPTED = 130
_BROKEN_PIPE = 141

#: Most things that one command does one after the other.
MOST = 1_000_000
_NEGATIVE_NUMBER = re.compile(r"-\.?[0-9]")


class Parser(argparse.ArgumentParser):
    """An argument parser that takes ``-1/2`` and ``-0.25`` as values, not as options.

    A subcommand's parser names its function with ``set_defaults(command=function)``; the function
    takes the parsed arguments and returns an exit code (see `run`).
    """

    def __init__(self, **options: Any) -> None:
        options.setdefault("allow_abbrev", False)
        super().__init__(**options)
        # argparse asks this pattern which words that start with "-" are values.
        self._negative_number_matcher = _NEGATIVE_NUMBER

        #: Adds the options that take time to find out, when they are asked for.
        self.later: Callable[[], None] | None = None

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Parse, with all options; ``--help`` comes through here too."""
        later, self.later = self.later, None
        if later is not None:
            later()
        words = sys.argv[1:] if args is None else args
        found, rest = super().parse_known_args(list(self._separated(words)), namespace)
        for word in rest:
            near = get_close_matches(word, self._option_string_actions, 1)
            if near and word.startswith("-"):
                self.error(f"there is no option {word}; did you mean {near[0]}?")
        return found, rest

    def _separated(self, words: Sequence[str]) -> Iterator[str]:
        """Split ``0,1,0`` after an option that takes several numbers."""
        for before, word in pairwise(("", *words)):
            option = self._option_string_actions.get(before)
            several = option is not None and (
                isinstance(option.nargs, int)
                or (option.nargs == "+" and option.type is rational_argument)
            )
            yield from map(str.strip, word.split(",")) if several else (word,)

    def error(self, message: str) -> NoReturn:
        """Print the usage and one line with the error to stderr; exit with 2."""
        self.print_usage(sys.stderr)
        self.exit(_BAD_INPUT, f"error: {printable(message)}\n")


class _Version(argparse.Action):
    """Print the version of the distribution, read only when it is asked for."""

    def __init__(self, option_strings: Sequence[str], dest: str, **options: Any) -> None:
        super().__init__(option_strings, argparse.SUPPRESS, nargs=0, help="print the version")

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> NoReturn:
        from . import __version__

        print(f"{parser.prog} {__version__}")
        parser.exit(YES)


def command_parser(prog: str, description: str) -> Parser:
    """Return the parser of one program, with ``--version`` and no subcommand yet."""
    parser = Parser(prog=prog, description=description)
    parser.add_argument("--version", action=_Version)
    return parser


def add_common_options(parser: argparse.ArgumentParser) -> None:
    """Add ``--json`` and ``--traceback``, which every command has."""
    parser.add_argument(
        "--json", action="store_true", help="print JSON on stdout, and nothing else"
    )
    parser.add_argument(
        "--traceback", action="store_true", help="after a fault of the program, show where it was"
    )


def rational_argument(text: str) -> Fraction:
    """Read an exact number from the command line (the ``type=`` of an argument)."""
    try:
        return rational(text, "value")
    except InputError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def count_argument(text: str) -> int:
    """Read a number of things to do, one after the other, or a seed."""
    if re.fullmatch(r"[0-9]{1,9}", text, re.ASCII) is None or int(text) > MOST:
        raise argparse.ArgumentTypeError(
            f"{shown(text)} is no whole number from 0 to {MOST}; more takes days: go in parts"
        )
    return int(text)


def length_argument(text: str) -> float:
    """Read a length on paper or of a model, which is no exact number."""
    try:
        return float(rational_argument(text))
    except OverflowError:
        raise argparse.ArgumentTypeError(f"{shown(text)} is too long for paper") from None


def run(parser: Parser, argv: Sequence[str] | None = None) -> int:
    """Parse the arguments, call the subcommand, and return its exit code.

    Bad input ends with one line ``error: ...`` on stderr and exit code 2, without a traceback;
    whatever is not expected, with one line and exit code 70. A reader that closes the pipe
    (``| head``) ends the command quietly.
    """
    if sys.stderr is None:  # closed by the shell; print would write to stdout instead
        sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115
    if sys.stdout is None:
        return _refuse("standard output is closed, so there is nowhere to answer; open it")
    try:
        arguments = parser.parse_args(argv)
        with progress.shown():
            code: int = arguments.command(arguments)
        sys.stdout.flush()
    except (InputError, MissingExtraError) as error:
        return _refuse(str(error))
    except BrokenPipeError:
        _discard_stdout()
        return _BROKEN_PIPE
    except OSError as error:
        _discard_stdout()
        return _refuse(f"cannot write the output: {error.strerror or error}")
    except KeyboardInterrupt:
        return _INTERRUPTED
    except Exception as error:
        _discard_stdout()
        if "--traceback" in (sys.argv if argv is None else argv):
            traceback.print_exc()
        return _refuse(
            f"a fault of the program, no answer: {type(error).__name__}: {shown(str(error))}; "
            "please report it with the command, as CONTRIBUTING.md says (--traceback shows where)",
            _FAULT,
        )
    return code


def print_json(value: Any) -> None:
    """Print one JSON value on one line of stdout; rationals become strings such as ``"7/3"``."""
    print(json.dumps(value, default=_encode, allow_nan=False))


def print_names(described: Mapping[str, str], as_json: bool) -> int:
    """Print names with their descriptions, one a line."""
    if as_json:
        print_json({"names": [{"name": n, "description": text} for n, text in described.items()]})
        return YES
    width = max(map(len, described), default=0)
    for name, text in described.items():
        print(f"{name:<{width}}  {text}".rstrip())
    return YES


def printable(text: str) -> str:
    """Return text that is safe on a terminal: control characters and stray bytes are escaped."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


def _encode(value: Any) -> str:
    if isinstance(value, Fraction):
        return to_text(value)
    raise TypeError(f"{type(value).__name__} has no JSON form")


def _refuse(message: str, code: int = _BAD_INPUT) -> int:
    print(f"error: {printable(message)}", file=sys.stderr)
    return code


def _discard_stdout() -> None:
    """Send what is still buffered nowhere, so that the interpreter does not complain at exit."""
    try:
        descriptor = sys.stdout.fileno()
    except (OSError, ValueError):
        return
    devnull = os.open(os.devnull, os.O_WRONLY)
    os.dup2(devnull, descriptor)
    os.close(devnull)
