"""Check the list of nine hyperplanes without coordinates: ``python -m`` this module."""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from dataclasses import asdict

from arrangement.console import terminal
from arrangement.console.options import values
from arrangement.console.options.parser import Parser
from arrangement.errors import InputError
from arrangement.numbers.budget import limit

from .catalogue import MOST_PLANES, PUBLISHED
from .tables import check


def main(argv: Sequence[str] | None = None) -> int:
    """Run the check; exit code 0 when the list is right, 1 when it is wrong."""
    parser = Parser(description=__doc__)
    parser.add_argument(
        "--sample",
        type=values.count_argument,
        default=20,
        metavar="N",
        help="classes of eight hyperplanes to extend (default: 20)",
    )
    parser.add_argument("--seed", type=values.count_argument, default=0, help="of their choice")
    parser.add_argument(
        "--verified",
        action="store_true",
        help="check the proofs by the formally verified program (built by `make formal`)",
    )
    terminal.add_common_options(parser)
    parser.set_defaults(command=_check, long=True)
    return terminal.run(parser, argv)


def _check(arguments: argparse.Namespace) -> int:
    if not 0 <= arguments.sample <= PUBLISHED[MOST_PLANES - 1]:
        raise InputError(
            f"--sample is {arguments.sample}; expected 0 to {PUBLISHED[MOST_PLANES - 1]}"
        )
    with limit(math.inf):  # its progress is shown
        result = check(arguments.sample, arguments.seed, proved=arguments.verified)
    checker = "verified" if arguments.verified else "Python"
    if arguments.json:
        name = "proved" if arguments.verified else "python"
        terminal.print_json({**asdict(result), "checker": name, "holds": result.holds})
    else:
        words = "all different" if result.different else "NOT in order: some may be the same"
        print(f"the list's classes are {words}")
        print(
            f"{result.proofs} classes have no coordinates, by proofs that hold (by the {checker} "
            "checker)"
        )
        print(
            f"{result.parents} classes of eight hyperplanes have {result.extensions:,} extensions: "
            f"{result.listed:,} in the list, {result.without} without coordinates, "
            f"{result.extensions - result.listed - result.without} missing"
        )
    return terminal.YES if result.holds else terminal.NO


if __name__ == "__main__":
    raise SystemExit(main())
