"""The cells of an arrangement inside a body, a ball or a cube: convex solids, cut exactly.

A cell is a list of faces over points that all cells share; its points are those of `body`.
Every cell is a closed surface by construction: the cut faces close what the cut has opened. Nothing
is rounded.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from arrangement.drawing.solids.flat_polygons import clipped
from arrangement.enumeration.choose import enumerate_faces
from arrangement.errors import InputError
from arrangement.numbers.exact import (
    IntegerVector,
    shown,
)
from arrangement.numbers.linear.rank import cycle_edges, loop_around
from arrangement.planes.planes import Planes

from .body import Body, Faces, body_around


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
        """Take the next plane, ``(a, b, c, d)`` for ``a x + b y + c z + d w = 0``."""
        a, b, c, d = plane
        self.label = label
        self.values = [a * x + b * y + c * z + d * w for x, y, z, w in self.points]

    def halves(self, solid: _Solid) -> Mapping[int, _Solid]:
        """Return the parts of a solid on the sides +1 and -1, as far as they have a volume."""
        faces, _ = solid
        corners = {i for face in faces for i in face}
        above = any(self.values[i] > 0 for i in corners)
        below = any(self.values[i] < 0 for i in corners)
        if above and below:
            return {1: self._half(solid, 1), -1: self._half(solid, -1)}
        return {1 if above else -1: solid}

    def _half(self, solid: _Solid, side: int) -> _Solid:
        """Return the part on one side, closed by a face in the plane."""
        faces, walls = [], []
        for face, wall in zip(*solid, strict=True):
            kept = self._clipped(face, side)
            if len(kept) > 2:
                faces.append(kept)
                walls.append(wall)
        edges = {
            edge
            for face in faces
            if sum(not self.values[i] for i in face) > 1
            for edge in cycle_edges(face)
            if not (self.values[edge[0]] or self.values[edge[1]])
        }
        first, *rest = loop_around(edges)
        return (*faces, (first, *reversed(rest))), (*walls, self.label)

    def _clipped(self, face: tuple[int, ...], side: int) -> tuple[int, ...]:
        """Return the part of a face on one side, which may be less than a polygon."""
        values = [side * self.values[i] for i in face]
        if min(values) >= 0:
            return face
        if max(values) <= 0:
            return ()
        return tuple(map(self._number, clipped([self.points[i] for i in face], values)))

    def _number(self, point: IntegerVector) -> int:
        """Return the number of a point; a new one lies in the plane."""
        if point not in self.index:
            self.index[point] = len(self.points)
            self.points.append(point)
            self.values.append(0)
        return self.index[point]
