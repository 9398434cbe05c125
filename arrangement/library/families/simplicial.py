"""The known simplicial arrangements of Gruenbaum's catalogue, those with regular polygons too.

A central arrangement of rank 3 is simplicial when every region has three facets. A(n, k) is the
k-th entry with n planes in the catalogue, to which four finds of Cuntz and the one of 35 planes
came later; the near-pencils A(n, 0) are an infinite family and in `near_pencil`. All 119 known
ones with up to 37 planes are here.

The normals were found by search: from a few planes, or the orbits of a few under a group, the
plane or orbit through vertices that brings t_2 nearest to 3 + sum of (k - 3) t_k is added; over Q,
the square roots of 2, 3 and 5, and modulo primes, from where the numbers were lifted to the fields
of the roots of a^3 - a - 1 and a^4 - 3a^3 + 3a^2 - 3a + 1. The members of the families of regular
polygons are made by `regular`. Entries are told apart by their vectors t and r as printed, and
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
from functools import cache
from importlib.resources import files
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.numbers.number_field import NumberField

from .polygons import regular


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
    field = NumberField(*entry["field"])
    rows = [[x if isinstance(x, int) else field.number(x) for x in row] for row in entry["normals"]]
    return Arrangement(rows)


def printed_vectors(planes: int, number: int) -> tuple[dict[int, int], dict[int, int]]:
    """Return t and r of an entry as printed: numbers by k of vertices on k planes, and of planes
    with k vertices. No function computes with them.
    """
    t, r = ({k: x for k, x in enumerate(_entry(planes, number)[key], 2) if x} for key in "tr")
    return t, r


def simplicial_entries() -> tuple[tuple[int, int], ...]:
    """Return the entries (planes, number) that `simplicial` knows, by number of planes."""
    return tuple(_document())


def _entry(planes: int, number: int) -> dict[str, Any]:
    entry = (planes, number)
    if entry not in _document():
        known = ", ".join(f"A{key}" for key in _document() if key[0] == planes) or "A(6, 1), ..."
        raise InputError(
            f"A{entry} is not here; known are {known}, as `simplicial_entries` lists them, and "
            "near_pencil for A(n, 0)"
        )
    return _document()[entry]
