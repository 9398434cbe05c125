"""The dual polyhedron: how it is built, validated, and written as a mesh."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from arrangement.console.number_form import Shown
from arrangement.console.writing import write_bytes_atomically
from arrangement.drawing.solids.meshes import KINDS, ClosedSurface, model_bytes, triangles
from arrangement.errors import ArrangementError, InputError
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, largest, quotient, shown
from arrangement.numbers.linear.rank import cross, difference
from arrangement.planes.planes import Planes

from .flat import (
    _REMEDIES,
    DualPolygon,
    DualSegment,
    Generators,
    dual_polygon,
    dual_segment,
    generators,
    require_rank,
)
from .incidence import dual_incidence

if TYPE_CHECKING:
    import networkx as nx


Floats = npt.NDArray[np.float64]


def coordinates(dual: DualPolyhedron, size: float | None) -> Floats:
    """Return the vertices as floats, (V, 3); with a size, the largest side of the box is `size`.

    Scaling is by a ratio of integers, correctly rounded for numbers of any length.
    """
    if size is not None and not (
        isinstance(size, (int, float)) and math.isfinite(size) and size > 0
    ):
        raise InputError(f"size is {shown(size)}; give a positive number of millimetres")
    columns = list(zip(*dual.integer_vertices, strict=True))
    if size is None:
        d = dual.generators.denominator
        return np.array([[x / d for x in v] for v in dual.integer_vertices])
    largest = max(max(column) - min(column) for column in columns)
    return np.array([[x / largest for x in v] for v in dual.integer_vertices]) * float(size)


def as_trimesh(dual: DualPolyhedron, size: float | None, single: bool = False) -> Any:
    """Return the mesh; see `DualPolyhedron.to_trimesh`. `single` tests in single precision."""
    import trimesh

    points = coordinates(dual, size)
    stored = points.astype(np.float32) if single else points
    if len(np.unique(stored, axis=0)) < len(stored):
        raise ArrangementError(
            "two vertices become one when rounded; give `lengths` that make the edges more equal"
        )
    mesh = trimesh.Trimesh(points, triangles(dual.faces), process=False)
    if size is not None:
        mesh.units = "millimeters"
    return mesh


def export(dual: DualPolyhedron, path: str | os.PathLike[str], size: float) -> None:
    """Write a model file; see `DualPolyhedron.export`."""
    write_bytes_atomically(path, content(dual, Path(path).suffix.lower(), size))


def content(
    dual: DualPolyhedron, kind: str, size: float, colours: tuple[str, ...] | None = None
) -> bytes:
    """Return the bytes of a model file of the kind ``.stl``, ``.glb`` or ``.obj``.

    Args:
        dual: the polyhedron.
        kind: the suffix.
        size: the largest side of the bounding box, in millimetres.
        colours: one for each face, as ``#rrggbb``; only GLB keeps them.
    """
    if kind not in KINDS:
        raise InputError(f"the file name ends in {shown(kind)}; known are {', '.join(KINDS)}")
    v, e, f = dual.f_vector
    points = np.array(as_trimesh(dual, size, single=True).vertices)
    part = ClosedSurface("dual", points, dual.faces, colours or (_GREY,) * f)
    return model_bytes([part], kind, f"dual polyhedron: {v} vertices, {e} edges, {f} faces")


_GREY = "#c8c8c8"


#: Largest number of products that are kept at once.
_CHUNK = 1 << 22


def check(dual: DualPolyhedron) -> None:
    """Raise `ArrangementError` unless the polyhedron is what it says (see its `validate`)."""
    _check_surface(dual)
    _check_vertices(dual)
    _check_edges(dual)
    _check_supporting_planes(dual)
    for face, (cycle, normal) in enumerate(zip(dual.faces, dual.face_normals, strict=True)):
        corners = [dual.integer_vertices[v] for v in cycle]
        if not _is_convex_polygon(corners, normal):
            raise ArrangementError(f"face {face} is no convex polygon, seen from outside")


def _check_surface(dual: DualPolyhedron) -> None:
    """The faces form a closed, connected, oriented surface of Euler number 2."""
    import networkx as nx

    directed = set(_steps(dual.faces))
    if len(directed) != sum(map(len, dual.faces)):
        raise ArrangementError("an edge is used twice in the same direction")
    edges = {(min(pair), max(pair)) for pair in dual.edges.tolist()}
    if len(edges) != len(dual.edges):
        raise ArrangementError("an edge is listed twice")
    if directed != {step for u, v in edges for step in ((u, v), (v, u))}:
        raise ArrangementError("the edges of the faces are not the edges, once in each direction")
    v, e, f = dual.f_vector
    if v - e + f != 2:
        raise ArrangementError(f"V - E + F is {v} - {e} + {f}, not 2")
    if not nx.is_connected(dual.graph()):
        raise ArrangementError("the graph is not connected")


def _steps(faces: tuple[tuple[int, ...], ...]) -> Iterator[tuple[int, int]]:
    for cycle in faces:
        yield from zip(cycle, cycle[1:] + cycle[:1], strict=True)


def _check_vertices(dual: DualPolyhedron) -> None:
    """Every vertex is the signed sum of the generators, and no two are equal."""
    columns = tuple(zip(*dual.generators.vectors, strict=True))
    for index, (signs, vertex) in enumerate(
        zip(dual.signs.tolist(), dual.integer_vertices, strict=True)
    ):
        if vertex != tuple(dot(signs, column) for column in columns):
            raise ArrangementError(f"vertex {index} is not the sum that its signs say")
    if len(set(dual.integer_vertices)) != len(dual.integer_vertices):
        raise ArrangementError("two vertices are equal")


def _check_edges(dual: DualPolyhedron) -> None:
    """The signs of an edge's ends differ in its class of planes, and nowhere else."""
    labels = np.array(dual.arrangement.class_of)
    differs = dual.signs[dual.edges[:, 0]] != dual.signs[dual.edges[:, 1]]
    wrong = np.flatnonzero((differs != (labels == dual.edge_classes[:, None])).any(axis=1))
    if len(wrong):
        raise ArrangementError(f"edge {wrong[0]} does not cross exactly its class of planes")


def _check_supporting_planes(dual: DualPolyhedron) -> None:
    """The vertices of a face lie on its plane, and all others strictly on the inner side."""
    largest = max(abs(x) for vector in dual.integer_vertices for x in vector)
    steepest = max(abs(x) for vector in dual.face_normals for x in vector)
    kind: Any = np.int64 if 3 * largest * steepest < 2**62 else object
    points = np.array(dual.integer_vertices, dtype=kind).T
    normals = np.array(dual.face_normals, dtype=kind)
    step = max(1, _CHUNK // len(dual.integer_vertices))
    for start in range(0, len(normals), step):
        heights = normals[start : start + step] @ points
        top = heights.max(axis=1)
        rows, columns = np.nonzero(heights == top[:, None])
        cycles = dual.faces[start : start + step]
        claimed = [np.sort(np.array(cycle)) for cycle in cycles]
        sizes = np.array([len(cycle) for cycle in cycles])
        found_sizes = np.bincount(rows, minlength=len(cycles))
        if (sizes != found_sizes).any() or (columns != np.concatenate(claimed)).any():
            raise ArrangementError(
                f"among faces {start} to {start + len(cycles) - 1} there is one whose vertices "
                "are not exactly the highest ones along its normal"
            )


def _is_convex_polygon(corners: list[IntegerVector], normal: IntegerVector) -> bool:
    """Whether every edge line has all other corners strictly on its left, seen along -normal."""
    for i, start in enumerate(corners):
        end = corners[(i + 1) % len(corners)]
        inward = cross(normal, difference(end, start))
        level = dot(inward, start)
        others = (corner for corner in corners if corner not in (start, end))
        if any(dot(inward, corner) <= level for corner in others):
            return False
    return len(corners) >= 3


@dataclass(frozen=True, eq=False)
class DualPolyhedron(Shown):
    """The zonohedron ``sum_i [-g_i, g_i]`` of an arrangement of rank 3 in R^3.

    Frame: the space of the normals. Vertex v belongs to a region of the arrangement, edge e to a
    facet (one class of coincident planes separates its two regions), face f to a ray.

    Attributes:
        arrangement: the planes.
        generators: the vectors ``g_i = lengths[i] * n_i``; those of coincident planes add up.
        signs: (V, m) int8, the sign vector of each vertex's region, over the input planes.
        integer_vertices: the vertices times ``generators.denominator``, integers.
        edges: (E, 2) vertex indices.
        edge_classes: (E,) the class of planes (index into ``arrangement.distinct``) of each edge.
        faces: for each face its vertices in cyclic order, counter-clockwise seen from outside.
        face_normals: for each face its outward normal, the primitive direction of its ray.
    """

    arrangement: Planes
    generators: Generators
    signs: npt.NDArray[np.int8]
    integer_vertices: tuple[IntegerVector, ...]
    edges: npt.NDArray[np.int64]
    edge_classes: npt.NDArray[np.int64]
    faces: tuple[tuple[int, ...], ...]
    face_normals: tuple[IntegerVector, ...]

    dimension = 3

    def __repr__(self) -> str:
        v, e, f = self.f_vector
        return f"<DualPolyhedron: {v} vertices, {e} edges, {f} faces>"

    @property
    def f_vector(self) -> tuple[int, int, int]:
        """The numbers of vertices, edges and faces."""
        return len(self.integer_vertices), len(self.edges), len(self.faces)

    @cached_property
    def vertices(self) -> tuple[RationalVector, ...]:
        """The exact vertices ``sum_i s_i g_i``, with the normals in their stored scaling."""
        d = self.generators.denominator
        return tuple(tuple(quotient(x, d) for x in v) for v in self.integer_vertices)

    @cached_property
    def is_inscribed(self) -> bool:
        """Whether all vertices have the same distance from the origin."""
        return len({sum(x * x for x in v) for v in self.integer_vertices}) == 1

    def graph(self) -> nx.Graph:
        """Return the graph: nodes 0..V-1, each edge with its ``plane_class``.

        It is planar, bipartite (a step across one class changes the parity) and 3-connected
        (Balinski's theorem).
        """
        import networkx as nx

        graph = nx.Graph()
        graph.add_nodes_from(range(len(self.integer_vertices)))
        graph.add_edges_from(
            (u, v, {"plane_class": c})
            for (u, v), c in zip(self.edges.tolist(), self.edge_classes.tolist(), strict=True)
        )
        return graph

    def validate(self) -> None:
        """Check everything exactly: first the topology, then the geometry.

        Every edge lies in two faces, in opposite directions; V - E + F = 2; every vertex is the
        sum that its signs say, every edge a double generator; every vertex lies on the inner
        side of every face plane, and only those of the face lie on it; every face is a strictly
        convex polygon, counter-clockwise seen from outside.

        Complexity: O(V F + E m) exact operations.

        Raises:
            ArrangementError: names the first rule that is broken, and where.
        """

        check(self)

    def to_trimesh(self, size: float | None = None) -> Any:
        """Return a `trimesh.Trimesh` with the same vertex numbers, watertight, faces outward.

        Args:
            size: the largest side of the bounding box, in millimetres; if omitted, the coordinates
                are the exact ones, rounded to the nearest float.

        Raises:
            InputError: the size is not positive and finite.
            ArrangementError: two vertices become one when rounded.
        """

        return as_trimesh(self, size)

    def export(self, path: str | os.PathLike[str], size: float = 60.0) -> None:
        """Write a model for printing or viewing; the suffix is ``.stl``, ``.glb`` or ``.obj``.

        The file appears whole or not at all. STL and OBJ carry no unit: their numbers are
        millimetres, and they say so where they begin. GLB is in metres with y upward, as its
        standard demands. OBJ keeps the true polygons.

        Args:
            path: where to.
            size: the largest side of the bounding box, in millimetres.

        Raises:
            InputError: unknown suffix, bad size, or the place cannot be written.
        """

        export(self, path, size)


def dual_polyhedron(arrangement: Planes, lengths: Iterable[Any] | None = None) -> DualPolyhedron:
    """Return the dual polyhedron of planes through the origin of R^3.

    Args:
        arrangement: central, in R^3, of rank 3. Coincident planes are fine.
        lengths: a positive exact factor for each normal; 1 if omitted. The factors change
            the shape and never the combinatorics. The normals count in their stored scaling,
            which has coprime integers.

    Raises:
        InputError: an affine arrangement, another dimension, rank 2 (a polygon) or 1 (a segment).

    Complexity: that of the incidence, plus O(V m) additions.
    Source: [HaasHeger2018], section IV.A, for the dual; [Ziegler1995], section 7.3.

    >>> from arrangement import Arrangement
    >>> cube = dual_polyhedron(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))
    >>> cube.f_vector, cube.is_inscribed
    ((8, 12, 6), True)
    """
    spans = generators(arrangement, lengths)
    require_rank(arrangement, 3, _REMEDIES)
    if arrangement.dimension != 3:
        raise InputError(
            f"the planes lie in R^{arrangement.dimension} and the dual polyhedron needs R^3; "
            "take arrangement.counts.essentialization(arrangement) first"
        )
    found = dual_incidence(arrangement)
    return DualPolyhedron(
        arrangement,
        spans,
        found.signs,
        _signed_sums(found.signs, spans.vectors),
        found.edges,
        found.edge_classes,
        found.faces,
        found.rays,
    )


def dual_zonotope(
    arrangement: Planes, lengths: Iterable[Any] | None = None
) -> DualPolyhedron | DualPolygon | DualSegment:
    """Return the dual of any rank from 1 to 3, each as the type that it is.

    >>> from arrangement import Arrangement
    >>> dual_zonotope(Arrangement([[1, 0, 0], [1, 1, 0]])).dimension
    2
    """
    if arrangement.rank == 1:
        return dual_segment(arrangement, lengths)
    if arrangement.rank == 2:
        return dual_polygon(arrangement, lengths)
    return dual_polyhedron(arrangement, lengths)


def _signed_sums(
    signs: npt.NDArray[np.int8], vectors: tuple[IntegerVector, ...]
) -> tuple[IntegerVector, ...]:
    """Return ``sum_i s_i g_i`` for every row s; in int64 if no sum can leave it."""
    kind: Any = np.int64 if largest(vectors) * len(vectors) < 2**62 else object
    sums = signs.astype(kind) @ np.array(vectors, dtype=kind)
    return tuple(map(tuple, sums.tolist()))
