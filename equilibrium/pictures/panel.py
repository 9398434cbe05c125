"""Squares of a plane of wrenches: the window that is shown, axes, a region and its boundary."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from statistics import median
from typing import Any

import numpy as np

from arrangement.drawing.colours import BLACK, GREY
from arrangement.drawing.labels import Labels, covering, inside, keep_off, near, write_if_free
from arrangement.drawing.scene import (
    FONT,
    POINTS,
    Box,
    Floats,
    Legend,
    PageMap,
    Place,
    Scene,
    area,
    measure,
)
from arrangement.drawing.views import Exact
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive, rational, shown
from arrangement.numbers.linear.intervals import where_positive
from arrangement.numbers.linear.polyhedron import Polyhedron, from_conditions
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.labels import AS_ROUNDED
from equilibrium.plane.states.contact_states import States
from equilibrium.wrench_sets import Region, Segment, polygon_cycle

from .body import Frame, middle_of
from .style import FILLS, MARKS, SHADE, SYMBOLS, Wrench, explain, nearest_float, ticks

ZERO: RationalVector = (Fraction(0), Fraction(0))
#: How far the window reaches beyond what it holds, as a share of its spread.
ROOM = Fraction(1, 5)


class Window(Frame):
    """A square of the plane of wrenches; paper coordinates run from -1 to 1 in it."""

    @cached_property
    def rows(self) -> list[IntegerVector]:
        """The conditions ``a . x + b >= 0`` of the square."""
        sides = [(Fraction(s * a), Fraction(s * (1 - a))) for a in (1, 0) for s in (1, -1)]
        return [primitive((*side, self.half - dot(side, self.centre))) for side in sides]

    def inside(self, polyhedron: Polyhedron) -> Floats | None:
        """Return the corners of the part of a polygon inside, counter-clockwise, on paper."""
        cut: Polyhedron | None = polyhedron
        far = (abs(x - c) for p in polyhedron.points for x, c in zip(p, self.centre, strict=True))
        if not (polyhedron.bounded and max(far) <= self.half):
            rows = [*polyhedron.inequalities, *self.rows]
            cut = from_conditions(rows, polyhedron.equalities, 2)
        return None if cut is None else np.array([self.paper(p) for p in polygon_cycle(cut)])

    def stretch(self, segment: Segment) -> Floats | None:
        """Return the ends of the part of a segment inside, on paper."""
        u, square = segment.direction, dot(segment.normal, segment.normal)
        foot = [Fraction(-segment.constant * x, square) for x in segment.normal]
        rows: list[Any] = [(dot(row[:2], u), dot(row, (*foot, 1))) for row in self.rows]
        for end, sign in ((segment.start, 1), (segment.end, -1)):
            if end is not None:
                rows.append((sign * square, -sign * dot(u, end)))
        span = where_positive(rows)
        if span is None or span[0] == span[1]:
            return None
        ends: Any = span  # of the square
        return np.array([self.paper(x + t * y for x, y in zip(foot, u, strict=True)) for t in ends])


def joint_window(
    regions: Sequence[Region],
    extra: Iterable[RationalVector] = (),
    half: Fraction | None = None,
    *,
    pieces: bool = False,
) -> Window:
    """Return one square window for several regions.

    It holds the origin and all ends of the regions' boundaries, and it shows a part of every ray.
    Rays and lines through the origin alone have it in the middle.

    Args:
        extra: more points to hold.
        half: this half side instead, about the origin.
        pieces: hold the corners of single pieces too, unless they lie far outside the others.
    """
    if half is not None:
        return Window(ZERO, half)
    needed = [ZERO, *extra, *(end for region in regions for end in ends(region))]
    shapes = [piece.polyhedron for region in regions for piece in region.polygons]
    inner = [p for shape in shapes for p in shape.points]
    reach = 3 * max(_size(p) for p in needed)
    if pieces:
        reach = max(reach, 3 * median([*map(_size, inner), Fraction(0)]))
        needed += [p for p in inner if _size(p) <= reach]
    _, finite = middle_of(needed)
    spread = finite or Fraction(1)
    if not finite and all(shape.dimension < 2 for shape in shapes):
        return Window(ZERO, spread)
    for shape in shapes:
        rays = [*shape.rays, *shape.lines, *((-x, -y) for x, y in shape.lines)]
        share = Fraction(1, 5) if finite and shape.dimension == 2 else Fraction(4, 5)
        for ray in rays:
            step = spread * share / max(map(abs, ray))
            held = (p for p in shape.points if _size(p) <= reach)
            needed += [(p[0] + step * ray[0], p[1] + step * ray[1]) for p in held]
    centre, half = middle_of(needed)
    return Window(centre, half * (1 + ROOM) or Fraction(1))


def ends(region: Region) -> Iterator[RationalVector]:
    """Yield the ends of boundary and dangling edges, and the isolated points."""
    for segment in (*region.outline.border, *region.outline.whiskers):
        yield from (end for end in (segment.start, segment.end) if end is not None)
    yield from region.outline.points


def _size(point: RationalVector) -> Fraction:
    return max(map(abs, point))


def clipped(polygon: Floats, normal: Floats, least: float) -> Floats:
    """Return the part of a convex polygon, of any dimension, where ``normal . x >= least``."""
    corners, values = [], polygon @ normal - least
    for k, here in enumerate(values):
        if here * values[k - 1] < 0:
            share = values[k - 1] / (values[k - 1] - here)
            corners.append(polygon[k - 1] + share * (polygon[k] - polygon[k - 1]))
        if here >= 0:
            corners.append(polygon[k])
    return np.array(corners).reshape(-1, polygon.shape[1])


#: Space in points beside and below a panel, for numbers and names of the axes.
LEFT, BELOW, ABOVE = 12.0 * POINTS, 9.0 * POINTS, 5.0 * POINTS
HATCH = "//////"
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_FADE = 0.16
#: The corners of a panel in the window.
SQUARE = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])


@dataclass
class Panel:
    """A square of a scene that shows a window.

    Args:
        corner: left and lower end in points.
        side: its length in points.
        name: a prefix for the names of its elements.
    """

    scene: Scene
    window: Window
    corner: tuple[float, float]
    side: float
    name: str = ""

    def at(self, places: Any) -> Floats:
        """Return points of the scene for places in the window, from -1 to 1."""
        points: Floats = np.array(self.corner) + (np.asarray(places) + 1) * (self.side / 2)
        return points

    @property
    def page_map(self) -> PageMap:
        """Where points of the plane that the window shows are on the scene."""
        return self.window.page_map(self.side / 2, np.array(self.corner) + self.side / 2)

    @property
    def box(self) -> Box:
        """The square, in points of the scene."""
        x, y = self.corner
        return x, y, x + self.side, y + self.side

    @property
    def zero(self) -> Floats:
        """The place of the origin."""
        return self.window.paper(ZERO)

    def gid(self, kind: str, index: int) -> str:
        """Return the name of an element."""
        return f"{self.name}{kind}-{index + 1}"

    def axes(self) -> list[Floats]:
        """Return the lines through the origin, as far as they are in the window."""
        return [
            self.at(np.array([[at, -1.0], [at, 1.0]])[:, :: -1 if k else 1])
            for k, at in enumerate(self.zero)
            if abs(at) < 1
        ]

    def rulers(
        self, names: Sequence[str], units: Sequence[str], *, left: bool = True, below: bool = True
    ) -> None:
        """Draw lines through the origin, and numbers and names at the left and lower edges.

        A power of ten goes to the names where the numbers would be long.
        """
        for axis in self.axes():
            self.scene.line(axis, ec=GREY, lw=0.4, zorder=1.5, role="axis")
        half = nearest_float(self.window.half)
        power = math.floor(math.log10(half)) if 0 < half < math.inf else 0
        power = 0 if -3 < power < 4 else power
        drawn = [k for k, wanted in enumerate((below, left)) if wanted]
        for k in drawn:
            self._numbers(k, Fraction(10) ** power)
        for k in drawn:
            factor = f"10{str(power).translate(_RAISED)}" if power else ""
            note = " ".join(filter(None, (factor, units[k])))
            place = self.at((-k, k - 1)) - ((26, 0) if k else (0, 19))
            self.scene.text(place, f"{names[k]} ({note})" if note else names[k], rotation=90 * k)

    def _numbers(self, k: int, factor: Fraction) -> None:
        out = np.array([(0, -1), (-1, 0)][k])
        for at, text in ticks(self.window.centre[k], self.window.half, factor):
            tick = self.at((at, -1.0) if k == 0 else (-1.0, at))
            beyond = (abs(at) - 1) * self.side / 2 + measure(text)[0] / 2
            if k == 0 and beyond > 5:
                continue
            self.scene.line([tick, tick + 2 * out], ec=GREY, lw=0.4)
            self.scene.text(tick + (4 if k else 8) * out, text, ha="right" if k else "center")

    def title(self, text: str, above: float = 5.0) -> None:
        """Write a title above, from the left edge; its middle is this many points above the top."""
        place = self.at((-1, 1)) + np.array((0, above))
        self.scene.text(place, text, ha="left", va="center_baseline")

    def region(
        self, region: Region, by_states: bool = True, clip: Box | tuple[Place, float] | None = None
    ) -> list[States]:
        """Fill the polygons, small ones on top, and draw the outline of their union.

        Lines of resisted forces that no polygon holds are drawn wide. Returned are the states of
        all that has a fill.
        """
        parts = []
        for i, piece in enumerate(region.polygons):
            shape = self.window.inside(piece.polyhedron)
            if shape is not None:
                parts.append((area(shape), i, shape, piece.states))
        parts.sort(key=lambda part: (-part[0], part[1]))
        stretches = map(self.window.stretch, region.outline.whiskers)
        dangling = np.array([line for line in stretches if line is not None]).reshape(-1, 2, 2)
        alone = set()
        for _, i, shape, _ in parts:
            middle = np.tile(shape.mean(axis=0), (1, 2))
            if len(shape) == 2 and covering(keep_off(dangling), middle, 1e-9).any():
                alone.add(i)
        with self.scene.clip(clip or self.box):
            for _, i, shape, states in parts:
                self._piece(i, self.at(shape), states, by_states, i in alone)
            self._outline(region)
        filled = [(i, shape, states) for size, i, shape, states in parts if size or i in alone]
        if by_states:
            self._codes([(shape, states) for i, shape, states in filled if i not in alone])
            labels = Labels(self.scene)
            labels.avoid(*self.axes(), *self.at(dangling))
            for i, shape, states in filled:
                if i in alone:
                    middle, along = self.at(shape.mean(axis=0)), shape[1] - shape[0]
                    side = np.array([-along[1], along[0]]) * (1 if along[0] > 0 else -1)
                    look = {"zorder": 1.6, "gid": self.gid("code", i)}
                    labels.write(code(states), near(middle, side), **look)
        return [states for _, _, states in filled]

    def _piece(
        self, index: int, shape: Floats, states: States, by_states: bool, alone: bool
    ) -> None:
        gid, fill = self.gid("polygon", index), fill_of(states) if by_states else SHADE
        thin = GREY if by_states else SHADE
        if len(shape) == 1:
            self.scene.mark(shape[0], "o", 2, color=thin, gid=gid, zorder=1.2)
        elif len(shape) == 2:
            wide = {"ec": fill, "lw": 5.0} if alone else {"ec": thin, "lw": 0.6}
            self.scene.line(shape, gid=gid, zorder=1.2, capstyle="butt", **wide)
        else:
            line = {"ec": "#404040", "lw": 0.4} if by_states else {"ec": fill, "lw": 0.5}
            style = {"zorder": 1, "joinstyle": "bevel"}
            self.scene.polygon(shape, fc=fill, gid=gid, **line, **style)
            if by_states and "detached" in states:
                self.scene.polygon(shape, fc="none", ec="#7d7d7d", lw=0, hatch=HATCH, **style)

    def _codes(self, parts: Sequence[tuple[Floats, States]]) -> None:
        """Write the states into the polygons where they fit and nothing later covers them."""
        within = (*self.at((_FADE - 1, _FADE - 1)), *self.at((1 - _FADE, 1 - _FADE)))
        shapes = [self.at(shape) for shape, _ in parts]
        low = np.array([shape.min(axis=0) for shape in shapes])
        high = np.array([shape.max(axis=0) for shape in shapes])
        for i, (_, states) in enumerate(parts):
            room = np.minimum(high[i], within[2:]) - np.maximum(low[i], within[:2])
            if (room < measure(code(states), FONT)).any():
                continue
            # What is farther away than a point covers no part of it.
            near = (low[i + 1 :] < high[i] + 1) & (high[i + 1 :] > low[i] - 1)
            later = [shapes[i + 1 + k] for k in np.flatnonzero(near.all(axis=1))]
            plate = {"boxstyle": "square,pad=0.12", "fc": fill_of(states), "ec": "none"}
            style = {"zorder": 1.6, "plate": plate, "va": "center_baseline"}
            for lines in (self.axes(), []):
                free = inside(self.scene, shapes[i], keep_off(lines, later), within)
                look = {**style, "gid": self.gid("code", i)}
                if write_if_free(self.scene, [code(states)], [FONT], free, **look):
                    break

    def _outline(self, region: Region) -> None:
        outline = region.outline
        for kind, segments in (("border", outline.border), ("whisker", outline.whiskers)):
            for i, segment in enumerate(segments):
                line = self.window.stretch(segment)
                if line is not None:
                    look: dict[str, Any] = {"ec": BLACK, "lw": 1.3, "capstyle": "round"}
                    look |= {"gid": self.gid(kind, i), "role": "border"}
                    self.scene.line(self.at(line), zorder=2, **look)
        for i, point in enumerate(outline.points):
            place = self.at(self.window.paper(point))
            self.scene.mark(place, "o", 3.5, color=BLACK, gid=self.gid("point", i), zorder=3)

    def fade(self) -> None:
        """Fade what reaches the edge: it is unbounded."""
        rings, closed = 12, np.vstack([SQUARE, SQUARE[:1]])
        with self.scene.clip(self.box):
            for k in range(rings):
                inner = 1 - _FADE * (rings - k) / rings
                ring = np.concatenate([1.01 * closed, inner * closed[::-1]])
                self.scene.polygon(self.at(ring), fc="white", ec="none", alpha=0.16, zorder=4)

    def wrench(self, point: RationalVector, resisted: bool) -> None:
        """Mark a wrench: a full disc when it is resisted, a cross when not."""
        sign, size, style = MARKS["resisted" if resisted else "refused"]
        edge = {"mec": "white", "mew": 0.7} if resisted else {}
        place = self.at(self.window.paper(point))
        self.scene.mark(place, sign, size, zorder=6, gid=f"{self.name}wrench", **style, **edge)


def fill_of(states: States) -> str:
    """Return the colour of a choice of states, by the number of sticking contacts."""
    return FILLS[min(states.count("stick"), len(FILLS) - 1)]


def code(states: States) -> str:
    """Return the states of all contacts as one character each."""
    return "\u200a".join(SYMBOLS[state] for state in states)


#: Space in points between panels, and right of the last.
GAP, RIGHT = 4.0 * POINTS, 3.0 * POINTS
FORCE_NAMES = ("$f_x$", "$f_y$")


class PlaneQuestion:
    """What a picture of a plane of forces is asked.

    Attributes:
        wrench: to be marked, if there is one; `marked` is its force, alone in a list.
        torque: of the plane.
        half: half the side, if it is given.

    Raises:
        GraspError: no wrench, or an extent that is not above 0.
    """

    def __init__(self, wrench: Wrench | None, extent: Exact | None) -> None:
        self.wrench = None if wrench is None else read_wrench(wrench)
        self.half = read_extent(extent)
        self.torque = self.wrench[2] if self.wrench else Fraction(0)
        self.marked = [self.wrench[:2]] if self.wrench else []


def row_of_panels(
    number: int,
    window: Window,
    width: float,
    grasp: Grasp,
    columns: int | None = None,
    names: Sequence[str] = FORCE_NAMES,
) -> tuple[Scene, list[Panel]]:
    """Return a scene with empty panels of planes of wrenches; only outer ones have rulers."""
    stated = grasp.units
    units = [(stated.force if "f" in name else stated.torque) if stated else "" for name in names]
    columns = min(number, columns or number)
    rows = -(-number // columns)
    side = (width * POINTS - LEFT - RIGHT - (columns - 1) * GAP) / columns
    height = rows * (side + ABOVE) + (rows - 1) * GAP / 2 + BELOW
    scene = Scene(width, height / POINTS)
    explain_error(scene.legend, grasp)
    panels = []
    for i in range(number):
        row, column = divmod(i, columns)
        x = LEFT + column * (side + GAP)
        y = height - (row + 1) * (side + ABOVE) - row * GAP / 2
        panel = Panel(scene, window, (x, y), side, "" if number == 1 else f"{i + 1}-")
        scene.maps.append(panel.page_map)
        panel.rulers(names, units, left=column == 0, below=i + columns >= number)
        panels.append(panel)
    return scene, panels


def explain_error(legend: Legend, grasp: Grasp) -> None:
    """Note that a picture shows one rounding of converted data."""
    if grasp.data_error is not None:
        legend.line(AS_ROUNDED)


def explain_borders(legend: Legend, regions: Sequence[Region], fades: bool) -> None:
    """Explain lines, points and faded edges of regions."""
    outlines = [region.outline for region in regions]
    shapes = [piece.polyhedron for region in regions for piece in region.polygons]
    keys = {
        ("border", "boundary"): any(outline.border or outline.whiskers for outline in outlines),
        ("accepted", "resisted: this point alone"): any(outline.points for outline in outlines),
        ("fade", "unbounded"): fades and not all(shape.bounded for shape in shapes),
    }
    explain(legend, keys)


def read_extent(extent: Exact | None) -> Fraction | None:
    """Return half the side of a picture, if it is given.

    Raises:
        GraspError: it is not above 0.
    """
    half = None if extent is None else rational(extent, "extent")
    if half is not None and half <= 0:
        raise GraspError(f"extent is {shown(half)}; it must be above 0")
    return half
