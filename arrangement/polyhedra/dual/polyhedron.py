"""The dual polyhedron of planes through the origin of R^3: a zonohedron with exact vertices."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from arrangement.errors import InputError
from arrangement.exact import IntegerVector, RationalVector, largest, quotient
from arrangement.planes import Planes
from arrangement.short_repr import Shown

from .flat import _REMEDIES, DualPolygon, DualSegment, dual_polygon, dual_segment
from .generators import Generators, generators, require_rank
from .incidence import dual_incidence

if TYPE_CHECKING:
    import networkx as nx


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
        from .validate import check

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
        from .mesh import as_trimesh

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
        from .mesh import export

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
