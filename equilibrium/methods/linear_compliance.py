"""Linear compliance ([Bicchi1993], [Bicchi1994], [Bicchi1995], [Cutkosky1989]).

Every contact has a linear spring in the normal and one in the tangential direction, both working
both ways; the motion that balances a wrench solves one linear system, which determines all forces.
The method accepts when these forces happen to lie inside the friction cones. Contacts neither slip
nor let go, so a spring that leaves its cone makes the method refuse, right or wrong.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from arrangement.exact import RationalVector
from arrangement.linprog import Infeasible, feasible_point
from equilibrium.model.grasp import Grasp, read_wrench

from .springs import (
    Forces,
    balance_rows,
    normal_form,
    rest_forces,
    tangential_form,
    tangential_stiffnesses,
    value,
)


@dataclass(frozen=True)
class ComplianceVerdict:
    """Whether the forces of the springs lie inside the cones.

    Attributes:
        accepts: they exist and do.
        motion: a motion that balances; None if the springs cannot (two contact points or more
            always can).
        forces: normal and tangential force of each contact, the same for all such motions.
        outside: the contacts whose force is outside the cone.
    """

    accepts: bool
    motion: RationalVector | None
    forces: Forces | None
    outside: tuple[int, ...]


def linear_compliance(
    grasp: Grasp,
    wrench: Iterable[Any],
    *,
    tangential_stiffness: Any = 1,
    rest_friction: Iterable[Any] | None = None,
) -> ComplianceVerdict:
    """Decide by linear springs in both directions, exactly.

    Args:
        grasp: normal stiffness and preload are those of the contacts.
        wrench: applied.
        tangential_stiffness: a factor on each normal stiffness, or a value for each contact.
        rest_friction: tangential forces at d = 0 (see `balancing_friction`); zeros if left out.
    """
    applied = read_wrench(wrench)
    stiffnesses = tangential_stiffnesses(grasp, tangential_stiffness)
    rest = rest_forces(grasp, rest_friction)
    forms = [
        (normal_form(contact), tangential_form(contact, k, t))
        for contact, k, t in zip(grasp, stiffnesses, rest, strict=True)
    ]
    motion = feasible_point(3, [], balance_rows(grasp, forms, applied))
    if isinstance(motion, Infeasible):
        return ComplianceVerdict(False, None, None, ())
    forces = tuple((value(n, motion), value(t, motion)) for n, t in forms)
    outside = tuple(
        i
        for i, (contact, (c_n, c_t)) in enumerate(zip(grasp, forces, strict=True))
        if c_n < 0 or abs(c_t) > contact.friction * c_n
    )
    return ComplianceVerdict(not outside, motion, forces, outside)
