"""A half globe on paper: great circles, cut exactly at the limb, as curves in a disc.

The plane of the limb joins the arrangement as one more plane, so that the exact engine itself does
the cutting. Floats begin when arcs become curves. A projection takes an arc (unit normal of its
circle, unit vector where it starts, angle through which it turns counter-clockwise about the
normal; all in the axes right, up, towards the viewer) and returns control points (3k + 1, 2) of
cubic curves, in units of the limb.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Any, TypeAlias

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import (
    Choice,
    Colouring,
    DrawnRegion,
    Painter,
    colouring,
    letter_colour,
)
from arrangement.drawing.labels import (
    SIZES,
    Leaders,
    beside,
    inside,
    keep_off,
    spread_angles,
    turn,
    write_if_free,
)
from arrangement.drawing.scene import (
    Box,
    Floats,
    PageMap,
    Scene,
    along,
    arrow,
    cubic_curves,
    curve_points,
    measure,
)
from arrangement.drawing.solids.sight import (
    Score,
    across,
    best_view,
    picture_axes,
    turn_view,
    unit,
    unit_vectors,
    view_direction,
    views,
)
from arrangement.drawing.views import Vector
from arrangement.enumeration.great_circles import SphereArrangement, sphere_arrangement
from arrangement.enumeration.great_circles.arrangement import PackedSigns, unpack
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, dot
from arrangement.numbers.linear.rank import cross
from arrangement.pictures.coordinates import (
    INK,
    REACH,
    AxisNames,
    drawn_axes,
    in_coordinates,
    orbits,
    planes_view,
    within_reach,
)
from arrangement.pictures.names import (
    Labels,
    RegionLabels,
    explain_regions,
    names_on_paper,
    plane_names,
    thinner,
)
from arrangement.planes.planes import Planes

Projection: TypeAlias = Callable[[Floats, Floats, float], Floats]


def orthographic(normal: Floats, start: Floats, angle: float) -> Floats:
    """Return the arc as seen from far away; within 10^-5 of the true ellipse."""
    place, speed = _points(normal, start, angle, math.pi / 8)
    step = angle / (len(place) - 1)
    return cubic_curves(place[:, :2], speed[:, :2] * (4 / 3 * math.tan(step / 4)))


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
        return cubic_curves(flat, np.tile((flat[1] - flat[0]) / 3, (2, 1)))
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
    return cubic_curves(centre + spoke, speed * (4 / 3 * math.tan(sweep / pieces / 4)))


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
    _arcs: dict[int, Floats] = field(default_factory=dict, init=False, repr=False)

    def place(self, point: Floats) -> Floats:
        """Return the place of a unit vector in the axes of the picture."""
        spot: Floats = self.projection(across(point), point, 1e-3)[0]
        return spot

    def arc(self, arc: int) -> Floats:
        """Return the control points (3k + 1, 2) of an arc."""
        if arc not in self._arcs:
            start, stop = self.sphere.incidence.origin[2 * arc : 2 * arc + 2].tolist()
            normal = self.normals[int(self.sphere.incidence.arc_circle[arc])]
            p, angle = across(normal), 2 * math.pi
            if start >= 0:
                p, q = self.points[[start, stop]]
                angle = math.atan2(math.hypot(*cross(p.tolist(), q.tolist())), float(p @ q))
            self._arcs[arc] = self.projection(normal, p, angle)
        return self._arcs[arc]

    def ends(self, circle: int) -> tuple[float, ...]:
        """Return the two angles where a circle meets the limb, or one to name the limb itself."""
        if circle == self.sphere.plane_circle[-1]:
            return (0.25,)
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


def _points(normal: Floats, start: Floats, angle: float, most: float) -> tuple[Floats, Floats]:
    """Return points along an arc, at most `most` apart, and the unit tangents there."""
    side = np.array(cross(normal.tolist(), start.tolist()))
    steps = max(1, math.ceil(angle / max(most, 1e-3) - 1e-9))
    at = np.linspace(0, angle, steps + 1)[:, None]
    return np.cos(at) * start + np.sin(at) * side, np.cos(at) * side - np.sin(at) * start


class Globe:
    """A central arrangement in R^3 seen from a direction, in the orthographic projection.

    Attributes:
        whole: the arrangement on the sphere.
        cut: the same with the limb as one more plane, the last one.
        direction: the primitive integer direction towards the viewer.
        axes: (3, 3); the unit vectors right, up and towards the viewer.
    """

    def __init__(
        self,
        arrangement: Arrangement,
        direction: Sequence[object] | None = None,
        azimuth: float = 0.0,
    ) -> None:
        budget.check_size(len(arrangement.distinct), "great circles in a picture")
        self.whole = sphere_arrangement(arrangement)
        if direction is not None:
            self.direction = view_direction(direction)
        else:
            self.direction = clear_direction(*self.lines())
        self.direction = turn_view(self.direction, azimuth)
        self.cut = sphere_arrangement(Arrangement([*arrangement.normals, self.direction]))
        self.axes = picture_axes(self.direction)

    def lines(self) -> tuple[list[IntegerVector], list[float]]:
        """Return what is to stay off the limb, normals and rays, and how many times nearer it may.

        A ray on three planes or more is to stay away farthest.
        """
        whole = self.whole
        count = [len(whole.incidence.circles_at(v)) for v in range(whole.vertex_count)]
        many = max(count, default=2) > 2
        times = [2.0 * many or 1.0] * whole.circle_count
        times += [3.0 if many and k == 2 else 1.0 for k in count]
        return [*whole.circle_normals, *map(whole.ray, range(whole.vertex_count))], times

    @cached_property
    def points(self) -> Floats:
        """(V, 3); the vertices of `cut`, in the axes of the picture."""
        rays = [self.cut.ray(v) for v in range(self.cut.vertex_count)]
        return unit_vectors(rays) @ self.axes.T

    @cached_property
    def normals(self) -> Floats:
        """(c, 3); the unit normals of the circles of `cut`, in the axes of the picture."""
        return unit_vectors(self.cut.circle_normals) @ self.axes.T

    @cached_property
    def regions(self) -> tuple[DrawnRegion, ...]:
        """All regions of `whole`, in its order."""
        degrees = self.whole.incidence.region_degree.tolist()
        return tuple(map(DrawnRegion, region_signs(self.whole), degrees))

    @cached_property
    def front(self) -> dict[int, DrawnRegion]:
        """The regions of `cut` on the near side, each with the region of which it is a part."""
        sides = {region.signs: region for region in self.regions}
        cut = enumerate(region_signs(self.cut))
        return {piece: sides[signs[:-1]] for piece, signs in cut if signs[-1] > 0}

    def colouring(self, colour: Choice | None) -> Colouring:
        """Return how the regions are coloured; see `colours.colouring`."""
        beside = self.whole.incidence.region[: 2 * self.whole.arc_count].tolist()
        pairs = list(zip(beside[::2], beside[1::2], strict=True))
        planes, signs = self.whole.arrangement, [region.signs for region in self.regions]
        find_orbits = partial(orbits, planes, signs)
        return colouring(colour, self.regions, pairs, planes.firsts, find_orbits)

    @cached_property
    def limb(self) -> int:
        """The circle of the limb."""
        return int(self.cut.plane_circle[-1])


def region_signs(sphere: SphereArrangement) -> list[tuple[int, ...]]:
    """Return the sign vectors of all regions."""
    positive = sphere.packed_region_signs
    return sign_vectors(sphere, (positive, ~positive))


def sign_vectors(
    sphere: SphereArrangement, packed: tuple[PackedSigns, PackedSigns]
) -> list[tuple[int, ...]]:
    """Return sign vectors, given where they are + and where they are -."""
    return [tuple(row) for row in unpack(*packed, len(sphere.arrangement)).tolist()]


def clear_direction(
    lines: Sequence[IntegerVector], times: Sequence[float] = (), also: Score | None = None
) -> IntegerVector:
    """Return a direction from above that is as far as can be from orthogonal to all `lines`.

    With the normals of planes as lines no plane is seen edge-on; with the rays as well, no ray
    is near the limb. A line may be `times` as near as others; `also` returns more numbers to be
    kept from 0.
    """
    units = unit_vectors([*lines, (0, 0, 1)])

    def score(seen: Sequence[IntegerVector]) -> Floats:
        least = (np.abs(unit_vectors(seen) @ units.T) * [*(times or [1.0] * len(lines)), 1.0]).min(
            axis=1
        )
        # A line alone is not seen from straight ahead.
        least = np.minimum(least, 1.2 - least)
        scores: Floats = least if also is None else np.minimum(least, also(seen))
        return scores

    return best_view(views(range(1, 8), range(-7, 8), range(1, 7), low=0.25, high=0.75), score)


def far_direction(arrangement: Planes, lines: Floats) -> IntegerVector:
    """Return the direction farthest from orthogonal to unit vectors, on the fewest planes."""
    return best_view(
        views(*[range(-7, 8)] * 3),
        lambda seen: np.abs(unit_vectors(seen) @ lines.T).min(axis=1),
        lambda seen: [sum(arrangement.signs_at(v)) for v in seen],
    )


#: Room for the numbers of the planes between the rim and the boundary, at least; in points.
RIM = 13.0
#: What is hidden: thinner, lighter, dashed. One rule for spheres and polyhedra.
HIDDEN: dict[str, Any] = {"lw": 0.5, "ls": (0, (3, 3)), "alpha": 0.5, "zorder": 2, "role": "hidden"}
#: More regions than this get no leader lines.
_MOST_LEADERS = 150
#: Of most lines, in points; what is narrower is covered by them.
LINE_WIDTH = 0.9


@dataclass(frozen=True)
class Disc:
    """A place on a scene for the front half of a globe.

    Attributes:
        scene: the scene.
        centre, radius: of the limb, in points.
        globe: what is seen.
        drawn: its arcs and regions, cut at the limb, as curves.
        names: of the regions.
        ink: the colour of each class of planes; if omitted, black.
        solid: whether it is a ball, shaded, with the arcs on its far side dashed.
        flat: whether no region is seen from the side.
    """

    scene: Scene
    centre: tuple[float, float]
    radius: float
    globe: Globe
    drawn: Drawn
    names: RegionLabels
    ink: Callable[[int], str] | None = None
    solid: bool = False
    flat: bool = False

    @property
    def room(self) -> Box:
        """The part of the scene that leader lines must not leave."""
        return 0.0, self.scene.height - self.scene.width, self.scene.width, self.scene.height

    def on_paper(self, points: Floats) -> Floats:
        """Return points of the disc in points of the scene."""
        return np.array(self.centre) + self.radius * points

    def place(self, point: Floats) -> Floats:
        """Return where a direction from the origin is on the scene, or its antipode in a chart."""
        direction = self.globe.axes @ point
        return self.on_paper(self.drawn.place(direction / np.linalg.norm(direction)))

    def map_points(self, moved: Callable[[Floats], Floats]) -> None:
        """Register in the scene where points of the model are drawn, after a move."""
        self.scene.maps.append(PageMap(place=lambda point: self.place(moved(point)), size=3))

    def draw(
        self,
        paint: Painter,
        *,
        both_ends: bool = False,
        avoid: Sequence[Floats] = (),
        within: Box | None = None,
    ) -> tuple[list[DrawnRegion], list[Floats]]:
        """Draw everything, labels of regions off `avoid`; return regions seen and lines, (k, 2)."""
        outlines, arcs, hidden = self.curves(paint, both_ends=both_ends)
        inner = [*hidden, *avoid]
        lines, box = [*arcs, *inner], within or self.room
        label_regions(self.scene, self.names, outlines, lines, inner, box, self.flat)
        return [region for region, _ in outlines], lines

    def curves(
        self, paint: Painter, *, both_ends: bool = False
    ) -> tuple[list[tuple[DrawnRegion, Floats]], list[Floats], list[Floats]]:
        """Draw everything but labels of regions; return outlines, near arcs and far arcs."""
        outlines = []
        for piece, region in self.globe.front.items():
            outline = self.on_paper(self.drawn.outline(piece))
            if not len(outline):
                continue
            self.scene.curve(
                outline, fc=paint(region), ec="none", gid=self.names.element("region", region.signs)
            )
            outlines.append((region, curve_points(outline)))
        if self.solid:
            self.scene.ball(self.centre, self.radius, "#ffffff55", "#0000003c", zorder=1.5)
        hidden = self._draw_back()
        self._names(both_ends)
        return outlines, self._arcs(), hidden

    def _draw_back(self) -> list[Floats]:
        """Draw the half of each circle on the far side, dashed; return points along them."""
        globe, curves = self.globe, []
        for circle, normal in enumerate(globe.normals if self.solid else ()):
            if circle != globe.limb:
                start = np.array([normal[1], -normal[0], 0.0]) / math.hypot(normal[0], normal[1])
                curve = self.on_paper(self.drawn.projection(normal, start, math.pi))
                ink = self.ink(circle) if self.ink is not None else "black"
                style = {**HIDDEN, "lw": HIDDEN["lw"] * thinner(globe.whole.circle_count)}
                name = f"back-{globe.whole.arrangement.firsts[circle] + 1}"
                self.scene.curve(curve, fill=False, ec=ink, gid=name, **style)
                curves.append(along(curve))
        return curves

    def _arcs(self) -> list[Floats]:
        """Draw the arcs on the near side and the limb; return points along them."""
        globe, drawn, curves = self.globe, self.drawn, []
        is_plane = len(globe.cut.arrangement.distinct[globe.limb]) > 1
        for arc, circle in enumerate(drawn.sphere.incidence.arc_circle.tolist()):
            colour = self.ink(circle) if self.ink is not None else "black"
            number = f"{globe.cut.arrangement.firsts[circle] + 1}-{arc + 1}"
            style: dict[str, Any] = {"fill": False, "capstyle": "round", "zorder": 3}
            if circle == globe.limb:
                colour = colour if is_plane else "black"
                name = f"limb-{number}" if is_plane else f"limb-{arc + 1}"
                style |= {"ec": colour, "lw": 1.6 if is_plane else 0.6, "gid": name}
            elif dot(globe.cut.arc_witness(arc), globe.direction) > 0:
                thick = 1.3 if self.ink is not None else 0.9
                thick *= thinner(globe.whole.circle_count)
                style |= {"ec": colour, "lw": thick, "gid": f"front-{number}"}
            else:
                continue
            curve = self.on_paper(drawn.arc(arc))
            if not len(curve):
                continue
            self.scene.curve(curve, **style)
            curves.append(along(curve))
        return curves

    def _names(self, both_ends: bool) -> None:
        """Write the numbers of the planes outside the rim, pushed apart along it."""
        wanted: list[tuple[float, float, str, int]] = []
        globe, distinct = self.globe, self.globe.cut.arrangement.distinct
        # Angles between planes; on paper circles are at most so many radii apart.
        units = globe.normals / np.linalg.norm(globe.normals, axis=1)[:, None]
        signs = np.sign(units @ units.T)

        def apart(one: int, other: int) -> float:
            if globe.limb in (one, other):
                return math.inf
            away = units[one] - signs[one, other] * units[other]
            return self.radius * float(np.linalg.norm(away))

        planes, legend = len(globe.whole.arrangement), self.scene.legend
        texts = names_on_paper(legend, self.names, distinct, apart, LINE_WIDTH, planes)
        for circle, text in texts.items():
            ends = list(self.drawn.ends(circle))
            if not ends:
                continue
            if len(ends) > 1 and not both_ends:
                gap = [min((abs(turn(a - b)) for b, *_ in wanted), default=4.0) for a in ends]
                ends = ends[:1] if gap[0] >= gap[1] - 1e-9 else ends[1:]
            # Angles of one point of the rim differ by rounding, also by a whole turn.
            near = [(end + 1e-9) % (2 * math.pi) - 1e-9 for end in ends]
            wanted += [(round(a, 8), self._lean(circle, a), text, circle) for a in near]
        wanted.sort()
        placed = spread_angles([angle for angle, *_ in wanted], 9.0 / (self.radius + RIM / 2))
        for (angle, _, text, circle), at in zip(wanted, placed, strict=True):
            ends_at = np.array([[math.cos(angle), math.sin(angle)], [math.cos(at), math.sin(at)]])
            leader = self.on_paper(ends_at * [[1.0], [1 + 2.6 / self.radius]])
            colour = self.ink(circle) if self.ink is not None else "black"
            self.scene.line(leader, ec=colour, lw=0.4, zorder=2)
            self._name(ends_at[1], text, letter_colour(circle) if self.ink else "black")

    def _lean(self, circle: int, angle: float) -> float:
        """Return how far a circle leans counter-clockwise from a point of the rim inwards."""
        x, y, z = self.globe.normals[circle].tolist()
        across = y * math.cos(angle) - x * math.sin(angle)
        return -z / across if circle != self.globe.limb else 0.0

    def _name(self, outward: Floats, text: str, colour: str) -> None:
        def places(half: Floats) -> Floats:
            out = self.radius + 3.4 + float(np.abs(outward) @ half) + np.array([[0], [2], [4]])
            centres: Floats = np.array(self.centre) + out * outward
            return centres

        write_if_free(self.scene, [text], SIZES, places, color=colour, style="italic")


def label_regions(
    scene: Scene,
    names: RegionLabels,
    outlines: Sequence[tuple[DrawnRegion, Floats]],
    lines: Sequence[Floats],
    inner: Sequence[Floats],
    within: Box,
    flat: bool = False,
) -> None:
    """Write the names of regions, first inside, then those that do not fit on leader lines.

    Args:
        scene: where to.
        names: counts those that are left out.
        outlines: of the regions.
        lines: all lines drawn, each (k, 2); no label covers one.
        inner: those among them that are not boundaries of regions.
        within: a part of the scene that leader lines must not leave.
        flat: whether no region is seen from the side.
    """
    names.unseen += sum(_is_unseen(outline, flat or names.joined) for _, outline in outlines)
    off = keep_off(inner)
    small = [
        (region, outline)
        for region, outline in outlines
        if names.forms(region.signs)
        and not write_if_free(scene, names.forms(region.signs), SIZES, inside(scene, outline, off))
    ]
    leaders = Leaders(scene, lines, within, [outline for _, outline in outlines])
    for region, outline in small:
        texts = names.forms(region.signs)[:1]
        names.left_out += len(outlines) > _MOST_LEADERS or not leaders.write(
            outline, texts, SIZES[1:]
        )


def _is_unseen(outline: Floats, narrow: bool) -> bool:
    """Return whether lines cover a region: it is as small as their width, or as narrow.

    Args:
        narrow: whether it is unseen where it is narrow; at the rim of a ball it is only seen
            from the side.
    """
    if not narrow:
        return bool((np.ptp(outline, axis=0) < LINE_WIDTH).all())
    along, nexts = np.asarray(outline), np.roll(outline, -1, axis=0)
    area = abs(float(np.sum(along[:, 0] * nexts[:, 1] - along[:, 1] * nexts[:, 0]))) / 2
    length = float(np.hypot(*(nexts - along).T).sum())
    return 2 * area < LINE_WIDTH * length


def single_disc(
    globe: Globe, drawn: Drawn, names: RegionLabels, width: float, *, solid: bool = False
) -> Disc:
    """Return a disc that fills its scene; `width` in millimetres."""
    scene = Scene(width, width)
    centre = (scene.width / 2, scene.width / 2)
    radius = scene.width / 2 - rim_width(scene, globe, names)
    return Disc(scene, centre, radius, globe, drawn, names, solid=solid)


def rim_width(scene: Scene, globe: Globe, names: RegionLabels | None = None) -> float:
    """Return the room that numbers of planes and short labels need outside the limb, in points."""
    arrangement = globe.whole.arrangement
    widths = [5.5 + measure(plane_names(arrangement, x), 7.0)[0] for x in arrangement.distinct]
    # Up to three signs fit into most regions.
    beside_ball = names and names.kind == "signs" and len(arrangement) > 3
    forms = names.forms((1,) * len(arrangement)) if names and beside_ball else []
    beside = min(24.0, 3.5 + max((measure(text, SIZES[1])[0] for text in forms), default=0.0))
    return max([RIM, beside, *widths])


def front_half(globe: Globe, projection: Projection) -> Drawn:
    """Return the arrangement with the limb as one more circle, in a projection."""
    return Drawn(globe.cut, globe.points, globe.normals, projection)


@planes_view("sphere")
def draw_sphere(
    arrangement: Arrangement,
    *,
    camera: Vector | None = None,
    azimuth: float = 0.0,
    colour: Choice | None = None,
    labels: Labels | None = None,
    axes: AxisNames | None = None,
    sides: bool = False,
    width: float = 88.0,
    coordinates: str | None = None,
) -> Scene:
    """Draw the great circles of central planes in R^3 as seen from a direction.

    The ball is lit from the upper left, from in front; arcs on its far side are dashed. A number
    at the limb names a circle: k for the k-th plane, counted from 1. A label that does not fit
    into its region stands beside it, with a line to a dot inside. Every visible region and every
    arc, cut at the limb, is an element of its own with a name (``region-3``, ``front-7``); so
    is the far half of a circle (``back-2``).

    Args:
        arrangement: central, of rank at most 3; in another space than R^3 its essentialisation.
        camera: exact vector to the viewer; if omitted, one in which no circle is edge-on.
        azimuth: degrees by which the viewer moves to the right.
        colour: "sides" (by number of sides), "parity" (two colours, by number of minus signs),
            "signs" (shades, by number of minus signs), "orbits" (of the symmetry), "none", or a
            function from a `DrawnRegion` to a colour; if omitted, sides if they distinguish
            neighbours, else parity. Your own colours follow the name,
            ``"sides:white,gold,#0072b2"``, or stand alone; or some regions have one,
            ``"+-+=gold,++-=#0af"``, and the others are white.
        labels: "signs" of regions; "numbers" in the order of `Arrangement.regions`, with a table
            of sign vectors below; "none". If omitted, signs of up to four planes, else numbers,
            with the table for up to 24 regions. For some regions only: these, by sign vector or
            number, ``"+-+,3"``, or with texts, ``"+-+=A,3=B"`` or ``{"+-+": "A", 3: "B"}``.
        axes: names of the axes, True for ``x,y,z``, or "none"; if omitted, axes are drawn where
            coordinates have a meaning, such as x, y, r of the motions of a grasp.
        sides: mark the positive side of each plane by an arrow.
        coordinates: "symmetric", after a linear map that shows the symmetry of the planes and
            changes no sign vector; "even", after one that spreads the normals evenly; or "given".
            If omitted, given for planes of motions and with axes, even for nearly parallel planes,
            else symmetric.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring.
    """
    names = RegionLabels(arrangement, labels, items="circles")
    shown, coordinates = drawn_axes(arrangement, axes, coordinates)
    arrangement, camera, moved = in_coordinates(coordinates, arrangement, camera)
    globe = Globe(arrangement, camera, azimuth)
    colours = globe.colouring(colour)
    disc = single_disc(globe, front_half(globe, orthographic), names, width, solid=True)
    arms, arrows = [], []
    if shown:
        disc = replace(disc, radius=within_reach(globe.axes.T, disc.scene.width / 2, disc.radius))
    disc.map_points(moved)
    if shown:
        arms = [_axis(disc, k) for k in range(3)]
        disc.scene.circle(disc.centre, 1.0, fc=INK, ec="none", zorder=2.5, gid="origin")
    if sides:
        arrows = [_side(disc, c) for c in range(globe.whole.circle_count)]
    _, lines = disc.draw(colours.paint, avoid=[*arms, *arrows])
    off = keep_off(lines)
    for name, (_, tip) in zip(shown, arms, strict=True):
        places = beside(tip, away=tip - np.array(disc.centre), distance=2.0)
        write_if_free(disc.scene, [name], SIZES[:2], places, off=off, style="italic")
    explain_regions(disc.scene, colours, names, globe.front.values())
    return disc.scene


def _axis(disc: Disc, k: int) -> Floats:
    """Draw a coordinate axis from the origin, dashed where the ball hides it; return its ends."""
    way = disc.globe.axes[:, k]
    tip = disc.on_paper(REACH * way[:2])
    flat = float(np.linalg.norm(way[:2]))
    # In front it leaves the ball where it meets it, else where it passes the limb.
    out = 1.0 if way[2] > 0 else 1 / max(flat, 1e-9)
    start = disc.on_paper(min(out, REACH) * way[:2])
    hidden = {**HIDDEN, "zorder": 2.2, "gid": f"axis-{k + 1}-hidden"}
    disc.scene.line([disc.centre, start], ec=INK, **hidden)
    if out < REACH:
        look: dict[str, Any] = {"fc": INK, "ec": "none", "role": "axis", "zorder": 3.5}
        arrow(disc.scene, start, tip, 0.6, gid=f"axis-{k + 1}", **look)
    return np.array([disc.centre, tip])


def _side(disc: Disc, circle: int) -> Floats:
    """Draw an arrow to the positive side of a circle, off its crossings; return its ends."""
    sphere, axes = disc.globe.whole, disc.globe.axes
    normal = axes @ unit_vectors([sphere.arrangement.distinct_planes[circle][:3]])[0]
    near = unit(np.array([0.0, 0.0, 1.0]) - normal[2] * normal)
    along = np.cross(normal, near)
    vertices = disc.globe.points
    spots = [math.cos(t) * near + math.sin(t) * along for t in np.arange(-9, 10) * 0.1]
    clear = [round(float(np.linalg.norm(vertices - p, axis=1).min(initial=9.0)), 6) for p in spots]
    foot = spots[int(np.argmax(clear))]
    tip = math.cos(0.1) * foot + math.sin(0.1) * normal
    ends = disc.on_paper(np.array([foot[:2], tip[:2]]))
    name = f"side-{sphere.arrangement.firsts[circle] + 1}"
    arrow(disc.scene, ends[0], ends[1], 0.55, fc="black", ec="none", zorder=3.5, gid=name)
    return ends
