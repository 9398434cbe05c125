"""Proofs that a chirotope of rank 3 has no coordinates: biquadratic final polynomials.

For vectors a, b, c, d, e of R^3 the three products of

    [abc][ade] - [abd][ace] + [abe][acd] = 0

add up to 0. Where a chirotope's signs make two of them positive and one negative (or the other
way), each of the two is smaller than the one in absolute value; where one of them is 0, the other
two are equal. Multiply such strict inequalities and equations: when the products of the brackets
on both sides come out the same, something is smaller than itself, and no vectors have these signs
([BokowskiRichter1990]). What is multiplied is found by a linear program in floats; the check is
in integers and looks at nothing but the signs.
"""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from math import lcm
from typing import NamedTuple, TypeAlias

import numpy as np

from arrangement.numbers.linear.programs import Infeasible, feasible_point

from .chirotopes import triples

Triple: TypeAlias = tuple[int, int, int]
Product: TypeAlias = tuple[Triple, Triple]
#: Weights in floats from here down are 0.
_TINY = 1e-9


class OrderedProducts(NamedTuple):
    """Two products of one relation, the first smaller than (or as large as) the second.

    Attributes:
        relation: the elements a, b, c, d, e of the relation.
        smaller: which of its three products, 0 to 2.
        larger: which other.
        times: how often the two are multiplied; equations may be turned round by a minus.
    """

    relation: tuple[int, int, int, int, int]
    smaller: int
    larger: int
    times: int


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
        products = _products(comparison.relation)
        for sign, side in ((1, comparison.larger), (-1, comparison.smaller)):
            for bracket in products[side]:
                exponents[column[_sorted(bracket)], k] += sign
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
    weights = feasible_point(len(used), units[[rows[k][1] for k in used]].tolist(), equations)
    if isinstance(weights, Infeasible):
        return None
    scale = lcm(*(weight.denominator for weight in weights))
    proof = tuple(
        rows[k][0]._replace(times=int(weight * scale))
        for k, weight in zip(used, weights, strict=True)
        if weight
    )
    return proof if proves_no_coordinates(signs, proof) else None


def proves_no_coordinates(signs: Mapping[Triple, int], proof: Sequence[OrderedProducts]) -> bool:
    """Check a proof: every comparison follows from the signs, and the products cancel."""
    total: Counter[Triple] = Counter()
    strict = False
    for relation, smaller, larger, times in proof:
        if len(set(relation)) != 5 or {smaller, larger} - {0, 1, 2} or smaller == larger:
            return False
        terms = _terms(signs, relation)
        third = terms[3 - smaller - larger]
        if terms[smaller] == 0 or terms[larger] != -terms[smaller]:
            return False
        if third not in (0, terms[smaller]) or (third and times < 0):
            return False
        strict |= bool(third and times)
        products = _products(relation)
        for sign, side in ((times, larger), (-times, smaller)):
            for bracket in products[side]:
                total[_sorted(bracket)] += sign
    return strict and not any(total.values())


def _comparisons(signs: Mapping[Triple, int], n: int) -> Iterator[tuple[OrderedProducts, bool]]:
    """Yield what follows from the signs, each with whether it is strict."""
    for a in range(n):
        others = [x for x in range(n) if x != a]
        for b, c, d, e in itertools.combinations(others, 4):
            terms = _terms(signs, (a, b, c, d, e))
            for smaller, larger in itertools.permutations(range(3), 2):
                third = terms[3 - smaller - larger]
                if terms[smaller] and terms[larger] == -terms[smaller]:
                    if third == terms[smaller]:
                        yield OrderedProducts((a, b, c, d, e), smaller, larger, 1), True
                    elif third == 0 and smaller < larger:
                        yield OrderedProducts((a, b, c, d, e), smaller, larger, 1), False


def _products(relation: Sequence[int]) -> tuple[Product, Product, Product]:
    a, b, c, d, e = relation
    return ((a, b, c), (a, d, e)), ((a, b, d), (a, c, e)), ((a, b, e), (a, c, d))


def _terms(signs: Mapping[Triple, int], relation: Sequence[int]) -> tuple[int, int, int]:
    first, second, third = (
        _sign(signs, left) * _sign(signs, right) for left, right in _products(relation)
    )
    return first, -second, third


def _sign(signs: Mapping[Triple, int], bracket: Triple) -> int:
    swaps = sum(x > y for x, y in itertools.combinations(bracket, 2))
    return (-1 if swaps % 2 else 1) * signs[_sorted(bracket)]


def _sorted(bracket: Triple) -> Triple:
    i, j, k = sorted(bracket)
    return i, j, k
