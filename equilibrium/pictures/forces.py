"""Resisted forces in a plane of wrenches: by states, by method, in three parts, by direction."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from contextlib import suppress
from fractions import Fraction

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.console.progress import watched
from arrangement.drawing.colours import GREY, VERMILION
from arrangement.drawing.scene import POINTS, Floats, Legend, Scene, measure
from arrangement.drawing.views import Exact, picture
from arrangement.errors import OutOfReachError
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, rational
from equilibrium.methods.compare import Comparison, check_cost, compare
from equilibrium.methods.registry import METHODS, WITH_REGION, method_named
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.plane.states.contact_states import States
from equilibrium.wrench_sets import Region
from equilibrium.wrench_sets.search_map import Entry, search_map
from equilibrium.wrench_sets.slice import resisted_region

from .panel import (
    ROOM,
    SQUARE,
    ZERO,
    Panel,
    PlaneQuestion,
    Window,
    ends,
    explain_borders,
    explain_error,
    joint_window,
    read_extent,
    row_of_panels,
)
from .space_slice import slice_in_space
from .style import (
    FILLS,
    MARKS,
    RIM,
    SHADE,
    SYMBOLS,
    Wrench,
    explain,
    symbol,
    wrench_text,
)


@picture(20.0)
def draw_resist(
    grasp: Grasp, *, wrench: Wrench | None = None, extent: Exact | None = None, width: float = 88.0
) -> Scene:
    """Draw which forces are resisted, at zero torque or at the torque of a wrench.

    Every polygon is exact and stands for one choice of contact states: its colour shows how many
    contacts stick, hatching that some contact is detached; where there is room, one character for
    each contact shows its state. Polygons may overlap (several equilibria exist); smaller ones lie
    on top. Lines that no polygon holds are drawn wide. The black boundary is drawn only where
    resistance ends. What reaches the edge of the picture is unbounded, and fades.

    Args:
        grasp: contacts.
        wrench: wrench to mark, by a disc if it is resisted, else a cross; the plane has its torque.
        extent: half the side of the picture, with the origin in the middle; then nothing fades, as
            a polygon at the edge may end beyond it; if omitted, the whole boundary is shown.

    Raises:
        GraspError: an extent that is not above 0.
    """
    question = PlaneQuestion(wrench, extent)
    half, torque = question.half, question.torque
    region = resisted_region(grasp, origin=(0, 0, torque))
    window = joint_window([region], question.marked, half, pieces=True)
    scene, (panel,) = row_of_panels(1, window, width, grasp)
    unit = f" {grasp.units.torque}" if grasp.units else ""
    panel.title(f"resisted forces at torque {LABEL.number(torque)}{unit}")
    states = panel.region(region)
    _describe(grasp, region, states, question, scene.legend)
    if half is None:
        panel.fade()
    for point in question.marked:
        panel.wrench(point, region.contains(point))
    return scene


def _describe(
    grasp: Grasp, region: Region, states: list[States], question: PlaneQuestion, legend: Legend
) -> None:
    applied = question.wrench
    if not region.polygons:
        legend.line("nothing in this plane is resisted")
    if applied is not None:
        resisted = region.contains(applied[:2])
        legend.key(symbol("resisted" if resisted else "refused"), wrench_text(applied, grasp.units))
    most, sticking = len(FILLS) - 1, [s.count("stick") for s in states]
    for count in sorted({min(k, most) for k in sticking}):
        more = " or more" if max(sticking) > count == most else ""
        legend.key(symbol(FILLS[count]), f"{count}{more} stick")
    if any("detached" in p.states for p in region.polygons if p.polyhedron.dimension == 2):
        legend.key(symbol("#ffffff hatched"), "some detached")
    explain_borders(legend, [region], question.half is None)
    if states and len(grasp):
        signs = [s for s in SYMBOLS if any(s in x for x in states)]
        shown = ", ".join(f"{SYMBOLS[s]} {s.replace('-', '−')}" for s in signs)
        kind = "point" if grasp.has_pads else "contact"
        which = f"{kind} 1" if len(grasp) == 1 else f"{kind}s 1 to {len(grasp)}"
        legend.line(f"{which}: {shown}")


@picture(20.0)
def draw_compare(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    methods: Iterable[str] | None = None,
    extent: Exact | None = None,
    width: float = 180.0,
) -> Scene:
    """Draw the forces that each method predicts stable, as exact polygons, side by side.

    Args:
        grasp: contacts; springs and preload count where a method knows of them.
        wrench: wrench to mark in every panel, with a disc where the method predicts stable, else a
            cross; the plane has its torque.
        methods: keys of `equilibrium.methods.METHODS`; if omitted, all that have a region (without
            those for which the contacts are too many).
        extent: half the side of each panel, with the origin in the middle; if omitted, all
            boundaries are shown.

    Raises:
        GraspError: an unknown method or none, too many contacts, an extent that is not above 0.
    """
    question = PlaneQuestion(wrench, extent)
    chosen = [method_named(name) for name in (WITH_REGION if methods is None else methods)]
    if not chosen:
        raise GraspError(f"no method is given; expected one of {', '.join(WITH_REGION)}")
    if methods is None:
        check_cost(grasp)
    parts = []
    for method in watched(chosen, "methods"):
        with suppress(*[OutOfReachError] * (methods is None)):
            parts.append((method.label, method.region(grasp, origin=(0, 0, question.torque))))
    return draw_parts(grasp, parts, question, width, columns=max(1, int(width / 44)))


@picture(20.0)
def draw_slice(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    preload: Exact | None = None,
    extent: Exact | None = None,
    slice: Iterable[str] = (),
    rays: int = 16,
    width: float = 180.0,
) -> Scene:
    """Draw the resisted forces by wrench space, without preload and with it, side by side.

    All three in the same plane, with the same axes. (a) The slice of the Grasp Wrench Space with
    normal forces that sum to at most 1: it knows neither springs nor preload. (b) The exact set
    without preload. (c) The same with the grasp's own preloads or, where it has none or one is
    given, with one preload at every contact. The boundary is drawn only where resistance ends; what
    reaches the edge is unbounded, and fades.

    In space, one picture: the wrenches along directions of a plane of two coordinates, as far as
    they are proved to be resisted, with both ends of each bracket of a boundary; thick where the
    magnitudes that were tried stayed undecided, up to the edge if no proof was found beyond.
    Shaded outside is all that the proofs found refute: each refutes a convex part of the plane.

    Args:
        grasp: contacts.
        wrench: wrench to mark in every part; the plane has its torque.
        preload: at every contact of part (c); if omitted, the grasp's own preloads, or 1 where it
            has none.
        extent: half the side of each part, with the origin in the middle; if omitted, all
            boundaries are shown.
        slice: in space, two of the coordinates fx, fy, fz, tx, ty, tz, which span the plane; if
            omitted, fx and fy.
        rays: in space, number of evenly spaced directions in which boundaries are computed.

    Raises:
        GraspError: an extent that is not above 0.
    """
    if grasp.dimension == 3:
        if not (wrench is preload is extent is None):
            raise GraspError("wrench, preload and extent are for slices in the plane")
        return slice_in_space(grasp, slice or ("fx", "fy"), rays, min(width, 88.0))
    if slice:
        raise GraspError("slice is for grasps in space; leave it out")
    question = PlaneQuestion(wrench, extent)
    loaded = None if preload is None else rational(preload, "preload")
    parts = slices(grasp, question.torque, loaded)
    return draw_parts(grasp, parts, question, width)


def draw_parts(
    grasp: Grasp,
    parts: Sequence[tuple[str, Region]],
    question: PlaneQuestion,
    width: float,
    columns: int | None = None,
) -> Scene:
    """Return panels of one window with a region each, in one colour."""
    marked, fades = question.marked, question.half is None
    regions = [region for _, region in parts]
    window = joint_window(regions, marked, question.half)
    scene, panels = row_of_panels(len(parts), window, width, grasp, columns)
    legend = scene.legend
    if any(region.polygons for region in regions):
        legend.key(symbol(SHADE), f"resisted forces at torque {LABEL.number(question.torque)}")
    else:
        legend.line(f"nothing is resisted at torque {LABEL.number(question.torque)}")
    explain_borders(legend, regions, fades)
    if question.wrench is not None:
        legend.key(symbol("wrench-points"), f"{wrench_text(question.wrench, grasp.units)}: yes, no")
    for panel, (title, region) in zip(panels, parts, strict=True):
        panel.title(title)
        panel.region(region, by_states=False)
        if fades:
            panel.fade()
        for point in marked:
            panel.wrench(point, region.contains(point))
    return scene


def slices(grasp: Grasp, torque: Fraction, preload: Fraction | None) -> list[tuple[str, Region]]:
    """Return title and region of the three parts."""
    origin = (0, 0, torque)
    own = {contact.preload for contact in grasp}
    if preload is None and len(own) > 1:
        title, loaded = "(c) the preloads of the grasp", grasp
    else:
        chosen = (max(own, default=0) or 1) if preload is None else preload
        title, loaded = f"(c) preload {LABEL.number(chosen)}", grasp.with_preload(chosen)
    # Most choices of states are with preload: what is out of reach is refused at once.
    with_preload = resisted_region(loaded, origin=origin)
    return [
        ("(a) Grasp Wrench Space, L1", METHODS["wrench-space-L1"].region(grasp, origin=origin)),
        ("(b) no preload", resisted_region(grasp.with_preload(0), origin=origin)),
        (title, with_preload),
    ]


_ROW, _SIDE, _TINT = 4.6 * POINTS, 3.0 * POINTS, "#f3c9a5"
_ANSWERS = {True: "accepted", False: "refusal", None: "silence"}


@picture(20.0)
def draw_methods(grasp: Grasp, *, wrenches: Iterable[Wrench], width: float = 88.0) -> Scene:
    """Draw the verdict of every method on several wrenches, one column for each.

    A disc: the method accepts; a cross: it refuses; a dash: it says nothing about one wrench.
    A shaded field: it disagrees with the full model, which is the first row.

    Args:
        grasp: contacts.
        wrenches: at least one, at most 24.

    Raises:
        GraspError: no wrench, or too many.
    """
    questions = [grasp.read_wrench(wrench) for wrench in wrenches]
    if not questions:
        raise GraspError("there is no wrench; give at least one")
    budget.check_size(len(questions), "wrenches in a picture")
    answers = [compare(grasp, wrench) for wrench in questions]
    heads = [LABEL.vector(wrench) for wrench in questions]
    above = max(measure(head)[0] for head in heads) + 3.0 * POINTS
    height = above + _ROW * len(answers[0].answers) + 2.0 * POINTS
    scene = Scene(width, height / POINTS)
    _paint(scene, heads, answers, height - above)
    explain_error(scene.legend, grasp)
    silent = any(entry.accepts is None for answer in answers for entry in answer.answers)
    keys = {
        ("accepted", "predicts stable"): True,
        ("refusal", "predicts unstable"): True,
        ("silence", "no prediction"): silent,
        (_TINT, "differs from the full model"): any(answer.disagreeing for answer in answers),
    }
    explain(scene.legend, keys)
    return scene


def _paint(scene: Scene, heads: Sequence[str], answers: Sequence[Comparison], top: float) -> None:
    titles = [METHODS[entry.method].label for entry in answers[0].answers]
    left = _SIDE + max(measure(title)[0] for title in titles) + 2.0 * POINTS
    column = min((scene.width - left - _SIDE) / len(heads), 12.0 * POINTS)
    for i, title in enumerate(titles):
        y = top - (i + 0.5) * _ROW
        weight = "bold" if i == 0 else "normal"
        scene.text((_SIDE, y), title, ha="left", va="center_baseline", weight=weight)
        for j, answer in enumerate(answers):
            entry, place = answer.answers[i], np.array([left + (j + 0.5) * column, y])
            if entry.method in answer.disagreeing:
                field = place + SQUARE * (column / 2, _ROW / 2)
                scene.polygon(field, fc=_TINT, ec="none", gid=f"differs-{i + 1}-{j + 1}")
            sign, size, style = MARKS[_ANSWERS[entry.accepts]]
            scene.mark(place, sign, size, zorder=3, gid=f"cell-{i + 1}-{j + 1}", **style)
    for j, head in enumerate(heads):
        place = np.array([left + (j + 0.5) * column, top + 1.5 * POINTS])
        scene.text(place, head, rotation=90, va="bottom")
    right = left + column * len(heads)
    for i in (0, 1, len(titles)):
        y = top - i * _ROW
        scene.line([(_SIDE, y), (right, y)], ec=GREY, lw=0.6 if i != 1 else 0.3, zorder=2)


@picture(20.0)
def draw_polar(
    grasp: Grasp,
    *,
    rays: int = 72,
    tolerance: Exact | None = None,
    extent: Exact | None = None,
    width: float = 88.0,
) -> Scene:
    """Draw the result of a binary search in each direction, over the exact set of resisted forces.

    Every direction has one mark, at the magnitude that the search returns, or at the rim when the
    largest magnitude tried is resisted ("unbounded"). A dot: the search is right. A cross: it
    errs, by more than its tolerance; a dashed line shows magnitudes that it wrongly claims, a full
    line resisted ones that it misses. The shaded set and its boundary are exact.

    Args:
        grasp: contacts.
        rays: how many, evenly spaced from f_x, counter-clockwise.
        tolerance: of the search; if omitted, a thousandth of the radius of the picture.
        extent: that radius; if omitted, it holds the largest preload and the ends of the boundary.
            The search tries magnitudes up to 1000 times as much.

    Raises:
        GraspError: a number that is out of range.
    """
    if rays < 1:
        raise GraspError(f"the number of rays is {rays}; give at least 1")
    budget.check_size(rays, "rays in a picture")
    region = resisted_region(grasp)
    radius = read_extent(extent) or _radius(grasp, region)
    step = radius / 1000 if tolerance is None else rational(tolerance, "tolerance")
    search = search_map(grasp, rays, step, 1000 * radius)
    window = Window(ZERO, radius)
    scene, (panel,) = row_of_panels(1, window, width, grasp)
    _describe_polar(search.entries, region, scene.legend)
    panel.title(f"largest resisted force in {rays} directions", above=8.0)
    middle, half = panel.at((0, 0)), panel.side / 2
    panel.region(region, by_states=False, clip=(middle, half))
    scene.circle(middle, half, fill=False, ec=RIM, lw=0.5, gid="rim")
    for i, entry in enumerate(search.entries):
        _mark(panel, i, entry)
    return scene


def _radius(grasp: Grasp, region: Region) -> Fraction:
    """Return a radius that holds the ends of the boundary, with room; if 0 is all, the preloads."""
    needed = [*ends(region), (max((c.preload for c in grasp), default=Fraction(0)), Fraction(0))]
    largest = max(max(map(abs, point)) for point in needed)
    if not largest:
        return Fraction(1)
    norms = (math.hypot(*(float(x / largest) for x in point)) for point in needed)
    return largest * Fraction(math.ceil(20 * max(norms) * (1 + ROOM)), 20)


def _mark(panel: Panel, index: int, entry: Entry) -> None:
    scene, gid = panel.scene, panel.gid("direction", index)
    sign, size, style = MARKS["dot" if entry.agrees else "cross"]
    place = _at(panel, entry.direction, entry.found)
    scene.mark(place, sign, size, zorder=6, gid=gid, **style)
    if entry.agrees:
        return
    for kind, parts in (("claimed", entry.wrongly_claimed), ("missed", entry.missed)):
        dashes = (0, (2, 1.2)) if kind == "claimed" else "solid"
        for k, part in enumerate(parts, 1):
            line, gid = [_at(panel, entry.direction, end) for end in part], panel.gid(kind, index)
            scene.line(line, ec=VERMILION, lw=1.1, ls=dashes, zorder=5, gid=f"{gid}-{k}")


def _at(panel: Panel, direction: RationalVector, magnitude: Fraction | None) -> Floats:
    """Return the place of a magnitude, on the rim when it lies beyond or is unbounded."""
    half = panel.window.half
    reach = half if magnitude is None else min(magnitude, half)
    return panel.at(panel.window.paper([reach * x for x in direction]))


def _describe_polar(entries: Sequence[Entry], region: Region, legend: Legend) -> None:
    wrong = [entry for entry in entries if not entry.agrees]
    legend.line(f"the binary search is wrong in {len(wrong)} of {len(entries)} directions")
    legend.key(symbol(SHADE), "resisted (exact)")
    explain_borders(legend, [region], fades=False)
    keys = {
        ("dot", "search is correct"): len(wrong) < len(entries),
        ("rim", "rim: unbounded"): any(entry.found is None for entry in entries),
        ("cross", "search is wrong"): wrong,
        ("claimed", "wrongly claimed"): any(entry.wrongly_claimed for entry in wrong),
        ("missed", "missed"): any(entry.missed for entry in wrong),
    }
    explain(legend, keys)
