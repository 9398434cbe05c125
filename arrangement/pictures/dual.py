"""The dual polyhedron beside the great circles, in corresponding colours; and as a model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.progress import note
from arrangement.counts import region_count
from arrangement.drawing.colours import BLUE, VERMILION, Choice, Painter, letter_colour, side_colour
from arrangement.drawing.labels import SIZES, across, beside, keep_off, label_count, write_if_free
from arrangement.drawing.scene import Box, Floats, PageMap, Scene, millimetres, ring
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes
from arrangement.drawing.solids.sight import face_normal, shade, unit, unit_vectors
from arrangement.drawing.views import Vector
from arrangement.duals.schlegel import SchlegelDiagram, schlegel_diagram
from arrangement.duals.zonohedron import DualPolyhedron, dual_polyhedron, dual_zonotope
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, dot
from arrangement.numbers.linear.rank import cycle_edges, difference, triple_product
from arrangement.numbers.real import rational_near
from arrangement.pictures.cells import centroid
from arrangement.pictures.coordinates import (
    DUAL_MODEL,
    in_coordinates,
    in_view_space,
    planes_view,
    symmetry,
)
from arrangement.pictures.globe import (
    HIDDEN,
    Disc,
    Globe,
    clear_direction,
    front_half,
    orthographic,
    rim_width,
)
from arrangement.pictures.names import Labels, RegionLabels, explain_regions, plane_names, stroke
from arrangement.planes.planes import Planes

if TYPE_CHECKING:
    from arrangement.duals.inscribed.hull import RepresentativeHull

#: Vertex, vertex, and class of planes.
Edge: TypeAlias = tuple[int, int, int]


@dataclass(frozen=True)
class SeenSolid:
    """A polyhedron, polygon or segment, seen from a direction.

    Attributes:
        corners: (V, 3); the vertices in the axes of the picture: right, up, towards the viewer.
        signs: the sign vector of each vertex's region.
        edges: vertex, vertex, and the class of planes of the edge, or -1.
        edge_hidden: for each edge.
        vertex_hidden: for each vertex.
        faces: the visible faces, as cycles of vertices, each with its outer unit normal.
    """

    corners: Floats
    signs: tuple[tuple[int, ...], ...]
    edges: tuple[tuple[int, int, int], ...]
    edge_hidden: tuple[bool, ...]
    vertex_hidden: tuple[bool, ...]
    faces: tuple[tuple[tuple[int, ...], Floats], ...]

    @property
    def places(self) -> Floats:
        """(V, 2); the vertices on paper, in any unit."""
        return self.corners[:, :2]


def dual_solid(arrangement: Planes, direction: IntegerVector, axes: Floats) -> SeenSolid:
    """Return the dual of a central arrangement of rank 1 to 3 in R^3.

    The generators have length 1, up to a rational error of 10^-6; those of coincident planes
    share it.
    """
    lengths = unit_lengths(arrangement)
    if arrangement.rank == 3:
        return _polyhedron(dual_polyhedron(arrangement, lengths), direction, axes)
    flat = dual_zonotope(arrangement, lengths)
    edges = flat_edges(arrangement, flat.signs)
    seen = np.array([[float(x) for x in corner] for corner in flat.vertices]) @ axes.T
    shown = (False,) * len(flat.signs)
    faces = ((tuple(range(len(shown))), np.array([0.0, 0.0, 1.0])),) if len(shown) > 2 else ()
    return SeenSolid(seen, tuple(flat.signs), edges, shown[: len(edges)], shown, faces)


def flat_edges(arrangement: Planes, signs: Sequence[tuple[int, ...]]) -> tuple[Edge, ...]:
    """Return the edges of a dual polygon, or of a segment, between regions in cyclic order."""
    count = len(signs)
    pairs = [(k, (k + 1) % count) for k in range(count if count > 2 else 1)]
    crossed = (
        next(i for i, (s, t) in enumerate(zip(signs[u], signs[v], strict=True)) if s != t)
        for u, v in pairs
    )
    return tuple((*pair, arrangement.class_of[i]) for pair, i in zip(pairs, crossed, strict=True))


def edges_of(dual: DualPolyhedron) -> tuple[Edge, ...]:
    """Return the edges of a dual polyhedron: vertex, vertex, and class of planes."""
    return tuple(
        (u, v, c) for (u, v), c in zip(dual.edges.tolist(), dual.edge_classes.tolist(), strict=True)
    )


def unit_lengths(arrangement: Planes) -> tuple[Fraction, ...]:
    """Return factors that give every class of planes generators of total length about 1."""
    million = 10**6
    sizes = [len(arrangement.distinct[label]) for label in arrangement.class_of]
    squares = [rational_near(dot(plane[:-1], plane[:-1])) for plane in arrangement.integer_planes]
    roots = [n * isqrt(int(x * million**2)) for n, x in zip(sizes, squares, strict=True)]
    if max(roots, default=0) < 10**18:
        return tuple(Fraction(million, root) for root in roots)
    common = max(roots) * million  # many long denominators would have a huge one in common
    return tuple(Fraction(million * common // root, common) for root in roots)


def _polyhedron(dual: DualPolyhedron, direction: IntegerVector, axes: Floats) -> SeenSolid:
    towards = [dot(normal, direction) for normal in dual.face_normals]
    edges = edges_of(dual)
    pairs = [(u, v) for u, v, _ in edges]
    edge_hidden, vertex_hidden = _hidden_part(pairs, dual.faces, towards, len(dual.signs))
    unit = dual.generators.denominator
    points = np.array([[float(x / unit) for x in vertex] for vertex in dual.integer_vertices])
    normals = unit_vectors(dual.face_normals) @ axes.T
    visible = tuple(
        (cycle, normal)
        for cycle, normal, ahead in zip(dual.faces, normals, towards, strict=True)
        if ahead > 0
    )
    signs = tuple(map(tuple, dual.signs.tolist()))
    return SeenSolid(points @ axes.T, signs, edges, edge_hidden, vertex_hidden, visible)


def hull_solid(hull: RepresentativeHull, direction: IntegerVector, axes: Floats) -> SeenSolid:
    """Return the hull of representatives; edges that are not edges of the hull come last.

    The class of an edge is -1 for an edge of the hull alone and -2 for an adjacency that is not
    an edge of the hull; the latter is a chord, hidden if its middle is.
    """
    points = [tuple(map(Fraction, point)) for point in hull.hull.points]
    corners = ([points[v] for v in triangle] for triangle in hull.hull.triangles)
    # How far the outer normals look towards the viewer.
    towards = [triple_product(direction, difference(q, p), difference(r, p)) for p, q, r in corners]
    true, missing = sorted(hull.hull.true_edges), sorted(hull.missing)
    shared = {(min(u, v), max(u, v)): c for u, v, c in edges_of(hull.dual)}
    edge_hidden, vertex_hidden = _hidden_part(true, hull.hull.triangles, towards, len(points))
    heights = [dot(point, direction) for point in points]
    edges = [(u, v, shared.get((u, v), -1)) for u, v in true] + [(u, v, -2) for u, v in missing]
    edge_hidden += tuple(heights[u] + heights[v] < 0 for u, v in missing)
    seen = np.array([[float(x) for x in point] for point in points]) @ axes.T
    faces = tuple(
        (triangle, face_normal(seen[list(triangle)]))
        for triangle, ahead in zip(hull.hull.triangles, towards, strict=True)
        if ahead > 0
    )
    signs = tuple(map(tuple, hull.dual.signs.tolist()))
    return SeenSolid(seen, signs, tuple(edges), edge_hidden, vertex_hidden, faces)


def _hidden_part(
    edges: Sequence[tuple[int, int]],
    faces: Sequence[Sequence[int]],
    towards: Sequence[int | Fraction],
    count: int,
) -> tuple[tuple[bool, ...], tuple[bool, ...]]:
    """Return what no face that looks towards the viewer, or is seen edge-on, contains."""
    seen_edges: set[tuple[int, int]] = set()
    seen_vertices: set[int] = set()
    for cycle, ahead in zip(faces, towards, strict=True):
        if ahead >= 0:
            seen_vertices.update(cycle)
            seen_edges.update(cycle_edges(cycle))
    edge_hidden = tuple((u, v) not in seen_edges and (v, u) not in seen_edges for u, v in edges)
    return edge_hidden, tuple(v not in seen_vertices for v in range(count))


def symmetric_diagram(arrangement: Arrangement, coordinates: str | None) -> SchlegelDiagram:
    """Return the dual with generators of length 1, seen through one of its largest facets.

    Of these it is a most symmetric one, and of those a round one.

    Raises:
        OutOfReachError: more regions than a picture can show.
    """
    budget.check_size(region_count(arrangement), "regions in a picture")
    arrangement, *_ = in_coordinates(coordinates, arrangement)
    group = symmetry(arrangement)
    units = unit_vectors([plane[:-1] for plane in arrangement.distinct_planes])

    def fitness(ray: IntegerVector) -> tuple[float, ...]:
        kept = 1 if group is None else int(group.stabilizers(unit_vectors([ray]))[0])
        own = units[[not dot(plane[:-1], ray) for plane in arrangement.distinct_planes]]
        return kept, round(float(np.linalg.eigvalsh(own.T @ own)[1]), 6)

    return schlegel_diagram(arrangement, unit_lengths(arrangement), fitness)


def schlegel_model(
    arrangement: Arrangement, suffix: str, size: float, explode: float, coordinates: str | None
) -> bytes:
    """Return the cells of the Schlegel diagram as closed parts that stand apart."""
    diagram = symmetric_diagram(arrangement, coordinates)
    whole = diagram.places * (size / np.ptp(diagram.places, axis=0).max())
    parts = []
    for k, cell in enumerate(diagram.cells):
        used = sorted({v for face in cell for v in face})
        number = {v: i for i, v in enumerate(used)}
        points, middle = whole[used], whole[used].mean(axis=0)
        faces = []
        for cycle in cell:
            face = tuple(number[v] for v in cycle)
            outward = face_normal(points[list(face)]) @ (points[face[0]] - middle) > 0
            faces.append(face if outward else face[::-1])
        shift = centroid(points, tuple(faces)) * (explode - 1)
        colours = tuple(side_colour(len(face)) for face in faces)
        parts.append(ClosedSurface(f"cell-{k + 1}", points, tuple(faces), colours, tuple(shift)))
    return model_bytes(parts, suffix, f"Schlegel diagram: {len(parts)} cells")


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
    sphere: bool = True,
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
        sphere: draw the sphere, too; if omitted, yes, but for one of several views in panels.
        coordinates: as for `draw_sphere`; for the hull "given" if omitted.

    Raises:
        InputError: another space or rank, planes off the origin, too many circles, unknown
            colouring.
    """
    if coordinates is None and hull:
        coordinates = "given"
    names = RegionLabels(arrangement, labels, items="circles")
    arrangement, camera, moved = in_coordinates(coordinates, arrangement, camera)
    globe = Globe(arrangement, camera)
    if camera is None and not hull:
        globe = Globe(arrangement, _oblique_direction(globe))
    if azimuth:
        globe = Globe(arrangement, globe.direction, azimuth)
    colours = globe.colouring(colour)
    if hull:
        from arrangement.duals.inscribed.hull import representative_hull

        representatives = representative_hull(dual_polyhedron(arrangement))
        solid = hull_solid(representatives, globe.direction, globe.axes)
        points = (
            np.array([[float(x) for x in p] for p in representatives.hull.points]) @ globe.axes.T
        )
    else:
        solid, points = dual_solid(arrangement, globe.direction, globe.axes), None
    beside = sphere and width >= SIDE_BY_SIDE
    panel = width / 2 if beside else width
    scene = Scene(width, panel * (2 if sphere and not beside else 1))
    size = scene.width / 2 if beside else scene.width
    first = second = (size / 2, scene.height - size / 2)
    if sphere:
        second = (size * 1.5, first[1]) if beside else (size / 2, first[1] - size)
    radius = size / 2 - rim_width(scene, globe, names)
    if sphere:
        ink = None if hull else letter_colour
        seen = front_half(globe, orthographic)
        disc = Disc(scene, first, radius, globe, seen, names, ink, True)
        _sphere(disc, colours.paint, points, (0.0, first[1] - size / 2, size, scene.height))
        disc.map_points(moved)
    by_signs = {region.signs: region for region in globe.regions}
    fills = [colours.paint(by_signs[signs]) for signs in solid.signs]
    picture = _SolidPanel(scene, globe, solid, fills, names, hull)
    picture.draw(second, radius if hull else size / 2 - 19.0, size / 2)
    scene.maps.append(PageMap(picture.scale, second, place=lambda p: (globe.axes @ p)[:2], size=3))
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
        gaps: Floats = np.sqrt(np.maximum(0, 1 - near**2))
        return gaps

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
        self.scale = radius / max(largest, 1e-9)
        self.places = np.array(centre) + solid.places * self.scale
        self.limb: list[Floats] = []
        if self.hull:
            scene.circle(centre, radius, fill=False, ec="0.6", lw=0.4, zorder=1, gid="limb")
            self.limb = [ring(centre, radius)]
        for k, (cycle, normal) in enumerate(solid.faces):
            grey = shade("#ffffff", normal, 0.8)
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
            text = plane_names(self.globe.whole.arrangement, classes[c])
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
        for v in order[: max(seen, label_count(len(far)))] if self.names.kind != "none" else ():
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
            vertices = ", ".join(sorted(missing, key=lambda text: (len(text), text)))
            note(f"no room for the names of vertices {vertices} of the dual, which are left out")


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
    arrangement, *_ = in_coordinates(coordinates, arrangement)
    lengths = None if coordinates == "given" else unit_lengths(arrangement)
    dual = dual_polyhedron(arrangement, lengths)
    colours = tuple(side_colour(len(face)) for face in dual.faces)
    return dual.model(suffix, length, colours)
