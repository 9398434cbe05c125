"""The subcommand ``equilibrium resisted``: which wrenches a grasp resists, in eight forms.

Two of them, magnitudes of a load and its margin, are for assemblies of several bodies, too.
"""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from arrangement.console.options import values
from equilibrium.model.contact import contact_entry, contact_words
from equilibrium.model.errors import GraspError, UndecidedError

from .arguments import (
    Bodies,
    add_applied,
    add_command,
    add_displacement,
    add_number,
    add_on_body,
    add_wrench,
    applied,
    bodies_of,
    contact_number,
    force_given,
    grasp_of,
    has_load,
    show,
    spanning_wrench,
)
from .goes_with import ASSEMBLY, BEST, FRICTION, GRASP, LOAD, PARAMETER, WHOLE_SET, check_options

if TYPE_CHECKING:
    from equilibrium.model.assembly import Assembly
    from equilibrium.model.grasp import Grasp
    from equilibrium.wrench_sets import ResistedSet
    from equilibrium.wrench_sets.text import Answer


def add_command_resisted(commands: Any) -> None:
    """Add resisted, whose options choose a form: a load, its margin, a slice, the whole set."""
    text = "compute the set of resisted wrenches, or the limits, margin or friction of a load"
    answers = ("resisted at least in part", "not resisted or the search errs", "undecided")
    parser: Any = add_command(commands, "resisted", _resisted, text, *answers, heading="common")
    text = "only the resisted magnitudes of this force (f_x, f_y) and torque tau"
    forms = add_applied(parser, text=text)
    text = "the resisted magnitudes of this wrench on one body, added to the wrenches of the file"
    add_on_body(forms, "--along", text)
    add_on_body(parser)
    parser.description += " In space: along a load only, without --margin."
    rational, contact = values.rational_argument, contact_number
    text = "planar grasps: find the smallest wrench that is not resisted, in any direction"
    forms.add_argument("--smallest", action="store_true", help=text)
    text = (
        "planar grasps: find the least force at this point, in any direction, with which the load "
        "is no longer resisted"
    )
    place = ("X", "Y")
    parser.add_argument("--best-direction", nargs=2, type=rational, metavar=place, help=text)
    text = "planar grasps: only the plane spanned by two of fx, fy, tau or vectors such as 1,0,0"
    forms.add_argument("--slice", nargs=2, metavar=("U", "V"), type=spanning_wrench, help=text)
    text = "planar grasps: search for the largest force in N directions, as the paper does"
    forms.add_argument("--search", action="store_true", help=text)
    text = "print by which factors the load may be scaled, and the least preload and friction"
    parser.add_argument("--margin", action="store_true", help=text)
    text = "with --margin: change the preload and friction of these contacts only"
    parser.add_argument("--contacts", nargs="+", type=contact, metavar="NUMBER", help=text)
    text = "with --contacts: another wrench that must be resisted with the preload; repeatable"
    style: dict[str, Any] = {"action": "append", "metavar": ("F_X", "F_Y", "TAU")}
    parser.add_argument("--also", nargs=3, type=rational, help=text, **style)
    text = "find the values of a letter in the file, as in t=0..1, with which its load is resisted"
    parser.add_argument("--parameter", metavar="LETTER=FROM..TO", help=text)
    text = "find the least friction of these contacts, with certificates just above and below it"
    parser.add_argument("--friction", nargs="+", type=contact, metavar="NUMBER", help=text)
    text = (
        "with a load: list the contacts of this file with which, each added alone, it is resisted"
    )
    parser.add_argument("--candidates", metavar="FILE", help=text)
    text = "with a load, --smallest or --best-direction: a wrench that acts as well (default: 0)"
    add_wrench(parser, "--base", text)
    text = "with --smallest: divide torques by this to compare them with forces (default: 1)"
    add_number(parser, "--torque-length", None, text)
    add_wrench(parser, "--origin", "with --slice: a wrench in the plane (default: 0)")
    text = "with --search: number of directions (default: 72)"
    parser.add_argument("--rays", type=values.count_argument, metavar="N", help=text)
    text = "with --search: largest magnitude tried (default: 1000)"
    add_number(parser, "--max-magnitude", None, text)
    text = (
        "accepted error of the friction of --margin (default: 1/1048576), of the magnitudes of "
        "--search (default: 1/1000), of --parameter and --friction (default: 1/1000000)"
    )
    add_number(parser, "--tolerance", None, text)
    add_displacement(parser)


def _resisted(arguments: argparse.Namespace) -> int:
    if arguments.parameter is not None or arguments.friction is not None:
        return show(arguments, *_values(arguments))
    bodies = bodies_of(arguments)
    if bodies is not None:
        return show(arguments, *_of_assembly(arguments, bodies), bodies.assembly)
    form = _form(arguments)
    _check_form(arguments, GRASP, form)
    grasp = grasp_of(arguments)
    return show(arguments, *_answer(arguments, grasp, form), grasp)


def _check_form(arguments: argparse.Namespace, subject: str | None, form: str) -> None:
    check_options(arguments, "resisted", subject, form)
    if arguments.margin and form != "--margin":
        raise GraspError(f"--margin goes with {LOAD}, not with {form}")


def _values(arguments: argparse.Namespace) -> Answer:
    """Return for which values of a letter, or of the friction of contacts, a load is resisted."""
    from equilibrium.grasps.inputs.parameter import read_parametric, read_range
    from equilibrium.wrench_sets.parameter import TOLERANCE, resisted_values
    from equilibrium.wrench_sets.sufficient_friction import sufficient_friction
    from equilibrium.wrench_sets.text import answer_of

    if None not in (arguments.parameter, arguments.friction):
        raise GraspError(f"{PARAMETER} and {FRICTION} are two questions; give one of them")
    form = PARAMETER if arguments.friction is None else FRICTION
    _check_form(arguments, None, form)
    for name in ("preload", "round_normals", "as_given"):
        if getattr(arguments, name, None) not in (None, False):
            option = name.replace("_", "-")
            raise GraspError(f"--{option} does not go with {form}; write it into the file")
    tolerance = arguments.tolerance or TOLERANCE
    load = arguments.on or force_given(arguments) or arguments.wrench
    if arguments.friction is not None:
        chosen = arguments.friction
        return answer_of(sufficient_friction(arguments.grasp, chosen, load, tolerance))
    letter, low, high = read_range(arguments.parameter)
    family = read_parametric(arguments.grasp, letter, load)
    return answer_of(resisted_values(family, low, high, tolerance=tolerance))


def _form(arguments: argparse.Namespace) -> str:
    """Return which form of the command is meant."""
    if arguments.best_direction is not None:
        return BEST
    if has_load(arguments):
        return "--margin" if arguments.margin else LOAD
    if arguments.slice is not None:
        return "--slice"
    if arguments.smallest:
        return "--smallest"
    return "--search" if arguments.search else WHOLE_SET


def _answer(arguments: argparse.Namespace, grasp: Grasp, form: str) -> Answer:
    """Return the answer about a grasp in one of the forms."""
    from equilibrium.grasps.inputs.documents import question_document
    from equilibrium.wrench_sets import text

    resisted, base = _set(arguments, grasp), arguments.base or 0
    if form == LOAD:
        if arguments.candidates is not None:
            return _candidates(arguments, grasp, resisted)
        magnitudes: Any = resisted.along(applied(arguments, grasp), base)
        if grasp.dimension == 3:
            return text.spatial_answer(magnitudes)
        return text.along_answer(resisted, magnitudes)
    if form == "--margin":
        wrench = applied(arguments, grasp)
        question_document(grasp, wrench, "margin")
        if grasp.dimension == 3:
            raise GraspError(
                "--margin is for grasps in the plane and assemblies; in space omit it: the "
                "magnitudes t that are printed are the factors of the load"
            )
        return _margin(arguments, resisted, wrench)
    if form == BEST:
        load = _with_base(arguments, grasp) if has_load(arguments) else base or (0, 0, 0)
        return text.answer_of(resisted.best_direction(load, arguments.best_direction), grasp)
    if form == "--smallest":
        length = 1 if arguments.torque_length is None else arguments.torque_length
        return text.answer_of(resisted.smallest_outside(base, length), grasp)
    if form == "--slice":
        u, v = arguments.slice
        return text.answer_of(resisted.slice(u, v, arguments.origin or 0))
    if form == "--search":
        chosen = {name: getattr(arguments, name) for name in ("rays", "tolerance", "max_magnitude")}
        options = {name: value for name, value in chosen.items() if value is not None}
        return text.answer_of(resisted.search(**options), grasp)
    return text.answer_of(resisted)


def _of_assembly(arguments: argparse.Namespace, bodies: Bodies) -> Answer:
    """Return magnitudes of wrenches on bodies, or the margin of those of the file."""
    from equilibrium.decide import undecided
    from equilibrium.wrench_sets.text import Answer, along_answer

    check_options(arguments, "resisted", ASSEMBLY)
    if arguments.margin == (arguments.along is not None):
        raise GraspError(
            "an assembly takes either --along BODY F_X F_Y TAU, the direction of a wrench besides "
            "those of its file, or --margin, how far these may be scaled"
        )
    check_options(arguments, "resisted", ASSEMBLY, "--margin" if arguments.margin else "--along")
    wrenches = bodies.wrenches(arguments.on, required=arguments.margin)
    resisted = _set(arguments, bodies.assembly)
    try:
        if arguments.margin:
            return _margin(arguments, resisted, wrenches)
        magnitudes: Any = resisted.along(arguments.along, wrenches)
    except UndecidedError as unknown:
        return Answer(undecided(unknown), [f"undecided: {unknown}"], None)
    return along_answer(resisted, magnitudes)


def _set(arguments: argparse.Namespace, grasp: Grasp | Assembly) -> ResistedSet:
    from equilibrium.wrench_sets import ResistedSet

    return ResistedSet(grasp, max_displacement=arguments.max_displacement)


def _candidates(arguments: argparse.Namespace, grasp: Grasp, resisted: ResistedSet) -> Answer:
    """Return which candidate contacts, each added alone, make the grasp resist the load."""
    from equilibrium.grasps.inputs import read_any
    from equilibrium.wrench_sets.text import Answer

    candidates = read_any(arguments.candidates, round_normals=arguments.round_normals)
    wrench = _with_base(arguments, grasp)
    with_each = resisted.with_contact(candidates.grasp)
    verdicts = [changed.solve(wrench).verdict for changed in with_each]
    tried = list(zip(candidates.grasp.parts, verdicts, strict=True))
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
    return Answer(document, lines, yes)


def _with_base(arguments: argparse.Namespace, grasp: Grasp) -> list[Any]:
    """Return the load with what acts in any case."""
    start = grasp.read_wrench(applied(arguments, grasp))
    loads = [start, grasp.read_wrench(arguments.base)] if arguments.base else [start]
    return list(map(sum, zip(*loads, strict=True)))


def _margin(arguments: argparse.Namespace, resisted: ResistedSet, load: Any) -> Answer:
    from equilibrium.wrench_sets.text import margin_answer

    chosen, also = arguments.contacts, arguments.also
    if also is not None and chosen is None:
        raise GraspError("--also goes with --contacts")
    bound = {} if arguments.tolerance is None else {"tolerance": arguments.tolerance}
    return margin_answer(resisted, resisted.margin(load), chosen, also or (), **bound)
