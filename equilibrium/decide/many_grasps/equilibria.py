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

from typing import Any

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
        sharper = eps * factor
        end, residual = _newton(balance, motion, sharper[:, None, None])
        tried = np.flatnonzero((sharper < SHARP) & (residual < 1))
        holds = np.zeros(len(rows), dtype=bool)
        if len(tried):
            near = balance.take(tried)
            force, share, _ = near.forces(end[tried], sharper[tried, None, None])
            holds[tried] = _exists_near(q[tried], near, end[tried], force[..., 0], share)
        proved[rows[holds]] = True
        good = residual <= PATH_RESIDUAL
        motion, eps = np.where(good[:, None], end, motion), np.where(good, sharper, eps)
        going = ~holds & np.where(good, sharper >= SHARPEST, factor <= MAX_SMOOTHING_FACTOR)
        factor = np.where(good, np.maximum(factor**2, SMOOTHING_FACTOR), factor**0.5)
        if not going.any():
            break
        rows, q, balance = rows[going], q[going], balance.take(going)
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


def _inverse(matrix: Floats) -> Any:
    try:
        return np.linalg.inv(matrix)
    except np.linalg.LinAlgError:
        return np.linalg.pinv(np.nan_to_num(matrix))


def _exists_near(
    q: Questions, balance: Balance, motion: Floats, force: Floats, ratio: Floats
) -> Booleans:
    """Return where an equilibrium of the contact states at a motion exists.

    Args:
        force: of springs, (n, m); ratio: of friction to its limits, (n, m, t).
    """
    on = (force > 0) & q.present
    sticks = on & (q.friction > 0) & (norms(ratio) <= SLIP_SHARE)
    friction = (q.friction * np.maximum(force, 0.0))[..., None] * ratio
    exists = np.zeros(len(q), dtype=bool)
    few = np.flatnonzero(np.count_nonzero(sticks, axis=1) <= _MAX_STICKING)
    if len(few):
        near = q[few], balance.take(few), on[few], sticks[few], motion[few], friction[few]
        exists[few] = _exist_in_states(*near)
    rest = np.flatnonzero(~exists & np.any(q.preload > 0, axis=1))
    if len(rest):
        exists[rest] = _at_rest(q[rest], ratio[rest])
    return exists


def _exist_in_states(
    q: Questions,
    balance: Balance,
    on: Booleans,
    sticks: Booleans,
    motion: Floats,
    friction: Floats,
) -> Booleans:
    """Return where an equilibrium of fixed contact states surely exists near a motion.

    Args:
        on, sticks: (n, m), which contacts are loaded, and which of these stick, two at most.
        friction: forces near those of contacts that stick, (n, m, t).
    """
    (n, m, t), k, mu = friction.shape, motion.shape[1], q.friction
    slides = on & (mu > 0) & ~sticks
    # The contacts that stick, and others in place of missing ones, without effect.
    stuck = np.arange(n)[:, None], np.argsort(~sticks, axis=1, kind="stable")[:, :_MAX_STICKING]
    real = sticks[stuck]
    filled = np.repeat(~real, t, axis=1)
    pulls = np.where(real[..., None, None], q.tangents[stuck], 0.0).reshape(n, -1, k)

    def system(z: Floats) -> tuple[Floats, Floats, Floats]:
        """Return F, its Jacobian, and forces of springs."""
        spring, _, total, derivative = balance.in_states(z[:, :k], on, slides)
        total = total + (z[:, None, k:] @ pulls)[:, 0]
        value = np.concatenate([total, products(pulls, z[:, :k])], axis=1)
        jacobian = np.zeros((*z.shape, z.shape[1]))
        jacobian[:, :k, :k] = derivative()
        jacobian[:, :k, k:], jacobian[:, k:, :k] = pulls.transpose(0, 2, 1), pulls
        i = np.arange(k, z.shape[1])
        jacobian[:, i, i] = filled
        return value, jacobian, spring

    forces = (friction[stuck] * real[..., None]).reshape(n, -1)
    z = np.concatenate([motion, forces], axis=1)
    for _ in range(2 * t):
        value, jacobian, _ = system(z)
        z = z - _solved(jacobian, value)
    value, jacobian, spring = system(z)
    inverse, size = _inverse(jacobian), norms(q.slips(z[:, :k]))
    magnitude, force = np.abs(inverse), np.abs(spring)
    tilt, rounding = q.tilt + q.rounding, (m + 16) * q.unit
    way, width = products(q.reach, np.abs(z[:, :k])), q.reach.sum(axis=2)

    def errors(radius: Floats | float) -> tuple[Floats, Floats, Floats]:
        """Return errors of springs, slips and unit vectors along slips, in a box around z."""
        tilted = _MARGIN * tilt * (way + radius * width)
        springs = q.stiffness * tilted + 5 * q.unit * (q.preload + force)
        missed = 1.5 * tilted + 1.5 * radius * width
        turned = np.where(slides, missed / (size - missed) + 8 * q.unit, 0.0) if t > 1 else 0 * size
        return springs + q.stiffness * radius * width, missed, turned

    springs, missed, turned = errors(0.0)
    held = np.zeros_like(tilt)
    held[stuck] = norms(z[:, k:].reshape(n, -1, t)) * real
    share = np.where(on, springs, 0.0) * (1 + mu)
    share += np.where(on, force, 0.0) * ((1 + mu) * tilt + mu * turned)
    share += held * tilt + rounding * (force * on * (1 + mu) + held)
    error = (share[:, None] @ q.reach)[:, 0] + rounding * np.abs(q.load)
    error = np.concatenate([error, np.repeat(missed[stuck] * real, t, axis=1)], axis=1)
    radius = 2.1 * _MARGIN * products(magnitude, np.abs(value) + error).max(axis=1)[:, None]
    # In the whole box, of the Jacobian too.
    springs, missed, turned = errors(radius)
    arm, least = (1 + mu) * tilt + mu * turned, size - missed
    unsure = np.where(on, q.stiffness, 0.0) * (arm + (1 + mu + arm) * tilt + rounding * (1 + mu))
    if t > 1:
        bent = springs / least + (force + springs) * (
            3 * missed / (least * least) + 3 * tilt / least
        )
        # Two tangents: twice as many terms, of at most twice their entries' size together.
        bent += 4 * rounding * force / size
        unsure += np.where(slides, mu * bent, 0.0)
    doubt = (z.shape[1] + 4) * q.unit * np.abs(jacobian)
    doubt[:, :k, :k] += q.reach.transpose(0, 2, 1) @ (unsure[..., None] * q.reach)
    rows = np.repeat((tilt[..., None] * q.reach)[stuck] * real[..., None], t, axis=1)
    doubt[:, k:, :k] += rows
    doubt[:, :k, k:] += rows.transpose(0, 2, 1)
    far = np.abs(np.eye(z.shape[1]) - inverse @ jacobian) + magnitude @ doubt
    sure = np.where(on, spring, -spring) > _MARGIN * springs
    sure &= ~slides | (size > _MARGIN * missed)
    most = (1 - 8 * q.unit) * mu * (spring - _MARGIN * springs)
    sure &= ~sticks | (held + 1.5 * radius < most)
    contracts = (_MARGIN * far.sum(axis=2).max(axis=1) < 0.5) & np.isfinite(radius[:, 0])
    exist: Booleans = contracts & (sure | ~q.present).all(axis=1)
    return exist


def _at_rest(q: Questions, ratio: Floats) -> Booleans:
    """Return where tangential forces, within the cones of the preloads, balance the load."""
    (n, m, t), k = ratio.shape, q.load.shape[1]
    most = q.friction * q.preload
    rows = (most[..., None, None] * q.tangents).reshape(n, m * t, k)
    reach = np.repeat(most[..., None] * q.reach, t, axis=1)
    rounding = (m * t + 6) * q.unit * reach
    spread = (np.repeat(q.tilt, t, axis=1) + q.rounding)[..., None] * reach + rounding
    right = -q.load - (q.preload[:, None] @ q.normal)[:, 0]
    wide = (q.preload * (q.tilt + q.rounding + m * q.unit))[:, None] @ q.reach
    square = rows.transpose(0, 2, 1) @ rows
    size = np.trace(square, axis1=1, axis2=2) + 1e-300
    inverse = rows @ _inverse(square + 1e-15 * size[:, None, None] * np.eye(k))
    share = np.clip(ratio, -SLIP_SHARE, SLIP_SHARE).reshape(n, m * t)
    for _ in range(3):
        share = share + products(inverse, right - (share[:, None] @ rows)[:, 0])
    off = np.abs(right - (share[:, None] @ rows)[:, 0]) + wide[:, 0]
    off += (m + 8) * q.unit * np.abs(q.load) + (np.abs(share)[:, None] @ spread)[:, 0]
    magnitude = np.abs(inverse)
    far = np.abs(np.eye(k) - rows.transpose(0, 2, 1) @ inverse)
    far += spread.transpose(0, 2, 1) @ magnitude
    beta = _MARGIN * far.sum(axis=2).max(axis=1) + k * k * q.unit
    change = _MARGIN * magnitude.sum(axis=2) * (off.max(axis=1) / (1 - beta))[:, None]
    room = 1 - 8 * q.unit - norms(np.abs(share).reshape(n, m, t) + change.reshape(n, m, t))
    proved: Booleans = (beta < 0.9) & np.all((room > 0) | (most == 0), axis=1)
    return proved
