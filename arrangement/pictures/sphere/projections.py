"""Arcs of great circles as curves on paper, in two projections.

A projection takes an arc (unit normal of its circle, unit vector where it starts, angle through
which it turns counter-clockwise about the normal; all in the axes right, up, towards the viewer)
and returns control points (3k + 1, 2) of cubic curves, in units of the limb.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np

from arrangement.drawing.scene.curves import ring
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.scene import joined
from arrangement.drawing.solids.sight import across
from arrangement.enumeration.great_circles import SphereArrangement
from arrangement.numbers.linear.rank import cross

Projection: TypeAlias = Callable[[Floats, Floats, float], Floats]


def orthographic(normal: Floats, start: Floats, angle: float) -> Floats:
    """Return the arc as seen from far away; within 10^-5 of the true ellipse."""
    place, speed = _points(normal, start, angle, math.pi / 8)
    step = angle / (len(place) - 1)
    return joined(place[:, :2], speed[:, :2] * (4 / 3 * math.tan(step / 4)))


def stereographic(normal: Floats, start: Floats, angle: float) -> Floats:
    """Return the arc seen from the far pole, on the plane of the limb: a circular arc.

    The circle with normal (a, b, c) becomes the one with centre (a/c, b/c) and radius 1/|c|. The
    far pole must not lie on it, or the arc must keep away from that pole. Curves are within 10^-6
    of the true circle, in units of its radius.
    """
    a, b, c = normal
    if abs(c) < 1e-9:
        ends, _ = _points(normal, start, angle, angle)
        flat = ends[:, :2] / (1 + ends[:, 2:])
        return joined(flat, np.tile((flat[1] - flat[0]) / 3, (2, 1)))
    centre, radius = np.array([a / c, b / c]), 1 / abs(c)
    ends, _ = _points(normal, start, angle, angle)
    first, last = ends[:, :2] / (1 + ends[:, 2:]) - centre
    way = 1.0 if c > 0 else -1.0
    sweep = way * (math.atan2(last[1], last[0]) - math.atan2(first[1], first[0])) % (2 * math.pi)
    if angle > 2 * math.pi - 1e-9:
        sweep = 2 * math.pi
    pieces = max(1, math.ceil(sweep / (math.pi / 8)))
    at = math.atan2(first[1], first[0]) + way * np.linspace(0, sweep, pieces + 1)
    spoke = radius * np.stack([np.cos(at), np.sin(at)], axis=1)
    speed = way * np.stack([-spoke[:, 1], spoke[:, 0]], axis=1)
    return joined(centre + spoke, speed * (4 / 3 * math.tan(sweep / pieces / 4)))


@dataclass(frozen=True)
class Drawn:
    """The arcs and regions of an arrangement on the sphere, as curves on paper.

    Attributes:
        sphere: the arrangement.
        points: (V, 3); its vertices as unit vectors in the axes of the picture.
        normals: (c, 3); the unit normals of its circles, likewise.
        projection: how arcs become curves.
    """

    sphere: SphereArrangement
    points: Floats
    normals: Floats
    projection: Projection

    @cached_property
    def _arcs(self) -> dict[int, Floats]:
        return {}

    def arc(self, arc: int) -> Floats:
        """Return the control points (3k + 1, 2) of an arc."""
        if arc not in self._arcs:
            self._arcs[arc] = self._arc(arc)
        return self._arcs[arc]

    def _arc(self, arc: int) -> Floats:
        incidence = self.sphere.incidence
        normal = self.normals[int(incidence.arc_circle[arc])]
        start, stop = incidence.origin[2 * arc], incidence.origin[2 * arc + 1]
        if start < 0:
            return self.projection(normal, across(normal), 2 * math.pi)
        p, q = self.points[start], self.points[stop]
        angle = math.atan2(math.hypot(*cross(p.tolist(), q.tolist())), float(p @ q))
        return self.projection(normal, p, angle)

    def ends(self, circle: int) -> tuple[float, ...]:
        """Return the two angles at which a circle meets the limb, opposite to each other."""
        x, y, _ = self.normals[circle]
        angle = math.atan2(x, -y)
        return angle % (2 * math.pi), (angle + math.pi) % (2 * math.pi)

    def outline(self, region: int) -> Floats:
        """Return the closed boundary of a region, as control points (3k + 1, 2)."""
        curves = []
        for half_edge in self.sphere.incidence.boundary(region).tolist():
            curve = self.arc(half_edge >> 1)
            curves.append(curve[::-1] if half_edge & 1 else curve)
        return np.concatenate([curves[0], *(curve[1:] for curve in curves[1:])])


@dataclass(frozen=True)
class CutChart(Drawn):
    """A chart to scale, with straight lines, cut off at a circle; infinity is left out.

    Attributes:
        limb: the circle at infinity.
        reach: the radius of the part that is shown, in radii of the sphere.
    """

    limb: int
    reach: float

    @cached_property
    def _far(self) -> float:
        """A distance beyond all vertices, in units of the part that is shown."""
        front = self.points[self.points[:, 2] > 1e-9]
        spans = np.linalg.norm(front[:, :2] / front[:, 2:], axis=1) / self.reach
        return 4 * max(10.0, float(spans.max(initial=0.0)))

    def _line(self, circle: int) -> tuple[Floats, Floats]:
        """Return the point of a line nearest to the middle, and its direction."""
        a, b, c = self.normals[circle]
        length = math.hypot(a, b)
        return -c / length / self.reach * np.array([a, b]) / length, np.array([-b, a]) / length

    def _place(self, vertex: int, circle: int) -> Floats:
        """Return where a vertex is on a line; far away if it is at infinity."""
        x, y, z = self.points[vertex]
        if z > 1e-9:
            return np.array([x / z, y / z]) / self.reach
        foot, way = self._line(circle)
        return foot + math.copysign(self._far, float(np.array([x, y]) @ way)) * way

    def _ends(self, arc: int) -> list[Floats]:
        """Return the ends of an arc, and points between them if it is a part of infinity."""
        start, stop = self.sphere.incidence.origin[2 * arc : 2 * arc + 2].tolist()
        circle = int(self.sphere.incidence.arc_circle[arc])
        if circle != self.limb:
            return [self._place(start, circle), self._place(stop, circle)]
        normal = self.normals[circle]
        begin = across(normal) if start < 0 else self.points[start]
        sweep = 2 * math.pi
        if start >= 0:
            one, two = (math.atan2(*self.points[v][1::-1]) for v in (start, stop))
            sweep = math.copysign(1.0, normal[2]) * (two - one) % (2 * math.pi)
        return list(self._far * _points(normal, begin, sweep, math.pi / 8)[0][:, :2])

    def _arc(self, arc: int) -> Floats:
        """Return the part of an arc that is shown; nothing if there is none, or at infinity."""
        if int(self.sphere.incidence.arc_circle[arc]) == self.limb:
            return np.empty((0, 2))
        start, stop = self._ends(arc)
        foot, way = self._line(int(self.sphere.incidence.arc_circle[arc]))
        half = math.sqrt(max(0.0, 1 - float(foot @ foot)))
        low, high = sorted(max(-half, min(half, float((p - foot) @ way))) for p in (start, stop))
        if high - low < 1e-9:
            return np.empty((0, 2))
        ends = foot + np.array([[low], [high]]) * way
        return joined(ends, np.tile((ends[1] - ends[0]) / 3, (2, 1)))

    def outline(self, region: int) -> Floats:
        """Return the boundary of the part of a region that is shown, or nothing."""
        import shapely

        corners: list[Floats] = []
        for half_edge in self.sphere.incidence.boundary(region).tolist():
            ends = self._ends(half_edge >> 1)
            corners += ends[::-1] if half_edge & 1 else ends
        seen = shapely.Polygon(corners).buffer(0).intersection(shapely.Polygon(ring((0, 0), 1.0)))
        if seen.area < 1e-9:
            return np.empty((0, 2))
        edge = shapely.get_coordinates(seen)
        steps = np.diff(edge, axis=0) / 3
        handles = np.stack([edge[:-1] + steps, edge[1:] - steps, edge[1:]], axis=1)
        return np.concatenate([edge[:1], handles.reshape(-1, 2)])

    def ends(self, circle: int) -> tuple[float, ...]:
        """Return the angles at which a line leaves what is shown, if it is in it."""
        if circle == self.limb:
            return ()
        foot, way = self._line(circle)
        half = 1 - float(foot @ foot)
        if half <= 0:
            return ()
        tips = (foot + sign * math.sqrt(half) * way for sign in (1, -1))
        return tuple(math.atan2(y, x) % (2 * math.pi) for x, y in tips)


def _points(normal: Floats, start: Floats, angle: float, most: float) -> tuple[Floats, Floats]:
    """Return points along an arc, at most `most` apart, and the unit tangents there."""
    side = np.array(cross(normal.tolist(), start.tolist()))
    steps = max(1, math.ceil(angle / max(most, 1e-3) - 1e-9))
    at = np.linspace(0, angle, steps + 1)[:, None]
    return np.cos(at) * start + np.sin(at) * side, np.cos(at) * side - np.sin(at) * start
