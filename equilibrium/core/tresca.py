"""Likely equilibria in floats as fixed points of Tresca friction; each step is a convex program.

With a limit g of the friction of each contact in place of mu c_n, the equilibria are the least
points of a convex energy,

    sum x^2 / (2 k) + sum g |T . d| - w . d   with   x >= q - k N . d,  x >= 0,

whose x are the normal forces; they give the next limits, g = mu x. A fixed point obeys Coulomb's
law. The steps need not converge: this proposes, and proves nothing.

Source: J. Haslinger, I. Hlavacek, J. Necas, Numerical methods for unilateral problems in solid
mechanics, Handbook of Numerical Analysis IV (1996), section 10.
"""

from __future__ import annotations

import numpy as np

from arrangement.errors import extra

from .relaxation import Columns, Point, Relaxation

with extra("space"):
    import clarabel

#: Steps of one iteration; walls of 85 bricks take 8.
_MAX_STEPS = 25
#: Change of a limit, as a share of the load, at which the limits are a fixed point.
_FIXED = 1e-7
#: The weighted motion is what forces leave of the load: with more they do not balance it.
_UNBALANCED = 1e-5
#: Error that ends the solution of one program.
_PROGRAM_ERROR = 1e-11
#: The first limit of every contact, as a multiple of the load.
_FIRST_LIMIT = 10.0
#: Weight of the square of the motion beside the energy of springs: it decides what balance leaves.
_MOTION_WEIGHT = 1e-9


def tresca_point(relaxation: Relaxation) -> Point | None:
    """Return the motion and the forces at a fixed point, in units of the relaxation, if reached.

    For friction along lines, and springs of positive stiffness.
    """
    m, n, k = relaxation.m, relaxation.n, relaxation.stiffness
    if not m or not (k > 0).all():
        return None
    slip, one, none = relaxation.tangents[:, 0], np.eye(m), np.zeros((m, m))
    # Unknowns: the motion, the normal forces x, and s >= |T . d|.
    rows = np.block(
        [
            [relaxation.spring[:, 1:], -one, none],
            [np.zeros((m, n)), -one, none],
            [slip, none, -one],
            [-slip, none, -one],
        ]
    )
    right = np.concatenate([-relaxation.preload, np.zeros(3 * m)])
    squares = Columns.of(np.diag([*[_MOTION_WEIGHT] * n, *(1 / k), *[0.0] * m]))
    settings = clarabel.DefaultSettings()
    settings.verbose = settings.presolve_enable = False
    settings.max_threads = 1
    settings.tol_feas = settings.tol_gap_abs = settings.tol_gap_rel = _PROGRAM_ERROR
    limit, solver = np.full(m, _FIRST_LIMIT), None
    for _ in range(_MAX_STEPS):
        cost = np.concatenate([-relaxation.load, np.zeros(m), limit])
        if solver is None:
            cones = [clarabel.NonnegativeConeT(4 * m)]
            question = squares, cost, Columns.of(rows), right, cones, settings
            solver = clarabel.DefaultSolver(*question)
        else:
            solver.update(q=cost)
        solved = solver.solve()
        if str(solved.status) not in ("Solved", "AlmostSolved"):
            return None
        unknowns, multipliers = np.array(solved.x), np.array(solved.z)
        if np.abs(unknowns[:n]).max() * _MOTION_WEIGHT > _UNBALANCED:
            return None
        normal = np.maximum(0.0, unknowns[n : n + m])
        last, limit = limit, relaxation.friction * normal
        if np.abs(limit - last).max() <= _FIXED:
            friction = multipliers[3 * m :] - multipliers[2 * m : 3 * m]
            return Point(unknowns[:n], np.column_stack([normal, friction]))
    return None
