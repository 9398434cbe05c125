"""Regions of one arrangement: down to rank 2, and up again."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from arrangement.console.progress import watched
from arrangement.enumeration.reduction import from_dimension, in_dimension
from arrangement.enumeration.sequence import Level, Rows, Signs
from arrangement.numbers import budget
from arrangement.numbers.coefficients import Integers
from arrangement.numbers.exact import IntegerVector, fast_integers, largest, primitive
from arrangement.numbers.linear.programs import some_point
from arrangement.numbers.packing import Bits, Words, chunks, distinct_rows, unit_words, unpack
from arrangement.planes.planes import Planes

from .half_regions import HalfRegions, TooCloseError, check, dot, margin, sectors
from .insertion import Insertion
from .restrictions import (
    Arrangements,
    Floats,
    Restrictions,
    arrangement_of,
    joined,
    portions,
    restricted,
)

#: Bits of the coordinates that are tried for an integral witness, the shortest first.
_BITS = (3, 6, 12, 24, 52)
#: Regions whose witnesses are made at once.
_PORTION = 1 << 14
#: So many regions are listed before their number is looked at.
_MANY = 10_000
#: What a restriction takes, and a linear program.
RESTRICTION_STEPS = 50
PROGRAM_STEPS = 3000
#: What a region takes for each coordinate and each word of signs.
REGION_STEPS = 8
REGION_BYTES = 48


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
    found = _regions(whole.chosen(there), points[there], unit_words(len(rows)))
    check(found, whole)
    if len(distinct_rows(found.signs)) < len(found.signs):
        raise TooCloseError
    return from_dimension([_as_level(essential, rows, found)], planes, columns)[-1]


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
    found, onto = _in_planes(above, units)
    levels.append((above.without_normals(), points, onto))
    del above
    while levels:
        kept, first, onto = levels.pop()
        count = len(first) + len(found.of)
        _check_growth(REGION_STEPS * count, count, kept.dimension + units.shape[1])
        insertion = Insertion(kept, first, onto, found, units)
        del found  # which the insertion has copied
        found = insertion.regions()
    return found


def _all_restricted(above: Arrangements, units: Words) -> tuple[Arrangements, Floats, Restrictions]:
    """Return the restrictions that have regions, a point in each, and where they come from."""
    parts, points, maps, count = [], [], [], 0
    for onto in watched(portions(above), "portions of restrictions"):
        below, restrictions = restricted(above, onto)
        first, there = _first_points(below)
        parts.append(below.chosen(there))
        points.append(first[there])
        maps.append(restrictions.chosen(there))
        count += len(points[-1])
        _check_growth(RESTRICTION_STEPS * len(onto), count, above.dimension + units.shape[1])
    return joined(parts), np.concatenate(points), joined(maps)


def _in_planes(above: Arrangements, units: Words) -> tuple[HalfRegions, Restrictions]:
    """Return the regions of all restrictions to rank 2, and where these come from."""
    parts, maps, arrangements, regions = [], [], 0, 0
    for onto in watched(portions(above), "portions of restrictions"):
        lines, restrictions = restricted(above, onto)
        found = sectors(lines, units)
        there = np.bincount(found.of, minlength=len(lines.sizes)) > 0
        of = arrangements + (np.cumsum(there) - 1)[found.of]
        parts.append(HalfRegions(found.signs, found.points, of))
        maps.append(restrictions.chosen(there))
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


def _as_level(planes: Planes, rows: Sequence[IntegerVector], found: HalfRegions) -> Level:
    """Return the regions over all input planes; of central ones the opposites, too."""
    infinity = len(rows) - len(planes.distinct)  # 1 or 0 planes
    columns = np.array(planes.class_of, np.intp) + infinity
    orientation = np.array(planes.orientation, np.int8)
    half = len(found.points)
    count = half if infinity else 2 * half

    def chosen(rows: Rows) -> tuple[NDArray[np.intp], NDArray[np.int8]]:
        place = np.arange(count)[rows]
        return place % half, np.where(place < half, 1, -1).astype(np.int8)[:, None]

    def signs(at: Rows) -> Signs:
        place, side = chosen(at)
        bits = unpack(found.signs[place], len(rows)).view(np.int8)
        return (2 * bits - 1)[:, columns] * orientation * side

    def points(at: Rows) -> Integers:
        place, side = chosen(at)
        whole = np.concatenate(
            [
                _integral(found.points[part], rows, unpack(found.signs[part], len(rows)))
                for part in (place[piece] for piece in chunks(max(1, len(place)), _PORTION))
            ]
        )
        if infinity:
            return whole
        return np.hstack([whole * side, np.ones((len(whole), 1), whole.dtype)])

    return Level(count, signs, points)


def _integral(points: Floats, rows: Sequence[IntegerVector], sides: Bits) -> Integers:
    """Return short integral vectors on the given sides of all hyperplanes."""
    found = np.zeros(points.shape, np.int64)
    left = np.arange(len(points))
    for bits in _BITS:
        rounded = np.rint(points[left] * 2.0**bits).astype(np.int64)
        small = largest(rows) * 2.0**bits * points.shape[1] < 2.0**62
        normals = np.array(rows, np.int64) if small else np.array(fast_integers(rows), object)
        products = (rounded if small else rounded.astype(object)) @ normals.T
        right = ((products > 0) == sides[left]).all(axis=1) & (products != 0).all(axis=1)
        found[left[right]] = rounded[right]
        left = left[~right]
    if not len(left):
        return found
    whole = found.astype(object)
    for i in left.tolist():
        ratios = [x.as_integer_ratio() for x in points[i].tolist()]
        scale = math.lcm(*(q for _, q in ratios))
        whole[i] = [p * (scale // q) for p, q in ratios]
    try:
        return whole.astype(np.int64)
    except OverflowError:
        return whole
