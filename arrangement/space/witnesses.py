"""Points inside regions: floats propose short binary fractions, a bound or integers prove them.

Take points inside several edges of a region. Each plane has them in one closed side, so their mean
is strictly inside that side unless the plane contains them all. If the normals have rank 3, no
plane contains all edges of a region, so the mean over all its edges lies inside it. That mean is
computed in floats and rounded to binary fractions with ever more bits, until all signs are
certain: ``n . x - b`` is a sum of four products with less than 8 roundings for each, so the error
is below the bound of `predicates`. What is still open gets an exact mean over a few edges that no
plane contains all, checked with integers.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from arrangement.errors import ArrangementError
from arrangement.exact import IntegerVector, RationalVector, dot, primitive, sign

from .around import Faces
from .lines import Lines, points_on_lines
from .packing import Bits
from .predicates import ERROR, Floats, Indices, Numbers, PlaneTable, Signs

#: Significant bits of the largest coordinate, in the order they are tried.
PRECISIONS = (8, 14, 24, 50)
#: Points whose signs are certified at once.
BLOCK = 1 << 12


def interior_points(table: PlaneTable, lines: Lines, faces: Faces, regions: Signs) -> Numbers:
    """Return homogeneous integers (X, Y, Z, W), W > 0, of a point inside each region.

    Complexity: O(n^4) float operations in matrix products for n planes.
    """
    centres = _centres(table, lines, faces, len(regions))
    points = np.zeros((len(regions), 4), np.int64)
    open_ = np.arange(len(regions))
    for bits in PRECISIONS:
        if not len(open_):
            break
        rounded = _rounded(centres[open_], bits)
        inside = _certified(table, rounded, regions[open_])
        points[open_[inside]] = rounded[inside]
        open_ = open_[~inside]
    points = _shortened(points)
    if not len(open_):
        return points
    exact = points.astype(object)
    boundary = _Boundary(table, lines, faces)
    for region in open_.tolist():
        exact[region] = boundary.interior_point(region, regions[region])
    return exact


def _centres(table: PlaneTable, lines: Lines, faces: Faces, count: int) -> Floats:
    """Return the mean of the midpoints of the edges of each region, roughly."""
    middle = _edge_parameters(lines)
    points, directions = points_on_lines(table, lines.first, lines.second)
    with np.errstate(invalid="ignore", over="ignore"):
        points = points[lines.line] + middle[:, None] * directions[lines.line]
    region, edge = faces.incident_region, faces.incident_edge
    sums = [np.bincount(region, points[:, m][edge], count) for m in range(3)]
    return np.stack(sums, axis=1) / np.bincount(region, minlength=count)[:, None]


def _edge_parameters(lines: Lines) -> Floats:
    """Return a parameter in the middle of each segment; unbounded ones get the mean length."""
    first = np.append(True, lines.line[1:] != lines.line[:-1])
    upper = lines.parameter
    last = np.append(first[1:], True)
    lower = np.append(np.nan, upper[:-1])
    starts, ends = np.nonzero(first)[0], np.nonzero(last)[0]
    lowest, highest = upper[starts], lower[ends]
    with np.errstate(invalid="ignore", over="ignore"):
        step = (highest - lowest) / (ends - starts)
        step = np.where(step > 0, step, 1.0 + np.abs(lowest))
        middle: Floats = lower / 2 + upper / 2
        middle[starts], middle[ends] = lowest - step, highest + step
    return middle


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


def _certified(table: PlaneTable, points: NDArray[np.int64], regions: Signs) -> Bits:
    """Return which points surely have all signs of their regions."""
    rows = table.floats * np.array([1.0, 1.0, 1.0, -1.0])
    error = max(table.error, ERROR)
    inside = np.empty(len(points), bool)
    for start in range(0, len(points), BLOCK):
        part = slice(start, start + BLOCK)
        x = points[part].astype(np.float64)
        values = (x @ rows.T) * regions[part]
        inside[part] = (values > error * (np.abs(x) @ np.abs(rows.T))).all(axis=1)
    return inside


def _shortened(points: NDArray[np.int64]) -> NDArray[np.int64]:
    """Cancel common powers of two; W is one."""
    joined = np.bitwise_or.reduce(points, axis=1, keepdims=True)
    low = joined & -joined
    return points // np.maximum(low, 1)


class _Boundary:
    """Exact points of the edges of regions."""

    def __init__(self, table: PlaneTable, lines: Lines, faces: Faces) -> None:
        self._table = table
        self._lines = lines
        self._order = np.argsort(faces.incident_region, kind="stable")
        counts = np.bincount(faces.incident_region, minlength=len(faces.regions))
        self._bounds = np.append(0, np.cumsum(counts))
        self._edges: Indices = faces.incident_edge[self._order]

    def interior_point(self, region: int, signs: Signs) -> IntegerVector:
        """Return (X, Y, Z, W): the mean of points inside edges that no class contains all."""
        edges = self._edges[self._bounds[region] : self._bounds[region + 1]]
        chosen: list[RationalVector] = []
        common = np.ones(len(self._table), bool)
        for edge in edges.tolist():
            fewer = common & self._lines.through[self._lines.line[edge]]
            if (fewer != common).any():
                chosen.append(self._inside(edge))
                common = fewer
        mean = primitive([*(sum(column) for column in zip(*chosen, strict=True)), len(chosen)])
        wanted = tuple(signs.tolist())
        if self._signs_at(mean) != wanted:  # pragma: no cover - the argument above would be wrong
            raise ArrangementError(f"no interior point of region {region}; report this input")
        return mean

    def _signs_at(self, point: Sequence[int]) -> tuple[int, ...]:
        x, y, z, w = point
        return tuple(sign(dot(row, (x, y, z, -w))) for row in self._table.exact.tolist())

    def _inside(self, edge: int) -> RationalVector:
        """Return a point inside an edge: its midpoint, or a step away from its only vertex."""
        lines = self._lines
        line = lines.line[edge]
        here = [edge - 1] if edge and lines.line[edge - 1] == line else []
        ends = [self._vertex(e) for e in [*here, edge] if lines.upper[e] >= 0]
        if len(ends) == 2:
            return tuple((a + b) / 2 for a, b in zip(*ends, strict=True))
        direction = self._minors(edge)[:3]
        step = 1 if here else -1
        return tuple(a + step * b for a, b in zip(ends[0], direction, strict=True))

    def _minors(self, edge: int) -> list[int]:
        line = self._lines.line[edge]
        i, j = self._lines.first[[line]], self._lines.second[[line]]
        minors: list[int] = self._table.exact_minors(i, j)[0].tolist()
        return minors

    def _vertex(self, edge: int) -> RationalVector:
        """Return the upper vertex, where row k meets the line: ``(b_k D + n_k x M) / (n_k . D)``.

        For P on the line, ``M = n_i (n_j . P) - n_j (n_i . P) = P x D``, and for the vertex P
        ``n_k x (P x D) = P (n_k . D) - D (n_k . P)``.
        """
        *direction, m0, m1, m2 = self._minors(edge)
        *normal, offset = self._table.exact[self._lines.upper[edge]].tolist()
        n0, n1, n2 = normal
        turned = (n1 * m2 - n2 * m1, n2 * m0 - n0 * m2, n0 * m1 - n1 * m0)
        below = dot(normal, direction)
        return tuple(
            Fraction(offset * d + t, below) for d, t in zip(direction, turned, strict=True)
        )
