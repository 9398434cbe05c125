"""The proof that a wrench is not resisted: motions cut into regions, each with a virtual motion."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.colours import BLUE, GREY, VERMILION, pale, plane_colour
from arrangement.drawing.labels import Labels, inside, near, pole, write_if_free
from arrangement.drawing.pages import BASE_SCRIPT, BASE_STYLE, Template, floats, one_page
from arrangement.drawing.scene import (
    FONT,
    POINTS,
    Floats,
    Scene,
    arc,
    area,
    checked_width,
    curve_points,
    turning_arrow,
)
from arrangement.drawing.views import Exact, picture
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    primitive,
    rational,
    sign,
    to_text,
)
from arrangement.numbers.linear.cones import generators
from arrangement.numbers.linear.polyhedron import Polyhedron, from_conditions
from equilibrium.certificate.leaves import ClosedPart, parts, works
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.decide.solver import Solver
from equilibrium.decide.verdict import Verdict
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows

from .body import Frame, frame_of
from .grasp import GraspLayout
from .layout import MOVED, PlanePicture, shift_at
from .panel import ABOVE, BELOW, GAP, LEFT, RIGHT, Panel, Window
from .space_grasp import proof_in_space
from .style import SKETCH_SCRIPT, SKETCH_STYLE, Wrench, nice_near, symbol

#: Half the side of the maps, where the contacts fill [-1, 1].
MAP = 3
#: The senses of rotation, r > 0 and r < 0, and their names.
TURNS = {1: "counter-clockwise", -1: "clockwise"}


class Shape(NamedTuple):
    """A part of the motions where it meets the rotations of one sense: a polygon of centres."""

    part: ClosedPart
    sense: int
    corners: Floats


@dataclass(frozen=True)
class ProofMaps:
    """The parts of a proof and what the maps show of them.

    Attributes:
        angle: of the rotations that are shown; None if regions do not depend on it.
        shapes: the largest first.
        ranks: the virtual motions, from the one with the largest regions on.
    """

    verdict: Verdict
    parts: Sequence[ClosedPart]
    angle: Fraction | None
    window: Window
    shapes: Sequence[Shape]
    ranks: Mapping[RationalVector, int]


def proof_maps(grasp: Grasp, wrench: Wrench, rotation: Exact | None) -> ProofMaps:
    """Return the maps of the proof that a wrench is not resisted (see `draw_proof`).

    Raises:
        GraspError: the wrench is resisted, or a rotation that is not above 0.
    """
    verdict = Solver(grasp).solve(wrench)
    if verdict.stable:
        raise GraspError(
            "the wrench is resisted, so no proof refutes it; the view grasp shows what balances it"
        )
    frame = frame_of(grasp, grasp.outline)
    regions = list(parts(verdict.proof))
    angle = _angle(grasp, frame, regions, rotation)
    window = Window(frame.centre, MAP * frame.half)
    shapes = [
        Shape(part, sense, corners)
        for part in regions
        for sense in TURNS
        if (centres := _centres(part, grasp, sense, angle)) is not None
        and (corners := window.inside(centres)) is not None
    ]
    sizes: dict[RationalVector, float] = {part.leaf.motion: 0.0 for part in regions}
    for shape in shapes:
        sizes[shape.part.leaf.motion] += area(shape.corners)
    ranks = {motion: i for i, motion in enumerate(sorted(sizes, key=lambda m: -sizes[m]))}
    shapes.sort(key=lambda shape: -area(shape.corners))
    return ProofMaps(verdict, regions, angle, window, shapes, ranks)


def _angle(
    grasp: Grasp, frame: Frame, regions: list[ClosedPart], rotation: Exact | None
) -> Fraction | None:
    """Return the rotation to be shown; None if regions do not depend on the size of motions."""
    if rotation is not None:
        angle = rational(rotation, "rotation")
        if angle <= 0:
            raise GraspError(f"rotation is {angle}; it must be above 0")
        return angle
    plain = all(g[0] == 0 or not any(g[1:]) for part in regions for g in part.region)
    if plain and not any(grasp.contacts[i].preload for part in regions for i in part.states):
        return None
    reach = max((c.preload / c.stiffness for c in grasp if c.stiffness), default=Fraction(0))
    angle = nice_near(reach / frame.half or Fraction(1))
    rows = (row for part in regions for row, _ in _conditions(part, grasp))
    borders = {Fraction(abs(zero), abs(r)) for x, y, r, zero in rows if r and not (x or y)}
    while angle in borders:
        angle *= Fraction(9, 10)
    return angle


def _conditions(part: ClosedPart, grasp: Grasp) -> Iterator[tuple[IntegerVector, bool]]:
    """Yield rows ``a . (x, y, r, d_0) >= 0`` of a part, and whether ``= 0`` is meant instead."""
    for zero, *row in generators(part.region, (), 4)[0]:
        yield (*row, zero), False
    question = LinearQuestion(ContactRows.of_grasp(grasp), (Fraction(0),) * 3)
    for i, state in part.states.items():
        yield from question.motion_rows(i, state)


def _centres(
    part: ClosedPart, grasp: Grasp, sense: int, angle: Fraction | None
) -> Polyhedron | None:
    """Return the centres of the rotations of a part, of one sense and angle."""
    rows: dict[bool, list[IntegerVector]] = {False: [], True: []}
    for (x, y, r, zero), equal in _conditions(part, grasp):
        constant = sense * r + (zero / angle if angle else 0)
        if any(row := primitive((-sense * y, sense * x, constant))):
            rows[equal].append(row)
    return from_conditions(rows[False], rows[True], 2)


def summary_lines(maps: ProofMaps, named: int) -> Iterator[str]:
    """Yield what is shown, in words; `named` virtual motions are named beside."""
    more = f", {named} of them named" if len(maps.ranks) > named else ""
    yield (
        f"w = {LABEL.vector(maps.verdict.wrench)} is not resisted; "
        + (f"{maps.verdict.doubt}; " if maps.verdict.doubt else "")
        + f"regions of motions: {len(maps.parts)}; "
        f"virtual motions λ = (x, y, r): {len(maps.ranks)}{more}"
    )
    yield (
        "regions: motions of every size; farther centres and translations lie beyond the edges"
        if maps.angle is None
        else f"regions: only the motions with r = {LABEL.number(maps.angle)} (left) and r = "
        f"{LABEL.number(-maps.angle)} (right) are shown; the proof covers all"
    )


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
    layout = GraspLayout(grasp, verdict)
    width = checked_width(width, 150.0)
    side = (width * POINTS - LEFT - RIGHT - GAP) / 2
    small = 0.6 * side
    scene = Scene(width, (side + small + 2.5 * ABOVE + BELOW) / POINTS)
    low = small + 1.5 * ABOVE + BELOW
    unit = grasp.units.length if grasp.units else ""
    for i, sense in enumerate(TURNS):
        panel = Panel(scene, maps.window, (LEFT + i * (side + GAP), low), side, f"{i + 1}-")
        panel.rulers(("$x$", "$y$"), (unit, unit), left=i == 0)
        scene.maps.append(panel.page_map)
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
    for i, shape in enumerate(shapes):
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


def _grasp(
    scene: Scene, layout: GraspLayout, scale: float, middle: Floats, name: str
) -> PlanePicture:
    """Draw the grasp and its load; `name` comes before the names of all elements."""
    drawn, first = PlanePicture(layout, scene, scale, middle), len(scene.items)
    drawn.bodies()
    drawn.contacts()
    drawn.wrenches()
    named = (replace(item, name=item.name and name + item.name) for item in scene.items[first:])
    scene.items[first:] = named
    return drawn


def _example(
    scene: Scene,
    layout: GraspLayout,
    verdict: Verdict,
    together: list[ClosedPart],
    where: tuple[int, Floats, float],
) -> None:
    """Draw the virtual motion of some parts on a small grasp, with the works on it."""
    (i, middle, size), (x, y, r) = where, together[0].leaf.motion
    half, name = _SMALL[len(verdict.grasp) > _WRITTEN], f"{i + 3}-"
    scale = size / 2 / half
    drawn = _grasp(scene, layout, scale, middle, name)
    work = works(verdict.grasp, verdict.wrench, together, verdict.max_displacement)
    load, least, both = map(LABEL.number, (work.load, work.least, work.load + work.least))
    loads = "load and adhesion" if any(verdict.grasp.adhesion_wrench) else "load"
    place = np.add(middle, (0, size / 2 + 12))
    scene.text(place, f"{i + 1}: {loads} {load}, contacts ≥ {least}", weight="bold")
    scene.text(place - (0, 9), f"together ≥ {both}")
    shifts = [shift_at((x, y, r), c.point) for c in verdict.grasp]
    largest = max((abs(v) for shift in shifts for v in shift), default=Fraction(0))
    colours = [
        GREY if factor is None else VERMILION if factor < 0 else BLUE for factor in work.factors
    ]
    for k, (shift, start) in enumerate(zip(shifts, drawn.places, strict=True)):
        if any(shift):
            end = start + 2 * MOVED * scale * np.array([float(v / largest) for v in shift])
            drawn.arrow(start, end, 1.0, fc=colours[k], gid=f"{name}shift-{k + 1}", zorder=7)
    if r:
        frame, centre = layout.frame, (-y / r, x / r)
        far = max(abs(v - c) for v, c in zip(centre, frame.centre, strict=True)) / frame.half
        if far < 0.9 * half:
            at, reach = drawn.at(frame.paper(centre)), 0.15 * scale
            look: dict[str, Any] = {"color": BLUE, "gid": f"{name}centre", "zorder": 7}
            turning_arrow(scene, at, reach, sign(r), **look)
            scene.mark(at, "o", 2.5, color=BLUE, zorder=7)
            drawn.labels.avoid(curve_points(arc(at, reach, 0, 2 * math.pi)))
    drawn.letter()
    if len(verdict.grasp) <= _WRITTEN:
        drawn.numbers()
        for k, (factor, colour) in enumerate(zip(work.factors, colours, strict=True)):
            text = "no force" if factor is None else f"{LABEL.number(factor)} c"
            places = near(drawn.places[k], -layout.normals[k])
            drawn.labels.write(text, places, color=colour, gid=f"{name}work-{k + 1}")


_OWN = "equilibrium.pictures"
SCRIPTS: tuple[Template, ...] = (BASE_SCRIPT, SKETCH_SCRIPT, (_OWN, "proof.js"))
#: Half width and half height of a number in a region, where a map fills [-1, 1].
_LABEL = np.array([0.05, 0.06])


def proof_page(
    grasp: Grasp, *, wrench: Wrench, rotation: Exact | None = None, title: str | None = None
) -> str:
    """Build a self-contained HTML page: why a wrench is not resisted.

    The two maps of `draw_proof`. For the region under the pointer, or the one that has the focus,
    the page draws the virtual motion on the grasp and states its inequality: the work of the load,
    the least work of each contact as a factor of its normal force, and that of all together. It
    states the question, as the certificate has it.

    Args:
        grasp: contacts.
        wrench, rotation: as for `draw_proof`.
        title: a heading; if omitted, the wrench.

    Raises:
        GraspError: as for `draw_proof`.
    """
    maps = proof_maps(grasp, wrench, rotation)
    load = maps.verdict.wrench
    heading = f"Why w = {LABEL.vector(load)} is not resisted" if title is None else title
    places = {id(part): i for i, part in enumerate(maps.parts)}
    largest = next(iter(maps.ranks))
    data = {
        "title": heading,
        "summary": "; ".join(summary_lines(maps, len(maps.ranks))),
        "load": {"force": _directions([load[:2]])[0], "turn": sign(load[2])},
        "stuck": any(maps.verdict.grasp.adhesion_wrench),
        "colours": [pale(plane_colour(i), 0.35) for i in range(len(maps.ranks))],
        "maps": [
            {
                "title": f"centres of {name} motions",
                "shapes": [
                    {"part": places[id(shape.part)], **_outline(shape.corners)}
                    for shape in maps.shapes
                    if shape.sense == sense
                ],
            }
            for sense, name in TURNS.items()
        ],
        "first": next(
            (places[id(s.part)] for s in maps.shapes if s.part.leaf.motion == largest), 0
        ),
        "half": MAP,
        "question": maps.verdict.verify().question,
        "motions": [_motion(maps, motion) for motion in maps.ranks],
        "parts": [_part(maps, part) for part in maps.parts],
        **_grasp_data(grasp),
    }
    styles: list[Template] = [BASE_STYLE, SKETCH_STYLE, (_OWN, "proof.css")]
    return one_page(heading, (_OWN, "proof.html"), styles, SCRIPTS, data, ["theme", "print"])


def _outline(corners: Any) -> dict[str, Any]:
    import shapely

    label = {}
    if len(corners) > 2:
        shape = shapely.Polygon(corners)
        place = pole(shape, _LABEL)
        if shape.contains(shapely.box(*(place - _LABEL), *(place + _LABEL))):
            label["label"] = floats(place)
    return {"corners": floats(corners), **label}


def _motion(maps: ProofMaps, motion: RationalVector) -> dict[str, Any]:
    """Return a virtual motion: in words, by its centre, and at the contacts."""
    (x, y, r), centre = motion, None
    words = f"moves the object along {LABEL.vector((x, y))}"
    if r:
        point = (-y / r, x / r)
        words = f"turns the object {TURNS[sign(r)]} about {LABEL.vector(point)}"
        place = maps.window.paper(point)
        centre = floats(MAP * place) if abs(place).max() <= 1 else None
    return {
        "text": LABEL.vector(motion),
        "exact": f"({', '.join(map(to_text, motion))})",
        "words": words,
        "turn": sign(r),
        "centre": centre,
        "shifts": _directions([shift_at(motion, c.point) for c in maps.verdict.grasp]),
    }


def _part(maps: ProofMaps, part: ClosedPart) -> dict[str, Any]:
    """Return a part: its motions, and the numbers of its inequality."""
    verdict = maps.verdict
    work = works(verdict.grasp, verdict.wrench, [part], verdict.max_displacement)
    values = (work.load, work.least, work.load + work.least)
    return {
        "motion": maps.ranks[part.leaf.motion],
        "cone": [f"({', '.join(map(to_text, generator))})" for generator in part.region],
        "states": [f"{verdict.grasp.point_names[i]} {x}" for i, x in part.states.items()],
        "works": list(map(LABEL.number, values)),
        "exact": list(map(to_text, values)),
        "factors": [None if factor is None else LABEL.number(factor) for factor in work.factors],
    }


def _directions(vectors: Sequence[RationalVector]) -> Any:
    """Return vectors as floats, the largest component of all being 1 or -1."""
    largest = max((abs(x) for vector in vectors for x in vector), default=Fraction(0)) or 1
    return floats([[x / largest for x in vector] for vector in vectors])


def _grasp_data(grasp: Grasp) -> dict[str, Any]:
    """Return the contacts and the outline in paper coordinates, for ``sketch.js``."""
    layout = GraspLayout(grasp)
    frame, curve = layout.frame, layout.body.curve
    return {
        "contacts": [
            {
                "place": floats(place),
                "normal": [float(x) for x in contact.normal],
                "cone": floats(rim),
                "preload": float(contact.preload),
            }
            for contact, place, rim in zip(grasp, layout.places, layout.cones, strict=True)
        ],
        "stated": layout.body.stated,
        "outline": None if curve is None else floats(curve_points(curve, 16)),
        "origin": floats(np.clip(frame.paper((Fraction(0),) * 2), -1.5, 1.5)),
        "centre": [float(x) for x in frame.centre],
        "size": float(frame.half),
    }
