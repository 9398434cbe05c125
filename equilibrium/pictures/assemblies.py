"""An assembly as a picture: bodies, contacts, forces on each body, wrenches, displaced bodies."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.colours import BLACK, BLUE, GREY, PALE, VERMILION
from arrangement.drawing.scene.curves import flattened
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import Labels
from arrangement.drawing.scene.places import near
from arrangement.drawing.scene.scene import AROUND, Scene, arrow, fitted, turning_arrow
from arrangement.drawing.views import picture
from arrangement.numbers.exact import RationalVector
from equilibrium.decide.assemblies.solver import AssemblySolver
from equilibrium.decide.assemblies.verdict import AssemblyVerdict
from equilibrium.model.assembly import Assembly, RigidBody
from equilibrium.model.outline import Polygon
from equilibrium.wrench_sets.margin import limit_words

from .body import Frame, stated_body
from .style import bar, mark, nice_near, symbol

#: Lengths on paper, where the bodies fill [-1, 1]: the largest force, the arc of a torque, the
#: largest displacement, half a pad.
_FORCE, _ARC, _MOVED, _PAD = 0.45, 0.1, 0.15, 0.05
_DASHES = (0, (5, 2.5))
_DOTS = (0, (1, 1.5))


@picture(20.0)
def draw_assembly(subject: Assembly | AssemblyVerdict, *, width: float = 88.0) -> Scene:
    """Draw bodies and contacts; of a verdict the wrenches too, and an equilibrium if there is one.

    At a contact of two bodies two arrows show the force on either, at one with the ground that on
    the body; all arrows of forces and wrenches have one scale, which the bar states. A wrench is
    drawn on its line of action, where that is next to the middle of the body, a torque as an arc
    there. The displacement is drawn as dotted outlines, by a factor that is stated. A body without
    outline is drawn as the dashed hull of its contacts, or as dashed lines to them.

    Args:
        subject: an assembly, or the verdict of one with its wrenches.
    """
    verdict = subject if isinstance(subject, AssemblyVerdict) else None
    assembly = subject.assembly if isinstance(subject, AssemblyVerdict) else subject
    plan = _AssemblyPlan(assembly, verdict)
    scene, scale, shift = fitted(width, (plan.content(), AROUND))
    _AssemblyPicture(plan, scene, scale, shift).all()
    _describe(plan, scene, scale)
    return scene


class _AssemblyPlan:
    """What a picture shows, in paper coordinates.

    Attributes:
        curves: of bodies with outline, control points; middles: of all bodies.
        reference: the largest force, exact; step: the factor of displacements, or None.
    """

    def __init__(self, assembly: Assembly, verdict: AssemblyVerdict | None) -> None:
        self.assembly, self.verdict = assembly, verdict
        points = [c.contact.point for c in assembly.contacts]
        for body in assembly.bodies:
            points += body.outline.extremes if body.outline else ()
        self.frame = _frame(points)
        shapes = {body.name: body.outline or self._hull(body.name) for body in assembly.bodies}
        self.curves = {
            name: stated_body(shape, self.frame) for name, shape in shapes.items() if shape
        }
        self.centres = {body.name: self._centre(body) for body in assembly.bodies}
        self.middles = {name: self.frame.paper(c) for name, c in self.centres.items()}
        self.motions = {} if verdict is None else verdict.motions
        shares = () if verdict is None else verdict.forces
        pairs = zip(assembly.contacts, shares, strict=False)
        self.forces = [(pressed - c.contact.adhesion, rubbed) for c, (pressed, rubbed) in pairs]
        loads = () if verdict is None else verdict.wrenches.values()
        sizes = [abs(x) for row in (*self.forces, *(w[:2] for w in loads)) for x in row]
        self.reference = max(sizes, default=Fraction(0))
        self.step = self._step()

    def _hull(self, name: str) -> Polygon | None:
        """Return the convex hull of the contacts of a body; None if they lie in a line."""
        touching = (c for c in self.assembly.contacts if name in (c.body_a, c.body_b))
        points = sorted({c.contact.point for c in touching})
        sides = []
        for order in (points, points[::-1]):
            side: list[RationalVector] = []
            for point in order:
                while len(side) > 1 and _turn(side[-2], side[-1], point) <= 0:
                    side.pop()
                side.append(point)
            sides += side[:-1]
        return Polygon(sides) if len(sides) > 2 else None

    def _centre(self, body: RigidBody) -> RationalVector:
        """Return the middle of the outline of a body, else of its contacts."""
        points = list(body.outline.extremes) if body.outline else []
        touching = (c for c in self.assembly.contacts if body.name in (c.body_a, c.body_b))
        points = points or [c.contact.point for c in touching] or [(Fraction(0),) * 2]
        return tuple(sum(column, Fraction(0)) / len(points) for column in zip(*points, strict=True))

    def _step(self) -> Fraction | None:
        """Return a round factor that makes the largest displacement of a contact visible."""
        moved = [
            max(map(abs, _moved(self.motions[name], c.contact.point)))
            for c in self.assembly.contacts
            for name in (c.body_a, c.body_b)
            if name is not None and self.motions
        ]
        largest = max(moved, default=Fraction(0))
        return nice_near(Fraction(_MOVED) * self.frame.half / largest) if largest else None

    def displaced(self, name: str) -> Floats | None:
        """Return the outline of a body where it is displaced to, by `step`, to first order."""
        if self.step is None or not any(self.motions[name]) or name not in self.curves:
            return None
        x, y, turn = (float(self.step * v) for v in self.motions[name])
        half, (a, b) = float(self.frame.half), map(float, self.frame.centre)
        curve = self.curves[name]
        places = curve * half + np.array([a, b])
        change = np.stack([x - turn * places[:, 1], y + turn * places[:, 0]], axis=1)
        found: Floats = curve + change / half
        return found

    def arm(self, force: RationalVector) -> Floats | None:
        """Return a force on paper; None of none."""
        if not self.reference or not any(force):
            return None
        return np.array([_FORCE * float(x / self.reference) for x in force])

    def line_of_action(self, name: str, wrench: RationalVector) -> Floats:
        """Return the place of a wrench's force next to the middle of its body."""
        (x, y), (u, v, torque) = self.centres[name], wrench
        rest = (torque - (x * v - y * u)) / (u * u + v * v)
        return self.frame.paper((x + rest * v, y - rest * u))

    def content(self) -> Floats:
        """Return points whose box holds all that is drawn but labels."""
        held = [np.array(list(self.middles.values()) or [np.zeros(2)])]
        held += map(flattened, self.curves.values())
        for name in self.curves:
            moved = self.displaced(name)
            held += [] if moved is None else [flattened(moved)]
        for start, arm in (*self.contact_arms(), *self.wrench_arms()):
            held.append(np.array([start, start + arm]))
        for c in self.assembly.contacts:
            held.append(self.frame.paper(c.contact.point)[None] + [[-0.1, -0.1], [0.1, 0.1]])
        return np.concatenate(held)

    def contact_arms(self) -> Iterator[tuple[Floats, Floats]]:
        """Yield the arrows of contact forces, from the contact into the body they act on."""
        for c, force in zip(self.assembly.contacts, self.forces, strict=False):
            arm = self.arm(c.contact.force(force))
            if arm is not None:
                yield self.frame.paper(c.contact.point), arm
                if c.body_b is not None:
                    yield self.frame.paper(c.contact.point), -arm

    def wrench_arms(self) -> Iterator[tuple[Floats, Floats]]:
        """Yield the arrows of wrenches, on their lines of action."""
        for name, wrench in ({} if self.verdict is None else self.verdict.wrenches).items():
            arm = self.arm(wrench[:2])
            if arm is not None:
                yield self.line_of_action(name, wrench), arm


class _AssemblyPicture:
    """Puts a plan on a scene: a place p on paper at ``scale * p + shift``."""

    def __init__(self, plan: _AssemblyPlan, scene: Scene, scale: float, shift: Floats) -> None:
        self.plan, self.scene, self.scale, self.shift = plan, scene, scale, shift
        self.labels = Labels(scene)

    def at(self, places: Floats) -> Floats:
        """Return places on paper in points of the scene."""
        points: Floats = self.scale * np.asarray(places) + self.shift
        return points

    def all(self) -> None:
        """Draw everything."""
        self._bodies()
        self._contacts()
        self._arrows()
        for i, c in enumerate(self.plan.assembly.contacts, 1):
            out = -np.array([float(x) for x in c.contact.normal])
            place = self.at(self.plan.frame.paper(c.contact.point))
            self.labels.write(str(i), near(place, out), gid=f"number-{i}")
        for k, (name, middle) in enumerate(self.plan.middles.items(), 1):
            self.labels.write(name, near(self.at(middle), np.array([0.0, 1.0])), gid=f"name-{k}")

    def _bodies(self) -> None:
        plan, scene = self.plan, self.scene
        for k, body in enumerate(plan.assembly.bodies, 1):
            if body.name in plan.curves:
                curve = self.at(plan.curves[body.name])
                dashes = _DASHES if body.outline is None else "solid"
                scene.curve(curve, fc=PALE, ec=GREY, lw=0.7, ls=dashes, gid=f"body-{k}", zorder=0)
                self.labels.avoid(flattened(curve))
            else:
                middle = self.at(plan.middles[body.name])
                for c in plan.assembly.contacts:
                    if body.name in (c.body_a, c.body_b):
                        line = [middle, self.at(plan.frame.paper(c.contact.point))]
                        scene.line(line, ec=GREY, lw=0.7, ls=_DASHES, gid=f"body-{k}", zorder=0)
                        self.labels.avoid(line)
            moved = plan.displaced(body.name)
            if moved is not None:
                look = {"ec": BLUE, "lw": 0.9, "ls": _DOTS, "role": "arrow"}
                scene.curve(self.at(moved), fill=False, gid=f"motion-{k}", zorder=2.5, **look)
                self.labels.avoid(flattened(self.at(moved)))

    def _contacts(self) -> None:
        plan, states = self.plan, self.plan.verdict.states if self.plan.verdict else ()
        for i, c in enumerate(plan.assembly.contacts):
            place = self.at(plan.frame.paper(c.contact.point))
            tangent = np.array([float(x) for x in c.contact.tangent])
            pad = _PAD * self.scale * tangent
            look = {"ec": BLACK, "lw": 1.6, "capstyle": "butt", "role": "point"}
            self.scene.line([place - pad, place + pad], gid=f"pad-{i + 1}", zorder=3, **look)
            self.labels.avoid([place - pad, place + pad])
            if states:
                mark(self.scene, states[i], place, tangent, gid=f"mark-{i + 1}", zorder=6)

    def _arrows(self) -> None:
        plan = self.plan
        for k, (start, arm) in enumerate(plan.contact_arms(), 1):
            ends = self.at(start), self.at(start + arm)
            look: dict[str, Any] = {"fc": BLACK, "ec": "none", "gid": f"force-{k}", "zorder": 5.5}
            self.labels.avoid(arrow(self.scene, *ends, 1.0, **look))
        for k, (start, arm) in enumerate(plan.wrench_arms(), 1):
            ends = self.at(start), self.at(start + arm)
            look = {"fc": VERMILION, "ec": "none", "gid": f"wrench-{k}", "zorder": 5}
            self.labels.avoid(arrow(self.scene, *ends, **look))
        wrenches = {} if plan.verdict is None else plan.verdict.wrenches
        for k, (name, (x, y, torque)) in enumerate(wrenches.items(), 1):
            if torque and not (x or y):
                turn = 1 if torque > 0 else -1
                place, radius = self.at(plan.middles[name]), _ARC * self.scale
                look = {"color": VERMILION, "gid": f"torque-{k}", "zorder": 5}
                turning_arrow(self.scene, place, radius, turn, **look)


def _describe(plan: _AssemblyPlan, scene: Scene, scale: float) -> None:
    """Say in words and keys what is drawn, and at what scale forces are."""
    legend, verdict = scene.legend, plan.verdict
    if verdict is None:
        return
    if verdict.solution is None:
        legend.line(f"{verdict.verdict}: {verdict.reason}", emphasis=True)
    if verdict.doubt:
        legend.line(verdict.doubt, emphasis=True)
    if any(any(w) for w in verdict.wrenches.values()):
        legend.key(symbol("wrench"), "wrench on a body")
    if any(any(force) for force in plan.forces):
        legend.key(symbol("force"), "contact force on a body")
    states = {state.rstrip("+-") for state in verdict.states}
    for name in ("stick", "slip", "detached"):
        if name in states:
            legend.key(symbol(name), name)
    if plan.step is not None and any(plan.displaced(name) is not None for name in plan.curves):
        legend.key(symbol("motion"), f"displacement × {LABEL.number(plan.step)}")
    if plan.reference:
        force = nice_near(plan.reference)
        units = plan.assembly.units
        unit = f" {units.force}" if units else ""
        length = float(force / plan.reference) * _FORCE * scale
        legend.key(bar(length), f"force {LABEL.number(force)}{unit}")
    for line in limit_words(
        AssemblySolver(plan.assembly, verdict.max_displacement), verdict.wrenches
    ):
        legend.line(line)


def _frame(points: list[RationalVector]) -> Frame:
    """Return the frame in which points fill [-1, 1] in the longer direction."""
    if not points:
        return Frame((Fraction(0),) * 2, Fraction(1))
    lows, highs = ([end(column) for column in zip(*points, strict=True)] for end in (min, max))
    half = max(high - low for low, high in zip(lows, highs, strict=True)) / 2
    middle = tuple((low + high) / 2 for low, high in zip(lows, highs, strict=True))
    return Frame(middle, half or Fraction(1))


def _turn(p: RationalVector, q: RationalVector, r: RationalVector) -> Fraction:
    """Return above 0 where the way from p over q to r turns left."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def _moved(motion: RationalVector, point: RationalVector) -> RationalVector:
    """Return the displacement of a point of a body."""
    (x, y, turn), (p, q) = motion, point
    return x - turn * q, y + turn * p
