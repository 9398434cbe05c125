"""The graph of regions, and the poset of regions, drawn flat."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.arrangement import Arrangement
from arrangement.counts import region_count
from arrangement.drawing.colours import CHECKERS, Choice, DrawnRegion, colouring, letter_colour
from arrangement.drawing.labels import (
    SIZES,
    across,
    beside,
    keep_off,
    label_count,
    sign_text,
    write_if_free,
)
from arrangement.drawing.scene import Floats, Scene, measure
from arrangement.drawing.solids.sight import unit, unit_vectors
from arrangement.drawing.views import picture
from arrangement.duals.zonohedron import dual_polyhedron, dual_zonotope
from arrangement.enumeration.regions import distances, neighbours
from arrangement.errors import extra
from arrangement.numbers import budget
from arrangement.numbers.exact import dot
from arrangement.numbers.linear.rank import cycle_edges
from arrangement.pictures.coordinates import in_coordinates, orbits, planes_view, symmetry
from arrangement.pictures.dual import Edge, edges_of, flat_edges
from arrangement.pictures.names import (
    MOST,
    Labels,
    RegionLabels,
    explain_regions,
    plane_names,
    stroke,
    vertex_symbol,
)
from arrangement.planes.faces import Face

Indices: TypeAlias = npt.NDArray[np.int64]

#: How often the weight of an edge grows with its length and with the areas beside it, which evens
#: out both.
_ROUNDS = 80
#: Weights stay between these, so that rounding cannot move a vertex across an edge.
_LEAST, _MOST = 1e-4, 1e4


def tutte_places(count: int, faces: Sequence[Sequence[int]], outer: Sequence[int]) -> Floats:
    """Return places (V, 2) with the outer face as a regular polygon in the unit circle.

    Args:
        count: the number of vertices V.
        faces: all faces of a 3-connected planar graph, as cycles.
        outer: one of them; its order decides which way round it is drawn.
    """
    at = math.pi / 2 + (2 * np.arange(len(outer)) + 1) * math.pi / len(outer)
    places = np.zeros((count, 2))
    places[list(outer)] = np.stack([np.cos(at), np.sin(at)], axis=1)
    inner = np.setdiff1d(np.arange(count), outer)
    inside = [cycle for cycle in faces if set(cycle) != set(outer)]
    pairs, beside = _edges(inside)
    weights = np.ones(len(pairs))
    corners = np.concatenate([np.array(cycle) for cycle in inside])
    following = np.concatenate([np.roll(cycle, -1) for cycle in inside])
    starts = np.cumsum([0, *map(len, inside[:-1])])
    places[inner] = _means(places, pairs, weights, inner)
    for _ in range(_ROUNDS):
        steps = places[pairs[:, 0]] - places[pairs[:, 1]]
        lengths = _even(np.hypot(steps[:, 0], steps[:, 1]))
        (x, y), (right, up) = places[corners].T, places[following].T
        areas = _even(np.abs(np.add.reduceat(x * up - y * right, starts)) / 2)
        mean = np.sqrt(areas[beside[:, 0]] * areas[beside[:, 1]])
        weights = np.asarray(np.clip(weights * mean**0.15 * lengths**0.05, _LEAST, _MOST))
        places[inner] = _means(places, pairs, weights, inner)
    return np.round(places, 9) + 0.0


def _edges(faces: Sequence[Sequence[int]]) -> tuple[Indices, Indices]:
    """Return the edges (E, 2) of some faces, and for each the faces beside it (one: twice)."""
    beside: dict[tuple[int, int], list[int]] = {}
    for f, cycle in enumerate(faces):
        for u, v in cycle_edges(cycle):
            beside.setdefault((min(u, v), max(u, v)), []).append(f)
    return np.array(list(beside)), np.array([(f[0], f[-1]) for f in beside.values()])


def _even(values: Floats) -> Floats:
    """Return values divided by their geometric mean."""
    return values / math.exp(float(np.log(values).mean()))


def _means(places: Floats, pairs: Indices, weights: Floats, inner: Indices) -> Floats:
    """Solve for the inner vertices, the others being fixed."""
    with extra("figures"):
        from scipy.sparse import coo_array
        from scipy.sparse.linalg import spsolve

    size, index = len(inner), np.full(len(places), -1)
    index[inner] = np.arange(size)
    ends, others = np.concatenate([pairs, pairs[:, ::-1]]).T
    kept = index[ends] >= 0
    rows, others, pulls = index[ends][kept], others[kept], np.tile(weights, 2)[kept]
    columns, diagonal = index[others], np.arange(size)
    free = columns >= 0
    entries = np.concatenate([-pulls[free], np.bincount(rows, pulls, size)])
    at = np.concatenate([[rows[free], columns[free]], [diagonal, diagonal]], axis=1)
    matrix = coo_array((entries, (at[0], at[1])), shape=(size, size)).tocsc()
    fixed = (pulls[:, None] * places[others])[~free].T
    right = np.stack([np.bincount(rows[~free], x, size) for x in fixed], axis=1)
    return np.asarray(spsolve(matrix, right))


#: Up to this many regions have labels where edges cross.
FEW = 40
#: This many planes of projection are tried, this far from one of symmetry.
_TRIED, _TILT = 60, 0.12


@dataclass(frozen=True)
class PlacedGraph:
    """The graph of regions with places for a drawing.

    Attributes:
        places: (V, 2); to the right and up.
        signs: the sign vector of each vertex's region.
        edges: vertex, vertex, and the class of planes of the edge.
        outer: of a planar drawing of rank 3, the outer face, in cyclic order.
    """

    places: Floats
    signs: tuple[tuple[int, ...], ...]
    edges: tuple[Edge, ...]
    outer: tuple[int, ...] = ()


@planes_view("graph")
def draw_graph(
    arrangement: Arrangement,
    *,
    colour: Choice | None = None,
    labels: Labels | None = None,
    width: float = 88.0,
) -> Scene:
    """Draw the graph of the dual: regions, and which of them share a facet.

    For central planes up to rank 3 no edges cross: the outer polygon is a largest face, of these a
    most symmetric one; all other vertices are at weighted means of their neighbours (Tutte's
    theorem), so that edges are straight. In rank 2 the graph is a cycle, in rank 1 one edge.

    For others a vertex is at the sum of unit normals with the signs of its region, seen in a
    plane: so edges across one plane are parallel and of one length. Of lines in R^2 this is a
    tiling by polygons. Of central planes with much symmetry the plane of the picture is near that
    of a rotation by the smallest angle, as Coxeter's.

    Round vertices have an even number of negative classes of planes, square ones an odd
    number: every edge joins one of each. A colour and a number on edges name the plane that they
    cross.

    Elements: ``vertex-3`` and ``edge-7``, numbered as in the dual.

    Args:
        arrangement: central of any rank, or affine.
        colour, labels: of vertices, as for `draw_sphere`; where edges cross, no labels
            for more than 40 regions if omitted.

    Raises:
        InputError: too many planes or regions, unknown colouring.
    """
    planar = arrangement.is_central and arrangement.rank <= 3
    graph = planar_graph(arrangement) if planar else _project_graph(arrangement)
    flat = planar or arrangement.dimension == 2
    names = RegionLabels(arrangement, labels, most=MOST if flat else FEW)
    scene = Scene(width, width)
    if planar and arrangement.rank == 3:
        crossed = sorted({c for u, v, c in graph.edges if u in graph.outer and v in graph.outer})
        members = sorted(k for c in crossed for k in arrangement.distinct[c])
        planes = plane_names(arrangement, members)
        scene.legend.line(f"outer polygon: a ray on the planes {planes}")
    GraphPicture(arrangement, graph, scene, names, colour).draw()
    return scene


def region_edges(arrangement: Arrangement) -> tuple[tuple[tuple[int, ...], ...], tuple[Edge, ...]]:
    """Return the sign vectors of all regions, and the edges between them.

    Raises:
        OutOfReachError: they are too many for a picture.
    """
    budget.check_size(region_count(arrangement), "regions in a picture")
    regions = arrangement.regions().signs.tolist()
    return tuple(map(tuple, regions)), tuple(neighbours(arrangement, arrangement.faces()))


def _project_graph(arrangement: Arrangement) -> PlacedGraph:
    """Return the graph with signed sums of unit normals as places, seen in a plane."""
    signs, edges = region_edges(arrangement)
    size = arrangement.dimension
    group = symmetry(arrangement) if arrangement.is_central and arrangement.rank == size else None
    even = arrangement.is_central and group is None
    planes, *_ = in_coordinates("even" if even else None, arrangement)
    units = unit_vectors([plane[:-1] for plane in planes.distinct_planes]).reshape(-1, size)
    sides = np.array(signs).reshape(len(signs), -1)[:, list(arrangement.firsts)]
    frame = np.eye(2)
    if size > 2:
        whole = np.zeros((2, size))
        if group is not None:
            whole = group.turned() @ group.frame @ np.linalg.inv(group.shape)
        frame = _clear_frame(sides @ units, units, whole)
    return PlacedGraph(np.round(sides @ units @ frame.T, 9) + 0.0, signs, edges)


def _clear_frame(points: Floats, units: Floats, whole: Floats) -> Floats:
    """Return two orthonormal vectors, (2, d), along which no edges or points fall together.

    Args:
        whole: (2, d); orthonormal vectors to which they are near, or zeros.
    """
    with extra("figures"):
        from scipy.spatial import KDTree

    size = units.shape[1]
    steps = np.arange(1, _TRIED + 1)[:, None] * np.log(np.arange(2 * size) + 2.0)
    tilts = (steps % 1 - 0.5).reshape(-1, 2, size)
    right, up = np.moveaxis(whole + (_TILT if whole.any() else 1.0) * tilts, 1, 0)
    right = unit(right)
    up = unit(up - (up * right).sum(axis=1)[:, None] * right)

    def clear(frame: Floats) -> float:
        x, y = frame @ units.T
        areas = np.abs(np.outer(x, y) - np.outer(y, x))[np.triu_indices(len(x), 1)]
        seen = points @ frame.T
        gaps = KDTree(seen).query(seen, 2)[0][:, 1] / np.abs(seen).max()
        return float(round(areas.min(initial=1.0) + gaps.min(), 9))

    return max(np.stack([right, up], axis=1), key=clear)


def planar_graph(arrangement: Arrangement) -> PlacedGraph:
    """Return the graph of the dual with places for a planar drawing.

    Raises:
        InputError: as for `draw_graph`.
    """
    budget.check_size(len(arrangement.distinct), "great circles in a picture")
    if arrangement.is_central and arrangement.rank in (1, 2):
        return _cycle(arrangement)
    dual = dual_polyhedron(arrangement)
    degrees = np.bincount(dual.edges.ravel()).tolist()
    group = symmetry(arrangement)
    kept = [1] * len(dual.faces)
    if group is not None:
        kept = group.stabilizers(unit_vectors(dual.face_normals)).tolist()

    def fitness(face: int) -> tuple[int, ...]:
        cycle = dual.faces[face]
        return len(cycle), kept[face], sum(min(degrees[v], 5) for v in cycle)

    outer = dual.faces[max(range(len(dual.faces)), key=fitness)][::-1]
    places = tutte_places(len(dual.signs), dual.faces, outer)
    return PlacedGraph(places, tuple(map(tuple, dual.signs.tolist())), edges_of(dual), outer)


def _cycle(arrangement: Arrangement) -> PlacedGraph:
    """Return the cycle of a pencil, or the one edge of a single plane."""
    signs = dual_zonotope(arrangement).signs
    count = len(signs)
    at = math.pi * (1 - 1 / count) - 2 * math.pi * np.arange(count) / count
    at += math.pi / 2 * (count == 2)
    places = np.round(np.stack([np.cos(at), np.sin(at)], axis=1), 9) + 0.0
    return PlacedGraph(places, signs, flat_edges(arrangement, signs), tuple(range(count)))


class GraphPicture:
    """Regions as vertices and facets as edges at given places, as large as a sheet allows."""

    def __init__(
        self,
        arrangement: Arrangement,
        graph: PlacedGraph,
        scene: Scene,
        names: RegionLabels,
        colour: Choice | None = None,
        least: float = 0.0,
    ) -> None:
        """Draw a graph on a scene, with at least this margin in points."""
        self.arrangement, self.graph, self.scene, self.names = arrangement, graph, scene, names
        pairs = [(u, v) for u, v, _ in graph.edges]
        degrees = np.bincount(np.ravel(pairs).astype(int), minlength=len(graph.signs)).tolist()
        self.regions = [DrawnRegion(s, d) for s, d in zip(graph.signs, degrees, strict=True)]
        full = arrangement.dimension in (3, arrangement.rank) and arrangement.is_central
        find_orbits = partial(orbits, arrangement, graph.signs) if full else None
        firsts = arrangement.firsts
        self.colours = colouring(colour, self.regions, pairs, firsts, find_orbits)
        self.fills = [self.colours.paint(region) for region in self.regions]
        widest = max(
            (form for s in graph.signs for form in names.forms(s)[:1]), key=len, default=""
        )
        margin = max(least, min(max(measure(widest, 6.0)) + 6, 26.0))
        low, high = graph.places.min(axis=0), graph.places.max(axis=0)
        self.centre = np.array([scene.width, scene.height]) / 2
        scale = 2 * (self.centre - margin) / np.maximum(high - low, 1e-9)
        self.places = self.centre + (graph.places - (low + high) / 2) * min(scale)
        self.segments = self.places[np.array(pairs)]
        lengths = np.linalg.norm(self.segments[:, 0] - self.segments[:, 1], axis=1)
        self.lengths = np.round(lengths, 4)
        crowded = 3.0 if graph.outer else 0.07 * scene.width / math.sqrt(len(graph.signs))
        self.size = float(min(3.0, crowded, max(0.4, 0.28 * np.quantile(lengths, 0.1))))

    def draw(self) -> None:
        """Draw all, and explain it in the legend."""
        self._shapes()
        graph, scene = self.graph, self.scene
        thick = float(np.clip(0.75 * self.size, 0.3, 1.5 if graph.outer else 0.9))
        firsts = self.arrangement.firsts
        for e, (_, _, c) in enumerate(graph.edges):
            name = f"edge-{firsts[c] + 1}-{e + 1}"
            scene.line(self.segments[e], ec=letter_colour(c), lw=thick, zorder=3, gid=name)
        for v, place in enumerate(self.places):
            odd = sum(graph.signs[v][k] < 0 for k in firsts) % 2
            shape, width = "square" if odd else "round", min(0.7, 0.35 * self.size)
            style = {
                "fc": self.fills[v],
                "ec": "black",
                "lw": width,
                "gid": self.names.element("vertex", graph.signs[v]),
                "zorder": 5,
            }
            scene.marker(place, self.size, shape, **style)
        self._zones()
        self._labels()
        explain_regions(scene, self.colours, self.names, self.regions)

    def _shapes(self) -> None:
        """Explain the shapes of vertices, with the colours where these say the same."""
        parity = self.colours.name == "parity"
        fills = [self.colours.own_colour(fill) if parity else "white" for fill in CHECKERS]
        even = "even number of minus signs"
        if len(self.arrangement.distinct) < len(self.arrangement):
            even += f", coincident {self.names.items} counted once"
        shapes = (("round", even), ("square", "odd"))
        for (shape, text), fill in zip(shapes, fills, strict=False):
            self.scene.legend.key(vertex_symbol(shape, fc=fill, lw=0.7), text)
        if parity:
            self.colours = replace(self.colours, name=None)

    def _zones(self) -> None:
        """Number the edges: the outer polygon outside, then one long edge of each class.

        Where edges cross, the legend has the numbers for which there is no room.
        """
        off = keep_off(self.segments, discs=self.places, radius=self.size + 0.5)
        named: set[int] = set()
        for e in np.argsort(-self.lengths, kind="stable").tolist():
            c = self.graph.edges[e][2]
            if c in named and len(self.graph.edges) > 40:
                continue
            if self.lengths[e] < 2 * self.size + 10:
                break
            text = plane_names(self.arrangement, self.arrangement.distinct[c])
            look = {"off": off, "color": letter_colour(c), "style": "italic"}
            places = across(self.segments[e])
            if write_if_free(self.scene, [text], SIZES[1:2], places, **look):
                named.add(c)
        unnamed = set() if self.graph.outer else {*range(len(self.arrangement.distinct))} - named
        for c in sorted(unnamed):
            text = plane_names(self.arrangement, self.arrangement.distinct[c])
            self.scene.legend.key(stroke(ec=letter_colour(c), lw=1.2), text)

    def _labels(self) -> None:
        """Write the sign vectors where they fit, the outer polygon first."""
        off = keep_off(self.segments, discs=self.places, radius=self.size)
        far = np.round(np.linalg.norm(self.places - self.centre, axis=1), 3)
        order = np.argsort(-far, kind="stable").tolist()
        for v in order[: label_count(len(far))] if self.names.kind != "none" else ():
            places = beside(
                self.places[v],
                away=self._gap(v),
                distance=self.size + 1.0,
                within=(0.0, 0.0, self.scene.width, self.scene.height),
                others=np.delete(self.places, v, axis=0),
            )
            texts = self.names.forms(self.graph.signs[v])
            write_if_free(self.scene, texts, SIZES, places, off=off)

    def _gap(self, v: int) -> tuple[float, float]:
        """Return the direction in the middle of the widest gap between the edges of a vertex."""
        ends = [(b if a == v else a) for a, b, _ in self.graph.edges if v in (a, b)]
        steps = self.places[ends] - self.places[v]
        angles = sorted(math.atan2(y, x) for x, y in steps.tolist())
        nexts = [*angles[1:], angles[0] + 2 * math.pi]
        at = max(((round(b - a, 6), (a + b) / 2) for a, b in zip(angles, nexts, strict=True)))[1]
        return math.cos(at), math.sin(at)


#: This many directions are tried in which rows are sorted.
_TRIED_DIRECTIONS = 60
#: Room for the numbers at the left, in points.
_MARGIN = 22.0


@picture()
def draw_poset(
    arrangement: Arrangement,
    *,
    bottom: str | None = None,
    colour: Choice | None = None,
    labels: Labels | None = None,
    width: float = 120.0,
) -> Scene:
    """Draw the poset of regions with its base at the bottom, as a Hasse diagram.

    A region is as high as planes lie between it and the base; the numbers at the left count the
    regions of each height. Rows are sorted as a zonotope shows them whose edges all rise by one,
    so that most edges across one plane go the same way. Vertices, colours and numbers of planes
    are those of `draw_graph`.

    Elements: ``vertex-3`` and ``edge-7``.

    Args:
        arrangement: any, central or not.
        bottom: the region at the bottom, by signs as ``"++-"`` or by number; if omitted, the one on
            the positive side of all planes where there is one, else region 1.
        colour, labels: as for `draw_sphere`; no labels for more than 150 regions if
            omitted.

    Raises:
        InputError: no such region, too many regions, unknown colouring.
    """
    signs, edges = region_edges(arrangement)
    names = RegionLabels(arrangement, labels)
    positive = (1,) * len(arrangement)
    lowest = names.signs_of(bottom or ("1" if positive not in signs else positive))
    regions = arrangement.regions()
    first = regions[signs.index(lowest)]
    heights = np.array(distances(arrangement, regions, first))
    across, rows = np.empty(len(signs)), Counter(heights.tolist())
    most = max(rows.values())
    sums = _zonotope_places(arrangement, first, signs, heights)
    for row, count in rows.items():
        members = np.flatnonzero(heights == row)
        order = members[np.argsort(sums[members], kind="stable")]
        across[order] = (np.arange(count) - (count - 1) / 2) / most
    top = int(heights.max())
    tall = min(1.3, max(0.4, 0.18 * top))
    scene = Scene(width, width * tall)
    number = names.element("region", lowest).removeprefix("region-")
    text = sign_text(lowest) if len(lowest) <= 24 else ""
    scene.legend.line(f"bottom: region {number}, {text}".rstrip(", "))
    graph = PlacedGraph(np.column_stack([across, tall * heights / max(top, 1)]), signs, edges)
    drawn = GraphPicture(arrangement, graph, scene, names, colour, _MARGIN)
    drawn.draw()
    for row, count in rows.items():
        at = (4.0, float(drawn.places[heights == row][0, 1]))
        scene.write(at, str(count), 6.0, anchor=(0.0, 0.5), color="0.25")
    return scene


def _zonotope_places(
    arrangement: Arrangement, first: Face, signs: tuple[tuple[int, ...], ...], heights: Floats
) -> Floats:
    """Return how far to the right each region is on a zonotope whose edges all rise by one.

    Its generators are the planes ``(n, -b)``, divided by their values at a point of the base; seen
    from a direction of some in which regions of one height are not near each other.
    """
    point = (*first.witness, 1)
    ways = []
    for plane in arrangement.distinct_planes:
        normal = (*plane[:-1], -plane[-1])
        height = abs(dot(normal, point))
        ways.append([float(x / height) for x in normal])
    sums = np.array(signs)[:, list(arrangement.firsts)] @ np.array(ways)
    steps = np.arange(1, _TRIED_DIRECTIONS + 1)[:, None] * np.log(np.arange(sums.shape[1]) + 2.0)
    seen = sums @ (steps % 1 - 0.5).T
    seen /= np.maximum(np.abs(seen).max(axis=0), 1e-12)
    rows = np.sort(seen + 4.0 * heights[:, None], axis=0)
    gaps = np.diff(rows, axis=0).min(axis=0, initial=1.0)
    chosen: Floats = seen[:, int(np.argmax(np.round(gaps, 9)))]
    return chosen
