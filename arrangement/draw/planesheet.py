"""Puts a staged arrangement on a sheet: facets, edges of the body, lifted cells, numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from .globe import Floats
from .labels import sign_rows, spread, turn, write_beside
from .lifting import Lifted
from .painting import Facet, Key, Stage
from .sheet import POINTS, Sheet

#: Opacity of the facets; what lies behind them shows through.
OPACITY = 0.82
#: The share of white in the colour of a plane.
WHITE = 0.42
#: Towards the light, in the axes of the picture.
LIGHT = np.array([-0.35, 0.65, 0.68]) / np.linalg.norm([-0.35, 0.65, 0.68])
#: Room for the numbers around the body, in points.
MARGIN = 15.0
#: The surface of the body on a lifted cell.
SKIN = "#f3ead8"


@dataclass(frozen=True)
class DrawnFacet:
    """What a colouring may look at.

    Attributes:
        label: the class of planes (index into ``arrangement.distinct``).
        signs: of the facet, over the input planes; empty for the number of a plane and for faces
            of lifted cells.
        normal: the unit normal of the plane in the picture (right, up, towards the viewer).
    """

    label: int
    signs: tuple[int, ...]
    normal: tuple[float, float, float]


Colour: TypeAlias = tuple[float, float, float]
FacetPainter: TypeAlias = Callable[[DrawnFacet], str]


class PlanesSheet:
    """The picture; see `planes.draw_planes`."""

    def __init__(
        self, stage: Stage, lifted: Sequence[Lifted], paint: FacetPainter, width: float
    ) -> None:
        self.stage, self.lifted, self.paint = stage, lifted, paint
        self.round = stage.cells.body.kind == "ball"
        self.outline = self._outline()
        low, high = self._frame()
        loose = [item.corners[:, :2] for item in lifted] or [np.zeros((1, 2))]
        corner = np.concatenate(loose)
        least, most = corner.min(axis=0), corner.max(axis=0)
        paper = width * POINTS
        self.scale = min(
            (paper - a - b) / (right - left)
            for left, a in ((low[0], MARGIN), (least[0], 3.0))
            for right, b in ((high[0], MARGIN), (most[0], 3.0))
            if right - left > 0.5
        )
        left = min(low[0] * self.scale - MARGIN, least[0] * self.scale - 3)
        bottom = min(low[1] * self.scale - MARGIN, least[1] * self.scale - 10)
        top = max(high[1] * self.scale + MARGIN, most[1] * self.scale + 10)
        self.shift = np.array([-left, -bottom])
        self.sheet = Sheet(width, (top - bottom) / POINTS)
        self.figure = self.sheet.figure
        self.areas: list[tuple[float, Floats]] = []
        self.painted_at: dict[tuple[int, ...], float] = {}
        self._paint_all()

    def place(self, points: Any) -> Floats:
        """Return points of the picture (.., 2 or 3) on the sheet."""
        placed: Floats = np.asarray(points)[..., :2] * self.scale + self.shift
        return placed

    def _outline(self) -> Floats:
        """Return the outline of the body, (k, 2), counter-clockwise."""
        if self.round:
            angles = np.linspace(0, 2 * math.pi, 361)[:-1]
            return np.column_stack([np.cos(angles), np.sin(angles)])
        from scipy.spatial import ConvexHull

        flat = self.stage.points[: len(self.stage.cells.body.corners), :2]
        outline: Floats = flat[ConvexHull(flat).vertices]
        return outline

    def _frame(self) -> tuple[Floats, Floats]:
        return self.outline.min(axis=0), self.outline.max(axis=0)

    # Pieces, back to front

    def _paint_all(self) -> None:
        """Paint everything in the order of its keys."""
        self.sheet.polygon(self.place(self.outline), fc="#f7f7f5", ec="none", zorder=0)
        gone = {item.cell.signs for item in self.lifted}
        stage = self.stage
        todo: list[tuple[int, Key, Callable[[], None]]] = []
        for number, facet in enumerate(stage.facets):
            todo.append((0, stage.key(facet.sides), self._facet(facet, number)))
        for item in self.lifted:
            key = stage.key(item.cell.sides) if item.place == 0 else ()
            todo.append((item.place, key, self._solid(item)))
        for key, signs, ends in self._frame_pieces():
            if signs not in gone:
                todo.append((0, key, self._frame_line(ends)))
        todo.sort(key=lambda item: item[:2])
        for step, (_, _, act) in enumerate(todo):
            self.z = 1 + step / (len(todo) + 1)
            act()
        self._numbers()
        self._names_of_cells()

    def _facet(self, facet: Facet, number: int) -> Callable[[], None]:
        stage = self.stage
        members = stage.arrangement.distinct[facet.label]
        normal = stage.planes[facet.label][0]
        drawn = DrawnFacet(facet.label, stage.signs(facet.sides), (normal[0], normal[1], normal[2]))
        colour = _pale(self.paint(drawn))
        corners = self.place(stage.points[list(facet.corners)])
        name = f"facet-{number}-plane-{members[0] + 1}"

        def act() -> None:
            self.areas.append((self.z, corners))
            self.sheet.polygon(
                corners, fc=colour, ec="none", alpha=OPACITY, zorder=self.z, gid=name
            )
            for rim, style in ((True, {"lw": 0.9}), (False, {"lw": 0.55})):
                self._edges(corners, [r is rim for r in facet.rim], style)

        return act

    def _edges(self, corners: Floats, wanted: list[bool], style: dict[str, Any]) -> None:
        """Draw the wanted edges of a polygon as few open lines."""
        n = len(corners)
        if not any(wanted):
            return
        start = next((k for k in range(n) if wanted[k] and not wanted[k - 1]), 0)
        run: list[Any] = []
        for k in range(start, start + n):
            if wanted[k % n]:
                run = run or [corners[k % n]]
                run.append(corners[(k + 1) % n])
            elif run:
                self._line(run, style)
                run = []
        if run:
            self._line(run, style)

    def _line(self, points: Any, style: dict[str, Any]) -> None:
        base = {"ec": "black", "capstyle": "round", "joinstyle": "round", "zorder": self.z}
        self.sheet.line(points, **{**base, **style})

    def _frame_pieces(self) -> list[tuple[Key, tuple[int, ...], Floats]]:
        """Return the edges of the cube, or the outline of the ball, cut at the planes."""
        stage = self.stage
        if not self.round:
            return [(k, signs, stage.points[ends]) for k, signs, ends in stage.body_edges()]
        pieces = []
        for run in self._outline_runs():
            middle = run[len(run) // 2]
            sides = stage.sides_of(middle)
            pieces.append((stage.key(sides), stage.signs(sides), run))
        return pieces

    def _outline_runs(self) -> list[Floats]:
        """Cut the outline of the ball where a plane meets it."""
        cuts: set[float] = set()
        for normal, offset in self.stage.planes:
            length = math.hypot(normal[0], normal[1])
            if length > abs(offset):
                turned, half = math.atan2(normal[1], normal[0]), math.acos(offset / length)
                cuts |= {(turned + half) % (2 * math.pi), (turned - half) % (2 * math.pi)}
        ends = sorted(cuts) or [0.0]
        runs = []
        for start, stop in zip(ends, [*ends[1:], ends[0] + 2 * math.pi], strict=True):
            angles = np.linspace(start, stop, max(3, math.ceil((stop - start) / 0.03)))
            if stop - start > 1e-9:
                runs.append(np.column_stack([np.cos(angles), np.sin(angles), 0 * angles]))
        return runs

    def _frame_line(self, ends: Floats) -> Callable[[], None]:
        return lambda: self._line(self.place(ends), {"lw": 0.5, "ec": "#555555"})

    def _solid(self, item: Lifted) -> Callable[[], None]:
        """Paint a lifted cell: its visible faces, shaded, then its edges."""
        name = "cell-" + "".join("+" if s > 0 else "-" for s in item.cell.signs)

        def act() -> None:
            self.painted_at[item.cell.signs] = self.z
            self.areas += [(self.z, self.place(loop)) for loop in item.visible_outlines(self.round)]
            for k in item.visible:
                face, wall = item.cell.faces[k], item.cell.walls[k]
                corners, normal = item.points[list(face)], item.normals[k]
                if wall < 0 and self.round:
                    normal = corners.mean(axis=0) - item.shift
                    normal = normal / np.linalg.norm(normal)
                colour = _shaded(SKIN if wall < 0 else self._colour(wall), normal)
                self.sheet.polygon(
                    self.place(corners), fc=colour, ec=colour, lw=0.3,
                    zorder=self.z, joinstyle="round", gid=name,
                )  # fmt: skip
            for segment in item.outlines():
                self._line(self.place(segment), {"lw": 0.9})

        return act

    def _colour(self, label: int) -> Colour:
        """Return the colour of a plane, as its facets have it."""
        normal = self.stage.planes[label][0]
        return _pale(self.paint(DrawnFacet(label, (), (normal[0], normal[1], normal[2]))))

    # Numbers and names

    def _numbers(self) -> None:
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
            text = ",".join(str(k + 1) for k in members)
            wanted.append((float(angles[best]), points[best], text, self._colour(label)))
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

        length = np.maximum(np.linalg.norm(points[:, :2], axis=1, keepdims=True), 1e-9)
        places = self.place(points) + 8.5 * points[:, :2] / length
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
        if self.round:
            return float(np.linalg.norm(point))
        step = np.roll(self.outline, -1, axis=0) - self.outline
        out = np.column_stack([step[:, 1], -step[:, 0]])
        return float(((out @ point) / (out * self.outline).sum(axis=1)).max())

    def _names_of_cells(self) -> None:
        """Write the sign vector of each lifted cell on its largest free face, or beside it."""
        for item in self.lifted:
            hiders = self._hiders(item)
            outlines = [self.place(loop) for loop in item.visible_outlines(self.round)]
            outlines.sort(key=_area, reverse=True)
            if not any(self._name_on(outline, hiders, item.cell.signs) for outline in outlines):
                way = item.shift[:2] + 1e-12
                corners = self.place(item.corners)
                write_beside(
                    self.sheet, corners[int(np.argmax(corners @ way))],
                    sign_rows(item.cell.signs, 1), (7.0, 6.0), away=way,
                    segments=np.array([self.place(segment) for segment in item.outlines()]),
                )  # fmt: skip

    def _hiders(self, item: Lifted) -> list[Floats]:
        """Return the outlines of all that is painted after a lifted cell."""
        own = self.painted_at[item.cell.signs]
        return [area for z, area in self.areas if z > own]

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


def _pale(colour: str) -> Colour:
    """Return a colour mixed with white."""
    from matplotlib.colors import to_rgb

    red, green, blue = (x + (1 - x) * WHITE for x in to_rgb(colour))
    return red, green, blue


def _shaded(colour: str | Colour, normal: Floats) -> Colour:
    """Return a colour as it looks on a face with this normal."""
    from matplotlib.colors import to_rgb

    light = 0.76 + 0.24 * max(0.0, float(LIGHT @ normal))
    red, green, blue = to_rgb(colour)
    return red * light, green * light, blue * light
