"""What regions are called in a picture: sign vectors, or numbers with a table below."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property

from arrangement.arrangement import Arrangement
from arrangement.exact import shown

from .labels import sign_text
from .registry import refusal
from .scene import Scene, measure

LABELS = ("signs", "numbers", "none")
#: Planes up to which sign vectors are written of themselves.
SHORT = 4
_SIZE, _STEP = 5.5, 7.0
#: A space as wide as a digit.
FIGURE = "\u2007"


class RegionLabels:
    """The names of regions, and the table that explains numbers.

    Numbers are 1, 2, ... in the order of `Arrangement.regions`.

    Attributes:
        kind: "signs", "numbers" or "none".
        left_out: how many regions were too small for a label.
    """

    def __init__(self, arrangement: Arrangement, labels: str | None) -> None:
        if labels is not None and labels not in LABELS:
            raise refusal(f"the labels are {shown(labels)}", labels, LABELS)
        self.kind = labels or ("signs" if len(arrangement) <= SHORT else "numbers")
        self.left_out = 0
        self._arrangement = arrangement

    @cached_property
    def _numbers(self) -> dict[tuple[int, ...], int]:
        return {face.signs: k + 1 for k, face in enumerate(self._arrangement.regions())}

    def forms(self, signs: Sequence[int]) -> list[str]:
        """Return the name of a region, four signs also in two rows; nothing if it has none."""
        if self.kind == "numbers":
            return [str(self._numbers[tuple(signs)])]
        if self.kind == "none" or not signs:
            return []
        square = [f"{sign_text(signs[:2])}\n{sign_text(signs[2:])}"] * (len(signs) == 4)
        return [sign_text(signs), *square]

    def height(self, width: float, drawn: Sequence[Sequence[int]]) -> float:
        """Return the height of the notes and the table on a sheet, both in points."""
        if self.kind == "none" or not drawn:
            return 0.0
        return _STEP * (3 + len(self._rows(width, drawn)) if self.kind == "numbers" else 1)

    def write(self, scene: Scene, y: float, drawn: Sequence[Sequence[int]]) -> None:
        """Write the notes and the table of the regions drawn, from `y` down."""
        rows = self._rows(scene.width, drawn) if self.kind == "numbers" and drawn else []
        if rows:
            note = "regions by number; numbers of planes are italic"
            scene.write((scene.width / 2, y - _STEP / 2), note, _SIZE)
            y -= _STEP
            column = (scene.width - 8) / len(rows[0])
            for k, row in enumerate(rows):
                for j, text in enumerate(row):
                    place = (6 + column * j, y - _STEP * (k + 0.5))
                    scene.write(place, text, _SIZE, anchor=(0.0, 0.5))
            y -= _STEP * len(rows)
        elif self.kind == "numbers" and drawn:
            text = "regions in the order of Arrangement.regions(); their table would fill the page"
            scene.write((scene.width / 2, y - _STEP / 2), text, _SIZE)
            y -= _STEP
        if self.left_out:
            many = "regions are" if self.left_out > 1 else "region is"
            text = f"{self.left_out} {many} too small for a label"
            scene.write((scene.width / 2, y - _STEP / 2), text, _SIZE)

    def _rows(self, width: float, drawn: Sequence[Sequence[int]]) -> list[list[str]]:
        """Return the table, column by column in order; empty if it is higher than wide."""
        named = sorted((self._numbers[tuple(signs)], sign_text(signs)) for signs in drawn)
        digits = len(str(named[-1][0]))
        entries = [f"{str(number).rjust(digits, FIGURE)} {text}" for number, text in named]
        room = measure(entries[0], _SIZE)[0] + 8
        columns = max(1, min(len(entries), math.floor((width - 8) / room)))
        count = math.ceil(len(entries) / columns)
        if count * _STEP > width:
            return []
        return [entries[k::count] for k in range(count)]
