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
from equilibrium.core.contacts import FloatContacts, nearest
from equilibrium.core.float_law import Balance, smooth_slip
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
    springs = np.maximum(0.0, c.spring_forces(motion))
    for k, (i, j) in enumerate(balance.pillars, p):
        start[k] = c.friction[i] * springs[i] * balance.states.ratio[i, j]
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
    spring, force = balance.contacts.spring, balance.contacts.spring_forces(motion)
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
        self.basis = array(balance.basis, len(balance.basis), n).T
        self.contacts = balance.contacts if number is nearest else FloatContacts(rows, number)
        self.law = Balance.of(self.contacts, array([balance.wrench], n), smooth_slip)
        self.on, self.slides = np.array(balance.states.touching), np.array(balance.states.slipping)
        self.held = array(map(balance.share, range(m)), m, 2)
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
        law, basis, p = self.law, self.basis, len(self.balance.basis)
        motion = basis @ point[:p] if p else np.zeros(len(self.basis), self.type)
        force, share, value, slope = law.in_states(motion, self.on, self.slides, self.held)
        # Friction along pillars is unknown, beside what is held.
        pillars = np.array(self.balance.pillars, dtype=int).reshape(-1, 2).T
        pulls = law.tangents[tuple(pillars)]
        value = value + point[p:] @ pulls
        jacobian = slope()
        for row in self.idle:
            value = value + row[:-1] * (row[:-1] @ motion - row[-1])
            jacobian = jacobian + np.outer(row[:-1], row[:-1])
        normal = np.where(self.on, force, 0)[:, None]
        forces = np.hstack([normal, normal * self.contacts.friction[:, None] * share])
        forces[pillars[0], pillars[1] + 1] += point[p:]
        return value, np.hstack([jacobian @ basis, pulls.T]), motion, forces


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
