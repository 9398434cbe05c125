"""The wrenches that are resisted with one choice of contact states: a convex polyhedron.

With the states fixed the motions d form a closed cell, given by the springs and the directions of
slip. The wrench is linear in d, except that a sticking contact may pull either way up to its limit,
which is linear in d too. So the resisted wrenches are the convex hull of the images of the cell's
vertices and rays, each with both extreme forces of every sticking contact. (Any force in between is
a mixture of the two at the same d, and the maps are linear.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import lcm
from typing import NamedTuple

from arrangement.numbers.exact import IntegerVector, dot, primitive, reduced
from arrangement.numbers.linear.cones import Cone, both_ways
from arrangement.numbers.linear.polyhedron import Polyhedron, from_generators
from equilibrium.model.grasp import Grasp
from equilibrium.model.range import NO_RANGE, Range
from equilibrium.plane.contact_rows import (
    friction_edges,
    negated,
    normal_force_row,
    range_rows,
    slip_edge,
)

#: Above this number, redundant images are removed before the next sticking contact.
_MANY = 40


class _Integers(NamedTuple):
    """One contact in integers.

    Attributes:
        spring: the row of the normal force, times a factor that is the same for all contacts.
        slip: a multiple of the homogeneous row ``T . d``.
        balances: for each state the extreme wrenches that balance a normal force of 1 with its
            tangential force, times a factor that is the same for all contacts.
    """

    spring: IntegerVector
    slip: IntegerVector
    balances: dict[str, list[IntegerVector]]


class StateImages:
    """The contacts of one grasp in integers, ready for any choice of states."""

    def __init__(self, grasp: Grasp, within: Range = NO_RANGE) -> None:
        springs = [normal_force_row(contact) for contact in grasp]
        edges = []
        for contact in grasp:
            both = list(dict.fromkeys(friction_edges(contact)))
            slipping = {state: [slip_edge(contact, state)] for state in ("slip+", "slip-")}
            edges.append({"stick": both, "attached": both, **slipping})
        first = lcm(*(x.denominator for row in springs for x in row))
        second = lcm(*(x.denominator for e in edges for edge in e["stick"] for x in edge))
        self._scale = first * second
        self._contacts = [
            _Integers(
                tuple(int(x * first) for x in spring),
                primitive((*contact.tangential_wrench, Fraction(0))),
                {name: [tuple(int(-x * second) for x in v) for v in e[name]] for name in e},
            )
            for contact, spring, e in zip(grasp, springs, edges, strict=True)
        ]
        self._whole = Cone(4)
        self._whole.cut((0, 0, 0, 1), keep_positive=True)
        for row in range_rows(within, springs):
            self._whole.cut(primitive(row), keep_positive=True)
        self._path: list[tuple[str, Cone]] = []
        self._plane: IntegerVector | None = None

    def resisted_with(
        self, states: Sequence[str], plane: IntegerVector | None = None
    ) -> Polyhedron | None:
        """Return the wrenches resisted with these contact states; None when there are none.

        Args:
            states: besides those of the complete model, "attached": friction inside the cone,
                whatever the slip.
            plane: ``(a, b)``: leave out motions at which none of the wrenches has
                ``a . w + b = 0``. All wrenches of this plane remain, of others only some.
        """
        cell = self._cell(tuple(states))
        if plane is not None and cell.has_points:
            inequalities, equalities = self._reaching(states, plane)
            cell = cell.copy()
            for row in (*equalities, *inequalities):
                cell.cut(reduced(row), keep_positive=not equalities)
        if not cell.has_points:
            return None
        # Along a line of the cell no touching spring may change, so the wrench does not either.
        rays, _ = cell.generators
        images = {image for ray in rays for image in self._images(states, ray)}
        return from_generators(images, (), 3)

    def _cell(self, states: tuple[str, ...]) -> Cone:
        """Return the homogeneous motions with these states; those of the first contacts are kept.

        So states in lexicographic order share most of their work.
        """
        shared = 0
        while self._path[shared : shared + 1] and self._path[shared][0] == states[shared]:
            shared += 1
        del self._path[shared:]
        cone = self._path[-1][1] if self._path else self._whole
        for contact, state in zip(self._contacts[shared:], states[shared:], strict=True):
            cone = cone.copy()
            if cone.has_points:
                detached = state == "detached"
                spring = negated(contact.spring) if detached else contact.spring
                cone.cut(reduced(spring), keep_positive=True)
                if state == "stick":
                    cone.cut(contact.slip, keep_positive=False)
                elif state not in ("detached", "attached"):
                    slip = contact.slip if state == "slip+" else negated(contact.slip)
                    cone.cut(slip, keep_positive=True)
            self._path.append((state, cone))
        return cone

    def _reaching(
        self, states: Sequence[str], plane: IntegerVector
    ) -> tuple[list[IntegerVector], list[IntegerVector]]:
        """Return the conditions on a motion that its wrenches reach a plane.

        At one motion ``a . w + b`` lies between two bounds, each linear: every sticking contact
        pulls one way or the other.
        """
        if plane != self._plane:
            self._plane, self._bounds = plane, self._bounds_on(plane)
        constant = self._scale * plane[3]
        lowest, highest = [0, 0, 0, constant], [0, 0, 0, constant]
        for contact, bounds, state in zip(self._contacts, self._bounds, states, strict=True):
            if state != "detached":
                least, most = bounds[state]
                for j, x in enumerate(contact.spring):
                    lowest[j] += least * x
                    highest[j] += most * x
        if lowest == highest:
            return [], [tuple(lowest)] if any(lowest) else []
        return [negated(tuple(lowest)), tuple(highest)], []

    def _bounds_on(self, plane: IntegerVector) -> list[dict[str, tuple[int, int]]]:
        """Return the bounds of ``a . w`` for a normal force of 1, by contact and state."""
        found = []
        for contact in self._contacts:
            values = {s: [dot(plane[:3], b) for b in contact.balances[s]] for s in contact.balances}
            found.append({state: (min(v), max(v)) for state, v in values.items()})
        return found

    def _images(self, states: Sequence[str], motion: IntegerVector) -> Iterator[IntegerVector]:
        """Yield the homogeneous wrenches that balance the extreme forces at a motion."""
        wrenches: list[IntegerVector] = [(0, 0, 0)]
        for contact, state in zip(self._contacts, states, strict=True):
            force = 0 if state == "detached" else dot(contact.spring, motion)
            if force == 0:
                continue
            wrenches = [
                (w[0] + force * b[0], w[1] + force * b[1], w[2] + force * b[2])
                for w in wrenches
                for b in contact.balances[state]
            ]
            if len(wrenches) > _MANY:
                wrenches = _extreme(wrenches)
        homogeneous = ((*wrench, self._scale * motion[3]) for wrench in wrenches)
        yield from (reduced(wrench) for wrench in homogeneous if any(wrench))


def _extreme(points: list[IntegerVector]) -> list[IntegerVector]:
    """Return the vertices of the convex hull of integer points."""
    _, (rays, _) = both_ways([(*point, 1) for point in points], (), 4)
    return [ray[:3] for ray in rays]
