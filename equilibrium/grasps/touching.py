"""Assemblies from polygons that touch: bodies, and the ground if there is one.

Where two polygons have part of an edge in common there are two contacts, at its ends, else one
where a corner of either lies inside an edge of the other. A corner that only meets a corner is no
contact: it has no normal. Where the boundary is straight there is no corner, whatever is listed.
Overlaps are refused. All is exact.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any, NamedTuple

from arrangement.numbers.exact import RationalVector, dot, rational, vector_text
from arrangement.numbers.linear.rank import cycle_edges, difference
from equilibrium.model.assembly import Assembly, BodyContact, RigidBody
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.outline import Polygon
from equilibrium.model.unit_normal import unit_normal

from .inputs.polygon import is_straight, orientation, place_on_segment, turn

#: An edge, the inside of the polygon to its left.
_Edge = tuple[RationalVector, RationalVector]


class _NamedPolygon(NamedTuple):
    """A polygon, counter-clockwise; of the ground without a name."""

    name: str | None
    corners: tuple[RationalVector, ...]

    @property
    def edges(self) -> list[_Edge]:
        return list(cycle_edges(self.corners))

    @property
    def words(self) -> str:
        return self.name or "the ground"


def touching_polygons(
    polygons: Mapping[str, Any],
    friction: Any,
    *,
    ground: Iterable[Any] = (),
    stiffness: Any = None,
    preload: Any = 0,
    density: Any = 0,
    angle_tolerance: Any = None,
) -> Assembly:
    """Return the assembly of polygons that touch; see `Assembly.from_polygons`.

    Args:
        polygons: corners of each body by name, in either orientation.
        friction, stiffness, preload: of all contacts; a stiffness that is not given is 1.
        ground: corners of each polygon of the ground.
        density: weight of a unit of area; 0: bodies have no weight.
        angle_tolerance: the normal of an edge whose length is not rational is the nearest simple
            one within this; None: such an edge is refused where it touches.

    Raises:
        GraspError: overlaps, or no exact normal.
    """
    heavy = rational(density, "density")
    shapes = [_shape(name, corners) for name, corners in polygons.items()]
    shapes += [_shape(None, corners) for corners in ground]
    bodies = []
    for shape in shapes:
        if shape.name is not None:
            area = sum((turn(a, b) for a, b in shape.edges), Fraction(0)) / 2
            bodies.append(RigidBody(shape.name, Polygon(shape.corners), heavy * area))
    values = {"preload": preload} | ({} if stiffness is None else {"stiffness": stiffness})
    contacts = []
    for one, other in combinations(shapes, 2):
        if one.name is None or _are_apart(one, other):
            continue
        _refuse_overlap(one, other)
        for point, (start, end) in _touches(one, other):
            along = difference(end, start)
            normal = _unit((along[1], -along[0]), one, other, angle_tolerance)
            contact = Contact(point, normal, friction, **values)
            contacts.append(BodyContact(one.name, other.name, contact))
    return Assembly(bodies, contacts)


def _shape(name: str | None, given: Iterable[Iterable[Any]]) -> _NamedPolygon:
    found = Polygon(given).corners
    try:
        turned = orientation(found)
    except GraspError as error:
        raise GraspError(f"{name or 'the ground'}: {error}") from None
    corners = tuple(x for i, x in enumerate(found) if not is_straight(found, i))
    return _NamedPolygon(name, corners if turned > 0 else corners[::-1])


def _are_apart(one: _NamedPolygon, other: _NamedPolygon) -> bool:
    """Return whether the boxes around two polygons have no point in common."""
    pairs = zip(zip(*one.corners, strict=True), zip(*other.corners, strict=True), strict=True)
    return any(max(a) < min(b) or max(b) < min(a) for a, b in pairs)


def _touches(one: _NamedPolygon, other: _NamedPolygon) -> Iterator[tuple[RationalVector, _Edge]]:
    """Yield points of contact, each with an edge that has the second polygon to its left."""
    shared: set[RationalVector] = set()
    for edge in other.edges:
        for mine in one.edges:
            ends = _common(edge, mine)
            if len(ends) == 2:
                shared |= {*ends}
                yield from ((point, edge) for point in ends)
    for edge in other.edges:
        yield from ((p, edge) for p in one.corners if p not in shared and _inside(p, edge))
    for start, end in one.edges:
        # Turned round it has the second polygon to its left.
        found = (p for p in other.corners if p not in shared and _inside(p, (start, end)))
        yield from ((p, (end, start)) for p in found)


def _common(edge: _Edge, mine: _Edge) -> list[RationalVector]:
    """Return the ends of what two edges have in common, two if both lie on one line."""
    ends = [p for p in mine if place_on_segment(*edge, p) is not None]
    ends += [p for p in edge if place_on_segment(*mine, p) is not None]
    return list(dict.fromkeys(ends))


def _inside(point: RationalVector, edge: _Edge) -> bool:
    """Return whether a point lies on an edge and is not one of its ends."""
    return point not in edge and place_on_segment(*edge, point) is not None


def _refuse_overlap(one: _NamedPolygon, other: _NamedPolygon) -> None:
    """Refuse polygons whose insides meet.

    They do where the edge of one runs inside the other, or two edges run the same way: the inside
    is to the left of both.
    """
    for shape, second in ((one, other), (other, one)):
        for edge in shape.edges:
            for start, end in _pieces(edge, second):
                middle = tuple((x + y) / 2 for x, y in zip(start, end, strict=True))
                if _is_within(middle, edge, second):
                    raise GraspError(
                        f"{one.words} and {other.words} overlap at {vector_text(middle)}; expected "
                        "polygons that touch at most"
                    )


def _pieces(edge: _Edge, shape: _NamedPolygon) -> Iterator[_Edge]:
    """Yield the parts of an edge between the places where it meets the edges of a polygon.

    Where it runs along one of these, it meets another one at each of the ends.
    """
    start, end = edge
    along = difference(end, start)
    places = {Fraction(0), Fraction(1)}
    for a, b in shape.edges:
        across = difference(b, a)
        if slope := turn(along, across):
            s = turn(difference(a, start), across) / slope
            t = turn(difference(a, start), along) / slope
            places |= {s} if 0 <= s <= 1 and 0 <= t <= 1 else set()
    ordered = [tuple(x + s * y for x, y in zip(start, along, strict=True)) for s in sorted(places)]
    yield from pairwise(ordered)


def _is_within(point: RationalVector, edge: _Edge, shape: _NamedPolygon) -> bool:
    """Return whether a point of an edge is inside a polygon, or on an edge that runs the same way.

    Counts how often the ray from the point to the right crosses the boundary.
    """
    crossings = 0
    for a, b in shape.edges:
        if place_on_segment(a, b, point) is not None:
            along, mine = difference(b, a), difference(edge[1], edge[0])
            return bool(dot(along, mine) > 0)
        if (a[1] > point[1]) != (b[1] > point[1]):
            lower, upper = (a, b) if a[1] < b[1] else (b, a)
            crossings += turn(difference(upper, lower), difference(point, lower)) > 0
    return crossings % 2 == 1


def _unit(
    direction: RationalVector, one: _NamedPolygon, other: _NamedPolygon, tolerance: Any
) -> RationalVector:
    """Return the exact unit normal along a direction, or one near it."""
    found = unit_normal(direction, "1/1000" if tolerance is None else tolerance)
    if found.angle_error and tolerance is None:
        raise GraspError(
            f"the normal between {one.words} and {other.words} is along {vector_text(direction)}, "
            "whose length is not rational; give angle_tolerance to take one near it"
        )
    return found.normal
