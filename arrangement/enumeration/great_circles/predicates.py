"""The three predicates of a great-circle arrangement, with the bounds that make int64 exact.

Every circle is the trace on the unit sphere of the plane ``n . x = 0``. A vector is *positive* if
its first nonzero coordinate is positive; of a vector and its negative exactly one is. All normals
here are integer and positive, and no two are equal.

With ``d_ij = n_i x n_j`` and ``turn_ij`` = +1 or -1 so that ``turn_ij d_ij`` is positive:

* ``turn_ij`` says on which side of circle i the positive crossing with circle j leaves: seen
  from outside, circle j runs counterclockwise of circle i at their positive crossing exactly
  when ``turn_ij = +1``. Moving counterclockwise about ``n_i`` through that crossing, the sign of
  ``n_j . x`` changes from ``turn_ij`` to ``-turn_ij``.
* ``det(n_i, n_j, n_k) turn_ij turn_ik`` is positive exactly when, counterclockwise about ``n_i``,
  the positive crossing with k comes less than half a turn after that with j, because
  ``(n_i x n_j) x (n_i x n_k) = n_i det(n_i, n_j, n_k)``.
* the slope of a crossing (`slope_terms`) grows counterclockwise along the positive half circle.

Bounds. Let B be the largest absolute value of an entry. Then ``|d_ij| <= 2 B^2`` in each
coordinate; a determinant ``n_k . d_ij`` and each partial sum of it is at most ``6 B^3``; the
numerator of a slope is at most ``4 B^3``. All are exact in int64 if ``6 B^3 < 2^63``. SymPy's
matrices take 150 times as long for all crossings of 200 circles (4 times with python-flint, before
anything is read out of them).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.exact import largest
from arrangement.float_filter import (
    UNUSABLE,
    Signs,
    decided,
    error_bound,
    least_sizes,
    scaled,
    signs_of,
)
from arrangement.linear import cross, triple_product

#: int64, or Python integers in an object array where int64 could overflow.
Integers: TypeAlias = NDArray[Any]
Indices: TypeAlias = NDArray[np.intp]
Components: TypeAlias = tuple[Integers, Integers, Integers]


def integer_array(
    rows: Sequence[tuple[int, ...]], degree_bound: int = 3, factor: int = 6
) -> Integers:
    """Return integer rows as int64 if ``factor * B^degree_bound < 2^63``, else as Python integers.

    The default is the bound proven above. The choice depends on the largest entry B alone.
    """
    exact_in_int64 = factor * largest(rows) ** degree_bound < 2**63
    array = np.empty((len(rows), 3), dtype=np.int64 if exact_in_int64 else object)
    array[...] = np.array(rows, dtype=array.dtype).reshape(-1, 3)
    return array


def cross_products(left: Integers, right: Integers) -> Components:
    """Return the coordinates of all ``left[i] x right[j]``, rows i and columns j."""
    ax, ay, az = (left[:, k, None] for k in range(3))
    bx, by, bz = (right[None, :, k] for k in range(3))
    return ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx


def turns(directions: Components) -> Signs:
    """Return +1 where a vector is positive, -1 where its negative is, 0 where it is zero."""
    x, y, z = directions
    found = signs_of(x)
    undecided = np.nonzero(found == 0)
    if len(undecided[0]):
        second, third = signs_of(y[undecided]), signs_of(z[undecided])
        found[undecided] = np.where(second != 0, second, third)
    return found


class ExactSigns:
    """The signs of products of normals in int64.

    Attributes:
        normals: (c, 3).
        numbers: the same, or floats near positive multiples, for a proposal.
    """

    def __init__(self, normals: Integers) -> None:
        self.normals = self.numbers = normals

    def turns(self, directions: Components, block: slice) -> Signs:
        """Return `turns` of the cross products of a block of the normals with all of them."""
        return turns(directions)

    def determinants(
        self, directions: Components, block: slice, here: Indices, there: Indices
    ) -> Signs:
        """Return the signs of ``det(n_i, n_j, n_k)``, row i of the block, j in here, k in there."""
        return signs_of(_determinants(self.numbers, directions, here, there))


class FilteredSigns(ExactSigns):
    """The same for normals beyond int64: floats where the bound of their error decides."""

    #: Three entries, two products and three sums.
    error = error_bound(8)

    def __init__(self, normals: Integers) -> None:
        self.normals = normals
        rows = normals.tolist()
        self.numbers, usable = scaled(rows)
        self._least = least_sizes(rows)
        self._absolute = np.abs(self.numbers)
        if not usable.all():  # then they serve for proposals alone
            self.error = UNUSABLE
            self._absolute[...], self._least[...] = 1, 0

    def turns(self, directions: Components, block: slice) -> Signs:
        """Return the same with the products that floats leave open in exact numbers."""
        here, least = np.arange(len(self.normals))[block], self._least
        sizes = self._sizes(block)
        for part in sizes:
            part[np.arange(len(here)), here] = 0  # that of a normal with itself

        def exact(k: int) -> Callable[[tuple[Indices, ...]], Integers]:
            after, before = (k + 1) % 3, (k + 2) % 3

            def component(at: tuple[Indices, ...]) -> Integers:
                left, right = self.normals[here[at[0]]], self.normals[at[1]]
                found: Integers = left[:, after] * right[:, before] - (
                    left[:, before] * right[:, after]
                )
                return found

            return component

        bound = least[here][:, None] * least
        parts = [decided(directions[k], sizes[k], self.error, bound, exact(k)) for k in range(3)]
        return turns((parts[0], parts[1], parts[2]))

    def determinants(
        self, directions: Components, block: slice, here: Indices, there: Indices
    ) -> Signs:
        """Return the same with the determinants that floats leave open in exact numbers."""
        own = np.arange(len(self.normals))[block]

        def exact(at: tuple[Indices, ...]) -> Integers:
            rows = (self.normals[own[at[0]]], self.normals[here[at]], self.normals[there[at]])
            return np.array([triple_product(*row) for row in zip(*rows, strict=True)], object)

        return decided(
            _determinants(self.numbers, directions, here, there),
            _determinants(self._absolute, self._sizes(block), here, there),
            self.error,
            self._least[own][:, None] * self._least[here] * self._least[there],
            exact,
        )

    def _sizes(self, block: slice) -> Components:
        """Return the sums of the absolute products in all cross products."""
        sizes = self._absolute
        a, b, c = (sizes[block, k, None] for k in range(3))
        x, y, z = (sizes[None, :, k] for k in range(3))
        return b * z + c * y, c * x + a * z, a * y + b * x


def along_rows(values: NDArray[Any], columns: Indices) -> NDArray[Any]:
    """Return the entries of each row at its columns, as `numpy.take_along_axis`, twice as fast."""
    starts = np.arange(len(values))[:, None] * values.shape[1]
    found: NDArray[Any] = values.take(columns + starts)
    return found


def _determinants(
    normals: Integers, directions: Components, here: Indices, there: Indices
) -> Integers:
    x, y, z = (along_rows(part, here) for part in directions)
    n = [np.ascontiguousarray(normals[:, k]).take(there) for k in range(3)]
    determinants: Integers = n[0] * x + n[1] * y + n[2] * z
    return determinants


def slope_terms(normals: Integers, directions: Components) -> tuple[Integers, Integers]:
    """Return numerators p and denominators q of the slopes of crossings, before orientation.

    In the plane of circle i take the frame ``e1`` (projected) and ``n_i x e1``; then a positive
    vector d has ``q = d . e1 >= 0`` and ``p = d . (n_i x e1)``. The one circle with normal e1 uses
    e2 and e3 instead. For ``-d`` both change sign.
    """
    x, y, z = directions
    p = y * normals[:, 2, None] - z * normals[:, 1, None]
    polar = np.nonzero((normals[:, 1] == 0) & (normals[:, 2] == 0))[0]
    if len(polar):
        q = x.copy()
        p[polar], q[polar] = z[polar], y[polar]
        return p, q
    return p, x


def exact_slope_terms(normal: tuple[int, ...], other: tuple[int, ...]) -> tuple[int, int]:
    """Return (p, q) of the positive crossing of two circles in Python integers, ``q >= 0``."""
    _, b, c = normal
    x, y, z = cross(normal, other)
    leading = x or y or z
    p, q = (z, y) if b == c == 0 else (y * c - z * b, x)
    return (p, q) if leading > 0 else (-p, -q)
