"""Vectors grouped by equal ratios of their coordinates in a quotient: flats of the next rank.

Contract by a flat: the vectors outside it that are proportional in the quotient lie on one flat
above it. By one vector the quotient has a coordinate less; by two of four it has two coordinates,
3 x 3 minors.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arrangement.numbers.exact import all_reduced, one_way

Integers = NDArray[Any]
#: Entries that arrays of one piece of the work hold.
_CHUNK = 1 << 19
#: Relative distance of quotients, each rounded three times, that may be equal.
_CLOSE = 2.0**-48
#: Rows of so many slopes are sorted where slopes share a hash alone; a table of these bits.
_MIN_HASHED = 2000
_HASH_BITS = 17
_HASH_FACTOR = np.uint64(0x9E3779B97F4A7C15)
_COLUMN_PAIRS = np.array([(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)])
_COLUMN_REST = np.array([(2, 3), (1, 3), (1, 2), (0, 3), (0, 2), (0, 1)])


@dataclass(frozen=True)
class Groups:
    """Columns grouped within each row by equal ratio of their coordinates.

    Attributes:
        row, first, last, size: of each group; `first` and `last` are its extreme columns.
        columns: the members of all groups, one group after the other, increasing in each.
    """

    row: Integers
    first: Integers
    last: Integers
    size: Integers
    columns: Integers

    def members(self) -> list[Integers]:
        """Return the columns of every group."""
        return np.split(self.columns, np.cumsum(self.size)[:-1])


def group_ratios(coordinates: list[Integers], rows: Integers) -> Groups:
    """Group the columns of each row by ratio; columns whose coordinates are all 0 are left out."""
    local, column = np.nonzero(np.logical_or.reduce([part != 0 for part in coordinates]))
    keys = _canonical([part[local, column] for part in coordinates])
    order = np.lexsort((*reversed(keys), local))
    changed = np.zeros(len(order), dtype=bool)
    changed[:1] = True
    for key in (local, *keys):
        changed[1:] |= key[order[1:]] != key[order[:-1]]
    start = np.flatnonzero(changed)
    size = np.diff(np.append(start, len(order)))
    columns = column[order]
    return Groups(
        rows[local[order[start]]], columns[start], columns[start + size - 1], size, columns
    )


def _canonical(parts: list[Integers]) -> list[Integers]:
    """Return sortable keys, equal exactly for proportional coordinates."""
    if parts[0].dtype == object:
        names: dict[tuple[int, ...], int] = {}
        lines = map(one_way, all_reduced(list(zip(*parts, strict=True))))
        return [np.array([names.setdefault(key, len(names)) for key in lines], dtype=np.int64)]
    divisor = np.gcd.reduce(parts)
    sign = np.zeros(len(divisor), dtype=np.int64)
    for part in parts:
        sign = np.where(sign == 0, np.sign(part), sign)
    return [part // divisor * sign for part in parts]


def without_infinity(groups: Groups, infinity: int) -> Groups:
    """Leave out groups with the column of infinity, which is the last if there is one."""
    return keep_groups(groups, lambda g: g.last < infinity)


def keep_groups(groups: Groups, rule: Any) -> Groups:
    """Return the groups for which the vectorised rule holds."""
    chosen = rule(groups)
    return Groups(
        groups.row[chosen],
        groups.first[chosen],
        groups.last[chosen],
        groups.size[chosen],
        groups.columns[np.repeat(chosen, groups.size)],
    )


def contract_by_one(vectors: Integers, rows: Integers) -> list[Integers]:
    """Return the coordinates of every vector in the quotient by each of the chosen vectors."""
    rank = vectors.shape[1]
    pivots = (vectors[rows] != 0).argmax(axis=1)
    order = np.array([[j, *(k for k in range(rank) if k != j)] for j in range(rank)])[pivots]
    a = np.take_along_axis(vectors[rows], order, axis=1)
    columns = vectors.T
    at_pivot = columns[order[:, 0]]
    return [columns[order[:, k]] * a[:, :1] - at_pivot * a[:, k, None] for k in range(1, rank)]


def contract_by_two(vectors: Integers, first: Integers, second: Integers) -> list[Integers]:
    """Return two 3 x 3 minors of (a, b, c) for every c: its ratio in the quotient by a and b."""
    a, b = vectors[first], vectors[second]
    i, j = _COLUMN_PAIRS.T
    minors = a[:, i] * b[:, j] - a[:, j] * b[:, i]
    choice = (minors != 0).argmax(axis=1)
    each = np.arange(len(first))
    i, j = _COLUMN_PAIRS[choice].T
    columns = vectors.T
    plain = minors[each, choice][:, None]
    coordinates = []
    for k in _COLUMN_REST[choice].T:
        with_i = (a[each, i] * b[each, k] - a[each, k] * b[each, i])[:, None]
        with_j = (a[each, j] * b[each, k] - a[each, k] * b[each, j])[:, None]
        coordinates.append(columns[i] * with_j - columns[j] * with_i + columns[k] * plain)
    return coordinates


def row_chunks(rows: int, columns: int) -> list[Integers]:
    """Split row numbers so that each piece holds about `_CHUNK` entries."""
    step = max(1, _CHUNK // max(1, columns))
    return [np.arange(start, min(rows, start + step)) for start in range(0, rows, step)]


def equal_slopes(parts: list[Integers], affine: bool) -> tuple[int, int]:
    """Return how many groups of equal slope have one member, and how many there are.

    Args:
        parts: two coordinates of vectors, in rows; 0 for what is not in a group.
        affine: the last column is infinity, whose groups are left out.
    """
    slopes: Integers = np.empty(parts[0].shape)
    _divide(parts, slopes)
    if affine:
        slopes[slopes == slopes[:, -1:]] = np.nan
    everybody = np.count_nonzero(slopes == slopes)
    rows = list(map(_maybe_equal, slopes)) if slopes.shape[1] >= _MIN_HASHED else list(slopes)
    framed = np.full((len(rows), max(map(len, rows)) + 2), np.nan)
    for line, row in zip(framed, rows, strict=True):
        line[1 : len(row) + 1] = row
    slopes = framed[:, 1:-1]
    slopes.sort(axis=1)
    # Those without another one in their place, and less what is NaN, which differs from itself.
    left = int(everybody) - slopes.size
    changes = framed[:, 1:] != framed[:, :-1]
    alone, groups = changes[:, 1:] & changes[:, :-1], changes[:, :-1]
    return int(np.count_nonzero(alone)) + left, int(np.count_nonzero(groups)) + left


def _maybe_equal(row: Integers) -> Integers:
    """Return the slopes of a row that share a place in a table of hashes with another one."""
    hashes = (row + 0.0).view(np.uint64) * _HASH_FACTOR >> np.uint64(64 - _HASH_BITS)
    places, numbers = hashes.astype(np.intp), np.arange(len(row))
    table = np.empty(2**_HASH_BITS, np.intp)
    table[places] = numbers
    last = table[places]
    shared = last != numbers
    shared[last[shared]] = True
    equal: Integers = row[shared]
    return equal


def close_slopes(parts: list[Integers], affine: bool) -> tuple[int, int]:
    """Return the same, where slopes that floats do not distinguish are compared exactly."""
    slopes: Integers = np.empty(parts[0].shape)
    _divide(parts, slopes)
    is_open = _are_close(np.sort(slopes, axis=1)).any(axis=1)
    count = int((~np.isnan(slopes[~is_open])).sum()) - affine * int((~is_open).sum())
    rows, end = np.flatnonzero(is_open), slopes.shape[1] - affine
    if not len(rows):
        return count, count
    slopes = slopes[rows]
    order = np.argsort(slopes, axis=1)
    changes = np.ones((len(rows), slopes.shape[1] + 1), np.bool_)
    changes[:, 1:-1] = ~_are_close(np.take_along_axis(slopes, order, axis=1))
    alone = np.empty(slopes.shape, np.bool_)
    np.put_along_axis(alone, order, changes[:, 1:] & changes[:, :-1], axis=1)
    count += int((alone & ~np.isnan(slopes))[:, :end].sum())
    sizes = without_infinity(
        group_ratios([np.where(alone, 0, part[rows]) for part in parts], rows), end
    ).size
    return count + int((sizes == 1).sum()), count + len(sizes)


def _are_close(line: Any) -> Any:
    """Return which of sorted slopes floats do not distinguish from the one before."""
    with np.errstate(invalid="ignore"):
        near = np.abs(line[:, 1:] - line[:, :-1]) <= _CLOSE * np.abs(line[:, 1:])
    return near | (line[:, 1:] == line[:, :-1])


def _divide(parts: list[Integers], slopes: Any) -> None:
    with np.errstate(divide="ignore", invalid="ignore"):
        np.divide(parts[0], parts[1], out=slopes)  # 0 / 0 is NaN
    slopes[slopes == -np.inf] = np.inf
