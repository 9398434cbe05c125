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
from arrangement.console.number_form import counted
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.polyhedron import Polyhedron
from arrangement.numbers.linear.programs import some_point
from equilibrium.core.contact_rows import Pair, balance_rows, negated, normal_force_row, unit_row
from equilibrium.methods.method import Accepting, Method, Outcome, cut
from equilibrium.methods.springs import Forces, force_rows, forces_at
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.wrench_sets.polyhedra import StateImages


@dataclass(frozen=True)
class ConesVerdict(Accepting):
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
    tried, n = 0, 3 + len(grasp)
    budget.check_cost(f"a linear program in {n} variables", "leave out contacts", steps=1.5 * n**3)
    choices = [(True,) * len(grasp)] if printed else _attached_choices(grasp)
    for tried, attached in enumerate(choices, 1):
        pairs, rows = _program(grasp, attached)
        point = some_point(n, rows, balance_rows(grasp, pairs, applied, n)[0])
        if point is not None:
            return ConesVerdict(True, point[:3], forces_at(pairs, point), tried)
    return ConesVerdict(False, None, None, tried)


def _attached_choices(grasp: Grasp) -> Iterator[tuple[bool, ...]]:
    """Yield which contacts are attached, for every region of the normal planes."""
    springs = [contact for contact in grasp if contact.stiffness]
    planes = Arrangement(
        [[contact.stiffness * x for x in contact.normal_wrench] for contact in springs],
        [contact.preload for contact in springs],
        dimension=3,
    )
    for region in planes.regions():
        signs = iter(region.signs)
        yield tuple(not contact.stiffness or next(signs) < 0 for contact in grasp)


def _program(grasp: Grasp, attached: Sequence[bool]) -> tuple[list[Pair], list[RationalVector]]:
    """Return forces and conditions as rows in the motion and a friction force a contact."""
    n = 3 + len(grasp)
    pairs: list[Pair] = []
    rows: list[RationalVector] = []
    for column, (contact, touches) in enumerate(zip(grasp, attached, strict=True), 3):
        normal, friction = normal_force_row(contact, n), unit_row(column, n)
        if touches:
            pairs.append((normal, friction))
            rows += force_rows(contact, pairs[-1])
        else:
            pairs.append(((Fraction(0),) * (n + 1),) * 2)
            rows.append(negated(normal))
    return pairs, rows


def _decide(grasp: Grasp, wrench: RationalVector) -> Outcome:
    found = cones(grasp, wrench)
    return found.accepts, f"{counted(found.tried, 'choice')} of attached contacts tried"


@cut
def _region(grasp: Grasp) -> Iterator[Polyhedron | None]:
    """Yield one polyhedron for each choice of attached contacts."""
    images = StateImages(grasp)
    for choice in _attached_choices(grasp):
        yield images.resisted_with(["attached" if touches else "detached" for touches in choice])


CONES = Method(
    "cones",
    "springs and cones without dissipation",
    "springs and cones only",
    _decide,
    _region,
)
