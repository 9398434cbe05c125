"""Cells moved outward from the body, and where they stand in the painter's order.

A cell of central planes moves inside its own cone, so it keeps its sign vector and its place in
the order. For other planes a lifted cell leaves its region. It moves until a plane separates it
from the whole body; two lifted cells are compared where they overlap in the picture.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from graphlib import CycleError, TopologicalSorter
from itertools import pairwise
from typing import Any, TypeAlias, TypeVar

import numpy as np

from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.depth_tree import Node, back_to_front, plane_tree
from arrangement.drawing.solids.sight import face_normal, picture_axes
from arrangement.duals.cells import Cell, Cells
from arrangement.errors import InputError
from arrangement.numbers.exact import IntegerVector, dot
from arrangement.numbers.linear.rank import cycle_edges
from arrangement.pictures.parts.coordinates import REACH
from arrangement.planes.planes import Planes

#: How far a cell of central planes moves; the body has radius 1.
LIFT = 0.6
#: The free distance between the body and a cell of other planes.
CLEARANCE = 0.12


@dataclass(frozen=True)
class Lifted:
    """A cell outside its place.

    Attributes:
        cell: the cell.
        points: (P, 3); the points of all cells in the picture, moved with this one.
        shift: (3,); by how much.
        place: -1 if it is painted before the body, +1 if after, 0 if in the body's order.
    """

    cell: Cell
    points: Floats
    shift: Floats
    place: int = 0

    @cached_property
    def corners(self) -> Floats:
        """The corners of the cell, (k, 3)."""
        return self.points[sorted({i for face in self.cell.faces for i in face})]

    @cached_property
    def normals(self) -> Floats:
        """The outward unit normals of the faces."""
        return np.array([face_normal(self.points[list(face)]) for face in self.cell.faces])

    @cached_property
    def visible(self) -> tuple[int, ...]:
        """The faces that the viewer sees."""
        return tuple(np.flatnonzero(self.normals[:, 2] > 1e-9).tolist())

    def outlines(self) -> Iterator[Floats]:
        """Yield the visible edges between two walls, and the contour, as segments (2, 3)."""
        faces = {e: k for k, face in enumerate(self.cell.faces) for e in cycle_edges(face)}
        walls = walls_of_edges(self.cell)
        seen = set(self.visible)
        for (a, b), k in faces.items():
            other = faces[b, a]
            contour = k in seen and other not in seen
            inner = k in seen and other in seen and a < b and sharp(*walls[a, b], self.smooth)
            if contour or inner:
                yield self.points[[a, b]]

    def visible_outlines(self, one_skin: bool) -> list[Floats]:
        """Return the outline of the visible part of each wall, (k, 3).

        Args:
            one_skin: whether all faces on the surface of the body count as one wall.
        """
        groups: dict[int, set[tuple[int, int]]] = {}
        for k in self.visible:
            wall = self.cell.walls[k]
            group = groups.setdefault(-1 if one_skin and wall < 0 else wall, set())
            group.update(cycle_edges(self.cell.faces[k]))
        return [self.points[loop] for group in groups.values() if (loop := _loop(group))]

    @cached_property
    def smooth(self) -> bool:
        """Whether the surface of the body is round: then it has many small faces."""
        return sum(wall < 0 for wall in self.cell.walls) > 6


def lifted_cells(stage: Stage, chosen: Sequence[tuple[int, ...]]) -> tuple[Lifted, ...]:
    """Return the chosen cells, lifted, those in the body's order first, then back to front.

    Raises:
        InputError: a cell is named twice, or outside the body; no order exists in which the cells
            can be painted.
    """
    if len(set(chosen)) < len(chosen):
        raise InputError("a cell is to be lifted twice; name each once")
    cells = {cell.signs: cell for cell in stage.cells.cells}
    if not set(chosen) <= set(cells):
        raise InputError("a cell to be lifted is outside the body; choose a larger radius")
    if stage.arrangement.is_central and not any(stage.cells.body.centre):
        return tuple(_inside_its_cone(stage, cells[signs]) for signs in chosen)
    lifted: list[Lifted] = []
    for signs in chosen:
        lifted.append(_clear_of_the_body(stage, cells[signs], lifted))
    return _back_to_front(lifted)


def _inside_its_cone(stage: Stage, cell: Cell) -> Lifted:
    own = Lifted(cell, stage.points, np.zeros(3))
    way = own.corners.mean(axis=0) if stage.arrangement.rank else np.array([0.0, 1.0, 0.0])
    length = float(np.linalg.norm(way))
    way = way / length if length > 1e-9 else np.array([0.0, 1.0, 0.0])
    return Lifted(cell, stage.points + LIFT * way, LIFT * way)


def _clear_of_the_body(stage: Stage, cell: Cell, others: Sequence[Lifted]) -> Lifted:
    """Move a cell away from the centre until it is clear of the body and of other lifted cells."""
    corners = Lifted(cell, stage.points, np.zeros(3)).corners
    middle = corners.mean(axis=0)
    length = float(np.linalg.norm(middle))
    way = middle / length if length > 0.02 else np.array([0.0, 1.0, 0.0])
    reach = max(float((stage.points @ way).max()), 1.0)
    far = reach + CLEARANCE - float((corners @ way).min())
    place = 1 if way[2] >= 0 else -1
    for _ in range(64):
        lifted = Lifted(cell, stage.points + far * way, far * way, place)
        if not any(_meet(lifted, other) for other in others):
            return lifted
        far += CLEARANCE
    raise InputError("the lifted cells run into each other; lift fewer of them")


def _meet(one: Lifted, other: Lifted) -> bool:
    """Whether two convex solids have a common point."""
    from scipy.optimize import linprog

    rows = np.concatenate([one.normals, other.normals])
    bounds = np.concatenate([_offsets(one), _offsets(other)])
    answer: Any = linprog(np.zeros(3), rows, bounds, bounds=(None, None), method="highs")
    return bool(answer.status != 2)


def _offsets(lifted: Lifted) -> Floats:
    first = lifted.points[[face[0] for face in lifted.cell.faces]]
    offsets: Floats = (lifted.normals * first).sum(axis=1)
    return offsets


def _back_to_front(lifted: Sequence[Lifted]) -> tuple[Lifted, ...]:
    """Sort so that none hides one that comes later; the body lies between places -1 and +1."""
    n = len(lifted)
    behind = {(i, j) for i in range(n) for j in range(n) if i != j and _hides(lifted[j], lifted[i])}
    behind |= {(i, j) for i in range(n) for j in range(n) if lifted[i].place < lifted[j].place}
    order = TopologicalSorter({j: {i for i in range(n) if (i, j) in behind} for j in range(n)})
    try:
        return tuple(lifted[i] for i in order.static_order())
    except CycleError:
        raise InputError(
            "the lifted cells hide each other in a circle; choose another direction"
        ) from None


def _hides(near: Lifted, far: Lifted) -> bool:
    """Whether two disjoint convex solids overlap in the picture, the first in front."""
    point = _common_point(near.corners[:, :2], far.corners[:, :2])
    if point is None:
        return False
    return bool(_depths(near, point).mean() > _depths(far, point).mean())


def _common_point(one: Floats, other: Floats) -> Floats | None:
    """Return the point deepest inside the convex hulls of both sets, or None."""
    from scipy.optimize import linprog
    from scipy.spatial import ConvexHull

    rows = np.concatenate([ConvexHull(one).equations, ConvexHull(other).equations])
    table = np.column_stack([rows[:, :2], np.ones(len(rows))])
    answer: Any = linprog([0, 0, -1], table, -rows[:, 2], bounds=(None, None), method="highs")
    return None if answer.x[2] < 1e-6 else np.array(answer.x[:2])


def _depths(lifted: Lifted, point: Floats) -> Floats:
    """Return the depths at which the line of sight enters and leaves a solid."""
    normals, offsets = lifted.normals, _offsets(lifted)
    steep = np.abs(normals[:, 2]) > 1e-12
    at = (offsets[steep] - normals[steep, :2] @ point) / normals[steep, 2]
    front = normals[steep, 2] > 0
    return np.array([at[~front].max(), at[front].min()])


def _loop(directed: set[tuple[int, int]]) -> list[int]:
    """Return the boundary of faces given by their directed edges; empty if it is not one cycle."""
    following = {a: b for a, b in directed if (b, a) not in directed}
    loop = [min(following)]
    while following[loop[-1]] != loop[0] and len(loop) < len(following):
        loop.append(following[loop[-1]])
    return loop if following[loop[-1]] == loop[0] else []


def sharp(wall: int, other: int, smooth: bool) -> bool:
    """Whether the edge between two walls is one of the solid, not one of a round surface."""
    return wall != other and not (smooth and wall < 0 and other < 0)


#: Of the first plane of each class.
Sides: TypeAlias = tuple[int, ...]
_Drawn = TypeVar("_Drawn")


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
    sides: Sides
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
    def facets(self) -> tuple[Facet, ...]:
        """All facets, back to front."""
        found = [facet for cell in self.cells.cells for facet in _facets_below(cell)]
        found.sort(key=lambda facet: (facet.label, facet.sides))
        nodes = back_to_front(self.tree((f.sides, f) for f in found), self.direction)
        return tuple(facet for node in nodes for facet in node.patches)

    def tree(self, pieces: Iterable[tuple[Sequence[int], _Drawn]]) -> list[Node[_Drawn]]:
        """Return the tree of the planes, with pieces that have these sides of them."""
        return plane_tree([(*p[:3], -p[3]) for p in self.arrangement.distinct_planes], pieces)

    @cached_property
    def planes(self) -> tuple[tuple[Floats, float], ...]:
        """For each class the unit normal and offset of its first plane, in the picture."""
        body = self.cells.body
        found = []
        for plane in self.arrangement.distinct_planes:
            offset = plane[3] - dot(body.centre, plane[:3])
            scale = max(map(abs, plane[:3]))
            normal = np.array([float(x / scale) for x in plane[:3]])
            length = float(np.linalg.norm(normal))
            found.append(
                (self.axes @ normal / length, float(offset / body.radius / scale) / length)
            )
        return tuple(found)

    def body_edges(self) -> Iterator[tuple[Sides, Floats]]:
        """Yield sides and ends of the segments of the edges of a cube."""
        for cell in self.cells.cells:
            ends = {
                (min(edge), max(edge))
                for edge, (one, other) in walls_of_edges(cell).items()
                if one < 0 and other < 0 and one != other
            }
            for pair in sorted(ends):
                yield cell.sides, self.points[list(pair)]


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


class StagedAxes:
    """The three half-axes in a body, cut where planes and its surface meet them.

    Attributes:
        names: of the axes; there may be none.
        origin: (3,); in the axes of the picture, the body having its centre at 0 and radius 1.
        tips: (3, 3); the ends, or nothing.

    Raises:
        InputError: there are names, and the origin is not in the body.
    """

    def __init__(self, stage: Stage, names: Sequence[str]) -> None:
        self.stage, self.names = stage, names
        body = stage.cells.body
        place = np.array([float(-c / body.radius) for c in body.centre])
        self.origin = stage.axes @ place
        inside = float(np.abs(place).max()) if body.kind == "cube" else float(place @ place)
        if names and inside >= 1:
            raise InputError("the origin is not in the body; choose another body, or axes none")
        square = place**2 + 1 - place @ place
        # Where |place + t e_k| = 1 in a ball, and where the k-th coordinate is 1 in a cube.
        self._out = 1 - place if body.kind == "cube" else np.sqrt(np.maximum(0, square)) - place
        ways = stage.axes.T[: len(names)]
        self.tips = self.origin + (self._out[: len(names), None] + REACH - 1) * ways

    def inside(self) -> Iterator[tuple[Sides, Floats]]:
        """Yield the sides and the ends (2, 3) of each piece in the body."""
        for way, out in zip(self.stage.axes.T[: len(self.names)], self._out, strict=False):
            cuts = [0.0, float(out)]
            for normal, offset in self.stage.planes:
                slope = float(normal @ way)
                if abs(slope) > 1e-12:
                    cuts.append((offset - float(normal @ self.origin)) / slope)
            inner = sorted(t for t in cuts if 0 <= t <= out)
            for start, stop in pairwise(inner):
                if stop - start > 1e-9:
                    ends = self.origin + np.array([[start], [stop]]) * way
                    middle = ends.mean(axis=0)
                    # In floats: an axis may lie in planes.
                    heights = [float(n @ middle) - offset for n, offset in self.stage.planes]
                    yield tuple(0 if abs(h) < 1e-9 else 1 if h > 0 else -1 for h in heights), ends

    def outside(self) -> Iterator[tuple[bool, Floats]]:
        """Yield for each axis whether it comes out of the body in front, and the ends (2, 3)."""
        for way, out, tip in zip(self.stage.axes.T, self._out, self.tips, strict=False):
            yield bool(way[2] > 0), np.array([self.origin + out * way, tip])
