"""Characteristic polynomial, Whitney numbers, and Zaslavsky's counts of faces and regions.

Everything here is read off one table: the sums of |mu(X, Y)| over flats X <= Y of ranks k and j.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple

from arrangement.console.number_form import table
from arrangement.errors import InputError, OutOfTimeError
from arrangement.numbers.deadline import Deadline
from arrangement.planes.planes import Planes

from .configuration import Configuration, configuration, is_generic
from .lattice import intersection_lattice
from .low_rank import MAX_RANK, WhitneyMatrix, whitney_matrix, with_top
from .operations import over_factors, restriction

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
    return _generic_matrix(config) or intersection_lattice(arrangement).whitney_matrix


def _generic_matrix(config: Configuration) -> WhitneyMatrix | None:
    """Return the table of planes in general position; None if they are not seen to be.

    Each flat below the top has as many planes as its rank, so every interval below it is Boolean.
    """
    if not is_generic(config):
        return None
    m, ranks = len(config.vectors), range(config.rank)
    below = tuple(
        tuple(math.comb(m, j) * math.comb(j, k) if j >= k else 0 for j in ranks) for k in ranks
    )
    return below if config.infinity is not None else with_top(below, config.rank)


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
        if (by_classes := _flats_and_faces(arrangement, config, faces=False)) is not None:
            return WhitneyNumbers(first, by_classes[0])
        return WhitneyNumbers(first, tuple(map(len, intersection_lattice(arrangement).masks)))
    return WhitneyNumbers(tuple((-1) ** j * value for j, value in enumerate(unsigned)), second)


def first_whitney_numbers(
    arrangement: Planes,
    *,
    symmetry: Sequence[Sequence[int]] | None = None,
    time_limit: float | None = None,
) -> tuple[int, ...]:
    """Return the sums of mu(X) over the flats X of rank 0, 1, ...: the coefficients of chi.

    Linear symmetries of the normals (of the cone, if planes miss the origin) are found and used;
    up to rank 4 (affine: 3) the formulas of `low_rank` are faster, unless symmetries are given.

    Args:
        symmetry: permutations of the planes to be used in place of those that a search finds;
            plane i goes to entry i. An empty list means none.
        time_limit: in seconds.

    Raises:
        InputError: a permutation that no linear map makes of the planes.
        OutOfTimeError: the time is over; its `known` has the numbers that are final.

    Complexity: with m planes and c orbits of flats of rank at most r - 2 (affine: r - 1), O(c m)
    operations modulo primes, and as many images of sets as classes have covers.

    Source: [Weisner1935]; [BrysiewiczEbleKuehne2023] for the use of symmetries.

    >>> from arrangement.library import families
    >>> first_whitney_numbers(families.resonance(6))
    (1, -63, 1652, -22435, 159460, -510524, 371909)
    """
    deadline = Deadline(time_limit)
    try:
        with deadline.enforce():
            return _first_numbers(arrangement, symmetry, deadline)
    except TimeoutError:
        message = (
            f"{deadline}: the first Whitney numbers 1 are final; give more time for the others"
        )
        raise OutOfTimeError(message, (1,)) from None


def _first_numbers(
    arrangement: Planes, symmetry: Sequence[Sequence[int]] | None, deadline: Deadline
) -> tuple[int, ...]:
    if symmetry is None:
        numbers_of = partial(_first_numbers, symmetry=None, deadline=deadline)
        numbers = over_factors(arrangement, numbers_of)
        if numbers is not None:
            return numbers
    config = configuration(arrangement)
    if symmetry is None and config.rank > MAX_RANK and (generic := _generic_matrix(config)):
        return tuple((-1) ** k * value for k, value in enumerate(generic[0]))
    if (config.rank > MAX_RANK or (config.rank and symmetry is not None)) and (orbits := _orbits()):
        numbers = orbits.first_numbers(arrangement, config, symmetry, deadline)
        return tuple(numbers)
    row = doubly_indexed_whitney_numbers(arrangement)[0]
    return tuple((-1) ** k * value for k, value in enumerate(row))


def _orbits() -> Any:
    """Return what counts one flat of each class under symmetries; None if it is absent."""
    name = "arrangement.counts.orbits"
    return import_module(f"{name}.symmetric") if find_spec(name) else None


def _flats_and_faces(
    arrangement: Planes, config: Configuration, *, faces: bool
) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    if config.rank <= MAX_RANK or not (orbits := _orbits()):
        return None
    totals: tuple[tuple[int, ...], tuple[int, ...]] | None
    totals = orbits.flats_and_faces(arrangement, config, faces=faces)
    return totals


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


def level_vector(arrangement: Planes) -> dict[int, int]:
    """Return how many regions have level k, the dimension of the recession cone, by k.

    The cone of a region spans a flat X of the planes moved to the origin. Those planes cut X in
    as many parts as there are cones that span it, and along each of them go as many regions as the
    planes that contain X in their direction have relatively bounded ones. Equal to
    `Arrangement.level_vector`, which enumerates; the two share no code.

    Source: T. Zaslavsky, Faces of a hyperplane arrangement enumerated by ideal dimension, with
    application to plane, plaids, and Shi, Geometriae Dedicata 98 (2003).

    >>> from arrangement import Arrangement
    >>> level_vector(Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1]))
    {0: 1, 2: 6}
    """
    rows = arrangement.integer_planes
    moved = Planes([row[:-1] for row in rows], dimension=arrangement.dimension)
    levels: dict[int, int] = {}
    for flat in (flat for level in intersection_lattice(moved).flats for flat in level):
        along = Planes(
            [rows[i][:-1] for i in flat.planes],
            [rows[i][-1] for i in flat.planes],
            dimension=arrangement.dimension,
        )
        if regions := bounded_region_count(along, relative=True):
            cones = region_count(restriction(moved, flat.planes))
            levels[flat.dimension] = levels.get(flat.dimension, 0) + cones * regions
    return dict(sorted(levels.items()))


def why_none_is_bounded(arrangement: Planes) -> str:
    """Return why no region is bounded although some are relative to the normals' span; or ""."""
    rank, dimension = arrangement.rank, arrangement.dimension
    if rank == dimension or arrangement.has_common_point:
        return ""
    return f"every region contains a line, as the normals span {rank} of {dimension} dimensions"


def f_vector(arrangement: Planes) -> tuple[int, ...]:
    """Return (f_0, ..., f_d), the faces by dimension, from Zaslavsky's theorem alone.

    f_k is the sum of the regions of the restrictions to all flats of dimension k. Equal to
    the f-vector of `Arrangement.faces`, which are enumerated; the two share no code.

    Source: T. Zaslavsky, Facing up to arrangements, Memoirs AMS 154 (1975), theorem A.
    Complexity: see `doubly_indexed_whitney_numbers`. Beyond rank 4, planes whose largest minors are
    all seen to be nonzero are counted by binomials, since every flat has as many planes as its
    rank, and planes with many symmetries by orbits of flats: one restriction for each.

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
    if config.rank > MAX_RANK and (generic := _generic_matrix(config)):
        return tuple(map(sum, generic))
    if (by_classes := _flats_and_faces(arrangement, config, faces=True)) is not None:
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
