"""Affine relatives of reflection arrangements: Shi, Catalan, Linial, semiorder, Ish.

A number n stands for planes x_i - x_j = k in R^n, of rank n - 1: every plane contains the direction
(1, ..., 1), and bounded regions are those of the essentialization. A graph, as in `graphical`,
leaves those of them whose i and j are an edge. A type such as "E6" stands for planes in R^6, a root
each with its offsets (see `coxeter`).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import comb
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from arrangement.arrangement import Arrangement
from arrangement.console.options.signature import Syntax
from arrangement.numbers.arguments import at_least, check_reach, is_listed

from .classical import differences, positive_roots, sums
from .graphs import edge_differences

if TYPE_CHECKING:
    import networkx as nx

    Type: TypeAlias = int | str | nx.Graph
else:

    def _value(text: str) -> int | str:
        """Read a number n, or the name of a type, or a graph."""
        return int(text) if text.isascii() and text.isdigit() else text

    Type = Annotated[Any, Syntax(_value, "N|TYPE|EDGES")]


def shi(type: Type, m: int = 1) -> Arrangement:
    """Return the Shi arrangement: a root = 1 - m, ..., m for every positive root; m = 1: 0 and 1.

    Args:
        type: a number, a type such as E6, or edges such as 1-2,2-3.

    Known counts: chi(t) = (t - mh)^r for a type of rank r with Coxeter number h, so (mh + 1)^r
    regions, (mh - 1)^r of them bounded; for a number n and m = 1 it is t (t - n)^(n-1). The graph
    of a forest with k edges has (2m + 1)^k.
    Source: J.-Y. Shi, Lecture Notes in Mathematics 1179 (1986); C. Athanasiadis, Bulletin of the
    London Mathematical Society 36 (2004); of graphs, S. Hopkins, D. Perkinson, Transactions of the
    American Mathematical Society 368 (2016); OEIS A000272.

    >>> shi(3).f_vector
    (0, 6, 21, 16)
    """
    return _deform(type, range(1 - at_least(m, 1, "m"), m + 1))


def catalan(type: Type, m: int = 1) -> Arrangement:
    """Return the Catalan arrangement: a root = -m, ..., m for every positive root.

    Args:
        type: a number, a type such as E6, or edges such as 1-2,2-3.

    Known counts: chi(t) is the product of t - mh - e over the exponents e of a type with Coxeter
    number h; for a number n and m = 1, n! C_n regions, C_n the Catalan number, and
    chi(t) = t (t - n - 1)(t - n - 2) ... (t - 2n + 1).
    Source: C. Athanasiadis, Bulletin of the London Mathematical Society 36 (2004); R. Stanley, An
    Introduction to Hyperplane Arrangements (2007), lecture 5.

    >>> catalan(3).f_vector[-1]
    30
    """
    return _deform(type, range(-at_least(m, 0, "m"), m + 1))


def linial(type: Type) -> Arrangement:
    """Return the Linial arrangement: a root = 1 for every positive root.

    Args:
        type: a number, a type such as E6, or edges such as 1-2,2-3.

    Known counts, for a number n: as many regions as labelled alternating trees on n + 1 vertices,
    1, 2, 7, 36, 246, ...; chi(t) = t 2^-n sum_k C(n, k) (t - k)^(n-1).
    Source: A. Postnikov, R. Stanley, Journal of Combinatorial Theory A 91 (2000); OEIS A007889.

    >>> linial(3).f_vector[-1]
    7
    """
    return _deform(type, (1,))


def semiorder(type: Type) -> Arrangement:
    """Return the semiorder arrangement: a root = -1, 1 for every positive root.

    Args:
        type: a number, a type such as E6, or edges such as 1-2,2-3.

    Known counts, for a number n: as many regions as labelled semiorders, 1, 3, 19, 183, 2371, ...;
    for a cycle of four edges 59.
    Source: R. Stanley, Proceedings of the National Academy of Sciences 93 (1996); OEIS A006531; for
    the cycle, Sage's reference manual, hyperplane_arrangements.bigraphical.

    >>> semiorder(3).f_vector[-1]
    19
    """
    return _deform(type, (-1, 1))


def ish(n: int) -> Arrangement:
    """Return the Ish arrangement in R^n: x_i - x_j = 0 and x_1 - x_j = i, for i < j.

    Known counts: those of the Shi arrangement, chi(t) = t (t - n)^(n-1) and (n+1)^(n-1) regions.
    Source: D. Armstrong, B. Rhoades, Transactions of the American Mathematical Society 364 (2012).

    >>> ish(3).f_vector[-1]
    16
    """
    n = at_least(n, 1, "n")
    check_reach(n * n, n)
    pairs = [(i, j) for i in range(n) for j in range(i + 1, n)]
    first = [[int(k == 0) - int(k == j) for k in range(n)] for _, j in pairs]
    offsets = [0] * len(pairs) + [i + 1 for i, _ in pairs]
    return Arrangement([*differences(n), *first], offsets, dimension=n)


def ish_b(n: int) -> Arrangement:
    """Return the Ish arrangement of type B: x_i = +-x_j for i < j, and x_i = i - n, ..., n - i + 1.

    Known counts: those of the Shi arrangement of B_n, chi(t) = (t - 2n)^n and (2n+1)^n regions.
    Source: T. N. Tran, S. Tsujie, A type B analog of the Ish arrangement, Algebraic Combinatorics 8
    (2025).

    >>> ish_b(2).f_vector[-1]
    25
    """
    n = at_least(n, 1, "n")
    check_reach(2 * n * n, n)
    axes = [(i, k) for i in range(1, n + 1) for k in range(i - n, n - i + 2)]
    units = [[int(j == i) for j in range(1, n + 1)] for i, _ in axes]
    mirrors = [*differences(n), *sums(n)]
    return Arrangement([*mirrors, *units], [*(0 for _ in mirrors), *(k for _, k in axes)])


def _deform(type: Type, offsets: Sequence[int]) -> Arrangement:
    """Return the planes of every root with every offset."""
    size = offsets[-1] - offsets[0] + 1  # a range too long for len()
    if isinstance(type, str) and not type[:1].isdigit():
        rows = [list(root) for root in positive_roots(type)]
        dimension = len(rows[0])
    elif isinstance(type, str) or hasattr(type, "edges") or is_listed(type):
        rows, dimension = edge_differences(type)
    else:
        dimension = at_least(type, 1, "type")
        check_reach(comb(dimension, 2) * size, dimension)
        rows = differences(dimension)
    check_reach(len(rows) * size, dimension)
    planes = [(row, offset) for row in rows for offset in offsets]
    return Arrangement(
        [row for row, _ in planes], [offset for _, offset in planes], dimension=dimension
    )
