"""The subcommand ``equilibrium resisted``: which wrenches a grasp resists, in six forms.

Two of them, magnitudes of a load and its margin, are for assemblies of several bodies, too.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import bracket, counted, number, vector
from arrangement.console.options import values
from arrangement.numbers.exact import number_text
from equilibrium.model.contact import contact_entry, contact_words
from equilibrium.model.errors import GraspError, UndecidedError
from equilibrium.model.labels import AS_ROUNDED, ROUNDED

from .arguments import (
    add_applied,
    add_command,
    add_displacement,
    add_number,
    add_wrench,
    among_text,
    applied,
    factors_text,
    force_given,
    grasp_of,
    intervals_text,
    resisted_text,
    show,
    spanning_wrench,
)
from .assemblies import (
    add_on_body,
    asked_assembly,
    assembly_document,
    or_undecided,
    refuse_one_body,
)
from .resisted_in_space import show_in_space

if TYPE_CHECKING:
    from arrangement.numbers.linear.intervals import Interval
    from equilibrium.model.assembly import Assembly
    from equilibrium.model.grasp import Grasp
    from equilibrium.wrench_sets import (
        Magnitudes,
        Margin,
        Preloads,
        Region,
        ResistedSet,
        SearchMap,
        Segment,
        SmallestUnresisted,
    )

#: The forms of the command, as its errors call them.
_LOAD, _WHOLE = "a load (--wrench, --force or --weight)", "the whole set"
#: Options with the forms that they go with.
_GOES_WITH = {
    "base": (_LOAD, "--smallest"),
    "torque_length": ("--smallest",),
    "origin": ("--slice",),
    "rays": ("--search",),
    "max_magnitude": ("--search",),
    "tolerance": ("--margin", "--search"),
    "contacts": ("--margin",),
    "also": ("--margin",),
    "candidates": (_LOAD,),
    "max_displacement": (_LOAD, "--margin", "--smallest", "--slice", _WHOLE),
}


def add_command_resisted(commands: Any) -> None:
    """Add resisted, whose options choose a form: a load, its margin, a slice, the whole set."""
    text = "compute the set of resisted wrenches, or its part along a load"
    answers = ("resisted at least in part", "not resisted or the search errs", "undecided")
    parser: Any = add_command(commands, "resisted", _resisted, text, *answers, heading="common")
    text = "only the magnitudes resisted along this force (f_x, f_y) and torque tau"
    forms = add_applied(parser, text=text, required=False)
    text = "the magnitudes of this wrench on one body that are resisted besides those of its file"
    add_on_body(forms, "--along", text)
    add_on_body(parser)
    parser.description += " In space: along a load only, without --margin."
    text = "planar grasps: find the smallest wrench that is not resisted, in any direction"
    forms.add_argument("--smallest", action="store_true", help=text)
    text = "planar grasps: only the plane spanned by two of fx, fy, tau or vectors such as 1,0,0"
    forms.add_argument("--slice", nargs=2, metavar=("U", "V"), type=spanning_wrench, help=text)
    text = "planar grasps: search for the largest force in N directions, as the paper does"
    forms.add_argument("--search", action="store_true", help=text)
    text = "print how far the load may be scaled, and the preload and friction that resist it"
    parser.add_argument("--margin", action="store_true", help=text)
    text = "with --margin: the preload and the friction of these contacts; the others keep theirs"
    numbers = values.count_argument
    parser.add_argument("--contacts", nargs="+", type=numbers, metavar="NUMBER", help=text)
    text = "with --contacts: one more wrench that the preload has to resist; repeatable"
    parser.add_argument(
        "--also",
        nargs=3,
        action="append",
        type=values.rational_argument,
        metavar=("F_X", "F_Y", "TAU"),
        help=text,
    )
    text = "with a load: print which contacts of this file (as GRASP), each added alone, resist it"
    parser.add_argument("--candidates", metavar="FILE", help=text)
    text = "with a load or --smallest: a wrench that acts in any case (default: none)"
    add_wrench(parser, "--base", text, None)
    text = "with --smallest: divide torques by this to compare them with forces (default: 1)"
    add_number(parser, "--torque-length", None, text)
    add_wrench(parser, "--origin", "with --slice: a wrench of the plane (default: none)", None)
    text = "with --search: number of directions (default: 72)"
    parser.add_argument("--rays", type=values.count_argument, metavar="N", help=text)
    text = "with --search: largest magnitude tried (default: 1000)"
    add_number(parser, "--max-magnitude", None, text)
    text = "accepted error: of the friction of --margin (default: 1/1048576), of the magnitudes of "
    add_number(parser, "--tolerance", None, f"{text}--search (default: 1/1000)")
    add_displacement(parser)


#: Options that are about one body.
_ONE_BODY = (
    *("wrench", "force", "weight", "at", "base", "smallest", "torque_length"),
    *("slice", "origin", "search", "rays", "max_magnitude"),
    *("also", "candidates"),
)


def _resisted(arguments: argparse.Namespace) -> int:
    assembly = assembly_document(arguments)
    if assembly is not None:
        return _of_assembly(arguments, assembly)
    for option in ("on", "along"):
        if getattr(arguments, option) is not None:
            raise GraspError(f"--{option} is for an assembly; a grasp takes --wrench F_X F_Y TAU")
    form = _form(arguments)
    if arguments.margin and form != "--margin":
        raise GraspError(f"--margin goes with {_LOAD}, not with {form}")
    for option, forms in _GOES_WITH.items():
        if getattr(arguments, option) is not None and form not in forms:
            name = option.replace("_", "-")
            raise GraspError(f"--{name} goes with {' or '.join(forms)}, not with {form}")
    if form not in (_LOAD, "--margin"):
        force_given(arguments)  # refuses a place without a force
    grasp = grasp_of(arguments)
    command = {
        _LOAD: _along,
        "--margin": _margin,
        "--smallest": _smallest,
        "--slice": _slice,
        "--search": _search,
        _WHOLE: _whole,
    }[form]
    return command(arguments, grasp)


def _of_assembly(arguments: argparse.Namespace, document: Mapping[str, Any]) -> int:
    """Print magnitudes of wrenches on bodies, or the margin of those of the file."""
    from equilibrium.decide import undecided
    from equilibrium.wrench_sets import ResistedSet

    refuse_one_body(arguments, _ONE_BODY)
    if arguments.margin == (arguments.along is not None):
        raise GraspError(
            "an assembly takes either --along BODY F_X F_Y TAU, the direction of a wrench besides "
            "those of its file, or --margin, how far these may be scaled"
        )
    given = document, arguments.on, arguments.preload
    assembly, wrenches = asked_assembly(*given, required=arguments.margin)
    resisted = ResistedSet(assembly, max_displacement=arguments.max_displacement)
    try:
        if arguments.margin:
            return _show_margin(arguments, resisted, resisted.margin(wrenches))
        magnitudes: Any = resisted.along(arguments.along, wrenches)
    except UndecidedError as unknown:
        return show(arguments, undecided(unknown), [f"undecided: {unknown}"], None, assembly)
    return _show_along(arguments, resisted, magnitudes)


def _form(arguments: argparse.Namespace) -> str:
    """Return which form of the command is meant."""
    if any(getattr(arguments, name) is not None for name in ("wrench", "force", "weight")):
        return "--margin" if arguments.margin else _LOAD
    if arguments.slice is not None:
        return "--slice"
    chosen = (name for name in ("smallest", "search") if getattr(arguments, name))
    return next((f"--{name}" for name in chosen), _WHOLE)


def _set(arguments: argparse.Namespace, grasp: Grasp) -> ResistedSet:
    from equilibrium.wrench_sets import ResistedSet

    return ResistedSet(grasp, max_displacement=arguments.max_displacement)


def _along(arguments: argparse.Namespace, grasp: Grasp) -> int:
    if arguments.candidates is not None:
        return _candidates(arguments, grasp)
    resisted = _set(arguments, grasp)
    magnitudes: Any = resisted.along(applied(arguments, grasp), arguments.base or 0)
    if grasp.dimension == 3:
        return show_in_space(arguments, magnitudes)
    return _show_along(arguments, resisted, magnitudes)


def _show_along(
    arguments: argparse.Namespace, resisted: ResistedSet, magnitudes: Magnitudes
) -> int:
    """Print the magnitudes that are resisted, what gives at their ends, and other roundings."""
    gives, ends = end_lines(resisted, magnitudes)
    more, lines, depends = _with_rounding(resisted, magnitudes, resisted_text, ends)
    yes = None if depends else bool(magnitudes.intervals)
    return show(arguments, magnitudes.to_dict() | gives | more, lines, yes, resisted.grasp)


def _candidates(arguments: argparse.Namespace, grasp: Grasp) -> int:
    """Print which candidate contacts, each added alone, make the grasp resist the load."""
    from equilibrium.grasps.inputs import read_any

    found = read_any(arguments.candidates, round_normals=arguments.round_normals)
    start = grasp.read_wrench(applied(arguments, grasp))
    loads = [start, grasp.read_wrench(arguments.base)] if arguments.base else [start]
    wrench = list(map(sum, zip(*loads, strict=True)))
    sets = _set(arguments, grasp).with_contact(found.grasp)
    verdicts = [resisted.solve(wrench).verdict for resisted in sets]
    tried = list(zip(found.grasp.parts, verdicts, strict=True))
    lines = [
        f"candidate {i}  {verdict:<12}  {contact_words(points)}"
        for i, (points, verdict) in enumerate(tried, 1)
    ]
    document = {
        "candidates": [
            {"contact": contact_entry(points), "verdict": verdict} for points, verdict in tried
        ]
    }
    yes = True if "resisted" in verdicts else None if "undecided" in verdicts else False
    return show(arguments, document, lines, yes, grasp)


def _smallest(arguments: argparse.Namespace, grasp: Grasp) -> int:
    length = 1 if arguments.torque_length is None else arguments.torque_length
    smallest = _set(arguments, grasp).smallest_outside(arguments.base or 0, length)
    lines = _smallest_lines(smallest, grasp)
    return show(arguments, smallest.to_dict(), lines, smallest.size_squared != 0, grasp)


def _smallest_lines(found: SmallestUnresisted, grasp: Grasp) -> Iterator[str]:
    load = "with the base, " if any(found.base) else ""
    if found.size is None or found.wrench is None or found.beyond is None:
        yield f"{load}every wrench is resisted, whichever way it points and however large it is"
        return
    if found.size_squared:
        exact = found.size**2 == found.size_squared
        size = number(found.size) if exact else number_text(found.size, longest=0)
        squared = "" if exact else f" (its square is {number(found.size_squared)})"
        yield f"{load}every wrench smaller than {size}{_force(grasp)}{squared} is resisted"
        length = f"length {number(found.length)} (--torque-length)"
        yield f"  where size^2 = f_x^2 + f_y^2 + (tau / length)^2, {length}"
        yield f"on the boundary: {vector(found.wrench)}"
    else:
        yield f"{load}no size is resisted in every direction"
    yield f"not resisted: {vector(found.beyond)}"


def end_lines(
    resisted: ResistedSet, found: Magnitudes | Preloads
) -> tuple[dict[str, Any], list[str]]:
    """Return what gives at the ends of magnitudes or preloads: JSON form and lines."""
    ends = resisted.what_gives(found)
    lines = [
        f"  at {number(end)}: {given.words}"
        for interval, pair in zip(found.intervals, ends, strict=True)
        for end, given in zip(interval, pair, strict=True)
        if end is not None and given is not None
    ]
    return {"gives": [[x and x.to_dict() for x in pair] for pair in ends]}, lines


def _with_rounding(
    resisted: ResistedSet,
    found: Magnitudes,
    text: Callable[[Sequence[Interval]], str],
    ends: Sequence[str],
) -> tuple[dict[str, Any], list[str], bool]:
    """Return what is known of other roundings as JSON, all lines, and whether others differ.

    Args:
        text: of the magnitudes, or factors.
        ends: what gives there.
    """
    from equilibrium.decide.nearby import DEPENDS

    stated = text(found.intervals)
    if resisted.grasp.data_error is None:
        return {}, [stated, *ends], False
    # A wrench of zero has no direction in which others are compared.
    zero = not isinstance(found.direction, dict) and not any(found.direction)
    if zero or (again := resisted.within_error(found)) is None:
        return {"as_rounded": True}, [f"{stated}, {AS_ROUNDED}", *ends], False
    more = {"as_rounded": True, "within_error": again.to_dict()}
    if again.turned is not None:
        other = f"{text(again.turned)}, for other data within the rounding error"
        return more, [f"{DEPENDS}: {other}", f"{ROUNDED}: {stated}", *ends], True
    tried = f"  tried {again.asked} other data within the error: {_tried_text(again.ends)}"
    return more, [f"{stated}, {AS_ROUNDED}", *ends, *([tried] if again.asked else [])], False


def _tried_text(ends: Sequence[tuple[Any, Any] | None]) -> str:
    """Return what all others tried resist, of the least and greatest value of each end."""
    parts = []
    for low, high in zip(ends[::2], ends[1::2], strict=True):
        start = _between(*low) if low else "-oo"
        point = low == high and low is not None and low[0] == low[1]
        until = "on" if high is None else f"to {_between(*high)}"
        parts.append(f"at {start} only" if point else f"from {start} {until}")
    return f"resisted {' and '.join(parts) or 'for no t'}"


def _slice(arguments: argparse.Namespace, grasp: Grasp) -> int:
    u, v = arguments.slice
    region = _set(arguments, grasp).slice(u, v, arguments.origin or 0)
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
    for name, segments in (("boundary", outline.border), ("whisker", outline.whiskers)):
        yield from (f"{name} {_segment(segment)}" for segment in segments)
    yield from (f"point {vector(point)}" for point in outline.points)
    for sector in region.unlimited:
        ends = f"from {vector(sector.start)} counter-clockwise to {vector(sector.end)}"
        yield f"unbounded: {'all directions' if sector.whole else ends}"


def _whole(arguments: argparse.Namespace, grasp: Grasp) -> int:
    whole = _set(arguments, grasp)
    return show(arguments, whole.to_dict(), _set_lines(whole), bool(whole.polyhedra), grasp)


def _set_lines(whole: ResistedSet) -> Iterator[str]:
    many = counted(len(whole.polyhedra), "polyhedron", "polyhedra")
    yield f"{many} (conditions a f_x + b f_y + c tau + d >= 0 or = 0)"
    for piece in whole.polyhedra:
        yield f"  {' '.join(piece.states)}"
        yield from (f"    {vector(row)} >= 0" for row in piece.polyhedron.inequalities)
        yield from (f"    {vector(row)} = 0" for row in piece.polyhedron.equalities)


def _margin(arguments: argparse.Namespace, grasp: Grasp) -> int:
    from equilibrium.grasps.inputs.documents import question_document

    wrench = applied(arguments, grasp)
    question_document(grasp, wrench, "margin")
    if grasp.dimension == 3:
        raise GraspError(
            "--margin is for grasps in the plane and assemblies; in space omit it: the magnitudes "
            "t that are printed are the factors of the load"
        )
    resisted = _set(arguments, grasp)
    return _show_margin(arguments, resisted, resisted.margin(wrench))


def _show_margin(arguments: argparse.Namespace, resisted: ResistedSet, factors: Margin) -> int:
    """Print a margin, with the preload and the friction that resist the wrench."""
    from equilibrium.decide.assemblies.ends import listed_contacts
    from equilibrium.wrench_sets.friction import rough_contacts

    grasp, chosen = resisted.grasp, arguments.contacts
    whose, rubbing = "uniform preload", "uniform friction"
    if chosen is not None:
        named = listed_contacts(chosen)
        whose, rubbing = f"preload of {named}", f"friction of {named}"
        rubbing += ", for the load alone" if arguments.also else ""
    elif arguments.also is not None:
        raise GraspError("--also goes with --contacts")
    elif smooth := sorted({*grasp.contact_numbers} - {*rough_contacts(grasp)}):
        rubbing += f" with {listed_contacts(smooth)} smooth"
    loads = [factors.wrench, *(arguments.also or ())]
    tolerance = Fraction(1, 2**20) if arguments.tolerance is None else arguments.tolerance
    at_preloads: dict[str, Any] = {}

    def preload_text(found: Preloads) -> str:
        gives, ends = end_lines(resisted, found)
        at_preloads.update(gives)
        first = f"resisted with {among_text(found.intervals, whose)}{_force(grasp)}{doubt}"
        return "\n".join([first, *ends])

    doubt = "" if grasp.data_error is None else f", {ROUNDED}"
    preload, in_preloads = or_undecided(
        lambda: factors.preloads if chosen is None else resisted.preloads(loads, chosen),
        preload_text,
        f"resisted with a {whose}",
    )
    friction, coefficient = or_undecided(
        lambda: factors.friction(tolerance, chosen),
        lambda found: f"least {rubbing}: {_friction(found.low, found.high)}{doubt}",
        f"least {rubbing}",
    )
    gives, ends = end_lines(resisted, factors.magnitudes)
    more, scaled, changes = _with_rounding(resisted, factors.magnitudes, factors_text, ends)
    known = None if grasp.data_error is None else resisted.solve(factors.wrench).rounding
    word = "yes" if factors.resisted else "no"
    depends = known is not None and known.turned is not None
    if known is not None and not known.proved:
        word += f", for the data as rounded; it {known.words}" if depends else f", {AS_ROUNDED}"
    unknown = depends or changes or "verdict" in {*preload, *friction}
    yes = None if unknown else factors.resisted
    lines = [f"resisted: {word}", *scaled, in_preloads, coefficient]
    remedies = {"preload": preload | at_preloads, "friction": friction}
    return show(arguments, factors.to_dict() | gives | more | remedies, lines, yes, grasp)


def _search(arguments: argparse.Namespace, grasp: Grasp) -> int:
    values = {name: getattr(arguments, name) for name in ("rays", "tolerance", "max_magnitude")}
    given = {name: value for name, value in values.items() if value is not None}
    searched = _set(arguments, grasp).search(**given)
    lines = _map_lines(searched, _force(grasp))
    return show(arguments, searched.to_dict(), lines, not searched.disagreements, grasp)


def _map_lines(found: SearchMap, unit: str) -> Iterator[str]:
    yield (
        f"{counted(len(found.entries), 'direction')}, tolerance {number(found.tolerance)}{unit}, "
        f"limit {number(found.limit)}{unit}: the search errs in {len(found.disagreements)}"
    )
    for entry in found.entries:
        answer = "unbounded" if entry.found is None else f"up to {number(entry.found)}{unit}"
        shown = ", ".join(f"{float(x):+.4f}" for x in entry.direction)
        wrong = "" if entry.agrees else f"; exactly {intervals_text(entry.exact)}"
        yield f"  ({shown})  {answer}{wrong}"


def _force(grasp: Grasp | Assembly) -> str:
    """Return what to write after a number that is a force."""
    return f" {grasp.units.force}" if grasp.units else ""


def _between(low: Any, high: Any) -> str:
    return number(high) if low == high else bracket(low, high)


def _friction(low: Fraction | None, high: Fraction | None) -> str:
    if low is None:
        return "none is enough"
    if high is None:
        return f"not below {number(low)}; undecided above"
    return _between(low, high)


def _segment(segment: Segment) -> str:
    start = "unbounded" if segment.start is None else vector(segment.start)
    end = "unbounded" if segment.end is None else vector(segment.end)
    return f"{start} to {end}, direction {vector(segment.direction)}"


def _points(points: Iterable[Iterable[Fraction | int]]) -> str:
    return " ".join(map(vector, points))
