"""A linear change of coordinates after which the regions of an arrangement are more alike.

Such a map changes no sign vector and no incidence. It serves pictures only. It is found in floats;
where planes are drawn after it, it is rounded to rationals and applied exactly.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import numpy.typing as npt

from arrangement.arrangement import Arrangement
from arrangement.exact import dot
from arrangement.linear import rank

Floats = npt.NDArray[np.float64]

#: Mean squares of unit normals below this, in some direction, make slivers.
NARROW = 0.08
_ROUNDS = 12
_PULL = 0.1


def evening_map(normals: Floats) -> Floats:
    """Return a matrix W of determinant 1 such that the directions of ``W n`` are spread evenly.

    Normals n become ``W n`` and points x become ``W^-T x``. The rounds are those of Tyler's
    estimator of scatter, pulled towards the identity, so that they end for every input.

    Args:
        normals: (c, 3) unit vectors of distinct planes, of rank 3.
    """
    whole = np.eye(3)
    for _ in range(_ROUNDS):
        moved = normals @ whole.T
        moved /= np.linalg.norm(moved, axis=1, keepdims=True)
        scatter = (1 - _PULL) * 3 * moved.T @ moved / len(moved) + _PULL * np.eye(3)
        sizes, axes = np.linalg.eigh(scatter)
        whole = (axes / np.sqrt(sizes)) @ axes.T @ whole
    even: Floats = whole / np.cbrt(np.linalg.det(whole))
    return even


def is_narrow(normals: Floats) -> bool:
    """Return whether unit normals leave some direction nearly empty."""
    return bool(np.linalg.eigvalsh(normals.T @ normals / len(normals))[0] < NARROW)


def evened(arrangement: Arrangement) -> Arrangement:
    """Return central planes of rank 3 in R^3 with normals spread evenly; others unchanged.

    The normals go through one invertible rational matrix, so that all sign vectors, and with them
    all faces and their incidences, stay what they were.

    >>> narrow = Arrangement([[1, t, t * t] for t in range(9)])
    >>> evened(narrow).f_vector == narrow.f_vector
    True
    """
    if arrangement.dimension != 3 or arrangement.rank != 3 or not arrangement.is_central:
        return arrangement
    firsts = [arrangement.integer_planes[members[0]][:3] for members in arrangement.distinct]
    scaled = np.array([[x / max(map(abs, n)) for x in n] for n in firsts])
    whole = evening_map(scaled / np.linalg.norm(scaled, axis=1, keepdims=True))
    scale = 1 << 7
    rows: list[tuple[int, ...]] = []
    while rank(rows) < 3:
        scale *= 8
        rows = [tuple(round(x * scale) for x in row) for row in whole.tolist()]
    return Arrangement(
        [[Fraction(dot(row, plane[:3]), scale) for row in rows]
         for plane in arrangement.integer_planes]
    )  # fmt: skip
