"""Single planes in a picture: names, colours, dashes, and what the legend says of them.

Names are those of the planes (`Planes.names`), written where numbers are otherwise. Colours and
dashes are given to the elements of a scene, which have the number of their plane in their name.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Annotated, Any, NamedTuple, Protocol, TypeAlias

from arrangement.console.options.signature import Syntax
from arrangement.drawing.colours import hex_colour, readable
from arrangement.drawing.scene import Item, Key, Label, Path, Scene
from arrangement.errors import InputError, refusal
from arrangement.numbers.exact import shown
from arrangement.planes.planes import Names, Planes

from .names import plane_names, stroke

#: Names of planes, and colours of planes, by number or name, as a text or a mapping.
NamesOption: TypeAlias = Annotated[str | Names, Syntax(metavar="1=NAME,...")]
ColoursOption: TypeAlias = Annotated[str | Names, Syntax(metavar="1=COLOUR,...")]

#: Of lines; on paper in units of their width.
DASHES: Mapping[str, Any] = {"solid": "-", "dashed": (0, (4, 2)), "dotted": (0, (1, 1.5))}
#: Elements of a plane: lines and arcs, and edges of a dual across it; facets and arrows.
_STROKE = re.compile(r"(?:line|back)-(\d+)|(?:front|limb|arc|edge)-(\d+)-\d+")
_FILL = re.compile(r"facet-\d+-plane-(\d+)|side-(\d+)")


class Named(Protocol):
    """Planes or segments: how many there are, and their names."""

    @property
    def names(self) -> tuple[str, ...]:
        """A name for each, or none at all."""

    def __len__(self) -> int: ...


class Look(NamedTuple):
    """A colour ``#rrggbb``, or "" for the usual one, and a dash, or "" for the usual one."""

    colour: str
    dash: str


def read_names(names: str | Names) -> Names:
    """Return names by number, from a text as ``1=ell,2=m`` or ``ell,m``; others as they are."""
    if not isinstance(names, str):
        return names
    if "=" not in names:
        return [text.strip() for text in names.split(",")]
    return {_number(k): text for k, text in _pairs(names, "names")}


def read_looks(colours: str | Names, planes: Named, what: str = "plane") -> dict[int, Look]:
    """Return looks by the number of a plane, from 0 on.

    Args:
        planes: or segments, with their names.
        colours: as a text such as ``1=gold,m=#0af:dashed,3=:dotted``, or as a mapping; the keys are
            numbers from 1 on, or names. Or one for each plane, as ``gold,red,blue`` or a list.

    Raises:
        InputError: no such plane, colour or dash.
    """
    if isinstance(colours, str):
        colours = dict(_pairs(colours, "colours")) if "=" in colours else colours.split(",")
    if not isinstance(colours, Mapping):
        listed = list(colours)
        if len(listed) != len(planes):
            raise InputError(
                f"{len(listed)} of {len(planes)} {what}s have a colour; give one for each, or "
                "by number, as in 1=gold"
            )
        colours = dict(enumerate(listed, 1))
    looks: dict[int, Look] = {}
    for key, text in colours.items():
        colour, _, dash = str(text).strip().partition(":")
        if dash and dash not in DASHES:
            raise refusal(f"the dash of {shown(key)} is {shown(dash)}", dash, DASHES)
        look = Look(hex_colour(colour) if colour else "", dash)
        if key in planes.names and key:
            looks |= {k: look for k, name in enumerate(planes.names) if name == key}
        elif 1 <= (number := _number(key)) <= len(planes):
            looks[number - 1] = look
        else:
            raise InputError(f"{shown(key)} has a colour; there are {what}s 1 to {len(planes)}")
    return looks


def _pairs(text: str, what: str) -> list[tuple[str, str]]:
    parts = [part.partition("=") for part in text.split(",")]
    keys = {key.strip() for key, equals, _ in parts if equals and key.strip()}
    if len(keys) < len(parts):
        raise InputError(f"the {what} are {shown(text)}; give each plane once, as in 1=ell,2=m")
    return [(key.strip(), value.strip()) for key, _, value in parts]


def _number(key: Any) -> int:
    if isinstance(key, int) or (isinstance(key, str) and key.isdecimal() and len(key) < 10):
        return int(key)
    raise InputError(f"{shown(key)} is not a plane; give its number from 1 on, or its name")


def looks_of_classes(planes: Planes, looks: Mapping[int, Look]) -> dict[int, Look]:
    """Return the looks of classes of coincident planes, by the first of their planes."""
    firsts = planes.firsts
    made = {firsts[planes.class_of[k]]: looks[k] for k in sorted(looks, reverse=True)}
    return dict(sorted(made.items()))


def give_looks(scene: Scene, planes: Planes, looks: Mapping[int, Look]) -> None:
    """Give elements, names and the legend of a scene the looks of some planes.

    Coincident planes are one element, with the look of the first one that has any.
    """
    own = looks_of_classes(planes, looks)
    by_element = {k + 1: look for k, look in own.items()}
    classes = {members[0]: plane_names(planes, members) for members in planes.distinct}
    by_text = {classes[k]: look for k, look in own.items()}
    scene.items[:] = [_restyle(item, by_element, by_text) for item in scene.items]
    legend = scene.legend
    legend.keys[:] = [
        Key([_restroke(x, by_text[key.text]) for x in key.symbol], key.width, key.text)
        if key.text in by_text and all(isinstance(x, Path) for x in key.symbol)
        else key
        for key in legend.keys
    ]
    known = {key.text for key in legend.keys}
    for text, (colour, dash) in by_text.items():
        if text not in known:
            style = {"ec": colour or "black", "ls": DASHES[dash or "solid"], "lw": 1.2}
            legend.key(stroke(**style), text)


def _restyle(item: Item, by_element: Mapping[int, Look], by_text: Mapping[str, Look]) -> Item:
    if isinstance(item, Label):
        look = by_text.get(item.text) if item.style.get("style") == "italic" else None
        if look is None or not look.colour:
            return item
        if plate := item.style.get("plate"):
            return replace(item, style={**item.style, "plate": {**plate, "fc": look.colour}})
        return replace(item, style={**item.style, "color": readable(look.colour)})
    for pattern, restyle in ((_STROKE, _restroke), (_FILL, _refill)):
        match = pattern.fullmatch(item.name)
        if match and (look := by_element.get(int(next(filter(None, match.groups()))))):
            return restyle(item, look)
    return item


def _restroke(item: Item, look: Look) -> Item:
    """Return a line with a look; what is hidden stays dashed."""
    style = dict(item.style)
    if look.colour:
        style["ec"] = look.colour
    if look.dash and item.role != "hidden":
        style["ls"] = DASHES[look.dash]
        style["capstyle"] = "butt"
    return replace(item, style=style)


def _refill(item: Item, look: Look) -> Item:
    return replace(item, style={**item.style, "fc": look.colour}) if look.colour else item
