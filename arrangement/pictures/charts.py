"""The sphere of central planes in its stereographic and gnomonic charts."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.drawing.colours import Choice, DrawnRegion, Painter
from arrangement.drawing.labels import SIZES, beside, inside, keep_off, write_if_free
from arrangement.drawing.scene import Box, Floats, Scene, along, area, curve_points, ring
from arrangement.drawing.solids.flat_polygons import between, clip_polygon
from arrangement.drawing.solids.sight import best_view, picture_axes, unit, unit_vectors, views
from arrangement.drawing.views import Vector
from arrangement.enumeration.great_circles import SphereArrangement
from arrangement.errors import InputError, extra
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, dot, reduced, sign, unoriented
from arrangement.numbers.linear.rank import cross, cycle_edges
from arrangement.pictures.coordinates import in_coordinates, planes_view, symmetry
from arrangement.pictures.globe import (
    HIDDEN,
    LINE_WIDTH,
    Disc,
    Drawn,
    Globe,
    far_direction,
    front_half,
    orthographic,
    rim_width,
    single_disc,
    stereographic,
)
from arrangement.pictures.names import (
    Labels,
    RegionLabels,
    explain_regions,
    names_on_paper,
    plane_names,
)

#: The whole plane is shown of itself when all circles end within this many radii of the limb.
FARTHEST = 3.3


@planes_view("stereographic")
def draw_stereographic(
    arrangement: Arrangement,
    *,
    camera: Vector | None = None,
    colour: Choice | None = None,
    labels: Labels | None = None,
    width: float = 88.0,
    whole: bool | None = None,
    coordinates: str | None = None,
) -> Scene:
    """Draw the great circles of central planes in R^3 in stereographic projection.

    The point of the sphere in the given direction is the middle of the picture, the opposite
    point is at infinity. The limb, the great circle half-way, is dashed and has radius 1. A
    number names a circle: k for the k-th plane, counted from 1.

    There are two pictures. The whole one has both halves of the sphere: every circle is complete,
    and the region with the opposite point is all that is outside. The other one is the front half
    alone, a disc; the back half shows the same with opposite signs.

    Every region and every arc is an element of its own (``region-3``, ``arc-7``; in the disc
    ``front-7``, ``limb-2``).

    Args:
        arrangement: central, of rank at most 3; in another space than R^3 its essentialisation.
        camera: the exact direction of the middle; if omitted, one is chosen.
        colour, labels: as for `draw_sphere`.
        whole: both halves, or the front half; if omitted, both where all circles stay within
            3.3 radii, as for few circles.
        coordinates: as for `draw_sphere`.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring; or
            the whole is asked for and the direction lies on a plane.
    """
    names = RegionLabels(arrangement, labels, items="circles")
    arrangement, camera, moved = in_coordinates(coordinates, arrangement, camera)
    globe = Globe(arrangement, camera)
    if camera is None and whole is not False:
        # The direction that keeps farthest from all planes.
        units = unit_vectors(globe.whole.circle_normals)
        inner = far_direction(globe.whole.arrangement, units) if len(units) else (1, 1, 1)
        central = Globe(arrangement, inner)
        if whole or _farthest(central) <= FARTHEST:
            globe, whole = central, True
    if whole is None:
        whole = 0 < _farthest(globe) <= FARTHEST
    colours = globe.colouring(colour)
    if whole and math.isinf(_farthest(globe)):
        k = next(i for i, s in enumerate(arrangement.signs_at(globe.direction)) if s == 0)
        raise InputError(
            f"the camera lies on circle {k + 1}, which would pass through infinity; "
            "choose another camera, or the front half alone "
            + budget.by_caller("(whole=False)", "(--no-whole)")
        )
    disc = (
        _both_halves(globe, names, width)
        if whole
        else single_disc(globe, front_half(globe, stereographic), names, width)
    )
    disc.map_points(moved)
    disc.draw(colours.paint)
    explain_regions(disc.scene, colours, names, globe.regions if whole else globe.front.values())
    return disc.scene


def _both_halves(globe: Globe, names: RegionLabels, width: float) -> _Whole:
    """Return the place for both halves: all circles and the limb, in a square frame."""
    scene = Scene(width, width)
    normals = unit_vectors(globe.whole.circle_normals).reshape(-1, 3) @ globe.axes.T
    a, b, c = normals.T
    centres, radii = np.stack([a / c, b / c], axis=1), 1 / np.abs(c)[:, None]
    low = np.vstack([centres - radii, [[-1.0, -1.0]]]).min(axis=0)
    high = np.vstack([centres + radii, [[1.0, 1.0]]]).max(axis=0)
    room = scene.width / 2 - _FRAME - rim_width(scene, globe)
    scale = room / max(float((high - low).max()) / 2, 1.0)
    x, y = (scene.width / 2 - scale * (low + high) / 2).tolist()
    rays = [globe.whole.ray(v) for v in range(globe.whole.vertex_count)]
    points = unit_vectors(rays) @ globe.axes.T if rays else np.empty((0, 3))
    drawn = Drawn(globe.whole, points, normals, stereographic)
    return _Whole(scene, (x, y), scale, globe, drawn, names, flat=True)


#: Between the frame of a whole picture and the edge of the paper, in points.
_FRAME = 1.5


class _Whole(Disc):
    """Both halves: the outer region in a frame, and all others on top of it."""

    def _frame(self, inside: float = 0.0) -> Box:
        """Return the frame, or a box that is so far inside of it."""
        low, high = _FRAME + inside, self.scene.width - _FRAME - inside
        return low, low, high, high

    @property
    def room(self) -> Box:
        return self._frame(2.0)

    def curves(
        self, paint: Painter, *, both_ends: bool = False
    ) -> tuple[list[tuple[DrawnRegion, Floats]], list[Floats], list[Floats]]:
        scene, sphere = self.scene, self.globe.whole
        left, low, right, high = self._frame()
        frame = np.array([(left, low), (right, low), (right, high), (left, high)])
        outlines: list[tuple[DrawnRegion, Floats]] = []
        outside = sphere.arrangement.signs_at([-x for x in self.globe.direction])
        numbers = sorted(enumerate(self.globe.regions), key=lambda item: item[1].signs != outside)
        for r, region in numbers:
            name = self.names.element("region", region.signs)
            style: dict[str, Any] = {"fc": paint(region), "ec": "none", "gid": name}
            if region.signs == outside:
                scene.polygon(frame, **style)
            else:
                outline = self.on_paper(self.drawn.outline(r))
                scene.curve(outline, **style)
                outlines.append((region, curve_points(outline)))
        lines = []
        for arc, circle in enumerate(sphere.incidence.arc_circle.tolist()):
            curve = self.on_paper(self.drawn.arc(arc))
            name = f"arc-{sphere.arrangement.firsts[circle] + 1}-{arc + 1}"
            scene.curve(curve, fill=False, ec="black", lw=LINE_WIDTH, zorder=3, gid=name)
            lines.append(along(curve))
        scene.circle(self.centre, self.radius, fill=False, ec="black", gid="limb", **HIDDEN)
        scene.polygon(frame, fill=False, ec="black", lw=0.4, ls=(0, (1, 2)), role="border")
        discs = self._name_circles(keep_off(lines))
        free = inside(scene, frame, keep_off([], [ring(disc[:2], disc[2]) for disc in discs]))
        write_if_free(scene, self.names.forms(outside)[:1], SIZES, free)
        return outlines, lines, [ring(self.centre, self.radius)]

    def _name_circles(self, off: Any) -> Floats:
        """Write each circle's number outside its farthest point, or else close to its line.

        Returns:
            The circles on paper, (c, 3): centre and radius.
        """
        a, b, c = self.drawn.normals.T
        centres = self.on_paper(np.stack([a / c, b / c], axis=1))
        discs = np.column_stack([centres, self.radius / np.abs(c)])

        def apart(one: int, other: int) -> float:
            x, y, larger = discs[one] - discs[other]
            return math.hypot(x, y) + abs(float(larger))

        classes = self.globe.whole.arrangement.distinct
        texts = names_on_paper(self.scene.legend, self.names, classes, apart, LINE_WIDTH)
        for k, text in sorted(texts.items(), key=lambda item: abs(c[item[0]])):
            # Farther and farther from the farthest point.
            for step in range(84):
                angle = math.atan2(b[k] * c[k], a[k] * c[k])
                angle += (step + 1) // 2 * 0.075 * (1 if step % 2 else -1)
                outward = np.array([math.cos(angle), math.sin(angle)])
                rim = discs[k, :2] + discs[k, 2] * outward
                places = beside(rim, away=outward, distance=1.2, within=self._frame(4.0), turns=2)
                look: dict[str, Any] = {"off": off, "style": "italic"}
                if write_if_free(self.scene, [text], SIZES[:2], places, **look):
                    break
        return discs


def _farthest(globe: Globe) -> float:
    """Return how far the circles reach from the middle of the picture, in radii of the limb."""
    if not globe.whole.circle_count:
        return 1.0
    if 0 in globe.whole.arrangement.signs_at(globe.direction):
        return math.inf
    heights = np.abs(unit_vectors(globe.whole.circle_normals) @ globe.axes[2])
    return float(((1 + np.sqrt(np.maximum(0, 1 - heights**2))) / heights).max())


#: Up to this many lines have names at both ends.
_BOTH_ENDS = 16
#: Parts of regions with a smaller area are not drawn; the disc has radius 1.
_LEAST = 1e-9


@planes_view("gnomonic")
def draw_gnomonic(
    arrangement: Arrangement,
    *,
    camera: Vector | None = None,
    colour: Choice | None = None,
    labels: Labels | None = None,
    width: float = 88.0,
    coordinates: str | None = None,
) -> Scene:
    """Draw central planes in R^3 as lines of the projective plane.

    The sphere is projected from its centre to the plane that touches it at the given direction,
    so that great circles become straight lines of this chart. The picture is a disc of it with
    most crossings; what is farther out is left out, and the legend says how much.

    Every region of the chart and every arc is an element of its own (``region-3``, ``front-7``).
    A number names a line, at both of its ends where there are few: k for the k-th plane, counted
    from 1.

    Args:
        arrangement: central, of rank at most 3; in another space than R^3 its essentialisation.
        camera: the exact direction of the middle; if omitted, one in which all rays stay far
            from infinity; of more than six planes an axis of most symmetries, if there is one, else
            one in which the crossings spread evenly.
        colour, labels: as for `draw_sphere`.
        coordinates: as for `draw_sphere`.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring.
    """
    names = RegionLabels(arrangement, labels, items="lines")
    arrangement, camera, moved = in_coordinates(coordinates, arrangement, camera)
    globe = Globe(arrangement, camera)
    if camera is None:
        globe = _upright(Globe(arrangement, _central_direction(globe)))
    colours = globe.colouring(colour)
    chart = _cut(globe)
    disc = single_disc(globe, chart, names, width)
    disc.map_points(moved)
    shown, _ = disc.draw(colours.paint, both_ends=globe.whole.circle_count <= _BOTH_ENDS)
    explain_regions(disc.scene, colours, names, shown)
    disc.scene.circle(disc.centre, disc.radius, fill=False, ec="black", lw=0.6, gid="border")
    whole = globe.whole.arrangement
    seen = {k for c, x in enumerate(whole.distinct) if chart.ends(c) for k in x}
    out = [k for k in range(len(whole)) if k not in seen]
    what = [f"line{'s' * (len(out) > 1)} {plane_names(whole, out)}"] * bool(out)
    what += [counted(len(globe.front) - len(shown), "region")] * (len(shown) < len(globe.front))
    disc.scene.legend.captions += [f"farther out: {', '.join(what)}"] * bool(what)
    disc.scene.legend.line("signs up to a common change")
    return disc.scene


class StraightChart:
    """Great circles as lines of a plane, cut off exactly at the edges of a convex window.

    Points are homogeneous, and finite: they are on one side of the circle at infinity.

    Attributes:
        sphere: the arrangement, with the circle at infinity.
        rows: for each circle integers of a linear form, 0 on its line, with the signs of its
            normal.
        corners: of the window, counter-clockwise.
    """

    def __init__(
        self,
        sphere: SphereArrangement,
        rows: Sequence[IntegerVector],
        corners: Sequence[IntegerVector],
    ) -> None:
        self.sphere, self.incidence = sphere, sphere.incidence
        self.rows, self.corners = rows, corners

    def outline(self, region: int) -> Floats:
        """Return the corners of the part of a region in the window."""
        return plane_points(self._clip(self.corners, region))

    def edge(self, arc: int) -> Floats:
        """Return the ends of the part of an arc in the window, (2, 2)."""
        ends = self._chords[int(self.incidence.arc_circle[arc])]
        region = int(self.incidence.region[2 * arc])
        return plane_points(dict.fromkeys(self._clip(ends, region)))

    def line(self, circle: int) -> Floats:
        """Return the ends of a line at the boundary of the window, (2, 2)."""
        return plane_points(self._chords[circle])

    @cached_property
    def _chords(self) -> list[list[IntegerVector]]:
        """The ends of each line at the boundary of the window, or nothing."""
        chords = []
        for row in self.rows:
            values = [dot(row, p) for p in self.corners]
            ends: list[IntegerVector] = []
            for (p, q), (at_p, at_q) in zip(
                cycle_edges(self.corners), cycle_edges(values), strict=True
            ):
                if at_p == 0:
                    ends.append(p)
                elif at_p * at_q < 0:
                    ends.append(between(p, q, at_p, at_q))
            chords.append(ends)
        return chords

    def _clip(self, loop: Sequence[IntegerVector], region: int) -> Sequence[IntegerVector]:
        """Return the part of a convex polygon in the closure of a region."""
        inside = self.sphere.region_witness(region)
        for circle in self.incidence.arc_circle[self.incidence.boundary(region) >> 1].tolist():
            side = sign(dot(self.sphere.circle_normals[circle], inside))
            loop = clip_polygon(loop, [side * dot(self.rows[circle], p) for p in loop])
        return loop


def plane_points(points: Iterable[IntegerVector]) -> Floats:
    """Return finite homogeneous points of a plane in floats, (k, 2)."""
    return np.array([[float(x / w), float(y / w)] for x, y, w in points]).reshape(-1, 2)


#: One over the rounding of unit vectors.
_GRID = 1 << 40


@dataclass(frozen=True)
class CutChart(Drawn):
    """A gnomonic chart, to scale and with straight lines, cut off at a circle.

    Attributes:
        reach: the radius of the part that is shown, in radii of the sphere.
    """

    reach: float

    @cached_property
    def straight(self) -> StraightChart:
        """The chart in units of the part that is shown, with a polygon for the circle."""
        normals = unit(self.normals * [self.reach, self.reach, 1.0])
        rim = np.insert(ring((0, 0), 1.0)[:-1], 2, 1.0, axis=1)
        rows, corners = (
            [tuple(row) for row in np.rint(_GRID * vectors).astype(int).tolist()]
            for vectors in (normals, rim)
        )
        return StraightChart(self.sphere, rows, corners)

    def place(self, point: Floats) -> Floats:
        """Return the place of a unit vector, or of its antipode, which is the same point here."""
        spot: Floats = point[:2] / point[2] / self.reach
        return spot

    def arc(self, arc: int) -> Floats:
        """Return the part of an arc that is shown; nothing if there is none, or at infinity."""
        ends = self.straight.edge(arc)
        return straight_curves(ends) if len(ends) == 2 else np.empty((0, 2))

    def outline(self, region: int) -> Floats:
        """Return the boundary of the part of a region that is shown, or nothing."""
        corners = self.straight.outline(region)
        seen = len(corners) > 2 and area(corners) > _LEAST
        return straight_curves(corners[[*range(len(corners)), 0]]) if seen else np.empty((0, 2))

    def ends(self, circle: int) -> tuple[float, ...]:
        """Return the angles at which a line leaves what is shown, if it is in it."""
        return tuple(
            math.atan2(y, x) % (2 * math.pi) for x, y in self.straight.line(circle).tolist()
        )


def straight_curves(points: Floats) -> Floats:
    """Return the control points of cubic curves that are straight from point to point."""
    steps = np.diff(points, axis=0) / 3
    thirds = np.stack([points[:-1] + steps, points[1:] - steps, points[1:]], axis=1)
    return np.concatenate([points[:1], thirds.reshape(-1, 2)])


def _cut(globe: Globe) -> CutChart:
    """Return the chart around most crossings: all of them, where none is far away."""
    inside = globe.points[globe.points[:, 2] > 1e-9]
    spans = np.linalg.norm(inside[:, :2] / inside[:, 2:], axis=1)
    gaps = [abs(c) / np.hypot(a, b) for a, b, c in globe.normals.tolist() if abs(c) < 1 - 1e-9]
    nearest = float(min(gaps, default=0.0))
    farthest = float(spans.max(initial=nearest))
    typical = float(np.quantile(spans, 0.75)) if len(spans) else nearest
    reach = max(0.5, 1.3 * farthest if farthest <= 3 * typical else 1.2 * typical)
    return CutChart(globe.cut, globe.points, globe.normals, orthographic, reach)


def _upright(globe: Globe) -> Globe:
    """Turn the picture so that the first line through the middle, if there is one, is upright."""
    normals = unit_vectors(globe.whole.circle_normals) @ globe.axes.T
    for x, y, z in normals.tolist():
        if abs(z) < _AT_LIMB:
            right = (x * globe.axes[0] + y * globe.axes[1]) / math.copysign(math.hypot(x, y), x)
            globe.axes = np.array([right, np.cross(globe.axes[2], right), globe.axes[2]])
            break
    return globe


#: This many lines leave enough room in the middle from everywhere.
_OPEN = 6
#: Rays so near to the limb are meant to lie on it: coordinates are rounded.
_AT_LIMB = 1e-3


def _central_direction(globe: Globe) -> IntegerVector:
    """Return where the farthest ray is nearest, on few planes; or where the rays spread evenly.

    Many symmetric planes are seen along an axis of most symmetries.
    """
    arrangement = globe.whole.arrangement
    rays = sorted({unoriented(globe.whole.ray(v)) for v in range(globe.whole.vertex_count)})
    if len(rays) < 2:
        return globe.direction
    lines = unit_vectors(rays)
    inside = np.abs(lines @ lines.T)
    if globe.whole.circle_count <= _OPEN:
        ray = best_view(rays, lambda seen: np.abs(unit_vectors(seen) @ lines.T).min(axis=1))
        far = far_direction(arrangement, lines)
        at_ray, at_far = np.abs(unit_vectors([ray, far]) @ lines.T).min(axis=1)
        return ray if at_ray > 0.98 * at_far else far
    group = symmetry(arrangement)
    if group is not None:
        kept = group.stabilizers(lines)
        # Of equal ones that from which the rays that are not at infinity are nearest.
        nearest = np.where(inside > _AT_LIMB, inside, 1.0).min(axis=1).round(3)
        best = max(range(len(rays)), key=lambda v: (kept[v], nearest[v], rays[v]))
        if kept[best] > 2:
            return _direction_near(
                rays[best], [rays[v] for v in np.flatnonzero(inside[best] < _AT_LIMB)]
            )
    halves = [v for v in views(*[range(-3, 4)] * 3) if v == unoriented(v)]
    return best_view(halves, lambda seen: [_evenness(picture_axes(v), lines) for v in seen])


def _direction_near(ray: IntegerVector, others: Sequence[IntegerVector]) -> IntegerVector:
    """Return a direction near a ray on whose limb the others lie, which are nearly there."""
    for one, two in combinations(others, 2):
        normal = reduced(cross(one, two))
        return normal if dot(normal, ray) > 0 else reduced(cross(two, one))
    return reduced(cross(others[0], cross(ray, others[0]))) if others else ray


def _evenness(axes: Floats, lines: Floats) -> float:
    """Return how far apart, in the mean of logarithms, rays are in the chart with these axes."""
    with extra("figures"):
        from scipy.spatial import KDTree

    points = lines @ axes.T
    points = np.where(points[:, 2:] < 0, -points, points)
    front = points[points[:, 2] > 1e-9]
    spans = np.linalg.norm(front[:, :2] / front[:, 2:], axis=1)
    places = compress(points, max(0.3, float(np.quantile(spans, 0.7))))
    gaps = KDTree(places).query(places, k=2)[0][:, 1]
    return round(float(np.log(gaps + 0.005).mean()), 6)


def compress(points: Floats, reach: float, inner: float = 0.7) -> Floats:
    """Return places in a disc of unit vectors (k, 3) in front of the limb, infinity at the rim.

    Within `reach` of the middle the chart is to scale. Beyond it, distance from the middle is
    compressed; directions are kept.

    Args:
        reach: where the compression begins; in radii of the sphere.
        inner: the part of the disc's radius that is to scale.
    """
    outward = np.linalg.norm(points[:, :2], axis=1)
    safe = np.maximum(outward, 1e-12)
    slope = points[:, 2] / safe  # 1 / (distance from the middle of the chart)
    rate = inner / (reach * (1 - inner))
    low = np.minimum(slope, 1 / reach)  # nearer ones are to scale
    far = 1 - (1 - inner) * low / (low + rate * (1 - reach * low))
    near = outward / np.maximum(points[:, 2], 1e-12) * inner / reach
    radius = np.where(slope * reach > 1, near, far)
    placed: Floats = points[:, :2] * (radius / safe)[:, None]
    return placed
