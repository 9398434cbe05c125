"""The whole set of wrenches that a grasp resists, as convex polyhedra with exact half-spaces.

For one choice of contact states the motions d form a closed cell, given by the springs and the
directions of slip. The wrench is linear in d, except that a sticking contact may pull either way up
to its limit, which is linear in d too. So the resisted wrenches are the convex hull of the images
of the cell's vertices and rays, each with both extreme forces of every sticking contact. (Any
force in between is a mixture of the two at the same d, and the maps are linear.)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

from arrangement.exact import IntegerVector, RationalVector, dot, primitive
from equilibrium.grasp import Contact, Grasp, read_wrench
from equilibrium.states import DIRECTION, State, States, contact_states

from .cones import generators
from .intervals import Interval, union
from .polyhedron import Polyhedron, from_generators

#: Above this number, redundant generators are removed before the next sticking contact.
_MANY = 40


@dataclass(frozen=True)
class Piece:
    """All wrenches that are resisted with one choice of contact states (a convex polyhedron)."""

    states: States
    polyhedron: Polyhedron

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {"states": list(self.states), **self.polyhedron.to_dict()}


@dataclass(frozen=True)
class ResistibleSet:
    """A finite union of convex polyhedra of wrenches (force x, force y, torque).

    Attributes:
        pieces: those that lie in no other single one; they may overlap and touch.
    """

    grasp: Grasp
    pieces: tuple[Piece, ...]

    def contains(self, wrench: Iterable[Any]) -> bool:
        """Return whether a wrench is resisted; the same answer as `passive.solve`."""
        w = read_wrench(wrench)
        return any(piece.polyhedron.contains(w) for piece in self.pieces)

    def states_at(self, wrench: Iterable[Any]) -> tuple[States, ...]:
        """Return the contact states of all pieces that contain a wrench."""
        w = read_wrench(wrench)
        return tuple(piece.states for piece in self.pieces if piece.polyhedron.contains(w))

    def along(
        self, direction: Iterable[Any], base: Iterable[Any] = (0, 0, 0)
    ) -> tuple[Interval, ...]:
        """Return the magnitudes t >= 0 with ``base + t direction`` inside, as closed intervals."""
        start, u = read_wrench(base), read_wrench(direction)
        found = (piece.polyhedron.along(start, u) for piece in self.pieces)
        halves = (
            (max(low or Fraction(0), Fraction(0)), high)
            for low, high in (part for part in found if part is not None)
            if high is None or high >= 0
        )
        return union(halves)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals."""
        return {"polyhedra": [piece.to_dict() for piece in self.pieces]}


@lru_cache(maxsize=16)
def resistible_set(grasp: Grasp) -> ResistibleSet:
    """Return all wrenches that a grasp resists, exactly.

    Complexity: two conversions between conditions and generators in four homogeneous coordinates
    for each choice of contact states: O(m^2) of them without preload, O(m^3) with.

    >>> from equilibrium.files import read_grasp
    >>> whole = resistible_set(read_grasp("paper-three-contacts"))
    >>> whole.contains([0, -5, 0]), whole.contains([0, 1, 0])
    (True, False)
    """
    found = ((states, resisted_with(grasp, states)) for states in contact_states(grasp))
    pieces = [Piece(states, shape) for states, shape in found if shape is not None]
    return ResistibleSet(grasp, maximal_pieces(pieces))


def resisted_with(grasp: Grasp, states: States) -> Polyhedron | None:
    """Return the wrenches that are resisted with these contact states; None when there are none."""
    inequalities: list[IntegerVector] = [(0, 0, 0, 1)]
    equalities: list[IntegerVector] = []
    for contact, state in zip(grasp, states, strict=True):
        spring = primitive(_normal_force(contact))
        slip = primitive((*contact.tangential_wrench, Fraction(0)))
        if state == "detached":
            inequalities.append(tuple(-x for x in spring))
            continue
        inequalities.append(spring)
        if state == "stick":
            equalities.append(slip)
        else:
            inequalities.append(slip if state == "slip+" else tuple(-x for x in slip))
    # Along a line of the cell no touching spring may change, so the wrench does not either.
    rays, _ = generators(inequalities, equalities, 4)
    images = {image for ray in rays for image in _images(grasp, states, ray)}
    return from_generators(images, (), 3)


def maximal_pieces(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """Return the pieces that lie in no other one, in their order; of equal ones the first."""
    order = sorted(range(len(pieces)), key=lambda i: -pieces[i].polyhedron.dimension)
    kept: list[int] = []
    for i in order:
        shape = pieces[i].polyhedron
        if any(shape.within(pieces[j].polyhedron) for j in kept):
            continue
        kept = [j for j in kept if not pieces[j].polyhedron.within(shape)] + [i]
    return tuple(pieces[i] for i in sorted(kept))


def _normal_force(contact: Contact) -> RationalVector:
    """Return the homogeneous row of ``preload - stiffness N . d``."""
    return (*(-contact.stiffness * x for x in contact.normal_wrench), contact.preload)


def _images(grasp: Grasp, states: States, motion: IntegerVector) -> Iterator[IntegerVector]:
    """Yield the homogeneous wrenches that balance the extreme forces at a homogeneous motion."""
    wrenches: list[RationalVector] = [(Fraction(0), Fraction(0), Fraction(0), Fraction(motion[-1]))]
    for contact, state in zip(grasp, states, strict=True):
        if state == "detached":
            continue
        force = dot(_normal_force(contact), motion)
        sides = _sides(contact, state) if force else (Fraction(0),)
        wrenches = [
            _balanced(wrench, contact, force, side * force) for wrench in wrenches for side in sides
        ]
        if len(wrenches) > _MANY:
            wrenches = _extreme(wrenches)
    yield from (primitive(wrench) for wrench in wrenches if any(wrench))


def _sides(contact: Contact, state: State) -> tuple[Fraction, ...]:
    """Return the extreme ratios of the tangential to the normal force."""
    if state == "stick":
        return (contact.friction, -contact.friction) if contact.friction else (Fraction(0),)
    return (DIRECTION[state] * contact.friction,)


def _balanced(
    wrench: RationalVector, contact: Contact, normal: Fraction, tangential: Fraction
) -> RationalVector:
    """Add the applied wrench that balances one more contact force."""
    pairs = zip(wrench[:3], contact.normal_wrench, contact.tangential_wrench, strict=True)
    return (*(w - normal * a - tangential * b for w, a, b in pairs), wrench[3])


def _extreme(wrenches: Iterable[RationalVector]) -> list[RationalVector]:
    """Return the extreme points among points of space; their common last entry stays as it is."""
    listed = list(wrenches)
    facets, equalities = generators([primitive((*w[:3], Fraction(1))) for w in listed], (), 4)
    rays, _ = generators(facets, equalities, 4)
    return [(*(Fraction(x, ray[3]) for x in ray[:3]), listed[0][3]) for ray in rays]
