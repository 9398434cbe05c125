"""The great circles on the sphere, as a picture: regions coloured, hidden halves dashed."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import Choice
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import SIZES, keep_off, write_if_free
from arrangement.drawing.scene.places import beside
from arrangement.drawing.scene.scene import Scene, arrow
from arrangement.drawing.solids.sight import unit, unit_vectors
from arrangement.drawing.views import Vector
from arrangement.pictures.parts.coordinates import (
    INK,
    REACH,
    AxisNames,
    drawn_axes,
    in_coordinates,
    planes_view,
    within_reach,
)
from arrangement.pictures.parts.names import Labels, RegionLabels, explain_regions

from .disc import HIDDEN, Disc, alone, front
from .globe import Globe
from .projections import orthographic


@planes_view("sphere")
def draw_sphere(
    arrangement: Arrangement,
    *,
    camera: Vector | None = None,
    azimuth: float = 0.0,
    colour: Choice | None = None,
    labels: Labels | None = None,
    axes: AxisNames | None = None,
    sides: bool = False,
    width: float = 88.0,
    coordinates: str | None = None,
) -> Scene:
    """Draw the great circles of central planes in R^3 as seen from a direction.

    The ball is lit from the upper left, from in front; arcs on its far side are dashed. A number
    at the limb names a circle: k for the k-th plane, counted from 1. A label that does not fit
    into its region stands beside it, with a line to a dot inside. Every visible region and every
    arc, cut at the limb, is an element of its own with a name (``region-3``, ``front-7``); so
    is the far half of a circle (``back-2``).

    Args:
        arrangement: central, of rank at most 3; in another space than R^3 its essentialisation.
        camera: exact vector to the viewer; if omitted, one in which no circle is edge-on.
        azimuth: degrees by which the viewer moves to the right.
        colour: "sides" (by number of sides), "parity" (two colours, by number of minus signs),
            "signs" (shades, by number of minus signs), "orbits" (of the symmetry), "none", or a
            function from a `DrawnRegion` to a colour; if omitted, sides if they distinguish
            neighbours, else parity. Your own colours follow the name,
            ``"sides:white,gold,#0072b2"``, or stand alone; or some regions have one,
            ``"+-+=gold,++-=#0af"``, and the others are white.
        labels: of regions: "signs"; "numbers" in the order of `Arrangement.regions`, with a table
            of sign vectors below; "none". If omitted, signs of up to four planes, else numbers,
            with the table for up to 24 regions. For some regions only: these, by sign vector or
            number, ``"+-+,3"``, or with texts, ``"+-+=A,3=B"`` or ``{"+-+": "A", 3: "B"}``.
        axes: names of the axes; True for ``x,y,z``; or "none"; if omitted, there are some
            where the coordinates have a meaning, as x, y, r of the motions of a grasp.
        sides: mark the positive side of each plane by an arrow.
        coordinates: "symmetric": after a linear map that shows the symmetry of the planes and
            changes no sign vector; "even": after one that spreads the normals evenly; "given". If
            omitted, symmetric (nearly parallel planes: even), but for planes of motions and with
            axes.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring.
    """
    names = RegionLabels(arrangement, labels, items="circles")
    shown, coordinates = drawn_axes(arrangement, axes, coordinates)
    arrangement, camera = in_coordinates(coordinates, arrangement, camera)
    globe = Globe(arrangement, camera, azimuth)
    colours = globe.colouring(colour)
    disc = alone(globe, front(globe, orthographic), names, width, solid=True)
    arms, arrows = [], []
    if shown:
        disc = replace(disc, radius=within_reach(globe.axes.T, disc.scene.width / 2, disc.radius))
        arms = [_axis(disc, k) for k in range(3)]
        disc.scene.circle(disc.centre, 1.0, fc=INK, ec="none", zorder=2.5, gid="origin")
    if sides:
        arrows = [_side(disc, c) for c in range(globe.whole.circle_count)]
    lines = disc.draw(colours.paint, avoid=[*arms, *arrows])
    off = keep_off(lines)
    for name, (_, tip) in zip(shown, arms, strict=True):
        places = beside(tip, away=tip - np.array(disc.centre), distance=2.0)
        write_if_free(disc.scene, [name], SIZES[:2], places, off=off, style="italic")
    explain_regions(disc.scene, colours, names, globe.front.values())
    return disc.scene


def _axis(disc: Disc, k: int) -> Floats:
    """Draw a coordinate axis from the origin, dashed where the ball hides it; return its ends."""
    way = disc.globe.axes[:, k]
    tip = disc.on_paper(REACH * way[:2])
    flat = float(np.linalg.norm(way[:2]))
    # In front it leaves the ball where it meets it, else where it passes the limb.
    out = 1.0 if way[2] > 0 else 1 / max(flat, 1e-9)
    start = disc.on_paper(min(out, REACH) * way[:2])
    hidden = {**HIDDEN, "zorder": 2.2, "gid": f"axis-{k + 1}-hidden"}
    disc.scene.line([disc.centre, start], ec=INK, **hidden)
    if out < REACH:
        look: dict[str, Any] = {"fc": INK, "ec": "none", "role": "axis", "zorder": 3.5}
        arrow(disc.scene, start, tip, 0.6, gid=f"axis-{k + 1}", **look)
    return np.array([disc.centre, tip])


def _side(disc: Disc, circle: int) -> Floats:
    """Draw an arrow to the positive side of a circle, off its crossings; return its ends."""
    sphere, axes = disc.globe.whole, disc.globe.axes
    normal = axes @ unit_vectors([sphere.arrangement.distinct_planes[circle][:3]])[0]
    near = unit(np.array([0.0, 0.0, 1.0]) - normal[2] * normal)
    along = np.cross(normal, near)
    vertices = disc.globe.points
    spots = [math.cos(t) * near + math.sin(t) * along for t in np.arange(-9, 10) * 0.1]
    clear = [round(float(np.linalg.norm(vertices - p, axis=1).min(initial=9.0)), 6) for p in spots]
    foot = spots[int(np.argmax(clear))]
    tip = math.cos(0.1) * foot + math.sin(0.1) * normal
    ends = disc.on_paper(np.array([foot[:2], tip[:2]]))
    name = f"side-{sphere.arrangement.firsts[circle] + 1}"
    arrow(disc.scene, ends[0], ends[1], 0.55, fc="black", ec="none", zorder=3.5, gid=name)
    return ends
