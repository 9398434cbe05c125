"""The exact check of a dual polyhedron: topology first, then geometry. It trusts no constructor."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.errors import ArrangementError
from arrangement.exact import IntegerVector, dot
from arrangement.linear import cross

if TYPE_CHECKING:
    from .polyhedron import DualPolyhedron

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
        inward = cross(normal, _difference(end, start))
        level = dot(inward, start)
        others = (corner for corner in corners if corner not in (start, end))
        if any(dot(inward, corner) <= level for corner in others):
            return False
    return len(corners) >= 3


def _difference(left: IntegerVector, right: IntegerVector) -> IntegerVector:
    return tuple(a - b for a, b in zip(left, right, strict=True))
