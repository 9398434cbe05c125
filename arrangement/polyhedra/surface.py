"""The surface of a finite union of convex polytopes in R^3, in flat pieces, exactly.

A generic point of a facet lies on the surface exactly when no polytope has it and points right
behind it. So what is left of every facet, after the sections of those polytopes with its plane are
taken away, is the surface: polygons, cut into convex ones. Parts without volume stay as sheets,
segments and points. Points are homogeneous integers ``(x, y, z, w)``, w > 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from arrangement.exact import IntegerVector, dot, primitive, unoriented
from arrangement.linear import determinant
from arrangement.progress import watched

from .flat_polygons import Loop, Segment, between, creases_of, flattened, lifted, minus, ordered
from .intervals import remainder
from .polyhedron import Polyhedron

#: Of rounded coordinates, over the largest of them: far above any error of rounding.
_APART = 1e-9


@dataclass(frozen=True)
class Patch:
    """A convex piece of the surface.

    Attributes:
        row: ``(a, b)`` with ``a . x + b = 0`` on it and < 0 in the solid behind it; of a segment
            or a point zeros.
        corners: in cyclic order.
        edges: the parts of its edges where the surface bends or ends.
        sheet: whether there is no solid behind it.
        name: whatever its user makes of it.
    """

    row: IntegerVector
    corners: tuple[IntegerVector, ...]
    edges: tuple[Segment, ...] = ()
    sheet: bool = False
    name: str = ""


def surface(shapes: Iterable[Polyhedron]) -> tuple[Patch, ...]:
    """Return the surface of the union of bounded polyhedra in R^3 of any dimension.

    >>> from arrangement.polyhedra.polyhedron import from_conditions
    >>> def box(low, high):
    ...     rows = [((1, 0, 0), low), ((0, 1, 0), 0), ((0, 0, 1), 0)]
    ...     rows = [(*n, -b) for n, b in rows]
    ...     return from_conditions([*rows, (-1, 0, 0, high), (0, -1, 0, 1), (0, 0, -1, 1)], (), 3)
    >>> len(surface([box(0, 2), box(1, 3)])), len(surface([box(0, 1), box(2, 3)]))
    (10, 12)
    """
    every = list(shapes)
    solids = _Solids([_Solid(shape) for shape in every if shape.dimension == 3])
    flat = [shape for shape in every if shape.dimension == 2]
    facets: dict[IntegerVector, list[Loop]] = {}
    for solid in solids.listed:
        for row, corners in solid.facets:
            facets.setdefault(row, []).append(corners)
    sheets: dict[IntegerVector, list[Loop]] = {}
    for shape in flat:
        row = unoriented(shape.equalities[0])
        sheets.setdefault(row, []).append(ordered(row, _homogeneous(shape)))
    return (
        *(
            p
            for row in watched(sorted(facets), "planes of faces")
            for p in _patches(row, facets[row], solids, sheet=False)
        ),
        *(p for row in sorted(sheets) for p in _patches(row, sheets[row], solids, sheet=True)),
        *_thin(every),
    )


def facets(
    shape: Polyhedron,
) -> tuple[Loop, tuple[tuple[int, ...], ...], tuple[IntegerVector, ...]]:
    """Return the corners of a polytope of dimension 3, its facets as cycles, and outward rows.

    Cycles run counter-clockwise seen from outside.
    """
    solid = _Solid(shape)
    number = {p: k for k, p in enumerate(solid.points)}
    cycles = []
    for row, loop in solid.facets:
        p, q, r = loop[:3]
        ahead = determinant([(*row[:3], 0), p, q, r])
        cycles.append(tuple(number[x] for x in (loop if ahead > 0 else reversed(loop))))
    return solid.points, tuple(cycles), tuple(row for row, _ in solid.facets)


class _Solid:
    """A polytope with its facets as (outward row, corners), and its edges."""

    def __init__(self, shape: Polyhedron) -> None:
        self.points = _homogeneous(shape)
        self.facets = []
        for inward in shape.inequalities:
            row = tuple(-x for x in inward)
            self.facets.append((row, ordered(row, [p for p in self.points if not dot(row, p)])))

    @cached_property
    def edges(self) -> set[Segment]:
        """Its edges, each once."""
        return {
            (min(p, q), max(p, q))
            for _, loop in self.facets
            for p, q in zip(loop, [*loop[1:], loop[0]], strict=True)
        }

    def section(self, row: IntegerVector, *, sheet: bool) -> Loop:
        """Return what it covers of a plane, on the side where ``row`` is positive; else nothing."""
        values = {p: dot(row, p) for p in self.points}
        if not sheet and max(values.values()) <= 0:
            return []
        found = {p for p, at in values.items() if at == 0}
        for p, q in self.edges:
            if values[p] * values[q] < 0:
                found.add(between(p, q, values[p], values[q]))
        return ordered(row, found) if len(found) > 2 else []


class _Solids:
    """Polytopes, with rounded corners to find those near a place quickly."""

    def __init__(self, listed: Sequence[_Solid]) -> None:
        self.listed = listed
        self.starts = np.cumsum([0, *(len(solid.points) for solid in listed)])[:-1]
        self.points = rounded([p for solid in listed for p in solid.points])

    def near(self, row: IntegerVector, corners: Sequence[IntegerVector]) -> list[_Solid]:
        """Return the polytopes that may have a common point with a polygon in a plane.

        Those left out are apart by much more than rounding moves points: `_APART` of their size.
        """
        if not self.listed:
            return []
        largest = max(map(abs, row))
        size = max(1.0, float(np.abs(self.points).max()))
        values = self.points @ [x / largest for x in row[:3]] + row[3] / largest
        polygon, far = rounded(corners), _APART * size
        low, high = (f.reduceat(self.points, self.starts) for f in (np.minimum, np.maximum))
        meets = (low <= polygon.max(axis=0) + far) & (high >= polygon.min(axis=0) - far)
        found = (
            meets.all(axis=1)
            & (np.minimum.reduceat(values, self.starts) <= 4 * far)
            & (np.maximum.reduceat(values, self.starts) >= -4 * far)
        )
        # The largest first: they cover most.
        order = np.argsort(-np.prod(high - low, axis=1), kind="stable")
        return [self.listed[k] for k in order[found[order]].tolist()]


def rounded(points: Iterable[IntegerVector]) -> NDArray[np.float64]:
    """Return homogeneous points as floats, (k, 3)."""
    return np.array([[x / p[3] for x in p[:3]] for p in points]).reshape(-1, 3)


def _homogeneous(shape: Polyhedron) -> Loop:
    return [primitive((*point, Fraction(1))) for point in shape.points]


def _patches(
    row: IntegerVector, loops: Sequence[Loop], solids: _Solids, *, sheet: bool
) -> Iterator[Patch]:
    """Yield what is seen of polygons in a plane, as convex polygons without overlaps."""
    kept: list[Loop] = []
    for loop in loops:
        left = [flattened(row, loop)]
        for cover in kept:
            left = [rest for part in left for rest in minus(part, cover)]
        kept += left
    for solid in solids.near(row, [p for loop in loops for p in loop]):
        if not kept:
            break
        if section := solid.section(row, sheet=sheet):
            cover = flattened(row, section)
            kept = [piece for part in kept for piece in minus(part, cover)]
    edges = creases_of(kept)
    for loop, creases in zip(kept, edges, strict=True):
        ends = tuple((lifted(row, p), lifted(row, q)) for p, q in creases)
        yield Patch(row, tuple(lifted(row, p) for p in loop), ends, sheet)


def _thin(shapes: Sequence[Polyhedron]) -> Iterator[Patch]:
    """Yield the parts of segments, and the points, that lie in nothing larger."""
    for shape in shapes:
        larger = [other for other in shapes if other.dimension > shape.dimension]
        if shape.dimension == 1:
            p, q = shape.points
            step = [b - a for a, b in zip(p, q, strict=True)]
            covered = [part for other in larger if (part := other.along(p, step))]
            for low, high in remainder((Fraction(0), Fraction(1)), covered):
                if low is not None and high is not None and low < high:
                    ends = tuple(
                        primitive((*(a + t * b for a, b in zip(p, step, strict=True)), Fraction(1)))
                        for t in (low, high)
                    )
                    yield Patch((0,) * 4, ends, ((ends[0], ends[1]),), sheet=True)
        elif shape.dimension == 0 and not any(other.contains(shape.points[0]) for other in larger):
            yield Patch((0,) * 4, (_homogeneous(shape)[0],), sheet=True)
