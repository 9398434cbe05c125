"""Numbers of planes around the body, and sign vectors on lifted cells."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from .exploded_cells import Lifted
from .globe import Floats
from .labels import sign_rows, spread, turn, write_beside
from .planesheet import Colour, PlanesSheet


class Names:
    """Writes on a finished picture; numbers first."""

    def __init__(self, picture: PlanesSheet) -> None:
        self.picture = picture
        self.stage, self.lifted = picture.stage, picture.lifted
        self.sheet, self.place = picture.sheet, picture.place
        self.outline = picture.outline

    def number_planes(self) -> None:
        """Write the numbers of the planes around the body, with a line to a visible rim."""
        wanted: list[tuple[float, Floats, str, Colour]] = []
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
            text = ",".join(str(k + 1) for k in members)
            wanted.append((float(angles[best]), points[best], text, self.picture.colour(label)))
        placed = spread([angle for angle, *_ in wanted], 0.13)
        for (_, point, text, colour), angle in zip(wanted, placed, strict=True):
            way = np.array([math.cos(angle), math.sin(angle)])
            edge = way / max(1e-9, self._gauge(way))
            start, stop = self.place(point), self.place(edge) + 4 * way
            self.sheet.line([start, stop], ec="black", lw=0.4, zorder=4)
            box = {"boxstyle": "round,pad=0.22,rounding_size=0.5", "fc": colour, "ec": "none"}
            self.sheet.write(self.place(edge) + 8.5 * way, text, 7.0, bbox=box)

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

    def name_cells(self) -> None:
        """Write the sign vector of each lifted cell on its largest free face, or beside it."""
        segments = self._segments()
        for item in self.lifted:
            hiders = self._hiders(item)
            outlines = [self.place(loop) for loop in item.visible_outlines(self.picture.round)]
            outlines.sort(key=_area, reverse=True)
            if not any(self._name_on(outline, hiders, item.cell.signs) for outline in outlines):
                way = item.shift[:2] + 1e-12
                corners = self.place(item.corners)
                write_beside(
                    self.sheet, corners[int(np.argmax(corners @ way))],
                    [sign_rows(item.cell.signs, rows) for rows in (1, 2)], (7.0, 6.0), away=way,
                    segments=segments,
                )  # fmt: skip

    def _segments(self) -> Floats:
        """Return what names beside cells must not cross: outlines of the body and of the cells."""
        around = np.stack([self.outline, np.roll(self.outline, -1, axis=0)], axis=1)
        lifted = [segment[:, :2] for item in self.lifted for segment in item.outlines()]
        return self.place(np.concatenate([around, np.array(lifted).reshape(-1, 2, 2)]))

    def _hiders(self, item: Lifted) -> list[Floats]:
        """Return the outlines of all that is painted after a lifted cell."""
        own = self.picture.painted_at[item.cell.signs]
        return [area for z, area in self.picture.areas if z > own]

    def _name_on(self, outline: Floats, hiders: list[Floats], signs: Sequence[int]) -> bool:
        """Write a sign vector on a face, off its edges and off what hides it, if there is room."""
        from matplotlib.path import Path

        low, high = outline.min(axis=0), outline.max(axis=0)
        near = [h for h in hiders if (h.max(axis=0) > low).all() and (h.min(axis=0) < high).all()]
        grid = np.stack(np.meshgrid(*np.linspace(low, high, 33).T), axis=-1).reshape(-1, 2)
        free = Path(outline).contains_points(grid)
        for hider in near:
            free &= ~Path(hider).contains_points(grid)
        if not free.any():
            return False
        grid = grid[free]
        walls = np.concatenate([_dense(loop) for loop in (outline, *near)])
        apart = np.abs(grid[:, None] - walls)
        for size, rows in ((7.0, 1), (6.0, 1), (7.0, 2), (6.0, 2), (6.0, 3)):
            text = sign_rows(signs, rows)
            box = np.array(self.sheet.measure(text, size)) + 2
            room = np.round((apart / box).max(axis=2).min(axis=1), 4)
            best = int(np.argmax(room))
            if room[best] > 0.5 and self.sheet.write(grid[best], text, size):
                return True
        return False


def _area(outline: Floats) -> float:
    """Return the area of a polygon in the plane, rounded so that ties stay ties."""
    x, y = outline.T
    return round(abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2, 3)


def _dense(outline: Floats) -> Floats:
    """Return a polygon with at most 2 points of paper between neighbouring corners."""
    pieces = []
    for p, q in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        steps = max(1, math.ceil(float(np.linalg.norm(q - p)) / 2))
        pieces.append(p + (q - p) * np.arange(steps)[:, None] / steps)
    return np.concatenate(pieces)
