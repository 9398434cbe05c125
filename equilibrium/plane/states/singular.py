"""Which loads the choices of contact states allow whose systems are singular, whatever the load.

With fewer than three touching contacts the balance has more equations than unknowns matter, so only
loads of some planes can have such states. Where contacts stick in all directions the motion is 0,
and forces inside the friction cones of the preloads balance the load: a virtual motion against
which they work less than the load shows that they cannot.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import combinations

from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive
from arrangement.numbers.linear.rank import cross, gauss_jordan, rank
from equilibrium.model.grasp import Grasp

from .state_system import States, state_system

_NO_LOAD = (Fraction(0),) * 3


class SingularStates:
    """Choices of contact states whose systems floats cannot solve."""

    def __init__(self, grasp: Grasp, choices: Iterable[States]) -> None:
        self._planes: list[list[IntegerVector]] = []
        self._bounds: list[list[IntegerVector]] = []
        for states in choices:
            planes = _planes(grasp, states)
            if planes:
                self._planes.append(planes)
            else:
                self._bounds.append(_bounds(grasp, states))

    def may_hold(self, wrench: RationalVector) -> bool:
        """Return whether one of them may balance a load; False is exact."""
        load = primitive((*wrench, Fraction(1)))
        return any(all(dot(row, load) == 0 for row in rows) for rows in self._planes) or any(
            all(dot(row, load) >= 0 for row in rows) for rows in self._bounds
        )


def _planes(grasp: Grasp, states: States) -> list[IntegerVector]:
    """Return rows that are 0 at all loads, with 1 last, that have these states."""
    system = state_system(grasp, states, _NO_LOAD)
    n = system.size
    unit = [tuple(Fraction(int(j == k)) for j in range(3)) for k in range(n)]
    rows = [(*row[:n], *e, row[n]) for row, e in zip(system.equalities, unit, strict=True)]
    reduced, pivots, _ = gauss_jordan(rows)
    return [primitive(row[n:]) for row, pivot in zip(reduced, pivots, strict=False) if pivot >= n]


def _bounds(grasp: Grasp, states: States) -> list[IntegerVector]:
    """Return rows that are at least 0 at all loads, with 1 last, that have these states.

    There are some where the motion is 0: by the planes of two tangential wrenches.
    """
    sticking = [c for c, state in zip(grasp, states, strict=True) if state == "stick"]
    if rank([primitive(c.tangential_wrench) for c in sticking]) < 3:
        return []
    rows = []
    for one, other in combinations(sticking, 2):
        motion = cross(one.tangential_wrench, other.tangential_wrench)
        pull = sum(c.friction * c.preload * abs(dot(c.tangential_wrench, motion)) for c in sticking)
        push = sum(c.preload * dot(c.normal_wrench, motion) for c in sticking)
        # The load, the preloads and at most all friction: no work is left over.
        rows += [primitive((*(s * x for x in motion), s * push + pull)) for s in (1, -1)]
    return rows
