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
from dataclasses import replace
from fractions import Fraction
from typing import Any

from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import RationalVector, shown
from equilibrium.model.assembly import SIZE, Assembly, Wrenches
from equilibrium.model.errors import CertificateError
from equilibrium.model.grasp import Grasp
from equilibrium.model.subject import LoadCase, by_body, flat

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


def check_assembly(document: Mapping[str, Any]) -> Report:
    """Check a certificate about an assembly.

    Raises:
        InputError: this is not a certificate, whatever its numbers are.
    """
    kind, assembly, wrenches = read_assembly_question(document)
    rows, form = joint_rows(assembly), _form(assembly)
    load, bound = flat(assembly, wrenches), read_bound(document)
    if "bounds" in document:
        problem = robust_problem(document, assembly, load)
        report = Report(kind, problem, bounds=read_bounds(document))
    elif kind == "resisted":
        motion, forces = read_equilibrium(document, len(rows), form)
        problem = displacement_problem(rows, motion, bound)
        report = Report(kind, problem or law_problem(rows, load, motion, forces))
    elif isinstance(document["tree"], Mapping) and "part" in document["tree"]:
        report = _part(document["tree"], assembly, wrenches, bound)
    else:
        report = tree_report(document["tree"], TreeQuestion(rows, load, form, (), bound))
    return replace(report, case=LoadCase(assembly, load, bound))


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
    return kind, assembly, by_body(assembly, load)


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
