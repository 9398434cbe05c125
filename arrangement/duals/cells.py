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
        kept: dict[int, list[tuple[tuple[int, ...], int]]] = {1: [], -1: []}
        edges: dict[int, set[tuple[int, int]]] = {1: set(), -1: set()}
        above = below = False
        for face, wall in zip(*solid, strict=True):
            values = [self.values[i] for i in face]
            low, high = min(values), max(values)
            above, below = above or high > 0, below or low < 0
            if low < 0 < high:
                parts = {side: self._clipped(face, [side * x for x in values]) for side in kept}
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
            return {side: self._closed(kept[side], edges[side]) for side in kept}
        return {1 if above else -1: solid}

    def _closed(
        self, kept: Sequence[tuple[tuple[int, ...], int]], edges: set[tuple[int, int]]
    ) -> _Solid:
        """Return a part, closed by a face in the plane, whose edges are among those there."""
        first, *rest = loop_around(edges)
        faces, walls = zip(*kept, strict=True)
        return (*faces, (first, *reversed(rest))), (*walls, self.label)

    def _clipped(self, face: tuple[int, ...], values: Sequence[int]) -> tuple[int, ...]:
        """Return the part of a face where values are positive."""
        return tuple(map(self._number, clipped([self.points[i] for i in face], values)))

    def _number(self, point: IntegerVector) -> int:
        """Return the number of a point; a new one lies in the plane."""
        if point not in self.index:
            self.index[point] = len(self.points)
            self.points.append(point)
            self.values.append(0)
        return self.index[point]
