"""The command of the workshop: make the lists of types again.

make census ARGS="8 -o types.json"     classes of 3 to 8 planes, byte for byte as they are shipped
make census ARGS="9 -o types9.npz"     isomorphism classes of nine planes (32 CPU minutes)
    make census ARGS="9 --numbers -o finschi_fukuda.npz"     the numbers of Finschi and Fukuda
"""

from __future__ import annotations

import argparse
import io
import math
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from arrangement.console import terminal
from arrangement.console.options import values
from arrangement.console.progress import watched
from arrangement.console.writing import write_bytes_atomically, write_text_atomically
from arrangement.errors import InputError
from arrangement.library.census.catalogue import (
    MOST_PLANES,
    PUBLISHED,
    chirotopes,
    without_coordinates,
)
from arrangement.library.census.finschi_fukuda import representatives
from arrangement.numbers.budget import chunks, limit

from .build import build
from .generate import generate

#: Chirotopes that are worked on together.
_TOGETHER = 200


def main(argv: list[str] | None = None) -> int:
    """Make a list of types and write it to a file."""
    parser = terminal.command_parser("make census", "Make the census of types again.")
    parser.add_argument("planes", type=values.integer_argument, metavar="M", help="4 to 9")
    parser.add_argument(
        "-o",
        "--output",
        required=True,
        metavar="FILE",
        help=".json: classes of 3 to M planes; .npz: of M, found without coordinates first",
    )
    parser.add_argument(
        "--store",
        metavar="PATH",
        help="keeps what is done; the same command goes on with it (default: OUTPUT.parts)",
    )
    parser.add_argument(
        "--jobs", type=values.integer_argument, default=1, metavar="N", help="processes"
    )
    text = "in place of types their numbers in the catalogue of Finschi and Fukuda, 3 to M planes"
    parser.add_argument("--numbers", action="store_true", help=text)
    parser.set_defaults(command=_write)
    return terminal.run(parser, argv)


def _write(arguments: argparse.Namespace) -> int:
    planes, output = arguments.planes, arguments.output
    if not 4 <= planes <= MOST_PLANES:
        raise InputError(f"M is {planes}; give 4 to {MOST_PLANES} planes")
    store = arguments.store or f"{output}.parts"
    with limit(math.inf):  # the user asked for it and sees the progress
        if output.endswith(".json"):
            write_text_atomically(output, generate(planes, Path(store)))
            return terminal.YES
        if arguments.numbers:
            arrays = {f"of_{m}": numbers(m) for m in range(3, planes + 1)}
        else:
            arrays = build(store, arguments.jobs, planes)
    stream = io.BytesIO()
    np.savez_compressed(stream, **arrays)  # type: ignore[arg-type]
    write_bytes_atomically(output, stream.getvalue())
    if not arguments.numbers:
        print(
            f"{len(arrays['parents']):,} types, {len(arrays['without'])} more without coordinates"
        )
    return terminal.YES


def numbers(planes: int) -> NDArray[np.int32]:
    """Return the numbers in the catalogue of Finschi and Fukuda, in the order of the census.

    Those of nine planes take 6 minutes, of eight 3 seconds.
    """
    parts = [
        representatives(chirotopes(planes, part), planes)
        for part in watched(list(chunks(PUBLISHED[planes], _TOGETHER)), "parts of the types")
    ]
    if planes == MOST_PLANES:
        signs = np.array([signs for signs, _ in without_coordinates()])
        parts.append(representatives(signs, planes))
    order = np.lexsort(np.concatenate(parts).T[::-1])
    found = np.empty(len(order), dtype=np.int32)
    found[order] = np.arange(1, len(order) + 1)
    return found[: PUBLISHED[planes]]


if __name__ == "__main__":
    raise SystemExit(main())
