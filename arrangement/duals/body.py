"""The body inside which planes of R^3 are shown: a ball or a cube, exactly.

Points are homogeneous integer vectors ``(x, y, z, w)`` with w > 0, for the point ``(x, y, z) / w``.
The ball is a geodesic polyhedron whose corners are rational points of the sphere.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import product

from arrangement.enumeration.choose import enumerate_faces
from arrangement.errors import InputError, extra, refusal
from arrangement.numbers import budget
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    dot,
    primitive,
    rational,
    rational_vector,
    reduced,
    shown,
)
from arrangement.numbers.linear.rank import cross
from arrangement.numbers.real import rational_near
from arrangement.planes.planes import Planes

#: So often the faces of the icosahedron are cut in four; the ball has 10 4^n + 2 corners.
_SUBDIVISIONS = 4

Faces = tuple[tuple[int, ...], ...]


@dataclass(frozen=True)
class Body:
    """A ball or a cube.

    Attributes:
        kind: "ball" or "cube".
        centre: exact.
        radius: of the ball; half the edge of the cube. Exact.
        corners: homogeneous points.
        faces: cycles of corners, counter-clockwise seen from outside.
    """

    kind: str
    centre: RationalVector
    radius: Fraction
    corners: tuple[IntegerVector, ...]
    faces: Faces


def body_around(
    arrangement: Planes,
    kind: str = "ball",
    centre: Sequence[object] | None = None,
    radius: object | None = None,
) -> Body:
    """Return the body in which planes of R^3 are shown.

    Left to itself, every face of the arrangement meets it. For central planes it is the unit
    ball, or the cube ``[-1, 1]^3``. For other planes its centre is that of the bounding box of
    all vertices, and its radius 4/3 of the distance to the farthest one; where there are no
    vertices, the lines (or planes) of the lowest dimension stand for them, each by its point in
    the span of the normals.

    Args:
        arrangement: in R^3.
        kind: "ball" or "cube".
        centre: exact, instead of the above.
        radius: exact, of the ball, or half the edge of the cube, instead of the above. In a
            smaller body, what is far off is left out.

    Raises:
        InputError: another space, too many planes, an unknown kind, a radius that is not positive.
    """
    if kind not in _SOLIDS:
        raise refusal(f"the body is {shown(kind)}", kind, _SOLIDS)
    if arrangement.dimension != 3:
        raise InputError(
            f"the planes lie in R^{arrangement.dimension}; a ball or cube can show those of R^3"
        )
    budget.check_size(len(arrangement.distinct), "planes in a body")
    middle, reach = _extent(arrangement)
    if centre is not None:
        middle = rational_vector(centre, "centre")
        if len(middle) != 3:
            raise InputError(f"the centre has {len(middle)} coordinates; give three")
    if radius is not None:
        reach = rational(radius, "radius")
        if reach <= 0:
            raise InputError(f"the radius is {shown(radius)}; give a positive number")
    units, faces = _SOLIDS[kind]()
    scale = math.lcm(*(x.denominator for x in (*middle, reach)))
    *origin, length = (int(x * scale) for x in (*middle, reach))
    corners = tuple(
        reduced([*(c * w + length * x for c, x in zip(origin, unit, strict=True)), scale * w])
        for *unit, w in units
    )
    return Body(kind, middle, reach, corners, faces)


def _extent(arrangement: Planes) -> tuple[RationalVector, Fraction]:
    """Return the centre and the radius of a body that every face meets."""
    origin = (Fraction(0),) * 3
    if arrangement.is_central:
        return origin, Fraction(1)
    lowest = enumerate_faces(arrangement).of_dimension(3 - arrangement.rank)
    # Irrational ones are rounded: the body has room.
    points = [tuple(map(rational_near, _in_span(arrangement, face.witness))) for face in lowest]
    columns = list(zip(*points, strict=True))
    centre = tuple((min(column) + max(column)) / 2 for column in columns)
    squares = (sum((x - c) ** 2 for x, c in zip(p, centre, strict=True)) for p in points)
    farthest = max(squares)
    if not farthest:
        return centre, Fraction(1)
    p, q = farthest.numerator, farthest.denominator
    return centre, Fraction(4, 3) * Fraction(math.isqrt(p * q << 32) + 1, q << 16)


def _in_span(arrangement: Planes, point: RationalVector) -> RationalVector:
    """Return the point of the span of the normals that lies on the same planes as `point`."""
    if arrangement.rank == 3:
        return point
    normals = [plane[:3] for plane in arrangement.integer_planes]
    if arrangement.rank == 1:
        return _projection(point, normals[0])
    along = next(c for c in (cross(normals[0], n) for n in normals) if any(c))
    return tuple(x - y for x, y in zip(point, _projection(point, along), strict=True))


def _projection(point: RationalVector, line: IntegerVector) -> RationalVector:
    factor = Fraction(dot(point, line)) / dot(line, line)
    return tuple(factor * x for x in line)


@lru_cache(maxsize=1)
def _cube() -> tuple[tuple[IntegerVector, ...], Faces]:
    """Return the cube ``[-1, 1]^3``; corner 4 i + 2 j + k has the signs i, j, k."""
    corners = tuple((x, y, z, 1) for x, y, z in product((-1, 1), repeat=3))
    faces = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return corners, faces


@lru_cache(maxsize=1)
def _ball() -> tuple[tuple[IntegerVector, ...], Faces]:
    """Return a geodesic polyhedron whose corners lie on the unit sphere exactly.

    It is turned out of every symmetric position, so that planes with small integers do not pass
    close to its corners.
    """
    with extra("mesh"):
        from scipy.spatial.transform import Rotation
        from trimesh.creation import icosphere

    ball = icosphere(subdivisions=_SUBDIVISIONS)
    points = Rotation.from_euler("ZXZ", (0.3719, 0.5923, 0.2281)).inv().apply(ball.vertices)
    return tuple(_on_sphere(*p) for p in points.tolist()), tuple(map(tuple, ball.faces.tolist()))


def _on_sphere(x: float, y: float, z: float) -> IntegerVector:
    """Return a rational point of the sphere near a float one, by stereographic projection."""
    far = -1 if z > 0 else 1
    scale = 1 << 12
    p, q = round(scale * x / (1 - far * z)), round(scale * y / (1 - far * z))
    square = p * p + q * q
    one = scale * scale
    return primitive(
        [Fraction(v) for v in (2 * p * scale, 2 * q * scale, far * (square - one), square + one)]
    )


_SOLIDS = {"ball": _ball, "cube": _cube}
