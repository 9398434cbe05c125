"""Arguments of the commands for own claims and sweeps; what they do is imported when they run."""

from __future__ import annotations

import argparse
import re
from typing import Any


def add_run_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of ``run`` that speak of files with own claims."""
    group = parser.add_argument_group(
        "claims of your own (FILE.py)",
        "The file is run as a Python program, with all your rights.",
    )
    group.add_argument("--samples", type=int, metavar="N", help="random instances of each claim")
    group.add_argument("--census", type=int, metavar="M", help="all types of up to M planes")
    group.add_argument(
        "--save",
        metavar="FOLDER",
        default="counterexamples",
        help="for the instances that refute a claim (default: counterexamples)",
    )


def run_files(arguments: argparse.Namespace, width: int) -> int:
    """Check the claims of files."""
    from .user import run_files as run

    return run(arguments, width)


def add_commands(commands: Any) -> list[argparse.ArgumentParser]:
    """Add the commands of sweeps; return their parsers."""
    return [_sweep(commands), _status(commands), _merge(commands), _report(commands)]


def _sweep(commands: Any) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        "sweep", help="check one claim on very many random instances; can be interrupted"
    )
    parser.add_argument("claim", metavar="ID", help="a claim, FILE.py, or FILE.py:ID")
    parser.add_argument(
        "--planes",
        type=_range,
        required=True,
        metavar="LOW..HIGH",
        help="numbers of planes, or of contacts",
    )
    parser.add_argument("--samples", type=int, required=True, metavar="N", help="instances in all")
    parser.add_argument("--seed", type=int, default=0, help="of all of them (default: 0)")
    parser.add_argument(
        "--store", required=True, metavar="FILE", help="keeps what is done; made when missing"
    )
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="processes (default: 1)")
    parser.add_argument(
        "--shard",
        type=_shard,
        default=(1, 1),
        metavar="I/N",
        help="do only the I-th of N parts, for machines without a cluster (see merge)",
    )
    parser.add_argument("--dask", metavar="ADDRESS", help="of a scheduler that has workers")
    parser.add_argument(
        "--chunk", type=int, default=200, metavar="N", help="instances in a chunk (default: 200)"
    )
    parser.set_defaults(command=_run_sweep)
    return parser


def _status(commands: Any) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        "status", help="say how far a sweep is, also while it runs"
    )
    parser.add_argument("store", metavar="STORE")
    parser.set_defaults(command=_run_status)
    return parser


def _merge(commands: Any) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        "merge", help="put the chunks of several stores of one sweep into one"
    )
    parser.add_argument("store", metavar="STORE", help="where to; made when missing")
    parser.add_argument("parts", nargs="+", metavar="PART", help="stores to read")
    parser.set_defaults(command=_run_merge)
    return parser


def _report(commands: Any) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        "report", help="make a report from a store or from a JSON record"
    )
    parser.add_argument("source", metavar="SOURCE", help="a store of a sweep, or FILE.json of run")
    parser.add_argument(
        "--output",
        metavar="FILE",
        help="FILE.json, FILE.md, FILE.html or FILE.tex (default: Markdown on stdout)",
    )
    parser.set_defaults(command=_run_report)
    return parser


def _range(text: str) -> tuple[int, int]:
    """Read 3..12, or 5 for 5..5."""
    found = re.fullmatch(r"([0-9]{1,6})(?:\.\.([0-9]{1,6}))?", text, re.ASCII)
    if found is None:
        raise argparse.ArgumentTypeError(f"{text!r} is no range; write 3..12")
    return int(found[1]), int(found[2] or found[1])


def _shard(text: str) -> tuple[int, int]:
    """Read 2/5."""
    found = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", text, re.ASCII)
    if found is None or not 1 <= int(found[1]) <= int(found[2]):
        raise argparse.ArgumentTypeError(f"{text!r} is no shard; write 2/5 for the second of five")
    return int(found[1]), int(found[2])


def _run_sweep(arguments: argparse.Namespace) -> int:
    from .sweep import run_sweep

    return run_sweep(arguments)


def _run_status(arguments: argparse.Namespace) -> int:
    from .sweep import run_status

    return run_status(arguments)


def _run_merge(arguments: argparse.Namespace) -> int:
    from .sweep import run_merge

    return run_merge(arguments)


def _run_report(arguments: argparse.Namespace) -> int:
    from .sweep import run_report

    return run_report(arguments)
