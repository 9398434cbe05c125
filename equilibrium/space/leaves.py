"""Leaves of a tree in space: a dual ray in floats, made exact and tested.

The virtual motion and the multipliers are rounded to integers; a few multipliers, those with most
room, are then solved for, so that what depends on the motion cancels exactly.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.numbers.exact import RationalVector, primitive, to_text
from arrangement.numbers.linear.rank import gauss_jordan
from equilibrium.model.range import NO_RANGE, Range
from equilibrium.plane.contacts import SpatialContacts

from .relaxation import Ray, State

#: Roots are rounded up to multiples of one over this.
_ROOTS = 2**30
#: Numbers are rounded to multiples of one over the first, multipliers below the second left out.
_FINE = ((2**10, 1e-6), (2**20, 1e-6), (2**34, 1e-9), (2**48, 1e-12))


def exact_leaf(
    contacts: SpatialContacts,
    wrench: RationalVector,
    states: Sequence[State],
    ray: Ray,
    within: Range = NO_RANGE,
) -> Any | None:
    """Return a leaf near a dual ray, or None where rounding finds none."""
    largest = float(np.abs(ray.virtual).max())
    if not 0 < largest < math.inf or not np.isfinite(ray.multipliers).all():
        return None
    grasp, kept = contacts.grasp, None
    turns: list[RationalVector] = []
    if ray.turn.any():
        turns = [tuple(Fraction(int(j == k)) for j in range(6)) for k in (3, 4, 5)]
    for fine, nothing in _FINE:
        if kept is None or not np.array_equal(kept, ray.sizes > nothing):
            kept = ray.sizes > nothing
            places = list(zip(*map(list, np.nonzero(kept)), strict=True))
            places.sort(key=lambda place: -ray.room[place])
            columns: list[RationalVector] = [
                contacts.springs[i][1:] if j == 0 else grasp.contacts[i].tangential_wrenches[j - 1]
                for i, j in places
            ]
            columns = turns + columns
            reduced, pivots, scale = gauss_jordan(list(zip(*columns, strict=True)))
        unit = fine / largest
        pinned = _pinned(contacts, states, ray, kept, nothing)
        motion = _rounded(pinned, [float(x) * unit for x in ray.virtual])
        listed = [*(ray.turn if turns else ()), *(ray.multipliers[place] for place in places)]
        values = [Fraction(round(float(x) * unit)) for x in listed]
        for row, pivot in zip(reduced, pivots, strict=False):
            others = sum(row[k] * values[k] for k in range(len(values)) if k not in pivots)
            values[pivot] = Fraction(-others) / scale
        given: dict[int, list[Fraction]] = {}
        for (i, j), value in zip(places, values[len(turns) :], strict=True):
            given.setdefault(int(i), [Fraction(0)] * 3)[j] = value
        turn = values[: len(turns)]
        if turn:
            turn = [_root_above(sum(x * x for x in turn)), *turn]
        pushed = np.flatnonzero(ray.forces > nothing * largest).tolist()
        rho = {i: Fraction(math.ceil(float(ray.forces[i]) * unit)) for i in pushed}
        if _holds(contacts, wrench, states, motion, given, within, turn, rho):
            return _node(motion, given, turn, rho)
    return None


def _pinned(
    contacts: SpatialContacts, states: Sequence[State], ray: Ray, kept: Any, nothing: float
) -> list[RationalVector]:
    """Return the wrenches of contacts that the virtual motion leaves where they are.

    The conditions of such a contact have no room, as of one on an axis of a rotation.
    """
    scale = ray.virtual * np.array([1.0] * 3 + [contacts.length] * 3)
    limit = max(nothing, 1e-9) * float(np.abs(scale).max())
    rows: list[RationalVector] = []
    for i, state in enumerate(states):
        moved = np.append(contacts.tangents[i] @ ray.virtual, contacts.normal[i] @ ray.virtual)
        if state != "detached" and not kept[i, 0] and np.abs(moved).max() <= limit:
            contact = contacts.grasp.contacts[i]
            rows += [contact.normal_wrench, *contact.tangential_wrenches]
    return rows


def _rounded(rows: list[RationalVector], motion: list[float]) -> list[Fraction]:
    """Return a motion near a given one on which all rows are exactly 0."""
    found = [Fraction(round(x)) for x in motion]
    # Pivots go to the entries that come first: the largest stay as they are.
    order = sorted(range(6), key=lambda j: abs(motion[j]))
    reduced, pivots, scale = gauss_jordan([[row[j] for j in order] for row in rows])
    for row, pivot in zip(reduced, pivots, strict=False):
        others = sum(row[k] * found[order[k]] for k in range(6) if k not in pivots)
        found[order[pivot]] = Fraction(-others) / scale
    return found


def _root_above(square: Fraction | int) -> Fraction:
    """Return a number just above a square root, or 0 for 0."""
    return (
        Fraction(math.isqrt(math.ceil(square * _ROOTS**2)) + 1, _ROOTS) if square else Fraction(0)
    )


def _node(
    motion: list[Fraction],
    given: dict[int, list[Fraction]],
    turn: list[Fraction],
    rho: dict[int, Fraction],
) -> Any:
    """Return the form of a leaf, in coprime integers."""
    every = [*motion, *(x for row in given.values() for x in row), *turn, *rho.values()]
    whole = [to_text(x) for x in primitive(every)]
    if not (given or turn or rho):
        return whole
    rows = {str(i): whole[6 + 3 * k : 9 + 3 * k] for k, i in enumerate(given)}
    short = {i: row[:1] if row[1:] == ["0", "0"] else row for i, row in rows.items()}
    leaf: dict[str, Any] = {"virtual_motion": whole[:6], "multipliers": short}
    end = 6 + 3 * len(given) + len(turn)
    used: dict[str, Any] = {"turn": whole[end - len(turn) : end]} if turn else {}
    if rho:
        used["forces"] = dict(zip(map(str, rho), whole[end:], strict=True))
    return {**leaf, "range": used} if used else leaf


def _holds(
    contacts: SpatialContacts,
    wrench: RationalVector,
    states: Sequence[State],
    motion: list[Fraction],
    given: dict[int, list[Fraction]],
    within: Range,
    turn: list[Fraction],
    rho: dict[int, Fraction],
) -> bool:
    """Return whether a leaf whose linear terms cancel shows what it has to."""
    work = sum((w * x for w, x in zip(wrench, motion, strict=True)), Fraction(0))
    work -= turn[0] * (within.largest_turn or 0) if turn else 0
    work -= sum(rho.values()) * (within.largest_force or 0)
    for i, (contact, state) in enumerate(zip(contacts.grasp, states, strict=True)):
        alpha, *h = given.get(i, (Fraction(0),) * 3)
        work += alpha * contact.preload
        if (state == "undecided" or state == "detached") and alpha < 0:
            return False
        if isinstance(state, tuple) and any(h[0] * x + h[1] * y > 0 for x, y in state):
            return False
        if state == "detached":
            continue
        a, s, t = (
            sum((x * y for x, y in zip(row, motion, strict=True) if y), Fraction(0))
            for row in (contact.normal_wrench, *contact.tangential_wrenches)
        )
        if not _within(a + rho.get(i, 0) - alpha, contact.friction, (s, t), state):
            return False
    return work > 0


def _within(room: Fraction, friction: Fraction, b: tuple[Fraction, Fraction], state: State) -> bool:
    """Return whether ``room >= friction x . b`` for all unit vectors x that the state allows."""
    s, t = b
    if isinstance(state, tuple):
        (p, q), (v, w) = state
        if not (p * t - q * s >= 0 and s * w - t * v >= 0):
            return all(_above(room, friction * (x * s + y * t), x * x + y * y) for x, y in state)
    return room >= 0 and room * room >= friction * friction * (s * s + t * t)


def _above(room: Fraction, product: Fraction, square: int) -> bool:
    """Return whether ``room >= product / sqrt(square)``."""
    if room >= 0 >= product:
        return True
    if room < 0 <= product:
        return False
    larger = room * room * square >= product * product
    return larger if room >= 0 else room * room * square <= product * product
