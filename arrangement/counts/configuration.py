"""The vectors behind an arrangement, in as few coordinates as their rank.

A central arrangement is the configuration of its normals. An affine one is homogenised: plane
``n . x = b`` becomes the vector ``(n, b)``, and one more vector, *infinity* ``(0, ..., 0, 1)``,
says which intersections are empty. Planes of a set S have a common point exactly when infinity
is outside the span of their vectors, and then the intersection has codimension rank(S).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, largest, shown
from arrangement.numbers.linear.rank import (
    ask_elimination,
    determinant,
    evenly_spaced,
    gauss_jordan,
    rank,
)
from arrangement.planes.planes import Hyperplane, Planes

#: Numbers of planes from 0, or planes of the arrangement themselves.
Indices = int | Hyperplane | Iterable[int | Hyperplane]
#: Minors are expanded modulo this prime.
PRIME = 2**26 - 5
#: Maximal minors that are looked at.
_MINORS = 10_000_000
#: With more that a prime divides, the vectors are taken for special ones.
_EXACT_MINORS = 20


@dataclass(frozen=True)
class Configuration:
    """Pairwise independent integer vectors, one for each class of coincident planes.

    Attributes:
        vectors: in the order of `Arrangement.distinct`, written in `rank` coordinates.
        infinity: the vector of the plane at infinity, or None for a central arrangement.
        rank: of all these vectors together, infinity included; also their length.
    """

    vectors: tuple[IntegerVector, ...]
    infinity: IntegerVector | None
    rank: int


def configuration(arrangement: Planes) -> Configuration:
    """Return the vectors of an arrangement in as few coordinates as their rank.

    The coordinates kept are the pivot columns. Leaving out the others is injective on the span,
    so every dependency stays as it is, and no entry grows.
    """
    planes = arrangement.distinct_planes
    if arrangement.is_central:
        vectors = [plane[:-1] for plane in planes]
    else:
        vectors = [*planes, (0,) * arrangement.dimension + (1,)]
    columns = pivot_columns(vectors, arrangement.dimension + (not arrangement.is_central))
    kept = [tuple([vector[j] for j in columns]) for vector in vectors]
    infinity = None if arrangement.is_central else kept.pop()
    return Configuration(tuple(kept), infinity, len(columns))


def pivot_columns(rows: Sequence[IntegerVector], width: int) -> tuple[int, ...]:
    """Return columns that form a basis of the column space; their number is the rank."""
    if not len(rows):
        return ()
    sample = evenly_spaced(rows, 2 * width)
    ask_elimination(sample, width)
    pivots = gauss_jordan(sample)[1]
    if len(sample) < len(rows) and len(pivots) < width and len(pivots) < rank(rows):
        pivots = gauss_jordan(rows)[1]
    return tuple(pivots)


def indices(arrangement: Planes, planes: Indices) -> tuple[int, ...]:
    """Return plane indices, each checked; a hyperplane stands for the first one equal to it."""
    single = (int, str, Hyperplane)
    chosen: tuple[Any, ...] = (planes,) if isinstance(planes, single) else tuple(planes)
    if len(chosen) == 1 and isinstance(chosen[0], Iterable) and not isinstance(chosen[0], single):
        chosen = tuple(chosen[0])
    if any(isinstance(plane, Hyperplane) for plane in chosen):
        places = {plane: i for i, plane in reversed(list(enumerate(arrangement)))}
        chosen = tuple(places.get(p, p) if isinstance(p, Hyperplane) else p for p in chosen)
    for plane in chosen:
        number = hasattr(plane, "__index__") and not isinstance(plane, bool)
        if not number or not 0 <= plane < len(arrangement):
            raise InputError(
                f"plane {shown(plane)} does not exist; this arrangement has {len(arrangement)} "
                "planes, counted from 0"
            )
    return chosen


def flats_foreseen(planes: int, rank: int, known: int, flats: float) -> float:
    """Return about how many flats of a rank there are, where this many of a known rank were found.

    In general position C(m, k) flats have the rank k. Of special planes it is a share near
    s^(k(k-1)/2), where s is known from the second rank on: measured on braids, resonance
    arrangements and random small normals.
    """
    share = (flats / max(1, budget.choose(planes, known))) ** (1 / max(1, known * (known - 1)))
    foreseen: float = budget.choose(planes, rank) * share ** (rank * (rank - 1))
    return foreseen


def is_generic(config: Configuration) -> bool:
    """Return whether every basis-many of the vectors, infinity included, are seen to be one.

    Then every flat has as many planes as its rank, and none is parallel to another. False says
    nothing: there may be too many of them, or too many that a prime divides.

    Where r of n vectors are the identity, the minors of order r of all are the minors of every
    order of the others. A row more at a time, they are expanded along it, modulo a prime: what is
    not 0 there is not 0. The few that are 0 there are computed exactly.
    """
    rows = [*config.vectors, *([] if config.infinity is None else [config.infinity])]
    rank, others = config.rank, len(rows) - config.rank
    if math.comb(len(rows), rank) > _MINORS or not others or largest(rows) == math.inf:
        return len(rows) == rank
    from flint import nmod_mat

    echelon, count = nmod_mat(list(map(list, zip(*rows, strict=True))), PRIME).rref()
    if count < rank:
        return False
    reduced = np.array([list(map(int, row)) for row in echelon.tolist()])
    pivots = (reduced != 0).argmax(axis=1)
    left = np.delete(np.arange(len(rows)), pivots)
    matrix = reduced[:, left]
    minors = np.ones((1, 1), dtype=np.int64)
    for k in range(1, min(rank, others) + 1):
        chosen, columns = _subsets(rank, k), _subsets(others, k)
        above = _place(chosen[:, :-1])[:, None]
        larger = np.zeros((len(chosen), len(columns)), dtype=np.int64)
        for j in range(k):
            rest = _place(np.delete(columns, j, axis=1))
            term = matrix[np.ix_(chosen[:, -1], columns[:, j])] * minors[above, rest]
            larger += (-1) ** j * term  # below rank * PRIME^2, far below 2^63
        minors = larger % PRIME
        zeros = np.argwhere(minors == 0)
        if len(zeros) > _EXACT_MINORS:
            return False
        for row, column in zeros:
            kept = np.delete(pivots, chosen[row])
            basis = [*kept, *left[columns[column]]]
            if not determinant([rows[i] for i in basis]):
                return False
    return True


def _subsets(n: int, k: int) -> NDArray[np.intp]:
    """Return the subsets of k of n numbers, increasing each, in the order of their places."""
    subsets = np.array(list(combinations(range(n), k)), dtype=np.intp)
    return subsets[np.argsort(_place(subsets))]


def _place(subsets: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return the place of each subset among those of its size, ordered by the last element."""
    place = np.zeros(len(subsets), dtype=np.intp)
    for i, column in enumerate(subsets.T, start=1):
        place += np.array([math.comb(x, i) for x in range(subsets.max() + 1)])[column]
    return place
