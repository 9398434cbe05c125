"""Polyhedral cones: from conditions to generators and back, exactly, on integer vectors.

The double description method, one condition at a time, with lineality. Two extreme rays make a new
one only when adjacent: no third ray is tight in all conditions in which both are.
[Motzkin1953; FukudaProdon1996]
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeAlias

from arrangement.exact import IntegerVector, dot
from arrangement.linear import reduced, unit_vectors

#: (extreme rays, a basis of the lines)
Generators: TypeAlias = tuple[tuple[IntegerVector, ...], tuple[IntegerVector, ...]]


def generators(
    inequalities: Iterable[Sequence[int]], equalities: Iterable[Sequence[int]], dimension: int
) -> Generators:
    """Return generators of ``{x : a . x >= 0, e . x = 0}`` in R^dimension.

    The rays are extreme modulo the lines, one for each, primitive. By polarity the same call turns
    generators (rays, lines) into the irredundant conditions (inequalities, equalities).

    >>> generators([(1, 0), (1, 1), (1, 2)], [], 2)
    (((0, 1), (2, -1)), ())
    """
    cone = _Cone(dimension)
    for row in equalities:
        cone.cut(row, keep_positive=False)
    for row in dict.fromkeys(reduced(row) for row in inequalities):
        cone.cut(row, keep_positive=True)
    return tuple(sorted(ray for ray, _ in cone.rays)), tuple(cone.lines)


class _Cone:
    """A cone under construction; the mask of a ray says in which conditions it is tight."""

    def __init__(self, dimension: int) -> None:
        self.lines: list[IntegerVector] = unit_vectors(dimension)
        self.rays: list[tuple[IntegerVector, int]] = []
        self.conditions = 0

    def cut(self, row: Sequence[int], *, keep_positive: bool) -> None:
        """Keep the part with ``row . x >= 0``, or only ``= 0``."""
        bit = 1 << self.conditions
        self.conditions += 1
        leaving = next((line for line in self.lines if dot(row, line)), None)
        if leaving is not None:
            self._cut_lines(row, leaving, bit, keep_positive)
        else:
            self._cut_rays(row, bit, keep_positive)

    def _cut_lines(
        self, row: Sequence[int], leaving: IntegerVector, bit: int, keep_positive: bool
    ) -> None:
        """Move everything into the plane along one line; its positive half becomes a ray."""
        if dot(row, leaving) < 0:
            leaving = tuple(-x for x in leaving)
        top = dot(row, leaving)

        def moved(vector: IntegerVector) -> IntegerVector:
            value = dot(row, vector)
            return reduced([top * a - value * b for a, b in zip(vector, leaving, strict=True)])

        others = [line for line in self.lines if tuple(-x for x in line) != leaving]
        self.lines = [moved(line) for line in others if line != leaving]
        self.rays = [(moved(ray), mask | bit) for ray, mask in self.rays]
        if keep_positive:
            self.rays.append((leaving, bit - 1))

    def _cut_rays(self, row: Sequence[int], bit: int, keep_positive: bool) -> None:
        """Keep the rays on the right side, and join adjacent rays of the two sides."""
        valued = [(dot(row, ray), ray, mask) for ray, mask in self.rays]
        below = [entry for entry in valued if entry[0] < 0]
        above = [entry for entry in valued if entry[0] > 0]
        kept = [(ray, mask | bit) for value, ray, mask in valued if value == 0]
        for high, ray, mask in above:
            for low, other, other_mask in below:
                if self._adjacent(mask & other_mask):
                    joined = [high * b - low * a for a, b in zip(ray, other, strict=True)]
                    kept.append((reduced(joined), (mask & other_mask) | bit))
        if keep_positive:
            kept += [(ray, mask) for _, ray, mask in above]
        self.rays = kept

    def _adjacent(self, common: int) -> bool:
        """Return whether only the two rays themselves are tight in all common conditions."""
        return sum(mask & common == common for _, mask in self.rays) == 2
