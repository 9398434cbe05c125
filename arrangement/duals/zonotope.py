"""The generators of the dual of central planes, and the duals of all ranks but 3.

With the segments ``[-g_i, g_i]`` along the normals as generators the dual is the zonotope
``sum_i [-g_i, g_i]``, whose vertex for the region of sign vector s is ``sum_i s_i g_i``
([Ziegler1995], section 7.3). So it is convex by construction.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from typing import Any

from arrangement.console.number_form import ReprMixin
from arrangement.counts.whitney import region_count
from arrangement.enumeration.choose import enumerate_faces, enumerate_regions
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    quotient,
    rational_vector,
    shown,
)
from arrangement.numbers.linear.rank import determinant
from arrangement.planes.planes import Planes

_REMEDIES = {
    0: "a single point; there are no planes",
    1: "a segment; use dual_segment",
    2: "a polygon; use dual_polygon",
    3: "a polyhedron; use dual_polyhedron",
}
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


def generators(arrangement: Planes, lengths: Iterable[Any] | None, rank: int) -> Generators:
    """Return the generators of the dual of a central arrangement of a rank.

    Raises:
        InputError: the arrangement is affine, of another rank, or there are not as many positive
            factors as planes.
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
    if (found := arrangement.rank) != rank:
        remedy = _REMEDIES.get(found, f"of dimension {found}; use dual_polytope")
        raise InputError(f"the normals have rank {found}, not {rank}: the dual is {remedy}")
    return Generators(factors, vectors, denominator)


class VolumeMixin:
    """The volume of a dual, from its generators."""

    generators: Generators

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


@dataclass(frozen=True, slots=True, repr=False)
class _VertexDual(ReprMixin, VolumeMixin):
    """A dual that is known by its vertices.

    Attributes:
        arrangement: the planes.
        generators: as of `DualPolyhedron`.
        signs: the sign vector of the region of each vertex; of a polygon in cyclic order.
        vertices: the exact vertices ``sum_i s_i g_i``, in the same order.
    """

    arrangement: Planes
    generators: Generators
    signs: tuple[tuple[int, ...], ...]
    vertices: tuple[RationalVector, ...]


class DualPolygon(_VertexDual):
    """The dual of a pencil of k distinct planes in R^d: a centrally symmetric polygon, 2k corners.

    It lies in the plane spanned by the normals. It is not a polyhedron: its graph is one cycle, and
    it has two sides instead of faces, so nothing of `DualPolyhedron` applies to it.
    """

    dimension = 2


class DualSegment(_VertexDual):
    """The dual of one plane, given once or more often: a segment through the origin."""

    dimension = 1


class DualPolytope(_VertexDual):
    """The dual of planes of rank 4 or more: a zonotope of that dimension, by its vertices."""

    @property
    def dimension(self) -> int:
        """The rank of the planes."""
        return self.arrangement.rank


def dual_polygon(arrangement: Planes, lengths: Iterable[Any] | None = None) -> DualPolygon:
    """Return the dual of an arrangement of rank 2, in R^d for any d >= 2.

    Args:
        arrangement: central planes whose normals span a plane.
        lengths: a positive factor for each normal; 1 if omitted.

    Raises:
        InputError: another rank, an affine arrangement, or bad lengths.

    >>> from arrangement import Arrangement
    >>> polygon = dual_polygon(Arrangement([[1, 0], [0, 1], [1, 1]]))
    >>> len(polygon.vertices)
    6
    """
    spans = generators(arrangement, lengths, 2)
    signs = _in_cyclic_order(arrangement)
    return DualPolygon(arrangement, spans, signs, tuple(_sum(spans, row) for row in signs))


def dual_segment(arrangement: Planes, lengths: Iterable[Any] | None = None) -> DualSegment:
    """Return the dual of an arrangement of rank 1, in R^d for any d.

    Args and errors: as for `dual_polygon`.

    >>> from arrangement import Arrangement
    >>> dual_segment(Arrangement([[2, 0, 0]])).vertices[0]
    (Fraction(1, 1), Fraction(0, 1), Fraction(0, 1))
    """
    spans = generators(arrangement, lengths, 1)
    positive = arrangement.orientation
    signs = (positive, tuple(-s for s in positive))
    return DualSegment(arrangement, spans, signs, tuple(_sum(spans, row) for row in signs))


def dual_polytope(arrangement: Planes, lengths: Iterable[Any] | None = None) -> DualPolytope:
    """Return the dual of an arrangement of rank 4 or more, as its vertices, one for each region.

    Args and errors: as for `dual_polygon`.

    >>> from arrangement import families
    >>> cube = dual_polytope(families.coordinate(4))
    >>> len(cube.vertices), cube.volume
    (16, Fraction(16, 1))
    """
    spans = generators(arrangement, lengths, max(4, arrangement.rank))
    regions = enumerate_regions(arrangement, region_count)
    if regions is None:
        regions = enumerate_faces(arrangement).of_dimension(arrangement.dimension)
    signs = tuple(map(tuple, regions.signs.tolist()))
    return DualPolytope(arrangement, spans, signs, tuple(_sum(spans, row) for row in signs))


def _in_cyclic_order(arrangement: Planes) -> tuple[tuple[int, ...], ...]:
    """Walk from region to region of a pencil, never back through the wall just crossed."""
    remaining = {
        face.signs for face in enumerate_faces(arrangement).of_dimension(arrangement.dimension)
    }
    current = max(remaining)
    order = [current]
    remaining.remove(current)
    while remaining:
        crossings = (
            tuple(-s if i in members else s for i, s in enumerate(current))
            for members in arrangement.distinct
        )
        current = next(signs for signs in crossings if signs in remaining)
        remaining.remove(current)
        order.append(current)
    return tuple(order)


def _sum(spans: Generators, signs: tuple[int, ...]) -> RationalVector:
    """Return ``sum_i s_i g_i``."""
    return tuple(
        Fraction(sum(s * x for s, x in zip(signs, column, strict=True)), spans.denominator)
        for column in zip(*spans.vectors, strict=True)
    )
