"""The visible and the hidden half of a great-circle arrangement, cut exactly at the limb.

The plane of the limb joins the arrangement as one more plane, so that the exact engine itself
does the cutting. Floats begin when arcs become curves.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from itertools import product

import numpy as np
import numpy.typing as npt

from arrangement.errors import InputError
from arrangement.exact import IntegerVector, primitive, rational
from arrangement.planes import Arrangement
from arrangement.sphere import sphere_arrangement

Floats = npt.NDArray[np.float64]
#: Circles beyond which a picture of one column shows nothing.
MAX_CIRCLES = 60


class Globe:
    """A central arrangement in R^3 seen from the direction `view`, in the orthographic projection.

    Attributes:
        whole: the arrangement on the sphere.
        cut: the same with the limb as one more plane, the last one.
        view: the primitive integer direction towards the viewer.
        axes: (3, 3); the unit vectors right, up and towards the viewer.
    """

    def __init__(self, arrangement: Arrangement, view: Sequence[object] | None = None) -> None:
        self.whole = sphere_arrangement(arrangement)
        if self.whole.circle_count > MAX_CIRCLES:
            raise InputError(
                f"{self.whole.circle_count} great circles; a picture shows at most {MAX_CIRCLES}"
            )
        self.view = _direction(view) if view is not None else self._clear_view()
        self.cut = sphere_arrangement(Arrangement([*arrangement.normals, self.view]))
        self.axes = _axes(self.view)

    def _clear_view(self) -> IntegerVector:
        """Return the direction in which circles are least edge-on and points far from the limb."""
        rays = [self.whole.ray(v) for v in range(self.whole.vertex_count)]
        lines = _unit([*self.whole.circle_normals, *rays, (0, 0, 1)])
        views = [v for v in product(range(1, 8), range(-7, 8), range(1, 7)) if primitive(v) == v]
        units = _unit(views)
        high = (units[:, 2] > 0.25) & (units[:, 2] < 0.75)
        clearance = np.where(high, np.abs(units @ lines.T).min(axis=1), -1.0)
        return views[int(np.argmax(np.round(clearance, 9)))]

    @cached_property
    def points(self) -> Floats:
        """(V, 3); the vertices of `cut`, in the axes of the picture."""
        rays = [self.cut.ray(v) for v in range(self.cut.vertex_count)]
        return _unit(rays) @ self.axes.T

    @cached_property
    def normals(self) -> Floats:
        """(c, 3); the unit normals of the circles of `cut`, in the axes of the picture."""
        return _unit(self.cut.circle_normals) @ self.axes.T

    @cached_property
    def limb(self) -> int:
        """The circle of the limb."""
        return int(self.cut.plane_circle[-1])

    def arc(self, arc: int) -> Floats:
        """Return control points (3k + 1, 2) of cubic curves; within 10^-5 of the true ellipse."""
        incidence = self.cut.incidence
        normal = self.normals[int(incidence.arc_circle[arc])]
        start, stop = incidence.origin[2 * arc], incidence.origin[2 * arc + 1]
        if start < 0:
            p, angle = np.array([1.0, 0.0, 0.0]), 2 * math.pi
        else:
            p, q = self.points[start], self.points[stop]
            angle = math.atan2(float(np.linalg.norm(np.cross(p, q))), float(p @ q))
        side = np.cross(normal, p)
        pieces = max(1, math.ceil(angle / (math.pi / 8)))
        step = angle / pieces
        handle = 4 / 3 * math.tan(step / 4)
        at = np.linspace(0, angle, pieces + 1)[:, None]
        place = np.cos(at) * p + np.sin(at) * side
        speed = handle * (np.cos(at) * side - np.sin(at) * p)
        curve = np.empty((3 * pieces + 1, 3))
        curve[0::3] = place
        curve[1::3] = place[:-1] + speed[:-1]
        curve[2::3] = place[1:] - speed[1:]
        return curve[:, :2]

    def outline(self, piece: int) -> Floats:
        """Return the closed boundary of a region of `cut` as control points (3k + 1, 2)."""
        curves = []
        for half_edge in self.cut.incidence.boundary(piece).tolist():
            curve = self.arc(half_edge >> 1)
            curves.append(curve[::-1] if half_edge & 1 else curve)
        return np.concatenate([curves[0], *(curve[1:] for curve in curves[1:])])


def _direction(view: Sequence[object]) -> IntegerVector:
    direction = primitive([rational(x, "view") for x in view])
    if len(direction) != 3 or not any(direction):
        raise InputError(f"the view is {direction}; give three numbers that are not all 0")
    return direction


def _axes(view: IntegerVector) -> Floats:
    ahead = _unit([view])[0]
    right = np.cross([0.0, 0.0, 1.0], ahead) if view[0] or view[1] else np.array([1.0, 0.0, 0.0])
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(ahead, right), ahead])


def _unit(vectors: Sequence[IntegerVector]) -> Floats:
    """Return unit vectors; integers of any length are divided before they become floats."""
    scaled = np.array([[x / max(map(abs, v)) for x in v] for v in vectors]).reshape(-1, 3)
    unit: Floats = scaled / np.linalg.norm(scaled, axis=1, keepdims=True)
    return unit
