"""Planes of points and sets: separations, what points span, thresholds, subset sums."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from itertools import combinations, permutations, product
from math import comb

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.arguments import at_least, flag
from arrangement.library.families.checks import planned
from arrangement.library.families.classical import sums
from arrangement.library.families.randoms import random_integer
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, shown
from arrangement.numbers.linear.rank import determinant

#: Name of a polytope -> its vertices in R^n.
_VERTICES: Mapping[str, Callable[[int], Iterator[IntegerVector]]] = {
    "cube": lambda n: product((0, 1), repeat=n),
    "demicube": lambda n: (x for x in product((0, 1), repeat=n) if sum(x) % 2 == 0),
    "cross-polytope": lambda n: (
        tuple(s * int(i == j) for j in range(n)) for i in range(n) for s in (1, -1)
    ),
    "permutohedron": lambda n: permutations(range(1, n + 1)),
}


def separations(polytope: str, n: int = 3) -> Arrangement:
    """Return w_0 + w . v = 0 for the vertices v of a cube, demicube, cross-polytope, permutohedron.

    A region is a way to separate vertices from the others by a hyperplane (or none from all).

    Args:
        polytope: "cube", "demicube" (vertices of the cube with an even sum), "cross-polytope" (plus
            and minus unit vectors) or "permutohedron" (permutations of 1, ..., n).
        n: the dimension of the space; the planes are in R^(n+1), coordinates (w_0, w).

    Known counts: the cube's are those of `threshold_functions`; the cross-polytope has
    2 3^n - 2^n regions, chi(t) = (t - 1)^n + (t - 1)(t - 2)^n; the demicube 4, 16, 146, 3756 for
    n = 2 to 5.
    Source: T. Brysiewicz, H. Eble, L. Kuehne, Discrete and Computational Geometry 70 (2023) and
    https://mathrepo.mis.mpg.de/CountingChambers; OEIS A027649.

    >>> separations("cross-polytope", 3).f_vector[-1]
    46
    """
    if not isinstance(polytope, str) or polytope not in _VERTICES:
        raise InputError(f"the polytope is {shown(polytope)}; there are {', '.join(_VERTICES)}")
    n = at_least(n, 1, "n")
    vertices = {"cross-polytope": 2 * n, "permutohedron": math.gamma(min(n, 169) + 1)}
    planned(vertices.get(polytope, budget.power(2, n)), n + 1)
    return Arrangement([(1, *vertex) for vertex in _VERTICES[polytope](n)])


def discriminantal(n: int, d: int = 3, *, affine: bool = False, seed: int = 0) -> Arrangement:
    """Return all planes through d - 1 of n random vectors in R^d; affine: through d of n points.

    Central, it is the discriminantal arrangement B(n, n - d) of Manin and Schechtman: in which
    translations n hyperplanes of R^(n-d) are not in general position. Entries are up to 999.
    Whether the vectors are generic enough for the largest intersection lattice is not checked; if
    they are, the counts are those in print.

    Known counts: for d = n - 1 those of the braid arrangement of n letters; the lines through n
    points of the plane have (n-1)(n^3 - 5n^2 + 18n - 8) / 8 regions.
    Source: Yu. Manin, V. Schechtman, Advanced Studies in Pure Mathematics 17 (1989);
    C. Athanasiadis, Discrete and Computational Geometry 21 (1999); OEIS A055503.

    >>> discriminantal(5, 2, affine=True).f_vector[-1]
    41
    """
    d, affine = at_least(d, 1, "d"), flag(affine, "affine")
    n = at_least(n, d, "n")
    width = d + affine
    planned(budget.choose(n, width - 1), width, 400 * width)
    points = random_integer(n, d, bound=999, seed=seed).integer_planes
    vectors = [(*point[:-1], 1) if affine else point[:-1] for point in points]
    rows = []
    for chosen in combinations(vectors, width - 1):
        kept = ([[v[j] for j in range(width) if j != k] for v in chosen] for k in range(width))
        rows.append([(-1) ** k * determinant(minor) for k, minor in enumerate(kept)])
    if affine:
        return Arrangement([row[:-1] for row in rows], [-row[-1] for row in rows])
    return Arrangement(rows)


def threshold(n: int) -> Arrangement:
    """Return the threshold arrangement x_i + x_j = 0 for i < j in R^n.

    Known counts: as many regions as labelled threshold graphs, 1, 2, 8, 46, 332, 2874, ...
    Source: R. Stanley, An Introduction to Hyperplane Arrangements (2007), exercises of
    lecture 5; OEIS A005840.

    >>> threshold(4).f_vector[-1]
    46
    """
    n = at_least(n, 1, "n")
    planned(comb(n, 2), n)
    return Arrangement(sums(n), dimension=n)


def threshold_functions(n: int) -> Arrangement:
    """Return w_0 + w . x = 0 for all x in {0, 1}^n, in the space R^(n+1) of (w_0, w).

    Known counts: as many regions as linear threshold functions of n variables, 2, 4, 14, 104,
    1882, ...
    Source: T. Cover, IEEE Transactions on Electronic Computers 14 (1965); OEIS A000609.

    >>> threshold_functions(2).f_vector[-1]
    14
    """
    n = at_least(n, 0, "n")
    planned(budget.power(2, n), n + 1)
    return Arrangement([(1, *x) for x in product((0, 1), repeat=n)])


def resonance(n: int) -> Arrangement:
    """Return the resonance arrangement sum_{i in I} x_i = 0, over all nonempty I, in R^n.

    Known counts: 2, 6, 32, 370, 11292, ... regions.
    Source: H. Kamiya, A. Takemura, H. Terao, Ranking patterns of unfolding models of
    codimension one, Advances in Applied Mathematics 47 (2011); OEIS A034997.

    >>> resonance(3).f_vector[-1]
    32
    """
    n = at_least(n, 1, "n")
    planned(budget.power(2, n), n)
    return Arrangement([x for x in product((0, 1), repeat=n) if any(x)])
