"""The subcommands of ``equilibrium`` about resisted wrenches; `equilibrium.cli` adds them."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.console import terminal
from arrangement.console.number_form import bracket, counted, number, vector
from arrangement.numbers.exact import number_text, to_text
from equilibrium.model.errors import GraspError

from .arguments import (
    add_applied,
    add_command,
    add_count,
    add_displacement,
    add_number,
    add_wrench,
    applied,
    force_given,
    grasp_of,
    show,
)

if TYPE_CHECKING:
    from arrangement.numbers.linear.intervals import Interval
    from equilibrium.decide.solver import Solver
    from equilibrium.model.grasp import Grasp
    from equilibrium.wrench_sets import (
        Gap,
        Magnitudes,
        Region,
        ResistedSet,
        SearchMap,
        Segment,
        SmallestUnresisted,
    )
    from equilibrium.wrench_sets.spatial import SpatialMagnitudes

_ZERO = (Fraction(0),) * 3
#: Of converted grasps in space: how many borders are asked about, at which share from them, and
#: with how many steps.
_BORDERS, _NEAR, _STEPS = 2, Fraction(1, 1000), 50_000_000
#: How often a margin tries all states, about: for the wrench, for preloads, for friction.
_MARGIN = 6


def add_commands(commands: Any) -> None:
    """Add limit, region, polyhedra, margin, map, figure and gaps."""
    some = ("some are resisted", "none is resisted")
    text = "find the magnitudes resisted along a direction, or in every one"
    limit = add_command(commands, "limit", _limit, text, *some, "undecided")
    ways = add_applied(limit, "--direction", "which way; not zero")
    text = "instead: find the smallest wrench that is not resisted, whichever way it points"
    ways.add_argument("--any-direction", action="store_true", help=text)
    text = "with --any-direction: divide torques by this to compare them with forces (default: 1)"
    add_number(limit, "--length", None, text)
    add_wrench(limit, "--base", "a wrench that acts in any case (default: none)", _ZERO)
    add_displacement(limit)

    text = "find the resisted wrenches of a plane"
    region = add_command(commands, "region", _region, text, *some)
    _add_plane(region)
    add_displacement(region)

    text = "list all resisted wrenches as half-spaces"
    add_displacement(add_command(commands, "polyhedra", _polyhedra, text, *some))

    text = "say how far a wrench may be scaled, and what would resist it"
    answers = ("resisted", "not resisted", "undecided")
    margin = add_command(commands, "margin", _margin, text, *answers)
    add_applied(margin)
    add_displacement(margin)
    add_number(margin, "--width", Fraction(1, 2**20), "length of the friction bracket")

    text = "search for the largest force in N directions, as the paper does"
    mapped = add_command(commands, "map", _map, text, "the search is right", "it errs")
    add_count(mapped, "--directions", 72, "how many")
    add_number(mapped, "--tolerance", Fraction(1, 1000), "of the search")
    add_number(mapped, "--largest", 1000, "largest magnitude tried")

    text = "compute the wrench-space slice, no preload and preload 1, as data"
    _add_plane(add_command(commands, "figure", _figure, text, preload=False))

    text = "look for random grasps that a binary search misjudges"
    gaps = add_command(commands, "gaps", _gaps, text, "some found", "none found", grasp=False)
    gaps.set_defaults(long=True)
    text = "of each grasp (default: 3)"
    gaps.add_argument("--contacts", type=terminal.count_argument, default=3, metavar="M", help=text)
    add_count(gaps, "--seed", 29, "of the random grasps", "SEED")
    add_count(gaps, "--tries", 20, "grasps looked at")


def _add_plane(parser: argparse.ArgumentParser) -> None:
    add_wrench(parser, "--origin", "a wrench of the plane (default: zero)", _ZERO)
    add_wrench(parser, "--first", "first span (default: 1 0 0)", (1, 0, 0))
    add_wrench(parser, "--second", "second span (default: 0 1 0)", (0, 1, 0))


def _solver(arguments: argparse.Namespace, grasp: Grasp) -> Solver:
    from equilibrium.decide.solver import Solver

    return Solver(grasp, arguments.max_displacement)


def _limit(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets.line import resisted_magnitudes

    if arguments.any_direction:
        return _smallest(arguments)
    if arguments.length is not None:
        raise GraspError("--length goes with --any-direction; a direction needs none")
    grasp = grasp_of(arguments)
    direction = applied(arguments, grasp, "direction")
    if grasp.dimension == 3:
        return _spatial_limit(arguments, grasp, direction, arguments.base)
    solver = _solver(arguments, grasp)
    found = resisted_magnitudes(solver, direction, arguments.base)
    more, again = _rounded(solver, found)
    lines = [f"resisted for t in {_intervals(found.intervals)}", *again]
    return show(arguments, found.to_dict() | more, lines, bool(found.intervals), grasp)


def _smallest(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import ResistedSet

    force_given(arguments)  # refuses a place without a force
    grasp = grasp_of(arguments)
    length = 1 if arguments.length is None else arguments.length
    whole = ResistedSet(grasp, max_displacement=arguments.max_displacement)
    found = whole.smallest_outside(arguments.base, length)
    lines = _smallest_lines(found, grasp)
    return show(arguments, found.to_dict(), lines, found.size_squared != 0, grasp)


def _smallest_lines(found: SmallestUnresisted, grasp: Grasp) -> Iterator[str]:
    load = "with the base, " if any(found.base) else ""
    if found.size is None or found.wrench is None or found.beyond is None:
        yield f"{load}every wrench is resisted, whichever way it points and however large it is"
        return
    if found.size_squared:
        exact = found.size**2 == found.size_squared
        size = number(found.size) if exact else number_text(found.size, longest=0)
        squared = "" if exact else f" (squared {number(found.size_squared)})"
        yield f"{load}every wrench smaller than {size}{_force(grasp)}{squared} is resisted"
        yield f"  where size^2 = f_x^2 + f_y^2 + (tau / length)^2, length {number(found.length)}"
        yield f"on the border: {vector(found.wrench)}"
    else:
        yield f"{load}no size is resisted in every direction"
    yield f"not resisted: {vector(found.beyond)}"


def _rounded(solver: Solver, found: Magnitudes) -> tuple[dict[str, Any], list[str]]:
    """Return what other roundings of converted data say of the ends: JSON form and lines."""
    from equilibrium.decide.robustness import DEPENDS
    from equilibrium.wrench_sets.line import ends_within_error

    again = ends_within_error(solver, found)
    if again is None:
        return {}, []
    if again.turned is None:
        ends = ["no end" if x is None else _between(*x) for x in again.ends]
        line = f"ends for {again.asked} others within the error of the data: "
        line += ", ".join(ends) or "none"
    else:
        line = f"{DEPENDS}: {_intervals(again.turned)} for others within the error of the data"
    return {"within_error": again.to_dict()}, [line]


def _spatial_limit(
    arguments: argparse.Namespace, grasp: Grasp, direction: Sequence[Fraction], base: Any
) -> int:
    from equilibrium.model.effort import Effort
    from equilibrium.model.grasp import read_wrench
    from equilibrium.plane.contact_rows import sum_row
    from equilibrium.wrench_sets.spatial import spatial_magnitudes

    start = (0,) * 6 if base is _ZERO else base
    found = spatial_magnitudes(grasp, direction, start, max_displacement=arguments.max_displacement)
    yes = {"resisted": True, "not resisted": False}.get(found.verdict)
    lines, document = list(_border_lines(found)), found.to_dict()
    if grasp.data_error is not None and found.borders:
        # Brackets are finer than the data, so verdicts a little before a border are asked about.
        ends = [border.resisted for border in found.borders[:_BORDERS]]
        ways = [-1 if b.resisted < b.refused else 1 for b in found.borders]
        inside = [t * (1 + way * _NEAR) for t, way in zip(ends, ways, strict=False)]
        document["within_error"] = []
        for t in inside:
            wrench = sum_row(read_wrench(start, 6), tuple(direction), t)
            asked = _solver(arguments, grasp).decide(wrench, Effort(_STEPS))
            document["within_error"].append({"t": to_text(t), "verdict": asked.answer})
            words = asked.doubt or f"{asked.answer}, also for others within the error of the data"
            lines.append(f"at {number(t)}: {words}")
    return show(arguments, document, lines, yes, grasp)


def _border_lines(found: SpatialMagnitudes) -> Iterator[str]:
    first, last = found.samples[0], found.samples[-1]
    tried = counted(len(found.samples), "magnitude")
    yield f"{tried} from 0 to {number(last[0])} tried; at 0: {first[1]}"
    for border in found.borders:
        ends = sorted((border.resisted, border.refused))
        order = "resisted, then not" if border.resisted < border.refused else "not, then resisted"
        line = f"{order}: the border is {bracket(*ends)}"
        left = len(border.undecided)
        yield line + (f"; {left} undecided between them" if left else "")
    for a, b in found.gaps:
        yield f"a gap: not resisted from {number(a.refused)} to {number(b.refused)}"
    if last[1] != "not resisted":
        yield f"at {number(last[0])}: {last[1]}; no end above it was looked for"


def _region(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets.plane import resisted_region

    grasp, spans = grasp_of(arguments), (arguments.first, arguments.second)
    region = resisted_region(_solver(arguments, grasp), spans, arguments.origin)
    return show(arguments, region.to_dict(), _region_lines(region), bool(region.polygons), grasp)


def _region_lines(region: Region) -> Iterator[str]:
    from equilibrium.wrench_sets import polygon_cycle

    many = counted(len(region.polygons), "polygon")
    yield f"{many} (corners counter-clockwise; then rays, lines)"
    for piece in region.polygons:
        shape = piece.polyhedron
        parts = [_points(polygon_cycle(shape))]
        parts += [f"rays {_points(shape.rays)}"] if shape.rays else []
        parts += [f"lines {_points(shape.lines)}"] if shape.lines else []
        yield f"  {' '.join(piece.states)}: {'; '.join(parts)}"
    outline = region.outline
    for name, segments in (("border", outline.border), ("whisker", outline.whiskers)):
        yield from (f"{name} {_segment(segment)}" for segment in segments)
    yield from (f"point {vector(point)}" for point in outline.points)
    for sector in region.unlimited:
        ends = f"from {vector(sector.start)} counter-clockwise to {vector(sector.end)}"
        yield f"without limit: {'all directions' if sector.whole else ends}"


def _polyhedra(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import ResistedSet

    grasp = grasp_of(arguments)
    whole = ResistedSet(grasp, max_displacement=arguments.max_displacement)
    return show(arguments, whole.to_dict(), _set_lines(whole), bool(whole.polyhedra), grasp)


def _set_lines(whole: ResistedSet) -> Iterator[str]:
    many = counted(len(whole.polyhedra), "polyhedron", "polyhedra")
    yield f"{many} (conditions a f_x + b f_y + c tau + d >= 0 or = 0)"
    for piece in whole.polyhedra:
        yield f"  {' '.join(piece.states)}"
        yield from (f"    {vector(row)} >= 0" for row in piece.polyhedron.inequalities)
        yield from (f"    {vector(row)} = 0" for row in piece.polyhedron.equalities)


def _margin(arguments: argparse.Namespace) -> int:
    from equilibrium.grasps.inputs.documents import question_document
    from equilibrium.wrench_sets.margin import margin

    grasp = grasp_of(arguments)
    wrench = applied(arguments, grasp)
    question_document(grasp, wrench, "margin")
    if grasp.dimension == 3:
        return _spatial_limit(arguments, grasp, wrench, (0,) * 6)
    solver = _solver(arguments, grasp)
    solver.ask(_MARGIN)
    found = margin(solver, wrench)
    preloads, friction = found.preloads, found.friction(arguments.width)
    remedies = {"preload": preloads.to_dict(), "friction": friction.to_dict()}
    more, again = _rounded(solver, found.magnitudes) if any(wrench) else ({}, [])
    doubt = grasp.data_error is not None and solver.solve(wrench).doubt
    word = "yes" if found.resisted else "no"
    word += f", as it was rounded; it {doubt}" if doubt else ""
    yes = None if doubt else found.resisted
    lines = [
        f"resisted: {word}",
        f"resisted when scaled by a factor in {_intervals(found.intervals)}",
        *again,
        f"resisted with a uniform preload in {_intervals(preloads.intervals)}" + _force(grasp),
        "least uniform friction: " + _friction(friction.low, friction.high),
    ]
    return show(arguments, found.to_dict() | more | remedies, lines, yes, grasp)


def _map(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets.search_map import search_map

    grasp = grasp_of(arguments)
    found = search_map(grasp, arguments.directions, arguments.tolerance, arguments.largest)
    lines = _map_lines(found, _force(grasp))
    return show(arguments, found.to_dict(), lines, not found.disagreements, grasp)


def _map_lines(found: SearchMap, unit: str) -> Iterator[str]:
    yield (
        f"{counted(len(found.entries), 'direction')}, tolerance {number(found.tolerance)}{unit}, "
        f"limit {number(found.limit)}{unit}: the search errs in {len(found.disagreements)}"
    )
    for entry in found.entries:
        answer = "without limit" if entry.found is None else f"up to {number(entry.found)}{unit}"
        shown = ", ".join(f"{float(x):+.4f}" for x in entry.direction)
        wrong = "" if entry.agrees else f"; exactly {_intervals(entry.exact)}"
        yield f"  ({shown})  {answer}{wrong}"


def _figure(arguments: argparse.Namespace) -> int:
    from equilibrium.methods import resistance_figure

    grasp, spans = grasp_of(arguments), (arguments.first, arguments.second)
    data = resistance_figure(grasp, spans, arguments.origin)
    return show(arguments, data, _figure_lines(data), True, grasp)


def _figure_lines(data: dict[str, Any]) -> Iterator[str]:
    corners = data["grasp_wrench_space"]["corners"]
    yield "wrench-space slice: " + " ".join(f"({', '.join(corner)})" for corner in corners)
    for name in ("no_preload", "preload_1"):
        part = data[name]
        borders, sectors = len(part["outline"]["border"]), len(part["unlimited"])
        yield (
            f"{name}: {counted(len(part['polygons']), 'polygon')}, "
            f"{counted(borders, 'border part')}, {counted(sectors, 'sector')} without limit (all "
            "of it with --json)"
        )


def _gaps(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import gaps

    found = list(gaps(arguments.contacts, arguments.seed, arguments.tries))
    document = {"gaps": [gap.to_dict() for gap in found]}
    return show(arguments, document, _gap_lines(found), bool(found))


def _gap_lines(found: list[Gap]) -> Iterator[str]:
    yield f"{len(found)} found"
    for gap in found:
        yield f"direction {vector(gap.direction)}: {_intervals(gap.intervals)}"
        for c in gap.grasp:
            friction = number(c.friction)
            yield f"  point {vector(c.point)} normal {vector(c.normal)} friction {friction}"


def _force(grasp: Grasp) -> str:
    """Return what to write after a number that is a force."""
    return f" {grasp.units.force}" if grasp.units else ""


def _intervals(intervals: Iterable[Interval]) -> str:
    shown = [
        ("(no end" if low is None else f"[{number(low)}")
        + (", no end)" if high is None else f", {number(high)}]")
        for low, high in intervals
    ]
    return " or ".join(shown) if shown else "no interval"


def _between(low: Any, high: Any) -> str:
    return number(high) if low == high else bracket(low, high)


def _friction(low: Fraction | None, high: Fraction | None) -> str:
    if low is None:
        return "none is enough"
    if high is None:
        return f"not below {number(low)}; none found above"
    return _between(low, high)


def _segment(segment: Segment) -> str:
    start = "without end" if segment.start is None else vector(segment.start)
    end = "without end" if segment.end is None else vector(segment.end)
    return f"{start} to {end}, direction {vector(segment.direction)}"


def _points(points: Iterable[Iterable[Fraction | int]]) -> str:
    return " ".join(map(vector, points))
