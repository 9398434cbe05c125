"""A quick search for an equilibrium of contacts that are smooth at first, and get sharper.

The spring force ``q - k N . d`` bends smoothly to 0 where it would pull, and friction is a share of
its limit that turns smoothly with the slip ``T . d``: ``-s / sqrt(|s|^2 + eps^2)``, or with
pyramids a mean of their edges (`equilibrium.core.cones`). So balance is an equation in the n
unknowns of the motion, whatever the number of contacts: 3 in the plane, 6 in space, so many a body
in assemblies. Its solution is followed from eps = 1 (in units of the motion's typical size) down to
10^-8. What it ends at is a guess of contact states; the equilibrium is then solved for exactly, or
there is none of these states. A failure proves nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from statistics import median

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats

from .cones import Cones
from .contacts import FloatContacts, nearest
from .float_law import Balance

_MAX_NEWTON_STEPS = 30
#: The smoothing parameter is multiplied by this, or by more where a step fails.
SMOOTHING_FACTOR = 0.1
#: A path ends where a step fails with a larger factor.
MAX_SMOOTHING_FACTOR = 0.7
#: Smoothing parameters that are tried at most.
MAX_PATH_STEPS = 40
#: Below this smoothing parameter equilibria are proposed.
SHARP = 2e-2
#: Below this one a path ends.
SHARPEST = 1e-8
#: Residual of a point of a path, as a share of the load.
PATH_RESIDUAL = 1e-8
#: Where a path starts that starts near an equilibrium.
SHARPNESS_NEAR = 1e-3
#: Motions smaller than this, or larger than its inverse, are not scaled.
_MIN_SCALE = 1e-60
#: Newton steps in more unknowns are made without a singular value decomposition.
_MAX_DECOMPOSED = 6
#: Residual that ends Newton's method, as a share of the load.
NEWTON_RESIDUAL = 1e-12


class Continuation:
    """The path of one question's equilibrium as its contacts get sharper.

    Attributes:
        balance: of the contacts.
        scale: the typical size of the coordinates of a motion; it may be off by a lot.
        arms: what the entries of the balance are weighed with: torques count as forces at a typical
            distance.
        reached: the least residual of sharp contacts so far.
    """

    reached = math.inf

    def __init__(self, contacts: FloatContacts, wrench: RationalVector, cones: Cones) -> None:
        self.load = np.array([nearest(w) for w in wrench])
        self.scale = motion_scale(contacts, self.load)
        self.arms = self.scale / self.scale[0]
        self.balance = Balance.of(contacts, self.load, cones.smooth, self.arms)
        most = np.abs(self.load * self.arms).max()
        self.size = float(most + np.abs(contacts.preload).max(initial=0.0))

    def starts(self, count: int) -> Iterator[Floats]:
        """Yield motions to start from: none, then small random ones, the same on every run."""
        yield np.zeros(len(self.scale))
        random = np.random.default_rng(1)
        for _ in range(count):
            yield self.scale * random.normal(size=len(self.scale))

    def path(self, motion: Floats, first: float = 1.0) -> Iterator[tuple[Floats, float]]:
        """Yield motions along a path, from a sharpness on; the steps adapt."""
        slip = float(self.scale[0])
        eps, factor = first / SMOOTHING_FACTOR, SMOOTHING_FACTOR
        for _ in range(MAX_PATH_STEPS):
            end, residual = self._newton(motion, eps * factor * slip)
            good = residual <= PATH_RESIDUAL * self.size
            self.reached = min(self.reached, residual) if eps * factor < SHARP else self.reached
            if eps * factor < SHARP and residual <= self.size:
                yield end, eps * factor * slip
            if good:
                motion, eps, factor = end, eps * factor, max(factor**2, SMOOTHING_FACTOR)
                if eps < SHARPEST:
                    return
            elif factor > MAX_SMOOTHING_FACTOR:
                return
            else:
                factor = factor**0.5

    def _newton(self, motion: Floats, eps: float) -> tuple[Floats, float]:
        """Return a motion of less residual: Newton steps, damped where they fail."""
        value, derivative = self.balance.smoothed(motion, eps)
        jacobian = derivative()
        residual, damping = math.sqrt(value @ value), 0.0
        step_of: Callable[[Floats, float], Floats] | None = None
        for _ in range(_MAX_NEWTON_STEPS):
            if not np.isfinite(jacobian).all() or residual <= NEWTON_RESIDUAL * self.size:
                break
            # Where a step fails only the damping changes.
            step_of = step_of or _steps(jacobian * self.scale)
            step = self.scale * step_of(value, damping)
            tried_value, derivative = self.balance.smoothed(motion + step, eps)
            tried = math.sqrt(tried_value @ tried_value)
            if tried < residual:
                stalled = tried > 0.999 * residual
                motion = motion + step
                value, jacobian, residual, step_of = tried_value, derivative(), tried, None
                damping /= 30
                if stalled:
                    break
            elif damping > 1e3:
                break
            else:
                damping = max(30 * damping, 1e-10)
        return motion, residual


def _steps(jacobian: Floats) -> Callable[[Floats, float], Floats]:
    """Return what makes steps of a value and a damping.

    The decomposition shows small singular values. Of many bodies it takes thirty times as long as
    the normal equations, and more where a library shares it out to threads.
    """
    if len(jacobian) > _MAX_DECOMPOSED:
        return partial(_normal_step, jacobian)
    return partial(_step, *np.linalg.svd(jacobian))


def _step(left: Floats, sizes: Floats, right: Floats, value: Floats, damping: float) -> Floats:
    """Return the step of least ``|J x + v|^2 + damping |J|^2 |x|^2`` (Levenberg, Marquardt).

    Args:
        left, sizes, right: the singular value decomposition of J.
    """
    if damping == 0.0 and not sizes[-1] > 0.0:
        damping = 1e-10
    weights = sizes / (sizes * sizes + damping * (sizes @ sizes) + 1e-300)
    step: Floats = -((value @ left) * weights) @ right
    return step


def _normal_step(jacobian: Floats, value: Floats, damping: float) -> Floats:
    """Return the same step by the normal equations."""
    size = len(value)
    square, right = jacobian, value
    if damping:
        square = jacobian.T @ jacobian + damping * float((jacobian**2).sum()) * np.eye(size)
        right = jacobian.T @ value
    try:
        step: Floats = np.linalg.solve(square, -right).astype(float, copy=False)
    except np.linalg.LinAlgError:
        # A damped step follows.
        return np.zeros(size)
    return step


@np.errstate(all="ignore")  # sizes beyond floats are replaced below
def motion_scale(contacts: FloatContacts, load: Floats) -> Floats:
    """Return typical sizes of the coordinates of the motion of an equilibrium."""
    arms = contacts.arms(1 / contacts.length)
    total = float(contacts.stiffness.sum())
    if not 0 < total < np.inf:
        return arms
    size = 3 * float(np.abs(load * arms).max()) / total
    springs = contacts.stiffness > 0
    size = max(size, 2 * median((contacts.preload[springs] / contacts.stiffness[springs]).tolist()))
    return (size if _MIN_SCALE < size < 1 / _MIN_SCALE else 1.0) * arms
