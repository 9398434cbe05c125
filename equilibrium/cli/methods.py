"""The subcommands of ``equilibrium`` about the other methods and contact modes."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import gcd
from typing import TYPE_CHECKING, Any

from arrangement.console import terminal
from arrangement.console.number_form import counted, number, sign_text, vector
from arrangement.console.progress import shown
from arrangement.numbers.exact import rational
from equilibrium.model.contact import pyramid_words

from .arguments import (
    add_applied,
    add_command,
    add_cone,
    add_count,
    add_number,
    applied,
    grasp_of,
    seconds,
    show,
)

if TYPE_CHECKING:
    from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace
    from equilibrium.methods.survey import Example, Survey
    from equilibrium.model.grasp import Grasp
    from equilibrium.modes import ContactModes, Slips


_WORDS = {True: "yes", False: "no", None: "-"}


def add_commands(commands: Any) -> None:
    """Add compare, wrench-space, survey and modes."""
    answers = ("the complete model accepts", "it refuses", "undecided")
    text = "list the verdicts of all methods"
    comparison = add_command(commands, "compare", _compare, text, *answers)
    add_applied(comparison)
    add_cone(comparison)

    text = "measure the Grasp Wrench Space: quality, slice, facets"
    closed = ("force closure", "no force closure")
    space = add_command(commands, "wrench-space", _wrench_space, text, *closed)
    space.add_argument("--norm", choices=("L1", "Linf"), default="L1", help="default: L1")
    add_cone(space)
    add_number(space, "--length", 1, "that torques are divided by, in units of the grasp", "Q")
    add_number(space, "--torque", 0, "applied torque of the slice", "TAU")

    text = "count how often the methods disagree with the complete model on random grasps"
    survey = add_command(commands, "survey", _survey, text, grasp=False)
    survey.set_defaults(long=True)
    add_count(survey, "--number", 60, "of questions")
    survey.add_argument(
        "--contacts",
        type=terminal.count_argument,
        nargs="+",
        default=[2, 3],
        help="of each grasp (default: 2 3)",
    )
    add_count(survey, "--seed", 0, "of the random grasps")
    text = "tries of each size to find a smallest example of each disagreement"
    add_count(survey, "--examples", 0, text, "TRIES")

    text = "list contact modes: what rigid contacts can do, from kinematics alone"
    modes = add_command(commands, "modes", _modes, text, preload=False)
    modes.add_argument("--count", action="store_true", help="say how many there are, list none")
    modes.add_argument(
        "--time-limit", metavar="SECONDS", type=seconds, help="give up then: exit code 2"
    )


def _compare(arguments: argparse.Namespace) -> int:
    from equilibrium.decide.solver import solve
    from equilibrium.grasps.inputs.documents import question_document
    from equilibrium.methods.compare import compare

    grasp = grasp_of(arguments)
    wrench = applied(arguments, grasp)
    question_document(grasp, wrench, "compare")
    found = compare(grasp, wrench, pyramid=arguments.cone)
    lines, document, yes = list[str](), found.to_dict(), found.answers[0].accepts
    for answer in found.answers:
        mark = "!" if answer.method in found.disagreeing else " "
        lines.append(f"{mark} {_WORDS[answer.accepts]:<4}{answer.title:<60}{answer.remark}")
    if grasp.data_error is not None:
        again = solve(grasp, wrench, pyramid=arguments.cone).within_error()
        document["within_error"] = again.to_dict()
        lines += again.lines()
        yes = yes if again.turned is None else None
    return show(arguments, document, lines, yes, found.grasp)


def _wrench_space(arguments: argparse.Namespace) -> int:
    from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace

    grasp = grasp_of(arguments)
    edges = _edges(arguments, grasp)
    space = GraspWrenchSpace(grasp, arguments.norm, arguments.length, edges)
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
        torque = arguments.torque
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
    """Return the edges of the pyramids of a hull; refuse what would take minutes."""
    from equilibrium.methods.grasp_wrench_space import MOST_IN_HULL
    from equilibrium.model.contact import pyramid_edges
    from equilibrium.model.errors import GraspError

    edges: int = arguments.cone or 4
    if arguments.cone is not None:
        pyramid_edges(edges, grasp.dimension)
    if grasp.dimension == 2:
        return edges
    if arguments.torque:
        raise GraspError("--torque is for slices in the plane; omit it in space")
    if len(grasp) * edges > MOST_IN_HULL:
        raise GraspError(
            f"the hull of {len(grasp)} contacts with {edges} edges each in six dimensions takes "
            f"too long; up to {MOST_IN_HULL} edges in all are tried, and `compare` tells whether "
            "one wrench is in it"
        )
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
    yield f"torques over     {length}  ({what} on it; --length)"
    yield f"facets           {len(space.facets)}"


def _survey(arguments: argparse.Namespace) -> int:
    from equilibrium.methods.survey import smallest_examples, survey

    found = survey(arguments.number, contacts=arguments.contacts, seed=arguments.seed)
    examples: tuple[Example, ...] = ()
    if arguments.examples:
        examples = smallest_examples(tries=arguments.examples, seed=arguments.seed)
    document = {**found.to_dict(), "examples": [example.to_dict() for example in examples]}
    return show(arguments, document, _survey_lines(found, examples))


def _survey_lines(found: Survey, examples: Iterable[Example]) -> Iterator[str]:
    yield f"{counted(found.questions, 'question')}, {found.stable} stable in the complete model"
    heads = ("agrees", "accepts wrongly", "refuses wrongly", "says nothing")
    yield f"{'':<20}" + "".join(f"{head:>17}" for head in heads)
    for name, count in found.counts.items():
        agrees = count.both_accept + count.both_refuse
        numbers = (agrees, count.accepts_wrongly, count.refuses_wrongly, count.silent)
        yield f"{name:<20}" + "".join(f"{some:>17}" for some in numbers)
    for example in examples:
        verb = "accepts" if example.accepts else "refuses"
        yield f"{example.method} wrongly {verb} {vector(example.wrench)}:"
        for contact in example.grasp:
            values = {key: value for key, value in contact.to_dict().items() if value != "0"}
            yield "  " + "  ".join(f"{key} {_flat(value)}" for key, value in values.items())


def _flat(value: str | list[str]) -> str:
    return number(rational(value)) if isinstance(value, str) else vector(map(rational, value))


def _modes(arguments: argparse.Namespace) -> int:
    from arrangement.library.files.json_files import read_document
    from equilibrium.modes import ContactModes

    limit, document = arguments.time_limit, {}
    if not str(arguments.grasp).lower().endswith(".csv"):
        arguments.grasp = document = read_document(arguments.grasp, ("contacts", "normals"))
    if "normals" in document:
        modes = ContactModes.from_dict(document, time_limit=limit)
    else:
        modes = ContactModes.of_grasp(grasp_of(arguments), time_limit=limit)
    with shown():
        return show(
            arguments, _modes_document(modes, arguments), _modes_lines(modes, arguments.count)
        )


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
        yield f"  {signs}  dim {kept.dimension}  {vector(kept.motion)}"
    yield "sliding-sticking modes (0: no slip, + and -: slip along a tangent)"
    for slid in modes.sliding_sticking():
        yield f"  {_slips(slid.signs)}  dim {slid.dimension}  {vector(slid.motion)}"


def _slips(signs: Slips) -> str:
    return " ".join("s" if s is None else sign_text(s) for s in signs)
