"""Units of length, force and motion in which the largest numbers of a question are one.

The search sees the question in these units, so it takes the same steps whatever units the numbers
of the grasp are in; equilibria and proofs are put back into those exactly. Where a largest number
is long, the unit is a power of two near it, which keeps the numbers of proofs short.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    primitive,
    to_text,
    without_denominators,
)
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import TURNS, ContactRow, ContactRows
from equilibrium.model.solution import Leaf, Solution

from .motion_regions import HALF_SPACE, ORTHANTS
from .region_states import Node

#: Bits of a number that is a unit itself.
_MAX_UNIT_BITS = 48


def unit_of(numbers: Iterable[Fraction]) -> Fraction:
    """Return the largest number, or if it is long the power of two up to it; 1 if all are 0."""
    largest = max(map(abs, numbers), default=Fraction(0))
    if not largest:
        return Fraction(1)
    sizes = largest.numerator.bit_length(), largest.denominator.bit_length()
    if max(sizes) <= _MAX_UNIT_BITS:
        return largest
    unit = Fraction(2) ** (sizes[0] - sizes[1])
    return unit / 2 if largest < unit else unit


@dataclass(frozen=True)
class SearchUnits:
    """The units of lengths, of forces, and (`step`) of motions along x and y."""

    length: Fraction
    force: Fraction
    step: Fraction

    @classmethod
    def of(cls, grasp: Grasp, wrench: RationalVector) -> SearchUnits:
        """Return the units of a question; where there is preload, those of the grasp alone."""
        length = unit_of(x for c in grasp for x in c.point)
        loads = [c.preload for c in grasp]
        x, y, torque = wrench
        force = unit_of(loads if any(loads) else (x, y, torque / length))
        return cls(length, force, force / unit_of(c.stiffness for c in grasp))

    def rows(self, grasp: Grasp) -> ContactRows:
        """Return the contacts of a grasp in these units, without adhesion: the load has that."""

        def scaled(wrench: RationalVector) -> RationalVector:
            x, y, torque = wrench
            return x, y, torque / self.length

        contacts = tuple(
            ContactRow(
                scaled(c.normal_wrench),
                tuple(map(scaled, c.tangential_wrenches)),
                c.friction,
                c.stiffness * self.step / self.force,
                c.preload / self.force,
                Fraction(0),
            )
            for c in grasp
        )
        points = tuple(tuple(x / self.length for x in c.point) for c in grasp)
        return ContactRows(contacts, points, TURNS[2], 1)

    def wrench(self, wrench: RationalVector) -> RationalVector:
        """Return a wrench in these units."""
        x, y, torque = wrench
        return x / self.force, y / self.force, torque / (self.force * self.length)

    def displacement(self, bound: Fraction | None) -> Fraction | None:
        """Return a largest displacement in these units."""
        return None if bound is None else bound / self.step

    def solution_back(self, solution: Solution) -> Solution:
        """Return an equilibrium in the units of the question."""
        (x, y, r), unit = solution.motion, self.step
        forces = ((self.force * normal, self.force * rub) for normal, rub in solution.forces)
        return Solution((unit * x, unit * y, unit / self.length * r), tuple(forces))

    def tree_back(self, node: Node, region: Sequence[IntegerVector] = HALF_SPACE) -> Node:
        """Return a tree in the units of the question.

        Args:
            region: generators of the node, in these units.
        """
        if isinstance(node, Leaf):
            return self._leaf(node)
        if "orthants" in node:
            pairs = zip(node["orthants"], ORTHANTS, strict=True)
            return {"orthants": [self.tree_back(child, corner) for child, corner in pairs]}
        if "edge" in node:
            (j, k), (p, q) = node["edge"], map(int, node.get("at", (1, 1)))
            middle = primitive([p * x + q * y for x, y in zip(region[j], region[k], strict=True)])
            # The generators of the document are primitive, so they may be multiples of these.
            p, q = primitive([p * self._size(region[j]), q * self._size(region[k])])
            children = [
                self.tree_back(child, [*region[:n], middle, *region[n + 1 :]])
                for child, n in zip(node["children"], (j, k), strict=True)
            ]
            at = {} if p == q == 1 else {"at": [to_text(p), to_text(q)]}
            return {"edge": [j, k], **at, "children": children}
        kind = "slip" if "slip" in node else "attachment"
        parts = {name: self.tree_back(child, region) for name, child in node[kind].items()}
        return {"contact": node["contact"], kind: parts}

    @cached_property
    def _whole(self) -> tuple[int, ...]:
        """Units of what leaves and regions have, times one number that makes them integers.

        They are those of a leaf's turn, its slips and its works; of a region's step and its turn.
        """
        slip = self.force / self.step
        units = 1 / self.length, slip, Fraction(1), self.step
        return tuple(without_denominators((*units, self.step / self.length)))

    def _size(self, generator: IntegerVector) -> int:
        """Return which multiple of a primitive vector a generator is in units of `_whole`."""
        *_, unit, step, turn = self._whole
        return math.gcd(*(x * u for x, u in zip(generator, (unit, step, step, turn), strict=True)))

    def _leaf(self, leaf: Leaf) -> Leaf:
        """Return a leaf; its works are those in these units times a positive number."""
        turn, slip, one, *_ = self._whole
        units = [one, one, turn]
        units += [unit for _ in leaf.multipliers for unit in (one, slip)]
        units += [slip for row in leaf.displacements.values() for _ in row]
        pairs = zip(leaf.numbers, units, strict=True)
        return leaf.with_numbers(primitive([x * unit for x, unit in pairs]))
