"""A scene: the items of a picture, what they measure, its legend; arrows and arcs on it.

A view adds items to a `Scene`; a writer (`figure`, `tikz`) reads them and knows no view. The legend
is data until `layout` places it. Styles are those of `items`; besides, of all items: ``gid`` the
name, ``role``, ``zorder`` (see `Item.order`).
"""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from arrangement.console.progress import note
from arrangement.drawing.output import millimetres, require_matplotlib
from arrangement.errors import InputError

from .items import (
    Ball,
    Box,
    Floats,
    Item,
    Label,
    Mark,
    PageMap,
    Path,
    Place,
    moved,
    role_of,
    scaled,
)

#: Millimetres to points.
POINTS = 72 / 25.4
#: Resolution at which text is measured; pictures are saved with the same.
DPI = 300
#: Size of letters, in points.
FONT = 7.0
#: Least distance between two labels, and of a label from the boundary; in points.
GAP = 0.8

#: Characters as wide as others; those after which the next one stands at the same distance always.
_ALIKE = str.maketrans("123456789\u2007\u2212\u25cb", "0" * 10 + "+\u25cf")
_ALONE = frozenset("0+\u25cf\u200a")


def measure(
    text: str, size: float = FONT, rotation: float = 0.0, weight: str = "normal"
) -> tuple[float, float]:
    """Return the width and height of a text in the fonts that are set now, in points."""
    settings = require_matplotlib().rcParams
    text = text.translate(_ALIKE)
    if _ALONE.issuperset(text):
        text = "".join(sorted(text))
    fonts = (*settings["font.family"], *settings["font.sans-serif"])
    return _measured(text, size, rotation, weight, fonts)


@lru_cache(maxsize=8192)
def _measured(
    text: str, size: float, rotation: float, weight: str, _fonts: tuple[str, ...]
) -> tuple[float, float]:
    from matplotlib.text import Text

    renderer, figure = _measuring()
    label = Text(0, 0, text, size=size, rotation=rotation, weight=weight, linespacing=1.0)
    label.set_figure(figure)
    extent = label.get_window_extent(renderer)
    return extent.width * 72 / DPI, extent.height * 72 / DPI


@lru_cache(maxsize=1)
def _measuring() -> Any:
    from matplotlib.backends import backend_agg
    from matplotlib.figure import Figure

    renderer: Any = backend_agg.RendererAgg
    return renderer(10, 10, DPI), Figure(dpi=DPI)


def wrapped(text: str, room: float, size: float = FONT, weight: str = "normal") -> list[str]:
    """Return a text in lines that fit a width in points, as far as its words do."""
    lines, width = [text], len(text)
    # No letter is half as narrow as this one: where even that is too long nothing is measured.
    most = int(room / (measure("i" * 20, size)[0] / 40))
    if width > most > 8:
        lines, width = textwrap.wrap(text, most), most
    while width > 8 and any(
        measure(line, size, weight=weight)[0] > room for line in _longest_first(lines)
    ):
        lines = textwrap.wrap(text, width)
        width = min(width, max(map(len, lines))) - 1
    return lines


def _longest_first(lines: list[str]) -> list[str]:
    return sorted(lines, key=len, reverse=True)


def area(corners: Floats) -> float:
    """Return the area of a polygon; of fewer than three corners, 0."""
    if len(corners) < 3:
        return 0.0
    x, y = corners.T
    return abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2


class NarrowError(InputError):
    """The sheet is too narrow for what it shows."""


def checked_width(width: object, least: float = 40.0) -> float:
    """Return a width in millimetres, or refuse it."""
    length = millimetres(width, "the width")
    if length < least:
        raise NarrowError(f"the width is {length:.4g}; give at least {least:g} millimetres")
    return length


class Key(NamedTuple):
    """A symbol and what it means.

    Attributes:
        symbol: items whose left end, at half their height, is at (0, 0).
        width: of the symbol, in points.
        text: its meaning.
    """

    symbol: Sequence[Item]
    width: float
    text: str


@dataclass
class Legend:
    """The entries, in their order.

    Attributes:
        lines: of text, and whether they are emphatic; emphatic ones stand above the keys.
        keys: symbols with their meanings.
        table: short texts, read column by column.
        captions: what is said of the picture even where it has no legend.
        notes: what the picture cannot show; said on stderr, and by commands in JSON.
    """

    lines: list[tuple[str, bool]] = field(default_factory=list)
    keys: list[Key] = field(default_factory=list)
    table: list[str] = field(default_factory=list)
    captions: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def note(self, text: str) -> None:
        """Report what the picture cannot show."""
        self.notes.append(text)
        note(text)

    def line(self, text: str, emphasis: bool = False) -> None:
        """Add a line of text."""
        self.lines.append((text, emphasis))

    def key(self, symbol: Symbol, text: str) -> None:
        """Add a symbol and what it means."""
        self.keys.append(Key(*symbol, text))

    def extend(self, other: Legend) -> None:
        """Add the entries of another one."""
        for name in ("lines", "keys", "table", "captions", "notes"):
            getattr(self, name).extend(getattr(other, name))


#: The items and the width of a symbol.
Symbol = tuple[Sequence[Item], float]


#: Besides "round": corners of small shapes.
_SHAPES = {
    "square": ((-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)),
    "diamond": ((0, -1.25), (1.25, 0), (0, 1.25), (-1.25, 0)),
    "triangle": ((-1.2, -0.8), (1.2, -0.8), (0, 1.3)),
    "star": tuple(
        (r * math.sin(k * math.pi / 5), r * math.cos(k * math.pi / 5))
        for k, r in enumerate((1.8, 0.75) * 5)
    ),
}


class Scene:
    """A sheet of paper on which `write` lets no label cover another or leave the sheet.

    Attributes:
        paper: width and height in millimetres.
        width, height: in points.
        items: in the order in which they were added.
        boxes: what is covered by labels so far.
        legend: what is said below or beside the picture.
        numbers: of regions, by their signs as text, where elements have these numbers as names.
        maps: where points of the model are, of each panel; none where they have no place.
    """

    def __init__(self, width: float, height: float) -> None:
        """Take width and height in millimetres."""
        require_matplotlib()
        self.paper = width, height
        self.width, self.height = width * POINTS, height * POINTS
        self.items: list[Item] = []
        self.boxes: list[Box] = []
        self.legend = Legend()
        self.numbers: Mapping[str, int] = {}
        self.maps: list[PageMap] = []
        self._clip: Box | tuple[Place, float] | None = None

    @contextmanager
    def clipped(self, clip: Box | tuple[Place, float]) -> Iterator[None]:
        """Cut what is added meanwhile to a box or a disc."""
        self._clip = clip
        yield
        self._clip = None

    def scaled(self, factor: float) -> Scene:
        """Return the same sheet enlarged: paper, text and lines."""
        grown = Scene(*(factor * length for length in self.paper))
        grown.items = [scaled(item, factor) for item in self.items]
        grown.maps = [found.moved(0.0, 0.0, factor) for found in self.maps]
        return grown

    def measure(self, text: str, size: float = FONT, rotation: float = 0.0) -> tuple[float, float]:
        """Return the width and height of a text, in points."""
        return measure(text, size, rotation)

    def box(self, at: Place, text: str, size: float, rotation: float = 0.0) -> Box:
        """Return the box of a text centred at a point."""
        w, h = self.measure(text, size, rotation)
        return (at[0] - w / 2, at[1] - h / 2, at[0] + w / 2, at[1] + h / 2)

    def is_free(self, box: Box) -> bool:
        """Return whether a box is on the sheet and covers no label."""
        left, bottom, right, top = box
        if left < GAP or bottom < GAP or right > self.width - GAP or top > self.height - GAP:
            return False
        return not any(
            left < r + GAP and right > l - GAP and bottom < t + GAP and top > b - GAP
            for l, b, r, t in self.boxes  # noqa: E741
        )

    def write(
        self,
        at: Place,
        text: str,
        size: float = FONT,
        *,
        anchor: tuple[float, float] = (0.5, 0.5),
        rotation: float = 0.0,
        **style: Any,
    ) -> bool:
        """Write a text if its place is free; return whether it was.

        Args:
            at: a point of the scene.
            text: one or several lines.
            size: in points.
            anchor: the point of the text that is put there: (0, 0) its lower left corner,
                (1, 1) its upper right one.
            rotation: in degrees.
            style: see the module.
        """
        w, h = self.measure(text, size, rotation)
        x, y = at[0] + (0.5 - anchor[0]) * w, at[1] + (0.5 - anchor[1]) * h
        box = (x - w / 2, y - h / 2, x + w / 2, y + h / 2)
        if not self.is_free(box):
            return False
        self.boxes.append(box)
        ha = "left" if anchor[0] == 0 else "right" if anchor[0] == 1 else "center"
        place = {"left": box[0], "right": box[2], "center": x}[ha], y
        self.text(place, text, size, ha=ha, rotation=rotation, **style)
        return True

    def text(
        self,
        at: Place,
        text: str,
        size: float = FONT,
        *,
        ha: str = "center",
        va: str = "center",
        rotation: float = 0.0,
        **style: Any,
    ) -> None:
        """Write a text, whatever is there."""
        place = float(at[0]), float(at[1])
        how = {"size": size, "ha": ha, "va": va, "rotation": rotation}
        self._add(Label, {"zorder": 6, **style}, place=place, text=text, **how)

    def curve(self, points: Floats, **style: Any) -> None:
        """Draw control points (3k + 1, 2) of cubic curves, joined."""
        self._add(Path, style, points=points, kind="curve")

    def circle(self, centre: Place, radius: float, **style: Any) -> None:
        """Draw a circle."""
        self._add(Path, style, points=np.asarray(centre), kind="circle", radius=radius)

    def ball(
        self,
        centre: Place,
        radius: float,
        near: str = "#ffffff",
        far: str = "#c0c4cc",
        **style: Any,
    ) -> None:
        """Draw a shaded ball; with colours that let through, such as ``#00000040``, a shadow."""
        place = float(centre[0]), float(centre[1])
        how = {"radius": radius, "near": near, "far": far}
        self._add(Ball, {"role": "ball", **style}, centre=place, **how)

    def marker(self, at: Place, size: float, shape: str, **style: Any) -> None:
        """Draw a small shape of about the area of a disc with radius `size`; see `_SHAPES`."""
        if shape == "round":
            self.circle(at, size, **style)
        else:
            self.polygon([(at[0] + size * x, at[1] + size * y) for x, y in _SHAPES[shape]], **style)

    def polygon(self, corners: Any, **style: Any) -> None:
        """Draw a closed polygon."""
        self._add(Path, style, points=np.asarray(corners), kind="polygon")

    def line(self, points: Any, **style: Any) -> None:
        """Draw an open polygonal line."""
        self._add(Path, style, points=np.asarray(points), kind="line")

    def mark(self, at: Place, sign: str, size: float, **style: Any) -> None:
        """Draw a disc "o", a cross "x" or a dash "_" of a size in points."""
        self._add(Mark, style, place=(float(at[0]), float(at[1])), sign=sign, size=size)

    def _add(self, sort: type[Item], style: dict[str, Any], **what: Any) -> None:
        rest = {key: x for key, x in style.items() if key not in ("gid", "zorder", "role")}
        name, order = style.get("gid", ""), style.get("zorder")
        role = style.get("role") or role_of(sort, name, rest)
        self.items.append(
            sort(name=name, role=role, order=order, clip=self._clip, style=rest, **what)
        )

    def place(self, other: Scene, x: float, y: float) -> None:
        """Add all that another scene shows, its lower left corner at (x, y), and its legend."""
        self.items += [moved(item, x, y) for item in other.items]
        self.boxes += [(l + x, b + y, r + x, t + y) for l, b, r, t in other.boxes]  # noqa: E741
        self.legend.extend(other.legend)
        self.maps += [found.moved(x, y) for found in other.maps]


#: Room beside and above what is drawn, in points.
Margins: TypeAlias = tuple[float, float]
#: 6 mm all around.
AROUND = (6 * POINTS, 6 * POINTS)


def fitted(
    width: float, *parts: tuple[Floats, Margins], tallest: float | None = None
) -> tuple[Scene, float, Floats]:
    """Return an empty sheet, and the scale and shift that put points on it.

    Args:
        width: of the sheet, in millimetres.
        parts: points (k, 2 or more), whose box is to fit in the sheet with these margins.
        tallest: height of the sheet, at most; if omitted, the boxes are a little lower than wide.
    """
    margins = np.array([margin for _, margin in parts])
    low = np.array([points.min(axis=0)[:2] for points, _ in parts])
    high = np.array([points.max(axis=0)[:2] for points, _ in parts])
    wide = width * POINTS
    tall = 0.95 * wide + 2 * margins[:, 1].max() if tallest is None else tallest * POINTS
    # Any two parts may be the first and the last.
    room = np.array([wide, tall]) - margins[:, None] - margins
    scale = float((room / np.maximum(high - low[:, None], 1e-3)).min())
    least, most = (scale * low - margins).min(axis=0), (scale * high + margins).max(axis=0)
    scene = Scene(width, (most[1] - least[1]) / POINTS)
    return scene, scale, np.array([(wide - least[0] - most[0]) / 2, -least[1]])


def arrow(
    scene: Scene, start: Floats, end: Floats, size: float = 1.5, **style: Any
) -> list[Floats]:
    """Draw an arrow, never so short that what is not zero cannot be seen; return its corners.

    Args:
        size: of its head, and of its least length, in units of 2.5 points.
    """
    apart = float(np.linalg.norm(end - start))
    along, length = (end - start) / max(apart, 1e-9), max(apart, 2.5 * size)
    side = np.array([-along[1], along[0]])
    head = min(6.5 * size, 0.7 * length)
    wide, thin = 0.42 * head, min(0.8 * size, 0.1 * head)
    end = start + length * along
    neck = end - head * along
    half = [(start, thin), (neck, thin), (neck, wide)]
    left, right = ([at + way * out * side for at, out in half] for way in (1, -1))
    corners = [*left, end, *reversed(right)]
    scene.polygon(corners, **{"joinstyle": "miter", "role": "arrow", **style})
    return [*corners, corners[0]]


def arc(centre: Floats, radius: float, start: float, sweep: float) -> Floats:
    """Return a circular arc as control points (13, 2) of cubic curves; angles in radians."""
    angles = np.linspace(start, start + sweep, 5)
    handle = 4 / 3 * math.tan(sweep / 16)
    radial = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    tangent = np.stack([-radial[:, 1], radial[:, 0]], axis=1)
    return centre + radius * joined(radial, handle * tangent)


def turning_arrow(scene: Scene, centre: Floats, radius: float, way: int, **style: Any) -> None:
    """Draw an arc about a centre and its head; it turns counter-clockwise for `way` 1."""
    start, sweep = math.radians(-50), math.radians(250)
    curve = arc(centre, radius, start if way > 0 else math.pi - start, way * sweep)
    out = (curve[-1] - centre) / radius
    ahead = way * np.array([-out[1], out[0]])
    head = [curve[-1] + 4.5 * ahead, curve[-1] + 2.6 * out, curve[-1] - 2.6 * out]
    gid, colour, order = style["gid"], style["color"], style["zorder"]
    scene.curve(curve, fill=False, ec=colour, lw=1.5, gid=gid, zorder=order)
    scene.polygon(head, fc=colour, ec="none", gid=f"{gid}-head", zorder=order, role="arrow")


def joined(place: Floats, handle: Floats) -> Floats:
    """Return the control points of cubic curves through `place` with the given handles."""
    curve = np.empty((3 * len(place) - 2, 2))
    curve[0::3] = place
    curve[1::3] = place[:-1] + handle[:-1]
    curve[2::3] = place[1:] - handle[1:]
    return curve
