"""Planes of R^3 cut out by a ball or a cube, and sections of planes of R^4."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import groupby
from typing import Annotated, Any, TypeAlias

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.options.signature import Syntax
from arrangement.counts.configuration import pivot_columns
from arrangement.drawing.colours import SKIN, painter_of, pale, plane_colour, read_choice
from arrangement.drawing.labels import (
    SIZES,
    beside,
    beyond,
    inside,
    keep_off,
    spread_angles,
    turn,
    write_if_free,
)
from arrangement.drawing.scene import Floats, PageMap, Scene, area, arrow, measure
from arrangement.drawing.solids.depth_tree import SolidSheet
from arrangement.drawing.solids.sight import (
    light,
    shade,
    turn_view,
    unit,
    unit_vectors,
    view_direction,
)
from arrangement.drawing.solids.surface import Patch
from arrangement.drawing.views import Exact, Vector, picture
from arrangement.duals.cells import cut_cells, read_signs
from arrangement.errors import InputError, extra
from arrangement.numbers.exact import IntegerVector, dot, primitive, shown, sign_text
from arrangement.numbers.linear.rank import cut, rank, unit_vectors as standard_basis
from arrangement.numbers.symbolic import real_vector
from arrangement.pictures.coordinates import (
    INK,
    AxisNames,
    apply_map,
    caption,
    coordinate_map,
    drawn_axes,
    in_coordinates,
    in_space,
    in_view_space,
    inverse_root,
    planes_view,
    rounded_map,
)
from arrangement.pictures.names import Labels, RegionLabels, equation, plane_names, thinner
from arrangement.pictures.stage import (
    Facet,
    Lifted,
    Sides,
    Stage,
    StagedAxes,
    clear_sight,
    lifted_cells,
    with_lifted,
)

Equation: TypeAlias = Annotated[Iterable[Any], Syntax(lambda text: text.split(","), "A,B,..,E")]

#: Cosines below this are zero; what zeros cost.
_NEVER, _COST = 1e-9, 1.0


def cut_out(
    arrangement: Arrangement, plane: Equation | None, coordinates: str | None
) -> tuple[Arrangement, IntegerVector]:
    """Return what planes cut out on a hyperplane, and the hyperplane.

    Args:
        arrangement: central, of rank 4.
        plane: its equation ``a . x = e`` as ``(a_1, ..., a_d, e)``, a in the span of the normals;
            if omitted, one that meets lines of intersection not far off.
        coordinates: see `in_coordinates`; on the hyperplane they are orthonormal ones, rounded.

    Returns:
        Planes of R^3 with the signs of the given ones, and the equation in given coordinates.

    Raises:
        InputError: other planes, a hyperplane that is not one, or parallel to one of them.
    """
    space = in_view_space(arrangement, "section")
    matrix = coordinate_map(coordinates, space)
    mapped = rounded_map(np.eye(4) if matrix is None else matrix, 1 << 10)
    normals = [row[:-1] for row in arrangement.integer_planes]
    if plane is None:
        equation: IntegerVector = (*_clear_normal(normals, apply_map(*mapped, space)), 1)
    else:
        equation = primitive(real_vector(plane, "section"))
        d = arrangement.dimension
        if len(equation) != d + 1 or not any(equation[:-1]):
            raise InputError(
                f"the section is {shown(plane)}; give {d} coefficients, not all 0, and what the "
                "sum is equal to"
            )
        if rank([*normals, equation[:-1]]) > 4:
            raise InputError(
                f"the section {shown(plane)} is not of the space of the planes; give a sum of "
                "their normals"
            )
    both = Arrangement([*normals, equation[:-1]], [0] * len(normals) + [equation[-1]])
    *given, (*normal, offset) = apply_map(*mapped, in_space(both, 4)).integer_planes
    basis = cut(standard_basis(4), normal)
    lengths = np.array([math.hypot(*map(float, row)) for row in basis])
    units = np.array(basis, dtype=float) / lengths[:, None]
    scale = math.ceil(lengths.max()) << 10
    rows, scale = rounded_map(inverse_root(units @ units.T) / lengths, scale)
    axes = [[dot(row, column) for column in zip(*basis, strict=True)] for row in rows]
    square = dot(normal, normal)
    moved = [[square * dot(axis, row[:-1]) for axis in axes] for row in given]
    if flat := [k + 1 for k, row in enumerate(moved) if not any(row)]:
        raise InputError(f"plane {flat[0]} does not meet the section, to which it is parallel")
    offsets = [-scale * offset * dot(normal, row[:-1]) for row in given]
    return Arrangement(moved, offsets, names=arrangement.names), equation


def _clear_normal(normals: list[IntegerVector], space: Arrangement) -> IntegerVector:
    """Return a small sum of independent normals that is parallel to none, and orthogonal to no ray.

    Of the latter at least to none nearly, where lines that never meet the hyperplane cost little.

    Args:
        space: the same planes as they are drawn, in R^4.
    """
    chosen = pivot_columns(list(zip(*normals, strict=True)), len(normals))
    rays = unit_vectors([face.witness for face in space.faces(1)])
    drawn = unit_vectors([plane[:-1] for plane in space.integer_planes])
    basis = np.array([[float(x) for x in space.integer_planes[k][:-1]] for k in chosen])
    sums = sorted(itertools.product(range(-2, 3), repeat=4), key=lambda s: (sum(map(abs, s)), s))
    sums = [row for row in sums if any(row) and primitive(row) == row and row > (0, 0, 0, 0)]
    sums_on_axes = np.array(sums) @ basis
    sums_on_axes /= np.linalg.norm(sums_on_axes, axis=1, keepdims=True)
    near = np.abs(sums_on_axes @ rays.T)
    missed = near < _NEVER
    score = np.where(missed, 1.0, near).min(axis=1) - _COST * missed.any(axis=1)
    score -= (np.abs(sums_on_axes @ drawn.T) > 1 - _NEVER).any(axis=1)
    best = sums[int(np.argmax(np.round(score, 6)))]
    own = [normals[k] for k in chosen]
    return tuple(dot(best, column) for column in zip(*own, strict=True))


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
        """Draw a stage.

        Args:
            width: in millimetres.
            apart: whether all cells are lifted, each inside its cone, and nothing else is drawn.
        """
        self.half_axes, self.apart = axes, apart
        self.stage, self.lifted, self.paint = stage, lifted, paint
        self.round = stage.cells.body.kind == "ball"
        self.outline = self._outline()
        self.thinner = thinner(len(stage.arrangement.distinct))
        loose = [item.corners[:, :2] for item in lifted]
        numbers = [plane_names(stage.arrangement, x) for x in stage.arrangement.distinct]
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
        colour = shade(SKIN if wall < 0 else self.colour(wall), normal)
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
            score = np.minimum(gap, 0.35) - 2.5 * depth - 3.0 * self._cover_cost(points)
            best = int(np.argmax(np.round(score, 6)))
            if self._cover_cost(points[best : best + 1])[0]:
                continue
            text = plane_names(self.stage.arrangement, members)
            wanted.append((float(angles[best]), points[best], text, self.colour(label)))
        placed = spread_angles([angle for angle, *_ in wanted], 0.13)
        for (_, point, text, colour), angle in zip(wanted, placed, strict=True):
            way = np.array([math.cos(angle), math.sin(angle)])
            edge = way / max(1e-9, self._gauge(way))
            rim = self.place(edge)
            self.scene.line([self.place(point), rim + 4 * way], ec="black", lw=0.4, zorder=4)
            box = {"boxstyle": "round,pad=0.22,rounding_size=0.5", "fc": colour, "ec": "none"}
            places = beyond(rim[None], way[None], (5.6,))
            write_if_free(self.scene, [text], SIZES[:1], places, plate=box, style="italic")

    def _cover_cost(self, points: Floats) -> Floats:
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
        rims = {
            i
            for facet in self.stage.facets
            if facet.label == label
            for k, i in enumerate(facet.corners)
            if facet.rim[k] or facet.rim[k - 1]
        }
        points = self.stage.points[sorted(rims)]
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


@planes_view("planes")
def draw_planes(
    arrangement: Arrangement,
    *,
    body: str = "ball",
    centre: Vector | None = None,
    radius: Exact | None = None,
    camera: Vector | None = None,
    azimuth: float = 0.0,
    lift: Iterable[str] = (),
    colour: str | FacetPainter = "planes",
    labels: Labels | None = None,
    axes: AxisNames | None = None,
    sides: bool = False,
    width: float = 88.0,
    coordinates: str | None = None,
) -> Scene:
    """Draw the planes of an arrangement in R^3 inside a ball or a cube, cell by cell.

    Every facet is a polygon of its own (``facet-3-plane-1``), cut at the other planes. They are
    painted back to front in an exact order (see `depth_tree`), so that nothing hides wrongly. The
    projection is orthographic. A number beside the body names a plane: k for the k-th, counted
    from 1. For planes that are not central, the body contains all vertices (see `body_around`).

    Args:
        arrangement: of rank at most 3, central or not, coincident planes allowed; in another space
            than R^3 its essentialisation.
        body: "ball" or "cube".
        centre, radius: exact place and size of the body, if it is not to contain all vertices, for
            planes whose vertices are far apart. What is outside is left out.
        camera: exact vector to the viewer; if omitted, one in which no plane is edge-on.
        azimuth: as for `draw_sphere`.
        lift: sign vectors of cells such as ``"+-+"``, over the input planes; these cells are
            drawn as solids and moved outward.
        colour: "planes" (each its own colour), "shade" (grey by the angle to the light), "none",
            or a function from a `DrawnFacet` to a colour.
        labels: labels of lifted cells, as for `draw_sphere`.
        axes: names of the axes, True for ``x,y,z``, or "none"; if omitted, axes are drawn where
            coordinates have a meaning, such as x, y, r of the motions of a grasp.
        sides: mark the positive side of each plane by an arrow.
        coordinates: as for `draw_sphere`; "given" if omitted and the body has a given place.

    Raises:
        InputError: another space, too many planes, no such cell, lifted cells that run into
            each other, unknown body or colouring.
    """
    paint = _painter(colour)
    texts = [lift] if isinstance(lift, str) else list(lift)
    raised = [read_signs(arrangement, text) for text in texts]
    names = RegionLabels(arrangement, labels, len(raised))
    if coordinates is None and not (centre is None and radius is None):
        coordinates = "given"
    shown, coordinates = drawn_axes(arrangement, axes, coordinates)
    arrangement, camera, moved = in_coordinates(coordinates, arrangement, camera)
    toward = None if camera is None else view_direction(camera)
    cells = cut_cells(arrangement, body, centre, radius)
    if toward is None:
        toward = clear_sight(cells, raised)
    stage = Stage(cells, turn_view(toward, azimuth))
    lifted = lifted_cells(stage, raised)
    sheet = PlanesSheet(stage, lifted, paint, width, StagedAxes(stage, shown))
    if sides:
        sheet.mark_sides()
    sheet.number_planes()
    sheet.name_axes()
    sheet.name_cells(names)
    names.explain(sheet.scene.legend, raised)
    sheet.scene.maps.append(PageMap(place=lambda p: sheet.place(stage.in_view(moved(p))), size=3))
    return sheet.scene


@picture()
def draw_section(
    arrangement: Arrangement,
    *,
    section: Equation | None = None,
    body: str = "ball",
    camera: Vector | None = None,
    azimuth: float = 0.0,
    lift: Iterable[str] = (),
    colour: str | FacetPainter = "planes",
    labels: Labels | None = None,
    sides: bool = False,
    width: float = 88.0,
    coordinates: str | None = None,
) -> Scene:
    """Draw the section of central hyperplanes of rank 4 by another one, as planes in R^3.

    A caption has the equation of the hyperplane. Elements and signs are those of planes in R^3.

    Args:
        arrangement: central, of rank 4.
        section: the hyperplane ``a x1 + b x2 + c x3 + d x4 = e`` as ``a,b,c,d,e``; if omitted, one
            with small coefficients that meets lines of intersection not far off.
        body, azimuth, lift, colour, labels, sides: as for `draw_planes`.
        camera: as for `draw_planes`, in orthonormal coordinates of the hyperplane.
        coordinates: as for `draw_sphere`.

    Raises:
        InputError: other planes, a bad hyperplane; or as for `draw_planes`.
    """
    flat, (*normal, offset) = cut_out(arrangement, section, coordinates)
    scene: Scene = draw_planes.scene(
        flat,
        body=body,
        camera=camera,
        azimuth=azimuth,
        lift=lift,
        colour=colour,
        labels=labels,
        sides=sides,
        width=width,
        coordinates="given",
    )
    scene.maps.clear()  # a point of R^4 has no place
    cut = equation(tuple(normal), offset).replace("-", "\u2212")
    scene.legend.captions.append(f"section by {cut}")
    if text := caption(arrangement, 4):
        scene.legend.captions.append(text)
    return scene


def _painter(colour: str | FacetPainter) -> FacetPainter:
    painters: dict[str, FacetPainter] = {
        "planes": lambda facet: shade(plane_colour(facet.label), _facing(facet), 0.7),
        "shade": lambda facet: shade("#ffffff", _facing(facet), 0.1),
        "none": lambda facet: "#ffffff",
    }
    name, own = read_choice(colour)
    if own and name is None:
        return lambda facet: shade(own[facet.label % len(own)], _facing(facet), 0.7)
    return painter_of(colour, painters)


def _facing(facet: DrawnFacet) -> Floats:
    """Return the normal of a facet on the side of the light."""
    normal = np.array(facet.normal)
    return normal if light(normal) else -normal
