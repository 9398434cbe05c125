"""Vectors for one-element extensions of rank 3, from a box of small integers, exactly tested.

A vector v extends an arrangement to a given one-element extension when ``v . r`` has the wanted
sign for each ray r = a_i x a_j. All vectors of the box are tried together, the smallest first.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from .chirotopes import Signs, Vectors, pairs
from .codes import Integers

#: Products are sums of three integers; float32 gives them exactly below this.
_EXACT_IN_FLOAT32 = 2**24


@lru_cache(maxsize=2)
def box(size: int) -> Vectors:
    """Return the primitive vectors with entries up to `size`, up to sign, smallest first."""
    entries = np.arange(-size, size + 1)
    vectors = np.stack(np.meshgrid(entries, entries, entries, indexing="ij"), -1).reshape(-1, 3)
    vectors = vectors[np.gcd.reduce(vectors, axis=1) == 1]
    first = vectors[np.arange(len(vectors)), (vectors != 0).argmax(1)]
    vectors = vectors[first > 0]
    sizes = np.abs(vectors)
    ordered: Vectors = vectors[np.lexsort((*vectors.T[::-1], sizes.sum(1), sizes.max(1)))]
    return ordered


def keys(localizations: Signs) -> Integers:
    """Return an integer for each row of at most 39 signs, equal for a row and its negative."""
    first = localizations[np.arange(len(localizations)), (localizations != 0).argmax(1)]
    powers = 3 ** np.arange(localizations.shape[1], dtype=np.int64)
    result: Integers = (localizations * first[:, None]).astype(np.int64) @ powers
    return result


def smallest_vectors(normals: Vectors, wanted: Integers, size: int) -> NDArray[np.intp]:
    """Return the place in `box(size)` of the first vector with each wanted key, or -1."""
    available, first = np.unique(keys(_localizations(normals, box(size))), return_index=True)
    place = np.searchsorted(available, wanted).clip(max=len(available) - 1)
    return np.where(available[place] == wanted, first[place], -1)


def _localizations(normals: Vectors, vectors: Vectors) -> Signs:
    """Return the signs of det(a_i, a_j, v) for the pairs i < j and all vectors v, (V, pairs)."""
    i, j = pairs(len(normals)).T
    rays = np.cross(normals[i], normals[j])
    if 3 * int(np.abs(rays).max()) * int(np.abs(vectors).max()) >= _EXACT_IN_FLOAT32:
        return np.sign(vectors @ rays.T).astype(np.int8)
    return np.sign(vectors.astype(np.float32) @ rays.T.astype(np.float32)).astype(np.int8)
