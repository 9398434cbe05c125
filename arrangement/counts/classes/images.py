"""Sets of planes as bits, and small images of them under permutations.

The image that stands for a set need not be the smallest of its orbit: it is what a walk finds that
takes every permutation of a list in turn and keeps the smaller one. Sets that get the same image
lie in one orbit, and nothing else is asked.
"""

from __future__ import annotations

import numpy as np

from arrangement.numbers.packing import Bits, Words, grouped, pack, unpack

from .automorphisms import Permutations

#: Sets whose images are compared at once, in words of 64.
_BATCH = 1 << 9
#: Permutations that a walk tries.
_ELEMENTS = 40


class Images:
    """Small images under a group of permutations.

    Args:
        generators: of the group; each takes vector i to entry i.
    """

    def __init__(self, generators: Permutations) -> None:
        self._elements = _products(generators, _ELEMENTS)

    def small(self, sets: Bits) -> Words:
        """Return an image of each set (a row), packed, that no permutation of the list improves."""
        size = sets.shape[1]
        found = pack(sets)
        if not len(self._elements):
            return found
        names = np.arange(len(found))
        moving = np.ones(len(found), dtype=np.bool_)
        while moving.any():
            order, start = grouped(found)
            place = np.empty_like(order)
            place[order] = np.cumsum(start) - 1
            moving = np.logical_and.reduceat(moving[order], np.flatnonzero(start))
            found, names = found[order[start]], place[names]
            batch = 64 * _BATCH
            for part in np.array_split(np.flatnonzero(moving), -(-int(moving.sum()) // batch) or 1):
                walked = self._walked(unpack(found[part], size))
                moving[part] = (walked != found[part]).any(axis=1)
                found[part] = walked
        return found[names]

    def _walked(self, sets: Bits) -> Words:
        """Walk with up to 64 `_BATCH` sets; bit j of row i says whether set j has vector i."""
        best = pack(np.ascontiguousarray(sets.T))
        for element in self._elements:
            image = best[element]
            better = np.zeros(best.shape[1], dtype=np.uint64)
            open_ = ~better
            for here, there in zip(best, image, strict=True):
                differ = (here ^ there) & open_
                better |= differ & there
                open_ ^= differ
            best ^= (best ^ image) & better
        return pack(unpack(best, len(sets)).T)


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
