"""Random arrangements, the same for the same seed on every machine: integers only, no floats."""

from __future__ import annotations

from math import isqrt
from random import Random

from arrangement.arrangement import Arrangement
from arrangement.numbers.arguments import at_least, check_reach, flag, whole
from arrangement.numbers.exact import IntegerVector


def random_integer(
    m: int, d: int = 3, *, bound: int = 1000, seed: int = 0, affine: bool = False
) -> Arrangement:
    """Return m planes with normals drawn evenly from the integers -bound..bound, zero left out.

    With `affine` the offsets are drawn from the same range. Nothing keeps planes apart: with a
    small bound they coincide and meet by chance (see `random_degenerate`).

    >>> random_integer(3, 2, seed=7) == random_integer(3, 2, seed=7)
    True
    """
    m, d, bound = at_least(m, 0, "m"), at_least(d, 1, "d"), at_least(bound, 1, "bound")
    affine, seed = flag(affine, "affine"), whole(seed, "seed")
    check_reach(m, d, bound.bit_length())
    source = Random(seed)
    normals = [_nonzero(source, d, bound) for _ in range(m)]
    offsets = [source.randint(-bound, bound) for _ in range(m)] if affine else None
    return Arrangement(normals, offsets, dimension=d)


def random_degenerate(
    m: int, d: int = 3, *, bound: int = 2, seed: int = 0, affine: bool = False
) -> Arrangement:
    """Return m planes with tiny entries: many meet in common flats, some coincide.

    >>> random_degenerate(14).is_simple
    False
    """
    return random_integer(m, d, bound=bound, seed=seed, affine=affine)


def random_sphere(m: int, d: int = 3, *, bits: int = 20, seed: int = 0) -> Arrangement:
    """Return m central planes whose normals are rational points spread evenly on the unit sphere.

    A direction is drawn evenly from a ball of integer points (cube points outside it are drawn
    again). Its stereographic coordinates y, rounded to multiples of 2^-bits and seen from the
    farther pole, give the exactly rational unit vector (2y, 1 - |y|^2) / (1 + |y|^2). Rounding
    moves a direction by less than 2^(2-bits) sqrt(d).

    The stored planes are the coprime integer multiples of these unit vectors.

    >>> from math import isqrt
    >>> squares = [sum(x * x for x in p) for p in random_sphere(5, seed=1).integer_planes]
    >>> all(isqrt(s) ** 2 == s for s in squares)
    True
    """
    m, d, bits = at_least(m, 0, "m"), at_least(d, 1, "d"), at_least(bits, 1, "bits")
    seed = whole(seed, "seed")
    check_reach(m, d, 4 * bits)
    source = Random(seed)
    return Arrangement([_unit_multiple(source, d, bits) for _ in range(m)], dimension=d)


def _nonzero(source: Random, d: int, bound: int) -> IntegerVector:
    while True:
        vector = tuple(source.randint(-bound, bound) for _ in range(d))
        if any(vector):
            return vector


def _unit_multiple(source: Random, d: int, bits: int) -> IntegerVector:
    """Return an integer vector of integer length, in a direction spread evenly."""
    radius = 1 << (bits + 8)
    while True:
        x = _nonzero(source, d, radius)
        square = sum(entry * entry for entry in x)
        if square <= radius * radius:
            break
    scale = 1 << bits
    away = isqrt(square * scale * scale) + scale * abs(x[-1])
    y = [(2 * scale * scale * entry + away) // (2 * away) for entry in x[:-1]]
    square = sum(entry * entry for entry in y)
    last = scale * scale - square
    return (*(2 * scale * entry for entry in y), last if x[-1] >= 0 else -last)
