"""Units of measure that the user states: a label that results carry along.

Nothing is converted. All lengths of a grasp are in one unit and all forces in one; torques are
then in force times length, stiffness in force per length. The friction coefficient has none.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from arrangement.console.number_form import Documented
from arrangement.library.files.json_files import check_keys
from arrangement.numbers.exact import shown

from .errors import GraspError

_MAX_LENGTH = 20


@dataclass(frozen=True, repr=False)
class Units(Documented):
    """The units of length and of force, in the user's words.

    >>> Units("mm", "N").torque
    'N mm'
    """

    in_document = ("length", "force")

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
