"""What stands under a picture of regions: a legend, a note, and what numbers mean."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from .colours import Colouring, DrawnRegion
from .regionlabels import RegionLabels
from .scene import POINTS, Scene

_NOTE = 8.0


@dataclass(frozen=True)
class Footer:
    """The lower part of a sheet.

    Attributes:
        colouring: of the regions.
        names: of the regions.
        drawn: the regions in the picture.
        notes: lines of text.
        keys: more entries of a legend, see `Scene.keys`; a row of their own.
    """

    colouring: Colouring
    names: RegionLabels
    drawn: Sequence[DrawnRegion]
    notes: Sequence[str] = ()
    keys: Sequence[tuple[str, dict[str, Any]]] = ()

    def height(self, width: float) -> float:
        """Return how much room it needs on a sheet of a width; both in millimetres."""
        trial = Scene(width, 10.0)
        rows = trial.keys(0.0, self.colouring.keys(self.drawn)) + trial.keys(0.0, self.keys)
        signs = [region.signs for region in self.drawn]
        names = self.names.height(trial.width, signs)
        return (rows + _NOTE * len(self.notes) + names + 4.0) / POINTS

    def write(self, scene: Scene, y: float) -> None:
        """Write it from the height `y` down, in points."""
        y -= scene.keys(y, self.colouring.keys(self.drawn))
        y -= scene.keys(y, self.keys)
        for note in self.notes:
            scene.write((scene.width / 2, y - _NOTE / 2), note, 6.0)
            y -= _NOTE
        self.names.write(scene, y, [region.signs for region in self.drawn])
