"""The generators of the dual of central planes, and the duals of rank 2 and 1: polygon, segment.

With the segments ``[-g_i, g_i]`` along the normals as generators the dual is the zonotope
``sum_i [-g_i, g_i]``, whose vertex for the region of sign vector s is ``sum_i s_i g_i``
([Ziegler1995], section 7.3). So it is convex by construction.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.console.number_form import ReprMixin
from arrangement.enumeration.choose import enumerate_faces
from arrangement.errors import InputError
from arrangement.numbers.exact import IntegerVector, RationalVector, rational_vector, shown
from arrangement.planes.planes import Planes

_REMEDIES = {
    0: "a single point; there are no planes",
    1: "a segment; use dual_segment",
    2: "a polygon; use dual_polygon",
    3: "a polyhedron; use dual_polyhedron",
}


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
        remedy = _REMEDIES.get(found, f"a dual of dimension {found}, which this package lacks")
        raise InputError(f"the normals have rank {found}, not {rank}: the dual is {remedy}")
    return Generators(factors, vectors, denominator)


@dataclass(frozen=True, slots=True, repr=False)
class _FlatDual(ReprMixin):
    """A dual that is not a polyhedron.

    Attributes:
        arrangement: the planes.
        signs: the sign vector of the region of each corner, in cyclic order.
        vertices: the exact corners ``sum_i s_i g_i``, in the same order.
    """

    arrangement: Planes
    signs: tuple[tuple[int, ...], ...]
    vertices: tuple[RationalVector, ...]


class DualPolygon(_FlatDual):
    """The dual of a pencil of k distinct planes in R^d: a centrally symmetric polygon, 2k corners.

    It lies in the plane spanned by the normals. It is not a polyhedron: its graph is one cycle, and
    it has two sides instead of faces, so nothing of `DualPolyhedron` applies to it.
    """

    dimension = 2


class DualSegment(_FlatDual):
    """The dual of one plane, given once or more often: a segment through the origin."""

    dimension = 1


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
    return DualPolygon(arrangement, signs, tuple(_sum(spans, row) for row in signs))


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
    return DualSegment(arrangement, signs, tuple(_sum(spans, row) for row in signs))


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
