"""What the three programs share: their parsers, options of all commands, errors, exit codes.

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
import sys
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from arrangement.errors import InputError, MissingExtraError
from arrangement.numbers import budget
from arrangement.numbers.real import Irrational, written

from . import number_form, progress
from .entry import INTERRUPTED, fault
from .options.completion import PrintCompletion
from .options.parser import Parser, Version
from .options.values import digits_argument, integer_argument, shard_argument, times_argument
from .safe_text import discard, error_text, safe_stderr, safe_stdout

YES = 0
NO = 1
_BAD_INPUT = 2
#: Neither yes nor no was proved.
UNDECIDED = 3
#: What a shell reports for a program that SIGPIPE ended (128 + the signal's number).
_BROKEN_PIPE = 141


def command_parser(prog: str, description: str) -> Parser:
    """Return the parser of one program, with the options that print and end."""
    every = ("yes or done", "no or refuted", "undecided", "internal error")
    parser = Parser(prog=prog, description=description, epilog=_exit_codes(every))
    parser.add_argument("--version", action=Version)
    parser.add_argument("--print-completion", action=PrintCompletion)
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
    added.commands = commands.choices
    return added


def _exit_codes(answers: Sequence[str]) -> str:
    """Return the line on exit codes: what 0, 1, 3 and 70 mean, and 2."""
    codes = {**dict(zip((YES, NO, UNDECIDED, 70), answers, strict=False)), _BAD_INPUT: "bad input"}
    return f"Exit codes: {', '.join(f'{code} {codes[code]}' for code in sorted(codes))}."


def add_common_options(parser: argparse.ArgumentParser) -> None:
    """Add ``--json``, ``--limit`` and ``--traceback``, which every command has."""
    group = parser.add_argument_group("other")
    group.add_argument("--json", action="store_true", help="print only JSON on stdout")
    group.add_argument(
        "--limit",
        type=times_argument,
        default=1.0,
        metavar="N",
        help="scale the default limits on size, memory and work by N",
    )
    group.add_argument(
        "--traceback", action="store_true", help="show the traceback of an internal error"
    )


def add_jobs_option(parser: Any) -> None:
    """Add the number of processes."""
    parser.add_argument(
        "--jobs",
        type=integer_argument,
        default=1,
        metavar="N",
        help="number of processes (default: 1)",
    )


def add_worker_options(parser: Any, shard: bool = True) -> None:
    """Add who does the parts of a long computation: processes, machines or a cluster.

    Args:
        shard: whether a machine may do some of the parts alone.
    """
    add_jobs_option(parser)
    if shard:
        parser.add_argument(
            "--shard",
            type=shard_argument,
            default=(1, 1),
            metavar="I/N",
            help="compute only the I-th of N parts, for machines without a cluster",
        )
    parser.add_argument("--dask", metavar="ADDRESS", help="address of a Dask scheduler")


def add_number_options(parser: argparse.ArgumentParser) -> None:
    """Add ``--exact`` and ``--digits``, for commands that print numbers; `run` heeds them."""
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--exact", action="store_true", help="print every number exactly")
    text = f"digits of numbers too long to be printed exactly (default: {number_form.DIGITS})"
    form.add_argument("--digits", type=digits_argument, metavar="N", help=text)


def run(parser: Parser, argv: Sequence[str] | None = None) -> int:
    """Parse the arguments, call the subcommand, and return its exit code.

    Bad input ends with one line ``error: ...`` on stderr and exit code 2, without a traceback;
    whatever is not expected, with one line and exit code 70. A reader that closes the pipe
    (``| head``) ends the command quietly. Where stderr cannot be written, the code alone tells what
    happened. Answers are complete whatever the encoding of stdout is,
    and no text of a file changes the terminal (`safe_text`).
    """
    if sys.stderr is None:  # closed by the shell; print would write to stdout instead
        sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115
    with safe_stderr():
        if sys.stdout is None:
            return _report_error("standard output is closed; open it, the answer goes there")
        with safe_stdout():
            return _run(parser, argv)


def _run(parser: Parser, argv: Sequence[str] | None) -> int:
    try:
        arguments = parser.parse_args(argv)
        exact = any(getattr(arguments, name, False) for name in ("json", "exact"))
        form = number_form.Form(exact, getattr(arguments, "digits", None) or number_form.DIGITS)
        limit, allowed = getattr(arguments, "limit", 1.0), _steps(arguments)
        with budget.limit(limit), budget.meter_steps(allowed), progress.shown(), form.used():
            code: int = arguments.command(arguments)
        sys.stdout.flush()
    except KeyboardInterrupt:
        return INTERRUPTED
    except (Exception, budget.WorkOver) as error:
        return INTERRUPTED if _was_interrupted(error) else _end(error, argv)
    return code


def _was_interrupted(error: BaseException) -> bool:
    """Return whether Ctrl-C is behind an error: closing what was half written raises others."""
    context = error.__context__
    return context is not None and (
        isinstance(context, KeyboardInterrupt) or _was_interrupted(context)
    )


def _end(error: BaseException, argv: Sequence[str] | None) -> int:
    """Report why a command ends; return its exit code."""
    if isinstance(error, (InputError, MissingExtraError)):
        return _report_error(str(error))
    discard(sys.stdout)
    match error:
        case budget.WorkOver():
            return _report_error(str(error))
        case MemoryError():
            return _report_error("there is not enough memory on this machine for it; ask for less")
        case BrokenPipeError():
            return _BROKEN_PIPE
        case OSError():
            return _report_error(f"cannot write the output: {error.strerror or error}")
    return fault(error, argv)


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
