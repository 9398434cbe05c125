"""Equilibria of many questions at once, each proved to exist by a bound on errors.

The law of `equilibrium.core.continuation` is made sharper for all together, by the steps of the
path there, which takes half to two thirds of the time for one question. What it ends at is a guess
of contact states, whose conditions are a system F(z) = 0 and inequalities. The unknowns z are the
motion d and the tangential forces of the contacts that stick; in the plane F is linear, in space
the directions of slips turn with d. Let R be an approximate inverse of the Jacobian J of F at z'.
If ``|R F(z')| <= rho / 2`` and ``|I - R J(z)| <= 1/2`` (largest row sum) for all z within rho of
z', then ``z - R F(z)`` maps this box into itself and contracts: it has a zero of F [Rump2010].
Where the inequalities hold, strictly, in the whole box, there is an equilibrium. Where all contacts
stick d is 0, and the tangential forces alone have to balance the load: R is an approximate right
inverse then, and ``z' + R y`` with ``|y| <= |b - A z'| / (1 - beta)``, beta = ``|I - A R|``, a
solution of ``A z = b``. All bounds are taken over all numbers within the errors of the data.
"""

from __future__ import annotations

import numpy as np

from arrangement.numbers.float_filter import Booleans, Floats
from equilibrium.core.cones import SLIP_SHARE
from equilibrium.core.continuation import (
    MAX_PATH_STEPS,
    MAX_SMOOTHING_FACTOR,
    NEWTON_RESIDUAL,
    PATH_RESIDUAL,
    SHARP,
    SHARPEST,
    SMOOTHING_FACTOR,
)
from equilibrium.core.float_law import Balance, norms, products, smooth_slip

from .questions import Questions

#: Where a path starts that starts near an equilibrium.
_NEAR = 1e-2
_MAX_NEWTON_STEPS = 20
#: Steps to the motion of contact states.
_STATE_STEPS = 4
#: Contacts that stick while others slip, at most: with three the motion is 0, mostly.
_MAX_STICKING = 2
#: Above the rounding errors of a bound's own computation.
_MARGIN = 1.01


@np.errstate(all="ignore")  # what is not finite proves nothing
def have_equilibria(questions: Questions, starts: Floats | None = None) -> Booleans:
    """Return for which questions an equilibrium was proved to exist; false says nothing.

    Args:
        starts: motions that may be near one; paths then begin with rather sharp contacts.
    """
    first = 1.0 if starts is None else _NEAR
    proved, rows, q = np.zeros(len(questions), dtype=bool), np.arange(len(questions)), questions
    balance = Balance.of(q, q.load, smooth_slip)
    motion = np.zeros_like(q.load) if starts is None else starts
    eps, factor = np.full(len(q), first / SMOOTHING_FACTOR), np.full(len(q), SMOOTHING_FACTOR)
    for _ in range(MAX_PATH_STEPS):
        if not len(rows):
            break
        sharper = eps * factor
        end, residual = _newton(balance, motion, sharper[:, None, None])
        tried = np.flatnonzero((sharper < SHARP) & (residual < 1))
        holds = np.zeros(len(q), dtype=bool)
        if len(tried):
            near = balance.take(tried)
            force, share, _ = near.forces(end[tried], sharper[tried, None, None])
            holds[tried] = _exists_near(q.take(tried), near, end[tried], force[..., 0], share)
        proved[rows[holds]] = True
        good = residual <= PATH_RESIDUAL
        going = ~holds & np.where(good, sharper >= SHARPEST, factor <= MAX_SMOOTHING_FACTOR)
        motion, eps = np.where(good[:, None], end, motion), np.where(good, sharper, eps)
        factor = np.where(good, np.maximum(factor**2, SMOOTHING_FACTOR), factor**0.5)
        rows, q, balance = rows[going], q.take(going), balance.take(going)
        motion, eps, factor = motion[going], eps[going], factor[going]
    return proved


def _newton(balance: Balance, motion: Floats, eps: Floats) -> tuple[Floats, Floats]:
    """Return motions of less residual, and that: Newton steps, damped where they fail."""
    motion, smallest = motion.copy(), np.full(len(motion), np.inf)
    rows, at, damping = np.arange(len(motion)), motion, np.full(len(motion), 1e-14)
    value, derivative = balance.smoothed(at, eps)
    jacobian = derivative()
    residual = smallest = np.linalg.norm(value, axis=1)
    for _ in range(_MAX_NEWTON_STEPS):
        turned = jacobian.transpose(0, 2, 1)
        square = turned @ jacobian
        size = np.trace(square, axis1=1, axis2=2) + 1e-300
        square += (damping * size)[:, None, None] * np.eye(motion.shape[1])
        moved = at - _solved(square, products(turned, value))
        tried, derivative = balance.smoothed(moved, eps)
        left = np.linalg.norm(tried, axis=1)
        better = left < residual
        at, value = np.where(better[:, None], moved, at), np.where(better[:, None], tried, value)
        jacobian = np.where(better[:, None, None], derivative(), jacobian)
        stalled = better & (left > 0.999 * residual) | ~better & (damping > 1e3)
        residual = np.where(better, left, residual)
        damping = np.where(better, damping / 30, np.maximum(30 * damping, 1e-10))
        motion[rows], smallest[rows] = at, residual
        going = (residual > NEWTON_RESIDUAL) & ~stalled
        if not going.any():
            break
        rows, balance, at, eps = rows[going], balance.take(going), at[going], eps[going]
        value, jacobian, residual = value[going], jacobian[going], residual[going]
        damping = damping[going]
    return motion, smallest


def _solved(matrix: Floats, right: Floats) -> Floats:
    """Solve equations, roughly; what is singular has the solution 0."""
    try:
        solution = np.linalg.solve(matrix, right[..., None])[..., 0]
    except np.linalg.LinAlgError:  # one singular matrix ends the solution of all
        solution = products(np.linalg.pinv(np.nan_to_num(matrix)), right)
    finite: Floats = np.nan_to_num(solution, nan=0.0, posinf=0.0, neginf=0.0)
    return finite


def _exists_near(
    q: Questions, balance: Balance, motion: Floats, force: Floats, ratio: Floats
) -> Booleans:
    """Return where an equilibrium of the contact states at a motion exists.

    Args:
        force: of springs, (n, m); ratio: of friction to its limits, (n, m, t).
    """
    on = (force > 0) & q.present
    share = q.friction * np.maximum(force, 0.0)
    sticks = on & (q.friction > 0) & (norms(ratio) <= SLIP_SHARE)
    exists = np.zeros(len(q), dtype=bool)
    few = np.flatnonzero(np.count_nonzero(sticks, axis=1) <= _MAX_STICKING)
    if len(few):
        part = _FixedStates(q.take(few), balance.take(few), on[few], sticks[few])
        exists[few] = part.hold(motion[few], (share[..., None] * ratio)[few])
    rest = np.flatnonzero(~exists & np.any(q.preload > 0, axis=1))
    if len(rest):
        exists[rest] = _at_rest(q.take(rest), ratio[rest])
    return exists


class _FixedStates:
    """The balance and the conditions of n questions whose contact states are fixed.

    Attributes:
        on, slides: (n, m), which contacts are loaded, and which of these slip.
        stuck: (n, s), numbers of the sticking contacts, s at most 2, padded with other contacts.
        real: (n, s), which entries of `stuck` are not padding.
        pulls: (n, s t, k), the t tangential wrenches of each contact in `stuck`, 0 for padding.
    """

    def __init__(self, q: Questions, balance: Balance, on: Booleans, sticks: Booleans) -> None:
        self.q, self.balance, self.on, self.sticks = q, balance, on, sticks
        self.slides = on & (q.friction > 0) & ~sticks
        self.stuck = np.argsort(~sticks, axis=1, kind="stable")[:, :_MAX_STICKING]
        self.real = np.take_along_axis(sticks, self.stuck, axis=1)
        pulls = q.tangents[np.arange(len(q))[:, None], self.stuck]
        self.pulls = np.where(self.real[..., None, None], pulls, 0.0)
        self.n, (self.k, self.t) = len(q), (q.load.shape[1], q.tangents.shape[2])
        self.pulls = self.pulls.reshape(self.n, -1, self.k)
        self.weight = np.where(on, q.stiffness, 0.0)

    def _at(self, z: Floats) -> tuple[Floats, Floats]:
        """Return F and its Jacobian; forces of springs are kept."""
        k, motion = self.k, z[:, : self.k]
        self.spring, _, total, derivative = self.balance.in_states(motion, self.on, self.slides)
        filled = np.repeat(~self.real, self.t, axis=1)
        value = np.zeros_like(z)
        value[:, :k] = total + (z[:, None, k:] @ self.pulls)[:, 0]
        value[:, k:] = products(self.pulls, motion) + np.where(filled, z[:, k:], 0.0)
        jacobian = np.zeros((*z.shape, z.shape[1]))
        jacobian[:, :k, :k] = derivative()
        jacobian[:, :k, k:], jacobian[:, k:, :k] = self.pulls.transpose(0, 2, 1), self.pulls
        i = np.arange(k, z.shape[1])
        jacobian[:, i, i] = filled
        return value, jacobian

    def hold(self, motion: Floats, friction: Floats) -> Booleans:
        """Return where there is an equilibrium near a motion and friction forces (n, m, t)."""
        forces = friction[np.arange(self.n)[:, None], self.stuck] * self.real[..., None]
        z = np.concatenate([motion, forces.reshape(self.n, -1)], axis=1)
        for _ in range(_STATE_STEPS if self.t == 2 else 2):
            value, jacobian = self._at(z)
            z = z - _solved(jacobian, value)
        return self._enclosed(z)

    def _enclosed(self, z: Floats) -> Booleans:
        """Return where F surely has a zero in a box around z in which all inequalities hold."""
        q, k, m = self.q, self.k, self.q.normal.shape[1]
        value, jacobian = self._at(z)
        self.size = norms(q.slips(z[:, :k]))
        try:
            inverse = np.linalg.inv(jacobian)
        except np.linalg.LinAlgError:
            inverse = np.linalg.pinv(np.nan_to_num(jacobian))
        magnitude = np.abs(inverse)
        reach, tilt, mu = q.reach, q.tilt + q.rounding, q.friction
        way, width = products(reach, np.abs(z[:, :k])), reach.sum(axis=2)
        # Errors at z' itself: of springs, directions of slips, and so of the balance.
        spring, missed = self._errors(way)
        turned = self._turned(missed)
        share = np.where(self.on, spring, 0.0) * (1 + mu)
        share += np.where(self.on, np.abs(self.spring), 0.0) * ((1 + mu) * tilt + mu * turned)
        held = np.zeros_like(tilt)
        pulled = norms(z[:, k:].reshape(self.n, -1, self.t)) * self.real
        np.put_along_axis(held, self.stuck, pulled, axis=1)
        rounding = (m + 16) * q.unit
        share += held * tilt + rounding * (np.abs(self.spring) * self.on * (1 + mu) + held)
        error = np.zeros_like(z)
        error[:, :k] = (share[:, None] @ reach)[:, 0] + rounding * np.abs(q.load)
        stuck = np.take_along_axis(missed, self.stuck, axis=1) * self.real
        error[:, k:] = np.repeat(stuck, self.t, axis=1)
        radius = 2.1 * _MARGIN * products(magnitude, np.abs(value) + error).max(axis=1)[:, None]
        # Errors in the whole box, of the Jacobian too.
        spring, missed = self._errors(way + radius * width)
        spring, missed = spring + q.stiffness * radius * width, missed + 1.5 * radius * width
        turned, least = self._turned(missed), self.size - missed
        arm = (1 + mu) * tilt + mu * turned
        unsure = self.weight * (arm + (1 + mu + arm) * tilt + rounding * (1 + mu))
        if self.t == 2:
            bent = spring / least + (np.abs(self.spring) + spring) * (
                3 * missed / (least * least) + 3 * tilt / least
            )
            # Two tangents: twice as many terms, of at most twice their entries' size together.
            bent += 4 * rounding * np.abs(self.spring) / self.size
            unsure += np.where(self.slides, mu * bent, 0.0)
        errors = np.zeros_like(jacobian)
        errors[:, :k, :k] = reach.transpose(0, 2, 1) @ (unsure[..., None] * reach)
        rows = np.take_along_axis(tilt[..., None] * reach, self.stuck[..., None], axis=1)
        rows = np.repeat(rows * self.real[..., None], self.t, axis=1)
        errors[:, k:, :k], errors[:, :k, k:] = rows, rows.transpose(0, 2, 1)
        far = np.abs(np.eye(z.shape[1]) - inverse @ jacobian)
        far += magnitude @ (errors + (z.shape[1] + 4) * q.unit * np.abs(jacobian))
        proved = _MARGIN * far.sum(axis=2).max(axis=1) < 0.5
        sure = np.where(self.on, self.spring > _MARGIN * spring, self.spring < -_MARGIN * spring)
        sure &= ~self.slides | (self.size > _MARGIN * missed)
        most = (1 - 8 * q.unit) * mu * (self.spring - _MARGIN * spring)
        sure &= ~self.sticks | (held + 1.5 * radius < most)
        holds: Booleans = proved & (sure | ~q.present).all(axis=1) & np.isfinite(radius[:, 0])
        return holds

    def _errors(self, way: Floats) -> tuple[Floats, Floats]:
        """Return errors of springs and of slips (lengths) that go this far in each wrench."""
        q = self.q
        tilted = _MARGIN * (q.tilt + q.rounding) * way
        return q.stiffness * tilted + 5 * q.unit * (q.preload + np.abs(self.spring)), 1.5 * tilted

    def _turned(self, missed: Floats) -> Floats:
        """Return how far unit vectors along slips are off where slips are off so far."""
        if self.t == 1:
            return np.zeros_like(missed)
        return np.where(self.slides, missed / (self.size - missed) + 8 * self.q.unit, 0.0)


def _at_rest(q: Questions, ratio: Floats) -> Booleans:
    """Return where tangential forces, within the cones of the preloads, balance the load."""
    (n, m, t), k = ratio.shape, q.load.shape[1]
    most = q.friction * q.preload
    rows = (most[..., None, None] * q.tangents).reshape(n, m * t, k)
    reach = np.repeat(most[..., None] * q.reach, t, axis=1)
    spread = (np.repeat(q.tilt, t, axis=1) + q.rounding)[..., None] * reach
    right = -q.load - (q.preload[:, None] @ q.normal)[:, 0]
    wide = (q.preload * (q.tilt + q.rounding + m * q.unit))[:, None] @ q.reach
    right_error = wide[:, 0] + (m + 8) * q.unit * np.abs(q.load)
    square = rows.transpose(0, 2, 1) @ rows
    size = np.trace(square, axis1=1, axis2=2) + 1e-300
    square += 1e-15 * size[:, None, None] * np.eye(k)
    try:
        inverse = rows @ np.linalg.inv(square)
    except np.linalg.LinAlgError:
        inverse = rows @ np.linalg.pinv(square)
    share = np.clip(ratio, -SLIP_SHARE, SLIP_SHARE).reshape(n, m * t)
    for _ in range(3):
        share = share + products(inverse, right - (share[:, None] @ rows)[:, 0])
    rounding = (m * t + 6) * q.unit
    off = np.abs(right - (share[:, None] @ rows)[:, 0]) + right_error
    off += (np.abs(share)[:, None] @ (spread + rounding * reach))[:, 0]
    size = np.abs(inverse)
    far = np.abs(np.eye(k) - rows.transpose(0, 2, 1) @ inverse)
    far += (spread + rounding * reach).transpose(0, 2, 1) @ size
    beta = _MARGIN * far.sum(axis=2).max(axis=1) + k * k * q.unit
    change = _MARGIN * size.sum(axis=2) * (off.max(axis=1) / (1 - beta))[:, None]
    room = 1 - 8 * q.unit - norms(np.abs(share).reshape(n, m, t) + change.reshape(n, m, t))
    proved: Booleans = (beta < 0.9) & np.all((room > 0) | (most == 0), axis=1)
    return proved
