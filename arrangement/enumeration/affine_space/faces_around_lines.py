"""The vertices, facets and regions around the segments of the lines.

*Up* is the lexicographic order of points: (x, y, z) is above (x', y', z') if the first coordinate
that differs is larger. For finitely many edges this is the order of one generic linear function.
If the normals have rank 3, no facet or region contains a line. So it either has a lowest vertex,
and all its edges there lead up, or it has an unbounded edge that leads down, since its directions
of recession are the sums of those of its unbounded edges. Hence all are found at

1. *simple vertices*, where exactly three planes meet: one region has it as its lowest vertex, and
   so has one facet on each plane;
2. segments that lead up from any other vertex, and segments unbounded downwards: all facets and
   regions around them are taken.

Around a line with direction D and k planes through it there are 2k half planes. That of class j on
side s = +1 or -1 leaves the line along ``s n_j x D``; there class l, another of the k, has sign
``s sign det(n_l, n_j, D)``. Counterclockwise of it begins a region, where class j has sign s. Every
region around the line follows exactly one half plane.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from .lines import Lines
from .packing import Bits, Words, distinct_labelled, distinct_rows, pack, unit_words
from .predicates import Indices, PlaneTable, Signs

#: (..., 2) half planes that bound a region at a segment, as ``s (j + 1)`` for class j and side s.
Wedges: TypeAlias = NDArray[np.int32]


@dataclass(frozen=True, slots=True)
class Faces:
    """The faces of dimension 0, 2 and 3, as bits over the classes.

    Attributes:
        vertices: (V); for each vertex one segment whose upper end it is.
        facets, on: (F, W) and (F); the classes with sign +, and the class with sign 0.
        regions: (R, W); the classes with sign +.
        edge, wedge: (R) and (R, 2); one segment in the boundary of each region, and the two half
            planes there between which the region lies.
    """

    vertices: Indices
    facets: Words
    on: NDArray[np.int64]
    regions: Words
    edge: Indices
    wedge: Wedges


@dataclass(frozen=True, slots=True)
class _Found:
    """Facets and regions, with repetitions; the attributes are those of `Faces`."""

    facets: Words
    on: NDArray[np.int64]
    regions: Words
    edge: Indices
    wedge: Wedges


def faces_around(table: PlaneTable, lines: Lines) -> Faces:
    """Return the faces at the segments.

    Complexity: O(n^3 log n) time and O(n^3) memory for n planes.
    """
    below, unbounded = _lower_ends(table, lines)
    simple = lines.single[below] & ~unbounded
    new = simple & (lines.upper[below] > lines.second[lines.line])
    parts = [_at_simple_vertices(table, lines, np.nonzero(new)[0], below)]
    parts += _around_segments(table, lines, np.nonzero(~simple)[0])
    regions = np.concatenate([part.regions for part in parts])
    first = distinct_rows(regions)
    facets, label = distinct_labelled(
        np.concatenate([part.facets for part in parts]),
        np.concatenate([part.on for part in parts]),
        len(table),
    )
    return Faces(
        np.concatenate([below[new], _crowded_vertices(lines)]),
        facets,
        label.astype(np.int64),
        regions[first],
        np.concatenate([part.edge for part in parts])[first],
        np.concatenate([part.wedge for part in parts])[first],
    )


def _lower_ends(table: PlaneTable, lines: Lines) -> tuple[Indices, Bits]:
    """Return, for each segment, the one that ends (along D) in its lowest point; and if none is."""
    up = table.turn[lines.first, lines.second][lines.line] > 0
    last = lines.upper < 0
    first = np.roll(last, 1)
    return np.arange(len(up)) - up, np.where(up, first, last)


def _crowded_vertices(lines: Lines) -> Indices:
    """Return, for each vertex on more than three planes, one segment whose upper end it is.

    A vertex is determined by the planes through it: those of a line, and those that change sign.
    """
    lower = np.nonzero(~lines.single & (lines.upper >= 0))[0]
    changing = lines.words[lower] ^ lines.words[lower + 1]
    return lower[distinct_rows(pack(lines.through)[lines.line[lower]] | changing)]


def _at_simple_vertices(table: PlaneTable, lines: Lines, edge: Indices, below: Indices) -> _Found:
    """Return the region and the three facets that are lowest at vertices where segments begin.

    Let planes i, j, k meet there and ``u_ij`` lead up on the line of i and j. The region lies on
    the side of plane k to which ``u_ij`` leads, and so on. With ``u_ij = turn_ij D_ij``, that side
    of plane i is ``turn_jk D3(j, k, i)``, and ``D3(j, k, i) = D3(i, j, k)`` has the sign
    ``turn_ij`` times the side of k on the segment of i and j.
    """
    units = unit_words(len(table))
    line = lines.line[edge]
    i, j, k = lines.first[line], lines.second[line], lines.upper[below[edge]]
    words = lines.words[edge]
    side = np.where((words & units[k]).any(axis=1), table.turn[i, j], -table.turn[i, j])
    on_i: Signs = side * table.turn[j, k]
    on_j: Signs = side * table.turn[k, i]
    regions = words | units[i] * (on_i > 0)[:, None] | units[j] * (on_j > 0)[:, None]
    facets = np.concatenate([regions & ~units[at] for at in (i, j, k)])
    wedge = np.stack([on_i * (j + 1), -on_j * (i + 1)], axis=1).astype(np.int32)
    return _Found(facets, np.concatenate([i, j, k]), regions, edge, wedge)


def _around_segments(table: PlaneTable, lines: Lines, edges: Indices) -> Iterator[_Found]:
    """Yield all facets and regions around some segments, for one number k of planes at a time."""
    units = unit_words(len(table))
    sizes = lines.through.sum(axis=1)[lines.line[edges]]
    for k in np.unique(sizes).tolist():
        edge = edges[sizes == k]
        numbers, place = np.unique(lines.line[edge], return_inverse=True)
        members = np.nonzero(lines.through[numbers])[1].reshape(-1, k)
        plane, side = _half_planes(table, members)
        half = _signs_on_half_planes(table, members, plane, side)
        beyond = half | units[plane] * (side > 0)[..., None]
        wedge = (plane + 1) * side
        wedges = np.stack([wedge, np.roll(wedge, -1, axis=1)], axis=2).astype(np.int32)
        words = lines.words[edge][:, None, :]
        yield _Found(
            (words | half[place]).reshape(-1, words.shape[2]),
            plane[place].ravel(),
            (words | beyond[place]).reshape(-1, words.shape[2]),
            np.repeat(edge, 2 * k),
            wedges[place].reshape(-1, 2),
        )


def _determinants(table: PlaneTable, members: Indices, left: Indices, right: Indices) -> Signs:
    """Return the signs of ``det(n_left, n_right, D)`` for planes through common lines.

    ``n_left x n_right`` is a multiple of D, so that sign is the product of the signs of both in one
    coordinate. The first two members of a line define its D.
    """
    base = table.turn[members[:, 0], members[:, 1]]
    found: Signs = table.turn[left, right] * base[:, None, None]
    return found


def _half_planes(table: PlaneTable, members: Indices) -> tuple[Indices, Signs]:
    """Return planes and sides, (L, 2k) each, of the half planes counterclockwise around lines.

    The first half turn begins at the first member on side +1. A half plane in it comes after as
    many others as it has to its right there.
    """
    det = _determinants(table, members, members[:, :, None], members[:, None, :])
    side: Signs = det[:, 0, :].copy()
    side[:, 0] = 1
    rank = (det * side[:, :, None] * side[:, None, :] > 0).sum(axis=1)
    order = np.argsort(rank, axis=1)
    plane = np.take_along_axis(members, order, axis=1)
    side = np.take_along_axis(side, order, axis=1)
    return np.hstack([plane, plane]), np.hstack([side, -side])


def _signs_on_half_planes(
    table: PlaneTable, members: Indices, plane: Indices, side: Signs
) -> Words:
    """Return which members have sign + on each half plane: (L, 2k, W)."""
    det = _determinants(table, members, members[:, :, None], plane[:, None, :])
    units = unit_words(len(table))[members][:, :, None, :]
    positive = det * side[:, None, :] > 0
    found: Words = np.bitwise_or.reduce(units * positive[..., None], axis=1)
    return found
