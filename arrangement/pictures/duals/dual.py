"""The dual polyhedron beside the great circles, in corresponding colours."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.progress import note
from arrangement.drawing.colours import (
    BLUE,
    VERMILION,
    Choice,
    Painter,
    letter_colour,
    side_colour,
)
from arrangement.drawing.output import millimetres
from arrangement.drawing.scene.curves import ring
from arrangement.drawing.scene.items import Box, Floats
from arrangement.drawing.scene.labels import SIZES, keep_off, write_if_free
from arrangement.drawing.scene.places import across, beside, tried
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.solids.sight import lit, unit, unit_vectors
from arrangement.drawing.views import Vector
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.numbers.exact import IntegerVector
from arrangement.pictures.parts.coordinates import (
    DUAL_MODEL,
    in_coordinates,
    in_view_space,
    planes_view,
)
from arrangement.pictures.parts.names import (
    Labels,
    RegionLabels,
    explain_regions,
    plane_names,
    stroke,
)
from arrangement.pictures.sphere.disc import HIDDEN, Disc, front, rim_width
from arrangement.pictures.sphere.globe import Globe, clear_direction
from arrangement.pictures.sphere.projections import orthographic

from .schlegel import schlegel_model
from .solids import SeenSolid, dual_solid, hull_solid, unit_lengths

#: Below this width the two panels stand one above the other; in millimetres.
SIDE_BY_SIDE = 120.0


@planes_view("dual")
def draw_dual(
    arrangement: Arrangement,
    *,
    camera: Vector | None = None,
    azimuth: float = 0.0,
    colour: Choice | None = None,
    labels: Labels | None = None,
    width: float = 180.0,
    hull: bool = False,
    coordinates: str | None = None,
) -> Scene:
    """Draw the dual polyhedron of central planes beside the great circles in R^3.

    Both are seen from the same direction. A region of the sphere and its vertex of the dual have
    the same colour and sign vector; a circle and its zone of parallel edges have the same colour
    and number. Both are lit from the upper left, from in
    front. Hidden edges are dashed; which are hidden is decided exactly. The generators of
    the dual have length 1. In rank 2 the dual is a polygon, in rank 1 a segment.

    With `hull` the second panel has instead the convex hull of one point of the unit sphere for
    each region (see `arrangement.duals.inscribed.hull`). Edges of the hull between
    regions that are not adjacent stand out, and so do adjacencies that are not edges of the hull;
    the legend counts them.

    Elements: in the first panel as for the sphere; in the second ``vertex-3``, ``edge-7``, and
    ``face-2`` for the visible faces.

    Args:
        arrangement: central, of rank 1 to 3; rank 3 for the hull.
        camera: the exact direction towards the viewer; if omitted, one from above in which no
            circle is edge-on and no vertex hides its opposite.
        azimuth, colour, labels: as for `draw_sphere`.
        width: of the figure, in millimetres; below 120 the panels stand one above the other.
        hull: draw the hull of representatives.
        coordinates: as for `draw_sphere`; for the hull "given" if omitted.

    Raises:
        InputError: another space or rank, planes off the origin, too many circles, unknown
            colouring.
    """
    if coordinates is None and hull:
        coordinates = "given"
    names = RegionLabels(arrangement, labels, items="circles")
    arrangement, camera = in_coordinates(coordinates, arrangement, camera)
    globe = Globe(arrangement, camera)
    if camera is None and not hull:
        globe = Globe(arrangement, _oblique_direction(globe))
    if azimuth:
        globe = Globe(arrangement, globe.direction, azimuth)
    colours = globe.colouring(colour)
    if hull:
        from arrangement.duals.inscribed.hull import representative_hull

        found = representative_hull(dual_polyhedron(arrangement))
        solid = hull_solid(found, globe.direction, globe.axes)
        points = np.array([[float(x) for x in p] for p in found.hull.points]) @ globe.axes.T
    else:
        solid, points = dual_solid(arrangement, globe.direction, globe.axes), None
    beside = width >= SIDE_BY_SIDE
    panel = width / 2 if beside else width
    scene = Scene(width, panel * (1 if beside else 2))
    size = scene.width / 2 if beside else scene.width
    first = (size / 2, scene.height - size / 2)
    second = (size * 1.5, first[1]) if beside else (size / 2, first[1] - size)
    radius = size / 2 - rim_width(scene, globe, names)
    disc = Disc(
        scene,
        first,
        radius,
        globe,
        front(globe, orthographic),
        names,
        None if hull else letter_colour,
        True,
    )
    _sphere(disc, colours.paint, points, (0.0, first[1] - size / 2, size, scene.height))
    by_signs = {region.signs: region for region in globe.regions}
    fills = [colours.paint(by_signs[signs]) for signs in solid.signs]
    picture = _SolidPanel(scene, globe, solid, fills, names, hull)
    picture.draw(second, radius if hull else size / 2 - 19.0, size / 2)
    explain_regions(scene, colours, names, globe.regions)
    if hull:
        kinds = [min(c, 0) for _, _, c in solid.edges]
        for k, text in enumerate(("hull and adjacency", "hull only", "adjacency only")):
            scene.legend.key(stroke(**_HULL_STYLES[-k]), f"{text}: {kinds.count(-k)}")
    else:
        scene.legend.line("vertex = region, zone of parallel edges = circle; hidden ones dashed")
    return scene


def _oblique_direction(globe: Globe) -> IntegerVector:
    """Return a direction clear of the limb as usual, and of the vertices of the dual."""
    whole = globe.whole
    if not whole.circle_count:
        return clear_direction(*globe.lines())
    corners = unit(dual_solid(whole.arrangement, (0, 0, 1), np.eye(3)).corners)

    def apart(seen: Sequence[IntegerVector]) -> Floats:
        near = np.abs(unit_vectors(seen) @ corners.T).max(axis=1)
        found: Floats = np.sqrt(np.maximum(0, 1 - near**2))
        return found

    return clear_direction(*globe.lines(), apart)


def _sphere(disc: Disc, paint: Painter, points: Floats | None, within: Box) -> None:
    """Draw the first panel, with the representatives in front as dots."""
    dots: list[Floats] = []
    if points is not None:
        places = disc.on_paper(points[points[:, 2] > 0][:, :2])
        dots = [ring(place, 1.1, 9) for place in places]
        for place in places:
            disc.scene.circle(place, 1.1, fc="black", ec="none", zorder=4, role="point")
    disc.draw(paint, avoid=dots, within=within)


@dataclass
class _SolidPanel:
    """The second panel."""

    scene: Scene
    globe: Globe
    solid: SeenSolid
    fills: Sequence[str]
    names: RegionLabels
    hull: bool

    def draw(self, centre: tuple[float, float], radius: float, half: float) -> None:
        """Draw into the square around `centre` with sides of twice `half`."""
        solid, scene = self.solid, self.scene
        largest = 1.0 if self.hull else float(np.linalg.norm(solid.places, axis=1).max())
        self.places = np.array(centre) + solid.places * (radius / max(largest, 1e-9))
        self.limb: list[Floats] = []
        if self.hull:
            scene.circle(centre, radius, fill=False, ec="0.6", lw=0.4, zorder=1, gid="limb")
            self.limb = [ring(centre, radius)]
        for k, (cycle, normal) in enumerate(solid.faces):
            grey = lit("#ffffff", normal, 0.8)
            scene.polygon(
                self.places[list(cycle)], fc=grey, ec="none", zorder=1, gid=f"face-{k + 1}"
            )
        small = self._inscribe(radius)
        firsts = self.globe.whole.arrangement.firsts
        for e, (u, v, c) in enumerate(solid.edges):
            style = self._style(c, solid.edge_hidden[e])
            style["lw"] *= min(1.0, small / 1.6)
            scene.line(self.places[[u, v]], gid=f"edge-{firsts[c] + 1}-{e + 1}", **style)
        for v, place in enumerate(self.places):
            hidden = solid.vertex_hidden[v]
            style = (
                {"lw": 0.35, "zorder": 2.5} if hidden else {"lw": min(0.7, small / 2), "zorder": 5}
            )
            r = small * (0.7 if hidden else 1.0)
            name = self.names.element("vertex", solid.signs[v])
            scene.circle(place, r, fc=self.fills[v], ec="black", gid=name, **style)
        if not self.hull:
            self._zones(small)
        self._labels(
            np.array(centre),
            small,
            (centre[0] - half, centre[1] - half, centre[0] + half, centre[1] + half),
        )

    def _inscribe(self, radius: float) -> float:
        """Return the radius of the vertices: for a number inside, if they are far enough apart."""
        seen = self.places[~np.array(self.solid.vertex_hidden)]
        gaps = np.linalg.norm(seen[:, None] - seen, axis=2) + 99.0 * np.eye(len(seen))
        digits = max(len(self._text(v)) for v in range(len(self.places)))
        inside = 2.6 + 1.6 * digits
        self.inside = self.names.kind == "numbers" and gaps.min() > 2 * inside + 1
        edges = self.places[[edge[:2] for edge in self.solid.edges]]
        lengths = np.linalg.norm(edges[:, 0] - edges[:, 1], axis=1)
        crowded = max(0.5, 0.28 * float(np.quantile(lengths, 0.1)))
        return inside if self.inside else min(2.6, radius / 14, crowded)

    def _text(self, v: int) -> str:
        return next(iter(self.names.forms(self.solid.signs[v])), "")

    def _style(self, label: int, hidden: bool) -> dict[str, Any]:
        style: dict[str, Any] = {"capstyle": "round"}
        if self.hull:
            style |= _HULL_STYLES[min(label, 0)]
            return style | HIDDEN if hidden else style
        style["ec"] = letter_colour(label)
        if hidden:
            return style | HIDDEN
        return style | {"lw": 1.5, "zorder": 4}

    def _zones(self, small: float) -> None:
        """Write the number of each circle beside an edge of its zone, the longest that is free."""
        solid, classes = self.solid, self.globe.whole.arrangement.distinct
        by_class: dict[int, list[tuple[float, int]]] = {}
        for e, (u, v, c) in enumerate(solid.edges):
            if not solid.edge_hidden[e]:
                length = float(np.linalg.norm(self.places[u] - self.places[v]))
                by_class.setdefault(c, []).append((-round(length, 3), e))
        off = self._off(small + 0.5)
        for c, edges in sorted(by_class.items()):
            text = plane_names(classes[c])
            for _, e in sorted(edges):
                ends = self.places[list(solid.edges[e][:2])]
                look = {"off": off, "color": letter_colour(c), "style": "italic"}
                if write_if_free(self.scene, [text], SIZES[1:2], across(ends), **look):
                    break

    def _off(self, small: float) -> Any:
        """Return what no label may cover: edges, vertices, and the limb of a hull."""
        edges = self.places[[edge[:2] for edge in self.solid.edges]]
        return keep_off([*edges, *self.limb], discs=self.places, radius=small)

    def _labels(self, centre: Floats, small: float, within: Box) -> None:
        """Write the names of the vertices: inside, or beside, where no other vertex is as near."""
        solid, far = self.solid, np.round(np.linalg.norm(self.places - centre, axis=1), 4)
        off = self._off(small)
        order = sorted(range(len(far)), key=lambda v: (solid.vertex_hidden[v], -far[v]))
        seen = solid.vertex_hidden.count(False)
        missing = []
        for v in order[: max(seen, tried(len(far)))] if self.names.kind != "none" else ():
            hidden = solid.vertex_hidden[v]
            if self.inside and not hidden:
                self.scene.write(self.places[v], self._text(v), SIZES[1], zorder=7)
                continue
            places = beside(
                self.places[v],
                away=self.places[v] - centre if far[v] else (0.0, 1.0),
                distance=small * (0.7 if hidden else 1) + 1.0,
                within=within,
                others=np.delete(self.places, v, axis=0),
            )
            texts, colour = self.names.forms(solid.signs[v]), "0.45" if hidden else "black"
            if not write_if_free(self.scene, texts, SIZES, places, off=off, color=colour):
                missing += texts[:1] * (not hidden)
        if missing and self.names.requested:
            some = ", ".join(sorted(missing, key=lambda text: (len(text), text)))
            note(f"no room for the names of vertices {some} of the dual, which are left out")


_HULL_STYLES: dict[int, dict[str, Any]] = {
    0: {"ec": "black", "lw": 0.9, "zorder": 3},
    -1: {"ec": VERMILION, "lw": 1.7, "zorder": 4},
    -2: {"ec": BLUE, "lw": 1.4, "ls": (0, (1.2, 1.2)), "zorder": 4.5},
}


def dual_model(
    arrangement: Arrangement,
    suffix: str,
    *,
    size: float = 60.0,
    explode: float = 1.3,
    coordinates: str | None = None,
) -> bytes:
    """Build the dual polyhedron as a solid.

    In GLB a face is coloured by its number of corners. In rank 4 there are the cells of the
    Schlegel diagram instead, as parts that stand apart.

    Args:
        arrangement: central, of rank 3 or 4; in another space its essentialisation.
        suffix: ``.stl``, ``.glb`` or ``.obj``.
        size: the longest side of the bounding box, in millimetres, before parts move.
        explode: of rank 4, how far the cells stand apart; with 1 they stay together.
        coordinates: as for `draw_dual`, with generators of length 1; with "given" those of the
            file, in rank 3 of its lengths.
    """
    arrangement, length = in_view_space(arrangement, "dual", DUAL_MODEL), millimetres(size, "size")
    if arrangement.rank == 4:
        return schlegel_model(arrangement, suffix, length, explode, coordinates)
    arrangement, _ = in_coordinates(coordinates, arrangement)
    lengths = None if coordinates == "given" else unit_lengths(arrangement)
    dual = dual_polyhedron(arrangement, lengths)
    colours = tuple(side_colour(len(face)) for face in dual.faces)
    return dual.model(suffix, length, colours)
