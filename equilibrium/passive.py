"""The complete decision: does a grasp hold a wrench passively, and in which ways.

Model: a motion d and forces with, at every contact, ``c_n = max(0, preload - stiffness N . d)``,
``|c_t| <= friction c_n``, maximum dissipation (``T . d > 0`` gives ``c_t = -friction c_n``,
``T . d < 0`` gives ``+friction c_n``), and ``sum (c_n N + c_t T) + w = 0``. Every d has its contact
states among `contact_states`, and for fixed states the conditions are linear; so solving one
system for each decides the question, with no bound on the motion and no tolerance.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from arrangement.exact import RationalVector, to_text

from .certificate import Certificate, Report, check, stable_certificate, unstable_certificate
from .elimination import Refutation, decide
from .grasp import Grasp, read_wrench
from .pieces import Equilibrium, equilibrium_of, maximal
from .states import States, contact_states, motion_faces, state_system


@dataclass(frozen=True)
class Verdict:
    """The answer for one grasp and wrench, with what is needed to check it.

    Attributes:
        grasp, wrench: the question.
        equilibria: the maximal pieces of the set of all solutions; empty when unstable. Pieces
            may touch; none lies in another.
        refutations: the Farkas vector of each choice of states that has no solution.
    """

    grasp: Grasp
    wrench: RationalVector
    equilibria: tuple[Equilibrium, ...]
    refutations: tuple[tuple[States, Refutation], ...] = field(repr=False)

    @property
    def stable(self) -> bool:
        """Whether at least one equilibrium exists."""
        return bool(self.equilibria)

    @cached_property
    def certificate(self) -> Certificate:
        """The proof, checkable without the solver."""
        if self.equilibria:
            first = self.equilibria[0]
            return stable_certificate(self.grasp, self.wrench, first.motion, first.forces)
        return unstable_certificate(
            self.grasp,
            self.wrench,
            motion_faces(self.grasp),
            [(states, r.inequalities, r.equalities) for states, r in self.refutations],
        )

    def verify(self) -> Report:
        """Check the certificate, and that it answers this question; the report is true if so."""
        return check(self.certificate.to_dict(), question=(self.grasp, self.wrench))

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals."""
        return {
            "stable": self.stable,
            "equilibria": [piece.to_dict() for piece in self.equilibria],
            "wrench": [to_text(x) for x in self.wrench],
            "grasp": self.grasp.to_dict(),
        }


def solve(grasp: Grasp, wrench: Iterable[Any]) -> Verdict:
    """Decide exactly whether a grasp holds a wrench, and find all ways in which it does.

    Args:
        grasp: contacts in the object frame.
        wrench: applied force x, force y and torque about the origin.

    Returns:
        The verdict. Of a piece with many solutions, the reported one has the least ``|d|^2``, and
        among those the least ``|c|^2``, both exact.

    Complexity: one linear system of at most 3 + m unknowns for each of the contact states:
    O(m^2) of them without preload, O(m^3) with. Source: [HaasHeger2018], Algorithm 2, completed.

    >>> from equilibrium.files import read_grasp
    >>> bool(solve(read_grasp("paper-three-contacts-preload-1"), [0, 1, 0]).stable)
    True
    """
    applied = read_wrench(wrench)
    pieces: list[Equilibrium] = []
    refutations: list[tuple[States, Refutation]] = []
    for states in contact_states(grasp):
        system = state_system(grasp, states, applied)
        outcome = decide(system)
        if isinstance(outcome, Refutation):
            refutations.append((states, outcome))
        else:
            pieces.append(equilibrium_of(system, outcome))
    return Verdict(grasp, applied, maximal(pieces), tuple(refutations))
