"""The known simplicial arrangements of Gruenbaum's catalogue, those with regular polygons too.

A central arrangement of rank 3 is simplicial when every region has three facets. A(n, k) is the
k-th entry with n planes in the catalogue, to which four finds of Cuntz and the one of 35 planes
came later; the near-pencils A(n, 0) are an infinite family and in `near_pencil`. All 119 known
ones with up to 37 planes are here.

The normals were found by search: from a few planes, or the orbits of a few under a group, the
plane or orbit through vertices that brings t_2 nearest to 3 + sum of (k - 3) t_k is added; over Q,
the square roots of 2, 3 and 5, and modulo primes, from where the numbers were lifted to the fields
of the roots of a^3 - a - 1 and a^4 - 3a^3 + 3a^2 - 3a + 1. The members of the families of regular
polygons are made by `regular`. Entries are distinguished by their vectors t and r as printed, and
those that have these in common by their graphs of regions or their symmetries.

Sources: B. Gruenbaum, A catalogue of simplicial arrangements in the real projective plane, Ars
Mathematica Contemporanea 2 (2009); M. Cuntz, Simplicial arrangements with up to 27 lines,
Discrete and Computational Geometry 48 (2012), and A greedy algorithm to compute arrangements of
lines in the projective plane, the same 68 (2022), for the way of the search; M. Cuntz, S. Elia,
J.-P. Labbe, Congruence normality of simplicial hyperplane arrangements via oriented matroids,
Annals of Combinatorics 26 (2022), table 5, for t and r.
"""

from __future__ import annotations

import json
from fractions import Fraction
from functools import cache
from importlib.resources import files
from itertools import accumulate
from math import gcd, pi, sin
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.numbers.arguments import at_least, flag
from arrangement.numbers.exact import quotient, shown
from arrangement.numbers.symbolic import real_vector

#: 2 cos(2 pi / n) where it is rational.
_RATIONAL_COSINES = {3: -1, 4: 0, 6: 1}


@cache
def _document() -> dict[tuple[int, int], dict[str, Any]]:
    text = files(__package__).joinpath("simplicial.json").read_text(encoding="utf-8")
    entries = json.loads(text).items()
    return {(int(n), int(k)): entry for (n, k), entry in ((x.split(","), y) for x, y in entries)}


def simplicial(planes: int, number: int) -> Arrangement:
    """Return A(planes, number) of Gruenbaum's catalogue, central in R^3.

    Known counts: with t_k vertices (pairs of rays) on k planes, t_2 = 3 + sum over k >= 4 of
    (k - 3) t_k, which is equality in Melchior's inequality; 3/2 as many facets as regions.

    Raises:
        InputError: for an entry that is not known.

    >>> simplicial(13, 2).f_vector, simplicial(31, 1).f_vector
    ((1, 50, 144, 96), (1, 242, 720, 480))
    """
    entry = _entry(planes, number)
    if "normals" not in entry:
        return regular(planes)
    if "field" not in entry:
        return Arrangement(entry["normals"])
    from arrangement.numbers.fields import NumberField

    field = NumberField(*entry["field"])
    rows = [[x if isinstance(x, int) else field.number(x) for x in row] for row in entry["normals"]]
    return Arrangement(rows)


def printed_vectors(planes: int, number: int) -> tuple[dict[int, int], dict[int, int]]:
    """Return t and r of an entry as printed: numbers by k of vertices on k planes, and of planes
    with k vertices. No function computes with them.
    """
    t, r = ({k: x for k, x in enumerate(_entry(planes, number)[key], 2) if x} for key in "tr")
    return t, r


def simplicial_entries(*, rational: bool = False) -> tuple[tuple[int, int], ...]:
    """Return the entries (planes, number) that `simplicial` knows, by number of planes.

    Args:
        rational: only those whose planes have rational entries here.
    """
    flag(rational, "rational")
    return tuple(key for key in _document() if not rational or _is_rational(*key))


def _is_rational(planes: int, number: int) -> bool:
    """Return whether an entry needs no field; `regular` needs that of cos(2 pi / n)."""
    entry = _entry(planes, number)
    return "field" not in entry if "normals" in entry else planes // 2 in _RATIONAL_COSINES


def _entry(planes: int, number: int) -> dict[str, Any]:
    entry = (at_least(planes, 1, "planes"), at_least(number, 0, "number"))
    if entry not in _document():
        known = ", ".join(f"A{key}" for key in _document() if key[0] == entry[0]) or "A(6, 1), ..."
        raise InputError(
            f"A{shown(entry)} is not here; expected one of {known}, as `simplicial_entries` lists "
            "them, and near_pencil for A(n, 0)"
        )
    return _document()[entry]


def regular(planes: int) -> Arrangement:
    """Return Gruenbaum's simplicial arrangement A(2n, 1), or A(4k + 1, 1), central in R^3.

    A(2n, 1) has the n sides and the n mirrors of a regular n-gon; A(4k + 1, 1) has those of a
    2k-gon, and the line at infinity, z = 0, last. The y-axis is stretched, so that all entries are
    in the field of cos(2 pi / n); they are rational for n = 3, 4 and 6.

    Known counts: A(2n, 1) has 2n (n + 1) regions, A(4k + 1, 1) has 8k (k + 1).
    Source: B. Gruenbaum, A catalogue of simplicial arrangements in the real projective plane, Ars
    Mathematica Contemporanea 2 (2009), families R(1) and R(2).

    Raises:
        InputError: a number of planes that is neither even nor 4k + 1, or too small; or a cosine
            of a degree above `arrangement.numbers.fields.MAX_DEGREE`.

    >>> regular(10).f_vector
    (1, 32, 90, 60)
    """
    planes = at_least(planes, 6, "planes")
    infinity = planes % 2
    n = planes // 2
    if infinity and (n % 2 or n < 4):
        raise InputError(
            f"there is no regular arrangement of {planes} planes; give an even number, or 4k + 1 "
            "from 9 on"
        )
    cosines, sines = _multiples(n)
    square = 2 - quotient(cosines[1] * cosines[1], 2)  # twice that of the sine
    sides = [(c, square * s, -2) for c, s in zip(cosines, sines, strict=True)]
    return Arrangement([*sides, *((*m, 0) for m in mirrors(n)), *([(0, 0, 1)] * infinity)])


def mirrors(n: int) -> list[tuple[Any, Any]]:
    """Return normals of the mirrors of a regular n-gon in R^2, with the y-axis stretched.

    The k-th one runs at the angle k pi / n; it is divided by the sine of 2 pi / n, or for odd k
    and even n by that of half of it.
    """
    cosines, sines = _multiples(n)
    if n % 2:
        return [(-2 * s, c) for c, s in zip(cosines, sines, strict=True)]
    normals = []
    sums = list(accumulate(cosines[1:], initial=1))
    for k in range(n):
        j = k // 2
        if k % 2:
            normals.append((-2 * sums[j], cosines[j] + cosines[j + 1]))
        else:
            normals.append((-2 * sines[j], cosines[j]))
    return normals


def regular_corners(n: int) -> list[tuple[Any, Any]]:
    """Return the corners of a regular n-gon in R^2, counter-clockwise from (2, 0).

    The y-axis is stretched, by less than 1/1000, so that all are in the field of cos(2 pi / n).
    """
    cosines, sines = _multiples(n)
    height = Fraction(2 * sin(2 * pi / n)).limit_denominator(100)
    return [(c, height * s) for c, s in zip(cosines, sines, strict=True)]


def _multiples(n: int) -> tuple[list[Any], list[Any]]:
    """Return 2 cos(k x) and sin(k x) / sin(x) for x = 2 pi / n, k = 0, ..., n - 1."""
    from arrangement.numbers.fields import MAX_DEGREE

    # its degree is half of Euler's function
    if n > 8 * MAX_DEGREE**2 or sum(gcd(k, n) == 1 for k in range(n)) > 2 * MAX_DEGREE:
        raise InputError(
            f"the cosine of 2 pi / {shown(n)} has a degree above {MAX_DEGREE}; take fewer planes"
        )
    t: Any = _RATIONAL_COSINES.get(n)
    if t is None:
        import sympy  # slow to load

        t = real_vector([2 * sympy.cos(2 * sympy.pi / n)], "the cosine")[0]
    cosines, sines = [2, t], [0, 1]
    for row in (cosines, sines):
        while len(row) < n:
            row.append(t * row[-1] - row[-2])
    return cosines, sines
