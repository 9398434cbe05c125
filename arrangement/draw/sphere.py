"""The great circles on the sphere, as a picture: regions coloured, hidden halves dashed."""

from __future__ import annotations

from arrangement.arrangement import Arrangement

from .colours import Painter
from .disc import alone, front
from .equalize import evened
from .essential import shown_as
from .figure import picture
from .footer import Footer
from .globe import Globe
from .projections import orthographic
from .regionlabels import RegionLabels
from .registry import Vector
from .scene import Scene, checked_width


@picture
@shown_as("sphere")
def draw_sphere(
    arrangement: Arrangement,
    *,
    direction: Vector | None = None,
    colour: str | Painter | None = None,
    antipodes: str | None = None,
    labels: str | None = None,
    width: float = 88.0,
    even: bool = False,
) -> Scene:
    """Draw the great circles of central planes in R^3 as seen from a direction.

    The ball is lit from the upper left, from in front; arcs on its far side are dashed. A number
    at the limb names a circle: k for the k-th plane, counted from 1. A label that does not fit
    into its region stands beside it, with a line to a dot inside. Every visible region and every
    arc, cut at the limb, is an element of its own with a name (``region-3``, ``front-7``,
    ``back-9``).

    Args:
        arrangement: central, of rank at most 3; in another space than R^3 its essentialisation.
        direction: exact, towards the viewer; if omitted, one in which no circle is edge-on.
        colour: "sides" (by number of sides), "parity" (two colours, by number of minus signs),
            "signs" (shades, by number of minus signs), "none", or a function from a `DrawnRegion`
            to a colour; if omitted, sides if they tell neighbours apart, else parity.
        antipodes: "same" or "opposite" colours for opposite regions (see `colours.colouring`); if
            omitted, whatever two colours give.
        labels: of regions: "signs"; "numbers" in the order of `Arrangement.regions`, with a table
            of sign vectors below; "none". If omitted, signs of up to four planes, else numbers.
        width: of the figure, in millimetres.
        even: draw the planes after a linear map that spreads their normals evenly and changes no
            sign vector (see `equalize.evened`); the direction counts after it.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring.
        MissingExtraError: matplotlib is absent.
    """
    width = checked_width(width)
    arrangement = evened(arrangement) if even else arrangement
    globe = Globe(arrangement, direction)
    colours, names = globe.colouring(colour, antipodes), RegionLabels(arrangement, labels)
    footer = Footer(colours, names, list(globe.front.values()))
    disc = alone(globe, front(globe, orthographic), footer, width, solid=True)
    disc.draw(colours.paint)
    footer.write(disc.scene, disc.scene.height - disc.scene.width)
    return disc.scene
