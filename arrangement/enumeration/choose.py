"""Which engine lists the faces of which planes: the one door to all of them."""

from __future__ import annotations

from collections.abc import Callable
from copy import copy
from dataclasses import dataclass

from arrangement.errors import InputError
from arrangement.exact import shown
from arrangement.planes import Planes

from . import affine_space, any_dimension, great_circles
from .sequence import FaceSequence, Level


@dataclass(frozen=True)
class Engine:
    """One way to list all faces.

    Attributes:
        list_faces: from planes to their faces of dimension 0, 1, ..., d.
        ranks: the ranks, of the planes or of the cone over affine ones, that it can do.
        can: the same in words.
    """

    list_faces: Callable[[Planes], tuple[Level, ...]]
    ranks: Callable[[Planes], bool]
    can: str


def cone_rank(planes: Planes) -> int:
    """Return the rank of the planes, or one more if they are affine."""
    return planes.rank + (not planes.is_central)


#: The fastest comes first. In any dimension: what counts is the rank.
ENGINES = {
    "great-circles": Engine(
        great_circles.list_faces,
        lambda planes: cone_rank(planes) <= 3,
        "rank up to 3, or up to 2 with planes that miss the origin",
    ),
    "affine-space": Engine(
        affine_space.list_faces,
        lambda planes: planes.rank == 3 or cone_rank(planes) == 4,
        "rank 3, or 4 if all planes contain the origin",
    ),
    "any-dimension": Engine(any_dimension.list_faces, lambda planes: True, "every rank"),
}


def enumerate_faces(planes: Planes, engine: str | None = None) -> FaceSequence:
    """Return every face, listed by the fastest engine that can, or by the one that is named.

    Raises:
        InputError: no engine of this name, or one that cannot do these planes.
    """
    planes = copy(planes)  # planes may keep their faces, so the faces do not keep those planes
    if engine is None:
        engine = next(name for name, known in ENGINES.items() if known.ranks(planes))
    if engine not in ENGINES:
        raise InputError(f"the engine is {shown(engine)}; known are {', '.join(ENGINES)}")
    chosen = ENGINES[engine]
    if not chosen.ranks(planes):
        raise InputError(f"the engine {engine} does {chosen.can}; these are {planes!r}")
    return FaceSequence(planes, chosen.list_faces(planes), engine)
