"""Convex polygons in a plane of R^3 as loops of points, exactly.

In space points are homogeneous integers ``(x, y, z, w)``, w > 0. In a plane ``row`` one of the
coordinates is left out, one along which the plane is not parallel to its axis.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from arrangement.exact import IntegerVector, dot, primitive, reduced, sign
from arrangement.linear import cross, triple_product

from .intervals import Interval, remainder

Loop = list[IntegerVector]
Segment = tuple[IntegerVector, IntegerVector]


def between(p: IntegerVector, q: IntegerVector, at_p: int, at_q: int) -> IntegerVector:
    """Return where a linear form vanishes between two points; its values there differ in sign."""
    s, t = abs(at_q), abs(at_p)
    return reduced([s * x + t * y for x, y in zip(p, q, strict=True)])


def _dropped(row: IntegerVector) -> int:
    """Return the coordinate that is left out of points in a plane."""
    return max(range(3), key=lambda k: abs(row[k]))


def flattened(row: IntegerVector, points: Iterable[IntegerVector]) -> Loop:
    """Return points of a plane with one coordinate left out."""
    gone = _dropped(row)
    return [reduced([x for k, x in enumerate(p) if k != gone]) for p in points]


def ordered(row: IntegerVector, points: Iterable[IntegerVector]) -> Loop:
    """Return the corners of the hull of points in a plane, in cyclic order (A. Andrew, 1979)."""
    gone = _dropped(row)
    keys = [k for k in range(3) if k != gone]
    listed = sorted(points, key=lambda p: [Fraction(p[k], p[3]) for k in keys])
    if len(listed) < 3:
        return listed

    def half(along: Iterable[IntegerVector]) -> Loop:
        chain: Loop = []
        for p in along:
            while len(chain) > 1 and triple_product(*flattened(row, [*chain[-2:], p])) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return half(listed) + half(reversed(listed))


def lifted(row: IntegerVector, point: IntegerVector) -> IntegerVector:
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


def minus(loop: Loop, cover: Loop) -> list[Loop]:
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


def creases_of(loops: Sequence[Loop]) -> list[list[Segment]]:
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
