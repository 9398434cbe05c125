"""What central planes of rank 4 cut out on an affine hyperplane: planes of R^3."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable
from typing import Annotated, Any, TypeAlias

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.options.signature import Syntax
from arrangement.counts.configuration import pivot_columns
from arrangement.drawing.solids.sight import unit_vectors
from arrangement.errors import InputError
from arrangement.numbers.entries import real_vector
from arrangement.numbers.exact import IntegerVector, dot, primitive, shown
from arrangement.numbers.linear.rank import cut, rank, unit_vectors as standard_basis
from arrangement.pictures.parts.coordinates import (
    coordinate_map,
    in_space,
    in_view_space,
    inverse_root,
    mapped,
    rounded_map,
)

Equation: TypeAlias = Annotated[Iterable[Any], Syntax(lambda text: text.split(","), "A,B,..,E")]

#: Cosines below this are zero; what zeros cost.
_NEVER, _COST = 1e-9, 1.0


def cut_out(
    arrangement: Arrangement, plane: Equation | None, coordinates: str | None
) -> tuple[Arrangement, IntegerVector]:
    """Return what planes cut out on a hyperplane, and the hyperplane.

    Args:
        arrangement: central, of rank 4.
        plane: its equation ``a . x = e`` as ``(a_1, ..., a_d, e)``, a in the span of the normals;
            if omitted, one that meets lines of intersection not far off.
        coordinates: see `in_coordinates`; on the hyperplane they are orthonormal ones, rounded.

    Returns:
        Planes of R^3 with the signs of the given ones, and the equation in given coordinates.

    Raises:
        InputError: other planes, a hyperplane that is not one, or parallel to one of them.
    """
    space = in_view_space(arrangement, "section")
    matrix = coordinate_map(coordinates, space)
    matrix = np.eye(4) if matrix is None else matrix
    normals = [row[:-1] for row in arrangement.integer_planes]
    if plane is None:
        equation: IntegerVector = (*_clear_normal(normals, mapped(matrix, space)[0]), 1)
    else:
        equation = primitive(real_vector(plane, "section"))
        d = arrangement.dimension
        if len(equation) != d + 1 or not any(equation[:-1]):
            raise InputError(
                f"the section is {shown(plane)}; give {d} coefficients, not all 0, and what the "
                "sum is equal to"
            )
        if rank([*normals, equation[:-1]]) > 4:
            raise InputError(
                f"the section {shown(plane)} is not of the space of the planes; give a sum of "
                "their normals"
            )
    both = Arrangement([*normals, equation[:-1]], [0] * len(normals) + [equation[-1]])
    *given, (*normal, offset) = mapped(matrix, in_space(both, 4))[0].integer_planes
    basis = cut(standard_basis(4), normal)
    lengths = np.array([math.hypot(*map(float, row)) for row in basis])
    units = np.array(basis, dtype=float) / lengths[:, None]
    scale = math.ceil(lengths.max()) << 10
    rows, scale = rounded_map(inverse_root(units @ units.T) / lengths, scale)
    axes = [[dot(row, column) for column in zip(*basis, strict=True)] for row in rows]
    square = dot(normal, normal)
    found = [[square * dot(axis, row[:-1]) for axis in axes] for row in given]
    if flat := [k + 1 for k, row in enumerate(found) if not any(row)]:
        raise InputError(f"plane {flat[0]} does not meet the section, to which it is parallel")
    offsets = [-scale * offset * dot(normal, row[:-1]) for row in given]
    return Arrangement(found, offsets), equation


def _clear_normal(normals: list[IntegerVector], space: Arrangement) -> IntegerVector:
    """Return a small sum of independent normals that is parallel to none, and orthogonal to no ray.

    Of the latter at least to none nearly, where lines that never meet the hyperplane cost little.

    Args:
        space: the same planes as they are drawn, in R^4.
    """
    chosen = pivot_columns(list(zip(*normals, strict=True)), len(normals))
    rays = unit_vectors([face.witness for face in space.faces(1)])
    drawn = unit_vectors([plane[:-1] for plane in space.integer_planes])
    basis = np.array([[float(x) for x in space.integer_planes[k][:-1]] for k in chosen])
    sums = sorted(itertools.product(range(-2, 3), repeat=4), key=lambda s: (sum(map(abs, s)), s))
    sums = [row for row in sums if any(row) and primitive(row) == row and row > (0, 0, 0, 0)]
    found = np.array(sums) @ basis
    found /= np.linalg.norm(found, axis=1, keepdims=True)
    near = np.abs(found @ rays.T)
    missed = near < _NEVER
    score = np.where(missed, 1.0, near).min(axis=1) - _COST * missed.any(axis=1)
    score -= (np.abs(found @ drawn.T) > 1 - _NEVER).any(axis=1)
    best = sums[int(np.argmax(np.round(score, 6)))]
    own = [normals[k] for k in chosen]
    return tuple(dot(best, column) for column in zip(*own, strict=True))
