"""The faces of a body in space: joined where they are flat, and which of their edges are drawn."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TypeAlias

import numpy as np

from arrangement.drawing.scene.scene import Floats
from arrangement.drawing.solids.sight import face_normal
from arrangement.numbers.linear.rank import cycle_edges

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
    found = set()
    for (a, b), normal in normals.items():
        other = normals.get((b, a))
        drawn = other is None or float(normal @ other) < _SHARP
        if towards is not None and other is not None:
            seen, behind = bool(normal @ towards > 0), bool(other @ towards > 0)
            drawn = (drawn or seen != behind) and (seen, a < b) > (behind, b < a)
        if drawn:
            found.add((a, b))
    return found


def open_edges(faces: Sequence[Cycle]) -> Iterator[tuple[int, int]]:
    """Yield the edges that have a face on one side only."""
    every = {edge for face in faces for edge in cycle_edges(face)}
    return (edge for edge in every if edge[::-1] not in every)


def convex_hull(points: Floats) -> tuple[Floats, list[Cycle]]:
    """Return the convex hull of points, without faces if it has no volume."""
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
    return points, merged(points, faces)


def merged(points: Floats, faces: list[Cycle]) -> list[Cycle]:
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
            joined = _joined(points, kept[k], kept[j], (a, b), normals[k])
            if joined is not None:
                del kept[j]
                kept[k] = joined
                owner |= dict.fromkeys(cycle_edges(joined), k)
                waiting = list(cycle_edges(joined))
    return list(kept.values())


def _joined(
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
