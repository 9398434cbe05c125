"""Certified signs of determinants of planes: floats within a proven error, else integers.

A plane is a row ``(n, b)`` of four integers, ``{x : n . x = b}``. For rows i and j let
``D_ij = n_i x n_j`` and ``M_ij = n_i b_j - n_j b_i``, the six 2x2 minors. Then, with D3 the
determinant of three normals and D4 that of four rows,

* ``D3(i, j, k) = D_ij . n_k``;
* ``D4(i, j, k, l) = D_ij . M_kl + M_ij . D_kl`` (Laplace expansion by two rows);
* planes k and l meet the line ``P + t D_ij`` of planes i and j at parameters with
  ``t_l - t_k = D4(i, j, k, l) / (D3(i, j, k) D3(i, j, l))``.

Error bound. A row is divided by a power of two, which moves nothing, and rounded to floats. All
determinants are sums of products; no product takes more than `_ROUNDINGS`, in any order of
summation, so `arrangement.numbers.float_filter` bounds the error. S = 0 proves that the
determinant is 0: four planes through the origin need no integers.

Small integers. For entries up to B, the six products of D4 and each partial sum are at most
``24 B^4`` (each D and M at most ``2 B^2``), those of all other determinants less. If that is at
most 2^53, floats are exact.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.numbers.exact import IntegerVector, largest
from arrangement.numbers.float_filter import (
    EXACT,
    UNUSABLE,
    Floats,
    Signs,
    decided,
    error_bound,
    least_sizes,
    scaled,
    signs_of,
)

#: Python integers.
Integers: TypeAlias = NDArray[Any]
Numbers: TypeAlias = NDArray[Any]
Indices: TypeAlias = NDArray[np.intp]

#: Of each product in D4: four entries, two minors of two each, one product, five sums.
_ROUNDINGS = 4 + 2 * 2 + 1 + 5
ERROR = error_bound(_ROUNDINGS)


class PlaneTable:
    """Pairwise different planes in R^3, as integers and as floats with a known error.

    Attributes:
        exact: (n, 4) Python integers.
        floats: (n, 4), rows near positive multiples of the exact ones.
        error: a determinant of the floats is wrong by at most `error` times the sum of its
            absolute products. 0 where all determinants are small integers. `UNUSABLE` where floats
            cannot hold the rows: they are all 1 then, and integers decide everything.
        minors, sizes: (n, n, 6); ``(D_ij, M_ij)`` in floats, and their absolute products.
        axis: (n, n); the first coordinate in which ``D_ij`` is not 0.
        turn: (n, n); its sign there, or 0 for parallel planes.
    """

    def __init__(self, rows: Sequence[IntegerVector]) -> None:
        self.exact: Integers = np.empty((len(rows), 4), dtype=object)
        self.exact[...] = np.array(rows, dtype=object).reshape(-1, 4)
        self.floats, self.error = scaled_floats(rows)
        self.minors = minors(self.floats[:, None], self.floats[None])
        self.sizes = _sizes(self.floats)
        usable = self.error < UNUSABLE
        self._least = least_sizes(rows) if usable and self.error else np.zeros(len(rows))
        least = (self._least[:, None] * self._least)[..., None]
        components = self._signs(
            self.minors[..., :3], self.sizes[..., :3], self._exact_component, least
        )
        self.axis: Indices = np.argmax(components != 0, axis=-1)
        self.turn: Signs = np.take_along_axis(components, self.axis[..., None], axis=-1)[..., 0]

    def __len__(self) -> int:
        return len(self.exact)

    def triples(self, i: Indices, j: Indices) -> tuple[Signs, Floats]:
        """Return the signs of ``D3(i, j, k)`` for all planes k, a row for each pair, and floats."""

        def exact(at: tuple[Indices, ...]) -> Integers:
            row, k = at
            return _dot3(self.exact_minors(i[row], j[row]), self.exact[k])

        normals = self.floats[:, :3].T
        values = self.minors[i, j, :3] @ normals
        sizes = self.sizes[i, j, :3] @ np.abs(normals)
        row = np.arange(len(i))
        for own in (i, j):
            values[row, own] = sizes[row, own] = 0.0
        pairs = self._least[i] * self._least[j]
        return self._signs(values, sizes, exact, pairs[:, None] * self._least), values

    def sides(self, i: Indices, j: Indices, k: Indices) -> Signs:
        """Return the sides of planes k on which the lines of i and j lie, if parallel to them."""
        axis = self.axis[i, j]

        def exact(at: tuple[Indices, ...]) -> Integers:
            minor = self.exact_minors(i[at], j[at])
            return _value_on_line(minor, self.exact[k[at]], axis[at], -1)

        values = _value_on_line(self.minors[i, j], self.floats[k], axis, -1)
        sizes = _value_on_line(self.sizes[i, j], np.abs(self.floats[k]), axis, 1)
        least = self._least[i] * self._least[j] * self._least[k]
        return self._signs(values, sizes, exact, least) * self.turn[i, j]

    def quadruples(self, i: Indices, j: Indices, k: Indices, l: Indices, use: Any) -> Signs:  # noqa: E741
        """Return the signs of ``D4(i, j, k, l)`` where `use` is set, else 0.

        Args:
            i, j: (L) planes of lines.
            k, l: (L, c) planes that cross them.
            use: (L, c) Booleans.
        """

        def exact(at: tuple[Indices, ...]) -> Integers:
            row = at[0]
            return _dot6(self.exact_minors(i[row], j[row]), self.exact_minors(k[at], l[at]))

        pair = k * len(self) + l
        line, crossing = self.minors[i, j], self.minors.reshape(-1, 6)[pair]
        values = _by_line(line, crossing)
        sizes = _by_line(self.sizes[i, j], self.sizes.reshape(-1, 6)[pair])
        unused = ~use
        values[unused] = sizes[unused] = 0.0
        pairs = self._least[i] * self._least[j]
        least = pairs[:, None] * self._least[k] * self._least[l]
        return self._signs(values, sizes, exact, least)

    def exact_parameters(self, i: int, j: int, crossing: Indices) -> tuple[Integers, Integers]:
        """Return numerators and positive denominators that order crossings of one line exactly.

        They are the parameters up to a positive factor, counted from the first crossing.
        """
        here = self.exact_minors(np.full_like(crossing, i), np.full_like(crossing, j))
        below = _dot3(here, self.exact[crossing])
        above = _dot6(here, self.exact_minors(np.full_like(crossing, crossing[0]), crossing))
        flip = np.where(below < 0, -1, 1).astype(object)
        first = 1 if below[0] > 0 else -1
        return above * flip * first, below * flip

    def exact_minors(self, i: Indices, j: Indices) -> Integers:
        """Return the six minors of pairs of rows in Python integers."""
        return minors(self.exact[i], self.exact[j])

    def _exact_component(self, at: tuple[Indices, ...]) -> Integers:
        i, j, component = at
        return self.exact_minors(i, j)[np.arange(len(i)), component]

    def _signs(
        self,
        values: Floats,
        sizes: Floats,
        exact: Callable[[tuple[Indices, ...]], Integers],
        least: Floats,
    ) -> Signs:
        """Return the signs of determinants; `exact` gives those that the floats leave open."""
        if self.error == 0:
            return signs_of(values)
        return decided(values, sizes, self.error, least, exact)


def scaled_floats(rows: Sequence[IntegerVector]) -> tuple[Floats, float]:
    """Return floats near positive multiples of integer rows, and the `error` of determinants."""
    if 24 * largest(rows) ** 4 <= EXACT:
        return np.array(rows, dtype=np.float64).reshape(-1, 4), 0.0
    floats, usable = scaled(rows)
    return (floats, ERROR) if usable.all() else (np.ones_like(floats), UNUSABLE)


def minors(left: Numbers, right: Numbers) -> Numbers:
    """Return the six minors ``(D, M)`` of rows along the last axis."""
    a, b, c, p = (left[..., m] for m in range(4))
    u, v, w, q = (right[..., m] for m in range(4))
    parts = [b * w - c * v, c * u - a * w, a * v - b * u]
    parts += [a * q - u * p, b * q - v * p, c * q - w * p]
    return np.stack(parts, axis=-1)


def _sizes(floats: Floats) -> Floats:
    """Return the sums of the absolute products in all minors."""
    left, right = np.abs(floats)[:, None], np.abs(floats)[None]
    moment = left[..., :3] * right[..., 3:] + right[..., :3] * left[..., 3:]
    after, before = [1, 2, 0], [2, 0, 1]
    direction = left[..., after] * right[..., before] + left[..., before] * right[..., after]
    return np.concatenate([direction, moment], axis=-1)


def _dot3(minor: Numbers, row: Numbers) -> Numbers:
    found: Numbers = (minor[..., :3] * row[..., :3]).sum(axis=-1)
    return found


def _dot6(left: Numbers, right: Numbers) -> Numbers:
    direction, moment = left[..., :3] * right[..., 3:], left[..., 3:] * right[..., :3]
    found: Numbers = (direction + moment).sum(axis=-1)
    return found


def _by_line(line: Floats, crossing: Floats) -> Floats:
    """Return D4 for each line (a row of minors) and each of its pairs of planes."""
    exchanged = np.concatenate([line[:, 3:], line[:, :3]], axis=1)
    found: Floats = np.matmul(crossing, exchanged[:, :, None])[..., 0]
    return found


def _value_on_line(minor: Numbers, row: Numbers, axis: Indices, minus: int) -> Numbers:
    """Return ``(n_k . P - b_k) D_m`` for the point P of the line with coordinate m equal to 0.

    `minus` is -1, or +1 for the sum of the absolute products.
    """
    at = np.arange(len(axis))
    a, c = (axis + 1) % 3, (axis + 2) % 3
    found: Numbers = (
        row[at, c] * minor[at, 3 + a]
        + minus * (row[at, a] * minor[at, 3 + c])
        + minus * (row[at, 3] * minor[at, axis])
    )
    return found
