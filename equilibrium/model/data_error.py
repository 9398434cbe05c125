"""The error of the data that a grasp was converted from: a label that its verdicts look at."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.console.number_form import Shown
from arrangement.library.files.json_files import check_keys
from arrangement.numbers.exact import rational, shown, to_text

from .errors import GraspError


@dataclass(frozen=True, repr=False)
class DataError(Shown):
    """How far an exact grasp may be from what was measured.

    Attributes:
        length: of each coordinate.
        angle: of each normal (radians).
        value: of friction, stiffness and preload.
        as_given: whether normals that meet, equal numbers and the like were left alone; else they
            hold for the data as they do for the grasp.
    """

    length: Fraction
    angle: Fraction
    value: Fraction
    as_given: bool = False

    def to_dict(self) -> dict[str, Any]:
        """Return the file form."""
        errors = {name: to_text(getattr(self, name)) for name in ("length", "angle", "value")}
        return {**errors, "as_given": self.as_given}

    @classmethod
    def from_dict(cls, document: Any) -> DataError:
        """Return the error of a file form, strictly read."""
        names = "length", "angle", "value"
        check_keys(document, (*names, "as_given"), (), "data_error")
        errors = tuple(rational(document[name], f"data_error.{name}") for name in names)
        if not all(0 <= x <= 10**9 for x in errors) or errors[1] > 1:
            raise GraspError(
                f"data_error is {shown(document)}; give errors from 0 to 10^9, an angle up to 1"
            )
        if type(document["as_given"]) is not bool:
            raise GraspError("data_error.as_given is true or false")
        length, angle, value = errors
        return cls(length, angle, value, document["as_given"])
