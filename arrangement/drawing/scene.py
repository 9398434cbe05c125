"""A scene: the items of a picture, each with its role, what they measure, and the legend.

A view adds items to a `Scene`; a writer (`figure`, `tikz`) reads them and knows no view. The legend
is data until `layout` places it. Coordinates are points (1/72 inch) from the lower left corner of
the sheet.

Styles: ``fc`` colour inside, ``ec`` of the line, ``lw`` its width in points, ``ls`` its dashes
(offset, lengths in line widths), ``alpha``, ``capstyle``, ``joinstyle``, ``hatch``; of labels and
marks ``color``, ``weight``, ``style``, ``halo`` (width, colour), ``plate`` (a box behind the text).
Methods of a scene take besides ``gid``, the name of the item, ``role`` and ``zorder``
(`Item.order`).
"""

from __future__ import annotations

import math
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.console.progress import note
from arrangement.errors import InputError, extra
from arrangement.numbers.exact import rational, shown

Floats: TypeAlias = npt.NDArray[np.float64]
#: A point of the scene.
Place: TypeAlias = Sequence[float] | Floats
#: Left, bottom, right, top; in points.
Box: TypeAlias = tuple[float, float, float, float]


def require_matplotlib() -> Any:
    """Return matplotlib, or say which extra installs it and what places labels."""
    try:
        import matplotlib as mpl
        import shapely  # noqa: F401
    except ImportError:
        with extra("figures"):
            raise
    return mpl


#: In millimetres; a point is that of TeX, as in ``\\the\\columnwidth``.
_UNITS = {"mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72.27}


def millimetres(value: object, name: str, unit: str = "mm") -> float:
    """Return a length for paper or print as a float, or refuse what is not positive and finite.

    Args:
        value: a number, or a text such as ``84``, ``8.4cm``, ``3.3in``, ``252pt``.
        name: of the length, for the error.
        unit: of a number without one.
    """
    number: object = value
    if isinstance(value, str):
        text = value.strip()
        unit = next((end for end in _UNITS if text.endswith(end)), unit)
        with suppress(InputError):
            number = rational(text.removesuffix(unit).strip())
    if isinstance(number, (int, float, Fraction)) and 0 < number < 100_000:
        length = float(number) * _UNITS[unit]
        if 0 < length < 10_000:  # a tiny number may be 0 as a float
            return length
    raise InputError(
        f"{name} is {shown(value)}; give a number above 0 in {unit}, or one with mm, cm, in or pt "
        "after it, below ten metres"
    )


def points(value: object, name: str) -> float:
    """Return a length such as ``8``, ``8pt`` or ``3mm`` in points, or refuse it."""
    return millimetres(value, name, "pt") / _UNITS["pt"]


#: What an item can be, and what it then is.
ROLES: Mapping[str, str] = {
    "region": "an area: a region, a face, a cell, a set",
    "ball": "a shaded ball",
    "circle": "the visible part of a plane or a line through the whole picture",
    "hidden": "what lies behind something",
    "edge": "an edge of a polyhedron, a graph or a diagram",
    "border": "where a set, a body or the picture ends",
    "point": "a vertex, a mark, the sign of a state",
    "axis": "axes, rulers, ticks, the origin",
    "arrow": "an arrow",
    "line": "any other line",
    "label": "a text",
}
#: The role that goes with the first word of a name, unless the view gives another.
_ROLES = {
    word: role
    for role, words in {
        "region": "body cell face polygon region",
        "circle": "arc front",
        "hidden": "back",
        "edge": "cover edge link",
        "border": "border limb outline rim",
        "point": "mark point vertex",
        "axis": "axis origin scale",
    }.items()
    for word in words.split()
}


@dataclass(frozen=True, kw_only=True)
class Item:
    """Something on the paper.

    Attributes:
        name: of the element, such as ``region-3``; may be empty.
        role: one of `ROLES`.
        order: what is higher is painted later; if None, marks over paths.
        clip: the box, or the disc (centre and radius), outside which it is not seen.
        style: see the module.
    """

    name: str = ""
    role: str
    order: float | None = None
    clip: Box | tuple[Place, float] | None = None
    style: Mapping[str, Any] = field(default_factory=dict)

    @property
    def height(self) -> float:
        """The z-order: lower items are painted first, equal ones as they were added."""
        return self.order if self.order is not None else 2.0 if isinstance(self, Mark) else 1.0


@dataclass(frozen=True, kw_only=True)
class Path(Item):
    """A line or a filled shape.

    Attributes:
        points: (k, 2) corners; (3k + 1, 2) control points of cubic curves; or one centre.
        kind: "line" (open), "polygon" (closed), "curve", or "circle".
        radius: of the circle.
    """

    points: Floats
    kind: str
    radius: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Ball(Item):
    """A ball lit from one side: a radial gradient in a disc.

    Attributes:
        centre, radius: of the disc, in points.
        near, far: colours ``#rrggbb`` or ``#rrggbbaa`` at the focus, where the ball is brightest
            (`LIGHT`, in radii), and at the rim. Between them, on a circle with its centre on the
            way from the centre to the focus, stands the colour of `SHADES`.
    """

    centre: tuple[float, float]
    radius: float
    near: str
    far: str


#: Size of a circle between focus (0) and rim (1) of a ball, and the share of the far colour there:
#: 1 - cos of an angle over its sine, as on a matt ball.
SHADES = tuple((math.sin(a), 1 - math.cos(a)) for a in (k * math.pi / 16 for k in range(9)))
#: From where all balls are lit: from the upper left.
LIGHT = (-0.35, 0.4)


@dataclass(frozen=True, kw_only=True)
class Mark(Item):
    """A small sign of a fixed size in points: a disc "o", a cross "x", or a dash "_"."""

    place: tuple[float, float]
    sign: str
    size: float


@dataclass(frozen=True, kw_only=True)
class Label(Item):
    """A text; `ha` and `va` say which of its points is at the place."""

    place: tuple[float, float]
    text: str
    size: float
    ha: str = "center"
    va: str = "center"
    rotation: float = 0.0


def move_item(item: Any, right: float, up: float) -> Any:
    """Return an item, with what it is cut to, at another place."""
    by, clip = np.array([right, up]), item.clip
    if clip is not None and len(clip) == 2:
        clip = np.asarray(clip[0]) + by, clip[1]
    elif clip is not None:
        clip = clip[0] + right, clip[1] + up, clip[2] + right, clip[3] + up
    if isinstance(item, Path):
        return replace(item, clip=clip, points=item.points + by)
    if isinstance(item, Ball):
        return replace(item, clip=clip, centre=(item.centre[0] + right, item.centre[1] + up))
    return replace(item, clip=clip, place=(item.place[0] + right, item.place[1] + up))


def role_of(sort: type[Item], name: str, style: Mapping[str, Any]) -> str:
    """Return the role of an item without one: by its name, else by its kind."""
    if sort is Label:
        return "label"
    word = next((part for part in name.split("-") if part.isalpha()), "")
    if sort is Mark:
        return "point"
    filled = style.get("fc", "none") != "none"
    return _ROLES.get(word, "region" if filled else "line")


#: What of an item is a length or a point, or several.
_LENGTHS = ("points", "radius", "place", "centre", "size")


def scale_item(item: Item, factor: float) -> Item:
    """Return an item with all lengths enlarged."""
    lengths: dict[str, Any] = {
        key: _enlarge(getattr(item, key), factor) for key in _LENGTHS if hasattr(item, key)
    }
    style = dict(item.style)
    for key in {"lw", "mew"} & style.keys():
        style[key] *= factor
    if style.get("halo"):
        style["halo"] = (factor * style["halo"][0], style["halo"][1])
    if "pad" in (style.get("plate") or {}):
        style["plate"] = {**style["plate"], "pad": factor * style["plate"]["pad"]}
    clip = None if item.clip is None else _enlarge(item.clip, factor)
    return replace(item, style=style, clip=clip, **lengths)


def _enlarge(value: Any, factor: float) -> Any:
    if isinstance(value, (tuple, list)):
        return tuple(_enlarge(x, factor) for x in value)
    return factor * value


@dataclass(frozen=True)
class PageMap:
    """Where points of the model are on a sheet: p at ``scale * place(p) + shift``, in points.

    Attributes:
        place: from coordinates of the model; None where these are those of a plane, seen to scale.
        size: how many coordinates a point has.
    """

    scale: float = 1.0
    shift: Place = (0.0, 0.0)
    place: Callable[[Floats], Floats] | None = None
    size: int = 2

    def numbers(self, point: Iterable[Any]) -> Floats:
        """Return the coordinates of a point of the model as floats.

        Raises:
            InputError: it has another number of them.
        """
        coordinates = np.array([float(Fraction(x) if isinstance(x, str) else x) for x in point])
        if len(coordinates) != self.size:
            raise InputError(f"the point has {len(coordinates)} coordinates; expected {self.size}")
        return coordinates

    def at(self, point: Iterable[Any]) -> Floats:
        """Return a point of the model on the sheet.

        Raises:
            InputError: it has another number of coordinates, or lies at infinity.
        """
        placed = self.numbers(point)
        with np.errstate(all="ignore"):
            placed = placed if self.place is None else self.place(placed)
        if not np.isfinite(placed).all():
            raise InputError("the point lies at infinity in this picture; choose another view")
        spot: Floats = self.scale * placed + np.asarray(self.shift)
        return spot

    @property
    def is_to_scale(self) -> bool:
        """Whether axes can carry the coordinates: those of a plane, which floats resolve."""
        resolved = bool((np.abs(self.shift) < 1e12).all()) and 1e-250 < self.scale < 1e250
        return self.place is None and resolved

    def back(self, place: Place) -> tuple[float, float]:
        """Return the coordinates that are at a place of the sheet, of a plane seen to scale."""
        x, y = (np.asarray(place) - np.asarray(self.shift)) / self.scale
        return float(x), float(y)

    def on_sheet(self, right: float, up: float, factor: float = 1.0) -> PageMap:
        """Return the map of a sheet that is enlarged and then moved."""
        shift = factor * np.asarray(self.shift) + (right, up)
        return replace(self, scale=factor * self.scale, shift=(float(shift[0]), float(shift[1])))


def curve_points(curve: Floats, steps: int = 24) -> Floats:
    """Return points along cubic curves given by control points (3k + 1, 2)."""
    t = np.linspace(0, 1, steps, endpoint=False)[:, None, None]
    p, q, r, end = curve[:-1:3], curve[1::3], curve[2::3], curve[3::3]
    points = (1 - t) ** 3 * p + 3 * t * (1 - t) ** 2 * q + 3 * t**2 * (1 - t) * r + t**3 * end
    return points.transpose(1, 0, 2).reshape(-1, 2)


def along(curve: Floats, steps: int = 8) -> Floats:
    """Return points along cubic curves with both ends."""
    return np.vstack([curve_points(curve, steps), curve[-1:]])


def ring(centre: Place, radius: float, steps: int = 200) -> Floats:
    """Return points along a circle, the last one as the first."""
    at = np.linspace(0, 2 * math.pi, steps)
    return np.asarray(centre) + radius * np.stack([np.cos(at), np.sin(at)], axis=1)


#: Millimetres to points.
POINTS = 72 / 25.4
#: Resolution at which text is measured; pictures are saved with the same.
DPI = 300
#: Size of letters, in points.
FONT = 7.0
#: The name of what is behind a picture in a theme that is not white.
SHEET = "sheet"
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
    return _measure(text, size, rotation, weight, fonts)


@lru_cache(maxsize=8192)
def _measure(
    text: str, size: float, rotation: float, weight: str, _fonts: tuple[str, ...]
) -> tuple[float, float]:
    from matplotlib.text import Text

    renderer, figure = _measuring()
    label = Text(0, 0, text, size=size, rotation=rotation, weight=weight, linespacing=1.0)
    label.set_figure(figure)
    try:
        extent = label.get_window_extent(renderer)
    except ValueError as error:  # of matplotlib's formulas
        problem = str(error).strip().splitlines()[-1]
        raise InputError(f"the text {shown(text)} is not a formula: {problem}") from None
    return extent.width * 72 / DPI, extent.height * 72 / DPI


@lru_cache(maxsize=1)
def _measuring() -> Any:
    from matplotlib.backends import backend_agg
    from matplotlib.figure import Figure

    renderer: Any = backend_agg.RendererAgg
    return renderer(10, 10, DPI), Figure(dpi=DPI)


def wrap_lines(text: str, room: float, size: float = FONT, weight: str = "normal") -> list[str]:
    """Return a text in lines that fit a width in points, as far as its words do."""
    lines, width = [text], len(text)
    # No letter is half as narrow as this one: where even that is too long nothing is measured.
    most = int(room / (measure("i" * 20, size)[0] / 40))
    if width > most > 8:
        lines, width = textwrap.wrap(text, most), most
    while width > 8 and any(
        measure(line, size, weight=weight)[0] > room
        for line in sorted(lines, key=len, reverse=True)
    ):
        lines = textwrap.wrap(text, width)
        width = min(width, max(map(len, lines))) - 1
    return lines


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
    """The texts that explain a picture; each list in the order of the sheet.

    Attributes:
        lines: texts, each with whether it is bold; bold ones stand above the keys.
        keys: symbols with their meanings.
        table: short texts, such as the sign vectors of numbered regions, column by column.
        captions: texts below the picture, with any legend and without one.
        notes: what the picture leaves out; printed on stderr, and in the JSON of a command.
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
        legend: the texts below or beside the picture.
        numbers: of regions, by their signs as text, where elements have these numbers as names.
        maps: where points of the model are, of each panel; none where they have no place.
    """

    def __init__(self, width: float, height: float) -> None:
        """Make an empty scene; width and height are in millimetres."""
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
    def clip(self, clip: Box | tuple[Place, float]) -> Iterator[None]:
        """Cut what is added meanwhile to a box or a disc."""
        self._clip = clip
        yield
        self._clip = None

    def enlarge(self, factor: float) -> Scene:
        """Return the same sheet enlarged: paper, text and lines."""
        grown = Scene(*(factor * length for length in self.paper))
        grown.items = [scale_item(item, factor) for item in self.items]
        grown.maps = [lengths.on_sheet(0.0, 0.0, factor) for lengths in self.maps]
        return grown

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
        w, h = measure(text, size, rotation)
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
        self.items += [move_item(item, x, y) for item in other.items]
        self.boxes += [(l + x, b + y, r + x, t + y) for l, b, r, t in other.boxes]  # noqa: E741
        self.legend.extend(other.legend)
        self.maps += [own.on_sheet(x, y) for own in other.maps]


#: Room beside and above what is drawn, in points.
Margins: TypeAlias = tuple[float, float]
#: 6 mm all around.
AROUND = (6 * POINTS, 6 * POINTS)


def fit_sheet(
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
    return centre + radius * cubic_curves(radial, handle * tangent)


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


def cubic_curves(place: Floats, handle: Floats) -> Floats:
    """Return the control points of cubic curves through `place` with the given handles."""
    curve = np.empty((3 * len(place) - 2, 2))
    curve[0::3] = place
    curve[1::3] = place[:-1] + handle[:-1]
    curve[2::3] = place[1:] - handle[1:]
    return curve
