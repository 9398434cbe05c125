"""The complete decision: does a grasp hold a wrench passively, and in which ways.

Model: a motion d and forces with, at every contact, ``c_n = max(0, preload - stiffness N . d)``,
``|c_t| <= friction c_n``, maximum dissipation (``T . d > 0`` gives ``c_t = -friction c_n``,
``T . d < 0`` gives ``+friction c_n``), and ``sum (c_n N + c_t T) + w = 0``. Every equilibrium
satisfies the conditions of one of `contact_states`, which are linear; so solving one system for
each decides the question, with no bound on the motion and no tolerance. A quick search may find a
stable answer first. Only the complete enumeration says that there is none.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from arrangement.exact import RationalVector, to_text
from arrangement.progress import watched

from .certificate.regions_checker import Reason, Report, check
from .certificate.regions_document import (
    Certificate,
    regions_text,
    stable_certificate,
    unstable_certificate,
)
from .draw.notebook import verdict_html
from .model.grasp import Grasp, read_wrench
from .solver.all_stick import rest_refutation
from .solver.contact_states import Codes, letters_of_codes, motion_faces, states_at, states_of_code
from .solver.elimination import Continuum, Point, Refutation, decide, point_with_idle
from .solver.equilibrium import Equilibrium, equilibrium_of, maximal
from .solver.float_contacts import Integers
from .solver.interval_filter import CONDITIONS, UNDECIDED, screen_of
from .solver.lemke import likely_states
from .solver.refutations import balances_of
from .solver.state_system import StateSystem, state_system, value


@dataclass(frozen=True)
class Solution:
    """One equilibrium: the motion, and the (normal, tangential) force at each contact."""

    motion: RationalVector
    forces: tuple[tuple[Fraction, Fraction], ...]


@dataclass(frozen=True)
class Verdict:
    """The answer for one grasp and wrench, with what is needed to check it.

    Attributes:
        grasp, wrench: the question.
        solution: the equilibrium that the certificate shows; None when there is none.
    """

    grasp: Grasp
    wrench: RationalVector
    solution: Solution | None

    @property
    def stable(self) -> bool:
        """Whether at least one equilibrium exists."""
        return self.solution is not None

    @cached_property
    def equilibria(self) -> tuple[Equilibrium, ...]:
        """The maximal pieces of the set of all solutions; empty when unstable.

        Pieces may touch; none lies in another. Of a piece with many solutions, the reported one
        has the least ``|d|^2``, and among those the least ``|c|^2``, both exact.
        """
        if self.solution is None:
            return ()
        return _all_equilibria(self.grasp, self.wrench)

    @cached_property
    def certificate(self) -> Certificate:
        """The proof, checkable without the solver."""
        if self.solution is not None:
            shown = self.solution
            return stable_certificate(self.grasp, self.wrench, shown.motion, shown.forces)
        reasons = _reasons(self.grasp, self.wrench)
        return unstable_certificate(self.grasp, self.wrench, _regions(self.grasp), reasons)

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

    def _repr_html_(self) -> str:
        """What a notebook shows: every equilibrium with its forces."""
        return verdict_html(self.grasp, self.wrench, self.equilibria)


def solve(grasp: Grasp, wrench: Iterable[Any]) -> Verdict:
    """Decide exactly whether a grasp holds a wrench; the verdict finds all ways when asked.

    Args:
        grasp: contacts in the object frame.
        wrench: applied force x, force y and torque about the origin.

    Complexity: one linear system of at most 3 + m unknowns for each of the contact states:
    O(m^2) of them without preload, O(m^3) with; most are decided in floating point with a proven
    error bound, the others and every solution in rationals. The states of a grasp are kept for the
    next wrench. Source: [HaasHeger2018], Algorithm 2, completed.

    >>> from equilibrium.io.files import read_grasp
    >>> solve(read_grasp("paper-three-contacts-preload-1"), [0, 1, 0]).stable
    True
    """
    applied = read_wrench(wrench)
    found = _quick_solution(grasp, applied)
    if found is not None:
        return Verdict(grasp, applied, found)
    pieces = _all_equilibria(grasp, applied)
    if pieces:
        verdict = Verdict(grasp, applied, Solution(pieces[0].motion, pieces[0].forces))
        verdict.__dict__["equilibria"] = pieces
        return verdict
    return Verdict(grasp, applied, None)


def _quick_solution(grasp: Grasp, wrench: RationalVector) -> Solution | None:
    """Return an equilibrium if the float search leads to one; exact, and checked exactly."""
    guess = likely_states(grasp, wrench)
    if guess is None:
        return None
    system = state_system(grasp, guess.states, wrench)
    z = point_with_idle(system, guess.idle)
    if z is None:
        return None
    forces = tuple((value(c_n, z), value(c_t, z)) for c_n, c_t in system.forces)
    return Solution(z[:3], forces)


@dataclass(frozen=True)
class _Enumeration:
    """What became of each choice of contact states.

    Attributes:
        codes: the choices.
        violated: for each the condition of `Screen.violations`, or `UNDECIDED`.
        refuted: exact refutations of undecided ones, by row.
        open: the systems of the others with their solutions.
    """

    codes: Codes
    violated: Integers
    refuted: dict[int, Refutation]
    open: tuple[tuple[StateSystem, Point | Continuum], ...]


@lru_cache(maxsize=4)
def _enumerate(grasp: Grasp, wrench: RationalVector) -> _Enumeration:
    """Decide every choice of contact states."""
    screen, balances = screen_of(grasp), balances_of(grasp)
    violated = screen.violations(wrench)
    refuted: dict[int, Refutation] = {}
    solved: list[tuple[StateSystem, Point | Continuum]] = []
    for row in watched(np.flatnonzero(violated == UNDECIDED).tolist(), "contact states"):
        states = states_of_code(screen.codes[row].tolist())
        refutation = balances.refutation(wrench, states)
        refutation = refutation or rest_refutation(grasp, wrench, states)
        if refutation is None:
            system = state_system(grasp, states, wrench)
            outcome = decide(system)
            if not isinstance(outcome, Refutation):
                solved.append((system, outcome))
                continue
            refutation = outcome
        refuted[row] = refutation
    return _Enumeration(screen.codes, violated, refuted, tuple(solved))


def _all_equilibria(grasp: Grasp, wrench: RationalVector) -> tuple[Equilibrium, ...]:
    """Return the maximal pieces of all solutions.

    The states at a motion on the border of normal planes may be none of `contact_states`; where
    they hold more of the solutions, theirs is the piece to report.
    """
    pieces = [equilibrium_of(*found) for found in _enumerate(grasp, wrench).open]
    known = {piece.states for piece in pieces}
    for piece in pieces:
        states = states_at(grasp, piece.motion)
        if states not in known:
            known.add(states)
            system = state_system(grasp, states, wrench)
            outcome = decide(system)
            if not isinstance(outcome, Refutation):
                pieces.append(equilibrium_of(system, outcome))
    return maximal(pieces)


def _reasons(grasp: Grasp, wrench: RationalVector) -> Iterator[tuple[str, Reason]]:
    """Yield the reason why each choice of contact states admits no equilibrium."""
    done, m = _enumerate(grasp, wrench), len(grasp)
    names = [f"{kind} {contact}" for kind in CONDITIONS for contact in range(m)]
    listed = zip(letters_of_codes(done.codes), done.violated.tolist(), strict=True)
    for row, (letters, index) in enumerate(listed):
        if index == UNDECIDED:
            refutation = done.refuted[row]
            yield letters, (refutation.inequalities, refutation.equalities)
        else:
            yield letters, names[index]


@lru_cache(maxsize=2)
def _regions(grasp: Grasp) -> str:
    """Return the regions as they stand in certificates; kept for the next wrench."""
    faces = motion_faces(grasp)
    signs, points = faces.plane_signs(faces.regions), faces.integer_witnesses()
    return regions_text(signs, points.tolist())
