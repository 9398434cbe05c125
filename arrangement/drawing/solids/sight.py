"""How solids are seen: directions towards the viewer, the axes of a picture, light on a face."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import product
from typing import Any, TypeAlias

import numpy as np

from arrangement.drawing.colours import darken
from arrangement.drawing.scene import LIGHT, Floats
from arrangement.errors import InputError
from arrangement.numbers.exact import IntegerVector, primitive, shown
from arrangement.numbers.symbolic import real_vector

#: The unit vector towards the light, in the axes of a picture: the same for balls and solids.
TO_LIGHT = np.array([*LIGHT, (1 - LIGHT[0] ** 2 - LIGHT[1] ** 2) ** 0.5])
#: How good each of some views is.
Score: TypeAlias = Callable[[Sequence[IntegerVector]], Any]


def light(normal: Any) -> float:
    """Return how much a face with this unit normal, in the axes of a picture, faces the light."""
    return max(0.0, float(TO_LIGHT @ normal))


def shade(colour: str, normal: Any, least: float = 0.76) -> str:
    """Return a colour ``#rrggbb`` as it looks on a face; away from the light a share is left."""
    return darken(colour, least + (1 - least) * light(normal))


def unit(vectors: Any) -> Floats:
    """Return vectors (.., 3) with length 1; those of length 0 stay."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(vectors) / np.where(lengths > 0, lengths, 1.0)


def unit_vectors(vectors: Sequence[Sequence[Any]]) -> Floats:
    """Return unit vectors, zeros for 0; exact numbers are divided before they become floats."""
    units = unit([[float(x / (max(map(abs, v)) or 1)) for x in v] for v in vectors])
    return units if len(units) else units.reshape(0, 3)


def face_normal(corners: Floats) -> Floats:
    """Return the unit normal of a plane polygon, 0 if it has no area."""
    steps = corners[1:] - corners[0]
    return unit(np.cross(steps[:-1], steps[1:]).sum(axis=0))


def across(vector: Floats) -> Floats:
    """Return a unit vector orthogonal to another, the same for all multiples."""
    return unit(np.cross(vector, np.eye(3)[int(np.argmin(np.abs(vector)))]))


def picture_axes(direction: IntegerVector) -> Floats:
    """Return the unit vectors right, up and towards the viewer, (3, 3); z is up in the picture."""
    ahead = unit_vectors([direction])[0]
    upright = direction[0] or direction[1]
    right = unit(np.cross([0.0, 0.0, 1.0], ahead)) if upright else np.array([1.0, 0.0, 0.0])
    return np.array([right, np.cross(ahead, right), ahead])


def view_direction(direction: Sequence[object]) -> IntegerVector:
    """Return the direction towards the viewer as a primitive integer vector, or refuse it."""
    vector = primitive(real_vector(direction, "camera"))
    if len(vector) != 3 or not any(vector):
        raise InputError(f"the camera is {shown(vector)}; give three numbers that are not all 0")
    return vector


def turn_view(direction: IntegerVector, azimuth: float) -> IntegerVector:
    """Return a direction near the one that is reached by going round the upright axis.

    Args:
        azimuth: in degrees, counter-clockwise seen from above.
    """
    if not azimuth % 360:
        return direction
    (x, y, z), turn = unit_vectors([direction])[0].tolist(), math.radians(azimuth)
    c, s = math.cos(turn), math.sin(turn)
    return primitive([round(1000 * k) for k in (c * x - s * y, s * x + c * y, z)])


def views(*entries: Iterable[int], low: float = -1.0, high: float = 1.0) -> list[IntegerVector]:
    """Return the primitive directions with these entries, their height between two bounds."""
    directions = [v for v in product(*entries) if any(v) and primitive(v) == v]
    heights = unit_vectors(directions)[:, 2]
    return [v for v, z in zip(directions, heights, strict=True) if low <= z <= high]


def best_view(candidates: Sequence[IntegerVector], *scores: Score) -> IntegerVector:
    """Return the view with the highest score; of equal ones by the next score, then the first.

    >>> best_view([(1, 2, 2), (0, 1, 1), (2, 1, 2)], lambda seen: [v[2] for v in seen])
    (1, 2, 2)
    """
    for score in scores:
        values = np.round(np.asarray(score(candidates), dtype=float), 9)
        candidates = [v for v, x in zip(candidates, values, strict=True) if x == values.max()]
    return candidates[0]
