"""What lines, parts of lines and segments cut the plane into: vertices, edges and cells.

All lines, those of segments and of sides of a polygon too, are great circles of a sphere together
with the line at infinity, by the exact engine. An arc of it is *drawn* if a line or a segment
covers it. Then

1. a vertex is a point where a segment ends, or where drawn arcs of two circles meet; where an arc
   only goes on, two arcs are one edge;
2. a cell is made of the regions that are joined across arcs that are not drawn;
3. a cell is unbounded if one of its regions has a vertex at infinity.

Complexity: that of the great circles, O(m^2 log m) for m lines.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.enumeration.choose import ENGINES, check_engine
from arrangement.enumeration.great_circles import sphere_arrangement
from arrangement.enumeration.great_circles.arrangement import unpack
from arrangement.errors import InputError
from arrangement.numbers.exact import dot
from arrangement.planes.planes import Planes
from arrangement.planes.polygon import line_through

_Truth: TypeAlias = NDArray[np.bool_]
_Places: TypeAlias = NDArray[np.int8]
_OUTSIDE, _BOUNDARY, _INSIDE = range(3)


class Pieces(NamedTuple):
    """Numbers of vertices, edges and cells.

    Attributes:
        cells: the components of the plane without the lines and segments.
        bounded_cells: those of finite area.
        cells_by_edges: the number of bounded cells with k edges, by k. An edge with one cell on
            both sides counts twice.
    """

    vertices: int
    edges: int
    cells: int
    bounded_cells: int
    cells_by_edges: Mapping[int, int]


class Cut(NamedTuple):
    """What lines cut a convex polygon and the rest of the plane into.

    Attributes:
        inside: in the interior of the polygon.
        boundary: vertices and edges on its sides, which are drawn; it has no cells.
        outside: the rest of the plane.
    """

    inside: Pieces
    boundary: Pieces
    outside: Pieces


def cut(lines: Planes, sides: Planes) -> Cut:
    """Return what lines of R^2 and the boundary of a polygon cut its two sides into.

    Args:
        sides: lines with the polygon, which need not be bounded, on the positive side of each.

    Raises:
        InputError: lines of another space, or nothing on the positive side of all sides.
        OutOfReachError: this takes more than the budget.
    """
    for planes in (lines, sides):
        if planes.dimension != 2:
            raise InputError(
                f"{planes!r} are not lines of R^2, whose pieces are counted; the faces inside of a "
                "polyhedron are listed (arrangement faces --inside, faces(inside=...))"
            )
    sheet = Sheet([*sides.integer_planes, *lines.integer_planes])
    own = slice(len(sides))

    def places(signs: _Places) -> _Places:
        of_sides = signs[:, own]
        place = np.where((of_sides > 0).all(axis=1), _INSIDE, _BOUNDARY)
        return np.where((of_sides < 0).any(axis=1), _OUTSIDE, place).astype(np.int8)

    of_vertices, of_arcs, of_regions = map(places, sheet.signs)
    if not (of_regions[sheet.front_regions] == _INSIDE).any():
        raise InputError(
            "nothing is on the positive side of all sides; give lines with a polygon there, or the "
            "corners of one, as in 0,0; 4,0; 0,4"
        )
    covered = np.zeros(sheet.circles, bool)
    covered[list(sheet.sphere.plane_circle[len(sides) : -1])] = True
    drawn = covered[sheet.circle] | (of_arcs[sheet.front] == _BOUNDARY)
    sheet.draw(drawn, np.zeros(len(of_vertices), bool))
    parts = sheet.pieces(of_vertices, of_arcs, of_regions)
    return Cut(*(parts[place] for place in (_INSIDE, _BOUNDARY, _OUTSIDE)))


def segment_sheet(segments: Sequence[Sequence[Sequence[Any]]]) -> Sheet:
    """Return the plane with segments [p, q] drawn in it, p and q different points of R^2."""
    lines = [line_through(p, q) for p, q in segments]
    ends = [(line, p) for line, segment in zip(lines, segments, strict=True) for p in segment]
    crossing = Planes([line[:2] for line in lines], [line[2] for line in lines], dimension=2)
    # An end that no other line goes through is cut off by a line across, which is not drawn.
    across = [
        (-b, a, a * p[1] - b * p[0])
        for (a, b, _), p in ends
        if sum(dot(n[:2], p) == n[2] for n in crossing.distinct_planes) == 1
    ]
    sheet = Sheet([*lines, *across])
    drawn, is_end = np.zeros(len(sheet.front), bool), np.zeros(sheet.sphere.vertex_count, bool)
    rays = sheet.sphere.rays.tolist()
    for circle, (p, q) in zip(sheet.sphere.plane_circle.tolist(), segments, strict=False):
        way = [b - a for a, b in zip(p, q, strict=True)]
        start, stop = dot(way, p), dot(way, q)
        within = np.zeros(len(is_end), bool)
        for v in sheet.sphere.incidence.crossings(circle).tolist():
            *point, w = rays[v]
            if w > 0 and start * w <= (at := dot(way, point)) <= stop * w:
                within[v] = True
                is_end[v] |= at in (start * w, stop * w)
        drawn |= (sheet.circle == circle) & within[sheet.tail] & within[sheet.head]
    sheet.draw(drawn, is_end)
    return sheet


class Sheet:
    """The plane as the front half of a sphere.

    Attributes:
        rows: a, b, c of each line a x + b y = c.
        sphere: circles of the lines and, last, the line at infinity.
        signs: of all vertices, arcs and regions, a column for each line.
        front: the arcs that are not at infinity; `circle`, `tail`, `head`, `left`, `right` of each.
        front_regions: the regions of the front half.
    """

    def __init__(self, rows: Iterable[Sequence[Any]]) -> None:
        """Build the great circles of lines, given as rows."""
        self.rows = list(rows)
        planes = Planes([*((a, b, -c) for a, b, c in self.rows), (0, 0, 1)])
        check_engine(planes, ENGINES["great-circles"])
        self.sphere = sphere = sphere_arrangement(planes)
        incidence = sphere.incidence
        self.circles = sphere.circle_count
        positive = sphere.packed_region_signs
        packed = (sphere.packed_vertex_signs, sphere.packed_arc_signs, (positive, ~positive))
        every = [unpack(*pair, len(planes)) for pair in packed]
        self.signs = [signs[:, :-1] for signs in every]
        self.front_vertices = every[0][:, -1] > 0
        self.front = np.flatnonzero(every[1][:, -1] > 0)
        self.front_regions = np.flatnonzero(every[2][:, -1] > 0)
        self.circle = incidence.arc_circle[self.front]
        self.tail, self.head = (incidence.origin[2 * self.front + k] for k in (0, 1))
        self.left, self.right = (incidence.region[2 * self.front + k] for k in (0, 1))
        # the closed arc of a circle alone has the origin -1
        at_infinity = np.append(every[0][:, -1] == 0, True)[incidence.origin]
        self.unbounded = np.zeros(sphere.region_count, bool)
        self.unbounded[incidence.region[at_infinity]] = True

    def place(self, vertex: int) -> NDArray[np.float64]:
        """Return about where a vertex is that is not at infinity, (2)."""
        x, y, w = self.sphere.ray(vertex)
        return np.array([float(x / w), float(y / w)])

    def draw(self, drawn: _Truth, is_end: _Truth) -> None:
        """Mark arcs in front as drawn, and join the regions that these do not separate.

        Args:
            is_end: which vertices are such even where an arc only goes on.

        Sets `drawn`, `passed` and `is_vertex`; the `cell` of each region in front, by the number of
        one of its regions; the `open_cells`; and the numbers of `edges` of all cells.
        """
        from networkx.utils import UnionFind  # slow to load

        count = self.sphere.vertex_count
        degree, least, most = np.zeros(count, int), np.full(count, self.circles), np.full(count, -1)
        for end in (self.tail[drawn], self.head[drawn]):
            np.add.at(degree, end, 1)
            np.minimum.at(least, end, self.circle[drawn])
            np.maximum.at(most, end, self.circle[drawn])
        self.drawn = drawn
        self.passed = self.front_vertices & ~is_end & (degree == 2) & (least == most)
        self.is_vertex = self.front_vertices & ~self.passed & (degree > 0)
        joined = UnionFind(self.front_regions.tolist())
        for pair in zip(self.left[~drawn].tolist(), self.right[~drawn].tolist(), strict=True):
            joined.union(*pair)
        self.cell = {region: joined[region] for region in self.front_regions.tolist()}
        self.open_cells = {own for region, own in self.cell.items() if self.unbounded[region]}
        self.edges = Counter[int]()
        for on, sign in ((drawn, 1), (drawn & self.passed[self.tail], -1)):
            for side in (self.left, self.right):
                for region in side[on].tolist():
                    self.edges[self.cell[region]] += sign

    def pieces(self, vertices: _Places, arcs: _Places, regions: _Places) -> list[Pieces]:
        """Count what is at each of the places 0, 1, 2, which those of all parts are."""
        made = []
        for place in (_OUTSIDE, _BOUNDARY, _INSIDE):
            cells = {own for own in self.cell.values() if regions[own] == place}
            bounded = cells - self.open_cells
            arcs_here = int((arcs[self.front[self.drawn]] == place).sum())
            made.append(
                Pieces(
                    int((self.is_vertex & (vertices == place)).sum()),
                    arcs_here - int((self.passed & (vertices == place)).sum()),
                    len(cells),
                    len(bounded),
                    dict(sorted(Counter(self.edges[own] for own in bounded).items())),
                )
            )
        return made

    def all_pieces(self) -> Pieces:
        """Count what is anywhere."""
        return self.pieces(*(np.zeros(len(signs), np.int8) for signs in self.signs))[0]
