"""Planes as lines of the projective plane: a chart with its line at infinity as the rim."""

from __future__ import annotations

import math

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.exact import IntegerVector

from .colours import Painter
from .coordinates import in_coordinates, symmetry
from .disc import alone, front, plane_names
from .essential import shown_as
from .figure import picture
from .globe import Globe, best_direction, unit_vectors
from .items import Floats
from .measuring import checked_width
from .projections import Chart, Drawn, StraightChart, orthographic
from .regionlabels import RegionLabels
from .registry import Vector
from .scene import Scene
from .symbols import explain_regions

_BOTH_ENDS = 16


@picture
@shown_as("gnomonic")
def draw_gnomonic(
    arrangement: Arrangement,
    *,
    direction: Vector | None = None,
    colour: str | Painter | None = None,
    antipodes: str | None = None,
    labels: str | None = None,
    width: float = 88.0,
    coordinates: str | None = None,
) -> Scene:
    """Draw central planes in R^3 as lines of the projective plane.

    The sphere is projected from its centre to the plane that touches it at the given direction,
    so that great circles become lines of this chart. The rim is the line at infinity; the two
    ends of a line are one point, and a region that reaches the rim goes on at the opposite part
    of it, with all signs changed.

    Lines are straight up to the rim when no two of them are parallel and no crossing is far away.
    Otherwise the chart is to scale inside a thin dotted circle only. Outside it distances are
    compressed: each line bends to the point of the rim in its own direction, and parallel lines
    meet there.

    Every region of the chart and every arc is an element of its own (``region-3``, ``front-7``,
    ``limb-2``). A number names a line, at both of its ends where there are few: k for the k-th
    plane, counted from 1. If a plane is itself at infinity, the rim is drawn thick, and the note
    says so.

    Args:
        arrangement: central, of rank at most 3; in another space than R^3 its essentialisation.
        direction: the exact direction of the middle; if omitted, one in which all rays stay far
            from infinity; of more than six planes an axis of most symmetries, if there is one.
        colour, antipodes, labels: as for `draw_sphere`.
        width: of the figure, in millimetres.
        coordinates: "symmetric": after a linear map that shows the symmetry of the planes and
            changes no sign vector; "even": after one that spreads the normals evenly; "given". If
            omitted, symmetric (narrow planes: even), but for planes of motions.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring.
        MissingExtraError: matplotlib is absent.
    """
    width = checked_width(width)
    names = RegionLabels(arrangement, labels)
    arrangement, direction = in_coordinates(coordinates, arrangement, direction)
    globe = Globe(arrangement, direction)
    if direction is None:
        globe = Globe(arrangement, _central_direction(globe))
    colours = globe.colouring(colour, antipodes)
    disc = alone(globe, _chart(globe), names, width)
    dotted = []
    if isinstance(disc.drawn.projection, Chart):
        inner = disc.drawn.projection.inner
        style = {"lw": 0.5, "ls": (0, (1, 2)), "zorder": 2, "gid": "to-scale", "role": "line"}
        disc.scene.circle(disc.centre, disc.radius * inner, fill=False, ec="black", **style)
        at = np.linspace(0, 2 * math.pi, 200)
        dotted = [disc.on_paper(inner * np.stack([np.cos(at), np.sin(at)], axis=1))]
    disc.draw(colours.paint, both_ends=globe.whole.circle_count <= _BOTH_ENDS, avoid=dotted)
    explain_regions(disc.scene, colours, names, globe.front.values())
    disc.scene.legend.line(_note(globe))
    return disc.scene


def _note(globe: Globe) -> str:
    members = globe.cut.arrangement.distinct[globe.limb]
    names = plane_names(members, len(globe.whole.arrangement))
    if not names:
        return "rim: the line at infinity; signs up to a common change"
    many = "planes" if len(members) > 2 else "plane"
    return f"rim: the line at infinity, {many} {names}; signs up to a common change"


def _chart(globe: Globe) -> Drawn:
    """Return straight lines where they show everything, else the compressed chart."""
    inside = globe.points[globe.points[:, 2] > 1e-9]
    places = inside[:, :2] / inside[:, 2:]
    incidence, limb = globe.cut.incidence, globe.limb
    at_rim = [len(incidence.circles_at(v)) for v in incidence.crossings(limb).tolist()]
    if not len(places):
        places = np.zeros((1, 2))
    middle = (places.min(axis=0) + places.max(axis=0)) / 2
    distances = np.sort(np.linalg.norm(places - middle, axis=1))
    typical, farthest = float(distances[(len(distances) - 1) // 2]), float(distances[-1])
    if max(at_rim, default=2) == 2 and farthest <= 5 * typical + 1e-9:
        chart = Drawn(globe.cut, globe.points, globe.normals, orthographic)
        reach = max(1.35 * farthest, *_distances(globe, middle))
        return StraightChart(**vars(chart), limb=limb, middle=middle, reach=reach)
    spans = np.linalg.norm(places, axis=1)
    reach = 1.15 * min(float(spans.max()), 4 * float(np.median(spans)) + 0.2)
    return front(globe, Chart(max(reach, *_distances(globe, np.zeros(2)))))


def _distances(globe: Globe, middle: Floats) -> tuple[float, ...]:
    """Return reaches that are enough for no line to pass by near the rim or beyond it."""
    found = [0.5]
    for circle, (a, b, c) in enumerate(globe.normals.tolist()):
        if circle != globe.limb:
            found.append(1.3 * abs(c + a * middle[0] + b * middle[1]) / math.hypot(a, b))
    return tuple(found)


#: So many lines leave enough room in the middle from everywhere.
_OPEN = 6


def _central_direction(globe: Globe) -> IntegerVector:
    """Return where the farthest ray is nearest, on few planes; or the axis of most symmetries.

    Many symmetric planes crowd in the middle unless it is such an axis.
    """
    arrangement = globe.whole.arrangement
    rays = [globe.whole.ray(v) for v in range(globe.whole.vertex_count)]
    if len(rays) <= 2:
        return globe.direction
    lines = unit_vectors(rays)
    found = symmetry(arrangement) if globe.whole.circle_count > _OPEN else None
    if found is not None:
        kept = found.stabilizers(lines)
        inside = np.sort(np.abs(lines @ lines.T), axis=1)
        # Of equal ones that from which the rays that are not at infinity are nearest.
        nearest = np.where(inside > 1e-6, inside, 1.0).min(axis=1).round(6)
        best = max(range(len(rays)), key=lambda v: (kept[v], nearest[v], rays[v]))
        if kept[best] > 2:
            return max(rays[best], tuple(-x for x in rays[best]))
    return best_direction(arrangement, lambda units: np.abs(units @ lines.T).min(axis=1))
