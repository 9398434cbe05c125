"""Points along curves of a picture."""

from __future__ import annotations

import math

import numpy as np

from .items import Floats, Place


def flattened(curve: Floats, steps: int = 24) -> Floats:
    """Return points along cubic curves given by control points (3k + 1, 2)."""
    t = np.linspace(0, 1, steps, endpoint=False)[:, None, None]
    p, q, r, end = curve[:-1:3], curve[1::3], curve[2::3], curve[3::3]
    points = (1 - t) ** 3 * p + 3 * t * (1 - t) ** 2 * q + 3 * t**2 * (1 - t) * r + t**3 * end
    return points.transpose(1, 0, 2).reshape(-1, 2)


def along(curve: Floats, steps: int = 8) -> Floats:
    """Return points along cubic curves with both ends."""
    return np.vstack([flattened(curve, steps), curve[-1:]])


def ring(centre: Place, radius: float, steps: int = 200) -> Floats:
    """Return points along a circle, the last one as the first."""
    at = np.linspace(0, 2 * math.pi, steps)
    return np.asarray(centre) + radius * np.stack([np.cos(at), np.sin(at)], axis=1)
