"""Equilibria in space near motions in floats: exact ones, and boxes that may hold one.

The states of contacts are read off a motion of the smoothed balance. Where all friction forces are
known shares of their limits (no contact slips, or along rational directions), balance is linear and
solved exactly. Else a small box is put around what Newton's method finds (`enclosures`). Both are
proposals, which `equilibrium.certificate` checks.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.rank import gauss_jordan
from equilibrium.model.solution import Solution
from equilibrium.plane.contacts import FloatContacts
from equilibrium.space.enclosures import enclosures
from equilibrium.space.states import StateBalance, States

#: Motions that balance leaves open are multiples of one over this.
_COARSE = 2**10
#: Motions that agree to one over this lead to the same equilibrium, mostly.
_ABOUT = 8


def proposals(
    contacts: FloatContacts,
    wrench: RationalVector,
    motion: Floats,
    states: States,
    tried: set[object],
) -> Iterator[Solution]:
    """Yield equilibria of given states near a motion; those in `tried` are not tried again."""
    size = float(np.abs(motion).max()) or 1.0
    about = tuple(np.rint(_ABOUT * motion / size).astype(int).tolist())
    if (states.key, states.rational, about) in tried:
        return
    tried.add((states.key, states.rational, about))
    balance = StateBalance(contacts, wrench, states)
    if states.rational:
        # The simplest motion first, of those that balance leaves open.
        for start in (np.zeros(6), motion):
            found = _solved(balance, start)
            if found is not None:
                yield found
    if any(states.slipping):
        yield from enclosures(balance, motion)


def _solved(balance: StateBalance, motion: Floats) -> Solution | None:
    """Return the solution where no slip turns with the motion."""
    p, size = len(balance.basis), len(balance.basis) + len(balance.pillars)
    springs = _springs(balance, size)
    rows = _rows(balance, springs, size)
    reduced, pivots, scale = gauss_jordan(rows)
    if size in pivots:
        return None
    # What the equations leave open is taken from the motion in floats.
    point = [Fraction(round(_COARSE * x), _COARSE) for x in balance.coordinates(motion)]
    point += [Fraction(0)] * (size - p)
    free = [k for k in range(size) if k not in pivots]
    for row, pivot in zip(reduced, pivots, strict=False):
        point[pivot] = Fraction(-row[size] - sum(row[k] * point[k] for k in free)) / scale
    moved = tuple(dot(column, point[:p]) for column in zip(*balance.basis, strict=True))
    forces = []
    for i, contact in enumerate(balance.contacts.grasp):
        normal = dot(springs[i], [*point, Fraction(1)]) if i in springs else Fraction(0)
        pair = [contact.friction * normal * x for x in balance.share(i)]
        for k, (pillar, j) in enumerate(balance.pillars, p):
            if pillar == i:
                pair[j] += point[k]
        forces.append((normal, *pair))
    return Solution(moved or (Fraction(0),) * 6, tuple(forces))


def _springs(balance: StateBalance, size: int) -> dict[int, list[Fraction]]:
    """Return the normal forces of touching contacts as rows in the unknowns."""
    rest = [Fraction(0)] * (size - len(balance.basis))
    return {
        i: [
            *(-contact.stiffness * dot(contact.normal_wrench, b) for b in balance.basis),
            *rest,
            contact.preload,
        ]
        for i, contact in enumerate(balance.contacts.grasp)
        if balance.states.touching[i]
    }


def _rows(
    balance: StateBalance, springs: dict[int, list[Fraction]], size: int
) -> list[list[Fraction]]:
    """Return balance, and that slipping contacts do not move across their directions."""
    rows = [[Fraction(0)] * size + [w] for w in balance.wrench]
    p, straight = len(balance.basis), []
    for i, spring in springs.items():
        contact, share = balance.contacts.grasp.contacts[i], balance.share(i)
        one, other = contact.tangential_wrenches
        arm = [
            n + contact.friction * (share[0] * s + share[1] * t)
            for n, s, t in zip(contact.normal_wrench, one, other, strict=True)
        ]
        for row, x in zip(rows, arm, strict=True):
            row[:] = [y + x * slope for y, slope in zip(row, spring, strict=True)]
        if balance.states.slipping[i]:
            across = [share[0] * t - share[1] * s for s, t in zip(one, other, strict=True)]
            turns = [dot(across, b) for b in balance.basis]
            straight.append([*turns, *[Fraction(0)] * (size - p + 1)])
    for k, (i, j) in enumerate(balance.pillars, p):
        pull = balance.contacts.grasp.contacts[i].tangential_wrenches[j]
        for row, x in zip(rows, pull, strict=True):
            row[k] += x
    return rows + straight
