"""Arguments of the commands for own claims and sweeps; what they do is imported when they run."""

from __future__ import annotations

import argparse
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
    from .owncli import run_files as run

    return run(arguments, width)


def add_commands(_commands: Any) -> list[argparse.ArgumentParser]:
    """Add the commands of sweeps; return their parsers."""
    return []
