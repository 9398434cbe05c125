"""The space in which planes are drawn: their own, or that of their essentialisation.

Planes of rank r in R^d are those of an arrangement in R^r, times a linear space. Most views are
made for one space, R^2, R^3 or R^4. This module brings planes there, and says so below the picture.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.counts.configuration import pivot_columns
from arrangement.drawing.scene.items import Floats
from arrangement.numbers.exact import IntegerVector, dot
from arrangement.numbers.linear.rank import rank, unit_vectors
from arrangement.planes.planes import Planes

RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
#: A linear map is rounded to multiples of 1 over this, or of a fraction of it.
_SCALE = 1 << 12


def items_of(planes: Planes) -> str:
    """Return what hyperplanes are called in their space."""
    return {2: "lines", 3: "planes"}.get(planes.dimension, "hyperplanes")


def caption(planes: Planes, dimension: int) -> str:
    """Return what is said below a picture of planes in R^dimension; nothing in their own space."""
    if planes.dimension == dimension:
        return ""
    essential = "essentialisation of an " * (planes.dimension > planes.rank)
    space = f"arrangement in R{str(planes.dimension).translate(RAISED)}"
    return (
        f"{essential}{space}"
        + ("", ", times a line", ", times a plane", ", times R³")[dimension - planes.rank]
    )


def in_space(arrangement: Arrangement, dimension: int) -> Arrangement:
    """Return planes of rank r in R^n, n >= r, with the same signs, faces and offsets.

    The first r coordinates are orthonormal ones of the span of the normals, rounded: angles stay
    what they were but for less than 10^-3. The map is invertible, and applied exactly.

    >>> braid = Arrangement([[1, -1, 0, 0], [0, 1, -1, 0], [0, 0, 1, -1]])
    >>> in_space(braid, 3).rank
    3
    """
    if arrangement.dimension == dimension:
        return arrangement
    normals = [plane[:-1] for plane in arrangement.integer_planes]
    columns = pivot_columns(normals, arrangement.dimension)
    scale, rows = 1, unit_vectors(len(columns))
    if len(columns) < arrangement.dimension and columns:
        rows, scale = rounded_map(_isometry(normals, columns), _SCALE // 8)
    zeros = (0,) * (dimension - len(columns))
    chosen = ([normal[j] for j in columns] for normal in normals)
    return Arrangement(
        [(*(dot(row, normal) for row in rows), *zeros) for normal in chosen],
        [offset * scale for offset in arrangement.offsets],
        dimension=dimension,
    )


def _isometry(normals: Sequence[IntegerVector], columns: Sequence[int]) -> Floats:
    """Return the symmetric matrix that makes chosen coordinates of normals orthonormal ones."""
    largest = [max(map(abs, normal)) for normal in normals]
    scaled = [[x / most for x in n] for n, most in zip(normals, largest, strict=True)]
    span = np.linalg.svd(np.array(scaled), full_matrices=False)[2][: len(columns), columns]
    return inverse_root(span.T @ span)


def inverse_root(squares: Floats) -> Floats:
    """Return the inverse of the symmetric root of a matrix of sums of squares."""
    sizes, axes = np.linalg.eigh(squares)
    root: Floats = (axes / np.sqrt(np.maximum(sizes, 1e-12))) @ axes.T
    return root


def rounded_map(matrix: Floats, scale: int) -> tuple[list[IntegerVector], int]:
    """Return an invertible integer matrix that is nearly a float one times a scale, and the scale.

    Args:
        scale: times 8, or a higher power of 8 where rounding leaves no inverse.
    """
    rows: list[IntegerVector] = []
    while rank(rows) < len(matrix):
        scale *= 8
        rows = [tuple(round(x * scale) for x in row) for row in matrix.tolist()]
    return rows, scale
