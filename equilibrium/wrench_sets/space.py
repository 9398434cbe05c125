"""The whole set of wrenches that a grasp resists, as convex polyhedra with exact half-spaces.

It is the union, over all contact states, of what `StateImages.resisted_with` returns.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.console.number_form import Shown
from arrangement.console.progress import watched
from arrangement.numbers.exact import IntegerVector, RationalVector
from arrangement.numbers.linear.intervals import Interval, intersection, union
from arrangement.numbers.linear.polyhedron import Polyhedron
from arrangement.numbers.linear.separation import surely_outside
from equilibrium.decide.verdict import Solver, prepare
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.plane.states.state_system import States

from .images import StateImages


@dataclass(frozen=True, repr=False)
class Piece(Shown):
    """All wrenches that are resisted with one choice of contact states (a convex polyhedron)."""

    states: States
    polyhedron: Polyhedron

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {"states": list(self.states), **self.polyhedron.to_dict()}


@dataclass(frozen=True, repr=False)
class ResistedSet(Shown):
    """A finite union of convex polyhedra of wrenches ``(f_x, f_y, tau)``.

    Attributes:
        pieces: those that lie in no other single one; they may overlap and touch.
    """

    grasp: Grasp
    pieces: tuple[Piece, ...]

    def contains(self, wrench: Iterable[Any]) -> bool:
        """Return whether a wrench is resisted; the same answer as `solve`."""
        return bool(self.states_at(wrench))

    def states_at(self, wrench: Iterable[Any]) -> tuple[States, ...]:
        """Return the contact states of all pieces that contain a wrench."""
        return states_with(self.pieces, read_wrench(wrench))

    def along(
        self, direction: Iterable[Any], base: Iterable[Any] = (0, 0, 0)
    ) -> tuple[Interval, ...]:
        """Return the magnitudes t >= 0 with ``base + t direction`` inside, as closed intervals."""
        return magnitudes_in(self.pieces, read_wrench(base), read_wrench(direction))

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals."""
        return {"polyhedra": [piece.to_dict() for piece in self.pieces]}


def resisted_set(grasp: Grasp | Solver) -> ResistedSet:
    """Return all wrenches that a grasp resists, exactly.

    Complexity: two conversions between conditions and generators in four homogeneous coordinates
    for each choice of contact states: O(m^2) of them without preload, O(m^3) with.

    >>> from equilibrium.grasps.files import read_grasp
    >>> whole = resisted_set(read_grasp("paper-three-contacts"))
    >>> whole.contains([0, -5, 0]), whole.contains([0, 1, 0])
    (True, False)
    """
    solver = prepare(grasp)
    pieces = [Piece(states, shape) for states, shape in images_of(solver) if shape is not None]
    return ResistedSet(solver.grasp, maximal_pieces(pieces))


def images_of(
    solver: Solver, plane: IntegerVector | None = None
) -> Iterator[tuple[States, Polyhedron | None]]:
    """Yield all contact states with `StateImages.resisted_with`."""
    images, found = StateImages(solver.grasp, solver.within), {}
    for states in watched(sorted(solver.states), "contact states"):
        found[states] = images.resisted_with(states, plane)
    yield from ((states, found[states]) for states in solver.states)


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
