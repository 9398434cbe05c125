"""The numbers of many questions, in floats, with bounds of their errors.

A question is a grasp and a load. Its units are powers of two, in which its largest numbers are
about one: of length, of force, and of displacement, near what springs yield. So scaling is exact.
Rows are wrenches in R^k, k = 3 in the plane and 6 in space, where a contact has two tangents.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from arrangement.numbers.float_filter import UNIT, Booleans, Floats
from equilibrium.core.float_law import Batch, FloatLaw

#: Largest tangent of the angle from a given normal to the rational unit normal that stands for it.
ANGLE = Fraction(1, 10**12)
#: How far normals and tangents in floats are off at most, their rounding included.
_TILT = 1.1e-12
#: Relative error by rounding of wrenches, and of their scalar products with motions, in units.
_ROUNDING = 10
#: How much larger errors are where the numbers of the question were rounded to floats, too. Each is
#: off by a share of one unit then; every bound counts five units or more for a product of at most
#: four of them (of point, normal, friction and spring), and 5 + 4 is at most 4 * 5.
_ROUNDED = 4
#: Numbers but 0 below this, or above its inverse, in the units of the question: no screening.
_SMALLEST = 2.0**-100


@dataclass
class Questions(FloatLaw, Batch):
    """n questions on up to m contacts; contacts that never press have zeros alone.

    The exact unit normal of a contact is the given direction turned by a small angle, and its
    tangents turn along. So N and the wrench of a unit vector among the tangents are off by at most
    `tilt` times `reach` in each entry, beside what computing them rounds.

    Numbers that are called exact, but 0, are off by a share of `UNIT` where `unit` is larger.

    Attributes:
        load: (n, k), exact.
        normal: (n, m, k), N.
        tangents: (n, m, t, k), T, t = 1 in the plane and 2 in space.
        tilt: (n, m), the angle at most; 0 where the normal is along an axis.
        reach: (n, m, k), not below the absolute entries of wrenches of unit forces.
        friction, stiffness, preload: (n, m), exact.
        unit: relative error of one operation, in all bounds.
    """

    load: Floats
    normal: Floats
    tangents: Floats
    tilt: Floats
    reach: Floats
    friction: Floats
    stiffness: Floats
    preload: Floats
    unit: float = UNIT

    @property
    def rounding(self) -> float:
        """Relative error of wrenches, and of their scalar products with motions."""
        return _ROUNDING * self.unit

    def __len__(self) -> int:
        return len(self.load)

    @property
    def present(self) -> Booleans:
        """Which contacts may press, (n, m)."""
        present: Booleans = self.reach[..., 0] > 0
        return present


@np.errstate(all="ignore")  # questions with extreme numbers are not used
def questions(
    points: Floats,
    normals: Floats,
    values: tuple[Floats, Floats, Floats],
    loads: Floats,
    rounded: bool = False,
) -> tuple[Questions, Booleans]:
    """Return the questions, and which of them may be screened: no number is extreme.

    Args:
        points, normals: (n, m, 2) or (n, m, 3); NaN for contacts that are missing.
        values: friction, stiffness and preload, (n, m).
        loads: (n, k).
        rounded: whether these are the nearest floats of other numbers, 0 of 0 alone.
    """
    is_force = np.arange(loads.shape[1]) < points.shape[2]
    friction, stiffness, preload = values
    pressing = ~np.isnan(points[..., 0]) & ((stiffness > 0) | (preload > 0))
    friction, stiffness, preload = (np.where(pressing, x, 0.0) for x in values)
    points, normals = (np.where(pressing[..., None], x, 0.0) for x in (points, normals))
    # Then nothing underflows on the way.
    moderate = _moderate(_SMALLEST**2, loads, friction, stiffness, preload, points)
    length = _unit(np.abs(points).max(axis=(1, 2), initial=0.0))
    load = loads / np.where(is_force, 1.0, length[:, None])
    force = _unit(np.maximum(np.abs(load).max(axis=1), preload.max(axis=1, initial=0.0)))
    load, preload = load / force[:, None], preload / force[:, None]
    points = points / length[:, None, None]
    # Typical displacements, as the search for one question takes them.
    step = 3 * np.abs(load).max(axis=1) / stiffness.sum(axis=1)
    shares = np.sort(np.where(stiffness > 0, preload / stiffness, np.inf), axis=1)
    if shares.size:
        middle = (np.count_nonzero(stiffness > 0, axis=1) - 1) // 2
        step = np.fmax(step, 2 * shares[np.arange(len(step)), middle])
    stiffness = stiffness * _unit(np.where(np.isfinite(step), step, 1.0))[:, None]
    usable = moderate & _moderate(_SMALLEST, load, friction, stiffness, preload, points)
    unit = _directions(normals)
    frame = np.stack([unit, *_tangents(unit)], axis=2)
    wrenches = np.concatenate([frame, _torques(points[:, :, None], frame)], axis=3)
    arms = np.abs(points).sum(axis=2, keepdims=True)
    reach = np.where(is_force, 1.0, arms) * pressing[..., None]
    # Normals along an axis are exact.
    tilt = _TILT * (np.count_nonzero(normals, axis=2) > 1)
    normal, tangents = wrenches[:, :, 0], wrenches[:, :, 1:]
    relative = _ROUNDED * UNIT if rounded else UNIT
    return (
        Questions(load, normal, tangents, tilt, reach, friction, stiffness, preload, relative),
        usable,
    )


def _torques(points: Floats, forces: Floats) -> Floats:
    """Return the torques of forces at points, one number in the plane, three in space."""
    if forces.shape[-1] == 3:
        return np.cross(points, forces)
    return (points[..., :1] * forces[..., 1:]) - (points[..., 1:] * forces[..., :1])


def _directions(vectors: Floats) -> Floats:
    """Return vectors divided by their lengths; those of length 0 stay."""
    largest = np.abs(vectors).max(axis=2, keepdims=True, initial=0.0)
    moderate = vectors / np.where(largest > 0, largest, 1.0)
    length = np.sqrt((moderate * moderate).sum(axis=2, keepdims=True))
    units: Floats = moderate / np.where(length > 0, length, 1.0)
    return units


def _tangents(unit: Floats) -> list[Floats]:
    """Return unit vectors at right angles to unit normals and to each other, one or two."""
    if unit.shape[2] == 2:
        return [np.stack([-unit[..., 1], unit[..., 0]], axis=2)]
    axis = np.eye(3)[np.abs(unit).argmin(axis=2)]
    first = _directions(np.cross(unit, axis))
    return [first, np.cross(unit, first)]


def _moderate(smallest: float, *numbers: Floats) -> Booleans:
    """Return for which questions all numbers but 0 have sizes from this to its inverse."""
    sizes = np.abs(np.concatenate([x.reshape(len(x), -1) for x in numbers], axis=1))
    moderate = (sizes == 0) | ((sizes >= smallest) & (sizes <= 1 / smallest))
    every: Booleans = moderate.all(axis=1)
    return every


def _unit(sizes: Floats) -> Floats:
    """Return the power of two above each number; 1 for 0."""
    return np.where(sizes > 0, np.ldexp(1.0, np.frexp(sizes)[1]), 1.0)
