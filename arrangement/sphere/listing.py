"""The faces of a great-circle arrangement in the form of `Arrangement.faces`."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

from arrangement.exact import IntegerVector
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
    return (
        _faces(0, origin, [(0, 0, 0)] * len(origin)),
        _faces(1, vertices, map(sphere.ray, range(len(vertices)))),
        _faces(2, arcs, map(sphere.arc_witness, range(len(arcs)))),
        _faces(3, regions, map(sphere.region_witness, range(len(regions)))),
    )


def _faces(
    dimension: int, signs: list[list[int]], witnesses: Iterable[IntegerVector]
) -> tuple[Face, ...]:
    return tuple(
        Face(tuple(row), dimension, tuple(map(Fraction, witness)))
        for row, witness in zip(signs, witnesses, strict=True)
    )
