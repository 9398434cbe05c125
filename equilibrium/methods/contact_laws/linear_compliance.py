"""Linear compliance ([Bicchi1993], [Bicchi1994], [Bicchi1995], [Cutkosky1989]).

Every contact has a linear spring in the normal and one in the tangential direction, both working
both ways; the motion that balances a wrench solves one linear system, which determines all forces.
The method accepts when these forces happen to lie inside the friction cones. Contacts neither slip
nor let go, so a spring that leaves its cone makes the method refuse, right or wrong.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.polyhedron import Polyhedron
from arrangement.numbers.linear.programs import Infeasible, feasible_point
from equilibrium.methods.method import Accepting, Method, Outcome, cut
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.plane.contact_rows import Pair, balance_rows

from .springs import Forces, balanced_wrenches, force_rows, forces_at, springs_of, usual_springs


@dataclass(frozen=True)
class ComplianceVerdict(Accepting):
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
        rest_friction: tangential forces at d = 0 (see `balancing_friction`); zeros if omitted.
    """
    springs = springs_of(grasp, tangential_stiffness, rest_friction)
    return _decided(grasp, read_wrench(wrench), springs)


def _decided(grasp: Grasp, wrench: RationalVector, springs: list[Pair]) -> ComplianceVerdict:
    motion = feasible_point(3, [], balance_rows(grasp, springs, wrench))
    if isinstance(motion, Infeasible):
        return ComplianceVerdict(False, None, None, ())
    forces = forces_at(springs, motion)
    outside = tuple(
        i
        for i, (contact, (c_n, c_t)) in enumerate(zip(grasp, forces, strict=True))
        if c_n < 0 or abs(c_t) > contact.friction * c_n
    )
    return ComplianceVerdict(not outside, motion, forces, outside)


def _decide(grasp: Grasp, wrench: RationalVector) -> Outcome:
    springs, remark = usual_springs(grasp)
    return _decided(grasp, wrench, springs).accepts, remark


@cut
def _region(grasp: Grasp) -> Iterator[Polyhedron | None]:
    springs, _ = usual_springs(grasp)
    pairs = zip(grasp, springs, strict=True)
    rows = [row for contact, pair in pairs for row in force_rows(contact, pair)]
    yield balanced_wrenches(grasp, springs, rows)


LINEAR_COMPLIANCE = Method(
    "linear-compliance",
    "linear compliance (Bicchi 1993-95; Cutkosky, Kao 1989)",
    "linear compliance",
    _decide,
    _region,
)
