"""Lines of the plane: cut to a window that shows all vertices, or with the line at infinity.

Both come from the great circles of the cone over the lines, cut at the line at infinity. So which
faces there are, which of them are bounded, and what the window cuts, is exact. Lines that are
nearly parallel cross far away. When a window with all crossings would make most bounded regions
too small to be seen, the farthest crossings are left out.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from operator import ne
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.console.options.signature import Syntax
from arrangement.drawing.colours import (
    BLUE,
    PALETTE,
    VERMILION,
    Choice,
    Colouring,
    DrawnRegion,
    colouring,
    read_choice,
)
from arrangement.drawing.labels import (
    SIZES,
    beside,
    beyond,
    fixed_places,
    keep_off,
    sign_text,
    write_if_free,
)
from arrangement.drawing.scene import POINTS, Floats, PageMap, Scene, along, arrow, measure
from arrangement.drawing.views import Corner
from arrangement.errors import InputError, refusal
from arrangement.library.files.table import read_polygon
from arrangement.numbers.arguments import entries
from arrangement.numbers.exact import (
    RationalVector,
    dot,
    primitive,
    quotient,
    rational_vector,
    shown,
)
from arrangement.numbers.real import rational_near
from arrangement.pictures.charts import StraightChart, plane_points
from arrangement.pictures.coordinates import in_coordinates, planes_view
from arrangement.pictures.globe import (
    Drawn,
    Globe,
    label_regions,
    region_signs,
    sign_vectors,
    single_disc,
    stereographic,
)
from arrangement.pictures.names import (
    Labels,
    RegionLabels,
    explain_regions,
    names_on_paper,
    plane_names,
    swatch,
    vertex_symbol,
)
from arrangement.planes.planes import Planes
from arrangement.planes.polygon import Inside, bounding_planes


def _polygon_file(path: str) -> Arrangement:
    """Read a polygon for the command line (the ``type=`` of an argument)."""
    try:
        return read_polygon(path)
    except InputError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


if TYPE_CHECKING:
    PolygonFile: TypeAlias = Inside
else:  # on a command line a file
    PolygonFile = Annotated[Any, Syntax(_polygon_file, "POLYGON")]

#: The direction from which the cone is seen: the plane of the lines is at height 1 above it.
ABOVE = (0, 0, 1)
#: Room around the vertices as a share of the window.
_ROOM = Fraction(1, 2)
#: The least width of the window over its height, and the least height over its width.
_LEAST = Fraction(4, 5), Fraction(11, 20)
#: A region below this share of the window cannot be seen: a millimetre in a column of text.
_SEEN = 1 / 80
#: Shares of the crossings that a window may have, tried in turn.
_SHARES = (1.0, 0.98, 0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6, 0.55, 0.5)


@dataclass(frozen=True)
class LineWindow:
    """A rectangle of the plane.

    Attributes:
        middle, half: its middle and half sides.
        vertices: the crossings in it, or rational points near them.
        left_out: how many crossings are not in it, because of which regions can be seen.
    """

    middle: RationalVector
    half: RationalVector
    vertices: Sequence[RationalVector]
    left_out: int = 0

    @classmethod
    def between(cls, lines: Arrangement, corners: Sequence[RationalVector]) -> LineWindow:
        """Return the window with two opposite corners."""
        columns = [sorted(column) for column in zip(*corners, strict=True)]
        middle, half = (tuple((b + s * a) / 2 for a, b in columns) for s in (1, -1))
        vertices = _crossings(lines)[0].values()
        return cls(middle, half, [p for p in vertices if _inside(p, middle, half)])

    @classmethod
    def of(cls, lines: Arrangement) -> LineWindow:
        """Return the window in which most bounded regions are seen, with all crossings if it can.

        Lines without a crossing are shown around their points nearest to 0.
        """
        crossings, boxes = _crossings(lines)
        vertices = list(crossings.values())
        if not vertices:
            feet = (((a * c, b * c), a * a + b * b) for a, b, c in lines.integer_planes)
            nearest = [tuple(rational_near(quotient(x, square)) for x in p) for p, square in feet]
            return cls(*_around(nearest), [])
        places = np.array(vertices, dtype=float)
        away = np.abs(places - np.median(places, axis=0)).max(axis=1)
        order = np.argsort(away, kind="stable").tolist()
        best, fewest = cls(*_around(vertices), vertices), len(boxes) + 1
        for share in _SHARES:
            middle, half = _around([vertices[k] for k in order[: round(share * len(order))]])
            unseen = len(boxes) - _count_visible(boxes, middle, half)
            if unseen < fewest:
                inside = [p for p in vertices if _inside(p, middle, half)]
                best = cls(middle, half, inside, len(vertices) - len(inside))
                fewest = unseen
            if 2 * unseen <= len(boxes):
                break
        return best

    @property
    def unit(self) -> Fraction:
        """The length that the disc draws half-way to infinity or nearer."""
        sizes = (
            max(abs(x - c) for x, c in zip(p, self.middle, strict=True)) for p in self.vertices
        )
        away = sorted(size for size in sizes if size)
        if not away:
            return max(self.half) / 2
        return max(away[len(away) // 2] * Fraction(5, 4), away[-1] / 5)


def cone(lines: Arrangement, middle: RationalVector, unit: Fraction) -> Arrangement:
    """Return the cone over lines in the coordinates ``(x - middle) / unit``."""
    planes = lines.integer_planes
    rows = [(unit * a, unit * b, dot((a, b), middle) - c) for a, b, c in planes]
    return Arrangement(rows, dimension=3)


def _crossings(lines: Arrangement) -> tuple[dict[int, RationalVector], Floats]:
    """Return crossings, or rational points near them, and the boxes of the bounded regions.

    A box is ``(left, low, right, high)``, shape (regions, 4).
    """
    sphere = Globe(cone(lines, (Fraction(0),) * 2, Fraction(1)), ABOVE).whole
    crossings: dict[int, RationalVector] = {}
    places = np.full((sphere.vertex_count, 2), np.nan)
    for v in range(sphere.vertex_count):
        x, y, w = sphere.ray(v)
        if w > 0:
            crossings[v] = (rational_near(quotient(x, w)), rational_near(quotient(y, w)))
            places[v] = [float(x) for x in crossings[v]]
    boxes = [np.empty((0, 4))]
    for r in range(sphere.region_count if sphere.rank == 3 else 0):
        corners = places[sphere.incidence.origin[sphere.incidence.boundary(r)]]
        if not np.isnan(corners).any():  # all on the side of the plane: the region is bounded
            boxes.append(np.concatenate([corners.min(axis=0), corners.max(axis=0)])[None])
    return crossings, np.concatenate(boxes)


def _around(points: Sequence[RationalVector]) -> tuple[RationalVector, RationalVector]:
    """Return middle and half sides of a window around points."""
    columns = list(zip(*points, strict=True)) or [(Fraction(0),)] * 2
    middle = tuple((min(column) + max(column)) / 2 for column in columns)
    sizes = [(max(column) - min(column)) / 2 for column in columns]
    room = (max(sizes) or Fraction(1)) * _ROOM
    largest = max(sizes) + room
    return middle, tuple(max(s + room, largest * x) for s, x in zip(sizes, _LEAST, strict=True))


def _inside(point: RationalVector, middle: RationalVector, half: RationalVector) -> bool:
    return all(abs(x - c) <= h for x, c, h in zip(point, middle, half, strict=True))


def _count_visible(boxes: Floats, middle: RationalVector, half: RationalVector) -> int:
    """Return how many regions have their middle in a window, and a size that is seen."""
    centres, sizes = (boxes[:, :2] + boxes[:, 2:]) / 2, (boxes[:, 2:] - boxes[:, :2]).max(axis=1)
    centre, room = (np.array([float(x) for x in v]) for v in (middle, half))
    within = (np.abs(centres - centre) <= room).all(axis=1)
    return int((within & (sizes >= _SEEN * 2 * room.max())).sum())


class LinesChart(StraightChart):
    """The faces of lines of R^2 that are not at infinity, as points of the plane.

    Places are those of the plane, moved and scaled so that the window has its middle at 0 and
    most vertices are at a distance below 1.

    Attributes:
        lines: the arrangement; its first `count` lines have names.
        half: exact half sides of the window.
        middle, unit: a point p of the plane is at ``(p - middle) / unit``, in floats.
        left_out: how many far crossings the window leaves out.
        globe: the great circles of the cone, with the same coordinates, cut at the limb, which is
            the line at infinity.
    """

    def __init__(self, lines: Arrangement, window: Sequence[RationalVector] = ()) -> None:
        """Choose a window for lines, or use the one with these opposite corners."""
        self.lines, self.count = lines, len(lines)
        chosen = LineWindow.between(lines, window) if window else LineWindow.of(lines)
        self.left_out, unit = chosen.left_out, chosen.unit
        self.half = [x / unit for x in chosen.half]
        self.middle, self.unit = np.array([float(x) for x in chosen.middle]), float(unit)
        self.globe = Globe(cone(lines, chosen.middle, unit), ABOVE)
        x, y = self.half
        turns = ((-1, -1), (1, -1), (1, 1), (-1, 1))
        corners = [primitive((s * x, t * y, Fraction(1))) for s, t in turns]
        super().__init__(self.globe.cut, self.globe.cut.circle_normals, corners)

    @cached_property
    def regions(self) -> dict[int, tuple[int, ...]]:
        """The sign vectors of the regions, by their numbers on the sphere."""
        return _finite(region_signs(self.sphere))

    @cached_property
    def edges(self) -> dict[int, tuple[int, ...]]:
        """The sign vectors of the edges, by their numbers on the sphere."""
        return _finite(sign_vectors(self.sphere, self.sphere.packed_arc_signs))

    @cached_property
    def vertices(self) -> dict[int, tuple[int, ...]]:
        """The sign vectors of the vertices, by their numbers on the sphere."""
        return _finite(sign_vectors(self.sphere, self.sphere.packed_vertex_signs))

    @cached_property
    def parallels(self) -> list[int]:
        """The points at infinity, on the sphere, in which two or more lines meet."""
        ends = self.incidence.crossings(self.globe.limb).tolist() if self.lines.rank else []
        return [v for v in ends if len(self.incidence.circles_at(v)) > 2]

    @cached_property
    def bounded(self) -> set[tuple[int, ...]]:
        """The sign vectors of the bounded regions: those without a vertex at infinity."""
        ends = {r: self.incidence.origin[self._boundary(r)].tolist() for r in self.regions}
        return {
            self.regions[r]
            for r, cycle in ends.items()
            if cycle and self.vertices.keys() >= {*cycle}
        }

    @cached_property
    def sides(self) -> dict[tuple[int, ...], int]:
        """The number of edges of each region."""
        edges = self.edges.keys()
        return {
            signs: len(edges & set((self._boundary(r) >> 1).tolist()))
            for r, signs in self.regions.items()
        }

    def _boundary(self, region: int) -> np.ndarray[tuple[int], np.dtype[np.int32]]:
        return self.incidence.boundary(region) if self.lines.rank else np.empty(0, np.int32)

    def vertex(self, vertex: int) -> Floats:
        """Return the place of a vertex."""
        return plane_points([self.sphere.ray(vertex)]).reshape(2)

    @property
    def drawn(self) -> Drawn:
        """Arcs and regions of the half sphere as circular arcs in a disc."""
        return Drawn(self.sphere, self.globe.points, self.globe.normals, stereographic)


def _finite(vectors: Iterable[tuple[int, ...]]) -> dict[int, tuple[int, ...]]:
    """Return the signs of what is on the positive side of the last plane, without that one."""
    return {k: signs[:-1] for k, signs in enumerate(vectors) if signs[-1] > 0}


class PolygonChart(LinesChart):
    """The faces of lines and of the sides of a polygon, in a window around the polygon.

    The sides come after the lines, whose numbers stay.
    """

    def __init__(
        self, lines: Arrangement, sides: Planes, window: Sequence[RationalVector] = ()
    ) -> None:
        """Add the sides of a polygon, which is on the positive side of each."""
        corners = Arrangement(sides.normals, sides.offsets).regions(sides)
        if not len(corners):
            raise InputError(
                "nothing is on the positive side of all sides; give those of a polygon"
            )
        if not window and corners[0].is_bounded:
            vertices = [tuple(map(rational_near, p)) for p in corners[0].vertices]
            middle, half = _around(vertices)
            window = [tuple(m + s * h for m, h in zip(middle, half, strict=True)) for s in (-1, 1)]
        rows = [*lines.integer_planes, *sides.integer_planes]
        names = [*(lines.names or [""] * len(lines)), *[""] * len(sides)]
        joined = Arrangement([r[:-1] for r in rows], [r[-1] for r in rows], names=names)
        super().__init__(joined, window)
        self.count = len(lines)

    def is_inside(self, signs: Sequence[int], closed: bool = False) -> bool:
        """Return whether a face is in the interior of the polygon, or in it with its boundary."""
        return min(signs[self.count :], default=1) >= (not closed)


#: Room around the window for the names of the lines, in points.
MARGIN = 14.0
FACES = ("regions", "all")
_BOUNDED, _UNBOUNDED = PALETTE[2], "#ffffff"
#: Of lines outside of a polygon.
_OUTSIDE = "#c8c8c8"
_LINE: dict[str, Any] = {"ec": "black", "zorder": 3, "role": "circle"}
#: Widths of up to so many lines in points, and of very many.
_WIDTH, _FEW, _THIN = 0.9, 9, 0.25


@planes_view("lines")
def draw_lines(
    arrangement: Arrangement,
    *,
    projective: bool = False,
    faces: str = "regions",
    labels: Labels | None = None,
    colour: Choice | None = None,
    sides: bool = False,
    width: float = 88.0,
    coordinates: str | None = None,
    window: Iterable[Corner] = (),
    inside: PolygonFile | None = None,
) -> Scene:
    """Draw lines of the plane in a window with their vertices, or in the projective plane.

    A number at its end names a line: k for the k-th one, counted from 1. The legend counts the
    regions. Lines without a common point are shown around their points nearest to 0. Far crossings
    are left out where most bounded regions would be too small to be seen; a window has its own.

    With `projective` the whole plane is a disc: the half sphere above it, in stereographic
    projection, so that lines are arcs of circles. The rim is the line at infinity. Opposite points
    of it are one point; so the ends of a line have one name. A dot is where parallel lines meet.

    With `inside` only what is in a convex polygon has colours and labels, and the lines are pale
    outside of it.

    Elements: ``region-3``, ``line-2`` for a class of coincident lines, ``vertex-5``; in the disc
    ``front-2-7`` for edges of line 2, ``limb-1`` for the rim, ``infinity-4`` for the dots; of a
    polygon ``border`` for its sides, ``outside-2`` for what is pale.

    Args:
        arrangement: of rank at most 2; in another space than R^2 its essentialisation.
        projective: show the line at infinity.
        faces: that have labels: "regions"; or "all", with edges and vertices.
        labels: "signs"; "numbers" for regions in the order of `Arrangement.regions`, with a table
            of sign vectors below; "none". If omitted, signs of up to four lines, or of all faces,
            else numbers, with the table for up to 24 regions.
        colour: "bounded" (bounded regions are tinted), also with colours of these and of others,
            ``"bounded:gold,white"``; or as for `draw_sphere`; if omitted, bounded, or inside of a
            polygon sides.
        sides: at each line, an arrow to its positive side.
        coordinates: "symmetric" or "given"; if omitted, the lines of a root system of rank 2, all
            roots with the same offsets, have its angles. This changes no sign vector.
        window: two opposite corners of what is shown, exact; coordinates are those given then.
        inside: a polygon, or lines that have it on their positive sides; on a command line a file.

    Raises:
        InputError: rank 3 or more, too many lines, unknown faces, labels or colouring; a polygon
            with another choice that it does not go with.
    """
    if faces not in FACES:
        raise refusal(f"the faces are {shown(faces)}", faces, FACES)
    everything = faces == "all"
    if everything and labels == "numbers":
        raise InputError("numbers are for regions only; with all faces, labels are signs or none")
    if inside is not None and (everything or projective):
        raise InputError("inside of a polygon only regions are named, and nothing is at infinity")
    kind = "signs" if everything and labels is None else labels
    names = RegionLabels(arrangement, kind if len(arrangement) else "none", items="lines")
    given = entries(window, "window", "two corners, such as [(0, 0), (4, 3)]")
    corners = [
        rational_vector(corner, f"the corner window[{i}], such as (4, 3),")
        for i, corner in enumerate(given)
    ]
    if corners or inside is not None:
        if coordinates not in (None, "given") or projective:
            raise InputError(
                "a window or polygon is one of given coordinates, without the line at infinity"
            )
        if corners and ([*map(len, corners)] != [2, 2] or not all(map(ne, *corners))):
            raise InputError("the window has two opposite corners, such as -1,-1 2,3")
        coordinates = "given"
    drawn, _, moved = in_coordinates(coordinates, arrangement)
    if inside is None:
        made = _DiscSheet if projective else _WindowSheet
        sheet: _Sheet = made(LinesChart(drawn, corners), width, names, colour or "bounded")
    else:
        chart = PolygonChart(drawn, bounding_planes(inside), corners)
        sheet = _PolygonSheet(chart, width, names, colour or "sides")
    if sides:
        sheet.mark_sides()
    if everything and names.kind == "signs":
        sheet.label_faces()
    sheet.label_regions()
    sheet.explain()
    sheet.map_points(None if drawn is arrangement else moved)
    for what, number in (+sheet.missing).items():
        sheet.scene.legend.note(f"no room for {number} of the labels of {what}, which are left out")
    return sheet.scene


class _Sheet:
    """What both pictures share.

    Attributes:
        lines: points along each class of lines, from one end to the other.
        outlines: the regions and their boundaries.
        edges, vertices: points along the edges, and places of the vertices, by number.
        arms: the arrows to positive sides.
    """

    scene: Scene
    #: How many labels were left out, besides those of regions.
    missing: Counter[str]
    notes: tuple[str, ...] = ()

    def __init__(
        self, chart: LinesChart, width: float, names: RegionLabels, colour: Choice
    ) -> None:
        self.chart, self.names, self.missing = chart, names, Counter()
        drawn = map(self.drawn_region, chart.regions.values())
        self.regions = [region for region in drawn if region is not None]
        bounded = chart.bounded
        name, own = read_choice(colour)
        fills = (*own, *(_BOUNDED, _UNBOUNDED)[len(own) :])
        self.fills = {True: fills[0], False: fills[1]}
        if name == "bounded":
            if len(own) > 2:
                raise InputError(f"bounded takes two colours and has {len(own)}; name two")
            self.colours = Colouring(lambda r: self.fills[r.signs in bounded], name)
        else:
            firsts = [k for k in chart.lines.firsts if k < chart.count]
            self.colours = colouring(colour, self.regions, (), firsts)
        self.paint = self.colours.paint
        self.lines: list[Floats] = []
        self.outlines: list[tuple[DrawnRegion, Floats]] = []
        self.edges: dict[int, Floats] = {}
        self.vertices: dict[int, Floats] = {}
        self.arms: list[Floats] = []
        self.rim: list[Floats] = []
        self.draw(width)

    def drawn_region(self, signs: tuple[int, ...]) -> DrawnRegion | None:
        """Return a region as it is coloured and named, None if it is not."""
        return DrawnRegion(signs, self.chart.sides[signs])

    def draw(self, width: float) -> None:
        """Draw regions, lines, and the names of lines."""
        raise NotImplementedError

    def explain(self) -> None:
        """Describe in the legend what is drawn."""
        legend = self.scene.legend
        if self.colours.name == "bounded":
            count, rest = len(self.chart.bounded), len(self.regions) - len(self.chart.bounded)
            style = {"ec": "black", "lw": 0.5}
            if count:
                text = counted(count, "bounded region")
                legend.key(swatch(self.fills[True], **style), text)
            legend.key(swatch(self.fills[False], **style), f"{rest} unbounded")
        explain_regions(self.scene, self.colours, self.names, self.regions)
        for text in self.notes:
            legend.line(text)
        if self.notes and self.chart.parallels:
            legend.key(vertex_symbol("round", fc="black"), "parallel lines meet")

    def label_regions(self) -> None:
        """Write the names of the regions."""
        within = (0.0, 0.0, self.scene.width, self.scene.height)
        lines = [*self.edges.values(), *self.rim, *self.arms]
        label_regions(self.scene, self.names, self.outlines, lines, self.arms, within, True)

    def label_faces(self) -> None:
        """Mark the vertices, and write sign vectors beside them and on the edges."""
        for e in self.edges:
            self.missing["edges"] += not self._label_edge(e)
        off = keep_off([*self.edges.values(), *self.arms])
        for v, spot in self.vertices.items():
            style = {"fc": VERMILION, "ec": "none", "zorder": 4, "gid": f"vertex-{v + 1}"}
            self.scene.circle(spot, 1.7, **style)
            texts = [sign_text(self.chart.vertices[v])]
            look = {"off": off, "color": VERMILION}
            self.missing["vertices"] += not write_if_free(
                self.scene, texts, SIZES, beside(spot), **look
            )

    def _label_edge(self, edge: int) -> bool:
        """Write a sign vector on an edge, off all others, or beside it."""
        text = sign_text(self.chart.edges[edge])
        line = self.edges[edge]
        others = [*(other for e, other in self.edges.items() if e != edge), *self.arms]
        off = keep_off(others)
        centres = np.array([_point_at(line, t) for t in (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)])
        look: dict[str, Any] = {"off": off, "color": BLUE}
        if write_if_free(self.scene, [text], SIZES, fixed_places(centres), **look):
            left, low, right, high = self.scene.boxes[-1]
            plate = [(left, low), (right, low), (right, high), (left, high)]
            self.scene.polygon(plate, fc="white", ec="none", zorder=3.5, role="line")
            return True
        look["off"] = keep_off([*others, line])
        places = beside(centres[0], distance=1.5)
        return write_if_free(self.scene, [text], SIZES, places, **look)

    def mark_sides(self) -> None:
        """Draw an arrow across each line, near an end, to its positive side."""
        whole = self.chart.globe.whole.arrangement
        for members, points in zip(whole.distinct, self.lines, strict=True):
            if not len(points):
                continue
            share = min(0.3, 9 / float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum()))
            start, way = (
                _point_at(points, share),
                _point_at(points, 1.1 * share) - _point_at(points, share),
            )
            way /= np.linalg.norm(way)
            left = np.array([-way[1], way[0]])
            sides = {
                np.sign(float(whole.integer_planes[k][:3] @ self.plane(start + left)))
                for k in members
                if k < self.chart.count
            }
            for side in sorted(sides):
                tip = start + 9 * side * left
                self.arms.append(np.array([start, tip]))
                look: dict[str, Any] = {"fc": "black", "ec": "none", "zorder": 4}
                arrow(self.scene, start, tip, 0.55, gid=f"side-{members[0] + 1}", **look)

    def plane(self, place: Floats) -> Floats:
        """Return the homogeneous point of the plane at a place on paper."""
        raise NotImplementedError

    def map_points(self, moved: Callable[[Floats], Floats] | None) -> None:
        """Register in the scene where points of the plane are drawn, after a move."""
        raise NotImplementedError


class _WindowSheet(_Sheet):
    """A rectangle of the plane."""

    def draw(self, width: float) -> None:
        chart = self.chart
        x, y = (float(half) for half in chart.half)
        names = [plane_names(chart.lines, members, chart.count) for members in chart.lines.distinct]
        margin = max([MARGIN, *(measure(name)[0] + 5 for name in names)])
        room = width * POINTS - 2 * margin
        scale = room / max(2 * x, 1.2 * y)
        self.scene = Scene(width, 2 * (y * scale + margin) / POINTS)
        self.centre = np.array([self.scene.width / 2, margin + y * scale])
        self.scale = scale

        def at(points: Floats) -> Floats:
            return self.centre + scale * points

        if chart.left_out:
            self.scene.legend.note(
                f"the window leaves out {chart.left_out} of {len(chart.vertices)} crossings, so "
                "that bounded regions are seen; --window has other corners"
            )
        outside = 0
        for r, signs in chart.regions.items():
            region, outline = self.drawn_region(signs), at(chart.outline(r))
            if region is None or len(outline) < 3:
                outside += region is not None
                continue
            self.scene.polygon(
                outline,
                fc=self.paint(region),
                ec="none",
                gid=self.names.element("region", region.signs),
            )
            self.outlines.append((region, outline))
        if outside:
            self.scene.legend.captions.append(f"{counted(outside, 'region')} outside the window")
        ends_of = {e: at(chart.edge(e)) for e in chart.edges}
        self.edges = {e: ends for e, ends in ends_of.items() if len(ends) == 2}
        places = {v: chart.vertex(v) for v in chart.vertices}
        self.vertices = {v: at(p) for v, p in places.items() if (np.abs(p) <= (x, y)).all()}
        for label in range(len(names)):
            ends = at(chart.line(label))
            is_line = len(ends) == 2 and chart.lines.firsts[label] < chart.count
            self.lines.append(ends if is_line else np.empty((0, 2)))
            if len(ends) < 2:
                continue
            thick = max(_THIN, _WIDTH * min(1.0, (_FEW / len(names)) ** 0.75))
            self.draw_line(label, ends, thick)
        drawn = [label for label, ends in enumerate(self.lines) if len(ends)]

        def apart(one: int, other: int) -> float:
            """Return how far ends of two lines are from the other line, at most."""
            first, second = self.lines[drawn[one]], self.lines[drawn[other]]
            distances = []
            for (start, end), ends in ((first, second), (second, first)):
                x, y = (end - start) / max(float(np.linalg.norm(end - start)), 1e-300)
                distances += [abs(float(x * (p - start)[1] - y * (p - start)[0])) for p in ends]
            return max(distances)

        seen = [chart.lines.distinct[label] for label in drawn]
        texts = names_on_paper(self.scene.legend, self.names, seen, apart, _WIDTH, chart.count)
        for k, text in texts.items():
            self._name(self.lines[drawn[k]], text)

    def plane(self, place: Floats) -> Floats:
        return np.append((place - self.centre) / self.scale, 1.0)

    def map_points(self, moved: Callable[[Floats], Floats] | None) -> None:
        scale, middle = self.scale / self.chart.unit, self.chart.middle
        self.scene.maps.append(PageMap(scale, self.centre - scale * middle, moved))

    def draw_line(self, label: int, ends: Floats, thick: float) -> None:
        """Draw a class of lines, from one end in the window to the other."""
        name = f"line-{self.chart.lines.firsts[label] + 1}"
        self.scene.line(ends, lw=thick, gid=name, capstyle="butt", **_LINE)

    def _name(self, ends: Floats, text: str) -> None:
        """Write the name of a line beyond one of its ends, where there is more room."""
        ways = ends - ends[::-1]
        ways = ways / np.linalg.norm(ways, axis=1, keepdims=True)
        places = beyond(ends, ways, (2.5, 5.5, 8.5))
        self.missing["lines"] += not write_if_free(
            self.scene, [text], SIZES[:1], places, style="italic"
        )


class _PolygonSheet(_WindowSheet):
    """A window around a convex polygon, outside of which lines are pale."""

    chart: PolygonChart

    def drawn_region(self, signs: tuple[int, ...]) -> DrawnRegion | None:
        region = DrawnRegion(signs[: self.chart.count], self.chart.sides[signs])
        return region if self.chart.is_inside(signs) else None

    def draw_line(self, label: int, ends: Floats, thick: float) -> None:
        chart, number = self.chart, self.chart.lines.firsts[label] + 1
        if number <= chart.count:
            look = {**_LINE, "ec": _OUTSIDE, "zorder": 2}
            self.scene.line(ends, lw=thick, gid=f"outside-{number}", capstyle="butt", **look)
        own = [arc for arc in self.edges if int(chart.incidence.arc_circle[arc]) == label]
        closed = [arc for arc in own if chart.is_inside(chart.edges[arc], closed=True)]
        if not closed:
            return
        points = np.concatenate([self.edges[arc] for arc in closed])
        part = points[np.argsort(points @ (ends[1] - ends[0]))[[0, -1]]]
        if chart.is_inside(chart.edges[closed[0]]):
            super().draw_line(label, part, thick)
        else:
            look = {"ec": "black", "zorder": 3.2, "capstyle": "round", "role": "border"}
            self.scene.line(part, lw=1.5, gid="border", **look)

    def explain(self) -> None:
        super().explain()
        self.scene.legend.line(
            f"{counted(len(self.regions), 'cell')} inside; lines are pale outside"
        )


class _DiscSheet(_Sheet):
    """The projective plane, with the line at infinity as a rim."""

    notes = ("rim: the line at infinity; opposite points of it are one point",)

    def draw(self, width: float) -> None:
        chart = self.chart
        self.disc = single_disc(chart.globe, chart.drawn, self.names, width)
        self.scene = self.disc.scene
        self.outlines, self.rim, _ = self.disc.curves(self.paint, both_ends=True)
        # What meets across the rim is one region, with the sides of both parts.
        self.regions = [region for region, _ in self.outlines]
        self.edges = {e: along(self.disc.on_paper(chart.drawn.arc(e)), 12) for e in chart.edges}
        seen = {v: chart.globe.points[v] for v in chart.vertices}
        self.vertices = {v: self.disc.on_paper(p[:2] / (1 + p[2])) for v, p in seen.items()}
        ends = {e: set(chart.incidence.origin[2 * e : 2 * e + 2].tolist()) for e in chart.edges}
        for label in range(chart.globe.whole.circle_count):
            own = (e for e in chart.edges if int(chart.incidence.arc_circle[e]) == label)
            outer = next(e for e in own if not ends[e] <= chart.vertices.keys())
            first_inside = int(chart.incidence.origin[2 * outer]) in chart.vertices
            points = self.edges[outer]
            self.lines.append(points[::-1] if first_inside else points)
        for v in chart.parallels:
            place = self.disc.on_paper(chart.globe.points[v][:2])
            self.scene.circle(
                place, 2.2, fc="black", ec="white", lw=0.5, zorder=4, gid=f"infinity-{v + 1}"
            )

    def plane(self, place: Floats) -> Floats:
        x, y = (place - np.array(self.disc.centre)) / self.disc.radius
        return np.array([2 * x, 2 * y, 1 - x * x - y * y])

    def map_points(self, moved: Callable[[Floats], Floats] | None) -> None:
        def place(point: Floats) -> Floats:
            place = (
                (point if moved is None else moved(point)) - self.chart.middle
            ) / self.chart.unit
            return self.disc.place(np.append(place, 1.0))

        self.scene.maps.append(PageMap(place=place))


def _point_at(points: Floats, share: float) -> Floats:
    """Return the point at a share of the length of a polygonal line."""
    at = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    return np.array([np.interp(share * at[-1], at, column) for column in points.T])
