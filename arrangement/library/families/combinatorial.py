"""Arrangements of thresholds and subset sums."""

from __future__ import annotations

from itertools import product
from math import comb

from arrangement.arrangement import Arrangement
from arrangement.numbers import budget

from .checks import at_least, planned
from .classical import sums


def threshold(n: int) -> Arrangement:
    """Return the threshold arrangement x_i + x_j = 0 for i < j in R^n.

    Known counts: as many regions as labelled threshold graphs, 1, 2, 8, 46, 332, 2874, ...
    Source: R. Stanley, An Introduction to Hyperplane Arrangements (2007), exercises of
    lecture 5; OEIS A005840.

    >>> threshold(4).f_vector[-1]
    46
    """
    at_least(n, 1, "n")
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
    at_least(n, 0, "n")
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
    at_least(n, 1, "n")
    planned(budget.power(2, n), n)
    return Arrangement([x for x in product((0, 1), repeat=n) if any(x)])
