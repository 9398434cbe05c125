"""The answer to one question: resisted, not resisted or undecided, in the plane and in space.

Model: a motion d and forces with, at every contact, ``c_n = max(0, preload - stiffness N . d)``,
``|c_t| <= friction c_n``, maximum dissipation (a contact that slips by ``s = T d`` has ``c_t =
-friction c_n s / |s|``), and ``sum ((c_n - adhesion) N + c_t T) + w = 0``. The answer is an
equilibrium, or a tree of virtual motions against which nothing balances the load. In space there
are two tangents and the cone is round, so equilibria need not have rational numbers, and on a
boundary neither proof may close: then the answer is "undecided".
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from arrangement.console.plugins import attached
from arrangement.errors import OutOfReachError
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import RationalVector, dot, to_text, vector_text
from equilibrium.certificate.checker import check, proof_problem
from equilibrium.certificate.document import Certificate, refuted_certificate, resisted_certificate
from equilibrium.certificate.report import Report
from equilibrium.model.contact import pyramid_edges, pyramid_words
from equilibrium.model.displacement import (
    displacement,
    displacement_entry,
    small_displacement,
    warning,
)
from equilibrium.model.effort import Effort
from equilibrium.model.errors import (
    CertificateError,
    EquilibriumError,
    TimeLimitError,
)
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Open, Outcome, Solution, Tree, pad_entries
from equilibrium.plane.states.contact_states import states_at
from equilibrium.plane.states.equilibrium import Equilibrium

from . import NOT_RESISTED, RESISTED, UNDECIDED, robustness
from .answer import AnswerMixin
from .proofs_for_all import NO_DEADLINE

if TYPE_CHECKING:
    from .solver import Solver

#: With more contacts all equilibria are listed only when asked for: their search takes long.
MAX_CONTACTS_LISTED = 20


@dataclass(frozen=True)
class Verdict(AnswerMixin):
    """The answer for one grasp and wrench, true when resisted, with what is needed to check it.

    Attributes:
        grasp, wrench: the question.
        verdict: "resisted", "not resisted" or, in space alone, "undecided"; the others are proved.
        solution: the equilibrium that the certificate shows; None when there is none.
        max_displacement: how far contact points may move for an equilibrium to count, if bounded.
        pyramid: in space, edges of the friction pyramids asked for; None for round cones.
        reason: why it is undecided; else empty.
        residual: when undecided, the least force that is left over at the best motion found, as a
            share of the largest force given.
    """

    grasp: Grasp
    wrench: RationalVector
    verdict: str
    solution: Solution | None
    _tree: Tree | None = field(repr=False, compare=False)
    _solver: Solver = field(repr=False, compare=False)
    max_displacement: Fraction | None = None
    pyramid: int | None = None
    reason: str = ""
    residual: float = 0.0
    _deadline: Deadline = field(default=NO_DEADLINE, repr=False, compare=False)

    _synonyms: ClassVar[Mapping[str, str]] = {
        "check": "verify()",
        "forces": "solution.forces",
        "is_stable": "stable",
        "margin": "ResistedSet(grasp).margin(wrench)",
        "motion": "solution.motion",
        "plot": "grasp.draw(wrench=wrench)",
        "resisted": "stable",
        "save": "certificate.save(path)",
        "show": "grasp.draw(wrench=wrench)",
    }

    def __repr__(self) -> str:
        count = self.grasp.size_words + " in space" * (self.grasp.dimension == 3)
        cones = pyramid_words(self.pyramid, before=", ")
        wrench = vector_text(self.wrench)
        return f"<Verdict: {self._verdict_in_repr()}, wrench {wrench}, {count}{cones}>"

    def _load(self) -> str:
        return f"the wrench {vector_text(self.wrench)} is"

    @cached_property
    def equilibria(self) -> tuple[Equilibrium, ...]:
        """In the plane the maximal pieces of the set of all solutions; empty when unstable.

        Pieces may touch; none lies in another. Of a piece with many solutions, the reported one
        has the least ``|d|^2``, and among those the least ``|c|^2``, both exact. To find all
        takes far longer than the verdict where there are many contacts.

        Raises:
            UndecidedError: whether there are any is not known.
            GraspError: there are some, and the grasp is in space.
        """
        return self._solver.choices.equilibria(self.wrench) if self.stable else ()

    @cached_property
    def states(self) -> tuple[str, ...]:
        """The state of each contact at the motion of `solution`; none when there is none."""
        found = self.solution
        if found is None:
            return ()
        if found.box is not None:
            shares = found.box.friction
            return tuple("detached" if x is None else "stick" if x else "slip" for x in shares)
        if self.grasp.dimension == 2:
            return states_at(self.grasp, found.motion)
        return tuple(
            "detached"
            if not force[0]
            else "slip"
            if any(dot(row, found.motion) for row in contact.tangential_wrenches)
            else "stick"
            for contact, force in zip(self.grasp, found.forces, strict=True)
        )

    @cached_property
    def tree(self) -> Tree | None:
        """The tree of virtual motions that the certificate shows; None where there is none.

        Where the choices of contact states have refuted the wrench, it is searched for when asked.
        """
        if self._tree is None and self.verdict == NOT_RESISTED:
            return self._solver.find_refutation(self.wrench)
        return self._tree

    @property
    def outcome(self) -> Outcome | None:
        """What the search ended with; None where the tree that refutes the wrench is not known."""
        if not self.decided:
            return Open(self.reason, self.residual)
        return self.solution or self._tree

    @cached_property
    def certificate(self) -> Certificate | None:
        """The proof, checkable without the solver; None when undecided."""
        if not self.decided:
            return None
        asked = self.pyramid, self.max_displacement
        if self.solution is None:
            return refuted_certificate(self.grasp, self.wrench, self.tree, *asked)
        return resisted_certificate(self.grasp, self.wrench, self.solution, *asked)

    def verify(self) -> Report:
        """Check the certificate, and that it answers this question; the report is true if so.

        Raises:
            UndecidedError: there is no certificate.
        """
        question = self.grasp, self.wrench
        return check(
            self.proof,
            question=question,
            pyramid=self.pyramid,
            max_displacement=self.max_displacement,
        )

    @property
    def problem(self) -> str:
        """What the checker finds wrong with the equilibrium or the tree; empty if nothing."""
        edges = () if self.pyramid is None else pyramid_edges(self.pyramid)
        proof = self.solution or self.tree
        return proof_problem(self.grasp, self.wrench, proof, edges, self.max_displacement)

    def accepted(self) -> Verdict:
        """Return this verdict, whose proof the checker accepts.

        Raises:
            EquilibriumError: it does not, which is an internal error.
        """
        try:
            problem = self.problem
        except CertificateError as error:
            problem = str(error)
        if problem:
            raise EquilibriumError(
                f"the checker refuses the proof of the verdict on {vector_text(self.wrench)}: "
                f"{problem}. This is an internal error; please report it"
            )
        return self

    def lists_all(self, every: bool | None = None) -> bool:
        """Return whether `to_dict` lists all equilibria."""
        if self.solution is None:
            return self.decided
        few = self.grasp.dimension == 2 and len(self.grasp) <= MAX_CONTACTS_LISTED
        return few if every is None else every

    def to_dict(self, every: bool | None = None) -> dict[str, Any]:
        """Return a JSON form; exact numbers are strings of rationals.

        Contacts are the points of `grasp`; forces of pads, and where they act, are in "pads", with
        the numbers of contacts from 1, and of their points from 0.

        In space an equilibrium that has no rational numbers is given in floats, with
        ``"exact": false``; the certificate has the box that holds it.

        Args:
            every: in the plane list all equilibria; False: only the one of the certificate, by
                states, motion and forces, and ``"complete": false``. None: all, if the contacts are
                at most `MAX_CONTACTS_LISTED`.
        """
        listed = self._listed(every) if self.grasp.dimension == 2 else self._found()
        return {
            "verdict": self.verdict if self.rounding is None else self.rounding.verdict,
            **listed,
            **({"warnings": list(self.warnings)} if self.warnings else {}),
            "wrench": [to_text(x) for x in self.wrench],
            **displacement_entry(self.max_displacement),
            "grasp": self.grasp.to_dict(),
            **({} if self.rounding is None else {"within_error": self.rounding.to_dict()}),
        }

    def _listed(self, every: bool | None) -> dict[str, Any]:
        """Return the equilibria in the plane."""
        if self.lists_all(every) or self.solution is None:
            listed = [x.to_dict() | self._pads(x.forces) for x in self.equilibria]
            return {"stable": self.stable, "equilibria": listed}
        shown = {"states": list(self.states), **self.solution.to_dict()}
        shown |= self._pads(self.solution.forces)
        return {"stable": self.stable, "equilibria": [shown], "complete": False}

    def _pads(self, forces: Sequence[RationalVector], form: Any = to_text) -> dict[str, Any]:
        return pad_entries(self.grasp.groups, self.grasp.contacts, forces, form)

    def _found(self) -> dict[str, Any]:
        """Return what was found in space."""
        document: dict[str, Any] = {} if self.pyramid is None else {"pyramid": self.pyramid}
        if self.solution is not None:
            exact = self.solution.box is None
            form: Any = to_text if exact else float
            document |= {
                "states": list(self.states),
                "motion": list(map(form, self.solution.motion)),
                "forces": [list(map(form, force)) for force in self.solution.forces],
                "exact": exact,
                **self._pads(self.solution.forces, form),
            }
        return (
            document
            if self.decided
            else document
            | {
                "reason": self.reason,
                "residual": self.residual,
            }
        )

    @property
    def subject(self) -> Grasp:
        """The grasp."""
        return self.grasp

    @property
    def load(self) -> RationalVector:
        """The wrench."""
        return self.wrench

    def flat(self, motion: Any) -> RationalVector:
        """Return a motion as it stands in a certificate, as one vector."""
        return tuple(motion)

    def again(self, grasp: Grasp, wrench: Iterable[Any], effort: Effort) -> Verdict:
        """Decide another question in the same way, with the effort that is left."""
        found = self._solver.for_grasp(grasp).decide(wrench, effort)
        return replace(found, _deadline=self._deadline)

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """Where displacements are not bounded: a line if no equilibrium is one of small motions."""
        if self.solution is None or self.max_displacement is not None:
            return ()
        most = small_displacement(self.grasp)
        if most is None or displacement(self.grasp, self.solution.motion) <= most:
            return ()
        answer = self.decide_within(most)
        return () if answer == RESISTED else (warning(every=answer == NOT_RESISTED),)

    def decide_within(self, max_displacement: Fraction) -> str:
        """Search for an equilibrium of smaller displacements, with the steps of one other grasp.

        Returns:
            the verdict; "undecided" where the steps do not do.
        """
        solver, effort = (
            self._solver.within(max_displacement),
            robustness.effort_within(self._deadline),
        )
        try:
            return solver.decide(self.wrench, effort).verdict
        except (OutOfReachError, TimeLimitError):
            return UNDECIDED

    def _repr_html_(self) -> str | None:
        """Return what a notebook shows: the picture, and every equilibrium with its forces."""
        text: str | None = attached("Verdict._repr_html_")(self)
        return text
