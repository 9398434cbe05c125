"""The sheet on which planes and cells in a body are painted and named."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import groupby
from typing import Any, TypeAlias

import numpy as np

from arrangement.console.number_form import sign_text
from arrangement.drawing.colours import SKIN, pale
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import SIZES, keep_off, write_if_free
from arrangement.drawing.scene.places import beside, beyond, inside, spread, turn
from arrangement.drawing.scene.scene import area, arrow, measure
from arrangement.drawing.solids.depth_tree import SolidSheet
from arrangement.drawing.solids.sight import lit, unit
from arrangement.drawing.solids.surface import Patch
from arrangement.errors import extra
from arrangement.pictures.parts.coordinates import INK
from arrangement.pictures.parts.names import RegionLabels, plane_names, thinner

from .lifted_cells import Lifted, with_lifted
from .stage import Facet, Sides, Stage, StagedAxes

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


class PlanesSheet(SolidSheet):
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
        self.half_axes, self.apart = axes, apart
        self.stage, self.lifted, self.paint = stage, lifted, paint
        self.round = stage.cells.body.kind == "ball"
        self.outline = self._outline()
        self.thinner = thinner(len(stage.arrangement.distinct))
        loose = [item.corners[:, :2] for item in lifted]
        numbers = map(plane_names, stage.arrangement.distinct)
        margin = max(MARGIN, 10.0 + max((measure(text, 7.0)[0] for text in numbers), default=0.0))
        bounds = np.vstack([self.outline, axes.tips[:, :2]])
        parts = [(bounds, (margin, MARGIN)), *((corners, (3.0, 10.0)) for corners in loose)]
        super().__init__(stage.direction, width, *parts)
        # When an area is painted, and the signs of the lifted cell that it is of.
        self.areas: list[tuple[float, tuple[int, ...], Floats]] = []
        self.painted_at: dict[tuple[int, ...], float] = {}
        self._paint_all()

    def _outline(self) -> Floats:
        """Return the outline of the body, (k, 2), counter-clockwise."""
        if self.round:
            angles = np.linspace(0, 2 * math.pi, 361)[:-1]
            return np.column_stack([np.cos(angles), np.sin(angles)])
        with extra("figures"):
            from scipy.spatial import ConvexHull

        flat = self.stage.points[: len(self.stage.cells.body.corners), :2]
        outline: Floats = flat[ConvexHull(flat).vertices]
        return outline

    # Pieces, back to front

    def _paint_all(self) -> None:
        """Paint everything back to front: by the tree of the planes what is in the body."""
        stage = self.stage
        pieces: list[tuple[Sides, Callable[[], None]]] = []
        if not self.apart:
            self.scene.polygon(self.place(self.outline), fc="#f7f7f5", ec="none", zorder=0)
            for number, facet in enumerate(stage.facets):
                pieces.append((facet.sides, partial(self._facet, facet, number)))
        pieces += [(x.cell.sides, partial(self._solid, x)) for x in self.lifted if not x.row]
        gone = {item.cell.sides for item in self.lifted}
        for sides, ends in () if self.apart else self._frame_pieces():
            if sides not in gone:
                style = {"lw": 0.5, "ec": "#555555"}
                pieces.append((sides, partial(self._line, self.place(ends), style)))
        for sides, ends in self.half_axes.inside():
            pieces.append((sides, partial(self._axis, self.place(ends), False)))

        tree = with_lifted(
            stage.tree(pieces), stage, self.lifted, lambda faces: partial(self._pieces, faces)
        )
        order = [paint for _, paints in self.layers(tree, 1) for paint in paints]
        tips = [
            (front, partial(self._axis, self.place(ends), True))
            for front, ends in self.half_axes.outside()
        ]
        behind, before = ([tip for front, tip in tips if front is side] for side in (False, True))
        todo: list[Callable[[], None]] = [*behind, *order, *before]
        for step, paint in enumerate(todo):
            self.z = 1 + step / (len(todo) + 1)
            paint()

    def _facet(self, facet: Facet, number: int) -> None:
        stage = self.stage
        fill = self.colour(facet.label, stage.arrangement.over_planes(facet.sides))
        corners = self.place(stage.points[list(facet.corners)])
        name = f"facet-{number}-plane-{stage.arrangement.firsts[facet.label] + 1}"
        self.areas.append((self.z, (), corners))
        style = {"alpha": OPACITY, "zorder": self.z, "gid": name}
        self.scene.polygon(corners, fc=fill, ec="none", **style)
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
            arrow(self.scene, ends[0], ends[1], 0.6, fc=INK, ec="none", role="axis", **style)
        else:
            self.scene.line(ends, ec=INK, lw=0.8, **style)

    def _frame_pieces(self) -> Iterator[tuple[Sides, Floats]]:
        """Yield the edges of the cube, or the outline of the ball, cut at the planes."""
        stage = self.stage
        if not self.round:
            yield from stage.body_edges()
            return
        cuts: set[float] = set()
        for normal, offset in stage.planes:
            length = math.hypot(normal[0], normal[1])
            if length > abs(offset):
                turned, half = math.atan2(normal[1], normal[0]), math.acos(offset / length)
                cuts |= {(turned + half) % (2 * math.pi), (turned - half) % (2 * math.pi)}
        ends = sorted(cuts) or [0.0]
        for start, stop in zip(ends, [*ends[1:], ends[0] + 2 * math.pi], strict=True):
            angles = np.linspace(start, stop, max(3, math.ceil((stop - start) / 0.03)))
            if stop - start > 1e-9:
                run = np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
                middle = run[len(run) // 2]
                yield tuple(1 if float(n @ middle) > b else -1 for n, b in stage.planes), run

    def _solid(self, item: Lifted) -> None:
        """Paint a lifted cell: its visible faces, shaded, then its edges."""
        for loop in item.visible_outlines(self.round):
            self._covers(item, self.place(loop))
        for k in item.visible:
            self._face(item, k, self.place(item.points[list(item.cell.faces[k])]))
        for segment in item.outlines():
            self._line(self.place(segment), {"lw": 0.9})

    def _pieces(self, patches: Sequence[Patch]) -> None:
        """Paint pieces of faces of lifted cells, shaded, then their edges."""
        for patch in patches:
            (number, k), corners = map(int, patch.name.split()), self.at_exact(patch.corners)
            self._covers(self.lifted[number], corners)
            self._face(self.lifted[number], k, corners)
        for edge in dict.fromkeys(frozenset(edge) for patch in patches for edge in patch.edges):
            self._line(self.at_exact(edge), {"lw": 0.9})

    def _covers(self, item: Lifted, loop: Floats) -> None:
        self.painted_at.setdefault(item.cell.signs, self.z)
        self.areas.append((self.z, item.cell.signs, loop))

    def _face(self, item: Lifted, k: int, corners: Floats) -> None:
        wall, normal = item.cell.walls[k], item.normals[k]
        if wall < 0 and self.round:
            normal = unit(item.points[list(item.cell.faces[k])].mean(axis=0) - item.shift)
        colour = lit(SKIN if wall < 0 else self.colour(wall), normal)
        name = f"cell-{sign_text(item.cell.signs)}"
        look: dict[str, Any] = {"lw": 0.3, "zorder": self.z, "joinstyle": "round", "gid": name}
        self.scene.polygon(corners, fc=colour, ec=colour, **look)

    def colour(self, label: int, signs: tuple[int, ...] = ()) -> str:
        """Return the colour of a plane, or of a facet of it."""
        normal = self.stage.planes[label][0]
        return _pale(self.paint(DrawnFacet(label, signs, (normal[0], normal[1], normal[2]))))

    # Names

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
            depth = np.array([1 - self._gauge(p[:2]) for p in points])
            score = np.minimum(gap, 0.35) - 2.5 * depth - 3.0 * self._covered(points)
            best = int(np.argmax(np.round(score, 6)))
            if self._covered(points[best : best + 1])[0]:
                continue
            text = plane_names(members)
            wanted.append((float(angles[best]), points[best], text, self.colour(label)))
        placed = spread([angle for angle, *_ in wanted], 0.13)
        for (_, point, text, colour), angle in zip(wanted, placed, strict=True):
            way = np.array([math.cos(angle), math.sin(angle)])
            edge = way / max(1e-9, self._gauge(way))
            rim = self.place(edge)
            self.scene.line([self.place(point), rim + 4 * way], ec="black", lw=0.4, zorder=4)
            box = {"boxstyle": "round,pad=0.22,rounding_size=0.5", "fc": colour, "ec": "none"}
            places = beyond(rim[None], way[None], (5.6,))
            write_if_free(self.scene, [text], SIZES[:1], places, plate=box, style="italic")

    def _covered(self, points: Floats) -> Floats:
        """Return 1 for points whose number would stand on or at a lifted cell, else 0."""
        from matplotlib.path import Path

        with extra("figures"):
            from scipy.spatial import ConvexHull

        reach = np.array([[max(self._gauge(p[:2]), 1e-9)] for p in points])
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
        reach = np.array([self._gauge(p[:2]) for p in points])
        seen = (points[:, 2] > 0) | (reach > 0.985)
        return points[seen] if seen.any() else points

    def _gauge(self, point: Floats) -> float:
        """Return by which factor the outline must be scaled to pass through a point."""
        if self.round:
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
                style: dict[str, Any] = {"zorder": 4.5, "gid": f"side-{label}"}
                arrow(self.scene, ends[0], ends[1], 0.55, fc="black", ec="none", **style)

    def name_axes(self) -> None:
        """Write the names of the axes beyond their tips."""
        closed = [np.vstack([loop, loop[:1]]) for _, _, loop in self.areas]
        for name, tip in zip(self.half_axes.names, self.half_axes.tips, strict=True):
            tip, origin = self.place(tip), self.place(self.half_axes.origin)
            off = keep_off([*closed, np.array([origin, tip])])
            places = beside(tip, away=tip - origin, distance=2.0)
            write_if_free(self.scene, [name], SIZES[:2], places, off=off, style="italic")

    def name_cells(self, names: RegionLabels, *, outside: bool = True) -> int:
        """Write the name of each lifted cell on its largest free face, or else `outside` of it.

        Return how many found no room on their faces.
        """
        left, segments = 0, [segment for item in self.lifted for segment in item.outlines()]
        closed = np.vstack([self.outline, self.outline[:1]])
        around = keep_off(self.place(line) for line in (closed, *segments))
        for item in self.lifted:
            own, signs = self.painted_at[item.cell.signs], item.cell.signs
            # What is painted after it may hide it.
            off = keep_off([], [at for z, of, at in self.areas if z > own and of != signs])
            outlines = [self.place(loop) for loop in item.visible_outlines(self.round)]
            outlines.sort(key=lambda outline: round(area(outline), 3), reverse=True)
            forms = names.forms(item.cell.signs)
            if not any(
                write_if_free(self.scene, forms, SIZES[:2], inside(self.scene, outline, off))
                for outline in outlines
            ):
                left += 1
                if not outside:
                    continue
                way = item.shift[:2] + 1e-12
                corners = self.place(item.corners)
                places = beside(corners[int(np.argmax(corners @ way))], away=way)
                write_if_free(self.scene, forms, SIZES[:2], places, off=around)
        return left


def _pale(colour: str) -> str:
    """Return any colour that matplotlib knows, mixed with white."""
    from matplotlib.colors import to_hex

    return pale(to_hex(colour))
