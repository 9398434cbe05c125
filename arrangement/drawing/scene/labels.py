"""Labels that cover nothing: `write_if_free` leaves them out for want of room, `Labels` does not.

Where a label could stand is said by `places`, as a function of its size.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import product
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.console import number_form

from .items import Floats
from .places import Places
from .scene import FONT, Scene

Booleans: TypeAlias = npt.NDArray[np.bool_]
#: Sizes of sign vectors that are tried, in points.
SIZES = (7.0, 6.0, 5.0)
#: Between signs, so that minus signs do not run together.
HAIR = "\u200a"


def sign_text(signs: Sequence[int]) -> str:
    """Return a sign vector as text: true minus signs, a hair apart."""
    return HAIR.join(number_form.sign_text(signs, "\u2212"))


def write_if_free(
    scene: Scene,
    texts: Sequence[str],
    sizes: Sequence[float],
    places: Places,
    *,
    off: Any = None,
    **style: Any,
) -> bool:
    """Write a label at the first of its places that is free; return whether there is one.

    Args:
        scene: where to.
        texts: forms of the label; all of them are tried before a smaller size.
        sizes: in points, the largest first.
        places: for half the width and height of a text, centres (k, 2), the best first.
        off: shapes that must not be covered, see `keep_off`; labels never cover each other.
        style: of the text, see `scene`.
    """
    for size, text in product(sizes, texts):
        half = np.array(scene.measure(text, size)) / 2
        centres = places(half)
        if off is not None:
            centres = centres[~covering(off, np.hstack([centres - half, centres + half]))]
        for centre in centres:
            if scene.write(centre, text, size, **style):
                return True
    return False


class Labels:
    """Labels that must be written: each at its first free place, else where it covers least."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._lines: list[Floats] = []
        self._off: Any = None

    @property
    def off(self) -> Any:
        """What labels should not cover, as for `write_if_free`."""
        self._off = self._off or keep_off(self._lines)
        return self._off

    def avoid(self, *lines: Any) -> None:
        """Keep labels off lines through points (k, 2), where that can be."""
        self._lines += map(np.asarray, lines)
        self._off = None

    def write(self, text: str, places: Places, **style: Any) -> None:
        """Write a text at one of its places."""
        import shapely

        half = np.array([self.scene.measure(text)[0], FONT]) / 2
        centres, room = places(half), half + np.array([1.0, 0.5])
        low, high = centres - room, centres + room
        others = np.array(self.scene.boxes).reshape(-1, 2, 2)
        shared = np.minimum(high[:, None], others[:, 1]) - np.maximum(low[:, None], others[:, 0])
        paper = np.array([self.scene.width, self.scene.height])
        outside = np.maximum(-low, 0).sum(axis=1) + np.maximum(high - paper, 0).sum(axis=1)
        rooms = shapely.box(*(low - 0.6).T, *(high + 0.6).T)
        crossed = np.bincount(self.off.query(rooms, "intersects")[0], minlength=len(rooms))
        covered = np.maximum(shared, 0).prod(axis=2).sum(axis=1) + outside
        best = int(np.argmin(crossed + 1000 * covered))
        self.scene.boxes.append((*low[best].tolist(), *high[best].tolist()))
        self.scene.text(centres[best], text, **{"halo": (1.5, "white"), "zorder": 7, **style})


def keep_off(
    lines: Iterable[Floats],
    areas: Iterable[Floats] = (),
    discs: Floats | None = None,
    radius: float = 0.0,
) -> Any:
    """Return what labels must not cover as a tree of shapes.

    Args:
        lines: each (k, 2).
        areas: polygons, each (k, 2).
        discs: their centres, (k, 2).
        radius: of the discs.
    """
    import shapely

    pieces = [np.stack([line[:-1], line[1:]], axis=1) for line in lines]
    segments = shapely.linestrings(np.concatenate([np.empty((0, 2, 2)), *pieces]))
    dots = [] if discs is None else shapely.buffer(shapely.points(discs), radius, quad_segs=2)
    return shapely.STRtree([*segments, *(shapely.Polygon(area) for area in areas), *dots])


def covering(off: Any, boxes: Floats, margin: float = 0.6) -> Booleans:
    """Return for boxes (k, 4), widened by a margin, whether they meet a shape of a tree."""
    import shapely

    low, high = boxes[:, :2] - margin, boxes[:, 2:] + margin
    met = np.zeros(len(boxes), dtype=np.bool_)
    met[off.query(shapely.box(*low.T, *high.T), "intersects")[0]] = True
    return met
