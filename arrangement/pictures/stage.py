"""Planes inside a body, in the axes of a picture: cells, facets, axes, and a clear view of them.

A cell of central planes that is lifted from the body moves inside its own cone, so it keeps its
sign vector and its place. For other planes a lifted cell leaves its region. It moves until a plane
separates it from the whole body; before that plane its faces, and what else is there, have a tree
of their own.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations, pairwise
from typing import Any, TypeAlias, TypeVar

import numpy as np

from arrangement.drawing.scene import Floats
from arrangement.drawing.solids.depth_tree import (
    Node,
    back_to_front,
    depth_tree,
    halves,
    join_trees,
    plane_tree,
)
from arrangement.drawing.solids.sight import (
    best_view,
    face_normal,
    picture_axes,
    unit,
    unit_vectors,
    views,
)
from arrangement.drawing.solids.surface import Patch, float_points
from arrangement.duals.cells import Cell, Cells
from arrangement.errors import InputError, extra
from arrangement.numbers.exact import IntegerVector, dot, primitive, reduced, unoriented
from arrangement.numbers.linear.rank import cycle_edges, loop_around, plane_through
from arrangement.pictures.coordinates import REACH
from arrangement.planes.planes import Planes

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

    def in_view(self, point: Floats) -> Floats:
        """Return a point of R^3 in the axes of the picture, where the body has its place."""
        body = self.cells.body
        centre = np.array([float(x) for x in body.centre])
        placed: Floats = self.axes @ (point - centre) / float(body.radius)
        return placed

    def cell_of(self, place: Floats) -> Cell:
        """Return the cell that a point in the axes of the picture is in, or on the boundary of."""
        sides = [float(normal @ place) - offset for normal, offset in self.planes]

        def inside(cell: Cell) -> float:
            return min((x * s for x, s in zip(sides, cell.sides, strict=True)), default=0.0)

        return max(self.cells.cells, key=inside)

    @cached_property
    def facets(self) -> tuple[Facet, ...]:
        """All facets, back to front."""
        facets = [facet for cell in self.cells.cells for facet in _facets_below(cell)]
        facets.sort(key=lambda facet: (facet.label, facet.sides))
        nodes = back_to_front(self.tree((f.sides, f) for f in facets), self.direction)
        return tuple(facet for node in nodes for facet in node.patches)

    def tree(self, pieces: Iterable[tuple[Sequence[int], _Drawn]]) -> list[Node[_Drawn]]:
        """Return the tree of the planes, with pieces that have these sides of them."""
        return plane_tree([(*p[:3], -p[3]) for p in self.arrangement.distinct_planes], pieces)

    @cached_property
    def planes(self) -> tuple[tuple[Floats, float], ...]:
        """For each class the unit normal and offset of its first plane, in the picture."""
        body = self.cells.body
        polygons = []
        for plane in self.arrangement.distinct_planes:
            offset = plane[3] - dot(body.centre, plane[:3])
            scale = max(map(abs, plane[:3]))
            length = float(np.linalg.norm([float(x / scale) for x in plane[:3]]))
            normal = self.axes @ unit_vectors([plane[:3]])[0]
            polygons.append((normal, float(offset / body.radius / scale) / length))
        return tuple(polygons)

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
    """Return the points of the cells with the body at the origin and of radius 1, (P, 3)."""
    return float_points(exact_points(cells))


def exact_points(cells: Cells) -> list[IntegerVector]:
    """Return the same points as homogeneous ones."""
    centre, radius = cells.body.centre, cells.body.radius
    common = math.lcm(*(c.denominator for c in centre))
    shift = [int(c * common) for c in centre]
    above, below = radius.denominator, radius.numerator * common
    return [
        (*((common * x - s * p[3]) * above for x, s in zip(p, shift, strict=False)), below * p[3])
        for p in cells.points
    ]


def _facets_below(cell: Cell) -> list[Facet]:
    """Return the facets of a cell that lie under it, so that each facet occurs once."""
    facets = []
    for face, wall in zip(cell.faces, cell.walls, strict=True):
        if wall >= 0 and cell.sides[wall] > 0:
            sides = tuple(0 if k == wall else s for k, s in enumerate(cell.sides))
            facets.append((wall, sides, face))
    if not facets:
        return []
    walls = walls_of_edges(cell)
    return [
        Facet(wall, sides, face, tuple(min(walls[edge]) < 0 for edge in cycle_edges(face)))
        for wall, sides, face in facets
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


def sharp(wall: int, other: int, smooth: bool) -> bool:
    """Return whether the edge between two walls is one of the solid, not one of a round surface."""
    return wall != other and not (smooth and wall < 0 and other < 0)


#: Pairs of lines that are compared at most; the rest of a large arrangement hardly matters.
_MOST_PAIRS = 400


def clear_sight(cells: Cells, lifted: Sequence[tuple[int, ...]] = ()) -> IntegerVector:
    """Return a direction from above that shows the planes well.

    It avoids planes seen edge-on or from straight ahead. Less strictly, it avoids directions in
    which two planes are seen at the same angle, or two of these lines fall together: intersections
    of planes, axes, diagonals of a cube.
    Lifted cells move sideways in the picture, a little towards the viewer. The choice is one of a
    fixed list, so that it is exact and repeats.
    """
    directions = views(range(-7, 8), range(-7, 8), range(1, 6), low=0.25, high=0.62)
    return best_view(directions, lambda seen: _score(unit_vectors(seen), cells, lifted))


def _score(units: Floats, cells: Cells, lifted: Sequence[tuple[int, ...]]) -> Floats:
    normals = [plane[:3] for plane in cells.arrangement.integer_planes]
    score = np.ones(len(units))
    if normals:
        facing = np.abs(units @ unit_vectors(normals).T)
        oblique = np.minimum(facing, 0.8 * np.sqrt(np.maximum(0.0, 1 - facing**2)))
        score = np.minimum(score, oblique.min(axis=1))
        pairs = list(combinations(unit_vectors(normals), 2))[:_MOST_PAIRS]
        # From the planes of symmetry between two of the planes, and those through two lines.
        score = np.minimum(
            score, 2 * _distances(units, [m for a, b in pairs for m in (a - b, a + b)])
        )
    pairs = list(combinations(unit_vectors(_lines(cells, normals)), 2))[:_MOST_PAIRS]
    score = np.minimum(score, 3 * _distances(units, [np.cross(a, b) for a, b in pairs]))
    for way in _lift_directions(cells, lifted):
        towards = units @ way
        score *= np.exp(-(((towards - 0.3) / 0.35) ** 2))
    return score * (1 + 0.02 * units[:, 0] - 0.05 * units[:, 1])


def _lines(cells: Cells, normals: Sequence[IntegerVector]) -> list[IntegerVector]:
    """Return the directions of intersections of planes, the axes, and the diagonals of a cube."""
    # Of entries short enough for machine integers.
    small = np.array([n for n in normals if max(map(abs, n)) < 2**30]).reshape(-1, 3)
    first, second = np.triu_indices(len(small), 1)
    lines = set(map(tuple, np.cross(small[first], small[second]).tolist()))
    crosses = {unoriented(primitive(line)) for line in lines}
    fixed = {(1, 0, 0), (0, 1, 0), (0, 0, 1)}
    if cells.body.kind == "cube":
        fixed |= {(1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1)}
    return sorted(line for line in crosses | fixed if any(line))


def _distances(units: Floats, normals: Sequence[Floats]) -> Floats:
    """Return how far each view is from planes; normals of length 0 do not count."""
    rows = np.array(normals).reshape(-1, 3)
    lengths = np.linalg.norm(rows, axis=1)
    rows = rows[lengths > 1e-6] / lengths[lengths > 1e-6, None]
    apart: Floats = np.abs(units @ rows.T).min(axis=1, initial=1.0)
    return apart


def _lift_directions(cells: Cells, lifted: Sequence[tuple[int, ...]]) -> Floats:
    """Return the unit directions from the centre to the lifted cells."""
    points = unit_points(cells)
    chosen = [cell.faces for cell in cells.cells if cell.signs in lifted]
    middles = [points[sorted({i for face in faces for i in face})].mean(axis=0) for faces in chosen]
    return unit(np.array([way for way in middles if np.linalg.norm(way) > 1e-9]).reshape(-1, 3))


#: How far a cell of central planes moves; the body has radius 1.
LIFT = 0.6
#: Shifts of cells of other planes are multiples of one over this.
_GRID = 1 << 20
#: The free distance between the body and a cell of other planes.
CLEARANCE = 0.12


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
        tree = join_trees(row, drawn, tree)
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
