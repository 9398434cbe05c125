"""Chirotopes of rank 3 in batches, as numpy arrays of signs.

A chirotope of n elements is written as the signs of its triples i < j < k in lexicographic order
(int8, shape (..., C(n, 3))), or as an alternating array (..., n, n, n). Elements have no loops and
no two are parallel; chi and -chi are one oriented matroid.
"""

from __future__ import annotations

import itertools
from functools import lru_cache
from math import comb
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.errors import InputError

Signs: TypeAlias = NDArray[np.int8]
Vectors: TypeAlias = NDArray[np.int64]

#: Entries up to this size have determinants that int64 holds: 6 * 10^18 < 2^63.
LARGEST_ENTRY = 10**6


@lru_cache
def triples(n: int) -> NDArray[np.intp]:
    """The triples i < j < k below n, in lexicographic order."""
    return np.array(list(itertools.combinations(range(n), 3)), dtype=np.intp).reshape(-1, 3)


@lru_cache
def pairs(n: int) -> NDArray[np.intp]:
    """The pairs i < j below n, in lexicographic order."""
    return np.array(list(itertools.combinations(range(n), 2)), dtype=np.intp).reshape(-1, 2)


def chirotope_of(normals: NDArray[np.integer[Any]]) -> Signs:
    """Return the signs of the determinants of all triples of normals, shape (..., n, 3).

    Raises:
        InputError: an entry is larger than `LARGEST_ENTRY` in absolute value.
    """
    if np.abs(normals).max(initial=0) > LARGEST_ENTRY:
        raise InputError(f"entries of normals are at most {LARGEST_ENTRY} here")
    large = normals.astype(np.int64)
    first, second, third = (large[..., column, :] for column in triples(normals.shape[-2]).T)
    signs: Signs = np.sign((np.cross(first, second) * third).sum(-1)).astype(np.int8)
    return signs


def alternating(signs: Signs, n: int) -> Signs:
    """Return the alternating arrays (N, n, n, n) of chirotopes (N, C(n, 3))."""
    chi = np.zeros((len(signs), n, n, n), dtype=np.int8)
    i, j, k = triples(n).T
    for a, b, c in ((i, j, k), (j, k, i), (k, i, j)):
        chi[:, a, b, c] = signs
        chi[:, b, a, c] = -signs
    return chi


def extended(signs: Signs, localizations: Signs, n: int) -> Signs:
    """Return the chirotopes of n + 1 elements, given those of the last with each pair.

    Args:
        signs: one chirotope of n elements, (C(n, 3),).
        localizations: signs of (i, j, new) for the pairs i < j, (K, C(n, 2)).
    """
    new = triples(n + 1)
    last = new[:, 2] == n
    result = np.empty((len(localizations), len(new)), dtype=np.int8)
    result[:, ~last] = signs
    result[:, last] = localizations
    return result


def t_vectors(signs: Signs, n: int) -> NDArray[np.int64]:
    """Return how many points lie on k elements, for k = 0 to n: (N, n + 1)."""
    i, j = pairs(n).T
    through = (alternating(signs, n)[:, i, j] == 0).sum(2)  # both elements of the pair among them
    on = [(through == k).sum(1) // max(comb(k, 2), 1) for k in range(n + 1)]
    return np.stack(on, 1)


def regions(signs: Signs, n: int) -> NDArray[np.int64]:
    """Return how many regions each arrangement of pseudolines has, by Euler's formula: (N,)."""
    counts: NDArray[np.int64] = 2 + 2 * t_vectors(signs, n)[:, 2:] @ np.arange(1, n)
    return counts
