"""Arrows, arcs, segments and faces of bodies, in floats, as flat pieces of solids."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from arrangement.drawing.scene import Floats
from arrangement.drawing.solids.sight import across, face_normal, unit
from arrangement.drawing.solids.surface import Patch
from arrangement.errors import extra
from arrangement.numbers.exact import IntegerVector, primitive, reduced
from arrangement.numbers.linear.rank import cycle_edges, plane_through

#: Sides of the head of an arrow; its length and radius.
_HEAD_SIDES, _HEAD, _HEAD_RADIUS = 6, 0.09, 0.03
_GRID = 1 << 20


@dataclass(frozen=True)
class Arrow:
    """An arrow or, with `headless`, a segment, in picture coordinates."""

    name: str
    start: Floats
    end: Floats
    headless: bool = False


def arc(
    name: str, centre: Floats, axis: Floats, radius: float, rise: float, turns: float
) -> Iterator[Arrow]:
    """Yield segments of a circle or helix around an axis, the last one as an arrow."""
    side = across(axis)
    count = max(8, round(24 * turns))
    angles = np.linspace(0, 2 * math.pi * turns, count + 1)[:, None]
    ring = np.cos(angles) * side + np.sin(angles) * np.cross(axis, side)
    ends = centre + radius * ring + rise * (angles / (2 * math.pi) - turns / 2) * axis
    for k, (p, q) in enumerate(pairwise(ends)):
        yield Arrow(name, p, q, headless=k < count - 1)


def head_of(arrow: Arrow) -> tuple[Floats, Floats]:
    """Return the tip of an arrow and the ring around its neck."""
    along = unit(arrow.end - arrow.start)
    side = across(along)
    turns = np.linspace(0, 2 * math.pi, _HEAD_SIDES, endpoint=False)[:, None]
    ring = np.cos(turns) * side + np.sin(turns) * np.cross(along, side)
    return arrow.end, arrow.end - _HEAD * along + _HEAD_RADIUS * ring


def arrow_pieces(arrow: Arrow) -> list[Patch]:
    """Return the shaft and the faces of the head; of a segment, itself."""
    if arrow.headless:
        return segment(arrow.start, arrow.end, arrow.name)
    tip, ring = head_of(arrow)
    shaft = segment(arrow.start, ring.mean(axis=0), arrow.name)
    for p, q in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        shaft += flat([tip, p, q], arrow.name, [])
    return shaft + flat(list(ring[::-1]), arrow.name, [])


def _exact(point: Floats) -> IntegerVector:
    x, y, z = (round(v * _GRID) for v in point.tolist())
    return primitive((x, y, z, _GRID))


def segment(start: Floats, end: Floats, name: str) -> list[Patch]:
    """Return a segment, nothing if rounding leaves no length."""
    p, q = _exact(start), _exact(end)
    return [] if p == q else [Patch((0,) * 4, (p, q), ((p, q),), sheet=True, name=name)]


def flat(
    corners: Sequence[Floats], name: str, edges: Sequence[tuple[Floats, Floats]]
) -> list[Patch]:
    """Return a polygon, in triangles where rounding has bent it; ``a . x + b`` is < 0 inside."""
    points = [_exact(p) for p in corners]
    planes = (plane_through(points[0], q, p) for p, q in pairwise(points[1:]))
    rows = [reduced(row) if any(row) else None for row in planes]
    lines = tuple((_exact(p), _exact(q)) for p, q in edges)
    if len({row for row in rows if row}) == 1:
        return [Patch(next(row for row in rows if row), tuple(points), lines, name=name)]
    pieces = []
    for k, row in enumerate(rows):
        if row:
            triangle = (points[0], points[k + 1], points[k + 2])
            own = tuple(line for line in lines if set(line) <= set(triangle))
            pieces.append(Patch(row, triangle, own, name=name))
    return pieces


#: Numbers of points, counter-clockwise seen from outside.
Cycle: TypeAlias = tuple[int, ...]

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
    normals = {}
    for face in faces:
        normal = face_normal(points[list(face)])
        normals.update(dict.fromkeys(cycle_edges(face), normal))
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


def open_edges(faces: Sequence[Cycle]) -> Iterator[tuple[int, int]]:
    """Yield the edges that have a face on one side only."""
    every = {edge for face in faces for edge in cycle_edges(face)}
    return (edge for edge in every if edge[::-1] not in every)


def convex_hull(points: Floats) -> tuple[Floats, list[Cycle]]:
    """Return the convex hull of points, without faces if it has no volume."""
    with extra("figures"):
        from scipy.spatial import ConvexHull, QhullError

    if len(points) < 4:
        return points, []
    try:
        hull = ConvexHull(points)
    except QhullError:
        return points, []
    middle = points[hull.vertices].mean(axis=0)
    faces = []
    for row in hull.simplices.tolist():
        outward = float(face_normal(points[row]) @ (points[row].mean(axis=0) - middle)) > 0
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
                owner |= dict.fromkeys(cycle_edges(joined), k)
                waiting = list(cycle_edges(joined))
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
