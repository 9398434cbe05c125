"""The parts of the motions that a proof is made of, as regions of rotation centres on two maps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from arrangement.console.number_form import LABEL
from arrangement.drawing.registry import Exact
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.scene import area
from arrangement.numbers.exact import IntegerVector, RationalVector, primitive, rational
from arrangement.numbers.linear.cones import generators
from arrangement.numbers.linear.polyhedron import Polyhedron, from_conditions
from equilibrium.certificate.leaves import ClosedPart, parts
from equilibrium.core.contact_rows import negated, normal_force_row, slip_row
from equilibrium.decide.solver import Solver
from equilibrium.decide.verdict import Verdict
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.parts.body import Frame, frame_of
from equilibrium.pictures.parts.style import Wrench, nice_near
from equilibrium.pictures.parts.window import Window

#: Half the side of the maps, where the contacts fill [-1, 1].
MAP = 3
#: The senses of rotation, r > 0 and r < 0, and their names.
TURNS = {1: "counter-clockwise", -1: "clockwise"}


class Shape(NamedTuple):
    """A part of the motions where it meets the rotations of one sense: a polygon of centres."""

    part: ClosedPart
    sense: int
    corners: Floats


@dataclass(frozen=True)
class ProofMaps:
    """The parts of a proof and what the maps show of them.

    Attributes:
        angle: of the rotations that are shown; None if regions do not depend on it.
        ranks: the virtual motions, from the one with the largest regions on.
    """

    verdict: Verdict
    parts: Sequence[ClosedPart]
    angle: Fraction | None
    window: Window
    shapes: Sequence[Shape]
    ranks: Mapping[RationalVector, int]


def proof_maps(grasp: Grasp, wrench: Wrench, rotation: Exact | None) -> ProofMaps:
    """Return the maps of the proof that a wrench is not resisted (see `draw_proof`).

    Raises:
        GraspError: the wrench is resisted, or a rotation that is not above 0.
    """
    verdict = Solver(grasp).solve(wrench)
    if verdict.stable:
        raise GraspError(
            "the wrench is resisted, so no proof refutes it; the view grasp shows what balances it"
        )
    frame = frame_of(grasp, grasp.outline)
    found = list(parts(verdict.proof))
    angle = _angle(grasp, frame, found, rotation)
    window = Window(frame.centre, MAP * frame.half)
    shapes = [
        Shape(part, sense, corners)
        for part in found
        for sense in TURNS
        if (centres := _centres(part, grasp, sense, angle)) is not None
        and (corners := window.inside(centres)) is not None
    ]
    sizes: dict[RationalVector, float] = {part.leaf.motion: 0.0 for part in found}
    for shape in shapes:
        sizes[shape.part.leaf.motion] += area(shape.corners)
    ranks = {motion: i for i, motion in enumerate(sorted(sizes, key=lambda m: -sizes[m]))}
    return ProofMaps(verdict, found, angle, window, shapes, ranks)


def _angle(
    grasp: Grasp, frame: Frame, found: list[ClosedPart], rotation: Exact | None
) -> Fraction | None:
    """Return the rotation to be shown; None if regions do not depend on the size of motions."""
    if rotation is not None:
        angle = rational(rotation, "rotation")
        if angle <= 0:
            raise GraspError(f"rotation is {angle}; it must be above 0")
        return angle
    plain = all(g[0] == 0 or not any(g[1:]) for part in found for g in part.region)
    if plain and not any(grasp.contacts[i].preload for part in found for i in part.states):
        return None
    reach = max((c.preload / c.stiffness for c in grasp if c.stiffness), default=Fraction(0))
    angle = nice_near(reach / frame.half or Fraction(1))
    rows = (row for part in found for row, _ in _conditions(part, grasp))
    borders = {Fraction(abs(zero), abs(r)) for x, y, r, zero in rows if r and not (x or y)}
    while angle in borders:
        angle *= Fraction(9, 10)
    return angle


def _conditions(part: ClosedPart, grasp: Grasp) -> Iterator[tuple[IntegerVector, bool]]:
    """Yield rows ``a . (x, y, r, d_0) >= 0`` of a part, and whether ``= 0`` is meant instead."""
    for zero, *row in generators(part.region, (), 4)[0]:
        yield (*row, zero), False
    for i, state in part.states.items():
        spring, slip = normal_force_row(grasp.contacts[i]), slip_row(grasp.contacts[i])
        yield primitive(negated(spring) if state == "detached" else spring), False
        if state not in ("detached", "attached"):
            yield primitive(negated(slip) if state == "slip-" else slip), state == "stick"


def _centres(
    part: ClosedPart, grasp: Grasp, sense: int, angle: Fraction | None
) -> Polyhedron | None:
    """Return the centres of the rotations of a part, of one sense and angle."""
    rows: dict[bool, list[IntegerVector]] = {False: [], True: []}
    for (x, y, r, zero), equal in _conditions(part, grasp):
        constant = sense * r + (zero / angle if angle else 0)
        if any(row := primitive((-sense * y, sense * x, constant))):
            rows[equal].append(row)
    return from_conditions(rows[False], rows[True], 2)


def summary_lines(maps: ProofMaps, named: int) -> Iterator[str]:
    """Yield what is shown, in words; `named` virtual motions are named beside."""
    some = f", {named} of them named" if len(maps.ranks) > named else ""
    yield (
        f"w = {LABEL.vector(maps.verdict.wrench)} is not resisted; "
        + (f"{maps.verdict.doubt}; " if maps.verdict.doubt else "")
        + f"regions of motions: {len(maps.parts)}; "
        f"virtual motions λ = (x, y, r): {len(maps.ranks)}{some}"
    )
    yield (
        "regions: motions of every size; farther centres and translations lie beyond the edges"
        if maps.angle is None
        else f"regions: only the motions with r = {LABEL.number(maps.angle)} (left) and r = "
        f"{LABEL.number(-maps.angle)} (right) are shown; the proof has all"
    )
