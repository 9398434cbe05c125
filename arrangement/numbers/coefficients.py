"""Arrays of numbers of one field as arrays of integers, int64 where a bound of their size allows.

The last axis has the coefficients of a number over the powers of the generator; over Q it has
length 1. So linear algebra over a field of degree c is linear algebra over the integers with
vectors c times as long, and engines that work with such arrays need nothing else for irrational
planes.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from .exact import largest, quotient, sign
from .float_filter import Signs, certain, error_bound, signs_of
from .real import Irrational, field_of

#: int64 where all entries fit, else Python integers.
Integers: TypeAlias = NDArray[Any]

#: Sums and products below this bound are exact in int64.
SAFE = 1 << 62


class Coefficients:
    """The field of some vectors of algebraic integers, and the arithmetic of arrays over it.

    Attributes:
        field: None for the rational numbers.
        degree: the length of the last axis of every array.
    """

    def __init__(self, rows: Sequence[Sequence[Any]]) -> None:
        self.field = field_of(x for row in rows for x in row)
        self.degree = 1 if self.field is None else self.field.degree
        products = [[1]]
        if self.field is not None:
            units = list(map(tuple, np.eye(self.degree, dtype=int).tolist()))
            products = [[x for v in units for x in self.field.product(u, v)] for u in units]
        # (c, c * c): from the coefficients of x to the matrix of y -> x y for rows y
        self._table = as_integers(products)

    def array(self, rows: Sequence[Sequence[Any]], n: int) -> Integers:
        """Return vectors with n entries as an array (rows, n, c)."""
        rest = (0,) * (self.degree - 1)
        vectors = [
            x
            for row in rows
            for y in row
            for x in (y.coefficients if isinstance(y, Irrational) else (y, *rest))
        ]
        return as_integers([vectors]).reshape(len(rows), n, self.degree)

    def numbers(self, array: Integers) -> Integers:
        """Return the numbers themselves: the array without its last axis."""
        if self.field is None:
            return array[..., 0]
        result = np.empty(array.shape[:-1], object)
        canonical = self.field.canonical
        flat = array.reshape(-1, self.degree).tolist()
        result.ravel()[:] = [canonical(tuple(x), 1) for x in flat]
        return result

    def matrices(self, array: Integers) -> Integers:
        """Return (..., c, c): the matrices by which these numbers multiply rows of coefficients."""
        array = for_products(array, self.degree * largest_entry(self._table))
        products = array.reshape(-1, self.degree) @ self._table
        return products.reshape(*array.shape, self.degree)

    def forms(self, vectors: Integers) -> Integers:
        """Return the matrix of the products with m vectors of n entries: (n c, m c)."""
        m, n, c = vectors.shape
        return self.matrices(vectors).transpose(1, 2, 0, 3).reshape(n * c, m * c)

    def signs(self, array: Integers) -> Signs:
        """Return the signs of numbers, an array without the last axis."""
        if self.field is None:
            return signs_of(array[..., 0])
        powers = np.array(self.field.float_powers)
        try:
            floats = array.astype(float)
        except OverflowError:
            floats = np.full(array.shape, np.nan)
        with np.errstate(invalid="ignore"):
            products = floats * powers
            values, sizes = products.sum(axis=-1), np.abs(products).sum(axis=-1)
        signs = signs_of(values)
        # an entry, a power and their product are rounded, and the sums
        open_ = ~certain(values, sizes, error_bound(self.degree + 3)) & array.any(axis=-1)
        for at in zip(*np.nonzero(open_), strict=True):
            number: Any = self.field.canonical(tuple(array[at].tolist()), 1)
            signs[at] = sign(number)
        return signs

    def unoriented(self, rows: Integers) -> tuple[Integers, NDArray[np.intp], Signs]:
        """Return one vector for each line of vectors; vectors that are 0 stay.

        Args:
            rows: (N, k, c).

        Returns:
            The multiples whose first entry that is not 0 is rational and positive, integral without
            a common divisor; the place of that entry, and the sign of the factor.
        """
        pivot = np.argmax(rows.any(axis=-1), axis=1)
        first = rows[np.arange(len(rows)), pivot]
        sides = self.signs(first)
        if rows.shape[1] == 1:
            return np.broadcast_to(self.one, rows.shape), pivot, sides
        rows = primitive(rows)
        if self.field is None:
            return rows * sides[:, None, None], pivot, sides
        factors = self.matrices(self._inverses(rows[np.arange(len(rows)), pivot]))
        rows = for_products(rows, self.degree * largest_entry(factors))
        return primitive(rows @ factors), pivot, sides

    def _inverses(self, array: Integers) -> Integers:
        """Return positive rational multiples of 1 / x for numbers x, and 0 for 0."""
        assert self.field is not None
        if self.degree == 2:
            conjugate = array * np.array([1, -1])
            wide = for_products(array, largest_entry(array) * 2 * largest_entry(self._table))
            norm = wide[:, 0] ** 2 - self._table[-1, 2] * wide[:, 1] ** 2
            positive: Integers = conjugate * signs_of(norm)[:, None]
            return positive
        canonical = self.field.canonical
        listed = list(map(tuple, array.tolist()))
        known = {x: quotient(1, canonical(x, 1)).numerator if any(x) else 0 for x in set(listed)}
        return self.array([[known[x]] for x in listed], 1)[:, 0]

    @property
    def one(self) -> Integers:
        """The coefficients of 1."""
        unit: Integers = np.eye(1, self.degree, dtype=np.int64)[0]
        return unit


def primitive(rows: Integers) -> Integers:
    """Return vectors (..., k, c), each divided by the greatest common divisor of its integers."""
    *outer, k, c = rows.shape
    joined = rows.reshape(*outer, k * c)
    divisor = np.abs(np.gcd.reduce(joined, axis=-1))  # of one object: with its sign
    whole: Integers = rows // np.maximum(divisor, 1)[..., None, None]
    return whole


def as_integers(rows: Sequence[Sequence[int]]) -> Integers:
    """Return a matrix, int64 where all entries fit."""
    return np.array(rows, np.int64 if largest(rows) < SAFE else object)


def for_products(array: Integers, factor: float) -> Integers:
    """Return the array as Python integers unless `factor` times its entries stays in int64."""
    exact = array.dtype == object or factor * max(1, largest_entry(array)) < SAFE
    return array if exact else array.astype(object)


def largest_entry(array: Integers) -> float:
    """Return the largest absolute value of an entry; those of int64 arrays are below 2^62."""
    if array.dtype == object:
        return largest([array.flat])
    return int(np.abs(array).max(initial=0))
