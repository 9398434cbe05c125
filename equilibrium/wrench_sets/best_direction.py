"""The least force at a point, in the best direction, that a grasp with a load does not resist.

The forces at one point are a plane of wrenches, in which the resisted ones are a union of polygons
(`plane`). Along a direction resistance ends where the ray leaves them: at an edge of their outline
that has the load on its inner side. So the least of these forces is the nearest point of all these
edges, exactly.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import JsonMixin
from arrangement.numbers.exact import RationalVector, dot, rational_vector
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import read_wrench

from .any_direction import root, unresisted_near
from .outline import Segment

if TYPE_CHECKING:
    from .resisted_set import ResistedSet
    from .slice import Region

#: How far `BestDirection.beyond` is from `moving` at most, as a share of its size.
_BEYOND = Fraction(1, 1000)
_ORIGIN: RationalVector = (Fraction(0), Fraction(0))


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
    return math.degrees(math.atan2(*map(float, reversed(force))))


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
    outline, is_held = region.outline, region.contains(_ORIGIN)
    ends = [edge for edge in outline.border if edge.constant > 0 or (is_held and not edge.constant)]
    solid = (p.polyhedron for p in region.polygons if p.polyhedron.dimension == 2)
    moving = beyond = holding = None
    if is_held and not any(polygon.contains(_ORIGIN) for polygon in solid):
        moving, beyond = _ORIGIN, _beyond(region, _ORIGIN, None)
    elif ends:
        nearest = ((_nearest(edge), edge) for edge in ends)
        moving, edge = min(nearest, key=lambda pair: dot(pair[0], pair[0]))
        beyond = _beyond(region, moving, edge)
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


def _beyond(region: Region, end: RationalVector, edge: Segment | None) -> RationalVector:
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
