"""Equilibria in space near motions in floats: exact ones, and boxes that may hold one.

The states of contacts are read off a motion of the smoothed balance. Where all friction forces are
known shares of their limits (no contact slips, or along rational directions), balance is linear and
solved exactly. Else it is solved by Newton's method in floats, with a small box around. Both are
proposals, which `equilibrium.certificate` checks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

import numpy as np

from arrangement.exact import RationalVector
from arrangement.float_filter import Floats
from equilibrium.solver.elimination import gauss_jordan
from equilibrium.solver.float_contacts import nearest
from equilibrium.solver.spatial_contacts import SpatialContacts

#: Shares of the friction limit are multiples of one over this.
_SHARES = 2**14
#: Motions that balance leaves open are multiples of one over this.
_COARSE = 2**10
#: Of rational slip directions: the largest denominator of half-angle tangents, the error allowed.
_SIMPLE, _SAME = 64, 1e-6
#: From this share of its limit on, friction may be that of a slip.
_SLIPS = 0.9999
#: Sizes of boxes, relative to the motion.
_RADII = (1e-11, 1e-9, 1e-7)
_LEAST = 1e-40
_STEPS, _CLOSE = 12, 1e-9


@dataclass(frozen=True)
class SpatialSolution:
    """One equilibrium: the motion, and the normal and two tangential forces at each contact."""

    motion: RationalVector
    forces: tuple[RationalVector, ...]


@dataclass(frozen=True)
class Enclosed:
    """A box that may hold one equilibrium; see `equilibrium.certificate.reading.Enclosure`.

    Attributes:
        motion, forces: in floats.
    """

    basis: tuple[RationalVector, ...]
    friction: tuple[RationalVector | None, ...]
    pillars: tuple[tuple[int, int], ...]
    centre: RationalVector
    radius: RationalVector
    inverse: tuple[RationalVector, ...]
    idle: tuple[RationalVector, ...]
    motion: Floats
    forces: Floats


Proposal: TypeAlias = SpatialSolution | Enclosed


class States:
    """What each contact does, read off normal forces (m,) and shares of friction limits (m, 2).

    Attributes:
        ratio: (m, 2), of friction forces to their limits.
        touching, slipping: contacts with a force, and those among them that slip.
        shares: (m, 2), of the friction limit, rounded; those of slips only if they are rational.
        rational: whether all slips go along rational directions.
    """

    def __init__(self, force: Floats, ratio: Floats) -> None:
        self.touching = [bool(x) for x in force > 0]
        self.ratio = ratio
        size = np.linalg.norm(ratio, axis=1)
        self.slipping = [t and bool(x > _SLIPS) for t, x in zip(self.touching, size, strict=True)]
        self.shares: list[RationalVector | None] = []
        for (x, y), slips in zip(ratio, self.slipping, strict=True):
            if slips:
                self.shares.append(_rational_direction(float(x), float(y)))
            else:
                self.shares.append(tuple(Fraction(int(v * _SHARES), _SHARES) for v in (x, y)))
        self.rational = None not in self.shares
        near = tuple(np.rint(64 * ratio).astype(int).ravel().tolist())
        self.key = (tuple(self.touching), tuple(self.slipping), near)


def _rational_direction(x: float, y: float) -> RationalVector | None:
    """Return the unit vector of a simple half-angle tangent in a direction, if there is one."""
    size = math.hypot(x, y)
    x, y = x / size, y / size
    folded = abs(y) / (1 + abs(x))
    u = Fraction(folded).limit_denominator(_SIMPLE)
    if abs(float(u) - folded) > _SAME:
        return None
    cosine, sine = (1 - u * u) / (1 + u * u), 2 * u / (1 + u * u)
    return (cosine if x > 0 else -cosine, sine if y > 0 else -sine)


class StateBalance:
    """The balance for given states, in y, of the motion B y, and forces of pillars."""

    def __init__(self, contacts: SpatialContacts, wrench: RationalVector, states: States) -> None:
        self.contacts, self.wrench, self.states = contacts, wrench, states
        grasp = contacts.grasp
        self.sticking = [
            i for i in range(len(grasp)) if states.touching[i] and not states.slipping[i]
        ]
        rows = [row for i in self.sticking for row in grasp.contacts[i].tangential_wrenches]
        self.basis = _null_space(rows)
        self.pillars = self._pillars(6 - len(self.basis))
        # Motions that no touching contact feels; balance does not tell them.
        touching = [c for c, near in zip(grasp, states.touching, strict=True) if near]
        self.unfelt = _null_space(
            [row for c in touching for row in (c.normal_wrench, *c.tangential_wrenches)]
        )

    def _pillars(self, count: int) -> tuple[tuple[int, int], ...]:
        """Return tangents of sticking contacts that span all of them; strong contacts first."""
        c = self.contacts
        places = [(i, j) for i in self.sticking for j in (0, 1)]
        tangents = np.array([c.tangents[i, j] for i, j in places]).reshape(-1, 6)
        spare = [1.01 - float(np.linalg.norm(self.states.ratio[i])) for i, _ in places]
        weight = np.array(
            [x * (c.friction[i] + 1e-9) for x, (i, _) in zip(spare, places, strict=True)]
        )
        left = tangents * weight[:, None] if places else tangents
        chosen: list[tuple[int, int]] = []
        for _ in range(count):
            size = np.linalg.norm(left, axis=1)
            best = int(np.argmax(size))
            if not size[best] > 0:
                break
            chosen.append(places[best])
            unit = left[best] / size[best]
            left = left - np.outer(left @ unit, unit)
        return tuple(chosen)

    def share(self, i: int) -> list[Fraction]:
        """Return the share of a contact, without what pillars carry."""
        given = self.states.shares[i] or (Fraction(0), Fraction(0))
        return [Fraction(0) if (i, j) in self.pillars else x for j, x in enumerate(given)]

    def exact(self, motion: Floats) -> SpatialSolution | None:
        """Return the solution where no slip turns with the motion."""
        p, size = len(self.basis), len(self.basis) + len(self.pillars)
        springs = self._springs(size)
        rows = self._rows(springs, size)
        reduced, pivots, scale = gauss_jordan(rows)
        if size in pivots:
            return None
        # What the equations leave open is taken from the motion in floats.
        point = [Fraction(round(_COARSE * x), _COARSE) for x in self._coordinates(motion)]
        point += [Fraction(0)] * (size - p)
        free = [k for k in range(size) if k not in pivots]
        for row, pivot in zip(reduced, pivots, strict=False):
            point[pivot] = Fraction(-row[size] - sum(row[k] * point[k] for k in free)) / scale
        moved = tuple(_dot(column, point[:p]) for column in zip(*self.basis, strict=True))
        forces = []
        for i, contact in enumerate(self.contacts.grasp):
            normal = _dot(springs[i], [*point, Fraction(1)]) if i in springs else Fraction(0)
            pair = [contact.friction * normal * x for x in self.share(i)]
            for k, (pillar, j) in enumerate(self.pillars, p):
                if pillar == i:
                    pair[j] += point[k]
            forces.append((normal, *pair))
        return SpatialSolution(moved or (Fraction(0),) * 6, tuple(forces))

    def _springs(self, size: int) -> dict[int, list[Fraction]]:
        """Return the normal forces of touching contacts as rows in the unknowns."""
        rest = [Fraction(0)] * (size - len(self.basis))
        return {
            i: [
                *(-contact.stiffness * _dot(contact.normal_wrench, b) for b in self.basis),
                *rest,
                contact.preload,
            ]
            for i, contact in enumerate(self.contacts.grasp)
            if self.states.touching[i]
        }

    def _rows(self, springs: dict[int, list[Fraction]], size: int) -> list[list[Fraction]]:
        """Return balance, and that slipping contacts do not move across their directions."""
        rows = [[Fraction(0)] * size + [w] for w in self.wrench]
        p, straight = len(self.basis), []
        for i, spring in springs.items():
            contact, share = self.contacts.grasp.contacts[i], self.share(i)
            one, other = contact.tangential_wrenches
            arm = [
                n + contact.friction * (share[0] * s + share[1] * t)
                for n, s, t in zip(contact.normal_wrench, one, other, strict=True)
            ]
            for row, x in zip(rows, arm, strict=True):
                row[:] = [y + x * slope for y, slope in zip(row, spring, strict=True)]
            if self.states.slipping[i]:
                across = [share[0] * t - share[1] * s for s, t in zip(one, other, strict=True)]
                turns = [_dot(across, b) for b in self.basis]
                straight.append([*turns, *[Fraction(0)] * (size - p + 1)])
        for k, (i, j) in enumerate(self.pillars, p):
            pull = self.contacts.grasp.contacts[i].tangential_wrenches[j]
            for row, x in zip(rows, pull, strict=True):
                row[k] += x
        return rows + straight

    def _float_basis(self) -> Floats:
        """Return the basis in floats, (6, p)."""
        rows = [[nearest(x) for x in motion] for motion in self.basis]
        basis: Floats = np.array(rows).reshape(len(rows), 6).T
        return basis

    def _coordinates(self, motion: Floats) -> Floats:
        """Return the combination of the basis that is nearest to a motion."""
        if not self.basis:
            return np.zeros(0)
        found = np.linalg.lstsq(self._float_basis(), motion, rcond=None)[0]
        nearest_one: Floats = found.astype(np.float64)
        return nearest_one

    def boxes(self, motion: Floats) -> Iterator[Enclosed]:
        """Yield boxes around the solution that Newton's method finds near a motion."""
        p, size = len(self.basis), len(self.basis) + len(self.pillars)
        if size != 6:
            return
        basis, point = self._float_basis(), np.zeros(6)
        point[:p] = self._coordinates(motion)
        load = np.array([nearest(w) for w in self.wrench])
        idle = [
            (*v, *_short(np.array([nearest(x) for x in v]) @ motion[:, None], 9))
            for v in self.unfelt
        ]
        size_of = float(np.abs(load).max()) + float(np.abs(self.contacts.preload).max(initial=0.0))
        for k, (i, j) in enumerate(self.pillars, p):
            c = self.contacts
            force = max(0.0, float(c.spring[i, 0] + c.spring[i, 1:] @ motion))
            point[k] = c.friction[i] * force * self.states.ratio[i, j]
        for _ in range(_STEPS):
            value, derivative, _ = self._balance(basis, point, load, idle)
            try:
                step = np.linalg.solve(derivative, value)
            except np.linalg.LinAlgError:
                return
            if not np.isfinite(step).all():
                return
            point = point - step
            if np.abs(step).max() <= 1e-15 * np.abs(point).max():
                break
        value, derivative, forces = self._balance(basis, point, load, idle)
        if not np.abs(value).max() <= _CLOSE * size_of or not np.isfinite(derivative).all():
            return
        try:
            inverse = np.linalg.inv(derivative)
        except np.linalg.LinAlgError:
            return
        error = np.abs(inverse) @ np.full(6, 1e-14 * size_of)
        for radius in _RADII:
            radii = np.maximum(
                radius
                * np.maximum(np.abs(point), np.abs(point[:p]).max(initial=0.0) if p else 0.0),
                error,
            )
            radii = np.maximum(radii, _LEAST)
            yield Enclosed(
                tuple(self.basis),
                tuple(map(self._named_share, range(len(self.states.touching)))),
                self.pillars,
                _short(point, 20),
                _short(radii, 2),
                tuple(_short(row, 9) for row in inverse),
                tuple(idle),
                basis @ point[:p] if p else np.zeros(6),
                forces,
            )

    def _named_share(self, i: int) -> RationalVector | None:
        """Return None for a detached contact, nothing for one that slips, else its share."""
        if not self.states.touching[i]:
            return None
        return () if self.states.slipping[i] else tuple(self.share(i))

    def _balance(
        self, basis: Floats, point: Floats, load: Floats, idle: Sequence[RationalVector]
    ) -> tuple[Floats, Floats, Floats]:
        """Return the sum of all wrenches, its derivative, and the forces."""
        c, p = self.contacts, basis.shape[1]
        motion = basis @ point[:p]
        value, derivative, forces = load.copy(), np.zeros((6, 6)), np.zeros((len(c.grasp), 3))
        for i, touching in enumerate(self.states.touching):
            if not touching:
                continue
            normal = c.spring[i, 0] + c.spring[i, 1:] @ motion
            slope = np.zeros(6)
            slope[:p] = c.spring[i, 1:] @ basis
            if self.states.slipping[i]:
                slip = c.tangents[i] @ motion
                length = float(np.hypot(*slip))
                unit = slip / length if length else np.zeros(2)
                turn = np.zeros((2, 6))
                moved = c.tangents[i] @ basis
                turn[:, :p] = (moved - np.outer(unit, unit @ moved)) / (length or 1.0)
                friction = -c.friction[i] * normal * unit
                change = -c.friction[i] * (np.outer(unit, slope) + normal * turn)
            else:
                share = c.friction[i] * np.array([float(x) for x in self.share(i)])
                friction, change = normal * share, np.outer(share, slope)
                for k, (pillar, j) in enumerate(self.pillars, p):
                    if pillar == i:
                        friction[j] += point[k]
                        change[j, k] += 1
            value = value + normal * c.normal[i] + friction @ c.tangents[i]
            derivative += np.outer(c.normal[i], slope) + c.tangents[i].T @ change
            forces[i] = normal, *friction
        for *row, x in idle:
            turn = np.array([nearest(y) for y in row])
            value = value + turn * (turn @ motion - nearest(x))
            derivative[:, :p] += np.outer(turn, turn @ basis)
        return value, derivative, forces


def smooth_states(contacts: SpatialContacts, motion: Floats, eps: float) -> States:
    """Return the states of contacts at a motion of the smoothed balance."""
    force = contacts.spring[:, 0] + contacts.spring[:, 1:] @ motion
    slip = contacts.tangents @ motion
    root = np.sqrt((slip * slip).sum(axis=1) + eps * eps)
    return States(force, np.nan_to_num(-slip / root[:, None]))


def proposals(
    contacts: SpatialContacts,
    wrench: RationalVector,
    motion: Floats,
    states: States,
    tried: set[object],
) -> Iterator[Proposal]:
    """Yield equilibria of given states near a motion; those in `tried` are not tried again."""
    if (states.key, states.rational) in tried:
        return
    tried.add((states.key, states.rational))
    balance = StateBalance(contacts, wrench, states)
    if states.rational:
        # The simplest motion first, of those that balance leaves open.
        for start in (np.zeros(6), motion):
            found = balance.exact(start)
            if found is not None:
                yield found
    if any(states.slipping):
        yield from balance.boxes(motion)


def _null_space(rows: list[RationalVector]) -> list[RationalVector]:
    """Return a basis of the motions on which all rows are 0."""
    reduced, pivots, scale = gauss_jordan([list(row) for row in rows])
    basis = []
    for j in range(6):
        if j not in pivots:
            motion = [Fraction(int(k == j)) for k in range(6)]
            for row, pivot in zip(reduced, pivots, strict=False):
                motion[pivot] = Fraction(-row[j], scale)
            basis.append(tuple(motion))
    return basis


def _dot(left: list[Fraction] | RationalVector, right: list[Fraction] | RationalVector) -> Fraction:
    return sum((x * y for x, y in zip(left, right, strict=True)), Fraction(0))


def _short(numbers: Floats, digits: int) -> RationalVector:
    """Return floats with so many significant digits as rationals."""
    return tuple(Fraction(f"{x:.{digits - 1}e}") for x in numbers.tolist())
