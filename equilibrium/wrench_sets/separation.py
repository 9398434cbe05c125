"""Quick proofs, by rounded numbers, that polyhedra are apart or not inside one another.

Conditions and generators are scaled to entries of at most 1, so their scalar products are wrong by
little, wherever no digit of their entries counts: see `_NEGATIVE`. What this leaves open is for
exact arithmetic.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from arrangement.numbers.exact import IntegerVector
from arrangement.numbers.float_filter import Booleans, Floats, error_bound, scale_rows
from arrangement.numbers.linear.polyhedron import Polyhedron
from equilibrium.core.contact_rows import negated

#: A value below this is truly negative. A scalar product has at most `_TERMS` terms, each at most 1
#: in size, of two rounded factors; so `error_bound` is also a bound of its error, up to the factor
#: `_TERMS`. A mean of k generators adds k roundings, of which 2^20 are allowed. Entries that
#: underflow are wrong by 2^-1074 at most, far less than the two units to spare.
_TERMS = 4
_MAX_GENERATORS = 2**20
_NEGATIVE = -_TERMS * error_bound(2 + 1 + _TERMS + _MAX_GENERATORS)
#: This many homogeneous points are compared with all conditions at once.
_POINTS_AT_ONCE = 256


def surely_outside(shapes: Sequence[Polyhedron]) -> Booleans:
    """Return for i and j whether shape j surely has a point outside shape i.

    The mean of all generators is asked first: where it is outside, some generator is.
    """
    points, starts = _stack([both_ways(*shape.homogeneous) for shape in shapes])
    counts = np.diff([*starts, len(points)])
    means = np.add.reduceat(points, starts) / counts[:, None] if len(shapes) else points
    rows, firsts = _conditions(shapes)
    outside = np.zeros((len(shapes), len(shapes)), dtype=np.bool_)
    for start in range(0, len(shapes), _POINTS_AT_ONCE):
        part = slice(start, start + _POINTS_AT_ONCE)
        outside[:, part] = _any_of(means[part] @ rows.T < _NEGATIVE, firsts).T
    ends = [*firsts, len(rows)]
    for i in range(len(shapes)):
        left = np.flatnonzero(~outside[i])
        own = points[np.repeat(~outside[i], counts)]
        beyond = (own @ rows[ends[i] : ends[i + 1]].T < _NEGATIVE).any(axis=1)
        outside[i, left] = np.logical_or.reduceat(beyond, np.cumsum(counts[left]) - counts[left])
        outside[i, i] = False
    return outside


def possibly_meeting(
    edges: Sequence[Sequence[IntegerVector]], polygons: Sequence[Polyhedron]
) -> Booleans:
    """Return for each edge and polygon whether they may have a point in common.

    Args:
        edges: the homogeneous generators of each edge, none empty.
        polygons: of dimension 2.
    """
    meeting = np.ones((len(edges), len(polygons)), dtype=np.bool_)
    if not polygons:
        return meeting
    rows, firsts = _conditions(polygons)
    for start in range(0, len(edges), _POINTS_AT_ONCE):
        points, starts = _stack(edges[start : start + _POINTS_AT_ONCE])
        beyond = np.logical_and.reduceat(points @ rows.T < _NEGATIVE, starts)
        meeting[start : start + _POINTS_AT_ONCE] = ~_any_of(beyond, firsts)
    return meeting


def sides(
    rows: Sequence[IntegerVector], polygons: Sequence[Polyhedron]
) -> tuple[Booleans, Booleans]:
    """Return for each row and polygon whether the row is surely positive, or negative, on it."""
    above, below = np.zeros((2, len(rows), len(polygons)), dtype=np.bool_)
    if polygons:
        points, starts = _stack([both_ways(*polygon.homogeneous) for polygon in polygons])
        for start in range(0, len(rows), _POINTS_AT_ONCE):
            values = scale_rows(rows[start : start + _POINTS_AT_ONCE])[0] @ points.T
            part = slice(start, start + _POINTS_AT_ONCE)
            above[part] = np.minimum.reduceat(values, starts, axis=1) > -_NEGATIVE
            below[part] = np.maximum.reduceat(values, starts, axis=1) < _NEGATIVE
    return above, below


def _conditions(shapes: Sequence[Polyhedron]) -> tuple[Floats, list[int]]:
    """Return the conditions of all shapes, each with one at least, and the first of each shape."""
    return _stack(
        [
            both_ways(shape.inequalities, shape.equalities) or [(*[0] * len(shape.points[0]), 1)]
            for shape in shapes
        ]
    )


def _any_of(flags: Booleans, starts: Sequence[int]) -> Booleans:
    """Return whether any column of each group has its flag set."""
    return np.logical_or.reduceat(flags, starts, axis=1)


def _stack(groups: Sequence[Sequence[IntegerVector]]) -> tuple[Floats, list[int]]:
    """Return the vectors of all groups as rounded rows, and the first row of each group."""
    starts = np.cumsum([0, *map(len, groups)])[:-1].tolist()
    return scale_rows([vector for group in groups for vector in group])[0], starts


def both_ways(once: Iterable[IntegerVector], twice: Iterable[IntegerVector]) -> list[IntegerVector]:
    """Return the vectors of the first kind, and those of the second with both signs."""
    return [*once, *(x for y in twice for x in (y, negated(y)))]
