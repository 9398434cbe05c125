"""Colours of regions and planes, the same in all views; safe in grey and for the colour-blind."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TypeAlias, TypeVar

from arrangement.exact import shown

from .registry import refusal

#: Light to dark, so that the order stays in grey: numbers of sides 2, 3, 4, 5, 6, and more.
PALETTE = ("#ffffff", "#fdf0c0", "#b9dfd3", "#7fb9d8", "#6a96c8", "#8a7fb5")

#: Inks; the colours are those of Okabe and Ito.
BLACK, GREY, PALE, BLUE, VERMILION = "#000000", "#767676", "#f2f2f2", "#0072b2", "#d55e00"

#: The surface of a ball or cube on its cells.
SKIN = "#f3ead8"

#: For planes, when each has a colour of its own (P. Tol's muted scheme, dark ones first). A number
#: stands beside every use.
PLANE_COLOURS = (
    "#332288", "#cc6677", "#117733", "#882255", "#999933", "#aa4499", "#44aa99", "#88ccee",
    "#ddaa33",
)  # fmt: skip


@dataclass(frozen=True)
class DrawnRegion:
    """What a colouring may look at: the sign vector of a region and its number of sides."""

    signs: tuple[int, ...]
    sides: int


Paint = TypeVar("Paint", bound=Callable[..., str])
Painter: TypeAlias = Callable[[DrawnRegion], str]


def painter(colour: str | Painter) -> Painter:
    """Return the function that colours a region: sides, signs, none, or the given function.

    Raises:
        InputError: a name that is unknown.
    """
    painters: dict[str, Painter] = {
        "sides": lambda region: side_colour(region.sides),
        "signs": lambda region: PALETTE[
            round(5 * region.signs.count(-1) / max(1, len(region.signs)))
        ],
        "none": lambda region: "#ffffff",
    }
    return chosen(colour, painters)


def chosen(colour: str | Paint, painters: Mapping[str, Paint]) -> Paint:
    """Return a colouring by name, or the given function.

    Raises:
        InputError: a name that is unknown.
    """
    if not isinstance(colour, str):
        return colour
    if colour not in painters:
        raise refusal(f"the colouring is {shown(colour)}", colour, painters)
    return painters[colour]


def side_colour(sides: int) -> str:
    """Return the colour of a region by its number of sides."""
    return PALETTE[min(max(sides - 2, 0), 5)]


def plane_colour(label: int) -> str:
    """Return the colour of a class of planes; black when the scheme is exhausted."""
    return PLANE_COLOURS[label] if label < len(PLANE_COLOURS) else "#000000"


def fill_colour(label: int) -> str:
    """Return the colour of the facets of a class of planes; the scheme begins anew when it ends."""
    return PLANE_COLOURS[label % len(PLANE_COLOURS)]


def pale(colour: str, white: float = 0.42) -> str:
    """Return a colour ``#rrggbb`` mixed with a share of white."""
    channels = (int(colour[k : k + 2], 16) for k in (1, 3, 5))
    return "#" + "".join(f"{round(x + (255 - x) * white):02x}" for x in channels)
