"""Sets of planes as bits, and small images of them under permutations.

The image that stands for a set need not be the smallest of its orbit: it is what a walk finds that
takes every permutation of a list in turn and keeps the smaller one. Sets that get the same image
lie in one orbit, and nothing else is asked.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .automorphisms import Permutations

Booleans = NDArray[np.bool_]
Words = NDArray[np.uint64]
#: Sets whose images are compared at once, in words of 64.
_BATCH = 1 << 9
_FACTOR = 0x9E3779B97F4A7C15
#: Permutations that a walk tries.
_ELEMENTS = 40


class Images:
    """Small images under a group of permutations.

    Args:
        generators: of the group; each takes vector i to entry i.
    """

    def __init__(self, generators: Permutations) -> None:
        self._elements = _products(generators, _ELEMENTS)

    def small(self, sets: Booleans) -> Words:
        """Return an image of each set (a row), packed, that no permutation of the list improves."""
        size = sets.shape[1]
        found = packed(sets)
        if not len(self._elements):
            return found
        names = np.arange(len(found))
        moving = np.ones(len(found), dtype=np.bool_)
        while moving.any():
            order, start = groups(found)
            place = np.empty_like(order)
            place[order] = np.cumsum(start) - 1
            moving = np.logical_and.reduceat(moving[order], np.flatnonzero(start))
            found, names = found[order[start]], place[names]
            batch = 64 * _BATCH
            for part in np.array_split(np.flatnonzero(moving), -(-int(moving.sum()) // batch) or 1):
                walked = self._walked(unpacked(found[part], size))
                moving[part] = (walked != found[part]).any(axis=1)
                found[part] = walked
        return found[names]

    def _walked(self, sets: Booleans) -> Words:
        """Walk with up to 64 `_BATCH` sets; bit j of row i says whether set j has vector i."""
        best = packed(np.ascontiguousarray(sets.T))
        for element in self._elements:
            image = best[element]
            better = np.zeros(best.shape[1], dtype=np.uint64)
            open_ = ~better
            for here, there in zip(best, image, strict=True):
                differ = (here ^ there) & open_
                better |= differ & there
                open_ ^= differ
            best ^= (best ^ image) & better
        return packed(unpacked(best, len(sets)).T)


def groups(words: Words) -> tuple[NDArray[np.intp], Booleans]:
    """Return an order that puts equal rows side by side, and where in it a row begins to differ.

    Rows are sorted by a hash. If two different rows have the same one, equal rows may end up apart.
    """
    factors = np.cumprod(np.full(words.shape[1], _FACTOR, dtype=np.uint64))
    order = (words * factors).sum(axis=1).argsort()
    start = np.ones(len(order), dtype=np.bool_)
    start[1:] = (words[order[1:]] != words[order[:-1]]).any(axis=1)
    return order, start


def packed(rows: Booleans) -> Words:
    """Return rows of bits as words; the last word is filled with zeros."""
    size = rows.shape[1]
    bits = np.packbits(rows, axis=1, bitorder="little")
    full = np.zeros((len(rows), 8 * -(-size // 64)), dtype=np.uint8)
    full[:, : bits.shape[1]] = bits
    return full.view(np.uint64)


def unpacked(words: Words, size: int) -> Booleans:
    """Return the first `size` bits of each row."""
    bits = np.unpackbits(words.view(np.uint8), axis=1, count=size, bitorder="little")
    return bits.view(np.bool_)


def _products(generators: Permutations, count: int) -> Permutations:
    """Return the generators and random products of them, the same every time."""
    if not len(generators):
        return generators
    random = np.random.default_rng(0)
    found = list(generators)
    state = [*generators] * (1 + 10 // len(generators))
    identity = np.arange(generators.shape[1])
    known = {identity.tobytes(), *(g.tobytes() for g in generators)}
    for step in range(20 * count):
        i, j = random.choice(len(state), 2, replace=False)
        state[i] = state[i][state[j]] if random.integers(2) else state[j][state[i]]
        if step > 60 and state[i].tobytes() not in known:
            known.add(state[i].tobytes())
            found.append(state[i])
        if len(found) >= count:
            break
    return np.array(found)
