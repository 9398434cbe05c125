"""Arrows, arcs, segments and bodies, in floats: as flat pieces of pictures, as parts of models."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np

from arrangement.drawing.scene import Floats
from arrangement.drawing.solids.sight import across, face_normal, unit
from arrangement.drawing.solids.surface import Patch
from arrangement.errors import extra
from arrangement.numbers.exact import IntegerVector, primitive, reduced
from arrangement.numbers.linear.rank import cycle_edges, plane_through

#: Numbers of points, counter-clockwise seen from outside.
Cycle: TypeAlias = tuple[int, ...]
#: Points (P, 3) and faces.
Solid: TypeAlias = tuple[Floats, list[Cycle]]

#: Sides of the head of an arrow; its length and radius; the radius of the shaft in a model.
_HEAD_SIDES, _HEAD, _HEAD_RADIUS, _SHAFT = 6, 0.09, 0.03, 0.008
_GRID = 1 << 20


@dataclass(frozen=True)
class Arrow:
    """An arrow or, with `headless`, a segment, in picture coordinates."""

    name: str
    start: Floats
    end: Floats
    headless: bool = False


def circle(axes: Sequence[Any], count: int) -> Floats:
    """Return points around the unit circle that two orthogonal vectors span, (count, 3)."""
    return _turned(axes, np.linspace(0, 2 * math.pi, count, endpoint=False))


def _turned(axes: Sequence[Any], angles: Floats) -> Floats:
    first, second = np.array(axes, float)
    turned: Floats = np.cos(angles)[:, None] * first + np.sin(angles)[:, None] * second
    return turned


def arc(
    name: str, centre: Floats, axis: Floats, radius: float, rise: float, turns: float
) -> Iterator[Arrow]:
    """Yield segments of a circle or helix around an axis, the last one as an arrow."""
    side = across(axis)
    count = max(8, round(24 * turns))
    angles = np.linspace(0, 2 * math.pi * turns, count + 1)
    heights = np.outer(rise * (angles / (2 * math.pi) - turns / 2), axis)
    ends = centre + radius * _turned((side, np.cross(axis, side)), angles) + heights
    for k, (p, q) in enumerate(pairwise(ends)):
        yield Arrow(name, p, q, headless=k < count - 1)


def _neck(arrow: Arrow) -> Floats:
    """Return the ring around the neck of an arrow."""
    along = unit(arrow.end - arrow.start)
    side = across(along)
    ring = circle((side, np.cross(along, side)), _HEAD_SIDES)
    return np.asarray(arrow.end - _HEAD * along + _HEAD_RADIUS * ring)


def arrow_pieces(arrow: Arrow) -> list[Patch]:
    """Return the shaft and the faces of the head; of a segment, itself."""
    if arrow.headless:
        return segment(arrow.start, arrow.end, arrow.name)
    ring = _neck(arrow)
    pieces = segment(arrow.start, ring.mean(axis=0), arrow.name)
    for p, q in cycle_edges(list(ring)):
        pieces += flat([arrow.end, p, q], arrow.name)
    return pieces + flat(ring[::-1], arrow.name)


def arrow_solids(arrow: Arrow) -> Iterator[Solid]:
    """Yield the shaft of an arrow, unless the head is longer, and its head."""
    ring = _neck(arrow)
    neck = ring.mean(axis=0)
    thin = (ring - neck) * (_SHAFT / float(np.linalg.norm(ring[0] - neck)))
    end = arrow.end if arrow.headless else neck
    if float((end - arrow.start) @ (arrow.end - arrow.start)) > 0:
        yield prism(arrow.start + thin, end + thin)
    if not arrow.headless:
        yield prism(ring, np.broadcast_to(arrow.end, ring.shape))


def prism(base: Floats, top: Floats) -> Solid:
    """Return the solid between two rings, of which one may be the apex of a pyramid, repeated.

    Seen from the top both go counter-clockwise.
    """
    k = len(base)
    sides = [(j, (j + 1) % k, k + (j + 1) % k, k + j) for j in range(k)]
    return np.vstack([base, top]), [(*range(k - 1, -1, -1),), (*range(k, 2 * k),), *sides]


def ball(centre: Floats, radius: float) -> Solid:
    """Return a sphere, so fine that pictures show its silhouette alone."""
    heights, turns = (np.linspace(0, part * np.pi, n + 1) for part, n in ((1, 24), (2, 48)))
    h, a = np.meshgrid(heights[1:-1], turns[:-1], indexing="ij")
    rings = np.stack([np.sin(h) * np.cos(a), np.sin(h) * np.sin(a), -np.cos(h)], axis=-1)
    low, high = h.size, h.size + 1
    faces: list[Cycle] = []
    columns = np.arange(h.size).reshape(h.shape).T.tolist()
    for p, q in cycle_edges(columns):
        faces += [(low, q[0], p[0]), (high, p[-1], q[-1])]
        faces += zip(p, q, q[1:], p[1:], strict=False)
    return centre + radius * np.vstack([rings.reshape(-1, 3), [[0, 0, -1], [0, 0, 1]]]), faces


def _exact(point: Floats) -> IntegerVector:
    x, y, z = (round(v * _GRID) for v in point.tolist())
    return primitive((x, y, z, _GRID))


def segment(start: Floats, end: Floats, name: str) -> list[Patch]:
    """Return a segment, nothing if rounding leaves no length."""
    p, q = _exact(start), _exact(end)
    return [] if p == q else [Patch((0,) * 4, (p, q), ((p, q),), sheet=True, name=name)]


def flat(
    corners: Sequence[Floats] | Floats, name: str, edges: Sequence[tuple[Floats, Floats]] = ()
) -> list[Patch]:
    """Return a polygon, in triangles where rounding has bent it; ``a . x + b`` is < 0 inside."""
    first, *others = points = tuple(map(_exact, corners))
    lines = tuple((_exact(p), _exact(q)) for p, q in edges)
    triangles = {}
    for p, q in pairwise(others):
        if any(row := plane_through(first, q, p)):
            triangles[first, p, q] = reduced(row)
    rows = set(triangles.values())
    if len(rows) == 1:
        return [Patch(rows.pop(), points, lines, name=name)]
    return [
        Patch(row, corners, tuple(x for x in lines if set(x) <= set(corners)), name=name)
        for corners, row in triangles.items()
    ]


#: Edges at which faces meet at a larger angle than this (its cosine) are drawn.
_SHARP = math.cos(math.radians(20))


def drawn_edges(
    points: Floats, faces: Sequence[Cycle], towards: Floats | None = None
) -> set[tuple[int, int]]:
    """Return the edges at which faces meet at more than 20 degrees, or that have one face only.

    Args:
        points: (P, 3).
        faces: whose directed edges are returned, both ways.
        towards: the viewer; then those of the silhouette too, and each edge once, from a face that
            the viewer sees if there is one.
    """
    normals: dict[tuple[int, int], Floats] = {}
    for face in faces:
        normals |= dict.fromkeys(cycle_edges(face), face_normal(points[list(face)]))
    edges = set()
    for (a, b), normal in normals.items():
        other = normals.get((b, a))
        drawn = other is None or float(normal @ other) < _SHARP
        if towards is not None and other is not None:
            seen, behind = bool(normal @ towards > 0), bool(other @ towards > 0)
            drawn = (drawn or seen != behind) and (seen, a < b) > (behind, b < a)
        if drawn:
            edges.add((a, b))
    return edges


def open_edges(faces: Sequence[Cycle]) -> set[tuple[int, int]]:
    """Return the edges that have a face on one side only."""
    edges = {edge for face in faces for edge in cycle_edges(face)}
    return {edge for edge in edges if edge[::-1] not in edges}


def convex_hull(points: Floats) -> Solid:
    """Return the convex hull of points, without faces if it has no volume."""
    with extra("figures"):
        from scipy.spatial import ConvexHull, QhullError

    faces: list[Cycle] = []
    if len(points) > 3:
        with suppress(QhullError):
            hull = ConvexHull(points)
            for row, plane in zip(hull.simplices.tolist(), hull.equations, strict=True):
                outward = float(face_normal(points[row]) @ plane[:3]) > 0
                faces.append(tuple(row if outward else row[::-1]))
    return points, merge_faces(points, faces)


def merge_faces(points: Floats, faces: list[Cycle]) -> list[Cycle]:
    """Join neighbouring faces of one plane, where what comes out is convex."""
    normals = {k: face_normal(points[list(face)]) for k, face in enumerate(faces)}
    kept = {k: face for k, face in enumerate(faces) if normals[k].any()}
    owner = {edge: k for k, face in kept.items() for edge in cycle_edges(face)}
    for k in list(kept):
        waiting = list(cycle_edges(kept[k])) if k in kept else []
        while waiting:
            a, b = waiting.pop()
            j = owner.get((b, a), k)
            if j == k or float(normals[k] @ normals[j]) < 1 - 1e-9:
                continue
            joined = _join_faces(points, kept[k], kept[j], (a, b), normals[k])
            if joined is not None:
                del kept[j]
                kept[k] = joined
                waiting = list(cycle_edges(joined))
                owner |= dict.fromkeys(waiting, k)
    return list(kept.values())


def _join_faces(
    points: Floats, face: Cycle, other: Cycle, edge: tuple[int, int], up: Floats
) -> Cycle | None:
    """Return two faces of one plane, with an edge in common, as one face if it is convex."""
    a, b = edge
    at, back = face.index(b), other.index(a)
    cycle = [*face[at:], *face[:at], *other[back + 1 :], *other[:back]]
    cycle = cycle[: cycle.index(b, 1)] if cycle.count(b) > 1 else cycle
    steps = np.roll(points[cycle], -1, axis=0) - points[cycle]
    turns = np.cross(np.roll(steps, 1, axis=0), steps) @ up
    convex = len(set(cycle)) == len(cycle) and (turns > -1e-9).all()
    return tuple(cycle) if convex else None
