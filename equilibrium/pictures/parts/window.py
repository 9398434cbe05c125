"""A window on the plane of wrenches, and regions inside it as polygons on paper.

The window holds the whole finite boundary of a region with room to spare, so that what reaches its
edge is unbounded, and fades there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from statistics import median

import numpy as np

from arrangement.drawing.scene.items import Floats
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive
from arrangement.numbers.linear.polyhedron import Polyhedron, from_conditions
from equilibrium.wrench_sets import Region, Segment, polygon_cycle

from .body import Frame

ZERO: RationalVector = (Fraction(0), Fraction(0))
#: How far the window reaches beyond what it holds, as a share of its spread.
ROOM = Fraction(1, 5)


class Window(Frame):
    """A square of the plane of wrenches; paper coordinates run from -1 to 1 in it."""

    @property
    def rows(self) -> tuple[IntegerVector, ...]:
        """The conditions ``a . x + b >= 0`` of the square."""
        found = []
        for k in (0, 1):
            for side in (1, -1):
                row = [Fraction(0), Fraction(0), self.half - side * self.centre[k]]
                row[k] = Fraction(side)
                found.append(primitive(row))
        return tuple(found)

    def inside(self, polyhedron: Polyhedron) -> Floats | None:
        """Return the corners of the part of a polygon inside, counter-clockwise, on paper."""
        cut: Polyhedron | None = polyhedron
        far = (abs(x - c) for p in polyhedron.points for x, c in zip(p, self.centre, strict=True))
        if not (polyhedron.bounded and max(far) <= self.half):
            cut = self._cut(polyhedron.inequalities, polyhedron.equalities)
        return None if cut is None else np.array([self.paper(p) for p in polygon_cycle(cut)])

    def stretch(self, segment: Segment) -> Floats | None:
        """Return the ends of the part of a segment inside, on paper."""
        inequalities = []
        for end, sign in ((segment.start, 1), (segment.end, -1)):
            if end is not None:
                row = [sign * Fraction(x) for x in segment.direction]
                inequalities.append(primitive([*row, -Fraction(dot(row, end))]))
        cut = self._cut(inequalities, [(*segment.normal, segment.constant)])
        if cut is None or len(cut.points) < 2:
            return None
        ends = sorted(cut.points, key=lambda p: Fraction(dot(segment.direction, p)))
        return np.array([self.paper(end) for end in ends])

    def _cut(
        self, inequalities: Iterable[IntegerVector], equalities: Iterable[IntegerVector]
    ) -> Polyhedron | None:
        return from_conditions([*inequalities, *self.rows], equalities, 2)


def joint_window(
    regions: Sequence[Region],
    extra: Iterable[RationalVector] = (),
    half: Fraction | None = None,
    *,
    pieces: bool = False,
) -> Window:
    """Return one square window for several regions.

    It holds the origin and all ends of the regions' boundaries, and it shows a part of every ray.
    Rays and lines through the origin alone have it in the middle.

    Args:
        extra: more points to hold.
        half: this half side instead, about the origin.
        pieces: hold the corners of single pieces too, unless they lie far outside the others.
    """
    if half is not None:
        return Window(ZERO, half)
    needed = [ZERO, *extra, *(end for region in regions for end in ends(region))]
    shapes = [piece.polyhedron for region in regions for piece in region.polygons]
    inner = [p for shape in shapes for p in shape.points]
    reach = 3 * max(_size(p) for p in needed)
    if pieces:
        reach = max(reach, 3 * median([*map(_size, inner), Fraction(0)]))
        needed += [p for p in inner if _size(p) <= reach]
    lows, highs = _box(needed)
    finite = max(high - low for low, high in zip(lows, highs, strict=True)) / 2
    spread = finite or Fraction(1)
    if not finite and all(shape.dimension < 2 for shape in shapes):
        return Window(ZERO, spread)
    for shape in shapes:
        rays = [*shape.rays, *shape.lines, *((-x, -y) for x, y in shape.lines)]
        share = Fraction(1, 5) if finite and shape.dimension == 2 else Fraction(4, 5)
        for ray in rays:
            step = spread * share / max(map(abs, ray))
            held = (p for p in shape.points if _size(p) <= reach)
            needed += [(p[0] + step * ray[0], p[1] + step * ray[1]) for p in held]
    lows, highs = _box(needed)
    spread = max(high - low for low, high in zip(lows, highs, strict=True)) / 2
    centre = tuple((low + high) / 2 for low, high in zip(lows, highs, strict=True))
    return Window(centre, spread * (1 + ROOM) or Fraction(1))


def ends(region: Region) -> Iterator[RationalVector]:
    """Yield the ends of boundary and dangling edges, and the isolated points."""
    for segment in (*region.outline.border, *region.outline.whiskers):
        yield from (end for end in (segment.start, segment.end) if end is not None)
    yield from region.outline.points


def _size(point: RationalVector) -> Fraction:
    return max(map(abs, point))


def _box(points: Sequence[RationalVector]) -> tuple[list[Fraction], list[Fraction]]:
    lows = [min(p[k] for p in points) for k in (0, 1)]
    return lows, [max(p[k] for p in points) for k in (0, 1)]


def clipped(polygon: Floats, normal: Floats, least: float) -> Floats:
    """Return the part of a convex polygon, of any dimension, where ``normal . x >= least``."""
    corners, values = [], polygon @ normal - least
    for k, here in enumerate(values):
        if here * values[k - 1] < 0:
            share = values[k - 1] / (values[k - 1] - here)
            corners.append(polygon[k - 1] + share * (polygon[k] - polygon[k - 1]))
        if here >= 0:
            corners.append(polygon[k])
    return np.array(corners).reshape(-1, polygon.shape[1])
