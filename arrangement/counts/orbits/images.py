"""Low images of sets of planes under permutations: few of them for each orbit of sets.

Every plane has a height, and a set the sum of those of its planes. Steps go from a set to the
lowest of its images under a list of permutations, until none is lower. Sets that end at the same
image lie in one orbit, and nothing else is asked; but the fewer images an orbit has, the better.

Heights that vary at random have many valleys. So those are taken that permutations change least:
on each orbit of planes the slowest wave of a walk in which every generator takes a step.
"""

from __future__ import annotations

import numpy as np

from arrangement.counts.modular import Integers
from arrangement.numbers.packing import Bits, Words, chunks, pack

from .automorphisms import Permutations

#: Sets that go down together.
_BATCH = 1 << 12
#: Permutations that are tried in each step.
_ELEMENTS = 40
#: Steps of the walk after which the slowest wave is left.
_ROUNDS = 300


class Images:
    """Low images under a group of permutations.

    Args:
        generators: of the group; each takes vector i to entry i.
    """

    def __init__(self, generators: Permutations) -> None:
        # a vector more, of height 0, that nothing moves: it fills up small sets
        size = generators.shape[1]
        moves = np.vstack([np.arange(size), *_products(generators, _ELEMENTS)])
        self._moves = np.column_stack([moves, np.full(len(moves), size)])
        self._heights = np.append(_heights(generators), 0)[self._moves].T.copy()

    def low(self, sets: Bits) -> Words:
        """Return an image of each set (a row), packed, that no permutation of the list lowers."""
        found = pack(sets)
        if len(self._moves) > 1:
            order = sets.sum(axis=1).argsort(kind="stable")
            for part in chunks(len(sets), _BATCH):
                found[order[part]] = pack(self._lowered(sets[order[part]]))
        return found

    def steps(self, sets: Bits) -> float:
        """Return about how many steps their images take."""
        return np.count_nonzero(sets) * len(self._moves) / 20

    def _lowered(self, sets: Bits) -> Bits:
        """Return images of sets of about the same size."""
        count, size = sets.shape
        sizes = sets.sum(axis=1)
        names, vectors = np.nonzero(sets)
        members = np.full((sizes.max(), count), size)
        members[np.arange(len(names)) - (sizes.cumsum() - sizes)[names], names] = vectors
        found = np.zeros((count, size + 1), dtype=np.bool_)
        names = np.arange(count)
        while len(names):
            heights = np.zeros((len(names), len(self._moves)), dtype=np.int64)
            for member in members:
                heights += self._heights[member]
            lowest = heights.argmin(axis=1)
            goes = lowest > 0
            found[names[~goes], members[:, ~goes]] = True
            names, members = names[goes], self._moves[lowest[goes], members[:, goes]]
        return found[:, :size]


def _heights(generators: Permutations) -> Integers:
    """Return heights of the vectors, the highest four times the lowest at most."""
    size = generators.shape[1]
    steps = np.concatenate([[np.arange(size)], generators, generators.argsort(axis=1)])
    orbit = np.arange(size)
    while ((lower := orbit[steps].min(axis=0)) < orbit).any():
        orbit = lower
    number = np.bincount(orbit)[orbit]
    wave = np.random.default_rng(0).random((size,))
    for _ in range(_ROUNDS):
        wave = len(steps) * wave + wave[steps].sum(axis=0)
        wave -= np.bincount(orbit, wave)[orbit] / number
        top = np.zeros(size)
        np.maximum.at(top, orbit, np.abs(wave))
        wave /= np.maximum(top, 1)[orbit]
    heights: Integers = (2.0 ** (60 - size.bit_length() - wave)).astype(np.int64)
    return heights


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
