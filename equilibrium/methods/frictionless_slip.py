"""Stick, slip without friction, or detached: the extended compliance of [Prattichizzo1997].

Each contact is in one of three states. Stick: linear springs in both directions, the force inside
the cone. Slip: the normal spring alone, no friction force at all. Detached: no force. Every one of
the 3^m choices of states gives one linear system in the motion; the method accepts when some
choice has a legal solution.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import product
from typing import Any, Literal

from arrangement.exact import RationalVector
from arrangement.linprog import Infeasible, Row, feasible_point
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench

from .springs import (
    ZERO,
    Forces,
    Form,
    balance_rows,
    cone_rows,
    normal_form,
    rest_forces,
    tangential_form,
    tangential_stiffnesses,
    value,
)

State = Literal["stick", "slip", "detached"]
STATES: tuple[State, ...] = ("stick", "slip", "detached")
#: More contacts than this are refused: 3^12 systems are half a million.
MAX_CONTACTS = 12


@dataclass(frozen=True)
class FrictionlessSlipVerdict:
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
        grasp: at most `MAX_CONTACTS` contacts.
        wrench: applied.
        tangential_stiffness, rest_friction: as in `linear_compliance`.
        gap: a contact counts as detached only where its normal spring would pull. Without this a
            contact that is pressed together may be said to carry nothing.

    Raises:
        GraspError: too many contacts.
    """
    if len(grasp) > MAX_CONTACTS:
        raise GraspError(
            f"{len(grasp)} contacts are too many for 3^m choices; at most {MAX_CONTACTS} are tried"
        )
    applied = read_wrench(wrench)
    stiffnesses = tangential_stiffnesses(grasp, tangential_stiffness)
    rest = rest_forces(grasp, rest_friction)
    springs = [
        (normal_form(contact), tangential_form(contact, k, t))
        for contact, k, t in zip(grasp, stiffnesses, rest, strict=True)
    ]
    tried = 0
    for states in product(STATES, repeat=len(grasp)):
        tried += 1
        forms = [forms_of(state, pair) for state, pair in zip(states, springs, strict=True)]
        rows = list(legal_rows(grasp, states, springs, gap))
        motion = feasible_point(3, rows, balance_rows(grasp, forms, applied))
        if not isinstance(motion, Infeasible):
            forces = tuple((value(n, motion), value(t, motion)) for n, t in forms)
            return FrictionlessSlipVerdict(True, states, motion, forces, tried)
    return FrictionlessSlipVerdict(False, None, None, None, tried)


def forms_of(state: State, springs: tuple[Form, Form]) -> tuple[Form, Form]:
    """Return the two forces of a contact in a state."""
    if state == "stick":
        return springs
    return (springs[0], ZERO) if state == "slip" else (ZERO, ZERO)


def legal_rows(
    grasp: Grasp, states: tuple[State, ...], springs: list[tuple[Form, Form]], gap: bool
) -> Iterator[Row]:
    """Yield the conditions that make the forces of the states legal."""
    for contact, state, (normal, tangential) in zip(grasp, states, springs, strict=True):
        if state == "stick":
            yield from cone_rows(contact, normal, tangential)
        elif state == "slip":
            yield normal
        elif gap:
            yield [-x for x in normal]
