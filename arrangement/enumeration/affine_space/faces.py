"""All faces of an arrangement of planes in R^3 at scale: the public class."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import cached_property, partial
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement import linear
from arrangement.enumeration import great_circles
from arrangement.enumeration.sequence import Level, Rows, rational_points
from arrangement.errors import InputError
from arrangement.planes import Planes

from .exact_points import edge_point, vertex_point
from .faces_around_lines import Faces, faces_around
from .lines import Lines, trace_lines
from .packing import Words, unit_words, unpack
from .predicates import Numbers, PlaneTable, Signs
from .witnesses import interior_points

Point: TypeAlias = tuple[Fraction, Fraction, Fraction]


class SpaceFaces:
    """The faces of dimension 1, 2 and 3 of an arrangement in R^3, as arrays of signs.

    Made by `space_faces`. A sign vector here has one entry for each class of coincident planes, in
    the order of `Arrangement.distinct`: the sign of ``n . x - b`` for the first plane of the class.
    `plane_signs` translates to the input planes. The order of the faces is the same for the same
    input, and means nothing. Arrays are computed when first used, and read-only.

    Attributes:
        arrangement: the input.
        classes: the number of classes of coincident planes.
    """

    def __init__(self, arrangement: Planes) -> None:
        self.arrangement = arrangement
        self.classes = len(arrangement.distinct)
        rows = [arrangement.integer_planes[members[0]] for members in arrangement.distinct]
        self._table = PlaneTable(rows)

    @cached_property
    def _lines(self) -> Lines:
        return trace_lines(self._table)

    @cached_property
    def _faces(self) -> Faces:
        return faces_around(self._table, self._lines)

    @cached_property
    def edges(self) -> Signs:
        """The faces of dimension 1: (count, classes) signs."""
        return _frozen(self._edges(slice(None)))

    @cached_property
    def facets(self) -> Signs:
        """The faces of dimension 2: (count, classes) signs, 0 for exactly one class."""
        return _frozen(self._facets(slice(None)))

    @cached_property
    def regions(self) -> Signs:
        """The faces of dimension 3: (count, classes) signs."""
        return _frozen(self._regions(slice(None)))

    def edges_between(self, classes: Sequence[int]) -> Signs:
        """Return those `edges` whose line lies in at least two of some classes."""
        chosen = self._lines.through[:, classes].sum(axis=1) >= 2
        return self._edges(np.flatnonzero(chosen[self._lines.line]))

    def facets_on(self, classes: Sequence[int]) -> Signs:
        """Return those `facets` that lie in one of some classes."""
        return self._facets(np.flatnonzero(np.isin(self._faces.on, classes)))

    def _vertices(self, rows: Rows) -> Signs:
        lower = self._faces.vertices[rows]
        signs = _signs(self._lines.words[lower], self.classes)
        signs[signs != _signs(self._lines.words[lower + 1], self.classes)] = 0
        signs[self._lines.through[self._lines.line[lower]]] = 0
        return signs

    def _edges(self, rows: Rows) -> Signs:
        signs = _signs(self._lines.words[rows], self.classes)
        signs[self._lines.through[self._lines.line[rows]]] = 0
        return signs

    def _facets(self, rows: Rows) -> Signs:
        signs = _signs(self._faces.facets[rows], self.classes)
        signs[np.arange(len(signs)), self._faces.on[rows]] = 0
        return signs

    def _regions(self, rows: Rows) -> Signs:
        return _signs(self._faces.regions[rows], self.classes)

    @cached_property
    def f_vector(self) -> tuple[int, int, int, int]:
        """The number of faces of dimension 0, 1, 2, 3, each counted on its own.

        Vertices are counted as the different sets of classes that meet at crossings.
        """
        faces = self._faces
        edges, facets, regions = self._lines.words, faces.facets, faces.regions
        return len(faces.vertices), len(edges), len(facets), len(regions)

    def __repr__(self) -> str:
        return f"<SpaceFaces: {self.classes} distinct planes, f-vector {self.f_vector}>"

    def plane_signs(self, signs: Signs) -> Signs:
        """Return sign vectors over the input planes, from ones over their classes."""
        columns = np.array(self.arrangement.class_of, np.intp)
        orientation = np.array(self.arrangement.orientation, np.int8)
        if np.array_equal(columns, np.arange(self.classes)):
            return signs  # no two planes coincide
        translated: Signs = signs[:, columns] * orientation
        return translated

    @cached_property
    def _witnesses(self) -> Numbers:
        return interior_points(self._table, self._lines, self._faces)

    def levels(self) -> tuple[Level, ...]:
        """Return the faces of dimension 0 to 3 with their signs over the input planes."""
        signs = (self._vertices, self._edges, self._facets, self._regions)
        points = (self._vertex_points, self._edge_points, self._facet_points, self._region_points)
        return tuple(
            Level(count, partial(self._over_planes, of), at)
            for count, of, at in zip(self.f_vector, signs, points, strict=True)
        )

    def _over_planes(self, signs: Callable[[Rows], Signs], rows: Rows) -> Signs:
        return self.plane_signs(signs(rows))

    def _vertex_points(self, rows: Rows) -> Numbers:
        segments = self._faces.vertices[rows].tolist()
        return _points(vertex_point(self._table, self._lines, e) for e in segments)

    def _edge_points(self, rows: Rows) -> Numbers:
        segments = np.arange(len(self._lines.line))[rows].tolist()
        return _points(edge_point(self._table, self._lines, e) for e in segments)

    def _facet_points(self, rows: Rows) -> Numbers:
        """Return where the segments between points of the regions on both sides meet the planes.

        Their signs differ in one plane only. With heights a > 0 > b of points P and Q over it, in
        homogeneous coordinates, ``a Q - b P`` is on it.
        """
        below, on = self._faces.facets[rows], self._faces.on[rows]
        above = below | unit_words(self.classes)[on]
        planes = self._table.exact[on] * np.array([1, 1, 1, -1], object)
        p, q = (self._witnesses[self._place(side)].astype(object) for side in (above, below))
        heights = ((planes * end).sum(axis=1, keepdims=True) for end in (p, q))
        a, b = heights
        return _points(map(linear.reduced, (a * q - b * p).tolist()))

    def _region_points(self, rows: Rows) -> Numbers:
        return self._witnesses[rows]

    @cached_property
    def _region_of(self) -> dict[bytes, int]:
        return {row.tobytes(): i for i, row in enumerate(self._faces.regions)}

    def _place(self, regions: Words) -> list[int]:
        """Return the rows of regions, given by the classes with sign +."""
        return [self._region_of[row.tobytes()] for row in regions]

    def integer_witnesses(self) -> Numbers:
        """Return (count, 4) integers (X, Y, Z, W), W > 0: a point (X, Y, Z) / W of each region.

        int64 where all fit, else Python integers. Every point is proven to lie inside its region
        (see `witnesses`). The rows are in the order of `regions`. The points are
        short binary fractions where floats find them; another machine may find other ones.
        """
        points = self._witnesses.view()
        points.flags.writeable = False
        return points

    def witnesses(self) -> list[Point]:
        """Return an exact point inside each region, in the order of `regions`."""
        return [(x, y, z) for x, y, z in rational_points(self.integer_witnesses())]


class _FewDirections(SpaceFaces):
    """The same for normals of rank 2 or less, from great circles; there is no vertex then."""

    def __init__(self, arrangement: Planes) -> None:
        self.arrangement = arrangement
        self.classes = len(arrangement.distinct)
        self._first = [members[0] for members in arrangement.distinct]
        self._levels = great_circles.list_faces(arrangement)

    def _edges(self, rows: Rows) -> Signs:
        return self._levels[1].signs(rows)[:, self._first]

    def _facets(self, rows: Rows) -> Signs:
        return self._levels[2].signs(rows)[:, self._first]

    def _regions(self, rows: Rows) -> Signs:
        return self._levels[3].signs(rows)[:, self._first]

    def edges_between(self, classes: Sequence[int]) -> Signs:
        chosen: Signs = self.edges[(self.edges[:, classes] == 0).sum(axis=1) >= 2]
        return chosen

    def facets_on(self, classes: Sequence[int]) -> Signs:
        chosen: Signs = self.facets[(self.facets[:, classes] == 0).any(axis=1)]
        return chosen

    @cached_property
    def f_vector(self) -> tuple[int, int, int, int]:
        f0, f1, f2, f3 = (level.count for level in self._levels)
        return f0, f1, f2, f3

    @cached_property
    def _witnesses(self) -> Numbers:
        return self._levels[3].points(slice(None))


def space_faces(arrangement: Planes) -> SpaceFaces:
    """Return the faces of an arrangement in R^3, of any rank, central or affine.

    Exact for every input: coincident and parallel planes, pencils, many planes through one point,
    entries of any size. Floats only propose; each decision is certified or taken by integers.

    Raises:
        InputError: the dimension is not 3.

    Complexity: O(n^3) faces for n planes; O(n^3 log n) time and O(n^3) memory. The constants are
    those of numpy, unless so many determinants vanish or nearly vanish that integers decide most.

    >>> from arrangement import Arrangement
    >>> faces = space_faces(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], [0, 0, 0, 1]))
    >>> faces.f_vector
    (4, 18, 28, 15)
    """
    if arrangement.dimension != 3:
        raise InputError(
            f"the arrangement is in R^{arrangement.dimension}; this engine works in R^3 only; "
            "use Arrangement.faces"
        )
    return SpaceFaces(arrangement) if arrangement.rank == 3 else _FewDirections(arrangement)


def _signs(words: Words, classes: int) -> Signs:
    """Return +1 where a bit is set, else -1."""
    signs = unpack(words, classes).view(np.int8)
    signs *= 2
    signs -= 1
    return signs


def _frozen(signs: NDArray[np.int8]) -> Signs:
    signs.flags.writeable = False
    return signs


def _points(rows: Iterable[Sequence[int]]) -> Numbers:
    listed = list(rows)
    points = np.empty((len(listed), 4), object)
    points[...] = np.array(listed, object).reshape(-1, 4)
    return points
