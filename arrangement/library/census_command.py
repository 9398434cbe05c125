"""The commands of the census: show its numbers, check the list of nine planes.

The census itself is imported when a command runs, so that ``--help`` answers at once.
"""

from __future__ import annotations

import argparse
import math
from dataclasses import asdict

from arrangement.console import terminal
from arrangement.errors import InputError
from arrangement.numbers.budget import limit


def add_commands(parser: argparse.ArgumentParser) -> None:
    """Add ``show`` and ``check``."""
    commands = parser.add_subparsers(required=True, metavar="WHAT")

    show = commands.add_parser("show", help="how many types have so many regions, or such points")
    show.add_argument("planes", type=terminal.integer_argument, metavar="M", help="3 to 9")
    show.set_defaults(command=_show)

    check = commands.add_parser("check", help="check the list of nine planes without coordinates")
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


def _planes(arguments: argparse.Namespace, least: int) -> int:
    from .census import MOST_PLANES

    planes: int = arguments.planes
    if not least <= planes <= MOST_PLANES:
        raise InputError(f"M is {planes}; give {least} to {MOST_PLANES} planes")
    return planes


def _show(arguments: argparse.Namespace) -> int:
    from .census import PUBLISHED, PUBLISHED_SIMPLE
    from .census.tables import table

    planes = _planes(arguments, 3)
    found = table(planes)
    if arguments.json:
        record = asdict(found)
        points = [{"t": row, "types": number} for row, number in found.by_points.items()]
        terminal.print_json({**record, "by_points": points})
        return terminal.YES
    print(f"types            {found.types:,} (published {PUBLISHED[planes]:,})")
    print(f"simple           {found.simple:,} (published {PUBLISHED_SIMPLE[planes]:,})")
    print(f"simplicial       {found.simplicial}")
    print(f"SHA-256          {found.digest}")
    print("regions          types")
    for regions, number in found.by_regions.items():
        print(f"{regions:>7}  {number:>13,}")
    print(f"points           {len(found.by_points)} t-vectors; --json lists them")
    return terminal.YES


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
