"""Rational points of the sphere, one in each region, and their hull.

Orientation: a triangle (a, b, c) is counter-clockwise seen from outside. A point p lies on its
inner side when ``det[a 1; b 1; c 1; p 1] > 0``.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TypeAlias

import numpy as np

from arrangement.drawing.solids.meshes import triangles
from arrangement.duals.zonohedron import DualPolyhedron
from arrangement.errors import InputError, extra
from arrangement.numbers.exact import IntegerVector, RationalVector, dot
from arrangement.numbers.linear.polyhedron import from_generators
from arrangement.numbers.linear.rank import cycle_edges, plane_through, triple_product


def sphere_points(dual: DualPolyhedron) -> tuple[RationalVector, ...]:
    """Return a rational point of the unit sphere in the region of each vertex of the dual.

    The point is near the middle of the region's rays. It is the stereographic image of a point
    with coordinates that are multiples of 2^-10, 2^-20, ..., until the point lies in the region,
    which is tested by integer signs. Opposite regions get opposite points.

    >>> from arrangement import Arrangement
    >>> from arrangement.duals.zonohedron import dual_polyhedron
    >>> cube = dual_polyhedron(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))
    >>> {sum(x * x for x in point) for point in sphere_points(cube)}
    {Fraction(1, 1)}
    """
    planes = [plane[:3] for plane in dual.arrangement.integer_planes]
    points = []
    for middle, signs in zip(_middles(dual), dual.signs.tolist(), strict=True):
        sides = [tuple(s * x for x in plane) for s, plane in zip(signs, planes, strict=True)]
        points.append(_inside(middle, sides))
    return tuple(points)


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


def _inside(middle: IntegerVector, sides: list[IntegerVector]) -> RationalVector:
    """Return a unit vector near `middle` on the positive side of all the given normals."""
    bits = 10
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
    point = [_round(x << (guard + bits), divisor) for x in vector]
    square = sum(a * a for j, a in enumerate(point) if j != k)
    result = [2 * unit * a for a in point]
    result[k] = (unit * unit - square) * (1 if vector[k] > 0 else -1)
    return (*result, unit * unit + square)


def _round(numerator: int, denominator: int) -> int:
    """Return the nearest integer to a ratio; halves go away from zero."""
    size = (2 * abs(numerator) + denominator) // (2 * denominator)
    return size if numerator >= 0 else -size


Triangle: TypeAlias = tuple[int, int, int]
Edge: TypeAlias = tuple[int, int]


@dataclass(frozen=True, slots=True)
class SphereHull:
    """The hull of points on the unit sphere with the origin inside, triangulated.

    Every point is a vertex, for no point of a sphere lies in the hull of others. So there are
    V vertices, 3V - 6 edges and 2V - 4 triangles. Flat faces are triangulated arbitrarily.

    Attributes:
        points: exact unit vectors.
        triangles: counter-clockwise seen from outside.
        edges: of the triangulation, each as (smaller, larger).
        flat_edges: those whose two triangles lie in one plane: no edges of the hull proper.
    """

    points: tuple[RationalVector, ...]
    triangles: tuple[Triangle, ...]
    edges: frozenset[Edge]
    flat_edges: frozenset[Edge]

    @property
    def true_edges(self) -> frozenset[Edge]:
        """The edges of the hull itself, with flat faces left whole."""
        return self.edges - self.flat_edges


@dataclass(frozen=True)
class RepresentativeHull:
    """The hull of one unit vector for each region, compared with the adjacency of regions.

    Attributes:
        dual: the dual polyhedron; its vertex v and point v belong to the same region.
        hull: the exact hull of the points.
    """

    dual: DualPolyhedron
    hull: SphereHull

    @cached_property
    def adjacencies(self) -> frozenset[Edge]:
        """The pairs of regions that share a facet."""
        return frozenset((min(pair), max(pair)) for pair in self.dual.edges.tolist())

    @cached_property
    def missing(self) -> frozenset[Edge]:
        """The adjacent pairs that are not edges of the hull."""
        return self.adjacencies - self.hull.true_edges


def representative_hull(
    dual: DualPolyhedron, points: Sequence[RationalVector] | None = None
) -> RepresentativeHull:
    """Return the exact hull of one point of the unit sphere for each region.

    Args:
        dual: the dual polyhedron of the arrangement.
        points: for each vertex of the dual an exact unit vector inside its region; if omitted,
            `sphere_points` chooses.

    Raises:
        InputError: a point is not on the unit sphere or not inside its region.

    The origin is always strictly inside: any direction u is a combination of three independent
    normals; a region on the right sides of these three planes has a point p with u . p > 0.
    """
    chosen = sphere_points(dual) if points is None else tuple(map(tuple, points))
    if len(chosen) != len(dual.signs):
        raise InputError(f"there are {len(chosen)} points for {len(dual.signs)} regions")
    for v, (point, signs) in enumerate(zip(chosen, dual.signs.tolist(), strict=True)):
        if dual.arrangement.signs_at(point) != tuple(signs):
            raise InputError(f"points[{v}] is not inside the region of vertex {v}")
    return RepresentativeHull(dual, sphere_hull(chosen))


def sphere_hull(points: Sequence[RationalVector]) -> SphereHull:
    """Return the exact hull of distinct rational points of the unit sphere around the origin.

    Qhull proposes triangles; if they do not pass the exact check, an exact hull takes over. The
    check: every directed edge occurs once, with its reverse; all triangles are positively oriented
    about the origin; a ray meets only one triangle, so that they tile the sphere once; and no edge
    is reentrant. A star-shaped body without reentrant edges is convex.

    Raises:
        InputError: a point off the sphere, two equal points, or the origin is not strictly inside.

    Complexity: O(V log V) for the proposal and O(V) determinants; O(V^3) for the other hull.
    """
    homogeneous = [_homogeneous(i, point) for i, point in enumerate(points)]
    if len(set(homogeneous)) < len(homogeneous):
        raise InputError("two points are equal; give distinct points")
    for propose in (_qhull, _exact):
        faces = propose(homogeneous)
        flat = _flat_edges_if_hull(homogeneous, faces)
        if flat is not None:
            edges = frozenset((min(e), max(e)) for triangle in faces for e in cycle_edges(triangle))
            return SphereHull(tuple(map(tuple, points)), tuple(faces), edges, flat)
    raise InputError("the origin is not strictly inside the hull of the points")


def _homogeneous(i: int, point: RationalVector) -> IntegerVector:
    """Return integers (x, y, z, q), q > 0, with point = (x, y, z) / q."""
    if len(point) != 3 or sum(Fraction(x) ** 2 for x in point) != 1:
        raise InputError(f"points[{i}] is not on the unit sphere of R^3")
    q = math.lcm(*(Fraction(x).denominator for x in point))
    return (*(int(x * q) for x in point), q)


def _flat_edges_if_hull(
    points: list[IntegerVector], triangles: list[Triangle]
) -> frozenset[Edge] | None:
    """Return the flat edges if the triangles are the hull (see `sphere_hull`), else None."""
    opposite: dict[Edge, int] = {}
    for a, b, c in triangles:
        if triple_product(points[a][:3], points[b][:3], points[c][:3]) <= 0:
            return None
        opposite.update({(a, b): c, (b, c): a, (c, a): b})
    if len(triangles) != 2 * len(points) - 4 or len(opposite) != 3 * len(triangles):
        return None
    flat = set()
    for a, b, c in triangles:
        h = plane_through(points[a], points[b], points[c])
        for u, v in cycle_edges((a, b, c)):
            beyond = opposite.get((v, u))
            height = -1 if beyond is None else dot(h, points[beyond])
            if height < 0:
                return None
            if height == 0:
                flat.add((min(u, v), max(u, v)))
    used = {v for triangle in triangles for v in triangle}
    if len(used) < len(points) or not _covers_once(points, triangles):
        return None
    return frozenset(flat)


def _covers_once(points: list[IntegerVector], triangles: list[Triangle]) -> bool:
    """Return whether the ray through the middle of the first triangle meets no other one."""
    directions = [point[:3] for point in points]
    middle = [sum(column) for column in zip(*(directions[v] for v in triangles[0]), strict=True)]
    meets = 0
    for triangle in triangles:
        corners = [directions[v] for v in triangle]
        tests = ([middle if j == k else corners[j] for j in range(3)] for k in range(3))
        meets += all(triple_product(*rows) >= 0 for rows in tests)
    return meets == 1


def _qhull(points: list[IntegerVector]) -> list[Triangle]:
    """Propose the triangles of the hull in floating point, oriented by exact signs."""
    with extra("search"):
        from scipy.spatial import ConvexHull, QhullError

    try:
        simplices = ConvexHull(np.array([[x / p[3] for x in p[:3]] for p in points])).simplices
    except QhullError:
        return []
    return [
        (a, b, c) if triple_product(*(points[v][:3] for v in (a, b, c))) > 0 else (a, c, b)
        for a, b, c in simplices.tolist()
    ]


def _exact(points: list[IntegerVector]) -> list[Triangle]:
    """Return the triangles of the hull by the double description; none if it is flat."""
    hull = from_generators(points, (), 3)
    if hull is None or hull.equalities:
        return []
    place = {point: k for k, point in enumerate(points)}
    number = [place[corner] for corner in hull.homogeneous[0]]
    fans = triangles([tuple(number[j] for j in cycle) for cycle in hull.cycles]).tolist()
    return [(a, b, c) for a, b, c in fans]
