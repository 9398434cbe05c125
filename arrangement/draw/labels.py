"""Where labels fit: inside a region, beside a point, along a rim."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from .scene import GAP, Box, Floats, Place, Scene

Booleans: TypeAlias = npt.NDArray[np.bool_]
#: Sizes of sign vectors that are tried, in points.
SIZES = (7.0, 6.0, 5.0)
#: Radius of the dot at the end of a leader line, in points.
DOT = 0.6
#: Between signs, so that minus signs do not run together.
HAIR = "\u200a"


def sign_text(signs: Sequence[int]) -> str:
    """Return a sign vector as text: true minus signs, a hair apart."""
    return HAIR.join("+" if sign > 0 else "\u2212" if sign < 0 else "0" for sign in signs)


def flattened(curve: Floats, steps: int = 24) -> Floats:
    """Return points along cubic curves given by control points (3k + 1, 2)."""
    t = np.linspace(0, 1, steps, endpoint=False)[:, None, None]
    p, q, r, end = curve[:-1:3], curve[1::3], curve[2::3], curve[3::3]
    points = (1 - t) ** 3 * p + 3 * t * (1 - t) ** 2 * q + 3 * t**2 * (1 - t) * r + t**3 * end
    flat: Floats = points.transpose(1, 0, 2).reshape(-1, 2)
    return flat


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
        off: a geometry of shapely that must not be touched, such as lines and what hides a part.
        style: goes to matplotlib.
    """
    import shapely

    free = shapely.Polygon(edge).buffer(0)
    w, h = scene.measure(text, sizes[-1])
    left, low, right, high = free.bounds if not free.is_empty else (0.0,) * 4
    if not text or right - left < w or high - low < h:
        return False
    boxes = [
        shapely.box(*box) for box in scene.boxes
        if box[0] < right and box[2] > left and box[1] < high and box[3] > low
    ]  # fmt: skip
    free = shapely.difference(free, shapely.unary_union([*boxes, off or shapely.Point()]))
    if free.is_empty:
        return False
    unit = shapely.transform(free, lambda points: points / (w, h))
    x, y = shapely.maximum_inscribed_circle(unit).coords[0]
    place = round(x * w, 2), round(y * h, 2)
    shapely.prepare(free)
    for size in sizes:
        left, low, right, high = scene.box(place, text, size)
        room = shapely.box(left - GAP, low - GAP / 2, right + GAP, high + GAP / 2)
        if free.contains(room) and scene.write(place, text, size, **style):
            return True
    return False


def write_outside(
    scene: Scene,
    edge: Floats,
    text: str,
    *,
    size: float = SIZES[-1],
    segments: Floats,
    leaders: list[Floats],
    within: Box,
) -> bool:
    """Write a text off all segments, with a line to a dot inside an outline, or not at all.

    Args:
        scene: where to.
        edge: points along the outline, which is too small for the text.
        text: one line.
        size: in points.
        segments: (k, 2, 2) that the text must not cover; the line crosses as few as can be.
        leaders: the lines drawn so far, which no text covers and no new line crosses; the new one
            is added.
        within: a part of the scene that must not be left.
    """
    import shapely

    area = shapely.Polygon(edge).buffer(0)
    if area.is_empty:
        return False
    pole, rim = shapely.maximum_inscribed_circle(area).coords
    if math.dist(pole, rim) < DOT + 0.3:
        return False
    start = np.round(pole, 2)
    half = np.array(scene.measure(text, size)) / 2
    blocked = np.concatenate([segments, *(line[None] for line in leaders)])
    tried: list[tuple[float, float, Floats, Floats]] = []
    for reach in (7.0, 10.0, 14.0, 19.0, 25.0, 32.0, 40.0, 50.0):
        ways = np.array(list(_around((0.0, 1.0))))
        centres = start + ways * (
            reach + (half / np.maximum(np.abs(ways), 1e-9)).min(axis=1)[:, None]
        )
        boxes = np.hstack([centres - half, centres + half])
        clear = ~segments_meet(boxes, blocked, 1.0).any(axis=1)
        for k in np.flatnonzero(clear).tolist():
            x0, y0, x1, y1 = boxes[k]
            inside = within[0] <= x0 and within[1] <= y0 and x1 <= within[2] and y1 <= within[3]
            line = np.array([start, start + ways[k] * (reach - 0.6)])
            if not inside or not scene.is_free((x0, y0, x1, y1)):
                continue
            if segments_meet(np.array(scene.boxes).reshape(-1, 4), line[None], 0.3).any():
                continue
            track = shapely.LineString(line)
            if any(track.distance(shapely.LineString(other)) < 0.6 for other in leaders):
                continue
            crossed = int(shapely.intersects(track, shapely.linestrings(segments)).sum())
            tried.append((crossed * 6.0 + reach, float(k), centres[k], line))
    if not tried:
        return False
    _, _, centre, line = min(tried, key=lambda found: found[:2])
    leaders.append(line)
    scene.line(line, ec="black", lw=0.35, zorder=5.5, gid="leader")
    scene.circle(start, DOT, fc="black", ec="none", zorder=5.5, gid="leader")
    return scene.write(centre, text, size)


def dense(outline: Floats) -> Floats:
    """Return a polygon with at most 2 points of paper between neighbouring corners."""
    pieces = []
    for p, q in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        steps = max(1, math.ceil(float(np.linalg.norm(q - p)) / 2))
        pieces.append(p + (q - p) * np.arange(steps)[:, None] / steps)
    return np.concatenate(pieces)


def write_beside(
    scene: Scene,
    point: Place,
    texts: Sequence[str],
    sizes: Sequence[float],
    *,
    segments: Floats,
    away: Place = (0.0, 1.0),
    distance: float = 3.0,
    within: Box | None = None,
    **style: Any,
) -> bool:
    """Write a label beside a point, off all segments, or not at all.

    Args:
        scene: where to.
        point: the point.
        texts: the label in different forms, the first one that fits is taken.
        sizes: those tried, in points.
        segments: (k, 2, 2) that must not be covered.
        away: the direction tried first.
        distance: from the point to the nearest part of the label; up to twice as much is tried.
        within: a part of the scene that must not be left.
        style: goes to matplotlib.
    """
    x, y = float(point[0]), float(point[1])
    close = segments[segments_meet((x - 60, y - 60, x + 60, y + 60), segments)]
    directions = np.array(list(_around(away)))
    for size, text, beyond in product(sizes, texts, (1.0, 2.0)):
        half = np.array(scene.measure(text, size)) / 2
        reach = distance * beyond + (half / np.maximum(np.abs(directions), 1e-9)).min(axis=1)
        centres = np.asarray(point) + reach[:, None] * directions
        boxes = np.hstack([centres - half, centres + half])
        for k in np.flatnonzero(~segments_meet(boxes, close).any(axis=1)).tolist():
            left, low, right, high = within or boxes[k]
            x0, y0, x1, y1 = boxes[k]
            inside = left <= x0 and low <= y0 and x1 <= right and y1 <= high
            if inside and scene.write(centres[k], text, size, **style):
                return True
    return False


def crosses(points: Floats, radius: float) -> Floats:
    """Return segments (2k, 2, 2) that cover small dots, for `write_beside`."""
    arms = radius * np.array([[1.0, 0.0], [0.0, 1.0]])
    return np.concatenate([np.stack([points - arm, points + arm], axis=1) for arm in arms])


def tried(count: int) -> int:
    """Return how many of so many points are to be labelled, outer ones first; few in a crowd."""
    return min(count, 100 if count <= 200 else 12)


def _around(away: Place) -> Iterator[tuple[float, float]]:
    """Yield directions, the given one first, then alternating farther from it."""
    start = math.atan2(away[1], away[0])
    for k in range(24):
        angle = start + (k + 1) // 2 * math.pi / 12 * (1 if k % 2 else -1)
        yield math.cos(angle), math.sin(angle)


def segments_meet(boxes: Box | Floats, segments: Floats, margin: float = 0.6) -> Booleans:
    """Return for boxes (..., 4), widened a little, and segments (k, 2, 2) whether they meet."""
    start, step = segments[:, 0], segments[:, 1] - segments[:, 0]
    corners = np.asarray(boxes, dtype=float)[..., None, :]
    low, high = corners[..., :2] - margin, corners[..., 2:] + margin
    with np.errstate(divide="ignore", invalid="ignore"):
        one, two = (low - start) / step, (high - start) / step
    flat = step == 0
    inside = (start >= low) & (start <= high)
    enter = np.where(flat, np.where(inside, -np.inf, np.inf), np.minimum(one, two)).max(axis=-1)
    leave = np.where(flat, np.where(inside, np.inf, -np.inf), np.maximum(one, two)).min(axis=-1)
    met: Booleans = (enter <= leave) & (leave >= 0) & (enter <= 1)
    return met


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
