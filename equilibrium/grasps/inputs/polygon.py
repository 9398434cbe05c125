"""Contacts on a polygon or a circle."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from numbers import Integral
from typing import Any, NamedTuple, TypeAlias

from arrangement.library.files.json_files import Source, check_keys, check_list, read_document
from arrangement.numbers.arguments import at_least, entries
from arrangement.numbers.exact import (
    RationalVector,
    dot,
    from_float,
    rational,
    rational_vector,
    shown,
    sign,
)
from arrangement.numbers.linear.rank import cycle_edges, difference
from equilibrium.model.contact import VALUES
from equilibrium.model.errors import GraspError
from equilibrium.model.outline import Circle, Polygon, coordinates

from .conversion import (
    DEFAULT_TOLERANCE,
    Conversion,
    assembled,
    contact_values,
    direction_of,
    unit_normals,
    value_columns,
)
from .incidences import converted, rounding


def on_circle(
    angles: int | Iterable[float],
    friction: Any,
    *,
    radius: Any = 1,
    centre: Iterable[Any] = (0, 0),
    stiffness: Any = None,
    preload: Any = 0,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
) -> Conversion:
    """Return contacts on a circle, which is the outline, with normals to its centre.

    Each contact is a rational point of the circle near the wanted angle, and lies on the circle
    exactly. `point_errors` bound how far it is from the wanted place, up to the rounding of the
    sine and cosine (about 10^-16 of the radius).

    Args:
        angles: degrees, counter-clockwise from the x axis; or a number m of contacts, evenly
            spread from angle 0.
        friction, stiffness, preload: one for all or one for each contact; a stiffness that is
            not given is 1.
        radius: above 0.
        centre: of the circle.

    >>> [c.normal for c in on_circle(2, 1).grasp]
    [(Fraction(-1, 1), Fraction(0, 1)), (Fraction(1, 1), Fraction(0, 1))]
    """
    if isinstance(angles, Integral):
        m = at_least(angles, 0, "angles")
        wanted = [360 * i / m for i in range(m)]
    else:
        wanted = [_degrees(x, f"angle {i + 1}") for i, x in enumerate(entries(angles, "angles"))]
    size, middle = rational(radius, "radius"), rational_vector(centre, "centre")
    if size <= 0 or len(middle) != 2:
        raise GraspError(
            f"radius is {shown(size)}, it must be above 0; a centre has two coordinates"
        )
    inward = unit_normals(
        [tuple(-x for x in direction_of(Fraction(angle))) for angle in wanted], angle_tolerance
    )
    points = [
        tuple(c - size * n for c, n in zip(middle, normal, strict=True)) for normal, _ in inward
    ]
    errors = [size * abs(error) for _, error in inward]
    values = contact_values(len(points), friction, stiffness, preload)
    return assembled(points, errors, inward, values, outline=Circle(middle, size))


def _degrees(value: Any, name: str) -> float:
    try:
        return float(from_float(value, name))
    except OverflowError:
        raise GraspError(f"{name} is {shown(value)}; give degrees that a float holds") from None


#: Two points.
Segment: TypeAlias = tuple[RationalVector, RationalVector]


class OnEdge(NamedTuple):
    """A place on a polygon: the point ``(1 - at) vertices[edge] + at vertices[edge + 1]``.

    Attributes:
        edge: 0 for the edge from vertex 0 to vertex 1.
        at: from 0 to 1.
    """

    edge: int
    at: Any


def from_polygon(
    vertices: Iterable[Iterable[Any]],
    places: Iterable[OnEdge | Iterable[Any]],
    friction: Any,
    *,
    stiffness: Any = None,
    preload: Any = 0,
    adhesion: Any = 0,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
    tolerance: Any = DEFAULT_TOLERANCE,
    as_given: bool = False,
) -> Conversion:
    """Return contacts on a simple polygon, which is the outline; the object is its inside.

    Args:
        vertices: at least three corners in either orientation, exact (see `from_floats`).
        places: for each contact an `OnEdge`, or its coordinates, which must lie exactly on the
            boundary and not in a corner (in one where the boundary is straight they may).
        friction, stiffness, preload, adhesion: one for all or one for each contact; a stiffness
            that is not given is 1.
        angle_tolerance: an edge whose length is not rational has no exactly unit rational normal;
            the nearest simple one within this is taken and the error reported.
        tolerance, as_given: as in `read_csv`, where normals are rounded.

    Raises:
        GraspError: the polygon crosses or touches itself or has no area; a contact is off the
            boundary, or in a corner and without an edge.

    >>> triangle = [[0, 0], [4, 0], [0, 3]]
    >>> from_polygon(triangle, [OnEdge(1, "1/2")], 1).grasp.contacts[0].normal
    (Fraction(-3, 5), Fraction(-4, 5))
    """
    listed = entries(vertices, "vertices", "points")
    corners = [coordinates(v, f"vertices[{i}]", 2) for i, v in enumerate(listed)]
    inside = orientation(corners)
    on_edges = [
        _placed(corners, place, i) if isinstance(place, OnEdge) else _located(corners, place, i)
        for i, place in enumerate(entries(places, "places", "places"))
    ]
    directions = []
    for edge, _ in on_edges:
        along = difference(corners[(edge + 1) % len(corners)], corners[edge])
        directions.append((-inside * along[1], inside * along[0]))
    return converted(
        [point for _, point in on_edges],
        directions,
        contact_values(len(on_edges), friction, stiffness, preload, adhesion),
        rounding(0, tolerance, angle_tolerance, as_given),
        outline=Polygon(corners),
    )


def orientation(corners: Sequence[RationalVector]) -> int:
    """Return 1 for a counter-clockwise simple polygon, -1 for a clockwise one.

    Raises:
        GraspError: fewer than three corners, or the boundary meets itself.
    """
    n = len(corners)
    if n < 3:
        raise GraspError(f"a polygon has at least three corners; {n} are given")
    if all(is_straight(corners, i) for i in range(n)):
        raise GraspError("the corners of the polygon lie on one line; give three that do not")
    for i in range(n):
        for j in range(i + 1, n):
            if _clash(corners, i, j):
                raise GraspError(
                    f"edges {i} and {j} of the polygon meet outside a common corner; "
                    "list the corners of a simple polygon in order"
                )
    area = sum(turn(a, b) for a, b in cycle_edges(corners))
    return sign(area)


def is_straight(corners: Sequence[RationalVector], i: int) -> bool:
    """Return whether a corner of a simple polygon lies in the middle of a straight edge."""
    before, at, after = corners[i - 1], corners[i], corners[(i + 1) % len(corners)]
    return turn(difference(at, before), difference(after, at)) == 0


def _clash(corners: Sequence[RationalVector], i: int, j: int) -> bool:
    """Return whether two edges, i < j, share more than the corner that neighbours share."""
    n = len(corners)
    (a, b), (c, d) = first, second = [(corners[k], corners[(k + 1) % n]) for k in (i, j)]
    if a == b or c == d:
        return True
    if j - i in (1, n - 1):
        before, shared, after = (a, b, d) if j == i + 1 else (c, a, b)
        ahead, back = difference(after, shared), difference(before, shared)
        return turn(ahead, back) == 0 and bool(dot(ahead, back) > 0)
    places = ((first, c), (first, d), (second, a), (second, b))
    return do_cross(first, second) or any(is_on(edge, end) for edge, end in places)


def do_cross(first: Segment, second: Segment) -> bool:
    """Return whether segments cross in a point that is no end of either."""
    return all(
        sign(side(line, start)) * sign(side(line, end)) < 0
        for line, (start, end) in ((first, second), (second, first))
    )


def is_on(edge: Segment, point: RationalVector) -> bool:
    """Return whether a point lies on a segment, maybe at an end."""
    return side(edge, point) == 0 and bool(dot(*(difference(end, point) for end in edge)) <= 0)


def side(edge: Segment, point: RationalVector) -> Fraction:
    """Return a number above 0 where a point is left of an edge, 0 where it is on its line."""
    (a, b), (c, d), (x, y) = *edge, point
    return (a - x) * (d - y) - (b - y) * (c - x)


def _located(
    corners: Sequence[RationalVector], place: Iterable[Any], index: int
) -> tuple[int, RationalVector]:
    """Return the edge that a point lies on."""
    point = rational_vector(place, f"places[{index}]")
    if len(point) != 2:
        raise GraspError(f"places[{index}] has {len(point)} coordinates; give two, or an OnEdge")
    if point in corners and not is_straight(corners, corners.index(point)):
        raise GraspError(
            f"places[{index}] is corner {corners.index(point)}, where two normals meet; "
            "name the edge with OnEdge(edge, at)"
        )
    for i, edge in enumerate(cycle_edges(corners)):
        if is_on(edge, point):
            return i, point
    raise GraspError(f"places[{index}] is not on the boundary; name the edge with OnEdge(edge, at)")


def _placed(
    corners: Sequence[RationalVector], place: OnEdge, index: int
) -> tuple[int, RationalVector]:
    edge, s = place.edge, rational(place.at, f"places[{index}].at")
    if type(edge) is not int or not 0 <= edge < len(corners):
        raise GraspError(f"places[{index}].edge is {edge!r}; edges are 0 to {len(corners) - 1}")
    if not 0 <= s <= 1:
        raise GraspError(f"places[{index}].at is {shown(s)}; it must be from 0 to 1")
    start, end = corners[edge], corners[(edge + 1) % len(corners)]
    return edge, tuple(x + s * (y - x) for x, y in zip(start, end, strict=True))


def turn(a: RationalVector, b: RationalVector) -> Fraction:
    """Return the cross product, above 0 where b is to the left of a."""
    return a[0] * b[1] - a[1] * b[0]


def read_polygon(source: Source, **options: Any) -> Conversion:
    """Read contacts on a polygon from a JSON document.

    The form is ``{"schema_version": 1, "polygon": [["0","0"], ...], "places": [{"edge": 0, "at":
    "1/2", "friction": "1/2"}, {"point": ["2","0"], "friction": "1/2", "preload": "1"}]}``.

    Args:
        source: a path, a file or a mapping.
        options: of `from_polygon`, as ``angle_tolerance``.

    Raises:
        InputError: for anything else.
    """
    document = read_document(source, ("polygon",))
    check_keys(document, ("schema_version", "polygon", "places"), ("description",), "the document")
    vertices = [
        check_list(v, f"polygon[{i}]", 2)
        for i, v in enumerate(check_list(document["polygon"], "polygon"))
    ]
    places: list[OnEdge | list[Any]] = []
    listed = check_list(document["places"], "places")
    for i, entry in enumerate(listed):
        name = f"places[{i}]"
        on_edge = isinstance(entry, Mapping) and "edge" in entry
        required = ("edge", "at", "friction") if on_edge else ("point", "friction")
        check_keys(entry, required, VALUES[1:], name)
        places.append(
            OnEdge(entry["edge"], entry["at"]) if on_edge else check_list(entry["point"], name, 2)
        )
    values: dict[str, Any] = value_columns(listed)
    return from_polygon(vertices, places, **values, **options)
