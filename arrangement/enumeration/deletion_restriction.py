"""Regions alone, by deletion and restriction: no face of lower dimension is listed.

Hyperplanes are added one by one. A new one, H, cuts exactly those regions of the others that have a
region of the restriction to H in their closure, and these have the same signs at the others. So the
regions of the restriction, listed first in the same way, say which regions are cut in two, and
every other region is on one side of H. Of a central arrangement only the half on the positive
side of the first hyperplane is listed; of an affine one that is all, if infinity comes first. So
may the regions be listed that are on the positive side of several hyperplanes, the first ones: a
linear program has a point there or none, in each restriction.

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
Complexity: at most C(m, r - 2) restrictions to rank 2 for m hyperplanes of rank r; in all O(m R r)
numbers for R regions, and memory O(R (r + m / 64)).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.console.progress import watched
from arrangement.numbers import budget
from arrangement.numbers.coefficients import Integers
from arrangement.numbers.exact import (
    IntegerVector,
    fast_integers,
    largest,
    one_way,
    primitive,
    reduced,
)
from arrangement.numbers.linear.programs import some_point
from arrangement.numbers.packing import Bits, Words, chunks, distinct_rows, grouped, pack, unpack
from arrangement.planes.planes import Planes

from .reduction import from_dimension, in_dimension
from .sequence import Level, Rows, Signs

Floats: TypeAlias = NDArray[np.float64]

#: Half the distance from 1 to the next float.
_ROUNDING = 2.0**-53
#: Bits of the coordinates that are tried for an integral witness, the shortest first.
_BITS = (3, 6, 12, 24, 52)
#: Points whose signs are compared at once.
_PORTION = 1 << 16
#: So many regions are listed before their number is looked at.
_MANY = 10_000
#: What a restriction takes.
RESTRICTION_STEPS = 1300


class TooCloseError(ArithmeticError):
    """A witness is so near a hyperplane that floats do not tell its side."""


@dataclass(frozen=True, slots=True)
class _HalfRegions:
    """Regions on the positive side of the first hyperplane.

    Attributes:
        signs: (R, W); bit k is set if the region is on the positive side of hyperplane k.
        points: (R, r); a point of each, with largest entry 1.
    """

    signs: Words
    points: Floats


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
    floats = _as_floats(rows)
    numbers = watched(range(1 + inside, len(rows)), "hyperplanes")
    found = _by_insertion(rows, floats, numbers, 1 + inside)
    _check(found, floats)
    if len(distinct_rows(found.signs)) < len(found.signs):
        raise TooCloseError
    return from_dimension([_as_level(essential, rows, found)], planes, columns)[-1]


def _regions(rows: Sequence[IntegerVector], inside: int) -> _HalfRegions:
    """Return the regions of distinct central hyperplanes, by recursion on the dimension.

    Only those on the positive side of the first `inside` of them.
    """
    floats = _as_floats(rows)
    if len(rows) == 1:
        return _HalfRegions(np.ones((1, 1), np.uint64), floats)
    if len(rows[0]) == 2:
        return _kept(_in_the_plane(floats), floats, inside)  # distinct: in order around the origin
    return _by_insertion(rows, floats, range(inside, len(rows)), inside)


def _by_insertion(
    rows: Sequence[IntegerVector], floats: Floats, numbers: Iterable[int], inside: int
) -> _HalfRegions:
    """Add the hyperplanes one by one; each cuts the regions that its restriction names."""
    m = len(rows)
    bits = pack(np.eye(m, dtype=np.bool_))
    signs, points = bits[:inside].sum(axis=0, keepdims=True), _first_point(rows, floats, inside)
    signs = signs[: len(points)]
    for j in numbers:
        if inside > 1:
            _check_growth(signs, points)
        if not len(signs):
            break
        normal = floats[j]
        pivot = int(np.abs(normal).argmax())
        below, class_of, flipped, sides = _restriction(rows[:j], rows[j], pivot, inside)
        if not sides:
            cut_signs, on_both_sides = signs[:0], points[:0]
        else:
            found = _regions(below, sides)
            cut_signs = pack(unpack(found.signs, len(below))[:, class_of] ^ flipped, m)
            on_both_sides = _moved(_lifted(found.points, normal, pivot), normal, floats[:j])
        cut = np.zeros(len(signs), np.bool_)
        cut[_places(cut_signs, signs)] = True
        whole_points, whole_signs = points[~cut], signs[~cut]
        whole_signs[_products(whole_points, normal[None])[:, 0] > 0] |= bits[j]
        signs = np.concatenate([whole_signs, cut_signs, cut_signs | bits[j]])
        points = np.concatenate([whole_points, on_both_sides])
    return _HalfRegions(signs, points)


def _first_point(rows: Sequence[IntegerVector], floats: Floats, inside: int) -> Floats:
    """Return a point on the positive side of the first hyperplanes, or none."""
    if inside == 1:
        return floats[:1]
    point = some_point(len(rows[0]), [(*row, -1) for row in rows[:inside]])
    if point is None:
        return floats[:0]
    found = _as_floats([primitive(point)])
    _check(_HalfRegions(pack(np.ones((1, inside), np.bool_)), found), floats[:inside])
    return found


def _kept(found: _HalfRegions, floats: Floats, inside: int) -> _HalfRegions:
    """Return those of all regions that are on the positive side of the first hyperplanes."""
    if inside == 1:
        return found
    _check(found, floats)
    kept = unpack(found.signs, len(floats))[:, :inside].all(axis=1)
    return _HalfRegions(found.signs[kept], found.points[kept])


def _check_growth(signs: Words, points: Floats) -> None:
    """Refuse more regions inside than the limits allow: their number is not known before."""
    budget.spend(RESTRICTION_STEPS + len(signs))
    if len(signs) > _MANY:
        budget.check_cost(
            f"a list of more than {len(signs):,} regions inside planes",
            "give a smaller polytope",
            faces=len(signs),
            bytes=2 * (signs.nbytes + points.nbytes),
        )


def _in_the_plane(floats: Floats) -> _HalfRegions:
    """Return the sectors between lines through the origin of R^2, on one side of the first."""
    first = np.array([-floats[0, 1], floats[0, 0]])
    rays = np.stack([-floats[1:, 1], floats[1:, 0]], axis=1)
    above = _products(rays, floats[:1])[:, 0]
    if not above.all():
        raise TooCloseError
    rays *= np.sign(above)[:, None]
    order = np.argsort(_products(rays, first[None])[:, 0] / np.abs(above), kind="stable")
    rays = np.concatenate([-first[None], rays[order], first[None]])
    rays /= np.sqrt(rays[:, :1] ** 2 + rays[:, 1:] ** 2)
    points = _scaled(rays[:-1] + rays[1:])
    return _HalfRegions(pack(_products(points, floats) > 0), points)


def _restriction(
    rows: Sequence[IntegerVector], normal: IntegerVector, pivot: int, inside: int
) -> tuple[list[IntegerVector], list[int], Bits, int]:
    """Restrict hyperplanes to another one, whose coordinate `pivot` is eliminated.

    Returns:
        The distinct restrictions, the first oriented as the first hyperplanes, of which regions are
        on the positive side; for each hyperplane which one it is, and whether it has the other
        orientation; how many the first are, 0 if two of them leave nothing between them.
    """
    scale = abs(normal[pivot])
    others = [x if normal[pivot] > 0 else -x for q, x in enumerate(normal) if q != pivot]
    found: dict[IntegerVector, int] = {}
    class_of, flipped = [], []
    for row in rows:
        rest = (x for q, x in enumerate(row) if q != pivot)
        image = reduced([x * scale - row[pivot] * y for x, y in zip(rest, others, strict=True)])
        oriented = one_way(image)
        class_of.append(found.setdefault(oriented, len(found)))
        flipped.append(oriented != image)
    below = list(found)
    sides = dict(zip(class_of[:inside], flipped[:inside], strict=True))
    for k in (k for k, turned in sides.items() if turned):
        below[k] = tuple(-x for x in below[k])
    turned = np.array(flipped) ^ np.array([sides.get(k, False) for k in class_of])
    return below, class_of, turned, 0 if turned[:inside].any() else len(sides)


def _places(wanted: Words, signs: Words) -> NDArray[np.intp]:
    """Return where the wanted rows, all distinct, are among the others."""
    if not len(wanted):
        return np.zeros(0, np.intp)
    order, new = grouped(np.concatenate([signs, wanted]))
    places = order[np.flatnonzero(~new) - 1]
    if len(places) != len(wanted) or (places >= len(signs)).any():
        raise TooCloseError
    return places


def _lifted(points: Floats, normal: Floats, pivot: int) -> Floats:
    """Return the points of a hyperplane from their other coordinates."""
    others = np.arange(len(normal)) != pivot
    found = np.empty((len(points), len(normal)))
    found[:, others] = points
    found[:, pivot] = -_products(points, normal[None, others])[:, 0] / normal[pivot]
    return found


def _moved(points: Floats, normal: Floats, others: Floats) -> Floats:
    """Move points of a hyperplane off it to either side, half the way to another one at most."""
    speed = np.maximum(np.abs(_products(normal[None], others)), 1e-300)
    room = (np.abs(_products(points, others)) / speed).min(axis=1)
    step = np.minimum(room / 2, 1.0)[:, None] * normal
    return _scaled(np.concatenate([points - step, points + step]))


def _products(points: Floats, rows: Floats) -> Floats:
    """Return the scalar products (P, R), summed over the coordinates in order."""
    found = points[:, :1] * rows[:, 0]
    for k in range(1, rows.shape[1]):
        found += points[:, k : k + 1] * rows[:, k]
    return found


def _scaled(points: Floats) -> Floats:
    size: Floats = np.abs(points).max(axis=1, keepdims=True)
    if not size.all():
        raise TooCloseError
    scaled: Floats = points / size
    return scaled


def _as_floats(rows: Sequence[IntegerVector]) -> Floats:
    """Return the normals, each divided by its largest entry: correctly rounded quotients."""
    sizes = [max(map(abs, row)) for row in rows]
    return np.array([[x / size for x in row] for row, size in zip(rows, sizes, strict=True)])


def _check(found: _HalfRegions, floats: Floats) -> None:
    """Compare every sign of every point with a bound on its rounding error.

    Entries of points and of normals are at most 1, the latter with an error of one rounding: a sum
    of d products has an error below d (d + 2) roundings.
    """
    m, d = floats.shape
    bound = 2 * d * (d + 2) * _ROUNDING
    for part in chunks(len(found.points), _PORTION):
        products = _products(found.points[part], floats)
        sides = unpack(found.signs[part], m)
        if not ((products > bound) == sides).all() or not ((products < -bound) != sides).all():
            raise TooCloseError


def _as_level(planes: Planes, rows: Sequence[IntegerVector], found: _HalfRegions) -> Level:
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
        sides = unpack(found.signs[place], len(rows))
        whole = _integral(found.points[place], rows, sides)
        if infinity:
            return whole
        return np.hstack([whole * side, np.ones((len(whole), 1), whole.dtype)])

    return Level(count, signs, points)


def _integral(points: Floats, rows: Sequence[IntegerVector], sides: Bits) -> Integers:
    """Return short integral vectors on the given sides of all hyperplanes."""
    found = np.zeros(points.shape, object)
    left = np.arange(len(points))
    for bits in _BITS:
        rounded = np.rint(points[left] * 2.0**bits).astype(np.int64)
        small = largest(rows) * 2.0**bits * points.shape[1] < 2.0**62
        normals = np.array(rows, np.int64) if small else np.array(fast_integers(rows), object)
        products = (rounded if small else rounded.astype(object)) @ normals.T
        right = ((products > 0) == sides[left]).all(axis=1) & (products != 0).all(axis=1)
        found[left[right]] = rounded[right]
        left = left[~right]
    for i in left.tolist():
        ratios = [x.as_integer_ratio() for x in points[i].tolist()]
        scale = math.lcm(*(q for _, q in ratios))
        found[i] = [p * (scale // q) for p, q in ratios]
    try:
        return found.astype(np.int64)
    except OverflowError:
        return found
