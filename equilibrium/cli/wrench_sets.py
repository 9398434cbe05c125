"""The subcommands of ``equilibrium`` about resisted wrenches; `equilibrium.cli` adds them."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement import terminal
from arrangement.exact import to_text

if TYPE_CHECKING:
    from arrangement.polyhedra.intervals import Interval
    from equilibrium.model.grasp import Grasp
    from equilibrium.wrench_sets import Region, Segment

_AXES = ("X", "Y", "R")
_ZERO = (Fraction(0),) * 3


def add_commands(commands: Any) -> None:
    """Add limit, region, polyhedra, margin, map, figure and gaps."""
    limit = _add(
        commands, "limit", _limit, "magnitudes resisted along a direction (exit 1 if none)"
    )
    _add_wrench(limit, "--direction", "which way; not zero")
    _add_wrench(limit, "--base", "a wrench that acts in any case (default: none)", _ZERO)

    region = _add(commands, "region", _region, "resisted wrenches of a plane (exit 1 if none)")
    _add_plane(region)

    _add(commands, "polyhedra", _polyhedra, "all resisted wrenches as half-spaces (exit 1 if none)")

    margin = _add(
        commands, "margin", _margin, "how far a wrench may be scaled, and what would resist it"
    )
    _add_wrench(margin, "--wrench", "force x, force y, torque (exit 1 if it is not resisted)")
    _add_number(margin, "--width", Fraction(1, 2**20), "length of the friction bracket")

    mapped = _add(commands, "map", _map, "binary search in N directions (exit 1 if it errs)")
    mapped.add_argument("--directions", type=int, default=72, metavar="N")
    _add_number(mapped, "--tolerance", Fraction(1, 1000), "of the search")
    _add_number(mapped, "--limit", Fraction(1000), "largest magnitude tried")

    figure = _add(
        commands, "figure", _figure, "wrench-space slice, no preload and preload 1, as data"
    )
    _add_plane(figure)

    gaps = commands.add_parser(
        "gaps", help="seeded search for grasps that a binary search misjudges"
    )
    gaps.add_argument("--contacts", type=int, default=3, metavar="M")
    gaps.add_argument("--seed", type=int, default=29, metavar="SEED")
    gaps.add_argument("--tries", type=int, default=20, metavar="N")
    terminal.add_json_option(gaps)
    gaps.set_defaults(command=_gaps)


def _add(
    commands: Any, name: str, function: Callable[[argparse.Namespace], int], text: str
) -> argparse.ArgumentParser:
    """Add a subcommand that takes a grasp."""
    parser: argparse.ArgumentParser = commands.add_parser(name, help=text)
    parser.add_argument("grasp", metavar="GRASP", help="a path, - for stdin, or a built-in name")
    if name != "figure":
        _add_number(parser, "--preload", None, "use this preload at every contact")
    terminal.add_json_option(parser)
    parser.set_defaults(command=function)
    return parser


def _add_wrench(parser: argparse.ArgumentParser, name: str, text: str, default: Any = None) -> None:
    parser.add_argument(
        name,
        nargs=3,
        required=default is None,
        default=default,
        metavar=_AXES,
        type=terminal.rational_argument,
        help=text,
    )


def _add_number(parser: argparse.ArgumentParser, name: str, default: Any, text: str) -> None:
    shown = text if default is None else f"{text} (default: {to_text(default)})"
    parser.add_argument(
        name, metavar="Q", type=terminal.rational_argument, default=default, help=shown
    )


def _add_plane(parser: argparse.ArgumentParser) -> None:
    _add_wrench(parser, "--origin", "a wrench of the plane (default: zero)", _ZERO)
    _add_wrench(parser, "--first", "first span (default: force x)", (1, 0, 0))
    _add_wrench(parser, "--second", "second span (default: force y)", (0, 1, 0))


def _grasp(arguments: argparse.Namespace) -> Grasp:
    from equilibrium.io.files import read_grasp

    grasp = read_grasp(arguments.grasp)
    preload = getattr(arguments, "preload", None)
    return grasp if preload is None else grasp.with_preload(preload)


def _show(
    arguments: argparse.Namespace,
    document: dict[str, Any],
    lines: Iterable[str],
    yes: bool,
    grasp: Grasp | None = None,
) -> int:
    """Print one JSON object or the lines, with the units of a grasp; return the exit code."""
    units = None if grasp is None else grasp.units
    if arguments.json:
        terminal.print_json({**document, "units": units.to_dict()} if units else document)
    else:
        for line in [str(units), *lines] if units else lines:
            print(line)
    return terminal.YES if yes else terminal.NO


def _limit(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import resisted_magnitudes

    grasp = _grasp(arguments)
    found = resisted_magnitudes(grasp, arguments.direction, arguments.base)
    lines = [f"resisted for t in {_intervals(found.intervals)}"]
    return _show(arguments, found.to_dict(), lines, bool(found.intervals), grasp)


def _region(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import resistible_region

    spans = (arguments.first, arguments.second)
    grasp = _grasp(arguments)
    region = resistible_region(grasp, spans, arguments.origin)
    lines = _region_lines(region)
    return _show(arguments, region.to_dict(), lines, bool(region.polygons), grasp)


def _region_lines(region: Region) -> Iterable[str]:
    from equilibrium.wrench_sets import polygon_cycle

    yield f"{len(region.polygons)} polygons (corners counter-clockwise; then rays, lines)"
    for piece in region.polygons:
        shape = piece.polyhedron
        parts = [_points(polygon_cycle(shape))]
        parts += [f"rays {_points(shape.rays)}"] if shape.rays else []
        parts += [f"lines {_points(shape.lines)}"] if shape.lines else []
        yield f"  {' '.join(piece.states)}: {'; '.join(parts)}"
    outline = region.outline
    for name, segments in (("border", outline.border), ("whisker", outline.whiskers)):
        yield from (f"{name} {_segment(segment)}" for segment in segments)
    yield from (f"point {_points([point])}" for point in outline.points)
    for sector in region.unlimited:
        ends = f"from {_points([sector.start])} counter-clockwise to {_points([sector.end])}"
        yield f"without limit: {'all directions' if sector.whole else ends}"


def _polyhedra(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import resistible_set

    grasp = _grasp(arguments)
    whole = resistible_set(grasp)
    lines = [f"{len(whole.pieces)} polyhedra (conditions a x + b y + c r + d >= 0 or = 0)"]
    for piece in whole.pieces:
        lines.append(f"  {' '.join(piece.states)}")
        shape = piece.polyhedron
        lines += [f"    {_points([row])} >= 0" for row in shape.inequalities]
        lines += [f"    {_points([row])} = 0" for row in shape.equalities]
    return _show(arguments, whole.to_dict(), lines, bool(whole.pieces), grasp)


def _margin(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import least_friction, margin, sufficient_preloads

    grasp = _grasp(arguments)
    found = margin(grasp, arguments.wrench)
    preloads = sufficient_preloads(grasp, arguments.wrench)
    friction = least_friction(grasp, arguments.wrench, arguments.width)
    document = {
        **found.to_dict(),
        "preload": preloads.to_dict(),
        "friction": friction.to_dict(),
    }
    lines = [
        f"resisted: {'yes' if found.resisted else 'no'}",
        f"resisted when scaled by a factor in {_intervals(found.intervals)}",
        f"resisted with a uniform preload in {_intervals(preloads.intervals)}" + _force(grasp),
        "least uniform friction: " + _bracket(friction.low, friction.high),
    ]
    return _show(arguments, document, lines, found.resisted, grasp)


def _map(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import search_map

    grasp = _grasp(arguments)
    found = search_map(grasp, arguments.directions, arguments.tolerance, arguments.limit)
    unit = _force(grasp)
    lines = [
        f"{len(found.entries)} directions, tolerance {to_text(found.tolerance)}{unit}, "
        f"limit {to_text(found.limit)}{unit}: the search errs in {len(found.disagreements)}"
    ]
    for entry in found.entries:
        answer = "without limit" if entry.found is None else f"up to {float(entry.found):.4f}{unit}"
        shown = ", ".join(f"{float(x):+.4f}" for x in entry.direction)
        wrong = "" if entry.agrees else f"; exactly {_intervals(entry.exact)}"
        lines.append(f"  ({shown})  {answer}{wrong}")
    return _show(arguments, found.to_dict(), lines, not found.disagreements, grasp)


def _figure(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import resistance_figure

    spans = (arguments.first, arguments.second)
    grasp = _grasp(arguments)
    data = resistance_figure(grasp, spans, arguments.origin)
    lines = ["wrench-space slice: " + " ".join(f"({', '.join(p)})" for p in _corners(data))]
    for name in ("no_preload", "preload_1"):
        part = data[name]
        borders, sectors = len(part["outline"]["border"]), len(part["unlimited"])
        lines.append(
            f"{name}: {len(part['polygons'])} polygons, {borders} border parts, "
            f"{sectors} sectors without limit (all of it with --json)"
        )
    return _show(arguments, data, lines, True, grasp)


def _gaps(arguments: argparse.Namespace) -> int:
    from equilibrium.wrench_sets import gaps

    found = list(gaps(arguments.contacts, arguments.seed, arguments.tries))
    document = [
        {
            "grasp": gap.grasp.to_dict(),
            "direction": [to_text(x) for x in gap.direction],
            "intervals": [[_end(low), _end(high)] for low, high in gap.intervals],
        }
        for gap in found
    ]
    lines = [f"{len(found)} found"]
    for gap in found:
        lines.append(f"direction {_points([gap.direction])}: {_intervals(gap.intervals)}")
        lines += [
            f"  point {_points([c.point])} normal {_points([c.normal])} friction {c.friction}"
            for c in gap.grasp
        ]
    return _show(arguments, {"gaps": document}, lines, bool(found))


def _corners(data: dict[str, Any]) -> list[list[str]]:
    corners: list[list[str]] = data["grasp_wrench_space"]["corners"]
    return corners


def _force(grasp: Grasp) -> str:
    """Return what to write after a number that is a force."""
    return f" {grasp.units.force}" if grasp.units else ""


def _intervals(intervals: Iterable[Interval]) -> str:
    shown = [
        f"[{_end(low)}, " + ("no end)" if high is None else f"{_end(high)}]")
        for low, high in intervals
    ]
    return " or ".join(shown) if shown else "no interval"


def _bracket(low: Fraction | None, high: Fraction | None) -> str:
    if low is None:
        return "none is enough"
    if high is None:
        return f"not below {to_text(low)}; none found above"
    return to_text(high) if low == high else f"above {to_text(low)}, at most {to_text(high)}"


def _segment(segment: Segment) -> str:
    start = "without end" if segment.start is None else _points([segment.start])
    end = "without end" if segment.end is None else _points([segment.end])
    return f"{start} to {end}, direction {_points([segment.direction])}"


def _points(points: Iterable[Iterable[Fraction | int]]) -> str:
    return " ".join(f"({', '.join(map(to_text, point))})" for point in points)


def _end(end: Fraction | None) -> str | None:
    return None if end is None else to_text(end)
