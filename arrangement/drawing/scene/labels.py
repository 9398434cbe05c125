"""Where labels stand: beside what they name, or outside with leader lines."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.console import number_form
from arrangement.drawing.colours import VERMILION

from .items import Box, Floats, Place
from .scene import FONT, Scene

Booleans: TypeAlias = npt.NDArray[np.bool_]
#: Sizes of sign vectors that are tried, in points.
SIZES = (7.0, 6.0, 5.0)
#: Between signs, so that minus signs do not run together.
HAIR = "\u200a"


def sign_text(signs: Sequence[int]) -> str:
    """Return a sign vector as text: true minus signs, a hair apart."""
    return HAIR.join(number_form.sign_text(signs, "\u2212"))


def flattened(curve: Floats, steps: int = 24) -> Floats:
    """Return points along cubic curves given by control points (3k + 1, 2)."""
    t = np.linspace(0, 1, steps, endpoint=False)[:, None, None]
    p, q, r, end = curve[:-1:3], curve[1::3], curve[2::3], curve[3::3]
    points = (1 - t) ** 3 * p + 3 * t * (1 - t) ** 2 * q + 3 * t**2 * (1 - t) * r + t**3 * end
    return points.transpose(1, 0, 2).reshape(-1, 2)


def along(curve: Floats, steps: int = 8) -> Floats:
    """Return points along cubic curves with both ends."""
    return np.vstack([flattened(curve, steps), curve[-1:]])


def write_inside(
    scene: Scene,
    edge: Floats,
    text: str,
    sizes: Sequence[float] = SIZES,
    *,
    off: Any = None,
    **style: Any,
) -> bool:
    """Write a text inside a closed outline, in the largest size that fits, or not at all.

    It stands at the pole of inaccessibility, in units of the width and height of the text: at the
    centre of the largest such ellipse in what is free.

    Args:
        scene: where to.
        edge: points along the outline.
        text: one line.
        sizes: those tried, in points.
        off: shapes that must not be touched, as a tree (see `keep_off`).
        style: goes to matplotlib.
    """
    import shapely

    free = shapely.Polygon(edge).buffer(0)
    w, h = scene.measure(text, sizes[-1])
    left, low, right, high = free.bounds if not free.is_empty else (0.0,) * 4
    if not text or right - left < w or high - low < h:
        return False
    boxes = [
        shapely.box(*box)
        for box in scene.boxes
        if box[0] < right and box[2] > left and box[1] < high and box[3] > low
    ]
    near = np.array([]) if off is None else off.geometries.take(off.query(free, "dwithin", 0.5))
    lines = shapely.get_dimensions(near) == 1
    # Of merged lines one buffer has fewer corners than those of many segments.
    merged = shapely.line_merge(shapely.multilinestrings(near[lines]))
    kept = shapely.buffer([merged, *near[~lines]], 0.5, quad_segs=2)
    free = shapely.difference(free, shapely.union_all([*boxes, *kept]))
    if free.is_empty:
        return False
    # Cut off at lines, a region may leave lines of no width.
    free = shapely.multipolygons([x for x in shapely.get_parts(free) if x.area > 0])
    unit = shapely.transform(free, lambda points: points / (w, h))
    circle, middle = shapely.maximum_inscribed_circle(unit), unit.centroid
    x, y = circle.coords[0]
    # A strip has many such circles; the middle one is taken.
    if unit.contains(middle) and middle.distance(unit.boundary) > 0.97 * circle.length:
        x, y = middle.coords[0]
    place = round(x * w, 2), round(y * h, 2)
    shapely.prepare(free)
    for size in sizes:
        left, low, right, high = scene.box(place, text, size)
        room = shapely.box(left - 1.2, low - 0.4, right + 1.2, high + 0.4)
        if free.contains(room) and scene.write(place, text, size, **style):
            return True
    return False


def ring(centre: Place, radius: float, steps: int = 200) -> Floats:
    """Return points along a circle, the last one as the first."""
    at = np.linspace(0, 2 * math.pi, steps)
    return np.asarray(centre) + radius * np.stack([np.cos(at), np.sin(at)], axis=1)


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


def write_beside(
    scene: Scene,
    point: Place,
    texts: Sequence[str],
    sizes: Sequence[float],
    *,
    off: Any,
    away: Place = (0.0, 1.0),
    distance: float = 3.0,
    within: Box | None = None,
    others: Floats | None = None,
    turns: int = 24,
    **style: Any,
) -> bool:
    """Write a label beside a point, off all segments, or not at all.

    Args:
        scene: where to.
        point: the point.
        texts: the label in different forms, the first one that fits is taken.
        sizes: those tried, in points.
        off: shapes that must not be covered, see `keep_off`.
        away: the direction tried first.
        distance: from the point to the nearest part of the label; up to twice as much is tried.
        within: a part of the scene that must not be left.
        others: points (k, 2) that must be farther from the label, by a half, than this one.
        turns: how many directions are tried, of 24.
        style: goes to matplotlib.
    """
    import shapely

    own, rest = shapely.points(point), shapely.MultiPoint(() if others is None else others)
    ways = np.array(list(around(away)))[:turns]
    left, low, right, high = within or (-math.inf, -math.inf, math.inf, math.inf)
    for size, text, beyond in product(sizes, texts, (1.0, 2.0)):
        half = np.array(scene.measure(text, size)) / 2
        centres = np.asarray(point) + (distance * beyond + reach(half, ways)) * ways
        inside = (centres - half >= (left, low)) & (centres + half <= (right, high))
        boxes = shapely.box(*(centres - half).T, *(centres + half).T)
        near = rest.distance(boxes) < 1.5 * own.distance(boxes)
        free = inside.all(axis=1) & ~near
        if place(scene, text, size, centres, off=off, free=free, **style) >= 0:
            return True
    return False


def reach(half: Floats, ways: Floats) -> Floats:
    """Return how far a box of half a width and a height reaches in some directions, (k, 1)."""
    reaches: Floats = (half / np.maximum(np.abs(ways), 1e-9)).min(axis=-1, keepdims=True)
    return reaches


def place(
    scene: Scene,
    text: str,
    size: float,
    centres: Floats,
    *,
    off: Any = None,
    free: Any = True,
    order: Iterable[int] | None = None,
    **style: Any,
) -> int:
    """Write a text at the first of some centres (k, 2) where it has room; return which, or -1.

    Args:
        off: shapes that must not be covered, see `keep_off`.
        free: which centres are allowed.
        order: in which they are tried.
    """
    half = np.array(scene.measure(text, size)) / 2
    allowed = np.array(np.broadcast_to(free, len(centres)))
    if off is not None:
        allowed &= ~covering(off, np.hstack([centres - half, centres + half]))
    for k in range(len(centres)) if order is None else order:
        if allowed[k] and scene.write(centres[k], text, size, **style):
            return k
    return -1


def write_along(scene: Scene, ends: Floats, text: str, size: float, off: Any, **style: Any) -> bool:
    """Write a text beside the middle of a segment, close to it and off all segments, or not at all.

    Args:
        scene: where to.
        ends: (2, 2); of the segment.
        text: one line.
        size: in points.
        off: shapes that must not be covered, see `keep_off`.
        style: goes to matplotlib.
    """
    step = ends[1] - ends[0]
    across = np.array([-step[1], step[0]]) / max(float(np.linalg.norm(step)), 1e-9)
    beyond = float(np.abs(across) @ np.array(scene.measure(text, size))) / 2 + 1.6
    centres = ends.mean(axis=0) + beyond * np.array([across, -across])
    return place(scene, text, size, centres, off=off, **style) >= 0


def tried(count: int) -> int:
    """Return how many points are to be labelled, outer ones first; few in a crowd."""
    return min(count, 100 if count <= 200 else 12)


def around(away: Place) -> Iterator[tuple[float, float]]:
    """Yield directions, the given one first, then alternating farther from it."""
    start = math.atan2(away[1], away[0])
    for k in range(24):
        angle = start + (k + 1) // 2 * math.pi / 12 * (1 if k % 2 else -1)
        yield math.cos(angle), math.sin(angle)


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


#: How far from the wanted direction labels are tried: ahead and aside first, then behind.
_TURNS = (0, 0.5, -0.5, 1, -1, 1.6, -1.6, 2.3, -2.3, 3.1)


class Labels:
    """Places for labels that overlap neither each other nor what is drawn, on the sheet."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._boxes: list[Floats] = []
        self._lines: list[Floats] = []
        self._tree: Any = None

    def avoid(self, *lines: Any) -> None:
        """Keep labels off lines through points (k, 2)."""
        self._lines += map(np.asarray, lines)
        self._tree = None

    def place(self, text: str, wanted: Any) -> Floats:
        """Return the first wanted centre that is free, else the one that covers least."""
        import shapely

        half = np.array([self.scene.measure(text)[0] / 2 + 1, FONT / 2 + 0.5])
        centres = np.asarray(wanted)
        low, high = centres - half, centres + half
        others = np.array(self._boxes).reshape(-1, 2, 2)
        shared = np.minimum(high[:, None], others[:, 1]) - np.maximum(low[:, None], others[:, 0])
        paper = np.array([self.scene.width, self.scene.height])
        off = np.maximum(-low, 0).sum(axis=1) + np.maximum(high - paper, 0).sum(axis=1)
        self._tree = self._tree or keep_off(self._lines)
        rooms = shapely.box(*(low - 0.6).T, *(high + 0.6).T)
        met = np.bincount(self._tree.query(rooms, "intersects")[0], minlength=len(rooms))
        taken = met + 1000 * (np.maximum(shared, 0).prod(axis=2).sum(axis=1) + off)
        best = int(np.argmin(taken))
        self._boxes.append(np.array([low[best], high[best]]))
        found: Floats = centres[best]
        return found

    def beside(self, text: str, at: Floats, out: Floats, **style: Any) -> None:
        """Write a text near a point, in a direction if that is free."""
        start, half = math.atan2(out[1], out[0]), self.scene.measure(text)[0] / 2
        angles = start + np.array(_TURNS)
        ways = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        wider = np.stack([np.copysign(max(0.0, half - 3), ways[:, 0]), 0 * angles], axis=1)
        wanted = [
            at + reach * ways[part] + wider[part]
            for part in (slice(0, 7), slice(7, None))
            for reach in (8, 11, 15, 20, 26, 34)
        ]
        place = self.place(text, np.concatenate(wanted))
        self.scene.text(place, text, **{"halo": (1.5, "white"), "zorder": 7, **style})

    def name_wrench(self, ends: Sequence[Floats], away: tuple[Floats, float] | None = None) -> None:
        """Write w beside one of some points, farther from a place than a distance."""
        ways = [k * math.pi / 4 + 0.4 for k in range(8)]
        wanted = [
            end + reach * np.array([math.cos(k), math.sin(k)])
            for reach in (9, 13, 18)
            for end in ends
            for k in ways
        ]
        if away is not None:
            wanted = [at for at in wanted if np.linalg.norm(at - away[0]) > away[1]]
        look: dict[str, Any] = {"weight": "bold", "halo": (1.5, "white"), "zorder": 7}
        self.scene.text(self.place("w", wanted), "w", color=VERMILION, style="italic", **look)


#: Lengths of leader lines that are tried, in points.
_REACHES = (7.0, 10.0, 14.0, 19.0, 25.0, 32.0, 40.0, 50.0)
#: Radius of the dot at the end of a leader line, in points.
DOT = 0.6
#: The least radius of a disc in what is named, in points.
LEAST = 0.45


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

    def write(self, edge: Floats, text: str, size: float) -> bool:
        """Name what has an outline with points `edge`, or return False where there is no room."""
        import shapely

        area = shapely.Polygon(edge).buffer(0)
        if area.is_empty:
            return False
        pole, rim = shapely.maximum_inscribed_circle(area).coords
        room = math.dist(pole, rim)
        if room < LEAST:
            return False
        start = np.round(pole, 2)
        half = np.array(self.scene.measure(text, size)) / 2
        ways = np.tile(list(around((0.0, 1.0))), (len(_REACHES), 1))
        length = np.repeat(_REACHES, 24)[:, None]
        centres = start + ways * (length + reach(half, ways))
        low, high = centres - half, centres + half
        boxes = shapely.box(*(low - 1.0).T, *(high + 1.0).T)
        # Of long names few have a place at all.
        kept = np.flatnonzero(shapely.contains(self.within, boxes))
        kept = kept[~covering(self.off, np.hstack([low, high])[kept], 1.0)]
        if not len(kept):
            return False
        ways, length, centres, boxes = (x[kept] for x in (ways, length, centres, boxes))
        tracks = shapely.linestrings(
            np.stack([np.broadcast_to(start, centres.shape), start + ways * (length - 0.6)], axis=1)
        )
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
        order = np.argsort(cost, kind="stable").tolist()
        if (k := place(self.scene, text, size, centres, free=free, order=order)) < 0:
            return False
        self.drawn.append(tracks[k])
        style = {"zorder": 5.5, "gid": "leader"}
        self.scene.line(shapely.get_coordinates(tracks[k]), ec="black", lw=0.35, **style)
        self.scene.circle(start, min(DOT, 0.8 * room), fc="black", ec="none", **style)
        return True
