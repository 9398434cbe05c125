"""The shape of the object, if it is stated: pictures show it, and no decision looks at it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.exact import RationalVector, rational, rational_vector, to_text
from arrangement.io.files import check_keys, check_list

from .errors import GraspError


@dataclass(frozen=True)
class Polygon:
    """An object with straight edges.

    Args:
        corners: at least three points in order, in either orientation (length).
    """

    corners: tuple[RationalVector, ...]

    def __init__(self, corners: Iterable[Iterable[Any]]) -> None:
        found = tuple(pair(corner, f"outline[{i}]") for i, corner in enumerate(corners))
        if len(found) < 3:
            raise GraspError(f"the outline has {len(found)} corners; give at least three")
        object.__setattr__(self, "corners", found)

    @property
    def extremes(self) -> tuple[RationalVector, ...]:
        """Points whose bounding box is that of the object."""
        return self.corners

    def to_dict(self) -> list[list[str]]:
        """Return the file form: the corners."""
        return [[to_text(x) for x in corner] for corner in self.corners]


@dataclass(frozen=True)
class Circle:
    """A round object.

    Args:
        centre: point (length).
        radius: above 0 (length).
    """

    centre: RationalVector
    radius: Fraction

    def __init__(self, centre: Iterable[Any], radius: Any) -> None:
        object.__setattr__(self, "centre", pair(centre, "the centre of the outline"))
        object.__setattr__(self, "radius", rational(radius, "the radius of the outline"))
        if self.radius <= 0:
            raise GraspError(f"the radius of the outline is {self.radius}; it must be above 0")

    @property
    def extremes(self) -> tuple[RationalVector, ...]:
        """Points whose bounding box is that of the object."""
        return tuple(tuple(x + side * self.radius for x in self.centre) for side in (-1, 1))

    def to_dict(self) -> dict[str, Any]:
        """Return the file form."""
        return {"centre": [to_text(x) for x in self.centre], "radius": to_text(self.radius)}


Outline: TypeAlias = Polygon | Circle


def read_outline(form: Any) -> Outline:
    """Return the outline of a file form: a list of corners, or an object with centre and radius.

    Raises:
        InputError: another form, or a number out of range.
    """
    if isinstance(form, (list, tuple)):
        return Polygon(check_list(corner, f"outline[{i}]", 2) for i, corner in enumerate(form))
    check_keys(form, ("centre", "radius"), (), "outline")
    return Circle(check_list(form["centre"], "outline.centre", 2), form["radius"])


def pair(values: Iterable[Any], name: str) -> RationalVector:
    """Return two rationals."""
    found = rational_vector(values, name)
    if len(found) != 2:
        raise GraspError(f"{name} has {len(found)} coordinates; give two")
    return found
