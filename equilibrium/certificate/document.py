"""Certificates of verdicts as documents; `equilibrium.certificate.reading` says what is in them."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

from arrangement.console.number_form import ReprMixin
from arrangement.console.writing import write_text_atomically
from arrangement.numbers.exact import RationalVector
from equilibrium.model.assembly import Assembly
from equilibrium.model.displacement import displacement_entry
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Leaf, Solution
from equilibrium.model.subject import Subject, by_body, points_of, texts

from .checker import check
from .reading import SCHEMA_VERSION
from .report import Report


@dataclass(frozen=True)
class Certificate(ReprMixin):
    """A proof of a verdict: `text` is compact JSON. `to_dict` gives a fresh copy."""

    text: str

    def __repr__(self) -> str:
        return f"<Certificate: {self.kind}, {len(self.text)} bytes>"

    @property
    def kind(self) -> str:
        """Either "resisted" or "not resisted"."""
        return str(self.to_dict()["certificate"])

    def to_dict(self) -> dict[str, Any]:
        """Return the JSON document."""
        document: dict[str, Any] = json.loads(self.text)
        return document

    def verify(self) -> Report:
        """Check the certificate; see `check`."""
        return check(self.to_dict())

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the certificate as a JSON file, whole or not at all; `verify` checks it there.

        Raises:
            InputError: the place cannot be written.
        """
        write_text_atomically(path, self.text + "\n")


def resisted_certificate(
    subject: Subject,
    load: RationalVector,
    solution: Solution,
    pyramid: int | None = None,
    max_displacement: Fraction | None = None,
) -> Certificate:
    """Return the certificate of an equilibrium: its motion and forces, or the box that holds it."""
    box = solution.box
    if box is None:
        motion = texts(by_body(subject, solution.motion))
        proof = {"motion": motion, "forces": list(map(texts, solution.forces))}
        return certificate("resisted", subject, load, pyramid, max_displacement, **proof)
    friction = [
        "detached" if share is None else texts(share) if share else "slip" for share in box.friction
    ]
    form = {
        "basis": list(map(texts, box.basis)),
        "friction": friction,
        "pillars": [list(pair) for pair in box.pillars],
        "centre": texts(box.centre),
        "radius": texts(box.radius),
        "inverse": list(map(texts, box.inverse)),
    }
    if box.idle:
        form["idle"] = list(map(texts, box.idle))
    return certificate("resisted", subject, load, max_displacement=max_displacement, enclosure=form)


def certificate(
    kind: str,
    subject: Subject,
    load: RationalVector,
    pyramid: int | None = None,
    max_displacement: Fraction | None = None,
    **proof: Any,
) -> Certificate:
    """Return the certificate of a verdict.

    Args:
        subject: a grasp, or an assembly; then the load has the wrenches on its bodies in a row.
        pyramid: edges of friction pyramids; None for round cones.
        proof: by the keys of `equilibrium.certificate.reading`, or of a verdict for all grasps
            within bounds those of `equilibrium.certificate.robust`.
    """
    if pyramid is not None:
        proof = {"pyramid": pyramid, **proof}
    # A proof is about these numbers, whether they were given or assumed, and about points.
    points = (
        replace(c, stiffness_given=True, share=Fraction(1), thread=()) for c in points_of(subject)
    )
    question: dict[str, Any]
    if isinstance(subject, Assembly):
        pairs = zip(subject.contacts, points, strict=True)
        touching = [replace(c, contact=point) for c, point in pairs]
        question = {"assembly": Assembly(subject.names, touching, subject.units).to_dict()}
    else:
        question = {"grasp": Grasp(points, subject.units).to_dict()}
    question["wrench"] = texts(by_body(subject, load))
    question |= displacement_entry(max_displacement)
    document = {"schema_version": SCHEMA_VERSION, "certificate": kind, **question, **proof}
    # A proof about one part of an assembly is planar, as one about a grasp.
    tree = proof.get("tree")
    is_flat = isinstance(subject, Grasp) or (isinstance(tree, dict) and "part" in tree)
    write = partial(_leaf_entry, None if is_flat else subject)
    return Certificate(json.dumps(document, separators=(",", ":"), default=write))


def _leaf_entry(assembly: Subject | None, leaf: Leaf) -> Any:
    """Return the JSON form of a leaf; of an assembly with motions by the names of bodies."""
    is_long, motion = assembly is not None, texts(leaf.motion)
    if assembly is not None:
        rows_by_name = by_body(assembly, leaf.motion).items()
        motion = {name: texts(row) for name, row in rows_by_name if any(row)}
    elif not (leaf.multipliers or leaf.displacements):
        return motion
    rows = {
        str(i): texts(row if is_long or any(row[1:]) else row[:1])
        for i, row in leaf.multipliers.items()
    }
    moved = {str(i): texts(row) for i, row in leaf.displacements.items()}
    return {
        "virtual_motion": motion,
        **({"multipliers": rows} if rows or not is_long else {}),
        **({"displacements": moved} if moved else {}),
    }
