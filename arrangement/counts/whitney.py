"""Characteristic polynomial, Whitney numbers, and Zaslavsky's counts of faces and regions.

Everything here is read off one table: the sums of |mu(X, Y)| over flats X <= Y of ranks k and j.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from arrangement.console.number_form import table
from arrangement.counts.classes.symmetric import flats_and_faces
from arrangement.errors import InputError
from arrangement.planes.planes import Planes

from .classes.symmetric import first_whitney_numbers
from .configuration import configuration
from .lattice import intersection_lattice
from .low_rank import MAX_RANK, WhitneyMatrix, whitney_matrix
from .operations import over_factors

if TYPE_CHECKING:
    import sympy


class WhitneyNumbers(NamedTuple):
    """The Whitney numbers by rank 0, 1, ...: sums of mu (first kind), numbers of flats (second)."""

    first: tuple[int, ...]
    second: tuple[int, ...]

    def _repr_html_(self) -> str:
        return table(self, self._fields)


def doubly_indexed_whitney_numbers(arrangement: Planes) -> WhitneyMatrix:
    """Return the table V, V[k][j] = sum of |mu(X, Y)| over flats X <= Y of rank k and j.

    Its first row gives the characteristic polynomial, its diagonal the flats, its row sums the
    faces. Central arrangements of rank <= 4 and affine ones of rank <= 3 take a vectorised route
    that needs no lattice; the others go through `intersection_lattice`.

    Complexity: up to rank 3 (affine: 2) O(m^2 log m) for m planes; central rank 4 and affine
    rank 3 O(L m log m) with L <= m^2 / 2 flats of rank 2; beyond, the square of the number of
    flats at worst.

    Source: C. Greene, T. Zaslavsky, Trans. AMS 280 (1983), section 2.
    """
    config = configuration(arrangement)
    if config.rank <= MAX_RANK:
        return whitney_matrix(config)
    return intersection_lattice(arrangement).whitney_matrix


def whitney_numbers(arrangement: Planes) -> WhitneyNumbers:
    """Return the Whitney numbers of both kinds; many symmetries help, as in `f_vector`.

    >>> from arrangement import Arrangement
    >>> whitney_numbers(Arrangement([[1, 0], [0, 1], [1, 1]]))
    WhitneyNumbers(first=(1, -3, 2), second=(1, 3, 1))
    """
    config = configuration(arrangement)
    if config.rank <= MAX_RANK:
        table = whitney_matrix(config)
        unsigned, second = table[0], tuple(row[k] for k, row in enumerate(table))
    else:
        first = first_whitney_numbers(arrangement)
        by_classes = flats_and_faces(arrangement, config, faces=False)
        if by_classes is not None:
            return WhitneyNumbers(first, by_classes[0])
        return WhitneyNumbers(first, tuple(map(len, intersection_lattice(arrangement).masks)))
    return WhitneyNumbers(tuple((-1) ** j * value for j, value in enumerate(unsigned)), second)


def characteristic_polynomial(
    arrangement: Planes,
    *,
    symmetry: Sequence[Sequence[int]] | None = None,
    time_limit: float | None = None,
) -> sympy.Poly:
    """Return chi(t) = sum over flats X of mu(X) t^dim(X), an integer polynomial in ``t``.

    Coincident planes count once. Options, errors, complexity: see `first_whitney_numbers`.

    >>> from arrangement import Arrangement
    >>> characteristic_polynomial(Arrangement([[1, 0], [0, 1], [1, 1]]))
    Poly(t**2 - 3*t + 2, t, domain='ZZ')
    """
    import sympy

    first = first_whitney_numbers(arrangement, symmetry=symmetry, time_limit=time_limit)
    padded = [*first, *(0 for _ in range(arrangement.dimension + 1 - len(first)))]
    return sympy.Poly(padded, sympy.Symbol("t"), domain=sympy.ZZ)


def region_count(arrangement: Planes) -> int:
    """Return the number of regions, |chi(-1)|.

    Source: T. Zaslavsky, Facing up to arrangements, Memoirs AMS 154 (1975), theorem A.

    >>> from arrangement import Arrangement
    >>> region_count(Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1]))
    7
    """
    return sum(map(abs, first_whitney_numbers(arrangement)))


def bounded_region_count(arrangement: Planes, *, relative: bool = False) -> int:
    """Return the number of bounded regions, |chi(1)| when the normals span R^d.

    Otherwise every region contains a line and none is bounded. With `relative`, regions are
    counted that are bounded within the span of the normals, which is |chi(1)| always.

    Source: T. Zaslavsky, Facing up to arrangements, Memoirs AMS 154 (1975), theorem C.

    >>> from arrangement import Arrangement
    >>> bounded_region_count(Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1]))
    1
    """
    if not relative and arrangement.rank < arrangement.dimension:
        return 0
    return abs(sum(first_whitney_numbers(arrangement)))


def f_vector(arrangement: Planes) -> tuple[int, ...]:
    """Return (f_0, ..., f_d), the faces by dimension, from Zaslavsky's theorem alone.

    f_k is the sum of the regions of the restrictions to all flats of dimension k. Equal to
    `Arrangement.f_vector`, which enumerates; the two share no code.

    Source: T. Zaslavsky, Facing up to arrangements, Memoirs AMS 154 (1975), theorem A.
    Complexity: see `doubly_indexed_whitney_numbers`. Beyond rank 4, planes with many symmetries are
    counted by classes of flats: one restriction for each.

    >>> from arrangement import Arrangement
    >>> f_vector(Arrangement([[1, 0, 0], [0, 1, 0], [1, 1, 1]]))
    (1, 6, 12, 8)
    """
    sums = _faces_by_codimension(arrangement)
    return (0,) * (arrangement.dimension + 1 - len(sums)) + tuple(reversed(sums))


def _faces_by_codimension(arrangement: Planes) -> tuple[int, ...]:
    product = over_factors(arrangement, _faces_by_codimension)
    if product is not None:
        return product
    config = configuration(arrangement)
    if config.rank > MAX_RANK:
        by_classes = flats_and_faces(arrangement, config, faces=True)
        if by_classes is not None:
            return by_classes[1]
    return tuple(map(sum, doubly_indexed_whitney_numbers(arrangement)))


def fukuda_bound(n: int, d: int, k: int) -> int:
    """Return the largest number of k-faces that n planes in R^d can have.

    C(n, d-k) * sum_{i <= k} C(n-d+k, i); attained by simple affine arrangements, and by central
    ones exactly when n <= d planes are independent.

    Source: K. Fukuda, S. Saito, A. Tamura, T. Tokuyama, Discrete Applied Mathematics 31 (1991);
    [HaasHeger2018], section IV.

    >>> [fukuda_bound(3, 3, k) for k in range(4)]
    [1, 6, 12, 8]
    """
    if not (0 <= k <= d and n >= 0 and d >= 1):
        raise InputError(f"n, d, k are {n}, {d}, {k}; give n >= 0, d >= 1 and 0 <= k <= d")
    if n < d - k:
        return 0
    free = n - d + k
    return math.comb(n, d - k) * sum(math.comb(free, i) for i in range(k + 1))
