"""What a picture of bodies in the plane shows, in paper coordinates, and how it is painted.

A grasp is one body against the ground, an assembly has several: both become a `PlaneLayout`, which
is exact until the last division, and one `PlanePicture` paints it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.drawing.colours import BLACK, BLUE, GREY, PALE, VERMILION
from arrangement.drawing.labels import Labels, near
from arrangement.drawing.scene import (
    AROUND,
    Floats,
    Legend,
    Scene,
    arrow,
    curve_points,
    fit_sheet,
    ring,
    turning_arrow,
)
from arrangement.numbers.exact import RationalVector
from equilibrium.model.contact import Contact
from equilibrium.model.labels import Units

from .body import Frame
from .style import CONE_EDGE, CONE_FILL, explain, explain_scale, mark, name_wrench, nice_near

#: Lengths on paper, where contacts and outlines fill [-1, 1]: the largest force, the arc of a
#: torque, the largest displacement, half a pad, room around a contact.
FORCE, ARC, MOVED, PAD, NEAR = 0.65, 0.2, 0.22, 0.07, 0.1
#: The least length of a force that is not zero.
_LEAST = 1e-9
_DASHES, _DOTS, _AXIS = (0, (5, 2.5)), (0, (1, 1.5)), (0, (6, 2, 1, 2))


@dataclass
class DrawnBody:
    """A body on paper.

    Attributes:
        curve: its outline as cubic control points; None where no simple curve passes through the
            contacts, so that dashed lines join them in the middle.
        stated: whether the outline is its own; else it is dashed, as only indicative.
        middle: of the contacts or the outline.
        touching: the indices of its contacts.
        motion: exact (x, y, r), if one is drawn.
        tag: after the names of its elements.
        name: that is written in it.
    """

    curve: Floats | None
    stated: bool
    middle: Floats
    touching: Sequence[int]
    motion: RationalVector | None = None
    tag: str = ""
    name: str = ""


@dataclass
class DrawnLoad:
    """A wrench on a body.

    Attributes:
        force: exact; its arrow `arm` on paper is set with the scale of all forces.
        turn: the sense of the torque that is shown, or 0.
        place: where the force begins, and the middle of the arc of the torque.
        names: of the elements for force and torque.
    """

    force: RationalVector
    turn: int
    place: Floats
    names: tuple[str, str]
    arm: Floats | None = None


class PlaneLayout:
    """Bodies, contacts, forces and wrenches in paper coordinates.

    Attributes:
        detail: factor of all lengths on paper; below 1 where bodies share the picture.
        cones: the rim of each friction cone, if cones are drawn.
        states: of contacts, at the motion that is drawn.
        threads: the other end of each contact that is a thread, else None.
        origin: of the wrench, if it is marked.
        numbers: the text for each numbered contact, its place and the side to write it.
        pads: the ends of each pad, whose points are contacts of their own.
        step: the exact factor that motions are drawn with, or None when nothing moves.
        reference: the largest force component; arrows of forces are `FORCE` for `longest` of it.
        arms: of each contact, the forces that act on bodies there.
    """

    def __init__(
        self,
        frame: Frame,
        contacts: Sequence[Contact],
        bodies: Sequence[DrawnBody],
        detail: float = 1.0,
    ) -> None:
        self.frame, self.contacts, self.bodies, self.detail = frame, contacts, bodies, detail
        self.places = [frame.paper(c.point) for c in contacts]
        self.normals = [np.array([float(x) for x in c.normal]) for c in contacts]
        self.threads = [frame.paper(c.thread) if c.thread else None for c in contacts]
        self.cones: Sequence[Floats] = ()
        self.states: Sequence[str] = ()
        self.origin: Floats | None = None
        self.numbers: Sequence[tuple[str, Floats, Floats]] = ()
        self.pads: Sequence[Floats] = ()
        # A round factor with which no contact moves further than `MOVED` on paper.
        shifts = [
            abs(x)
            for body in bodies
            if body.motion is not None
            for i in body.touching
            for x in shift_at(body.motion, contacts[i].point)
        ]
        self.step = (
            nice_near(Fraction(MOVED * detail) * frame.half / max(shifts)) if any(shifts) else None
        )

    def scale_forces(
        self,
        forces: Sequence[Sequence[RationalVector]],
        loads: Sequence[DrawnLoad],
        preloads: Sequence[Fraction] = (),
    ) -> None:
        """Turn all forces into arrows of one scale; exact until the largest one is known.

        Args:
            forces: of each contact, those on bodies there.
            preloads: that are drawn, of each contact.
        """
        every = [*(force for at in forces for force in at), *(load.force for load in loads)]
        self.reference = max((abs(x) for f in [*every, preloads] for x in f), default=Fraction(0))
        unit = self.reference or Fraction(1)
        lengths = [float(np.linalg.norm([float(x / unit) for x in f])) for f in every]
        longest = max([*lengths, *(float(q / unit) for q in preloads)], default=1.0)
        self.longest = longest or 1.0
        factor = FORCE * self.detail / self.longest
        self.arms = [[_arm(f, unit, factor) for f in at if any(f)] for at in forces]
        self.loads = loads
        for load in loads:
            load.arm = _arm(load.force, unit, factor) if any(load.force) else None
        lengths = [max(factor * float(q / unit), _LEAST) if q else 0.0 for q in preloads]
        self.preloads = lengths or [0.0] * len(self.contacts)

    def displaced(self, body: DrawnBody, places: Floats) -> Floats:
        """Return paper points after the motion of a body, to first order, times `step`."""
        assert body.motion is not None
        assert self.step is not None
        x, y = shift_at(body.motion, self.frame.centre)
        shift = np.array([float(self.step * v / self.frame.half) for v in (x, y)])
        turn = float(self.step * body.motion[2])
        moved: Floats = places + shift + turn * np.stack([-places[:, 1], places[:, 0]], axis=1)
        return moved

    def moves(self, body: DrawnBody) -> bool:
        """Return whether the displacement of a body is drawn."""
        return self.step is not None and body.motion is not None and any(body.motion)

    def content(self) -> Floats:
        """Return points whose box holds all that is drawn but labels."""
        corner, near_by = 1.3 * ARC * self.detail * np.ones(2), NEAR * self.detail
        held: list[Floats] = [*(body.middle for body in self.bodies), *self.cones]
        held += [place for place in (self.origin, *self.threads) if place is not None]
        for body in self.bodies:
            if body.curve is not None:
                held.append(curve_points(body.curve))
                if self.moves(body):
                    held.append(self.displaced(body, held[-1]))
        for p, n, preload, arms in zip(
            self.places, self.normals, self.preloads, self.arms, strict=True
        ):
            t = near_by * np.array([-n[1], n[0]])
            held += [p - max(preload, near_by) * n, p - t, p + t, *(p + arm for arm in arms)]
        for load in self.loads:
            if load.arm is not None:
                held += [load.place, load.place + load.arm]
            if load.turn:
                held += [load.place + corner, load.place - corner]
        return np.vstack(held if self.places else [*held, np.ones(2), -np.ones(2)])

    def scene(self, width: float, tallest: float | None = None) -> tuple[Scene, float]:
        """Return the picture, without legend, and its scale; see `fit_sheet` for its size."""
        scene, scale, shift = fit_sheet(width, (self.content(), AROUND), tallest=tallest)
        scene.maps.append(self.frame.page_map(scale, shift))
        picture = PlanePicture(self, scene, scale, shift)
        picture.bodies()
        picture.contacts()
        picture.wrenches()
        picture.letter()
        picture.numbers()
        return scene, scale

    def explain(self, legend: Legend, motion: str, scale: float, units: Units | None) -> None:
        """Explain the marks of states, the motion, and the scale of forces."""
        states = {state.rstrip("+-") for state in self.states}
        moving = [body for body in self.bodies if self.moves(body)]
        outlined = any(body.curve is not None for body in moving)
        keys = {(name, name): name in states for name in ("stick", "slip", "detached")}
        explain(legend, {**keys, ("motion" if outlined else "shift", motion): moving})
        if self.reference:
            force = nice_near(self.reference)
            length = float(force / self.reference) / self.longest * FORCE * self.detail * scale
            explain_scale(legend, units, force, length)


class PlanePicture:
    """Puts a layout on a scene: a place p on paper at ``scale * p + shift``."""

    def __init__(self, layout: PlaneLayout, scene: Scene, scale: float, shift: Floats) -> None:
        self.layout, self.scene, self.scale, self.shift = layout, scene, scale, shift
        self.labels = Labels(scene)
        self.places = [self.at(place) for place in layout.places]

    def at(self, places: Any) -> Floats:
        """Return places on paper in points of the scene."""
        points: Floats = self.scale * np.asarray(places) + self.shift
        return points

    def line(self, points: Sequence[Floats] | Floats, gid: str, **style: Any) -> None:
        """Draw a line that labels avoid."""
        self.scene.line(points, gid=gid, **style)
        self.labels.avoid(points)

    def arrow(self, start: Floats, end: Floats, size: float = 1.5, **style: Any) -> None:
        """Draw an arrow that labels avoid."""
        self.labels.avoid(arrow(self.scene, start, end, size, **{"ec": "none", **style}))

    def bodies(self) -> None:
        """Draw outlines, or links between contacts, as they are and displaced."""
        for body in self.layout.bodies:
            if body.curve is None:
                self._links(body)
            else:
                self._outline(body, body.curve)

    def _outline(self, body: DrawnBody, outline: Floats) -> None:
        curve, scene = self.at(outline), self.scene
        dashes = "solid" if body.stated else _DASHES
        scene.curve(curve, fc=PALE, ec="none", gid=f"body{body.tag}", zorder=0)
        look: dict[str, Any] = {"ec": GREY, "lw": 0.7, "ls": dashes, "zorder": 2}
        scene.curve(curve, fill=False, gid=f"outline{body.tag}", **look)
        self.labels.avoid(curve_points(curve))
        if self.layout.moves(body):
            moved = self.at(self.layout.displaced(body, outline))
            look = {"ec": BLUE, "lw": 0.9, "ls": _DOTS, "role": "arrow", "zorder": 2.5}
            scene.curve(moved, fill=False, gid=f"motion{body.tag}", **look)
            self.labels.avoid(curve_points(moved))

    def _links(self, body: DrawnBody) -> None:
        middle, places = self.at(body.middle), [self.layout.places[i] for i in body.touching]
        look: dict[str, Any] = {"ec": GREY, "lw": 0.5, "ls": _DASHES, "zorder": 0.5}
        for i, place in zip(body.touching, map(self.at, places), strict=True):
            self.line([place, middle], f"link{body.tag}-{i + 1}", **look)
        if places and self.layout.moves(body):
            ends = self.at(self.layout.displaced(body, np.array(places)))
            for i, start, end in zip(body.touching, self.at(places), ends, strict=True):
                if np.linalg.norm(end - start) > 1:
                    self.arrow(start, end, fc=BLUE, gid=f"motion{body.tag}-{i + 1}", zorder=5)

    def contacts(self) -> None:
        """Draw friction cones, pads, preloads, contact forces and states."""
        layout, scene, labels = self.layout, self.scene, self.labels
        seen: dict[RationalVector, int] = {}
        pad_look: dict[str, Any] = {"ec": BLACK, "lw": 1.6, "role": "point", "zorder": 3}
        for i, ends in enumerate(layout.pads, 1):
            self.line(self.at(ends), f"bar-{i}", **pad_look)
        for i, (contact, p, n) in enumerate(
            zip(layout.contacts, self.places, layout.normals, strict=True)
        ):
            t, thread = np.array([-n[1], n[0]]), layout.threads[i]
            look: dict[str, Any] = {"ec": CONE_EDGE, "lw": 0.5}
            if layout.cones:
                rim = self.at(np.vstack([layout.places[i], layout.cones[i]]))
                scene.polygon(rim, fc=CONE_FILL, zorder=1, gid=f"cone-{i + 1}", **look)
                labels.avoid([*rim, p])
                middle = rim[len(rim) // 2]
                self.line([p, middle], f"normal-{i + 1}", ls=_AXIS, zorder=1.1, **look)
            if thread is not None:
                look = {"ec": BLACK, "lw": 0.8, "zorder": 2.8}
                self.line([p, self.at(thread)], f"thread-{i + 1}", **look)
            pad = PAD * layout.detail * self.scale * t * (thread is None)
            self.line([p - pad, p + pad], f"pad-{i + 1}", capstyle="butt", **pad_look)
            preload = layout.preloads[i] * self.scale
            if preload > 0:
                tip = p - 3.2 * n * (preload > 12)
                look = {"fc": "white", "ec": GREY, "lw": 0.7, "zorder": 3.5}
                self.arrow(p - preload * n, tip, 1.6, gid=f"preload-{i + 1}", **look)
            for end, arm in zip(("", "-back"), layout.arms[i], strict=False):
                look = {"fc": BLACK, "zorder": 5.5, "gid": f"force-{i + 1}{end}"}
                self.arrow(p, p + self.scale * arm, 1.0, **look)
            if layout.states and (thread is None or layout.states[i] == "detached"):
                # Marks of one body's contacts at one place stand one behind the other.
                again = seen[contact.point] = seen.get(contact.point, -1) + 1
                place = p - 7.5 * again * n * (len(layout.bodies) == 1)
                mark(scene, layout.states[i], place, t, gid=f"mark-{i + 1}", zorder=6)
                labels.avoid(ring(place, 4.0, 13), place + np.array([[-4, 0], [4, 0]]))

    def wrenches(self) -> None:
        """Draw the origin and the applied wrenches."""
        scene, labels, reach = self.scene, self.labels, ARC * self.layout.detail * self.scale
        if self.layout.origin is not None:
            o = self.at(self.layout.origin)
            for arm in (np.array([3, 0]), np.array([0, 3])):
                scene.line([o - arm, o + arm], ec=GREY, lw=0.6, zorder=4.5, gid="origin")
        for load in self.layout.loads:
            (force, torque), o = load.names, self.at(load.place)
            if load.arm is not None:
                self.arrow(o, o + self.scale * load.arm, fc=VERMILION, gid=force, zorder=5)
            if load.turn:
                turning_arrow(scene, o, reach, load.turn, color=VERMILION, gid=torque, zorder=5)
                labels.avoid(ring(o, reach, 25), o + reach * np.array([[-1, 0], [1, 0]]))

    def letter(self) -> None:
        """Write w beside the wrench of a grasp, never inside the arc of its torque."""
        if self.layout.origin is None:
            return
        reach = ARC * self.layout.detail * self.scale
        for load in self.layout.loads:
            o, ends = self.at(load.place), []
            if load.arm is not None:
                ends = [o + share * self.scale * load.arm for share in (1, 0.5, 0)]
            if load.turn:
                ends += [o + reach * np.array(arm) for arm in ((0, 1), (0, -1), (1, 0), (-1, 0))]
            if ends:
                name_wrench(self.labels, ends, (o, reach + 7 if load.turn else 0.0))

    def numbers(self) -> None:
        """Write the number of every contact on the side of its preload, and the names of bodies."""
        for i, (text, place, away) in enumerate(self.layout.numbers, 1):
            self.labels.write(text, near(self.at(place), away), gid=f"number-{i}")
        for body in self.layout.bodies:
            if body.name:
                places = near(self.at(body.middle), np.array([0.0, 1.0]))
                self.labels.write(body.name, places, gid=f"name{body.tag}")


def _arm(force: RationalVector, unit: Fraction, factor: float) -> Floats:
    """Return a force on paper; one too small for a float keeps its direction."""
    own = max(map(abs, force))
    direction = np.array([float(x / own) for x in force])
    length = float(np.linalg.norm(direction))
    arm: Floats = direction / length * max(factor * float(own / unit) * length, _LEAST)
    return arm


def shift_at(motion: RationalVector, point: RationalVector) -> RationalVector:
    """Return the displacement of a point, to first order."""
    return (motion[0] - motion[2] * point[1], motion[1] + motion[2] * point[0])
