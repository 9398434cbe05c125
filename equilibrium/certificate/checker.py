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
from dataclasses import replace
from fractions import Fraction
from typing import Any

from arrangement.numbers.exact import RationalVector
from equilibrium.model.assembly import Assembly
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.displacement import along_tangents
from equilibrium.model.errors import CertificateError, GraspError
from equilibrium.model.grasp import Grasp, in_plane
from equilibrium.model.solution import Solution
from equilibrium.model.subject import LoadCase, points_of

from .assemblies import part_report
from .enclosure import enclosure_problem
from .law import displacement_problem, law_problem, law_rows, rows_of
from .leaf_rule import TreeQuestion
from .reading import VERSIONS, form_of, read_case, read_enclosure, read_equilibrium, read_plane
from .report import Question, Report
from .robust import read_bounds, robust_problem
from .tree import tree_report


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
    if isinstance(document, Mapping) and "parameter" in document:
        # Few certificates are about a parameter, and polynomials take a while to import.
        from .parameter import check_parameter

        return check_parameter(document).asked(question)
    kind, case = read_case(document)
    if "bounds" in document:
        problem = robust_problem(document, case.subject, case.load)
        report = Report(kind, problem, bounds=read_bounds(document))
    else:
        proof = document["tree"] if kind == "not resisted" else _read_solution(document, case)
        report = proof_report(case, proof)
        if report.problem and kind == "not resisted":
            hint = VERSIONS[document["schema_version"]]
            report = replace(report, problem=report.problem + hint)
    return replace(report, case=case).asked(question, pyramid, max_displacement)


def proof_report(case: LoadCase, proof: Solution | Any) -> Report:
    """Check an equilibrium, or a tree.

    Raises:
        InputError: a node of the tree is none, or does not fit its place.
    """
    edges = edges_of(case)
    if not isinstance(proof, Solution):
        return _tree_report(case, proof, edges)
    if proof.box is not None and isinstance(case.subject, Grasp):
        problem = enclosure_problem(case.subject, case.load, proof.box, case.max_displacement)
        return Report("resisted", problem)
    rows = rows_of(case.subject)
    problem = displacement_problem(rows, proof.motion, case.max_displacement)
    problem = problem or law_problem(rows, case.load, proof.motion, proof.forces, edges)
    return Report("resisted", problem)


def _tree_report(case: LoadCase, tree: Any, edges: Sequence[RationalVector]) -> Report:
    """Check a tree; it may be one in the plane, which has all contacts and the load, or a part."""
    subject, bound = case.subject, case.max_displacement
    if isinstance(subject, Assembly):
        if isinstance(tree, Mapping) and "part" in tree:
            joints = subject.contacts
            bodies = [(joint.body_a, joint.body_b) for joint in joints]
            own = law_rows(joint.contact for joint in joints)
            return part_report(tree, bodies, own, case.wrench, max_displacement=bound)
    elif subject.dimension == 3 and (plane := read_plane(tree)) is not None:
        if edges:
            raise CertificateError("tree.plane is for round cones")
        try:
            flat, load = in_plane(subject, case.load, plane.axes)
        except GraspError as error:
            return Report("not resisted", f"tree.plane: {error}")
        if bound is not None and not along_tangents(subject, plane.axes):
            problem = "displacements along tangents that are at an angle to the plane are bounded"
            return Report("not resisted", f"tree.plane: {problem}")
        return tree_report(plane.tree, TreeQuestion.of(flat, load, max_displacement=bound))
    return tree_report(tree, TreeQuestion.of(subject, case.load, edges, bound))


def _read_solution(document: Mapping[str, Any], case: LoadCase) -> Solution:
    """Return the equilibrium of a certificate, or the box that holds it."""
    contacts, form = len(points_of(case.subject)), form_of(case.subject)
    if "enclosure" in document:
        return Solution((), (), read_enclosure(document["enclosure"], contacts, form))
    motion, forces = read_equilibrium(document, contacts, form)
    return Solution(motion, tuple(forces))


def edges_of(case: LoadCase) -> tuple[RationalVector, ...]:
    """Return the edges of friction pyramids, none for round cones."""
    return () if case.pyramid is None else pyramid_edges(case.pyramid)
