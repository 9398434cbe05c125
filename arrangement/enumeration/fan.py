"""The faces of central planes inside a cone: a fan, cut by one plane at a time.

Planes outside the cone cost nothing: where a few planes bound a cone and many cut it, this lists
the faces inside alone. Each closed face is known by its extreme rays, modulo the lines that all
faces have in common. A plane that has rays of a face on both sides cuts it in three, and its rays
on the plane are those of the face there and one on each edge of the face that the plane cuts: an
edge (a, b) is one of a face exactly when a and b are rays of it, since faces are convex.

Cost: one pass over the faces found so far for each plane, in arrays of truth values, faces by rays.
Numbers are int64 wherever a bound of their size allows, else Python integers.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arrangement.numbers.coefficients import (
    Integers,
    as_integers,
    for_products,
    largest_entry,
)
from arrangement.numbers.linear.rank import unit_vectors
from arrangement.numbers.packing import Bits

from .sequence import Signs, primitive_rows


@dataclass(frozen=True, slots=True)
class Fan:
    """The faces of central planes inside a closed cone of R^n.

    >>> quadrant = Fan.space(2).cut((1, 0), (0, 1)).cut((0, 1), (0, 1))
    >>> quadrant.cut((1, -1)).signs.tolist()
    [[0, 0, 0], [1, 0, 1], [0, 1, -1], [1, 1, 0], [1, 1, 1], [1, 1, -1]]

    Attributes:
        rays: (R, n); one point of each ray, modulo the lines.
        lines: (L, n); a basis of the lines that every closed face contains.
        members: (F, R); whether a ray is in a closed face.
        signs: (F, k); the side of each face of each plane that was cut, in their order.
        dimensions: (F); lines included.
    """

    rays: Integers
    lines: Integers
    members: Bits
    signs: Signs
    dimensions: NDArray[np.int8]

    @classmethod
    def space(cls, n: int) -> Fan:
        """Return R^n, which no plane has cut yet: one face."""
        return cls(
            np.zeros((0, n), np.int64),
            np.array(unit_vectors(n), np.int64).reshape(n, n),
            np.zeros((1, 0), bool),
            np.zeros((1, 0), np.int8),
            np.array([n], np.int8),
        )

    def __len__(self) -> int:
        return len(self.members)

    def cut(self, normal: Sequence[int], sides: Collection[int] = (-1, 0, 1)) -> Fan:
        """Return the faces into which a plane cuts these, on the chosen sides of it.

        Args:
            normal: n integers; all zero for a plane that contains every face.
            sides: of -1, 0, 1: (0, 1) leaves a half space, (0,) the plane itself.
        """
        form = as_integers([normal])[0]
        factor = len(form) * largest_entry(form)
        on_lines = for_products(self.lines, factor) @ form
        if on_lines.any():
            return self._cut_lines(form, on_lines, sides)
        return self._cut_rays(for_products(self.rays, factor) @ form, sides)

    def boundary_and(self, face: int) -> Fan:
        """Return one face with all faces of its boundary: again a fan."""
        mine = self.members[face]
        inside = ~self.members[:, ~mine].any(axis=1)
        return Fan(
            self.rays[mine],
            self.lines,
            self.members[np.ix_(inside, mine)],
            self.signs[inside],
            self.dimensions[inside],
        )

    def at(self, chosen: NDArray[np.intp]) -> Fan:
        """Return some of the faces in an order, no longer all of a cone perhaps."""
        return Fan(
            self.rays, self.lines, self.members[chosen], self.signs[chosen], self.dimensions[chosen]
        )

    @property
    def points(self) -> Integers:
        """(F, n); an integer point in each face, the sum of its rays, without common divisor."""
        rays = for_products(self.rays, len(self.rays))
        return primitive_rows(self.members.astype(rays.dtype) @ rays)

    def _cut_lines(self, form: Integers, on_lines: Integers, sides: Collection[int]) -> Fan:
        """Move everything into the plane along one line; its two halves become rays."""
        pivot = int(np.flatnonzero(on_lines)[0])
        line, top = self.lines[pivot], on_lines[pivot]
        if top < 0:
            line, top = -line, -top
        others = np.delete(self.lines, pivot, axis=0)
        rays, lines = (_moved(part, form, line, top) for part in (self.rays, others))
        halves = [(0, [False, False]), (1, [True, False]), (-1, [False, True])]
        kept = [(side, half) for side, half in halves if side in sides]
        count = len(self)
        return Fan(
            np.concatenate([rays, [line, -line]]),
            lines,
            np.concatenate([np.column_stack([self.members, [h] * count]) for _, h in kept]),
            np.concatenate([_with(self.signs, side) for side, _ in kept]),
            np.concatenate([self.dimensions - (side == 0) for side, _ in kept]).astype(np.int8),
        )._without_unused_rays()

    def _cut_rays(self, values: Integers, sides: Collection[int]) -> Fan:
        """Sort the faces by the sides of their rays, and cut those with rays on both sides."""
        above, below = values > 0, values < 0
        high = self.members[:, above].any(axis=1)
        low = self.members[:, below].any(axis=1)
        both = high & low
        side = np.sign(high.astype(np.int8) - low.astype(np.int8))
        whole = ~both & np.isin(side, list(sides))
        edges = self.members[both & (self.members.sum(axis=1) == 2)]
        first, second = np.nonzero(edges)[1].reshape(-1, 2).T
        cut, dimensions = self.members[both], self.dimensions[both]
        on_edges = cut[:, first] & cut[:, second]
        old = {0: ~(above | below), 1: ~below, -1: ~above}
        kept = [s for s in (0, 1, -1) if s in sides]
        none = np.zeros((int(whole.sum()), len(edges)), bool)
        return Fan(
            np.concatenate([self.rays, _crossings(self.rays, values, first, second)]),
            self.lines,
            np.concatenate(
                [
                    np.column_stack([self.members[whole], none]),
                    *[np.column_stack([cut & old[s], on_edges]) for s in kept],
                ]
            ),
            np.concatenate(
                [
                    np.column_stack([self.signs[whole], side[whole]]),
                    *[_with(self.signs[both], s) for s in kept],
                ]
            ),
            np.concatenate([self.dimensions[whole], *[dimensions - np.int8(s == 0) for s in kept]]),
        )._without_unused_rays()

    def _without_unused_rays(self) -> Fan:
        used = self.members.any(axis=0)
        if used.all():
            return self
        return Fan(self.rays[used], self.lines, self.members[:, used], self.signs, self.dimensions)


def _with(signs: Signs, side: int) -> Signs:
    return np.column_stack([signs, np.full(len(signs), side, np.int8)])


def _moved(vectors: Integers, form: Integers, line: Integers, top: int) -> Integers:
    """Return vectors moved along a line into the plane, scaled by positive numbers."""
    size = len(form) * largest_entry(form) * largest_entry(line)
    vectors = for_products(vectors, 2 * size)
    return primitive_rows(top * vectors - (vectors @ form)[:, None] * line)


def _crossings(
    rays: Integers, values: Integers, first: NDArray[np.intp], second: NDArray[np.intp]
) -> Integers:
    """Return the point of the plane on each edge between two rays on different sides of it."""
    rays = for_products(rays, 2 * largest_entry(values))
    left, right = np.abs(values[second])[:, None], np.abs(values[first])[:, None]
    return primitive_rows(left * rays[first] + right * rays[second])
