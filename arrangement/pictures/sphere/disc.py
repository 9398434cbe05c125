"""The front half of the sphere as a disc: regions, arcs, names at the rim, labels."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from arrangement.drawing.colours import DrawnRegion, Painter, letter_colour
from arrangement.drawing.scene.curves import along, flattened
from arrangement.drawing.scene.items import Box, Floats
from arrangement.drawing.scene.labels import SIZES, keep_off, write_if_free
from arrangement.drawing.scene.leaders import Leaders
from arrangement.drawing.scene.places import inside, spread, turn
from arrangement.drawing.scene.scene import Scene
from arrangement.numbers.exact import dot
from arrangement.pictures.parts.names import (
    RegionLabels,
    near_classes,
    note_near,
    plane_names,
    thinner,
)

from .globe import Globe
from .projections import CutChart, Drawn, Projection

#: Room for the numbers of the planes between the rim and the boundary, at least; in points.
RIM = 13.0
#: What is hidden: thinner, lighter, dashed. One rule for spheres and polyhedra.
HIDDEN: dict[str, Any] = {"lw": 0.5, "ls": (0, (3, 3)), "alpha": 0.5, "zorder": 2, "role": "hidden"}
#: More regions than this get no leader lines.
_MOST_LEADERS = 150
#: Of most lines, in points; what is narrower is covered by them.
LINE_WIDTH = 0.9


@dataclass(frozen=True)
class Disc:
    """A place on a scene for the front half of a globe.

    Attributes:
        scene: the scene.
        centre, radius: of the limb, in points.
        globe: what is seen.
        drawn: its arcs and regions, cut at the limb, as curves.
        names: of the regions.
        ink: the colour of each class of planes; if omitted, black.
        solid: whether it is a ball, shaded, with the arcs on its far side dashed.
    """

    scene: Scene
    centre: tuple[float, float]
    radius: float
    globe: Globe
    drawn: Drawn
    names: RegionLabels
    ink: Callable[[int], str] | None = None
    solid: bool = False

    def on_paper(self, points: Floats) -> Floats:
        """Return points of the disc in points of the scene."""
        return np.array(self.centre) + self.radius * points

    def draw(
        self,
        paint: Painter,
        *,
        both_ends: bool = False,
        avoid: Sequence[Floats] = (),
        within: Box | None = None,
    ) -> list[Floats]:
        """Draw everything, labels of regions off the lines `avoid`; return all lines, (k, 2)."""
        outlines, arcs, hidden = self.curves(paint, both_ends=both_ends)
        inner = [*hidden, *avoid]
        wide, high = self.scene.width, self.scene.height
        box = within or (0.0, high - wide, wide, high)
        lines = [*arcs, *inner]
        label_regions(self.scene, self.names, outlines, lines, inner, box)
        return lines

    def curves(
        self, paint: Painter, *, both_ends: bool = False
    ) -> tuple[list[tuple[DrawnRegion, Floats]], list[Floats], list[Floats]]:
        """Draw everything but labels of regions; return outlines, near arcs and far arcs."""
        outlines = []
        for piece, region in self.globe.front.items():
            outline = self.on_paper(self.drawn.outline(piece))
            if not len(outline):
                continue
            self.scene.curve(
                outline, fc=paint(region), ec="none", gid=self.names.element("region", region.signs)
            )
            outlines.append((region, flattened(outline)))
        if self.solid:
            self.scene.ball(self.centre, self.radius, "#ffffff55", "#0000003c", zorder=1.5)
        hidden = self._hidden()
        self._names(both_ends)
        return outlines, self._arcs(), hidden

    def _hidden(self) -> list[Floats]:
        """Draw the half of each circle on the far side, dashed; return points along them."""
        globe, found = self.globe, []
        for circle, normal in enumerate(globe.normals if self.solid else ()):
            if circle != globe.limb:
                start = np.array([normal[1], -normal[0], 0.0]) / math.hypot(normal[0], normal[1])
                curve = self.on_paper(self.drawn.projection(normal, start, math.pi))
                ink = self.ink(circle) if self.ink is not None else "black"
                style = {**HIDDEN, "lw": HIDDEN["lw"] * thinner(globe.whole.circle_count)}
                name = f"back-{globe.whole.arrangement.firsts[circle] + 1}"
                self.scene.curve(curve, fill=False, ec=ink, gid=name, **style)
                found.append(along(curve))
        return found

    def _arcs(self) -> list[Floats]:
        """Draw the arcs on the near side and the limb; return points along them."""
        globe, drawn, found = self.globe, self.drawn, []
        is_plane = len(globe.cut.arrangement.distinct[globe.limb]) > 1
        for arc, circle in enumerate(drawn.sphere.incidence.arc_circle.tolist()):
            colour = self.ink(circle) if self.ink is not None else "black"
            number = f"{globe.cut.arrangement.firsts[circle] + 1}-{arc + 1}"
            style: dict[str, Any] = {"fill": False, "capstyle": "round", "zorder": 3}
            if circle == globe.limb:
                colour = colour if is_plane else "black"
                name = f"limb-{number}" if is_plane else f"limb-{arc + 1}"
                style |= {"ec": colour, "lw": 1.6 if is_plane else 0.6, "gid": name}
            elif dot(globe.cut.arc_witness(arc), globe.direction) > 0:
                thick = 1.3 if self.ink is not None else 0.9
                thick *= thinner(globe.whole.circle_count)
                style |= {"ec": colour, "lw": thick, "gid": f"front-{number}"}
            else:
                continue
            curve = self.on_paper(drawn.arc(arc))
            if not len(curve):
                continue
            self.scene.curve(curve, **style)
            found.append(along(curve))
        return found

    def _names(self, both_ends: bool) -> None:
        """Write the numbers of the planes outside the rim, pushed apart along it."""
        wanted: list[tuple[float, float, str, int]] = []
        globe, distinct = self.globe, self.globe.cut.arrangement.distinct
        # Angles between planes; on paper circles are at most so many radii apart.
        units = globe.normals / np.linalg.norm(globe.normals, axis=1)[:, None]
        signs = np.sign(units @ units.T)

        def apart(one: int, other: int) -> float:
            if globe.limb in (one, other):
                return math.inf
            away = units[one] - signs[one, other] * units[other]
            return self.radius * float(np.linalg.norm(away))

        groups = near_classes(len(distinct), apart, LINE_WIDTH)
        joint = []
        for group in groups:
            circle = group[0]
            members = sorted(k for c in group for k in distinct[c])
            text = plane_names(members, len(globe.whole.arrangement))
            if not text:
                continue
            joint += [text] * (len(group) > 1)
            at_rim = circle == globe.limb and not isinstance(self.drawn, CutChart)
            ends = [0.25] if at_rim else list(self.drawn.ends(circle))
            if not ends:
                continue
            if circle != globe.limb and not both_ends:
                gap = [min((abs(turn(a - b)) for b, *_ in wanted), default=4.0) for a in ends]
                ends = ends[:1] if gap[0] >= gap[1] - 1e-9 else ends[1:]
            # Angles of one point of the rim differ by rounding, also by a whole turn.
            near = [(end + 1e-9) % (2 * math.pi) - 1e-9 for end in ends]
            wanted += [(round(a, 8), self._lean(circle, a), text, circle) for a in near]
        note_near(self.scene.legend, self.names.items, joint)
        self.names.joined = bool(joint)
        wanted.sort()
        placed = spread([angle for angle, *_ in wanted], 9.0 / (self.radius + RIM / 2))
        for (angle, _, text, circle), at in zip(wanted, placed, strict=True):
            ends_at = np.array([[math.cos(angle), math.sin(angle)], [math.cos(at), math.sin(at)]])
            leader = self.on_paper(ends_at * [[1.0], [1 + 2.6 / self.radius]])
            colour = self.ink(circle) if self.ink is not None else "black"
            self.scene.line(leader, ec=colour, lw=0.4, zorder=2)
            self._name(ends_at[1], text, letter_colour(circle) if self.ink else "black")

    def _lean(self, circle: int, angle: float) -> float:
        """Return how far a circle leans counter-clockwise from a point of the rim inwards."""
        x, y, z = self.globe.normals[circle].tolist()
        across = y * math.cos(angle) - x * math.sin(angle)
        return -z / across if circle != self.globe.limb else 0.0

    def _name(self, outward: Floats, text: str, colour: str) -> None:
        def places(half: Floats) -> Floats:
            out = self.radius + 3.4 + float(np.abs(outward) @ half) + np.array([[0], [2], [4]])
            centres: Floats = np.array(self.centre) + out * outward
            return centres

        write_if_free(self.scene, [text], SIZES, places, color=colour, style="italic")


def label_regions(
    scene: Scene,
    names: RegionLabels,
    outlines: Sequence[tuple[DrawnRegion, Floats]],
    lines: Sequence[Floats],
    inner: Sequence[Floats],
    within: Box,
    flat: bool = False,
) -> None:
    """Write the names of regions, first inside, then those that do not fit on leader lines.

    Args:
        scene: where to.
        names: counts those that are left out.
        outlines: of the regions.
        lines: all lines drawn, each (k, 2); no label covers one.
        inner: those among them that are not boundaries of regions.
        within: a part of the scene that leader lines must not leave.
        flat: whether no region is seen from the side.
    """
    names.unseen += sum(_is_unseen(outline, flat or names.joined) for _, outline in outlines)
    off = keep_off(inner)
    small = [
        (region, outline)
        for region, outline in outlines
        if names.forms(region.signs)
        and not write_if_free(scene, names.forms(region.signs), SIZES, inside(scene, outline, off))
    ]
    leaders = Leaders(scene, lines, within, [outline for _, outline in outlines])
    for region, outline in small:
        texts = names.forms(region.signs)[:1]
        names.left_out += len(outlines) > _MOST_LEADERS or not leaders.write(
            outline, texts, SIZES[1:]
        )


def _is_unseen(outline: Floats, narrow: bool) -> bool:
    """Return whether lines cover a region: it is as small as their width, or as narrow.

    Args:
        narrow: whether it is unseen where it is narrow; at the rim of a ball it is only seen
            from the side.
    """
    if not narrow:
        return bool((np.ptp(outline, axis=0) < LINE_WIDTH).all())
    along, nexts = np.asarray(outline), np.roll(outline, -1, axis=0)
    area = abs(float(np.sum(along[:, 0] * nexts[:, 1] - along[:, 1] * nexts[:, 0]))) / 2
    length = float(np.hypot(*(nexts - along).T).sum())
    return 2 * area < LINE_WIDTH * length


def alone(
    globe: Globe, drawn: Drawn, names: RegionLabels, width: float, *, solid: bool = False
) -> Disc:
    """Return a disc that fills its scene; `width` in millimetres."""
    scene = Scene(width, width)
    centre = (scene.width / 2, scene.width / 2)
    radius = scene.width / 2 - rim_width(scene, globe, names)
    return Disc(scene, centre, radius, globe, drawn, names, solid=solid)


def rim_width(scene: Scene, globe: Globe, names: RegionLabels | None = None) -> float:
    """Return the room that numbers of planes and short labels need outside the limb, in points."""
    arrangement = globe.whole.arrangement
    widths = [5.5 + scene.measure(plane_names(x), 7.0)[0] for x in arrangement.distinct]
    # Up to three signs fit into most regions.
    beside_ball = names and names.kind == "signs" and len(arrangement) > 3
    forms = names.forms((1,) * len(arrangement)) if names and beside_ball else []
    beside = min(24.0, 3.5 + max((scene.measure(text, SIZES[1])[0] for text in forms), default=0.0))
    return max([RIM, beside, *widths])


def front(globe: Globe, projection: Projection) -> Drawn:
    """Return the arrangement with the limb as one more circle, in a projection."""
    return Drawn(globe.cut, globe.points, globe.normals, projection)
