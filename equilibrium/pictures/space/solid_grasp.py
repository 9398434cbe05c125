"""A grasp in space as flat pieces: body, friction cones, arrows, the axis of a motion.

Everything is moved and scaled so that body and contacts fill [-1, 1], then rounded (`pieces`); the
pieces are exact from there on, and so is the order in which they hide each other.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

import numpy as np

from arrangement.drawing.colours import BLACK, BLUE, GREY, VERMILION
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.depth_tree import Node, depth_tree
from arrangement.drawing.solids.meshes import volume
from arrangement.drawing.solids.pieces import (
    Arrow,
    arc,
    arrow_pieces,
    convex_hull,
    drawn_edges,
    flat,
    merged,
    segment,
)
from arrangement.drawing.solids.sight import unit, unit_vectors
from arrangement.drawing.solids.surface import Patch
from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear.rank import cross, cycle_edges
from equilibrium.model.grasp import Grasp
from equilibrium.model.outline import Mesh
from equilibrium.pictures.parts.body import Frame, frame_of

#: Lengths, where body and contacts fill [-1, 1]: cones, the largest force, slip and motion.
CONE, FORCE, MOVED = 0.3, 0.6, 0.3
#: Sides of a cone.
_SIDES = 16
#: An axis farther than this from the middle is not drawn.
FAR = 1.8
#: Radius of the helix of a motion, and most turns of it.
_HELIX, _TURNS = 0.14, 2.0
#: Meshes of more facets are drawn as their convex hull.
_MOST_FACETS = 1500

#: Colours by the first word of a piece's name.
INKS = {
    "force": BLACK,
    "wrench": VERMILION,
    "slip": BLUE,
    "axis": BLUE,
    "preload": GREY,
    "link": GREY,
}


@dataclass(frozen=True)
class Screw:
    """A motion as a turn about an axis and a shift along it.

    Attributes:
        axis: unit vector; of a pure shift, its direction.
        point: on the axis, nearest to the middle of the picture; None for a shift.
        pitch: shift along the axis for each radian; None for a shift.
    """

    axis: Floats
    point: Floats | None
    pitch: float | None

    @classmethod
    def of(cls, motion: Sequence[float | Fraction]) -> Screw | None:
        """Return the screw of a motion ``(v, omega)``; None if it is 0. Lengths as in the grasp.

        >>> Screw.of((0, 0, 2, 0, 0, 1)).pitch
        2.0
        """
        exact = [Fraction(x) for x in motion]
        largest = max(map(abs, exact))
        if not largest:
            return None
        v, omega = (tuple(x / largest for x in part) for part in (exact[:3], exact[3:]))
        square = dot(omega, omega)
        if square < Fraction(1, 10**18):
            return cls(unit_vectors([v])[0], None, None)
        point = np.array([float(x / square) for x in cross(omega, v)])
        return cls(unit_vectors([omega])[0], point, float(dot(v, omega) / square))


@dataclass
class SolidGrasp:
    """What is drawn of a grasp in space.

    Attributes:
        grasp: contacts.
        motion: a motion (v, omega) to be shown, if there is one.
        forces: contact forces to be shown, none if there are none.
        wrench: applied, if one is shown.
        virtual: show how the motion moves the contact points, not how they slip.
    """

    grasp: Grasp
    motion: Sequence[float | Fraction] = ()
    forces: Sequence[Sequence[float | Fraction]] = ()
    wrench: RationalVector = ()
    virtual: bool = False
    frame: Frame = field(init=False)

    def __post_init__(self) -> None:
        self.frame = frame_of(self.grasp, self.grasp.outline)

    @cached_property
    def places(self) -> Floats:
        """(m, 3); the contact points."""
        return np.array([self.frame.paper(c.point) for c in self.grasp]).reshape(-1, 3)

    @cached_property
    def normals(self) -> Floats:
        """(m, 3); inward."""
        return np.array([[float(x) for x in c.normal] for c in self.grasp]).reshape(-1, 3)

    @property
    def groups(self) -> Iterator[tuple[int, list[int], str]]:
        """Yield the contacts at one place, a pad in its middle.

        The first point among `places`, the first points of all, and their numbers as a text.
        """
        found: dict[object, list[int]] = {}
        for i, contact in enumerate(self.grasp.joined()):
            found.setdefault(contact.point, []).append(i)
        for members in found.values():
            firsts = [self.grasp.groups[i].start for i in members]
            yield firsts[0], firsts, ", ".join(str(i + 1) for i in members)

    @cached_property
    def body(self) -> tuple[Floats, list[tuple[int, ...]], bool]:
        """Points and faces, counter-clockwise from outside, and whether it is the stated outline.

        Without an outline, or beyond 1500 facets, it is the convex hull, if that has a volume.
        """
        outline = self.grasp.outline
        if not isinstance(outline, Mesh):
            return (*convex_hull(self.places), False)
        points = np.array([self.frame.paper(p) for p in outline.vertices])
        faces = [tuple(face) for face in outline.faces]
        if faces and volume(points, faces) < 0:
            faces = [face[::-1] for face in faces]
        if len(outline.faces) > _MOST_FACETS:
            return (*convex_hull(points), False)
        return points, merged(points, faces), True

    @cached_property
    def largest_force(self) -> float:
        """The largest contact force, preload or applied force; 0 without any."""
        sizes = [math.hypot(*map(float, f)) for f in self.forces]
        sizes += [math.hypot(*map(float, self.wrench[:3]))] if self.wrench else []
        sizes += [float(c.preload) for c in self.grasp]
        return max(sizes, default=0.0)

    @property
    def force_scale(self) -> float:
        """By what forces are multiplied: the largest one has the length `FORCE`."""
        return FORCE / self.largest_force if self.largest_force else 0.0

    @cached_property
    def screw(self) -> Screw | None:
        """The screw of the motion, in the coordinates of the grasp."""
        return Screw.of(self.motion) if self.motion else None

    @cached_property
    def slips(self) -> Floats:
        """(m, 3); how each contact point slips or moves, the longest `MOVED` long."""
        v, omega = (np.array(part, float) for part in (self.motion[:3], self.motion[3:]))
        points = np.array([[float(x) for x in c.point] for c in self.grasp]).reshape(-1, 3)
        moved = v + np.cross(omega, points)
        inward = np.einsum("ij,ij->i", moved, self.normals)[:, None] * self.normals
        slips = moved if self.virtual else moved - inward
        sizes = np.linalg.norm(slips, axis=1)
        slips[sizes < 1e-9 * np.linalg.norm(moved, axis=1)] = 0
        largest = float(np.linalg.norm(slips, axis=1).max(initial=0.0))
        found: Floats = slips * (MOVED / largest if largest else 0.0)
        return found

    def arrows(self) -> Iterator[Arrow]:
        """Yield the arrows: preloads, the wrench, forces, slips, the axis of the motion."""
        for i, (p, n) in enumerate(zip(self.places, self.normals, strict=True), 1):
            preload = float(self.grasp.contacts[i - 1].preload) * self.force_scale
            if preload:
                yield Arrow(f"preload-{i}", p - max(preload, 0.12) * n, p)
        for i, force in enumerate(self.forces, 1):
            arm = np.array([float(x) for x in force]) * self.force_scale
            if arm.any():
                yield Arrow(f"force-{i}", self.places[i - 1], self.places[i - 1] + arm)
        yield from self._wrench()
        if self.motion:
            for i, slip in enumerate(self.slips, 1):
                if slip.any():
                    yield Arrow(f"slip-{i}", self.places[i - 1], self.places[i - 1] + slip)
            yield from self._axis()

    def _wrench(self) -> Iterator[Arrow]:
        """Yield the applied force at the origin, and the torque as an arc around its axis."""
        origin = self.frame.paper((Fraction(0),) * 3)
        if np.abs(origin).max() > 2:
            return
        force, torque = (np.array(part, float) for part in (self.wrench[:3], self.wrench[3:]))
        if force.any():
            yield Arrow("wrench-force", origin, origin + force * self.force_scale)
        if torque.any():
            yield from arc("wrench-torque", origin, unit(torque), 0.25, 0.0, 0.75)

    @property
    def axis_is_far(self) -> bool:
        """Whether the motion is a turn about an axis that is outside the picture."""
        turns = self.screw is not None and self.screw.point is not None
        return turns and not any(arrow.name == "axis" for arrow in self._axis())

    def _axis(self) -> Iterator[Arrow]:
        if self.screw is None:
            return
        axis = self.screw.axis
        if self.screw.point is None or self.screw.pitch is None:
            yield Arrow("axis", -0.5 * MOVED * axis, 0.5 * MOVED * axis)
            return
        size = float(self.frame.half)
        point = self.screw.point / size - np.array(
            [float(c / self.frame.half) for c in self.frame.centre]
        )
        point = point - (point @ axis) * axis
        if float(np.linalg.norm(point)) > FAR:
            return
        yield Arrow("axis", point - 1.3 * axis, point + 1.3 * axis, headless=True)
        rise = 2 * math.pi * self.screw.pitch / size
        turns = min(0.75 if abs(rise) < 1e-9 else _TURNS, 1.6 / max(abs(rise), 1e-9))
        yield from arc("axis-turn", point, axis, _HELIX, rise, turns)

    @property
    def cones(self) -> Iterator[tuple[int, Floats, Floats]]:
        """Yield number, apex and rim of each friction cone; without friction the rim is a point."""
        for i, (c, p, n) in enumerate(zip(self.grasp, self.places, self.normals, strict=True), 1):
            angle = math.atan(float(c.friction))
            across, other = (np.array([float(x) for x in t]) for t in c.tangents)
            turns = np.linspace(0, 2 * math.pi, _SIDES, endpoint=False)[:, None]
            ring = np.cos(turns) * across + np.sin(turns) * other
            rim = p + CONE * (math.cos(angle) * n + math.sin(angle) * ring)
            yield i, p, rim if c.friction else rim[:1]

    def patches(self, towards: Floats | None = None) -> list[Patch]:
        """Return all pieces.

        Args:
            towards: the viewer, see `drawn_edges`.
        """
        points, faces, _ = self.body
        drawn, found = drawn_edges(points, faces, towards), []
        for face in faces:
            shown = [(points[a], points[b]) for a, b in cycle_edges(face) if (a, b) in drawn]
            found += flat([points[a] for a in face], "body", shown)
        if not faces and len(self.places) > 1:
            middle = self.places.mean(axis=0)
            found += [p for place in self.places for p in segment(place, middle, "link")]
        for i, apex, rim in self.cones:
            if len(rim) == 1:
                found += segment(apex, rim[0], f"normal-{i}")
                continue
            for p, q in zip(rim, np.roll(rim, -1, axis=0), strict=True):
                found += flat([apex, p, q], f"cone-{i}", [(p, q)])
        for arrow in self.arrows():
            found += arrow_pieces(arrow)
        return found

    def tree(self, towards: Floats | None = None) -> list[Node[Patch]]:
        """Return the pieces in an order for painting; they may be cut."""
        return depth_tree(self.patches(towards))
