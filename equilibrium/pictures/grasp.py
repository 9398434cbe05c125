"""The grasp as a picture: object, contacts, friction cones, preload, wrench, forces, motion."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.scene import Floats, Scene, curve_points
from arrangement.drawing.views import Corner, Exact, Vector, picture
from arrangement.numbers.exact import sign
from equilibrium.decide.solver import Solver
from equilibrium.decide.verdict import Verdict
from equilibrium.model.assembly import Assembly
from equilibrium.model.displacement import NOT_SMALL, displacement_words
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.outline import Polygon
from equilibrium.model.solution import Solution
from equilibrium.plane.states.contact_states import states_at
from equilibrium.plane.states.equilibrium import Equilibrium
from equilibrium.wrench_sets.line import limit_words

from .assemblies import draw_assembly
from .body import body, frame_of, free_lengths, stated_body
from .layout import DrawnBody, DrawnLoad, PlaneLayout
from .space_grasp import decided_in_space, drawn_in_space, solved_in_space
from .style import Wrench, explain_grasp, nearest_float

#: The length of a friction cone on paper, and points on its rim.
CONE, _RIM = 0.42, 17


@picture(20.0)
def draw_grasp(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    outline: Iterable[Corner] | None = None,
    equilibrium: int = 1,
    camera: Vector | None = None,
    azimuth: float = 0.0,
    max_displacement: Exact | None = None,
    width: float = 88.0,
) -> Scene:
    """Draw contacts with friction cones and preloads; with a wrench, the equilibrium too.

    Forces are those on the object; all arrows of forces have one scale, which the bar states. The
    mark of a contact shows by shape its state at the motion drawn. The virtual motion is drawn as
    the displaced outline (of a grasp without outline, as arrows at the contacts), to first order,
    by a factor that is stated. The outline is that of the grasp; where none is stated, it is dashed
    and only indicative (see `body`), and where no simple curve passes through the contacts, dashed
    lines join them.
    Where the origin of the frame is far from the contacts, the wrench is carried to their middle.

    A grasp in space is drawn from a direction. Hidden edges of its body are dashed, what is behind
    or inside the body shines through; without a mesh as outline, dashed lines show the hull of the
    contacts. The motion is drawn as a turn about an axis with its pitch, and as slips of contacts.

    Args:
        grasp: contacts; none, coincident ones and coordinates of any size are possible.
        wrench: applied wrench (f_x, f_y, tau), with the torque about the origin, or six numbers in
            space; if omitted, none acts and nothing is solved.
        outline: exact corners of the object in the plane, which replace the outline of the grasp.
        equilibrium: number of the equilibrium in the plane (see `solve`), from 1.
        camera: exact vector to the viewer, in space; if omitted, one from above that sees forces
            from the side.
        azimuth: degrees by which the viewer moves to the right, in space.
        max_displacement: count only equilibria up to this exact displacement (see `solve`).

    Raises:
        GraspError: a bad outline, or no such equilibrium.
    """
    if grasp.dimension == 3:
        if outline is not None or equilibrium != 1:
            raise GraspError("outline and equilibrium are for grasps in the plane; leave them out")
        solid, note = solved_in_space(grasp, wrench, max_displacement)
        return drawn_in_space(solid, camera, azimuth, width, note)
    if camera is not None or azimuth:
        raise GraspError(
            "the grasp is in the plane; camera, azimuth, .gif and .mp4 are for grasps in space. "
            "Write -o FIGURE.svg, or see `equilibrium lab -o LAB.html`"
        )
    if wrench is None and equilibrium != 1:
        raise GraspError("without a wrench nothing is solved; give one with the equilibrium")
    solver = Solver(grasp, max_displacement)
    verdict = None if wrench is None else solver.solve(wrench)
    scene = drawn(GraspLayout(grasp, verdict, outline, equilibrium), width)
    for line in () if verdict is None else limit_words(solver, verdict.wrench):
        scene.legend.line(line)
    return scene


def verdict_scene(verdict: Verdict, width: float = 88.0) -> Scene:
    """Return the picture of a verdict: bodies with their wrenches, and an equilibrium if any."""
    if isinstance(verdict.subject, Assembly):
        return draw_assembly.scene(verdict, width=width)
    if verdict.grasp.dimension == 3:
        solid, note = decided_in_space(verdict)
        return drawn_in_space(solid, None, 0.0, width, note)
    return drawn(GraspLayout(verdict.grasp, verdict), width)


class GraspLayout(PlaneLayout):
    """A grasp as one body against the ground (see `draw_grasp` for the arguments).

    Attributes:
        body: the object.
        equilibrium: that is drawn, if there is one; or `of_method`, the motion and the forces of
            another method, which have no contact states.
        by_model: whether it is an equilibrium of the full model.
        moved: whether the wrench is drawn about the middle of the contacts, as the origin is far.
        applied: the wrench as it is drawn.
        states: often on the boundary of the set of solutions, where a contact that may slip does
            not.
    """

    def __init__(
        self,
        grasp: Grasp,
        verdict: Verdict | None = None,
        outline: Iterable[Iterable[Any]] | None = None,
        equilibrium: int = 1,
        of_method: Solution | None = None,
    ) -> None:
        self.grasp, self.verdict, self.by_model = grasp, verdict, of_method is None
        self.equilibrium = _chosen(verdict, equilibrium) if of_method is None else of_method
        shape = grasp.outline if outline is None else Polygon(outline)
        frame = frame_of(grasp, shape)
        curve = body(grasp, frame) if shape is None else stated_body(shape, frame)
        self.moved = any(abs(x) > Fraction(3, 2) * frame.half for x in frame.centre)
        middle = frame.centre if self.moved else (Fraction(0), Fraction(0))
        motion = None if self.equilibrium is None else self.equilibrium.motion
        places = [frame.paper(c.point) for c in grasp] or [frame.paper(middle)]
        self.body = DrawnBody(
            curve, shape is not None, np.mean(places, axis=0), range(len(grasp)), motion
        )
        super().__init__(frame, grasp.contacts, [self.body])
        self.origin = frame.paper(middle)
        self.cones = [
            _cone_rim(curve, place, normal, contact.friction)
            for contact, place, normal in zip(grasp, self.places, self.normals, strict=True)
        ]
        self.applied, loads = None, []
        if verdict is not None:
            x, y, torque = verdict.wrench
            self.applied = (x, y, torque - (middle[0] * y - middle[1] * x))
            names = ("wrench-force", "wrench-torque")
            loads.append(DrawnLoad((x, y), sign(self.applied[2]), self.origin, names))
        shares = () if self.equilibrium is None else self.equilibrium.forces
        forces = [[c.total_force(share)] for c, share in zip(grasp, shares, strict=False)]
        self.scale_forces(forces or [[]] * len(grasp), loads, [c.preload for c in grasp])
        if motion is not None and self.by_model:
            self.states = states_at(grasp, motion)
        pads = [np.array(self.places[group.start : group.stop]) for group in grasp.groups]
        # Points of a pad lie on a line: the two that are farthest apart are its ends.
        self.pads = [points[np.lexsort(points.T)[[0, -1]]] for points in pads if len(points) > 1]
        self.numbers = [
            (str(i), frame.paper(contact.point), -self.normals[group.start])
            for i, (group, contact) in enumerate(zip(grasp.groups, grasp.joined(), strict=True), 1)
        ]


def drawn(layout: GraspLayout, width: float, tallest: float | None = None) -> Scene:
    """Return the picture; see `fit_sheet` for its size."""
    scene, scale = layout.scene(width, tallest)
    for line, emphasis in _lines(layout):
        scene.legend.line(line, emphasis)
    applied = () if layout.verdict is None else layout.verdict.wrench
    explain_grasp(scene.legend, layout.grasp, applied, any(layout.arms))
    motion = ""
    if layout.equilibrium is not None and layout.step is not None:
        shown = LABEL.vector(layout.equilibrium.motion)
        motion = f"motion (x, y, r) = {shown} × {LABEL.number(layout.step)}"
    layout.explain(scene.legend, motion, scale, layout.grasp.units)
    return scene


def _chosen(verdict: Verdict | None, number: int) -> Equilibrium | Solution | None:
    """Return an equilibrium by its number; of many contacts the one that was found is the first."""
    if verdict is None or (number == 1 and not (verdict.stable and verdict.lists_all())):
        return None if verdict is None else verdict.solution
    if not 1 <= number <= len(verdict.equilibria):
        raise GraspError(
            f"the equilibrium is number {number}; their number is {len(verdict.equilibria)}"
        )
    equilibrium: Equilibrium = verdict.equilibria[number - 1]
    return equilibrium


def _cone_rim(curve: Floats | None, place: Floats, normal: Floats, friction: Fraction) -> Floats:
    """Return points on the rim of a friction cone from edge to edge; their number is odd.

    It stays inside the outline, if there is one, and is shorter on all sides where that helps.
    """
    half = math.atan(nearest_float(friction))
    angles: Floats = math.atan2(normal[1], normal[0]) + np.linspace(-half, half, _RIM)
    directions: Floats = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    if curve is None:
        return place + CONE * directions
    free = free_lengths(curve_points(curve), place, angles)
    reach = np.minimum(free, max(min(CONE, 0.92 * float(free.min())), CONE / 2))
    return place + reach[:, None] * directions


def _lines(layout: GraspLayout) -> Iterator[tuple[str, bool]]:
    verdict, equilibrium = layout.verdict, layout.equilibrium
    if verdict is None or not layout.by_model:
        return
    if layout.moved:
        assert layout.applied is not None
        torque = LABEL.number(layout.applied[2])
        yield f"w drawn about the middle of the contacts, torque {torque}", False
    if equilibrium is not None and layout.step is None:
        yield "no motion", False
    if verdict.warnings:
        yield NOT_SMALL, True
    if verdict.doubt:
        yield verdict.doubt, True
    if equilibrium is None:
        yield f"no equilibrium{displacement_words(verdict.max_displacement)}", True
    elif isinstance(equilibrium, Solution):
        yield "the equilibrium found; there may be others", False
    else:
        notes = []
        if len(verdict.equilibria) > 1:
            place = verdict.equilibria.index(equilibrium) + 1
            notes.append(f"equilibrium {place} of {len(verdict.equilibria)}")
        if not equilibrium.unique:
            what = "motion" if equilibrium.forces_determined else "motion and forces"
            notes.append(f"{what} not unique; the minimum-norm solution is drawn")
        if notes:
            yield "; ".join(notes), False
