"""Points inside regions: floats propose short binary fractions, a bound or integers prove them.

A region lies between two half planes at one of its edges. From a point inside that edge, a ray
between the two enters the region and leaves it at the first plane ahead; the point half way is
inside. Done in floats, that is a proposal. It is rounded to binary fractions with ever more bits,
until all signs are certain: ``n . x - b`` is a sum of four products with less than 8 roundings for
each, so the error is below the bound of `predicates`. What is still open goes to `exactpoints`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from arrangement.float_filter import Floats, certain

from .exact_points import exact_point
from .faces_around_lines import Faces, Wedges
from .lines import Lines, points_on_lines
from .packing import Bits, unpack
from .predicates import ERROR, Numbers, PlaneTable

#: Significant bits of the largest coordinate, in the order they are tried.
_PRECISIONS = (6, 10, 16, 26, 50)
#: Regions handled at once: temporary arrays of so many signs stay in the cache.
BLOCK = 1 << 16


def interior_points(table: PlaneTable, lines: Lines, faces: Faces) -> Numbers:
    """Return homogeneous integers (X, Y, Z, W), W > 0, of a point inside each region.

    Complexity: O(n^4) float operations for n planes, in matrix products.
    """
    count = len(faces.regions)
    points = np.zeros((count, 4), np.int64)
    middle, directions = _middles(table, lines)
    step = max(1, BLOCK // len(table))
    for start in range(0, count, step):
        part = slice(start, start + step)
        signs: Floats = unpack(faces.regions[part], len(table)) * np.float64(2) - 1
        edge = faces.edge[part]
        line = lines.line[edge]
        into = _into(table, directions[line], faces.wedge[part])
        centre = _centres(table, middle[edge], into, lines.through[line])
        points[part] = _short_points(table, centre, signs)
    open_ = np.nonzero(points[:, 3] == 0)[0].tolist()
    if not open_:
        return points
    exact = points.astype(object)
    for region in open_:
        exact[region] = exact_point(table, lines, faces, region)
    return exact


def _middles(table: PlaneTable, lines: Lines) -> tuple[Floats, Floats]:
    """Return, roughly, a point inside each segment, and the direction of each line."""
    first = np.roll(lines.upper < 0, 1)
    upper = lines.parameter
    lower = np.where(first, np.nan, np.roll(upper, 1))
    starts, ends = np.nonzero(first)[0], np.nonzero(lines.upper < 0)[0]
    lowest, highest = upper[starts], lower[ends]
    points, directions = points_on_lines(table, lines.first, lines.second)
    with np.errstate(all="ignore"):
        step = (highest - lowest) / (ends - starts)
        step = np.where(step > 0, step, 1.0 + np.abs(lowest))
        middle = lower / 2 + upper / 2
        middle[starts], middle[ends] = lowest - step, highest + step
        return points[lines.line] + middle[:, None] * directions[lines.line], directions


def _into(table: PlaneTable, directions: Floats, wedge: Wedges) -> Floats:
    """Return, roughly, a vector from the edge into each region, between two half planes."""
    into = np.zeros_like(directions)
    with np.errstate(all="ignore"):
        for half in wedge.T:
            ray = np.cross(table.floats[np.abs(half) - 1, :3], directions)
            ray *= np.sign(half)[:, None]
            into += ray / np.linalg.norm(ray, axis=1, keepdims=True)
    return into


def _centres(table: PlaneTable, points: Floats, into: Floats, through: Bits) -> Floats:
    """Return points roughly half way through regions, from points in their edges.

    With heights above the planes of a region, a plane is met at minus the height over the slope.
    """
    normals, offsets = table.floats[:, :3].T, table.floats[:, 3]
    with np.errstate(all="ignore"):
        meets = (points @ normals - offsets) / (into @ normals)
        meets[through | (meets > 0)] = -np.inf
        ahead = -meets.max(axis=1)
        return points + np.where(np.isinf(ahead), 0.5, ahead / 2)[:, None] * into


def _short_points(table: PlaneTable, centres: Floats, signs: Floats) -> NDArray[np.int64]:
    """Return points with all these signs for sure, as short as found; W = 0 where none is."""
    points = np.zeros((len(centres), 4), np.int64)
    open_ = np.arange(len(centres))
    for bits in _PRECISIONS:
        if not len(open_):
            break
        rounded = _rounded(centres[open_], bits)
        inside = _certified(table, rounded, signs[open_])
        points[open_[inside]] = rounded[inside]
        open_ = open_[~inside]
    joined = np.bitwise_or.reduce(points, axis=1, keepdims=True)
    found: NDArray[np.int64] = points // np.maximum(joined & -joined, 1)
    return found


def _rounded(points: Floats, bits: int) -> NDArray[np.int64]:
    """Return points as integers over a power of two, the largest coordinate with so many bits.

    Points that need too large integers, or are no points, become (0, 0, 0) / 0, on no side of
    any plane.
    """
    largest = np.abs(points).max(axis=1)
    exponent = np.frexp(largest)[1]
    shift = np.maximum(bits - exponent, 0)
    usable = np.isfinite(largest) & (exponent < 60) & (shift < 60)
    result = np.zeros((len(points), 4), np.int64)
    scaled = np.rint(np.ldexp(points[usable], shift[usable, None]))
    result[usable, :3] = scaled.astype(np.int64)
    result[usable, 3] = np.int64(1) << shift[usable].astype(np.int64)
    return result


def _certified(table: PlaneTable, points: NDArray[np.int64], signs: Floats) -> Bits:
    """Return which points surely have all these signs."""
    rows = (table.floats * np.array([1.0, 1.0, 1.0, -1.0])).T
    x = points.astype(np.float64)
    values, sizes = x @ rows, np.abs(x) @ np.abs(rows)
    right = certain(values, sizes, max(table.error, ERROR)) & (values * signs > 0)
    surely: Bits = right.all(axis=1)
    return surely
