"""The solutions of one choice of states: a point or a polyhedron, as one reported equilibrium."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Any, TypeVar

from arrangement.console.number_form import JsonMixin
from arrangement.numbers.exact import (
    RationalVector,
    primitive,
    rational_vector,
    vector_text,
)
from arrangement.numbers.linear.intervals import Interval
from arrangement.numbers.linear.rank import rank
from equilibrium.core.contact_law import LinearQuestion, State, Terms
from equilibrium.core.contact_program import ContactProgram
from equilibrium.core.contact_rows import unit_row
from equilibrium.model.errors import GraspError
from equilibrium.model.solution import Solution

from .contact_states import States
from .min_norm_point import least_point


@dataclass(frozen=True)
class Equilibrium(JsonMixin):
    """All solutions with one choice of contact states: a closed convex polyhedron, often a point.

    Attributes:
        states: the state of each contact (its conditions are closed: boundaries belong).
        motion: ``(x, y, r)`` of the solution of least norm (see `solve`).
        forces: (normal, tangential) force on the object at each contact, without its adhesion, of
            the same solution.
        unique: whether the polyhedron is this one point.
        motion_ranges, force_ranges: exact (least, largest) value of each component over the
            polyhedron; None where it is unbounded.
    """

    json_fields = (
        "states",
        "motion",
        "forces",
        "unique",
        "forces_determined",
        "motion_ranges",
        "force_ranges",
    )

    states: States
    motion: RationalVector
    forces: tuple[RationalVector, ...]
    unique: bool
    motion_ranges: tuple[Interval, ...]
    force_ranges: tuple[tuple[Interval, Interval], ...]
    program: ContactProgram = field(repr=False, compare=False)

    def __repr__(self) -> str:
        return f"<Equilibrium: {' '.join(self.states)}, motion {vector_text(self.motion)}>"

    @property
    def forces_determined(self) -> bool:
        """Whether every solution of the polyhedron has the same contact forces."""
        return all(low == high for pair in self.force_ranges for low, high in pair)

    def contains(self, motion: Iterable[Any], forces: Iterable[Iterable[Any]]) -> bool:
        """Return whether a motion with forces is one of these solutions."""
        d = rational_vector(motion, "motion")
        pairs = [rational_vector(pair, "forces") for pair in forces]
        if len(d) != 3 or len(pairs) != len(self.states) or any(len(p) != 2 for p in pairs):
            raise GraspError(
                f"give a motion of 3 numbers and {len(self.states)} pairs (normal, tangential)"
            )
        return self.program.holds(Solution(d, tuple(pairs)))

    def within(self, other: Equilibrium) -> bool:
        """Return whether every solution here is also one of `other` (exact linear programs)."""
        if self.unique:
            return other.contains(self.motion, self.forces)
        if other.unique:
            return False
        return self.program.within(other.program)


def equilibrium_of(
    question: LinearQuestion, states: States, as_read: Sequence[State] = ()
) -> Equilibrium | None:
    """Return the solutions with one choice of states as one equilibrium; None if there are none.

    Regular equations leave one point to check; of singular consistent ones the exact linear program
    decides.

    Args:
        as_read: what the states are taken for in place of the law.
    """
    sticking = [c for c, state in zip(question.rows, states, strict=True) if state == "stick"]
    if len(sticking) > 2 and rank([primitive(c.tangential_wrenches[0]) for c in sticking]) == 3:
        question = question.at_rest
    program = ContactProgram(question, tuple(as_read or states))
    if program.freedom == 0:
        solution = program.admitted(program.completed([]))
        if solution is None:
            return None
        ranges: list[Interval] = [(x, x) for x in chain(solution.motion, *solution.forces)]
    else:
        if program.freedom is None or not program.feasible:
            return None
        solution = program.at(program.values(_least_solution(program)))
        components: list[Terms] = [*({j: 1} for j in range(3)), *chain(*program.forces)]
        ranges = list(map(program.range_of, components))
    return Equilibrium(
        states,
        solution.motion,
        solution.forces,
        all(low == high and low is not None for low, high in ranges),
        tuple(ranges[:3]),
        tuple(zip(ranges[3::2], ranges[4::2], strict=True)),
        program,
    )


#: Solutions with one choice of states.
P = TypeVar("P", Equilibrium, ContactProgram)


def maximal(pieces: Sequence[P]) -> tuple[P, ...]:
    """Return the pieces that lie in no other one.

    Of equal pieces the one with most detached, then most sticking contacts stays: for a single
    point these are the states of its own motion, and the others are on their boundary.
    """
    specific = sorted(
        pieces, key=lambda piece: (-piece.states.count("detached"), -piece.states.count("stick"))
    )
    kept: list[P] = []
    for piece in specific:
        if any(piece.within(other) for other in kept):
            continue
        kept = [other for other in kept if not other.within(piece)]
        kept.append(piece)
    return tuple(kept)


def _least_solution(program: ContactProgram) -> RationalVector:
    """Return the unknowns of least motion, and among those of least tangential forces.

    The motion fixes the normal forces, so least forces means least tangential ones of the sticking
    contacts.
    """
    n, inequalities, equalities = program.size, program.inequalities, program.equalities
    variables = [unit_row(j, n) for j in range(n)]
    motion = least_point(n, inequalities, equalities, variables[:3])
    if n == 3:
        return motion
    fixed: list[Any] = [(*row[:-1], -x) for row, x in zip(variables, motion, strict=False)]
    return (*motion, *least_point(n, inequalities, (*equalities, *fixed), variables[3:]))
