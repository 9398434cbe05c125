"""The checker of certificates about assemblies: no solver, no floats.

The law is that of one body, in R^(3b): a contact has its rows in the numbers of body_a, and their
negatives in those of body_b, so "resisted" is checked like that of a grasp. "not resisted" is a
tree of contact states with the rule of `equilibrium.certificate.leaf_rule`; its leaves have virtual
motions for some bodies, 0 for the others. At the root the tree may instead be one of a *part*:
bodies S that touch the rest at contacts of one body in S with one outside, or with the ground.
Their balances add up to one in which only these contacts are left, and the law of these depends on
the motion of the one body relative to the other alone: so a planar proof about them and the whole
load of S will do.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import RationalVector, shown, to_text, vector_text
from equilibrium.model.assembly import SIZE, Assembly, Wrenches
from equilibrium.model.displacement import displacement_entry
from equilibrium.model.errors import CertificateError
from equilibrium.model.grasp import Grasp

from .law import LawRow, displacement_problem, frame, law_problem
from .leaf_rule import TreeQuestion
from .reading import (
    KEYS,
    STATES,
    TreeForm,
    check_version,
    read_bound,
    read_equilibrium,
    read_index,
    read_motion,
)
from .report import Report, tree_report
from .robust import check_form, read_bounds, robust_problem


@dataclass(frozen=True, repr=False)
class AssemblyReport(Report):
    """What a check of a certificate about an assembly found.

    Attributes:
        assembly, wrenches: the question that it is about.
    """

    assembly: Assembly = field(default_factory=lambda: Assembly([]))
    wrenches: Wrenches = field(default_factory=dict)

    def asked(
        self,
        question: Any,
        pyramid: int | None = None,
        max_displacement: Fraction | None = None,
    ) -> AssemblyReport:
        """Return what this says of a question: nothing, if the certificate is about another one."""
        if question is None:
            return self
        problem, (assembly, wrenches) = self.problem, question
        if isinstance(assembly, Assembly):
            wrenches = assembly.read_wrenches(wrenches)
        if (assembly, wrenches) != (self.assembly, self.wrenches):
            problem = "it is about another assembly or other wrenches"
        elif max_displacement != self.max_displacement:
            problem = "it is about other displacements of contacts"
        return replace(self, problem=problem, compared=True)

    @property
    def to_compare(self) -> str:
        """How the command compares what it is about with a question."""
        return "not compared with an assembly: give --grasp FILE, whose file has the wrenches"

    @property
    def question(self) -> list[str]:
        """What it is about, in lines: the wrench on each body, and each contact."""
        lines = [f"wrench on {name} {vector_text(w)}" for name, w in self.wrenches.items()]
        for i, c in enumerate(self.assembly.contacts, 1):
            lines.append(f"contact {i} {c.pair} {c.contact.words}")
        return lines

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {
            "valid": bool(self),
            "certificate": self.kind,
            "leaves": self.leaves,
            **({"problem": self.problem} if self.problem else {}),
            **displacement_entry(self.max_displacement),
            "wrench": {name: list(map(to_text, w)) for name, w in self.wrenches.items()},
            "assembly": self.assembly.to_dict(),
            "compared": self.compared,
        }


def check_assembly(document: Mapping[str, Any]) -> AssemblyReport:
    """Check a certificate about an assembly.

    Raises:
        InputError: this is not a certificate, whatever its numbers are.
    """
    kind, assembly, wrenches = read_assembly_question(document)
    rows, form = joint_rows(assembly), _form(assembly)
    load = tuple(x for name in assembly.names for x in wrenches[name])
    bound = read_bound(document)
    if "bounds" in document:
        found = Report(kind, robust_problem(document, assembly, load), bounds=read_bounds(document))
    elif kind == "resisted":
        motion, forces = read_equilibrium(document, len(rows), form)
        problem = displacement_problem(rows, motion, bound)
        found = Report(kind, problem or law_problem(rows, load, motion, forces))
    elif isinstance(document["tree"], Mapping) and "part" in document["tree"]:
        found = _part(document["tree"], assembly, wrenches, bound)
    else:
        found = tree_report(document["tree"], TreeQuestion(rows, load, form, (), bound))
    return AssemblyReport(
        kind,
        found.problem,
        found.leaves,
        bounds=found.bounds,
        max_displacement=bound,
        assembly=assembly,
        wrenches=wrenches,
    )


def read_assembly_question(document: Mapping[str, Any]) -> tuple[str, Assembly, Wrenches]:
    """Return the kind of a certificate about an assembly, and what it is about.

    Raises:
        InputError: this is not such a certificate; its proof is not looked at.
    """
    kind = check_version(document)
    common = ("schema_version", "certificate", "assembly", "wrench")
    if "bounds" in document:
        check_form(document, kind, common)
    else:
        required = (*common, *KEYS[kind])
        check_keys(document, required, ("max_displacement",), "the certificate")
    assembly = Assembly.from_dict(document["assembly"])
    if "wrench" in document["assembly"] or any(body.outline for body in assembly.bodies):
        raise CertificateError("the assembly of a certificate has no wrench and no outlines")
    load = read_motion(document["wrench"], _form(assembly), "wrench")
    pairs = enumerate(assembly.names)
    return kind, assembly, {name: load[SIZE * k : SIZE * (k + 1)] for k, name in pairs}


def _form(assembly: Assembly) -> TreeForm:
    return TreeForm(SIZE * len(assembly.bodies), 1, tuple(STATES), assembly.names)


def joint_rows(assembly: Assembly) -> list[LawRow]:
    """Return the rows of the contacts in R^(3b), made without those of the solver."""
    place = {name: SIZE * k for k, name in enumerate(assembly.names)}
    rows = []
    for joint in assembly.contacts:
        lifted, c = [], joint.contact
        for wrench in frame(c):
            row = [Fraction(0)] * (SIZE * len(place))
            row[place[joint.body_a] : place[joint.body_a] + SIZE] = wrench
            if joint.body_b is not None:
                other = [-x for x in wrench]
                row[place[joint.body_b] : place[joint.body_b] + SIZE] = other
            lifted.append(tuple(row))
        rows.append(LawRow(tuple(lifted), c.friction, c.stiffness, c.preload, c.adhesion))
    return rows


def _part(
    tree: Mapping[str, Any],
    assembly: Assembly,
    wrenches: Wrenches,
    max_displacement: Fraction | None,
) -> Report:
    """Check a planar proof about the contacts of a part with the rest."""
    check_keys(tree, ("part", "contacts", "tree"), (), "tree")
    part = check_list(tree["part"], "tree.part")
    for name in part:
        if not isinstance(name, str) or name not in wrenches:
            raise CertificateError(f"tree.part has {shown(name)}; expected names of bodies")
    listed, joints = check_list(tree["contacts"], "tree.contacts"), assembly.contacts
    places = [read_index(i, f"tree.contacts[{k}]", len(joints)) for k, i in enumerate(listed)]
    inside = set(part)
    crossing = [i for i, j in enumerate(joints) if (j.body_a in inside) != (j.body_b in inside)]
    if sorted(places) != crossing or len(part) != len(inside):
        due = ", ".join(map(str, crossing))
        problem = f"tree.contacts: the contacts of the part with the rest are [{due}], each once"
        return Report("not resisted", problem)
    inward = [joints[i] if joints[i].body_a in inside else joints[i].reversed for i in places]
    zero: RationalVector = (Fraction(0),) * SIZE
    load = [sum(column) for column in zip(zero, *(wrenches[name] for name in part), strict=True)]
    grasp = Grasp(joint.contact for joint in inward)
    wrench = tuple(map(Fraction, load))
    question = TreeQuestion.of(grasp, wrench, max_displacement=max_displacement)
    report = tree_report(tree["tree"], question)
    if len({(joint.body_a, joint.body_b) for joint in inward}) > 1:
        problem = "tree.part: it touches the rest at more than one pair of bodies"
        return replace(report, problem=problem)
    return replace(report, problem=report.problem and f"tree.{report.problem}")
