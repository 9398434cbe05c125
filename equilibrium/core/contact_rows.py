"""Springs, slips, cones and balance as rows, for methods with another law, and for pictures.

The law is in `equilibrium.core.contact_law`. A row has one coefficient for each of n variables, the
motion ``d = (x, y, r)`` first, and the constant last.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any, TypeAlias, TypeVar

from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import RationalVector, dot, over_unit
from arrangement.numbers.linear.programs import Infeasible, Program, Unbounded
from equilibrium.model.contact import Contact, pyramid_edges
from equilibrium.model.grasp import Grasp

from .contact_law import spring_row

#: Normal and tangential force.
Pair: TypeAlias = tuple[RationalVector, RationalVector]

_Number = TypeVar("_Number", int, Fraction)


def normal_force_row(contact: Contact) -> RationalVector:
    """Return the normal force of a touching contact, ``preload - stiffness N . d``."""
    preload, *spring = spring_row(contact)
    return (*spring, preload)


def unit_row(column: int, n: int) -> RationalVector:
    """Return one variable as a row."""
    return tuple(Fraction(int(j == column)) for j in range(n + 1))


def negated(row: tuple[_Number, ...]) -> tuple[_Number, ...]:
    """Return the row with all signs changed."""
    return tuple(-x if x else x for x in row)


def sum_row(left: RationalVector, right: RationalVector, factor: Fraction | int) -> RationalVector:
    """Return ``left + factor right``."""
    # Most entries are 0, and fractions are slow.
    return tuple(a + factor * b if b else a for a, b in zip(left, right, strict=True))


def cone_rows(friction: Fraction, normal: RationalVector, tangential: RationalVector) -> Pair:
    """Return ``friction c_n - c_t`` and ``friction c_n + c_t``, at least 0 inside the cone."""
    limit = tuple(friction * x if x else x for x in normal)
    return sum_row(limit, tangential, -1), sum_row(limit, tangential, 1)


def any_friction_does(
    n: int,
    inequalities: Sequence[RationalVector],
    equalities: Sequence[RationalVector],
    forces: Iterable[Pair],
    deadline: Deadline | None = None,
) -> bool:
    """Return whether conditions have a solution, where friction may have any coefficient.

    The cone of a contact is a half-plane then, without its edge: where the normal force is 0 there
    is no friction. A contact without normal force in all solutions has no friction in any, which
    is one more equality. When no such contact is left, the mean of solutions with normal forces at
    each of the others is one with friction in cones.

    Args:
        forces: of the contacts with friction.
    """
    rubbing, equal = list(forces), list(equalities)
    while True:
        program = Program(n, inequalities, equal, deadline)
        if not program.feasible:
            return False
        loose = _never_pressed(program, rubbing)
        if not loose:
            return True
        equal += [tangential for _, tangential in loose]
        rubbing = [pair for pair in rubbing if pair not in loose]


def _never_pressed(program: Program, forces: list[Pair]) -> list[Pair]:
    """Return the contacts whose normal force is 0 in all solutions, of which there are some."""
    loose = forces
    while loose:
        columns = zip(*(row for row, _ in loose), strict=True)
        optimum = program.minimize([-sum(column) for column in columns][:-1])
        assert not isinstance(optimum, Infeasible)
        ends = [(*optimum.point, Fraction(1))]
        if isinstance(optimum, Unbounded):
            ends.append((*optimum.ray, Fraction(0)))
        rest = [(row, t) for row, t in loose if not any(dot(row, end) > 0 for end in ends)]
        if len(rest) == len(loose):
            break
        loose = rest
    return loose


def balance_rows(
    grasp: Grasp, forces: Iterable[Pair], wrench: Sequence[Fraction], n: int = 3
) -> tuple[tuple[tuple[Any, ...], ...], int]:
    """Return the rows of ``sum ((c_n - adhesion) N + c_t T) + w`` times a unit, and the unit.

    They are integers: no fraction is reduced on the way, which takes long where numbers are.
    """
    parts = [
        (*over_unit(direction), *over_unit(force))
        for contact, pair in zip(grasp, forces, strict=True)
        for direction, force in zip(
            (contact.normal_wrench, contact.tangential_wrench), pair, strict=True
        )
        if any(force)
    ]
    load, size = over_unit(grasp.total_load(wrench))
    unit = math.lcm(size, *(one * other for _, one, _, other in parts))
    rows = [[0] * n + [w * (unit // size)] for w in load]
    for direction, one, force, other in parts:
        factor = unit // (one * other)
        for row, a in zip(rows, direction, strict=True):
            if a:
                a *= factor
                for j, x in enumerate(force):
                    if x:
                        row[j] += a * x
    return tuple(map(tuple, rows)), unit


def value(row: RationalVector, point: RationalVector) -> Fraction:
    """Return the value of a row (constant last) at a point."""
    # No fraction is reduced on the way.
    entries, unit = over_unit(row)
    place, scale = over_unit((*point, Fraction(1)))
    return Fraction(dot(entries, place), unit * scale)


def friction_edges(contact: Contact, pyramid: int = 4) -> tuple[RationalVector, ...]:
    """Return the edges of the friction cone, ``N + friction T`` and ``N - friction T``.

    In space those of a pyramid inside the round cone, see `edge_directions`.
    """
    return tuple(cone_edge(contact, along) for along in edge_directions(contact, pyramid))


def edge_directions(contact: Contact, pyramid: int = 4) -> tuple[RationalVector, ...]:
    """Return the directions of friction on `friction_edges`, in the frame of the tangents."""
    if contact.dimension == 2:
        return (Fraction(1),), (Fraction(-1),)
    return pyramid_edges(pyramid)


def cone_edge(contact: Contact, along: Iterable[Fraction]) -> RationalVector:
    """Return the wrench of a unit normal force with friction along a vector of the tangents."""
    edge = contact.normal_wrench
    for tangential, x in zip(contact.tangential_wrenches, along, strict=True):
        edge = sum_row(edge, tangential, contact.friction * x)
    return edge
