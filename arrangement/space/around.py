"""The faces around each line: half planes and the regions between them, in every segment.

Let k classes contain a line with direction D. The half plane of class j on side s = +1 or -1
leaves the line along ``s n_j x D``; there class l, another of the k, has sign
``s sign det(n_l, n_j, D)``. Counterclockwise of it begins a region, where class j has sign s.
Every region around the line follows exactly one half plane. So the 2k half planes, with the sign of
j set to 0 or to s, give all facets and regions at each segment of the line.

If the normals have rank 3, every facet and every region contains no line, so it has a vertex and
thus an edge; hence all facets and regions are found at the segments.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .lines import Lines
from .packing import Words, distinct_labelled, distinct_rows, unit_words
from .predicates import Indices, PlaneTable


@dataclass(frozen=True, slots=True)
class Faces:
    """The faces of dimension 0, 2 and 3, as bits over the classes.

    Attributes:
        vertices: (V, W); the classes with sign 0, which determine a vertex.
        facets, on: (F, W) and (F); the classes with sign +, and the class with sign 0.
        regions: (R, W); the classes with sign +.
        incident_region, incident_edge: (I) each; a region and a segment in its boundary, all
            such pairs.
    """

    vertices: Words
    facets: Words
    on: NDArray[np.int64]
    regions: Words
    incident_region: NDArray[np.int32]
    incident_edge: Indices


def faces_around(table: PlaneTable, lines: Lines, through: Words) -> Faces:
    """Return the faces at the segments; row L of `through` has the classes through line L.

    Complexity: O(n^3 log n) time and O(n^3) memory for n planes.
    """
    facets, on, regions, edges = [], [], [], []
    for members, edge, ring in _rings(lines):
        plus, minus = _half_planes(table, lines, members)
        units = unit_words(len(table))[members]
        words = lines.words[edge][:, None, :]
        for half, beyond in ((plus, plus | units), (minus, minus)):
            facets.append((words | half[ring]).reshape(-1, words.shape[2]))
            on.append(members[ring].ravel())
            regions.append((words | beyond[ring]).reshape(-1, words.shape[2]))
            edges.append(np.repeat(edge, members.shape[1]))
    found = np.concatenate(regions)
    first, number = distinct_rows(found)
    facet_words, facet_on = distinct_labelled(
        np.concatenate(facets), np.concatenate(on), len(table)
    )
    return Faces(
        _vertices(lines, through),
        facet_words,
        facet_on.astype(np.int64),
        found[first],
        number,
        np.concatenate(edges),
    )


def _rings(lines: Lines) -> Iterator[tuple[Indices, Indices, Indices]]:
    """Yield, for each number k of classes through a line, the lines of that kind.

    As (members, edge, ring): the classes through each such line, (L_k, k), sorted; the segments
    on such lines, (E_k); the row of `members` that belongs to each segment.
    """
    sizes = lines.through.sum(axis=1)
    for k in np.unique(sizes).tolist():
        rows = np.nonzero(sizes == k)[0]
        members = np.nonzero(lines.through[rows])[1].reshape(-1, k)
        place = np.full(len(sizes), -1)
        place[rows] = np.arange(len(rows))
        edge = np.nonzero(sizes[lines.line] == k)[0]
        yield members, edge, place[lines.line[edge]]


def _half_planes(table: PlaneTable, lines: Lines, members: Indices) -> tuple[Words, Words]:
    """Return the classes with sign + on the two half planes of each member, (L_k, k, W) each.

    ``n_l x n_j`` is a multiple of ``D = n_i x n_j'``, so the sign of ``det(n_l, n_j, D)`` is the
    product of the signs that they have in one coordinate. The first two members define D.
    """
    base = table.turn[members[:, 0], members[:, 1]]
    side = table.turn[members[:, :, None], members[:, None, :]] * base[:, None, None]
    units = unit_words(len(table))[members][:, :, None, :]
    nothing = np.uint64(0)
    plus = np.bitwise_or.reduce(np.where(side[..., None] > 0, units, nothing), axis=1)
    minus = np.bitwise_or.reduce(np.where(side[..., None] < 0, units, nothing), axis=1)
    return plus, minus


def _vertices(lines: Lines, through: Words) -> Words:
    """Return the zero classes of each vertex: those of a line, and those that change sign there."""
    lower = np.nonzero(lines.upper >= 0)[0]
    zeros = through[lines.line[lower]] | (lines.words[lower] ^ lines.words[lower + 1])
    return zeros[distinct_rows(zeros)[0]]
