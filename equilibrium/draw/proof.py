"""The proof that a wrench is not resisted: motions cut into regions, each with a virtual motion."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from arrangement.draw.colours import BLUE, GREY, VERMILION, fill_colour, pale
from arrangement.draw.figure import picture
from arrangement.draw.registry import Exact, Wrench
from arrangement.draw.scene import POINTS, Floats, Scene, area, checked_width
from arrangement.exact import IntegerVector, RationalVector, primitive, rational
from arrangement.polyhedra.cones import generators
from arrangement.polyhedra.polyhedron import Polyhedron, from_conditions
from equilibrium.certificate.leaves import Part, parts, works
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.solver.contact_rows import negated, normal_force_row, slip_row
from equilibrium.verdict import Verdict, solve

from .grasp import Picture
from .layout import MOVED, Layout, layout_of
from .panel import ABOVE, BELOW, LEFT, Panel
from .row import GAP, RIGHT, new_legend
from .shapes import Labels, arrow, turning_arrow
from .style import nice, number, rounded, vector
from .window import Window, roomiest

#: Half the side of the maps, and of the small grasps, where the contacts fill [-1, 1].
_MAP, _SMALL = 3, 2.5
#: How many parts are shown beside the map, and how many virtual motions the legend names.
_SHOWN, _NAMED = 3, 9
_TURNS = {1: "counter-clockwise", -1: "clockwise"}


class _Shape(NamedTuple):
    """A part of the motions where it meets the rotations of one sense: a polygon of centres."""

    part: Part
    sense: int
    corners: Floats


@picture
def draw_proof(
    grasp: Grasp, *, wrench: Wrench, turn: Exact | None = None, width: float = 180.0
) -> Scene:
    """Draw why a wrench is not resisted: regions of motions, and the virtual motion against each.

    A motion (x, y, r) with r != 0 turns the object about (-y/r, x/r). The two maps show these
    centres in the plane of the object, for r > 0 and for r < 0; translations are rotations about
    points at infinity. The regions are those of the certificate, exact, coloured by their virtual
    motions. Where they depend on the size of the motion, the maps show the rotations by one angle.

    Below, the three virtual motions of the largest regions, by their centres and by arrows at the
    contacts; at each contact its least work, as a factor of its normal force.

    Args:
        grasp: contacts.
        wrench: one that is not resisted.
        turn: the angle r of the rotations shown (linearised), above 0, where it matters; if
            omitted, about the largest one at which a preloaded spring still touches, and no border.
        width: of the figure, in millimetres.

    Raises:
        GraspError: the wrench is resisted, or a turn that is not above 0.
        MissingExtraError: matplotlib is absent.
    """
    verdict = solve(grasp, read_wrench(wrench))
    if verdict.stable:
        raise GraspError(
            "the wrench is resisted, so no proof refutes it; the view grasp shows what balances it"
        )
    layout = layout_of(grasp, verdict, None, 1)
    found = list(parts(verdict.certificate.to_dict()))
    angle = _angle(layout, found, turn)
    window = Window(layout.frame.centre, _MAP * layout.frame.size)
    shapes = [
        _Shape(part, sense, corners)
        for part in found
        for sense in _TURNS
        if (centres := _centres(part, grasp, sense, angle)) is not None
        and (corners := window.inside(centres)) is not None
    ]
    sizes: dict[RationalVector, float] = {part.leaf.motion: 0.0 for part in found}
    for shape in shapes:
        sizes[shape.part.leaf.motion] += area(shape.corners)
    ranks = {motion: i for i, motion in enumerate(sorted(sizes, key=lambda m: -sizes[m]))}
    legend = new_legend(checked_width(width, 150.0))
    for line in _lines(verdict, found, ranks, angle):
        legend.line(line)
    for motion, i in list(ranks.items())[:_NAMED]:
        legend.key(_fill(i), f"{i + 1}: λ = {vector(motion)}")
    side = (legend.width - LEFT - RIGHT - GAP) / 2
    small = 0.6 * side
    scene = Scene(width, (side + small + 2.5 * ABOVE + BELOW + legend.height) / POINTS)
    low = legend.height + small + 1.5 * ABOVE + BELOW
    unit = grasp.units.length if grasp.units else ""
    for i, sense in enumerate(_TURNS):
        panel = Panel(scene, window, (LEFT + i * (side + GAP), low), side, f"{i + 1}-")
        panel.rulers(("$x$", "$y$"), unit, left=i == 0)
        panel.title(f"centres of {_TURNS[sense]} motions")
        drawn = _grasp(scene, layout, side / 2 / _MAP, panel.at((0, 0)), panel.name)
        _map(panel, [shape for shape in shapes if shape.sense == sense], ranks, drawn.labels)
    shown = list(ranks)[:_SHOWN]
    for i, motion in enumerate(shown):
        together = [part for part in found if part.leaf.motion == motion]
        middle = np.array([(2 * i + 1) * scene.width / len(shown), 2 * legend.height + small]) / 2
        _example(scene, layout, verdict, together, (i, middle, small))
    legend.draw(scene)
    return scene


def _angle(layout: Layout, found: list[Part], turn: Exact | None) -> Fraction | None:
    """Return the rotation to be shown; None if regions do not depend on the size of motions."""
    if turn is not None:
        angle = rational(turn, "turn")
        if angle <= 0:
            raise GraspError(f"turn is {angle}; it must be above 0")
        return angle
    plain = all(g[0] == 0 or not any(g[1:]) for part in found for g in part.region)
    if plain and not any(layout.grasp.contacts[i].preload for part in found for i in part.states):
        return None
    reach = max((c.preload / c.stiffness for c in layout.grasp), default=Fraction(0))
    wanted = reach / layout.frame.size or Fraction(1)
    near = rounded(wanted)
    angle = nice(near) if near and math.isfinite(near) else wanted
    rows = (row for part in found for row, _ in _conditions(part, layout.grasp))
    borders = {Fraction(abs(zero), abs(r)) for x, y, r, zero in rows if r and not (x or y)}
    while angle in borders:
        angle *= Fraction(9, 10)
    return angle


def _conditions(part: Part, grasp: Grasp) -> Iterator[tuple[IntegerVector, bool]]:
    """Yield rows ``a . (x, y, r, d_0) >= 0`` of a part, and whether ``= 0`` is meant instead."""
    for zero, *row in generators(part.region, (), 4)[0]:
        yield (*row, zero), False
    for i, state in part.states.items():
        spring, slip = normal_force_row(grasp.contacts[i]), slip_row(grasp.contacts[i])
        yield primitive(negated(spring) if state == "detached" else spring), False
        if state not in ("detached", "attached"):
            yield primitive(negated(slip) if state == "slip-" else slip), state == "stick"


def _centres(part: Part, grasp: Grasp, sense: int, angle: Fraction | None) -> Polyhedron | None:
    """Return the centres of the rotations of a part, of one sense and angle."""
    rows: dict[bool, list[IntegerVector]] = {False: [], True: []}
    for (x, y, r, zero), equal in _conditions(part, grasp):
        constant = sense * r + (zero / angle if angle else 0)
        if any(row := primitive((-sense * y, sense * x, constant))):
            rows[equal].append(row)
    return from_conditions(rows[False], rows[True], 2)


def _map(
    panel: Panel, shapes: list[_Shape], ranks: dict[RationalVector, int], labels: Labels
) -> None:
    """Fill the regions, with the number of their virtual motion where there is room."""
    for i, shape in enumerate(sorted(shapes, key=lambda s: -area(s.corners))):
        rank, corners = ranks[shape.part.leaf.motion], panel.at(shape.corners)
        fill, gid, text = _fill(rank), panel.gid("region", i), str(rank + 1)
        if len(corners) > 2:
            panel.scene.polygon(corners, fc=fill, ec="#404040", lw=0.4, gid=gid, zorder=0.3)
            half = panel.scene.measure(text)[0] / panel.side + 0.02, 9 / panel.side
            place, room = roomiest(shape.corners, half, 1)
            if room > 1:
                others = (place + shape.corners) / 2 if room > 2 else []
                at = labels.place(text, [panel.at(other) for other in (place, *others)])
                panel.scene.text(at, text, weight="bold", halo=(1.5, "white"), zorder=8)
        elif "stick" in shape.part.states.values():
            panel.scene.line(corners, ec=fill, lw=2, gid=gid, zorder=0.5)


def _fill(rank: int) -> str:
    return pale(fill_colour(rank), 0.6)


def _grasp(scene: Scene, layout: Layout, scale: float, middle: Floats, name: str) -> Picture:
    """Draw the grasp and its load; `name` comes before the names of all elements."""
    drawn, first = Picture(layout, scene, scale, middle), len(scene.items)
    drawn.body()
    drawn.contacts()
    drawn.wrench()
    drawn.numbers()
    named = (replace(item, name=item.name and name + item.name) for item in scene.items[first:])
    scene.items[first:] = named
    return drawn


def _example(
    scene: Scene,
    layout: Layout,
    verdict: Verdict,
    together: list[Part],
    where: tuple[int, Floats, float],
) -> None:
    """Draw the virtual motion of some parts on a small grasp, with the works on it."""
    (i, middle, size), (x, y, r) = where, together[0].leaf.motion
    scale, name = size / 2 / _SMALL, f"{i + 3}-"
    drawn = _grasp(scene, layout, scale, middle, name)
    done = works(verdict.grasp, verdict.wrench, together)
    load, least, both = map(number, (done.load, done.least, done.load + done.least))
    for k, text in enumerate((f"{i + 1}: load {load}, contacts ≥ {least}", f"together ≥ {both}")):
        place = middle[0], middle[1] + size / 2 + 12 - 9 * k
        scene.text(place, text, weight="normal" if k else "bold")
    shifts = [(x - r * c.point[1], y + r * c.point[0]) for c in verdict.grasp]
    largest = max((abs(v) for shift in shifts for v in shift), default=Fraction(0))
    for k, (shift, start) in enumerate(zip(shifts, drawn.places, strict=True), 1):
        if any(shift):
            end = start + 2 * MOVED * scale * np.array([float(v / largest) for v in shift])
            arrow(scene, start, end, 1.0, fc=BLUE, ec="none", gid=f"{name}shift-{k}", zorder=7)
            drawn.labels.avoid_line(start, end)
    for k, (factor, start) in enumerate(zip(done.factors, drawn.places, strict=True), 1):
        text = "no force" if factor is None else f"{number(factor)} c"
        normal = layout.normals[k - 1]
        along, half = np.array([-normal[1], normal[0]]), scene.measure(text)[0] / 2
        wanted = [
            start - out * normal + side * along - [half * np.sign(round(normal[0], 3)), 0]
            for out in (6, 12, 18, 26)
            for side in (-10, 10, 16, -16, 0)
        ]
        ends = half + 2, scene.width - half - 2
        wanted = [np.array([min(max(place[0], ends[0]), ends[1]), place[1]]) for place in wanted]
        colour = GREY if factor is None else VERMILION if factor < 0 else BLUE
        scene.text(drawn.labels.place(text, wanted), text, color=colour, halo=(1.5, "white"),
                   gid=f"{name}work-{k}", zorder=8)  # fmt: skip
    if r:
        frame, centre = layout.frame, (-y / r, x / r)
        far = max(abs(v - c) for v, c in zip(centre, frame.centre, strict=True)) / frame.size
        if 4 * far < 9:
            at = drawn.at(frame.paper(centre))
            turning_arrow(scene, at, 0.15 * scale, 1 if r > 0 else -1, color=BLUE,
                          gid=f"{name}centre", zorder=7)  # fmt: skip
            scene.mark(at, "o", 2.5, color=BLUE, zorder=7)


def _lines(
    verdict: Verdict, found: list[Part], ranks: dict[RationalVector, int], angle: Fraction | None
) -> Iterator[str]:
    named = f", {_NAMED} of them named" if len(ranks) > _NAMED else ""
    yield (
        f"w = {vector(verdict.wrench)} is not resisted; regions of motions: {len(found)}; "
        f"virtual motions λ = (x, y, r): {len(ranks)}{named}"
    )
    yield (
        "regions: motions of every size; farther centres and translations lie beyond the edges"
        if angle is None
        else f"regions: only the motions with r = {number(angle)} (left) and r = "
        f"{number(-angle)} (right) are shown; the proof has all"
    )
    yield "below: λ as arrows at the contacts; the least work of each where its normal force is c"
