"""The poset of regions as a Hasse diagram."""

from __future__ import annotations

from collections import Counter

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import Choice
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import sign_text
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.views import picture
from arrangement.enumeration.regions import distances
from arrangement.numbers.exact import dot
from arrangement.pictures.parts.names import Labels, RegionLabels
from arrangement.planes.faces import Face

from .graph import GraphPicture, PlacedGraph, region_edges

#: This many directions are tried in which rows are sorted.
_TRIED = 60
#: Room for the numbers at the left, in points.
_MARGIN = 22.0


@picture()
def draw_poset(
    arrangement: Arrangement,
    *,
    bottom: str | None = None,
    colour: Choice | None = None,
    labels: Labels | None = None,
    width: float = 120.0,
) -> Scene:
    """Draw the poset of regions with its base at the bottom, as a Hasse diagram.

    A region is as high as planes lie between it and the base; the numbers at the left count the
    regions of each height. Rows are sorted as a zonotope shows them whose edges all rise by one,
    so that most edges across one plane go the same way. Vertices, colours and numbers of planes
    are those of `draw_graph`.

    Elements: ``vertex-3`` and ``edge-7``.

    Args:
        arrangement: any, central or not.
        bottom: the region at the bottom, by signs as ``"++-"`` or by number; if omitted, the one on
            the positive side of all planes where there is one, else region 1.
        colour, labels: as for `draw_sphere`; no labels for more than 150 regions if
            omitted.

    Raises:
        InputError: no such region, too many regions, unknown colouring.
    """
    signs, edges = region_edges(arrangement)
    names = RegionLabels(arrangement, labels)
    positive = (1,) * len(arrangement)
    lowest = names.signs_of(bottom or ("1" if positive not in signs else positive))
    regions = arrangement.regions()
    first = regions[signs.index(lowest)]
    heights = np.array(distances(arrangement, regions, first))
    across, rows = np.empty(len(signs)), Counter(heights.tolist())
    most = max(rows.values())
    sums = _risen(arrangement, first, signs, heights)
    for row, count in rows.items():
        members = np.flatnonzero(heights == row)
        order = members[np.argsort(sums[members], kind="stable")]
        across[order] = (np.arange(count) - (count - 1) / 2) / most
    top = int(heights.max())
    tall = min(1.3, max(0.4, 0.18 * top))
    scene = Scene(width, width * tall)
    number = names.element("region", lowest).removeprefix("region-")
    text = sign_text(lowest) if len(lowest) <= 24 else ""
    scene.legend.line(f"bottom: region {number}, {text}".rstrip(", "))
    graph = PlacedGraph(np.column_stack([across, tall * heights / max(top, 1)]), signs, edges)
    drawn = GraphPicture(arrangement, graph, scene, names, colour, _MARGIN)
    drawn.draw()
    for row, count in rows.items():
        at = (4.0, float(drawn.places[heights == row][0, 1]))
        scene.write(at, str(count), 6.0, anchor=(0.0, 0.5), color="0.25")
    return scene


def _risen(
    arrangement: Arrangement, first: Face, signs: tuple[tuple[int, ...], ...], heights: Floats
) -> Floats:
    """Return how far to the right each region is on a zonotope whose edges all rise by one.

    Its generators are the planes ``(n, -b)``, divided by their values at a point of the base; seen
    from a direction of some in which regions of one height are not near each other.
    """
    point = (*first.witness, 1)
    ways = []
    for plane in arrangement.distinct_planes:
        normal = (*plane[:-1], -plane[-1])
        height = abs(dot(normal, point))
        ways.append([float(x / height) for x in normal])
    sums = np.array(signs)[:, list(arrangement.firsts)] @ np.array(ways)
    steps = np.arange(1, _TRIED + 1)[:, None] * np.log(np.arange(sums.shape[1]) + 2.0)
    seen = sums @ (steps % 1 - 0.5).T
    seen /= np.maximum(np.abs(seen).max(axis=0), 1e-12)
    rows = np.sort(seen + 4.0 * heights[:, None], axis=0)
    gaps = np.diff(rows, axis=0).min(axis=0, initial=1.0)
    chosen: Floats = seen[:, int(np.argmax(np.round(gaps, 9)))]
    return chosen
