"""Potential Contact Robustness and Potential Grasp Robustness ([Prattichizzo1997]).

Linear springs, in the normal and in the tangential direction, turn a wrench w into changes of the
contact forces, ``p = R w`` with ``R = -K G^T (G K G^T)^-1``. With delta the least distance of a
force at rest from violating its constraint, every w with ``|w| <= delta / sigma_max(R)`` leaves all
forces legal. This bound is the PCR. The PGR is the largest such bound over choices of states: a
contact sticks (both springs; its distance is that from the boundary of its cone), slips (the normal
spring alone and no friction; its distance is ``c_n``) or is detached (no force, so that its preload
is 0). At rest there are the preloads, and friction that balances them if it has to.

Neither is a verdict beyond its bound, so there they say nothing. Torque is measured in force times
one unit of length. The decision is exact: ``delta^2 - |w|^2 R^T R`` has no negative eigenvalue.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import chain, combinations, product

import numpy as np

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear.rank import determinant, gauss_jordan
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp

from .method import Method, Outcome
from .springs import STATES, balancing_friction, check_states

Matrix = tuple[RationalVector, ...]


@dataclass(frozen=True)
class RobustnessBound:
    """Wrenches up to a size that leave all contact forces legal, with linear springs.

    Attributes:
        states: of the contacts.
        squared_distance: delta^2, exact.
        gain: ``R^T R``, exact, 3 x 3.
    """

    states: tuple[str, ...]
    squared_distance: Fraction
    gain: Matrix

    @property
    def value(self) -> float:
        """The bound on ``|w|``, in floats; `covers` is exact."""
        gain = np.array([[float(x) for x in row] for row in self.gain])
        return math.sqrt(float(self.squared_distance) / float(np.linalg.eigvalsh(gain)[-1]))

    def covers(self, wrench: Iterable[Fraction]) -> bool:
        """Return whether a wrench is within the bound, exactly."""
        load = tuple(wrench)
        size = dot(load, load)
        rows = [[-size * x for x in row] for row in self.gain]
        for k in range(3):
            rows[k][k] += self.squared_distance
        unit = math.lcm(*(x.denominator for row in rows for x in row))
        minors = (combinations(range(3), k) for k in (1, 2, 3))
        # A symmetric matrix has no negative eigenvalue where no principal minor is negative.
        return all(
            determinant([[int(rows[i][j] * unit) for j in places] for i in places]) >= 0
            for places in chain(*minors)
        )


def contact_robustness(grasp: Grasp) -> RobustnessBound | None:
    """Return the PCR: every contact sticks; None where friction cannot balance the preloads.

    None as well where the springs cannot balance every wrench.

    Source: [Prattichizzo1997].

    >>> from equilibrium import read_grasp
    >>> round(contact_robustness(read_grasp("paper-four-contacts-preload-1")).value, 4)
    0.8944
    """
    grasp.require_plane()
    return _bound(grasp, ("stick",) * len(grasp))


def grasp_robustness(grasp: Grasp) -> RobustnessBound | None:
    """Return the PGR: the choice of states with the largest bound; None as `contact_robustness`.

    Raises:
        OutOfReachError: too many contacts for all 3^m choices.
    """
    grasp.require_plane()
    check_states(grasp)
    bounds = (_bound(grasp, states) for states in product(STATES, repeat=len(grasp)))
    known = (bound for bound in bounds if bound is not None)
    return max(known, key=lambda bound: bound.value, default=None)


def _bound(grasp: Grasp, states: tuple[str, ...]) -> RobustnessBound | None:
    pairs = list(zip(grasp.without_pads(), states, strict=True))
    if any(state == "detached" and contact.preload for contact, state in pairs):
        return None
    none = Fraction(0)
    held = (c if state == "stick" else replace(c, friction=none) for c, state in pairs)
    friction = balancing_friction(Grasp(held))
    if friction is None:
        return None
    gain = _gain([*_springs(pairs)])
    if gain is None:
        return None
    distances = (
        contact.preload**2 if state == "slip" else _squared_distance(contact, force)
        for (contact, state), force in zip(pairs, friction, strict=True)
        if state != "detached"
    )
    return RobustnessBound(states, min(distances), gain)


def _squared_distance(contact: Contact, friction: Fraction) -> Fraction:
    """Return how far a force at rest is from the boundary of its cone, squared."""
    inside = contact.friction * contact.preload - abs(friction)
    return inside * inside / (1 + contact.friction**2)


def _springs(pairs: Iterable[tuple[Contact, str]]) -> Iterator[tuple[Fraction, RationalVector]]:
    """Yield the stiffness and the direction of each spring that acts."""
    for contact, state in pairs:
        if state != "detached":
            yield contact.stiffness, contact.normal_wrench
        if state == "stick":
            yield contact.stiffness, contact.tangential_wrench


def _gain(springs: list[tuple[Fraction, RationalVector]]) -> Matrix | None:
    """Return ``A^-1 B A^-1`` with A and B the sums of ``k v v^T`` and ``k^2 v v^T``."""
    once, twice = (
        [[sum((k**power * v[i] * v[j] for k, v in springs), Fraction(0)) for j in range(3)]
         for i in range(3)]
        for power in (1, 2)
    )  # fmt: skip
    unit = [[Fraction(int(i == j)) for j in range(3)] for i in range(3)]
    rows, pivots, scale = gauss_jordan([a + e for a, e in zip(once, unit, strict=True)])
    if [*pivots[:3]] != [0, 1, 2]:
        return None
    inverse = [tuple(Fraction(x, scale) for x in row[3:]) for row in rows]
    half = [[dot(row, column) for column in zip(*twice, strict=True)] for row in inverse]
    return tuple(tuple(Fraction(dot(row, other)) for other in inverse) for row in half)


def _outcome(bound: RobustnessBound | None, wrench: RationalVector) -> Outcome:
    if bound is None:
        return None, "no bound: springs or friction at rest do not balance"
    if bound.covers(wrench):
        return True, f"every wrench up to {bound.value:.4g}"
    return None, f"says nothing beyond {bound.value:.4g}"


PCR = Method(
    "pcr",
    "Potential Contact Robustness (Prattichizzo 1997)",
    "PCR",
    lambda grasp, wrench: _outcome(contact_robustness(grasp), wrench),
)
PGR = Method(
    "pgr",
    "Potential Grasp Robustness (Prattichizzo 1997)",
    "PGR",
    lambda grasp, wrench: _outcome(grasp_robustness(grasp), wrench),
)
