"""The answer for an assembly: resisted, not resisted or undecided, with its certificate."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from arrangement.console.number_form import counted, number, vector
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import RationalVector, dot, to_text
from equilibrium.certificate.checker import check
from equilibrium.certificate.document import Certificate, certificate
from equilibrium.certificate.report import Report
from equilibrium.decide.answer import AnswerMixin, undecided
from equilibrium.decide.proofs_for_all import NO_DEADLINE
from equilibrium.model.assembly import SIZE, Assembly, Wrenches
from equilibrium.model.displacement import displacement_entry, displacement_words
from equilibrium.model.effort import Effort
from equilibrium.model.errors import UndecidedError
from equilibrium.model.labels import force_lines
from equilibrium.model.solution import Solution

from .magnitudes import PartEquilibrium, part_equilibria
from .rigid import rigid_forces

if TYPE_CHECKING:
    from .solver import AssemblySolver

#: Why rigid bodies hold, and springs do not.
_SQUEEZED = "forces in the friction cones balance the wrenches, and no displacement gives them"


@dataclass(frozen=True)
class AssemblyVerdict(AnswerMixin):
    """The answer for one assembly and a wrench on each body, true when resisted.

    Attributes:
        assembly, wrenches: the question; zero where no wrench was given.
        verdict: "resisted", "not resisted" or "undecided"; the first two are proved.
        solution: an equilibrium, with three numbers a body in its motion; None when there is none.
        reason: why it is not resisted, or undecided, in words; else empty.
        max_displacement: how far bodies may move relative to each other at a contact for an
            equilibrium to count, if bounded.
    """

    assembly: Assembly
    wrenches: Wrenches
    verdict: str
    solution: Solution | None
    reason: str = ""
    max_displacement: Fraction | None = None
    pyramid: None = field(default=None, repr=False, init=False)
    _tree: Any = field(default=None, repr=False, compare=False)
    _solver: AssemblySolver | None = field(default=None, repr=False, compare=False)
    _deadline: Deadline = field(default=NO_DEADLINE, repr=False, compare=False)

    _synonyms: ClassVar[Mapping[str, str]] = {
        "check": "verify()",
        "motion": "motions",
        "resisted": "stable",
        "save": "certificate.save(path)",
    }

    def __repr__(self) -> str:
        return f"<AssemblyVerdict: {self._verdict_in_repr()}, {self.assembly!r}>"

    def _load(self) -> str:
        return "the wrenches are"

    @property
    def subject(self) -> Assembly:
        """The assembly."""
        return self.assembly

    @property
    def load(self) -> RationalVector:
        """The wrenches on the bodies in a row."""
        return self.flat(self.wrenches)

    def flat(self, motion: Mapping[str, Iterable[Any]]) -> RationalVector:
        """Return a motion, or wrenches, by the names of bodies, as one vector."""
        rows = (motion.get(name, (0,) * SIZE) for name in self.assembly.names)
        return tuple(Fraction(x) for row in rows for x in row)

    def again(self, assembly: Assembly, load: RationalVector, effort: Effort) -> AssemblyVerdict:
        """Decide another question in the same way, with the effort that is left."""
        assert self._solver is not None
        rows = {name: load[SIZE * k : SIZE * (k + 1)] for k, name in enumerate(assembly.names)}
        found = replace(self._solver, grasp=assembly).decide(rows, effort)
        return replace(found, _deadline=self._deadline)

    @cached_property
    def motions(self) -> dict[str, RationalVector]:
        """The motion (x, y, r) of each body in `solution`; empty when there is none."""
        if self.solution is None:
            return {}
        moved, names = self.solution.motion, self.assembly.names
        return {name: moved[SIZE * k : SIZE * (k + 1)] for k, name in enumerate(names)}

    @property
    def forces(self) -> tuple[RationalVector, ...]:
        """At each contact the normal and the tangential force on body_a; empty without one.

        The adhesion of the contact acts besides.
        """
        return () if self.solution is None else self.solution.forces

    @cached_property
    def states(self) -> tuple[str, ...]:
        """The state of each contact in `solution`; empty when there is none."""
        if self.solution is None:
            return ()
        found = []
        for row, (pressed, _) in zip(self.assembly.rows, self.solution.forces, strict=True):
            slip = dot(row.tangential_wrenches[0], self.solution.motion)
            slips = "slip+" if slip > 0 else "slip-" if slip < 0 else "stick"
            found.append(slips if pressed else "detached")
        return tuple(found)

    @cached_property
    def equilibria(self) -> tuple[tuple[PartEquilibrium, ...], ...]:
        """All equilibria of each part, as sets with one choice of contact states; none if unstable.

        Those of different parts combine freely. To find all takes far longer than the verdict.

        Raises:
            UndecidedError: whether there are any is not known, or a part has too many choices of
                contact states.
        """
        if not self.stable:
            return ()
        found = self._all_equilibria
        if isinstance(found, str):
            raise UndecidedError(found)
        return found

    @cached_property
    def _all_equilibria(self) -> tuple[tuple[PartEquilibrium, ...], ...] | str:
        """The equilibria of each part; or why they are not known, which takes long to find out."""
        try:
            return part_equilibria(self.assembly, self.wrenches, self.max_displacement)
        except UndecidedError as unknown:
            return str(unknown)

    @cached_property
    def balances_rigidly(self) -> bool:
        """Whether some forces in the friction cones balance the wrenches, whatever the springs do.

        That is the linear program of rigid bodies, exactly solved. Where it says yes and the
        verdict is not resisted, it squeezes bodies for free: no displacement gives these forces.
        """
        return rigid_forces(self.assembly, self.wrenches) is not None

    @cached_property
    def certificate(self) -> Certificate | None:
        """The proof, checkable without the solver; None when undecided."""
        if not self.decided:
            return None
        question = self.verdict, self.assembly, self.load, None, self.max_displacement
        if self.solution is None:
            return certificate(*question, tree=self._tree)
        forces = [list(map(to_text, force)) for force in self.forces]
        return certificate(*question, motion=_texts(self.motions), forces=forces)

    def verify(self) -> Report:
        """Check the certificate, and that it answers this question; the report is true if so.

        Raises:
            UndecidedError: there is no certificate.
        """
        question = self.assembly, self.wrenches
        return check(self.proof, question, max_displacement=self.max_displacement)

    def to_dict(self, every: bool = False) -> dict[str, Any]:
        """Return a JSON form; exact numbers are strings of rationals.

        Args:
            every: with `equilibria`, or why they are not known.
        """
        found: dict[str, Any] = {"reason": self.reason} if self.reason else {}
        if self.solution is not None:
            found |= {
                "states": list(self.states),
                "motion": _texts(self.motions),
                "forces": [list(map(to_text, force)) for force in self.forces],
            }
        if every and self.solution is not None:
            parts = self._all_equilibria
            found["equilibria"] = (
                undecided(parts)
                if isinstance(parts, str)
                else [[one.to_dict() for one in part] for part in parts]
            )
        return {
            "verdict": self.verdict if self.rounding is None else self.rounding.verdict,
            **found,
            "wrench": _texts(self.wrenches),
            **displacement_entry(self.max_displacement),
            "assembly": self.assembly.to_dict(),
            **({} if self.rounding is None else {"within_error": self.rounding.to_dict()}),
        }

    def lines(self, every: bool = False) -> list[str]:
        """Return the answer in lines for people: the reason, or motions and forces.

        Args:
            every: with `equilibria`, or why they are not known.
        """
        within = displacement_words(self.max_displacement)
        if self.solution is None:
            proof = within
            if self.decided:
                leaves = self.verify().leaves
                proof += f"; proof with {counted(leaves, 'leaf', 'leaves')}"
            found = [f"{self.verdict}: {self.reason}{proof}"]
            if self.decided and self.balances_rigidly:
                found.append(f"rigid bodies would hold: {_SQUEEZED}")
            return found
        found = [f"resisted{within}: an exact equilibrium"]
        found += [f"  {name} moves by {vector(moved)}" for name, moved in self.motions.items()]
        joints = self.assembly.contacts
        rows = []
        for i, (c, state, force) in enumerate(zip(joints, self.states, self.forces, strict=True)):
            cells = f"contact {i + 1}", c.pair, state, *map(number, force)
            stuck = c.contact.adhesion
            rows.append((cells, f"  adhesion {number(stuck)}" if stuck else ""))
        found += force_lines(rows, self.assembly.units, "bodies")
        parts = self._all_equilibria if every else ()
        if isinstance(parts, str):
            return [*found, f"all equilibria: undecided, {parts}"]
        for part in parts:
            numbers = ", ".join(str(i + 1) for i in part[0].contacts)
            many = counted(len(part), "family", "families")
            found.append(f"  contacts {numbers}: {many} of equilibria")
            for one in part:
                forces = "unique" if one.unique else "not unique"
                found.append(f"    {' '.join(one.states)}  (contact forces {forces})")
        return found


def _texts(rows: Mapping[str, RationalVector]) -> dict[str, list[str]]:
    return {name: list(map(to_text, row)) for name, row in rows.items()}
