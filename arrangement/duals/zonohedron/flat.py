"""Generators of a zonotope, and duals that are flat: polygons and segments."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.console.number_form import Shown
from arrangement.enumeration.choose import enumerate_faces
from arrangement.errors import InputError
from arrangement.numbers.exact import IntegerVector, RationalVector, rational_vector, shown
from arrangement.planes.planes import Planes


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


_REMEDIES = {
    0: "a single point; there are no planes",
    1: "a segment; use dual_segment",
    2: "a polygon; use dual_polygon",
    3: "a polyhedron; use dual_polyhedron",
}


@dataclass(frozen=True, slots=True, repr=False)
class DualPolygon(Shown):
    """The dual of a pencil of k distinct planes: a centrally symmetric polygon of 2k corners.

    It lies in the plane spanned by the normals. It is no polyhedron: its graph is one cycle, and
    it has two sides instead of faces, so nothing of `DualPolyhedron` applies to it.

    Attributes:
        arrangement: the planes, in R^d, of rank 2.
        signs: the sign vector of each corner's region, in cyclic order.
        vertices: the exact corners ``sum_i s_i g_i``, in the same order.
    """

    arrangement: Planes
    signs: tuple[tuple[int, ...], ...]
    vertices: tuple[RationalVector, ...]

    dimension = 2


@dataclass(frozen=True, slots=True, repr=False)
class DualSegment(Shown):
    """The dual of one plane, given once or more often: a segment through the origin.

    Attributes:
        arrangement: the planes, all coincident.
        signs: the sign vectors of the two sides.
        vertices: the exact ends ``sum_i s_i g_i``.
    """

    arrangement: Planes
    signs: tuple[tuple[int, ...], ...]
    vertices: tuple[RationalVector, ...]

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
    spans = generators(arrangement, lengths)
    require_rank(arrangement, 2, _REMEDIES)
    signs = _in_cyclic_order(arrangement)
    return DualPolygon(arrangement, signs, tuple(_sum(spans, row) for row in signs))


def dual_segment(arrangement: Planes, lengths: Iterable[Any] | None = None) -> DualSegment:
    """Return the dual of an arrangement of rank 1, in R^d for any d.

    Args and errors: as for `dual_polygon`.

    >>> from arrangement import Arrangement
    >>> dual_segment(Arrangement([[2, 0, 0]])).vertices[0]
    (Fraction(1, 1), Fraction(0, 1), Fraction(0, 1))
    """
    spans = generators(arrangement, lengths)
    require_rank(arrangement, 1, _REMEDIES)
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
        crossings = (_across(current, members) for members in arrangement.distinct)
        current = next(signs for signs in crossings if signs in remaining)
        remaining.remove(current)
        order.append(current)
    return tuple(order)


def _across(signs: tuple[int, ...], members: tuple[int, ...]) -> tuple[int, ...]:
    """Return the sign vector on the other side of one class of coincident planes."""
    changed = list(signs)
    for plane in members:
        changed[plane] = -changed[plane]
    return tuple(changed)


def _sum(spans: Generators, signs: tuple[int, ...]) -> RationalVector:
    """Return ``sum_i s_i g_i``."""
    return tuple(
        Fraction(sum(s * x for s, x in zip(signs, column, strict=True)), spans.denominator)
        for column in zip(*spans.vectors, strict=True)
    )
