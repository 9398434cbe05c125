"""Sign vectors as bits in 64-bit words, and what is distinct among many."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

#: (..., W) 64-bit words; class k is bit ``k % 64`` of word ``k // 64``.
Words: TypeAlias = NDArray[np.uint64]
Bits: TypeAlias = NDArray[np.bool_]

_MULTIPLIER = np.uint64(0x9E3779B97F4A7C15)
_HALF = np.uint64(32)


def pack(bits: Bits, classes: int = 1) -> Words:
    """Pack the last axis into words, which have room for a number of classes at least."""
    width = bits.shape[-1]
    padded = np.zeros((*bits.shape[:-1], 64 * -(-max(width, classes) // 64)), bool)
    padded[..., :width] = bits
    packed = np.packbits(padded, axis=-1, bitorder="little")
    return packed.view("<u8").astype(np.uint64, copy=False)


def unpack(words: Words, classes: int) -> Bits:
    """Return rows of bits, one column for each class."""
    octets = np.ascontiguousarray(words, dtype="<u8").view(np.uint8)
    return np.unpackbits(octets, axis=1, count=classes, bitorder="little").view(np.bool_)


def unit_words(classes: int) -> Words:
    """Return (classes, W); row k has bit k alone."""
    return pack(np.eye(classes, dtype=bool))


def distinct_rows(rows: Words) -> NDArray[np.intp]:
    """Return the place of one copy of each different row."""
    order, new = group_rows(rows)
    return order[new]


def group_rows(rows: Words) -> tuple[NDArray[np.intp], Bits]:
    """Return an order in which equal rows are neighbours, and which of them are new in it.

    Rows are sorted by one mixed key. Then rows with equal keys are compared in full; if two
    different ones share a key, all are sorted as they are.

    Complexity: O(N log N) for N rows.
    """
    keys = _keys(rows)
    order = np.argsort(keys, kind="stable")
    new = _changes(rows, order)
    if rows.shape[1] > 1 and (new & ~_changes(keys[:, None], order)).any():
        order = np.lexsort(rows.T)
        new = _changes(rows, order)
    return order, new


def _keys(rows: Words) -> Words:
    keys = rows[:, 0].copy()
    for column in range(1, rows.shape[1]):
        keys *= _MULTIPLIER
        keys ^= keys >> _HALF
        keys ^= rows[:, column]
    return keys


def _changes(rows: Words, order: NDArray[np.intp]) -> Bits:
    """Return which rows differ from the one before in an order; the first one does."""
    new = np.zeros(len(rows), bool)
    new[:1] = True
    for column in rows.T:
        ordered = column[order]
        new[1:] |= ordered[1:] != ordered[:-1]
    return new
