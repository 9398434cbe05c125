"""Puts a staged arrangement on a scene: facets, edges of the body, lifted cells, numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import groupby
from typing import Any, TypeAlias

import numpy as np

from arrangement.drawing.colours import SKIN, pale
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.measuring import POINTS, measure
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.solids.sight import lit, unit
from arrangement.pictures.sphere.disc import plane_names, thinner

from .axes import INK, StagedAxes, arrow
from .exploded_cells import Lifted
from .painting import Facet, Key, Stage

#: Opacity of the facets; what lies behind them shows through.
OPACITY = 0.82
#: Room for the numbers around the body, at least; in points.
MARGIN = 15.0


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


FacetPainter: TypeAlias = Callable[[DrawnFacet], str]


class PlanesSheet:
    """The picture; see `planes.draw_planes`."""

    def __init__(
        self,
        stage: Stage,
        lifted: Sequence[Lifted],
        paint: FacetPainter,
        width: float,
        axes: StagedAxes,
        *,
        apart: bool = False,
    ) -> None:
        """Take the width in millimetres.

        `apart` says that all cells are lifted, each inside its cone, and nothing else is drawn.
        """
        self.axes, self.apart = axes, apart
        self.stage, self.lifted, self.paint = stage, lifted, paint
        self.round = stage.cells.body.kind == "ball"
        self.outline = self._outline()
        self.thinner = thinner(len(stage.arrangement.distinct))
        bounds = np.vstack([self.outline, axes.tips[:, :2]])
        low, high = bounds.min(axis=0), bounds.max(axis=0)
        loose = [item.corners[:, :2] for item in lifted] or [np.zeros((1, 2))]
        corner = np.concatenate(loose)
        least, most = corner.min(axis=0), corner.max(axis=0)
        paper = width * POINTS
        numbers = map(plane_names, stage.arrangement.distinct)
        margin = max(MARGIN, 10.0 + max((measure(text, 7.0)[0] for text in numbers), default=0.0))
        self.scale = min(
            (paper - a - b) / (right - left)
            for left, a in ((low[0], margin), (least[0], 3.0))
            for right, b in ((high[0], margin), (most[0], 3.0))
            if right - left > 0.5
        )
        left = min(low[0] * self.scale - margin, least[0] * self.scale - 3)
        bottom = min(low[1] * self.scale - MARGIN, least[1] * self.scale - 10)
        top = max(high[1] * self.scale + MARGIN, most[1] * self.scale + 10)
        self.shift = np.array([-left, -bottom])
        self.scene = Scene(width, (top - bottom) / POINTS)
        self.areas: list[tuple[float, Floats]] = []
        self.painted_at: dict[tuple[int, ...], float] = {}
        self._paint_all()

    def place(self, points: Any) -> Floats:
        """Return points of the picture (.., 2 or 3) on the scene."""
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

    # Pieces, back to front

    def _paint_all(self) -> None:
        """Paint everything in the order of its keys."""
        stage = self.stage
        todo: list[tuple[int, Key, Callable[[], None]]] = []
        if not self.apart:
            self.scene.polygon(self.place(self.outline), fc="#f7f7f5", ec="none", zorder=0)
            for number, facet in enumerate(stage.facets):
                todo.append((0, stage.key(facet.sides), partial(self._facet, facet, number)))
        for item in self.lifted:
            key = stage.key(item.cell.sides) if item.place == 0 else ()
            todo.append((item.place, key, partial(self._solid, item)))
        gone = {item.cell.signs for item in self.lifted}
        for key, signs, ends in () if self.apart else self._frame_pieces():
            if signs not in gone:
                style = {"lw": 0.5, "ec": "#555555"}
                todo.append((0, key, partial(self._line, self.place(ends), style)))
        for place, key, ends in self.axes.pieces():
            todo.append((place, key, partial(self._axis, self.place(ends), place != 0)))
        todo.sort(key=lambda item: item[:2])
        for step, (_, _, paint) in enumerate(todo):
            self.z = 1 + step / (len(todo) + 1)
            paint()

    def _facet(self, facet: Facet, number: int) -> None:
        stage = self.stage
        normal = stage.planes[facet.label][0]
        drawn = DrawnFacet(
            facet.label,
            stage.arrangement.over_planes(facet.sides),
            (normal[0], normal[1], normal[2]),
        )
        corners = self.place(stage.points[list(facet.corners)])
        name = f"facet-{number}-plane-{stage.arrangement.distinct[facet.label][0] + 1}"
        self.areas.append((self.z, corners))
        style = {"alpha": OPACITY, "zorder": self.z, "gid": name}
        self.scene.polygon(corners, fc=_pale(self.paint(drawn)), ec="none", **style)
        for rim, line in ((True, {"lw": 0.9}), (False, {"lw": 0.55})):
            self._edges(corners, [r is rim for r in facet.rim], line)

    def _edges(self, corners: Floats, wanted: list[bool], style: dict[str, Any]) -> None:
        """Draw the wanted edges of a polygon as few open lines."""
        n = len(corners)
        start = next((k for k in range(n) if wanted[k] and not wanted[k - 1]), 0)
        edges = [(start + k) % n for k in range(n)]
        for drawn, run in groupby(edges, key=lambda k: wanted[k]):
            if drawn:
                firsts = list(run)
                self._line(corners[[*firsts, (firsts[-1] + 1) % n]], style)

    def _line(self, points: Any, style: dict[str, Any]) -> None:
        style = {**style, "lw": style["lw"] * self.thinner}
        base = {"ec": "black", "capstyle": "round", "joinstyle": "round", "zorder": self.z}
        self.scene.line(points, **{**base, **style})

    def _axis(self, ends: Floats, last: bool) -> None:
        style: dict[str, Any] = {"gid": "axis", "zorder": self.z}
        if last:
            arrow(self.scene, *ends, **style)
        else:
            self.scene.line(ends, ec=INK, lw=0.8, **style)

    def _frame_pieces(self) -> list[tuple[Key, tuple[int, ...], Floats]]:
        """Return the edges of the cube, or the outline of the ball, cut at the planes."""
        stage = self.stage
        if not self.round:
            return [(k, signs, stage.points[ends]) for k, signs, ends in stage.body_edges()]
        pieces = []
        for run in self._outline_runs():
            middle = run[len(run) // 2]
            sides = stage.sides_of(middle)
            pieces.append((stage.key(sides), stage.arrangement.over_planes(sides), run))
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

    def _solid(self, item: Lifted) -> None:
        """Paint a lifted cell: its visible faces, shaded, then its edges."""
        name = "cell-" + "".join("+" if s > 0 else "-" for s in item.cell.signs)
        self.painted_at[item.cell.signs] = self.z
        self.areas += [(self.z, self.place(loop)) for loop in item.visible_outlines(self.round)]
        for k in item.visible:
            face, wall = item.cell.faces[k], item.cell.walls[k]
            corners, normal = item.points[list(face)], item.normals[k]
            if wall < 0 and self.round:
                normal = unit(corners.mean(axis=0) - item.shift)
            colour = lit(SKIN if wall < 0 else self.colour(wall), normal)
            look: dict[str, Any] = {"lw": 0.3, "zorder": self.z, "joinstyle": "round", "gid": name}
            self.scene.polygon(self.place(corners), fc=colour, ec=colour, **look)
        for segment in item.outlines():
            self._line(self.place(segment), {"lw": 0.9})

    def colour(self, label: int) -> str:
        """Return the colour of a plane, as its facets have it."""
        normal = self.stage.planes[label][0]
        return _pale(self.paint(DrawnFacet(label, (), (normal[0], normal[1], normal[2]))))


def _pale(colour: str) -> str:
    """Return any colour that matplotlib knows, mixed with white."""
    from matplotlib.colors import to_hex

    return pale(to_hex(colour))
