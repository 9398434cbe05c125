"""How far contact points move: what an equilibrium may do to count, and where it is not small."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.numbers.exact import RationalVector, dot, rational, shown, to_text
from arrangement.numbers.linear.rank import cross

from .errors import GraspError

if TYPE_CHECKING:
    from .grasp import Grasp

#: An equilibrium is not small where it moves a contact point by more than this share of the spread.
SMALL_SHARE = Fraction(1, 10)
#: What pictures say of an equilibrium that is not small.
NOT_SMALL = "beyond small motions: contact points move too far for the linear model"
#: What is said where no number of the grasp gives displacements a unit.
STIFFNESS_ASSUMED = (
    "stiffness 1 assumed: neither stiffness nor preload is given, so displacements have no unit"
)


def read_displacement(value: Any) -> Fraction | None:
    """Return the largest displacement that counts; None means unbounded.

    Raises:
        InputError: no exact number, or one below 0.
    """
    number = None if value is None else rational(value, "max_displacement")
    if number is not None and number < 0:
        raise GraspError(f"max_displacement is {shown(value)}; expected a number of at least 0")
    return number


def displacement_words(bound: Fraction | None) -> str:
    """Return what follows a verdict that is about displacements up to a bound; else nothing."""
    return "" if bound is None else f", among displacements of contacts up to {to_text(bound)}"


def displacement_entry(bound: Fraction | None) -> dict[str, str]:
    """Return the entry of a document for a bound, if there is one."""
    return {} if bound is None else {"max_displacement": to_text(bound)}


def displacement(grasp: Grasp, motion: RationalVector) -> Fraction:
    """Return the largest displacement of a contact point along its normal or a tangent."""
    rows = (row for c in grasp for row in (c.normal_wrench, *c.tangential_wrenches))
    return max((Fraction(abs(dot(row, motion))) for row in rows), default=Fraction(0))


def spread(points: Sequence[RationalVector]) -> Fraction:
    """Return the longest side of the box around points, along the axes."""
    sides = (max(column) - min(column) for column in zip(*points, strict=True))
    return max(sides, default=Fraction(0))


def has_unit(grasp: Grasp) -> bool:
    """Return whether a stiffness or a preload was given, so that displacements have a unit."""
    return any(contact.preload or contact.stiffness_given for contact in grasp)


def small_displacement(grasp: Grasp) -> Fraction | None:
    """Return the largest displacement of small motions; None where nothing says what is small.

    Displacements are forces over stiffnesses. Their size means something where units are stated
    and a number carries them; elsewhere no verdict depends on it.
    """
    size = SMALL_SHARE * spread([contact.point for contact in grasp])
    return size if size and grasp.units is not None and has_unit(grasp) else None


def along_tangents(grasp: Grasp, axes: Sequence[RationalVector]) -> bool:
    """Return whether each contact in space has a tangent in a plane, given by orthonormal axes.

    Then the largest displacement of motions in the plane is that of the plane's own contacts.
    """
    normal = cross(*axes)
    return all(abs(dot(normal, contact.tangent)) in (0, 1) for contact in grasp)


def warning(every: bool) -> str:
    """Return the line of a verdict whose motions are not small.

    Args:
        every: whether this is known of all equilibria.
    """
    return (
        f"beyond small motions: {'every equilibrium' if every else 'the equilibrium found'} moves "
        f"a contact point by more than {to_text(SMALL_SHARE)} of the spread of the contacts (see "
        "--max-displacement)"
    )
