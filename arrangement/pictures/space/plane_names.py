"""Numbers of planes around the body, and sign vectors on lifted cells."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import keep_off, spread, turn, write_beside, write_inside
from arrangement.drawing.scene.measuring import area
from arrangement.pictures.region_labels import RegionLabels
from arrangement.pictures.sphere.disc import plane_names

from .axes import arrow
from .exploded_cells import Lifted
from .planesheet import PlanesSheet


class Names:
    """Writes on a finished picture; numbers first."""

    def __init__(self, picture: PlanesSheet, names: RegionLabels) -> None:
        self.picture, self.names = picture, names
        self.stage, self.lifted = picture.stage, picture.lifted
        self.scene, self.place = picture.scene, picture.place
        self.outline = picture.outline

    def number_planes(self) -> None:
        """Write the numbers of the planes around the body, with a line to a visible rim."""
        wanted: list[tuple[float, Floats, str, str]] = []
        for label, members in enumerate(self.stage.arrangement.distinct):
            points = self._rim(label)
            if not len(points):
                continue
            angles = np.arctan2(points[:, 1], points[:, 0])
            gap = np.array(
                [min((abs(turn(a - b)) for b, *_ in wanted), default=3.0) for a in angles]
            )
            depth = np.array([1 - self._reach(p) for p in points])
            score = np.minimum(gap, 0.35) - 2.5 * depth - 3.0 * self._covered(points)
            best = int(np.argmax(np.round(score, 6)))
            if self._covered(points[best : best + 1])[0]:
                continue
            text = plane_names(members)
            wanted.append((float(angles[best]), points[best], text, self.picture.colour(label)))
        placed = spread([angle for angle, *_ in wanted], 0.13)
        for (_, point, text, colour), angle in zip(wanted, placed, strict=True):
            way = np.array([math.cos(angle), math.sin(angle)])
            edge = way / max(1e-9, self._gauge(way))
            rim = self.place(edge)
            half = np.array(self.scene.measure(text, 7.0)) / 2 + 1.6
            beyond = float((half / np.maximum(np.abs(way), 1e-9)).min())
            self.scene.line([self.place(point), rim + 4 * way], ec="black", lw=0.4, zorder=4)
            box = {"boxstyle": "round,pad=0.22,rounding_size=0.5", "fc": colour, "ec": "none"}
            style: dict[str, Any] = {"plate": box, "style": "italic"}
            self.scene.write(rim + (4 + beyond) * way, text, 7.0, **style)

    def _covered(self, points: Floats) -> Floats:
        """Return 1 for points whose number would stand on or at a lifted cell, else 0."""
        from matplotlib.path import Path
        from scipy.spatial import ConvexHull

        reach = np.array([[max(self._reach(p), 1e-9)] for p in points])
        length = np.maximum(np.linalg.norm(points[:, :2], axis=1, keepdims=True), 1e-9)
        places = self.place(points[:, :2] / reach) + 8.5 * points[:, :2] / length
        covered = np.zeros(len(points))
        for item in self.lifted:
            flat = self.place(item.corners)
            hull = Path(flat[ConvexHull(flat).vertices])
            covered += hull.contains_points(places, radius=8.0)
        return covered

    def _rim(self, label: int) -> Floats:
        """Return the points of a plane on the surface of the body that the viewer can see."""
        found = {
            i
            for facet in self.stage.facets
            if facet.label == label
            for k, i in enumerate(facet.corners)
            if facet.rim[k] or facet.rim[k - 1]
        }
        points = self.stage.points[sorted(found)]
        reach = np.array([self._reach(p) for p in points])
        seen = (points[:, 2] > 0) | (reach > 0.985)
        return points[seen] if seen.any() else points

    def _reach(self, point: Floats) -> float:
        return self._gauge(point[:2])

    def _gauge(self, point: Floats) -> float:
        """Return by which factor the outline must be scaled to pass through a point."""
        if self.picture.round:
            return float(np.linalg.norm(point))
        step = np.roll(self.outline, -1, axis=0) - self.outline
        out = np.column_stack([step[:, 1], -step[:, 0]])
        return float(((out @ point) / (out * self.outline).sum(axis=1)).max())

    def mark_sides(self) -> None:
        """Draw an arrow to the positive side of each plane, at the nearest point of its rim."""
        for label in range(len(self.stage.arrangement.distinct)):
            points = self._rim(label)
            if len(points):
                foot = points[int(np.argmax(np.round(points[:, 2], 6)))]
                normal = self.stage.planes[label][0]
                ends = self.place(np.array([foot, foot + 0.11 * normal]))
                style: dict[str, Any] = {"zorder": 4.5, "gid": f"side-{label}", "role": "arrow"}
                arrow(self.scene, *ends, ec="black", lw=0.8, **style)

    def name_axes(self) -> None:
        """Write the names of the axes beyond their tips."""
        closed = [np.vstack([area, area[:1]]) for _, area in self.picture.areas]
        for name, tip in zip(self.picture.axes.names, self.picture.axes.tips, strict=True):
            tip, origin = self.place(tip), self.place(self.picture.axes.origin)
            off = keep_off([*closed, np.array([origin, tip])])
            look: dict[str, Any] = {"away": tip - origin, "distance": 2.0, "style": "italic"}
            write_beside(self.scene, tip, [name], (7.0, 6.0), off=off, **look)

    def name_cells(self, *, beside: bool = True) -> int:
        """Write the name of each lifted cell on its largest free face, or `beside` it.

        Return how many found no room on their faces.
        """
        left = 0
        around = self._lines()
        for item in self.lifted:
            off = keep_off([], self._hiders(item))
            outlines = [self.place(loop) for loop in item.visible_outlines(self.picture.round)]
            outlines.sort(key=lambda outline: round(area(outline), 3), reverse=True)
            forms = self.names.forms(item.cell.signs)
            if not any(
                write_inside(self.scene, outline, text, (7, 6), off=off)
                for outline in outlines
                for text in forms
            ):
                left += 1
                if not beside:
                    continue
                way = item.shift[:2] + 1e-12
                corners = self.place(item.corners)
                look: dict[str, Any] = {"away": way, "off": around}
                write_beside(
                    self.scene, corners[int(np.argmax(corners @ way))], forms, (7.0, 6.0), **look
                )
        return left

    def _lines(self) -> Any:
        """Return what names beside cells must not cross: outlines of the body and of the cells."""
        lifted = [segment for item in self.lifted for segment in item.outlines()]
        closed = np.vstack([self.outline, self.outline[:1]])
        return keep_off(self.place(line) for line in (closed, *lifted))

    def _hiders(self, item: Lifted) -> list[Floats]:
        """Return the outlines of all that is painted after a lifted cell."""
        own = self.picture.painted_at[item.cell.signs]
        return [area for z, area in self.picture.areas if z > own]
