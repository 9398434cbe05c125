"""The checker of certificates: no solver, no floats; it sees the question and the document.

* "resisted": a motion and forces that obey the law of `equilibrium.certificate.law`, or in space a
  box that holds them, see `equilibrium.certificate.enclosure`.
* "not resisted": a tree. Each node cuts a region of motions, or distinguishes the states of one
  contact; a split whose children do not cover it is refused by `equilibrium.certificate.tree`. Each
  leaf has a virtual motion, on which load and contacts do work together, whatever the contacts do:
  the rule of `equilibrium.certificate.leaf_rule`. So nothing balances the load at any motion.
* With "bounds": for all grasps within them, see `equilibrium.certificate.robust`.

Where contacts and load in space lie in one plane, and cones are round, a planar tree will do: out
of the plane forces do no work together, and friction none or less at each contact, so no loaded
contact slips that way, and what the motion and the forces are in the plane would be an equilibrium
there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.console.number_form import ReprMixin
from arrangement.console.plugins import named
from arrangement.numbers.exact import RationalVector, to_text, vector_text
from equilibrium.model.contact import VALUES, pyramid_edges
from equilibrium.model.displacement import along_tangents, displacement_entry
from equilibrium.model.errors import CertificateError, GraspError
from equilibrium.model.grasp import Grasp, in_plane
from equilibrium.model.solution import Solution

from .enclosure import enclosure_problem
from .law import displacement_problem, law_problem, law_rows, short
from .leaf_rule import TreeQuestion
from .reading import (
    FORMS,
    read_bound,
    read_enclosure,
    read_equilibrium,
    read_plane,
    read_question,
)
from .robust import read_bounds, robust_problem
from .tree import walk
from .uncertain import Bounds

#: A grasp and a wrench.
Question: TypeAlias = tuple[Grasp, RationalVector]


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


def _difference(asked: Question, found: Question) -> str:
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


def check(
    document: Mapping[str, Any],
    question: Question | None = None,
    pyramid: int | None = None,
    max_displacement: Fraction | None = None,
) -> Report:
    """Check a certificate, given as `Certificate.to_dict` or `read_certificate` returns it.

    Args:
        question: the grasp and wrench that the certificate has to be about; if omitted, the report
            says what it is about, and that this was compared with nothing.
        pyramid: with a question, the edges of the friction pyramids it has to be about; None for
            cones, in space round ones.
        max_displacement: with a question, the largest displacement it has to be about.

    Raises:
        InputError: this is not a certificate, whatever its numbers are: wrong keys or types,
            floats, a split that does not fit its region. A wrong proof is a false report instead.

    Complexity: O(m) integer operations for each node of the tree.
    """
    if isinstance(document, Mapping) and "assembly" in document:
        report: Report = named("equilibrium.certificate.assemblies:check_assembly")(
            document, question, max_displacement
        )
        return report
    kind, grasp, wrench = read_question(document)
    bound = read_bound(document)
    if "bounds" in document:
        problem = robust_problem(document, grasp, wrench)
        report = Report(kind, problem, bounds=read_bounds(document))
    elif kind == "resisted":
        how = edges_of(document), bound
        report = Report(kind, proof_problem(grasp, wrench, _read_solution(document, grasp), *how))
    else:
        report = _tree_report(document["tree"], grasp, wrench, edges_of(document), bound)
    pyramid_of = document.get("pyramid")
    report = replace(report, pyramid=pyramid_of, max_displacement=bound, grasp=grasp, wrench=wrench)
    return report.asked(question, pyramid, max_displacement)


def _tree_report(
    tree: Any,
    grasp: Grasp,
    wrench: RationalVector,
    edges: Sequence[RationalVector],
    max_displacement: Fraction | None,
) -> Report:
    """Check a tree; in space also one in the plane that has all contacts and the load."""
    plane = read_plane(tree) if grasp.dimension == 3 else None
    if plane is None:
        return tree_report(tree, TreeQuestion.of(grasp, wrench, edges, max_displacement))
    if edges:
        raise CertificateError("tree.plane is for round cones")
    try:
        flat, load = in_plane(grasp, wrench, plane.axes)
    except GraspError as error:
        return Report("not resisted", f"tree.plane: {error}")
    if max_displacement is not None and not along_tangents(grasp, plane.axes):
        problem = "displacements along tangents that are at an angle to the plane are bounded"
        return Report("not resisted", f"tree.plane: {problem}")
    question = TreeQuestion.of(flat, load, max_displacement=max_displacement)
    return tree_report(plane.tree, question)


def tree_report(tree: Any, question: TreeQuestion) -> Report:
    """Check all leaves of a tree."""
    leaves, problem = walk(tree, question)
    return Report("not resisted", problem, leaves)


def _read_solution(document: Mapping[str, Any], grasp: Grasp) -> Solution:
    """Return the equilibrium of a certificate, or the box that holds it."""
    form = FORMS[grasp.dimension]
    if "enclosure" in document:
        return Solution((), (), read_enclosure(document["enclosure"], len(grasp), form))
    motion, forces = read_equilibrium(document, len(grasp), form)
    return Solution(motion, tuple(forces))


def proof_problem(
    grasp: Grasp,
    wrench: RationalVector,
    proof: Solution | Any,
    edges: Sequence[RationalVector] = (),
    max_displacement: Fraction | None = None,
) -> str:
    """Return what is wrong with an equilibrium, or a tree; empty if it is proof.

    Args:
        edges: of friction pyramids; none for cones, in space round ones.

    Raises:
        InputError: a node of the tree is none, or does not fit its place.
    """
    if not isinstance(proof, Solution):
        return _tree_report(proof, grasp, wrench, edges, max_displacement).problem
    if proof.box is not None:
        return enclosure_problem(grasp, wrench, proof.box, max_displacement)
    rows = law_rows(grasp)
    problem = displacement_problem(rows, proof.motion, max_displacement)
    return problem or law_problem(rows, wrench, proof.motion, proof.forces, edges)


def edges_of(document: Mapping[str, Any]) -> tuple[RationalVector, ...]:
    """Return the edges of friction pyramids, none for round cones."""
    return pyramid_edges(document["pyramid"]) if "pyramid" in document else ()
