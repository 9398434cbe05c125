"""What the subcommands share: the grasp, wrenches and numbers they take, and how they print."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from arrangement.console import terminal
from arrangement.console.options import values
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, number_text, shown, to_text
from equilibrium.cli.colours import print_verdict
from equilibrium.model.errors import GraspError
from equilibrium.model.labels import AS_ROUNDED

if TYPE_CHECKING:
    from equilibrium.grasps.inputs import Conversion
    from equilibrium.model.assembly import Assembly, Wrenches
    from equilibrium.model.grasp import Grasp

_AXES = ("F_X", "F_Y", "TAU")
_SPANNING = ("fx", "fy", "tau")

#: More incidences than this that rounding kept are only counted.
_MOST_KEPT = 6

#: A letter or a name in place of a number, in an error.
_LETTER = re.compile(
    r" is '([^A-Za-z' ]*[A-Za-z][^A-Za-z' ]*|[A-Za-z]+)', which is not an exact num"
)

#: Keys of documents that have units.
_STATING = {"grasp", "assembly"}

_Command: TypeAlias = Callable[[argparse.Namespace], int]


def add_command(
    commands: Any,
    name: str,
    function: _Command,
    text: str,
    *answers: str,
    grasp: bool = True,
    optional: bool = False,
    preload: bool = True,
    numbers: bool = True,
    heading: str = "more",
) -> argparse.ArgumentParser:
    """Add a subcommand; most take a grasp, and a preload in place of its own, and print numbers.

    Args:
        answers: what the exit codes mean, as for `terminal.add_command`.
        optional: whether the grasp may be left out.
        heading: under which the help of the program lists it, "" for none.
    """
    parser: argparse.ArgumentParser = terminal.add_command(
        commands, name, text, *answers, heading=heading
    )
    if grasp:
        add_grasp(parser, "grasp", "?" if optional else None, preload)
    terminal.add_common_options(parser)
    if numbers:
        terminal.add_number_options(parser)
    parser.set_defaults(command=function)
    return parser


def add_grasp(parser: Any, name: str, number: Any = None, preload: bool = True) -> None:
    """Add a grasp, as an argument or an option, and a preload in place of its own."""
    text = (
        "a path (JSON, or .csv with one contact per line: x, y, nx, ny, friction mu), - for stdin, "
    )
    text += "or a built-in name"
    action = parser.add_argument(name, metavar="GRASP", nargs=number, help=text)
    parser.names[action.dest] = built_in
    text = "replace normals of any length by the nearest exact unit vectors, and report the change"
    parser.add_argument("--round-normals", action="store_true", help=text)
    add_as_given(parser)
    if preload:
        text = "use this preload at every contact instead of the grasp's own"
        add_number(parser, "--preload", None, text, metavar="P")


def contact_number(text: str) -> int:
    """Read the number of a contact."""
    try:
        return values.count_argument(text)
    except argparse.ArgumentTypeError:
        raise argparse.ArgumentTypeError(
            f"{shown(text)} is not the number of a contact; write numbers from 1 on, such as 1 2. "
            "Their friction and preload stand in the file"
        ) from None


def built_in() -> Iterable[str]:
    """Return the names of the built-in grasps."""
    from arrangement.library.files.json_files import descriptions

    return descriptions("contacts")


def add_as_given(parser: argparse.ArgumentParser) -> None:
    """Add the choice to round numbers each on its own."""
    text = (
        "round each number separately; by default incidences such as concurrent normals and points "
        "on a circle are preserved"
    )
    parser.add_argument("--as-given", action="store_true", help=text)


def add_applied(
    parser: argparse.ArgumentParser,
    name: str = "--wrench",
    text: str = "the load: force (f_x, f_y) and torque (moment) tau about the origin",
) -> Any:
    """Add a wrench, as such, or as a force or a weight at a point; see `applied`.

    Returns the group of these options, of which one may be taken.

    Args:
        name, text: of the option that takes the wrench as such.
    """
    group: Any = parser.add_mutually_exclusive_group()
    add_wrench(group, name, text)
    add_force(parser, group)
    return group


def add_displacement(parser: argparse.ArgumentParser) -> None:
    """Add how far an equilibrium may move contact points to count."""
    text = "count only equilibria that move each contact point by at most D along its normal and "
    add_number(parser, "--max-displacement", None, f"{text}each tangent (default: any)", "D")


def add_cone(parser: argparse.ArgumentParser) -> None:
    """Add the choice of friction cones in space: None is round, else edges of a pyramid."""
    text = "in space: use friction pyramids with K edges, K even, instead of round cones"
    parser.add_argument("--cone", metavar="pyramid:K", type=_cone, default="round", help=text)


def _cone(text: str) -> int | None:
    if text == "round":
        return None
    kind, _, count = text.partition(":")
    if kind != "pyramid" or not count.isascii() or not count.isdigit() or len(count) > 3:
        raise argparse.ArgumentTypeError(f"{text[:60]!r} is no cone; give pyramid:K or round")
    return int(count)


def add_force(parser: argparse.ArgumentParser, group: Any) -> None:
    """Add a force or a weight at a point to the options of which one states a wrench."""
    rational = values.rational_argument
    text = "instead of a wrench: a force (three numbers in space)"
    force = group.add_argument("--force", nargs=2, metavar=_AXES[:2], type=rational, help=text)
    text = "instead of a wrench: mass times gravity, the force (0, -W), in space (0, 0, -W)"
    group.add_argument("--weight", metavar="W", type=rational, help=text)
    text = "where the force or weight acts (default: at the origin)"
    place = parser.add_argument("--at", nargs=2, metavar=("X", "Y"), type=rational, help=text)
    _let_grow(parser, force, place)


def applied(arguments: argparse.Namespace, grasp: Grasp) -> RationalVector:
    """Return the wrench that `add_applied` has read, else that of the file."""
    wrench = force_given(arguments, grasp.dimension) or arguments.wrench
    if wrench is None and isinstance(arguments.grasp, Mapping):
        wrench = arguments.grasp.get("wrench")
    if wrench is None:
        raise GraspError(
            "there is no wrench; give a load such as --wrench 0 -1 0, --force 0 -1 or --weight 1, "
            'or write the key "wrench" into the file'
        )
    return grasp.read_wrench(wrench)


def has_load(arguments: argparse.Namespace) -> bool:
    """Return whether an option states a wrench, a force or a weight.

    Raises:
        GraspError: a place without a force or a weight.
    """
    if arguments.force is arguments.weight is None and arguments.at is not None:
        raise GraspError("--at goes with --force or --weight; a wrench has its torque")
    loads = arguments.wrench, arguments.force, arguments.weight
    return any(load is not None for load in loads)


def force_given(arguments: argparse.Namespace, dimension: int = 2) -> RationalVector | None:
    """Return the wrench of the force or the weight, if an option states one of them."""
    from equilibrium.model.grasp import wrench_of

    if not has_load(arguments) or arguments.force is arguments.weight is None:
        return None
    down = *[Fraction(0)] * (dimension - 1), -(arguments.weight or 0)
    return wrench_of(arguments.force or down, arguments.at, dimension)


def add_wrench(parser: Any, name: str, text: str) -> None:
    """Add three numbers, or six for a grasp in space; whoever reads them knows which."""
    rational = values.rational_argument
    option = parser.add_argument(name, nargs=3, metavar=_AXES, type=rational, help=text)
    _let_grow(parser, option)


class _OnBody(argparse._AppendAction):
    """Collects a wrench for each body."""

    def __call__(self, parser: Any, namespace: Any, texts: Any, option: Any = None) -> None:
        name, *numbers = texts
        wrenches = dict(getattr(namespace, self.dest) or {})
        if name in wrenches:
            parser.error(f"{option} has the body {name} twice; give each body once")
        try:
            wrenches[name] = tuple(map(values.rational_argument, numbers))
        except argparse.ArgumentTypeError as error:
            parser.error(f"{option} {name}: {error}")
        setattr(namespace, self.dest, wrenches)


def add_on_body(
    group: Any,
    name: str = "--on",
    text: str = "the wrench on one body, which replaces that of the file",
) -> None:
    """Add wrenches on the bodies of an assembly to the options of which one states a load."""
    text = f"for an assembly: {text}; repeatable"
    group.add_argument(name, nargs=4, action=_OnBody, metavar=("BODY", *_AXES), help=text)


def spanning_wrench(text: str) -> tuple[Fraction, ...]:
    """Read one of the wrenches that span a plane: fx, fy, tau, or three numbers as 1,0,0."""
    if text in _SPANNING:
        return tuple(Fraction(name == text) for name in _SPANNING)
    parts = [part for part in re.split(r"[\s,]+", text.strip(", ")) if part]
    if len(parts) != 3:
        names = ", ".join(_SPANNING)
        raise argparse.ArgumentTypeError(
            f"{shown(text)}; expected one of {names}, or three numbers such as 1,0,0"
        )
    return tuple(map(values.rational_argument, parts))


def _let_grow(parser: Any, *options: argparse.Action) -> None:
    """Let options take more numbers, for grasps in space; groups know their parser."""
    getattr(parser, "_container", parser).variadic.update((x, x.nargs) for x in options)


def add_number(
    parser: argparse.ArgumentParser, name: str, default: Any, text: str, metavar: str = "Q"
) -> None:
    """Add an exact number."""
    value = None if default is None else Fraction(default)
    text += "" if value is None else f" (default: {to_text(value)})"
    number = values.rational_argument
    parser.add_argument(name, metavar=metavar, type=number, default=value, help=text)


def add_count(
    parser: argparse.ArgumentParser, name: str, default: int, text: str, metavar: str = "N"
) -> None:
    """Add a number of things to do, or a seed."""
    text = f"{text} (default: {default})"
    count = values.count_argument
    parser.add_argument(name, type=count, default=default, metavar=metavar, help=text)


def read(arguments: argparse.Namespace) -> Grasp:
    """Return the grasp as its source has it; on stderr say what had to be rounded."""
    from equilibrium.grasps.inputs import read_any

    try:
        conversion = read_any(
            arguments.grasp, round_normals=arguments.round_normals, as_given=arguments.as_given
        )
    except InputError as error:
        if not _LETTER.search(str(error)):
            raise
        use = "One letter, such as t, is for `resisted --parameter t=0..1`"
        raise GraspError(f"{error}. {use}") from None
    tell_rounding(conversion)
    arguments.remarks = conversion.remarks
    # In space proofs are long, and of converted data many roundings are asked.
    if conversion.grasp.dimension == 3 or conversion.grasp.data_error is not None:
        budget.allow(3 * budget.COMMAND_STEPS)
    return conversion.grasp


def tell_rounding(conversion: Conversion) -> None:
    """Report on stderr how much numbers changed, and which incidences are preserved."""
    if not conversion.exact:
        errors = conversion.point_errors, conversion.angle_errors, (conversion.value_error,)
        point, angle, value = (
            number_text(max(map(abs, changes), default=Fraction(0)), 2, longest=0).removeprefix("≈")
            for changes in errors
        )
        values_text = f", values by {value}" if conversion.value_error else ""
        text = f"rounded: points by {point}, normals by {angle} radians{values_text}"
        print(text, file=sys.stderr)
    for remark in conversion.remarks:
        print(f"note: {remark}", file=sys.stderr)
    if kept := [*map(str, conversion.kept[:_MOST_KEPT])]:
        more = len(conversion.kept) - len(kept)
        print("preserved:", "; ".join(kept + [f"{more} more"] * (more > 0)), file=sys.stderr)


def grasp_of(arguments: argparse.Namespace) -> Grasp:
    """Return the grasp that the arguments name."""
    grasp = read(arguments)
    preload = getattr(arguments, "preload", None)
    return grasp if preload is None else grasp.with_preload(preload)


class Bodies(NamedTuple):
    """An assembly, and the wrenches in its file.

    Attributes:
        stated: the key "wrench", else weights of bodies; None if there are neither.
        has_key: whether there is the key.
    """

    assembly: Assembly
    stated: Mapping[str, Any] | None
    has_key: bool

    def wrenches(self, on_bodies: Any = None, *, required: bool = True) -> Wrenches:
        """Return the wrenches of options, for other bodies those of the file, else zero.

        Raises:
            GraspError: there are none, and some are required.
        """
        if required and self.stated is None and on_bodies is None:
            raise GraspError(
                "the assembly has no wrenches; give --on BODY F_X F_Y TAU for each body that has "
                'one, or write the key "wrench" into its file'
            )
        return self.assembly.read_wrenches({**(self.stated or {}), **(on_bodies or {})})


def bodies_of(arguments: argparse.Namespace) -> Bodies | None:
    """Return the assembly that the arguments name; else None, with what was read as the source."""
    from equilibrium.grasps.files import decimal_text, has_decimals, read_contacts
    from equilibrium.grasps.inputs.csv_file import is_table, read_bodies
    from equilibrium.grasps.inputs.documents import with_unit_normals
    from equilibrium.model.assembly import Assembly, wrenches_of

    source, preload = arguments.grasp, getattr(arguments, "preload", None)
    if is_table(source):
        table = read_bodies(source, as_given=arguments.as_given)
        if table is None:
            return None
        tell_rounding(table[1])
        assembly, document = table[0], dict[str, Any]()
    else:
        document = read_contacts(source, floats=decimal_text)
        if "bodies" not in document:
            arguments.grasp = document  # what came on stdin can be read once
            return None
        if arguments.round_normals or has_decimals(document["contacts"]):
            document, contacts = with_unit_normals(document, as_given=arguments.as_given)
            tell_rounding(contacts)
        assembly = Assembly.from_dict(document)
    budget.allow(3 * budget.COMMAND_STEPS)  # of a part of many contacts, as in space
    if preload is not None:
        assembly = assembly.with_preload(preload)
    stated = wrenches_of(document) if document else None
    return Bodies(assembly, stated, "wrench" in document)


#: Fields of documents that say already how far the answer holds for the data as rounded.
_CALLED_ROUNDED = {"as_rounded", "within_error", "robust"}


def show(
    arguments: argparse.Namespace,
    document: dict[str, Any],
    lines: Iterable[str],
    yes: bool | None = True,
    grasp: Grasp | Assembly | None = None,
) -> int:
    """Print one JSON object or the lines, with the units of a grasp; return the exit code.

    Args:
        yes: None is undecided.
    """
    units = None if grasp is None else grasp.units
    if getattr(grasp, "data_error", None) and not _CALLED_ROUNDED & document.keys():
        document, lines = document | {"as_rounded": True}, [*lines, AS_ROUNDED]
    if arguments.json:
        stated = {"units": units.to_dict()} if units and not _STATING & document.keys() else {}
        terminal.print_json({**document, **stated})
    else:
        if units:
            print(units)
        for line in lines:
            print_verdict(line)
    return terminal.UNDECIDED if yes is None else terminal.YES if yes else terminal.NO
