"""What the methods with springs share: forces as linear rows in the motion."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    dot,
    primitive,
    rational,
    rational_vector,
    shown,
)
from arrangement.numbers.linear.cones import generators
from arrangement.numbers.linear.polyhedron import Polyhedron, from_generators
from arrangement.numbers.linear.programs import Infeasible, feasible_point
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.plane.contact_rows import Pair, balance_rows, cone_rows, normal_force_row, unit_row
from equilibrium.plane.states.state_system import value

#: The point zero as a homogeneous point; also the condition that a homogeneous point is one.
APEX: IntegerVector = (0, 0, 0, 1)
#: Normal and tangential force of each contact.
Forces: TypeAlias = tuple[RationalVector, ...]


def forces_at(pairs: Sequence[Pair], motion: RationalVector) -> Forces:
    """Return the forces at a motion."""
    return tuple((value(normal, motion), value(tangential, motion)) for normal, tangential in pairs)


def force_rows(contact: Contact, pair: Pair) -> list[RationalVector]:
    """Return ``c_n >= 0`` and ``|c_t| <= friction c_n`` as rows."""
    return [pair[0], *cone_rows(contact.friction, *pair)]


def balanced_wrenches(
    grasp: Grasp, pairs: Sequence[Pair], rows: Iterable[RationalVector]
) -> Polyhedron | None:
    """Return the wrenches that forces linear in the motion balance, under conditions on it."""
    rays, lines = generators([APEX, *map(primitive, rows)], [], 4)
    if not any(ray[3] for ray in rays):
        return None
    balance = balance_rows(grasp, pairs, (Fraction(0),) * 3)

    def images(motions: Iterable[IntegerVector]) -> list[IntegerVector]:
        found = (([-Fraction(dot(row, d)) for row in balance], Fraction(d[3])) for d in motions)
        return [primitive([*wrench, h]) for wrench, h in found if h or any(wrench)]

    return from_generators(images(rays), images(lines), 3)


def springs_of(
    grasp: Grasp, tangential_stiffness: Any = 1, rest_friction: Iterable[Any] | None = None
) -> list[Pair]:
    """Return the normal and the tangential spring of each contact as rows in the motion.

    Args:
        tangential_stiffness: a factor on each normal stiffness, or a value for each contact.
        rest_friction: the tangential forces at d = 0; none if omitted.

    Raises:
        GraspError: a wrong number of values, or a stiffness that is not above 0.
    """
    if isinstance(tangential_stiffness, Iterable) and not isinstance(tangential_stiffness, str):
        stiffnesses = rational_vector(tangential_stiffness, "tangential_stiffness")
    else:
        factor = rational(tangential_stiffness, "tangential_stiffness")
        stiffnesses = tuple(factor * contact.stiffness for contact in grasp)
    rest = [0] * len(grasp) if rest_friction is None else rest_friction
    forces = rational_vector(rest, "rest_friction")
    for name, found in (("tangential_stiffness", stiffnesses), ("rest_friction", forces)):
        if len(found) != len(grasp):
            raise GraspError(f"{name} has {len(found)} values for {len(grasp)} contacts")
    for x in stiffnesses:
        if x <= 0:
            raise GraspError(f"a tangential stiffness is {shown(x)}; it must be above 0")
    return [
        (normal_force_row(c), (*(-k * x for x in c.tangential_wrench), t))
        for c, k, t in zip(grasp, stiffnesses, forces, strict=True)
    ]


def usual_springs(grasp: Grasp) -> tuple[list[Pair], str]:
    """Return the springs that a comparison takes, with a remark.

    Tangential ones are as stiff as the normal ones, and at rest they balance the preloads where
    friction can.
    """
    rest = balancing_friction(grasp)
    if rest is None:
        remark = "no friction at rest, as none would balance the preloads"
    elif any(rest):
        remark = "friction at rest balances the preloads"
    else:
        remark = "no friction at rest"
    return springs_of(grasp, 1, rest), remark


def balancing_friction(grasp: Grasp) -> RationalVector | None:
    """Return tangential forces that balance the preloads at d = 0, if the cones allow it.

    Where several do, one corner of the set is returned. A grasp that was closed with its preloads
    and stood still has such forces; None says that no such grasp exists.

    >>> from equilibrium.grasps.files import read_grasp
    >>> [str(x) for x in balancing_friction(read_grasp("paper-three-contacts-preload-1"))]
    ['-1/2', '0', '1/2']
    """
    m = len(grasp)
    limits = [contact.friction * contact.preload for contact in grasp]
    cones = [
        (*(side * x for x in unit_row(i, m)[:-1]), limit)
        for i, limit in enumerate(limits)
        for side in (1, -1)
    ]
    at_rest = [((*[Fraction(0)] * m, c.preload), unit_row(i, m)) for i, c in enumerate(grasp)]
    balance = balance_rows(grasp, at_rest, (Fraction(0),) * 3, m)
    if all(row[-1] == 0 for row in balance):
        return (Fraction(0),) * m
    point = feasible_point(m, cones, balance)
    return None if isinstance(point, Infeasible) else point
