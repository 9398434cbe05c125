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

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from arrangement.numbers.exact import RationalVector
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.displacement import along_tangents
from equilibrium.model.errors import CertificateError, GraspError
from equilibrium.model.grasp import Grasp, in_plane
from equilibrium.model.solution import Solution
from equilibrium.model.subject import LoadCase

from .assemblies import check_assembly
from .enclosure import enclosure_problem
from .law import displacement_problem, law_problem, law_rows
from .leaf_rule import TreeQuestion
from .reading import (
    FORMS,
    read_bound,
    read_enclosure,
    read_equilibrium,
    read_plane,
    read_question,
)
from .report import Question, Report, tree_report
from .robust import read_bounds, robust_problem


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
    about = "assembly" if isinstance(document, Mapping) and "assembly" in document else "grasp"
    return _CHECKS[about](document).asked(question, pyramid, max_displacement)


def _check_grasp(document: Mapping[str, Any]) -> Report:
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
    return replace(report, case=LoadCase(grasp, wrench, bound, document.get("pyramid")))


#: The check of each form of certificate, by the key of what it is about.
_CHECKS: Mapping[str, Callable[[Mapping[str, Any]], Report]] = {
    "assembly": check_assembly,
    "grasp": _check_grasp,
}


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
