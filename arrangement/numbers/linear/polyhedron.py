"""Closed convex polyhedra with exact half-spaces, vertices and rays.

Everything is homogeneous: a condition ``(a, b)`` means ``a . x + b >= 0`` (or ``= 0``); a generator
``(x, h)`` with h > 0 is the point ``x / h``, with h = 0 the direction x.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import factorial, lcm, prod
from typing import Any

from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    bits,
    dot,
    primitive,
    quotient,
    reduced,
    to_text,
)
from arrangement.numbers.linear.cones import Generators, both_ways
from arrangement.numbers.linear.rank import cross, determinant, rank, triple_product

from .intervals import LINE, Interval, where_positive


@dataclass(frozen=True)
class Polyhedron:
    """A non-empty polyhedron in R^n; no condition and no generator is redundant.

    Attributes:
        inequalities, equalities: conditions, primitive integers with the constant last.
        homogeneous: the points and then the rays, and the lines, as homogeneous generators.
    """

    inequalities: tuple[IntegerVector, ...]
    equalities: tuple[IntegerVector, ...]
    homogeneous: Generators

    @cached_property
    def points(self) -> tuple[RationalVector, ...]:
        """Of a polyhedron without lines the vertices, else one point of each minimal face."""
        finite = (ray for ray in self.homogeneous[0] if ray[-1])
        return tuple(tuple(quotient(x, ray[-1]) for x in ray[:-1]) for ray in finite)

    @property
    def rays(self) -> tuple[IntegerVector, ...]:
        """The directions in which it is unbounded."""
        return tuple(ray[:-1] for ray in self.homogeneous[0] if not ray[-1])

    @property
    def lines(self) -> tuple[IntegerVector, ...]:
        """A basis of the directions in which it is unbounded both ways."""
        return tuple(line[:-1] for line in self.homogeneous[1])

    @property
    def dimension(self) -> int:
        """The dimension of the affine hull."""
        return len(self.homogeneous[0][0]) - 1 - len(self.equalities)

    @property
    def bounded(self) -> bool:
        """Whether there is an end in every direction."""
        return all(ray[-1] for ray in self.homogeneous[0]) and not self.homogeneous[1]

    def on(self, row: Sequence[int]) -> int:
        """Return which points and rays lie in a plane ``(a, b)``, as bits."""
        return sum(1 << j for j, x in enumerate(self.homogeneous[0]) if dot(row, x) == 0)

    @cached_property
    def facets(self) -> tuple[int, ...]:
        """For each inequality the points and rays of its facet, as bits."""
        return tuple(map(self.on, self.inequalities))

    @cached_property
    def faces(self) -> dict[int, int]:
        """The points and rays of every face that has a point, as bits, and its dimension."""
        rows, lines = self.homogeneous
        finite = sum(1 << j for j, x in enumerate(rows) if x[-1])
        dimensions = {(1 << len(rows)) - 1: self.dimension}
        waiting = list(dimensions)
        while waiting:
            mask = waiting.pop()
            for part in {mask & facet for facet in self.facets if mask & facet & finite}:
                if part not in dimensions:
                    dimensions[part] = rank([*(rows[j] for j in bits(part)), *lines]) - 1
                    waiting.append(part)
        return dimensions

    def cycle(self, face: int | None = None) -> tuple[int, ...]:
        """Return the points and rays around a face of dimension 2; rays, if any, at the ends.

        Args:
            face: its points and rays, as bits; if omitted, all. The face has no lines.
        """
        rows = self.homogeneous[0]
        whole = (1 << len(rows)) - 1 if face is None else face
        finite = sum(1 << j for j, x in enumerate(rows) if x[-1])
        beside: dict[int, list[int]] = {j: [] for j in bits(whole)}
        for edge in {whole & facet for facet in self.facets}:
            if edge.bit_count() == 2 and edge != whole and edge & finite:
                j, k = bits(edge)
                beside[j].append(k)
                beside[k].append(j)
        # Rays are listed last.
        order = [min(beside, key=lambda j: (len(beside[j]), -j))]
        while follow := [k for k in beside[order[-1]] if k not in order]:
            order.append(follow[0])
        return tuple(order)

    @cached_property
    def cycles(self) -> tuple[tuple[int, ...], ...]:
        """For each facet of a polytope in R^3 its points, counter-clockwise seen from outside."""
        points = self.homogeneous[0]
        corners: list[tuple[int, ...]] = []
        for row, facet in zip(self.inequalities, self.facets, strict=True):
            cycle = self.cycle(facet)
            (*p, u), (*q, v), (*r, w) = (points[j] for j in cycle[:3])
            one = [u * y - v * x for x, y in zip(p, q, strict=True)]
            two = [u * y - w * x for x, y in zip(p, r, strict=True)]
            inward = triple_product(row[:3], one, two) > 0
            corners.append(cycle[::-1] if inward else cycle)
        return tuple(corners)

    @property
    def volume(self) -> Fraction:
        """The exact volume, if it is bounded: of pyramids over facets, again and again."""
        corners = self.homogeneous[0]
        if self.equalities:
            return Fraction(0)
        total = Fraction(0)
        for chosen in _simplices((1 << len(corners)) - 1, self.facets):
            simplex = [corners[j] for j in chosen]
            total += quotient(abs(determinant(simplex)), prod(row[-1] for row in simplex))
        return total / factorial(self.dimension)

    def contains(self, point: Sequence[Fraction | int]) -> bool:
        """Return whether a point lies in the polyhedron, its boundary included."""
        x = (*point, 1)
        return all(dot(row, x) == 0 for row in self.equalities) and all(
            dot(row, x) >= 0 for row in self.inequalities
        )

    def within(self, other: Polyhedron) -> bool:
        """Return whether this polyhedron is a part of the other."""
        rays, lines = self.homogeneous
        return all(
            all(dot(row, x) >= 0 for x in rays) and not any(dot(row, x) for x in lines)
            for row in other.inequalities
        ) and not any(dot(row, x) for row in other.equalities for x in (*rays, *lines))

    def along(
        self, start: Sequence[Fraction | int], direction: Sequence[Fraction | int]
    ) -> Interval | None:
        """Return all s with ``start + s direction`` inside; None when there is none."""
        return self.along_homogeneous((*start, 1), (*direction, 0))

    def along_homogeneous(
        self, start: Sequence[Fraction | int], direction: Sequence[Fraction | int]
    ) -> Interval | None:
        """Return all s with the homogeneous point ``start + s direction`` inside.

        The last entry of `start` is above 0, that of `direction` is 0.
        """
        rows = [(dot(row, direction), dot(row, start)) for row in self.inequalities]
        for row in self.equalities:
            slope, constant = dot(row, direction), dot(row, start)
            rows += [(slope, constant), (-slope, -constant)]
        return where_positive(rows) if rows else LINE

    def cut(
        self, origin: Sequence[Fraction], spans: Sequence[Sequence[Fraction]]
    ) -> Polyhedron | None:
        """Return all parameters p with ``origin + sum p_j spans_j`` inside; None when none.

        The rows of `spans` need not be independent.
        """
        if self._misses(origin, spans):
            return None
        zero, one = Fraction(0), Fraction(1)
        frame = [*((*span, zero) for span in spans), (*origin, one)]
        scale = lcm(*(x.denominator for column in frame for x in column))
        whole = [[int(x * scale) for x in column] for column in frame]
        pulled = [
            [reduced([dot(row, column) for column in whole]) for row in rows]
            for rows in (self.inequalities, self.equalities)
        ]
        return from_conditions(pulled[0], pulled[1], len(spans))

    def _misses(self, origin: Sequence[Fraction], spans: Sequence[Sequence[Fraction]]) -> bool:
        """Return whether a plane in space leaves all points strictly on one side (quick)."""
        if len(origin) != 3 or len(spans) != 2 or self.homogeneous[1]:
            return False
        normal = cross(*spans)
        plane = primitive((*normal, -Fraction(dot(normal, origin))))
        values = [(dot(plane, x), x[-1]) for x in self.homogeneous[0]]
        return any(
            all(side * at > 0 if finite else side * at >= 0 for at, finite in values)
            for side in (1, -1)
        )

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings, a condition has its constant last."""
        names = ("inequalities", "equalities", "points", "rays", "lines")
        return {name: [list(map(to_text, row)) for row in getattr(self, name)] for name in names}


def from_conditions(
    inequalities: Iterable[Sequence[int]], equalities: Iterable[Sequence[int]], dimension: int
) -> Polyhedron | None:
    """Return the polyhedron of conditions ``(a, b)``; None when they have no solution."""
    return _polyhedron(*both_ways(inequalities, equalities, dimension + 1, finite=True))


def from_generators(
    rays: Iterable[IntegerVector], lines: Iterable[IntegerVector], dimension: int
) -> Polyhedron | None:
    """Return the polyhedron that homogeneous generators span; None when none is a point.

    Args:
        rays, lines: may be redundant. The last entry of each is at least 0, and 0 for lines.
    """
    conditions, kept = both_ways(rays, lines, dimension + 1)
    return _polyhedron(kept, conditions)


def _polyhedron(kept: Generators, conditions: Generators) -> Polyhedron | None:
    finite = [ray for ray in kept[0] if ray[-1]]
    if not finite:
        return None
    # A facet without a point is the one at infinity, which says nothing about points.
    facets = tuple(row for row in conditions[0] if any(dot(row, ray) == 0 for ray in finite))
    endless = [ray for ray in kept[0] if not ray[-1]]
    return Polyhedron(facets, conditions[1], ((*finite, *endless), kept[1]))


def _simplices(mask: int, facets: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """Yield the simplices of a triangulation of a face: pyramids over facets off one corner."""
    apex = mask & -mask
    corner = apex.bit_length() - 1
    if mask == apex:
        yield (corner,)
    kept: list[int] = []
    parts = {mask & facet for facet in facets if mask & ~facet and mask & facet}
    for part in sorted(parts, key=int.bit_count, reverse=True):
        if not any(part & other == part for other in kept):
            kept.append(part)
            if not part & apex:
                for simplex in _simplices(part, facets):
                    yield (corner, *simplex)
