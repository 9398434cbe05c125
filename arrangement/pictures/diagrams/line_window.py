"""Which part of the plane a picture of lines shows: all crossings, or those that are not far off.

Lines that are nearly parallel cross far away. When a window with all crossings would make most
bounded regions too small to be seen, the farthest crossings are left out. Whatever the window is,
what is drawn in it is exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.drawing.scene.items import Floats
from arrangement.enumeration.great_circles import SphereArrangement
from arrangement.numbers.exact import RationalVector, dot, quotient
from arrangement.numbers.real import rational_near
from arrangement.pictures.sphere.globe import Globe

#: The direction from which the cone is seen: the plane of the lines is at height 1 above it.
ABOVE = (0, 0, 1)
#: Room around the vertices as a share of the window.
_ROOM = Fraction(1, 2)
#: The least width of the window over its height, and the least height over its width.
_LEAST = Fraction(4, 5), Fraction(11, 20)
#: A region below this share of the window cannot be seen: a millimetre in a column of text.
_SEEN = 1 / 80
#: Shares of the crossings that a window may have, tried in turn.
_SHARES = (1.0, 0.98, 0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6, 0.55, 0.5)


@dataclass(frozen=True)
class LineWindow:
    """A rectangle of the plane.

    Attributes:
        middle, half: its middle and half sides.
        vertices: the crossings in it, or rational points near them.
        left_out: how many crossings are not in it, because of which regions can be seen.
    """

    middle: RationalVector
    half: RationalVector
    vertices: Sequence[RationalVector]
    left_out: int = 0

    @classmethod
    def between(cls, lines: Arrangement, corners: Sequence[RationalVector]) -> LineWindow:
        """Return the window with two opposite corners."""
        columns = [sorted(column) for column in zip(*corners, strict=True)]
        middle, half = (tuple((b + s * a) / 2 for a, b in columns) for s in (1, -1))
        vertices = _crossings(lines)[0].values()
        return cls(middle, half, [p for p in vertices if _inside(p, middle, half)])

    @classmethod
    def of(cls, lines: Arrangement) -> LineWindow:
        """Return the window in which most bounded regions are seen, with all crossings if it can.

        Lines without a crossing are shown around their points nearest to 0.
        """
        found, boxes = _crossings(lines)
        vertices = list(found.values())
        if not vertices:
            feet = (((a * c, b * c), a * a + b * b) for a, b, c in lines.integer_planes)
            nearest = [tuple(rational_near(quotient(x, square)) for x in p) for p, square in feet]
            return cls(*_around(nearest), [])
        places = np.array(vertices, dtype=float)
        away = np.abs(places - np.median(places, axis=0)).max(axis=1)
        order = np.argsort(away, kind="stable").tolist()
        best, fewest = cls(*_around(vertices), vertices), len(boxes) + 1
        for share in _SHARES:
            middle, half = _around([vertices[k] for k in order[: round(share * len(order))]])
            unseen = len(boxes) - _seen(boxes, middle, half)
            if unseen < fewest:
                inside = [p for p in vertices if _inside(p, middle, half)]
                best = cls(middle, half, inside, len(vertices) - len(inside))
                fewest = unseen
            if 2 * unseen <= len(boxes):
                break
        return best

    @property
    def unit(self) -> Fraction:
        """The length that the disc draws half-way to infinity or nearer."""
        sizes = (
            max(abs(x - c) for x, c in zip(p, self.middle, strict=True)) for p in self.vertices
        )
        away = sorted(size for size in sizes if size)
        if not away:
            return max(self.half) / 2
        return max(away[len(away) // 2] * Fraction(5, 4), away[-1] / 5)


def cone(lines: Arrangement, middle: RationalVector, unit: Fraction) -> Arrangement:
    """Return the cone over lines in the coordinates ``(x - middle) / unit``."""
    planes = lines.integer_planes
    rows = [(unit * a, unit * b, dot((a, b), middle) - c) for a, b, c in planes]
    return Arrangement(rows, dimension=3)


def _crossings(lines: Arrangement) -> tuple[dict[int, RationalVector], Floats]:
    """Return crossings, or rational points near them, and the boxes of the bounded regions.

    A box is ``(left, low, right, high)``, shape (regions, 4).
    """
    sphere = Globe(cone(lines, (Fraction(0),) * 2, Fraction(1)), ABOVE).whole
    found: dict[int, RationalVector] = {}
    for v in range(sphere.vertex_count):
        x, y, w = sphere.ray(v)
        if w > 0:
            found[v] = (rational_near(quotient(x, w)), rational_near(quotient(y, w)))
    return found, _boxes(sphere, found)


def _boxes(sphere: SphereArrangement, found: dict[int, RationalVector]) -> Floats:
    places = np.full((sphere.vertex_count, 2), np.nan)
    for v, place in found.items():
        places[v] = [float(x) for x in place]
    boxes = [np.empty((0, 4))]
    for r in range(sphere.region_count if sphere.rank == 3 else 0):
        corners = places[sphere.incidence.origin[sphere.incidence.boundary(r)]]
        if not np.isnan(corners).any():  # all on the side of the plane: the region is bounded
            boxes.append(np.concatenate([corners.min(axis=0), corners.max(axis=0)])[None])
    return np.concatenate(boxes)


def _around(points: Sequence[RationalVector]) -> tuple[RationalVector, RationalVector]:
    """Return middle and half sides of a window around points."""
    columns = list(zip(*points, strict=True)) or [(Fraction(0),)] * 2
    middle = tuple((min(column) + max(column)) / 2 for column in columns)
    sizes = [(max(column) - min(column)) / 2 for column in columns]
    room = (max(sizes) or Fraction(1)) * _ROOM
    largest = max(sizes) + room
    return middle, tuple(max(s + room, largest * x) for s, x in zip(sizes, _LEAST, strict=True))


def _inside(point: RationalVector, middle: RationalVector, half: RationalVector) -> bool:
    return all(abs(x - c) <= h for x, c, h in zip(point, middle, half, strict=True))


def _seen(boxes: Floats, middle: RationalVector, half: RationalVector) -> int:
    """Return how many regions have their middle in a window, and a size that is seen."""
    centres, sizes = (boxes[:, :2] + boxes[:, 2:]) / 2, (boxes[:, 2:] - boxes[:, :2]).max(axis=1)
    centre, room = (np.array([float(x) for x in v]) for v in (middle, half))
    within = (np.abs(centres - centre) <= room).all(axis=1)
    return int((within & (sizes >= _SEEN * 2 * room.max())).sum())
