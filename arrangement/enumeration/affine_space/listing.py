"""All faces of planes of rank 3, and of central ones of rank 4, in a space of any dimension."""

from __future__ import annotations

import numpy as np

from arrangement.enumeration import great_circles
from arrangement.enumeration.reduction import from_dimension, in_dimension, joined
from arrangement.enumeration.sequence import Level, Rows, Signs, no_faces
from arrangement.numbers.coefficients import Integers
from arrangement.numbers.exact import dot
from arrangement.numbers.linear.rank import cut, unit_vectors
from arrangement.planes.planes import Planes

from .faces import space_levels


def list_faces(planes: Planes) -> tuple[Level, ...]:
    """Return the faces of dimension 0, 1, ..., d of planes of rank 3, or central ones of rank 4."""
    if planes.rank == 3:
        reduced, columns = in_dimension(planes, 3)
        return from_dimension(space_levels(reduced), planes, columns)
    reduced, columns = in_dimension(planes, 4)
    return from_dimension(_central_levels(reduced), planes, columns)


def _central_levels(planes: Planes) -> tuple[Level, ...]:
    """Return the faces of central planes of rank 4 in R^4, with the first plane at infinity.

    With coordinates (y, w) such that the first plane is w = 0, its positive side is the cone over
    affine planes in the space of y, its negative side the antipode of that, and the first plane
    itself has central planes of rank 3.
    """
    normals = [plane[:-1] for plane in planes.integer_planes]
    pivot = next(i for i, x in enumerate(normals[0]) if x)
    beside = tuple(x if normals[0][pivot] > 0 else -x for x in unit_vectors(4)[pivot])
    basis = [*cut(unit_vectors(4), normals[0]), beside]
    at_infinity = np.array(planes.class_of) == 0
    others = np.flatnonzero(~at_infinity)
    rows = [[dot(normals[i], vector) for vector in basis] for i in others]
    affine = Planes([row[:3] for row in rows], [-row[3] for row in rows])
    half = space_levels(affine)
    flat = great_circles.list_faces(Planes([row[:3] for row in rows]))
    sides = np.where(at_infinity, planes.orientation, 0).astype(np.int8)

    def lifted(level: Level, side: int) -> Level:
        """Return faces in R^4 on one side of the first plane, or on it."""

        def signs(rows: Rows) -> Signs:
            found = level.signs(rows)
            whole = np.repeat(side * sides[None], len(found), axis=0)
            whole[:, others] = found * (side or 1)
            return whole

        def points(rows: Rows) -> Integers:
            found = level.points(rows).astype(object)
            if not side:
                found[:, -1] = 0
            found = (side or 1) * (found @ np.array(basis, object))
            return np.hstack([found, np.ones((len(found), 1), object)])

        return Level(level.count, signs, points)

    nothing = no_faces(len(planes), 4)
    by_side = (
        [nothing, *(lifted(level, 1) for level in half)],
        [nothing, *(lifted(level, -1) for level in half)],
        [*(lifted(level, 0) for level in flat), nothing],
    )
    return tuple(map(joined, zip(*by_side, strict=True)))
