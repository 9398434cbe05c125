"""Exact points inside faces, in integers: sums of points of smaller faces.

A point is a row (X, Y, Z, W) of integers, W > 0, and stands for (X, Y, Z) / W. The sum of two rows
is a weighted mean of their points. That of two edges of a facet is inside the facet, and that of
two facets of a region inside the region.
"""

from __future__ import annotations

import numpy as np

from arrangement.enumeration.sequence import primitive_rows
from arrangement.exact import largest

from .faces_around_lines import Faces
from .lines import Lines
from .predicates import Indices, Integers, PlaneTable, minors


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
        above, below = upper[segments] >= 0, upper[segments - 1] >= 0  # the last one has no end
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
