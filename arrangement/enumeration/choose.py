"""Which engine lists the faces of which planes: the one door to all of them."""

from __future__ import annotations

from arrangement.errors import InputError
from arrangement.exact import shown
from arrangement.planes import Face, Planes

from .any_dimension import enumerate_faces


def faces(planes: Planes, dimension: int | None = None) -> tuple[Face, ...]:
    """Return every face, or those of one dimension, lowest dimension first."""
    levels = enumerate_faces(planes)
    if dimension is None:
        return tuple(face for level in levels for face in level)
    if type(dimension) is not int or not 0 <= dimension <= planes.dimension:
        raise InputError(
            f"dimension is {shown(dimension)}; faces have dimension 0 to {planes.dimension}"
        )
    return levels[dimension]
