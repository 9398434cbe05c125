"""Colours of regions and planes, the same in all views; safe in grey and for the colour-blind."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import cycle
from typing import Annotated, Any, TypeAlias, TypeVar

from arrangement.console.options.signature import Syntax
from arrangement.errors import InputError, refusal
from arrangement.numbers.exact import shown

#: Light to dark, so that the order stays in grey: numbers of sides 2, 3, 4, 5, 6, and more.
PALETTE = ("#ffffff", "#fdf0c0", "#b9dfd3", "#7fb9d8", "#6a96c8", "#8a7fb5")

#: Regions with a common side, never of one colour; the second row for opposite regions.
CHECKERS = (PALETTE[1], PALETTE[3], "#d8a640", "#3f7fae")

COLOURINGS = ("sides", "parity", "signs", "orbits", "none")

#: Inks; the colours are those of Okabe and Ito.
BLACK, GREY, PALE, BLUE, VERMILION = "#000000", "#767676", "#f2f2f2", "#0072b2", "#d55e00"

#: The surface of a ball or cube on its cells.
SKIN = "#f3ead8"

#: For planes, when each has a colour of its own (P. Tol's muted scheme, dark ones first). A number
#: stands beside every use.
PLANE_COLOURS = (
    "#332288",
    "#cc6677",
    "#117733",
    "#882255",
    "#999933",
    "#aa4499",
    "#44aa99",
    "#88ccee",
    "#ddaa33",
)


@dataclass(frozen=True)
class DrawnRegion:
    """What a colouring may look at: the sign vector of a region and its number of sides."""

    signs: tuple[int, ...]
    sides: int


Paint = TypeVar("Paint", bound=Callable[..., str])
Painter: TypeAlias = Callable[[DrawnRegion], str]
#: A name, with own colours after it as in ``sides:white,gold``; own colours; or a function.
Choice: TypeAlias = Annotated[str | Sequence[str] | Painter, Syntax(metavar="NAME")]
#: More orbits than this are counted, not listed.
_LISTED = 12


@dataclass(frozen=True)
class Colouring:
    """A colour for each region, and what a legend says of it.

    Attributes:
        base: the colour of a region, without own colours.
        name: of the colouring; None for a function of one's own.
        own: the colours that replace others.
        orbits: the sizes of the orbits, in the order of their colours.
    """

    base: Painter
    name: str | None
    own: Mapping[str, str] = field(default_factory=dict)
    orbits: Sequence[int] = ()

    def paint(self, region: DrawnRegion) -> str:
        """Return the colour of a region."""
        return self.own_colour(self.base(region))

    def own_colour(self, fill: str) -> str:
        """Return the own colour in place of one of the scheme."""
        return self.own.get(fill, fill)

    def with_own(self, own: Sequence[str], drawn: Sequence[DrawnRegion]) -> Colouring:
        """Return the same with own colours in the order of the legend, again from the first one."""
        fills = dict.fromkeys([fill for fill, _ in self.keys(drawn)] + [*map(self.base, drawn)])
        return replace(self, own=dict(zip(fills, cycle(own), strict=False)) if own else {})

    def keys(self, drawn: Iterable[DrawnRegion]) -> list[tuple[str, str]]:
        """Return fills and what they mean, for the regions that are drawn."""
        return [(self.own_colour(fill), text) for fill, text in self._keys(drawn)]

    def _keys(self, drawn: Iterable[DrawnRegion]) -> list[tuple[str, str]]:
        if self.name == "orbits":
            if len(self.orbits) > _LISTED:
                return []
            texts = [f"orbit of {size}" for size in self.orbits]
            return [(orbit_colour(k), text) for k, text in enumerate(texts)]
        if self.name == "sides":
            numbers = sorted({region.sides for region in drawn} - {0})
            return [(side_colour(k), f"{k} sides" if k > 1 else "1 side") for k in numbers]
        if self.name == "parity":
            return [(CHECKERS[0], "even"), (CHECKERS[1], "odd number of minus signs")]
        groups: dict[str, set[int]] = {}
        for region in drawn if self.name == "signs" else ():
            groups.setdefault(self.base(region), set()).add(region.signs.count(-1))
        entries: list[tuple[str, str]] = []
        for fill, counts in sorted(groups.items(), key=lambda item: min(item[1])):
            low, high = min(counts), max(counts)
            entries.append((fill, f"{low}" if low == high else f"{low}\u2013{high}"))
        if entries:
            entries[-1] = (entries[-1][0], f"{entries[-1][1]} minus signs")
        return entries


def colouring(
    colour: Choice | None,
    regions: Sequence[DrawnRegion],
    pairs: Sequence[tuple[int, int]],
    firsts: Sequence[int],
    orbits: Callable[[], Sequence[int]] | None = None,
) -> Colouring:
    """Return the colouring of a name, or the one that suits an arrangement best.

    Args:
        colour: "sides", "signs", "parity", "orbits", "none", or a function; own colours after a
            name, or alone; or colours of some regions, as in "+-+=gold,++-=#0af". If omitted: the
            number of sides where it distinguishes neighbours, else the parity of minus signs, which
            always does. So two colours are enough for distinct planes.
        regions: all of them.
        pairs: the numbers of regions with a common side.
        firsts: the first plane of each class of coincident ones.
        orbits: returns the number of the orbit of each region, from 0, where that is known.

    Raises:
        InputError: an unknown name or colour.
    """
    if isinstance(colour, str) and "=" in colour:
        colour = _some_regions(colour, regions)
    name, own = read_choice(colour)
    if name is None and len(own) == 1:
        return Colouring(lambda _: own[0], None)
    if name is None:
        apart = all(regions[a].sides != regions[b].sides for a, b in pairs)
        name = "sides" if apart and pairs else "parity"
    orbit_of: dict[tuple[int, ...], int] = {}
    if name == "orbits":
        if orbits is None:
            raise InputError(
                "orbits are those of central planes in R^3 or of full rank; choose another one"
            )
        orbit_of = dict(zip((region.signs for region in regions), orbits(), strict=True))

    painters: dict[str, Painter] = {
        **PAINTERS,
        "parity": lambda region: CHECKERS[sum(region.signs[k] < 0 for k in firsts) % 2],
        "orbits": lambda region: orbit_colour(orbit_of[region.signs]),
    }
    base = painter_of(name, {known: painters[known] for known in COLOURINGS})
    sizes = [number for _, number in sorted(Counter(orbit_of.values()).items())]
    scheme = Colouring(base, name if isinstance(name, str) else None, orbits=sizes)
    return scheme.with_own(own, regions) if own else scheme


def read_choice(
    colour: str | Sequence[str] | Callable[..., str] | None,
) -> tuple[Any, list[str]]:
    """Return the name of a colouring, a function or None; and own colours as ``#rrggbb``.

    Raises:
        InputError: what follows a name is not a colour.
    """
    if colour is None or callable(colour):
        return colour, []
    name, fills = "", list(colour)
    if isinstance(colour, str):
        name, colon, listed = colour.partition(":")
        if not colon and not is_colour(colour.partition(",")[0]):
            return colour, []
        name, listed = (name, listed) if colon else ("", colour)
        fills = listed.split(",")
    return name or None, [hex_colour(text.strip()) for text in fills]


def is_colour(text: str) -> bool:
    """Return whether a text is a colour of matplotlib, by name or as ``#rrggbb``."""
    from matplotlib.colors import is_color_like

    return text not in COLOURINGS and is_color_like(text.strip())


def hex_colour(text: str) -> str:
    """Return a colour by name or ``#rgb`` as ``#rrggbb``, or refuse it."""
    from matplotlib.colors import to_hex

    if not is_colour(text):
        raise InputError(f"{shown(text)} is not a colour; give names or #rrggbb, such as gold,#0af")
    return to_hex(text)


def _some_regions(text: str, regions: Sequence[DrawnRegion]) -> Painter:
    """Return the painter of ``+-+=gold,++-=#0af``: regions by sign vector, the others white."""
    fills: dict[tuple[int, ...], str] = {}
    known = {region.signs for region in regions}
    for part in text.split(","):
        name, _, fill = part.partition("=")
        signs = tuple({"+": 1, "-": -1}.get(sign, 0) for sign in name.strip())
        if signs not in known:
            raise InputError(
                f"the colour of {shown(name)} is given; expected the sign vector of a region that "
                "is drawn, as in +-+=gold"
            )
        fills[signs] = hex_colour(fill)
    return lambda region: fills.get(region.signs, "#ffffff")


#: What colours a region by itself, by the name of its colouring.
PAINTERS: Mapping[str, Painter] = {
    "sides": lambda region: side_colour(region.sides),
    "signs": lambda region: PALETTE[round(5 * region.signs.count(-1) / max(1, len(region.signs)))],
    "none": lambda region: "#ffffff",
}


def painter_of(colour: str | Paint, painters: Mapping[str, Paint]) -> Paint:
    """Return a colouring by name, or the given function.

    Raises:
        InputError: a name that is unknown.
    """
    if not isinstance(colour, str):
        return colour
    if colour not in painters:
        remedy = "expected colours, such as gold or gold,#0072b2, or one of"
        raise refusal(f"the colouring is {shown(colour)}", colour, painters, remedy)
    return painters[colour]


def orbit_colour(orbit: int) -> str:
    """Return the colour of an orbit of regions, by its number."""
    first = (CHECKERS[0], CHECKERS[1], PALETTE[2], CHECKERS[2], PALETTE[5])
    return first[orbit] if orbit < len(first) else pale(plane_colour(orbit - len(first)), 0.4)


def side_colour(sides: int) -> str:
    """Return the colour of a region by its number of sides."""
    return PALETTE[min(max(sides - 2, 0), 5)]


@cache
def plane_colour(label: int) -> str:
    """Return the colour of a class of planes: the scheme, then darker and paler; 36 in all."""
    turn, place = divmod(label % (4 * len(PLANE_COLOURS)), len(PLANE_COLOURS))
    colour = PLANE_COLOURS[place]
    return (colour, darken(colour, 0.6), pale(colour, 0.4), darken(colour, 0.8))[turn]


@cache
def letter_colour(label: int) -> str:
    """Return the colour of a class of planes, dark enough for text on white."""
    return readable(plane_colour(label))


def readable(colour: str) -> str:
    """Return a colour ``#rrggbb``, dark enough for text on white (4.5 to 1, WCAG)."""
    channels = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    weights = 0.2126, 0.7152, 0.0722
    while sum(w * x**2.2 for w, x in zip(weights, channels, strict=True)) > 0.18:
        channels = [0.95 * x for x in channels]
    return "#" + "".join(f"{round(255 * x):02x}" for x in channels)


def darken(colour: str, light: float) -> str:
    """Return a colour ``#rrggbb`` as a share of the light shows it."""
    channels = (int(colour[k : k + 2], 16) for k in (1, 3, 5))
    return "#" + "".join(f"{round(light * x):02x}" for x in channels)


def pale(colour: str, white: float = 0.42) -> str:
    """Return a colour ``#rrggbb`` mixed with a share of white."""
    channels = (int(colour[k : k + 2], 16) for k in (1, 3, 5))
    return "#" + "".join(f"{round(x + (255 - x) * white):02x}" for x in channels)
