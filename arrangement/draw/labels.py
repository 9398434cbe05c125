"""Where labels fit: inside a region, beside a point, along a rim."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from .scene import Box, Floats, Place, Scene

Booleans: TypeAlias = npt.NDArray[np.bool_]
#: Sizes of sign vectors that are tried, in points.
SIZES = (7.0, 6.0, 5.0)
#: Between signs, so that minus signs do not run together.
HAIR = "\u200a"


def sign_text(signs: Sequence[int]) -> str:
    """Return a sign vector as text: true minus signs, a hair apart."""
    return HAIR.join("+" if sign > 0 else "\u2212" if sign < 0 else "0" for sign in signs)


def sign_rows(signs: Sequence[int], rows: int) -> str:
    """Return a sign vector broken into rows of equal length."""
    length = math.ceil(len(signs) / rows)
    return "\n".join(sign_text(signs[k : k + length]) for k in range(0, len(signs), length))


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
    signs: Sequence[int],
    sizes: Sequence[float] = SIZES,
    *,
    other: Floats | None = None,
    hiders: Sequence[Floats] = (),
    **style: Any,
) -> bool:
    """Write a sign vector inside a closed outline, in the largest size that fits, or not at all.

    Args:
        scene: where to.
        edge: points along the outline, denser than a label is wide.
        signs: the sign vector.
        sizes: those tried, in points.
        other: more points that must not be covered.
        hiders: polygons that cover a part of it.
        style: goes to matplotlib.
    """
    from matplotlib.path import Path

    if not signs:
        return False
    low, high = edge.min(axis=0), edge.max(axis=0)
    fitting = []
    for size, rows in product(sizes, (1, 2, 3)):
        text = sign_rows(signs, rows)
        box = np.array(scene.measure(text, size)) * (1.0, 0.92) + 1.8
        if rows <= len(signs) and (box < high - low).all():
            fitting.append((size, text, box))
    if not fitting:
        return False
    grid = np.stack(np.meshgrid(*np.linspace(low, high, 29).T), axis=-1).reshape(-1, 2)
    near = [h for h in hiders if (h.max(axis=0) > low).all() and (h.min(axis=0) < high).all()]
    free = Path(edge).contains_points(grid)
    for hider in near:
        free &= ~Path(hider).contains_points(grid)
    grid = grid[free]
    obstacles = np.vstack([_thinned(edge), *map(dense, near)])
    if other is not None:
        inside = ((other > low) & (other < high)).all(axis=1)
        obstacles = np.vstack([obstacles, other[inside]])
    apart = np.abs(grid[:, None] - obstacles)
    for size, text, box in fitting:
        room = (apart / box).max(axis=2).min(axis=1, initial=9.0)
        order = np.argsort(-np.round(room, 4), kind="stable")[:40]
        for place in grid[order][room[order] > 0.5]:
            if scene.write(place, text, size, **style):
                return True
    return False


def dense(outline: Floats) -> Floats:
    """Return a polygon with at most 2 points of paper between neighbouring corners."""
    pieces = []
    for p, q in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        steps = max(1, math.ceil(float(np.linalg.norm(q - p)) / 2))
        pieces.append(p + (q - p) * np.arange(steps)[:, None] / steps)
    return np.concatenate(pieces)


def _thinned(points: Floats, spacing: float = 1.0) -> Floats:
    """Return some of the points along a line, not much closer than `spacing`."""
    along = np.cumsum(np.linalg.norm(np.diff(points, axis=0, prepend=points[:1]), axis=1))
    return points[np.unique(np.floor(along / spacing), return_index=True)[1]]


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


def sign_forms(signs: Sequence[int]) -> list[str]:
    """Return a sign vector in one row and, when it is long, in several."""
    rows = [1] if len(signs) <= 4 else [1, 2] if len(signs) <= 6 else [1, 2, 3]
    return [sign_rows(signs, k) for k in rows]


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
