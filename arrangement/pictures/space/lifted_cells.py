"""Cells moved outward from the body, and where they hang on the tree of all that is painted.

A cell of central planes moves inside its own cone, so it keeps its sign vector and its place. For
other planes a lifted cell leaves its region. It moves until a plane separates it from the whole
body; before that plane its faces, and what else is there, have a tree of their own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, TypeVar

import numpy as np

from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.depth_tree import Node, depth_tree, halves, joined
from arrangement.drawing.solids.sight import face_normal
from arrangement.drawing.solids.surface import Patch
from arrangement.duals.cells import Cell
from arrangement.errors import InputError, extra
from arrangement.numbers.exact import IntegerVector, primitive, reduced
from arrangement.numbers.linear.rank import cycle_edges, loop_around, plane_through

from .stage import Stage, exact_points, sharp, walls_of_edges

#: How far a cell of central planes moves; the body has radius 1.
LIFT = 0.6
#: Shifts of cells of other planes are multiples of one over this.
_GRID = 1 << 20
#: The free distance between the body and a cell of other planes.
CLEARANCE = 0.12

_Drawn = TypeVar("_Drawn")


@dataclass(frozen=True)
class Lifted:
    """A cell outside its place.

    Attributes:
        cell: the cell.
        points: (P, 3); the points of all cells in the picture, moved with this one.
        shift: (3,); by how much.
        row: the plane between it and the body; none for a cell in its own cone.
    """

    cell: Cell
    points: Floats
    shift: Floats
    row: IntegerVector | None = None

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

    @cached_property
    def edges(self) -> frozenset[tuple[int, int]]:
        """The edges of visible faces where two walls meet, or that are on the contour."""
        faces = {e: k for k, face in enumerate(self.cell.faces) for e in cycle_edges(face)}
        walls, seen = walls_of_edges(self.cell), set(self.visible)
        return frozenset(
            (a, b)
            for (a, b), k in faces.items()
            if k in seen and (faces[b, a] not in seen or sharp(*walls[a, b], self.smooth))
        )

    def outlines(self) -> Iterator[Floats]:
        """Yield these edges, each once, as segments (2, 3)."""
        once = (
            edge for edge in sorted(self.edges) if edge[::-1] not in self.edges or edge[0] < edge[1]
        )
        return (self.points[list(edge)] for edge in once)

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
        return [self.points[loop] for group in groups.values() if (loop := loop_around(group))]

    @cached_property
    def smooth(self) -> bool:
        """Whether the surface of the body is round: then it has many small faces."""
        return sum(wall < 0 for wall in self.cell.walls) > 6


def lifted_cells(stage: Stage, chosen: Sequence[tuple[int, ...]]) -> tuple[Lifted, ...]:
    """Return the chosen cells, lifted.

    Raises:
        InputError: a cell is named twice, or outside the body; the cells run into each other.
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
    return tuple(lifted)


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
    # Exact from here on: the margins are far wider than any error.
    row = primitive((*_fractions(stage.axes.T @ way), -_fraction(reach + CLEARANCE / 2)))
    for _ in range(64):
        shift = stage.axes @ np.array(_fractions(stage.axes.T @ (far * way)), dtype=float)
        lifted = Lifted(cell, stage.points + shift, shift, row)
        if not any(_meet(lifted, other) for other in others):
            return lifted
        far += CLEARANCE
    raise InputError("the lifted cells run into each other; lift fewer of them")


def _fraction(x: float) -> Fraction:
    return Fraction(round(x * _GRID), _GRID)


def _fractions(vector: Floats) -> list[Fraction]:
    return list(map(_fraction, vector.tolist()))


def with_lifted(
    body: list[Node[_Drawn]],
    stage: Stage,
    lifted: Sequence[Lifted],
    draw: Callable[[Sequence[Patch]], _Drawn],
) -> list[Node[_Drawn]]:
    """Return a tree of the body with the visible faces of lifted cells before their planes.

    Args:
        draw: takes pieces that hide nothing of each other, each named by the numbers of its cell
            and of the face.
    """
    patches = [
        patch for k, item in enumerate(lifted) if item.row for patch in _patches(stage, item, k)
    ]
    fronts = []
    for item in lifted:
        if item.row:
            fronts.append((item.row, halves(patches, item.row, 1)))
            patches = halves(patches, item.row, -1)

    tree = body
    for row, front in reversed(fronts):
        nodes = depth_tree(front, lambda group: len({p.name.split()[0] for p in group}) == 1)
        drawn = [Node(n.row, [draw(n.patches)], n.front, n.back) for n in nodes]
        tree = joined(row, drawn, tree)
    return tree


def _patches(stage: Stage, item: Lifted, number: int) -> Iterator[Patch]:
    """Yield the visible faces of a lifted cell, exactly, named by its number and their own."""
    points = exact_points(stage.cells)
    shift = [int(x * _GRID) for x in _fractions(stage.axes.T @ item.shift)]

    def moved(i: int) -> IntegerVector:
        *place, scale = points[i]
        pairs = zip(place, shift, strict=True)
        return reduced([*(_GRID * x + s * scale for x, s in pairs), _GRID * scale])

    for k in item.visible:
        face = item.cell.faces[k]
        corners = tuple(map(moved, face))
        ends = tuple((moved(a), moved(b)) for a, b in cycle_edges(face) if (a, b) in item.edges)
        yield Patch(reduced(plane_through(*corners[:3])), corners, ends, name=f"{number} {k}")


def _meet(one: Lifted, other: Lifted) -> bool:
    """Return whether two convex solids have a common point."""
    with extra("figures"):
        from scipy.optimize import linprog

    rows = np.concatenate([one.normals, other.normals])
    bounds = np.concatenate([_offsets(one), _offsets(other)])
    answer: Any = linprog(np.zeros(3), rows, bounds, bounds=(None, None), method="highs")
    return bool(answer.status != 2)


def _offsets(lifted: Lifted) -> Floats:
    first = lifted.points[[face[0] for face in lifted.cell.faces]]
    offsets: Floats = (lifted.normals * first).sum(axis=1)
    return offsets
