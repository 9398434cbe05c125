"""What the dual needs of the great-circle engine: signs, facets, and cycles round the rays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from arrangement.enumeration.great_circles import sphere_arrangement
from arrangement.numbers.exact import IntegerVector
from arrangement.planes.planes import Planes


@dataclass(frozen=True, slots=True, eq=False)
class DualIncidence:
    """The faces of a central arrangement of rank 3 in R^3, read as those of its dual.

    Attributes:
        signs: (V, m) int8, one row for each region, over the input planes.
        edges: (E, 2) the two regions of each facet.
        edge_classes: (E,) the class of planes that separates them.
        faces: for each ray the regions around it, counter-clockwise seen from outside.
        rays: the primitive integer direction of each ray.
    """

    signs: npt.NDArray[np.int8]
    edges: npt.NDArray[np.int64]
    edge_classes: npt.NDArray[np.int64]
    faces: tuple[tuple[int, ...], ...]
    rays: tuple[IntegerVector, ...]


def dual_incidence(arrangement: Planes) -> DualIncidence:
    """Return the incidence of a central arrangement of rank 3 in R^3.

    Complexity: that of `sphere_arrangement`, plus O(E + V m) for the sign matrix.
    """
    sphere = sphere_arrangement(arrangement)
    topology = sphere.incidence
    bits = np.unpackbits(sphere.packed_region_signs, axis=1, count=len(arrangement))
    return DualIncidence(
        bits.astype(np.int8) * 2 - 1,
        topology.region.astype(np.int64).reshape(-1, 2),
        topology.arc_circle.astype(np.int64),
        _around_vertices(topology.origin, topology.next, topology.region),
        tuple(sphere.ray(vertex) for vertex in range(sphere.vertex_count)),
    )


def _around_vertices(
    origin: npt.NDArray[np.int32], following: npt.NDArray[np.int32], region: npt.NDArray[np.int32]
) -> tuple[tuple[int, ...], ...]:
    """Return the regions around each vertex, counter-clockwise seen from outside.

    The region on the left of a half-edge h lies between h and the next half-edge that leaves the
    same vertex, in counter-clockwise order. That one is the twin of the predecessor of h.
    """
    previous = np.empty_like(following)
    previous[following] = np.arange(len(following), dtype=following.dtype)
    turned = (previous ^ 1).tolist()
    left = region.tolist()
    cycles = []
    leaders = np.unique(origin, return_index=True)[1].tolist()
    for start in leaders:
        cycle, current = [left[start]], turned[start]
        while current != start:
            cycle.append(left[current])
            current = turned[current]
        cycles.append(tuple(cycle))
    return tuple(cycles)
