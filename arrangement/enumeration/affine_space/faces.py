"""All faces of an arrangement of planes in R^3 at scale: the public class."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.enumeration.any_dimension import enumerate_faces
from arrangement.errors import InputError
from arrangement.exact import primitive
from arrangement.planes import Face, Planes

from .faces_around_lines import Faces, faces_around
from .lines import Lines, trace_lines
from .packing import Words, unpack
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
        signs = _signs(self._lines.words, self.classes)
        signs[self._lines.through[self._lines.line]] = 0
        return _frozen(signs)

    @cached_property
    def facets(self) -> Signs:
        """The faces of dimension 2: (count, classes) signs, 0 for exactly one class."""
        signs = _signs(self._faces.facets, self.classes)
        signs[np.arange(len(signs)), self._faces.on] = 0
        return _frozen(signs)

    @cached_property
    def regions(self) -> Signs:
        """The faces of dimension 3: (count, classes) signs."""
        return _frozen(_signs(self._faces.regions, self.classes))

    def edges_between(self, classes: Sequence[int]) -> Signs:
        """Return those `edges` whose line lies in at least two of some classes."""
        chosen = self._lines.through[:, classes].sum(axis=1) >= 2
        kept = chosen[self._lines.line]
        signs = _signs(self._lines.words[kept], self.classes)
        signs[self._lines.through[self._lines.line[kept]]] = 0
        return signs

    def facets_on(self, classes: Sequence[int]) -> Signs:
        """Return those `facets` that lie in one of some classes."""
        kept = np.isin(self._faces.on, classes)
        signs = _signs(self._faces.facets[kept], self.classes)
        signs[np.arange(len(signs)), self._faces.on[kept]] = 0
        return signs

    @cached_property
    def f_vector(self) -> tuple[int, int, int, int]:
        """The number of faces of dimension 0, 1, 2, 3, each counted on its own.

        Vertices are counted as the different sets of classes that meet at crossings.
        """
        faces = self._faces
        edges, facets, regions = self._lines.words, faces.facets, faces.regions
        return faces.vertices, len(edges), len(facets), len(regions)

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
        known = _Quotients()
        return [
            (known[x, w], known[y, w], known[z, w])
            for x, y, z, w in self.integer_witnesses().tolist()
        ]


class _FewDirections(SpaceFaces):
    """The same for normals of rank 2 or less, from the engine for every dimension.

    There is no vertex then, and at most O(n^2) faces.
    """

    def __init__(self, arrangement: Planes) -> None:
        self.arrangement = arrangement
        self.classes = len(arrangement.distinct)

    def _level(self, dimension: int) -> Signs:
        first = [members[0] for members in self.arrangement.distinct]
        found = enumerate_faces(self.arrangement)[dimension]
        signs = np.array([face.signs for face in found], np.int8)
        return _frozen(signs.reshape(len(found), len(self.arrangement))[:, first])

    @cached_property
    def edges(self) -> Signs:
        return self._level(1)

    @cached_property
    def facets(self) -> Signs:
        return self._level(2)

    @cached_property
    def regions(self) -> Signs:
        return self._level(3)

    def edges_between(self, classes: Sequence[int]) -> Signs:
        chosen: Signs = self.edges[(self.edges[:, classes] == 0).sum(axis=1) >= 2]
        return chosen

    def facets_on(self, classes: Sequence[int]) -> Signs:
        chosen: Signs = self.facets[(self.facets[:, classes] == 0).any(axis=1)]
        return chosen

    @cached_property
    def f_vector(self) -> tuple[int, int, int, int]:
        f0, f1, f2, f3 = map(len, enumerate_faces(self.arrangement))
        return f0, f1, f2, f3

    @cached_property
    def _witnesses(self) -> Numbers:
        return _homogeneous(enumerate_faces(self.arrangement)[3])


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


class _Quotients(dict[tuple[int, int], Fraction]):
    """Quotients of integers, each made once: short ones come again and again."""

    def __missing__(self, pair: tuple[int, int]) -> Fraction:
        return self.setdefault(pair, Fraction(*pair))


def _signs(words: Words, classes: int) -> Signs:
    """Return +1 where a bit is set, else -1."""
    signs = unpack(words, classes).view(np.int8)
    signs *= 2
    signs -= 1
    return signs


def _frozen(signs: NDArray[np.int8]) -> Signs:
    signs.flags.writeable = False
    return signs


def _homogeneous(regions: Iterable[Face]) -> Numbers:
    """Return the witnesses of faces as integer rows (X, Y, Z, W)."""
    rows = [primitive((*face.witness, Fraction(1))) for face in regions]
    points = np.empty((len(rows), 4), dtype=object)
    points[...] = np.array(rows, dtype=object).reshape(-1, 4)
    return points
