"""The exact boundary of a finite union of convex polygons, bounded or not, flat ones included.

A generic point of an edge is a boundary point of the union exactly when no polygon covers the
other side of the edge there. Which part of the edge's line a polygon covers is one interval. So the
boundary is what is left of every edge after these intervals are taken away: no overlay is built.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.console.number_form import JsonMixin
from arrangement.console.progress import watched
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, to_text
from arrangement.numbers.linear.intervals import Interval, is_long, remainder, union
from arrangement.numbers.linear.polyhedron import Polyhedron
from equilibrium.core.contact_rows import negated
from equilibrium.wrench_sets.separation import possibly_meeting, sides


@dataclass(frozen=True)
class Segment:
    """A closed part of a line: a segment, a ray or the whole line.

    Attributes:
        normal: ``normal . x + constant = 0`` on the line, primitive; where there is a region on
            one side, ``>= 0`` there.
        start, end: None for unbounded; from start to end the region is on the left.
        direction: the direction from start to end, primitive.
    """

    normal: IntegerVector
    constant: int
    start: RationalVector | None
    end: RationalVector | None

    @property
    def direction(self) -> IntegerVector:
        """The direction from start to end; a region on the side of `normal` is on the left."""
        return (self.normal[1], -self.normal[0])

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; null means unbounded."""
        return {
            "start": _point_text(self.start),
            "end": _point_text(self.end),
            "direction": [to_text(x) for x in self.direction],
        }


@dataclass(frozen=True, repr=False)
class Outline(JsonMixin):
    """The boundary of a union of polygons.

    Attributes:
        border: where the two-dimensional part ends, the region on the left.
        whiskers: dangling edges: one-dimensional parts outside the polygons.
        points: isolated points.
    """

    json_fields = ("border", "whiskers", "points")

    border: tuple[Segment, ...]
    whiskers: tuple[Segment, ...]
    points: tuple[RationalVector, ...]


def outline_of(polygons: Sequence[Polyhedron]) -> Outline:
    """Return the boundary of the union of polygons in the plane (dimensions 0, 1 and 2).

    Complexity: O(n e) for n polygons with e edges in all, most of it rounded tests of whether an
    edge is near a polygon; exact intervals for those that are.
    """
    solid = [p for p in polygons if p.dimension == 2]
    thin = [p for p in polygons if p.dimension == 1]
    single = (p.points[0] for p in polygons if p.dimension == 0)
    larger = [*solid, *thin]
    points = sorted({x for x in single if not any(p.contains(x) for p in larger)})
    return Outline(tuple(_border(solid)), tuple(_dangling_edges(thin, solid)), tuple(points))


def _border(solid: Sequence[Polyhedron]) -> Iterator[Segment]:
    """Yield the parts of edges with nothing of the union on their other side."""
    edges: dict[IntegerVector, dict[frozenset[IntegerVector], Polyhedron]] = {}
    for p in solid:
        for row in p.inequalities:
            edges.setdefault(row, {})[frozenset(tight(row, p))] = p
    # An edge with a polygon on either side is inside, and most are.
    alone = {
        row: [p for ends, p in edges[row].items() if ends not in edges.get(negated(row), ())]
        for row in sorted(edges)
    }
    rows = [row for row in alone if alone[row]]
    carriers = [alone[row] for row in rows]
    triples = zip(rows, carriers, polygons_near(rows, carriers, solid), strict=True)
    for row, carrying, near in watched(triples, "lines", len(rows)):
        line = _Line(row)
        covered = [line.part(p) for p in near if row not in p.inequalities]
        yield from line.segments([line.part(p) for p in carrying], covered)


def _dangling_edges(thin: Sequence[Polyhedron], solid: Sequence[Polyhedron]) -> Iterator[Segment]:
    """Yield the parts of flat polygons outside the two-dimensional part."""
    rows = sorted({max(p.equalities[0], negated(p.equalities[0])) for p in thin})
    carriers = [[p for p in thin if p.equalities[0] in (row, negated(row))] for row in rows]
    for row, edges, near in zip(rows, carriers, polygons_near(rows, carriers, solid), strict=True):
        line = _Line(row)
        yield from line.segments([line.part(p) for p in edges], [line.part(p) for p in near])


def polygons_near(
    rows: Sequence[IntegerVector],
    carriers: Sequence[Sequence[Polyhedron]],
    solid: Sequence[Polyhedron],
) -> Iterator[list[Polyhedron]]:
    """Yield for each line the polygons that may cover a part of its edges.

    Args:
        carriers: for each line the polygons with an edge in it, or that lie in it.
    """
    above, below = sides(rows, solid)
    edges = [tight(row, p) for row, carrying in zip(rows, carriers, strict=True) for p in carrying]
    meeting = possibly_meeting(edges, solid)
    start = 0
    for i, carrying in enumerate(carriers):
        near = meeting[start : start + len(carrying)].any(axis=0) & ~above[i] & ~below[i]
        start += len(carrying)
        yield [solid[j] for j in np.flatnonzero(near).tolist()]


def tight(row: IntegerVector, polygon: Polyhedron) -> list[IntegerVector]:
    """Return the homogeneous generators of the part of a polygon in a line at its boundary."""
    rays, lines = polygon.homogeneous
    within = [x for x in rays if dot(row, x) == 0]
    return [*within, *(x for y in lines if dot(row, y) == 0 for x in (y, negated(y)))]


class _Line:
    """An oriented line ``normal . x + constant = 0`` with a parameter along it.

    The point of parameter s is ``(-constant normal + s direction) / |normal|^2``, so that all
    coefficients stay integers.
    """

    def __init__(self, row: IntegerVector) -> None:
        self.normal, self.constant = row[:2], row[2]
        self.square = dot(self.normal, self.normal)
        self.base = tuple(-self.constant * x for x in self.normal)
        self.direction = (self.normal[1], -self.normal[0])

    def part(self, polygon: Polyhedron) -> Interval | None:
        """Return the part of the line in a polygon."""
        return polygon.along_homogeneous((*self.base, self.square), (*self.direction, 0))

    def segments(
        self, edges: Iterable[Interval | None], covered: Iterable[Interval | None]
    ) -> list[Segment]:
        """Return what is left of the edges after the covered parts are taken away."""
        cover = [part for part in covered if part is not None and is_long(part)]
        whole = union(part for part in edges if part is not None and is_long(part))
        left = (rest for part in whole for rest in remainder(part, cover))
        return [
            Segment(self.normal, self.constant, self._point(low), self._point(high))
            for low, high in left
        ]

    def _point(self, parameter: Fraction | None) -> RationalVector | None:
        if parameter is None:
            return None
        pairs = zip(self.base, self.direction, strict=True)
        return tuple((b + parameter * u) / self.square for b, u in pairs)


def _point_text(point: RationalVector | None) -> list[str] | None:
    return None if point is None else [to_text(x) for x in point]
