"""What a check of a certificate found, and whether that answers a question."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.console.number_form import ReprMixin
from arrangement.numbers.exact import RationalVector, to_text, vector_text
from equilibrium.model.contact import VALUES
from equilibrium.model.displacement import displacement_entry
from equilibrium.model.grasp import Grasp
from equilibrium.model.subject import Subject

from .law import short
from .leaf_rule import TreeQuestion
from .tree import walk
from .uncertain import Bounds

#: A grasp and a wrench, or an assembly and the wrenches on its bodies.
Question: TypeAlias = tuple[Subject, Any]


@dataclass(frozen=True, repr=False)
class Report(ReprMixin):
    """What a check found; it is true exactly when the proof holds.

    Attributes:
        kind: "resisted" or "not resisted".
        problem: the first inequality that fails and its place, or where the question is another
            one than that asked; empty when all hold.
        leaves: of the tree.
        pyramid: edges of the friction pyramids that it is about; None for cones.
        compared: whether the question that it is about was compared with one asked.
        grasp, wrench: that question.
        max_displacement: how far contact points may move for an equilibrium to count, if bounded.
        bounds: of the grasps for all of which it holds; None: it is about one.
    """

    kind: str
    problem: str
    leaves: int = 0
    pyramid: int | None = None
    compared: bool = False
    grasp: Grasp = field(default_factory=Grasp)
    wrench: RationalVector = ()
    max_displacement: Fraction | None = None
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
        """Return what this says of a question: nothing, if the certificate is about another one."""
        if question is None:
            return self
        problem = _difference(question, (self.grasp, self.wrench))
        if not problem and pyramid != self.pyramid:
            problem = "it is about other cones of friction"
        if not problem and max_displacement != self.max_displacement:
            problem = "it is about other displacements of contacts"
        return replace(self, problem=problem or self.problem, compared=True)

    @property
    def to_compare(self) -> str:
        """How the command compares what it is about with a question."""
        return "not compared with a grasp and wrench: give --grasp FILE --wrench W"

    @property
    def question(self) -> list[str]:
        """What it is about, in lines: the wrench and each contact."""
        contacts = [f"contact {i} {c.words}" for i, c in enumerate(self.grasp, 1)]
        return [f"wrench {vector_text(self.wrench)}", *contacts]

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        found: dict[str, Any] = {"problem": self.problem} if self.problem else {}
        if self.pyramid is not None:
            found["pyramid"] = self.pyramid
        found |= displacement_entry(self.max_displacement)
        if self.bounds is not None:
            found["bounds"] = self.bounds.to_dict()
        about = {"wrench": list(map(to_text, self.wrench)), "grasp": self.grasp.to_dict()}
        return {
            "valid": bool(self),
            "certificate": self.kind,
            "leaves": self.leaves,
            **found,
            **about,
            "compared": self.compared,
        }


def tree_report(tree: Any, question: TreeQuestion) -> Report:
    """Check all leaves of a tree."""
    leaves, problem = walk(tree, question)
    return Report("not resisted", problem, leaves)


def _difference(asked: Question, found: tuple[Grasp, RationalVector]) -> str:
    """Return the first difference of a certificate from what is expected, or nothing."""
    (wanted, load), (own, wrench) = asked, found
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
    for name, one, other in [*rows, ("wrench: it", wrench, own.read_wrench(load))]:
        if one != other:
            pair = [x if isinstance(x, tuple) else (x,) for x in (one, other)]
            texts = [vector_text(x) if len(x) > 1 else short(*x) for x in pair]
            apart = [abs(a - b) for a, b in zip(*pair, strict=True)]
            unlike = f" ({short(max(apart))} apart)" if "≈" in "".join(texts) else ""
            return f"it is about another {name} is {texts[0]}; expected {texts[1]}{unlike}"
    return ""
