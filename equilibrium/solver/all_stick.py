"""The state in which nothing moves and all touching contacts stick, refuted without a program.

At d = 0 the normal forces are the preloads, and the friction forces fill a zonotope. Where it does
not reach the wrench, a direction x separates the two: ``x . (w + sum q N + c_t T)`` is positive for
all allowed friction forces. Such an x is found in floating point, made rational, and turned into a
Farkas vector in rationals.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from arrangement.exact import RationalVector, dot
from equilibrium.model.grasp import Contact, Grasp

from .elimination import Refutation, gauss_jordan
from .state_system import States

_ZERO = Fraction(0)


def rest_refutation(grasp: Grasp, wrench: RationalVector, states: States) -> Refutation | None:
    """Return a Farkas vector for states in which every touching contact sticks, or None.

    None also where the tangential wrenches leave a motion free, and where floats do not decide.
    """
    if {"slip+", "slip-"} & set(states):
        return None
    touching = [c for c, state in zip(grasp, states, strict=True) if state == "stick"]
    x = _separating(touching, wrench)
    if x is None:
        return None
    across = [dot(x, c.tangential_wrench) for c in touching]
    along = [dot(x, c.normal_wrench) for c in touching]
    margin = dot(x, wrench) + sum(
        c.preload * (n - c.friction * abs(t))
        for c, n, t in zip(touching, along, across, strict=True)
    )
    if margin <= 0:
        return None
    # The part of d in balance and friction limits, to be cancelled by the conditions T . d = 0.
    rest = [
        sum(
            (c.stiffness * c.normal_wrench[j] * (n - c.friction * abs(t))
             for c, n, t in zip(touching, along, across, strict=True)),
            _ZERO,
        )
        for j in range(3)
    ]  # fmt: skip
    cancel = _combination([c.tangential_wrench for c in touching], rest)
    if cancel is None:
        return None
    inequalities: list[Fraction] = []
    pulls = iter(across)
    for state in states:
        pull = next(pulls) if state == "stick" else _ZERO
        inequalities += (
            [_ZERO, max(-pull, _ZERO), max(pull, _ZERO)] if state == "stick" else [_ZERO]
        )
    equalities = [*(-component for component in x), *(-z for z in cancel)]
    return Refutation(
        tuple(y / margin for y in inequalities), tuple(z / margin for z in equalities)
    )


def _separating(touching: list[Contact], wrench: RationalVector) -> RationalVector | None:
    """Return a direction that may separate, as found in floating point.

    The shortest sum of all forces that friction allows separates where anything does.
    """
    try:
        rows = [[float(x) for x in c.tangential_wrench] for c in touching]
        tangents = np.array(rows).reshape(len(rows), 3)
        limits = np.array([float(c.friction * c.preload) for c in touching])
        load = np.array([float(x) for x in wrench])
        for c in touching:
            load += float(c.preload) * np.array([float(x) for x in c.normal_wrench])
    except OverflowError:
        return None
    useful = limits > 0
    # Against a strong wrench friction is little, and its own direction separates.
    if load @ load < 1.001 * np.abs(tangents @ load) @ limits:
        from scipy.optimize import lsq_linear

        columns = (tangents[useful] * limits[useful, None]).T
        shares = lsq_linear(columns, -load, bounds=(-1.0, 1.0)).x
        load = load + columns @ shares
    size = float(np.abs(load).max(initial=0.0))
    if not np.isfinite(size) or size == 0.0:
        return None
    # Few bits are enough wherever the separation is not narrow.
    return tuple(Fraction(round(x / size * 2**30), 2**30) for x in load.tolist())


def _combination(vectors: list[RationalVector], target: list[Fraction]) -> RationalVector | None:
    """Return factors with which the vectors add up to the target, most of them 0."""
    rows = [[*(vector[j] for vector in vectors), target[j]] for j in range(3)]
    reduced, pivots, scale = gauss_jordan(rows)
    if len(vectors) in pivots:
        return None
    factors = [_ZERO] * len(vectors)
    for row, pivot in zip(reduced, pivots, strict=False):
        factors[pivot] = Fraction(row[-1], scale)
    return tuple(factors)
