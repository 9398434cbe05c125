"""Which wrenches of a plane a grasp resists: the exact union of polygons, possibly unbounded.

A point ``(a, b)`` of the plane stands for the wrench ``origin + a first + b second``; by default
the plane has the forces at zero torque about the origin of the object frame.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import count
from typing import Any

from arrangement.console.number_form import ReprMixin
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    dot,
    primitive,
    rational_vector,
    to_text,
)
from arrangement.numbers.linear.intervals import Interval
from arrangement.numbers.linear.polyhedron import Polyhedron
from arrangement.numbers.linear.rank import cross, triple_product
from equilibrium.decide.solver import Solver, prepare
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.plane.states.contact_states import States
from equilibrium.wrench_sets.outline import Outline, outline_of
from equilibrium.wrench_sets.polyhedra import (
    Piece,
    images_of,
    magnitudes_in,
    maximal_pieces,
    states_with,
)

_AXES: tuple[IntegerVector, ...] = ((1, 0), (0, 1), (-1, 0), (0, -1))


@dataclass(frozen=True)
class Sector:
    """The directions from `start` counter-clockwise to `end`.

    With equal ends it is this one direction, or, if the ends do not belong, all but this one.

    Attributes:
        has_start, has_end: whether the ends belong to it.
        whole: whether it is the whole turn; `start` and `end` mean nothing then.
    """

    start: IntegerVector
    end: IntegerVector
    has_start: bool = True
    has_end: bool = True
    whole: bool = False

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        ends = {"start": list(map(to_text, self.start)), "end": list(map(to_text, self.end))}
        flags = {"has_start": self.has_start, "has_end": self.has_end, "whole": self.whole}
        return {**ends, **flags}


def sectors(
    ends: Iterable[IntegerVector], member: Callable[[IntegerVector], bool]
) -> tuple[Sector, ...]:
    """Return the set of directions with a property that changes at most at the given ends.

    Exact: each end and one direction between each two neighbours are asked.
    """
    corners = sorted({*ends, *_AXES}, key=_angle)
    after = [*corners[1:], corners[0]]
    # With the axes among them, neighbours are at most a right angle apart.
    # Stops of even number are corners.
    pairs = zip(corners, after, strict=True)
    stops = [stop for a, b in pairs for stop in (a, (a[0] + b[0], a[1] + b[1]))]
    flags = [member(stop) for stop in stops]
    if all(flags):
        return (Sector((1, 0), (1, 0), whole=True),)
    runs = []
    for first, flag in enumerate(flags):
        if flag and not flags[first - 1]:
            last = next(k for k in count(first) if not flags[(k + 1) % len(flags)]) % len(flags)
            # A run that starts or ends between corners is open.
            open_start, open_end = first % 2, last % 2
            ends_of_run = stops[first - open_start], stops[(last + open_end) % len(stops)]
            runs.append(Sector(*ends_of_run, not open_start, not open_end))
    return tuple(runs)


def _angle(direction: IntegerVector) -> tuple[int, Fraction]:
    """Return the number of the quadrant, and the tangent of the angle in it.

    >>> sorted([(0, -1), (1, 1), (1, 0)], key=_angle)
    [(1, 0), (1, 1), (0, -1)]
    """
    (x, y), quadrant = direction, 0
    while x <= 0 or y < 0:
        x, y, quadrant = y, -x, quadrant + 1
    return quadrant, Fraction(y, x)


FORCES = ((1, 0, 0), (0, 1, 0))


@dataclass(frozen=True, repr=False)
class Region(ReprMixin):
    """The resisted wrenches of a plane.

    Attributes:
        origin, spans: the plane.
        polygons: convex, possibly unbounded or flat; none lies in another single one. Points and
            rays are in plane coordinates.
    """

    origin: RationalVector
    spans: tuple[RationalVector, RationalVector]
    polygons: tuple[Piece, ...]

    def contains(self, point: Iterable[Any]) -> bool:
        """Return whether the wrench at a point of the plane is resisted."""
        return bool(self.states_at(point))

    def states_at(self, point: Iterable[Any]) -> tuple[States, ...]:
        """Return the contact states of all polygons at a point."""
        return states_with(self.polygons, rational_vector(point, "point"))

    def along(self, direction: Iterable[Any]) -> tuple[Interval, ...]:
        """Return the t >= 0 with ``t direction`` in the region, as disjoint closed intervals."""
        u = rational_vector(direction, "direction")
        return magnitudes_in(self.polygons, (Fraction(0),) * 2, u)

    @cached_property
    def outline(self) -> Outline:
        """The exact boundary of the union: there is boundary only where resistance ends."""
        return outline_of([piece.polyhedron for piece in self.polygons])

    @cached_property
    def unlimited(self) -> tuple[Sector, ...]:
        """The directions u for which every ``t u`` with large enough t is resisted.

        This property changes only at the rays and lines of polygons.
        """
        shapes = [piece.polyhedron for piece in self.polygons]
        ends = [ray for shape in shapes for ray in (*shape.rays, *shape.lines)]
        ends += [(-x, -y) for shape in shapes for x, y in shape.lines]
        return sectors(ends, self._is_unlimited)

    def _is_unlimited(self, direction: IntegerVector) -> bool:
        endless = [piece.polyhedron for piece in self.polygons if not piece.polyhedron.bounded]
        parts = (shape.along((0, 0), direction) for shape in endless)
        return any(part is not None and part[1] is None for part in parts)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals, null means unbounded."""
        return {
            "plane": {
                "origin": list(map(to_text, self.origin)),
                "spans": [list(map(to_text, span)) for span in self.spans],
            },
            "polygons": [
                {
                    **piece.to_dict(),
                    "points": [list(map(to_text, p)) for p in polygon_cycle(piece.polyhedron)],
                }
                for piece in self.polygons
            ],
            "outline": self.outline.to_dict(),
            "unlimited": [sector.to_dict() for sector in self.unlimited],
        }


def resisted_region(
    grasp: Grasp | Solver,
    spans: Sequence[Iterable[Any]] = FORCES,
    origin: Iterable[Any] = (0, 0, 0),
) -> Region:
    """Return the exact set of resisted wrenches ``origin + a spans[0] + b spans[1]``.

    Raises:
        GraspError: not two spans, or parallel ones.

    Source: [HaasHeger2018], the maps of resisted forces without and with preload, exactly.

    >>> from equilibrium import read_grasp
    >>> region = resisted_region(read_grasp("paper-three-contacts"))
    >>> [sector.to_dict()["start"] for sector in region.unlimited]
    [['-1', '0']]
    """
    solver = prepare(grasp)
    return region_of(lambda plane: images_of(solver, plane), spans, origin)


def region_of(
    shapes: Callable[[IntegerVector], Iterable[tuple[States, Polyhedron | None]]],
    spans: Sequence[Iterable[Any]],
    origin: Iterable[Any],
) -> Region:
    """Return what a plane cuts out of polyhedra of wrenches.

    Args:
        shapes: gives them, with their contact states, for ``(a, b)`` with ``a . w + b = 0`` in the
            plane.
    """
    frame = [read_wrench(span) for span in spans]
    start = read_wrench(origin)
    if len(frame) != 2 or not any(normal := cross(*frame)):
        raise GraspError("a plane needs two spanning wrenches that are not parallel")
    images = shapes(primitive((*normal, -dot(normal, start))))
    cuts = ((states, shape.cut(start, frame)) for states, shape in images if shape is not None)
    polygons = [Piece(states, shape) for states, shape in cuts if shape is not None]
    return Region(start, (frame[0], frame[1]), maximal_pieces(polygons))


def polygon_cycle(polygon: Polyhedron) -> tuple[RationalVector, ...]:
    """Return the vertices of a polygon counter-clockwise, the lowest one last.

    Those of an unbounded one are listed from end to end.
    """
    if polygon.dimension < 2 or polygon.lines:
        return polygon.points
    rows, around = polygon.homogeneous[0], list(polygon.cycle())
    if triple_product(*(rows[j] for j in around[:3])) < 0:
        around.reverse()
    corners = [polygon.points[j] for j in around if rows[j][-1]]
    if polygon.bounded:
        lowest = corners.index(min(corners, key=lambda p: p[::-1]))
        corners = [*corners[lowest + 1 :], *corners[: lowest + 1]]
    return tuple(corners)
