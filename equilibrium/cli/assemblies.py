"""Assemblies of several bodies on the command line: their files, wrenches and answers."""

from __future__ import annotations

import argparse
import json
import os
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

from arrangement.console.number_form import JsonMixin
from arrangement.console.options import values
from arrangement.console.options.signature import options_of
from arrangement.numbers import budget
from arrangement.numbers.deadline import Deadline
from equilibrium.model.errors import GraspError, UndecidedError

from .arguments import add_command, show, tell_rounding
from .verdict_words import robustly, with_rounding

if TYPE_CHECKING:
    from equilibrium.model.assembly import Assembly

_Found = TypeVar("_Found", bound=JsonMixin)

_AXES = ("BODY", "F_X", "F_Y", "TAU")
#: Options of solve that are about one body.
_ONE_BODY = (
    *("wrench", "force", "weight", "at", "cone"),
    *("as_printed", "shorten"),
)


#: The kinds of make. Their options are the parameters of `equilibrium.grasps.textbook`, which is
#: imported when one of them is parsed.
_MAKERS = {
    "stack": "put blocks on each other, the topmost pushed",
    "arch": "build a round arch of voussoirs",
    "ramp": "put a block on a ramp",
    "wedge": "put a wedge under a block at a smooth wall",
    "wall": "build a wall of bricks in running bond",
    "cylinders": "put a cylinder on two others",
    "ladder": "lean a ladder on a block",
    "tongs": "lift a block with the jaws of tongs",
}


class _OnBody(argparse._AppendAction):
    """Collects a wrench for each body."""

    def __call__(self, parser: Any, namespace: Any, given: Any, option: Any = None) -> None:
        name, *numbers = given
        wrenches = dict(getattr(namespace, self.dest) or {})
        if name in wrenches:
            parser.error(f"{option} has the body {name} twice; give each body once")
        try:
            wrenches[name] = tuple(map(values.rational_argument, numbers))
        except argparse.ArgumentTypeError as error:
            parser.error(f"{option} {name}: {error}")
        setattr(namespace, self.dest, wrenches)


def add_on_body(
    ways: Any,
    name: str = "--on",
    text: str = "the wrench on one body, instead of that in its file",
) -> None:
    """Add wrenches on the bodies of an assembly, to the ways in which a wrench can be given."""
    text = f"of an assembly: {text}; repeatable"
    ways.add_argument(name, nargs=4, action=_OnBody, metavar=_AXES, help=text)


def assembly_document(arguments: argparse.Namespace) -> Mapping[str, Any] | None:
    """Return the document that the arguments name if it has bodies; else keep it as the source."""
    from equilibrium.grasps.files import decimal_text, has_decimals, read_contacts

    source = arguments.grasp
    if isinstance(source, (str, os.PathLike)) and str(source).lower().endswith(".csv"):
        from equilibrium.grasps.inputs.csv_file import read_bodies

        found = read_bodies(source, as_given=arguments.as_given)
        if found is None:
            return None
        tell_rounding(found[1])
        return found[0].to_dict()
    document = read_contacts(source, floats=decimal_text)
    if "bodies" in document:
        if has_decimals(document):
            raise GraspError(
                "the assembly has decimals; write numbers as integers or as strings such as "
                '"1/4", "-0.25"'
            )
        if not arguments.round_normals:
            return document
        from equilibrium.grasps.inputs.documents import with_unit_normals

        rounded, contacts = with_unit_normals(document, as_given=arguments.as_given)
        tell_rounding(contacts)
        return rounded
    # What came on stdin can be read once.
    arguments.grasp = document
    return None


def asked_assembly(
    document: Mapping[str, Any], given: Any = None, preload: Any = None, *, required: bool = True
) -> tuple[Assembly, Any]:
    """Return the assembly of a document, and the wrenches given or those that stand in it.

    Args:
        preload: in place of those of its contacts.
        required: whether there have to be wrenches.

    Raises:
        GraspError: there are none.
    """
    from equilibrium.model.assembly import Assembly, wrenches_of

    budget.allow(3 * budget.COMMAND_STEPS)  # of a part of many contacts, as in space
    assembly, stated = Assembly.from_dict(document), wrenches_of(document)
    if preload is not None:
        assembly = assembly.with_preload(preload)
    wrenches = {**(stated or {}), **(given or {})}
    if required and stated is None and given is None:
        raise GraspError(
            "the assembly has no wrenches; give --on BODY F_X F_Y TAU for each body that has one, "
            'or write the key "wrench" into its file'
        )
    return assembly, assembly.read_wrenches(wrenches)


def assembly_question(
    arguments: argparse.Namespace, document: Mapping[str, Any]
) -> tuple[Assembly, Any]:
    """Return the assembly of a document, and the wrenches that solve is asked about."""
    refuse_one_body(arguments, _ONE_BODY)
    return asked_assembly(document, arguments.on, arguments.preload)


def solve_assembly(arguments: argparse.Namespace, given: Mapping[str, Any]) -> int:
    """Print the verdict on an assembly."""
    from equilibrium.decide.solver import solve

    assembly, wrenches = assembly_question(arguments, given)
    bound, seconds, deadline = (
        arguments.max_displacement,
        arguments.time_limit,
        Deadline(arguments.time_limit),
    )
    verdict = solve(assembly, wrenches, time_limit=seconds, max_displacement=bound)
    if arguments.certificate is not None and verdict.certificate is not None:
        verdict.certificate.save(arguments.certificate)
    document, lines = verdict.to_dict(arguments.all), verdict.lines(arguments.all)
    if arguments.robust is not None:
        yes = robustly(arguments, verdict, document, lines, deadline)
    else:
        lines, yes = with_rounding(verdict, lines)
    if isinstance(document.get("equilibria"), dict):
        yes = None
    return show(arguments, document, lines, yes, assembly)


def draw_assembly(arguments: argparse.Namespace, document: Mapping[str, Any]) -> int:
    """Draw the assembly of a document, solved if it has wrenches."""
    from arrangement.drawing.command import given_options, write
    from equilibrium.decide.solver import solve
    from equilibrium.pictures.views import DRAWINGS, OF_ASSEMBLIES

    refuse_one_body(arguments, ("wrench", "force", "weight", "at", "origin"))
    assembly, wrenches = asked_assembly(document, None, arguments.preload, required=False)
    subject = solve(assembly, wrenches) if "wrench" in document else assembly
    options = given_options(arguments, OF_ASSEMBLIES, DRAWINGS)
    return write(arguments, OF_ASSEMBLIES, subject, options)


def or_undecided(
    ask: Callable[[], _Found], text: Callable[[_Found], str], name: str
) -> tuple[dict[str, Any], str]:
    """Return the JSON form and the text of an answer, or why what has this name is undecided."""
    from equilibrium.decide import undecided

    try:
        found = ask()
    except UndecidedError as unknown:
        return undecided(unknown), f"{name}: undecided, {unknown}"
    return found.to_dict(), text(found)


def refuse_one_body(arguments: argparse.Namespace, names: Iterable[str]) -> None:
    """Refuse options that are about one body.

    Raises:
        GraspError: one of them is given.
    """
    for name in names:
        if getattr(arguments, name) not in (None, False, []):
            option = name.replace("_", "-")
            raise GraspError(f"--{option} is for one body, not for an assembly; leave it out")


def add_makers(kinds: Any) -> None:
    """Add the kinds of make that are assemblies."""
    for name, text in _MAKERS.items():
        parser: Any = add_command(kinds, name, _make, text, grasp=False, numbers=False, heading="")
        parser.set_defaults(maker=name)
        parser.lazy_options = partial(_add_parameters, parser, name)
        parser.add_argument("-o", "--output", metavar="OUT.json", help="write the file here")


def _add_parameters(parser: argparse.ArgumentParser, maker: str) -> None:
    from equilibrium.grasps.textbook import TEXTBOOK

    for option in options_of(TEXTBOOK[maker]).values():
        option.add_to(parser, help=f"{option.help} (default: {option.default})")


def _make(arguments: argparse.Namespace) -> int:
    """Print or write a textbook assembly."""
    from equilibrium.grasps.textbook import TEXTBOOK

    made = TEXTBOOK[arguments.maker]
    assembly, wrenches = made(**{name: getattr(arguments, name) for name in options_of(made)})
    if arguments.output is not None:
        assembly.save(arguments.output, wrenches)
    document = assembly.to_dict(wrenches)
    lines = [json.dumps(document, indent=1)] if arguments.output is None else []
    return show(arguments, document, lines)
