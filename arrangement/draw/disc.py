"""The front half of the sphere as a disc: regions, arcs, names at the rim, sign vectors."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .colours import DrawnRegion, Painter, side_colour
from .globe import Globe
from .labels import flattened, spread, turn, write_inside
from .projections import Drawn, Projection
from .scene import Floats, Scene, checked_width

#: Room for the numbers of the planes between the rim and the border, at least; in points.
RIM = 13.0


@dataclass(frozen=True)
class Disc:
    """A place on a scene for the front half of a globe.

    Attributes:
        scene: the scene.
        centre, radius: of the limb, in points.
        globe: what is seen.
        drawn: its arcs and regions, cut at the limb, as curves.
        ink: the colour of each class of planes; if omitted, black.
    """

    scene: Scene
    centre: tuple[float, float]
    radius: float
    globe: Globe
    drawn: Drawn
    ink: Callable[[int], str] | None = None

    def on_paper(self, points: Floats) -> Floats:
        """Return points of the disc in points of the scene."""
        return np.array(self.centre) + self.radius * points

    def draw(
        self, paint: Painter, *, both_ends: bool = False, avoid: Floats | None = None
    ) -> list[DrawnRegion]:
        """Draw everything, sign vectors off the points `avoid`; return the regions seen."""
        outlines = self.draw_curves(paint, both_ends=both_ends)
        for region, outline in outlines:
            write_inside(self.scene, outline, region.signs, other=avoid)
        return [region for region, _ in outlines]

    def draw_curves(
        self, paint: Painter, *, both_ends: bool = False
    ) -> list[tuple[DrawnRegion, Floats]]:
        """Draw everything but sign vectors; return the regions seen with their outlines."""
        outlines = self._fill(paint)
        self._arcs()
        self._names(both_ends)
        return [(region, flattened(outline)) for region, outline in outlines]

    def _fill(self, paint: Painter) -> list[tuple[DrawnRegion, Floats]]:
        drawn, sides = self.drawn, region_sides(self.globe)
        found = []
        for piece in range(drawn.sphere.region_count):
            *signs, front = drawn.sphere.region_signs(piece)
            if front > 0:
                region = DrawnRegion(tuple(signs), sides[tuple(signs)])
                outline = self.on_paper(drawn.outline(piece))
                self.scene.curve(outline, fc=paint(region), ec="none", gid=f"region-{piece}")
                found.append((region, outline))
        return found

    def _arcs(self) -> None:
        globe, drawn = self.globe, self.drawn
        is_plane = len(globe.cut.arrangement.distinct[globe.limb]) > 1
        for arc, circle in enumerate(drawn.sphere.incidence.arc_circle.tolist()):
            colour = self.ink(circle) if self.ink is not None else "black"
            style: dict[str, Any] = {"fill": False, "capstyle": "round", "zorder": 3}
            if circle == globe.limb:
                colour = colour if is_plane else "black"
                style |= {"ec": colour, "lw": 1.6 if is_plane else 0.6, "gid": f"limb-{arc}"}
            elif globe.cut.arc_signs(arc)[-1] > 0:
                thick = 1.3 if self.ink is not None else 0.9
                style |= {"ec": colour, "lw": thick, "gid": f"front-{arc}"}
            else:
                continue
            self.scene.curve(self.on_paper(drawn.arc(arc)), **style)

    def _names(self, both_ends: bool) -> None:
        """Write the numbers of the planes outside the rim, pushed apart along it."""
        wanted: list[tuple[float, str, int]] = []
        globe = self.globe
        for circle, members in enumerate(globe.cut.arrangement.distinct):
            text = plane_names(members, len(globe.whole.arrangement))
            if not text:
                continue
            ends = [0.25] if circle == globe.limb else list(self.drawn.ends(circle))
            if circle != globe.limb and not both_ends:
                gap = [min((abs(turn(a - b)) for b, _, _ in wanted), default=4.0) for a in ends]
                ends = ends[:1] if gap[0] >= gap[1] - 1e-9 else ends[1:]
            wanted += [(end, text, circle) for end in ends]
        placed = spread([angle for angle, _, _ in wanted], 9.0 / (self.radius + RIM / 2))
        for (angle, text, circle), at in zip(wanted, placed, strict=True):
            ends_at = np.array([[math.cos(angle), math.sin(angle)], [math.cos(at), math.sin(at)]])
            leader = self.on_paper(ends_at * [[1.0], [1 + 3.2 / self.radius]])
            colour = self.ink(circle) if self.ink is not None else "black"
            self.scene.line(leader, ec=colour, lw=0.4, zorder=2)
            self._name(ends_at[1], text, colour)

    def _name(self, outward: Floats, text: str, colour: str) -> None:
        for size in (7.0, 6.0, 5.0):
            w, h = self.scene.measure(text, size)
            beyond = 3.6 + (abs(outward[0]) * w + abs(outward[1]) * h * 0.75) / 2
            for extra in (0.0, 2.0, 4.0):
                place = np.array(self.centre) + (self.radius + beyond + extra) * outward
                if self.scene.write(place, text, size, color=colour):
                    return


def alone(
    globe: Globe, drawn: Drawn, colour: str | Painter, width: float, below: float = 0.0
) -> Disc:
    """Return a disc as wide as its scene, with room for a legend and more below, all in mm."""
    width = checked_width(width)
    scene = Scene(width, width + below + 5.0 * has_key(colour))
    centre = (scene.width / 2, scene.height - scene.width / 2)
    return Disc(scene, centre, scene.width / 2 - rim_width(scene, globe), globe, drawn)


def rim_width(scene: Scene, globe: Globe) -> float:
    """Return the room that the numbers of the planes need outside the limb, in points."""
    names = map(plane_names, globe.whole.arrangement.distinct)
    return max(RIM, 5.5 + max((scene.measure(name, 7.0)[0] for name in names), default=0.0))


def front(globe: Globe, projection: Projection) -> Drawn:
    """Return the arrangement with the limb as one more circle, in a projection."""
    return Drawn(globe.cut, globe.points, globe.normals, projection)


def region_sides(globe: Globe) -> dict[tuple[int, ...], int]:
    """Return the number of sides of every region of the whole arrangement, by sign vector."""
    degrees = globe.whole.incidence.region_degree.tolist()
    return {globe.whole.region_signs(r): degrees[r] for r in range(globe.whole.region_count)}


def plane_names(members: Sequence[int], count: int | None = None) -> str:
    """Return plane numbers counted from 1, runs of four and more shortened: ``1,2,5-9``."""
    numbers = [k + 1 for k in members if count is None or k < count]
    parts: list[str] = []
    while numbers:
        run = 1
        while run < len(numbers) and numbers[run] == numbers[0] + run:
            run += 1
        if run >= 4:
            parts.append(f"{numbers[0]}\u2013{numbers[run - 1]}")
        else:
            parts += map(str, numbers[:run])
        numbers = numbers[run:]
    return ",".join(parts)


def has_key(colour: str | Painter) -> bool:
    """Return whether a colouring has a legend."""
    return colour in ("sides", "signs")


def key_entries(
    colour: str | Painter, drawn: Sequence[DrawnRegion], paint: Painter
) -> list[tuple[str, dict[str, Any]]]:
    """Return the legend of a colouring for the regions that are drawn, for `Scene.keys`."""
    if colour == "sides":
        numbers = sorted({region.sides for region in drawn} - {0})
        return [(f"{k} sides" if k > 1 else "1 side", {"fc": side_colour(k)}) for k in numbers]
    groups: dict[str, set[int]] = {}
    for region in drawn if colour == "signs" else ():
        groups.setdefault(paint(region), set()).add(region.signs.count(-1))
    entries: list[tuple[str, dict[str, Any]]] = []
    for fill, counts in sorted(groups.items(), key=lambda item: min(item[1])):
        low, high = min(counts), max(counts)
        entries.append((f"{low}" if low == high else f"{low}\u2013{high}", {"fc": fill}))
    if entries:
        entries[-1] = (f"{entries[-1][0]} minus signs", entries[-1][1])
    return entries
