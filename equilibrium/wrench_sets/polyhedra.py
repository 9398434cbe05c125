"""The whole set of wrenches that a grasp resists, as convex polyhedra with exact half-spaces.

It is the union, over all contact states, of what `StateImages.resisted_with` returns.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import compress
from math import lcm
from operator import add
from typing import Any, NamedTuple

import numpy as np

from arrangement import Arrangement
from arrangement.console.number_form import ReprMixin
from arrangement.console.progress import watched
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, reduced
from arrangement.numbers.float_filter import SMALLEST, Booleans, error_bound, scale_rows
from arrangement.numbers.linear.cones import Cone
from arrangement.numbers.linear.intervals import Interval, intersection, union
from arrangement.numbers.linear.polyhedron import Polyhedron, from_generators
from arrangement.numbers.linear.rank import difference
from arrangement.numbers.packing import pack
from equilibrium.core.contact_law import LinearQuestion, fraction
from equilibrium.core.contact_rows import negated, normal_force_row
from equilibrium.decide.solver import Solver
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from equilibrium.plane.states.contact_states import States
from equilibrium.wrench_sets.separation import surely_outside

#: Above this number, images that are not vertices are left out.
_MANY = 40
#: The states with a normal force, and the number of each state in arrays.
_TOUCHING = ("stick", "slip+", "slip-")
_ATTACHED = ("attached", *_TOUCHING)
_CODES = {state: k for k, state in enumerate(("detached", *_TOUCHING))}


class _Integers(NamedTuple):
    """One contact in integers.

    Attributes:
        spring: the row of the normal force, times a factor that is the same for all contacts.
        cuts: for each state the rows that are at least 0 at its motions; or 0, if that is said.
        balances: for each state the extreme wrenches that balance a normal force of 1 with its
            tangential force, times a factor that is the same for all contacts.
    """

    spring: IntegerVector
    cuts: dict[str, list[tuple[IntegerVector, bool]]]
    balances: dict[str, list[IntegerVector]]


class StateImages:
    """The contacts of one grasp in integers, ready for any choice of states.

    With the states fixed the motions d form a closed cell, given by the springs and the directions
    of slip. The wrench is linear in d, except that a sticking contact may pull either way up to its
    limit, which is linear in d too. So the resisted wrenches are the convex hull of the images of
    the cell's vertices and rays, each with both extreme forces of every sticking contact. (Any
    force in between is a mixture of the two at the same d, and the maps are linear.)
    """

    def __init__(self, grasp: Grasp, max_displacement: Fraction | None = None) -> None:
        question = LinearQuestion(
            ContactRows.of_grasp(grasp), (Fraction(0),) * 3, max_displacement=max_displacement
        )
        springs = [normal_force_row(contact) for contact in grasp]
        edges = [
            {
                x: dict.fromkeys(tuple(map(fraction, w)) for w in question.unit_wrenches(i, x))
                for x in _ATTACHED
            }
            for i in range(len(grasp))
        ]
        first = lcm(*(x.denominator for row in springs for x in row))
        rows = [edge for e in edges for edge in e["attached"]]
        second = lcm(*(x.denominator for row in (*rows, grasp.adhesion_wrench) for x in row))
        self._scale = first * second
        #: What balances the adhesion, for a motion with 1 last.
        self._constant = tuple(int(-x * self._scale) for x in grasp.adhesion_wrench)
        self._contacts = [
            _Integers(
                tuple(int(x * first) for x in spring),
                {x: question.motion_rows(i, x) for x in ("detached", *_ATTACHED)},
                {name: [tuple(int(-x * second) for x in v) for v in e[name]] for name in e},
            )
            for i, (spring, e) in enumerate(zip(springs, edges, strict=True))
        ]
        self._whole = Cone(4)
        self._whole.cut((0, 0, 0, 1), keep_positive=True)
        self._grasp = grasp
        self._path: list[tuple[str, Cone]] = []
        self._plane: IntegerVector | None = None

    def resisted_with(
        self, states: Sequence[str], plane: IntegerVector | None = None
    ) -> Polyhedron | None:
        """Return the wrenches resisted with these contact states; None when there are none.

        Args:
            states: besides those of the full model, "attached": friction inside the cone,
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
            for row, is_zero in contact.cuts[state] if cone.has_points else ():
                cone.cut(reduced(row), keep_positive=not is_zero)
            self._path.append((state, cone))
        return cone

    def _reaching(
        self, states: Sequence[str], plane: IntegerVector
    ) -> tuple[list[IntegerVector], list[IntegerVector]]:
        """Return the conditions on a motion that its wrenches reach a plane.

        At one motion ``a . w + b`` lies between two bounds, each linear: every sticking contact
        pulls one way or the other.
        """
        self._bounds_on(plane)
        constant = self._constant_on(plane)
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
        if plane != self._plane:
            self._plane, self._bounds = plane, []
            for contact in self._contacts:
                balances = contact.balances.items()
                values = {state: [dot(plane[:3], b) for b in vs] for state, vs in balances}
                self._bounds.append({state: (min(v), max(v)) for state, v in values.items()})
        return self._bounds

    def _constant_on(self, plane: IntegerVector) -> int:
        """Return ``a . w + b`` for the wrench that balances the adhesion alone."""
        return int(self._scale * plane[3] + dot(plane[:3], self._constant))

    def may_reach(self, listed: Sequence[States], plane: IntegerVector) -> Booleans:
        """Return for each choice of contact states whether it may resist a wrench of a plane.

        Where ``a . w + b`` has one sign at all vertices and rays of the planes of motions that a
        cell may have, in floats by more than their error, the cell does not reach the plane.
        """
        planes, bounds = self._grasp.motion_arrangement(), self._bounds_on(plane)
        if planes.rank < 3:
            return np.ones(len(listed), np.bool_)
        at_infinity = Arrangement(planes.normals).faces(1).points[:, :-1].tolist()
        motions = [*planes.faces(0).points.tolist(), *((*ray, 0) for ray in at_infinity)]
        springs = [contact.spring for contact in self._contacts]
        slips = [contact.cuts["slip+"][-1][0] for contact in self._contacts]
        rows = np.array([*springs, (0, 0, 0, 1), *slips], object)
        values = np.array(motions, object) @ rows.T
        forces, moves = (
            scale_rows(part.tolist())[0] for part in np.hsplit(values, [len(bounds) + 1])
        )
        # For each contact and state what it adds at least, and less what it adds at most.
        both = [((0, 0), *(b[state] for state in _TOUCHING)) for b in bounds]
        ends = [sign * pair[k] for k, sign in ((0, 1), (1, -1)) for of in both for pair in of]
        constant = self._constant_on(plane)
        factors = scale_rows([(*ends, constant, -constant)])[0][0]
        constants, factors = factors[-2:], factors[:-2].reshape(2, len(bounds), 4)
        codes = np.array([[_CODES[state] for state in states] for states in listed], np.intp)
        stick = codes == _CODES["stick"]
        # What a state excludes; what a motion has of it.
        excluded = (codes == 0, codes > 0, stick | (codes == 2), stick | (codes == 3))
        has = (forces[:, :-1] > 0, forces[:, :-1] < 0, moves < 0, moves > 0)
        excluded_bits, has_bits = pack(np.hstack(excluded)), pack(np.hstack(has))
        error = error_bound(2 + 1 + len(bounds) + 1)
        inside = np.zeros(len(listed), np.bool_)
        for start in watched(range(0, len(listed), _MANY), "parts of the contact states"):
            part = excluded_bits[start : start + _MANY, None]
            at, motion = np.nonzero(~(part & has_bits).any(axis=2))
            at += start
            terms = factors[:, range(len(bounds)), codes[at]] * forces[motion, :-1]
            last = constants[:, None] * forces[motion, -1]
            sizes = np.abs(terms).sum(axis=2) + np.abs(last)
            low, high = terms.sum(axis=2) + last <= error * sizes + SMALLEST
            inside[np.intersect1d(at[low], at[high])] = True
        return inside

    def _images(self, states: Sequence[str], motion: IntegerVector) -> Iterator[IntegerVector]:
        """Yield the homogeneous wrenches that balance the extreme forces at a motion."""
        balancing = []
        for contact, state in zip(self._contacts, states, strict=True):
            if state != "detached" and (force := dot(contact.spring, motion)):
                ends = contact.balances[state]
                balancing.append([(force * b[0], force * b[1], force * b[2]) for b in ends])
        at_rest = tuple(x * motion[3] for x in self._constant)
        sums = (map(add, wrench, at_rest) for wrench in _extreme_sums(balancing))
        homogeneous = ((*wrench, self._scale * motion[3]) for wrench in sums)
        yield from (reduced(wrench) for wrench in homogeneous if any(wrench))


def _extreme_sums(ends: Sequence[Sequence[IntegerVector]]) -> Sequence[Sequence[int]]:
    """Return the sums of one end of each segment or point; of many only the vertices of the hull.

    A vertex is the farthest sum in the directions of a cell of the planes across the segments.
    """
    segments = [pair for pair in ends if len(pair) > 1]
    if 1 << len(segments) > _MANY:
        steps = [difference(second, first) for first, second in segments]
        forward = (Arrangement(steps).faces(3).signs > 0).astype(object)
        starts = np.array([first for first, *_ in ends], object).sum(axis=0)
        sums: list[list[int]] = (starts + forward @ np.array(steps, object)).tolist()
        return sums
    points: list[IntegerVector] = [(0, 0, 0)]
    for choice in ends:
        points = [(w[0] + b[0], w[1] + b[1], w[2] + b[2]) for w in points for b in choice]
    return points


@dataclass(frozen=True, repr=False)
class Piece(ReprMixin):
    """All wrenches that are resisted with one choice of contact states (a convex polyhedron)."""

    states: States
    polyhedron: Polyhedron

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {"states": list(self.states), **self.polyhedron.to_dict()}


def resisted_pieces(solver: Solver) -> tuple[Piece, ...]:
    """Return all wrenches that a planar grasp resists, as polyhedra none of which lies in another.

    Complexity: two conversions between conditions and generators in four homogeneous coordinates
    for each choice of contact states: O(m^2) of them without preload, O(m^3) with.
    """
    solver.grasp.require_plane()
    pieces = (Piece(states, shape) for states, shape in images_of(solver) if shape is not None)
    return maximal_pieces(list(pieces))


def images_of(
    solver: Solver, plane: IntegerVector | None = None
) -> Iterator[tuple[States, Polyhedron | None]]:
    """Yield all contact states with `StateImages.resisted_with`."""
    images, listed = StateImages(solver.grasp, solver.max_displacement), solver.choices.states
    contacts = len(solver.grasp)
    budget.check_cost(
        f"all resisted wrenches of {contacts} contacts, {len(listed):,} choices of states",
        "decide one load after the other (solve)",
        long_steps=300 * contacts * len(listed),
    )
    if plane is not None:
        listed = tuple(compress(listed, images.may_reach(listed, plane)))
    shapes = {
        states: images.resisted_with(states, plane)
        for states in watched(sorted(listed), "contact states")
    }
    yield from ((states, shapes.get(states)) for states in solver.choices.states)


def states_with(pieces: Sequence[Piece], point: RationalVector) -> tuple[States, ...]:
    """Return the contact states of all pieces that contain a point."""
    return tuple(piece.states for piece in pieces if piece.polyhedron.contains(point))


def magnitudes_in(
    pieces: Sequence[Piece], start: RationalVector, direction: RationalVector
) -> tuple[Interval, ...]:
    """Return the t >= 0 with ``start + t direction`` in a piece, as disjoint closed intervals."""
    parts = (piece.polyhedron.along(start, direction) for piece in pieces)
    kept = (intersection(part, (Fraction(0), None)) for part in parts if part is not None)
    return union(part for part in kept if part is not None)


def maximal_pieces(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """Return the pieces that lie in no other one, in their order; of equal ones the first."""
    shapes = [piece.polyhedron for piece in pieces]
    outside = surely_outside(shapes)
    kept: list[int] = []
    largest_first = sorted(range(len(pieces)), key=lambda i: -shapes[i].dimension)
    for i in watched(largest_first, "pieces"):
        if any(not outside[j, i] and shapes[i].within(shapes[j]) for j in kept):
            continue
        kept = [j for j in kept if outside[i, j] or not shapes[j].within(shapes[i])] + [i]
    return tuple(pieces[i] for i in sorted(kept))
