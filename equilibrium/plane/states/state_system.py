"""The linear system of one choice of contact states, exactly.

With the state of every contact fixed, equilibrium is linear in z = (d, tangential forces of
sticking contacts). Its closed form is used: the union of all solutions is the same as with strict
signs.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Literal, TypeAlias

from arrangement.numbers.exact import RationalVector, dot, primitive
from arrangement.numbers.linear import programs
from arrangement.numbers.linear.rank import rank
from equilibrium.model.grasp import Grasp
from equilibrium.model.range import NO_RANGE, Range
from equilibrium.plane.contact_rows import (
    DIRECTION,
    balance_rows,
    cone_rows,
    negated,
    normal_force_row,
    range_rows,
    slip_row,
    unit_row,
)

State: TypeAlias = Literal["detached", "slip+", "slip-", "stick"]
States: TypeAlias = tuple[State, ...]


@dataclass(frozen=True)
class StateSystem:
    """The closed linear system of one choice of states, for one wrench.

    Rows have one coefficient for each variable and the constant last. Equalities (``= 0``): the
    three balances, then ``T . d`` of each sticking contact. Inequalities (``>= 0``), contact by
    contact: the spring (``stiffness N . d - preload`` when detached, else the normal force); then
    for slip the direction of ``T . d``, for stick ``friction c_n - c_t`` and the same with ``+``;
    at last the bounds of a range.

    Attributes:
        forces: for each contact the (normal, tangential) force as two rows in the variables.
    """

    states: States
    equalities: tuple[RationalVector, ...]
    inequalities: tuple[RationalVector, ...]
    forces: tuple[tuple[RationalVector, RationalVector], ...]

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
    within: Range = NO_RANGE,
) -> StateSystem:
    """Return the linear system of a choice of states.

    Args:
        friction_sign: -1 lets friction pull along the slip (a literal reading only).
        cell_check: False leaves out the direction of slip (a literal reading only).
        within: conditions of this range come last.
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
            tangential = tuple(pull * x for x in normal)
            if cell_check:
                inequalities.append(tuple(-direction * x for x in slip))
        forces.append((normal, tangential))
    rows = (*balance_rows(grasp, forces, wrench, n), *equalities)
    inequalities += range_rows(within, (normal for normal, _ in forces), n)
    return StateSystem(states, rows, tuple(inequalities), tuple(forces))


def value(row: RationalVector, point: RationalVector) -> Fraction:
    """Return the value of a row (constant last) at a point."""
    return Fraction(dot(row[:-1], point) + row[-1])


def each_force(system: StateSystem) -> Iterator[RationalVector]:
    """Yield the rows of all force components: c_n, c_t of contact 0, then of contact 1, ..."""
    for pair in system.forces:
        yield from pair
