"""The generators of a zonotope: one exact vector along each normal."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.errors import InputError
from arrangement.exact import IntegerVector, rational_vector, shown
from arrangement.planes import Planes


@dataclass(frozen=True, slots=True)
class Generators:
    """The vectors ``g_i = lengths[i] * n_i``, kept as integers over one denominator.

    Attributes:
        lengths: a positive factor for each plane.
        vectors: ``denominator * g_i``, integers.
        denominator: a positive integer.
    """

    lengths: tuple[Fraction, ...]
    vectors: tuple[IntegerVector, ...]
    denominator: int


def generators(arrangement: Planes, lengths: Iterable[Any] | None) -> Generators:
    """Return the generators of the dual of a central arrangement.

    Raises:
        InputError: the arrangement is affine, or a factor is not positive, or there are not as
            many factors as planes.
    """
    if not arrangement.is_central:
        raise InputError(
            "some offsets are not zero, and only planes through the origin have a dual "
            "polyhedron; leave the offsets out, or take arrangement.counts.cone(arrangement)"
        )
    m = len(arrangement)
    factors = (Fraction(1),) * m if lengths is None else rational_vector(lengths, "lengths")
    if len(factors) != m:
        raise InputError(f"there are {len(factors)} lengths for {m} planes; give one for each")
    for i, factor in enumerate(factors):
        if factor <= 0:
            raise InputError(f"lengths[{i}] is {shown(factor)}; every length must be positive")
    denominator = math.lcm(*(factor.denominator for factor in factors))
    vectors = tuple(
        tuple(int(factor * denominator) * x for x in plane[:-1])
        for factor, plane in zip(factors, arrangement.integer_planes, strict=True)
    )
    return Generators(factors, vectors, denominator)


def require_rank(arrangement: Planes, rank: int, remedies: dict[int, str]) -> None:
    """Refuse an arrangement of another rank, and say what its dual is instead."""
    if arrangement.rank != rank:
        found = arrangement.rank
        remedy = remedies.get(found, f"a dual of dimension {found}, which this package lacks")
        raise InputError(f"the normals have rank {found}, not {rank}: the dual is {remedy}")
