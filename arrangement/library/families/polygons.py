"""Lines of regular polygons: the mirrors of dihedral groups, and two simplicial families."""

from __future__ import annotations

from itertools import accumulate

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.numbers.exact import quotient, shown
from arrangement.numbers.number_field import Real
from arrangement.numbers.polynomials import MAX_DEGREE
from arrangement.numbers.real_entries import real_vector

from .checks import at_least


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
            of a degree above `arrangement.numbers.polynomials.MAX_DEGREE`.

    >>> regular(10).f_vector
    (1, 32, 90, 60)
    """
    at_least(planes, 6, "planes")
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


def mirrors(n: int) -> list[tuple[Real, Real]]:
    """Return normals of the mirrors of a regular n-gon in R^2, with the y-axis stretched.

    The k-th one runs at the angle k pi / n; it is divided by the sine of 2 pi / n, or for odd k
    and even n by that of half of it.
    """
    cosines, sines = _multiples(n)
    if n % 2:
        return [(-2 * s, c) for c, s in zip(cosines, sines, strict=True)]
    found = []
    sums = list(accumulate(cosines[1:], initial=1))
    for k in range(n):
        j = k // 2
        if k % 2:
            found.append((-2 * sums[j], cosines[j] + cosines[j + 1]))
        else:
            found.append((-2 * sines[j], cosines[j]))
    return found


def _multiples(n: int) -> tuple[list[Real], list[Real]]:
    """Return 2 cos(k x) and sin(k x) / sin(x) for x = 2 pi / n, k = 0, ..., n - 1."""
    import sympy

    if n > 8 * MAX_DEGREE**2 or sympy.totient(n) > 2 * MAX_DEGREE:  # its degree is half of that
        raise InputError(
            f"the cosine of 2 pi / {shown(n)} has a degree above {MAX_DEGREE}; take fewer planes"
        )
    t = real_vector([2 * sympy.cos(2 * sympy.pi / n)], "the cosine")[0]
    cosines: list[Real] = [2, t]
    sines: list[Real] = [0, 1]
    for row in (cosines, sines):
        while len(row) < n:
            row.append(t * row[-1] - row[-2])
    return cosines, sines
