"""The vertices, facets and regions around the segments of the lines.

If the normals have rank 3, no facet or region contains a line. So every facet has two edges or
more, and every region two facets or more: facets are found around the segments, and regions on
both sides of the facets, each from all of its boundary.

Around a line with direction D and k planes through it there are 2k half planes. That of class j on
side s = +1 or -1 leaves the line along ``s n_j x D``; there class l, another of the k, has sign
``s sign det(n_l, n_j, D)``.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from arrangement.enumeration.packing import Words, distinct_rows, grouped, pack, unit_words

from .lines import Lines
from .predicates import Indices, PlaneTable


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
        for k in np.unique(sizes).tolist()
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
