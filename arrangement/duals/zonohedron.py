"""The dual polyhedron of central planes of rank 3 in R^3: a zonohedron.

It has a vertex for each region, an edge for each facet and a polygon for each ray of the
arrangement; see `zonotope`.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from arrangement.console.writing import write_bytes_atomically
from arrangement.drawing.solids.meshes import KINDS, ClosedSurface, model_bytes, triangles
from arrangement.enumeration.great_circles import Incidence, SphereArrangement, sphere_arrangement
from arrangement.errors import ArrangementError, InputError, extra
from arrangement.numbers.exact import IntegerVector, dot, rational_vector, shown
from arrangement.numbers.linear.rank import cross, cycle_edges, difference
from arrangement.planes.planes import Planes

from .zonotope import Zonotope, generators

if TYPE_CHECKING:
    import networkx as nx

_GREY = "#c8c8c8"
#: Largest number of products that are kept at once.
_CHUNK = 1 << 22


class DualPolyhedron(Zonotope):
    """The dual of planes of rank 3 in R^3, with its edges and faces.

    Frame: the space of the normals. Vertex v belongs to a region of the arrangement, edge e to a
    facet (one class of coincident planes separates its two regions), face f to a ray.
    """

    @cached_property
    def _sphere(self) -> SphereArrangement:
        return sphere_arrangement(self.arrangement)

    @cached_property
    def signs(self) -> npt.NDArray[np.int8]:
        """(V, m) int8, the sign vector of each vertex's region, over the input planes."""
        packed = self._sphere.packed_region_signs
        bits = np.unpackbits(packed, axis=1, count=len(self.arrangement))
        return bits.astype(np.int8) * 2 - 1

    @cached_property
    def edges(self) -> npt.NDArray[np.int64]:
        """(E, 2) vertex indices."""
        return self._sphere.incidence.region.astype(np.int64).reshape(-1, 2)

    @cached_property
    def edge_classes(self) -> npt.NDArray[np.int64]:
        """(E,) the class of planes (index into ``arrangement.distinct``) of each edge."""
        return self._sphere.incidence.arc_circle.astype(np.int64)

    @cached_property
    def faces(self) -> tuple[tuple[int, ...], ...]:
        """For each face its vertices in cyclic order, counter-clockwise seen from outside."""
        return around_rays(self._sphere.incidence)

    @cached_property
    def face_normals(self) -> tuple[IntegerVector, ...]:
        """For each face its outward normal, the primitive direction of its ray."""
        return tuple(map(self._sphere.ray, range(self._sphere.vertex_count)))

    def __repr__(self) -> str:
        v, e, f = self.f_vector
        return f"<DualPolyhedron: {v} vertices, {e} edges, {f} faces>"

    @property
    def f_vector(self) -> tuple[int, int, int]:
        """The numbers of vertices, edges and faces."""
        return len(self.integer_vertices), len(self.edges), len(self.faces)

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
        graph.add_nodes_from(range(self._sphere.region_count))
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
        _check_surface(self)
        _check_vertices_and_edges(self)
        _check_supporting_planes(self)
        for face, (cycle, normal) in enumerate(zip(self.faces, self.face_normals, strict=True)):
            if not _is_convex_polygon([self.integer_vertices[v] for v in cycle], normal):
                raise ArrangementError(f"face {face} is not a convex polygon, seen from outside")

    def _coordinates(self, size: float | None) -> npt.NDArray[np.float64]:
        """Return the vertices as floats, each a correctly rounded ratio of integers, (V, 3)."""
        if size is None:
            unit, factor = self.generators.denominator, 1.0
        elif isinstance(size, (int, float)) and math.isfinite(size) and size > 0:
            columns = zip(*self.integer_vertices, strict=True)
            unit, factor = max(max(column) - min(column) for column in columns), float(size)
        else:
            raise InputError(f"size is {shown(size)}; give a positive number of millimetres")
        return np.array([[x / unit for x in v] for v in self.integer_vertices]) * factor

    def to_trimesh(self, size: float | None = None, *, single: bool = False) -> Any:
        """Return a `trimesh.Trimesh` with the same vertex numbers, watertight, faces outward.

        Args:
            size: the largest side of the bounding box, in millimetres; if omitted, the coordinates
                are the exact ones, rounded to the nearest float.
            single: refuse what single precision makes one.

        Raises:
            InputError: the size is not positive and finite.
            ArrangementError: two vertices become one when rounded.
        """
        with extra("mesh"):
            import trimesh

        points = self._coordinates(size)
        stored = points.astype(np.float32) if single else points
        if len(np.unique(stored, axis=0)) < len(stored):
            raise ArrangementError(
                "two vertices become one when rounded; give `lengths` that make edges more equal"
            )
        mesh = trimesh.Trimesh(points, triangles(self.faces), process=False)
        if size is not None:
            mesh.units = "millimeters"
        return mesh

    def model(self, kind: str, size: float, colours: tuple[str, ...] = ()) -> bytes:
        """Return the bytes of a model file; see `export`.

        Args:
            kind: ``.stl``, ``.glb`` or ``.obj``.
            size: the largest side of the bounding box, in millimetres.
            colours: one for each face, as ``#rrggbb``; only GLB keeps them.
        """
        if kind not in KINDS:
            raise InputError(
                f"the file name ends in {shown(kind)}; expected one of {', '.join(KINDS)}"
            )
        v, e, f = self.f_vector
        points = np.array(self.to_trimesh(size, single=True).vertices)
        part = ClosedSurface("dual", points, self.faces, colours or (_GREY,) * f)
        return model_bytes([part], kind, f"dual polyhedron: {v} vertices, {e} edges, {f} faces")

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
        write_bytes_atomically(path, self.model(Path(path).suffix.lower(), size))


def dual_polyhedron(arrangement: Planes, lengths: Iterable[Any] | None = None) -> DualPolyhedron:
    """Return the dual polyhedron of planes through the origin of R^3.

    Args:
        arrangement: central, in R^3, of rank 3. Coincident planes are fine.
        lengths: a positive exact factor for each normal; 1 if omitted. The factors change
            the shape and never the combinatorics. The normals count in their stored scaling,
            which has coprime integers.

    Raises:
        InputError: an affine arrangement, another dimension, rank 2 (a polygon) or 1 (a segment).

    Complexity: of the vertices that of the incidence, plus O(V m) additions, at the first use.
    Source: [HaasHeger2018], section IV.A, for the dual; [Ziegler1995], section 7.3.

    >>> from arrangement import Arrangement
    >>> cube = dual_polyhedron(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))
    >>> cube.f_vector, cube.is_inscribed
    ((8, 12, 6), True)
    """
    spans = generators(arrangement, lengths, 3)
    if arrangement.dimension != 3:
        raise InputError(
            f"the planes lie in R^{arrangement.dimension} and the dual polyhedron needs R^3; "
            "take arrangement.counts.essentialization(arrangement) first"
        )
    return DualPolyhedron(arrangement, spans)


def around_rays(topology: Incidence) -> tuple[tuple[int, ...], ...]:
    """Return the regions around each ray, counter-clockwise seen from outside.

    The region on the left of a half-edge h lies between h and the next half-edge that leaves the
    same vertex, in counter-clockwise order. That one is the twin of the predecessor of h.
    """
    previous = np.empty_like(topology.next)
    previous[topology.next] = np.arange(len(topology.next), dtype=topology.next.dtype)
    turned, left = (previous ^ 1).tolist(), topology.region.tolist()
    cycles = []
    for start in np.unique(topology.origin, return_index=True)[1].tolist():
        cycle, current = [left[start]], turned[start]
        while current != start:
            cycle.append(left[current])
            current = turned[current]
        cycles.append(tuple(cycle))
    return tuple(cycles)


def dual_zonotope(arrangement: Planes, lengths: Iterable[Any] | None = None) -> Zonotope:
    """Return the dual of central planes of any rank from 1 on.

    Normals are stored as coprime integers, so their lengths are forgotten: `zonotope` keeps them.

    >>> from arrangement import Arrangement
    >>> dual_zonotope(Arrangement([[1, 0, 0], [1, 1, 0]])).dimension
    2
    """
    if arrangement.rank == 3:
        return dual_polyhedron(arrangement, lengths)
    return Zonotope(arrangement, generators(arrangement, lengths))


def zonotope(generators: Iterable[Iterable[Any]]) -> Zonotope:
    """Return the zonotope ``sum_i [-g_i, g_i]`` of vectors, with their lengths and multiplicities.

    It is the dual of the planes with these normals, whose `lengths` are those of the vectors.

    Args:
        generators: exact rational vectors of one length, none of them zero.

    Raises:
        InputError: other vectors, or those of rank 3 in another space than R^3.

    >>> zonotope([[2, 0], [1, 0], [0, "1/2"]]).vertices[0]
    (Fraction(3, 1), Fraction(1, 2))
    """
    vectors = [rational_vector(row, f"generators[{i}]") for i, row in enumerate(generators)]
    planes = Planes(vectors)
    pairs = zip(vectors, planes.integer_planes, strict=True)
    lengths = [next(x / n for x, n in zip(*pair, strict=False) if n) for pair in pairs]
    return dual_zonotope(planes, lengths)


def _check_surface(dual: DualPolyhedron) -> None:
    """The faces form a closed, connected, oriented surface of Euler number 2."""
    import networkx as nx

    directed = {step for cycle in dual.faces for step in cycle_edges(cycle)}
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


def _check_vertices_and_edges(dual: DualPolyhedron) -> None:
    """Every vertex is the signed sum of the generators; ends differ in the class of their edge."""
    columns = tuple(zip(*dual.generators.vectors, strict=True))
    for index, (signs, vertex) in enumerate(
        zip(dual.signs.tolist(), dual.integer_vertices, strict=True)
    ):
        if vertex != tuple(dot(signs, column) for column in columns):
            raise ArrangementError(f"vertex {index} is not the sum given by its signs")
    if len(set(dual.integer_vertices)) != len(dual.integer_vertices):
        raise ArrangementError("two vertices are equal")
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
