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

    def text(self, signs: Sequence[int]) -> str:
        """Return the name of a region; empty if it has none."""
        if self.kind == "numbers":
            return str(self._numbers[tuple(signs)])
        return sign_text(signs) if self.kind == "signs" else ""

    def height(self, width: float, drawn: Sequence[Sequence[int]]) -> float:
        """Return the height of the notes and the table on a sheet, both in points."""
        if self.kind == "none" or not drawn:
            return 0.0
        return _STEP * (2 + len(self._rows(width, drawn)) if self.kind == "numbers" else 1)

    def write(self, scene: Scene, y: float, drawn: Sequence[Sequence[int]]) -> None:
        """Write the notes and the table of the regions drawn, from `y` down."""
        rows = self._rows(scene.width, drawn) if self.kind == "numbers" and drawn else []
        if rows:
            column = (scene.width - 8) / len(rows[0])
            for k, row in enumerate(rows):
                for j, (number, signs) in enumerate(row):
                    place = (4 + column * j + 13, y - _STEP * (k + 0.5))
                    scene.write(place, number, _SIZE, anchor=(1.0, 0.5), color="0.35")
                    scene.write((place[0] + 3, place[1]), signs, _SIZE, anchor=(0.0, 0.5))
            y -= _STEP * len(rows)
        elif self.kind == "numbers" and drawn:
            text = "regions in the order of Arrangement.regions(); their table would fill the page"
            scene.write((scene.width / 2, y - _STEP / 2), text, _SIZE)
            y -= _STEP
        if self.left_out:
            many = "regions are" if self.left_out > 1 else "region is"
            text = f"{self.left_out} {many} too small for a label"
            scene.write((scene.width / 2, y - _STEP / 2), text, _SIZE)

    def _rows(self, width: float, drawn: Sequence[Sequence[int]]) -> list[list[tuple[str, str]]]:
        """Return the table, column by column in order; empty if it is higher than wide."""
        named = sorted((self._numbers[tuple(signs)], sign_text(signs)) for signs in drawn)
        entries = [(str(number), text) for number, text in named]
        room = measure(named[0][1], _SIZE)[0] + 24
        columns = max(1, min(len(entries), math.floor((width - 8) / room)))
        count = math.ceil(len(entries) / columns)
        if count * _STEP > width:
            return []
        return [entries[k::count] for k in range(count)]
