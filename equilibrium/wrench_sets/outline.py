"""The exact boundary of a finite union of convex polygons, bounded or not, flat ones included.

A generic point of an edge is a boundary point of the union exactly when no polygon covers the
other side of the edge there. Which part of the edge's line a polygon covers is one interval. So the
boundary is what is left of every edge after these intervals are taken away: no overlay is built.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from operator import itemgetter
from typing import Any

import numpy as np

from arrangement.console.number_form import JsonMixin
from arrangement.console.progress import watched
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, to_text
from arrangement.numbers.linear.intervals import Interval, is_long, remainder, union
from arrangement.numbers.linear.polyhedron import Polyhedron
from equilibrium.core.contact_rows import negated
from equilibrium.wrench_sets.separation import both_ways, possibly_meeting, sides


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
            name: None if point is None else list(map(to_text, point))
            for name, point in (
                ("start", self.start),
                ("end", self.end),
                ("direction", self.direction),
            )
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
    edges = outer_facets(solid)
    pairs = zip(edges, polygons_near(edges, solid), strict=True)
    for (row, carrying), near in watched(pairs, "lines", len(edges)):
        yield from _segments(row, carrying, [p for p in near if row not in p.inequalities])


def outer_facets(solid: Iterable[Polyhedron]) -> list[tuple[IntegerVector, list[Polyhedron]]]:
    """Return the conditions of facets without the same facet behind, each with their polyhedra.

    A facet with a polyhedron on either side is inside a union, and most are.
    """
    facets: dict[IntegerVector, dict[frozenset[IntegerVector], Polyhedron]] = {}
    for p in solid:
        for row in p.inequalities:
            facets.setdefault(row, {})[frozenset(tight(row, p))] = p
    outer = []
    for row in sorted(facets):
        behind = facets.get(negated(row), ())
        if alone := [p for ends, p in facets[row].items() if ends not in behind]:
            outer.append((row, alone))
    return outer


def _dangling_edges(thin: Sequence[Polyhedron], solid: Sequence[Polyhedron]) -> Iterator[Segment]:
    """Yield the parts of flat polygons outside the two-dimensional part."""
    lines: dict[IntegerVector, list[Polyhedron]] = {}
    for p in thin:
        lines.setdefault(max(p.equalities[0], negated(p.equalities[0])), []).append(p)
    edges = sorted(lines.items(), key=itemgetter(0))
    for (row, carrying), near in zip(edges, polygons_near(edges, solid), strict=True):
        yield from _segments(row, carrying, near)


def polygons_near(
    edges: Sequence[tuple[IntegerVector, Sequence[Polyhedron]]], solid: Sequence[Polyhedron]
) -> Iterator[list[Polyhedron]]:
    """Yield for each line the polygons that may cover a part of its edges.

    Args:
        edges: each line with the polygons that have an edge in it, or lie in it.
    """
    above, below = sides([row for row, _ in edges], solid)
    meeting = possibly_meeting([tight(row, p) for row, carrying in edges for p in carrying], solid)
    start = 0
    for i, (_, carrying) in enumerate(edges):
        near = meeting[start : start + len(carrying)].any(axis=0) & ~above[i] & ~below[i]
        start += len(carrying)
        yield [solid[j] for j in np.flatnonzero(near).tolist()]


def tight(row: IntegerVector, polygon: Polyhedron) -> list[IntegerVector]:
    """Return the homogeneous generators of the part of a polygon in a line at its boundary."""
    rays, lines = polygon.homogeneous
    return both_ways(*([x for x in part if dot(row, x) == 0] for part in (rays, lines)))


def _segments(
    row: IntegerVector, edges: Iterable[Polyhedron], covering: Iterable[Polyhedron]
) -> Iterator[Segment]:
    """Yield what is left of edges in a line after the parts in other polygons are taken away.

    The point of parameter s of the line ``normal . x + constant = 0`` is ``(-constant normal + s
    direction) / |normal|^2``, so that all coefficients stay integers.
    """
    (*normal, constant), square = row, dot(row[:2], row[:2])
    base, along = tuple(-constant * x for x in normal), (normal[1], -normal[0])

    def parts(polygons: Iterable[Polyhedron]) -> list[Interval]:
        intervals = (p.along_homogeneous((*base, square), (*along, 0)) for p in polygons)
        return [part for part in intervals if part is not None and is_long(part)]

    def point(s: Fraction | None) -> RationalVector | None:
        if s is None:
            return None
        return tuple((b + s * u) / square for b, u in zip(base, along, strict=True))

    cover = parts(covering)
    for whole in union(parts(edges)):
        for low, high in remainder(whole, cover):
            yield Segment(row[:2], constant, point(low), point(high))
