"""What the three commands share: arguments, one JSON object a line, errors, exit codes.

Exit codes: 0 yes (or done), 1 no (or refuted), 2 bad input or output that cannot be written,
3 undecided, 70 internal error (``--traceback`` shows where).
Answers go to stdout, everything else to stderr. With ``--json``, stdout carries nothing but JSON.
Long loops show how far they are, on a terminal (`progress`).
This module imports no numerical library, so that ``--help`` answers at once.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from fractions import Fraction
from itertools import takewhile
from pathlib import Path
from typing import Any, NoReturn

from arrangement.errors import InputError, MissingExtraError
from arrangement.numbers import budget
from arrangement.numbers.exact import rational, shown
from arrangement.numbers.real import Irrational, written

from . import number_form, progress
from .entry import fault
from .safe_text import error_text, safe_stdout

YES = 0
NO = 1
_BAD_INPUT = 2
#: Neither yes nor no was proved.
UNDECIDED = 3
#: What a shell reports for a program that SIGINT or SIGPIPE ended (128 + the signal's number).
_INTERRUPTED = 130
_BROKEN_PIPE = 141

#: Repetitions of a task in one command, at most.
MAX_COUNT = 1_000_000
_NEGATIVE_NUMBER = re.compile(r"-\.?[0-9]")
_WITH_UNIT = re.compile(r"[-+]?[0-9./]+ ?[A-Za-z]+")


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
        self.lazy_options: Callable[[], None] | None = None
        #: Options that take at least this many numbers.
        self.variadic: list[argparse.Action] = []
        #: What is parsed, and the options with a value seen so far.
        self.arguments: Sequence[str] = ()
        self._seen: list[argparse.Action] = []
        #: Commands and options of earlier releases and of other programs, with what to write now.
        self.renamed: Mapping[str, str] = {}
        #: Subcommands under the headings of ``--help``: names with what they do.
        self.headings: dict[str, list[tuple[str, str]]] = {}

    def add_subparsers(self, **options: Any) -> Any:
        """Return the commands, to which `add_command` adds one."""
        commands: Any = super().add_subparsers(**options)
        commands.program = self
        return commands

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Parse, with all options; ``--help`` comes through here too."""
        self.arguments = words = sys.argv[1:] if args is None else args
        self._seen = []
        lazy_options, self.lazy_options = self.lazy_options, None
        if lazy_options is not None:
            lazy_options()
        found, rest = super().parse_known_args(list(self._split_numbers(words)), namespace)
        for word in rest:
            self.error(self._unknown(word))
        for action in self._actions:
            if getattr(found, action.dest, None) == "" and action.dest != "title":
                name = "/".join(action.option_strings) or action.metavar
                self.error(f"argument {name}: it is empty; give a name")
        return found, rest

    def _split_numbers(self, words: Sequence[str]) -> Iterator[str]:
        """Split ``0,1,0`` and ``0, 1, 0``, in one word or several, where several are taken."""
        due = 0
        for i, word in enumerate(words):
            name, equals, value = word.partition("=")
            option = self._option_string_actions.get(name)
            if option is not None:
                if option in self.variadic:
                    given = [value, *words[i + 1 :]] if equals else words[i + 1 :]
                    option.nargs = max(option.nargs, _numbers(given))  # type: ignore[type-var]
                due = _numbers_after(option)
            if option is not None and due and equals:
                yield name
                word = value
            elif option is not None or not due:
                yield word
                continue
            parts = re.split(r"[\s,]+", word.strip(", "))
            due = max(due - len(parts), 0)
            yield from parts

    def _get_values(self, action: argparse.Action, arg_strings: list[str]) -> Any:
        """Refuse an option that is given again, whose last value would be taken, and ``-o=--``.

        argparse drops the ``--``, and goes on with no value.
        """
        if action.option_strings and action.nargs != 0:
            if "--" in arg_strings:
                raise argparse.ArgumentError(action, "it is '--'; expected a value")
            if action in self._seen and not isinstance(action, argparse._AppendAction):
                raise argparse.ArgumentError(action, "it is given twice; give it once")
            self._seen.append(action)
        return super()._get_values(action, arg_strings)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """Name the nearest choices of a misspelt one."""
        if action.choices is not None and value not in action.choices:
            if isinstance(action, argparse._SubParsersAction) and value in self.renamed:
                raise argparse.ArgumentError(None, self._renamed(value))
            known = list(action.choices)
            text = f"there is no {shown(value)}; expected one of {', '.join(known)}"
            raise argparse.ArgumentError(action, text + _suggestion(value, known))

    def _renamed(self, word: str) -> str:
        return f"{word!r} is now {self.renamed[word]!r}"

    def _unknown(self, word: str) -> str:
        if (name := word.partition("=")[0]) in self.renamed:
            return self._renamed(name)
        kind = "unknown option" if word.startswith("-") else "unexpected argument"
        return f"{kind} {shown(word)}{_suggestion(word, self._option_string_actions)}"

    def format_help(self) -> str:
        """Return the help; a program with headings lists its commands under them."""
        if not self.headings:
            return super().format_help()
        parts = [f"usage: {self.prog} [--version] COMMAND ...", self.description or ""]
        width = max(len(name) for rows in self.headings.values() for name, _ in rows) + 2
        for heading, rows in self.headings.items():
            parts.append("\n".join([f"{heading}:", *(f"  {n:<{width}}{text}" for n, text in rows)]))
        parts += [f"{self.prog} COMMAND --help describes a command.", self.epilog or ""]
        return "\n\n".join(parts) + "\n"

    def error(self, message: str) -> NoReturn:
        """Print one line with the error to stderr; exit with 2.

        Where something is missing, an option that is misspelt may be it.
        """
        options = (word.partition("=")[0] for word in self.arguments if word[:2] == "--" != word)
        misspelt = (word for word in options if word not in self._option_string_actions)
        if "required" in message and (word := next(misspelt, None)):
            message = self._unknown(word)
        for action in self._actions:
            if action.choices and message.endswith(f"required: {action.metavar}"):
                message += f"; expected one of {', '.join(map(str, action.choices))}"
        self.exit(_BAD_INPUT, f"error: {error_text(message)} (see {self.prog} --help)\n")


def _numbers_after(option: argparse.Action) -> int:
    """Return how many numbers an option takes at most."""
    if option.nargs == "+" and option.type is rational_argument:
        return MAX_COUNT
    numbers = isinstance(option.nargs, int) and option.type in (None, rational_argument)
    return option.nargs if numbers else 0  # type: ignore[return-value]


def _numbers(words: Sequence[str]) -> int:
    """Return how many numbers come first, in one word or several."""
    parts = (part for word in words for part in re.split(r"[\s,]+", word.strip(", ")))
    return sum(1 for _ in takewhile(re.compile(r"[-+]?[.]?[0-9]").match, parts))


def _suggestion(word: str, known: Iterable[str]) -> str:
    near = get_close_matches(word, known, 3)
    return f"; did you mean {' or '.join(near)}?" if near else ""


class _Version(argparse.Action):
    """Print the version of the distribution, read only when it is asked for."""

    def __init__(self, option_strings: Sequence[str], dest: str, **options: Any) -> None:
        super().__init__(option_strings, argparse.SUPPRESS, nargs=0, help="print the version")

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> NoReturn:
        from arrangement import __version__

        print(f"{parser.prog} {__version__}")
        parser.exit(YES)


def command_parser(prog: str, description: str, renamed: Mapping[str, str] | None = None) -> Parser:
    """Return the parser of one program, with ``--version`` and no subcommand yet.

    Args:
        renamed: commands and options of earlier releases and of other programs, with what to
            write now.
    """
    every = ("yes or done", "no or refuted", "undecided", "internal error")
    parser = Parser(prog=prog, description=description, epilog=_exit_codes(every))
    parser.add_argument("--version", action=_Version)
    parser.renamed = renamed or {}
    return parser


def add_command(commands: Any, name: str, text: str, *answers: str, heading: str = "") -> Any:
    """Add a subcommand; its help says what it does, and what its exit codes mean.

    Args:
        commands: what `Parser.add_subparsers` returned.
        text: what it does: a verb first, in lower case, no full stop.
        answers: what the codes 0, 1 and 3 mean, as far as it has them; if omitted, 0 is "done".
        heading: under which the help of the program lists it.
    """
    whole = f"{text[0].upper()}{text[1:]}."
    codes = _exit_codes(answers or ("done",))
    if heading:
        commands.program.headings.setdefault(heading, []).append((name, text))
    added = commands.add_parser(name, help=text, description=whole, epilog=codes)
    added.renamed = commands.program.renamed
    return added


def _exit_codes(answers: Sequence[str]) -> str:
    """Return the line on exit codes: what 0, 1, 3 and 70 mean, and 2."""
    codes = {**dict(zip((YES, NO, UNDECIDED, 70), answers, strict=False)), _BAD_INPUT: "bad input"}
    return f"Exit codes: {', '.join(f'{code} {codes[code]}' for code in sorted(codes))}."


def add_common_options(parser: argparse.ArgumentParser) -> None:
    """Add ``--json``, ``--limit`` and ``--traceback``, which every command has."""
    group = parser.add_argument_group("other")
    group.add_argument("--json", action="store_true", help="print JSON on stdout, and nothing else")
    group.add_argument(
        "--limit",
        type=times_argument,
        default=1.0,
        metavar="N",
        help="scale the default limits on size, memory and work by N",
    )
    group.add_argument(
        "--traceback", action="store_true", help="after an internal error, show where it was"
    )


def times_argument(text: str) -> float:
    """Read how many times the budget is allowed."""
    try:
        return float(rational_argument(text))
    except OverflowError:
        return math.inf


def add_jobs_option(parser: argparse.ArgumentParser) -> None:
    """Add the number of processes."""
    parser.add_argument(
        "--jobs", type=integer_argument, default=1, metavar="N", help="processes (default: 1)"
    )


def add_worker_options(parser: argparse.ArgumentParser) -> None:
    """Add who does the parts of a long computation: processes, machines or a cluster."""
    add_jobs_option(parser)
    parser.add_argument(
        "--shard",
        type=_shard,
        default=(1, 1),
        metavar="I/N",
        help="do only the I-th of N parts, for machines without a cluster",
    )
    parser.add_argument("--dask", metavar="ADDRESS", help="of a scheduler that has workers")


def _shard(text: str) -> tuple[int, int]:
    """Read 2/5."""
    found = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", text, re.ASCII)
    if found is None or not 1 <= int(found[1]) <= int(found[2]):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a shard; write 2/5 for the second of five"
        )
    return int(found[1]), int(found[2])


def add_number_options(parser: argparse.ArgumentParser) -> None:
    """Add ``--exact`` and ``--digits``, for commands that print numbers; `run` heeds them."""
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--exact", action="store_true", help="print every number exactly")
    text = f"of numbers that are too long to be printed exactly (default: {number_form.DIGITS})"
    form.add_argument("--digits", type=_digits, metavar="N", help=text)


def _digits(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 1 <= int(text[:5]) <= 1000:
        raise argparse.ArgumentTypeError(f"{shown(text)} digits; give 1 to 1000")
    return int(text)


def rational_argument(text: str) -> Fraction:
    """Read an exact number from the command line (the ``type=`` of an argument)."""
    if _WITH_UNIT.fullmatch(text):
        raise argparse.ArgumentTypeError(
            f"{shown(text)} has a unit; write the number alone: lengths and forces are in the "
            "units of the grasp, times in seconds (lengths on paper may have units)"
        )
    try:
        return rational(text, "value")
    except InputError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def count_argument(text: str) -> int:
    """Read a number of things to do, one after the other, or a seed."""
    if re.fullmatch(r"[0-9]{1,9}", text, re.ASCII) is None or int(text) > MAX_COUNT:
        raise argparse.ArgumentTypeError(
            f"{shown(text)} is not a whole number from 0 to {MAX_COUNT}; more takes days"
        )
    return int(text)


def integer_argument(text: str) -> int:
    """Read a whole number of ordinary size, such as a dimension or a seed."""
    if re.fullmatch(r"-?[0-9]{1,18}", text, re.ASCII) is None:
        raise argparse.ArgumentTypeError(f"{shown(text)} is not a whole number of up to 18 digits")
    return int(text)


def length_argument(text: str) -> float:
    """Read a length on paper or of a model, which is not an exact number."""
    try:
        return float(rational_argument(text))
    except OverflowError:
        raise argparse.ArgumentTypeError(f"{shown(text)} is too long for paper") from None


def run(parser: Parser, argv: Sequence[str] | None = None) -> int:
    """Parse the arguments, call the subcommand, and return its exit code.

    Bad input ends with one line ``error: ...`` on stderr and exit code 2, without a traceback;
    whatever is not expected, with one line and exit code 70. A reader that closes the pipe
    (``| head``) ends the command quietly. Answers are complete whatever the encoding of stdout is,
    and no text of a file changes the terminal (`safe_text`).
    """
    if sys.stderr is None:  # closed by the shell; print would write to stdout instead
        sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115
    if sys.stdout is None:
        return _report_error("standard output is closed, so there is nowhere to answer; open it")
    with safe_stdout():
        return _run(parser, argv)


def _run(parser: Parser, argv: Sequence[str] | None) -> int:
    try:
        arguments = parser.parse_args(argv)
        exact = any(getattr(arguments, name, False) for name in ("json", "exact"))
        form = number_form.Form(exact, getattr(arguments, "digits", None) or number_form.DIGITS)
        limit, allowed = getattr(arguments, "limit", 1.0), _steps(arguments)
        with budget.limit(limit), budget.metered(allowed), progress.shown(), form.used():
            code: int = arguments.command(arguments)
        sys.stdout.flush()
    except (InputError, MissingExtraError) as error:
        return _report_error(str(error))
    except budget.WorkOver as error:
        _discard_stdout()
        return _report_error(str(error))
    except MemoryError:
        _discard_stdout()
        return _report_error("there is not enough memory on this machine for it; ask for less")
    except BrokenPipeError:
        _discard_stdout()
        return _BROKEN_PIPE
    except OSError as error:
        _discard_stdout()
        return _report_error(f"cannot write the output: {error.strerror or error}")
    except KeyboardInterrupt:
        return _INTERRUPTED
    except Exception as error:
        _discard_stdout()
        return fault(error, argv)
    return code


def _steps(arguments: argparse.Namespace) -> float:
    """Return the steps that a command may take; any number where more is asked for explicitly."""
    named = vars(arguments)
    films = str(named.get("output")).endswith((".gif", ".mp4"))
    asked = any(named.get(name) for name in ("long", "store", "time_limit"))
    return math.inf if films or asked or named.get("jobs", 1) > 1 else budget.COMMAND_STEPS


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


def _encode(value: Any) -> str | list[str]:
    if isinstance(value, (Fraction, Irrational)):
        return written(value)
    raise TypeError(f"{type(value).__name__} has no JSON form")


def _report_error(message: str) -> int:
    print(f"error: {error_text(message)}", file=sys.stderr)
    return _BAD_INPUT


def _discard_stdout() -> None:
    """Send what is still buffered nowhere, so that the interpreter does not complain at exit."""
    try:
        descriptor = sys.stdout.fileno()
    except (OSError, ValueError):
        return
    devnull = os.open(os.devnull, os.O_WRONLY)
    os.dup2(devnull, descriptor)
    os.close(devnull)
