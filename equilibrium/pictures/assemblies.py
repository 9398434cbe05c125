"""An assembly as a picture: bodies, contacts, forces on each body, wrenches, displaced bodies."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.scene import Floats, Legend, Scene
from arrangement.drawing.solids.flat_polygons import hull_corners
from arrangement.drawing.views import picture
from arrangement.numbers.exact import RationalVector, primitive, sign
from equilibrium.decide.solver import Solver
from equilibrium.decide.verdict import Verdict
from equilibrium.model.assembly import Assembly
from equilibrium.model.outline import Circle, Outline, Polygon, Segments
from equilibrium.wrench_sets.line import limit_words

from .body import Frame, closed_line, frame_around, stated_body
from .layout import DrawnBody, DrawnLoad, PlaneLayout
from .panel import clipped
from .style import symbol

#: Of lengths on paper, where several bodies share the picture.
_DETAIL = 0.7
#: Polygons and walls of the ground are drawn as far as this beyond the bodies.
_BEYOND = 0.15


@picture(20.0)
def draw_assembly(subject: Assembly | Verdict, *, width: float = 88.0) -> Scene:
    """Draw bodies and contacts; of a verdict the wrenches too, and an equilibrium if there is one.

    At a contact of two bodies two arrows show the force on either, at one with the ground that on
    the body; all arrows of forces and wrenches have one scale, which the bar states. A wrench is
    drawn on its line of action, where that is next to the middle of the body, a torque as an arc
    there. The displacement is drawn as dotted outlines, by a factor that is stated. A body without
    outline is drawn as the dashed hull of its contacts, or as dashed lines to them. The ground is
    drawn near the bodies, if it is stated, and a thread as a line.

    Args:
        subject: an assembly, or the verdict of one with its wrenches.
    """
    if isinstance(subject, Assembly):
        return _AssemblyLayout(subject).scene(width)[0]
    layout = _AssemblyLayout(subject.assembly, subject)
    scene, scale = layout.scene(width)
    _describe(scene.legend, layout, subject, scale)
    return scene


class _AssemblyLayout(PlaneLayout):
    """The bodies of an assembly, with the wrenches and an equilibrium of a verdict."""

    def __init__(self, assembly: Assembly, verdict: Verdict | None = None) -> None:
        contacts = [c.contact for c in assembly.contacts]
        points = [contact.point for contact in contacts]
        for body in assembly.bodies:
            points += body.outline.extremes if body.outline else ()
        for part in assembly.ground:
            points += part.extremes if isinstance(part, Circle) else ()
        points += [contact.thread for contact in contacts if contact.thread]
        frame = frame_around(points)
        motions = {} if verdict is None else verdict.motions
        bodies, middles = [], {}
        for k, body in enumerate(assembly.bodies, 1):
            touching = [
                i for i, c in enumerate(assembly.contacts) if body.name in (c.body_a, c.body_b)
            ]
            own = [contacts[i].point for i in touching]
            shape = body.outline or _hull(own)
            curves = [None] if shape is None else _curves(shape, frame)
            middle = _mean([*body.outline.extremes] if body.outline else own)
            middles[body.name] = middle
            if isinstance(shape, Segments):
                middle = _mean([*shape.segments[0]])  # the name stands at a wall
            bodies.append(
                DrawnBody(
                    curves[0],
                    body.outline is not None,
                    frame.paper(middle),
                    touching,
                    motions.get(body.name),
                    f"-{k}",
                    body.name,
                )
            )
            for j, curve in enumerate(curves[1:], 2):
                tag = f"-{k}-{j}"
                bodies.append(DrawnBody(curve, True, bodies[-1].middle, (), bodies[-1].motion, tag))
        bodies += [
            DrawnBody(curve, True, np.array(curve).mean(axis=0), (), tag=f"-ground-{j}")
            for j, curve in enumerate(_ground(assembly, frame, points), 1)
        ]
        super().__init__(frame, contacts, bodies, _DETAIL)
        self.numbers = [
            (str(i), place, -normal)
            for i, (place, normal) in enumerate(zip(self.places, self.normals, strict=True), 1)
        ]
        forces: list[list[RationalVector]] = [[] for _ in contacts]
        if verdict is not None:
            self.states = verdict.states
            for i, share in enumerate(verdict.forces):
                force = contacts[i].total_force(share)
                back = [] if assembly.contacts[i].body_b is None else [tuple(-x for x in force)]
                forces[i] = [force, *back]
        loads, wrenches = [], {} if verdict is None else verdict.wrenches
        for k, (name, wrench) in enumerate(wrenches.items(), 1):
            pushes = any(wrench[:2])
            place = _line_of_action(wrench, middles[name]) if pushes else middles[name]
            turn, names = 0 if pushes else sign(wrench[2]), (f"wrench-{k}", f"torque-{k}")
            loads.append(DrawnLoad(wrench[:2], turn, frame.paper(place), names))
        self.scale_forces(forces, loads)


def _curves(outline: Outline, frame: Frame) -> list[Floats | None]:
    """Return the parts of an outline as cubic control points; a thin wall is there and back."""
    if isinstance(outline, Segments):
        return [closed_line([frame.paper(end) for end in ends]) for ends in outline.segments]
    return [stated_body(outline, frame)]


def _ground(assembly: Assembly, frame: Frame, points: list[RationalVector]) -> list[Floats]:
    """Return the shapes of the ground as cubic control points, those with edges near points."""
    places = np.array([frame.paper(point) for point in points]).reshape(-1, 2)
    curves = []
    for shape in assembly.ground:
        if isinstance(shape, Circle) or not len(places):
            curves += [curve for curve in _curves(shape, frame) if curve is not None]
            continue
        lines = shape.segments if isinstance(shape, Segments) else [shape.extremes]
        for line in lines:
            ends = np.array([frame.paper(end) for end in line])
            for direction in np.array([[1, 0], [-1, 0], [0, 1], [0, -1]]):
                ends = clipped(ends, direction, float((places @ direction).min()) - _BEYOND)
            if len(ends):
                curves.append(closed_line(list(ends)))
    return curves


def _hull(points: list[RationalVector]) -> Polygon | None:
    """Return the convex hull of points in the plane; None if they lie in a line."""
    in_space = (primitive((*p, Fraction(0), Fraction(1))) for p in points)
    corners = hull_corners((0, 0, 1, 0), in_space)
    if len(corners) < 3:
        return None
    return Polygon((Fraction(x, w), Fraction(y, w)) for x, y, _, w in corners)


def _mean(points: list[RationalVector]) -> RationalVector:
    """Return the mean of points in the plane; of none, the origin."""
    return tuple(
        sum(column, Fraction(0)) / len(points) for column in zip(*points, strict=True)
    ) or (Fraction(0), Fraction(0))


def _line_of_action(wrench: RationalVector, point: RationalVector) -> RationalVector:
    """Return the place on the line of action of a force that is next to a point."""
    (x, y), (u, v, torque) = point, wrench
    rest = (torque - (x * v - y * u)) / (u * u + v * v)
    return x + rest * v, y - rest * u


def _describe(legend: Legend, layout: _AssemblyLayout, verdict: Verdict, scale: float) -> None:
    """Describe in words and keys what is drawn, and at what scale forces are."""
    if verdict.solution is None:
        legend.line(f"{verdict.verdict}: {verdict.reason}", emphasis=True)
    if verdict.doubt:
        legend.line(verdict.doubt, emphasis=True)
    if any(any(w) for w in verdict.wrenches.values()):
        legend.key(symbol("wrench"), "wrench on a body")
    if any(layout.arms):
        legend.key(symbol("force"), "contact force on a body")
    motion = f"displacement × {LABEL.number(layout.step)}" if layout.step else ""
    layout.explain(legend, motion, scale, verdict.assembly.units)
    solver = Solver(verdict.assembly, verdict.max_displacement)
    for line in limit_words(solver, verdict.wrenches):
        legend.line(line)
