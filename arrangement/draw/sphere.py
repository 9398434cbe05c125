"""The great circles on the sphere, as a picture: regions coloured, hidden halves dashed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from arrangement.arrangement import Arrangement

from .colours import DrawnRegion, Painter, painter
from .disc import Disc, front, has_key, key_entries, rim_width
from .equalize import evened
from .globe import Floats, Globe
from .labels import flattened, write_inside
from .projections import orthographic
from .sheet import Sheet, checked_width

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw_sphere(
    arrangement: Arrangement,
    *,
    direction: Sequence[object] | None = None,
    colour: str | Painter = "sides",
    width: float = 88.0,
    even: bool = False,
) -> Figure:
    """Draw the great circles of central planes in R^3 as seen from a direction.

    A number at the limb names a circle: k for the k-th plane, counted from 1. Sign vectors stand
    where they fit. Every visible region and every arc, cut at the limb, is an element of its own
    with a name (``region-3``, ``front-7``, ``back-9``).

    Args:
        arrangement: central, in R^3, any rank.
        direction: exact, towards the viewer; left out, one in which no circle is edge-on.
        colour: "sides" (by number of sides), "signs" (by number of minus signs), "none", or a
            function from a `DrawnRegion` to a colour.
        width: of the figure, in millimetres.
        even: draw the planes after a linear map that spreads their normals evenly and changes no
            sign vector (see `evening.evened`); the direction counts after it.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring.
        MissingExtraError: matplotlib is absent.
    """
    paint, width = painter(colour), checked_width(width)
    arrangement = evened(arrangement) if even else arrangement
    globe = Globe(arrangement, direction)
    sheet = Sheet(width, width + (5.0 if has_key(colour) else 0.0))
    centre = (sheet.width / 2, sheet.height - sheet.width / 2)
    radius = sheet.width / 2 - rim_width(sheet, globe)
    disc = Disc(sheet, centre, radius, globe, front(globe, orthographic))
    hidden = _hidden(disc)
    outlines = disc.draw_curves(paint)
    _signs(sheet, outlines, hidden, paint)
    sheet.keys(14.0, key_entries(colour, [region for region, _ in outlines], paint))
    return sheet.figure


def _hidden(disc: Disc) -> Floats:
    """Draw the arcs on the far side, dashed; return points along them."""
    globe, found = disc.globe, [np.empty((0, 2))]
    for arc, circle in enumerate(disc.drawn.sphere.incidence.arc_circle.tolist()):
        if circle != globe.limb and globe.cut.arc_signs(arc)[-1] < 0:
            curve = disc.on_paper(disc.drawn.arc(arc))
            style = {"lw": 0.45, "ls": (0, (3, 3)), "alpha": 0.45, "zorder": 2}
            disc.sheet.curve(curve, fill=False, ec="black", gid=f"back-{arc}", **style)
            found.append(flattened(curve))
    return np.concatenate(found)


def _signs(
    sheet: Sheet, outlines: list[tuple[DrawnRegion, Floats]], hidden: Floats, paint: Painter
) -> None:
    """Write sign vectors off the hidden arcs; where there is no such room, on a halo."""
    import matplotlib.patheffects as effects

    for region, outline in outlines:
        low, high = outline.min(axis=0), outline.max(axis=0)
        near = hidden[((hidden > low) & (hidden < high)).all(axis=1)]
        if not write_inside(sheet, outline, region.signs, (7.0, 6.0), other=near):
            halo = effects.withStroke(linewidth=2.0, foreground=paint(region))
            write_inside(sheet, outline, region.signs, path_effects=[halo])
