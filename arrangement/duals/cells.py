"""The cells of an arrangement inside a body, a ball or a cube: convex solids, cut exactly.

Points are homogeneous integer vectors ``(x, y, z, w)`` with w > 0, for the point ``(x, y, z) / w``.
The ball is a geodesic polyhedron whose corners are rational points of the sphere. A cell is a list
of faces over points that all cells share. Every cell is a closed surface by construction: the cut
faces close what the cut has opened. Nothing is rounded.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import product
from typing import TypeAlias

from arrangement.drawing.solids.flat_polygons import clip_polygon
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
from arrangement.numbers.linear.rank import cross, cycle_edges, loop_around
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


@dataclass(frozen=True)
class Cell:
    """The part of one region inside the body.

    Attributes:
        signs: of the region, over the input planes.
        sides: the same over the classes of coincident planes, for the first plane of each.
        faces: cycles of points, counter-clockwise seen from outside.
        walls: for each face the class of planes that it lies on, or ``-1 - f`` for a part of face
            f of the body.
    """

    signs: tuple[int, ...]
    sides: tuple[int, ...]
    faces: Faces
    walls: tuple[int, ...]


@dataclass(frozen=True)
class Cells:
    """All cells, or chosen ones, of an arrangement inside a body, over one list of points.

    Attributes:
        points: homogeneous integer points ``(x, y, z, w)``, w > 0.
        cells: in the order of `Arrangement.regions`' sign vectors, sorted.
    """

    arrangement: Planes
    body: Body
    points: tuple[IntegerVector, ...]
    cells: tuple[Cell, ...]


def cut_cells(
    arrangement: Planes,
    kind: str = "ball",
    centre: Sequence[object] | None = None,
    radius: object | None = None,
) -> Cells:
    """Cut a body along all planes.

    Args:
        arrangement: in R^3; central or not, of any rank, coincident planes allowed.
        kind: "ball" or "cube".
        centre, radius: of the body; see `body_around`.

    Raises:
        InputError: as `body_around`.

    Complexity: each plane is tried on every cell: O(m (corners + faces of all cells)).
    """
    body = body_around(arrangement, kind, centre, radius)
    knife = _Knife(body.corners)
    walls = tuple(-1 - face for face in range(len(body.faces)))
    solids: list[tuple[tuple[int, ...], _Solid]] = [((), (body.faces, walls))]
    for label, plane in enumerate(arrangement.distinct_planes):
        knife.take(label, (*plane[:3], -plane[3]))
        solids = [
            ((*sides, side), part)
            for sides, solid in solids
            for side, part in knife.halves(solid).items()
        ]
    cells = tuple(
        sorted(
            (Cell(arrangement.over_planes(sides), sides, *solid) for sides, solid in solids),
            key=lambda cell: cell.signs,
        )
    )
    return Cells(arrangement, body, tuple(knife.points), cells)


def read_signs(arrangement: Planes, text: str) -> tuple[int, ...]:
    """Read the sign vector of a region from a text such as ``"+-+"``.

    Raises:
        InputError: other characters, another length, or no such region.
    """
    symbols = {"+": 1, "-": -1, "−": -1}
    if not isinstance(text, str) or not set(text) <= set(symbols):
        raise InputError(f"the cell is {shown(text)}; write one + or - for each plane, as in +-+")
    signs = tuple(symbols[c] for c in text)
    if len(signs) != len(arrangement):
        raise InputError(
            f"the cell {shown(text)} has {len(signs)} signs and there are {len(arrangement)} planes"
        )
    regions = enumerate_faces(arrangement).of_dimension(arrangement.dimension)
    if not (regions.signs == signs).all(axis=1).any():
        raise InputError(
            f"no region has the signs {shown(text)}; `arrangement faces FILE --dimension 3` "
            "lists them"
        )
    return signs


#: faces and walls, as in `Cell`
_Solid: TypeAlias = tuple[Faces, tuple[int, ...]]


class _Knife:
    """Cuts convex solids by one plane after the other; new points are shared by all."""

    def __init__(self, corners: Sequence[IntegerVector]) -> None:
        self.points = list(corners)
        self.index = {point: i for i, point in enumerate(self.points)}
        self.label = -1
        self.values: list[int] = []

    def take(self, label: int, plane: IntegerVector) -> None:
        """Set the plane that cuts, ``(a, b, c, d)`` for ``a x + b y + c z + d w = 0``."""
        a, b, c, d = plane
        self.label = label
        self.values = [a * x + b * y + c * z + d * w for x, y, z, w in self.points]

    def halves(self, solid: _Solid) -> Mapping[int, _Solid]:
        """Return the parts of a solid on the sides +1 and -1, as far as they have a volume."""
        kept: dict[int, list[tuple[tuple[int, ...], int]]] = {1: [], -1: []}
        edges: dict[int, set[tuple[int, int]]] = {1: set(), -1: set()}
        above = below = False
        for face, wall in zip(*solid, strict=True):
            values = [self.values[i] for i in face]
            low, high = min(values), max(values)
            above, below = above or high > 0, below or low < 0
            if low < 0 < high:
                parts = {side: self._clip(face, [side * x for x in values]) for side in kept}
            else:
                parts = {1 if low >= 0 else -1: face}
            for side, part in parts.items():
                kept[side].append((part, wall))
                if len(parts) == 2 or values.count(0) > 1:
                    edges[side].update(
                        (i, j)
                        for i, j in cycle_edges(part)
                        if not (self.values[i] or self.values[j])
                    )
        if above and below:
            return {side: self._close(kept[side], edges[side]) for side in kept}
        return {1 if above else -1: solid}

    def _close(
        self, kept: Sequence[tuple[tuple[int, ...], int]], edges: set[tuple[int, int]]
    ) -> _Solid:
        """Return a part, closed by a face in the plane, whose edges are among those there."""
        first, *rest = loop_around(edges)
        faces, walls = zip(*kept, strict=True)
        return (*faces, (first, *reversed(rest))), (*walls, self.label)

    def _clip(self, face: tuple[int, ...], values: Sequence[int]) -> tuple[int, ...]:
        """Return the part of a face where values are positive."""
        return tuple(map(self._number, clip_polygon([self.points[i] for i in face], values)))

    def _number(self, point: IntegerVector) -> int:
        """Return the number of a point; a new one lies in the plane."""
        if point not in self.index:
            self.index[point] = len(self.points)
            self.points.append(point)
            self.values.append(0)
        return self.index[point]
