"""Labels that cover nothing, where they could stand, and lines from them to what they name.

`write_if_free` tries places and leaves a label out for want of room; `Labels` writes all of them;
`Leaders` puts them outside of what they name. A place is a function of the size of the label:
beside a point, beyond a line, inside an outline, around a rim.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import product
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.drawing.scene import FONT, Box, Floats, Place, Scene, measure
from arrangement.numbers import exact

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


def fixed_places(centres: Floats) -> Places:
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


def label_count(count: int) -> int:
    """Return how many points are to be labelled, outer ones first; few in a crowd."""
    return min(count, 100 if count <= 200 else 12)


def spread_angles(angles: Sequence[float], least: float) -> list[float]:
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


Booleans: TypeAlias = npt.NDArray[np.bool_]
#: Sizes of sign vectors that are tried, in points.
SIZES = (7.0, 6.0, 5.0)
#: Between signs, so that minus signs do not run together.
HAIR = "\u200a"


def sign_text(signs: Sequence[int]) -> str:
    """Return a sign vector as text: true minus signs, a hair apart."""
    return HAIR.join(exact.sign_text(signs, "\u2212"))


def write_if_free(
    scene: Scene,
    texts: Sequence[str],
    sizes: Sequence[float],
    places: Places,
    *,
    off: Any = None,
    **style: Any,
) -> bool:
    """Write a label at the first of its places that is free; return whether there is one.

    Args:
        scene: where to.
        texts: forms of the label; all of them are tried before a smaller size.
        sizes: in points, the largest first.
        places: for half the width and height of a text, centres (k, 2), the best first.
        off: shapes that must not be covered, see `keep_off`; labels never cover each other.
        style: of the text, see `scene`.
    """
    for size, text in product(sizes, texts):
        half = np.array(measure(text, size)) / 2
        centres = places(half)
        if off is not None:
            centres = centres[~covering(off, np.hstack([centres - half, centres + half]))]
        for centre in centres:
            if scene.write(centre, text, size, **style):
                return True
    return False


class Labels:
    """Labels that must be written: each at its first free place, else where it covers least."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._lines: list[Floats] = []
        self._off: Any = None

    @property
    def off(self) -> Any:
        """What labels should not cover, as for `write_if_free`."""
        self._off = self._off or keep_off(self._lines)
        return self._off

    def avoid(self, *lines: Any) -> None:
        """Add lines, each through points (k, 2), that labels should not cover."""
        self._lines += map(np.asarray, lines)
        self._off = None

    def write(self, text: str, places: Places, **style: Any) -> None:
        """Write a text at one of its places."""
        import shapely

        half = np.array([measure(text)[0], FONT]) / 2
        centres, room = places(half), half + np.array([1.0, 0.5])
        low, high = centres - room, centres + room
        others = np.array(self.scene.boxes).reshape(-1, 2, 2)
        shared = np.minimum(high[:, None], others[:, 1]) - np.maximum(low[:, None], others[:, 0])
        paper = np.array([self.scene.width, self.scene.height])
        outside = np.maximum(-low, 0).sum(axis=1) + np.maximum(high - paper, 0).sum(axis=1)
        rooms = shapely.box(*(low - 0.6).T, *(high + 0.6).T)
        crossed = np.bincount(self.off.query(rooms, "intersects")[0], minlength=len(rooms))
        covered = np.maximum(shared, 0).prod(axis=2).sum(axis=1) + outside
        best = int(np.argmin(crossed + 1000 * covered))
        self.scene.boxes.append((*low[best].tolist(), *high[best].tolist()))
        self.scene.text(centres[best], text, **{"halo": (1.5, "white"), "zorder": 7, **style})


def keep_off(
    lines: Iterable[Floats],
    areas: Iterable[Floats] = (),
    discs: Floats | None = None,
    radius: float = 0.0,
) -> Any:
    """Return what labels must not cover as a tree of shapes.

    Args:
        lines: each (k, 2).
        areas: polygons, each (k, 2).
        discs: their centres, (k, 2).
        radius: of the discs.
    """
    import shapely

    pieces = [np.stack([line[:-1], line[1:]], axis=1) for line in lines]
    segments = shapely.linestrings(np.concatenate([np.empty((0, 2, 2)), *pieces]))
    dots = [] if discs is None else shapely.buffer(shapely.points(discs), radius, quad_segs=2)
    return shapely.STRtree([*segments, *(shapely.Polygon(area) for area in areas), *dots])


def covering(off: Any, boxes: Floats, margin: float = 0.6) -> Booleans:
    """Return for boxes (k, 4), widened by a margin, whether they meet a shape of a tree."""
    import shapely

    low, high = boxes[:, :2] - margin, boxes[:, 2:] + margin
    met = np.zeros(len(boxes), dtype=np.bool_)
    met[off.query(shapely.box(*low.T, *high.T), "intersects")[0]] = True
    return met


#: Lengths of leader lines that are tried, in points.
_LENGTHS = (7.0, 10.0, 14.0, 19.0, 25.0, 32.0, 40.0, 50.0)
#: Radius of the dot at the end of a leader line, in points.
_DOT = 0.6
#: The least radius of a disc in what is named, in points.
_LEAST = 0.45


class Leaders:
    """Labels off all lines, each with a line to a dot in what it names.

    Args:
        scene: where to.
        lines: (k, 2) each; no label covers one, and leader lines cross as few as can be.
        within: a part of the scene that must not be left.
        areas: (k, 2) each; other places are better for labels, which might be taken for theirs.
    """

    def __init__(
        self, scene: Scene, lines: Sequence[Floats], within: Box, areas: Sequence[Floats]
    ) -> None:
        import shapely

        self.scene = scene
        self.off = keep_off(lines)
        self.within = shapely.box(*within)
        self.areas = shapely.STRtree([shapely.Polygon(area).buffer(0) for area in areas])
        self.drawn: list[Any] = []

    def write(self, edge: Floats, texts: Sequence[str], sizes: Sequence[float]) -> bool:
        """Name what has an outline with points `edge`, or return False where there is no room."""
        import shapely

        area = shapely.Polygon(edge).buffer(0)
        if area.is_empty:
            return False
        pole, rim = shapely.maximum_inscribed_circle(area).coords
        room = math.dist(pole, rim)
        if room < _LEAST:
            return False
        start = np.round(pole, 2)
        ends: dict[Any, Floats] = {}

        def places(half: Floats) -> Floats:
            centres, tips = self._places(start, half)
            ends.update(zip(map(tuple, centres.tolist()), tips, strict=True))
            return centres

        if not write_if_free(self.scene, texts, sizes, places):
            return False
        written = np.reshape(self.scene.boxes[-1], (2, 2)).mean(axis=0)
        nearest = min(ends, key=lambda centre: math.dist(centre, written))
        track = np.array([start, ends[nearest]])
        self.drawn.append(shapely.linestrings(track))
        style = {"zorder": 5.5, "gid": "leader"}
        self.scene.line(track, ec="black", lw=0.35, **style)
        self.scene.circle(start, min(_DOT, 0.8 * room), fc="black", ec="none", **style)
        return True

    def _places(self, start: Floats, half: Floats) -> tuple[Floats, Floats]:
        """Return centres off all lines, the best first, and the ends of their leader lines."""
        import shapely

        ways = np.tile(around(), (len(_LENGTHS), 1))
        length = np.repeat(_LENGTHS, len(around()))[:, None]
        centres = start + ways * (length + reach(half, ways))
        low, high = centres - half, centres + half
        boxes = shapely.box(*(low - 1.0).T, *(high + 1.0).T)
        # Of long names few have a place at all.
        kept = np.flatnonzero(shapely.contains(self.within, boxes))
        kept = kept[~covering(self.off, np.hstack([low, high])[kept], 1.0)]
        ways, length, centres, boxes = (x[kept] for x in (ways, length, centres, boxes))
        ends = start + ways * (length - 0.6)
        tracks = shapely.linestrings(np.stack([np.broadcast_to(start, ends.shape), ends], axis=1))
        written = shapely.STRtree(shapely.box(*np.array(self.scene.boxes).reshape(-1, 4).T))
        leaders = shapely.STRtree(self.drawn)
        free = np.ones(len(kept), bool)
        for taken in (
            leaders.query(boxes, "dwithin", 0.6),
            leaders.query(tracks, "dwithin", 0.6),
            written.query(tracks, "intersects"),
        ):
            free[np.unique(taken[0])] = False
        crossed = np.bincount(self.off.query(tracks, "intersects")[0], minlength=len(tracks))
        cost = 6.0 * crossed + length[:, 0]
        cost[np.unique(self.areas.query(boxes, "intersects")[0])] += 15.0
        cost[np.unique(written.query(boxes, "dwithin", 3.0)[0])] += 8.0
        order = np.argsort(cost, kind="stable")
        order = order[free[order]]
        return centres[order], ends[order]
