"""The answer to one question: resisted, not resisted or undecided, in the plane and in space.

Model: a motion d and forces with, at every contact, ``c_n = max(0, preload - stiffness N . d)``,
``|c_t| <= friction c_n``, maximum dissipation (a contact that slips by ``s = T d`` has ``c_t =
-friction c_n s / |s|``), and ``sum ((c_n - adhesion) N + c_t T) + w = 0``. The answer is an
equilibrium, or a tree of virtual motions against which nothing balances the load. In space there
are two tangents and the cone is round, so equilibria need not have rational numbers, and on a
boundary neither proof may close: then the answer is "undecided".
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar

from arrangement.console.plugins import method_code
from arrangement.errors import OutOfReachError
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import RationalVector, to_text, vector_text
from arrangement.synonyms import by_word
from equilibrium.certificate.checker import check, proof_report
from equilibrium.certificate.document import Certificate, certificate, resisted_certificate
from equilibrium.certificate.report import Report
from equilibrium.certificate.uncertain import Bounds
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.contact import pyramid_edges, pyramid_words
from equilibrium.model.displacement import (
    displacement,
    displacement_entry,
    small_displacement,
    warning,
)
from equilibrium.model.effort import STEPS, Effort
from equilibrium.model.errors import (
    CertificateError,
    EquilibriumError,
    TimeLimitError,
    UndecidedError,
)
from equilibrium.model.labels import ROUNDED
from equilibrium.model.solution import Open, Refutation, Solution, Tree, pad_entries
from equilibrium.model.subject import AboutCaseMixin, LoadCase, Subject, by_body, texts
from equilibrium.model.synonyms import NAMES

from . import NOT_RESISTED, RESISTED, UNDECIDED, robustness, undecided
from .engines import Engine, PlanarEngine, SpatialEngine
from .nearby import Robustness, WithinError
from .proofs_for_all import NO_DEADLINE
from .verdict_text import verdict_lines

#: With more contacts all equilibria are listed only when asked for: their search takes long.
MAX_CONTACTS_LISTED = 20


def engine_of(
    subject: Subject, max_displacement: Fraction | None = None, pyramid: int | None = None
) -> Engine:
    """Return the engine of a grasp or an assembly.

    Raises:
        GraspError: a pyramid of no such number, or not in space.
    """
    if isinstance(subject, Assembly):
        from .assemblies.engine import AssemblyEngine

        return AssemblyEngine(subject, max_displacement)
    if pyramid is not None:
        pyramid_edges(pyramid, subject.dimension)
    if subject.dimension == 3:
        return SpatialEngine(subject, max_displacement, pyramid)
    return PlanarEngine(subject, max_displacement)


@dataclass(frozen=True)
class Verdict(AboutCaseMixin):
    """The answer for a grasp or an assembly and a load, true when resisted, with its proof.

    Attributes:
        case: the question.
        verdict: "resisted", "not resisted" or, in space and of assemblies alone, "undecided"; the
            others are proved.
        solution: the equilibrium that the certificate shows, of an assembly with three numbers a
            body in its motion; None when there is none.
        reason: why it is undecided, of an assembly also why it is not resisted; else empty.
        residual: in space, when undecided, the least force that is left over at the best motion
            found, as a share of the largest force given.
    """

    case: LoadCase
    verdict: str
    solution: Solution | None
    reason: str = ""
    residual: float = 0.0
    _tree: Tree | None = field(default=None, repr=False, compare=False)
    _engine: Engine = field(kw_only=True, repr=False, compare=False)
    _deadline: Deadline = field(default=NO_DEADLINE, repr=False, compare=False)

    _synonyms: ClassVar[Mapping[str, str]] = {
        **{word: name.removeprefix("solve(G, w).") for word, name in NAMES.items()},
        **by_word("""
            check -> verify()
            draw plot show -> verdict.grasp.draw(wrench=verdict.wrench)
            explain explanation reasons report why -> lines()
            is_stable resisted -> stable
            margin -> ResistedSet(grasp).margin(wrench)
            status result -> verdict
        """),
    }
    _main: ClassVar[Mapping[str, str]] = {
        "answer": "stable verdict lines",
        "equilibrium": "states forces solution equilibria",
        "proof": "certificate verify proof to_dict",
        "question": "grasp wrench",
    }

    @classmethod
    def of(
        cls,
        case: LoadCase,
        engine: Engine,
        outcome: Solution | Refutation | Open,
        deadline: Deadline = NO_DEADLINE,
    ) -> Verdict:
        """Return the verdict of what a search ended with."""
        hidden: dict[str, Any] = {"_engine": engine, "_deadline": deadline}
        if isinstance(outcome, Solution):
            return cls(case, RESISTED, outcome, **hidden)
        if isinstance(outcome, Open):
            return cls(case, UNDECIDED, None, outcome.reason, outcome.residual, **hidden)
        return cls(case, NOT_RESISTED, None, outcome.reason, _tree=outcome.tree, **hidden)

    def __repr__(self) -> str:
        if isinstance(self.subject, Assembly):
            return f"<Verdict: {self._verdict_in_repr}, {self.subject!r}>"
        count = self.subject.size_words + " in space" * (self.subject.dimension == 3)
        cones = pyramid_words(self.pyramid, before=", ")
        wrench = vector_text(self.load)
        return f"<Verdict: {self._verdict_in_repr}, wrench {wrench}, {count}{cones}>"

    @property
    def _verdict_in_repr(self) -> str:
        """The verdict; of converted data, where others are not asked for this, as theirs."""
        rounded = self.decided and self.subject.data_error is not None
        return f"{self.verdict} {ROUNDED}" if rounded else self.verdict

    @property
    def subject(self) -> Subject:
        """The grasp or the assembly."""
        return self.case.subject

    @property
    def load(self) -> RationalVector:
        """The wrench; of an assembly those on its bodies in a row."""
        return self.case.load

    @property
    def assembly(self) -> Assembly:
        """The assembly; a verdict on a grasp has none."""
        return self._assembly("assembly")

    @property
    def wrenches(self) -> Wrenches:
        """The wrench on each body of an assembly, by name; zero where none was given."""
        self._assembly("wrenches")
        wrenches: Wrenches = self.case.wrench
        return wrenches

    def _assembly(self, name: str) -> Assembly:
        """Return the assembly, where an attribute is about one.

        Raises:
            AttributeError: the verdict is about a grasp.
        """
        if isinstance(self.subject, Assembly):
            return self.subject
        word = {"assembly": "grasp", "motions": "solution.motion", "wrenches": "wrench"}.get(name)
        hint = f"; use {word}" if word else ""
        raise AttributeError(f"a verdict on a grasp has no attribute {name!r}{hint}", name=name)

    @property
    def decided(self) -> bool:
        """Whether there is a proof."""
        return self.verdict != UNDECIDED

    @property
    def stable(self) -> bool:
        """Whether the load is resisted: at least one equilibrium exists.

        Raises:
            UndecidedError: that is not known.
        """
        if not self.decided:
            bodies = isinstance(self.subject, Assembly)
            load = "the wrenches are" if bodies else f"the wrench {vector_text(self.load)} is"
            raise UndecidedError(
                f"whether {load} resisted is undecided: {self.reason}; ask `verdict` for "
                "the three answers"
            )
        return self.verdict == RESISTED

    def __bool__(self) -> bool:
        """Return whether the load is resisted; an undecided verdict raises UndecidedError."""
        return self.stable

    @property
    def forces(self) -> tuple[RationalVector, ...]:
        """The forces of contacts in `solution`, of an assembly on body_a; empty without one.

        The adhesion of a contact acts besides.
        """
        return () if self.solution is None else self.solution.forces

    @cached_property
    def motions(self) -> dict[str, RationalVector]:
        """The motion (x, y, r) of each body of an assembly in `solution`; empty without one."""
        assembly = self._assembly("motions")
        return {} if self.solution is None else by_body(assembly, self.solution.motion)

    @cached_property
    def states(self) -> tuple[str, ...]:
        """The state of each contact in `solution`; none when there is none."""
        return () if self.solution is None else self._engine.states(self.solution)

    @cached_property
    def equilibria(self) -> tuple[Any, ...]:
        """All equilibria; empty when unstable.

        In the plane they are the maximal pieces of the set of all solutions. Pieces may touch; none
        lies in another. Of a piece with many solutions, the reported one has the least ``|d|^2``,
        and among those the least ``|c|^2``, both exact. To find all takes far longer than the
        verdict where there are many contacts.

        Of an assembly they are, for each part, sets with one choice of contact states. Those of
        different parts combine freely.

        Raises:
            UndecidedError: whether there are any is not known, or a part of an assembly has too
                many choices of contact states.
            GraspError: there are some, and the grasp is in space.
        """
        if not self.stable:
            return ()
        if isinstance(self._all_equilibria, str):
            raise UndecidedError(self._all_equilibria)
        return self._all_equilibria

    @cached_property
    def _all_equilibria(self) -> tuple[Any, ...] | str:
        """All equilibria; or why they are not known, which takes long to find out."""
        try:
            return self._engine.equilibria(self.load)
        except UndecidedError as unknown:
            return str(unknown)

    @cached_property
    def balances_rigidly(self) -> bool:
        """Whether some forces in the friction cones balance the wrenches, whatever the springs do.

        Of an assembly: that is the linear program of rigid bodies, exactly solved. Where it says
        yes and the verdict is not resisted, it squeezes bodies for free: no displacement gives
        these forces.
        """
        from .assemblies.rigid import rigid_forces

        return rigid_forces(self._assembly("balances_rigidly"), self.wrenches) is not None

    @cached_property
    def tree(self) -> Tree | None:
        """The tree of virtual motions that the certificate shows; None where there is none.

        Where the choices of contact states have refuted the wrench, it is searched for when asked.
        """
        if self._tree is not None or self.verdict != NOT_RESISTED:
            return self._tree
        searched = self.again(self.subject, self.load, Effort.usual(STEPS[2]))
        if searched.stable:
            raise EquilibriumError(
                f"the wrench {vector_text(self.load)} has an equilibrium, but no choice of contact "
                "states has one. This is an internal error; please report it"
            )
        return searched.tree

    @property
    def outcome(self) -> Solution | Refutation | Open:
        """What the search ended with."""
        if not self.decided:
            return Open(self.reason, self.residual)
        return self.solution or Refutation(self._tree, self.reason)

    @property
    def proof(self) -> dict[str, Any]:
        """The document of the certificate.

        Raises:
            UndecidedError: there is none.
        """
        if self.certificate is None:
            raise UndecidedError(f"an undecided verdict has no certificate: {self.reason}")
        return self.certificate.to_dict()

    @cached_property
    def certificate(self) -> Certificate | None:
        """The proof, checkable without the solver; None when undecided."""
        if not self.decided:
            return None
        limits = self.pyramid, self.max_displacement
        if self.solution is None:
            return certificate("not resisted", self.subject, self.load, *limits, tree=self.tree)
        return resisted_certificate(self.subject, self.load, self.solution, *limits)

    def verify(self) -> Report:
        """Check the certificate, and that it answers this question; the report is true if so.

        Raises:
            UndecidedError: there is no certificate.
        """
        return check(
            self.proof,
            question=(self.subject, self.wrench),
            pyramid=self.pyramid,
            max_displacement=self.max_displacement,
        )

    @property
    def problem(self) -> str:
        """What the checker finds wrong with the equilibrium or the tree; empty if nothing."""
        return proof_report(self.case, self.solution or self.tree).problem if self.decided else ""

    def accepted(self) -> Verdict:
        """Return this verdict, whose proof the checker accepts.

        Raises:
            EquilibriumError: it does not, which is an internal error.
        """
        if not self.decided or (self.solution is not None and self._engine.checks_equilibria):
            return self
        try:
            problem = self.problem
        except CertificateError as error:
            problem = str(error)
        if problem:
            bodies = isinstance(self.subject, Assembly)
            about = repr(self.subject) if bodies else vector_text(self.load)
            raise EquilibriumError(
                f"the checker refuses the proof of the verdict on {about}: {problem}. This is an "
                "internal error; please report it"
            )
        return self

    def lists_all(self, every: bool | None = None) -> bool:
        """Return whether `to_dict` lists all equilibria."""
        if self.solution is None:
            return self.decided
        if isinstance(self.subject, Assembly):
            return bool(every)
        few = self.subject.dimension == 2 and len(self.subject) <= MAX_CONTACTS_LISTED
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
                at most `MAX_CONTACTS_LISTED`. Of an assembly: with `equilibria`, or why they are
                not known.
        """
        name = "grasp"
        if isinstance(self.subject, Assembly):
            name, listed = "assembly", self._of_bodies(every)
        elif self.subject.dimension == 2:
            listed = self._in_plane(every)
        else:
            listed = self._in_space()
        return {
            "verdict": self.verdict if self.rounding is None else self.rounding.verdict,
            **listed,
            **({"warnings": list(self.warnings)} if self.warnings else {}),
            "wrench": texts(self.wrench),
            **displacement_entry(self.max_displacement),
            name: self.subject.to_dict(),
            **({} if self.rounding is None else {"within_error": self.rounding.to_dict()}),
        }

    def _in_plane(self, every: bool | None) -> dict[str, Any]:
        if self.lists_all(every) or self.solution is None:
            listed = [x.to_dict() | self._pads(x.forces) for x in self.equilibria]
            return {"stable": self.stable, "equilibria": listed}
        shown = {"states": list(self.states), **self.solution.to_dict()}
        shown |= self._pads(self.solution.forces)
        return {"stable": self.stable, "equilibria": [shown], "complete": False}

    def _in_space(self) -> dict[str, Any]:
        document: dict[str, Any] = {} if self.pyramid is None else {"pyramid": self.pyramid}
        if self.solution is not None:
            exact = self.solution.box is None
            form: Any = to_text if exact else float
            document |= {
                "states": list(self.states),
                "motion": list(map(form, self.solution.motion)),
                "forces": [list(map(form, force)) for force in self.forces],
                "exact": exact,
                **self._pads(self.forces, form),
            }
        if not self.decided:
            document |= {"reason": self.reason, "residual": self.residual}
        return document

    def _of_bodies(self, every: bool | None) -> dict[str, Any]:
        if self.solution is None:
            return {"reason": self.reason} if self.reason else {}
        document: dict[str, Any] = {
            "states": list(self.states),
            "motion": texts(self.motions),
            "forces": list(map(texts, self.forces)),
        }
        if every:
            parts = self._all_equilibria
            document["equilibria"] = (
                undecided(parts)
                if isinstance(parts, str)
                else [[piece.to_dict() for piece in part] for part in parts]
            )
        return document

    def _pads(self, forces: Sequence[RationalVector], form: Any = to_text) -> dict[str, Any]:
        return pad_entries(self.grasp.groups, self.grasp.contacts, forces, form)

    def lines(self, every: bool | None = None, path: str | None = None) -> list[str]:
        """Return the answer in lines for people: equilibria, or why there is none.

        Args:
            every: see `to_dict`.
            path: of the certificate, if it was written.
        """
        return list(verdict_lines(self, every, path))

    @cached_property
    def rounding(self) -> WithinError | None:
        """What is known for all data within the error of converted ones; None of exact data."""
        if self.subject.data_error is None:
            return None
        return robustness.within_error(self, self._deadline)

    @property
    def answer(self) -> str:
        """The verdict, in words as strong as what is known.

        Of exact data, and where it is proved for all data within the rounding error, that is the
        verdict; else "depends on the rounding", or "... for the data as rounded; not proved for all
        within the rounding error".
        """
        return self.verdict if self.rounding is None else self.rounding.answer

    @property
    def depends(self) -> bool:
        """Whether other data within the rounding error have another verdict, as was found."""
        return self.rounding is not None and self.rounding.turned is not None

    @property
    def doubt(self) -> str:
        """What is added to a verdict that is not proved for all data within the rounding error."""
        if self.rounding is None or self.rounding.proved or not self.decided:
            return ""
        return self.rounding.words

    def robust(self, *, time_limit: float | None = None, **bounds: Any) -> Robustness:
        """Decide whether the verdict holds for all data within the given bounds.

        Args:
            time_limit: in seconds; none by default. It is undecided when that is over.
            bounds: of `Bounds`: degrees, length, friction, stiffness, preload.
        """
        return robustness.robust(self, Bounds(**bounds), Deadline(time_limit))

    def within_error(self) -> WithinError:
        """Decide other data within the error of those that this verdict was converted from.

        A time limit of `solve` counts for this, too.

        Raises:
            GraspError: they were not converted.
        """
        return self.rounding or robustness.within_error(self)

    def again(
        self, subject: Subject, load: RationalVector, effort: Effort, **limits: Any
    ) -> Verdict:
        """Decide another question, with the effort that is left and, if given, other limits."""
        case = replace(self.case, subject=subject, load=load, **limits)
        engine = engine_of(subject, case.max_displacement, case.pyramid)
        outcome = engine.outcome(load, effort)
        return Verdict.of(case, engine, outcome, self._deadline).accepted()

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """Where displacements are not bounded: a line if no equilibrium is one of small motions.

        None of assemblies.
        """
        assembly = isinstance(self.subject, Assembly)
        if assembly or self.solution is None or self.max_displacement is not None:
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
        question = self.subject, self.load, robustness.effort_within(self._deadline)
        try:
            return self.again(*question, max_displacement=max_displacement).verdict
        except (OutOfReachError, TimeLimitError):
            return UNDECIDED

    def _repr_html_(self) -> str | None:
        """Return what a notebook shows: the picture, and every equilibrium with its forces.

        None of an assembly, whose picture is shown alone.
        """
        if isinstance(self.subject, Assembly):
            return None
        text: str | None = method_code("Verdict._repr_html_")(self)
        return text

    def _repr_svg_(self) -> str | None:
        """Return what a notebook shows: bodies, wrenches and the forces of an equilibrium."""
        text: str | None = method_code("Verdict._repr_svg_")(self)
        return text
