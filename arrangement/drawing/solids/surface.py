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

from arrangement.console.progress import watched
from arrangement.numbers.exact import IntegerVector, dot, primitive, unoriented
from arrangement.numbers.linear.intervals import remainder
from arrangement.numbers.linear.polyhedron import Polyhedron
from arrangement.numbers.linear.rank import cycle_edges, difference

from .flat_polygons import (
    Boxed,
    Loop,
    Segment,
    between,
    creases_of,
    drop_coordinate,
    facing,
    hull_corners,
    restore_coordinate,
    with_box,
    without,
)

#: Of rounded coordinates, over the largest of them: far above any error of rounding.
_APART = 1e-9


@dataclass(frozen=True)
class Patch:
    """A convex polygon, segment or point of a surface in R^3.

    Attributes:
        row: (a, b); ``a . x + b`` is 0 on the patch and negative in the solid behind it. All
            entries are 0 for a segment or a point.
        corners: homogeneous, in cyclic order.
        edges: the parts of its edges where the surface bends or ends.
        sheet: whether no solid is behind it.
        name: set by the caller; not used here.
    """

    row: IntegerVector
    corners: tuple[IntegerVector, ...]
    edges: tuple[Segment, ...] = ()
    sheet: bool = False
    name: str = ""


def surface(shapes: Iterable[Polyhedron]) -> tuple[Patch, ...]:
    """Return the surface of the union of bounded polyhedra in R^3 of any dimension.

    >>> from arrangement.numbers.linear.polyhedron import from_conditions
    >>> def box(low, high):
    ...     rows = [((1, 0, 0), low), ((0, 1, 0), 0), ((0, 0, 1), 0)]
    ...     rows = [(*n, -b) for n, b in rows]
    ...     return from_conditions([*rows, (-1, 0, 0, high), (0, -1, 0, 1), (0, 0, -1, 1)], (), 3)
    >>> len(surface([box(0, 2), box(1, 3)])), len(surface([box(0, 1), box(2, 3)]))
    (10, 12)
    """
    every = list(shapes)
    solids = _Polytopes([_Polytope(shape) for shape in every if shape.dimension == 3])
    flat = [shape for shape in every if shape.dimension == 2]
    facets: dict[IntegerVector, dict[frozenset[IntegerVector], Loop]] = {}
    for solid in solids.listed:
        for row, corners in solid.facets:
            facets.setdefault(row, {})[frozenset(corners)] = corners
    # A facet with a solid on either side is inside, and most are.
    alone = {
        row: [c for ends, c in facets[row].items() if ends not in facets.get(_opposite(row), ())]
        for row in sorted(facets)
    }
    sheets: dict[IntegerVector, list[Loop]] = {}
    for shape in flat:
        row = unoriented(shape.equalities[0])
        sheets.setdefault(row, []).append(hull_corners(row, _homogeneous(shape)))
    return (
        *(
            p
            for row in watched([row for row in alone if alone[row]], "planes of faces")
            for p in _patches(row, alone[row], solids, sheet=False)
        ),
        *(p for row in sorted(sheets) for p in _patches(row, sheets[row], solids, sheet=True)),
        *_thin(every),
    )


class _Polytope:
    """A polytope with its facets as (outward row, corners), and its edges."""

    def __init__(self, shape: Polyhedron) -> None:
        self.points = _homogeneous(shape)
        self.facets = [
            (row, facing(row, [self.points[j] for j in cycle]))
            for row, cycle in zip(map(_opposite, shape.inequalities), shape.cycles, strict=True)
        ]
        self.rows = {row for row, _ in self.facets}
        self.corners = set(self.points)

    @cached_property
    def edges(self) -> set[Segment]:
        """Its edges, each once."""
        return {(min(p, q), max(p, q)) for _, loop in self.facets for p, q in cycle_edges(loop)}

    def reaches(self, row: IntegerVector) -> bool:
        """Return whether it has points where ``row`` is positive."""
        return row not in self.rows and any(dot(row, p) > 0 for p in self.points)

    def section(self, row: IntegerVector) -> Loop:
        """Return what it covers of a plane, if that has an area."""
        values = {p: dot(row, p) for p in self.points}
        corners = {p for p, at in values.items() if at == 0}
        for p, q in self.edges:
            if values[p] * values[q] < 0:
                corners.add(between(p, q, values[p], values[q]))
        return hull_corners(row, corners) if len(corners) > 2 else []


class _Polytopes:
    """Polytopes, with rounded corners and rows to find those that matter at a place quickly."""

    def __init__(self, listed: Sequence[_Polytope]) -> None:
        self.listed = listed
        self.starts = np.cumsum([0, *(len(solid.points) for solid in listed)])[:-1]
        self.points = float_points([p for solid in listed for p in solid.points])
        self.low, self.high = (
            f.reduceat(self.points, self.starts) if listed else self.points
            for f in (np.minimum, np.maximum)
        )
        #: The largest first: they cover most.
        self.order = np.argsort(-np.prod(self.high - self.low, axis=1), kind="stable")
        #: Rounding moves values of forms by far less than this.
        self.far = _APART * max(1.0, float(np.abs(self.points).max(initial=0.0)))
        self.rows = _unit_rows([row for solid in listed for row, _ in solid.facets])
        self.row_starts = np.cumsum([0, *(len(solid.facets) for solid in listed)])[:-1]

    def near(self, row: IntegerVector, loop: Loop, *, sheet: bool) -> list[_Polytope] | None:
        """Return the polytopes that may cover a part of a polygon in a plane; None if one has all.

        Those left out have no area in common with it: they are apart by much more than rounding
        moves points, or exactly one of their facets has the polygon on its outer side.
        """
        if not self.listed:
            return []
        corners, far = float_points(loop), 4 * self.far
        values = self.points @ _unit_rows([row])[0, :3] + _unit_rows([row])[0, 3]
        most = np.maximum.reduceat(values, self.starts)
        boxes = (self.low <= corners.max(axis=0) + far) & (self.high >= corners.min(axis=0) - far)
        near = (
            boxes.all(axis=1) & (np.minimum.reduceat(values, self.starts) <= far) & (most >= -far)
        )
        # One row for each corner, one column for each facet.
        sides = corners @ self.rows[:, :3].T + self.rows[:, 3]
        most_outside, least = sides.max(axis=0), sides.min(axis=0)
        near &= np.maximum.reduceat(least, self.row_starts) <= far
        beyond = np.maximum.reduceat(most_outside, self.row_starts)
        listed, planes = [], (row, _opposite(row))

        def holds(solid: int, values: NDArray[np.float64], side: int) -> Iterator[bool]:
            """Yield for facets of a polytope whether the corners are on a side, or on the facet.

            Only what the floats leave open is computed; those surely on the other side are left
            out.
            """
            first, facets = int(self.row_starts[solid]), self.listed[solid].facets
            own = values[first : first + len(facets)]
            for i in np.flatnonzero(own >= -far).tolist():
                normal = facets[i][0]
                if side < 0 or normal not in planes:
                    unsure = np.flatnonzero(np.abs(sides[:, first + i]) <= far).tolist()
                    yield all(
                        (side < 0 and loop[k] in self.listed[solid].corners)
                        or side * dot(normal, loop[k]) >= 0
                        for k in unsure
                    )

        for k in self.order[near[self.order]].tolist():
            solid = self.listed[k]
            if not (sheet or most[k] > far or solid.reaches(row)):
                continue
            if beyond[k] <= far and all(holds(k, most_outside, -1)):
                return None
            if not any(holds(k, least, 1)):
                listed.append(solid)
        return listed


def _unit_rows(rows: Sequence[IntegerVector]) -> NDArray[np.float64]:
    """Return rows divided by their largest entries, (k, 4)."""
    return np.array([[x / max(map(abs, row)) for x in row] for row in rows]).reshape(-1, 4)


def float_points(points: Iterable[IntegerVector]) -> NDArray[np.float64]:
    """Return homogeneous points as floats, (k, 3)."""
    return np.array([[float(x / p[3]) for x in p[:3]] for p in points]).reshape(-1, 3)


def _homogeneous(shape: Polyhedron) -> Loop:
    return list(shape.homogeneous[0])


def _opposite(row: IntegerVector) -> IntegerVector:
    return tuple([-x for x in row])


def _patches(
    row: IntegerVector, loops: Sequence[Loop], solids: _Polytopes, *, sheet: bool
) -> Iterator[Patch]:
    """Yield what is seen of polygons in a plane, as convex polygons without overlaps."""
    kept: list[Boxed] = []
    sections: dict[int, Boxed | None] = {}
    for loop in loops:
        near = solids.near(row, loop, sheet=sheet)
        if near is None:
            continue
        left = [with_box(drop_coordinate(row, loop))]
        for cover in kept:
            left = without(left, cover)
        for solid in near:
            if not left:
                break
            if id(solid) not in sections:
                section = drop_coordinate(row, solid.section(row))
                sections[id(solid)] = with_box(section) if section else None
            if part := sections[id(solid)]:
                left = without(left, part)
        kept += left
    listed = [part.loop for part in kept]
    edges = creases_of(listed)
    for loop, creases in zip(listed, edges, strict=True):
        ends = tuple((restore_coordinate(row, p), restore_coordinate(row, q)) for p, q in creases)
        yield Patch(row, tuple(restore_coordinate(row, p) for p in loop), ends, sheet)


def _thin(shapes: Sequence[Polyhedron]) -> Iterator[Patch]:
    """Yield the parts of segments, and the points, that lie in nothing larger."""
    for shape in (shape for shape in shapes if shape.dimension < 2):
        larger = [other for other in shapes if other.dimension > shape.dimension]
        if shape.dimension == 1:
            p, q = shape.points
            step = difference(q, p)
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
