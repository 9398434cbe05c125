"""The faces of a great-circle arrangement in the form of `Arrangement.faces`."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

from arrangement.exact import IntegerVector, primitive
from arrangement.planes import Face

from .signs import unpack

if TYPE_CHECKING:
    from .arrangement import SphereArrangement


def list_faces(sphere: SphereArrangement) -> tuple[tuple[Face, ...], ...]:
    """Return the faces of dimension 0, 1, 2, 3 (see `SphereArrangement.faces`)."""
    planes = len(sphere.arrangement)
    positive = sphere.packed_region_signs
    regions = unpack(positive, ~positive, planes).tolist()
    arcs = unpack(*sphere.packed_arc_signs, planes).tolist()
    vertices = unpack(*sphere.packed_vertex_signs, planes).tolist()
    if sphere.rank == 2:  # two antipodal vertices lie in one line, which is the smallest face
        vertices = vertices[:1]
    origin = [[0] * planes] if sphere.rank == 3 else []
    rays, arc_points, region_points = _witnesses(sphere)
    return (
        _faces(0, origin, [(0, 0, 0)] * len(origin)),
        _faces(1, vertices, rays[: len(vertices)]),
        _faces(2, arcs, arc_points),
        _faces(3, regions, region_points),
    )


def _witnesses(
    sphere: SphereArrangement,
) -> tuple[list[IntegerVector], list[IntegerVector], list[IntegerVector]]:
    """Return points of all vertices, arcs and regions, as `SphereArrangement` finds each."""
    if sphere.rank < 3:
        return (
            [sphere.ray(vertex) for vertex in range(sphere.vertex_count)],
            [sphere.arc_witness(arc) for arc in range(sphere.arc_count)],
            [sphere.region_witness(region) for region in range(sphere.region_count)],
        )
    rays = [primitive(ray) for ray in sphere.rays.tolist()]
    origin, following = sphere.incidence.origin.tolist(), sphere.incidence.next.tolist()
    ends = zip(origin[0::2], origin[1::2], strict=True)
    arc_points = [_sum(rays[tail], rays[head]) for tail, head in ends]
    region_points = []
    for first in sphere.incidence.leader.tolist():
        second = following[first]
        corner = rays[origin[following[second]]]
        region_points.append(_sum(_sum(rays[origin[first]], rays[origin[second]]), corner))
    return rays, arc_points, region_points


def _sum(left: IntegerVector, right: IntegerVector) -> IntegerVector:
    return (left[0] + right[0], left[1] + right[1], left[2] + right[2])


def _faces(
    dimension: int, signs: list[list[int]], witnesses: Iterable[IntegerVector]
) -> tuple[Face, ...]:
    return tuple(
        Face(tuple(row), dimension, tuple(map(Fraction, witness)))
        for row, witness in zip(signs, witnesses, strict=True)
    )
