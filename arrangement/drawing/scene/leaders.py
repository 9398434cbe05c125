"""Labels outside of what they name, each with a line to a dot in it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from .items import Box, Floats
from .labels import covering, keep_off, write_if_free
from .places import around, reach
from .scene import Scene

#: Lengths of leader lines that are tried, in points.
_LENGTHS = (7.0, 10.0, 14.0, 19.0, 25.0, 32.0, 40.0, 50.0)
#: Radius of the dot at the end of a leader line, in points.
_DOT = 0.6
#: The least radius of a disc in what is named, in points.
_LEAST = 0.45


class Leaders:
    """Labels off all lines, each with a line to a dot in what it names.

    Args:
        scene: where to.
        lines: (k, 2) each; no label covers one, and leader lines cross as few as can be.
        within: a part of the scene that must not be left.
        areas: (k, 2) each; other places are better for labels, which might be taken for theirs.
    """

    def __init__(
        self, scene: Scene, lines: Sequence[Floats], within: Box, areas: Sequence[Floats]
    ) -> None:
        import shapely

        self.scene = scene
        self.off = keep_off(lines)
        self.within = shapely.box(*within)
        self.areas = shapely.STRtree([shapely.Polygon(area).buffer(0) for area in areas])
        self.drawn: list[Any] = []

    def write(self, edge: Floats, texts: Sequence[str], sizes: Sequence[float]) -> bool:
        """Name what has an outline with points `edge`, or return False where there is no room."""
        import shapely

        area = shapely.Polygon(edge).buffer(0)
        if area.is_empty:
            return False
        pole, rim = shapely.maximum_inscribed_circle(area).coords
        room = math.dist(pole, rim)
        if room < _LEAST:
            return False
        start = np.round(pole, 2)
        ends: dict[Any, Floats] = {}

        def places(half: Floats) -> Floats:
            centres, tips = self._places(start, half)
            ends.update(zip(map(tuple, centres.tolist()), tips, strict=True))
            return centres

        if not write_if_free(self.scene, texts, sizes, places):
            return False
        written = np.reshape(self.scene.boxes[-1], (2, 2)).mean(axis=0)
        nearest = min(ends, key=lambda centre: math.dist(centre, written))
        track = np.array([start, ends[nearest]])
        self.drawn.append(shapely.linestrings(track))
        style = {"zorder": 5.5, "gid": "leader"}
        self.scene.line(track, ec="black", lw=0.35, **style)
        self.scene.circle(start, min(_DOT, 0.8 * room), fc="black", ec="none", **style)
        return True

    def _places(self, start: Floats, half: Floats) -> tuple[Floats, Floats]:
        """Return centres off all lines, the best first, and the ends of their leader lines."""
        import shapely

        ways = np.tile(around(), (len(_LENGTHS), 1))
        length = np.repeat(_LENGTHS, len(around()))[:, None]
        centres = start + ways * (length + reach(half, ways))
        low, high = centres - half, centres + half
        boxes = shapely.box(*(low - 1.0).T, *(high + 1.0).T)
        # Of long names few have a place at all.
        kept = np.flatnonzero(shapely.contains(self.within, boxes))
        kept = kept[~covering(self.off, np.hstack([low, high])[kept], 1.0)]
        ways, length, centres, boxes = (x[kept] for x in (ways, length, centres, boxes))
        ends = start + ways * (length - 0.6)
        tracks = shapely.linestrings(np.stack([np.broadcast_to(start, ends.shape), ends], axis=1))
        written = shapely.STRtree(shapely.box(*np.array(self.scene.boxes).reshape(-1, 4).T))
        leaders = shapely.STRtree(self.drawn)
        free = np.ones(len(kept), bool)
        for taken in (
            leaders.query(boxes, "dwithin", 0.6),
            leaders.query(tracks, "dwithin", 0.6),
            written.query(tracks, "intersects"),
        ):
            free[np.unique(taken[0])] = False
        crossed = np.bincount(self.off.query(tracks, "intersects")[0], minlength=len(tracks))
        cost = 6.0 * crossed + length[:, 0]
        cost[np.unique(self.areas.query(boxes, "intersects")[0])] += 15.0
        cost[np.unique(written.query(boxes, "dwithin", 3.0)[0])] += 8.0
        order = np.argsort(cost, kind="stable")
        order = order[free[order]]
        return centres[order], ends[order]
