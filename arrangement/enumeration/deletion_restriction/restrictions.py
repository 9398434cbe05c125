"""Restrictions of hyperplanes to one another, all those of one dimension at once.

They are made in exact integers, int64 where a bound of their products allows; equal ones are found
as equal tuples. Each class of hyperplanes that meet the other one in the same set is represented by
its first member, with the orientation of that one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.numbers.coefficients import (
    SAFE,
    Integers,
    as_integers,
    primitive,
)
from arrangement.numbers.float_filter import EXACT
from arrangement.numbers.packing import Bits

Floats: TypeAlias = NDArray[np.float64]
Places: TypeAlias = NDArray[np.intp]

#: Images of hyperplanes that are made at once.
_PORTION = 1 << 14


@dataclass(frozen=True, slots=True)
class Arrangements:
    """Arrangements of distinct hyperplanes through the origin of R^d, one after the other.

    Attributes:
        normals: (N, d), of all hyperplanes; int64 where sums of two products of their entries fit.
        floats: (N, d), the normals, each divided by its largest entry: correctly rounded quotients.
        sizes: (n,), how many hyperplanes each arrangement has.
        sides: (n,), of these, the first so many have the regions on their positive side.
    """

    normals: Integers
    floats: Floats
    sizes: Places
    sides: Places

    @property
    def dimension(self) -> int:
        """The dimension d of their space."""
        return int(self.floats.shape[1])

    @property
    def starts(self) -> Places:
        """(n,), the first hyperplane of each arrangement."""
        return np.cumsum(self.sizes) - self.sizes

    def without_normals(self) -> Arrangements:
        """Return the same with floats alone, for there are to be no more restrictions."""
        return replace(self, normals=np.empty((0, self.dimension), np.int64))

    def owners(self) -> Places:
        """Return (N,), the arrangement of each hyperplane."""
        return np.repeat(np.arange(len(self.sizes)), self.sizes)

    def chosen(self, kept: Bits) -> Arrangements:
        """Return some of the arrangements."""
        if kept.all():
            return self
        rows = np.repeat(kept, self.sizes)
        return Arrangements(
            self.normals[rows], self.floats[rows], self.sizes[kept], self.sides[kept]
        )


@dataclass(frozen=True, slots=True)
class Restrictions:
    """From which arrangements, one dimension above, others are restrictions.

    An arrangement restricted to its hyperplane j is that of the hyperplanes before j.

    Attributes:
        onto: (n,), the hyperplane, among all above, to which each is the restriction.
        pivot: (n,), its coordinate that is eliminated.
        merged: (n,), how many hyperplanes above are before it; 0 if no two have the same image.
        member: (sum of merged,), which hyperplane each of these becomes.
        turned: (sum of merged,), whether with the other orientation.
    """

    onto: Places
    pivot: Places
    merged: Places
    member: Places
    turned: Bits

    def chosen(self, kept: Bits) -> Restrictions:
        """Return those of some arrangements."""
        if kept.all():
            return self
        pairs = np.repeat(kept, self.merged)
        return Restrictions(
            self.onto[kept],
            self.pivot[kept],
            self.merged[kept],
            self.member[pairs],
            self.turned[pairs],
        )


def arrangement_of(rows: Sequence[Sequence[int]], sides: int) -> Arrangements:
    """Return one arrangement."""
    return _arrangements(as_integers(rows), np.array([len(rows)]), np.array([sides]))


def joined(parts: Sequence[Any]) -> Any:
    """Return the arrangements, or restrictions, of all parts."""
    if len(parts) == 1:
        return parts[0]
    kind = type(parts[0])
    names = kind.__slots__
    return kind(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))


def portions(above: Arrangements) -> list[Places]:
    """Return all hyperplanes to which there are restrictions: those that are no sides."""
    before = np.arange(len(above.normals)) - np.repeat(above.starts, above.sizes)
    onto = np.flatnonzero(before >= np.repeat(above.sides, above.sizes))
    parts = np.cumsum(before[onto]) // _PORTION
    return np.split(onto, np.flatnonzero(np.diff(parts)) + 1)


def restricted(above: Arrangements, onto: Places) -> tuple[Arrangements, Restrictions]:
    """Restrict hyperplanes to some others of their arrangements, which come after them.

    Those with two sides that leave nothing between them are left out.
    """
    owner = np.searchsorted(np.cumsum(above.sizes), onto, side="right")
    start, sides = above.starts[owner], above.sides[owner]
    before = onto - start
    n, below = len(onto), np.repeat(np.arange(len(onto)), before)
    number = np.arange(len(below)) - np.repeat(np.cumsum(before) - before, before)
    pivot = np.abs(above.floats[onto]).argmax(axis=1)
    images = _images(above.normals, onto, pivot, below, start[below] + number)
    label, first, turned = _classes(images, below)
    is_side = number < sides[below]
    sizes = np.bincount(below[first], minlength=n)
    new_sides = np.bincount(below[first[is_side[first]]], minlength=n)
    found = _arrangements(images[first], sizes, new_sides)
    merged = np.where(sizes < before, before, 0)
    pairs = merged[below] > 0
    member = (label - found.starts[below])[pairs]
    maps = Restrictions(onto, pivot, merged, member, turned[pairs])
    empty = np.bincount(below, turned & is_side, minlength=n) > 0
    return found.chosen(~empty), maps.chosen(~empty)


def _images(
    normals: Integers, onto: Places, pivot: Places, below: Places, rows: Places
) -> Integers:
    """Return the restriction of each row to a hyperplane, whose coordinate `pivot` is eliminated.

    Args:
        below: the place of the hyperplane in `onto`.
    """
    columns = other_columns(normals.shape[1], pivot)
    scale = normals[onto, pivot][:, None]
    others = normals[onto[:, None], columns] * np.where(scale > 0, 1, -1)
    found = normals[rows[:, None], columns[below]] * np.abs(scale)[below]
    found -= normals[rows, pivot[below]][:, None] * others[below]
    return primitive(found[..., None])[..., 0]


def _classes(images: Integers, below: Places) -> tuple[Places, Places, Bits]:
    """Compare restrictions in one arrangement.

    Returns:
        The number of the class of each, the first of each class, and which have not its
        orientation.
    """
    lead = images[np.arange(len(images)), (images != 0).argmax(axis=1)]
    away = lead < 0
    unoriented = np.where(away[:, None], -images, images)
    known: dict[tuple[int, ...], int] = {}
    keys = zip(below.tolist(), *unoriented.T.tolist(), strict=True)
    places = np.fromiter(map(known.setdefault, keys, range(len(images))), np.intp)
    is_first = places == np.arange(len(images))
    label = (np.cumsum(is_first) - 1)[places]
    return label, np.flatnonzero(is_first), away ^ away[places]


def other_columns(d: int, pivot: Places) -> Places:
    """Return (n, d - 1), all coordinates but the pivot."""
    columns = np.arange(d - 1)
    found: Places = columns + (columns >= pivot[:, None])
    return found


def _arrangements(normals: Integers, sizes: Places, sides: Places) -> Arrangements:
    largest = np.abs(normals).max(axis=1, keepdims=True)
    size = int(largest.max(initial=0))
    if size > EXACT:
        normals, largest = normals.astype(object), largest.astype(object)
    floats: Floats = (normals / largest).astype(np.float64)
    fits = 2 * size**2 < SAFE
    return Arrangements(normals.astype(np.int64 if fits else object), floats, sizes, sides)
