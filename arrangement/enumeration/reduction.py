"""Faces carried over between spaces: more or fewer coordinates, and the cone over affine planes.

An arrangement of rank r in R^d is a product of one in R^r and a linear space. So the coordinates
of r independent columns of the normals are enough, and the others can be 0.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arrangement.numbers.coefficients import Integers
from arrangement.numbers.linear.rank import rank
from arrangement.planes.planes import Planes

from .sequence import Level, Rows, no_faces

#: Faces whose points are made at once.
_PORTION = 1 << 16


def cone(planes: Planes) -> Planes:
    """Return the cone over planes: ``n . x = b`` becomes ``n . x - b w = 0``, and w = 0 is last."""
    rows = [(*plane[:-1], -plane[-1]) for plane in planes.integer_planes]
    return Planes([*rows, (0,) * planes.dimension + (1,)])


def in_dimension(planes: Planes, n: int) -> tuple[Planes, tuple[int, ...]]:
    """Return the same planes, with the same signs, in R^n, where n is at least the rank.

    Returns:
        The planes, and for each of their n coordinates the one of `planes` that it is: coordinates
        of independent columns of the normals. From d on they are new, and 0 in all normals.
    """
    d = planes.dimension
    if planes.rank == n == d:
        return planes, tuple(range(d))
    columns: list[int] = []
    by_column = list(zip(*planes.distinct_planes, strict=True))[:-1]
    for j, column in enumerate(by_column):
        if rank([*(by_column[i] for i in columns), column]) > len(columns):
            columns.append(j)
    columns += range(d, d + n - len(columns))
    rows = [[plane[j] if j < d else 0 for j in columns] for plane in planes.integer_planes]
    return Planes(rows, [plane[-1] for plane in planes.integer_planes], dimension=n), tuple(columns)


def from_dimension(
    levels: Sequence[Level], planes: Planes, columns: Sequence[int]
) -> tuple[Level, ...]:
    """Return the faces of planes, from those of ``in_dimension(planes, n)``."""
    d, more = planes.dimension, planes.dimension - len(columns)
    if list(columns) == list(range(d)):
        return tuple(levels)
    kept = [i for i, j in enumerate(columns) if j < d]
    places = [columns[i] for i in kept]

    def embedded(level: Level) -> Level:
        def points(rows: Rows) -> Integers:
            points = level.points(rows)
            whole = np.zeros((len(points), d + 1), points.dtype)
            whole[:, [*places, d]] = points[:, [*kept, -1]]
            return whole

        return Level(level.count, level.signs, points)

    empty = no_faces(len(planes), d)
    return (*[empty] * more, *map(embedded, levels[max(0, -more) :]))


def upper_half(level: Level) -> Level:
    """Return the faces of affine planes, from those of their cone one dimension up.

    They are the ones with w > 0, at w = 1. Points are made in portions, which bounds the memory.
    """
    starts = range(0, level.count, _PORTION)
    points = (level.points(slice(start, start + _PORTION)) for start in starts)
    above = [part[:, -2] > 0 for part in points]
    upper = np.flatnonzero(np.concatenate([*above, np.empty(0, np.bool_)]))
    return Level(
        len(upper),
        lambda rows: level.signs(upper[rows])[:, :-1],
        lambda rows: level.points(upper[rows])[:, :-1],
    )


def joined(levels: Sequence[Level]) -> Level:
    """Return the faces of several levels of one dimension, one level after the other."""
    ends = np.cumsum([level.count for level in levels])

    def gathered(parts: Callable[[Level, Rows], NDArray[Any]], rows: Rows) -> NDArray[Any]:
        chosen = np.arange(ends[-1])[rows]
        of = np.searchsorted(ends, chosen, side="right")
        result = np.concatenate(
            [
                parts(level, chosen[of == i] - (ends[i] - level.count))
                for i, level in enumerate(levels)
            ]
        )
        return result[np.argsort(np.argsort(of, kind="stable"))]

    return Level(
        int(ends[-1]),
        lambda rows: gathered(lambda level, at: level.signs(at), rows),
        lambda rows: gathered(lambda level, at: level.points(at), rows),
    )
