"""Long integers as FLINT's: the one door to python-flint.

A step of elimination, ``(p a - q b) // d``, takes as long with both kinds at 200 bits; with 500
bits Python's integers take 3 times as long as FLINT's, with 1000 bits 4 times, with 4000 bits 7.
Short ones stay as they are, and FLINT is loaded where long ones occur.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from .exact import largest

#: Bits of a long integer.
_LONG = 300


def fast_integers(rows: Sequence[Sequence[int]]) -> list[list[Any]]:
    """Return rows of integers of one kind; both kinds mix in sums and products.

    FLINT's are none of Python's numbers: `int` must come before a `Fraction` is made of them.
    """
    size = largest(rows)
    if not isinstance(size, int) or size.bit_length() < _LONG:
        return [list(row) for row in rows]
    from flint import fmpz

    return [[fmpz(x) for x in row] for row in rows]
