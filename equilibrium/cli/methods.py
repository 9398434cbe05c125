"""The subcommands of ``equilibrium`` about the other methods; `equilibrium.cli` adds them."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from arrangement import terminal
from arrangement.exact import to_text

if TYPE_CHECKING:
    from equilibrium.methods.survey import Example, Survey

_WORDS = {True: "yes", False: "no", None: "-"}


def add_commands(commands: Any) -> None:
    """Add compare, wrench-space and survey."""
    compare = commands.add_parser(
        "compare", help="the verdicts of all methods (exit 0 if the complete model accepts, else 1)"
    )
    _add_grasp(compare)
    compare.add_argument(
        "--wrench",
        nargs=3,
        required=True,
        metavar=("X", "Y", "R"),
        type=terminal.rational_argument,
        help="applied force x, force y, torque about the origin",
    )
    compare.set_defaults(command=_compare)

    space = commands.add_parser(
        "wrench-space", help="Grasp Wrench Space: quality, slice, facets (exit 1: no force closure)"
    )
    _add_grasp(space)
    space.add_argument("--norm", choices=("L1", "Linf"), default="L1", help="default: L1")
    space.add_argument(
        "--torque-scale",
        metavar="LENGTH",
        type=terminal.rational_argument,
        default=1,
        help="a length that torques are divided by (default: 1)",
    )
    space.add_argument(
        "--torque",
        metavar="R",
        type=terminal.rational_argument,
        default=0,
        help="applied torque of the slice (default: 0)",
    )
    space.set_defaults(command=_wrench_space)

    survey = commands.add_parser(
        "survey", help="how often the methods disagree with the complete model on random grasps"
    )
    survey.add_argument("--number", type=int, default=60, help="of questions (default: 60)")
    survey.add_argument(
        "--contacts", type=int, nargs="+", default=[2, 3], help="of each grasp (default: 2 3)"
    )
    survey.add_argument("--seed", type=int, default=0, help="of the random grasps (default: 0)")
    survey.add_argument(
        "--examples",
        type=int,
        default=0,
        metavar="TRIES",
        help="also look for a smallest example of each disagreement, with so many tries a size",
    )
    survey.set_defaults(command=_survey)

    for command in (compare, space, survey):
        terminal.add_json_option(command)


def _add_grasp(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("grasp", metavar="GRASP", help="a path, - for stdin, or a built-in name")
    parser.add_argument(
        "--preload",
        metavar="P",
        type=terminal.rational_argument,
        help="use this preload at every contact instead of the grasp's own",
    )


def _grasp(arguments: argparse.Namespace) -> Any:
    from equilibrium.io.files import read_grasp

    grasp = read_grasp(arguments.grasp)
    return grasp if arguments.preload is None else grasp.with_preload(arguments.preload)


def _compare(arguments: argparse.Namespace) -> int:
    from equilibrium.methods.compare import compare

    comparison = compare(_grasp(arguments), arguments.wrench)
    if arguments.json:
        terminal.print_json(comparison.to_dict())
    else:
        if comparison.grasp.units:
            print(comparison.grasp.units)
        for answer in comparison.answers:
            mark = "!" if answer.method in comparison.disagreeing else " "
            print(f"{mark} {_WORDS[answer.accepts]:<4}{answer.title:<60}{answer.remark}")
    return terminal.YES if comparison.stable else terminal.NO


def _wrench_space(arguments: argparse.Namespace) -> int:
    from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace

    grasp = _grasp(arguments)
    space = GraspWrenchSpace(grasp, arguments.norm, arguments.torque_scale)
    corners = space.slice(origin=(0, 0, arguments.torque))
    document = {
        "norm": space.norm,
        "torque_scale": space.torque_scale,
        "force_closure": space.force_closure,
        "epsilon_squared": space.epsilon_squared,
        "volume": space.volume,
        "vertices": space.hull.vertices,
        "facets": [[*facet.normal, -facet.offset] for facet in space.hull.facets],
        "slice": {"torque": arguments.torque, "corners": corners},
    }
    units = grasp.units
    if arguments.json:
        document = _as_text(document)
        terminal.print_json({**document, "units": units.to_dict()} if units else document)
    else:
        if units:
            print(units)
        # With torques divided by a length all three axes are forces.
        force, torque = (units.force, f" {units.torque}") if units else ("", "")
        square = to_text(space.epsilon_squared) + (f" {force}^2" if units else "")
        print(f"force closure    {_WORDS[space.force_closure]}")
        print(
            f"epsilon          {space.epsilon:.6g}{force and f' {force}'}  (its square is {square})"
        )
        print(f"volume           {to_text(space.volume)}{force and f' {force}^3'}")
        print(f"facets           {len(space.hull.facets)}")
        print(f"resisted forces at torque {arguments.torque}{torque}:")
        for corner in corners:
            print(f"  ({', '.join(map(to_text, corner))})")
    return terminal.YES if space.force_closure else terminal.NO


def _as_text(value: Any) -> Any:
    """Return a document with every number that is no truth value as text."""
    if isinstance(value, dict):
        return {key: _as_text(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_as_text(entry) for entry in value]
    return value if isinstance(value, (bool, str)) else to_text(value)


def _survey(arguments: argparse.Namespace) -> int:
    from equilibrium.methods.survey import smallest_examples, survey

    found = survey(arguments.number, contacts=arguments.contacts, seed=arguments.seed)
    examples: tuple[Example, ...] = ()
    if arguments.examples:
        examples = smallest_examples(tries=arguments.examples, seed=arguments.seed)
    if arguments.json:
        terminal.print_json(
            {**found.to_dict(), "examples": [example.to_dict() for example in examples]}
        )
    else:
        _print_survey(found, examples)
    return terminal.YES


def _print_survey(found: Survey, examples: Iterable[Example]) -> None:
    print(f"{found.questions} questions, {found.stable} stable in the complete model")
    heads = ("agrees", "accepts wrongly", "refuses wrongly", "says nothing")
    print(f"{'':<20}" + "".join(f"{head:>17}" for head in heads))
    for name, count in found.counts.items():
        agrees = count.both_accept + count.both_refuse
        numbers = (agrees, count.accepts_wrongly, count.refuses_wrongly, count.silent)
        print(f"{name:<20}" + "".join(f"{number:>17}" for number in numbers))
    for example in examples:
        verb = "accepts" if example.accepts else "refuses"
        print(f"{example.method} wrongly {verb} ({', '.join(map(to_text, example.wrench))}):")
        for contact in example.grasp:
            values = {key: value for key, value in contact.to_dict().items() if value != "0"}
            print("  " + "  ".join(f"{key} {_flat(value)}" for key, value in values.items()))


def _flat(value: str | list[str]) -> str:
    return value if isinstance(value, str) else f"({', '.join(value)})"
