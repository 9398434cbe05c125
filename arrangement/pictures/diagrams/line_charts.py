"""Lines of the plane on paper: cut to a window, or whole, with the line at infinity as a rim.

Both come from the great circles of the cone over the lines, cut at the line at infinity. So which
faces there are, which of them are bounded, and what the window cuts, is exact.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.flat_polygons import between, clipped
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive, sign
from arrangement.numbers.linear.rank import cycle_edges
from arrangement.pictures.sphere.globe import Globe, region_signs, sign_vectors
from arrangement.pictures.sphere.projections import Drawn, stereographic

from .line_window import ABOVE, LineWindow, cone


class LinesChart:
    """The faces of lines of R^2 that are not at infinity, as points of the plane.

    Places are those of the plane, moved and scaled so that the window has its middle at 0 and
    most vertices are at a distance below 1.

    Attributes:
        lines: the arrangement.
        half: exact half sides of the window.
        left_out: how many far crossings the window leaves out.
        globe: the great circles of the cone, with the same coordinates, cut at the limb, which is
            the line at infinity.
    """

    def __init__(self, lines: Arrangement, window: Sequence[RationalVector] = ()) -> None:
        """Take lines, and opposite corners of the window, if it is not to be chosen."""
        self.lines = lines
        chosen = LineWindow.between(lines, window) if window else LineWindow.of(lines)
        self.left_out, unit = chosen.left_out, chosen.unit
        self.half = [x / unit for x in chosen.half]
        self.globe = Globe(cone(lines, chosen.middle, unit), ABOVE)
        self.sphere, self.incidence = self.globe.cut, self.globe.cut.incidence

    @cached_property
    def regions(self) -> dict[int, tuple[int, ...]]:
        """The sign vectors of the regions, by their numbers on the sphere."""
        found = region_signs(self.sphere)
        return {r: signs[:-1] for r, signs in enumerate(found) if signs[-1] > 0}

    @cached_property
    def edges(self) -> dict[int, tuple[int, ...]]:
        """The sign vectors of the edges, by their numbers on the sphere."""
        found = sign_vectors(self.sphere, self.sphere.packed_arc_signs)
        return {a: signs[:-1] for a, signs in enumerate(found) if signs[-1] > 0}

    @cached_property
    def vertices(self) -> dict[int, tuple[int, ...]]:
        """The sign vectors of the vertices, by their numbers on the sphere."""
        found = sign_vectors(self.sphere, self.sphere.packed_vertex_signs)
        return {v: signs[:-1] for v, signs in enumerate(found) if signs[-1] > 0}

    @cached_property
    def parallels(self) -> list[int]:
        """The points at infinity, on the sphere, in which two or more lines meet."""
        ends = self.incidence.crossings(self.globe.limb).tolist() if self.lines.rank else []
        return [v for v in ends if len(self.incidence.circles_at(v)) > 2]

    @cached_property
    def bounded(self) -> set[tuple[int, ...]]:
        """The sign vectors of the bounded regions: those without a vertex at infinity."""
        ends = {r: self.incidence.origin[self._boundary(r)].tolist() for r in self.regions}
        return {
            self.regions[r]
            for r, cycle in ends.items()
            if cycle and self.vertices.keys() >= {*cycle}
        }

    @cached_property
    def sides(self) -> dict[tuple[int, ...], int]:
        """The number of edges of each region."""
        edges = self.edges.keys()
        return {
            signs: len(edges & set((self._boundary(r) >> 1).tolist()))
            for r, signs in self.regions.items()
        }

    def _boundary(self, region: int) -> np.ndarray[tuple[int], np.dtype[np.int32]]:
        return self.incidence.boundary(region) if self.lines.rank else np.empty(0, np.int32)

    # In the window

    @cached_property
    def corners(self) -> list[IntegerVector]:
        """The homogeneous corners of the window, counter-clockwise."""
        x, y = self.half
        turns = ((-1, -1), (1, -1), (1, 1), (-1, 1))
        return [primitive((s * x, t * y, Fraction(1))) for s, t in turns]

    def outline(self, region: int) -> Floats:
        """Return the corners of the part of a region in the window."""
        return _places(self._clipped(self.corners, region))

    def edge(self, arc: int) -> Floats:
        """Return the ends of the part of an edge in the window, (2, 2)."""
        ends = self._ends(int(self.incidence.arc_circle[arc]))
        return _places(dict.fromkeys(self._clipped(ends, int(self.incidence.region[2 * arc]))))

    def vertex(self, vertex: int) -> Floats:
        """Return the place of a vertex."""
        x, y, w = self.sphere.ray(vertex)
        return np.array([x / w, y / w])

    def line(self, label: int) -> Floats:
        """Return the ends of a class of lines at the boundary of the window, (2, 2)."""
        return _places(self._ends(label))

    def _ends(self, circle: int) -> list[IntegerVector]:
        row, found = self.sphere.circle_normals[circle], []
        for p, q in cycle_edges(self.corners):
            at_p, at_q = dot(row, p), dot(row, q)
            if at_p == 0:
                found.append(p)
            elif at_p * at_q < 0:
                found.append(between(p, q, at_p, at_q))
        return found

    def _clipped(self, loop: list[IntegerVector], region: int) -> list[IntegerVector]:
        """Return the part of a convex polygon of homogeneous points in the closure of a region."""
        inside = self.sphere.region_witness(region)
        circles = self.incidence.arc_circle[self._boundary(region) >> 1].tolist()
        for row in (self.sphere.circle_normals[circle] for circle in circles):
            side = sign(dot(row, inside))
            loop = clipped(loop, [side * dot(row, p) for p in loop])
        return loop

    # Whole

    @property
    def drawn(self) -> Drawn:
        """Arcs and regions of the half sphere as circular arcs in a disc."""
        return Drawn(self.sphere, self.globe.points, self.globe.normals, stereographic)


def _places(points: Iterable[IntegerVector]) -> Floats:
    return np.array([[x / w, y / w] for x, y, w in points]).reshape(-1, 2)
