"""The great circles on the sphere, as a picture: regions coloured, hidden halves dashed."""

from __future__ import annotations

import numpy as np

from arrangement.arrangement import Arrangement

from .colours import DrawnRegion, Painter, painter
from .disc import Disc, alone, front, key_entries
from .equalize import evened
from .essential import shown_as
from .figure import picture
from .globe import Floats, Globe
from .labels import flattened, write_inside
from .projections import orthographic
from .registry import Vector
from .scene import Scene


@picture
@shown_as("sphere")
def draw_sphere(
    arrangement: Arrangement,
    *,
    direction: Vector | None = None,
    colour: str | Painter = "sides",
    width: float = 88.0,
    even: bool = False,
) -> Scene:
    """Draw the great circles of central planes in R^3 as seen from a direction.

    A number at the limb names a circle: k for the k-th plane, counted from 1. Sign vectors stand
    where they fit. Every visible region and every arc, cut at the limb, is an element of its own
    with a name (``region-3``, ``front-7``, ``back-9``).

    Args:
        arrangement: central, of rank at most 3; in another space than R^3 its essentialisation.
        direction: exact, towards the viewer; if omitted, one in which no circle is edge-on.
        colour: "sides" (by number of sides), "signs" (by number of minus signs), "none", or a
            function from a `DrawnRegion` to a colour.
        width: of the figure, in millimetres.
        even: draw the planes after a linear map that spreads their normals evenly and changes no
            sign vector (see `equalize.evened`); the direction counts after it.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring.
        MissingExtraError: matplotlib is absent.
    """
    paint = painter(colour)
    arrangement = evened(arrangement) if even else arrangement
    globe = Globe(arrangement, direction)
    disc = alone(globe, front(globe, orthographic), colour, width)
    hidden = _hidden(disc)
    outlines = disc.draw_curves(paint)
    _signs(disc.scene, outlines, hidden, paint)
    disc.scene.keys(14.0, key_entries(colour, [region for region, _ in outlines], paint))
    return disc.scene


def _hidden(disc: Disc) -> Floats:
    """Draw the arcs on the far side, dashed; return points along them."""
    globe, found = disc.globe, [np.empty((0, 2))]
    for arc, circle in enumerate(disc.drawn.sphere.incidence.arc_circle.tolist()):
        if circle != globe.limb and globe.cut.arc_signs(arc)[-1] < 0:
            curve = disc.on_paper(disc.drawn.arc(arc))
            style = {"lw": 0.45, "ls": (0, (3, 3)), "alpha": 0.45, "zorder": 2}
            disc.scene.curve(curve, fill=False, ec="black", gid=f"back-{arc}", **style)
            found.append(flattened(curve))
    return np.concatenate(found)


def _signs(
    scene: Scene, outlines: list[tuple[DrawnRegion, Floats]], hidden: Floats, paint: Painter
) -> None:
    """Write sign vectors off the hidden arcs; where there is no such room, on a halo."""
    for region, outline in outlines:
        low, high = outline.min(axis=0), outline.max(axis=0)
        near = hidden[((hidden > low) & (hidden < high)).all(axis=1)]
        if not write_inside(scene, outline, region.signs, (7.0, 6.0), other=near):
            write_inside(scene, outline, region.signs, halo=(2.0, paint(region)))
