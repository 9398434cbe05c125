"""The solutions of one choice of states: a point or a polyhedron, as one reported equilibrium."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from arrangement.console.number_form import JsonMixin
from arrangement.numbers.exact import (
    RationalVector,
    dot,
    primitive,
    rational_vector,
    vector_text,
)
from arrangement.numbers.linear.intervals import Interval
from arrangement.numbers.linear.rank import gauss_jordan
from equilibrium.core.contact_rows import negated, sum_row, unit_row
from equilibrium.model.errors import GraspError

from .min_norm_point import least_point
from .state_system import States, StateSystem, each_force, value


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
    forces: tuple[tuple[Fraction, Fraction], ...]
    unique: bool
    motion_ranges: tuple[Interval, ...]
    force_ranges: tuple[tuple[Interval, Interval], ...]
    system: StateSystem = field(repr=False, compare=False)

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
        sticking = (p for p, state in zip(pairs, self.states, strict=True) if state == "stick")
        z = (*d, *(tangential for _, tangential in sticking))
        given = [component for pair in pairs for component in pair]
        return (
            all(value(row, z) == 0 for row in self.system.equalities)
            and all(value(row, z) >= 0 for row in self.system.inequalities)
            and given == [value(row, z) for row in each_force(self.system)]
        )

    def within(self, other: Equilibrium) -> bool:
        """Return whether every solution here is also one of `other` (exact linear programs)."""
        if self.unique:
            return other.contains(self.motion, self.forces)
        if other.unique:
            return False
        equalities, inequalities = _conditions(self.system, other.system)
        return all(set(_range(self.system, row)) == {0} for row in equalities) and all(
            (low := _least(self.system, row)) is not None and low >= 0 for row in inequalities
        )


def equilibrium_of(system: StateSystem) -> Equilibrium | None:
    """Return the solutions of a system as one reported equilibrium; None if there are none.

    The number of equalities equals the number of variables. Regular ones leave one point to check;
    of singular consistent ones the exact linear program decides.
    """
    n = system.size
    rows, pivots, scale = gauss_jordan(system.equalities)
    if n in pivots:
        return None
    components = [*(unit_row(j, n) for j in range(3)), *each_force(system)]
    if len(pivots) == n:
        sign = -1 if scale < 0 else 1
        point = [*(-sign * row[n] for row in rows), sign * scale]
        # In integers over the common denominator: no fraction is reduced on the way.
        if any(dot(primitive(row), point) < 0 for row in system.inequalities):
            return None
        z = tuple(Fraction(x, point[n]) for x in point[:n])
        ranges: list[Interval] = [(x, x) for x in (value(row, z) for row in components)]
    else:
        if not system.program.feasible:
            return None
        z = _least_solution(system)
        ranges = [_range(system, row) for row in components]
    return Equilibrium(
        system.states,
        z[:3],
        tuple((value(c_n, z), value(c_t, z)) for c_n, c_t in system.forces),
        all(low == high and low is not None for low, high in ranges),
        tuple(ranges[:3]),
        tuple(zip(ranges[3::2], ranges[4::2], strict=True)),
        system,
    )


def maximal(pieces: Sequence[Equilibrium]) -> tuple[Equilibrium, ...]:
    """Return the pieces that lie in no other one.

    Of equal pieces the one with most detached, then most sticking contacts stays: for a single
    point these are the states of its own motion, and the others are on their boundary.
    """
    specific = sorted(
        pieces, key=lambda piece: (-piece.states.count("detached"), -piece.states.count("stick"))
    )
    kept: list[Equilibrium] = []
    for piece in specific:
        if any(piece.within(other) for other in kept):
            continue
        kept = [other for other in kept if not other.within(piece)]
        kept.append(piece)
    return tuple(kept)


def _least_solution(system: StateSystem) -> RationalVector:
    """Return the solution of least motion, and among those of least tangential forces.

    The motion fixes the normal forces, so least forces means least tangential ones of the sticking
    contacts.
    """
    n, inequalities, equalities = system.size, system.inequalities, system.equalities
    variables = [unit_row(j, n) for j in range(n)]
    motion = least_point(n, inequalities, equalities, variables[:3])
    if n == 3:
        return motion
    fixed = [(*row[:-1], -x) for row, x in zip(variables, motion, strict=False)]
    return (*motion, *least_point(n, inequalities, (*equalities, *fixed), variables[3:]))


def _least(system: StateSystem, row: RationalVector) -> Fraction | None:
    """Return the least value of a row over the solutions; None if there is none."""
    least = system.program.least(row[:-1])
    return None if least is None else least + row[-1]


def _range(system: StateSystem, row: RationalVector) -> Interval:
    low = _least(system, row)
    high = _least(system, negated(row))
    return low, None if high is None else -high


def _conditions(
    inner: StateSystem, outer: StateSystem
) -> tuple[list[RationalVector], list[RationalVector]]:
    """Return the conditions of `outer` as rows in the variables of `inner`.

    The variables of `outer` are the motion and the tangential forces of its sticking contacts,
    each of which is a row in the variables of `inner`; besides, all forces have to agree.
    """
    n = inner.size
    images = [unit_row(j, n) for j in range(3)]
    images += [
        pair[1] for pair, state in zip(inner.forces, outer.states, strict=True) if state == "stick"
    ]

    def carried(row: RationalVector) -> RationalVector:
        combined: RationalVector = (*[Fraction(0)] * n, row[-1])
        for factor, image in zip(row[:-1], images, strict=True):
            if factor:
                combined = sum_row(combined, image, factor)
        return combined

    agree = [
        sum_row(mine, carried(theirs), -1)
        for mine, theirs in zip(each_force(inner), each_force(outer), strict=True)
    ]
    equalities = [*map(carried, outer.equalities), *agree]
    return equalities, [carried(row) for row in outer.inequalities]
