"""Polyhedral cones: from conditions to generators and back, exactly, on integer vectors.

The double description method, one condition at a time, with lineality. Two extreme rays make a new
one only when adjacent: no third ray is tight in all conditions in which both are.
[Motzkin1953; FukudaProdon1996]
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from operator import mul
from typing import TypeAlias

from arrangement.numbers.exact import IntegerVector, reduced

from .rank import unit_vectors

#: (extreme rays, a basis of the lines)
Generators: TypeAlias = tuple[tuple[IntegerVector, ...], tuple[IntegerVector, ...]]


def generators(
    inequalities: Iterable[Sequence[int]],
    equalities: Iterable[Sequence[int]],
    dimension: int,
    *,
    finite: bool = False,
) -> Generators:
    """Return generators of ``{x : a . x >= 0, e . x = 0}`` in R^dimension.

    The rays are extreme modulo the lines, one for each, primitive. By polarity the same call turns
    generators (rays, lines) into the irredundant conditions (inequalities, equalities).

    Args:
        finite: add the condition that the last entry is at least 0, and stop, with no generators,
            as soon as it is 0 everywhere (the cone of a polyhedron without a point).

    >>> generators([(1, 0), (1, 1), (1, 2)], [], 2)
    (((0, 1), (2, -1)), ())
    """
    rows = dict.fromkeys(map(reduced, inequalities))
    last = [unit_vectors(dimension)[-1]] if finite else []
    return _cut_out([*last, *rows], equalities, dimension, finite).generators


def both_ways(
    inequalities: Iterable[Sequence[int]],
    equalities: Iterable[Sequence[int]],
    dimension: int,
    *,
    finite: bool = False,
) -> tuple[Generators, Generators]:
    """Return the generators of a cone, see `generators`, and its irredundant conditions.

    By polarity the same call turns generators, redundant or not, into the conditions and the
    extreme rays with a basis of the lines.

    >>> both_ways([(1, 0), (1, 1), (1, 2)], [], 2)
    ((((0, 1), (2, -1)), ()), (((1, 0), (1, 2)), ()))
    """
    flat, rows = list(equalities), list(dict.fromkeys(map(reduced, inequalities)))
    if finite:
        rows.insert(0, unit_vectors(dimension)[-1])
    cone = _cut_out(rows, flat, dimension, finite)
    pair = cone.generators
    # Which rays are tight in each condition.
    masks = [mask for _, mask in cone.rays]
    tight = [sum((m >> i & 1) << k for k, m in enumerate(masks)) for i in range(len(rows))]
    if flat or cone.lines or (1 << len(masks)) - 1 in tight:
        return pair, generators(*pair, dimension)
    # The cone is pointed and has interior points: what no other condition is tight with, and more
    # rays, is a facet.
    largest = {
        row
        for row, own in zip(rows, tight, strict=True)
        if not any(own & other == own != other for other in tight)
    }
    return pair, (tuple(sorted(largest)), ())


def _cut_out(
    rows: Iterable[Sequence[int]], equalities: Iterable[Sequence[int]], dimension: int, finite: bool
) -> Cone:
    cone = Cone(dimension)
    for row in equalities:
        cone.cut(row, keep_positive=False)
    for k, row in enumerate(rows):
        if finite and k and not cone.has_points:
            return Cone(0)
        cone.cut(row, keep_positive=True)
    return cone


class Cone:
    """A cone under construction; the mask of a ray says in which conditions it is tight."""

    def __init__(self, dimension: int) -> None:
        self.lines: list[IntegerVector] = unit_vectors(dimension)
        self.rays: list[tuple[IntegerVector, int]] = []
        self.conditions = 0

    def copy(self) -> Cone:
        """Return the same cone, to be cut in another way."""
        twin = Cone(0)
        twin.lines, twin.rays, twin.conditions = self.lines, self.rays, self.conditions
        return twin

    @property
    def has_points(self) -> bool:
        """Whether the last entry of a ray is not 0."""
        return any(ray[-1] for ray, _ in self.rays)

    @property
    def generators(self) -> Generators:
        """The extreme rays in order, and a basis of the lines."""
        return tuple(sorted(ray for ray, _ in self.rays)), tuple(self.lines)

    def cut(self, row: Sequence[int], *, keep_positive: bool) -> None:
        """Intersect the cone with ``row . x >= 0``, or with ``row . x = 0``."""
        bit = 1 << self.conditions
        self.conditions += 1
        leaving = next((line for line in self.lines if _value(row, line)), None)
        if leaving is not None:
            self._cut_lines(row, leaving, bit, keep_positive)
        else:
            self._cut_rays(row, bit, keep_positive)

    def _cut_lines(
        self, row: Sequence[int], leaving: IntegerVector, bit: int, keep_positive: bool
    ) -> None:
        """Move everything into the plane along one line; its positive half becomes a ray."""
        if _value(row, leaving) < 0:
            leaving = tuple(-x for x in leaving)
        top = _value(row, leaving)

        def moved(vector: IntegerVector) -> IntegerVector:
            value = _value(row, vector)
            return reduced([top * a - value * b for a, b in zip(vector, leaving, strict=True)])

        others = [line for line in self.lines if tuple(-x for x in line) != leaving]
        self.lines = [moved(line) for line in others if line != leaving]
        self.rays = [(moved(ray), mask | bit) for ray, mask in self.rays]
        if keep_positive:
            self.rays.append((leaving, bit - 1))

    def _cut_rays(self, row: Sequence[int], bit: int, keep_positive: bool) -> None:
        """Keep the rays on the right side, and join adjacent rays of the two sides."""
        values = [sum(map(mul, row, ray)) for ray, _ in self.rays]
        if keep_positive and min(values, default=0) >= 0:
            if not all(values):
                pairs = zip(self.rays, values, strict=True)
                self.rays = [(ray, mask if at else mask | bit) for (ray, mask), at in pairs]
            return
        valued = [(value, *entry) for value, entry in zip(values, self.rays, strict=True)]
        below = [entry for entry in valued if entry[0] < 0]
        above = [entry for entry in valued if entry[0] > 0]
        kept = [(ray, mask | bit) for value, ray, mask in valued if value == 0]
        masks = [mask for _, mask in self.rays]
        # Two adjacent rays span a face of dimension 2, cut out by at least this many conditions.
        fewest = len(row) - len(self.lines) - 2
        for high, ray, mask in above:
            for low, other, other_mask in below:
                common = mask & other_mask
                if common.bit_count() >= fewest and _only_two(masks, common):
                    joined = [high * b - low * a for a, b in zip(ray, other, strict=True)]
                    kept.append((reduced(joined), common | bit))
        if keep_positive:
            kept += [(ray, mask) for _, ray, mask in above]
        self.rays = kept


def _value(row: Sequence[int], vector: IntegerVector) -> int:
    return sum(map(mul, row, vector))


def _only_two(masks: Iterable[int], common: int) -> bool:
    """Return whether only two rays are tight in all common conditions: they are adjacent."""
    count = 0
    for mask in masks:
        if mask & common == common:
            count += 1
            if count > 2:
                return False
    return True
