"""Points with exact coordinates, and convex polygons: their sides as lines."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any, TypeAlias

from arrangement.errors import InputError
from arrangement.numbers.arguments import entries
from arrangement.numbers.exact import dot, rational_vector, shown, sign
from arrangement.numbers.symbolic import entry, in_one_field

from .faces import Face
from .planes import Planes

#: A convex polyhedron: planes with it on the positive side, a region, or corners of a polygon.
Inside: TypeAlias = Planes | Face | str | Iterable[Iterable[Any]]


def exact_points(points: str | Iterable[Iterable[Any]]) -> list[tuple[Any, ...]]:
    """Return different points of one space R^d, d > 0, with coordinates in one field.

    Args:
        points: exact coordinates, as `Planes` takes them; or a text such as ``0,0; 1,0; 1/2,2``.

    Raises:
        InputError: no points, points of different spaces, or one that comes again.
    """
    listed: Any = points
    if isinstance(points, str):
        listed = [[x.strip() for x in point.split(",")] for point in points.split(";")]
    rows = entries(listed, "points", "points")
    made = in_one_field([rational_vector(row, f"points[{i}]", entry) for i, row in enumerate(rows)])
    if not made or len({len(point) for point in made}) > 1 or not made[0]:
        raise InputError(
            f"points is {shown(points)}; give points of one space, such as 0,0;1,0;1/2,2"
        )
    first = dict[Any, int]()
    for i, point in enumerate(made):
        if (known := first.setdefault(point, i)) != i:
            raise InputError(f"points[{i}] is points[{known}] again; give it once")
    return made


def line_through(p: Sequence[Any], q: Sequence[Any]) -> tuple[Any, Any, Any]:
    """Return a, b, c of the line a x + b y = c with all points left of the way from p to q as >."""
    a, b = p[1] - q[1], q[0] - p[0]
    return a, b, a * p[0] + b * p[1]


def convex_polygon(corners: str | Iterable[Iterable[Any]]) -> Planes:
    """Return the sides of a convex polygon in R^2 as lines with the polygon on the positive side.

    Args:
        corners: in their order around, either way; a corner may lie on the line of its neighbours.

    Raises:
        InputError: fewer than three corners, or corners that are not in convex position.
    """
    points = exact_points(corners)
    if len(points[0]) != 2 or len(points) < 3:
        raise InputError(f"a polygon has three or more corners in R^2; these are {shown(corners)}")
    for turned in (points, points[::-1]):
        lines = [line_through(p, q) for p, q in pairwise([*turned, turned[0]])]
        sides = {sign(dot(line[:2], p) - line[2]) for line in lines for p in points}
        if sides == {0, 1}:
            return Planes([line[:2] for line in lines], [line[2] for line in lines])
    raise InputError(
        f"the corners {shown(corners)} are not those of a convex polygon in their order around it; "
        "a polygon that is not convex is cut into convex ones"
    )


def bounding_planes(inside: Inside) -> Planes:
    """Return the planes that bound a polyhedron, with it on the positive side of each."""
    if isinstance(inside, Face):
        return inside.sides
    if not isinstance(inside, (Planes, Iterable)):
        raise InputError(
            f"inside is {shown(inside)}; give planes, a region of some, or corners of a polygon"
        )
    return inside if isinstance(inside, Planes) else convex_polygon(inside)
