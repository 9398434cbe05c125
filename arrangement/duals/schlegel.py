"""The dual of central planes of rank 4 in R^4, seen through one of its facets: a Schlegel diagram.

The dual is a polytope with a vertex for each region, an edge for each facet, a polygon for each
face of dimension 2 and a facet for each ray of the arrangement, which is its outward normal; see
`zonotope`. From a point beyond one facet and no other, the rest of its surface appears inside this
facet, divided into cells ([Ziegler1995], section 5.2). The point is checked exactly; what is seen
from there is rounded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from arrangement.console.number_form import ReprMixin
from arrangement.drawing.solids.sight import unit_vectors
from arrangement.enumeration.choose import enumerate_faces
from arrangement.enumeration.regions import neighbours
from arrangement.numbers.exact import IntegerVector, dot
from arrangement.planes.planes import Planes

from .zonotope import generators

#: How far the point is from the middle of the facet, as a share of the way to another facet.
_SHARE = 0.75


@dataclass(frozen=True, eq=False)
class SchlegelDiagram(ReprMixin):
    """The dual of rank 4, and a point from which it is seen.

    Attributes:
        signs: (V, m) int8, the sign vector of each vertex's region, over the input planes.
        edges: vertex, vertex, and the class of planes that separates their regions.
        vertices: the sums of signed generators, times a common factor, integers.
        normals: the outward normal of each facet, the primitive direction of its ray.
        facets: the vertices of each facet.
        polygons: the vertices of each face of dimension 2, in cyclic order.
        outer: the facet that is seen through, by number.
        point: from where it is seen, times the factor of the vertices and a positive integer,
            which is its last entry.
    """

    signs: npt.NDArray[np.int8]
    edges: tuple[tuple[int, int, int], ...]
    vertices: tuple[IntegerVector, ...]
    normals: tuple[IntegerVector, ...]
    facets: tuple[tuple[int, ...], ...]
    polygons: tuple[tuple[int, ...], ...]
    outer: int
    point: IntegerVector

    def __repr__(self) -> str:
        return f"<SchlegelDiagram: {len(self.vertices)} vertices, {len(self.facets)} facets>"

    @cached_property
    def places(self) -> npt.NDArray[np.float64]:
        """The vertices as they are seen in the outer facet, (V, 3)."""
        *above, scale = self.point
        largest = max(max(map(abs, vertex)) for vertex in self.vertices)
        points = np.array([[x / largest for x in vertex] for vertex in self.vertices])
        eye = np.array([x / (scale * largest) for x in above])
        normal = unit_vectors([self.normals[self.outer]])[0]
        heights = (points - eye) @ normal
        seen = (points - eye) * (heights[self.facets[self.outer][0]] / heights)[:, None]
        # The mirror that takes the normal to an axis takes the other axes into the facet.
        axis = int(np.argmax(np.abs(normal)))
        mirror = normal.copy()
        mirror[axis] += np.copysign(1.0, normal[axis])
        across = np.eye(4) - 2 * np.outer(mirror, mirror) / (mirror @ mirror)
        flat = seen @ np.delete(across, axis, axis=0).T
        places: npt.NDArray[np.float64] = flat - flat[list(self.facets[self.outer])].mean(axis=0)
        return places

    @property
    def cells(self) -> tuple[tuple[tuple[int, ...], ...], ...]:
        """The polygons of each facet but the outer one: of the cells inside it."""
        inner = [set(facet) for k, facet in enumerate(self.facets) if k != self.outer]
        return tuple(tuple(p for p in self.polygons if facet.issuperset(p)) for facet in inner)


def schlegel_diagram(
    arrangement: Planes,
    lengths: Iterable[Any] | None = None,
    fitness: Callable[[IntegerVector], Any] = lambda normal: 0,
) -> SchlegelDiagram:
    """Return the dual of central planes of rank 4 in R^4, and a point beyond one facet.

    Args:
        arrangement: coincident planes are fine.
        lengths: a positive exact factor for each normal; 1 if omitted.
        fitness: of a facet, from its normal; of those with most vertices the fittest one is seen
            through.

    Raises:
        InputError: other planes.

    >>> from arrangement import Arrangement
    >>> schlegel_diagram(Arrangement([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]))
    <SchlegelDiagram: 16 vertices, 8 facets>
    """
    spans = generators(arrangement, lengths, 4)
    faces = enumerate_faces(arrangement)
    signs = faces.of_dimension(4).signs
    edges = tuple(neighbours(arrangement, faces))
    rays, sheets = faces.of_dimension(1), faces.of_dimension(2)
    normals = tuple(tuple(point[:-1]) for point in rays.points.tolist())
    facets = tuple(map(tuple, _around(rays.signs, signs)))
    beside: list[list[int]] = [[] for _ in signs]
    for u, v, _ in edges:
        beside[u].append(v)
        beside[v].append(u)
    polygons = tuple(_cycle(corners, beside) for corners in _around(sheets.signs, signs))
    most = max(map(len, facets))
    largest = [k for k, facet in enumerate(facets) if len(facet) == most]
    outer = max(largest, key=lambda k: fitness(normals[k]))
    columns = list(zip(*spans.vectors, strict=True))
    vertices = [tuple(dot(row, column) for column in columns) for row in signs.tolist()]
    heights = [sum(abs(dot(g, r)) for g in spans.vectors) for r in normals]
    middle = [dot(rays.signs[outer].tolist(), column) for column in columns]
    point = _beyond(normals, heights, outer, middle)
    return SchlegelDiagram(signs, edges, tuple(vertices), normals, facets, polygons, outer, point)


def _beyond(
    normals: Sequence[IntegerVector], heights: Sequence[int], outer: int, middle: Sequence[int]
) -> IntegerVector:
    """Return a point, over its last entry, beyond the facet with this middle and no other one."""
    ray = normals[outer]
    others = [k for k in range(len(normals)) if k != outer]
    # How far the middle is below each facet, and how fast a way along the ray rises to it.
    gaps = [heights[k] - dot(normals[k], middle) for k in others]
    rises = [dot(normals[k], ray) for k in others]
    ways = [float(gap / rise) for gap, rise in zip(gaps, rises, strict=True) if rise > 0]
    way = _SHARE * min(ways, default=float(heights[outer] / dot(ray, ray)))
    while True:
        steps, scale = way.as_integer_ratio()
        if all(scale * gap > steps * rise for gap, rise in zip(gaps, rises, strict=True)):
            return (*(scale * x + steps * r for x, r in zip(middle, ray, strict=True)), scale)
        way /= 2


def _around(faces: npt.NDArray[np.int8], regions: npt.NDArray[np.int8]) -> list[list[int]]:
    """Return for each face the regions whose closure has it."""
    wide = regions.astype(np.float32)
    incident = faces.astype(np.float32) @ wide.T == np.abs(faces).sum(axis=1)[:, None]
    return [np.flatnonzero(row).tolist() for row in incident]


def _cycle(corners: Sequence[int], beside: Sequence[Sequence[int]]) -> tuple[int, ...]:
    """Return the corners of a polygon in cyclic order, by the neighbours of all vertices."""
    cycle = [corners[0]]
    for _ in corners[1:]:
        left = set(corners).difference(cycle)
        cycle.append(next(v for v in beside[cycle[-1]] if v in left))
    return tuple(cycle)
