"""The search for proofs that a chirotope has no coordinates; see `final_polynomials`."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from math import lcm

import numpy as np

from arrangement.library.census.chirotopes import triples
from arrangement.library.census.final_polynomials import (
    OrderedProducts,
    Triple,
    products_of,
    proves_no_coordinates,
    sorted_bracket,
    terms_of,
)
from arrangement.numbers.linear.programs import some_point

#: Weights in floats from here down are 0.
_TINY = 1e-9


def final_polynomial(signs: Mapping[Triple, int], n: int) -> tuple[OrderedProducts, ...] | None:
    """Return a proof that no vectors of R^3 have these signs; None when none was found.

    The search is in floats, so None proves nothing; what is returned is checked in integers.

    Args:
        signs: the sign of each triple i < j < k.
        n: the number of elements.
    """
    from scipy.optimize import linprog

    column = {tuple(row): k for k, row in enumerate(triples(n).tolist())}
    rows = list(_comparisons(signs, n))
    if not any(strict for _, strict in rows):
        return None
    exponents = np.zeros((len(column) + 1, len(rows)))
    for k, (comparison, strict) in enumerate(rows):
        products = products_of(comparison.relation)
        for sign, side in ((1, comparison.larger), (-1, comparison.smaller)):
            for bracket in products[side]:
                exponents[column[sorted_bracket(bracket)], k] += sign
        exponents[-1, k] = strict
    right = np.zeros(len(column) + 1)
    right[-1] = 1
    bounds = [(0, None) if strict else (None, None) for _, strict in rows]
    found = linprog(
        np.zeros(len(rows)), A_eq=exponents, b_eq=right, bounds=bounds, method="highs-ds"
    )
    if found.x is None:
        return None
    # The method ends at a vertex: the few comparisons that it uses have exact weights.
    used = np.flatnonzero(np.abs(found.x) > _TINY)
    equations = np.unique(np.c_[exponents[:, used], -right].astype(int), axis=0).tolist()
    units = np.eye(len(used), len(used) + 1, dtype=int)
    weights = some_point(len(used), units[[rows[k][1] for k in used]].tolist(), equations)
    if weights is None:
        return None
    scale = lcm(*(weight.denominator for weight in weights))
    proof = tuple(
        rows[k][0]._replace(times=int(weight * scale))
        for k, weight in zip(used, weights, strict=True)
        if weight
    )
    return proof if proves_no_coordinates(signs, proof) else None


def _comparisons(signs: Mapping[Triple, int], n: int) -> Iterator[tuple[OrderedProducts, bool]]:
    """Yield what follows from the signs, each with whether it is strict."""
    for a in range(n):
        others = [x for x in range(n) if x != a]
        for b, c, d, e in itertools.combinations(others, 4):
            terms = terms_of(signs, (a, b, c, d, e))
            for smaller, larger in itertools.permutations(range(3), 2):
                third = terms[3 - smaller - larger]
                if terms[smaller] and terms[larger] == -terms[smaller]:
                    if third == terms[smaller]:
                        yield OrderedProducts((a, b, c, d, e), smaller, larger, 1), True
                    elif third == 0 and smaller < larger:
                        yield OrderedProducts((a, b, c, d, e), smaller, larger, 1), False
