"""Brute force for central arrangements in R^3: all sign vectors, with no incidence at all.

Every covector is a composition of cocircuits. So: take all lines in which two planes meet (in
lower rank, their counterparts), both directions of each, and compose sign vectors until nothing
new appears. A face has dimension 3 minus the rank of its zero planes.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

Vector = tuple[int, ...]


def covectors(normals: Sequence[Vector]) -> tuple[set[Vector], ...]:
    """Return the sign vectors of all faces of dimension 0, 1, 2, 3; at most 30 planes."""
    matrix = np.array(normals, dtype=object).reshape(-1, 3)
    points = np.array(_cocircuit_points(normals), dtype=object).reshape(-1, 3)
    signs = np.sign((points @ matrix.T).astype(object)).astype(np.int8)
    cocircuits = np.vstack([signs, -signs])
    origin = np.zeros((1, len(normals)), np.int8)
    found = _closed_once(origin, cocircuits)
    while len(bigger := _closed_once(found, cocircuits)) > len(found):
        found = bigger
    faces: tuple[set[Vector], ...] = (set(), set(), set(), set())
    rank = cache(lambda zero: _rank([normals[i] for i in zero]))
    for row in found.tolist():
        zero = tuple(i for i, sign in enumerate(row) if sign == 0)
        faces[3 - rank(zero)].add(tuple(row))
    return faces


def _closed_once(found: NDArray[np.int8], cocircuits: NDArray[np.int8]) -> NDArray[np.int8]:
    """Return the rows of `found` and their compositions with cocircuits, each once."""
    left, right = found[:, None, :], cocircuits[None, :, :]
    shape = (len(found) * len(cocircuits), found.shape[1])
    composed = np.where(left != 0, left, right).reshape(shape)
    rows = np.vstack([found, composed])
    codes = (rows.astype(np.int64) + 1) @ 3 ** np.arange(found.shape[1], dtype=np.int64)
    return rows[np.unique(codes, return_index=True)[1]]


def _cocircuit_points(normals: Sequence[Vector]) -> list[Vector]:
    """Return points on all minimal faces above the smallest one, up to sign."""
    meets = {_line(cross(a, b)) for a in normals for b in normals} - {(0, 0, 0)}
    if len(meets) == 1:  # rank 2
        (axis,) = meets
        return [cross(normal, axis) for normal in normals]
    return sorted(meets) or list(normals[:1])


def _rank(vectors: Sequence[Vector]) -> int:
    meets = {_line(cross(a, b)) for a in vectors for b in vectors} - {(0, 0, 0)}
    return min(len(vectors), 1) if not meets else 2 if len(meets) == 1 else 3


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _line(vector: Vector) -> Vector:
    divisor = int(np.gcd.reduce(np.array(vector, dtype=object))) or 1
    reduced = tuple(x // divisor for x in vector)
    return max(reduced, tuple(-x for x in reduced))
