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
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from arrangement.exact import RationalVector, to_text
from arrangement.plugins import display
from arrangement.progress import watched

from .certificate.regions_checker import Reason, Report, check
from .certificate.regions_document import (
    Certificate,
    regions_text,
    stable_certificate,
    unstable_certificate,
)
from .model.grasp import Grasp, read_wrench
from .solver.all_stick import rest_refutation
from .solver.contact_states import Codes, letters_of_codes, states_at, states_of_code
from .solver.elimination import Continuum, Point, Refutation, decide, point_with_idle
from .solver.equilibrium import Equilibrium, equilibrium_of, maximal
from .solver.float_contacts import Integers
from .solver.interval_filter import CONDITIONS, UNDECIDED
from .solver.lemke import likely_states
from .solver.prepared import PreparedGrasp
from .solver.state_system import StateSystem, value


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
    _solver: Solver = field(repr=False, compare=False)
    _decided: _Enumeration | None = field(default=None, repr=False, compare=False)

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
        return () if self.solution is None else self._enumeration.pieces

    @cached_property
    def _enumeration(self) -> _Enumeration:
        return self._decided or self._solver._enumerate(self.wrench)

    @cached_property
    def certificate(self) -> Certificate:
        """The proof, checkable without the solver."""
        if self.solution is not None:
            shown = self.solution
            return stable_certificate(self.grasp, self.wrench, shown.motion, shown.forces)
        reasons, regions = self._enumeration.reasons(), self._solver._regions
        return unstable_certificate(self.grasp, self.wrench, regions, reasons)

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

    def _repr_html_(self) -> str | None:
        """What a notebook shows: every equilibrium with its forces."""
        return display("verdict-html", self)


def solve(grasp: Grasp, wrench: Iterable[Any]) -> Verdict:
    """Decide exactly whether a grasp resists a wrench; the verdict finds all ways when asked.

    Args:
        grasp: contacts in the object frame.
        wrench: applied force x, force y and torque about the origin.

    Complexity: one linear system of at most 3 + m unknowns for each of the contact states:
    O(m^2) of them without preload, O(m^3) with; most are decided in floating point with a proven
    error bound, the others and every solution in rationals. A `Solver` keeps the states for the
    next wrench. Source: [HaasHeger2018], Algorithm 2, completed.

    >>> from equilibrium.io.files import read_grasp
    >>> solve(read_grasp("paper-three-contacts-preload-1"), [0, 1, 0]).stable
    True
    """
    return Solver(grasp).solve(wrench)


class Solver(PreparedGrasp):
    """A grasp prepared for many wrenches: what one question computes serves the next.

    Every function about the wrenches that a grasp resists takes a solver in place of the grasp.

    >>> from equilibrium.io.files import read_grasp
    >>> solver = Solver(read_grasp("paper-three-contacts-preload-1"))
    >>> [verdict.stable for verdict in solver.solve_many([[0, 1, 0], [0, 2, 0]])]
    [True, False]
    """

    def solve(self, wrench: Iterable[Any]) -> Verdict:
        """Decide one wrench; see the function `solve`."""
        applied = read_wrench(wrench)
        found = self._quick_solution(applied)
        if found is not None:
            return Verdict(self.grasp, applied, found, self)
        decided = self._enumerate(applied)
        if decided.pieces:
            found = Solution(decided.pieces[0].motion, decided.pieces[0].forces)
        return Verdict(self.grasp, applied, found, self, decided)

    def solve_many(self, wrenches: Iterable[Iterable[Any]]) -> Iterator[Verdict]:
        """Decide one wrench after the other."""
        return map(self.solve, wrenches)

    def _quick_solution(self, wrench: RationalVector) -> Solution | None:
        """Return an equilibrium if the float search leads to one; exact, and checked exactly."""
        guess = likely_states(self.grasp, wrench)
        if guess is None:
            return None
        system = self.system(guess.states, wrench)
        z = point_with_idle(system, guess.idle)
        if z is None:
            return None
        forces = tuple((value(c_n, z), value(c_t, z)) for c_n, c_t in system.forces)
        return Solution(z[:3], forces)

    def _enumerate(self, wrench: RationalVector) -> _Enumeration:
        """Decide every choice of contact states."""
        violated = self.screen.violations(wrench)
        refuted: dict[int, Refutation] = {}
        solved: list[tuple[StateSystem, Point | Continuum]] = []
        for row in watched(np.flatnonzero(violated == UNDECIDED).tolist(), "contact states"):
            states = states_of_code(self.codes[row].tolist())
            refutation = self.balances.refutation(wrench, states)
            refutation = refutation or rest_refutation(self.grasp, wrench, states)
            if refutation is None:
                system = self.system(states, wrench)
                outcome = decide(system)
                if not isinstance(outcome, Refutation):
                    solved.append((system, outcome))
                    continue
                refutation = outcome
            refuted[row] = refutation
        return _Enumeration(self.codes, violated, refuted, self._maximal(solved, wrench))

    def _maximal(
        self, solved: list[tuple[StateSystem, Point | Continuum]], wrench: RationalVector
    ) -> tuple[Equilibrium, ...]:
        """Return the maximal pieces of all solutions.

        The states at a motion on the border of normal planes may be none of the choices; where
        they hold more of the solutions, theirs is the piece to report.
        """
        pieces = [equilibrium_of(*found) for found in solved]
        known = {piece.states for piece in pieces}
        for piece in pieces:
            states = states_at(self.grasp, piece.motion)
            if states not in known:
                known.add(states)
                system = self.system(states, wrench)
                outcome = decide(system)
                if not isinstance(outcome, Refutation):
                    pieces.append(equilibrium_of(system, outcome))
        return maximal(pieces)

    @cached_property
    def _regions(self) -> str:
        """The regions as they stand in certificates."""
        faces = self.faces
        signs, points = faces.plane_signs(faces.regions), faces.integer_witnesses()
        return regions_text(signs, points.tolist())


def prepare(grasp: Grasp | Solver) -> Solver:
    """Return the solver of a grasp; a solver is returned as it is."""
    return grasp if isinstance(grasp, Solver) else Solver(grasp)


@dataclass(frozen=True)
class _Enumeration:
    """What became of each choice of contact states.

    Attributes:
        codes: the choices.
        violated: for each the condition of `Screen.violations`, or `UNDECIDED`.
        refuted: exact refutations of undecided ones, by row.
        pieces: the maximal pieces of the solutions of the others.
    """

    codes: Codes
    violated: Integers
    refuted: dict[int, Refutation]
    pieces: tuple[Equilibrium, ...]

    def reasons(self) -> Iterator[tuple[str, Reason]]:
        """Yield the reason why each choice of contact states admits no equilibrium."""
        contacts = range(self.codes.shape[1])
        names = [f"{kind} {contact}" for kind in CONDITIONS for contact in contacts]
        listed = zip(letters_of_codes(self.codes), self.violated.tolist(), strict=True)
        for row, (letters, index) in enumerate(listed):
            if index == UNDECIDED:
                refutation = self.refuted[row]
                yield letters, (refutation.inequalities, refutation.equalities)
            else:
                yield letters, names[index]
