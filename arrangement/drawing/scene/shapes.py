"""Arrows and arcs on a scene."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.scene import Scene


def arrow(
    scene: Scene, start: Floats, end: Floats, size: float = 1.5, **style: Any
) -> list[Floats]:
    """Draw an arrow, never so short that what is not zero cannot be seen; return its corners.

    Args:
        size: of its head, and of its least length, in units of 2.5 points.
    """
    apart = float(np.linalg.norm(end - start))
    along, length = (end - start) / max(apart, 1e-9), max(apart, 2.5 * size)
    side = np.array([-along[1], along[0]])
    head = min(6.5 * size, 0.7 * length)
    wide, thin = 0.42 * head, min(0.8 * size, 0.1 * head)
    end = start + length * along
    neck = end - head * along
    half = [(start, thin), (neck, thin), (neck, wide)]
    left, right = ([at + way * out * side for at, out in half] for way in (1, -1))
    corners = [*left, end, *reversed(right)]
    scene.polygon(corners, **{"joinstyle": "miter", "role": "arrow", **style})
    return [*corners, corners[0]]


def arc(centre: Floats, radius: float, start: float, sweep: float) -> Floats:
    """Return a circular arc as control points (13, 2) of cubic curves; angles in radians."""
    angles = np.linspace(start, start + sweep, 5)
    handle = 4 / 3 * math.tan(sweep / 16)
    radial = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    tangent = np.stack([-radial[:, 1], radial[:, 0]], axis=1)
    return centre + radius * joined(radial, handle * tangent)


def turning_arrow(scene: Scene, centre: Floats, radius: float, way: int, **style: Any) -> None:
    """Draw an arc about a centre and its head; it turns counter-clockwise for `way` 1."""
    start, sweep = math.radians(-50), math.radians(250)
    curve = arc(centre, radius, start if way > 0 else math.pi - start, way * sweep)
    out = (curve[-1] - centre) / radius
    ahead = way * np.array([-out[1], out[0]])
    head = [curve[-1] + 4.5 * ahead, curve[-1] + 2.6 * out, curve[-1] - 2.6 * out]
    gid, colour, order = style["gid"], style["color"], style["zorder"]
    scene.curve(curve, fill=False, ec=colour, lw=1.5, gid=gid, zorder=order)
    scene.polygon(head, fc=colour, ec="none", gid=f"{gid}-head", zorder=order, role="arrow")


def joined(place: Floats, handle: Floats) -> Floats:
    """Return the control points of cubic curves through `place` with the given handles."""
    curve = np.empty((3 * len(place) - 2, 2))
    curve[0::3] = place
    curve[1::3] = place[:-1] + handle[:-1]
    curve[2::3] = place[1:] - handle[1:]
    return curve
