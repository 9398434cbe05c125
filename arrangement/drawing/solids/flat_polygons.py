"""Convex polygons in a plane of R^3 as loops of points, exactly.

In space points are homogeneous integers ``(x, y, z, w)``, w > 0. In a plane ``row`` one of the
coordinates is left out, one along which the plane is not parallel to its axis.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cmp_to_key
from typing import NamedTuple

from arrangement.numbers.exact import IntegerVector, dot, primitive, reduced, sign
from arrangement.numbers.linear.intervals import Interval, remainder
from arrangement.numbers.linear.rank import cross, cycle_edges, triple_product

Loop = list[IntegerVector]
Segment = tuple[IntegerVector, IntegerVector]


def between(p: IntegerVector, q: IntegerVector, at_p: int, at_q: int) -> IntegerVector:
    """Return where a linear form vanishes between two points; its values there differ in sign."""
    s, t = abs(at_q), abs(at_p)
    return reduced([s * x + t * y for x, y in zip(p, q, strict=True)])


def clip_polygon(loop: Sequence[IntegerVector], values: Sequence[int]) -> Loop:
    """Return the part of a convex polygon where a linear form, known at its corners, is not < 0."""
    kept: Loop = []
    for k, (p, at) in enumerate(zip(loop, values, strict=True)):
        if at * values[k - 1] < 0:
            cut = between(loop[k - 1], p, values[k - 1], at)
            if cut not in kept:
                kept.append(cut)
        if at >= 0:
            kept.append(p)
    return kept


def _largest_axis(row: IntegerVector) -> int:
    """Return the coordinate that is left out of points in a plane."""
    return max(range(3), key=lambda k: abs(row[k]))


def drop_coordinate(row: IntegerVector, points: Iterable[IntegerVector]) -> Loop:
    """Return points of a plane with one coordinate left out."""
    gone = _largest_axis(row)
    return [reduced([x for k, x in enumerate(p) if k != gone]) for p in points]


def facing(row: IntegerVector, loop: Loop) -> Loop:
    """Return a loop, counter-clockwise seen from where a row is > 0, so that it is so flattened."""
    gone = _largest_axis(row)
    return loop if row[gone] * (-1) ** gone > 0 else loop[::-1]


def hull_corners(row: IntegerVector, points: Iterable[IntegerVector]) -> Loop:
    """Return the corners of the hull of points in a plane, in cyclic order (A. Andrew, 1979)."""
    gone = _largest_axis(row)
    flat = {tuple([x for k, x in enumerate(p) if k != gone]): p for p in points}
    listed = sorted(flat, key=cmp_to_key(_before))
    if len(listed) < 3:
        return [flat[p] for p in listed]

    def half(along: Iterable[IntegerVector]) -> Loop:
        chain: Loop = []
        for p in along:
            while len(chain) > 1 and triple_product(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return [flat[p] for p in half(listed) + half(reversed(listed))]


def _before(p: IntegerVector, q: IntegerVector) -> int:
    """Return what is below 0 for a point left of another, or below it."""
    return p[0] * q[2] - q[0] * p[2] or p[1] * q[2] - q[1] * p[2]


def restore_coordinate(row: IntegerVector, point: IntegerVector) -> IntegerVector:
    """Return the point of a plane with one coordinate left out."""
    gone = _largest_axis(row)
    rest = [x for k, x in enumerate(row) if k != gone]
    scale = abs(row[gone])
    entries = [scale * x for x in point]
    entries.insert(gone, -sign(row[gone]) * dot(rest, point))
    return reduced(entries)


def _split(loop: Loop, line: IntegerVector) -> tuple[Loop, Loop]:
    """Return the parts of a polygon where a form is > 0 and < 0; nothing for one without area."""
    values = [dot(line, p) for p in loop]
    if max(values) <= 0:
        return [], loop
    if min(values) >= 0:
        return loop, []
    return clip_polygon(loop, values), clip_polygon(loop, [-at for at in values])


def minus(loop: Loop, cover: Loop) -> list[Loop]:
    """Return convex pieces of a polygon outside another; both run counter-clockwise."""
    pieces, rest = [], loop
    for p, q in cycle_edges(cover):
        rest, outside = _split(rest, cross(p, q))
        if not rest:
            return [loop]
        if outside:
            pieces.append(outside)
    return pieces


class Boxed(NamedTuple):
    """A convex polygon with its least and largest coordinates.

    These are quotients of integers, correctly rounded: of different ones the larger is larger.
    """

    loop: Loop
    low: tuple[float, float]
    high: tuple[float, float]


def with_box(loop: Loop) -> Boxed:
    """Return a polygon with its box."""
    first, second = [p[0] / p[2] for p in loop], [p[1] / p[2] for p in loop]
    return Boxed(loop, (min(first), min(second)), (max(first), max(second)))


def without(parts: Iterable[Boxed], cover: Boxed) -> list[Boxed]:
    """Return convex pieces of polygons outside another one."""
    rest = []
    (left, lowest), (right, highest) = cover.low, cover.high
    for part in parts:
        (x, y), (x_end, y_end) = part.low, part.high
        if x > right or x_end < left or y > highest or y_end < lowest:
            rest.append(part)
        else:
            rest += map(with_box, minus(part.loop, cover.loop))
    return rest


def creases_of(loops: Sequence[Loop]) -> list[list[Segment]]:
    """Return for each polygon the parts of its edges with no other polygon across."""
    sides: dict[IntegerVector, list[Interval]] = {}
    listed = []
    for loop in loops:
        own = []
        for p, q in cycle_edges(loop):
            line = reduced(cross(p, q))
            k = 0 if line[1] else 1
            ends = Fraction(p[k], p[2]), Fraction(q[k], q[2])
            part = (min(ends), max(ends))
            sides.setdefault(line, []).append(part)
            own.append((line, k, part))
        listed.append(own)
    rows = []
    for own in listed:
        creases = []
        for line, k, part in own:
            across = sides.get(tuple(-x for x in line), ())
            rest = remainder(part, across)
            creases += [(_at(line, k, low), _at(line, k, high)) for low, high in rest]
        rows.append(creases)
    return rows


def _at(line: IntegerVector, k: int, value: Fraction | None) -> IntegerVector:
    """Return the point of a line of the plane with this coordinate k."""
    assert value is not None
    other = Fraction(-(line[k] * value + line[2]), line[1 - k])
    return primitive((value, other, Fraction(1)) if k == 0 else (other, value, Fraction(1)))
