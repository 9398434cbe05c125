"""Equilibria of many questions at once, each proved to exist by a bound on errors.

The smoothed balance is followed as in `equilibrium.plane.search.continuation`, for all questions
together. What it ends at is a guess of contact states, whose conditions are a linear system
``A z = b`` and inequalities. The unknowns z are the motion d and the tangential forces of the
contacts that stick. For an approximate inverse R of A with ``|I - R A| <= beta < 1`` (largest row
sum) A is regular, and its solution is within ``|R (b - A z')| / (1 - beta)`` of any z'
[Rump2010]. Where the inequalities hold, strictly, everywhere so near, there is an equilibrium.
Where all contacts stick d is 0, and the tangential forces alone have to balance the load: R is an
approximate right inverse then, and ``z' + R y`` with ``|y| <= |b - A z'| / (1 - beta)`` a solution.
All bounds are taken over all numbers within the errors of the data.
"""

from __future__ import annotations

import numpy as np

from arrangement.numbers.float_filter import UNIT, Booleans, Floats
from equilibrium.plane.search.continuation import (
    MAX_PATH_STEPS,
    MAX_SMOOTHING_FACTOR,
    NEWTON_RESIDUAL,
    PATH_RESIDUAL,
    SHARP,
    SHARPEST,
    SMOOTHING_FACTOR,
)

from .questions import Questions, along

#: Where a path starts that starts near an equilibrium.
_NEAR = 1e-2
_MAX_NEWTON_STEPS = 20
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
    motion = np.zeros((len(q), 3)) if starts is None else starts
    eps, factor = np.full(len(q), first / SMOOTHING_FACTOR), np.full(len(q), SMOOTHING_FACTOR)
    for _ in range(MAX_PATH_STEPS):
        sharper = eps * factor
        end, residual = _newton(q, motion, sharper)
        tried = np.flatnonzero((sharper < SHARP) & (residual < 1))
        holds = np.zeros(len(q), dtype=bool)
        holds[tried] = _exists_near(q.take(tried), end[tried], sharper[tried])
        proved[rows[holds]] = True
        good = residual <= PATH_RESIDUAL
        going = ~holds & np.where(good, sharper >= SHARPEST, factor <= MAX_SMOOTHING_FACTOR)
        motion, eps = np.where(good[:, None], end, motion), np.where(good, sharper, eps)
        factor = np.where(good, np.maximum(factor**2, SMOOTHING_FACTOR), factor**0.5)
        rows, q = rows[going], q.take(going)
        motion, eps, factor = motion[going], eps[going], factor[going]
        if not len(rows):
            break
    return proved


def _exists_near(q: Questions, motion: Floats, eps: Floats) -> Booleans:
    """Return where an equilibrium of the contact states at a motion exists."""
    force, slip = q.spring_forces(motion)[0], along(q.tangent, motion)
    ratio = -slip / np.hypot(slip, eps[:, None])
    return _by_states(q, force > 0, ratio) | _at_rest(q, ratio)


def _newton(q: Questions, motion: Floats, eps: Floats) -> tuple[Floats, Floats]:
    """Return motions of less residual, and that: Newton steps, damped where they fail."""
    motion, smallest = motion.copy(), np.full(len(q), np.inf)
    rows, at, width, damping = np.arange(len(q)), motion, eps, np.full(len(q), 1e-14)
    value, jacobian = _balance(q, at, width)
    residual = smallest = np.linalg.norm(value, axis=1)
    for _ in range(_MAX_NEWTON_STEPS):
        turned = jacobian.transpose(0, 2, 1)
        square = turned @ jacobian
        size = np.trace(square, axis1=1, axis2=2) + 1e-300
        square += (damping * size)[:, None, None] * np.eye(3)
        moved = at - _solved(square, np.einsum("nij,nj->ni", turned, value))
        tried, tried_jacobian = _balance(q, moved, width)
        left = np.linalg.norm(tried, axis=1)
        better = left < residual
        at, value = np.where(better[:, None], moved, at), np.where(better[:, None], tried, value)
        jacobian = np.where(better[:, None, None], tried_jacobian, jacobian)
        stalled = better & (left > 0.999 * residual) | ~better & (damping > 1e3)
        residual = np.where(better, left, residual)
        damping = np.where(better, damping / 30, np.maximum(30 * damping, 1e-10))
        motion[rows], smallest[rows] = at, residual
        going = (residual > NEWTON_RESIDUAL) & ~stalled
        if not going.any():
            break
        rows, q, at, width = rows[going], q.take(going), at[going], width[going]
        value, jacobian, residual = value[going], jacobian[going], residual[going]
        damping = damping[going]
    return motion, smallest


def _balance(q: Questions, motion: Floats, eps: Floats) -> tuple[Floats, Floats]:
    """Return the sums of all wrenches, and their derivatives."""
    force = q.preload - q.stiffness * along(q.normal, motion)
    eps = eps[:, None]
    soft = eps * np.where(q.stiffness > 0, q.stiffness, 1.0)
    smooth = np.sqrt(force * force + soft * soft)
    normal, touching = (force + smooth) / 2, (1 + force / smooth) / 2
    normal = np.where(q.reach[..., 0] > 0, normal, 0.0)
    slip = along(q.tangent, motion)
    root = np.sqrt(slip * slip + eps * eps)
    pull = q.friction[..., None] * q.tangent
    arm = q.normal - (slip / root)[..., None] * pull
    turn = (normal * eps * eps / root**3)[..., None] * q.tangent
    spring = (touching * q.stiffness)[..., None] * q.normal
    value = q.load + np.einsum("nm,nmi->ni", normal, arm)
    jacobian = -(arm.transpose(0, 2, 1) @ spring + pull.transpose(0, 2, 1) @ turn)
    return value, jacobian


def _solved(matrix: Floats, right: Floats) -> Floats:
    """Solve three equations each, roughly, by cofactors."""
    a, b, c = np.moveaxis(matrix, 1, 0)
    rows = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=2)
    determinant = np.einsum("ni,ni->n", a, rows[:, :, 0])
    found: Floats = np.einsum("nij,nj->ni", rows, right) / determinant[:, None]
    return np.nan_to_num(found, nan=0.0, posinf=0.0, neginf=0.0)


def _by_states(q: Questions, touching: Booleans, ratio: Floats) -> Booleans:
    """Return where an equilibrium of these contact states exists."""
    n, m = ratio.shape
    present = q.reach[..., 0] > 0
    on = touching & present
    rubs = on & (q.friction > 0)
    sticks = rubs & (np.abs(ratio) <= 0.9999)
    sign = np.where(rubs & ~sticks, np.sign(ratio), 0.0)
    edge = q.normal + (sign * q.friction)[..., None] * q.tangent
    weight, push = np.where(on, q.stiffness, 0.0), np.where(on, q.preload, 0.0)
    matrix, errors = np.zeros((n, 3 + m, 3 + m)), np.zeros((n, 3 + m, 3 + m))
    matrix[:, :3, :3] = -np.einsum("nm,nmi,nmj->nij", weight, edge, q.normal)
    stuck = np.where(sticks[..., None], q.tangent, 0.0)
    matrix[:, 3:, :3], matrix[:, :3, 3:] = stuck, stuck.transpose(0, 2, 1)
    i = np.arange(3, 3 + m)
    matrix[:, i, i] = ~sticks
    # Each error of N and T, twice in a product, and the roundings of the sums.
    wide = (1 + q.friction)[..., None] * (2.2 * q.spread + 2 * (m + 8) * UNIT * q.reach)
    errors[:, :3, :3] = np.einsum("nm,nmi,nmj->nij", weight, wide, q.reach)
    unsure = np.where(sticks[..., None], q.spread, 0.0)
    errors[:, 3:, :3], errors[:, :3, 3:] = unsure, unsure.transpose(0, 2, 1)
    right, right_errors = np.zeros((n, 3 + m)), np.zeros((n, 3 + m))
    right[:, :3] = -q.load - np.einsum("nm,nmi->ni", push, edge)
    right_errors[:, :3] = np.einsum("nm,nmi->ni", push, wide) + (m + 8) * UNIT * np.abs(q.load)
    found, radius = _enclosed(matrix, errors, right, right_errors)
    motion, tangential = found[:, :3], found[:, 3:]
    force, error = q.spring_forces(motion)
    shift = radius[:, None] * q.reach.sum(axis=2) * _MARGIN
    error = _MARGIN * (error + q.stiffness * (shift + 2 * UNIT * np.abs(force)))
    slip = along(q.tangent, motion)
    size = np.abs(motion)
    doubt = _MARGIN * (shift + along(q.spread, size) + 10 * UNIT * along(q.reach, size))
    least = force - error
    inside = np.abs(tangential) + radius[:, None] < (1 - 8 * UNIT) * q.friction * least
    holds = np.where(on, least > 0, force + error < 0) | ~present
    holds &= np.where(sticks, inside, True) & np.where(sign != 0, -sign * slip > doubt, True)
    proved: Booleans = holds.all(axis=1) & np.isfinite(radius)
    return proved


def _enclosed(
    matrix: Floats, errors: Floats, right: Floats, right_errors: Floats
) -> tuple[Floats, Floats]:
    """Return solutions, roughly, and how far every entry of the true ones is away at most."""
    k = matrix.shape[1]
    usable = np.all(np.isfinite(matrix), axis=(1, 2)) & np.all(np.isfinite(right), axis=1)
    # One singular matrix would end the inversion of all.
    shaken = np.where(usable[:, None, None], matrix, np.eye(k)) + np.diag(
        1e-15 * (1 + np.arange(k) ** 0.5)
    )
    try:
        inverse = np.linalg.inv(shaken)
    except np.linalg.LinAlgError:
        inverse = np.linalg.pinv(shaken)
    found = np.einsum("nij,nj->ni", inverse, right)
    for _ in range(2):
        found = found + np.einsum(
            "nij,nj->ni", inverse, right - np.einsum("nij,nj->ni", matrix, found)
        )
    size, rounding = np.abs(inverse), (k + 4) * UNIT
    off = right - np.einsum("nij,nj->ni", matrix, found)
    wide = errors + rounding * np.abs(matrix)
    residual = np.abs(off) + np.einsum("nij,nj->ni", wide, np.abs(found))
    residual += right_errors + rounding * np.abs(right)
    far = np.abs(np.eye(k) - inverse @ matrix) + size @ wide
    beta = _MARGIN * far.sum(axis=2).max(axis=1) + k * k * UNIT
    radius = _MARGIN * np.einsum("nij,nj->ni", size, residual).max(axis=1) / (1 - beta)
    return found, np.where(usable & (beta < 0.9), radius, np.nan)


def _at_rest(q: Questions, ratio: Floats) -> Booleans:
    """Return where tangential forces, within the cones of the preloads, balance the load."""
    m = ratio.shape[1]
    most = q.friction * q.preload
    rows = most[..., None] * q.tangent
    spread = most[..., None] * (q.spread + 4 * UNIT * q.reach)
    right = -q.load - np.einsum("nm,nmi->ni", q.preload, q.normal)
    wide = q.spread + (m + 8) * UNIT * q.reach
    right_error = np.einsum("nm,nmi->ni", q.preload, wide) + (m + 8) * UNIT * np.abs(q.load)
    square = rows.transpose(0, 2, 1) @ rows + 1e-200 * np.eye(3)
    columns = [_solved(square, np.broadcast_to(axis, q.load.shape)) for axis in np.eye(3)]
    inverse = rows @ np.stack(columns, axis=2)
    share = np.clip(ratio, -0.9999, 0.9999)
    for _ in range(3):
        share = share + along(inverse, right - np.einsum("nm,nmi->ni", share, rows))
    rounding = (m + 6) * UNIT
    off = np.abs(right - np.einsum("nm,nmi->ni", share, rows)) + right_error
    off += np.einsum("nm,nmi->ni", np.abs(share), spread + rounding * np.abs(rows))
    size = np.abs(inverse)
    far = np.abs(np.eye(3) - rows.transpose(0, 2, 1) @ inverse)
    far += (spread + rounding * np.abs(rows)).transpose(0, 2, 1) @ size
    beta = _MARGIN * far.sum(axis=2).max(axis=1) + 9 * UNIT
    change = _MARGIN * size.sum(axis=2) * (off.max(axis=1) / (1 - beta))[:, None]
    proved: Booleans = (beta < 0.9) & np.all(np.abs(share) + change < 1 - 8 * UNIT, axis=1)
    return proved
