"""Regions alone, by deletion and restriction: no face of lower dimension is listed.

Hyperplanes are added one by one. A new one, H, cuts exactly those regions of the others that have a
region of the restriction to H in their closure, and these have the same signs at the others. So the
regions of the restriction, listed first in the same way, say which regions are cut in two, and
every other region is on one side of H. Of a central arrangement only the half on the positive
side of the first hyperplane is listed; of an affine one that is all, if infinity comes first. So
may the regions be listed that are on the positive side of several hyperplanes, the first ones: a
linear program has a point there or none, in each restriction.

1. Downwards, all restrictions of one dimension are made at once, to rank 2, in exact integers,
   int64 where a bound of their products allows; equal ones are found as equal tuples. Each class of
   hyperplanes that meet the other one in the same set is represented by its first member, with the
   orientation of that one.
2. There each arrangement is sorted around the origin, all with one sort.
3. Upwards, step j of a dimension adds hyperplane j of all its arrangements. The regions that it
   cuts are found by one sort of sign vectors, with the number of the arrangement before each.

**Exactness.** Restrictions are integral, so the number of regions listed is exact whatever floats
do: m on one side of the first of m lines of rank 2, and beyond that

    regions of A = regions of A without H + regions of the restriction to H.

Witnesses are floats, hence rational numbers. In the end each sign of each witness is compared with
a bound on the rounding error, and the sign vectors are seen to be distinct: then they are regions,
and all of them. Inside several hyperplanes the same holds from the first one on that is no side; in
rank 2 all points are compared before those outside are left out. Where floats do not suffice
(`TooCloseError`), the caller lists all faces instead.
Sums are formed in one order, elementwise, so that witnesses are the same on every machine.

Source: T. Zaslavsky, Facing up to arrangements, Memoirs AMS 154 (1975), for the counts; B. Sleumer,
Output-sensitive cell enumeration in hyperplane arrangements, Nordic J. Comput. 6 (1999), for lists
of regions alone.
Complexity: at most C(m, r - 2) restrictions to rank 2 for m hyperplanes of rank r, and by the
equation above fewer than R regions of all restrictions to one dimension, for R in the end. So
O(m R r^2) numbers, in O(m r) calls of NumPy and more only for portions of a fixed size; memory
O(R (r + m / 64)).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.console.progress import watched
from arrangement.enumeration.reduction import from_dimension, in_dimension
from arrangement.enumeration.sequence import Level, Rows, Signs
from arrangement.numbers import budget, coefficients
from arrangement.numbers.coefficients import SAFE, Integers, as_integers
from arrangement.numbers.exact import IntegerVector, fast_integers, largest, primitive
from arrangement.numbers.float_filter import EXACT, UNIT
from arrangement.numbers.linear.programs import some_point
from arrangement.numbers.packing import (
    Bits,
    Words,
    distinct_rows,
    group_rows,
    pack,
    unit_words,
    unpack,
)
from arrangement.planes.planes import Planes

Floats: TypeAlias = NDArray[np.float64]
Places: TypeAlias = NDArray[np.intp]

#: Images of hyperplanes, or witnesses of regions, that are made at once.
_PORTION = 1 << 14
#: Numbers that are multiplied at once.
_PRODUCTS = 1 << 18
#: Bits of the coordinates that are tried for an integral witness, the shortest first.
_BITS = (3, 6, 12, 24, 52)
#: So many regions are listed before their number is looked at.
_MANY = 10_000
#: What a restriction takes, and a linear program.
RESTRICTION_STEPS = 50
PROGRAM_STEPS = 3000
#: What a region takes for each coordinate and each word of signs.
REGION_STEPS = 8
REGION_BYTES = 48


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

    def take(self, kept: Bits) -> Arrangements:
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

    def take(self, kept: Bits) -> Restrictions:
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


def restrict(above: Arrangements, onto: Places) -> tuple[Arrangements, Restrictions]:
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
    restriction = _arrangements(images[first], sizes, new_sides)
    merged = np.where(sizes < before, before, 0)
    pairs = merged[below] > 0
    member = (label - restriction.starts[below])[pairs]
    maps = Restrictions(onto, pivot, merged, member, turned[pairs])
    empty = np.bincount(below, turned & is_side, minlength=n) > 0
    return restriction.take(~empty), maps.take(~empty)


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
    images = normals[rows[:, None], columns[below]] * np.abs(scale)[below]
    images -= normals[rows, pivot[below]][:, None] * others[below]
    return coefficients.primitive(images[..., None])[..., 0]


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
    places: Places = columns + (columns >= pivot[:, None])
    return places


def _arrangements(normals: Integers, sizes: Places, sides: Places) -> Arrangements:
    largest = np.abs(normals).max(axis=1, keepdims=True)
    size = int(largest.max(initial=0))
    if size > EXACT:
        normals, largest = normals.astype(object), largest.astype(object)
    floats: Floats = (normals / largest).astype(np.float64)
    fits = 2 * size**2 < SAFE
    return Arrangements(normals.astype(np.int64 if fits else object), floats, sizes, sides)


class TooCloseError(ArithmeticError):
    """A witness is so near a hyperplane that floats do not tell its side."""


@dataclass(frozen=True, slots=True)
class HalfRegions:
    """Regions of some arrangements, on the positive side of the first hyperplanes of each.

    Attributes:
        signs: (R, W), bit k is set if the region is on the positive side of hyperplane k.
        points: (R, d), a point of each, with largest entry 1.
        of: (R,), the arrangement of each.
    """

    signs: Words
    points: Floats
    of: Places

    def take(self, rows: Places) -> HalfRegions:
        """Return some of the regions."""
        return HalfRegions(self.signs[rows], self.points[rows], self.of[rows])


def sectors(lines: Arrangements, units: Words) -> HalfRegions:
    """Return the sectors between lines through the origin of R^2, on one side of the first."""
    starts, owner = lines.starts, lines.owners()
    if not len(owner):
        return HalfRegions(units[:0], lines.floats, owner)
    first = starts[owner]
    number = np.arange(len(owner)) - first
    rays = np.stack([-lines.floats[:, 1], lines.floats[:, 0]], axis=1)
    above = np.where(number > 0, dot(rays, lines.floats[first]), 1.0)
    if not above.all():
        raise TooCloseError
    rays *= np.sign(above)[:, None]
    along = np.where(number > 0, dot(rays, rays[first]) / np.abs(above), -np.inf)
    order = np.lexsort((along, owner))
    rays = rays[order] / np.sqrt(dot(rays, rays))[order, None]
    ends = np.append(starts[1:], len(owner)) - 1
    after = np.roll(rays, -1, axis=0)
    after[ends] = rays[starts]
    rays[starts] *= -1
    points = rays + after
    alone = starts[lines.sizes == 1]
    points[alone] = lines.floats[alone]
    # From one sector to the next the sign at the line between them changes.
    changes = units[number[order]]
    on_this_side = np.where((above > 0)[:, None], units[number], np.uint64(0))
    changes[starts] = np.add.reduceat(on_this_side, starts, axis=0)
    signs = np.bitwise_xor.accumulate(changes, axis=0)
    signs[ends[0] + 1 :] ^= np.repeat(signs[ends[:-1]], lines.sizes[1:], axis=0)
    return _keep(HalfRegions(signs, scaled(points), owner), lines, units)


def _keep(halves: HalfRegions, lines: Arrangements, units: Words) -> HalfRegions:
    """Return those of all regions that are on the positive side of the first hyperplanes."""
    several = np.flatnonzero(lines.sides[halves.of] > 1)
    if not len(several):
        return halves
    check(halves.take(several), lines)
    sides = np.cumsum(units, axis=0)[lines.sides - 1][halves.of]
    return halves.take(np.flatnonzero(((halves.signs & sides) == sides).all(axis=1)))


def dot(left: Floats, right: Floats) -> Floats:
    """Return the scalar products along the last axis, summed over it in order."""
    product: Floats = left[..., 0] * right[..., 0]
    for k in range(1, right.shape[-1]):
        product += left[..., k] * right[..., k]
    return product


def scaled(points: Floats) -> Floats:
    """Return the points, each divided by its largest entry."""
    size: Floats = np.abs(points).max(axis=1, keepdims=True)
    if not size.all():
        raise TooCloseError
    unit_points: Floats = points / size
    return unit_points


def margin(d: int) -> float:
    """Return a bound on the error of a scalar product of a point and a normal.

    Their entries are at most 1, those of the normal with an error of one rounding: a sum of d
    products has an error below d (d + 2) roundings.
    """
    return 2 * d * (d + 2) * UNIT


def check(halves: HalfRegions, arrangements: Arrangements) -> None:
    """Compare every sign of every point with a bound on its rounding error."""
    d, m = arrangements.dimension, int(arrangements.sizes.max(initial=1))
    starts, last, least = arrangements.starts, len(arrangements.floats) - 1, margin(d)
    for part in budget.chunks(len(halves.of), max(1, _PRODUCTS // (m * d))):
        of = halves.of[part]
        rows = np.minimum(starts[of, None] + np.arange(m), last)
        products = dot(halves.points[part, None], arrangements.floats[rows])
        sides = unpack(halves.signs[part], m)
        sure = np.where(sides, products > least, products < -least)
        if not (sure | (np.arange(m) >= arrangements.sizes[of, None])).all():
            raise TooCloseError


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
        for part in budget.chunks(len(order), max(1, _PRODUCTS // (len(steps) * d))):
            self._cut(part, cutting.take(order[part]))

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
    order, new = group_rows(rows)
    again = np.flatnonzero(~new)
    place, which = order[again - 1], order[again] - count
    if len(place) != len(rows) - count or (place >= count).any() or (which < 0).any():
        raise TooCloseError
    places = np.empty(len(place), np.intp)
    places[which] = place
    return places


def list_regions(planes: Planes, inside: int = 0) -> Level:
    """Return the regions of rational hyperplanes of rank 3 or more, affine ones of rank 2 or more.

    Args:
        inside: only those on the positive side of the first so many classes of hyperplanes, which
            miss the origin or not; all are then taken as affine.

    Raises:
        TooCloseError: floats do not separate them.
    """
    essential, columns = in_dimension(planes, planes.rank)
    rows = list(essential.distinct_planes)
    if essential.is_central and not inside:
        rows = [row[:-1] for row in rows]
    else:
        infinity = (0,) * planes.rank + (1,)
        rows = [infinity, *((*row[:-1], -row[-1]) for row in rows)]
    whole = arrangement_of(rows, 1 + inside)
    points, there = _first_points(whole)
    regions = _regions(whole.take(there), points[there], unit_words(len(rows)))
    check(regions, whole)
    if len(distinct_rows(regions.signs)) < len(regions.signs):
        raise TooCloseError
    return from_dimension([_as_level(essential, rows, regions)], planes, columns)[-1]


def _regions(above: Arrangements, points: Floats, units: Words) -> HalfRegions:
    """Return the regions of arrangements of rank 3 or more, by those of all their restrictions.

    Args:
        points: one in each, on the positive side of its first hyperplanes.
        units: a bit for each hyperplane.
    """
    levels = []
    while above.dimension > 3:
        kept, first = above.without_normals(), points
        above, points, onto = _all_restricted(above, units)
        levels.append((kept, first, onto))
    regions, onto = _in_planes(above, units)
    levels.append((above.without_normals(), points, onto))
    del above
    while levels:
        kept, first, onto = levels.pop()
        count = len(first) + len(regions.of)
        _check_growth(REGION_STEPS * count, count, kept.dimension + units.shape[1])
        insertion = Insertion(kept, first, onto, regions, units)
        del regions  # which the insertion has copied
        regions = insertion.regions()
    return regions


def _all_restricted(above: Arrangements, units: Words) -> tuple[Arrangements, Floats, Restrictions]:
    """Return the restrictions that have regions, a point in each, and where they come from."""
    parts, points, maps, count = [], [], [], 0
    for onto in watched(portions(above), "portions of restrictions"):
        below, restrictions = restrict(above, onto)
        first, there = _first_points(below)
        parts.append(below.take(there))
        points.append(first[there])
        maps.append(restrictions.take(there))
        count += len(points[-1])
        _check_growth(RESTRICTION_STEPS * len(onto), count, above.dimension + units.shape[1])
    return joined(parts), np.concatenate(points), joined(maps)


def _in_planes(above: Arrangements, units: Words) -> tuple[HalfRegions, Restrictions]:
    """Return the regions of all restrictions to rank 2, and where these come from."""
    parts, maps, arrangements, regions = [], [], 0, 0
    for onto in watched(portions(above), "portions of restrictions"):
        lines, restrictions = restrict(above, onto)
        halves = sectors(lines, units)
        there = np.bincount(halves.of, minlength=len(lines.sizes)) > 0
        of = arrangements + (np.cumsum(there) - 1)[halves.of]
        parts.append(HalfRegions(halves.signs, halves.points, of))
        maps.append(restrictions.take(there))
        arrangements += int(there.sum())
        regions += len(of)
        _check_growth(RESTRICTION_STEPS * len(onto), regions, above.dimension + units.shape[1])
    return joined(parts), joined(maps)


def _check_growth(steps: int, regions: int, of_each: int) -> None:
    """Refuse more regions than the limits allow: those inside are not counted before."""
    budget.spend(steps)
    if regions > _MANY:
        budget.check_cost(
            f"a list of more than {regions:,} regions",
            "give fewer planes, or a smaller polytope",
            faces=regions,
            bytes=REGION_BYTES * of_each * regions,
        )


def _first_points(arrangements: Arrangements) -> tuple[Floats, Bits]:
    """Return a point on the positive side of the first hyperplanes of each, and where one is."""
    starts = arrangements.starts
    points = arrangements.floats[starts]
    there = np.ones(len(starts), np.bool_)
    for k in np.flatnonzero(arrangements.sides > 1).tolist():
        budget.spend(PROGRAM_STEPS)
        sides = slice(starts[k], starts[k] + arrangements.sides[k])
        rows = arrangements.normals[sides].tolist()
        point = some_point(arrangements.dimension, [(*row, -1) for row in rows])
        there[k] = point is not None
        if point is not None:
            points[k] = arrangement_of([primitive(point)], 1).floats[0]
            if (dot(points[k], arrangements.floats[sides]) <= margin(len(points[k]))).any():
                raise TooCloseError
    return points, there


def _as_level(planes: Planes, rows: Sequence[IntegerVector], halves: HalfRegions) -> Level:
    """Return the regions over all input planes; of central ones the opposites, too."""
    infinity = len(rows) - len(planes.distinct)  # 1 or 0 planes
    columns = np.array(planes.class_of, np.intp) + infinity
    orientation = np.array(planes.orientation, np.int8)
    half = len(halves.points)
    count = half if infinity else 2 * half

    def chosen(rows: Rows) -> tuple[NDArray[np.intp], NDArray[np.int8]]:
        place = np.arange(count)[rows]
        return place % half, np.where(place < half, 1, -1).astype(np.int8)[:, None]

    def signs(at: Rows) -> Signs:
        place, side = chosen(at)
        bits = unpack(halves.signs[place], len(rows)).view(np.int8)
        return (2 * bits - 1)[:, columns] * orientation * side

    def points(at: Rows) -> Integers:
        place, side = chosen(at)
        whole = np.concatenate(
            [
                _integral(halves.points[part], rows, unpack(halves.signs[part], len(rows)))
                for part in (place[piece] for piece in budget.chunks(max(1, len(place)), _PORTION))
            ]
        )
        if infinity:
            return whole
        return np.hstack([whole * side, np.ones((len(whole), 1), whole.dtype)])

    return Level(count, signs, points)


def _integral(points: Floats, rows: Sequence[IntegerVector], sides: Bits) -> Integers:
    """Return short integral vectors on the given sides of all hyperplanes."""
    witnesses = np.zeros(points.shape, np.int64)
    left = np.arange(len(points))
    for bits in _BITS:
        rounded = np.rint(points[left] * 2.0**bits).astype(np.int64)
        small = largest(rows) * 2.0**bits * points.shape[1] < 2.0**62
        normals = np.array(rows, np.int64) if small else np.array(fast_integers(rows), object)
        products = (rounded if small else rounded.astype(object)) @ normals.T
        right = ((products > 0) == sides[left]).all(axis=1) & (products != 0).all(axis=1)
        witnesses[left[right]] = rounded[right]
        left = left[~right]
    if not len(left):
        return witnesses
    whole = witnesses.astype(object)
    for i in left.tolist():
        ratios = [x.as_integer_ratio() for x in points[i].tolist()]
        scale = math.lcm(*(q for _, q in ratios))
        whole[i] = [p * (scale // q) for p, q in ratios]
    try:
        return whole.astype(np.int64)
    except OverflowError:
        return whole
