"""Hyperplanes are added one by one, and cut the regions that their restrictions name."""

from __future__ import annotations

import numpy as np

from arrangement.console.progress import watched
from arrangement.numbers.packing import Words, chunks, grouped, pack, unpack

from .half_regions import PORTION, HalfRegions, TooCloseError, dot, scaled
from .restrictions import Arrangements, Floats, Places, Restrictions, other_columns


class Insertion:
    """Hyperplanes are added one by one to all arrangements of one dimension at once.

    Args:
        points: one in each, on the positive side of its first hyperplanes.
        onto, cutting: the restrictions, and their regions.
        units: a bit for each hyperplane.
    """

    def __init__(
        self,
        arrangements: Arrangements,
        points: Floats,
        onto: Restrictions,
        cutting: HalfRegions,
        units: Words,
    ) -> None:
        self.arrangements, self.onto, self.units = arrangements, onto, units
        self.starts = arrangements.starts
        #: Of each restriction: its arrangement, and which of its hyperplanes it is of.
        self.owner = arrangements.owners()[onto.onto]
        self.step = onto.onto - self.starts[self.owner]
        self.pairs = np.cumsum(onto.merged) - onto.merged
        order = np.lexsort((cutting.of, self.step[cutting.of]))
        count, d = len(points), arrangements.dimension
        steps = np.arange(int(arrangements.sizes.max(initial=0)) + 1)
        #: How many regions there are before each step.
        self.ends = (count + np.searchsorted(self.step[cutting.of[order]], steps)).tolist()
        self.of = np.concatenate([np.arange(count), self.owner[cutting.of[order]]])
        self.sizes = arrangements.sizes[self.of]
        #: The number of the arrangement, then the signs.
        self.words = np.empty((len(self.of), 1 + units.shape[1]), np.uint64)
        self.words[:, 0] = self.of
        self.words[:count, 1:] = np.cumsum(units, axis=0)[arrangements.sides - 1]
        self.points = np.empty((len(self.of), d))
        self.points[:count] = points
        #: New regions, and points on the other side of their hyperplanes.
        self.new_words, self.above = self.words[count:], self.points[count:]
        self.below = np.empty_like(self.above)
        for part in chunks(len(order), max(1, PORTION // (len(steps) * d))):
            self._cut(part, cutting.chosen(order[part]))

    def _cut(self, part: slice, cutting: HalfRegions) -> None:
        """Write the signs of regions of restrictions, and points on both sides of each."""
        floats, d = self.arrangements.floats, self.arrangements.dimension
        step, pivot = self.step[cutting.of], self.onto.pivot[cutting.of]
        each, before = np.arange(len(step)), np.arange(step[-1])
        is_next = np.ones(len(step), np.bool_)
        is_next[1:] = cutting.of[1:] != cutting.of[:-1]
        kinds, place = cutting.of[is_next], np.cumsum(is_next) - 1
        normals = floats[self.onto.onto[kinds]]
        last = self.step[kinds, None] - 1
        others = floats[self.starts[self.owner[kinds], None] + np.minimum(before, last)]
        # so that products are multiples of the normal
        others /= np.maximum(np.abs(dot(normals[:, None], others)), 1e-300)[..., None]
        normals = normals[place]
        lifted = np.zeros((len(step), d))
        lifted[each[:, None], other_columns(d, pivot)] = cutting.points
        lifted[each, pivot] = -dot(lifted, normals) / normals[each, pivot]
        room = np.abs(dot(lifted[:, None], others[place])).min(axis=1)
        move = np.minimum(room / 2, 1.0)[:, None] * normals
        self.above[part], self.below[part] = scaled(lifted + move), scaled(lifted - move)
        signs = cutting.signs
        merged = np.flatnonzero(self.onto.merged[cutting.of])
        if len(merged):
            last = step[merged, None] - 1
            pairs = self.pairs[cutting.of[merged], None] + np.minimum(before, last)
            bits = np.take_along_axis(
                unpack(signs[merged], len(before)), self.onto.member[pairs], axis=1
            )
            bits ^= self.onto.turned[pairs]
            signs[merged] = pack(bits & (before <= last), len(self.units))
        self.new_words[part, 1:] = signs

    def regions(self) -> HalfRegions:
        """Return the regions of all arrangements."""
        for j in watched(range(1, len(self.ends) - 1), "hyperplanes"):
            self._add(j)
        return HalfRegions(self.words[:, 1:], self.points, self.of)

    def _add(self, j: int) -> None:
        """Add hyperplane j of each arrangement that has it."""
        count, end = self.ends[j : j + 2]
        new = slice(count - self.ends[0], end - self.ends[0])
        word, bit = 1 + j // 64, self.units[j, j // 64]
        there = np.flatnonzero(self.sizes[:count] > j)
        places = _places(self.words[np.concatenate([there, np.arange(count, end)])], len(there))
        is_whole = np.ones(len(there), np.bool_)
        is_whole[places] = False
        whole = there[is_whole]
        normals = self.arrangements.floats[self.starts[self.of[whole]] + j]
        self.words[whole[dot(self.points[whole], normals) > 0], word] |= bit
        self.new_words[new, word] |= bit
        self.points[there[places]] = self.below[new]


def _places(rows: Words, count: int) -> Places:
    """Return where the rows after the first ones, all distinct, are among these."""
    if count == len(rows):
        return np.zeros(0, np.intp)
    order, new = grouped(rows)
    again = np.flatnonzero(~new)
    place, which = order[again - 1], order[again] - count
    if len(place) != len(rows) - count or (place >= count).any() or (which < 0).any():
        raise TooCloseError
    found = np.empty(len(place), np.intp)
    found[which] = place
    return found
