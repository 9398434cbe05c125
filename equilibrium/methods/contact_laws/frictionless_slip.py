"""Stick, slip without friction, or detached: the extended compliance of [Prattichizzo1997].

Each contact is in one of three states. Stick: linear springs in both directions, the force inside
the cone. Slip: the normal spring alone, no friction force at all. Detached: no force. Every one of
the 3^m choices of states gives one linear system in the motion; the method accepts when some
choice has a legal solution.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any, Literal

from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.polyhedron import Polyhedron
from arrangement.numbers.linear.programs import Infeasible, feasible_point
from equilibrium.methods.method import Accepting, Method, Outcome, cut
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.plane.contact_rows import Pair, balance_rows, negated

from .springs import Forces, balanced_wrenches, force_rows, forces_at, springs_of, usual_springs

_ZERO: RationalVector = (Fraction(0),) * 4
State = Literal["stick", "slip", "detached"]
STATES: tuple[State, ...] = ("stick", "slip", "detached")


@dataclass(frozen=True)
class FrictionlessSlipVerdict(Accepting):
    """Whether some choice of states has legal forces.

    Attributes:
        accepts: one does.
        states, motion, forces: of the first that does, in the order of `STATES`; else None.
        tried: how many choices were looked at (all 3^m when the method refuses).
    """

    accepts: bool
    states: tuple[State, ...] | None
    motion: RationalVector | None
    forces: Forces | None
    tried: int


def frictionless_slip(
    grasp: Grasp,
    wrench: Iterable[Any],
    *,
    tangential_stiffness: Any = 1,
    rest_friction: Iterable[Any] | None = None,
    gap: bool = True,
) -> FrictionlessSlipVerdict:
    """Decide by trying all 3^m choices of states, each exactly.

    Args:
        grasp: at most 12 contacts.
        wrench: applied.
        tangential_stiffness, rest_friction: as in `linear_compliance`.
        gap: a contact counts as detached only where its normal spring would pull. Without this a
            contact that is pressed together may be said to carry nothing.

    Raises:
        GraspError: too many contacts.
    """
    budget.keep(len(grasp), "contacts with a choice of three states")
    springs = springs_of(grasp, tangential_stiffness, rest_friction)
    return _decided(grasp, read_wrench(wrench), springs, gap)


def _decided(
    grasp: Grasp, wrench: RationalVector, springs: list[Pair], gap: bool = True
) -> FrictionlessSlipVerdict:
    tried = 0
    for tried, states in enumerate(product(STATES, repeat=len(grasp)), 1):
        forces, rows = _forces(states, springs), _legal_rows(grasp, states, springs, gap)
        motion = feasible_point(3, list(rows), balance_rows(grasp, forces, wrench))
        if not isinstance(motion, Infeasible):
            found = forces_at(forces, motion)
            return FrictionlessSlipVerdict(True, states, motion, found, tried)
    return FrictionlessSlipVerdict(False, None, None, None, tried)


def _forces(states: tuple[State, ...], springs: list[Pair]) -> list[Pair]:
    """Return the forces of contacts in these states."""
    return [
        (_ZERO if state == "detached" else normal, tangential if state == "stick" else _ZERO)
        for state, (normal, tangential) in zip(states, springs, strict=True)
    ]


def _legal_rows(
    grasp: Grasp, states: tuple[State, ...], springs: list[Pair], gap: bool = True
) -> Iterator[RationalVector]:
    """Yield the conditions that make the forces of the states legal."""
    for contact, state, pair in zip(grasp, states, springs, strict=True):
        if state == "stick":
            yield from force_rows(contact, pair)
        elif state == "slip":
            yield pair[0]
        elif gap:
            yield negated(pair[0])


def _decide(grasp: Grasp, wrench: RationalVector) -> Outcome:
    springs, remark = usual_springs(grasp)
    return _decided(grasp, wrench, springs).accepts, remark


@cut
def _region(grasp: Grasp) -> Iterator[Polyhedron | None]:
    springs, _ = usual_springs(grasp)
    for states in product(STATES, repeat=len(grasp)):
        forces, rows = _forces(states, springs), _legal_rows(grasp, states, springs)
        yield balanced_wrenches(grasp, forces, rows)


FRICTIONLESS_SLIP = Method(
    "frictionless-slip",
    "stick, frictionless slip, detached (Prattichizzo 1997)",
    "frictionless slip",
    _decide,
    _region,
    most_contacts=8,
)
