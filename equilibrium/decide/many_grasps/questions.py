"""The numbers of many questions in the plane, in floats, with bounds of their errors.

A question is a grasp and a load. Its units are powers of two, in which its largest numbers are
about one: of length, of force, and of displacement, near what springs yield. So scaling is exact.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.numbers.float_filter import UNIT, Booleans, Floats

#: Largest tangent of the angle from a given normal to the rational unit normal that stands for it,
#: in the plane and in space, where finer ones take long to find.
ANGLES = {2: Fraction(1, 10**12), 3: Fraction(1, 10**6)}
#: Error in the plane of the entries of a unit normal, with this angle and what computing it rounds.
_NORMAL_ERROR = 1.1e-12
#: Numbers but 0 below this, or above its inverse, in the units of the question: no screening.
_SMALLEST = 2.0**-100


@dataclass
class Questions:
    """n questions on up to m contacts; contacts that never press have zeros alone.

    Attributes:
        load: (n, 3), exact.
        normal, tangent: (n, m, 3), N and T.
        spread: (n, m, 3), errors of N and T at most; 0 where the normal is along an axis.
        reach: (n, m, 3), not below the absolute entries of N and T.
        friction, stiffness, preload: (n, m), exact.
    """

    load: Floats
    normal: Floats
    tangent: Floats
    spread: Floats
    reach: Floats
    friction: Floats
    stiffness: Floats
    preload: Floats

    def __len__(self) -> int:
        return len(self.load)

    def take(self, rows: Any) -> Questions:
        """Return some of the questions."""
        return Questions(*(getattr(self, entry.name)[rows] for entry in fields(self)))

    def spring_forces(self, motion: Floats) -> tuple[Floats, Floats]:
        """Return ``preload - stiffness N . d`` for motions (n, 3), and bounds of the errors."""
        force = self.preload - self.stiffness * along(self.normal, motion)
        shift = 10 * UNIT * along(self.reach, np.abs(motion)) + along(self.spread, np.abs(motion))
        return force, self.stiffness * shift + 10 * UNIT * self.preload


def along(rows: Floats, motion: Floats) -> Floats:
    """Return the scalar products of rows (n, m, 3) with a vector (n, 3) each."""
    products: Floats = np.einsum("nmi,ni->nm", rows, motion)
    return products


@np.errstate(all="ignore")  # questions with extreme numbers are not used
def questions(
    points: Floats, normals: Floats, values: tuple[Floats, Floats, Floats], loads: Floats
) -> tuple[Questions, Booleans]:
    """Return the questions, and which of them may be screened: no number is extreme.

    Args:
        points, normals: (n, m, 2); NaN for contacts that are missing.
        values: friction, stiffness and preload, (n, m).
        loads: (n, 3).
    """
    friction, stiffness, preload = values
    pressing = ~np.isnan(points[..., 0]) & ((stiffness > 0) | (preload > 0))
    friction, stiffness, preload = (np.where(pressing, x, 0.0) for x in values)
    points, normals = (np.where(pressing[..., None], x, 0.0) for x in (points, normals))
    # Then nothing underflows on the way.
    given = _moderate(_SMALLEST**2, loads, friction, stiffness, preload, points)
    length = _unit(np.abs(points).max(axis=(1, 2), initial=0.0))
    arms = np.stack([np.ones_like(length), np.ones_like(length), length], axis=1)
    load = loads / arms
    force = _unit(np.maximum(np.abs(load).max(axis=1), preload.max(axis=1, initial=0.0)))
    load, preload, points = (
        load / force[:, None],
        preload / force[:, None],
        points / length[:, None, None],
    )
    # Typical displacements, as the search for one question takes them.
    step = 3 * np.abs(load).max(axis=1) / stiffness.sum(axis=1)
    shares = np.sort(np.where(stiffness > 0, preload / stiffness, np.inf), axis=1)
    if shares.size:
        middle = (np.count_nonzero(stiffness > 0, axis=1) - 1) // 2
        step = np.fmax(step, 2 * shares[np.arange(len(step)), middle])
    stiffness = stiffness * _unit(np.where(np.isfinite(step), step, 1.0))[:, None]
    usable = given & _moderate(_SMALLEST, load, friction, stiffness, preload, points)
    largest = np.abs(normals).max(axis=2, keepdims=True, initial=0.0)
    unit = normals / np.where(largest > 0, largest, 1.0)
    size = np.hypot(unit[..., 0], unit[..., 1])[..., None]
    unit = unit / np.where(size > 0, size, 1.0)
    (x, y), (u, v) = np.moveaxis(points, 2, 0), np.moveaxis(unit, 2, 0)
    normal, tangent = np.stack([u, v, x * v - y * u], 2), np.stack([-v, u, x * u + y * v], 2)
    ones = pressing.astype(float)
    reach = np.stack([ones, ones, np.abs(x) + np.abs(y)], axis=2)
    spread = np.where((normals != 0).all(axis=2)[..., None], _NORMAL_ERROR, 0.0) * reach
    return (
        Questions(load, normal, tangent, spread, reach, friction, stiffness, preload),
        usable,
    )


def _moderate(smallest: float, *numbers: Floats) -> Booleans:
    """Return for which questions all numbers but 0 have sizes from this to its inverse."""
    sizes = np.abs(np.concatenate([x.reshape(len(x), -1) for x in numbers], axis=1))
    moderate: Booleans = ((sizes == 0) | ((sizes >= smallest) & (sizes <= 1 / smallest))).all(
        axis=1
    )
    return moderate


def _unit(sizes: Floats) -> Floats:
    """Return the power of two above each number; 1 for 0."""
    exponents = np.frexp(sizes)[1]
    units: Floats = np.where(sizes > 0, np.ldexp(1.0, exponents), 1.0)
    return units
