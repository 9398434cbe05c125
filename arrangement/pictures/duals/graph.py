"""The graph of the dual as a planar drawing with straight edges."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import (
    CHECKERS,
    Choice,
    DrawnRegion,
    colouring,
    letter_colour,
)
from arrangement.drawing.figure import picture
from arrangement.drawing.registry import Labels
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import SIZES, keep_off, tried, write_along, write_beside
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.solids.sight import unit_vectors
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.duals.zonotope import dual_polygon, dual_segment
from arrangement.numbers import budget
from arrangement.numbers.linear.rank import cycle_edges
from arrangement.pictures.parts.coordinates import orbits, symmetry
from arrangement.pictures.parts.essential import shown_as
from arrangement.pictures.parts.names import RegionLabels, dot, explain_regions, plane_names

from .solids import edges_of, flat_edges


@dataclass(frozen=True)
class PlanarGraph:
    """The graph of the dual with places that give a planar drawing.

    Attributes:
        places: (V, 2); in the unit circle.
        signs: the sign vector of each vertex's region.
        edges: vertex, vertex, and the class of planes of the edge.
        outer: the outer face, in cyclic order.
    """

    places: Floats
    signs: tuple[tuple[int, ...], ...]
    edges: tuple[tuple[int, int, int], ...]
    outer: tuple[int, ...]


@picture()
@shown_as("graph")
def draw_graph(
    arrangement: Arrangement,
    *,
    colour: Choice | None = None,
    antipodes: str | None = None,
    labels: Labels | None = None,
    width: float = 88.0,
) -> Scene:
    """Draw the graph of the dual (regions, and which of them share a facet) without crossings.

    The outer polygon is a largest face, of these a most symmetric one; all other vertices are at
    weighted means of their neighbours (Tutte's theorem), so that edges are straight and never
    cross. Round vertices have an even number of negative classes of planes, square ones an odd
    number: every edge joins one of each. A colour and a number on edges name the plane that they
    cross. In rank 2 the graph is a cycle, in rank 1 one edge.

    Elements: ``vertex-3`` and ``edge-7``, numbered as in the dual.

    Args:
        arrangement: central; rank 3 in R^3, or rank 1 or 2 in any space.
        colour, antipodes, labels: of vertices, as for `draw_sphere`.

    Raises:
        InputError: planes off the origin, another rank or space, too many planes, unknown
            colouring.
    """
    graph, names = planar_graph(arrangement), RegionLabels(arrangement, labels)
    degrees = np.bincount(np.array([edge[:2] for edge in graph.edges]).ravel()).tolist()
    regions = [DrawnRegion(s, d) for s, d in zip(graph.signs, degrees, strict=True)]
    pairs = [(u, v) for u, v, _ in graph.edges]
    found = partial(orbits, arrangement, graph.signs) if arrangement.dimension == 3 else None
    colours = colouring(colour, antipodes, regions, pairs, arrangement.firsts, found)
    parity = colours.name == "parity"
    fills = [colours.shown(fill) if parity else "white" for fill in CHECKERS]
    even = "even number of minus signs"
    if len(arrangement.distinct) < len(arrangement):
        even += ", coincident planes counted once"
    shapes = (("round", even), ("square", "odd"))
    scene = Scene(width, width)
    for (shape, text), fill in zip(shapes, fills, strict=False):
        scene.legend.key(dot(shape, fc=fill, lw=0.7), text)
    if colours.name == "parity":
        colours = replace(colours, name=None)
    if arrangement.rank == 3:
        crossed = sorted({c for u, v, c in graph.edges if u in graph.outer and v in graph.outer})
        planes = plane_names(sorted(k for c in crossed for k in arrangement.distinct[c]))
        scene.legend.line(f"outer polygon: a ray on the planes {planes}")
    _GraphPicture(
        arrangement, graph, scene, [colours.paint(region) for region in regions], names
    ).draw()
    explain_regions(scene, colours, names, regions)
    return scene


def planar_graph(arrangement: Arrangement) -> PlanarGraph:
    """Return the graph of the dual with places for a planar drawing.

    Raises:
        InputError: as for `draw_graph`.
    """
    budget.keep(len(arrangement.distinct), "great circles in a picture")
    if arrangement.is_central and arrangement.rank in (1, 2):
        return _cycle(arrangement)
    dual = dual_polyhedron(arrangement)
    degrees = np.bincount(dual.edges.ravel()).tolist()
    found = symmetry(arrangement)
    kept = [1] * len(dual.faces)
    if found is not None:
        kept = found.stabilizers(unit_vectors(dual.face_normals)).tolist()

    def fitness(face: int) -> tuple[int, ...]:
        cycle = dual.faces[face]
        return len(cycle), kept[face], sum(min(degrees[v], 5) for v in cycle)

    outer = dual.faces[max(range(len(dual.faces)), key=fitness)][::-1]
    places = tutte_places(len(dual.signs), dual.faces, outer)
    return PlanarGraph(places, tuple(map(tuple, dual.signs.tolist())), edges_of(dual), outer)


def _cycle(arrangement: Arrangement) -> PlanarGraph:
    """Return the cycle of a pencil, or the one edge of a single plane."""
    signs = (dual_polygon if arrangement.rank == 2 else dual_segment)(arrangement).signs
    count = len(signs)
    at = math.pi * (1 - 1 / count) - 2 * math.pi * np.arange(count) / count
    at += math.pi / 2 * (count == 2)
    places = np.round(np.stack([np.cos(at), np.sin(at)], axis=1), 9) + 0.0
    return PlanarGraph(places, signs, flat_edges(arrangement, signs), tuple(range(count)))


class _GraphPicture:
    def __init__(
        self,
        arrangement: Arrangement,
        graph: PlanarGraph,
        scene: Scene,
        fills: Sequence[str],
        names: RegionLabels,
    ) -> None:
        self.arrangement, self.graph, self.scene = arrangement, graph, scene
        self.fills, self.names = fills, names
        half = scene.width / 2
        widest = max(
            (form for s in graph.signs for form in names.forms(s)[:1]), key=len, default=""
        )
        margin = min(max(scene.measure(widest, 6.0)) + 6, 26.0)
        self.centre = np.array([half, scene.height - half])
        low, high = graph.places.min(axis=0), graph.places.max(axis=0)
        self.places = self.centre + (graph.places - (low + high) / 2) * (
            2 * (half - margin) / max(float((high - low).max()), 1e-9)
        )
        ends = np.array([edge[:2] for edge in graph.edges])
        self.segments = self.places[ends]
        lengths = np.linalg.norm(self.segments[:, 0] - self.segments[:, 1], axis=1)
        self.lengths = np.round(lengths, 4)
        self.size = float(min(3.0, max(0.4, 0.28 * np.quantile(lengths, 0.1))))

    def draw(self) -> None:
        graph, scene = self.graph, self.scene
        thick = float(np.clip(0.75 * self.size, 0.3, 1.5))
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
            }
            scene.marker(place, self.size, shape, zorder=5, **style)
        self._zones()
        self._labels()

    def _zones(self) -> None:
        """Number the edges: the outer polygon outside, then one long edge of each class."""
        off = keep_off(self.segments, discs=self.places, radius=self.size + 0.5)
        named: set[int] = set()
        for e in np.argsort(-self.lengths, kind="stable").tolist():
            c = self.graph.edges[e][2]
            if c in named and len(self.graph.edges) > 40:
                continue
            if self.lengths[e] < 2 * self.size + 10:
                break
            text = plane_names(self.arrangement.distinct[c])
            ink = {"color": letter_colour(c), "style": "italic"}
            if write_along(self.scene, self.segments[e], text, 6.0, off, **ink):
                named.add(c)

    def _labels(self) -> None:
        """Write the sign vectors where they fit, the outer polygon first."""
        off = keep_off(self.segments, discs=self.places, radius=self.size)
        far = np.round(np.linalg.norm(self.places - self.centre, axis=1), 3)
        order = np.argsort(-far, kind="stable").tolist()
        scene = self.scene
        within = (0.0, self.centre[1] - scene.width / 2, scene.width, scene.height)
        for v in order[: tried(len(far))] if self.names.kind != "none" else ():
            others = np.delete(self.places, v, axis=0)
            look: dict[str, Any] = {"away": self._gap(v), "others": others, "within": within}
            texts, place = self.names.forms(self.graph.signs[v]), self.places[v]
            write_beside(scene, place, texts, SIZES, off=off, distance=self.size + 1.0, **look)

    def _gap(self, v: int) -> tuple[float, float]:
        """Return the direction in the middle of the widest gap between the edges of a vertex."""
        ends = [(b if a == v else a) for a, b, _ in self.graph.edges if v in (a, b)]
        steps = self.places[ends] - self.places[v]
        angles = sorted(math.atan2(y, x) for x, y in steps.tolist())
        nexts = [*angles[1:], angles[0] + 2 * math.pi]
        at = max(((round(b - a, 6), (a + b) / 2) for a, b in zip(angles, nexts, strict=True)))[1]
        return math.cos(at), math.sin(at)


Indices: TypeAlias = npt.NDArray[np.int64]

#: Weights stay between these, so that rounding cannot move a vertex across an edge.
_LEAST, _MOST = 1e-4, 1e4


def tutte_places(
    count: int, faces: Sequence[Sequence[int]], outer: Sequence[int], rounds: int = 80
) -> Floats:
    """Return places (V, 2) with the outer face as a regular polygon in the unit circle.

    Args:
        count: the number of vertices V.
        faces: all faces of a 3-connected planar graph, as cycles.
        outer: one of them; its order decides which way round it is drawn.
        rounds: how often the weight of an edge grows with its length and with the areas beside
            it, which evens out both; with 0 all weights are 1.
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
    for step in range(rounds + 1):
        places[inner] = _means(places, pairs, weights, inner)
        if step < rounds:
            steps = places[pairs[:, 0]] - places[pairs[:, 1]]
            lengths = _even(np.hypot(steps[:, 0], steps[:, 1]))
            (x, y), (right, up) = places[corners].T, places[following].T
            areas = _even(np.abs(np.add.reduceat(x * up - y * right, starts)) / 2)
            mean = np.sqrt(areas[beside[:, 0]] * areas[beside[:, 1]])
            weights = np.asarray(np.clip(weights * mean**0.15 * lengths**0.05, _LEAST, _MOST))
    return np.round(places, 9) + 0.0


def _edges(faces: Sequence[Sequence[int]]) -> tuple[Indices, Indices]:
    """Return the edges (E, 2) of some faces, and for each the faces beside it (one: twice)."""
    found: dict[tuple[int, int], list[int]] = {}
    for f, cycle in enumerate(faces):
        for u, v in cycle_edges(cycle):
            found.setdefault((min(u, v), max(u, v)), []).append(f)
    return np.array(list(found)), np.array([(f[0], f[-1]) for f in found.values()])


def _even(values: Floats) -> Floats:
    """Return values divided by their geometric mean."""
    return values / math.exp(float(np.log(values).mean()))


def _means(places: Floats, pairs: Indices, weights: Floats, inner: Indices) -> Floats:
    """Solve for the inner vertices, the others being fixed."""
    from scipy.sparse import coo_array, diags_array
    from scipy.sparse.linalg import spsolve

    count = len(places)
    ends, others = np.concatenate([pairs, pairs[:, ::-1]]).T
    pulls = coo_array((np.tile(weights, 2), (ends, others)), shape=(count, count)).tocsr()
    fixed = np.setdiff1d(np.arange(count), inner)
    matrix = (diags_array(pulls.sum(axis=1)) - pulls).tocsc()[inner][:, inner]
    return np.asarray(spsolve(matrix.tocsc(), pulls[inner][:, fixed] @ places[fixed]))
