"""Boxes that may hold one equilibrium, around what Newton's method finds.

It runs in floats, then in decimals of 60 digits: with a friction of 10^12, or springs of 10^3
beside 10^-3, floats miss forces by as much as the load.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from decimal import Context, Decimal, localcontext
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.core.contacts import nearest
from equilibrium.core.states import StateBalance
from equilibrium.model.solution import Enclosure, Solution

#: Boxes tried in floats: sizes relative to the motion, and digits of the inverses.
_FLOAT_BOXES = ((1e-11, 9), (1e-9, 9), (1e-7, 9))
#: The same in decimals.
_DECIMAL_BOXES = ((1e-30, 30),)
#: No box is smaller: the checker wants radii above 0.
_MIN_RADIUS = 1e-40
#: Significant digits of the centres of boxes found in floats, and in decimals.
_FLOAT_CENTRE_DIGITS = 20
_DECIMAL_CENTRE_DIGITS = 45
_DECIMALS = Context(prec=60, Emin=-200, Emax=200)
_MAX_NEWTON_STEPS = 24
#: After this many steps each has to be an eighth of the last at most.
_FREE_NEWTON_STEPS = 6
#: What may be left over, as a share of the load.
_MAX_RESIDUAL = 1e-9
#: Relative error of sums in floats, with room.
_SUM_ERROR = 1e-13


def enclosures(balance: StateBalance, motion: Floats) -> Iterator[Solution]:
    """Yield boxes around the solution that Newton's method finds near a motion."""
    p, size = len(balance.basis), len(balance.basis) + len(balance.pillars)
    c, n = balance.contacts, balance.contacts.rows.n
    if size != n:
        return
    start = np.zeros(n)
    start[:p] = balance.coordinates(motion)
    for k, (i, j) in enumerate(balance.pillars, p):
        force = max(0.0, float(c.spring[i, 0] + c.spring[i, 1:] @ motion))
        start[k] = c.friction[i] * force * balance.states.ratio[i, j]
    if not np.isfinite(start).all():
        return
    idle = [
        (*v, *_short([float(np.array([nearest(x) for x in v]) @ motion)], 9))
        for v in balance.unfelt
    ]
    load = max(map(nearest, map(abs, balance.wrench))) + float(c.preload.max(initial=0.0))
    for number in (nearest, _decimal):
        floats = number is nearest
        try:
            with localcontext(_DECIMALS):
                reached = _System(balance, idle, number).newton(start)
        except (ArithmeticError, np.linalg.LinAlgError):
            # A derivative has no inverse, or decimals grow too long.
            continue
        point, value, inverse, *numbers = reached
        if not (np.abs(value).max() <= _MAX_RESIDUAL * load and np.abs(inverse).max() < 1e200):
            continue
        sizes = np.abs(point).astype(float)
        error = np.abs(inverse).astype(float).sum(axis=1) * load
        end, forces = (x.astype(float).tolist() for x in numbers)
        for radius, digits in _FLOAT_BOXES if floats else _DECIMAL_BOXES:
            radii = radius * np.maximum(sizes, sizes[:p].max(initial=0.0))
            radii = np.maximum(radii, error * (1e-14 if floats else 1e-40))
            if _leaves_states(balance, np.array(end), radii[:p]):
                continue
            box = Enclosure(
                tuple(balance.basis),
                tuple(map(balance.named_share, range(len(c.rows)))),
                balance.pillars,
                _short(point, _FLOAT_CENTRE_DIGITS if floats else _DECIMAL_CENTRE_DIGITS),
                _short(np.maximum(radii, _MIN_RADIUS), 2),
                tuple(_short(row, digits) for row in inverse),
                tuple(idle),
            )
            moved, *pressed = (tuple(map(Fraction, row)) for row in (end, *forces))
            yield Solution(moved, tuple(pressed), box)


def _leaves_states(balance: StateBalance, motion: Floats, radii: Floats) -> bool:
    """Return whether some motion of a box surely detaches a touching contact, or attaches another.

    The checker would refuse it, after far longer.
    """
    spring = balance.contacts.spring
    force = spring[:, 0] + spring[:, 1:] @ motion
    basis = np.array([[nearest(x) for x in row] for row in balance.basis]).reshape(-1, len(motion))
    reach = np.abs(spring[:, 1:] @ basis.T) @ radii
    reach -= _SUM_ERROR * (np.abs(spring[:, 0]) + np.abs(spring[:, 1:]) @ np.abs(motion))
    return bool((np.where(balance.states.touching, -force, force) + reach > 0).any())


class _System:
    """Balance of given states as n equations, in floats or in decimals."""

    def __init__(
        self,
        balance: StateBalance,
        idle: Iterable[RationalVector],
        number: Callable[[Fraction], Any],
    ) -> None:
        rows, self.balance, self.number = balance.contacts.rows, balance, number
        self.type: Any = float if number is nearest else object

        def array(table: Iterable[Iterable[Fraction]], *shape: int) -> Any:
            listed = [[number(x) for x in row] for row in table]
            return np.array(listed, dtype=self.type).reshape(shape)

        m, n = len(rows), rows.n
        self.load = array([balance.wrench], n)
        self.basis = array(balance.basis, len(balance.basis), n).T
        self.spring = array(balance.contacts.springs, m, n + 1)
        self.normal = array((c.normal_wrench for c in rows), m, n)
        self.tangents = array((row for c in rows for row in c.tangential_wrenches), m, 2, n)
        self.friction = array([[c.friction for c in rows]], m)
        self.shares = array(map(balance.share, range(m)), m, 2)
        self.idle = [array([row], n + 1) for row in idle]

    def newton(self, point: Any) -> tuple[Any, ...]:
        """Return the end, and there: the sum, its derivative's inverse, the motion, the forces."""
        point = np.array([self.number(Fraction(x)) for x in point.tolist()], dtype=self.type)
        close = 1e-15 if self.type is float else Decimal(10) ** -_DECIMAL_CENTRE_DIGITS
        last, long = False, point[0]
        for k in range(_MAX_NEWTON_STEPS):
            value, derivative, motion, forces = self._value(point)
            inverse = _inverse(derivative)
            if last:
                break
            step = inverse @ value
            point = point - step
            long, before = np.abs(step).max(), long
            # Near a root that has an inverse steps shrink faster and faster.
            last = bool(
                long <= close * np.abs(point).max()
                or (k >= _FREE_NEWTON_STEPS and 8 * long > before)
            )
        return point, value, inverse, motion, forces

    def _value(self, point: Any) -> tuple[Any, Any, Any, Any]:
        """Return the sum of all wrenches, its derivative, the motion and the forces."""
        balance, basis, p = self.balance, self.basis, len(self.balance.basis)
        zeros = np.zeros((len(self.load), len(self.load)), self.type)
        motion = basis @ point[:p] if p else zeros[0]
        value, derivative = self.load.copy(), zeros.copy()
        forces = np.zeros((len(self.spring), 3), self.type)
        for i, touching in enumerate(balance.states.touching):
            if not touching:
                continue
            normal = self.spring[i, 0] + self.spring[i, 1:] @ motion
            slope = zeros[0].copy()
            slope[:p] = self.spring[i, 1:] @ basis
            if balance.states.slipping[i]:
                slip = self.tangents[i] @ motion
                square = slip @ slip
                length = (square**0.5 if self.type is float else square.sqrt()) or self.number(
                    Fraction(1)
                )
                unit = slip / length
                turn = zeros[:2].copy()
                moved = self.tangents[i] @ basis
                turn[:, :p] = (moved - np.outer(unit, unit @ moved)) / length
                friction = -self.friction[i] * normal * unit
                change = -self.friction[i] * (np.outer(unit, slope) + normal * turn)
            else:
                share = self.friction[i] * self.shares[i]
                friction, change = normal * share, np.outer(share, slope)
                for k, (pillar, j) in enumerate(balance.pillars, p):
                    if pillar == i:
                        friction[j] += point[k]
                        change[j, k] += 1
            value = value + normal * self.normal[i] + friction @ self.tangents[i]
            derivative += np.outer(self.normal[i], slope) + self.tangents[i].T @ change
            forces[i] = normal, *friction
        for row in self.idle:
            value = value + row[:-1] * (row[:-1] @ motion - row[-1])
            derivative[:, :p] += np.outer(row[:-1], row[:-1] @ basis)
        return value, derivative, motion, forces


def _inverse(matrix: Any) -> Any:
    """Return the inverse; ArithmeticError or LinAlgError if there is none in the numbers given."""
    if matrix.dtype != object:
        return np.linalg.inv(matrix)
    n = len(matrix)
    table = np.hstack([matrix, np.diag([Decimal(1)] * n)])
    for k in range(n):
        top = k + int(np.abs(table[k:, k]).argmax())
        table[[k, top]] = table[[top, k]]
        table[k] = table[k] / table[k, k]
        others = np.arange(n) != k
        table[others] -= np.outer(table[others, k], table[k])
    return table[:, n:]


def _decimal(x: Fraction | int) -> Decimal:
    """Return a number rounded to the digits in use."""
    return Decimal(x.numerator) / x.denominator


def _short(numbers: Iterable[Any], digits: int) -> RationalVector:
    """Return numbers with a given number of significant digits as rationals."""
    return tuple(Fraction(f"{x:.{digits - 1}e}") for x in numbers)
