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

from arrangement import linprog
from arrangement.exact import RationalVector, dot
from equilibrium.model.grasp import Contact, Grasp

from .contact_rows import DIRECTION, normal_force_row

State: TypeAlias = Literal["detached", "slip+", "slip-", "stick"]
States: TypeAlias = tuple[State, ...]


@dataclass(frozen=True)
class StateSystem:
    """The closed linear system of one choice of states, for one wrench.

    Rows have one coefficient for each variable and the constant last. Equalities (``= 0``): the
    three balances, then ``T . d`` of each sticking contact. Inequalities (``>= 0``), contact by
    contact: the spring (``stiffness N . d - preload`` when detached, else the normal force); then
    for slip the direction of ``T . d``, for stick ``friction c_n - c_t`` and the same with ``+``.

    Attributes:
        forces: for each contact the (normal, tangential) force as two rows in the variables.
    """

    states: States
    equalities: tuple[RationalVector, ...]
    inequalities: tuple[RationalVector, ...]
    forces: tuple[tuple[RationalVector, RationalVector], ...]

    @cached_property
    def program(self) -> linprog.Program:
        """The exact linear programs over the solutions."""
        return linprog.Program(self.size, self.inequalities, self.equalities)

    @property
    def size(self) -> int:
        """The number of variables: 3, and one for each sticking contact."""
        return len(self.equalities)


def state_system(
    grasp: Grasp,
    states: States,
    wrench: RationalVector | None = None,
    *,
    friction_sign: int = 1,
    cell_check: bool = True,
) -> StateSystem:
    """Return the linear system of a choice of states.

    Args:
        wrench: applied; None for none. See `loaded` for another one.
        friction_sign: -1 lets friction pull along the slip (a literal reading only).
        cell_check: False leaves out the direction of slip (a literal reading only).
    """
    columns = _stick_columns(states)
    n = 3 + len(columns)
    balance = [[Fraction(0)] * (n + 1) for _ in range(3)]
    equalities, inequalities, forces = [], [], []
    for i, (contact, state) in enumerate(zip(grasp, states, strict=True)):
        normal = _normal_force(contact, n)
        if state == "detached":
            inequalities.append(tuple(-x for x in normal))
            forces.append(((Fraction(0),) * (n + 1),) * 2)
            continue
        inequalities.append(normal)
        moved = (*contact.tangential_wrench, *[Fraction(0)] * (n - 2))
        limit = tuple(contact.friction * x for x in normal)
        if state == "stick":
            tangential = _unit_row(columns[i], n)
            equalities.append(moved)
            inequalities += [_sum(limit, tangential, -1), _sum(limit, tangential, 1)]
        else:
            direction = DIRECTION[state]
            tangential = tuple(friction_sign * direction * x for x in limit)
            if cell_check:
                inequalities.append(tuple(-direction * x for x in moved))
        forces.append((normal, tangential))
        _add_force(balance, contact, normal, tangential)
    rows = (*map(tuple, balance), *equalities)
    system = StateSystem(states, rows, tuple(inequalities), tuple(forces))
    return system if wrench is None else loaded(system, wrench)


def loaded(system: StateSystem, wrench: RationalVector) -> StateSystem:
    """Return a system with one more wrench applied: only the constants of the balances change."""
    pairs = zip(system.equalities, wrench, strict=False)
    rows = (*((*row[:-1], row[-1] + w) for row, w in pairs), *system.equalities[3:])
    return StateSystem(system.states, rows, system.inequalities, system.forces)


def _stick_columns(states: States) -> dict[int, int]:
    """Return the column of the tangential force of each sticking contact."""
    sticking = [i for i, state in enumerate(states) if state == "stick"]
    return {contact: 3 + j for j, contact in enumerate(sticking)}


def _normal_force(contact: Contact, n: int) -> RationalVector:
    """Return the row of ``preload - stiffness N . d``."""
    *spring, preload = normal_force_row(contact)
    return (*spring, *[Fraction(0)] * (n - 3), preload)


def _unit_row(column: int, n: int) -> RationalVector:
    return tuple(Fraction(int(j == column)) for j in range(n + 1))


def _sum(left: RationalVector, right: RationalVector, factor: int) -> RationalVector:
    return tuple(a + factor * b for a, b in zip(left, right, strict=True))


def _add_force(
    balance: list[list[Fraction]],
    contact: Contact,
    normal: RationalVector,
    tangential: RationalVector,
) -> None:
    """Add the wrench of a contact force to the three balance rows."""
    wrenches = zip(contact.normal_wrench, contact.tangential_wrench, strict=True)
    for row, (along_normal, along_tangent) in zip(balance, wrenches, strict=True):
        for j, (c_n, c_t) in enumerate(zip(normal, tangential, strict=True)):
            if c_n or c_t:
                row[j] += along_normal * c_n + along_tangent * c_t


def value(row: RationalVector, point: RationalVector) -> Fraction:
    """Return the value of a row (constant last) at a point."""
    return Fraction(dot(row[:-1], point) + row[-1])


def each_force(system: StateSystem) -> Iterator[RationalVector]:
    """Yield the rows of all force components: c_n, c_t of contact 0, then of contact 1, ..."""
    for pair in system.forces:
        yield from pair
