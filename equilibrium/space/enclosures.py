"""Boxes that may hold one equilibrium, around what Newton's method finds in floats."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.plane.contacts import nearest
from equilibrium.space.states import StateBalance

#: Sizes of boxes, relative to the motion.
_RADII = (1e-11, 1e-9, 1e-7)
_LEAST = 1e-40
_STEPS, _CLOSE = 12, 1e-9


@dataclass(frozen=True)
class Enclosed:
    """A box that may hold one equilibrium; see `equilibrium.certificate.reading.Enclosure`.

    Attributes:
        motion, forces: in floats.
    """

    basis: tuple[RationalVector, ...]
    friction: tuple[RationalVector | None, ...]
    pillars: tuple[tuple[int, int], ...]
    centre: RationalVector
    radius: RationalVector
    inverse: tuple[RationalVector, ...]
    idle: tuple[RationalVector, ...]
    motion: Floats
    forces: Floats


def enclosures(balance: StateBalance, motion: Floats) -> Iterator[Enclosed]:
    """Yield boxes around the solution that Newton's method finds near a motion."""
    p, size = len(balance.basis), len(balance.basis) + len(balance.pillars)
    if size != 6:
        return
    basis, point = balance.float_basis(), np.zeros(6)
    point[:p] = balance.coordinates(motion)
    load = np.array([nearest(w) for w in balance.wrench])
    idle = [
        (*v, *_short(np.array([nearest(x) for x in v]) @ motion[:, None], 9))
        for v in balance.unfelt
    ]
    size_of = float(np.abs(load).max()) + float(np.abs(balance.contacts.preload).max(initial=0.0))
    for k, (i, j) in enumerate(balance.pillars, p):
        c = balance.contacts
        force = max(0.0, float(c.spring[i, 0] + c.spring[i, 1:] @ motion))
        point[k] = c.friction[i] * force * balance.states.ratio[i, j]
    for _ in range(_STEPS):
        value, derivative, _ = _value(balance, basis, point, load, idle)
        try:
            step = np.linalg.solve(derivative, value)
        except np.linalg.LinAlgError:
            return
        if not np.isfinite(step).all():
            return
        point = point - step
        if np.abs(step).max() <= 1e-15 * np.abs(point).max():
            break
    value, derivative, forces = _value(balance, basis, point, load, idle)
    if not np.abs(value).max() <= _CLOSE * size_of or not np.isfinite(derivative).all():
        return
    try:
        inverse = np.linalg.inv(derivative)
    except np.linalg.LinAlgError:
        return
    error = np.abs(inverse) @ np.full(6, 1e-14 * size_of)
    for radius in _RADII:
        radii = np.maximum(
            radius * np.maximum(np.abs(point), np.abs(point[:p]).max(initial=0.0) if p else 0.0),
            error,
        )
        radii = np.maximum(radii, _LEAST)
        yield Enclosed(
            tuple(balance.basis),
            tuple(map(balance.named_share, range(len(balance.states.touching)))),
            balance.pillars,
            _short(point, 20),
            _short(radii, 2),
            tuple(_short(row, 9) for row in inverse),
            tuple(idle),
            basis @ point[:p] if p else np.zeros(6),
            forces,
        )


def _value(
    balance: StateBalance,
    basis: Floats,
    point: Floats,
    load: Floats,
    idle: Sequence[RationalVector],
) -> tuple[Floats, Floats, Floats]:
    """Return the sum of all wrenches, its derivative, and the forces."""
    c, p = balance.contacts, basis.shape[1]
    motion = basis @ point[:p]
    value, derivative, forces = load.copy(), np.zeros((6, 6)), np.zeros((len(c.grasp), 3))
    for i, touching in enumerate(balance.states.touching):
        if not touching:
            continue
        normal = c.spring[i, 0] + c.spring[i, 1:] @ motion
        slope = np.zeros(6)
        slope[:p] = c.spring[i, 1:] @ basis
        if balance.states.slipping[i]:
            slip = c.tangents[i] @ motion
            length = float(np.hypot(*slip))
            unit = slip / length if length else np.zeros(2)
            turn = np.zeros((2, 6))
            moved = c.tangents[i] @ basis
            turn[:, :p] = (moved - np.outer(unit, unit @ moved)) / (length or 1.0)
            friction = -c.friction[i] * normal * unit
            change = -c.friction[i] * (np.outer(unit, slope) + normal * turn)
        else:
            share = c.friction[i] * np.array([float(x) for x in balance.share(i)])
            friction, change = normal * share, np.outer(share, slope)
            for k, (pillar, j) in enumerate(balance.pillars, p):
                if pillar == i:
                    friction[j] += point[k]
                    change[j, k] += 1
        value = value + normal * c.normal[i] + friction @ c.tangents[i]
        derivative += np.outer(c.normal[i], slope) + c.tangents[i].T @ change
        forces[i] = normal, *friction
    for *row, x in idle:
        turn = np.array([nearest(y) for y in row])
        value = value + turn * (turn @ motion - nearest(x))
        derivative[:, :p] += np.outer(turn, turn @ basis)
    return value, derivative, forces


def _short(numbers: Floats, digits: int) -> RationalVector:
    """Return floats with so many significant digits as rationals."""
    return tuple(Fraction(f"{x:.{digits - 1}e}") for x in numbers.tolist())
