"""The exact convex hull of rational points in space, by gift wrapping.

All predicates are signs of integer determinants, so coplanar and repeated points are no special
risk. A hull may also be flat: its dimension says so, and then it has no facets.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import lcm
from typing import Any

from arrangement.exact import IntegerVector, RationalVector, dot, primitive
from arrangement.linear import cross, rank


@dataclass(frozen=True)
class Facet:
    """The points with ``normal . x <= offset`` hold the hull; equality holds on the facet.

    Attributes:
        normal: outward, coprime integers.
        offset: a rational.
        vertices: indices into `Hull.vertices`, counter-clockwise seen from outside.
    """

    normal: IntegerVector
    offset: Fraction
    vertices: tuple[int, ...]


@dataclass(frozen=True)
class Hull:
    """A convex hull in space.

    Attributes:
        dimension: of the affine hull: -1 (no points), 0, 1, 2 or 3.
        vertices: the extreme points, without repeats, in lexicographic order.
        facets: of a hull of dimension 3; empty otherwise.
    """

    dimension: int
    vertices: tuple[RationalVector, ...]
    facets: tuple[Facet, ...]

    @property
    def volume(self) -> Fraction:
        """The exact volume; 0 for a flat hull."""
        six = Fraction(0)
        for facet in self.facets:
            a, *rest = (self.vertices[i] for i in facet.vertices)
            six += sum((dot(a, cross(b, c)) for b, c in pairwise(rest)), Fraction(0))
        return six / 6

    def has_inside(self, point: Sequence[Fraction | int]) -> bool:
        """Return whether a point lies strictly inside; never for a flat hull."""
        return self.dimension == 3 and all(dot(f.normal, point) < f.offset for f in self.facets)


def convex_hull(points: Iterable[Sequence[Fraction | int]]) -> Hull:
    """Return the convex hull of finitely many points of space.

    Complexity: O(n f) exact predicates for n points and f facets, plus sorting.

    >>> cube = convex_hull((x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1))
    >>> len(cube.vertices), len(cube.facets), cube.volume
    (8, 6, Fraction(1, 1))
    """
    rationals = sorted({tuple(Fraction(x) for x in point) for point in points})
    scale = lcm(*(x.denominator for point in rationals for x in point))
    whole = [tuple(int(x * scale) for x in point) for point in rationals]
    dimension = _affine_rank(whole)
    if dimension < 3:
        extreme = sorted(flat_hull(whole, dimension))
        return Hull(dimension, tuple(rationals[i] for i in extreme), ())
    polygons = _wrap(whole)
    extreme = sorted({i for _, cycle in polygons for i in cycle})
    number = {i: k for k, i in enumerate(extreme)}
    facets = []
    for normal, cycle in polygons:
        offset = Fraction(dot(normal, whole[cycle[0]]), scale)
        facets.append(Facet(normal, offset, tuple(number[i] for i in cycle)))
    return Hull(3, tuple(rationals[i] for i in extreme), tuple(facets))


def flat_hull(points: Sequence[IntegerVector], dimension: int) -> list[int]:
    """Return the extreme points of a flat set, in cyclic order if they form a polygon."""
    if dimension <= 0:
        return list(range(len(points)))[:1]
    if dimension == 1:
        order = sorted(range(len(points)), key=lambda i: points[i])
        return [order[0], order[-1]]
    for drop in range(3):
        kept = [tuple(x for k, x in enumerate(p) if k != drop) for p in points]
        if _affine_rank(kept) == 2:
            return plane_hull(kept)
    raise AssertionError("points of rank 2 keep it in some coordinate plane")


def plane_hull(points: Sequence[Sequence[Fraction | int]]) -> list[int]:
    """Return the extreme points of a planar set, counter-clockwise (Andrew's monotone chain)."""
    order = sorted(range(len(points)), key=lambda i: tuple(points[i]))

    def chain(indices: Iterable[int]) -> list[int]:
        found: list[int] = []
        for i in indices:
            while len(found) > 1 and _turn(points[found[-2]], points[found[-1]], points[i]) <= 0:
                found.pop()
            found.append(i)
        return found

    lower, upper = chain(order), chain(reversed(order))
    cycle = lower[:-1] + upper[:-1]
    return cycle if cycle else order[:1]


def _wrap(points: list[IntegerVector]) -> list[tuple[IntegerVector, list[int]]]:
    """Return all facets (outward normal, cycle of indices): turn about every edge once."""
    first = _first_facet(points)
    found = {first[0]: first[1]}
    pending = _edges(first[1])
    while pending:
        a, b = pending.pop()
        normal, cycle = _polygon(points, _pivot(points, a, b))
        if normal not in found:
            found[normal] = cycle
            pending.extend(_edges(cycle))
    return list(found.items())


def _edges(cycle: list[int]) -> list[tuple[int, int]]:
    """Return the edges of a facet as its neighbours see them: reversed."""
    return [(b, a) for a, b in zip(cycle, cycle[1:] + cycle[:1], strict=True)]


def _pivot(points: list[IntegerVector], a: int, b: int) -> IntegerVector:
    """Return the outward normal of the facet to the left of the hull's directed edge from a to b.

    Seen along the edge, every point lies within a half turn, so one pass finds the extreme one.
    """
    along = _minus(points[b], points[a])
    best: IntegerVector | None = None
    for point in points:
        away = _minus(point, points[a])
        normal = cross(along, away)
        if any(normal) and (best is None or dot(best, away) > 0):
            best = normal
    assert best is not None
    return primitive(best)


def _first_facet(points: list[IntegerVector]) -> tuple[IntegerVector, list[int]]:
    """Return one facet: along an edge of the shadow on a coordinate plane, or beside it.

    The plane that stands on an edge of the shadow holds the hull; it touches in a facet or in one
    edge, and turning about that edge gives a facet.
    """
    shadow = plane_hull([p[:2] for p in points])
    a, b = points[shadow[0]], points[shadow[1]]
    normal = primitive((b[1] - a[1], a[0] - b[0], 0))
    touching = sorted(i for i, p in enumerate(points) if dot(normal, _minus(p, a)) == 0)
    if _affine_rank([points[i] for i in touching]) == 2:
        return _polygon(points, normal)
    ends = sorted(touching, key=lambda i: points[i])
    return _polygon(points, _pivot(points, ends[0], ends[-1]))


def _polygon(points: list[IntegerVector], normal: IntegerVector) -> tuple[IntegerVector, list[int]]:
    """Return the facet of a supporting direction, its cycle counter-clockwise from outside."""
    top = max(dot(normal, p) for p in points)
    members = [i for i, p in enumerate(points) if dot(normal, p) == top]
    drop = max(range(3), key=lambda k: abs(normal[k]))
    # Leaving out coordinate k keeps the orientation for k = 0, 2 and turns it for k = 1.
    kept = [[x for k, x in enumerate(points[i]) if k != drop] for i in members]
    cycle = [members[i] for i in plane_hull(kept)]
    keeps = (normal[drop] > 0) == (drop != 1)
    return normal, cycle if keeps else cycle[::-1]


def _affine_rank(points: Sequence[Sequence[int]]) -> int:
    if not points:
        return -1
    return rank([_minus(p, points[0]) for p in points])


def _turn(a: Sequence[Any], b: Sequence[Any], c: Sequence[Any]) -> Any:
    """Return a number whose sign is 1 for a left turn from a by b to c."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _minus(a: Sequence[Any], b: Sequence[Any]) -> tuple[Any, ...]:
    return tuple(x - y for x, y in zip(a, b, strict=True))
