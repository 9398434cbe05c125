"""Planes as lines of the projective plane, in a chart that touches the sphere."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.drawing.colours import Choice
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.solids.sight import best_view, picture_axes, unit_vectors, views
from arrangement.drawing.views import Vector
from arrangement.errors import extra
from arrangement.numbers.exact import IntegerVector, dot, reduced, unoriented
from arrangement.numbers.linear.rank import cross
from arrangement.pictures.parts.coordinates import in_coordinates, planes_view, symmetry
from arrangement.pictures.parts.names import Labels, RegionLabels, explain_regions, plane_names

from .disc import alone
from .globe import Globe, far_direction
from .projections import CutChart, Drawn, orthographic

_BOTH_ENDS = 16


@planes_view("gnomonic")
def draw_gnomonic(
    arrangement: Arrangement,
    *,
    camera: Vector | None = None,
    colour: Choice | None = None,
    labels: Labels | None = None,
    width: float = 88.0,
    coordinates: str | None = None,
) -> Scene:
    """Draw central planes in R^3 as lines of the projective plane.

    The sphere is projected from its centre to the plane that touches it at the given direction,
    so that great circles become straight lines of this chart. The picture is a disc of it with
    most crossings; what is farther out is left out, and the legend says how much.

    Every region of the chart and every arc is an element of its own (``region-3``, ``front-7``).
    A number names a line, at both of its ends where there are few: k for the k-th plane, counted
    from 1.

    Args:
        arrangement: central, of rank at most 3; in another space than R^3 its essentialisation.
        camera: the exact direction of the middle; if omitted, one in which all rays stay far
            from infinity; of more than six planes an axis of most symmetries, if there is one, else
            one in which the crossings spread evenly.
        colour, labels: as for `draw_sphere`.
        coordinates: as for `draw_sphere`.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring.
    """
    names = RegionLabels(arrangement, labels, items="lines")
    arrangement, camera = in_coordinates(coordinates, arrangement, camera)
    globe = Globe(arrangement, camera)
    if camera is None:
        globe = _upright(Globe(arrangement, _central_direction(globe)))
    colours = globe.colouring(colour)
    chart = _cut(globe)
    disc = alone(globe, chart, names, width)
    disc.draw(colours.paint, both_ends=globe.whole.circle_count <= _BOTH_ENDS)
    shown = [r for piece, r in globe.front.items() if len(chart.outline(piece))]
    explain_regions(disc.scene, colours, names, shown)
    disc.scene.circle(disc.centre, disc.radius, fill=False, ec="black", lw=0.6, gid="border")
    whole = globe.whole.arrangement
    seen = {k for c, x in enumerate(whole.distinct) if chart.ends(c) for k in x}
    out = [k for k in range(len(whole)) if k not in seen]
    what = [f"line{'s' * (len(out) > 1)} {plane_names(out)}"] * bool(out)
    what += [counted(len(globe.front) - len(shown), "region")] * (len(shown) < len(globe.front))
    disc.scene.legend.captions += [f"farther out: {', '.join(what)}"] * bool(what)
    disc.scene.legend.line("signs up to a common change")
    return disc.scene


def _cut(globe: Globe) -> CutChart:
    """Return the chart around most crossings: all of them, where none is far away."""
    inside = globe.points[globe.points[:, 2] > 1e-9]
    spans = np.linalg.norm(inside[:, :2] / inside[:, 2:], axis=1)
    gaps = [abs(c) / np.hypot(a, b) for a, b, c in globe.normals.tolist() if abs(c) < 1 - 1e-9]
    nearest = float(min(gaps, default=0.0))
    farthest = float(spans.max(initial=nearest))
    typical = float(np.quantile(spans, 0.75)) if len(spans) else nearest
    reach = max(0.5, 1.3 * farthest if farthest <= 3 * typical else 1.2 * typical)
    chart = Drawn(globe.cut, globe.points, globe.normals, orthographic)
    return CutChart(**vars(chart), limb=globe.limb, reach=reach)


def _upright(globe: Globe) -> Globe:
    """Turn the picture so that the first line through the middle, if there is one, is upright."""
    normals = unit_vectors(globe.whole.circle_normals) @ globe.axes.T
    for x, y, z in normals.tolist():
        if abs(z) < _AT_LIMB:
            right = (x * globe.axes[0] + y * globe.axes[1]) / math.copysign(math.hypot(x, y), x)
            globe.axes = np.array([right, np.cross(globe.axes[2], right), globe.axes[2]])
            break
    return globe


#: This many lines leave enough room in the middle from everywhere.
_OPEN = 6
#: Rays so near to the limb are meant to lie on it: coordinates are rounded.
_AT_LIMB = 1e-3


def _central_direction(globe: Globe) -> IntegerVector:
    """Return where the farthest ray is nearest, on few planes; or where the rays spread evenly.

    Many symmetric planes are seen along an axis of most symmetries.
    """
    arrangement = globe.whole.arrangement
    rays = sorted({unoriented(globe.whole.ray(v)) for v in range(globe.whole.vertex_count)})
    if len(rays) < 2:
        return globe.direction
    lines = unit_vectors(rays)
    inside = np.abs(lines @ lines.T)
    if globe.whole.circle_count <= _OPEN:
        ray = best_view(rays, lambda seen: np.abs(unit_vectors(seen) @ lines.T).min(axis=1))
        far = far_direction(arrangement, lines)
        at_ray, at_far = np.abs(unit_vectors([ray, far]) @ lines.T).min(axis=1)
        return ray if at_ray > 0.98 * at_far else far
    found = symmetry(arrangement)
    if found is not None:
        kept = found.stabilizers(lines)
        # Of equal ones that from which the rays that are not at infinity are nearest.
        nearest = np.where(inside > _AT_LIMB, inside, 1.0).min(axis=1).round(3)
        best = max(range(len(rays)), key=lambda v: (kept[v], nearest[v], rays[v]))
        if kept[best] > 2:
            return _along(rays[best], [rays[v] for v in np.flatnonzero(inside[best] < _AT_LIMB)])
    halves = [v for v in views(*[range(-3, 4)] * 3) if v == unoriented(v)]
    return best_view(halves, lambda seen: [_evenness(picture_axes(v), lines) for v in seen])


def _along(ray: IntegerVector, others: Sequence[IntegerVector]) -> IntegerVector:
    """Return a direction near a ray on whose limb the others lie, which are nearly there."""
    for one, two in combinations(others, 2):
        normal = reduced(cross(one, two))
        return normal if dot(normal, ray) > 0 else reduced(cross(two, one))
    return reduced(cross(others[0], cross(ray, others[0]))) if others else ray


def _evenness(axes: Floats, lines: Floats) -> float:
    """Return how far apart, in the mean of logarithms, rays are in the chart with these axes."""
    with extra("figures"):
        from scipy.spatial import KDTree

    points = lines @ axes.T
    points = np.where(points[:, 2:] < 0, -points, points)
    front = points[points[:, 2] > 1e-9]
    spans = np.linalg.norm(front[:, :2] / front[:, 2:], axis=1)
    places = compressed(points, max(0.3, float(np.quantile(spans, 0.7))))
    gaps = KDTree(places).query(places, k=2)[0][:, 1]
    return round(float(np.log(gaps + 0.005).mean()), 6)


def compressed(points: Floats, reach: float, inner: float = 0.7) -> Floats:
    """Return places in a disc of unit vectors (k, 3) in front of the limb, infinity at the rim.

    Within `reach` of the middle the chart is to scale. Beyond it, distance from the middle is
    compressed; directions are kept.

    Args:
        reach: where the compression begins; in radii of the sphere.
        inner: the part of the disc's radius that is to scale.
    """
    outward = np.linalg.norm(points[:, :2], axis=1)
    safe = np.maximum(outward, 1e-12)
    slope = points[:, 2] / safe  # 1 / (distance from the middle of the chart)
    rate = inner / (reach * (1 - inner))
    low = np.minimum(slope, 1 / reach)  # nearer ones are to scale
    far = 1 - (1 - inner) * low / (low + rate * (1 - reach * low))
    near = outward / np.maximum(points[:, 2], 1e-12) * inner / reach
    radius = np.where(slope * reach > 1, near, far)
    placed: Floats = points[:, :2] * (radius / safe)[:, None]
    return placed
