"""A quick float search for the contact states of an equilibrium; what it finds is checked exactly.

Equilibrium is a linear complementarity problem in the gap v of each normal spring, the two
directions b+, b- of its friction force, and the size l of its slip. With the motion eliminated by
``K d = w + sum (q + v) N + (b+ - b-) T``, ``K = sum k N N'``:

* ``c_n = q - k N . d + v >= 0``, complementary to ``v >= 0``;
* ``l + T . d >= 0`` to ``b+ >= 0``, and ``l - T . d >= 0`` to ``b- >= 0``;
* ``friction c_n - b+ - b- >= 0`` to ``l >= 0``.

Lemke's method pivots along a ray until all is complementary [Cottle1992]. It can end without an
answer where one exists, so a failure proves nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.exact import RationalVector
from equilibrium.model.grasp import Grasp

from .state_system import State, States

Floats: TypeAlias = npt.NDArray[np.float64]

_ZERO = 1e-10


@dataclass(frozen=True)
class Guess:
    """Contact states in which an equilibrium may exist.

    A contact at its friction limit counts as slipping. With the tangential force of the `idle`
    ones among the sticking contacts set to zero, the equalities leave one solution, wherever the
    search ended in a regular basis.
    """

    states: States
    idle: frozenset[int]


def likely_states(grasp: Grasp, wrench: RationalVector) -> Guess | None:
    """Return a guess, or None."""
    m = len(grasp)
    try:
        with np.errstate(all="ignore"):
            basic = _lemke(*_problem(grasp, wrench))
    except (OverflowError, np.linalg.LinAlgError):
        return None
    if basic is None:
        return None
    states = tuple(_state(basic, i, m) for i in range(m))
    resting = (i for i in range(m) if not {m + i, 2 * m + i} & basic)
    return Guess(states, frozenset(i for i in resting if states[i] == "stick"))


def _state(basic: set[int], contact: int, m: int) -> State:
    """Return the state of a contact by its basic variables among v, b+, b-, l."""
    gap, plus, _, slip = (contact + part * m in basic for part in range(4))
    if gap:
        return "detached"
    if slip:
        return "slip-" if plus else "slip+"
    return "stick"


def _problem(grasp: Grasp, wrench: RationalVector) -> tuple[Floats, Floats]:
    """Return M and q of ``w = M z + q``, complementary to z = (v, b+, b-, l)."""
    m = len(grasp)
    normal = np.array([[float(x) for x in c.normal_wrench] for c in grasp]).reshape(m, 3)
    tangent = np.array([[float(x) for x in c.tangential_wrench] for c in grasp]).reshape(m, 3)
    numbers = [[float(c.stiffness), float(c.preload), float(c.friction)] for c in grasp]
    stiffness, preload, friction = np.array(numbers).reshape(m, 3).T
    spring = stiffness[:, None] * normal
    compliance = normal.T @ spring
    # Where the normals leave a motion free, a weak spring lets the search go on.
    compliance += 1e-9 * max(1.0, float(np.trace(compliance))) * np.eye(3)
    drive = np.zeros((3, 4 * m))
    drive[:, :m], drive[:, m : 2 * m], drive[:, 2 * m : 3 * m] = normal.T, tangent.T, -tangent.T
    response = np.linalg.solve(compliance, drive)
    load = np.array([float(x) for x in wrench]) + preload @ normal
    rest = np.linalg.solve(compliance, load)
    one = np.eye(m)
    force = -spring @ response
    force[:, :m] += one
    moved = tangent @ response
    limit = friction[:, None] * force
    limit[:, m : 2 * m] -= one
    limit[:, 2 * m : 3 * m] -= one
    plus, minus = moved.copy(), -moved
    plus[:, 3 * m :] += one
    minus[:, 3 * m :] += one
    matrix = np.concatenate([force, plus, minus, limit])
    shift = preload - spring @ rest
    start = np.concatenate([shift, tangent @ rest, -(tangent @ rest), friction * shift])
    return matrix, start


def _lemke(matrix: Floats, start: Floats) -> set[int] | None:
    """Return the basic ones of z in a complementary solution of ``w = M z + q``, or None."""
    n = len(start)
    if n == 0 or np.min(start) >= 0:
        return set()
    # Columns: w, z, the covering variable, the constants.
    table = np.concatenate([np.eye(n), -matrix, -np.ones((n, 1)), start[:, None]], axis=1)
    basis = np.arange(n)
    row, entering = int(np.argmin(start)), 2 * n
    for _ in range(20 * n + 20):
        leaving = int(basis[row])
        table[row] /= table[row, entering]
        column = table[:, entering].copy()
        column[row] = 0.0
        table -= np.outer(column, table[row])
        basis[row] = entering
        if leaving == 2 * n:
            return {int(b) - n for b in basis if b >= n}
        entering = leaving + n if leaving < n else leaving - n
        column = table[:, entering]
        up = column > _ZERO
        if not up.any():
            return None
        ratios = np.where(up, table[:, -1] / np.where(up, column, 1.0), np.inf)
        least = ratios.min()
        ties = np.flatnonzero(ratios <= least + _ZERO)
        covering = ties[basis[ties] == 2 * n]
        row = int(covering[0]) if len(covering) else int(ties[np.argmax(column[ties])])
    return None
