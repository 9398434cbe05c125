"""Choices of states in which the touching contacts cannot balance every wrench, whatever they do.

Where the forces of all touching contacts span less than the space of wrenches, they have no part
along some direction x. If the wrench has one, nothing balances it: the balance alone is a
contradiction. The directions depend on the states, not on the wrench, and are kept for the next.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from arrangement.exact import RationalVector, dot
from equilibrium.model.grasp import Grasp

from .contact_rows import normal_force_row, slip_edge
from .elimination import Refutation, gauss_jordan
from .state_system import States

_ZERO = Fraction(0)
#: The number of inequalities of a contact in each state.
_CONDITIONS = {"detached": 1, "slip+": 2, "slip-": 2, "stick": 3}


@dataclass(frozen=True, slots=True)
class _Unopposed:
    """What the touching contacts leave free, with one choice of states.

    Attributes:
        directions: a basis of the directions in which no contact force has a part.
        constants: for each axis the sum of the preloads along it, if no unknown is in its balance.
    """

    directions: tuple[RationalVector, ...]
    constants: tuple[Fraction | None, ...]


class Balances:
    """The directions that the contacts of one grasp leave free, by choice of states."""

    def __init__(self, grasp: Grasp) -> None:
        self._grasp = grasp
        self._known: dict[States, _Unopposed] = {}

    def refutation(self, wrench: RationalVector, states: States) -> Refutation | None:
        """Return a Farkas vector that needs the balance alone, if there is one."""
        free = self._known.get(states)
        if free is None:
            free = self._known[states] = self._unopposed(states)
        for direction in free.directions:
            product = dot(direction, wrench)
            if product:
                # A balance that is 0 = 0 gets no multiplier.
                factors = (
                    _ZERO if constant is not None and constant + w == 0 else x / -product
                    for x, w, constant in zip(direction, wrench, free.constants, strict=True)
                )
                conditions = sum(_CONDITIONS[state] for state in states)
                sticking = states.count("stick")
                return Refutation((_ZERO,) * conditions, (*factors, *[_ZERO] * sticking))
        return None

    def _unopposed(self, states: States) -> _Unopposed:
        span: list[RationalVector] = []
        for contact, state in zip(self._grasp, states, strict=True):
            if state == "stick":
                span += [contact.normal_wrench, contact.tangential_wrench]
            elif state != "detached":
                span.append(slip_edge(contact, state))
        reduced, pivots, scale = gauss_jordan(span)
        directions = []
        for free in (j for j in range(3) if j not in pivots):
            direction = [Fraction(int(j == free)) for j in range(3)]
            for row, pivot in zip(reduced, pivots, strict=False):
                direction[pivot] = Fraction(-row[free], scale)
            directions.append(tuple(direction))
        if not directions:
            return _Unopposed((), ())
        return _Unopposed(tuple(directions), tuple(self._constant(states, j) for j in range(3)))

    def _constant(self, states: States, axis: int) -> Fraction | None:
        """Return the constant of a balance without unknowns.

        Normal forces depend on one motion, so they can cancel where their directions do not.
        """
        row = [_ZERO] * 4
        for contact, state in zip(self._grasp, states, strict=True):
            if state == "detached":
                continue
            if state != "stick":
                along = slip_edge(contact, state)[axis]
            elif contact.tangential_wrench[axis]:
                return None
            else:
                along = contact.normal_wrench[axis]
            if along:
                spring = normal_force_row(contact)
                row = [a + along * b for a, b in zip(row, spring, strict=True)]
        return None if any(row[:3]) else row[3]
