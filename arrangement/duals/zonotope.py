"""The dual of central planes: the zonotope of their normals.

With the segments ``[-g_i, g_i]`` along the normals as generators the dual is the zonotope
``sum_i [-g_i, g_i]``, whose vertex for the region of sign vector s is ``sum_i s_i g_i``
([Ziegler1995], section 7.3). So it is convex by construction.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np

from arrangement.console.number_form import ReprMixin
from arrangement.counts.whitney import region_count
from arrangement.enumeration.choose import enumerate_faces, enumerate_regions
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    largest,
    quotient,
    rational_vector,
    shown,
)
from arrangement.numbers.linear.rank import determinant
from arrangement.planes.planes import Planes

#: What a determinant takes for each of its entries.
_STEPS = 10


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


def generators(arrangement: Planes, lengths: Iterable[Any] | None, rank: int = 0) -> Generators:
    """Return the generators of the dual of a central arrangement of rank 1 or more.

    Raises:
        InputError: the arrangement is affine, has no planes or another than a required rank, or
            there are not as many positive factors as planes.
    """
    if not arrangement.is_central:
        raise InputError(
            "some offsets are not zero, and only planes through the origin have a dual "
            "polyhedron; leave the offsets out, or take arrangement.counts.cone(arrangement)"
        )
    m = len(arrangement)
    if not m:
        raise InputError("there are no planes: the dual is a single point")
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
    if rank not in (0, arrangement.rank):
        kind = {1: "a segment", 2: "a polygon", 3: "a polyhedron"}
        raise InputError(
            f"the normals have rank {arrangement.rank}, not {rank}: the dual is "
            f"{kind.get(arrangement.rank, f'of dimension {arrangement.rank}')}; use dual_zonotope"
        )
    return Generators(factors, vectors, denominator)


@dataclass(frozen=True, repr=False)
class Zonotope(ReprMixin):
    """The zonotope ``sum_i [-g_i, g_i]`` of central planes: a segment, a polygon, a polytope.

    Each part is computed when it is first read.

    Attributes:
        arrangement: the planes.
        generators: the vectors ``g_i = lengths[i] * n_i``; those of coincident planes add up.
    """

    arrangement: Planes
    generators: Generators

    @property
    def dimension(self) -> int:
        """The rank of the planes."""
        return self.arrangement.rank

    @cached_property
    def signs(self) -> Any:
        """The sign vector of the region of each vertex; of a polygon in cyclic order."""
        regions = enumerate_regions(self.arrangement, region_count)
        if regions is None:
            regions = enumerate_faces(self.arrangement).of_dimension(self.arrangement.dimension)
        signs = tuple(map(tuple, regions.signs.tolist()))
        return signs if self.dimension > 2 else _in_cyclic_order(self.arrangement, set(signs))

    @cached_property
    def integer_vertices(self) -> tuple[IntegerVector, ...]:
        """The vertices times ``generators.denominator``, integers."""
        vectors = self.generators.vectors
        # In machine integers if no sum can leave them.
        kind: Any = np.int64 if largest(vectors) * len(vectors) < 2**62 else object
        sums = np.array(self.signs, dtype=kind) @ np.array(vectors, dtype=kind)
        return tuple(map(tuple, sums.tolist()))

    @cached_property
    def vertices(self) -> tuple[RationalVector, ...]:
        """The exact vertices ``sum_i s_i g_i``, with the normals in their stored scaling."""
        d = self.generators.denominator
        return tuple(tuple(quotient(x, d) for x in v) for v in self.integer_vertices)

    @property
    def volume(self) -> Fraction:
        """The exact volume, as a body of R^d: 0 if the normals span less.

        Source: P. McMullen, Volumes of projections of unit cubes, Bulletin of the London
        Mathematical Society 16 (1984); G. Shephard, Combinatorial properties of associated
        zonotopes, Canadian Journal of Mathematics 26 (1974).

        >>> from arrangement import Arrangement
        >>> Arrangement([[1, 0], [0, 1], [1, 1]]).dual().volume
        Fraction(12, 1)
        """
        vectors = self.generators.vectors
        d = len(vectors[0])
        budget.check_cost(
            f"the volume of a zonotope of {len(vectors)} generators",
            steps=_STEPS * d**3 * budget.choose(len(vectors), d),
        )
        total = sum(abs(determinant(chosen)) for chosen in combinations(vectors, d))
        whole: Fraction = quotient(2**d * total, self.generators.denominator**d)
        return whole


def _in_cyclic_order(
    arrangement: Planes, remaining: set[tuple[int, ...]]
) -> tuple[tuple[int, ...], ...]:
    """Walk from region to region of a pencil, never back through the wall just crossed."""
    order = [max(remaining)]
    remaining.remove(order[0])
    while remaining:
        crossings = (
            tuple(-s if i in members else s for i, s in enumerate(order[-1]))
            for members in arrangement.distinct
        )
        order.append(next(signs for signs in crossings if signs in remaining))
        remaining.remove(order[-1])
    return tuple(order)
