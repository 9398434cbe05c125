"""Cells moved outward from the body, and where they stand in the painter's order.

A cell of central planes moves inside its own cone, so it keeps its sign vector and its place in
the order. For other planes a lifted cell leaves its region. It moves until a plane separates it
from the whole body; two lifted cells are compared where they overlap in the picture.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from graphlib import CycleError, TopologicalSorter
from typing import Any

import numpy as np

from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.sight import face_normal
from arrangement.duals.cells import Cell
from arrangement.errors import InputError
from arrangement.numbers.linear.rank import cycle_edges

from .stage import Stage, sharp, walls_of_edges

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
