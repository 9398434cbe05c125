"""Generic arrangements, pencils, near-pencils, coordinate planes, mirrors of root systems.

Of a crystallographic type, a plane's normal is its root written in simple roots. So mirrors span
the space, entries are small integers, and no irrational coordinates come up; angles are not those
of the reflections.
"""

from __future__ import annotations

import re
from itertools import combinations, permutations, product
from math import comb
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.families.simplicial import mirrors
from arrangement.numbers.arguments import at_least, check_reach, flag
from arrangement.numbers.exact import IntegerVector, shown
from arrangement.numbers.linear.rank import unit_vectors


def generic(m: int, d: int = 3, *, affine: bool = False) -> Arrangement:
    """Return m planes in general position, with normals on the moment curve (1, t, ..., t^(d-1)).

    t = 1, ..., m. Any d normals are independent, because their Vandermonde determinant is not
    zero. With `affine`, plane t has offset t^d, so that no d + 1 planes share a point.

    Known counts: the affine one attains the bound `counts.fukuda_bound` in every dimension; the
    central one has 2 sum_{i < d} C(m-1, i) regions, in R^3 m^2 - m + 2.
    Source: L. Schlaefli, Theorie der vielfachen Kontinuitaet (1852); R. Buck, American
    Mathematical Monthly 50 (1943).

    >>> generic(4).f_vector
    (1, 12, 24, 14)
    """
    m, d, affine = at_least(m, 0, "m"), at_least(d, 1, "d"), flag(affine, "affine")
    check_reach(m, d, d * m.bit_length())
    normals = [[t**power for power in range(d)] for t in range(1, m + 1)]
    offsets = [t**d for t in range(1, m + 1)] if affine else None
    return Arrangement(normals, offsets, dimension=d)


def pencil(m: int, d: int = 3) -> Arrangement:
    """Return m planes through one subspace of codimension 2: normals (1, t, 0, ...), t = 0..m-1.

    Known counts: 2m regions; chi(t) = t^(d-2) (t - 1)(t - m + 1), for m >= 1.
    Source: B. Gruenbaum, Arrangements and Spreads (1972), chapter 1 (trivial arrangements).

    >>> pencil(5).f_vector
    (0, 1, 10, 10)
    """
    m = at_least(m, 0, "m")
    d = at_least(d, 2, "d")
    check_reach(m, d)
    return Arrangement([[1, t, *(0,) * (d - 2)] for t in range(m)], dimension=d)


def near_pencil(m: int, d: int = 3) -> Arrangement:
    """Return m - 1 planes of a pencil and one plane across it (the last).

    In R^3 it is Gruenbaum's simplicial arrangement A(m, 0).

    Known counts: 4(m - 1) regions; chi(t) = t^(d-3) (t - 1)^2 (t - m + 2).
    Source: B. Gruenbaum, A catalogue of simplicial arrangements in the real projective plane,
    Ars Mathematica Contemporanea 2 (2009), family R(0).

    >>> near_pencil(5).f_vector
    (1, 10, 24, 16)
    """
    m = at_least(m, 3, "m")
    d = at_least(d, 3, "d")
    check_reach(m, d)
    rows = [[1, t, *(0,) * (d - 2)] for t in range(m - 1)]
    return Arrangement([*rows, [0, 0, 1, *(0,) * (d - 3)]])


def coordinate(d: int) -> Arrangement:
    """Return the coordinate planes x_i = 0 of R^d, also called Boolean.

    Known counts: 2^k C(d, k) faces of dimension k, so 2^d regions;
    chi(t) = (t - 1)^d.
    Source: R. Stanley, An Introduction to Hyperplane Arrangements (2007), lecture 1.

    >>> coordinate(3).f_vector
    (1, 6, 12, 8)
    """
    d = at_least(d, 1, "d")
    check_reach(d, d)
    return Arrangement(unit_vectors(d))


def braid(n: int) -> Arrangement:
    """Return the braid arrangement x_i = x_j (i < j) in R^n: the mirrors of type A_(n-1).

    Known counts: n! regions; chi(t) = t (t - 1) ... (t - n + 1).
    Source: R. Stanley, An Introduction to Hyperplane Arrangements (2007), lecture 1.

    >>> braid(3).f_vector
    (0, 1, 6, 6)
    """
    n = at_least(n, 1, "n")
    check_reach(comb(n, 2), n)
    return Arrangement(differences(n), dimension=n)


def type_b(n: int) -> Arrangement:
    """Return the mirrors of type B_n: x_i = 0, x_i = x_j and x_i = -x_j in R^n.

    Known counts: 2^n n! regions; chi(t) = (t - 1)(t - 3) ... (t - 2n + 1).
    Source: R. Stanley, An Introduction to Hyperplane Arrangements (2007), lecture 5.

    >>> type_b(3).f_vector
    (1, 26, 72, 48)
    """
    n = at_least(n, 1, "n")
    check_reach(n * n, n)
    return Arrangement([*unit_vectors(n), *differences(n), *sums(n)])


def type_d(n: int) -> Arrangement:
    """Return the mirrors of type D_n: x_i = x_j and x_i = -x_j in R^n, for n >= 2.

    Known counts: 2^(n-1) n! regions; chi(t) = (t - 1)(t - 3) ... (t - 2n + 3) (t - n + 1).
    Source: R. Stanley, An Introduction to Hyperplane Arrangements (2007), lecture 5.

    >>> type_d(3).f_vector
    (1, 14, 36, 24)
    """
    n = at_least(n, 2, "n")
    check_reach(n * (n - 1), n)
    return Arrangement([*differences(n), *sums(n)])


def h3() -> Arrangement:
    """Return the 15 mirrors of type H_3, the symmetries of the icosahedron, over Q(sqrt(5)).

    They are the planes x_i = 0, and those with normals (1, ±g, ±1/g), the last two turned round,
    g the golden ratio: the roots are the 30 middles of edges of an icosahedron.

    Known counts: 120 regions; chi(t) = (t - 1)(t - 5)(t - 9).
    Source: J. Humphreys, Reflection Groups and Coxeter Groups (1990), section 2.13.

    >>> h3().f_vector
    (1, 62, 180, 120)
    """
    g, h = golden_ratio()
    turned = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
    roots = [(1, s * g, t * h) for s in (1, -1) for t in (1, -1)]
    return Arrangement(
        [*unit_vectors(3), *([root[k] for k in turn] for turn in turned for root in roots)]
    )


def perles() -> Arrangement:
    """Return the nine planes of Perles, over Q(sqrt(5)): their type has no rational coordinates.

    They are dual to nine of the eleven points of a regular pentagon, its diagonals' crossings and
    its centre. With (1, 0, 0), (0, 1, 0), (0, 0, 1) and (1, 1, 1) among the normals, the lines that
    lie on three planes or more force h h + h = 1 on the others.

    Known counts: lines on 2, 3, 4 planes: 6, 8, 1. Source: B. Gruenbaum, Convex Polytopes (1967),
    section 5.5 (M. Perles).

    >>> perles().f_vector
    (1, 30, 80, 52)
    """
    _, h = golden_ratio()
    first = [(0, 1, 0), (1, 0, h), (1, 1, 1), (1, -h, 0)]
    return Arrangement([*first, (0, 1, 1), (1, 0, 0), (1, 1, 0), (1, -h, 1), (0, 0, 1)])


def h4() -> Arrangement:
    """Return the 60 mirrors of type H_4, the symmetries of the 600-cell, over Q(sqrt(5)).

    The roots are the 120 unit icosians: x_i = 0, normals (1, ±1, ±1, ±1), and the even permutations
    of (0, 1, ±g, ±1/g), g the golden ratio.

    Known counts: 14,400 regions; chi(t) = (t - 1)(t - 11)(t - 19)(t - 29).
    Source: J. Humphreys, Reflection Groups and Coxeter Groups (1990), section 2.13.

    >>> len(h4())
    60
    """
    g, h = golden_ratio()
    even = [p for p in permutations(range(4)) if sum(a > b for a, b in combinations(p, 2)) % 2 == 0]
    roots = [(0, 1, s * g, t * h) for s in (1, -1) for t in (1, -1)]
    signs = product((1, -1), repeat=3)
    rest = [[root[k] for k in p] for p in even for root in roots]
    return Arrangement([*unit_vectors(4), *((1, *s) for s in signs), *rest])


def golden_ratio() -> tuple[Any, Any]:
    """Return the golden ratio and its inverse, which is one less."""
    from arrangement.numbers.fields import NumberField

    g = NumberField([-1, -1, 1], [1, 2]).root
    return g, g - 1


def differences(n: int) -> list[list[int]]:
    """Return the vectors e_i - e_j for i < j."""
    return [_pair(n, i, j, -1) for i in range(n) for j in range(i + 1, n)]


def sums(n: int) -> list[list[int]]:
    """Return the vectors e_i + e_j for i < j."""
    return [_pair(n, i, j, 1) for i in range(n) for j in range(i + 1, n)]


def _pair(n: int, i: int, j: int, sign: int) -> list[int]:
    """Return e_i + sign e_j."""
    row = [0] * n
    row[i], row[j] = 1, sign
    return row


_TYPE = re.compile(r"([A-G])([1-9][0-9]?)")
_RANKS = {
    "A": range(1, 100),
    "B": range(2, 100),
    "C": range(2, 100),
    "D": range(3, 100),
    "E": range(6, 9),
    "F": range(4, 5),
    "G": range(2, 3),
}


def coxeter(type: str) -> Arrangement:
    """Return the mirrors of a type: A1, A2, ..., B2, C2, D3, E6, E7, E8, F4, G2, H3, H4, I2(m).

    Known counts: as many regions as the reflection group has elements (E8: 696,729,600);
    chi(t) is the product of t - e over the exponents e of the type.
    Source: P. Orlik, L. Solomon, Inventiones Mathematicae 56 (1980); N. Bourbaki, Groupes et
    algebres de Lie, chapter VI (1968), plates I to IX.

    Raises:
        InputError: no such type.

    >>> coxeter("F4").f_vector[-1]
    1152
    """
    if isinstance(type, str) and type in ("H3", "H4"):
        return h3() if type == "H3" else h4()
    polygon = re.fullmatch(r"I2\(([1-9][0-9]{0,2})\)", type) if isinstance(type, str) else None
    if polygon and int(polygon[1]) >= 3:
        return Arrangement(mirrors(int(polygon[1])))
    return Arrangement(positive_roots(type))


def positive_roots(type: str) -> list[IntegerVector]:
    """Return the positive roots of a crystallographic type, as coefficients of simple roots.

    Simple roots are numbered as by Bourbaki, except that G2's first is the short one too.
    """
    cartan = _cartan_matrix(type)
    size = len(cartan)
    roots = [tuple(int(i == j) for j in range(size)) for i in range(size)]
    known = set(roots)
    for root in roots:
        for i in range(size):
            pairing = sum(root[j] * cartan[j][i] for j in range(size))
            image = (*root[:i], root[i] - pairing, *root[i + 1 :])
            if image[i] >= 0 and image not in known:
                known.add(image)
                roots.append(image)
    return sorted(roots, key=lambda root: (sum(root), root[::-1]))


def _cartan_matrix(type: str) -> list[list[int]]:
    """Return the pairings of simple roots (rows) with simple coroots (columns)."""
    match = _TYPE.fullmatch(type) if isinstance(type, str) else None
    if match is None or int(match[2]) not in _RANKS[match[1]]:
        raise InputError(
            f"the type is {shown(type)}; there are A1, A2, ..., B2, C2, ..., D3, ..., E6, E7, E8, "
            "F4 and G2, and as mirrors H3, H4 and I2(m) for m from 3 on"
        )
    letter, size = match[1], int(match[2])
    edges = [(i, i + 1) for i in range(size - 1)]
    if letter == "D":
        edges[-1] = (size - 3, size - 1)
    if letter == "E":
        edges = [(0, 2), (1, 3), *((i, i + 1) for i in range(2, size - 1))]
    matrix = [[2 * (i == j) for j in range(size)] for i in range(size)]
    for i, j in edges:
        matrix[i][j] = matrix[j][i] = -1
    if letter in "BF":  # the later root of the double bond is the short one
        i = size - 2 if letter == "B" else 1
        matrix[i][i + 1] = -2
    if letter == "C":
        matrix[size - 1][size - 2] = -2
    if letter == "G":
        matrix[1][0] = -3
    return matrix
