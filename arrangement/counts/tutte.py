"""The Tutte polynomial by deletion and contraction, and the sets without broken circuits.

Both contract a plane by projecting the other normals along it; neither uses the lattice of flats or
its Moebius function. Affine planes form a semimatroid: the sums run over the sets of planes with a
common point.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate
from math import comb
from typing import TYPE_CHECKING, TypeAlias

from arrangement.counts.configuration import configuration
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, unoriented
from arrangement.numbers.linear.rank import rank
from arrangement.planes.planes import Planes

if TYPE_CHECKING:
    import sympy

#: The coefficient of x^i y^j, by (i, j).
_Polynomial: TypeAlias = dict[tuple[int, int], int]
#: Pairwise independent vectors, each with its multiplicity.
_Rows: TypeAlias = tuple[tuple[IntegerVector, int], ...]
#: Forecast of the steps for a flat, times the number of planes.
_STEPS = 200


def tutte_polynomial(arrangement: Planes) -> sympy.Poly:
    """Return T(x, y): the sum of (x - 1)^(r - r(B)) (y - 1)^(|B| - r(B)) over sets B of planes.

    B runs over the sets with a common point, r is the rank; coincident planes count each for
    itself. There are T(2, 0) regions, T(0, 0) of them bounded in the span of the normals, and
    chi(t) = (-1)^r t^(d - r) T(1 - t, 0). For the planes of a graph T is the Tutte polynomial of
    the graph: T(1, 1) is the number of its spanning trees, if it is connected.

    Raises:
        OutOfReachError: too many flats are possible.

    Complexity: for each flat as many vectors as planes, reduced modulo it.

    Source: F. Ardila, Semimatroids and their Tutte polynomials, Revista Colombiana de Matematicas
    41 (2007).

    >>> from arrangement import families
    >>> T = tutte_polynomial(families.braid(4))
    >>> T.eval((2, 0)), T.eval((1, 1))
    (24, 16)
    """
    import sympy

    config = configuration(arrangement)
    _check_cost("the Tutte polynomial", len(config.vectors), arrangement.rank)
    sizes = map(len, arrangement.distinct)
    rows = tuple(zip(map(unoriented, config.vectors), sizes, strict=True))
    polynomial = _tutte(rows, config.infinity, {})
    return sympy.Poly(polynomial or {(0, 0): 0}, *sympy.symbols("x y"), domain=sympy.ZZ)


def _tutte(
    rows: _Rows,
    infinity: IntegerVector | None,
    known: dict[tuple[_Rows, IntegerVector | None], _Polynomial],
) -> _Polynomial:
    """Delete and contract the last plane; the same flat and planes before it come often."""
    if not rows:
        return {(0, 0): 1}
    if (rows, infinity) in known:
        return known[rows, infinity]
    *others, (last, times) = rows
    beyond = [] if infinity is None else [infinity]
    vectors = [vector for vector, _ in others] + beyond
    contracted: dict[IntegerVector, int] = {}
    far = None if infinity is None else _quotient(infinity, last)
    for vector, number in others:
        image = _quotient(vector, last)
        if image != far:
            contracted[image] = contracted.get(image, 0) + number
    below = _tutte(tuple(contracted.items()), far, known)
    polynomial: _Polynomial = {}
    for j in range(times):  # of parallel ones, the others are loops after the first
        for (a, b), number in below.items():
            polynomial[a, b + j] = polynomial.get((a, b + j), 0) + number
    if rank([*vectors, last]) > rank(vectors):  # in every basis
        for (a, b), number in below.items():
            polynomial[a, b] -= number
            polynomial[a + 1, b] = polynomial.get((a + 1, b), 0) + number
    else:
        for power, number in _tutte(tuple(others), infinity, known).items():
            polynomial[power] = polynomial.get(power, 0) + number
    known[rows, infinity] = polynomial
    return polynomial


def nbc_sets(arrangement: Planes) -> tuple[tuple[tuple[int, ...], ...], ...]:
    """Return the sets of planes without a broken circuit, by size, as numbers of planes.

    A broken circuit is a minimal dependent set with a common point without its first plane. There
    are as many sets of k planes as the Whitney number of the first kind of rank k has units, and as
    many in all as regions. Of coincident planes only the first one is taken.

    Raises:
        OutOfReachError: too many are possible.

    Source: G.-C. Rota, Zeitschrift fuer Wahrscheinlichkeitstheorie 2 (1964); T. Brylawski, Trans.
    AMS 234 (1977).

    >>> from arrangement import families
    >>> nbc_sets(families.braid(3))
    (((),), ((0,), (1,), (2,)), ((0, 1), (0, 2)))
    """
    config = configuration(arrangement)
    _check_cost("the sets without broken circuits", len(config.vectors), arrangement.rank)
    by_size: list[list[tuple[int, ...]]] = [[] for _ in range(arrangement.rank + 1)]

    def extend(
        chosen: tuple[int, ...], rows: Sequence[IntegerVector], far: IntegerVector | None
    ) -> None:
        """Add planes before the first chosen one; `rows` are in the quotient by those chosen."""
        by_size[len(chosen)].append(chosen)
        for i, row in enumerate(rows):
            if row != far and row not in rows[:i]:
                below = [_quotient(vector, row) for vector in rows[:i]]
                nearer = None if far is None else _quotient(far, row)
                extend((arrangement.firsts[i], *chosen), below, nearer)

    extend((), [*map(unoriented, config.vectors)], config.infinity)
    return tuple(tuple(sorted(sets)) for sets in by_size)


def _quotient(vector: IntegerVector, by: IntegerVector) -> IntegerVector:
    """Return a vector modulo another one, up to a factor, in a coordinate less."""
    j = next(k for k, x in enumerate(by) if x)
    pairs = zip(vector[:j] + vector[j + 1 :], by[:j] + by[j + 1 :], strict=True)
    return unoriented([x * by[j] - vector[j] * y for x, y in pairs])


def _check_cost(what: str, planes: int, order: int) -> None:
    flats = [*accumulate(comb(planes, k) if planes < 10**4 else 10**300 for k in range(order))]
    budget.check_cost(
        f"{what} of {planes} planes of rank {order}",
        "use characteristic_polynomial",
        steps=_STEPS * planes * (flats[-1] if flats else 1),
    )
