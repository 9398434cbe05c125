"""The vectors behind an arrangement, in as few coordinates as their rank.

A central arrangement is the configuration of its normals. An affine one is homogenised: plane
``n . x = b`` becomes the vector ``(n, b)``, and one more vector, *infinity* ``(0, ..., 0, 1)``,
says which intersections are empty. Planes of a set S have a common point exactly when infinity
is outside the span of their vectors, and then the intersection has codimension rank(S).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from arrangement.numbers.exact import IntegerVector, largest
from arrangement.numbers.linear.rank import ask_elimination, echelon, rank, spanning, spread
from arrangement.numbers.symbolic import exact_matrix
from arrangement.planes.planes import Planes


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
    """Return columns that form a basis of the column space; their number is the rank.

    Columns that are independent modulo a prime are; where they are as many as the rank, they do.
    """
    if len(rows) > 2 * width and rank(spread(rows, 2 * width)) == width:
        return tuple(range(width))
    if len(rows) and largest(rows) < math.inf:
        pivots = echelon(rows)[1]
        if len(pivots) in (width, len(rows)) or len(pivots) == rank(rows):
            return tuple(pivots)
    ask_elimination(rows, width)
    found: tuple[int, ...] = exact_matrix(spanning(rows), width).rref_den()[2]
    return found
