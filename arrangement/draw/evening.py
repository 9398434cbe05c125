"""A linear change of coordinates after which the regions of an arrangement are more alike.

Such a map changes no sign vector and no incidence. It serves pictures only, so it is in floats.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

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
