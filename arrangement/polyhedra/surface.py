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

from arrangement.exact import IntegerVector, dot, primitive, sign, unoriented
from arrangement.linear import cross, determinant, reduced, triple_product
from arrangement.progress import watched

from .intervals import Interval, remainder
from .polyhedron import Polyhedron

#: Of rounded coordinates, over the largest of them: far above any error of rounding.
_APART = 1e-9

Loop = list[IntegerVector]
Segment = tuple[IntegerVector, IntegerVector]


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
        sheets.setdefault(row, []).append(_ordered(row, _homogeneous(shape)))
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
            self.facets.append((row, _ordered(row, [p for p in self.points if not dot(row, p)])))

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
        return _ordered(row, found) if len(found) > 2 else []


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


def between(p: IntegerVector, q: IntegerVector, at_p: int, at_q: int) -> IntegerVector:
    """Return where a linear form vanishes between two points; its values there differ in sign."""
    s, t = abs(at_q), abs(at_p)
    return reduced([s * x + t * y for x, y in zip(p, q, strict=True)])


def _homogeneous(shape: Polyhedron) -> Loop:
    return [primitive((*point, Fraction(1))) for point in shape.points]


def _dropped(row: IntegerVector) -> int:
    """Return the coordinate that is left out of points in a plane."""
    return max(range(3), key=lambda k: abs(row[k]))


def _flat(row: IntegerVector, points: Iterable[IntegerVector]) -> Loop:
    gone = _dropped(row)
    return [reduced([x for k, x in enumerate(p) if k != gone]) for p in points]


def _ordered(row: IntegerVector, points: Iterable[IntegerVector]) -> Loop:
    """Return the corners of the hull of points in a plane, in cyclic order (A. Andrew, 1979)."""
    gone = _dropped(row)
    keys = [k for k in range(3) if k != gone]
    listed = sorted(points, key=lambda p: [Fraction(p[k], p[3]) for k in keys])
    if len(listed) < 3:
        return listed

    def half(along: Iterable[IntegerVector]) -> Loop:
        chain: Loop = []
        for p in along:
            while len(chain) > 1 and triple_product(*_flat(row, [*chain[-2:], p])) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return half(listed) + half(reversed(listed))


def _patches(
    row: IntegerVector, loops: Sequence[Loop], solids: _Solids, *, sheet: bool
) -> Iterator[Patch]:
    """Yield what is seen of polygons in a plane, as convex polygons without overlaps."""
    kept: list[Loop] = []
    for loop in loops:
        left = [_flat(row, loop)]
        for cover in kept:
            left = [rest for part in left for rest in _minus(part, cover)]
        kept += left
    for solid in solids.near(row, [p for loop in loops for p in loop]):
        if not kept:
            break
        if section := solid.section(row, sheet=sheet):
            cover = _flat(row, section)
            kept = [piece for part in kept for piece in _minus(part, cover)]
    edges = _edges(kept)
    for loop, creases in zip(kept, edges, strict=True):
        ends = tuple((_lifted(row, p), _lifted(row, q)) for p, q in creases)
        yield Patch(row, tuple(_lifted(row, p) for p in loop), ends, sheet)


def _lifted(row: IntegerVector, point: IntegerVector) -> IntegerVector:
    """Return the point of a plane with one coordinate left out."""
    gone = _dropped(row)
    rest = [x for k, x in enumerate(row) if k != gone]
    scale = abs(row[gone])
    found = [scale * x for x in point]
    found.insert(gone, -sign(row[gone]) * dot(rest, point))
    return reduced(found)


def _clipped(loop: Loop, line: IntegerVector) -> Loop:
    """Return the part of a polygon where a form is >= 0; nothing if that has no area."""
    values = [dot(line, p) for p in loop]
    if max(values) <= 0:
        return []
    if min(values) >= 0:
        return loop
    kept = []
    for k, (p, at) in enumerate(zip(loop, values, strict=True)):
        if at * values[k - 1] < 0:
            kept.append(between(loop[k - 1], p, values[k - 1], at))
        if at >= 0:
            kept.append(p)
    return kept


def _minus(loop: Loop, cover: Loop) -> list[Loop]:
    """Return convex pieces of a polygon outside another; both run counter-clockwise."""
    lines = [cross(p, q) for p, q in zip(cover, [*cover[1:], cover[0]], strict=True)]
    common = loop
    for line in lines:
        common = _clipped(common, line)
        if not common:
            return [loop]
    pieces, rest = [], loop
    for line in lines:
        if outside := _clipped(rest, tuple(-x for x in line)):
            pieces.append(outside)
        rest = _clipped(rest, line)
    return pieces


def _edges(loops: Sequence[Loop]) -> list[list[Segment]]:
    """Return for each polygon the parts of its edges with no other polygon across."""
    sides: dict[IntegerVector, list[Interval]] = {}
    listed = []
    for loop in loops:
        own = []
        for p, q in zip(loop, [*loop[1:], loop[0]], strict=True):
            line = reduced(cross(p, q))
            k = 0 if line[1] else 1
            ends = Fraction(p[k], p[2]), Fraction(q[k], q[2])
            part = (min(ends), max(ends))
            sides.setdefault(line, []).append(part)
            own.append((line, k, part))
        listed.append(own)
    found = []
    for own in listed:
        creases = []
        for line, k, part in own:
            across = sides.get(tuple(-x for x in line), ())
            rest = remainder(part, across)
            creases += [(_at(line, k, low), _at(line, k, high)) for low, high in rest]
        found.append(creases)
    return found


def _at(line: IntegerVector, k: int, value: Fraction | None) -> IntegerVector:
    """Return the point of a line of the plane with this coordinate k."""
    assert value is not None
    other = Fraction(-(line[k] * value + line[2]), line[1 - k])
    return primitive((value, other, Fraction(1)) if k == 0 else (other, value, Fraction(1)))


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
