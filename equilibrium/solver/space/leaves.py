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

from arrangement.exact import RationalVector, primitive, to_text
from arrangement.float_filter import Floats
from equilibrium.solver.elimination import gauss_jordan

from .contacts import SpatialContacts
from .relaxation import State

#: Numbers are rounded to multiples of one over these.
_FINE = (2**10, 2**20, 2**34, 2**48)
#: Multipliers below this share of the largest are left out.
_NOTHING = 1e-9


def exact_leaf(
    contacts: SpatialContacts,
    wrench: RationalVector,
    states: Sequence[State],
    virtual: Floats,
    multipliers: Floats,
    room: Floats,
) -> Any | None:
    """Return a leaf near a dual ray, or None where rounding finds none.

    Args:
        virtual: (6,) the virtual motion.
        multipliers: (m, 3), alpha and h.
        room: (m, 3), how far each may be changed, about.
    """
    largest = float(np.abs(virtual).max())
    if not 0 < largest < math.inf or not np.isfinite(multipliers).all():
        return None
    sizes = np.abs(multipliers) * np.column_stack(
        [np.abs(contacts.spring[:, 1:]).max(axis=1), np.abs(contacts.tangents).max(axis=2)]
    )
    kept = sizes > _NOTHING * max(float(sizes.max(initial=0.0)), 1e-300)
    grasp = contacts.grasp
    places = [(i, j) for i, j in zip(*np.nonzero(kept), strict=True)]
    places.sort(key=lambda place: -room[place])
    columns: list[RationalVector] = [
        contacts.springs[i][1:] if j == 0 else grasp.contacts[i].tangential_wrenches[j - 1]
        for i, j in places
    ]
    reduced, pivots, scale = (
        gauss_jordan(list(zip(*columns, strict=True))) if places else ([], [], 1)
    )
    for fine in _FINE:
        unit = fine / largest
        motion = [round(float(x) * unit) for x in virtual]
        values = [Fraction(round(float(multipliers[place]) * unit)) for place in places]
        for row, pivot in zip(reduced, pivots, strict=False):
            others = sum(
                row[k] * values[k] for k in range(len(values)) if k not in pivots and row[k]
            )
            values[pivot] = Fraction(-others, 1) / scale
        given: dict[int, list[Fraction]] = {}
        for (i, j), value in zip(places, values, strict=True):
            given.setdefault(int(i), [Fraction(0)] * 3)[j] = value
        if _holds(contacts, wrench, states, motion, given):
            return _node(motion, given)
    return None


def _node(motion: list[int], given: dict[int, list[Fraction]]) -> Any:
    """Return the form of a leaf, in coprime integers."""
    every = [Fraction(x) for x in motion] + [x for row in given.values() for x in row]
    whole = [to_text(x) for x in primitive(every)]
    if not given:
        return whole
    rows = {str(i): whole[6 + 3 * k : 9 + 3 * k] for k, i in enumerate(given)}
    short = {i: row[:1] if row[1:] == ["0", "0"] else row for i, row in rows.items()}
    return {"virtual_motion": whole[:6], "multipliers": short}


def _holds(
    contacts: SpatialContacts,
    wrench: RationalVector,
    states: Sequence[State],
    motion: list[int],
    given: dict[int, list[Fraction]],
) -> bool:
    """Return whether a leaf whose linear terms cancel shows what it has to."""
    work = sum((w * x for w, x in zip(wrench, motion, strict=True)), Fraction(0))
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
        if not _within(a - alpha, contact.friction, (s, t), state):
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
