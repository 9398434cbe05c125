"""The contact law in R^n as rows: all that a search for equilibria knows of a question.

A motion is d in R^n. Contact i has the row N_i and one or two tangential rows T_i; its spring has
the force ``max(0, q_i - k_i N_i . d)`` along N_i, its friction acts along the T_i, and balance is
``sum ((c_n - a_i) N_i + c_t T_i) + w = 0`` with the adhesion a_i. A grasp in the plane has n = 3
and one tangent, a grasp in space n = 6 and two; b bodies in the plane have n = 3 b and one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from arrangement.numbers.exact import RationalVector

from .contact import VALUES, adhesion_wrench
from .grasp import Grasp

#: Which numbers of the motion of one body are turns, in the plane and in space.
TURNS = {2: (False, False, True), 3: (False, False, False, True, True, True)}


class ContactRow(NamedTuple):
    """One contact: N, and T for each tangent, as rows of n rationals; and its values."""

    normal_wrench: RationalVector
    tangential_wrenches: tuple[RationalVector, ...]
    friction: Fraction
    stiffness: Fraction
    preload: Fraction
    adhesion: Fraction


@dataclass(frozen=True)
class ContactRows:
    """The contacts of a grasp, or of an assembly.

    Attributes:
        contacts: their rows.
        points: of the contacts, for the typical size of a motion.
        turns: for each of the n numbers of a motion, whether it is a turn.
        tangents: how many each contact has: 1 or 2.
    """

    contacts: tuple[ContactRow, ...]
    points: tuple[RationalVector, ...]
    turns: tuple[bool, ...]
    tangents: int

    @classmethod
    def of_grasp(cls, grasp: Grasp) -> ContactRows:
        """Return the rows of a grasp, in the plane or in space."""
        rows = tuple(
            ContactRow(c.normal_wrench, c.tangential_wrenches, *(getattr(c, x) for x in VALUES))
            for c in grasp
        )
        points = tuple(c.point for c in grasp)
        return cls(rows, points, TURNS[grasp.dimension], grasp.dimension - 1)

    @property
    def n(self) -> int:
        """How many numbers a motion has."""
        return len(self.turns)

    def total_load(self, load: Iterable[Fraction]) -> RationalVector:
        """Return a load and the constant wrench of the adhesion: what the other forces balance."""
        return tuple(x + y for x, y in zip(load, adhesion_wrench(self, self.n), strict=True))

    def __len__(self) -> int:
        return len(self.contacts)

    def __iter__(self) -> Iterator[ContactRow]:
        return iter(self.contacts)

    def __getitem__(self, i: int) -> ContactRow:
        return self.contacts[i]
