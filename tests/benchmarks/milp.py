"""The same model as a mixed-integer program in floats, for scipy's `milp` (HiGHS).

Unknowns: the motion d with ``|d_j| <= bound`` for its three components, the forces c_n and c_t,
and for each contact four binaries, one of which is 1: detached, slip+, slip-, stick. From the
bound follow the largest values of ``|stiffness N . d|`` and ``|T . d|``, so that every condition of
one state is an ordinary inequality in the others. There is no objective: any solution will do.

What is lost against an exact decision: motions beyond the bound, and the tolerance of the program.
"""

import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import coo_array

BOUND = 10
DETACHED, PLUS, MINUS, STICK = range(4)


@dataclass(frozen=True)
class Answer:
    """What the program says: "stable", "unstable", "no answer in time" or a message."""

    verdict: str
    seconds: float
    motion: tuple[float, ...] = ()
    forces: tuple[tuple[float, float], ...] = ()


class Rows:
    """Rows ``low <= a . z <= high``, collected entry by entry."""

    def __init__(self) -> None:
        self.entries: list[tuple[int, int, float]] = []
        self.low: list[float] = []
        self.high: list[float] = []

    def add(
        self, terms: Iterable[tuple[int, float]], low: float = -np.inf, high: float = np.inf
    ) -> None:
        self.entries += [(len(self.low), place, value) for place, value in terms]
        self.low.append(low)
        self.high.append(high)

    def constraint(self, size: int) -> LinearConstraint:
        rows, places, values = zip(*self.entries, strict=True)
        matrix = coo_array((values, (rows, places)), shape=(len(self.low), size)).tocsr()
        return LinearConstraint(matrix, self.low, self.high)


def solve_milp(
    grasp: Any,
    wrench: Sequence[Fraction],
    bound: float = BOUND,
    seconds: float = 60,
    presolve: bool = True,
) -> Answer:
    """Ask HiGHS whether the grasp has an equilibrium with a motion within the bound."""
    m = len(grasp)
    size = 3 + 6 * m
    rows = Rows()
    for axis in range(3):
        terms = [
            term
            for i, c in enumerate(grasp)
            for term in (
                (_normal(i), float(c.normal_wrench[axis])),
                (_tangential(i), float(c.tangential_wrench[axis])),
            )
        ]
        rows.add(terms, -float(wrench[axis]), -float(wrench[axis]))
    low, high = np.full(size, -np.inf), np.full(size, np.inf)
    low[:3], high[:3] = -bound, bound
    for i, contact in enumerate(grasp):
        low[_normal(i)] = 0
        low[_state(i, 0) : _state(i, 4)], high[_state(i, 0) : _state(i, 4)] = 0, 1
        _contact_rows(rows, i, contact, bound)
    whole = np.zeros(size)
    for i in range(m):
        whole[_state(i, 0) : _state(i, 4)] = 1
    found, taken = solved(rows, low, high, whole, seconds, presolve)
    return _answer(found, taken, m)


def solved(
    rows: Rows, low: Any, high: Any, whole: Any, seconds: float, presolve: bool = True
) -> tuple[Any, float]:
    """Ask HiGHS for any point between bounds, and how long that took."""
    start = time.process_time()
    found = milp(
        np.zeros(len(low)),
        integrality=whole,
        bounds=Bounds(low, high),
        constraints=rows.constraint(len(low)),
        options={"time_limit": seconds, "presolve": presolve},
    )
    return found, time.process_time() - start


def _contact_rows(rows: Rows, i: int, contact: Any, bound: float) -> None:
    """Add the conditions of one contact; those of a state bind when its binary is 1."""
    along_n = [float(contact.stiffness * x) for x in contact.normal_wrench]
    along_t = [float(x) for x in contact.tangential_wrench]
    mu, q = float(contact.friction), float(contact.preload)
    gap, slip = list(enumerate(along_n)), list(enumerate(along_t))
    most_gap, most_slip = (bound * sum(map(abs, along)) for along in (along_n, along_t))
    most_force = most_gap + q
    n, t, state = _normal(i), _tangential(i), [_state(i, s) for s in range(4)]
    rows.add([(place, 1.0) for place in state], 1, 1)
    # c_n >= q - gap always, equal unless detached; detached: c_n = 0 and gap >= q.
    rows.add([*gap, (n, 1.0)], low=q)
    rows.add([*gap, (n, 1.0), (state[DETACHED], -most_gap)], high=q)
    rows.add([(n, 1.0), (state[DETACHED], most_force)], high=most_force)
    # |c_t| <= mu c_n always.
    for sign in (1.0, -1.0):
        rows.add([(t, sign), (n, -mu)], high=0)
    for s, sign in ((PLUS, 1.0), (MINUS, -1.0)):
        # sign T . d >= 0 and sign c_t <= -mu c_n, which the cone makes an equality.
        rows.add([*((j, sign * a) for j, a in slip), (state[s], -most_slip)], low=-most_slip)
        most = 2 * mu * most_force
        rows.add([(t, sign), (n, mu), (state[s], most)], high=most)
        rows.add([*((j, sign * a) for j, a in slip), (state[STICK], most_slip)], high=most_slip)


def _answer(found: Any, seconds: float, m: int) -> Answer:
    if found.status == 0:
        z = found.x
        forces = tuple((float(z[_normal(i)]), float(z[_tangential(i)])) for i in range(m))
        return Answer("stable", seconds, tuple(map(float, z[:3])), forces)
    verdict = {1: "no answer in time", 2: "unstable"}.get(found.status, str(found.message))
    return Answer(verdict, seconds)


def _normal(i: int) -> int:
    return 3 + 6 * i


def _tangential(i: int) -> int:
    return 4 + 6 * i


def _state(i: int, s: int) -> int:
    return 5 + 6 * i + s


def violation(grasp: Any, wrench: Sequence[Fraction], answer: Answer) -> tuple[Fraction, str]:
    """Return by how much a point of the program violates the exact model, and in which condition.

    The floats are taken as the rationals they are. A wrong friction force under slip counts as the
    smaller one of the slip and the missing friction.
    """
    motion = [Fraction(x) for x in answer.motion]
    total = [Fraction(w) for w in wrench]
    found = [(Fraction(0), "none")]
    for contact, pair in zip(grasp, answer.forces, strict=True):
        c_n, c_t = map(Fraction, pair)
        along_n, along_t = contact.normal_wrench, contact.tangential_wrench
        gap = sum(a * x for a, x in zip(along_n, motion, strict=True))
        slip = sum(a * x for a, x in zip(along_t, motion, strict=True))
        total = [w + c_n * a + c_t * b for w, a, b in zip(total, along_n, along_t, strict=True)]
        limit = contact.friction * c_n
        due = max(Fraction(0), contact.preload - contact.stiffness * gap)
        missing = abs(c_t + limit) if slip > 0 else abs(c_t - limit)
        found.append((abs(c_n - due), "spring"))
        found.append((abs(c_t) - limit, "cone"))
        found.append((min(abs(slip), missing), "dissipation"))
    found += [(abs(w), "balance") for w in total]
    return max(found)
