"""Great circles in stereographic projection: every circle is a circle on paper."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import (
    Choice,
    DrawnRegion,
    Painter,
)
from arrangement.drawing.scene.curves import along, flattened, ring
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import SIZES, keep_off, write_if_free
from arrangement.drawing.scene.places import beside, inside
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.solids.sight import unit_vectors
from arrangement.drawing.views import Vector
from arrangement.errors import InputError
from arrangement.pictures.parts.coordinates import in_coordinates, planes_view
from arrangement.pictures.parts.names import (
    Labels,
    RegionLabels,
    explain_regions,
    near_classes,
    note_near,
    plane_names,
)

from .disc import HIDDEN, LINE_WIDTH, alone, front, label_regions, rim_width
from .globe import Globe, far_direction
from .projections import Drawn, stereographic

#: The whole plane is shown of itself when all circles end within this many radii of the limb.
FARTHEST = 3.3


@planes_view("stereographic")
def draw_stereographic(
    arrangement: Arrangement,
    *,
    camera: Vector | None = None,
    colour: Choice | None = None,
    labels: Labels | None = None,
    width: float = 88.0,
    whole: bool | None = None,
    coordinates: str | None = None,
) -> Scene:
    """Draw the great circles of central planes in R^3 in stereographic projection.

    The point of the sphere in the given direction is the middle of the picture, the opposite
    point is at infinity. The limb, the great circle half-way, is dashed and has radius 1. A
    number names a circle: k for the k-th plane, counted from 1.

    There are two pictures. The whole one has both halves of the sphere: every circle is complete,
    and the region with the opposite point is all that is outside. The other one is the front half
    alone, a disc; the back half shows the same with opposite signs.

    Every region and every arc is an element of its own (``region-3``, ``arc-7``; in the disc
    ``front-7``, ``limb-2``).

    Args:
        arrangement: central, of rank at most 3; in another space than R^3 its essentialisation.
        camera: the exact direction of the middle; if omitted, one is chosen.
        colour, labels: as for `draw_sphere`.
        whole: both halves, or the front half; if omitted, both where all circles stay within
            3.3 radii, as for few circles.
        coordinates: as for `draw_sphere`.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring; or
            the whole is asked for and the direction lies on a plane.
    """
    names = RegionLabels(arrangement, labels, items="circles")
    arrangement, camera = in_coordinates(coordinates, arrangement, camera)
    globe = Globe(arrangement, camera)
    if camera is None and whole is not False:
        # The direction that keeps farthest from all planes.
        units = unit_vectors(globe.whole.circle_normals)
        inner = far_direction(globe.whole.arrangement, units) if len(units) else (1, 1, 1)
        central = Globe(arrangement, inner)
        if whole or _farthest(central) <= FARTHEST:
            globe, whole = central, True
    if whole is None:
        whole = 0 < _farthest(globe) <= FARTHEST
    colours = globe.colouring(colour)
    if not whole:
        disc = alone(globe, front(globe, stereographic), names, width)
        disc.draw(colours.paint)
        explain_regions(disc.scene, colours, names, globe.front.values())
        return disc.scene
    if math.isinf(_farthest(globe)):
        k = next(i for i, s in enumerate(arrangement.signs_at(globe.direction)) if s == 0)
        raise InputError(
            f"the camera lies on circle {k + 1}, which would pass through infinity; "
            "choose another camera, or the front half alone (whole=False)"
        )
    scene = Scene(width, width)
    _Whole(globe, scene, colours.paint, names).draw()
    explain_regions(scene, colours, names, globe.regions)
    return scene


class _Whole:
    """The picture of both halves: a frame, the outer region, and all others on top of it."""

    def __init__(self, globe: Globe, scene: Scene, paint: Painter, names: RegionLabels) -> None:
        self.scene, self.globe, self.paint, self.names = scene, globe, paint, names
        self.centre = np.array([scene.width / 2, scene.height - scene.width / 2])
        self.half = scene.width / 2 - 1.5
        self.normals = unit_vectors(globe.whole.circle_normals).reshape(-1, 3) @ globe.axes.T
        low, high = self._extent()
        self.middle = (low + high) / 2
        self.scale = (self.half - rim_width(scene, globe)) / max(float((high - low).max()) / 2, 1.0)
        rays = [globe.whole.ray(v) for v in range(globe.whole.vertex_count)]
        points = unit_vectors(rays) @ globe.axes.T if rays else np.empty((0, 3))
        self.drawn = Drawn(globe.whole, points, self.normals, stereographic)

    def _extent(self) -> tuple[Floats, Floats]:
        """Return the lower left and upper right corners of all circles and the limb."""
        a, b, c = self.normals.T
        centres = np.stack([a / c, b / c], axis=1)
        radii = 1 / np.abs(c)[:, None]
        low = np.vstack([centres - radii, [[-1.0, -1.0]]]).min(axis=0)
        return low, np.vstack([centres + radii, [[1.0, 1.0]]]).max(axis=0)

    def on_paper(self, points: Floats) -> Floats:
        return self.centre + self.scale * (points - self.middle)

    def draw(self) -> None:
        outlines = self._fill()
        lines = []
        firsts = self.globe.whole.arrangement.firsts
        circles = self.globe.whole.incidence.arc_circle
        for arc in range(self.globe.whole.arc_count):
            curve = self.on_paper(self.drawn.arc(arc))
            name = f"arc-{firsts[circles[arc]] + 1}-{arc + 1}"
            self.scene.curve(curve, fill=False, ec="black", lw=0.9, zorder=3, gid=name)
            lines.append(along(curve))
        limb = self.on_paper(np.zeros((1, 2)))[0]
        self.scene.circle(limb, self.scale, fill=False, ec="black", gid="limb", **HIDDEN)
        corners = self._corners()
        self.scene.polygon(corners, fill=False, ec="black", lw=0.4, ls=(0, (1, 2)), role="border")
        self._names(lines)
        dashes = ring(limb, self.scale)
        a, b, c = self.normals.T
        centres = self.on_paper(np.stack([a / c, b / c], axis=1))
        discs = map(ring, centres, self.scale / np.abs(c))
        free = inside(self.scene, corners, keep_off([], discs))
        write_if_free(self.scene, self.outer, SIZES, free)
        within = (*(corners[0] + 2), *(corners[2] - 2))
        label_regions(self.scene, self.names, outlines, [*lines, dashes], [dashes], within, True)

    def _fill(self) -> list[tuple[DrawnRegion, Floats]]:
        """Fill the outer region first, then all others; return all but it with outlines."""
        globe = self.globe
        found: list[tuple[DrawnRegion, Floats]] = []
        outside = globe.whole.arrangement.signs_at([-x for x in globe.direction])
        numbers = sorted(enumerate(globe.regions), key=lambda item: item[1].signs != outside)
        for r, region in numbers:
            name = self.names.element("region", region.signs)
            style: dict[str, Any] = {"fc": self.paint(region), "ec": "none", "gid": name}
            if region.signs == outside:
                self.scene.polygon(self._corners(), **style)
                self.outer = self.names.forms(region.signs)[:1]
            else:
                outline = self.on_paper(self.drawn.outline(r))
                self.scene.curve(outline, **style)
                found.append((region, flattened(outline)))
        return found

    def _corners(self) -> Floats:
        signs = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        return self.centre + self.half * signs

    def _names(self, lines: Sequence[Floats]) -> None:
        """Write each circle's number outside its farthest point, or else close to its line."""
        classes, off = self.globe.whole.arrangement.distinct, keep_off(lines)
        a, b, c = self.normals.T
        discs = self.scale * np.stack([a / c, b / c, 1 / np.abs(c)], axis=1)

        def apart(one: int, other: int) -> float:
            x, y, larger = discs[one] - discs[other]
            return math.hypot(x, y) + abs(float(larger))

        groups = near_classes(len(classes), apart, LINE_WIDTH)
        texts = {g[0]: plane_names(sorted(i for k in g for i in classes[k])) for g in groups}
        joint = [texts[group[0]] for group in groups if len(group) > 1]
        note_near(self.scene.legend, self.names.items, joint)
        for k, text in sorted(texts.items(), key=lambda item: abs(self.normals[item[0], 2])):
            for step in range(84):
                if self._name(k, text, step, off):
                    break

    def _name(self, k: int, text: str, step: int, off: Any) -> bool:
        """Try a place, farther and farther from the farthest point of a circle."""
        a, b, c = self.normals[k].tolist()
        centre, radius = np.array([a / c, b / c]), 1 / abs(c)
        angle = math.atan2(b * c, a * c) + (step + 1) // 2 * 0.075 * (1 if step % 2 else -1)
        outward = np.array([math.cos(angle), math.sin(angle)])
        rim = self.on_paper((centre + radius * outward)[None])[0]
        within = (*(self._corners()[0] + 4), *(self._corners()[2] - 4))
        places = beside(rim, away=outward, distance=1.2, within=within, turns=2)
        look: dict[str, Any] = {"off": off, "style": "italic"}
        return write_if_free(self.scene, [text], SIZES[:2], places, **look)


def _farthest(globe: Globe) -> float:
    """Return how far the circles reach from the middle of the picture, in radii of the limb."""
    if not globe.whole.circle_count:
        return 1.0
    if 0 in globe.whole.arrangement.signs_at(globe.direction):
        return math.inf
    heights = np.abs(unit_vectors(globe.whole.circle_normals) @ globe.axes[2])
    return float(((1 + np.sqrt(np.maximum(0, 1 - heights**2))) / heights).max())
