"""The symbols of legends, and the legend of regions."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from .colours import GREY, Colouring, DrawnRegion
from .legend import Symbol
from .measuring import POINTS
from .regionlabels import RegionLabels
from .scene import Scene

#: Width and half the height of a symbol, in points.
WIDTH, HALF = 5.5 * POINTS, 1.2 * POINTS


def canvas() -> Scene:
    """Return a scene in which to draw a symbol about the left end of the horizontal axis."""
    return Scene(WIDTH / POINTS, 2 * HALF / POINTS)


def swatch(fill: str, **style: Any) -> Symbol:
    """Return a filled rectangle."""
    scene = canvas()
    corners = [(0, -HALF), (WIDTH, -HALF), (WIDTH, HALF), (0, HALF)]
    scene.polygon(corners, **{"fc": fill, "ec": GREY, "lw": 0.4, **style})
    return scene.items, WIDTH


def stroke(**style: Any) -> Symbol:
    """Return a line."""
    scene = canvas()
    scene.line([(0, 0), (WIDTH, 0)], **style)
    return scene.items, WIDTH


def dot(shape: str, **style: Any) -> Symbol:
    """Return a vertex, "round" or "square"."""
    scene = canvas()
    scene.marker((WIDTH / 2, 0), 2.8, shape, **{"ec": "black", **style})
    return scene.items, WIDTH


def explain_regions(
    scene: Scene, colours: Colouring, names: RegionLabels, drawn: Collection[DrawnRegion]
) -> None:
    """Add to the legend of a scene the colours of the regions drawn, and their numbers."""
    for fill, text in colours.keys(drawn):
        scene.legend.key(swatch(fill, ec="black", lw=0.5), text)
    names.explain(scene.legend, [region.signs for region in drawn])
