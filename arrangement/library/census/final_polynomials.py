"""Proofs that a chirotope of rank 3 has no coordinates: biquadratic final polynomials.

For vectors a, b, c, d, e of R^3 the three products of

    [abc][ade] - [abd][ace] + [abe][acd] = 0

add up to 0. Where a chirotope's signs make two of them positive and one negative (or the other
way), each of the two is smaller than the one in absolute value; where one of them is 0, the other
two are equal. Multiply such strict inequalities and equations: when the products of the brackets
on both sides come out the same, something is smaller than itself, and no vectors have these signs
([BokowskiRichter1990]). What is multiplied was found by a linear program in floats (in
`tests/census`); the check is in integers and looks at nothing but the signs.
"""

from __future__ import annotations

import itertools
import json
import math
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

from arrangement.numbers.exact import sign_text
from arrangement.planes.proved import ask_proved

Triple: TypeAlias = tuple[int, int, int]
Product: TypeAlias = tuple[Triple, Triple]


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


def proves_no_coordinates(signs: Mapping[Triple, int], proof: Sequence[OrderedProducts]) -> bool:
    """Check a proof: every comparison follows from the signs, and the products cancel."""
    total: Counter[Triple] = Counter()
    strict = False
    for relation, smaller, larger, times in proof:
        if len(set(relation)) != 5 or {smaller, larger} - {0, 1, 2} or smaller == larger:
            return False
        terms = terms_of(signs, relation)
        third = terms[3 - smaller - larger]
        if terms[smaller] == 0 or terms[larger] != -terms[smaller]:
            return False
        if third not in (0, terms[smaller]) or (third and times < 0):
            return False
        strict |= bool(third and times)
        products = products_of(relation)
        for sign, side in ((times, larger), (-times, smaller)):
            for bracket in products[side]:
                total[sorted_bracket(bracket)] += sign
    return strict and not any(total.values())


def proved_no_coordinates(signs: Sequence[int], proof: Sequence[OrderedProducts]) -> bool:
    """Return what the program that is proved in Coq says of a proof; no Python checks here.

    Args:
        signs: of all triples of the elements, in lexicographic order.
        proof: as `proves_no_coordinates` takes it.

    Raises:
        InputError: the program is not built.
    """
    text = json.dumps(final_document(signs, proof))
    return ask_proved("-", text=text) == ("accepted", "no coordinates")


def final_document(signs: Sequence[int], proof: Sequence[OrderedProducts]) -> dict[str, Any]:
    """Return signs and proof as the verified program reads them."""
    return {
        "schema_version": 1,
        "certificate": "no coordinates",
        "elements": next(n for n in itertools.count() if math.comb(n, 3) >= len(signs)),
        "signs": sign_text(signs),
        "proof": [[*row.relation, row.smaller, row.larger, row.times] for row in proof],
    }


def products_of(relation: Sequence[int]) -> tuple[Product, Product, Product]:
    """Return the three products of a relation, as brackets."""
    a, b, c, d, e = relation
    return ((a, b, c), (a, d, e)), ((a, b, d), (a, c, e)), ((a, b, e), (a, c, d))


def terms_of(signs: Mapping[Triple, int], relation: Sequence[int]) -> tuple[int, int, int]:
    """Return the signs of the three terms of a relation."""
    first, second, third = (
        _sign(signs, left) * _sign(signs, right) for left, right in products_of(relation)
    )
    return first, -second, third


def _sign(signs: Mapping[Triple, int], bracket: Triple) -> int:
    swaps = sum(x > y for x, y in itertools.combinations(bracket, 2))
    return (-1 if swaps % 2 else 1) * signs[sorted_bracket(bracket)]


def sorted_bracket(bracket: Triple) -> Triple:
    """Return the triple of a bracket with its elements in order."""
    i, j, k = sorted(bracket)
    return i, j, k
