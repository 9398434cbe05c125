"""The smallest wrench, and the least force at a point, that a grasp does not resist, exactly.

The resisted wrenches are finitely many closed convex polyhedra. Those without volume have wrenches
that are not resisted next to all of theirs, so what counts is how far the boundary of the union of
the others is. A generic point of a facet is on this boundary exactly when no polyhedron has it and
points right behind it. So each facet is a polygon, and the nearest polygon of all is looked at: a
polyhedron that has its nearest point and reaches behind it is taken away from it, which leaves
smaller polygons. Where there is none the nearest point is the answer; where no polygon is left,
every wrench is resisted. No polygon loses the same polyhedron twice, so this ends: see "Proofs" in
the documentation.

The forces at one point are a plane of wrenches, in which the resisted ones are a union of polygons.
Along a direction resistance ends where the ray leaves them: at an edge of their outline that has
the load on its inner side. So the least of these forces is the nearest point of all these edges.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from heapq import heappop, heappush
from itertools import combinations, count
from math import atan2, degrees, isqrt
from typing import TYPE_CHECKING, Any, NamedTuple

from arrangement.console.number_form import JsonMixin
from arrangement.console.progress import watched
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    dot,
    primitive,
    rational,
    rational_vector,
    shown,
    simplest_between,
)
from arrangement.numbers.linear.cones import Cone
from arrangement.numbers.linear.polyhedron import Polyhedron
from arrangement.numbers.linear.rank import difference
from equilibrium.core.contact_rows import negated, sum_row
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import read_wrench
from equilibrium.wrench_sets.outline import Segment, outer_facets, polygons_near
from equilibrium.wrench_sets.polyhedra import Piece, states_with
from equilibrium.wrench_sets.separation import both_ways

if TYPE_CHECKING:
    from equilibrium.wrench_sets.resisted_set import ResistedSet
    from equilibrium.wrench_sets.slice import Region

#: How far what is not resisted, `beyond`, is from the boundary at most, as a share of the size.
_BEYOND = Fraction(1, 1000)


@dataclass(frozen=True, repr=False)
class SmallestUnresisted(JsonMixin):
    """How small a wrench that is added to a load may be without being resisted.

    Attributes:
        base: the load.
        length: that torques are divided by: the squared size of a wrench is ``f_x^2 + f_y^2 +
            (tau / length)^2``.
        size_squared: every smaller wrench is resisted, and of none larger is this true; None if all
            wrenches are resisted. It is 0 where the load is not resisted, or is on the boundary.
        wrench: one of this size on the boundary, so itself resisted, unless the load is not; None
            if all are.
        beyond: one that is not resisted, `solve` proves it; from `wrench` it is away by at most a
            thousandth of the size (of 1, if the size is 0).
    """

    json_fields = ("base", "length", "size_squared", "wrench", "beyond")

    base: RationalVector
    length: Fraction
    size_squared: Fraction | None
    wrench: RationalVector | None
    beyond: RationalVector | None

    @property
    def size(self) -> Fraction | None:
        """The root of `size_squared`: exact where it is rational, else 64 bits of it."""
        return None if self.size_squared is None else root(self.size_squared)


def smallest_unresisted_wrench(
    whole: ResistedSet, base: Iterable[Any] = (0, 0, 0), torque_length: Any = 1
) -> SmallestUnresisted:
    """Return how small a wrench may be without being resisted; see `ResistedSet.smallest_outside`.

    Complexity: the polyhedra of the set, then O(n^2) rounded tests of whether one of n polyhedra is
    near a facet of another one, and exact cuts of the facets that are nearer than the answer.
    """
    if whole.grasp.dimension == 3:
        raise GraspError(
            "in space there is no proof for a whole ball of wrenches; decide one direction after "
            "the other (`ResistedSet.along`)"
        )
    sizes = _Sizes(read_wrench(base), rational(torque_length, "torque_length"))
    if sizes.length <= 0:
        raise GraspError(f"torque_length is {shown(sizes.length)}; it must be above 0")
    pieces = whole.polyhedra
    solids = [p.polyhedron for p in pieces if p.polyhedron.dimension == 3]
    part, square = None, Fraction(0)
    if any(solid.contains(sizes.base) for solid in solids):
        part = _nearest_border(solids, sizes)
        if part is None:
            return SmallestUnresisted(*sizes, None, None, None)
        square = sizes.square(part.nearest)
    end = sizes.base if part is None else part.nearest
    beyond = _beyond(pieces, part, sizes, _BEYOND * (root(square) or 1))
    added = (difference(load, sizes.base) for load in (end, beyond))
    return SmallestUnresisted(*sizes, square, *added)


_ORIGIN: RationalVector = (Fraction(0),) * 3
_NO_FORCE: RationalVector = (Fraction(0), Fraction(0))
_AXES = tuple(tuple(Fraction(i == j) for j in range(3)) for i in range(3))


def root(square: Fraction) -> Fraction:
    """Return a root to 64 bits, rounded down; exact where it is rational."""
    top, bottom = square.as_integer_ratio()
    return Fraction(isqrt(top * bottom << 128), bottom << 64)


class _Sizes(NamedTuple):
    """How loads are compared: by what they add to a base, torques divided by a length."""

    base: RationalVector
    length: Fraction

    def product(self, left: RationalVector, right: RationalVector) -> Fraction:
        x, y, torque = (a * b for a, b in zip(left, right, strict=True))
        return x + y + torque / self.length**2

    def square(self, load: RationalVector) -> Fraction:
        added = difference(load, self.base)
        return self.product(added, added)

    def foot(self, row: IntegerVector) -> RationalVector:
        """Return the nearest point of a plane."""
        steepest = (Fraction(row[0]), Fraction(row[1]), row[2] * self.length**2)
        height = Fraction(dot(row, (*self.base, 1))) / dot(row[:3], steepest)
        return sum_row(self.base, steepest, -height)

    def nearest(self, generators: Sequence[IntegerVector]) -> RationalVector:
        """Return the nearest point of all segments and rays between homogeneous generators."""
        points = []
        for first, second in combinations(sorted(generators, key=lambda x: -x[3]), 2):
            if first[3]:
                start, end = (tuple(Fraction(x, v[3] or 1) for x in v[:3]) for v in (first, second))
                step = difference(end, start) if second[3] else end
                away = difference(self.base, start)
                share = max(self.product(away, step) / self.product(step, step), Fraction(0))
                points.append(sum_row(start, step, min(share, Fraction(1)) if second[3] else share))
        return min(points, key=self.square)


class _FacetPart(NamedTuple):
    """A convex polygon in a facet.

    Attributes:
        row: the condition of the facet.
        cone: the polygon, homogeneous.
        nearest: its point nearest to the base.
        others: polyhedra that may cover some of it.
    """

    row: IntegerVector
    cone: Cone
    nearest: RationalVector
    others: list[Polyhedron]

    def covering(self) -> Polyhedron | None:
        """Return a polyhedron with the nearest point that reaches behind; the widest of several."""
        point, corners = primitive((*self.nearest, Fraction(1))), _generators(self.cone)

        def left(shape: Polyhedron) -> int:
            return sum(any(dot(row, x) < 0 for row in shape.inequalities) for x in corners)

        holding = (
            shape
            for shape in self.others
            if all(dot(row, point) >= 0 for row in shape.inequalities)
            and any(dot(self.row, x) < 0 for x in both_ways(*shape.homogeneous))
        )
        return min(holding, default=None, key=left)

    def without(self, shape: Polyhedron, sizes: _Sizes) -> list[_FacetPart]:
        """Return what a polyhedron with the nearest point leaves, in parts without overlaps."""
        others = [other for other in self.others if other is not shape]
        rest, parts = self.cone, []
        for row in shape.inequalities:
            values = [dot(row, x) for x in _generators(rest)]
            if min(values) >= 0:
                continue
            if max(values) <= 0:
                return [self._replace(others=others)]
            outer, rest = rest.copy(), rest.copy()
            outer.cut(negated(row), keep_positive=True)
            rest.cut(row, keep_positive=True)
            nearest = self.nearest
            if dot(row, (*nearest, 1)):
                nearest = sizes.nearest([x for x in _generators(outer) if dot(row, x) == 0])
            parts.append(_FacetPart(self.row, outer, nearest, others))
        return parts


def _nearest_border(solids: Sequence[Polyhedron], sizes: _Sizes) -> _FacetPart | None:
    """Return the part of the boundary of a union nearest to a base in it; None without boundary."""
    alone = [(row, [solid]) for row, shapes in outer_facets(solids) for solid in shapes]
    around = zip(alone, polygons_near(alone, solids), strict=True)
    parts = [_facet(row, solid, others, sizes) for (row, (solid,)), others in around]
    waiting: list[tuple[Fraction, int, _FacetPart]] = []
    order = count()

    def nearest_first() -> Iterator[_FacetPart]:
        while parts or waiting:
            for part in parts:
                heappush(waiting, (sizes.square(part.nearest), next(order), part))
            parts.clear()
            yield heappop(waiting)[-1]

    for part in watched(nearest_first(), "parts of facets"):
        shape = part.covering()
        if shape is None:
            return part
        parts += part.without(shape, sizes)
    return None


def _facet(
    row: IntegerVector, solid: Polyhedron, others: list[Polyhedron], sizes: _Sizes
) -> _FacetPart:
    cone = Cone(4)
    cone.cut((0, 0, 0, 1), keep_positive=True)
    cone.cut(row, keep_positive=False)
    for other in solid.inequalities:
        if other != row:
            cone.cut(other, keep_positive=True)
    foot, corners = sizes.foot(row), _generators(cone)
    at = primitive((*foot, Fraction(1)))
    # Where the foot is outside, the nearest point is on an edge that has it on its other side.
    beside = (other for other in solid.inequalities if dot(other, at) < 0)
    edges = ([x for x in corners if dot(other, x) == 0] for other in beside)
    ends = (sizes.nearest(edge) for edge in edges if len(edge) > 1 and any(x[3] for x in edge))
    nearest = min(ends, default=foot, key=sizes.square)
    return _FacetPart(row, cone, nearest, others)


def _generators(cone: Cone) -> list[IntegerVector]:
    return both_ways((ray for ray, _ in cone.rays), cone.lines)


def _beyond(
    pieces: Sequence[Piece], part: _FacetPart | None, sizes: _Sizes, reach: Fraction
) -> RationalVector:
    """Return a load that is not resisted, near the nearest point of a part of the boundary.

    In the loads of `unresisted_near` p is the nearest point, u leads into the polygon (anywhere,
    without a part), v in front of its facet. The sign of each
    condition of a polyhedron is the same at all of them from some k on: that at p if it is not 0,
    else that along u, which is chosen so that it is not 0 either, or the condition's plane is that
    of the polygon. So a polyhedron has all later loads or none, and "Proofs" in the documentation
    shows that none has them.

    Args:
        part: None where the base is in no polyhedron with volume: it is the nearest point then.
        reach: the distance from the nearest point, at most.
    """
    if part is None:
        end, inward = sizes.base, _ORIGIN
        corners = [primitive((*sum_row(end, axis, 1), Fraction(1))) for axis in _AXES]
    else:
        end, inward = part.nearest, tuple(map(Fraction, part.row[:3]))
        corners = _generators(part.cone)
    if not states_with(pieces, end):
        return end
    inner = _generic(end, corners, [piece.polyhedron for piece in pieces])

    def is_resisted(load: RationalVector) -> bool:
        """Return whether a load is resisted, or too far away."""
        away = difference(load, end)
        return sizes.product(away, away) > reach**2 or bool(states_with(pieces, load))

    return unresisted_near(end, _short(difference(inner, end)), _short(inward), reach, is_resisted)


def unresisted_near(
    end: RationalVector,
    u: Sequence[Any],
    v: Sequence[Any],
    reach: Fraction,
    is_resisted: Callable[[RationalVector], bool],
) -> RationalVector:
    """Return the first of the loads ``p + f/2^k (u - v/2^k)`` that is not resisted, rounded or not.

    Args:
        end: p, a load at the boundary.
        u, v: such that infinitely many of the loads are not resisted.
        reach: f.
    """
    for k in count(1):
        far = reach / 2**k
        exact = tuple(x + far * (a - Fraction(b) / 2**k) for x, a, b in zip(end, u, v, strict=True))
        room = far / 4**k
        for load in (tuple(simplest_between(x - room, x + room) for x in exact), exact):
            if not is_resisted(load):
                return load
    raise AssertionError  # some load is not


def _generic(
    end: RationalVector, corners: Sequence[IntegerVector], shapes: Iterable[Polyhedron]
) -> RationalVector:
    """Return a point between generators that is in no plane at a point but in those of all of them.

    On the curve of the points with weights ``1, k, k^2, ...`` a plane has fewer than there are
    generators, or all, as its row is a polynomial in k. So a wrong k is followed by a right one.
    """
    at = primitive((*end, Fraction(1)))
    planes = [
        row
        for row in {row for shape in shapes for row in (*shape.inequalities, *shape.equalities)}
        if dot(row, at) == 0 and any(dot(row, corner) for corner in corners)
    ]
    for k in range(1, len(planes) * len(corners) + 2):
        point = tuple(sum(k**i * x[j] for i, x in enumerate(corners)) for j in range(4))
        if all(dot(row, point) for row in planes):
            return tuple(Fraction(x, point[3]) for x in point[:3])
    raise AssertionError  # each plane has fewer points of the curve than there are corners


def _short(vector: RationalVector) -> RationalVector:
    """Return the multiple with entries of at most 1 in size; zeros stay."""
    largest = max(abs(x) for x in vector) or 1
    return tuple(x / largest for x in vector)


@dataclass(frozen=True, repr=False)
class BestDirection(JsonMixin):
    """The least forces that move an object, and that hold it.

    Attributes:
        base: the load that acts in any case.
        point: where the force acts.
        moving: the least force (f_x, f_y) at which resistance ends as it grows; it is itself
            resisted. None if no force in any direction ends it.
        beyond: one that is not resisted, `solve` proves it; from `moving` it is away by at most a
            thousandth of its size (of 1, if that is 0).
        holding: where the load alone is not resisted, the least force with which it is; None if
            there is none.
    """

    json_fields = ("base", "point", "moving", "size_squared", "degrees", "beyond", "holding")

    base: RationalVector
    point: RationalVector
    moving: RationalVector | None
    beyond: RationalVector | None
    holding: RationalVector | None

    @property
    def size_squared(self) -> Fraction | None:
        """The square of the size of `moving`."""
        return None if self.moving is None else dot(self.moving, self.moving)

    @property
    def size(self) -> Fraction | None:
        """The root of `size_squared`: exact where it is rational, else 64 bits of it."""
        return None if self.size_squared is None else root(self.size_squared)

    @property
    def degrees(self) -> float | None:
        """The angle of `moving` from the x axis, rounded."""
        return None if not self.size_squared else angle(self.moving)


def angle(force: RationalVector | None) -> float:
    """Return the direction of a force in degrees, from the x axis, rounded."""
    assert force is not None
    return degrees(atan2(*map(float, reversed(force))))


def best_direction(
    whole: ResistedSet, base: Iterable[Any] = (0, 0, 0), point: Iterable[Any] = (0, 0)
) -> BestDirection:
    """Return the least force at a point that ends resistance; see `ResistedSet.best_direction`.

    Forces that are resisted in one direction alone, next to others that are not, do not count.

    >>> from equilibrium import Contact, Grasp, ResistedSet
    >>> block = Grasp([Contact([x, 0], [0, 1], "3/4") for x in (-3, 3)])
    >>> best_direction(ResistedSet(block), [0, -5, 0]).size  # 5 sin(atan 3/4)
    Fraction(3, 1)
    """
    load = read_wrench(base)
    place = rational_vector(point, "point")
    if len(place) != 2:
        raise GraspError(f"point has {len(place)} coordinates; expected 2")
    x, y = place
    region = whole.slice((1, 0, -y), (0, 1, x), load)
    outline, is_held = region.outline, region.contains(_NO_FORCE)
    ends = [edge for edge in outline.border if edge.constant > 0 or (is_held and not edge.constant)]
    solid = (p.polyhedron for p in region.polygons if p.polyhedron.dimension == 2)
    moving = beyond = holding = None
    if is_held and not any(polygon.contains(_NO_FORCE) for polygon in solid):
        moving, beyond = _NO_FORCE, _beyond_edge(region, _NO_FORCE, None)
    elif ends:
        nearest = ((_nearest(edge), edge) for edge in ends)
        moving, edge = min(nearest, key=lambda pair: dot(pair[0], pair[0]))
        beyond = _beyond_edge(region, moving, edge)
    if not is_held:
        parts = [_nearest(edge) for edge in (*outline.border, *outline.whiskers)]
        holding = min([*parts, *outline.points], default=None, key=lambda x: dot(x, x))
    return BestDirection(load, place, moving, beyond, holding)


def _nearest(edge: Segment) -> RationalVector:
    """Return the point of a part of a line that is nearest to the origin."""
    along, ends = edge.direction, (edge.start, edge.end)
    square = dot(along, along)
    foot = tuple(Fraction(-edge.constant * x, square) for x in edge.normal)
    low, high = (None if end is None else dot(end, along) for end in ends)
    if low is not None and low > 0:
        return edge.start  # type: ignore[return-value]
    return edge.end if high is not None and high < 0 else foot  # type: ignore[return-value]


def _beyond_edge(region: Region, end: RationalVector, edge: Segment | None) -> RationalVector:
    """Return a force that is not resisted, near an end of the resisted ones on an edge.

    In those of `unresisted_near` p is the end, u leads along the edge, v to its inner side. A
    polygon with infinitely many of them has p, and covers the outer side of the edge there, or it
    is flat; but a line has two of them at most. So one is in no polygon.

    Args:
        edge: None where no polygon with area has the end.
    """
    u, v = ((1, 0), (0, 1)) if edge is None else (edge.direction, edge.normal)
    if edge is not None and end == edge.end:
        u = (-u[0], -u[1])
    reach = _BEYOND * (root(dot(end, end)) or 1) / 2 / sum(map(abs, u))
    return unresisted_near(end, u, v, reach, region.contains)
