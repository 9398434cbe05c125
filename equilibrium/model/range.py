"""The range of small motions: which equilibria count, by bounds on their rotation and forces."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypedDict

from arrangement.numbers.exact import RationalVector, rational, shown, to_text

from .errors import GraspError

#: Beyond these a verdict without a range says so: the rotation, and normal forces as multiples of
#: ``|f_x| + |f_y|`` (and ``|f_z|``) of the load plus the largest preload.
USUAL_TURN, USUAL_FORCE = Fraction(1, 10), 100


class RangeArguments(TypedDict):
    """The bounds of a range, as keyword arguments."""

    largest_turn: Any
    largest_force: Any


@dataclass(frozen=True)
class Range:
    """RangeArguments that an equilibrium has to keep in order to count; true if there is one.

    Attributes:
        largest_turn: of the rotation, in space of the length of the rotation vector, in radians.
        largest_force: of the normal force at each contact.
    """

    largest_turn: Fraction | None = None
    largest_force: Fraction | None = None

    def __bool__(self) -> bool:
        return self != NO_RANGE

    def __str__(self) -> str:
        """Return what follows a verdict in words; nothing without a bound."""
        named = {"largest_turn": "turns up to", "largest_force": "normal forces up to"}
        words = [f"{named[name]} {number}" for name, number in self.to_dict().items()]
        return f", among {' and '.join(words)}" if words else ""

    @classmethod
    def of(cls, largest_turn: Any = None, largest_force: Any = None) -> Range:
        """Return the range of two exact numbers; None is no bound.

        Raises:
            InputError: no exact number, or one below 0.
        """
        found = list[Fraction | None]()
        for name, value in (("largest_turn", largest_turn), ("largest_force", largest_force)):
            number = None if value is None else rational(value, name)
            if number is not None and number < 0:
                raise GraspError(f"{name} is {shown(value)}; give a number of at least 0")
            found.append(number)
        return cls(*found)

    @property
    def bounds(self) -> RangeArguments:
        """The bounds as keyword arguments of `equilibrium.solve`."""
        return {"largest_turn": self.largest_turn, "largest_force": self.largest_force}

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
#: What pictures say of an equilibrium beyond the usual range.
SMALL = "beyond small motions: it turns or pushes too far for the linear model"


def turns_of(motion: Sequence[Any]) -> Sequence[Any]:
    """Return the rotation of a motion: one number, in space three."""
    return motion[2 if len(motion) == 3 else 3 :]


def usual_range(wrench: RationalVector, preloads: Iterable[Fraction]) -> Range:
    """Return the range beyond which a verdict says that its motions are not small."""
    size = sum(map(abs, wrench[: 2 if len(wrench) == 3 else 3]), Fraction(0))
    size += max(preloads, default=Fraction(0))
    return Range(USUAL_TURN, USUAL_FORCE * size or None)


def warning(every: bool) -> str:
    """Return the line that a verdict has beyond the usual range.

    Args:
        every: whether this is known of all equilibria.
    """
    return (
        f"beyond small motions: {'every equilibrium' if every else 'the equilibrium found'} "
        f"turns by more than {to_text(USUAL_TURN)} or presses with over {USUAL_FORCE} times load "
        "and preload (see --largest-turn, --largest-force)"
    )
