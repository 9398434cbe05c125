"""Faces of planes of rank 3: around lines, all of them, and points inside.

If the normals have rank 3, no facet or region contains a line. So every facet has two edges or
more, and every region two facets or more: facets are found around the segments, and regions on
both sides of the facets, each from all of its boundary.

Around a line with direction D and k planes through it there are 2k half planes. That of class j on
side s = +1 or -1 leaves the line along ``s n_j x D``; there class l, another of the k, has sign
``s sign det(n_l, n_j, D)``.

A point is a row (X, Y, Z, W) of integers, W > 0, and stands for (X, Y, Z) / W. The sum of two rows
is a weighted mean of their points. That of two edges of a facet is inside the facet, and that of
two facets of a region inside the region.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from arrangement.enumeration import great_circles
from arrangement.enumeration.affine_space.lines import Lines, trace_lines
from arrangement.enumeration.affine_space.predicates import Indices, PlaneTable, minors
from arrangement.enumeration.reduction import from_dimension, in_dimension, joined
from arrangement.enumeration.sequence import Level, Rows, Signs, no_faces, primitive_rows
from arrangement.numbers.coefficients import Integers
from arrangement.numbers.exact import dot, largest
from arrangement.numbers.linear.rank import cut, unit_vectors
from arrangement.numbers.packing import Words, distinct_rows, grouped, pack, unit_words, unpack
from arrangement.planes.planes import Planes


@dataclass(frozen=True, slots=True)
class Faces:
    """The faces of dimension 0, 2 and 3, as bits over the classes.

    Attributes:
        vertices: (V); for each vertex one segment whose upper end it is.
        facets, on: (F, W) and (F); the classes with sign +, and the class with sign 0.
        facet_edges: (F, 2); two segments in the boundary of each facet.
        regions: (R, W); the classes with sign +.
        region_facets: (R, 2); two facets in the boundary of each region.
    """

    vertices: Indices
    facets: Words
    on: Indices
    facet_edges: Indices
    regions: Words
    region_facets: Indices


def faces_around(table: PlaneTable, lines: Lines) -> Faces:
    """Return the faces at the segments.

    Complexity: O(n^3 log n) time and O(n^3) memory for n planes.
    """
    sizes = lines.through.sum(axis=1)[lines.line]
    parts = [
        _around_segments(table, lines, np.flatnonzero(sizes == k), k)
        for k in sorted(set(sizes.tolist()))
    ]
    facets, on, edge = map(np.concatenate, zip(*parts, strict=True))
    one, other = _found_twice(np.column_stack([facets, on.astype(np.uint64)]))
    facets, on, edges = facets[one], on[one], np.stack([edge[one], edge[other]], axis=1)
    regions = np.concatenate([facets, facets | unit_words(len(table))[on]])
    one, other = _found_twice(regions)
    sides = np.stack([one, other], axis=1) % len(facets)
    return Faces(_vertices(lines), facets, on, edges, regions[one], sides)


def _found_twice(rows: Words) -> tuple[Indices, Indices]:
    """Return the places of two copies of each different row; every row has two or more."""
    order, new = grouped(rows)
    first = np.flatnonzero(new)
    return order[first], order[first + 1]


def _vertices(lines: Lines) -> Indices:
    """Return, for each vertex, one segment whose upper end it is.

    A vertex is determined by the planes through it: those of a line, and those that change sign.
    """
    lower = np.flatnonzero(lines.upper >= 0)
    changing = lines.words[lower] ^ lines.words[lower + 1]
    return lower[distinct_rows(pack(lines.through)[lines.line[lower]] | changing)]


def _around_segments(
    table: PlaneTable, lines: Lines, edge: Indices, k: int
) -> tuple[Words, Indices, Indices]:
    """Return all facets at segments of lines in k planes, as words, class, and segment.

    ``n_l x n_j`` is a multiple of D, so ``det(n_l, n_j, D)`` has the sign of the product of both in
    one coordinate. The first two members of a line define its D.
    """
    numbers, place = np.unique(lines.line[edge], return_inverse=True)
    members = np.nonzero(lines.through[numbers])[1].reshape(-1, k)
    base = table.turn[members[:, 0], members[:, 1]][:, None, None]
    det = table.turn[members[:, :, None], members[:, None, :]] * base
    units = unit_words(len(table))[members][:, :, None, :]
    half = [np.bitwise_or.reduce(units * (s * det > 0)[..., None], axis=1) for s in (1, -1)]
    words = lines.words[edge][:, None, :] | np.hstack(half)[place]
    plane = np.hstack([members, members])[place]
    return words.reshape(-1, words.shape[2]), plane.ravel(), np.repeat(edge, 2 * k)


class Points:
    """Points of chosen faces; int64 where that is proven to be exact, else Python integers.

    For entries up to B, a vertex has entries up to 6 B^3, and a region is the sum of 8 vertices.
    """

    def __init__(self, table: PlaneTable, lines: Lines, faces: Faces) -> None:
        fits = 48 * largest(table.exact.tolist()) ** 3 < 2**63
        self._planes = table.exact.astype(np.int64 if fits else object)
        self._lines = lines
        self._faces = faces

    def vertices(self, rows: Indices) -> Integers:
        """Return the vertices themselves."""
        return self._upper_ends(self._faces.vertices[rows])

    def edges(self, segments: Indices) -> Integers:
        """Return points between the ends of segments, or a step away from the only end."""
        upper = self._lines.upper
        above, below = upper[segments] >= 0, upper[segments - 1] >= 0  # the last one is unbounded
        found = np.zeros((len(segments), 4), self._planes.dtype)
        found[above] += self._upper_ends(segments[above])
        found[below] += self._upper_ends(segments[below] - 1)
        step = primitive_rows(self._minors(segments)[:, :3])
        found[:, :3] += (below.astype(int) - above)[:, None] * step
        return found

    def facets(self, rows: Indices) -> Integers:
        """Return points inside facets."""
        one, other = self._faces.facet_edges[rows].T
        return self.edges(one) + self.edges(other)

    def regions(self, rows: Indices) -> Integers:
        """Return points inside regions."""
        one, other = self._faces.region_facets[rows].T
        return self.facets(one) + self.facets(other)

    def _minors(self, segments: Indices) -> Integers:
        line = self._lines.line[segments]
        return minors(self._planes[self._lines.first[line]], self._planes[self._lines.second[line]])

    def _upper_ends(self, segments: Indices) -> Integers:
        """Return the vertex P, where row k meets the line: ``(b_k D + n_k x M) / (n_k . D)``.

        On the line, ``M = n_i (n_j . P) - n_j (n_i . P) = P x D``; at the vertex
        ``n_k x (P x D) = P (n_k . D) - D b_k``.
        """
        direction, moment = np.split(self._minors(segments), 2, axis=1)
        normal, offset = np.split(self._planes[self._lines.upper[segments]], [3], axis=1)
        scale = (normal * direction).sum(axis=1, keepdims=True)
        point = np.hstack([offset * direction + np.cross(normal, moment), scale])
        return primitive_rows(np.where(scale < 0, -point, point))


#: From chosen faces to the classes with sign +, and to those with sign 0, whose + does not count.
_Sides: TypeAlias = Callable[[Indices], tuple[Words, Words]]


def space_levels(planes: Planes) -> tuple[Level, ...]:
    """Return the faces of dimension 0 to 3 of planes of rank 3 in R^3.

    Exact for every input: coincident and parallel planes, pencils, many planes through one point,
    entries of any size. Floats only propose; each decision is certified or taken by integers.

    Complexity: O(n^3) faces for n planes; O(n^3 log n) time and O(n^3) memory. The constants are
    those of numpy, unless so many determinants vanish or nearly vanish that integers decide most.
    """
    table = PlaneTable(planes.distinct_planes)
    lines = trace_lines(table)
    faces = faces_around(table, lines)
    points = Points(table, lines, faces)
    words, through, units = lines.words, pack(lines.through), unit_words(len(table))
    columns, orientation = np.array(planes.class_of), np.array(planes.orientation, np.int8)

    def vertices(rows: Indices) -> tuple[Words, Words]:
        below = faces.vertices[rows]
        return words[below], words[below] ^ words[below + 1] | through[lines.line[below]]

    def level(count: int, sides: _Sides, inside: Callable[[Indices], Integers]) -> Level:
        def signs(rows: Rows) -> Signs:
            positive, zero = sides(np.arange(count)[rows])
            found = 2 * unpack(positive, len(table)).view(np.int8) - 1
            found[unpack(zero, len(table))] = 0
            return found[:, columns] * orientation

        return Level(count, signs, lambda rows: inside(np.arange(count)[rows]))

    return (
        level(len(faces.vertices), vertices, points.vertices),
        level(len(words), lambda rows: (words[rows], through[lines.line[rows]]), points.edges),
        level(
            len(faces.facets),
            lambda rows: (faces.facets[rows], units[faces.on[rows]]),
            points.facets,
        ),
        level(
            len(faces.regions),
            lambda rows: (faces.regions[rows], np.zeros_like(faces.regions[rows])),
            points.regions,
        ),
    )


def list_faces(planes: Planes) -> tuple[Level, ...]:
    """Return the faces of dimension 0, 1, ..., d of planes of rank 3, or central ones of rank 4."""
    if planes.rank == 3:
        reduced, columns = in_dimension(planes, 3)
        return from_dimension(space_levels(reduced), planes, columns)
    reduced, columns = in_dimension(planes, 4)
    return from_dimension(_central_levels(reduced), planes, columns)


def _central_levels(planes: Planes) -> tuple[Level, ...]:
    """Return the faces of central planes of rank 4 in R^4, with the first plane at infinity.

    With coordinates (y, w) such that the first plane is w = 0, its positive side is the cone over
    affine planes in the space of y, its negative side the antipode of that, and the first plane
    itself has central planes of rank 3.
    """
    normals = [plane[:-1] for plane in planes.integer_planes]
    pivot = next(i for i, x in enumerate(normals[0]) if x)
    beside = tuple(x if normals[0][pivot] > 0 else -x for x in unit_vectors(4)[pivot])
    basis = [*cut(unit_vectors(4), normals[0]), beside]
    at_infinity = np.array(planes.class_of) == 0
    others = np.flatnonzero(~at_infinity)
    rows = [[dot(normals[i], vector) for vector in basis] for i in others]
    affine = Planes([row[:3] for row in rows], [-row[3] for row in rows])
    half = space_levels(affine)
    flat = great_circles.list_faces(Planes([row[:3] for row in rows]))
    sides = np.where(at_infinity, planes.orientation, 0).astype(np.int8)

    def lifted(level: Level, side: int) -> Level:
        """Return faces in R^4 on one side of the first plane, or on it."""

        def signs(rows: Rows) -> Signs:
            found = level.signs(rows)
            whole = np.repeat(side * sides[None], len(found), axis=0)
            whole[:, others] = found * (side or 1)
            return whole

        def points(rows: Rows) -> Integers:
            found = level.points(rows).astype(object)
            if not side:
                found[:, -1] = 0
            found = (side or 1) * (found @ np.array(basis, object))
            return np.hstack([found, np.ones((len(found), 1), object)])

        return Level(level.count, signs, points)

    nothing = no_faces(len(planes), 4)
    by_side = (
        [nothing, *(lifted(level, 1) for level in half)],
        [nothing, *(lifted(level, -1) for level in half)],
        [*(lifted(level, 0) for level in flat), nothing],
    )
    return tuple(map(joined, zip(*by_side, strict=True)))
