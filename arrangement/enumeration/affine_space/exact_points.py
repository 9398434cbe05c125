"""Points in faces in integers: vertices, edges, and regions that floats do not resolve.

A point is a row (X, Y, Z, W) of integers, W > 0, and stands for (X, Y, Z) / W.
"""

from __future__ import annotations

from collections.abc import Sequence

from arrangement.errors import ArrangementError
from arrangement.exact import IntegerVector, dot, sign
from arrangement.linear import cross, reduced

from .faces_around_lines import Faces
from .lines import Lines
from .packing import unpack
from .predicates import Indices, PlaneTable

#: The first number of fractional bits that is tried; the next ones are doubled.
_FIRST_BITS = 32


def exact_point(table: PlaneTable, lines: Lines, faces: Faces, region: int) -> IntegerVector:
    """Return a point inside a region, found and checked in integers.

    Half way along a ray from an edge through the region, rounded to the first binary fraction
    that is still inside.
    """
    signs = [1 if bit else -1 for bit in unpack(faces.regions[[region]], len(table))[0].tolist()]
    point = _half_way(table, lines, faces, region, signs)
    if not _has_signs(table, point, signs):  # pragma: no cover - two exact methods would disagree
        raise ArrangementError(f"no interior point of region {region}; report this input")
    bits = _FIRST_BITS
    while bits < point[3].bit_length():
        rounded = _rounded(point, bits)
        if _has_signs(table, rounded, signs):
            return rounded
        bits *= 2
    return point


def _half_way(
    table: PlaneTable, lines: Lines, faces: Faces, region: int, signs: Sequence[int]
) -> IntegerVector:
    """Return the point half way from a point of an edge to the first plane ahead.

    The ray is the sum of the two half planes around the region. Plane k is met at the parameter
    ``height / (W slope)``; the least of these quotients is found by cross multiplication.
    """
    edge = int(faces.edge[region])
    into = _between(table, lines, edge, faces.wedge[region].tolist())
    start = edge_point(table, lines, edge)
    through = lines.through[lines.line[edge]].tolist()
    least: tuple[int, int] | None = None
    for side, row, on in zip(signs, table.exact.tolist(), through, strict=True):
        slope = -side * dot(row[:3], into)
        if slope > 0 and not on:
            height = side * _height(row, start)
            if least is None or height * least[1] < least[0] * slope:
                least = height, slope
    *point, w = start
    height, slope = least or (2 * w, 1)
    moved = (2 * slope * x + height * v for x, v in zip(point, into, strict=True))
    return reduced((*moved, 2 * slope * w))


def _between(table: PlaneTable, lines: Lines, edge: int, wedge: Sequence[int]) -> IntegerVector:
    """Return a vector between two half planes that leave an edge."""
    direction = _line_minors(table, lines, edge)[:3]
    rays = []
    for half in wedge:
        ray = reduced(cross(table.exact[abs(half) - 1, :3].tolist(), direction))
        rays.append(ray if half > 0 else tuple(-x for x in ray))
    return tuple(a + b for a, b in zip(*rays, strict=True))


def _height(row: Sequence[int], point: Sequence[int]) -> int:
    """Return ``W (n . x - b)`` at a point x = (X, Y, Z) / W."""
    a, b, c, offset = row
    x, y, z, w = point
    return a * x + b * y + c * z - offset * w


def _has_signs(table: PlaneTable, point: IntegerVector, signs: Sequence[int]) -> bool:
    return all(
        sign(_height(row, point)) == side
        for row, side in zip(table.exact.tolist(), signs, strict=True)
    )


def _rounded(point: IntegerVector, bits: int) -> IntegerVector:
    """Return the nearest point with so many fractional bits, in lowest terms."""
    *coordinates, w = point
    return reduced([*(((x << bits + 1) // w + 1) >> 1 for x in coordinates), 1 << bits])


def edge_point(table: PlaneTable, lines: Lines, edge: int) -> IntegerVector:
    """Return a point inside an edge: its midpoint, or a step away from its only vertex."""
    below = [edge - 1] if edge and lines.upper[edge - 1] >= 0 else []
    above = [edge] if lines.upper[edge] >= 0 else []
    ends = [vertex_point(table, lines, e) for e in below + above]
    *start, w = ends[0]
    if len(ends) == 2:
        *end, v = ends[1]
        return reduced([*(x * v + y * w for x, y in zip(start, end, strict=True)), 2 * w * v])
    direction = reduced(_line_minors(table, lines, edge)[:3])
    step = w if below else -w
    return (*(x + step * d for x, d in zip(start, direction, strict=True)), w)


def _line_minors(table: PlaneTable, lines: Lines, edge: int) -> list[int]:
    line: Indices = lines.line[[edge]]
    minors: list[int] = table.exact_minors(lines.first[line], lines.second[line])[0].tolist()
    return minors


def vertex_point(table: PlaneTable, lines: Lines, edge: int) -> IntegerVector:
    """Return the upper vertex P, where row k meets the line: ``(b_k D + n_k x M) / (n_k . D)``.

    On the line, ``M = n_i (n_j . P) - n_j (n_i . P) = P x D``; at the vertex
    ``n_k x (P x D) = P (n_k . D) - D b_k``.
    """
    *direction, m0, m1, m2 = _line_minors(table, lines, edge)
    *normal, offset = table.exact[lines.upper[edge]].tolist()
    turned = cross(normal, (m0, m1, m2))
    below = dot(normal, direction)
    point = [offset * d + t for d, t in zip(direction, turned, strict=True)]
    return reduced([*point, below] if below > 0 else [-x for x in (*point, below)])
