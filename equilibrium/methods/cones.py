"""Friction cones without dissipation: Eqs. 1 to 4 of [HaasHeger2018].

Normal forces arise from the springs, friction is bound by its cone alone and need not oppose the
motion. The paper shows by a picture why this accepts too much: a motion that no one asked for may
load the contacts.

The normal force is piecewise linear in the motion and continuous, so the closed regions of the
normal planes ``stiffness N . d = preload`` cover all motions with one linear program each.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.exact import RationalVector
from arrangement.linprog import Infeasible, Row, feasible_point
from equilibrium.model.grasp import Grasp, read_wrench

from .springs import Forces, Form, normal_form, value


@dataclass(frozen=True)
class ConesVerdict:
    """Whether some motion and friction inside the cones balance a wrench.

    Attributes:
        accepts: they exist.
        motion, forces: an example, else None.
        tried: how many choices of attached contacts were looked at.
    """

    accepts: bool
    motion: RationalVector | None
    forces: Forces | None
    tried: int


def cones(grasp: Grasp, wrench: Iterable[Any], *, printed: bool = False) -> ConesVerdict:
    """Decide exactly whether springs and cones, without dissipation, can balance a wrench.

    Args:
        grasp: contacts.
        wrench: applied.
        printed: read Eq. 4 as the equality that is printed, so that no contact may let go.

    Complexity: one linear program in 3 + m variables for each region, of which m planes have
    O(m^3); one in all if `printed`.
    """
    applied = read_wrench(wrench)
    tried = 0
    for attached in [(True,) * len(grasp)] if printed else attached_choices(grasp):
        tried += 1
        point = feasible_point(3 + len(grasp), *_program(grasp, applied, attached))
        if not isinstance(point, Infeasible):
            motion = point[:3]
            forces = tuple(
                (value(normal_form(contact), motion), friction) if touches else (Fraction(0),) * 2
                for contact, friction, touches in zip(grasp, point[3:], attached, strict=True)
            )
            return ConesVerdict(True, motion, forces, tried)
    return ConesVerdict(False, None, None, tried)


def attached_choices(grasp: Grasp) -> Iterator[tuple[bool, ...]]:
    """Yield which contacts are attached, for every region of the normal planes."""
    planes = Arrangement(
        [[contact.stiffness * x for x in contact.normal_wrench] for contact in grasp],
        [contact.preload for contact in grasp],
        dimension=3,
    )
    for region in planes.regions():
        yield tuple(sign < 0 for sign in region.signs)


def _program(
    grasp: Grasp, wrench: RationalVector, attached: Sequence[bool]
) -> tuple[list[Row], list[Row]]:
    """Return inequalities and equalities over the motion and one friction force each."""
    m = len(grasp)
    inequalities: list[Row] = []
    balance = [[Fraction(0)] * (3 + m) + [wrench[k]] for k in range(3)]
    for i, (contact, touches) in enumerate(zip(grasp, attached, strict=True)):
        normal = normal_form(contact)
        if not touches:
            inequalities.append(_wide(m, [-x for x in normal]))
            continue
        inequalities.append(_wide(m, normal))
        edge = [contact.friction * x for x in normal]
        inequalities += [_wide(m, edge, i, side) for side in (1, -1)]
        for k in range(3):
            for j, x in zip((0, 1, 2, -1), normal, strict=True):
                balance[k][j] += contact.normal_wrench[k] * x
            balance[k][3 + i] += contact.tangential_wrench[k]
    return inequalities, list(balance)


def _wide(m: int, form: Form | list[Fraction], i: int = 0, side: int = 0) -> Row:
    """Return a form of the motion, plus `side` times friction force i, as a row."""
    friction = [Fraction(side * int(i == j)) for j in range(m)]
    return [*form[:3], *friction, form[-1]]
