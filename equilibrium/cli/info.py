"""The subcommand ``equilibrium info``: a grasp, its force closure, its contact modes."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import chain
from math import gcd
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import counted, number, sign_text, vector
from arrangement.console.progress import shown
from equilibrium.model.contact import contact_entry, contact_words, pyramid_words
from equilibrium.model.errors import GraspError
from equilibrium.model.solution import numbering_words

from .arguments import (
    add_applied,
    add_command,
    add_cone,
    add_number,
    applied,
    force_given,
    grasp_of,
    seconds,
    show,
)
from .assemblies import asked_assembly, assembly_document, refuse_one_body

if TYPE_CHECKING:
    from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace
    from equilibrium.model.grasp import Grasp
    from equilibrium.modes import ContactModes, Slips

_WORDS = {True: "yes", False: "no"}
#: Options with the form that they go with.
_GOES_WITH = {
    "norm": "force_closure",
    "torque_length": "force_closure",
    "torque": "force_closure",
    "cone": "force_closure",
    "count": "modes",
    "time_limit": "modes",
}
#: Contacts of a grasp that are printed; more are only counted.
_MOST_CONTACTS = 20


def add_command_info(commands: Any) -> None:
    """Add info."""
    text = "describe a grasp, its force closure, a report of a load, or its contact modes"
    answers = (
        "done or force closure or resisted",
        "no force closure or not resisted",
        "undecided",
    )
    parser = add_command(commands, "info", _info, text, *answers)
    text = "report: decide this force (f_x, f_y) and torque tau, too, with its margin"
    add_applied(parser, text=text, required=False)
    parser.add_argument(
        "-o", "--output", metavar="FILE.html", help="report: write it as a page with a picture"
    )
    forms = parser.add_mutually_exclusive_group()
    text = "measure the Grasp Wrench Space: force closure, epsilon, slice, facets"
    forms.add_argument("--force-closure", action="store_true", help=text)
    text = "list contact modes: what rigid contacts can do, from kinematics alone"
    forms.add_argument("--modes", action="store_true", help=text)
    text = "with --force-closure: of the normal forces (default: L1)"
    parser.add_argument("--norm", choices=("L1", "Linf"), help=text)
    text = "with --force-closure: divide torques by this to compare them with forces (default: 1)"
    add_number(parser, "--torque-length", None, text)
    text = "with --force-closure: applied torque of the slice (default: 0)"
    add_number(parser, "--torque", None, text, "TAU")
    add_cone(parser)
    text = "with --modes: print their number only"
    parser.add_argument("--count", action="store_true", default=None, help=text)
    text = "with --modes: stop after SECONDS: exit code 2"
    parser.add_argument("--time-limit", metavar="SECONDS", type=seconds, help=text)


def _info(arguments: argparse.Namespace) -> int:
    for option, form in _GOES_WITH.items():
        if getattr(arguments, option) is not None and not getattr(
            arguments, form.replace("-", "_")
        ):
            raise GraspError(f"--{option.replace('_', '-')} goes with --{form.replace('_', '-')}")
    load = any(getattr(arguments, name) is not None for name in ("wrench", "force", "weight"))
    if (arguments.modes or arguments.force_closure) and (load or arguments.output is not None):
        form = "modes" if arguments.modes else "force-closure"
        raise GraspError(f"a load and --output are for the report; they do not go with --{form}")
    if arguments.modes:
        if arguments.preload is not None:
            raise GraspError("--preload does not go with --modes; modes do not depend on it")
        return _modes(arguments)
    if arguments.force_closure:
        return _force_closure(arguments)
    return _description(arguments, load)


def _description(arguments: argparse.Namespace, load: bool) -> int:
    """Print contacts, stiffness, rank of the tangential hyperplanes and force closure.

    With a load, or a page to write, that is the report.
    """
    from arrangement.numbers.exact import primitive
    from arrangement.numbers.linear.rank import rank
    from equilibrium.methods.form_closure import form_closure

    assembly = assembly_document(arguments)
    if assembly is not None:
        return _of_assembly(arguments, assembly)
    grasp = grasp_of(arguments)
    rows = [primitive(row) for contact in grasp for row in contact.tangential_wrenches]
    closed = form_closure(grasp, friction=True).accepts is True
    document: dict[str, Any] = {
        "contacts": [contact_entry(points) for points in grasp.parts],
        "dimension": grasp.dimension,
        "stiffness_given": any(contact.stiffness_given for contact in grasp),
        "tangential_hyperplanes": len(rows),
        "rank": rank(rows) if rows else 0,
        "force_closure": closed,
    }
    lines = _description_lines(grasp, document)
    force_given(arguments, grasp.dimension)  # refuses a place without a force
    if load or arguments.output is not None:
        from .grasp_report import give_report

        wrench = applied(arguments, grasp) if load else None
        return give_report(arguments, grasp, wrench, document, lines)
    return show(arguments, document, lines, True, grasp)


def _of_assembly(arguments: argparse.Namespace, document: Mapping[str, Any]) -> int:
    """Print bodies, contacts, and the rank of the tangential hyperplanes of an assembly."""
    from arrangement.numbers.exact import primitive
    from arrangement.numbers.linear.rank import rank

    refuse_one_body(arguments, ("wrench", "force", "weight", "at", "output"))
    assembly, wrenches = asked_assembly(document, None, arguments.preload, required=False)
    rows = [primitive(row.tangential_wrenches[0]) for row in assembly.rows]
    known = {"tangential_hyperplanes": len(rows), "rank": rank(rows) if rows else 0}
    lines = [f"bodies           {len(assembly.bodies)}"]
    stated = wrenches if "wrench" in document else None
    for name, wrench in wrenches.items():
        lines.append(f"  {name}" if stated is None else f"  {name}  wrench {vector(wrench)}")
    lines.append(f"contacts         {len(assembly)}")
    for i, c in enumerate(assembly.contacts[:_MOST_CONTACTS], 1):
        lines.append(f"  contact {i} {c.pair} {c.contact.words}")
    if len(assembly) > _MOST_CONTACTS:
        lines.append(f"  ... and {counted(len(assembly) - _MOST_CONTACTS, 'contact')} more")
    planes = counted(len(rows), "tangential hyperplane")
    lines.append(f"rank             {known['rank']} of {planes} in R^{assembly.rows.n}")
    return show(arguments, assembly.to_dict(stated) | known, lines, True, assembly)


def _description_lines(grasp: Grasp, document: dict[str, Any]) -> Iterator[str]:
    place = "in the plane" if grasp.dimension == 2 else "in space"
    points = f" ({counted(len(grasp), 'point')})" if grasp.has_pads else ""
    yield f"contacts         {len(grasp.parts)}{points}, {place}"
    for i, part in enumerate(grasp.parts[:_MOST_CONTACTS], 1):
        yield f"  contact {i} {contact_words(part)}"
    if len(grasp.parts) > _MOST_CONTACTS:
        yield f"  ... and {counted(len(grasp.parts) - _MOST_CONTACTS, 'contact')} more"
    yield f"stiffness        {'given' if document['stiffness_given'] else '1 (default)'}"
    planes = counted(document["tangential_hyperplanes"], "tangential hyperplane")
    yield f"rank             {document['rank']} of {planes}"
    # A pyramid lies inside the round cone: a yes holds for both.
    certain = grasp.dimension == 2 or document["force_closure"]
    inside = "" if certain else pyramid_words(4, before=", with ")
    yield f"force closure    {_WORDS[document['force_closure']]}{inside}"


def _force_closure(arguments: argparse.Namespace) -> int:
    """Print the Grasp Wrench Space: force closure, epsilon, slice, facets."""
    from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace

    grasp = grasp_of(arguments)
    edges = _edges(arguments, grasp)
    length = Fraction(1) if arguments.torque_length is None else arguments.torque_length
    space = GraspWrenchSpace(grasp, arguments.norm or "L1", length, edges)
    document: dict[str, Any] = {
        "norm": space.norm,
        "length": space.length,
        "force_closure": space.force_closure,
        "epsilon_squared": space.epsilon_squared,
        "vertices": sorted(space.polytope.points),
        # (normal, constant) with the normal outward and of coprime integers.
        "facets": sorted([Fraction(-x, gcd(*row[:-1])) for x in row] for row in space.facets),
    }
    lines = list(_space_lines(space))
    if grasp.dimension == 2:
        torque = arguments.torque or Fraction(0)
        corners = space.slice(origin=(0, 0, torque))
        document |= {"volume": space.volume, "slice": {"torque": torque, "corners": corners}}
        cube, turn = (
            (f" {grasp.units.force}^3", f" {grasp.units.torque}") if grasp.units else ("", "")
        )
        lines.insert(3, f"volume           {number(space.volume)}{cube}")
        lines.append(f"resisted forces at torque {number(torque)}{turn}:")
        lines += (f"  {vector(c)}" for c in corners)
    else:
        document["pyramid"] = edges
        lines.append(f"cones            {pyramid_words(edges)}, inside the round ones")
    return show(arguments, document, lines, space.force_closure, grasp)


def _edges(arguments: argparse.Namespace, grasp: Grasp) -> int:
    """Return the edges of the pyramids of a hull."""
    from equilibrium.model.contact import pyramid_edges

    edges: int = arguments.cone or 4
    if arguments.cone is not None:
        pyramid_edges(edges, grasp.dimension)
    if grasp.dimension == 3 and arguments.torque:
        raise GraspError("--torque is for slices in the plane; omit it in space")
    return edges


def _space_lines(space: GraspWrenchSpace) -> Iterator[str]:
    units = space.grasp.units
    # With torques divided by a length all axes are forces.
    force, square = (f" {units.force}", f" {units.force}^2") if units else ("", "")
    root = number(space.epsilon_squared) + square
    yield f"force closure    {_WORDS[space.force_closure]}"
    length = f"{number(space.length)} {units.length}" if units else number(space.length)
    yield f"epsilon          {space.epsilon:.6g}{force}  (its square is {root})"
    what = "epsilon and volume depend" if space.grasp.dimension == 2 else "epsilon depends"
    yield f"torques over     {length}  ({what} on it; --torque-length)"
    yield f"facets           {len(space.facets)}"


def _modes(arguments: argparse.Namespace) -> int:
    """Print the contact modes of a grasp, of an assembly, or of bodies given by normals."""
    from arrangement.library.files.json_files import read_document
    from equilibrium.modes import ContactModes

    limit, groups = arguments.time_limit, tuple[range, ...]()
    if str(arguments.grasp).lower().endswith(".csv"):
        document = assembly_document(arguments) or {}
    else:
        arguments.grasp = document = read_document(arguments.grasp, ("contacts", "normals"))
    if {"normals", "bodies"} & set(document):
        modes = ContactModes.from_dict(document, time_limit=limit)
    else:
        grasp = grasp_of(arguments)
        modes, groups = ContactModes.of_grasp(grasp, time_limit=limit), grasp.groups
    with shown():
        lines = chain(
            _modes_lines(modes, arguments.count),
            filter(None, [numbering_words(groups, "a mode")]),
        )
        return show(arguments, _modes_document(modes, arguments), lines)


def _modes_document(modes: ContactModes, arguments: argparse.Namespace) -> dict[str, Any]:
    if not arguments.json:
        return {}
    if arguments.count:
        return {
            "contacting_separating": len(modes.contacting_separating),
            "sliding_sticking": modes.sliding_sticking_count,
        }
    return {
        "contacting_separating": [mode.to_dict() for mode in modes.contacting_separating],
        "sliding_sticking": [mode.to_dict() for mode in modes.sliding_sticking()],
    }


def _modes_lines(modes: ContactModes, count: bool) -> Iterator[str]:
    total = len(modes.contacting_separating)
    if count:
        yield f"contacting-separating  {total:>7}"
        yield f"sliding-sticking       {modes.sliding_sticking_count:>7}"
        return
    yield f"contacting-separating modes: {total} (c: stays in contact, s: separates)"
    for kept in modes.contacting_separating:
        signs = "".join("s" if sign else "c" for sign in kept.signs)
        yield f"  {signs}  dim {kept.dimension}  {_scaled(kept.motion)}"
    yield "sliding-sticking modes (0: no slip, + and -: slip along a tangent)"
    for slid in modes.sliding_sticking():
        yield f"  {_slips(slid.signs)}  dim {slid.dimension}  {_scaled(slid.motion)}"


def _scaled(motion: Sequence[int]) -> str:
    """Return a motion with its largest entry 1: a mode has its positive multiples, too."""
    largest = max(map(abs, motion)) or 1
    return vector(Fraction(x, largest) for x in motion)


def _slips(signs: Slips) -> str:
    return " ".join("s" if s is None else sign_text(s) for s in signs)
