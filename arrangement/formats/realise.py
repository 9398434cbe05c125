"""Integer normals for a chirotope of rank 3.

Up to the size of the census they are those of its representative, relabelled and reoriented. Of
more elements one is taken away and put back: where the others stand, its signs are linear
conditions, which an exact linear program decides. Others may have to stand elsewhere for that, so
each element is tried; that none fits proves nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

import numpy as np

from arrangement.errors import InputError
from arrangement.exact import IntegerVector, primitive
from arrangement.library.census.catalogue import MOST_PLANES, normals
from arrangement.library.census.chirotopes import Signs, alternating, triples
from arrangement.library.census.codes import canonical
from arrangement.library.census.identify import found_type
from arrangement.linear import determinant
from arrangement.linprog import Infeasible, feasible_point

#: Linear programs that are tried for more elements than the census has.
_TRIES = 200


def realise(signs: Signs, n: int) -> list[IntegerVector]:
    """Return normals whose determinants have these signs, (C(n, 3),) in lexicographic order.

    Elements may be parallel; the signs are meant up to a common one.

    Raises:
        InputError: no normals have these signs, or none were found.
    """
    chi = alternating(signs[None], n)[0]
    if not chi.any():
        raise InputError("all signs are 0; three planes must meet in a point")
    if not chi.any((1, 2)).all():
        loop = int(np.flatnonzero(~chi.any((1, 2)))[0]) + 1
        raise InputError(f"element {loop} is in no basis: its normal would be 0")
    first = (~chi.any(2)).argmax(1)  # the first element that is parallel to each
    firsts = np.unique(first)
    part = chi[np.ix_(firsts, firsts, firsts)][tuple(triples(len(firsts)).T)]
    tried = islice(_attempts(part, len(firsts)), _TRIES)
    placed = next((found for found in tried if found is not None), None)
    if placed is not None:
        where = dict(zip(firsts.tolist(), placed, strict=True))
        result = []
        for element, like in enumerate(first.tolist()):
            i, j = np.argwhere(chi[like])[0]
            side = int(chi[like, i, j] * chi[element, i, j])
            result.append(tuple(side * x for x in where[like]))
        if _signs(result) in (tuple(signs.tolist()), tuple((-signs).tolist())):
            return result
    if len(firsts) <= MOST_PLANES:
        raise InputError("no planes have these signs: the census has all types of so many planes")
    raise InputError(
        f"no coordinates were found for these {len(firsts)} planes; types of up to {MOST_PLANES} "
        "are in the census. Give a file with coordinates"
    )


def _signs(vectors: list[IntegerVector]) -> tuple[int, ...]:
    values = (determinant([vectors[k] for k in row]) for row in triples(len(vectors)).tolist())
    return tuple((value > 0) - (value < 0) for value in values)


def _attempts(signs: Signs, m: int) -> Iterator[list[IntegerVector] | None]:
    """Yield normals with exactly these signs, or None for each attempt that failed."""
    if not signs.any():
        yield None
        return
    if m <= MOST_PLANES:
        yield _of_census(signs, m)
        return
    chi = alternating(signs[None], m)[0]
    for last in reversed(range(m)):
        others = [k for k in range(m) if k != last]
        part = chi[np.ix_(others, others, others)][tuple(triples(m - 1).T)]
        for found in _attempts(part, m - 1):
            vector = None if found is None else _put_back(found, chi[last][np.ix_(others, others)])
            yield None if vector is None else [*found[:last], vector, *found[last:]]  # type: ignore[index]


def _of_census(signs: Signs, m: int) -> list[IntegerVector] | None:
    mine = canonical(signs[None], m)
    try:
        place, order, sides = found_type(signs[None], mine, m)
    except LookupError:
        return None
    if not normals(m)[place].any():
        raise InputError(
            "planes with these signs need sqrt(5): they are `arrangement make perles`, relabelled"
        )
    found: list[IntegerVector] = [()] * m
    for element, side, normal in zip(order, sides, normals(m)[place].tolist(), strict=True):
        found[element] = tuple(int(side) * x for x in normal)
    common = 1 if _signs(found) == tuple(signs.tolist()) else -1
    return [tuple(common * x for x in vector) for vector in found]


def _put_back(others: list[IntegerVector], wanted: Signs) -> IntegerVector | None:
    """Return a vector v with the signs `wanted` of det(v, a_i, a_j)."""
    inequalities, equalities = [], []
    for j, second in enumerate(others):
        for i, first in enumerate(others[:j]):
            (a, b, c), (d, e, f) = first, second
            ray = (b * f - c * e, c * d - a * f, a * e - b * d)
            side = int(wanted[i, j])
            if side:
                inequalities.append((*(side * x for x in ray), -1))
            else:
                equalities.append((*ray, 0))
    found = feasible_point(3, inequalities, equalities)
    return None if isinstance(found, Infeasible) else primitive(found)
