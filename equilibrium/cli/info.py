"""The subcommand ``equilibrium info``: a grasp, a report on it, its closure, its contact modes."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, islice
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import bracket, counted, number, vector
from arrangement.console.options import values
from arrangement.console.progress import shown
from arrangement.console.writing import write_text_atomically
from arrangement.errors import OutOfReachError
from arrangement.numbers.exact import RationalVector, primitive
from arrangement.numbers.linear.rank import rank
from equilibrium.model.contact import contact_entry, contact_words, pyramid_words
from equilibrium.model.errors import GraspError
from equilibrium.model.labels import AS_ROUNDED, ROUNDED
from equilibrium.model.solution import numbering_words

from .arguments import (
    Bodies,
    add_applied,
    add_command,
    add_cone,
    add_number,
    applied,
    bodies_of,
    grasp_of,
    has_load,
    show,
)
from .goes_with import ASSEMBLY, DESCRIPTION, REPORT, check_options

if TYPE_CHECKING:
    from arrangement.numbers.linear.intervals import Interval
    from equilibrium.decide.verdict import Verdict
    from equilibrium.methods.closure_friction import ClosureFriction
    from equilibrium.methods.force_closure import ForceClosure
    from equilibrium.model.grasp import Grasp

_WORDS = {True: "yes", False: "no", None: "undecided"}
#: Contacts of a grasp that are printed; more are only counted.
_MOST_CONTACTS = 20
#: Contacts up to which the least friction for closure is bracketed; more take longer.
_MOST_WITH_LEAST_FRICTION = 40


def add_command_info(commands: Any) -> None:
    """Add info."""
    text = "describe a grasp, its force closure, a report of a load, or its contact modes"
    answers = (
        "done or force closure or resisted",
        "no force closure or not resisted",
        "undecided",
    )
    parser = add_command(commands, "info", _info, text, *answers)
    text = "report: also decide this force (f_x, f_y) and torque tau, with its margin"
    add_applied(parser, text=text)
    parser.add_argument(
        "-o", "--output", metavar="FILE.html", help="report: write it as a page with a picture"
    )
    forms = parser.add_mutually_exclusive_group()
    text = "measure the Grasp Wrench Space: force closure, epsilon, slice, facets"
    forms.add_argument("--force-closure", action="store_true", help=text)
    text = "list the contact modes of rigid contacts, from kinematics alone"
    forms.add_argument("--modes", action="store_true", help=text)
    text = "with --force-closure: norm of the normal forces (default: L1)"
    parser.add_argument("--norm", choices=("L1", "Linf"), help=text)
    text = "with --force-closure: divide torques by this to compare them with forces (default: 1)"
    add_number(parser, "--torque-length", None, text)
    text = "with --force-closure: applied torque of the slice (default: 0)"
    add_number(parser, "--torque", None, text, "TAU")
    add_cone(parser)
    text = "with --modes: print only their number"
    parser.add_argument("--count", action="store_true", default=None, help=text)
    text = "with --modes: stop after SECONDS with exit code 2"
    parser.add_argument("--time-limit", metavar="SECONDS", type=values.seconds_argument, help=text)


def _info(arguments: argparse.Namespace) -> int:
    form, answer = DESCRIPTION, _description
    if has_load(arguments) or arguments.output is not None:
        form = REPORT
    if arguments.modes:
        form, answer = "--modes", _modes
    elif arguments.force_closure:
        form, answer = "--force-closure", _force_closure
    check_options(arguments, "info", None, form)
    return answer(arguments)


def _description(arguments: argparse.Namespace) -> int:
    """Print contacts, stiffness, rank of the tangential hyperplanes and force closure.

    With a load, or a page to write, that is the report.
    """
    from equilibrium.methods.force_closure import force_closure

    bodies = bodies_of(arguments)
    if bodies is not None:
        return _of_assembly(arguments, bodies)
    grasp = grasp_of(arguments)
    closed, parts = force_closure(grasp), grasp.parts
    given = any(contact.stiffness_given for contact in grasp)
    known, planes = _rank([row for contact in grasp for row in contact.tangential_wrenches])
    document: dict[str, Any] = {
        "contacts": [contact_entry(points) for points in parts],
        "dimension": grasp.dimension,
        "stiffness_given": given,
    }
    document |= known | closed.to_dict()
    points = f" ({counted(len(grasp), 'point')})" if grasp.has_pads else ""
    place = "in the plane" if grasp.dimension == 2 else "in space"
    lines = [
        f"contacts         {len(parts)}{points}, {place}",
        *_numbered(map(contact_words, parts), len(parts)),
        f"stiffness        {'given' if given else '1 (default)'}",
        planes,
        _closure_line(grasp, closed),
    ]
    wrench = applied(arguments, grasp) if has_load(arguments) else None
    if wrench is not None or arguments.output is not None:
        return _give_report(arguments, grasp, wrench, document, lines)
    return show(arguments, document, lines, True, grasp)


def _of_assembly(arguments: argparse.Namespace, bodies: Bodies) -> int:
    """Print bodies, contacts, and the rank of the tangential hyperplanes of an assembly."""
    check_options(arguments, "info", ASSEMBLY)
    assembly, wrenches = bodies.assembly, bodies.wrenches(required=False)
    known, planes = _rank([row.tangential_wrenches[0] for row in assembly.rows])
    words = (f"{c.pair} {c.contact.words}" for c in assembly.contacts)
    lines = [
        f"bodies           {len(assembly.bodies)}",
        *(f"  {name}{f'  wrench {vector(w)}' * bodies.has_key}" for name, w in wrenches.items()),
        f"contacts         {len(assembly)}",
        *_numbered(words, len(assembly)),
        f"{planes} in R^{assembly.rows.n}",
    ]
    document = assembly.to_dict(wrenches if bodies.has_key else None)
    return show(arguments, document | known, lines, True, assembly)


def _rank(wrenches: Sequence[RationalVector]) -> tuple[dict[str, int], str]:
    """Return the number of tangential hyperplanes and their rank, for a document and as a line."""
    known = {"tangential_hyperplanes": len(wrenches), "rank": rank(list(map(primitive, wrenches)))}
    planes = counted(len(wrenches), "tangential hyperplane")
    return known, f"rank             {known['rank']} of {planes}"


def _numbered(words: Iterable[str], count: int) -> Iterator[str]:
    """Yield lines for the first contacts, and how many more there are."""
    for i, text in enumerate(islice(words, _MOST_CONTACTS), 1):
        yield f"  contact {i} {text}"
    if count > _MOST_CONTACTS:
        yield f"  ... and {counted(count - _MOST_CONTACTS, 'contact')} more"


def _closure_line(grasp: Grasp, closed: ForceClosure) -> str:
    """Return the answer, in space with the cones that it is about."""
    proof = "close to the boundary" if closed.accepts is None else "proved"
    about = f" (round cones, {proof})" if grasp.dimension == 3 else ""
    return f"force closure    {_WORDS[closed.accepts]}{about}"


def _friction_line(least: ClosureFriction) -> str:
    """Return the least uniform friction for closure."""
    if least.low is None:
        return "least friction   none is enough (the same at all contacts), proved"
    if least.high is None:
        return f"least friction   above {number(least.low)}, proved; undecided from there on"
    if least.high == 0:
        return "least friction   0, proved"
    return (
        f"least friction   {bracket(least.low, least.high)} (the same at all contacts), both proved"
    )


def _force_closure(arguments: argparse.Namespace) -> int:
    """Print force closure, and the Grasp Wrench Space: epsilon, slice, facets."""
    from equilibrium.methods.closure_friction import closure_friction
    from equilibrium.methods.force_closure import force_closure
    from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace
    from equilibrium.model.contact import pyramid_edges

    grasp, edges = grasp_of(arguments), arguments.cone or 4
    if arguments.cone is not None:
        pyramid_edges(edges, grasp.dimension)
    if grasp.dimension == 3 and arguments.torque:
        raise GraspError("--torque is for slices in the plane; omit it in space")
    length = Fraction(1) if arguments.torque_length is None else arguments.torque_length
    space = GraspWrenchSpace(grasp, arguments.norm or "L1", length, edges)
    closed = force_closure(grasp)
    document = closed.to_dict() | {"norm": space.norm, "length": space.length}
    lines = [_closure_line(grasp, closed)]
    if closed.free_motion is not None:
        lines.append(f"free motion      {vector(closed.free_motion)}: no contact force opposes it")
    if len(grasp) <= _MOST_WITH_LEAST_FRICTION:
        least = closure_friction(grasp)
        document["least_friction"] = least.to_dict()
        lines.append(_friction_line(least))
    else:
        lines.append(f"least friction   not computed above {_MOST_WITH_LEAST_FRICTION} contacts")
    if grasp.dimension == 3:
        document["pyramid"] = edges
        lines.append(f"linearised space {pyramid_words(edges)}, inside the round cones:")
    try:
        document |= space.to_dict()
        lines += space.lines()
    except OutOfReachError as error:
        if arguments.cone is not None:
            raise
        lines.append(f"epsilon          not computed: {error}")
    if grasp.dimension == 2:
        torque = arguments.torque or Fraction(0)
        corners = space.slice(origin=(0, 0, torque))
        document |= {"volume": space.volume, "slice": {"torque": torque, "corners": corners}}
        turn = f" {grasp.units.torque}" if grasp.units else ""
        lines.append(f"resisted forces at torque {number(torque)}{turn}:")
        lines += (f"  {vector(c)}" for c in corners)
    return show(arguments, document, lines, closed.accepts, grasp)


def _modes(arguments: argparse.Namespace) -> int:
    """Print the contact modes of a grasp, of an assembly, or of bodies given by normals."""
    from arrangement.library.files.json_files import read_document
    from equilibrium.grasps.inputs.csv_file import is_table
    from equilibrium.modes import ContactModes

    limit, groups = arguments.time_limit, tuple[range, ...]()
    if is_table(arguments.grasp):
        bodies = bodies_of(arguments)
        document = {} if bodies is None else bodies.assembly.to_dict()
    else:
        arguments.grasp = document = read_document(arguments.grasp, ("contacts", "normals"))
    if {"normals", "bodies"} & set(document):
        modes = ContactModes.from_dict(document, time_limit=limit)
    else:
        grasp = grasp_of(arguments)
        modes, groups = ContactModes.of_grasp(grasp, time_limit=limit), grasp.groups
    with shown():
        document = modes.to_dict(arguments.count) if arguments.json else {}
        numbering = filter(None, [numbering_words(groups, "a mode")])
        return show(arguments, document, chain(modes.lines(arguments.count), numbering))


#: Title and text of each line of the report, in the order in which they are printed.
Rows = list[tuple[str, str]]


def _give_report(
    arguments: argparse.Namespace,
    grasp: Grasp,
    wrench: RationalVector | None,
    document: dict[str, Any],
    lines: Sequence[str],
) -> int:
    """Print the report, and write it as a page where one is wanted; return the exit code.

    Args:
        wrench: the load to decide, if there is one.
        document, lines: the description of the grasp, which comes first.
    """
    rows: Rows = [("units", str(grasp.units) if grasp.units else "not stated")]
    if grasp.data_error is not None:
        rows.append(("rounding", "numbers were rounded to exact ones; see the data error"))
    rows += _report_closure(grasp, document)
    yes: bool | None = True
    verdict: Verdict | None = None
    factors: Sequence[Interval] = ()
    if wrench is not None:
        verdict, factors, more = _report_load(grasp, wrench, document)
        yes = verdict.stable if verdict.decided and not verdict.depends else None
        rows += more
    rows += [("remark", remark) for remark in arguments.remarks]
    if arguments.output is not None:
        from equilibrium.pictures.report_page import report_page

        described = [(line[:17].strip(), line[17:]) for line in lines]
        page = report_page(grasp, [*described, *rows], verdict, factors, arguments.remarks)
        write_text_atomically(arguments.output, page)
    printed = (
        f"{title if k == 0 else '':<16} {line}"
        for title, text in rows
        for k, line in enumerate(text.splitlines())
    )
    return show(arguments, document, [*lines, *printed], yes, grasp)


def _report_closure(grasp: Grasp, document: dict[str, Any]) -> Rows:
    """Return form closure, and epsilon of the Grasp Wrench Space, as rows; add them."""
    from equilibrium.methods.form_closure import form_closure
    from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace

    document["form_closure"] = form_closure(grasp).accepts is True
    rows = [("form closure", "yes" if document["form_closure"] else "no")]
    try:
        space = GraspWrenchSpace(grasp)
        document["epsilon_squared"] = space.epsilon_squared
        cones = pyramid_words(space.pyramid, before="; of ") if grasp.dimension == 3 else ""
        stuck = "; without adhesion" if any(grasp.adhesion_wrench) else ""
        rows.append(("epsilon", f"{space.epsilon:.6g} (L1, torques over 1{cones}{stuck})"))
    except OutOfReachError:
        rows.append(("epsilon", "not computed: too many contacts"))
    return rows


def _report_load(
    grasp: Grasp, load: RationalVector, document: dict[str, Any]
) -> tuple[Verdict, Sequence[Interval], Rows]:
    """Return the verdict on a load, its factors, and both as rows; add them to the document."""
    from equilibrium.wrench_sets import ResistedSet
    from equilibrium.wrench_sets.text import end_lines, factors_text

    resisted = ResistedSet(grasp)
    verdict: Verdict = resisted.solve(load)
    document |= {"wrench": load, "verdict": verdict.verdict}
    lines = verdict.lines()
    if verdict.rounding is not None:
        document["within_error"] = verdict.rounding.to_dict()
        lines.insert(0, verdict.rounding.words)
    intervals: Sequence[Interval] = ()
    rows = [("load", vector(load)), ("verdict", "\n".join(lines))]
    if grasp.dimension == 2 and any(load):
        factors = resisted.margin(load)
        intervals = factors.intervals
        least = factors.preloads.least
        gives, ends = end_lines(resisted, factors.magnitudes)
        document |= {**factors.magnitudes.to_dict(), **gives, "least_preload": least}
        force = f" {grasp.units.force}" if grasp.units else ""
        margin = factors_text(factors.intervals)
        preload = "none is enough" if least is None else f"{number(least)}{force}"
        if grasp.data_error is not None:
            margin, preload = f"{margin}, {AS_ROUNDED}", f"{preload}, {ROUNDED}"
        rows += [("margin", "\n".join([margin, *ends])), ("least preload", preload)]
    return verdict, intervals, rows
