"""Convex solids on paper: which edges are hidden is decided exactly, from the faces."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.sight import face_normal, unit_vectors
from arrangement.duals.zonohedron import DualPolyhedron, dual_polyhedron, dual_zonotope
from arrangement.numbers.exact import IntegerVector, dot
from arrangement.numbers.linear.rank import cycle_edges, difference, triple_product
from arrangement.numbers.real import rational_near
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
    edge_hidden, vertex_hidden = _hidden(pairs, dual.faces, towards, len(dual.signs))
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
    edge_hidden, vertex_hidden = _hidden(true, hull.hull.triangles, towards, len(points))
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


def _hidden(
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
