"""The decision in space: does a grasp hold a wrench passively?

Model: a motion ``d = (v, omega)`` and forces with, at every contact, ``c_n = max(0, preload -
stiffness N . d)``, ``|c_t| <= friction c_n`` (a round cone), maximum dissipation (a contact that
slips by s = T d has ``c_t = -friction c_n s / |s|``), and balance of all forces and torques. The
cone is curved, so equilibria need not have rational numbers, and on a border neither of the two
proofs may close: then the answer is "undecided".
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import partial
from typing import Any

from arrangement.numbers.exact import RationalVector, to_text, vector_text
from equilibrium.certificate.checker import Report, check
from equilibrium.certificate.document import (
    Certificate,
    enclosed_certificate,
    refuted_certificate,
    resisted_certificate,
)
from equilibrium.certificate.reading import Enclosure
from equilibrium.decide import (
    NOT_RESISTED as NOT_RESISTED,
    RESISTED as RESISTED,
    UNDECIDED as UNDECIDED,
)
from equilibrium.model.contact import pyramid_edges, pyramid_words
from equilibrium.model.errors import UndecidedError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.range import NO_RANGE, Range
from equilibrium.plane.contacts import SpatialContacts
from equilibrium.space.cones import Pyramids
from equilibrium.space.equilibria import Proposal, SpatialSolution
from equilibrium.space.tree import NODES, Open, SpatialSearch

from .robustness import AskedAgain, Solve


@dataclass(frozen=True)
class SpatialVerdict(AskedAgain):
    """The answer for one grasp in space and wrench, with what is needed to check it.

    Attributes:
        grasp, wrench: the question.
        verdict: "resisted", "not resisted" or "undecided"; the first two are proved.
        solution: the equilibrium that the certificate shows: exact, or a box that has exactly one.
        certificate: the proof; None when undecided.
        reason: why it is undecided; else empty.
        residual: when undecided, the least force that is left over at the best motion found, as a
            share of the largest force given.
        pyramid: edges of the friction pyramids asked for; None for round cones.
        within: the range in which equilibria count.
    """

    grasp: Grasp
    wrench: RationalVector
    verdict: str
    solution: Proposal | None = field(default=None, repr=False)
    certificate: Certificate | None = field(default=None, repr=False)
    reason: str = ""
    residual: float = 0.0
    pyramid: int | None = None
    within: Range = NO_RANGE

    def __repr__(self) -> str:
        wrench = vector_text(self.wrench)
        cones = pyramid_words(self.pyramid, before=", ")
        number = f"{len(self.grasp)} contacts in space"
        return f"<Verdict: {self.verdict}, wrench {wrench}, {number}{cones}>"

    @property
    def decided(self) -> bool:
        """Whether there is a proof."""
        return self.verdict != UNDECIDED

    @property
    def stable(self) -> bool:
        """Whether the wrench is resisted.

        Raises:
            UndecidedError: that is not known.
        """
        if not self.decided:
            raise UndecidedError(
                f"whether the wrench {vector_text(self.wrench)} is resisted is undecided: "
                f"{self.reason}; ask `verdict` for the three answers"
            )
        return self.verdict == RESISTED

    def __bool__(self) -> bool:
        """Return whether the wrench is resisted; an undecided verdict raises UndecidedError."""
        return self.stable

    @property
    def states(self) -> tuple[str, ...]:
        """The state of each contact at the equilibrium shown; none when there is none."""
        if self.solution is None:
            return ()
        if not isinstance(self.solution, SpatialSolution):
            shares = self.solution.friction
            return tuple("detached" if x is None else "stick" if x else "slip" for x in shares)
        found = []
        for contact, force in zip(self.grasp, self.solution.forces, strict=True):
            moves = any(
                sum(x * y for x, y in zip(row, self.solution.motion, strict=True))
                for row in contact.tangential_wrenches
            )
            found.append("detached" if not force[0] else "slip" if moves else "stick")
        return tuple(found)

    def verify(self) -> Report:
        """Check the certificate, and that it answers this question; the report is true if so.

        Raises:
            UndecidedError: there is no certificate.
        """
        if self.certificate is None:
            raise UndecidedError(f"an undecided verdict has no certificate: {self.reason}")
        question = self.grasp, self.wrench
        document = self.certificate.to_dict()
        return check(document, question=question, pyramid=self.pyramid, within=self.within)

    @property
    def again(self) -> Solve:
        """What decides other grasps in the same way."""
        return partial(solve_in_space, pyramid=self.pyramid, **self.within.bounds)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; exact numbers are strings of rationals.

        An equilibrium that has no rational numbers is given in floats, with ``"exact": false``; the
        certificate has the box that holds it.
        """
        document: dict[str, Any] = {"verdict": self.verdict}
        if self.pyramid is not None:
            document["pyramid"] = self.pyramid
        if self.solution is not None:
            exact = isinstance(self.solution, SpatialSolution)
            form: Any = to_text if exact else float
            document |= {
                "states": list(self.states),
                "motion": [form(x) for x in self.solution.motion],
                "forces": [[form(x) for x in force] for force in self.solution.forces],
                "exact": exact,
            }
        if not self.decided:
            document |= {"reason": self.reason, "residual": self.residual}
        if self.warnings:
            document["warnings"] = list(self.warnings)
        question = {"wrench": [to_text(x) for x in self.wrench], "grasp": self.grasp.to_dict()}
        return self._with_rounding(document | self.within.to_dict() | question)


def solve_in_space(
    grasp: Grasp,
    wrench: Iterable[Any],
    *,
    time_limit: float | None = None,
    nodes: int = NODES,
    pyramid: int | None = None,
    largest_turn: Any = None,
    largest_force: Any = None,
) -> SpatialVerdict:
    """Decide whether a grasp in space resists a wrench; see `equilibrium.solve`.

    Args:
        time_limit: in seconds; when it is over the verdict is undecided.
        nodes: of a tree; when they do not do the verdict is undecided.
        pyramid: edges of a friction pyramid in place of the round cone, see `pyramid_edges`; then
            every verdict is decided, exactly, if nodes and time do.
        largest_turn, largest_force: see `equilibrium.solve`.

    >>> from equilibrium.grasps.files import read_grasp
    >>> solve_in_space(read_grasp("two-opposed-fingers"), [0, "3/5", "4/5", 0, 0, 0]).verdict
    'resisted'
    """
    applied = read_wrench(wrench, grasp.dimension)
    within = Range.of(largest_turn, largest_force)
    deadline = math.inf if time_limit is None else time.monotonic() + time_limit
    cones = None if pyramid is None else Pyramids(pyramid_edges(pyramid))

    def accept(found: Proposal) -> bool:
        return bool(_certificate(grasp, applied, found, pyramid, within).verify())

    contacts = SpatialContacts(grasp)
    search = SpatialSearch(contacts, applied, accept, deadline, nodes, within, cones)
    return _verdict(grasp, applied, search.decide(), pyramid, within)


def _verdict(
    grasp: Grasp,
    applied: RationalVector,
    found: Any,
    pyramid: int | None = None,
    within: Range = NO_RANGE,
) -> SpatialVerdict:
    if isinstance(found, Open):
        return SpatialVerdict(
            grasp,
            applied,
            UNDECIDED,
            reason=found.reason,
            residual=found.residual,
            pyramid=pyramid,
            within=within,
        )
    if isinstance(found, (dict, list)):
        certificate, answer = (
            refuted_certificate(grasp, applied, found, pyramid, within),
            NOT_RESISTED,
        )
        found = None
    else:
        certificate, answer = _certificate(grasp, applied, found, pyramid, within), RESISTED
    return SpatialVerdict(
        grasp, applied, answer, found, certificate, pyramid=pyramid, within=within
    )


def _certificate(
    grasp: Grasp,
    wrench: RationalVector,
    found: Proposal,
    pyramid: int | None = None,
    within: Range = NO_RANGE,
) -> Certificate:
    if isinstance(found, SpatialSolution):
        return resisted_certificate(grasp, wrench, found.motion, found.forces, pyramid, within)
    box = Enclosure(
        found.basis,
        found.friction,
        found.pillars,
        found.centre,
        found.radius,
        found.inverse,
        found.idle,
    )
    return enclosed_certificate(grasp, wrench, box, within)
