"""The linear system of one choice of contact states, exactly; loads that singular ones allow.

With the state of every contact fixed, equilibrium is linear in z = (d, tangential forces of
sticking contacts). Its closed form is used: the union of all solutions is the same as with strict
signs.

With fewer than three touching contacts the balance has more equations than unknowns matter, so only
loads of some planes can have such states. Where contacts stick in all directions the motion is 0,
and forces inside the friction cones of the preloads balance the load: a virtual motion against
which they work less than the load shows that they cannot.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from typing import Literal, TypeAlias

from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive
from arrangement.numbers.linear import programs
from arrangement.numbers.linear.rank import cross, gauss_jordan, rank
from equilibrium.core.contact_rows import (
    DIRECTION,
    balance_rows,
    cone_rows,
    displacement_rows,
    negated,
    normal_force_row,
    over_unit,
    slip_row,
    unit_row,
)
from equilibrium.model.grasp import Grasp

State: TypeAlias = Literal["detached", "slip+", "slip-", "stick"]
States: TypeAlias = tuple[State, ...]


@dataclass(frozen=True)
class StateSystem:
    """The closed linear system of one choice of states, for one wrench.

    Rows have one coefficient for each variable and the constant last. Equalities (``= 0``): the
    three balances times `unit`, then ``T . d`` of each sticking contact. Inequalities (``>= 0``),
    contact by contact: the spring (``stiffness N . d - preload`` when detached, else the normal
    force); then for slip the direction of ``T . d``, for stick ``friction c_n - c_t`` and the same
    with ``+``; at last bounded displacements.

    Attributes:
        forces: for each contact the (normal, tangential) force as two rows in the variables.
        unit: with it the balances are in integers.
    """

    states: States
    equalities: tuple[RationalVector, ...]
    inequalities: tuple[RationalVector, ...]
    forces: tuple[tuple[RationalVector, RationalVector], ...]
    unit: int

    @cached_property
    def program(self) -> programs.Program:
        """The exact linear programs over the solutions."""
        return programs.Program(self.size, self.inequalities, self.equalities)

    @property
    def size(self) -> int:
        """The number of variables: 3, and one for each sticking contact."""
        return len(self.equalities)


def state_system(
    grasp: Grasp,
    states: States,
    wrench: RationalVector,
    *,
    friction_sign: int = 1,
    cell_check: bool = True,
    max_displacement: Fraction | None = None,
) -> StateSystem:
    """Return the linear system of a choice of states.

    Args:
        friction_sign: -1 lets friction pull along the slip (a literal reading only).
        cell_check: False leaves out the direction of slip (a literal reading only).
        max_displacement: the conditions on displacements come last.
    """
    n = 3 + states.count("stick")
    columns = iter(range(3, n))
    equalities, inequalities, forces = [], [], []
    pairs = list(zip(grasp, states, strict=True))
    # Three independent sticking planes leave d = 0 only: each spring has its preload, and exact
    # programs are many times faster without its stiffness.
    still = rank([primitive(c.tangential_wrench) for c, state in pairs if state == "stick"]) == 3
    for contact, state in pairs:
        normal, slip = normal_force_row(contact, n), slip_row(contact, n)
        if still:
            normal = (*[Fraction(0)] * n, contact.preload)
        if state == "detached":
            inequalities.append(negated(normal))
            forces.append(((Fraction(0),) * (n + 1),) * 2)
            continue
        inequalities.append(normal)
        if state == "stick":
            tangential = unit_row(next(columns), n)
            equalities.append(slip)
            inequalities += cone_rows(contact.friction, normal, tangential)
        else:
            direction = DIRECTION[state]
            pull = friction_sign * direction * contact.friction
            # Most entries are 0, and fractions are slow.
            tangential = tuple(pull * x if x else x for x in normal)
            if cell_check:
                inequalities.append(slip if direction < 0 else negated(slip))
        forces.append((normal, tangential))
    balance, unit = balance_rows(grasp, forces, wrench, n)
    inequalities += displacement_rows(max_displacement, grasp, n)
    rows = tuple(inequalities)
    return StateSystem(states, (*balance, *equalities), rows, tuple(forces), unit)


def value(row: RationalVector, point: RationalVector) -> Fraction:
    """Return the value of a row (constant last) at a point."""
    # No fraction is reduced on the way.
    entries, unit = over_unit(row)
    place, scale = over_unit((*point, Fraction(1)))
    return Fraction(dot(entries, place), unit * scale)


def each_force(system: StateSystem) -> Iterator[RationalVector]:
    """Yield the rows of all force components: c_n, c_t of contact 0, then of contact 1, ..."""
    for pair in system.forces:
        yield from pair


_NO_LOAD = (Fraction(0),) * 3


class SingularStates:
    """Choices of contact states whose systems floats cannot solve."""

    def __init__(self, grasp: Grasp, choices: Iterable[States]) -> None:
        self._planes: list[list[IntegerVector]] = []
        self._bounds: list[list[IntegerVector]] = []
        for states in choices:
            planes = _planes(grasp, states)
            if planes:
                self._planes.append(planes)
            else:
                self._bounds.append(_bounds(grasp, states))

    def may_hold(self, wrench: RationalVector) -> bool:
        """Return whether one of them may balance a load; False is exact."""
        load = primitive((*wrench, Fraction(1)))
        return any(all(dot(row, load) == 0 for row in rows) for rows in self._planes) or any(
            all(dot(row, load) >= 0 for row in rows) for rows in self._bounds
        )


def _planes(grasp: Grasp, states: States) -> list[IntegerVector]:
    """Return rows that are 0 at all loads, with 1 last, that have these states."""
    system = state_system(grasp, states, _NO_LOAD)
    n = system.size
    loads = [[Fraction(system.unit * (j == k)) for j in range(3)] for k in range(n)]
    rows = [[*row[:n], *w, row[n]] for row, w in zip(system.equalities, loads, strict=True)]
    reduced, pivots, _ = gauss_jordan(rows)
    return [primitive(row[n:]) for row, pivot in zip(reduced, pivots, strict=False) if pivot >= n]


def _bounds(grasp: Grasp, states: States) -> list[IntegerVector]:
    """Return rows that are at least 0 at all loads, with 1 last, that have these states.

    There are some where the motion is 0: by the planes of two tangential wrenches.
    """
    sticking = [c for c, state in zip(grasp, states, strict=True) if state == "stick"]
    if rank([primitive(c.tangential_wrench) for c in sticking]) < 3:
        return []
    rows = []
    for one, other in combinations(sticking, 2):
        motion = cross(one.tangential_wrench, other.tangential_wrench)
        pull = sum(c.friction * c.preload * abs(dot(c.tangential_wrench, motion)) for c in sticking)
        push = sum(c.preload * dot(c.normal_wrench, motion) for c in sticking)
        push += dot(grasp.adhesion_wrench, motion)
        # The load, adhesion, preloads and at most all friction: no work is left over.
        rows += [primitive((*(s * x for x in motion), s * push + pull)) for s in (1, -1)]
    return rows
