"""The order in which the pieces of an arrangement are painted, so that nothing hides wrongly.

Every piece (facet, segment of an edge of the body, cell) has one sign on each plane. Let k be the
first plane on which two pieces differ. Plane k separates them, and the viewer is on one side of
it. So the piece on the far side, or on the plane when the other is on the near side, cannot hide
the other. Hence the dictionary order of the sign vectors, far side first, is an order from back
to front. It is exact and needs no depths. A plane that is seen edge-on separates the picture
itself by a line, and does not count.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.sight import picture_axes
from arrangement.duals.cells import Cell, Cells
from arrangement.numbers.exact import IntegerVector, dot, sign
from arrangement.numbers.linear.rank import cycle_edges
from arrangement.planes.planes import Planes

Key = tuple[int, ...]


@dataclass(frozen=True)
class Facet:
    """A facet of the arrangement, cut off at the surface of the body.

    Attributes:
        label: the class of planes that it lies on.
        sides: its sign on the first plane of every class; 0 for `label`.
        corners: points of the cells, in cyclic order.
        rim: for each edge (corner to next corner) whether it lies on the surface of the body.
    """

    label: int
    sides: tuple[int, ...]
    corners: tuple[int, ...]
    rim: tuple[bool, ...]


class Stage:
    """The cells of an arrangement in the axes of a picture: right, up, towards the viewer.

    Attributes:
        cells: exact.
        direction: towards the viewer.
        axes: (3, 3); the unit vectors of the picture.
        points: (P, 3); the points of `cells`; the body has its centre at 0 and radius 1.
    """

    def __init__(self, cells: Cells, direction: IntegerVector) -> None:
        self.cells = cells
        self.direction = direction
        self.axes = picture_axes(direction)
        self.points = unit_points(cells) @ self.axes.T

    @property
    def arrangement(self) -> Planes:
        """The arrangement."""
        return self.cells.arrangement

    @cached_property
    def viewer(self) -> tuple[int, ...]:
        """For each class of planes the side, of its first plane, on which the viewer is."""
        return tuple(
            sign(dot(self.arrangement.integer_planes[members[0]][:3], self.direction))
            for members in self.arrangement.distinct
        )

    def key(self, sides: Sequence[int]) -> Key:
        """Return what pieces are sorted by, back to front."""
        return tuple(v * s for v, s in zip(self.viewer, sides, strict=True))

    @cached_property
    def facets(self) -> tuple[Facet, ...]:
        """All facets, back to front."""
        found = [facet for cell in self.cells.cells for facet in _facets_below(cell)]
        return tuple(sorted(found, key=lambda facet: (self.key(facet.sides), facet.label)))

    @cached_property
    def planes(self) -> tuple[tuple[Floats, float], ...]:
        """For each class the unit normal and offset of its first plane, in the picture."""
        body = self.cells.body
        found = []
        for members in self.arrangement.distinct:
            plane = self.arrangement.integer_planes[members[0]]
            offset = plane[3] - dot(body.centre, plane[:3])
            scale = max(map(abs, plane[:3]))
            normal = np.array([float(x / scale) for x in plane[:3]])
            length = float(np.linalg.norm(normal))
            found.append(
                (self.axes @ normal / length, float(offset / body.radius / scale) / length)
            )
        return tuple(found)

    def sides_of(self, point: Floats) -> tuple[int, ...]:
        """Return the sides of a point of the picture, in floats."""
        return tuple(1 if float(n @ point) > b else -1 for n, b in self.planes)

    def body_edges(self) -> tuple[tuple[Key, tuple[int, ...], npt.NDArray[np.int64]], ...]:
        """Return key, sign vector and ends of the segments of the edges of a cube."""
        found = []
        for cell in self.cells.cells:
            ends = [
                (min(edge), max(edge))
                for edge, (one, other) in walls_of_edges(cell).items()
                if one < 0 and other < 0 and one != other
            ]
            found += [
                (self.key(cell.sides), cell.signs, np.array(pair)) for pair in sorted(set(ends))
            ]
        return tuple(found)


def unit_points(cells: Cells) -> Floats:
    """Return the points of the cells with the body at the origin and of radius 1, (P, 3).

    Differences are exact; one division of integers rounds each coordinate.
    """
    centre, radius = cells.body.centre, cells.body.radius
    common = math.lcm(*(c.denominator for c in centre))
    shift = [int(c * common) for c in centre]
    above, below = radius.denominator, radius.numerator * common
    return np.array(
        [
            [
                float((common * x - s * p[3]) * above / (below * p[3]))
                for x, s in zip(p, shift, strict=False)
            ]
            for p in cells.points
        ]
    )


def _facets_below(cell: Cell) -> list[Facet]:
    """Return the facets of a cell that lie under it, so that each facet occurs once."""
    found = []
    for face, wall in zip(cell.faces, cell.walls, strict=True):
        if wall >= 0 and cell.sides[wall] > 0:
            sides = tuple(0 if k == wall else s for k, s in enumerate(cell.sides))
            found.append((wall, sides, face))
    if not found:
        return []
    walls = walls_of_edges(cell)
    return [
        Facet(wall, sides, face, tuple(min(walls[edge]) < 0 for edge in cycle_edges(face)))
        for wall, sides, face in found
    ]


def walls_of_edges(cell: Cell) -> Mapping[tuple[int, int], tuple[int, int]]:
    """Return for each directed edge its own wall and that of the face across."""
    own = {
        edge: wall
        for face, wall in zip(cell.faces, cell.walls, strict=True)
        for edge in cycle_edges(face)
    }
    return {(a, b): (wall, own[b, a]) for (a, b), wall in own.items()}
