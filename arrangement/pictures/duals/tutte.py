"""Places for a planar drawing with straight edges that never cross: Tutte's theorem."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.drawing.scene.items import Floats
from arrangement.errors import extra
from arrangement.numbers.linear.rank import cycle_edges

Indices: TypeAlias = npt.NDArray[np.int64]

#: How often the weight of an edge grows with its length and with the areas beside it, which evens
#: out both.
_ROUNDS = 80
#: Weights stay between these, so that rounding cannot move a vertex across an edge.
_LEAST, _MOST = 1e-4, 1e4


def tutte_places(count: int, faces: Sequence[Sequence[int]], outer: Sequence[int]) -> Floats:
    """Return places (V, 2) with the outer face as a regular polygon in the unit circle.

    Args:
        count: the number of vertices V.
        faces: all faces of a 3-connected planar graph, as cycles.
        outer: one of them; its order decides which way round it is drawn.
    """
    at = math.pi / 2 + (2 * np.arange(len(outer)) + 1) * math.pi / len(outer)
    places = np.zeros((count, 2))
    places[list(outer)] = np.stack([np.cos(at), np.sin(at)], axis=1)
    inner = np.setdiff1d(np.arange(count), outer)
    inside = [cycle for cycle in faces if set(cycle) != set(outer)]
    pairs, beside = _edges(inside)
    weights = np.ones(len(pairs))
    corners = np.concatenate([np.array(cycle) for cycle in inside])
    following = np.concatenate([np.roll(cycle, -1) for cycle in inside])
    starts = np.cumsum([0, *map(len, inside[:-1])])
    places[inner] = _means(places, pairs, weights, inner)
    for _ in range(_ROUNDS):
        steps = places[pairs[:, 0]] - places[pairs[:, 1]]
        lengths = _even(np.hypot(steps[:, 0], steps[:, 1]))
        (x, y), (right, up) = places[corners].T, places[following].T
        areas = _even(np.abs(np.add.reduceat(x * up - y * right, starts)) / 2)
        mean = np.sqrt(areas[beside[:, 0]] * areas[beside[:, 1]])
        weights = np.asarray(np.clip(weights * mean**0.15 * lengths**0.05, _LEAST, _MOST))
        places[inner] = _means(places, pairs, weights, inner)
    return np.round(places, 9) + 0.0


def _edges(faces: Sequence[Sequence[int]]) -> tuple[Indices, Indices]:
    """Return the edges (E, 2) of some faces, and for each the faces beside it (one: twice)."""
    found: dict[tuple[int, int], list[int]] = {}
    for f, cycle in enumerate(faces):
        for u, v in cycle_edges(cycle):
            found.setdefault((min(u, v), max(u, v)), []).append(f)
    return np.array(list(found)), np.array([(f[0], f[-1]) for f in found.values()])


def _even(values: Floats) -> Floats:
    """Return values divided by their geometric mean."""
    return values / math.exp(float(np.log(values).mean()))


def _means(places: Floats, pairs: Indices, weights: Floats, inner: Indices) -> Floats:
    """Solve for the inner vertices, the others being fixed."""
    with extra("figures"):
        from scipy.sparse import coo_array
        from scipy.sparse.linalg import spsolve

    size, index = len(inner), np.full(len(places), -1)
    index[inner] = np.arange(size)
    ends, others = np.concatenate([pairs, pairs[:, ::-1]]).T
    kept = index[ends] >= 0
    rows, others, pulls = index[ends][kept], others[kept], np.tile(weights, 2)[kept]
    columns, diagonal = index[others], np.arange(size)
    free = columns >= 0
    entries = np.concatenate([-pulls[free], np.bincount(rows, pulls, size)])
    at = np.concatenate([[rows[free], columns[free]], [diagonal, diagonal]], axis=1)
    matrix = coo_array((entries, (at[0], at[1])), shape=(size, size)).tocsc()
    fixed = (pulls[:, None] * places[others])[~free].T
    right = np.stack([np.bincount(rows[~free], x, size) for x in fixed], axis=1)
    return np.asarray(spsolve(matrix, right))
