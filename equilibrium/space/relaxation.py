"""The convex relaxation of a node of the tree in space, solved as a conic program in floats.

Unknowns are the motion and a force at each contact. The relaxed law, by the state of a contact:

* undecided: ``c_n >= 0``, ``c_n >= q - k N . d``, ``|c_t| <= mu c_n``;
* detached: no force, ``q - k N . d <= 0``;
* attached: ``c_n = q - k N . d``, ``|c_t| <= mu c_n``;
* stick: attached, and ``T d = 0``;
* in a range: ``c_n <= F``, and ``|r| <= Q`` for the rotation r of d;
* slip in the sector from u to v: attached, T d in the sector, and c_t in the convex hull of
  ``-mu c_n`` times the arc from u to v.

Where nothing satisfies it together with balance, the dual ray has a virtual motion and multipliers:
a leaf. Otherwise its solution says which contact to split.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import clarabel
import numpy as np
from scipy.sparse import csc_matrix

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.model.range import NO_RANGE, Range
from equilibrium.plane.contacts import SpatialContacts, nearest

from .balance import SpatialContinuation

#: Integer directions in the frame of the tangents; a sector has two, counter-clockwise.
Direction: TypeAlias = tuple[int, int]
Sector: TypeAlias = tuple[Direction, Direction]
#: "undecided", "detached", "attached", "stick", or a sector of slip.
State: TypeAlias = str | Sector

#: Weight of the square of the motion beside the forces, in scaled units.
_SMALL_MOTION = 1e-3
#: Where no ray has more room than minus this, there is none.
_NO_ROOM = 1e-6
#: Whether a contact touches is asked before how it slips, by this factor.
_FIRST = 3.0


class Ray(NamedTuple):
    """A dual ray: there is no solution.

    Attributes:
        virtual: (6,) virtual motion; multipliers: (m, 3), alpha and h.
        room: (m, 3), how far each multiplier may be changed.
        sizes: (m, 3), of the multipliers beside the virtual motion.
        turn: (3,), u of the largest turn; forces: (m,), rho of the largest force.
    """

    virtual: Floats
    multipliers: Floats
    room: Floats
    sizes: Floats
    turn: Floats
    forces: Floats


class Point(NamedTuple):
    """A solution of the relaxation, in scaled units: motion (6,) and forces (m, 3)."""

    motion: Floats
    forces: Floats


class Relaxation:
    """All relaxations of one question, in scaled units.

    Attributes:
        scale: of the coordinates of a motion.
    """

    def __init__(
        self, contacts: SpatialContacts, wrench: RationalVector, within: Range = NO_RANGE
    ) -> None:
        c, search = contacts, SpatialContinuation(contacts, wrench)
        self.contacts, self.m = c, len(c.grasp)
        self.arms = np.array([1.0] * 3 + [1 / c.length] * 3)
        self.force, self.step = search.size or 1.0, float(search.scale[0])
        self.scale = self.step * self.arms
        self.load = search.load * self.arms / self.force
        self.normal, self.tangents = c.normal * self.arms, c.tangents * self.arms
        self.stiffness = c.stiffness * self.step / self.force
        self.preload, self.friction = c.preload / self.force, c.friction
        turn, most = within.largest_turn, within.largest_force
        #: The largest turn as the right-hand side of a cone, and the largest force.
        self.turn = [] if turn is None else [nearest(turn) / self.scale[3], 0.0, 0.0, 0.0]
        self.most = np.inf if most is None else nearest(most) / self.force
        self.settings = clarabel.DefaultSettings()
        self.settings.verbose = False
        self.settings.presolve_enable = False
        self.settings.max_threads = 1

    def solve(self, states: Sequence[State]) -> Ray | Point | None:
        """Return a ray or a point for one node; None where the program solver fails."""
        free = [i for i, state in enumerate(states) if state != "detached"]
        n = 6 + 3 * len(free)
        column = {i: 6 + 3 * k for k, i in enumerate(free)}
        zero, plus = _Rows(n, 6 + 4 * self.m), _Rows(n, 5 * self.m)
        zero.matrix[:6, 6:] = (
            -np.concatenate(
                [self.normal[free, :, None], self.tangents[free].transpose(0, 2, 1)], axis=2
            )
            .transpose(1, 0, 2)
            .reshape(6, -1)
        )
        zero.right[:6], zero.used = self.load, 6
        place: list[int] = []
        cost = np.zeros(n)
        for i, state in enumerate(states):
            gap = self.stiffness[i] * self.normal[i]
            # q - k N . d is at most, or equal to, the normal force.
            rows = plus if state in ("undecided", "detached") else zero
            place.append(rows.used)
            if state == "detached":
                plus.add(-gap, -self.preload[i])
                continue
            j = column[i]
            rows.add(-gap, -self.preload[i], (j, -1.0))
            if state == "undecided":
                cost[j] = 1.0
            elif state == "stick":
                for tangent in self.tangents[i]:
                    zero.add(tangent, 0.0)
            elif isinstance(state, tuple):
                u, v = _ends(state)
                for side in _sides(u, v):
                    plus.add(-(side @ self.tangents[i]), 0.0)
                middle = (u + v) / np.hypot(*(u + v))
                limit = self.friction[i] * float(u @ middle)
                plus.add(np.zeros(6), 0.0, (j, limit), (j + 1, middle[0]), (j + 2, middle[1]))
        bounded = list(column.values()) * (self.most < np.inf)
        for j in bounded:
            plus.add(np.zeros(6), self.most, (j, 1.0))
        cones = np.zeros((3 * len(free), n))
        index = np.arange(6, n)
        cones[index - 6, index] = np.where(
            (index - 6) % 3 == 0, -self.friction[free].repeat(3), -1.0
        )
        turns = np.zeros((len(self.turn), n))
        turns[1:, 3:6] = -np.eye(3)[: len(turns) and 3]
        matrix = np.concatenate([zero.rows, plus.rows, cones, turns])
        right = np.concatenate([zero.ends, plus.ends, np.zeros(3 * len(free)), self.turn])
        kinds = [clarabel.ZeroConeT(zero.used)]
        if plus.used:
            kinds.append(clarabel.NonnegativeConeT(plus.used))
        kinds += [clarabel.SecondOrderConeT(3)] * len(free)
        kinds += [clarabel.SecondOrderConeT(4)] * (len(turns) // 4)
        quadratic = csc_matrix((np.full(6, _SMALL_MOTION), (range(6), range(6))), shape=(n, n))
        solver = clarabel.DefaultSolver(
            quadratic, cost, csc_matrix(matrix), right, kinds, self.settings
        )
        found = solver.solve()
        status = str(found.status)
        if status in ("PrimalInfeasible", "AlmostPrimalInfeasible"):
            dual, rho = np.array(found.z), np.zeros(self.m)
            end = zero.used + plus.used
            rho[free] = dual[end - len(free) : end] * bool(bounded)
            return self._ray(states, place, zero.used, dual)._replace(
                turn=-dual[-3:] * self.force / self.scale[3] * bool(self.turn),
                forces=rho,
            )
        if status not in ("Solved", "AlmostSolved"):
            return None
        x = np.array(found.x)
        forces = np.zeros((self.m, 3))
        forces[free] = x[6:].reshape(-1, 3)
        return Point(x[:6], forces)

    def _ray(
        self, states: Sequence[State], place: Sequence[int], equalities: int, dual: Floats
    ) -> Ray:
        """Read a virtual motion and multipliers off a dual ray."""
        multipliers = np.zeros((self.m, 3))
        for i, state in enumerate(states):
            row = place[i] + (equalities if state in ("undecided", "detached") else 0)
            multipliers[i, 0] = dual[row]
            if state == "stick":
                multipliers[i, 1:] = dual[row + 1 : row + 3]
            elif isinstance(state, tuple):
                j = equalities + self._sector_rows(states, i)
                multipliers[i, 1:] = -dual[j : j + 2] @ _sides(*_ends(state))
        return self._in_units(states, -dual[:6], multipliers)

    def _in_units(self, states: Sequence[State], virtual: Floats, multipliers: Floats) -> Ray:
        """Return a ray in the units of the grasp, with the room of its multipliers."""
        room = np.zeros((self.m, 3))
        for i, state in enumerate(states):
            alpha, h = multipliers[i, 0], multipliers[i, 1:]
            a, b = self.normal[i] @ virtual, self.tangents[i] @ virtual
            slack = a - alpha - self.friction[i] * np.hypot(*b)
            if state in ("undecided", "detached", "attached"):
                multipliers[i, 1:] = 0.0
            room[i, 0] = {"undecided": min(alpha, slack), "detached": alpha}.get(str(state), slack)
            if state == "stick":
                room[i, 1:] = np.inf
            elif isinstance(state, tuple):
                u, v = _ends(state)
                room[i, 0] = a - alpha - self.friction[i] * _largest(u, v, b)
                room[i, 1:] = min(-h @ u, -h @ v)
        sizes = np.abs(multipliers) / max(float(np.abs(virtual).max()), 1e-300)
        units = np.array([1.0, *[self.force / self.step] * 2])
        unused = np.zeros(3), np.zeros(self.m)
        return Ray(virtual * self.arms, multipliers * units, room, sizes, *unused)

    def cone_ray(self) -> Ray | None:
        """Return a virtual motion on which the load works and no force in a cone does less.

        It needs no springs, and sees loads that are tiny beside the preloads.
        """
        load = self.load / (np.abs(self.load).max() or 1.0)
        cones = np.zeros((3 * self.m, 6))
        cones[::3] = -self.normal
        cones[1::3] = -self.friction[:, None] * self.tangents[:, 0]
        cones[2::3] = -self.friction[:, None] * self.tangents[:, 1]
        matrix = csc_matrix(np.concatenate([np.eye(6), -np.eye(6), cones]))
        right = np.concatenate([np.ones(12), np.zeros(3 * self.m)])
        kinds = [clarabel.NonnegativeConeT(12), *[clarabel.SecondOrderConeT(3)] * self.m]
        program = (csc_matrix((6, 6)), -load, matrix, right, kinds)
        found = np.array(clarabel.DefaultSolver(*program, self.settings).solve().x)
        if not load @ found > _NO_ROOM:
            return None
        return self._in_units(["undecided"] * self.m, found, np.zeros((self.m, 3)))

    def inner_ray(self, states: Sequence[State]) -> Ray | None:
        """Return the ray with the most room in the conditions of a leaf, if any has some.

        Unknowns are the virtual motion, alpha and h of each contact, one more of each sector, and
        the room.
        """
        m, n = self.m, 6 + 4 * self.m + 1
        equal = np.zeros((6, n))
        plus, cones = _Rows(n, 12 + 4 * m), np.zeros((3 * m, n))
        fixed = []
        for i, state in enumerate(states):
            j = 6 + 4 * i
            equal[:, j] = -self.stiffness[i] * self.normal[i]
            equal[:, j + 1 : j + 3] = self.tangents[i].T
            if state in ("undecided", "detached"):
                plus.add(np.zeros(6), 0.0, (j, -1.0))
            if isinstance(state, tuple):
                u, v = _ends(state)
                for end in (u, v):
                    plus.add(np.zeros(6), 0.0, (j + 1, end[0]), (j + 2, end[1]))
                plus.add(np.zeros(6), 0.0, (j + 3, -1.0))
            else:
                fixed += [j + 3] if state == "stick" else [j + 1, j + 2, j + 3]
            if state == "detached":
                continue
            cone = cones[3 * i : 3 * i + 3]
            cone[0, :6], cone[0, j], cone[0, -1] = -self.normal[i], 1.0, 1.0
            cone[1:, :6] = -self.friction[i] * self.tangents[i]
            if isinstance(state, tuple):
                middle = (u + v) / np.hypot(*(u + v))
                cone[:, j + 3] = -self.friction[i] * np.array([u @ middle, *middle])
        rows = plus.rows
        work = np.zeros(n)
        work[:6], work[6:-1:4], work[-1] = -self.load, -self.preload, 1.0
        bounds = np.eye(n)[[*range(6), n - 1]]
        zeros = np.eye(n)[fixed].reshape(-1, n)
        matrix = np.concatenate([equal, zeros, rows, [work], bounds, -bounds[:6], cones])
        right = np.concatenate(
            [np.zeros(6 + len(fixed) + len(rows) + 1), np.ones(13), np.zeros(3 * m)]
        )
        kinds = [
            clarabel.ZeroConeT(6 + len(fixed)),
            clarabel.NonnegativeConeT(len(rows) + 14),
            *[clarabel.SecondOrderConeT(3)] * m,
        ]
        cost = np.zeros(n)
        cost[-1] = -1.0
        program = (csc_matrix((n, n)), cost, csc_matrix(matrix), right, kinds)
        found = np.array(clarabel.DefaultSolver(*program, self.settings).solve().x)
        if not found[-1] > -_NO_ROOM:
            return None
        return self._in_units(states, found[:6], found[6:-1].reshape(m, 4)[:, :3])

    def _sector_rows(self, states: Sequence[State], i: int) -> int:
        """Return how many inequalities come before those of the sector of a contact."""
        counts = (
            3 if isinstance(state, tuple) else int(state in ("undecided", "detached"))
            for state in states[:i]
        )
        return sum(counts)

    def violations(self, states: Sequence[State], found: Point) -> Floats:
        """Return how far each contact is from the law: the change of force that it would take."""
        d, f = found
        spring = self.preload - self.stiffness * (self.normal @ d)
        slip = self.tangents @ d
        size = np.hypot(slip[:, 0], slip[:, 1])
        miss = (
            f[:, 1:] + (self.friction * f[:, 0])[:, None] * slip / np.maximum(size, 1e-300)[:, None]
        )
        rubs = np.minimum(self.stiffness * size, np.hypot(miss[:, 0], miss[:, 1]))
        lifts = f[:, 0] - np.maximum(0.0, spring)
        value = [
            _FIRST * lifts[i] + rubs[i]
            if state == "undecided"
            else 0.0
            if state in ("detached", "stick")
            else rubs[i]
            for i, state in enumerate(states)
        ]
        return np.array(value)


class _Rows:
    """Rows of a matrix that grows, and their right-hand sides."""

    def __init__(self, n: int, most: int) -> None:
        self.matrix, self.right, self.used = np.zeros((most, n)), np.zeros(most), 0

    def add(self, motion: Floats, right: float, *entries: tuple[int, float]) -> None:
        """Add a row: coefficients of the motion, and of other unknowns."""
        row = self.matrix[self.used]
        row[:6] = motion
        for j, x in entries:
            row[j] = x
        self.right[self.used] = right
        self.used += 1

    @property
    def rows(self) -> Floats:
        """The rows in use."""
        return self.matrix[: self.used]

    @property
    def ends(self) -> Floats:
        """Their right-hand sides."""
        return self.right[: self.used]


def _ends(sector: Sector) -> Floats:
    """Return the unit vectors of the ends of a sector."""
    ends = np.array(sector, dtype=float)
    units: Floats = ends / np.hypot(ends[:, 0], ends[:, 1])[:, None]
    return units


def _sides(u: Floats, v: Floats) -> Floats:
    """Return two directions: all between u and v have products with them of at least 0."""
    return np.array([(-u[1], u[0]), (v[1], -v[0])])


def _largest(u: Floats, v: Floats, b: Floats) -> float:
    """Return the largest product of b with a unit vector between u and v."""
    if u[0] * b[1] >= u[1] * b[0] and b[0] * v[1] >= b[1] * v[0]:
        return float(np.hypot(*b))
    return float(max(u @ b, v @ b))
