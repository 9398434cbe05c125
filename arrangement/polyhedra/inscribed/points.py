"""Exactly rational points of the unit sphere, one inside each region."""

from __future__ import annotations

import math
from fractions import Fraction

from arrangement.exact import IntegerVector, RationalVector, dot
from arrangement.polyhedra.dual import DualPolyhedron


def sphere_points(dual: DualPolyhedron, bits: int = 10) -> tuple[RationalVector, ...]:
    """Return a rational point of the unit sphere in the region of each vertex of the dual.

    The point is near the middle of the region's rays. It is the stereographic image of a point
    with coordinates that are multiples of 2^-bits; `bits` is doubled until the point lies in the
    region, which is tested by integer signs. Opposite regions get opposite points.

    >>> from arrangement import Arrangement, dual_polyhedron
    >>> cube = dual_polyhedron(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))
    >>> {sum(x * x for x in point) for point in sphere_points(cube)}
    {Fraction(1, 1)}
    """
    planes = [plane[:3] for plane in dual.arrangement.integer_planes]
    found = []
    for middle, signs in zip(_middles(dual), dual.signs.tolist(), strict=True):
        sides = [tuple(s * x for x in plane) for s, plane in zip(signs, planes, strict=True)]
        found.append(_inside(middle, sides, bits))
    return tuple(found)


def _middles(dual: DualPolyhedron) -> list[IntegerVector]:
    """Return for each region a positive combination of its rays, of about equal lengths."""
    lengths = [math.isqrt(dot(ray, ray)) + 1 for ray in dual.face_normals]
    scale = 16 * max(lengths)
    sums = [[0, 0, 0] for _ in dual.integer_vertices]
    for ray, length, cycle in zip(dual.face_normals, lengths, dual.faces, strict=True):
        factor = scale // length
        for vertex in cycle:
            total = sums[vertex]
            for k in range(3):
                total[k] += factor * ray[k]
    return [tuple(total) for total in sums]


def _inside(middle: IntegerVector, sides: list[IntegerVector], bits: int) -> RationalVector:
    """Return a unit vector near `middle` on the positive side of all the given normals."""
    while True:
        *numerators, denominator = rational_direction(middle, bits)
        if all(dot(side, numerators) > 0 for side in sides):
            return tuple(Fraction(x, denominator) for x in numerators)
        bits *= 2


def rational_direction(vector: IntegerVector, bits: int) -> IntegerVector:
    """Return integers (x, y, z, q) with x^2 + y^2 + z^2 = q^2, near the direction of a vector.

    The vector v is projected from the pole of its largest coordinate v_k, the far one:
    ``a_j = v_j / (|v| + |v_k|)``, rounded to multiples of 2^-bits, then back to the sphere by
    ``(2 a, 1 - |a|^2) / (1 + |a|^2)``. Integers only; ``v`` and ``-v`` give opposite points.
    """
    k = max(range(3), key=lambda j: abs(vector[j]))
    guard = bits + 4
    length = math.isqrt(dot(vector, vector) << 2 * guard)
    divisor = length + (abs(vector[k]) << guard)
    unit = 1 << bits
    point = [_rounded(x << (guard + bits), divisor) for x in vector]
    square = sum(a * a for j, a in enumerate(point) if j != k)
    result = [2 * unit * a for a in point]
    result[k] = (unit * unit - square) * (1 if vector[k] > 0 else -1)
    return (*result, unit * unit + square)


def _rounded(numerator: int, denominator: int) -> int:
    """Return the nearest integer to a ratio; halves go away from zero."""
    size = (2 * abs(numerator) + denominator) // (2 * denominator)
    return size if numerator >= 0 else -size
