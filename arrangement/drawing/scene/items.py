"""The items of a picture: lines, shapes, balls, marks and texts, each with its role.

Coordinates are points (1/72 inch) from the lower left corner of the sheet.

Styles: ``fc`` colour inside, ``ec`` of the line, ``lw`` its width in points, ``ls`` its dashes
(offset, lengths in line widths), ``alpha``, ``capstyle``, ``joinstyle``, ``hatch``; of labels and
marks ``color``, ``weight``, ``style``, ``halo`` (width, colour), ``plate`` (a box behind the text).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.errors import InputError

Floats: TypeAlias = npt.NDArray[np.float64]
#: A point of the scene.
Place: TypeAlias = Sequence[float] | Floats
#: Left, bottom, right, top; in points.
Box: TypeAlias = tuple[float, float, float, float]

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
        """The order in which all items of a scene are painted; equal ones as they were added."""
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


def moved(item: Any, right: float, up: float) -> Any:
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


def scaled(item: Item, factor: float) -> Item:
    """Return an item with all lengths enlarged."""
    found: dict[str, Any] = {
        key: _grown(getattr(item, key), factor) for key in _LENGTHS if hasattr(item, key)
    }
    style = dict(item.style)
    for key in {"lw", "mew"} & style.keys():
        style[key] *= factor
    if style.get("halo"):
        style["halo"] = (factor * style["halo"][0], style["halo"][1])
    if "pad" in (style.get("plate") or {}):
        style["plate"] = {**style["plate"], "pad": factor * style["plate"]["pad"]}
    clip = None if item.clip is None else _grown(item.clip, factor)
    return replace(item, style=style, clip=clip, **found)


def _grown(value: Any, factor: float) -> Any:
    if isinstance(value, (tuple, list)):
        return tuple(_grown(x, factor) for x in value)
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
        found = np.array([float(Fraction(x) if isinstance(x, str) else x) for x in point])
        if len(found) != self.size:
            raise InputError(f"the point has {len(found)} coordinates; expected {self.size}")
        return found

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
        found: Floats = self.scale * placed + np.asarray(self.shift)
        return found

    @property
    def is_to_scale(self) -> bool:
        """Whether axes can carry the coordinates: those of a plane, which floats resolve."""
        resolved = bool((np.abs(self.shift) < 1e12).all()) and 1e-250 < self.scale < 1e250
        return self.place is None and resolved

    def back(self, place: Place) -> tuple[float, float]:
        """Return the coordinates that are at a place of the sheet, of a plane seen to scale."""
        x, y = (np.asarray(place) - np.asarray(self.shift)) / self.scale
        return float(x), float(y)

    def moved(self, right: float, up: float, factor: float = 1.0) -> PageMap:
        """Return the map of a sheet that is enlarged and then moved."""
        shift = factor * np.asarray(self.shift) + (right, up)
        return replace(self, scale=factor * self.scale, shift=(float(shift[0]), float(shift[1])))
