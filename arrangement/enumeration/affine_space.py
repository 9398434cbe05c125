"""The engine for planes of rank 3, and central ones of rank 4: fast at scale, always exact.

**Predicates.** Signs of determinants of planes are floats within a proven error, else integers.
A plane is a row ``(n, b)`` of four integers, ``{x : n . x = b}``. For rows i and j let
``D_ij = n_i x n_j`` and ``M_ij = n_i b_j - n_j b_i``, the six 2x2 minors. Then, with D3 the
determinant of three normals and D4 that of four rows,

* ``D3(i, j, k) = D_ij . n_k``;
* ``D4(i, j, k, l) = D_ij . M_kl + M_ij . D_kl`` (Laplace expansion by two rows);
* planes k and l meet the line ``P + t D_ij`` of planes i and j at parameters with
  ``t_l - t_k = D4(i, j, k, l) / (D3(i, j, k) D3(i, j, l))``.

Error bound. A row is divided by a power of two, which moves nothing, and rounded to floats. All
determinants are sums of products; no product takes more than `_ROUNDINGS`, in any order of
summation, so `arrangement.numbers.float_filter` bounds the error. S = 0 proves that the
determinant is 0: four planes through the origin need no integers.

Small integers. For entries up to B, the six products of D4 and each partial sum are at most
``24 B^4`` (each D and M at most ``2 B^2``), those of all other determinants less. If that is at
most 2^53, floats are exact.

**Lines.** The lines in which planes meet are cut into segments: floats propose an order,
determinants decide. On the line of planes i and j, planes k and l cross in this order, or together,
exactly when ``D4(i, j, k, l) D3(i, j, k) D3(i, j, l) >= 0``. If that holds for all neighbours in a
proposed order, the order is right, and equality says which crossings coincide. A line whose
proposal fails is sorted again by exact rational parameters.

**Faces.** If the normals have rank 3, no facet or region contains a line. So every facet has two
edges or more, and every region two facets or more: facets are found around the segments, and
regions on both sides of the facets, each from all of its boundary.

Around a line with direction D and k planes through it there are 2k half planes. That of class j on
side s = +1 or -1 leaves the line along ``s n_j x D``; there class l, another of the k, has sign
``s sign det(n_l, n_j, D)``.

A point is a row (X, Y, Z, W) of integers, W > 0, and stands for (X, Y, Z) / W. The sum of two rows
is a weighted mean of their points. That of two edges of a facet is inside the facet, and that of
two facets of a region inside the region.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.console.progress import watched
from arrangement.enumeration import great_circles
from arrangement.enumeration.reduction import from_dimension, in_dimension, joined
from arrangement.enumeration.sequence import Level, Rows, no_faces, primitive_rows
from arrangement.errors import ArrangementError
from arrangement.numbers.coefficients import Integers
from arrangement.numbers.exact import IntegerVector, dot, largest, quotient
from arrangement.numbers.float_filter import (
    EXACT,
    UNUSABLE,
    Floats,
    Signs,
    certified_signs,
    error_bound,
    least_sizes,
    scale_rows,
    signs_of,
)
from arrangement.numbers.linear.rank import cut, unit_vectors
from arrangement.numbers.packing import (
    Bits,
    Words,
    distinct_rows,
    group_rows,
    pack,
    unit_words,
    unpack,
)
from arrangement.planes.planes import Planes

Numbers: TypeAlias = NDArray[Any]
Indices: TypeAlias = NDArray[np.intp]

#: Of each product in D4: four entries, two minors of two each, one product, five sums.
_ROUNDINGS = 4 + 2 * 2 + 1 + 5
ERROR = error_bound(_ROUNDINGS)


class PlaneTable:
    """Pairwise different planes in R^3, as integers and as floats with a known error.

    Attributes:
        exact: (n, 4) Python integers.
        floats: (n, 4), rows near positive multiples of the exact ones.
        error: a determinant of the floats is wrong by at most `error` times the sum of its
            absolute products. 0 where all determinants are small integers. `UNUSABLE` where floats
            cannot hold the rows: they are all 1 then, and integers decide everything.
        minors, sizes: (n, n, 6); ``(D_ij, M_ij)`` in floats, and their absolute products.
        axis: (n, n); the first coordinate in which ``D_ij`` is not 0.
        turn: (n, n); its sign there, or 0 for parallel planes.
    """

    def __init__(self, rows: Sequence[IntegerVector]) -> None:
        self.exact: Integers = np.empty((len(rows), 4), dtype=object)
        self.exact[...] = np.array(rows, dtype=object).reshape(-1, 4)
        self.floats, self.error = scaled_floats(rows)
        self.minors = minors(self.floats[:, None], self.floats[None])
        self.sizes = _sizes(self.floats)
        usable = self.error < UNUSABLE
        self._least = least_sizes(rows) if usable and self.error else np.zeros(len(rows))
        least = (self._least[:, None] * self._least)[..., None]
        components = self._signs(
            self.minors[..., :3], self.sizes[..., :3], self._exact_component, least
        )
        self.axis: Indices = np.argmax(components != 0, axis=-1)
        self.turn: Signs = np.take_along_axis(components, self.axis[..., None], axis=-1)[..., 0]

    def __len__(self) -> int:
        return len(self.exact)

    def triples(self, i: Indices, j: Indices) -> tuple[Signs, Floats]:
        """Return the signs of ``D3(i, j, k)`` for all planes k, a row for each pair, and floats."""

        def exact(at: tuple[Indices, ...]) -> Integers:
            row, k = at
            return _dot3(self.exact_minors(i[row], j[row]), self.exact[k])

        normals = self.floats[:, :3].T
        values = self.minors[i, j, :3] @ normals
        sizes = self.sizes[i, j, :3] @ np.abs(normals)
        row = np.arange(len(i))
        for own in (i, j):
            values[row, own] = sizes[row, own] = 0.0
        pairs = self._least[i] * self._least[j]
        return self._signs(values, sizes, exact, pairs[:, None] * self._least), values

    def sides(self, i: Indices, j: Indices, k: Indices) -> Signs:
        """Return the sides of planes k on which the lines of i and j lie, if parallel to them."""
        axis = self.axis[i, j]

        def exact(at: tuple[Indices, ...]) -> Integers:
            minor = self.exact_minors(i[at], j[at])
            return _value_on_line(minor, self.exact[k[at]], axis[at], -1)

        values = _value_on_line(self.minors[i, j], self.floats[k], axis, -1)
        sizes = _value_on_line(self.sizes[i, j], np.abs(self.floats[k]), axis, 1)
        least = self._least[i] * self._least[j] * self._least[k]
        return self._signs(values, sizes, exact, least) * self.turn[i, j]

    def quadruples(self, i: Indices, j: Indices, k: Indices, l: Indices, use: Any) -> Signs:  # noqa: E741
        """Return the signs of ``D4(i, j, k, l)`` where `use` is set, else 0.

        Args:
            i, j: (L) planes of lines.
            k, l: (L, c) planes that cross them.
            use: (L, c) Booleans.
        """

        def exact(at: tuple[Indices, ...]) -> Integers:
            row = at[0]
            return _dot6(self.exact_minors(i[row], j[row]), self.exact_minors(k[at], l[at]))

        pair = k * len(self) + l
        line, crossing = self.minors[i, j], self.minors.reshape(-1, 6)[pair]
        values = _by_line(line, crossing)
        sizes = _by_line(self.sizes[i, j], self.sizes.reshape(-1, 6)[pair])
        unused = ~use
        values[unused] = sizes[unused] = 0.0
        pairs = self._least[i] * self._least[j]
        least = pairs[:, None] * self._least[k] * self._least[l]
        return self._signs(values, sizes, exact, least)

    def exact_parameters(self, i: int, j: int, crossing: Indices) -> tuple[Integers, Integers]:
        """Return numerators and positive denominators that order crossings of one line exactly.

        They are the parameters up to a positive factor, counted from the first crossing.
        """
        here = self.exact_minors(np.full_like(crossing, i), np.full_like(crossing, j))
        below = _dot3(here, self.exact[crossing])
        above = _dot6(here, self.exact_minors(np.full_like(crossing, crossing[0]), crossing))
        flip = np.where(below < 0, -1, 1).astype(object)
        first = 1 if below[0] > 0 else -1
        return above * flip * first, below * flip

    def exact_minors(self, i: Indices, j: Indices) -> Integers:
        """Return the six minors of pairs of rows in Python integers."""
        return minors(self.exact[i], self.exact[j])

    def _exact_component(self, at: tuple[Indices, ...]) -> Integers:
        i, j, component = at
        return self.exact_minors(i, j)[np.arange(len(i)), component]

    def _signs(
        self,
        values: Floats,
        sizes: Floats,
        exact: Callable[[tuple[Indices, ...]], Integers],
        least: Floats,
    ) -> Signs:
        """Return the signs of determinants; `exact` gives those that the floats leave open."""
        if self.error == 0:
            return signs_of(values)
        return certified_signs(values, sizes, self.error, least, exact)


def scaled_floats(rows: Sequence[IntegerVector]) -> tuple[Floats, float]:
    """Return floats near positive multiples of integer rows, and the `error` of determinants."""
    if 24 * largest(rows) ** 4 <= EXACT:
        return np.array(rows, dtype=np.float64).reshape(-1, 4), 0.0
    floats, usable = scale_rows(rows)
    return (floats, ERROR) if usable.all() else (np.ones_like(floats), UNUSABLE)


def minors(left: Numbers, right: Numbers) -> Numbers:
    """Return the six minors ``(D, M)`` of rows along the last axis."""
    a, b, c, p = (left[..., m] for m in range(4))
    u, v, w, q = (right[..., m] for m in range(4))
    parts = [b * w - c * v, c * u - a * w, a * v - b * u]
    parts += [a * q - u * p, b * q - v * p, c * q - w * p]
    return np.stack(parts, axis=-1)


def _sizes(floats: Floats) -> Floats:
    """Return the sums of the absolute products in all minors."""
    left, right = np.abs(floats)[:, None], np.abs(floats)[None]
    moment = left[..., :3] * right[..., 3:] + right[..., :3] * left[..., 3:]
    after, before = [1, 2, 0], [2, 0, 1]
    direction = left[..., after] * right[..., before] + left[..., before] * right[..., after]
    return np.concatenate([direction, moment], axis=-1)


def _dot3(minor: Numbers, row: Numbers) -> Numbers:
    product: Numbers = (minor[..., :3] * row[..., :3]).sum(axis=-1)
    return product


def _dot6(left: Numbers, right: Numbers) -> Numbers:
    direction, moment = left[..., :3] * right[..., 3:], left[..., 3:] * right[..., :3]
    product: Numbers = (direction + moment).sum(axis=-1)
    return product


def _by_line(line: Floats, crossing: Floats) -> Floats:
    """Return D4 for each line (a row of minors) and each of its pairs of planes."""
    exchanged = np.concatenate([line[:, 3:], line[:, :3]], axis=1)
    product: Floats = np.matmul(crossing, exchanged[:, :, None])[..., 0]
    return product


def _value_on_line(minor: Numbers, row: Numbers, axis: Indices, minus: int) -> Numbers:
    """Return ``(n_k . P - b_k) D_m`` for the point P of the line with coordinate m equal to 0.

    `minus` is -1, or +1 for the sum of the absolute products.
    """
    at = np.arange(len(axis))
    a, c = (axis + 1) % 3, (axis + 2) % 3
    value: Numbers = (
        row[at, c] * minor[at, 3 + a]
        + minus * (row[at, a] * minor[at, 3 + c])
        + minus * (row[at, 3] * minor[at, axis])
    )
    return value


#: Pairs (line, plane) handled at once: temporary arrays stay in the cache.
BLOCK = 1 << 16


@dataclass(frozen=True, slots=True)
class Lines:
    """The lines, each once, and their segments: the faces of dimension 1.

    Attributes:
        first, second: (L); the two smallest classes that contain the line.
        through: (L, n); which classes contain it.
        line: (E); the line of each segment. The segments of a line follow each other in the
            direction ``n_first x n_second``.
        words: (E, W); the classes with sign +.
        upper: (E); a class that crosses at the upper end, or -1 for the last segment.
    """

    first: Indices
    second: Indices
    through: Bits
    line: Indices
    words: Words
    upper: Indices


def trace_lines(table: PlaneTable) -> Lines:
    """Return all lines of planes whose normals have rank 3, with their segments.

    Complexity: O(n^3 log n) time and O(n^3) memory for n planes.
    """
    i, j = np.nonzero(np.triu(table.turn, 1))
    step = max(1, BLOCK // len(table))
    starts = watched(range(0, len(i), step), "blocks of lines")
    parts = [_block(table, i[s : s + step], j[s : s + step]) for s in starts]
    offsets = np.cumsum([0] + [len(part.first) for part in parts])
    for part, start in zip(parts, offsets, strict=False):
        np.add(part.line, start, out=part.line)
    columns = zip(*([getattr(part, f.name) for f in fields(Lines)] for part in parts), strict=True)
    return Lines(*map(np.concatenate, columns))


def _block(table: PlaneTable, i: Indices, j: Indices) -> Lines:
    """Return the lines that some pairs of classes represent."""
    triple, slopes = table.triples(i, j)
    sides = np.zeros_like(triple)
    row, k = np.nonzero(triple == 0)
    others = (k != i[row]) & (k != j[row])
    row, k = row[others], k[others]
    sides[row, k] = table.sides(i[row], j[row], k)
    through = (triple == 0) & (sides == 0)
    smaller = np.arange(len(table)) < j[:, None]
    keep = np.nonzero((through & smaller).sum(axis=1) == 1)[0]
    i, j, triple, through = i[keep], j[keep], triple[keep], through[keep]
    order, tied = _order(table, i, j, triple, _parameters(table, i, j, triple, slopes[keep]))
    return _segments(i, j, triple, sides[keep], through, order, tied)


def _parameters(table: PlaneTable, i: Indices, j: Indices, triple: Signs, slopes: Floats) -> Floats:
    """Return the float parameters of the crossings; infinity where there is none."""
    direction = table.minors[i, j, :3]
    left, right = table.floats[i], table.floats[j]
    sums = left[:, 3:] * np.cross(right[:, :3], direction)
    sums += right[:, 3:] * np.cross(direction, left[:, :3])
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        # The point of each line that is roughly the nearest to the origin.
        points = np.nan_to_num(sums / (direction**2).sum(axis=1, keepdims=True), copy=False)
        heights = table.floats[:, 3] - points @ table.floats[:, :3].T
        parameters: Floats = np.nan_to_num(heights / slopes, copy=False)
    parameters[triple == 0] = np.inf
    return parameters


def _order(
    table: PlaneTable, i: Indices, j: Indices, triple: Signs, parameters: Floats
) -> tuple[Indices, Bits]:
    """Return the certified order of the classes on each line, and which meet the one before there.

    Classes that do not cross come last.
    """
    order = np.argsort(parameters, axis=1)
    ascents = _ascents(table, i, j, triple, order)
    failed = np.nonzero((ascents < 0).any(axis=1))[0]
    if len(failed):
        for row in failed.tolist():
            count = int(np.count_nonzero(triple[row]))
            order[row, :count] = _exact_order(table, int(i[row]), int(j[row]), order[row, :count])
        again = _ascents(table, i[failed], j[failed], triple[failed], order[failed])
        if (again < 0).any():  # pragma: no cover - two exact methods would disagree
            raise ArrangementError(
                "parameters and determinants disagree on the order on a line; report this input"
            )
        ascents[failed] = again
    both = np.take_along_axis(triple, order[:, 1:], axis=1) != 0
    tied = np.zeros(order.shape, bool)
    tied[:, 1:] = both & (ascents == 0)
    return order, tied


def _ascents(table: PlaneTable, i: Indices, j: Indices, triple: Signs, order: Indices) -> Signs:
    """Return ``sign (t_l - t_k)`` for neighbours k, l in an order; 0 where one does not cross."""
    turned = np.take_along_axis(triple, order, axis=1)
    product = turned[:, :-1] * turned[:, 1:]
    return product * table.quadruples(i, j, order[:, :-1], order[:, 1:], product != 0)


def _exact_order(table: PlaneTable, i: int, j: int, crossing: Indices) -> list[int]:
    """Return the classes that cross a line, sorted by exact parameters."""
    above, below = table.exact_parameters(i, j, crossing)
    place = {
        int(k): quotient(p, q)
        for k, p, q in zip(crossing, above.tolist(), below.tolist(), strict=True)
    }
    return sorted(place, key=place.__getitem__)


def _segments(
    i: Indices,
    j: Indices,
    triple: Signs,
    sides: Signs,
    through: Bits,
    order: Indices,
    tied: Bits,
) -> Lines:
    """Cut lines at their crossings: sign vectors are running XORs of single bits.

    Where ``t`` is very negative, class k has sign ``-D3(i, j, k)``. A segment starts at a place p
    after p crossings, so `order` has a class of the next one at that place.
    """
    lines, classes = order.shape
    crossing = np.take_along_axis(triple, order, axis=1) != 0
    masks = unit_words(classes)
    states = np.empty((lines, classes + 1, masks.shape[1]), np.uint64)
    states[:, 0] = pack((triple < 0) | (sides > 0))
    np.multiply(masks[order], crossing[..., None], out=states[:, 1:])
    np.bitwise_xor.accumulate(states, axis=1, out=states)
    starts = np.zeros((lines, classes + 1), bool)
    starts[:, 0] = True
    starts[:, 1:] = crossing
    starts[:, 1:-1] &= ~tied[:, 1:]
    line, place = np.nonzero(starts)
    last = np.append(line[1:] != line[:-1], True)
    upper = np.where(last, -1, order[line, np.minimum(place, classes - 1)])
    return Lines(i, j, through, line, states[line, place], upper)


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
    one, other = _pairs_of_equal_rows(np.column_stack([facets, on.astype(np.uint64)]))
    facets, on, edges = facets[one], on[one], np.stack([edge[one], edge[other]], axis=1)
    regions = np.concatenate([facets, facets | unit_words(len(table))[on]])
    one, other = _pairs_of_equal_rows(regions)
    sides = np.stack([one, other], axis=1) % len(facets)
    return Faces(_vertices(lines), facets, on, edges, regions[one], sides)


def _pairs_of_equal_rows(rows: Words) -> tuple[Indices, Indices]:
    """Return the places of two copies of each different row; every row has two or more."""
    order, new = group_rows(rows)
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
        rows = np.zeros((len(segments), 4), self._planes.dtype)
        rows[above] += self._upper_ends(segments[above])
        rows[below] += self._upper_ends(segments[below] - 1)
        step = primitive_rows(self._minors(segments)[:, :3])
        rows[:, :3] += (below.astype(int) - above)[:, None] * step
        return rows

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
            signs = 2 * unpack(positive, len(table)).view(np.int8) - 1
            signs[unpack(zero, len(table))] = 0
            return signs[:, columns] * orientation

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
            rest = level.signs(rows)
            whole = np.repeat(side * sides[None], len(rest), axis=0)
            whole[:, others] = rest * (side or 1)
            return whole

        def points(rows: Rows) -> Integers:
            points = level.points(rows).astype(object)
            if not side:
                points[:, -1] = 0
            points = (side or 1) * (points @ np.array(basis, object))
            return np.hstack([points, np.ones((len(points), 1), object)])

        return Level(level.count, signs, points)

    nothing = no_faces(len(planes), 4)
    by_side = (
        [nothing, *(lifted(level, 1) for level in half)],
        [nothing, *(lifted(level, -1) for level in half)],
        [*(lifted(level, 0) for level in flat), nothing],
    )
    return tuple(map(joined, zip(*by_side, strict=True)))
