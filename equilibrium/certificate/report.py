"""What a check of a certificate found, and whether that answers a question."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.console.number_form import ReprMixin
from arrangement.numbers.exact import vector_text
from equilibrium.model.assembly import Assembly
from equilibrium.model.contact import VALUES
from equilibrium.model.displacement import displacement_entry
from equilibrium.model.grasp import Grasp
from equilibrium.model.subject import AboutCaseMixin, LoadCase, Subject, read_load, texts

from .law import short
from .uncertain import Bounds

#: A grasp and a wrench, or an assembly and the wrenches on its bodies.
Question: TypeAlias = tuple[Subject, Any]


@dataclass(frozen=True, repr=False)
class Report(AboutCaseMixin, ReprMixin):
    """What a check found; it is true exactly when the proof holds.

    Attributes:
        kind: "resisted" or "not resisted".
        problem: the first inequality that fails and its place, or where the question is another
            one than that asked; empty when all hold.
        leaves: of the tree.
        case: the question that it is about.
        compared: whether that was compared with one asked.
        bounds: of the grasps for all of which it holds; None: it is about one.
    """

    kind: str
    problem: str
    leaves: int = 0
    case: LoadCase = field(default=LoadCase(Grasp(), ()))
    compared: bool = False
    bounds: Bounds | None = None
    repr_fields = ("kind", "problem", "leaves", "pyramid", "compared")

    def __bool__(self) -> bool:
        return not self.problem

    def asked(
        self,
        question: Question | None,
        pyramid: int | None = None,
        max_displacement: Fraction | None = None,
    ) -> Report:
        """Return the report compared with a question; false if the certificate is about another."""
        if question is None:
            return self
        problem = _difference(question, self.case)
        if not problem and pyramid != self.pyramid and isinstance(self.grasp, Grasp):
            problem = "it is about other cones of friction"
        if not problem and max_displacement != self.max_displacement:
            problem = "it is about other displacements of contacts"
        return replace(self, problem=problem or self.problem, compared=True)

    @property
    def to_compare(self) -> str:
        """How the command compares what it is about with a question."""
        if isinstance(self.grasp, Assembly):
            return "not compared with an assembly: give --grasp FILE, whose file has the wrenches"
        return "not compared with a grasp and wrench: give --grasp FILE --wrench W"

    @property
    def question(self) -> list[str]:
        """What it is about, in lines: the wrench, of an assembly on each body; each contact."""
        if isinstance(self.grasp, Assembly):
            lines = [f"wrench on {name} {vector_text(w)}" for name, w in self.wrench.items()]
            contacts = [f"{c.pair} {c.contact.words}" for c in self.grasp.contacts]
        else:
            lines = [f"wrench {vector_text(self.wrench)}"]
            contacts = [contact.words for contact in self.grasp]
        return lines + [f"contact {i} {words}" for i, words in enumerate(contacts, 1)]

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {
            "valid": bool(self),
            "certificate": self.kind,
            "leaves": self.leaves,
            **({"problem": self.problem} if self.problem else {}),
            **({} if self.pyramid is None else {"pyramid": self.pyramid}),
            **displacement_entry(self.max_displacement),
            **({} if self.bounds is None else {"bounds": self.bounds.to_dict()}),
            "wrench": texts(self.wrench),
            "assembly" if isinstance(self.grasp, Assembly) else "grasp": self.grasp.to_dict(),
            "compared": self.compared,
        }


def _difference(asked: Question, case: LoadCase) -> str:
    """Return the first difference of a certificate from what is expected, or nothing."""
    (wanted, load), own = asked, case.subject
    if isinstance(own, Assembly):
        same = wanted == own and read_load(wanted, load) == case.load
        return "" if same else "it is about another assembly or other wrenches"
    if not isinstance(wanted, Grasp):
        return "it is about one body, not about an assembly"
    if (own.dimension, len(own)) != (wanted.dimension, len(wanted)):
        sizes = (f"{len(g)} contacts in {g.dimension} dimensions" for g in (own, wanted))
        return "it is about another grasp: {}; expected one with {}".format(*sizes)
    rows = [
        (f"grasp: {name} of contact {i}", getattr(one, name), getattr(other, name))
        for i, (one, other) in enumerate(zip(own, wanted, strict=True), 1)
        for name in ("point", "normal", *VALUES, "tangent")
    ]
    for name, one, other in [*rows, ("wrench: it", case.load, own.read_wrench(load))]:
        if one != other:
            pair = [x if isinstance(x, tuple) else (x,) for x in (one, other)]
            texts = [vector_text(x) if len(x) > 1 else short(*x) for x in pair]
            apart = [abs(a - b) for a, b in zip(*pair, strict=True)]
            unlike = f" ({short(max(apart))} apart)" if "≈" in "".join(texts) else ""
            return f"it is about another {name} is {texts[0]}; expected {texts[1]}{unlike}"
    return ""
