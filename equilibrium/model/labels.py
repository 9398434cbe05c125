"""What a grasp carries along and results repeat: units of measure, and the error of its data.

Units are the user's, and nothing is converted. All lengths of a grasp are in one unit and all
forces in one; torques are then in force times length, stiffness in force per length. The friction
coefficient has none.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.console.number_form import JsonMixin, counted
from arrangement.library.files.json_files import check_keys
from arrangement.numbers.exact import rational, shown

from .errors import GraspError

_MAX_LENGTH = 20


@dataclass(frozen=True, repr=False)
class Units(JsonMixin):
    """The units of length and of force, in the user's words.

    >>> Units("mm", "N").torque
    'N mm'
    """

    json_fields = ("length", "force")

    length: str
    force: str

    def __post_init__(self) -> None:
        for name in ("length", "force"):
            value = getattr(self, name)
            if not isinstance(value, str) or not 0 < len(value) <= _MAX_LENGTH:
                raise GraspError(
                    f"the unit of {name} is {shown(value)}; give a text of 1 to {_MAX_LENGTH} "
                    'characters, such as "mm" or "N"'
                )
            if not value.isprintable() or value != value.strip():
                raise GraspError(
                    f"the unit of {name} is {shown(value)}; write it without control characters "
                    "and without spaces at the ends"
                )

    @property
    def torque(self) -> str:
        """The unit of torques."""
        return f"{self.force} {self.length}"

    @classmethod
    def from_dict(cls, document: Any) -> Units:
        """Return the units of a file form, strictly read."""
        check_keys(document, ("length", "force"), (), "units")
        return cls(document["length"], document["force"])

    def __str__(self) -> str:
        return f"lengths in {self.length}, forces in {self.force}, torques in {self.torque}"


#: What is said of answers about one grasp, where its data were converted.
ROUNDED = "for the data as rounded"
AS_ROUNDED = f"{ROUNDED}; not proved for all within the rounding error"


@dataclass(frozen=True, repr=False)
class DataError(JsonMixin):
    """How far an exact grasp may be from what was measured.

    Attributes:
        length: of each coordinate.
        angle: of each normal (radians).
        value: of friction, stiffness and preload.
        as_given: whether normals that meet, equal numbers and the like were left alone; else they
            hold for the data as they do for the grasp.
    """

    json_fields = ("length", "angle", "value", "as_given")

    length: Fraction
    angle: Fraction
    value: Fraction
    as_given: bool = False

    @classmethod
    def from_dict(cls, document: Any) -> DataError:
        """Return the error of a file form, strictly read."""
        check_keys(document, cls.json_fields, (), "data_error")
        names = cls.json_fields[:3]
        errors = tuple(rational(document[name], f"data_error.{name}") for name in names)
        if not all(0 <= x <= 10**9 for x in errors) or errors[1] > 1:
            raise GraspError(
                f"data_error is {shown(document)}; give errors from 0 to 10^9, an angle up to 1"
            )
        if type(document["as_given"]) is not bool:
            raise GraspError("data_error.as_given is true or false")
        length, angle, value = errors
        return cls(length, angle, value, document["as_given"])


def force_lines(
    rows: Sequence[tuple[Sequence[str], str]], units: Units | None, middle: str = ""
) -> Iterator[str]:
    """Yield the table of contact forces, with its heads.

    Args:
        rows: of each contact its name, its bodies if `middle` says so, its state, normal and
            tangential force; and what follows the cells.
        middle: head of the bodies.
    """
    unit = f" ({units.force})" if units else ""
    heads = ("", *filter(None, [middle]), "state", f"normal{unit}", f"tangential{unit}")
    table = [(heads, ""), *rows]
    widths = [max(map(len, column)) for column in zip(*(cells for cells, _ in table), strict=True)]
    for cells, more in table if rows else ():
        padded = (cell.ljust(width) for cell, width in zip(cells, widths, strict=True))
        yield f"    {'  '.join(padded)}{more}".rstrip()


def equilibria_words(pieces: Sequence[Any]) -> str:
    """Return how many equilibria there are; one that is not unique stands for a family.

    Args:
        pieces: values of `equilibrium.plane.states.equilibrium.Equilibrium`.
    """
    if all(piece.unique for piece in pieces):
        return counted(len(pieces), "equilibrium", "equilibria")
    words = counted(len(pieces), "family of equilibria", "families of equilibria")
    if not all(piece.forces_determined for piece in pieces):
        return words
    return f"{words} (contact forces unique{' in each' * (len(pieces) > 1)})"
