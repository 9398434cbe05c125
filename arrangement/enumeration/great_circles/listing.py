"""All faces of planes that great circles show: rank 3 or less, or 2 or less if affine."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.enumeration.reduction import cone, from_dimension, in_dimension, upper_half
from arrangement.enumeration.sequence import Level, Rows
from arrangement.numbers.coefficients import Integers
from arrangement.planes.planes import Planes

from .arrangement import SphereArrangement, sphere_arrangement
from .signs import PackedSigns, unpack

_Chosen: TypeAlias = NDArray[np.int32]


def list_faces(planes: Planes) -> tuple[Level, ...]:
    """Return the faces of dimension 0, 1, ..., d.

    Affine planes are the part w > 0 of their cone, which has one dimension and one rank more.
    """
    if not planes.is_central:
        return tuple(upper_half(level) for level in list_faces(cone(planes))[1:])
    reduced, columns = in_dimension(planes, 3)
    return from_dimension(_levels(sphere_arrangement(reduced)), planes, columns)


def _levels(sphere: SphereArrangement) -> tuple[Level, ...]:
    """Return the faces of dimension 0, 1, 2, 3.

    A pencil has one line, not two rays: both its vertices have the same sign vector.
    """
    planes, incidence = len(sphere.arrangement), sphere.incidence
    rays = 1 if sphere.rank == 2 else incidence.vertex_count

    def unpacked(packed: tuple[PackedSigns, PackedSigns], rows: Rows) -> NDArray[np.int8]:
        return unpack(packed[0][rows], packed[1][rows], planes)

    def region_signs(rows: Rows) -> NDArray[np.int8]:
        positive = sphere.packed_region_signs[rows]
        return unpack(positive, ~positive, planes)

    def origin(rows: Rows) -> Integers:
        return _homogeneous(np.zeros((1, 3), np.int64)[rows])

    return (
        Level(int(sphere.rank == 3), lambda rows: np.zeros((1, planes), np.int8)[rows], origin),
        Level(
            rays,
            lambda rows: unpacked(sphere.packed_vertex_signs, rows)[:rays],
            lambda rows: _homogeneous(sphere.rays[:rays][rows]),
        ),
        Level(
            incidence.arc_count,
            lambda rows: unpacked(sphere.packed_arc_signs, rows),
            lambda rows: _homogeneous(_arc_points(sphere, rows)),
        ),
        Level(
            incidence.region_count,
            region_signs,
            lambda rows: _homogeneous(_region_points(sphere, rows)),
        ),
    )


def _homogeneous(points: Integers) -> Integers:
    return np.hstack([points, np.ones((len(points), 1), points.dtype)])


def _arc_points(sphere: SphereArrangement, rows: Rows) -> Integers:
    """Return vectors inside the cones of arcs: an arc is shorter than half a circle in rank 3."""
    if sphere.rank < 3:
        arcs = np.arange(sphere.arc_count)[rows].tolist()
        return np.array([sphere.arc_witness(arc) for arc in arcs], object).reshape(-1, 3)
    origin = sphere.incidence.origin
    ends: Integers = sphere.rays[origin[0::2][rows]] + sphere.rays[origin[1::2][rows]]
    return ends


def _region_points(sphere: SphereArrangement, rows: Rows) -> Integers:
    """Return vectors inside the cones of regions: sums of three corners that follow each other."""
    if sphere.rank < 3:
        regions = np.arange(sphere.region_count)[rows].tolist()
        return np.array([sphere.region_witness(r) for r in regions], object).reshape(-1, 3)
    origin, following = sphere.incidence.origin, sphere.incidence.next
    first: _Chosen = sphere.incidence.leader[rows]
    second = following[first]
    third = following[second]
    corners: Integers = sphere.rays[origin[first]] + sphere.rays[origin[second]]
    return corners + sphere.rays[origin[third]]
