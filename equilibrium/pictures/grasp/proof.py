"""The proof that a wrench is not resisted: motions cut into regions, each with a virtual motion."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.colours import BLUE, GREY, VERMILION, pale, plane_colour
from arrangement.drawing.figure import picture
from arrangement.drawing.registry import Exact
from arrangement.drawing.scene.curves import flattened
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import Labels, write_if_free
from arrangement.drawing.scene.places import inside, near
from arrangement.drawing.scene.scene import (
    FONT,
    POINTS,
    Scene,
    arc,
    area,
    arrow,
    checked_width,
    turning_arrow,
)
from arrangement.numbers.exact import RationalVector
from equilibrium.certificate.leaves import ClosedPart, works
from equilibrium.decide.verdict import Verdict
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.parts.panel import ABOVE, BELOW, GAP, LEFT, RIGHT, Panel
from equilibrium.pictures.parts.style import Wrench, symbol
from equilibrium.pictures.space.space_grasp import proof_in_space

from .grasp import GraspPicture
from .layout import MOVED, Layout, shift_at
from .proof_maps import MAP, TURNS, Shape, proof_maps, summary_lines

#: Half the side of the small grasps, where the contacts fill [-1, 1]: with numbers, and without.
_SMALL = (2.1, 1.7)
#: How many virtual motions are shown below the maps, and how many the legend names.
_SHOWN, _NAMED = 3, 9
#: With more contacts there is no room for the work of each.
_WRITTEN = 8
_ARROWS = (
    "below: λ as arrows at the contacts, grey where one has no force, red where its work may be < 0"
)
_EXAMPLES = (
    (_ARROWS, "numbers: the least work of each contact where its normal force is c"),
    (f"{_ARROWS};", f"no room for numbers beyond {_WRITTEN} contacts: a page (.html) has them"),
)


@picture(60.0)
def draw_proof(
    grasp: Grasp, *, wrench: Wrench, rotation: Exact | None = None, width: float = 180.0
) -> Scene:
    """Draw why a wrench is not resisted: regions of motions, and the virtual motion against each.

    A motion (x, y, r) with r != 0 turns the object about (-y/r, x/r). The two maps show these
    centres in the plane of the object, for r > 0 and for r < 0; translations are rotations about
    points at infinity. The regions are those of the certificate, exact, coloured by their virtual
    motions. Where they depend on the size of the motion, the maps show the rotations by one angle.

    Below, the three virtual motions of the largest regions, by their centres and by arrows at the
    contacts; at each contact its least work, as a factor of its normal force.

    Of a grasp in space, up to three leaves of the proof: each virtual motion as a screw, and the
    states of contacts against which it stands.

    Args:
        grasp: contacts.
        wrench: one that is not resisted.
        rotation: the angle r of the rotations shown (linearised), above 0, where it matters; if
            omitted, about the largest one at which a preloaded spring still touches, and no
            boundary.

    Raises:
        GraspError: the wrench is resisted, or a rotation that is not above 0.
    """
    if grasp.dimension == 3:
        if rotation is not None:
            raise GraspError("rotation is for grasps in the plane; leave it out")
        return proof_in_space(grasp, wrench, width)
    maps = proof_maps(grasp, wrench, rotation)
    verdict, ranks = maps.verdict, maps.ranks
    layout = Layout(grasp, verdict)
    width = checked_width(width, 150.0)
    side = (width * POINTS - LEFT - RIGHT - GAP) / 2
    small = 0.6 * side
    scene = Scene(width, (side + small + 2.5 * ABOVE + BELOW) / POINTS)
    low = small + 1.5 * ABOVE + BELOW
    unit = grasp.units.length if grasp.units else ""
    for i, sense in enumerate(TURNS):
        panel = Panel(scene, maps.window, (LEFT + i * (side + GAP), low), side, f"{i + 1}-")
        panel.rulers(("$x$", "$y$"), (unit, unit), left=i == 0)
        panel.title(f"centres of {TURNS[sense]} motions")
        drawn = _grasp(scene, layout, side / 2 / MAP, panel.at((0, 0)), panel.name)
        drawn.labels.avoid(*panel.axes())
        drawn.letter()
        _map(panel, [shape for shape in maps.shapes if shape.sense == sense], ranks, drawn.labels)
    shown = list(ranks)[:_SHOWN]
    for i, motion in enumerate(shown):
        together = [part for part in maps.parts if part.leaf.motion == motion]
        middle = np.array([(2 * i + 1) * scene.width / len(shown), small]) / 2
        _example(scene, layout, verdict, together, (i, middle, small))
    legend = scene.legend
    for line in summary_lines(maps, _NAMED):
        legend.line(line)
    for line in _EXAMPLES[len(grasp) > _WRITTEN]:
        legend.line(line)
    for motion, i in list(ranks.items())[:_NAMED]:
        legend.key(symbol(_fill(i)), f"{i + 1}: λ = {LABEL.vector(motion)}")
    return scene


def _map(
    panel: Panel, shapes: list[Shape], ranks: Mapping[RationalVector, int], labels: Labels
) -> None:
    """Fill the regions, with the number of their virtual motion where there is room."""
    for i, shape in enumerate(sorted(shapes, key=lambda s: -area(s.corners))):
        rank, corners = ranks[shape.part.leaf.motion], panel.at(shape.corners)
        fill, gid, text = _fill(rank), panel.gid("region", i), str(rank + 1)
        if len(corners) > 2:
            panel.scene.polygon(corners, fc=fill, ec="#404040", lw=0.4, gid=gid, zorder=0.3)
            look: dict[str, Any] = {"weight": "bold", "halo": (1.5, "white"), "zorder": 8}
            for off in (labels.off, None):
                free = inside(panel.scene, corners, off)
                if write_if_free(panel.scene, [text], [FONT], free, **look):
                    break
        elif len(corners) == 2 and "stick" in shape.part.states.values():
            panel.scene.line(corners, ec=fill, lw=2, gid=gid, zorder=0.5)


def _fill(rank: int) -> str:
    return pale(plane_colour(rank), 0.6)


def _grasp(scene: Scene, layout: Layout, scale: float, middle: Floats, name: str) -> GraspPicture:
    """Draw the grasp and its load; `name` comes before the names of all elements."""
    drawn, first = GraspPicture(layout, scene, scale, middle), len(scene.items)
    drawn.body()
    drawn.contacts()
    drawn.wrench()
    named = (replace(item, name=item.name and name + item.name) for item in scene.items[first:])
    scene.items[first:] = named
    return drawn


def _example(
    scene: Scene,
    layout: Layout,
    verdict: Verdict,
    together: list[ClosedPart],
    where: tuple[int, Floats, float],
) -> None:
    """Draw the virtual motion of some parts on a small grasp, with the works on it."""
    (i, middle, size), (x, y, r) = where, together[0].leaf.motion
    half, name = _SMALL[len(verdict.grasp) > _WRITTEN], f"{i + 3}-"
    scale = size / 2 / half
    drawn = _grasp(scene, layout, scale, middle, name)
    done = works(verdict.grasp, verdict.wrench, together, verdict.max_displacement)
    load, least, both = map(LABEL.number, (done.load, done.least, done.load + done.least))
    loads = "load and adhesion" if any(verdict.grasp.adhesion_wrench) else "load"
    for k, text in enumerate(
        (f"{i + 1}: {loads} {load}, contacts ≥ {least}", f"together ≥ {both}")
    ):
        place = middle[0], middle[1] + size / 2 + 12 - 9 * k
        scene.text(place, text, weight="normal" if k else "bold")
    shifts = [shift_at((x, y, r), c.point) for c in verdict.grasp]
    largest = max((abs(v) for shift in shifts for v in shift), default=Fraction(0))
    colours = [
        GREY if factor is None else VERMILION if factor < 0 else BLUE for factor in done.factors
    ]
    for k, (shift, start) in enumerate(zip(shifts, drawn.places, strict=True)):
        if any(shift):
            end = start + 2 * MOVED * scale * np.array([float(v / largest) for v in shift])
            look: dict[str, Any] = {"ec": "none", "gid": f"{name}shift-{k + 1}", "zorder": 7}
            edge = arrow(scene, start, end, 1.0, fc=colours[k], **look)
            drawn.labels.avoid(edge)
    if r:
        frame, centre = layout.frame, (-y / r, x / r)
        far = max(abs(v - c) for v, c in zip(centre, frame.centre, strict=True)) / frame.half
        if far < 0.9 * half:
            at, reach = drawn.at(frame.paper(centre)), 0.15 * scale
            turning_arrow(
                scene, at, reach, 1 if r > 0 else -1, color=BLUE, gid=f"{name}centre", zorder=7
            )
            scene.mark(at, "o", 2.5, color=BLUE, zorder=7)
            drawn.labels.avoid(flattened(arc(at, reach, 0, 2 * math.pi)))
    drawn.letter()
    if len(verdict.grasp) <= _WRITTEN:
        drawn.numbers()
        for k, (factor, colour) in enumerate(zip(done.factors, colours, strict=True)):
            text = "no force" if factor is None else f"{LABEL.number(factor)} c"
            places = near(drawn.places[k], -layout.normals[k])
            drawn.labels.write(text, places, color=colour, gid=f"{name}work-{k + 1}")
