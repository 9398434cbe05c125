"""What a search ends with: an equilibrium, exact or enclosed in a box; a proof; or neither."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple, TypeAlias

from arrangement.console.number_form import JsonMixin, counted
from arrangement.numbers.exact import RationalVector, vector_text


class Enclosure(NamedTuple):
    """What shows an equilibrium in space whose numbers are not rational.

    Attributes:
        basis: p motions; the motions looked at are their combinations.
        friction: for each contact None if it is detached, () if it slips, and if it sticks its
            friction force over ``mu c_n``, without that of pillars.
        pillars: (contact, 0 or 1): tangents along which a sticking contact has one more force.
        centre, radius: six intervals, of the combination and of the forces of pillars.
        inverse: (6, 6), about the inverse of the derivative of the balance in the centre.
        idle: null-space motions, which do no work at any loaded contact, as turns about the line of
        two, with a number.
    """

    basis: tuple[RationalVector, ...]
    friction: tuple[RationalVector | None, ...]
    pillars: tuple[tuple[int, int], ...]
    centre: RationalVector
    radius: RationalVector
    inverse: tuple[RationalVector, ...]
    idle: tuple[RationalVector, ...] = ()


@dataclass(frozen=True)
class Solution(JsonMixin):
    """One equilibrium.

    Attributes:
        motion: three numbers, in space six.
        forces: at each contact the normal force and one along each tangent: one, in space two.
        box: what holds it if its numbers are not rational; motion and forces are then near floats.
    """

    json_fields = ("motion", "forces")

    motion: RationalVector
    forces: tuple[RationalVector, ...]
    box: Enclosure | None = field(default=None, repr=False)

    def __repr__(self) -> str:
        return (
            f"<Solution: motion {vector_text(self.motion)}, {counted(len(self.forces), 'force')}>"
        )


@dataclass(frozen=True)
class Open:
    """Neither was proved.

    Attributes:
        reason: in words.
        residual: of the motion that is closest to an equilibrium, as a share of the forces.
    """

    reason: str
    residual: float


#: The tree of virtual motions that refutes all, in the form of certificates.
Tree: TypeAlias = dict[str, Any] | list[Any]
#: An equilibrium, the proof that there is none, or neither.
Outcome: TypeAlias = Solution | Tree | Open
