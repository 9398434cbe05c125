"""The lines in which planes meet, cut into segments: floats propose an order, determinants decide.

On the line of planes i and j, planes k and l cross in this order, or together, exactly when
``D4(i, j, k, l) D3(i, j, k) D3(i, j, l) >= 0`` (see `predicates`). If that holds for all neighbours
in a proposed order, the order is right, and equality says which crossings coincide. A line whose
proposal fails is sorted again by exact rational parameters.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from arrangement.console.progress import watched
from arrangement.errors import ArrangementError
from arrangement.numbers.exact import quotient
from arrangement.numbers.float_filter import Floats, Signs
from arrangement.numbers.packing import Bits, Words, pack, unit_words

from .predicates import Indices, PlaneTable

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


def _points_on_lines(table: PlaneTable, i: Indices, j: Indices) -> Floats:
    """Return, roughly, the point of each line nearest to the origin."""
    direction = table.minors[i, j, :3]
    left, right = table.floats[i], table.floats[j]
    sums = left[:, 3:] * np.cross(right[:, :3], direction)
    sums += right[:, 3:] * np.cross(direction, left[:, :3])
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        points: Floats = sums / (direction**2).sum(axis=1, keepdims=True)
    return np.nan_to_num(points, copy=False)


def _parameters(table: PlaneTable, i: Indices, j: Indices, triple: Signs, slopes: Floats) -> Floats:
    """Return the float parameters of the crossings; infinity where there is none."""
    points = _points_on_lines(table, i, j)
    heights = table.floats[:, 3] - points @ table.floats[:, :3].T
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        parameters = np.nan_to_num(heights / slopes, copy=False)
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
