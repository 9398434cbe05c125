"""New arrangements from old: one plane more or less, union, restriction, cone, and others."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeVar

import numpy as np

from arrangement.errors import InputError
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    one_way,
    primitive,
    quotient,
    rational_vector,
    unoriented,
)
from arrangement.numbers.linear.rank import ask_elimination, evenly_spaced, gauss_jordan, rank
from arrangement.numbers.symbolic import entry, exact_matrix, matrix_entries
from arrangement.planes.planes import Hyperplane, Planes

from .configuration import Indices, indices, pivot_columns
from .low_rank import MAX_RANK

#: Planes of low rank that are counted without a look at their factors.
_MANY = 500
#: What comes out is of the class of what went in.
AnyPlanes = TypeVar("AnyPlanes", bound=Planes)


@dataclass(frozen=True)
class Chart:
    """Coordinates on an affine subspace: y stands for the point ``origin + sum y_j basis_j``."""

    origin: RationalVector
    basis: tuple[IntegerVector, ...]


def deletion(arrangement: AnyPlanes, planes: Indices) -> AnyPlanes:
    """Return the arrangement without some input planes, the others in their order.

    Planes that coincide with a deleted one stay; name the whole class to delete it. For a class
    H, chi(A) = chi(A without H) - chi(A restricted to H).

    >>> from arrangement import Arrangement
    >>> deletion(Arrangement([[1, 0], [0, 1], [1, 1]]), 1).integer_planes
    ((1, 0, 0), (1, 1, 0))
    """
    gone = set(indices(arrangement, planes))
    return _select(arrangement, [i for i in range(len(arrangement)) if i not in gone])


def addition(arrangement: AnyPlanes, normal: Iterable[Any], offset: Any = 0) -> AnyPlanes:
    """Return the arrangement with one more plane, as its last one.

    It is ``normal . x = offset``, or a hyperplane of other planes, in place of both.

    >>> from arrangement import Arrangement
    >>> addition(Arrangement([[1, 0], [0, 1]]), [1, 1], 2).integer_planes
    ((1, 0, 0), (0, 1, 0), (1, 1, 2))
    """
    if isinstance(normal, Hyperplane):
        normal, offset = normal
    return _with_planes(
        arrangement, [(*rational_vector(normal, "normal", entry), entry(offset, "offset"))]
    )


def union(arrangement: AnyPlanes, other: Planes) -> AnyPlanes:
    """Return the planes of an arrangement, and after them those that only another one has.

    Raises:
        InputError: if the two live in different dimensions.

    >>> from arrangement import Arrangement
    >>> union(Arrangement([[1, 0]]), Arrangement([[0, 1], [-1, 0]])).integer_planes
    ((1, 0, 0), (0, 1, 0))
    """
    if arrangement.dimension != other.dimension:
        raise InputError(
            f"planes of R^{arrangement.dimension} and of R^{other.dimension} have no union; give "
            "planes of one space"
        )
    known = {unoriented(plane) for plane in arrangement.integer_planes}
    return _with_planes(
        arrangement, [plane for plane in other.integer_planes if unoriented(plane) not in known]
    )


def localization(arrangement: AnyPlanes, planes: Indices) -> AnyPlanes:
    """Return the planes that contain the common intersection of some planes, in their order.

    Raises:
        InputError: if that intersection is empty.

    >>> from arrangement import Arrangement
    >>> localization(Arrangement([[1, 0], [0, 1], [1, 1], [1, 2]], [0, 0, 0, 1]), [0, 1])
    <Arrangement: 3 planes (3 distinct) in R^2, rank 2, central>
    """
    rows = _on_flat(arrangement, flat_chart(arrangement, planes))
    return _select(arrangement, [i for i, row in enumerate(rows) if not any(row)])


def restriction(arrangement: AnyPlanes, planes: Indices) -> AnyPlanes:
    """Return the arrangement that the others cut out on the intersection of some planes.

    The coordinates are those of `flat_chart`. Planes that contain the flat or miss it are left
    out; the others keep their order and their sides. Planes that meet the flat in the same set
    stay as coincident planes.

    A restriction to a point is R^0 without planes: one region, chi = 1.

    Raises:
        InputError: if the intersection is empty.

    >>> from arrangement import Arrangement
    >>> restriction(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]), 0).integer_planes
    ((1, 0, 0), (0, 1, 0), (1, 1, 0))
    """
    chart = flat_chart(arrangement, planes)
    rows = [row for row in _on_flat(arrangement, chart) if any(row[:-1])]
    return type(arrangement)(
        [row[:-1] for row in rows], [row[-1] for row in rows], dimension=len(chart.basis)
    )


def cone(arrangement: AnyPlanes) -> AnyPlanes:
    """Return the cone over an arrangement: central, in one dimension more.

    Plane ``n . x = b`` becomes ``n . x - b z = 0``; the last plane is ``z = 0``, with the old
    space at z = 1. chi(cone)(t) = (t - 1) chi(A)(t).

    >>> from arrangement import Arrangement
    >>> cone(Arrangement([[1], [1]], [0, 2])).integer_planes
    ((1, 0, 0), (1, -2, 0), (0, 1, 0))
    """
    normals = [(*plane[:-1], -plane[-1]) for plane in arrangement.integer_planes]
    normals.append((0,) * arrangement.dimension + (1,))
    return type(arrangement)(normals)


def essentialization(arrangement: AnyPlanes) -> AnyPlanes:
    """Return the same planes in R^rank: faces, signs and order agree, without common lines.

    The space is cut down to the coordinate subspace of the normals' pivot columns, which is
    complementary to the directions that all planes share. Without planes it is R^0.

    >>> from arrangement import Arrangement
    >>> essentialization(Arrangement([[0, 1, 1], [0, 1, -1]])).integer_planes
    ((1, 1, 0), (1, -1, 0))
    """
    normals = [plane[:-1] for plane in arrangement.integer_planes]
    columns = pivot_columns(normals, arrangement.dimension)
    return type(arrangement)(
        [[normal[j] for j in columns] for normal in normals],
        arrangement.offsets,
        dimension=len(columns),
    )


def flat_chart(arrangement: Planes, planes: Indices) -> Chart:
    """Return coordinates on the intersection of some planes.

    The free coordinates of the linear system, in increasing order, give the basis; they are 0 at
    the origin of the chart.

    Raises:
        InputError: if the intersection is empty.
    """
    chosen = indices(arrangement, planes)
    dimension = arrangement.dimension
    echelon, scale, pivots = arrangement.matrix.extract(chosen, range(dimension + 1)).rref_den()
    if dimension in pivots:
        raise InputError(f"planes {sorted(chosen)} have no common point")
    rows = dict(zip(pivots, matrix_entries(echelon.to_list(), arrangement.field), strict=False))
    scale = matrix_entries([[scale]], arrangement.field)[0][0]
    origin = tuple(
        quotient(rows[j][dimension], scale) if j in rows else Fraction(0) for j in range(dimension)
    )
    basis = []
    for free in range(dimension):
        if free not in rows:
            vector = [quotient(-rows[j][free], scale) if j in rows else 0 for j in range(dimension)]
            vector[free] = 1
            basis.append(primitive(vector))
    return Chart(origin, tuple(basis))


def _on_flat(arrangement: Planes, chart: Chart) -> list[list[int]]:
    """Return a positive multiple of every plane ``(n, b)`` in the coordinates of a chart."""
    scale = math.lcm(*(x.denominator for x in chart.origin))
    columns = [[*(scale * x for x in vector), 0] for vector in chart.basis]
    columns.append([*((-scale * x).numerator for x in chart.origin), scale])
    inserted = exact_matrix(columns, arrangement.dimension + 1).transpose()
    planes, inserted = arrangement.matrix.unify(inserted)
    return matrix_entries((planes * inserted).to_list(), arrangement.field)


def irreducible_factors(arrangement: Planes) -> list[Planes]:
    """Return arrangements whose product this one is, each in as few coordinates as its rank.

    The normals of one are independent of those of the others, so its faces times theirs are the
    faces of all; chi is the product too, but for a power of t. Coincident planes come once.

    Source: P. Orlik, H. Terao, Arrangements of Hyperplanes (1992), lemma 2.50.

    >>> from arrangement import Arrangement
    >>> [len(factor) for factor in irreducible_factors(Arrangement([[1, 1], [2, 2], [1, 0]]))]
    [1, 1]
    """
    factors = []
    for planes in _parts(arrangement):
        kept = pivot_columns([plane[:-1] for plane in planes], arrangement.dimension)
        rows = [[plane[j] for j in kept] for plane in planes]
        factors.append(Planes(rows, [plane[-1] for plane in planes]))
    return factors


def _parts(arrangement: Planes) -> list[list[IntegerVector]]:
    parallel: dict[IntegerVector, list[IntegerVector]] = {}
    for plane in arrangement.distinct_planes:
        normal = unoriented(plane[:-1]) if plane[-1] else one_way(plane[:-1])
        parallel.setdefault(normal, []).append(plane)
    normals = list(parallel)
    few = evenly_spaced(normals, 4 * arrangement.dimension)
    if arrangement.rank == len(normals):
        parts = [{i} for i in range(len(normals))]
    elif len(few) < len(normals) and rank(few) == arrangement.rank and len(_circuits(few)) == 1:
        parts = [set(range(len(normals)))]  # each of the others is in a circuit with some of these
    else:
        parts = _circuits(normals)
    return [[plane for i in sorted(part) for plane in parallel[normals[i]]] for part in parts]


def _circuits(normals: Sequence[IntegerVector]) -> list[set[int]]:
    """Return the finest parts that split no circuit of normals."""
    columns = list(zip(*normals, strict=True))
    ask_elimination(columns, len(normals))
    rows, pivots, _ = gauss_jordan(columns)
    return _join({i for i, x in enumerate(row) if x} for row in rows[: len(pivots)])


def _join(circuits: Iterable[set[int]]) -> list[set[int]]:
    """Return the parts of rows: a plane and those that its column has are a circuit."""
    parts: list[set[int]] = []
    for row in circuits:
        joined = [part for part in parts if not part.isdisjoint(row)]
        parts = [part for part in parts if part.isdisjoint(row)]
        parts.append(row.union(*joined))
    return parts


def over_factors(
    arrangement: Planes, numbers: Callable[[Planes], tuple[int, ...]]
) -> tuple[int, ...] | None:
    """Return the product, as polynomials, of numbers of the factors; None if there is one factor.

    Where they are worth looking for: beyond rank 4, and of many planes.
    """
    if arrangement.dimension <= MAX_RANK and len(arrangement) <= _MANY:
        return None
    if len(_parts(arrangement)) <= 1:
        return None
    product = [1]
    for factor, times in Counter(irreducible_factors(arrangement)).items():
        own = numbers(factor)
        for _ in range(times):
            product = np.convolve(np.array(product, object), own).tolist()
    return tuple(product)


def _select(arrangement: AnyPlanes, planes: Sequence[int]) -> AnyPlanes:
    chosen = _of(arrangement, [arrangement.integer_planes[i] for i in planes])
    return chosen.named([arrangement.names[i] for i in planes]) if arrangement.names else chosen


def _with_planes(arrangement: AnyPlanes, more: Sequence[Sequence[Any]]) -> AnyPlanes:
    """Return the arrangement with more planes ``(n, b)`` behind its own."""
    return _of(arrangement, [*arrangement.integer_planes, *more])


def _of(arrangement: AnyPlanes, planes: Sequence[Sequence[Any]]) -> AnyPlanes:
    """Return an arrangement of this class and space, of planes ``(n, b)``."""
    return type(arrangement)(
        [plane[:-1] for plane in planes],
        [plane[-1] for plane in planes],
        dimension=arrangement.dimension,
    )
