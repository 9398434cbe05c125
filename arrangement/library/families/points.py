"""Planes of points and sets: separations, what points span, bisectors, thresholds, subset sums.

Points are sequences of exact numbers, or a text such as ``0,0; 1,0; 1/2,2``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations, permutations, product
from math import comb
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from arrangement.arrangement import Arrangement
from arrangement.console.options.signature import Syntax
from arrangement.errors import InputError
from arrangement.library.families.classical import sums
from arrangement.library.families.randoms import random_integer
from arrangement.library.families.simplicial import regular_corners
from arrangement.numbers import budget
from arrangement.numbers.arguments import at_least, check_reach, flag
from arrangement.numbers.exact import IntegerVector, dot, primitive, shown, unoriented
from arrangement.numbers.linear.rank import determinant
from arrangement.planes.polygon import convex_polygon, exact_points, line_through

if TYPE_CHECKING:
    Points: TypeAlias = str | Iterable[Iterable[Any]]
    Corners: TypeAlias = int | Points
else:  # on a command line a text
    Points = Annotated[Any, Syntax(metavar="X,Y;X,Y;...")]
    Corners = Annotated[Any, Syntax(metavar="N|X,Y;X,Y;...")]

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
    check_reach(vertices.get(polytope, budget.power(2, n)), n + 1)
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
    check_reach(budget.choose(n, width - 1), width, 400 * width)
    points = random_integer(n, d, bound=999, seed=seed).integer_planes
    rows = _span([(*point[:-1], 1) if affine else point[:-1] for point in points], width)
    if affine:
        return Arrangement([row[:-1] for row in rows], [-row[-1] for row in rows])
    return Arrangement(rows)


def _span(vectors: Sequence[IntegerVector], width: int) -> list[list[int]]:
    """Return the normals of what any ``width - 1`` of the vectors span, 0 if they are dependent."""
    rows = []
    for chosen in combinations(vectors, width - 1):
        kept = ([[v[j] for j in range(width) if j != k] for v in chosen] for k in range(width))
        rows.append([(-1) ** k * determinant(minor) for k, minor in enumerate(kept)])
    return rows


def lines_through(points: Points) -> Arrangement:
    """Return the lines through two or more of some points of R^2, each line once.

    In R^d: the hyperplanes through d or more of the points that determine them.

    Args:
        points: different points, such as 0,0;1,0;1/2,2.

    Known counts: those of n points in general position have (n-1)(n^3 - 5n^2 + 18n - 8) / 8
    regions, for n = 4 as many as 18; the vertices of a square have 16.
    Source: OEIS A055503.

    >>> lines_through([(0, 0), (1, 0), (0, 1), (2, 3)]).f_vector
    (7, 24, 18)
    """
    exact = exact_points(points)
    d = len(exact[0])
    check_reach(budget.choose(len(exact), d), d)
    vectors = [primitive((*point, Fraction(1))) for point in exact]
    rows = dict.fromkeys(unoriented(row) for row in _span(vectors, d + 1) if any(row))
    return Arrangement([row[:-1] for row in rows], [-row[-1] for row in rows], dimension=d)


def polygon(corners: Corners) -> Arrangement:
    """Return the lines of the sides of a convex polygon, with the polygon on the positive sides.

    It says what `Arrangement.pieces` and the option --inside of the commands take as the inside.

    Args:
        corners: in their order around, such as 0,0;1,0;1/2,2; or N, for a regular N-gon. Its y-axis
            is stretched by less than 1/1000, so that its coordinates are in the field of
            cos(2 pi / N): they are rational for N = 3, 4 and 6.

    Known counts: the sides of a regular polygon with n sides, n odd, have n (n + 1) / 2 + 1
    regions.

    >>> sorted([str(x) for x in corner.witness] for corner in polygon(4).vertices())
    [['-2', '0'], ['0', '-2'], ['0', '2'], ['2', '0']]
    >>> polygon("0,0;1,0;0,1").region_count()
    7
    """
    given: Any = corners
    if isinstance(corners, str) and corners.strip().isdecimal():
        given = int(corners)
    if not isinstance(given, str) and not isinstance(given, Iterable):
        given = regular_corners(at_least(given, 3, "corners"))
    sides = convex_polygon(given)
    return Arrangement(sides.normals, sides.offsets)


def diagonals(n: int) -> Arrangement:
    """Return the lines of all diagonals of a regular n-gon, which `polygon` has.

    Known counts: with the sides drawn, the diagonals cut its inside into 1, 4, 11, 24, 50, 80, 154,
    220, 375, 444 cells for n = 3, 4, ...; and their lines cut its outside into 1, 4, 10, 18, 35,
    64, 117, 190 cells. Without a polygon the lines are those of `lines_through`, but for the sides.
    Source: B. Poonen, M. Rubinstein, SIAM Journal on Discrete Mathematics 11 (1998); OEIS A007678
    and A217745.

    >>> cut = diagonals(6).pieces(polygon(6))
    >>> cut.inside.cells, cut.outside.cells
    (24, 18)
    """
    n = at_least(n, 3, "n")
    check_reach(n * (n - 3) / 2, 2)
    points = regular_corners(n)
    pairs = [(i, j) for i, j in combinations(range(n), 2) if 1 < j - i < n - 1]
    lines = [line_through(points[i], points[j]) for i, j in pairs]
    return Arrangement([line[:2] for line in lines], [line[2] for line in lines], dimension=2)


def complete_bipartite(n: int) -> Arrangement:
    """Return the lines from each point (0, i) to each point (1, j), for i, j = 0, ..., n - 1.

    Known counts: as segments they are a drawing of the graph K(n, n), which has 0, 2, 12, 40, 96,
    204, 368, 634 bounded faces for n = 1, 2, ...; with the two missing sides of the rectangle
    around it 2n - 2 more.
    Source: S. Legendre, Journal of Integer Sequences 12 (2009); M. Griffiths, the same 13 (2010);
    OEIS A290131 and A306302.

    >>> complete_bipartite(3).pieces("0,0;1,0;1,2;0,2").inside.cells
    16
    """
    n = at_least(n, 1, "n")
    check_reach(n * n, 2)
    pairs = list(product(range(n), repeat=2))
    return Arrangement([(i - j, 1) for i, j in pairs], [i for i, _ in pairs])


def bisectors(points: Points) -> Arrangement:
    """Return the points that are as far from p as from q, for each pair p, q of some points of R^d.

    A region has one order of the points by their distance. The points nearer to p are on the
    positive side of its planes with later points.

    Args:
        points: different points, such as 0,0;1,0;1/2,2.

    Known counts: n points of the plane in general position have as many regions as permutations of
    n letters with n, n - 1 or n - 2 cycles: 1, 2, 6, 18, 46, 101, ...
    Source: I. Good, T. Tideman, Journal of Combinatorial Theory A 23 (1977).

    >>> bisectors([(0, 0), (5, 0), (1, 3), (-2, 7)]).f_vector[-1]
    18
    """
    exact = exact_points(points)
    d = len(exact[0])
    check_reach(comb(len(exact), 2), d)
    pairs = list(combinations(exact, 2))
    normals = [[2 * (x - y) for x, y in zip(p, q, strict=True)] for p, q in pairs]
    offsets = [dot(p, p) - dot(q, q) for p, q in pairs]
    return Arrangement(normals, offsets, dimension=d)


def threshold(n: int) -> Arrangement:
    """Return the threshold arrangement x_i + x_j = 0 for i < j in R^n.

    Known counts: as many regions as labelled threshold graphs, 1, 2, 8, 46, 332, 2874, ...
    Source: R. Stanley, An Introduction to Hyperplane Arrangements (2007), exercises of
    lecture 5; OEIS A005840.

    >>> threshold(4).f_vector[-1]
    46
    """
    n = at_least(n, 1, "n")
    check_reach(comb(n, 2), n)
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
    check_reach(budget.power(2, n), n + 1)
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
    check_reach(budget.power(2, n), n)
    return Arrangement([x for x in product((0, 1), repeat=n) if any(x)])
