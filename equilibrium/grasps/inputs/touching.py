"""Contacts of shapes that touch: discs, spheres, polygons, thin walls and planes; threads.

Where two polygons have part of an edge in common there are two contacts, at its ends, else one
where a corner of either lies inside an edge of the other. A corner that only meets a corner is no
contact: it has no normal. Where the boundary is straight there is no corner, whatever is listed.

A disc or sphere touches a shape in one point for each disc, straight edge, plane or corner that is
as far from its centre as it has to be, up to a gap. Centre C and radius R are data; the contact is
derived from them: with the unit vector n along the shortest way to C it is at ``C - R n``. Where
that way has no rational length n is a rational unit vector near it, so the line of force meets C
exactly, and the arm of friction is R exactly, whatever was rounded. The line between two discs that
both can move has to meet two centres; there centres move a little, in `_placed`.

Overlaps are refused.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations, pairwise, product
from typing import Any, NamedTuple, TypeAlias

from arrangement.console.number_form import counted
from arrangement.numbers.exact import (
    RationalVector,
    dot,
    exact_root,
    rational,
    simplest_between,
    to_text,
    vector_text,
)
from arrangement.numbers.linear.rank import cycle_edges, difference
from equilibrium.model.assembly import Assembly, BodyContact, RigidBody
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.outline import Circle, Outline, Polygon, Segments
from equilibrium.model.unit_normal import UnitNormal, unit_normal

from .polygon import Segment, do_cross, is_on, is_straight, orientation, side, turn

#: Lines of centres whose angle has a sine below this do not fix the place of a disc.
_LEAST_SINE = Fraction(1, 100)


class Plane(NamedTuple):
    """The ground below a plane in space.

    Attributes:
        point: of the plane.
        normal: away from the ground, of any length.
    """

    point: RationalVector
    normal: RationalVector


Form: TypeAlias = Outline | Plane


class Shape(NamedTuple):
    """A body, or a part of the ground.

    Attributes:
        name: of the body; of a part of the ground by which friction refers to it.
        form: where it is; a polygon counter-clockwise and without straight corners.
        is_body: whether it can move.
    """

    name: str
    form: Form
    is_body: bool = True

    @property
    def corners(self) -> tuple[RationalVector, ...]:
        """The points where it is not smooth."""
        return () if isinstance(self.form, Circle | Plane) else self.form.extremes

    @property
    def edges(self) -> list[Segment]:
        """The edges, with the inside to their left."""
        if isinstance(self.form, Segments):
            return [edge for a, b in self.form.segments for edge in ((a, b), (b, a))]
        return list(cycle_edges(self.corners))


class Touch(NamedTuple):
    """A place where shapes touch.

    Attributes:
        first: the shape into which the normal points.
        way: from the second shape to the first, of any length; from a place to a centre.
        gap: the distance of the shapes as they were given, below 0 where they overlap (length).
        point: the place; None of a disc, where it is derived from the normal.
    """

    first: Shape
    second: Shape
    way: RationalVector
    gap: Fraction = Fraction(0)
    point: RationalVector | None = None


@dataclass(frozen=True)
class TouchingShapes:
    """The contacts of shapes that touch, and what was rounded.

    Attributes:
        contacts: the body into which the normal points, the other one (None: the ground), and the
            contact.
        touches: of each contact the shapes.
        angle_errors: of each contact, see `UnitNormal`.
        centres: of the discs that can move.
        moves: of each of these the largest change of a coordinate, made so that lines of force meet
            both centres.
        misses: of each contact how far its line of force stays away from the centre of the second
            disc; 0 unless no places of the centres were found where it meets both.
    """

    contacts: tuple[tuple[str, str | None, Contact], ...]
    touches: tuple[Touch, ...]
    angle_errors: RationalVector
    centres: Mapping[str, RationalVector]
    moves: RationalVector
    misses: RationalVector

    def assembly(self, bodies: Iterable[RigidBody], ground: Iterable[Any] = ()) -> Assembly:
        """Return the assembly of bodies with these contacts; discs stand in their `centres`."""
        placed = [
            replace(body, outline=Circle(self.centres[body.name], body.outline.radius))
            if body.name in self.centres and isinstance(body.outline, Circle)
            else body
            for body in bodies
        ]
        return Assembly(placed, [BodyContact(*entry) for entry in self.contacts], ground=ground)

    @property
    def remarks(self) -> list[str]:
        """What was rounded, in words."""
        lines = []
        for values, kind, text in (
            ([touch.gap for touch in self.touches], "contact", "within the gap, not exactly"),
            (self.angle_errors, "contact", "normal rounded, in radians"),
            (self.moves, "centre", "moved, so that lines of force meet both centres"),
            (self.misses, "contact", "line of force beside the second centre"),
        ):
            if sizes := [abs(x) for x in values if x]:
                many = f"{len(sizes)} of {counted(len(values), kind)}"
                lines.append(f"{text}: {many}, by up to {float(max(sizes)):.2g}")
        return lines


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
    heavy, land = rational(density, "density"), "the ground"
    shapes = [Shape(name, counter_clockwise(corners, name)) for name, corners in polygons.items()]
    fixed = [Shape(land, counter_clockwise(corners, land), False) for corners in ground]
    values = {"friction": friction, "stiffness": stiffness, "preload": preload}
    contacts = touching([*shapes, *fixed], lambda *_: values, angle_tolerance=angle_tolerance)
    bodies = [RigidBody(x.name, x.form, heavy * area(x.form)) for x in shapes]  # type: ignore[arg-type]
    return contacts.assembly(bodies, [x.form for x in fixed])


def counter_clockwise(corners: Iterable[Iterable[Any]], name: str) -> Polygon:
    """Return a simple polygon counter-clockwise, without the corners where it is straight."""
    listed = Polygon(corners).corners
    try:
        turned = orientation(listed)
    except GraspError as error:
        raise GraspError(f"{name}: {error}") from None
    bent = tuple(x for i, x in enumerate(listed) if not is_straight(listed, i))
    return Polygon(bent if turned > 0 else bent[::-1])


def area(form: Form) -> Fraction:
    """Return the area of a polygon with counter-clockwise corners; 0 of others."""
    corners = form.corners if isinstance(form, Polygon) else ()
    return sum((turn(a, b) for a, b in cycle_edges(corners)), Fraction(0)) / 2


def touching(
    shapes: Iterable[Shape],
    values: Callable[[str, str], Mapping[str, Any]],
    *,
    gap: Any = 0,
    angle_tolerance: Any = None,
) -> TouchingShapes:
    """Return the contacts of shapes, in the order of pairs of shapes.

    Args:
        shapes: all in the plane, or spheres and planes in space.
        values: friction, stiffness and preload of a contact, from the names of both shapes.
        gap: discs that are this close to a shape, or overlap it by this, touch it; at least 0 and
            below all radii. Polygons touch exactly.
        angle_tolerance: of normals that have no exact unit form; None refuses them.

    Raises:
        GraspError: overlaps, or no exact normal.
    """
    listed, close = list(shapes), rational(gap, "gap")
    radii = [shape.form.radius for shape in listed if isinstance(shape.form, Circle)]
    if not 0 <= close < min(radii, default=close + 1):
        raise GraspError(
            f"gap is {to_text(close)}; it must be at least 0 and below the least radius"
        )
    for name, times in Counter(shape.name for shape in listed if shape.is_body).items():
        if times > 1:
            raise GraspError(f"the body {name} is there twice; expected each name once")
    places = list(touches(listed, close))
    units = [_unit(touch, angle_tolerance) for touch in places]
    discs = {x.name: x.form.centre for x in listed if x.is_body and isinstance(x.form, Circle)}
    lines = {
        (touch.first.name, touch.second.name): unit.normal
        for touch, unit in zip(places, units, strict=True)
        if {touch.first.name, touch.second.name} <= discs.keys()
    }
    centres = _placed(discs, lines)
    contacts, misses = list[tuple[str, str | None, Contact]](), list[Fraction]()
    for (first, second, _, _, point), unit in zip(places, units, strict=True):
        normal, form, miss = unit.normal, first.form, Fraction(0)
        if isinstance(form, Circle):
            centre = centres.get(first.name, form.centre)
            point = tuple(c - form.radius * n for c, n in zip(centre, normal, strict=True))
            if (first.name, second.name) in lines:
                miss = abs(turn(difference(centres[second.name], centre), normal))
        assert point is not None  # those of discs are set above
        misses.append(miss)
        body, against, normal = into_body(first, second, normal)
        law = values(first.name, second.name)
        contacts.append((body, against, Contact(point, normal, **law)))
    return TouchingShapes(
        tuple(contacts),
        tuple(places),
        tuple(unit.angle_error for unit in units),
        centres,
        tuple(max(map(abs, difference(centres[name], place))) for name, place in discs.items()),
        tuple(misses),
    )


def touches(shapes: Sequence[Shape], gap: Fraction) -> Iterator[Touch]:
    """Yield where shapes touch, in the order of `touching`.

    Their numbers may be functions of a letter, if the gap is 0.
    """
    for first, second in combinations(shapes, 2):
        if not (first.is_body or second.is_body) or _are_apart(first, second, gap):
            continue
        if isinstance(second.form, Circle) and not (
            isinstance(first.form, Circle) and first.is_body
        ):
            first, second = second, first
        if isinstance(first.form, Circle):
            yield from _round_touches(first, second, first.form, gap)
        else:
            _refuse_overlap(first, second)
            yield from _edge_touches(first, second)


def into_body(
    first: Shape, second: Shape, normal: RationalVector
) -> tuple[str, str | None, RationalVector]:
    """Return the body into which a normal points, the other one (None: the ground), and it."""
    if not first.is_body:
        return second.name, None, tuple(-x for x in normal)
    return first.name, second.name if second.is_body else None, normal


def _are_apart(first: Shape, second: Shape, gap: Fraction) -> bool:
    """Return whether the boxes around two shapes are farther apart than a gap."""
    if isinstance(first.form, Plane) or isinstance(second.form, Plane):
        return False
    boxes = zip(*first.form.extremes, strict=True), zip(*second.form.extremes, strict=True)
    return any(max(a) + gap < min(b) or max(b) + gap < min(a) for a, b in zip(*boxes, strict=True))


def _round_touches(disc: Shape, other: Shape, form: Circle, gap: Fraction) -> Iterator[Touch]:
    due = form.radius + (other.form.radius if isinstance(other.form, Circle) else 0)
    ways = dict.fromkeys(_ways(form.centre, other))
    if isinstance(other.form, Polygon) and _contains(form.centre, other):
        ways = {form.centre[:0]: None}
    for way in ways:
        square, least, most = dot(way, way), due - gap, due + gap
        if square < least * least:
            raise GraspError(
                f"{disc.name} and {other.name} overlap: the centre {vector_text(form.centre)} is "
                f"nearer than {to_text(due)}, with a gap of {to_text(gap)}; expected shapes that "
                "touch at most. Move one, or give a larger gap"
            )
        if square <= most * most:
            yield Touch(disc, other, way, _root(square) - due if gap else Fraction(0))


def _ways(centre: RationalVector, shape: Shape) -> Iterator[RationalVector]:
    """Yield the shortest ways to a centre from a disc's centre, a plane, edges and corners."""
    form = shape.form
    if isinstance(form, Circle):
        yield difference(centre, form.centre)
        return
    if isinstance(form, Plane):
        height = dot(form.normal, difference(centre, form.point))
        share = max(height, Fraction(0)) / dot(form.normal, form.normal)
        yield tuple(share * x for x in form.normal)
        return
    # A corner counts where no edge at it has a nearer place; inside another wall it is none.
    is_nearest: dict[RationalVector, bool] = {}
    for a, b in shape.edges:
        along, away = difference(b, a), difference(centre, a)
        share = dot(along, away) / dot(along, along)
        is_nearest[a] = is_nearest.get(a, True) and share <= 0
        is_nearest[b] = is_nearest.get(b, True) and share >= 1
        if 0 < share < 1 and turn(along, away) <= 0:
            yield tuple(y - share * x for x, y in zip(along, away, strict=True))
    for corner, nearest in is_nearest.items():
        if nearest and not any(_is_inside(corner, edge) for edge in shape.edges):
            yield difference(centre, corner)


def _root(square: Fraction) -> Fraction:
    """Return a square root, exactly where it is rational, else to 2^-60."""
    if (exact := exact_root(square)) is not None:
        return exact
    return Fraction(math.isqrt((square.numerator << 120) // square.denominator), 1 << 60)


def _placed(
    discs: Mapping[str, RationalVector], lines: Mapping[tuple[str, str], RationalVector]
) -> dict[str, RationalVector]:
    """Return centres near the given ones such that lines along given directions join them.

    One disc after the other is placed, each on the lines from those before it: on one line next to
    where it was, at the crossing of two. The order leaves few lines to those before (the disc with
    the fewest neighbours is last, and so on), at most two unless every disc of some part has three
    neighbours in it; a third line is met where the data allow it, as in rows of equal discs.
    """
    neighbours: dict[str, dict[str, RationalVector]] = {name: {} for name in discs}
    # How many lines of each do not join the given centres: the fewer, the earlier it is placed.
    missed = Counter[str]()
    for (first, second), normal in lines.items():
        neighbours[first][second] = neighbours[second][first] = normal
        if turn(difference(discs[first], discs[second]), normal):
            missed.update((first, second))
    order, left = list[str](), {name: set(others) for name, others in neighbours.items()}
    while left:
        order.append(last := min(left, key=lambda name: (len(left[name]), -missed[name])))
        for second in left.pop(last):
            left[second].discard(last)
    placed: dict[str, RationalVector] = {}
    for name in reversed(order):
        before = [(placed[x], n) for x, n in neighbours[name].items() if x in placed]
        placed[name] = _on_lines(discs[name], before)
    return {name: placed[name] for name in discs}


def _on_lines(
    place: RationalVector, lines: Sequence[tuple[RationalVector, RationalVector]]
) -> RationalVector:
    """Return the place near a given one that is on one line, or on the two that cross best."""
    if not any(turn(difference(place, start), n) for start, n in lines):
        return place
    start, along = lines[0]
    second, across = max(lines, key=lambda line: abs(turn(along, line[1])))
    if abs(sine := turn(along, across)) >= _LEAST_SINE:
        step = turn(difference(second, start), across) / sine
    else:
        step = Fraction(dot(difference(place, start), along))
        room = abs(step) / 10**12
        step = simplest_between(step - room, step + room)
    return tuple(x + step * n for x, n in zip(start, along, strict=True))


def _edge_touches(first: Shape, second: Shape) -> Iterator[Touch]:
    """Yield the ends of what edges have in common, then corners inside edges."""
    shared: list[tuple[RationalVector, Segment]] = []
    for edge, mine in product(second.edges, first.edges):
        ends = [point for point in mine if is_on(edge, point)]
        ends += [point for point in edge if is_on(mine, point)]
        # Of the two edges of a thin wall the one counts that has the wall to its left.
        if len({*ends}) == 2 and dot(difference(*edge), difference(*mine)) < 0:
            shared += [(point, edge) for point in ends]
    corners = [
        # An edge of the first shape, turned round, has the second one to its left, too.
        (corner, edge if other is second else edge[::-1])
        for shape, other in ((first, second), (second, first))
        for edge, corner in product(other.edges, shape.corners)
        if _is_inside(corner, edge)
        and all(side(edge, end) <= 0 for pair in shape.edges if corner in pair for end in pair)
    ]
    known = {point for point, _ in shared}
    places = [*shared, *(place for place in corners if place[0] not in known)]
    for point, (start, end) in dict.fromkeys(places):
        along = difference(end, start)
        yield Touch(first, second, (along[1], -along[0]), point=point)


def _is_inside(point: RationalVector, edge: Segment) -> bool:
    """Return whether a point lies on an edge and is not one of its ends."""
    return point not in edge and is_on(edge, point)


def _refuse_overlap(first: Shape, second: Shape) -> None:
    """Refuse polygons whose insides meet, and thin walls inside polygons or across thin walls.

    Insides meet where the edge of one runs inside the other, or two edges run the same way: the
    inside is to the left of both.
    """
    walls = [x.form.segments for x in (first, second) if isinstance(x.form, Segments)]
    if len(walls) == 2:
        if any(do_cross(mine, theirs) for mine, theirs in product(*walls)):
            raise GraspError(f"a wall of {first.name} crosses one of {second.name}; move one")
        return
    for shape, other in ((first, second), (second, first)):
        for edge, middle in _middles(shape, other):
            on = [pair for pair in other.edges if is_on(pair, middle)]
            same = not walls and any(dot(difference(*edge), difference(*pair)) > 0 for pair in on)
            if same or (not on and _contains(middle, other)):
                raise GraspError(
                    f"{first.name} and {second.name} overlap at {vector_text(middle)}; expected "
                    "polygons that touch at most"
                )


def _middles(shape: Shape, other: Shape) -> Iterator[tuple[Segment, RationalVector]]:
    """Yield edges with points of them, one between any two places where they meet other edges.

    Where an edge runs along one of these, it meets another one at each of the ends.
    """
    for start, end in shape.edges:
        along = difference(end, start)
        shares = [Fraction(0), Fraction(1)]
        for a, b in other.edges:
            across, away = difference(b, a), difference(a, start)
            if slope := turn(along, across):
                share, place = (turn(away, way) / slope for way in (across, along))
                shares += [share] if 0 <= share <= 1 and 0 <= place <= 1 else []
        for low, high in pairwise(sorted(shares)):
            if low < high:
                half = (low + high) / 2
                yield (start, end), tuple(x + half * y for x, y in zip(start, along, strict=True))


def _contains(point: RationalVector, shape: Shape) -> bool:
    """Return whether a point off the boundary is inside: the ray to the right leaves once more."""
    crossings = [
        edge
        for edge in shape.edges
        if (edge[0][1] > point[1]) != (edge[1][1] > point[1])
        and (side(edge, point) > 0) == (edge[1][1] > point[1])
    ]
    return len(crossings) % 2 == 1


def _unit(touch: Touch, tolerance: Any) -> UnitNormal:
    """Return the exact unit normal along a direction, or one near it."""
    normal = unit_normal(touch.way, "1/1000" if tolerance is None else tolerance)
    if normal.angle_error and tolerance is None:
        raise GraspError(
            f"the normal between {touch.first.name} and {touch.second.name} is along "
            f"{vector_text(touch.way)}, whose length is not rational; give angle_tolerance to take "
            "one near it"
        )
    return normal
