"""Exact numbers near given ones, and the record of what the rounding cost."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.library.arguments import is_listed
from arrangement.numbers.exact import (
    RationalVector,
    from_float,
    number_text,
    rational,
    shown,
    to_text,
    vector_text,
)
from equilibrium.model.contact import VALUES, Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.outline import Outline
from equilibrium.model.unit_normal import UnitNormal, unit_normal

DEFAULT_TOLERANCE = Fraction(1, 10**6)


class ContactIncidence(NamedTuple):
    """Something that contacts have in common, exactly.

    Attributes:
        kind: "parallel" (normals, also opposite ones), "square" (normals at right angles, in
            space), "line" (one line has the normals), "level"
            (points on one line, in space a plane, at right angles to their normals), "point" (the
            points are equal), "meet" (normals meet in a point), "round" (they meet in the centre of
            a circle, in space a sphere, on which the points are).
        contacts: their numbers, from 0.
        at: the point in which normals meet.
        radius: of the circle or sphere.
    """

    kind: str
    contacts: tuple[int, ...]
    at: RationalVector = ()
    radius: Fraction = Fraction(0)

    def __str__(self) -> str:
        whose = "contacts " + ", ".join(str(i + 1) for i in self.contacts)
        surface = "sphere" if len(self.at) == 3 else "circle"
        return {
            "parallel": f"{whose}: parallel normals",
            "square": f"{whose}: normals at right angles",
            "line": f"{whose}: normals on one line",
            "level": f"{whose}: points at one level along parallel normals",
            "point": f"{whose}: one point",
            "meet": f"{whose}: normals meet in {vector_text(self.at)}",
            "round": f"{whose}: on a {surface} of radius {number_text(self.radius)}, normals meet "
            f"in its centre {vector_text(self.at)}",
        }[self.kind]


@dataclass(frozen=True)
class Conversion:
    """An exact grasp and how far it is from what was given.

    Attributes:
        grasp: the result.
        point_errors: for each contact the largest change of a coordinate (length).
        angle_errors: for each contact the tangent of the angle from the given normal to the one
            used (radians, counter-clockwise); see `unit_normal`.
        value_error: the largest change of a friction coefficient, stiffness or preload.
        kept: what contacts have in common within the error of the data, and so exactly.
    """

    grasp: Grasp
    point_errors: RationalVector
    angle_errors: RationalVector
    value_error: Fraction = Fraction(0)
    kept: tuple[ContactIncidence, ...] = ()

    @property
    def exact(self) -> bool:
        """Whether nothing was rounded."""
        return not (any(self.point_errors) or any(self.angle_errors) or self.value_error)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form: the grasp file, and the errors as strings of rationals."""
        return {
            "grasp": self.grasp.to_dict(),
            "point_errors": [to_text(x) for x in self.point_errors],
            "angle_errors": [to_text(x) for x in self.angle_errors],
            "value_error": to_text(self.value_error),
            "kept": [str(incidence) for incidence in self.kept],
        }


def simplest_between(low: Fraction, high: Fraction) -> Fraction:
    """Return the rational of least denominator in a closed interval (then of least size).

    >>> simplest_between(Fraction(31, 100), Fraction(34, 100))
    Fraction(1, 3)
    """
    if low > high:
        raise GraspError(f"the interval from {shown(low)} to {shown(high)} is empty")
    if low <= 0 <= high:
        return Fraction(0)
    if high < 0:
        return -simplest_between(-high, -low)
    whole = -(-low.numerator // low.denominator)
    if whole <= high:
        return Fraction(whole)
    floor = low.numerator // low.denominator
    return floor + 1 / simplest_between(1 / (high - floor), 1 / (low - floor))


def snapped(value: Any, tolerance: Any = DEFAULT_TOLERANCE) -> tuple[Fraction, Fraction]:
    """Return the simplest rational within a tolerance of a number, and the change made.

    Args:
        value: a float or anything exact.
        tolerance: at least 0; 0 keeps the binary value of a float.

    >>> snapped(0.1)
    (Fraction(1, 10), Fraction(-1, 180143985094819840))
    """
    exact, bound = from_float(value, "value"), from_float(tolerance, "tolerance")
    if bound < 0:
        raise GraspError(f"tolerance is {shown(tolerance)}; it must be at least 0")
    found = simplest_between(exact - bound, exact + bound)
    return found, found - exact


def assembled(
    places: Sequence[tuple[RationalVector, Fraction]],
    normals: Sequence[UnitNormal],
    values: Sequence[dict[str, Any]],
    value_error: Fraction = Fraction(0),
    outline: Outline | None = None,
) -> Conversion:
    """Put contacts together from points with errors, unit normals with errors, and values."""
    contacts = [
        Contact(point, normal.normal, **value)
        for (point, _), normal, value in zip(places, normals, values, strict=True)
    ]
    return Conversion(
        Grasp(contacts, outline=outline),
        tuple(error for _, error in places),
        tuple(normal.angle_error for normal in normals),
        value_error,
    )


def contact_values(
    number: int,
    friction: Any,
    stiffness: Any,
    preload: Any,
    read: Callable[[Any, str], Any] = rational,
) -> list[dict[str, Any]]:
    """Return the values of each contact by name, from one for all or a sequence of each kind.

    Args:
        stiffness: None where it is not given.
    """
    known = stiffness is not None
    given = zip(VALUES, (friction, stiffness if known else 1, preload), strict=True)
    columns = [[read(x, y) for x, y in _for_each(value, number, name)] for name, value in given]
    rows = (dict(zip(VALUES, row, strict=True)) for row in zip(*columns, strict=True))
    return [{**row, "stiffness_given": known} for row in rows]


def value_columns(contacts: Sequence[Mapping[str, Any]]) -> dict[str, list[Any]]:
    """Return the columns of values of entries of a document; friction, and what some entry has."""
    defaults = {"stiffness": 1, "preload": 0}
    return {
        name: [entry.get(name, defaults.get(name)) for entry in contacts]
        for name in VALUES
        if name == "friction" or any(name in entry for entry in contacts)
    }


def _for_each(value: Any, number: int, name: str) -> list[tuple[Any, str]]:
    """Return one value for each contact, and its name, from one for all or a sequence of them."""
    if not is_listed(value):
        return [(value, name)] * number
    found = list(value)
    if len(found) != number:
        raise GraspError(f"{name} has {len(found)} values for {number} contacts")
    return [(x, f"{name}[{i}]") for i, x in enumerate(found)]


def unit_normals(directions: Iterable[Any], tolerance: Any) -> list[UnitNormal]:
    """Return exactly unit vectors; errors name the contact."""
    found = []
    for i, direction in enumerate(directions):
        try:
            found.append(unit_normal(direction, tolerance))
        except ValueError as error:
            raise GraspError(f"normals[{i}]: {error}") from None
    return found
