"""Light, dark and mono: one map of colours for the scenes of both packages.

Views know the light theme alone. *dark* exchanges light and dark and keeps hues, in the space OKLab
[Ottosson2020], where equal steps look equal. *mono* prints black on white: opaque colours become
hatchings, the lightest colour the emptiest one; what shines through becomes grey.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, TypeAlias

import numpy as np

from arrangement.drawing.scene import SHEET, Ball, Floats, Item, Label, Path, Scene

#: The lightness of the darkest and of the lightest colour of the dark theme.
_NIGHT, _DAY = 0.19, 0.95
#: The least lightness of coloured lines and letters in it.
_LINE = 0.65
#: A colour at least as light as this is left white in print; darker ones have a hatching.
_PAPER = 0.92
#: Colours nearer to grey than this have no hatching.
_GREY = 0.02
_HATCHES = ("", "////", "....", "\\\\\\\\", "xxxx", "----", "||||", "++++", "oooo")
_HALO = (1.8, "#ffffff")

Rgba: TypeAlias = tuple[float, float, float, float]


def apply_theme(scene: Scene, theme: str) -> Scene:
    """Return a scene in a theme.

    Args:
        scene: in the light one.
        theme: "light", "dark" or "mono".
    """
    if theme == "light":
        return scene
    made = Scene(*scene.paper)
    made.boxes, made.maps = list(scene.boxes), list(scene.maps)
    change = _dark if theme == "dark" else _mono(scene)
    if theme == "dark":
        made.polygon(
            [(0, 0), (made.width, 0), (made.width, made.height), (0, made.height)],
            fc=_hex(_night(rgba("#ffffff"))),
            ec="none",
            zorder=-1,
            gid=SHEET,
            role="region",
        )
    made.items += map(change, scene.items)
    return made


def dark_colour(colour: Any, *, is_line: bool = False) -> str:
    """Return a colour of the light theme in the dark one; lines and letters are light enough."""
    return _hex(_night(rgba(colour), _LINE if is_line else 0.0))


def _dark(item: Item) -> Item:
    if isinstance(item, Ball):
        return item
    style = _with_colours(item, dark_colour)
    lines = {"ec", "color", "fc"} if item.role == "arrow" else {"ec", "color"}
    for key in lines & style.keys():
        if style[key] != "none" and not (key == "ec" and _is_seam(item)):
            style[key] = dark_colour(item.style[key], is_line=True)
    if isinstance(item, Label):
        style.setdefault("color", _hex(_night(rgba("black"))))
    elif not isinstance(item, Path) or "ec" not in style:
        style.setdefault("color" if not isinstance(item, Path) else "ec", _hex(_night(rgba("k"))))
    return replace(item, style=style)


def _with_colours(item: Item, change: Callable[[Rgba], str]) -> dict[str, Any]:
    """Return the style of an item with other colours."""
    style = dict(item.style)
    for key in ("fc", "ec", "color"):
        if key in style:
            style[key] = _map_colour(style[key], change)
    if "halo" in style:
        style["halo"] = (style["halo"][0], _map_colour(style["halo"][1], change))
    if isinstance(style.get("plate"), Mapping):
        plate = dict(style["plate"])
        plate.update({k: _map_colour(plate[k], change) for k in ("fc", "ec") if k in plate})
        style["plate"] = plate
    return style


def _map_colour(colour: Any, change: Callable[[Rgba], str]) -> Any:
    return colour if isinstance(colour, str) and colour == "none" else change(rgba(colour))


def _mono(scene: Scene) -> Callable[[Item], Item]:
    """Return the change of an item that belongs to the colours of a scene."""
    fills = {rgba(item.style["fc"])[:3] for item in scene.items if _is_hatched(item)}
    order = sorted(fills, key=lambda fill: (-round(float(_oklab(fill)[0]), 6), fill))
    first = int(bool(order) and float(_oklab(order[0])[0]) < _PAPER)
    hatches = {fill: _HATCHES[k % len(_HATCHES)] for k, fill in enumerate(order, first)}

    def change(item: Item) -> Item:
        if isinstance(item, Ball):
            return item
        style = _with_colours(
            item, lambda rgba: _hex(_from_oklab((float(_oklab(rgba)[0]), 0.0, 0.0), rgba[3]))
        )
        if _is_hatched(item):
            hatch = hatches[rgba(item.style["fc"])[:3]]
            style |= {"fc": "#ffffff"} | ({"hatch": hatch} if hatch else {})
            if hatch and (style.get("ec") == "none" or _is_seam(item)):
                style |= {"ec": "#808080", "lw": 0}
            elif _is_seam(item):
                style["ec"] = "#ffffff"
        elif item.role == "arrow" and not _is_grey(rgba(item.style.get("fc", "none"))):
            style["fc"] = "#000000"
        elif isinstance(item, Path) and style.get("ec", "none") != "none":
            style["ec"] = "#000000" if not _is_grey(rgba(item.style["ec"])) else style["ec"]
        elif isinstance(item, Label):
            style["color"] = "#000000"
            if "plate" in style:
                style["plate"] = {**style["plate"], "fc": "#ffffff"}
            else:
                style.setdefault("halo", _HALO)
        return replace(item, style=style)

    return change


def _is_hatched(item: Item) -> bool:
    """Return whether a shape has a colour inside through which nothing shines."""
    fill = item.style.get("fc", "none")
    if not isinstance(item, Path) or item.role == "arrow" or fill == "none":
        return False
    return item.style.get("alpha", 1) == 1 and rgba(fill)[3] == 1 and not _is_grey(rgba(fill))


def _is_seam(item: Item) -> bool:
    """Return whether the edge of a shape only closes the gap to the next one of its colour."""
    edge, fill = (str(item.style.get(key, "none")) for key in ("ec", "fc"))
    return edge == fill != "none"


def rgba(colour: Any) -> Rgba:
    """Return red, green, blue and how much covers, from 0 to 1, of any colour of matplotlib."""
    from matplotlib.colors import to_rgba

    return to_rgba(colour)


def _hex(colour: Rgba) -> str:
    from matplotlib.colors import to_hex

    return to_hex(colour, keep_alpha=colour[3] < 1)


#: From linear RGB to the cone responses of OKLab, and from their cube roots to L, a, b.
_CONES = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_LAB = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)


def _oklab(rgb: tuple[float, ...]) -> Floats:
    """Return lightness, from 0 to 1, and two coordinates of hue and strength."""
    srgb = np.array(rgb[:3])
    linear = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
    lab: Floats = _LAB @ np.cbrt(_CONES @ linear)
    return lab


def _is_grey(colour: Rgba) -> bool:
    return float(np.hypot(*_oklab(colour)[1:])) < _GREY


def _night(colour: Rgba, least: float = 0.0) -> Rgba:
    """Return the colour of the same hue at the opposite lightness; greys may be darker still."""
    light, a, b = _oklab(colour)
    lightness = _NIGHT + (1 - light) * (_DAY - _NIGHT)
    return _from_oklab((lightness if _is_grey(colour) else max(lightness, least), a, b), colour[3])


def _from_oklab(lab: tuple[float, float, float], alpha: float) -> Rgba:
    linear = np.linalg.solve(_CONES, np.linalg.solve(_LAB, np.array(lab)) ** 3)
    linear = np.clip(linear, 0.0, 1.0)
    rgb = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    red, green, blue = np.clip(rgb, 0.0, 1.0).tolist()
    return red, green, blue, alpha
