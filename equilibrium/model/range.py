"""The range of small motions: which equilibria count, by bounds on their rotation and forces."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.exact import RationalVector, rational, shown, to_text

from .errors import GraspError

#: Beyond these a verdict without a range says so: the rotation, and normal forces as multiples of
#: ``|f_x| + |f_y|`` (and ``|f_z|``) of the load plus the largest preload.
USUAL_TURN, USUAL_FORCE = Fraction(1, 10), 100


@dataclass(frozen=True)
class Range:
    """Bounds that an equilibrium has to keep in order to count; true if there is one.

    Attributes:
        largest_turn: of the rotation, in space of the length of the rotation vector, in radians.
        largest_force: of the normal force at each contact.
    """

    largest_turn: Fraction | None = None
    largest_force: Fraction | None = None

    def __bool__(self) -> bool:
        return self != NO_RANGE

    @classmethod
    def of(cls, largest_turn: Any = None, largest_force: Any = None) -> Range:
        """Return the range of two exact numbers; None is no bound.

        Raises:
            InputError: no exact number, or one below 0.
        """
        found = []
        for name, value in (("largest_turn", largest_turn), ("largest_force", largest_force)):
            number = None if value is None else rational(value, name)
            if number is not None and number < 0:
                raise GraspError(f"{name} is {shown(value)}; give a number of at least 0")
            found.append(number)
        return cls(*found)

    def holds(self, motion: Sequence[Any], forces: Iterable[Sequence[Any]]) -> bool:
        """Return whether a motion and forces, the normal one first, keep the bounds."""
        turns, bound, most = turns_of(motion), self.largest_turn, self.largest_force
        if bound is not None and sum(x * x for x in turns) > bound * bound:
            return False
        return most is None or all(force[0] <= most for force in forces)

    def to_dict(self) -> dict[str, str]:
        """Return the bounds that are given, as texts."""
        return {name: to_text(x) for name, x in vars(self).items() if x is not None}


NO_RANGE = Range()


def turns_of(motion: Sequence[Any]) -> Sequence[Any]:
    """Return the rotation of a motion: one number, in space three."""
    return motion[2 if len(motion) == 3 else 3 :]


def usual_range(wrench: RationalVector, preloads: Iterable[Fraction]) -> Range:
    """Return the range beyond which a verdict says that its motions are not small."""
    size = sum(map(abs, wrench[: 2 if len(wrench) == 3 else 3]), Fraction(0))
    size += max(preloads, default=Fraction(0))
    return Range(USUAL_TURN, USUAL_FORCE * size or None)


def warning(motion: Sequence[Any], forces: Iterable[Sequence[Any]], every: bool) -> str:
    """Return the line that a verdict has beyond the usual range.

    Args:
        every: whether this is known of all equilibria.
    """
    turn = sum(float(x) ** 2 for x in turns_of(motion)) ** 0.5
    most = max((float(force[0]) for force in forces), default=0.0)
    return (
        f"beyond small motions: {'every' if every else 'the'} equilibrium {'' if every else 'found '}"
        f"turns by more than {to_text(USUAL_TURN)} or has a normal force above {USUAL_FORCE} times "
        f"load and preload (here a turn of {turn:.3g}, forces up to {most:.3g}); --largest-turn "
        "and --largest-force bound them"
    )
