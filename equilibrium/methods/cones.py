"""Friction cones without dissipation: Eqs. 1 to 4 of [HaasHeger2018].

Normal forces arise from the springs, friction is bound by its cone alone and need not oppose the
motion. The paper shows by a picture why this accepts too much: a motion that no one asked for may
load the contacts.

The normal force is piecewise linear in the motion and continuous, so the closed regions of the
normal planes ``stiffness N . d = preload`` cover all motions with one linear program each.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.polyhedron import Polyhedron
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.methods.method import Method, Outcome, cut
from equilibrium.methods.springs import StatesVerdict
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.rows import ContactRows
from equilibrium.wrench_sets.polyhedra import StateImages


def cones(grasp: Grasp, wrench: Iterable[Any], *, printed: bool = False) -> StatesVerdict:
    """Decide exactly whether springs and cones, without dissipation, can balance a wrench.

    Args:
        grasp: contacts.
        wrench: applied.
        printed: read Eq. 4 as the equality that is printed, so that no contact may let go.

    Complexity: one linear program in 3 + m variables for each region, of which m planes have
    O(m^3); one in all if `printed`.
    """
    applied, n = read_wrench(wrench), 3 + len(grasp)
    budget.check_cost(f"a linear program in {n} variables", "leave out contacts", steps=1.5 * n**3)
    question = LinearQuestion(ContactRows.of_grasp(grasp), applied)
    tried = 0
    every = [("attached",) * len(grasp)] if printed else _states(grasp)
    for tried, states in enumerate(every, 1):
        if (solution := ContactProgram(question, states).solution()) is not None:
            return StatesVerdict(True, states, solution.motion, solution.forces, tried)
    return StatesVerdict(False, None, None, None, tried)


def _states(grasp: Grasp) -> Iterator[tuple[str, ...]]:
    """Yield which contacts are attached, for every region of the normal planes."""
    springs = [contact for contact in grasp if contact.stiffness]
    planes = Arrangement(
        [[contact.stiffness * x for x in contact.normal_wrench] for contact in springs],
        [contact.preload for contact in springs],
        dimension=3,
    )
    for region in planes.regions():
        signs = iter(region.signs)
        touches = (not contact.stiffness or next(signs) < 0 for contact in grasp)
        yield tuple("attached" if touch else "detached" for touch in touches)


def _decide(grasp: Grasp, wrench: RationalVector) -> Outcome:
    verdict = cones(grasp, wrench)
    return verdict.accepts, f"{counted(verdict.tried, 'choice')} of attached contacts tried"


@cut
def _region(grasp: Grasp) -> Iterator[Polyhedron | None]:
    """Yield one polyhedron for each choice of attached contacts."""
    return map(StateImages(grasp).resisted_with, _states(grasp))


CONES = Method(
    "cones",
    "springs and cones without dissipation",
    "springs and cones only",
    _decide,
    _region,
)
