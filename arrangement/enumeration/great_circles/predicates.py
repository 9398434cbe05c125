"""The predicates of a great-circle arrangement, with the bounds that make them exact.

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
* the slope of a crossing (`slope_functions`) grows counterclockwise along the positive half circle.

Bounds. Let B be the largest absolute value of an entry. Then ``|d_ij| <= 2 B^2`` in each
coordinate; a determinant ``n_k . d_ij`` and each partial sum of it is at most ``6 B^3``; the
numerator of a slope, with its partial sums, is at most ``4 B^3``. All are exact in int64 if
``6 B^3 < 2^63``, and a slope is exact in floats, up to the rounding of its quotient, if
``4 B^3 <= 2^53``. SymPy's matrices take 150 times as long for all crossings of 200 circles (4 times
with python-flint, before anything is read out of them).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.numbers.exact import largest
from arrangement.numbers.float_filter import (
    EXACT,
    UNUSABLE,
    Booleans,
    Floats,
    Signs,
    certified_signs,
    error_bound,
    least_sizes,
    scale_rows,
    signs_of,
)

#: int64, or Python integers in an object array where int64 could overflow.
Integers: TypeAlias = NDArray[Any]
#: The same, or floats.
Numbers: TypeAlias = NDArray[Any]
Indices: TypeAlias = NDArray[np.integer]
Components: TypeAlias = tuple[Integers, Integers, Integers]

#: Stands for an infinite slope; no other is as large.
VERTICAL = 2.0**1000


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


def turns(directions: Components) -> Signs:
    """Return +1 where a vector is positive, -1 where its negative is, 0 where it is zero."""
    x, y, z = directions
    signs = signs_of(x)
    undecided = np.nonzero(signs == 0)
    if len(undecided[0]):
        second, third = signs_of(y[undecided]), signs_of(z[undecided])
        signs[undecided] = np.where(second != 0, second, third)
    return signs


def slope_functions(normals: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any], Signs]:
    """Return rows P, Q: the slope on circle i of its crossing with j is ``P_i . n_j / Q_i . n_j``.

    In the plane of circle i take the frame ``e1`` (projected) and ``n_i x e1``; then a positive
    vector d has ``d . e1 >= 0``, and its slope is ``d . (n_i x e1) / d . e1``; d is ``n_i x n_j``
    or its negative. The one circle with normal e1 uses e2 and e3 instead. Where the denominator
    is 0 the slope of the positive crossing is infinite; its sign on each circle is returned last.
    """
    a, b, c = normals.T
    zero = np.zeros_like(a)
    numerators = np.stack([b * b + c * c, -a * b, -a * c], axis=1)
    denominators = np.stack([zero, -c, b], axis=1)
    polar = (b == 0) & (c == 0)
    numerators[polar, 1], denominators[polar, 2] = a[polar], -a[polar]
    upper = np.where(polar, 1, np.where(c != 0, signs_of(c), -signs_of(b))).astype(np.int8)
    return numerators, denominators, upper


class ExactSigns:
    """The slopes of crossings, and the signs of products of normals in int64.

    Attributes:
        normals: (c, 3).
        reliable: no slope has a relative error above ``4 u``, u = 2^-53.
    """

    reliable = True

    def __init__(self, normals: Integers) -> None:
        self.normals = normals
        exact_in_floats = 4 * int(np.abs(normals).max()) ** 3 <= EXACT
        self._set_numbers(normals.astype(np.float64) if exact_in_floats else normals)

    def _set_numbers(self, numbers: NDArray[Any]) -> None:
        """Set what slopes are computed from: normals, or numbers near positive multiples."""
        self._columns = np.ascontiguousarray(numbers.T)
        self._numerators, self._denominators, self._upper = slope_functions(numbers)

    def slopes(self, block: slice) -> tuple[Floats, Booleans]:
        """Return slopes of the crossings of a block of circles with all, and where turns are -1.

        An infinite slope, and that of a circle with itself, is plus or minus `VERTICAL`.
        """
        numerators = _products(self._numerators[block], self._columns)
        denominators = _products(self._denominators[block], self._columns)
        backward: Booleans = denominators < 0  # it is the first coordinate that is not 0
        vertical = np.flatnonzero(denominators == 0)  # else the numerator has its sign
        upper = self._upper[block].take(vertical // denominators.shape[1])
        backward.ravel()[vertical] = numerators.take(vertical) * upper < 0
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            slopes: Floats = numerators / denominators
        slopes.ravel()[vertical] = VERTICAL * upper
        return slopes, backward

    def determinants(self, *circles: Indices) -> Signs:
        """Return the signs of ``det(n_i, n_j, n_k)`` for three arrays i, j, k."""
        return signs_of(_determinants([self.normals[i] for i in circles]))


class FilteredSigns(ExactSigns):
    """The same for normals beyond int64: floats where the bound of their error decides."""

    reliable = False
    #: Three entries, two products and three sums.
    error = error_bound(8)

    def __init__(self, normals: Integers) -> None:
        self.normals = normals
        rows = normals.tolist()
        self._numbers, usable = scale_rows(rows)
        self._least = least_sizes(rows)
        self._absolute = np.abs(self._numbers)
        if not usable.all():  # then they serve for proposals alone
            self.error = UNUSABLE
            self._absolute[...], self._least[...] = 1, 0
        self._set_numbers(self._numbers)

    def slopes(self, block: slice) -> tuple[Floats, Booleans]:
        """Return the same: slopes for a proposal alone, turns in exact numbers if need be."""
        # Of huge entries a slope may be finite and above that of a circle with itself.
        slopes = np.clip(np.nan_to_num(super().slopes(block)[0]), -VERTICAL, VERTICAL)
        here, there = np.arange(len(self.normals))[block, None], np.arange(len(self.normals))
        least = np.where(here == there, np.inf, self._least[here] * self._least)

        def component(k: int) -> Signs:
            after, before = (k + 1) % 3, (k + 2) % 3

            def minor(numbers: NDArray[Any], at: tuple[Any, Any], sign: int) -> NDArray[Any]:
                left, right = numbers[at[0]], numbers[at[1]]
                minors: NDArray[Any] = left[..., after] * right[..., before] + sign * (
                    left[..., before] * right[..., after]
                )
                return minors

            return certified_signs(
                minor(self._numbers, (here, there), -1),
                minor(self._absolute, (here, there), 1),
                self.error,
                least,
                lambda at: minor(self.normals, (here[at[0], 0], at[1]), -1),
            )

        return slopes, turns((component(0), component(1), component(2))) < 0

    def determinants(self, *circles: Indices) -> Signs:
        """Return the same with the determinants that floats leave open in exact numbers."""
        i, j, k = circles
        return certified_signs(
            _determinants([self._numbers[at] for at in circles]),
            _determinants([self._absolute[at] for at in circles], sign=1),
            self.error,
            self._least[i] * self._least[j] * self._least[k],
            lambda at: _determinants([self.normals[c[at]] for c in circles]),
        )


def _products(rows: Numbers, columns: Numbers) -> Numbers:
    """Return the matrix product of (r, 3) and (3, c) in NumPy alone, not in a library."""
    a, b, c = rows[:, :, None].transpose(1, 0, 2)
    products: Numbers = a * columns[0]
    products += b * columns[1]
    products += c * columns[2]
    return products


def _determinants(rows: Sequence[Numbers], sign: int = -1) -> Numbers:
    """Return the determinants of three arrays' rows, or with sign +1 the sizes of their sums."""
    a, b, c = rows
    parts = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
    x, y, z = (a[:, i] * (b[:, j] * c[:, k] + sign * (b[:, k] * c[:, j])) for i, j, k in parts)
    determinants: Numbers = x + y + z
    return determinants


def along_rows(values: NDArray[Any], columns: Indices) -> NDArray[Any]:
    """Return the entries of each row at its columns, as `numpy.take_along_axis`, but faster."""
    starts = np.arange(len(values))[:, None] * values.shape[1]
    entries: NDArray[Any] = values.take(columns + starts, mode="clip")
    return entries
