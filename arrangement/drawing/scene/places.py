"""Where a label could stand: beside a point, beyond a line, inside an outline; and around a rim."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

import numpy as np

from .items import Box, Floats, Place
from .scene import Scene

#: For half the width and half the height of a label, its centres (k, 2), the best first.
Places: TypeAlias = Callable[[Floats], Floats]
#: Directions that are tried about a point.
_WAYS = 24
#: Turns from a direction that are tried by `near`; how many of them are ahead or aside.
_TURNS = (0, 0.5, -0.5, 1, -1, 1.6, -1.6, 2.3, -2.3, 3.1)
_AHEAD = 7


def around(away: Place = (0.0, 1.0)) -> Floats:
    """Return directions (24, 2), the given one first, then alternating farther from it."""
    k = np.arange(_WAYS)
    step = 2 * math.pi / _WAYS * np.where(k % 2, 1, -1)
    angles = math.atan2(away[1], away[0]) + (k + 1) // 2 * step
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def reach(half: Floats, ways: Floats) -> Floats:
    """Return how far a box of half a width and a height reaches in some directions, (k, 1)."""
    reaches: Floats = (half / np.maximum(np.abs(ways), 1e-9)).min(axis=-1, keepdims=True)
    return reaches


def fixed(centres: Floats) -> Places:
    """Return places (k, 2) that are the same for all labels."""
    return lambda _: centres


def beyond(points: Floats, ways: Floats, distances: Sequence[float]) -> Places:
    """Return places ahead of points (k, 2) in directions (k, 2), nearer ones first."""

    def places(half: Floats) -> Floats:
        out = reach(half, ways)
        return np.concatenate([points + (distance + out) * ways for distance in distances])

    return places


def beside(
    point: Place,
    *,
    away: Place = (0.0, 1.0),
    distance: float = 3.0,
    within: Box | None = None,
    others: Floats | None = None,
    turns: int = _WAYS,
) -> Places:
    """Return places around a point.

    Args:
        away: the direction tried first.
        distance: from the point to the nearest part of the label; up to twice as much is tried.
        within: a part of the scene that must not be left.
        others: points (k, 2) that must be farther from the label, by a half, than this one.
        turns: how many directions are tried, of 24.
    """
    import shapely

    at, ways = np.asarray(point), around(away)[:turns]
    own, rest = shapely.points(at), shapely.MultiPoint(() if others is None else others)
    left, low, right, high = within or (-math.inf, -math.inf, math.inf, math.inf)

    def places(half: Floats) -> Floats:
        centres = beyond(at, ways, (distance, 2 * distance))(half)
        inside = (centres - half >= (left, low)) & (centres + half <= (right, high))
        boxes = shapely.box(*(centres - half).T, *(centres + half).T)
        near = rest.distance(boxes) < 1.5 * own.distance(boxes)
        nearest: Floats = centres[inside.all(axis=1) & ~near]
        return nearest

    return places


def near(point: Floats, out: Floats) -> Places:
    """Return many places about a point: ahead and aside of a direction first, then behind."""
    angles = math.atan2(out[1], out[0]) + np.array(_TURNS)
    ways = np.stack([np.cos(angles), np.sin(angles)], axis=1)

    def places(half: Floats) -> Floats:
        wide = np.copysign(max(0.0, half[0] - 3), ways[:, 0])
        start = point + np.stack([wide, np.zeros_like(wide)], axis=1)
        return np.concatenate(
            [
                start[part] + distance * ways[part]
                for part in (slice(0, _AHEAD), slice(_AHEAD, None))
                for distance in (8, 11, 15, 20, 26, 34)
            ]
        )

    return places


def across(ends: Floats) -> Places:
    """Return places on both sides of the middle of a segment (2, 2), close to it."""
    step = ends[1] - ends[0]
    side = np.array([-step[1], step[0]]) / max(float(np.linalg.norm(step)), 1e-9)

    def places(half: Floats) -> Floats:
        out = float(np.abs(side) @ half) + 1.6
        centres: Floats = ends.mean(axis=0) + out * np.array([side, -side])
        return centres

    return places


def inside(scene: Scene, edge: Floats, off: Any = None, within: Box | None = None) -> Places:
    """Return the place inside an outline (k, 2), if a label has room there.

    It is the `pole` of what labels and the shapes `off` (see `keep_off`) leave free, in a part of
    the scene that must not be left.
    """
    import shapely

    area, none = shapely.Polygon(edge).buffer(0), np.empty((0, 2))
    if within is not None:
        area = area.intersection(shapely.box(*within))
    left, low, right, high = area.bounds if not area.is_empty else (0.0,) * 4
    free: list[Any] = []

    def cut() -> Any:
        boxes = [
            shapely.box(*box)
            for box in scene.boxes
            if box[0] < right and box[2] > left and box[1] < high and box[3] > low
        ]
        tree = shapely.STRtree([]) if off is None else off
        near = tree.geometries.take(tree.query(area, "dwithin", 0.5))
        lines = shapely.get_dimensions(near) == 1
        # Of merged lines one buffer has fewer corners than those of many segments.
        merged = shapely.line_merge(shapely.MultiLineString(list(near[lines])))
        kept = shapely.buffer([merged, *near[~lines]], 0.5, quad_segs=2)
        rest = shapely.difference(area, shapely.union_all([*boxes, *kept]))
        # Cut off at lines, a region may leave lines of no width.
        return shapely.MultiPolygon([x for x in shapely.get_parts(rest) if x.area > 0])

    def places(half: Floats) -> Floats:
        if right - left < 2 * half[0] or high - low < 2 * half[1] or not half[0]:
            return none
        if not free:
            free.append(cut())
            shapely.prepare(free[0])
        if free[0].is_empty:
            return none
        centre = np.round(pole(free[0], half), 2)
        room = half + np.array([1.2, 0.4])
        fits = free[0].contains(shapely.box(*(centre - room), *(centre + room)))
        return centre[None] if fits else none

    return places


def pole(area: Any, half: Floats) -> Floats:
    """Return the centre of the largest ellipse in a shape whose axes have the ratio of `half`."""
    import shapely

    unit = shapely.transform(area, lambda points: points / half)
    circle, middle = shapely.maximum_inscribed_circle(unit), unit.centroid
    centre = circle.coords[0]
    # A strip has many such circles; the middle one is taken.
    if unit.contains(middle) and middle.distance(unit.boundary) > 0.97 * circle.length:
        centre = middle.coords[0]
    place: Floats = half * np.array(centre)
    return place


def tried(count: int) -> int:
    """Return how many points are to be labelled, outer ones first; few in a crowd."""
    return min(count, 100 if count <= 200 else 12)


def spread(angles: Sequence[float], least: float) -> list[float]:
    """Return angles in the same cyclic order, at least `least` apart where there is room."""
    count = len(angles)
    least = min(least, 2 * math.pi / max(1, count) * 0.98)
    order = sorted(range(count), key=lambda k: angles[k] % (2 * math.pi))
    placed = [angles[k] % (2 * math.pi) for k in order]
    for _ in range(500 if count > 1 else 0):
        worst = 0.0
        for i in range(count):
            j = (i + 1) % count
            gap = placed[j] - placed[i] + (2 * math.pi if j == 0 else 0.0)
            if gap < least:
                push = (least - gap) / 2
                placed[i] -= push
                placed[j] += push
                worst = max(worst, push)
        if worst < 1e-4:
            break
    back = dict(zip(order, placed, strict=True))
    return [back[k] for k in range(count)]


def turn(angle: float) -> float:
    """Return an angle between -pi and pi."""
    return (angle + math.pi) % (2 * math.pi) - math.pi
