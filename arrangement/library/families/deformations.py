"""Affine relatives of the braid arrangement: Shi, Catalan, Linial, semiorder.

All live in R^n and have rank n - 1 (every plane contains the direction (1, ..., 1)). Their
bounded regions are those of the essentialization.
"""

from __future__ import annotations

from collections.abc import Sequence

from arrangement.arrangement import Arrangement

from .checks import at_least
from .classical import differences


def shi(n: int) -> Arrangement:
    """Return the Shi arrangement x_i - x_j = 0, 1 for i < j.

    Known counts: (n+1)^(n-1) regions, (n-1)^(n-1) of them bounded; chi(t) = t (t - n)^(n-1).
    Source: J.-Y. Shi, Lecture Notes in Mathematics 1179 (1986); R. Stanley, An Introduction to
    Hyperplane Arrangements (2007), lecture 5; OEIS A000272.

    >>> shi(3).f_vector
    (0, 6, 21, 16)
    """
    return _deformed(n, (0, 1))


def catalan(n: int) -> Arrangement:
    """Return the Catalan arrangement x_i - x_j = -1, 0, 1 for i < j.

    Known counts: n! C_n regions, C_n the Catalan number;
    chi(t) = t (t - n - 1)(t - n - 2) ... (t - 2n + 1).
    Source: R. Stanley, An Introduction to Hyperplane Arrangements (2007), lecture 5.

    >>> catalan(3).f_vector[-1]
    30
    """
    return _deformed(n, (-1, 0, 1))


def linial(n: int) -> Arrangement:
    """Return the Linial arrangement x_i - x_j = 1 for i < j.

    Known counts: as many regions as labelled alternating trees on n + 1 vertices, 1, 2, 7, 36,
    246, ...; chi(t) = t 2^-n sum_k C(n, k) (t - k)^(n-1).
    Source: A. Postnikov, R. Stanley, Journal of Combinatorial Theory A 91 (2000); OEIS A007889.

    >>> linial(3).f_vector[-1]
    7
    """
    return _deformed(n, (1,))


def semiorder(n: int) -> Arrangement:
    """Return the semiorder arrangement x_i - x_j = -1, 1 for i < j.

    Known counts: as many regions as labelled semiorders, 1, 3, 19, 183, 2371, ...
    Source: R. Stanley, Proceedings of the National Academy of Sciences 93 (1996);
    OEIS A006531.

    >>> semiorder(3).f_vector[-1]
    19
    """
    return _deformed(n, (-1, 1))


def _deformed(n: int, offsets: Sequence[int]) -> Arrangement:
    """Return the planes x_i - x_j = b for i < j and every offset b."""
    at_least(n, 1, "n")
    rows = differences(n)
    return Arrangement(
        [row for row in rows for _ in offsets], [b for _ in rows for b in offsets], dimension=n
    )
