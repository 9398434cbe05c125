"""What the subcommands share: the grasp, wrenches and numbers they take, and how they print."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterable
from contextvars import ContextVar
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

from arrangement import terminal
from arrangement.exact import RationalVector, common_digits, number_text, to_text
from equilibrium.model.errors import GraspError

if TYPE_CHECKING:
    from equilibrium.inputs import Conversion
    from equilibrium.model.grasp import Grasp

#: Significant digits of a number that is too long to be printed exactly.
DIGITS = 6

_Command: TypeAlias = Callable[[argparse.Namespace], int]
_Form: TypeAlias = Callable[[Fraction | int], str]
#: How the command that runs writes numbers.
_form: ContextVar[_Form] = ContextVar("_form", default=number_text)


def add_command(
    commands: Any,
    name: str,
    function: _Command,
    text: str,
    *,
    grasp: bool = True,
    preload: bool = True,
    numbers: bool = True,
) -> argparse.ArgumentParser:
    """Add a subcommand; most take a grasp, and a preload in place of its own, and print numbers."""
    parser: argparse.ArgumentParser = commands.add_parser(name, help=text)
    if grasp:
        text = "a path (JSON, or .csv with one contact a line), - for stdin, or a built-in name"
        parser.add_argument("grasp", metavar="GRASP", help=text)
        text = "take normals of any length: the nearest exact unit vector, with the change reported"
        parser.add_argument("--round-normals", action="store_true", help=text)
    if grasp and preload:
        text = "use this preload at every contact instead of the grasp's own"
        add_number(parser, "--preload", None, text, metavar="P")
    terminal.add_common_options(parser)
    if numbers:
        form = parser.add_mutually_exclusive_group()
        form.add_argument("--exact", action="store_true", help="print every number exactly")
        text = f"of numbers that are too long to be printed exactly (default: {DIGITS})"
        form.add_argument("--digits", type=_digits, metavar="N", help=text)
        function = _with_numbers(function)
    parser.set_defaults(command=function)
    return parser


def _with_numbers(function: _Command) -> _Command:
    """Return a command that writes numbers as its options --exact and --digits say."""

    def command(arguments: argparse.Namespace) -> int:
        digits = arguments.digits or DIGITS
        form = to_text if arguments.exact else partial(number_text, digits=digits)
        token = _form.set(form)
        try:
            return function(arguments)
        finally:
            _form.reset(token)

    return command


def _digits(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 1 <= int(text[:5]) <= 1000:
        raise argparse.ArgumentTypeError(f"{text[:60]!r} digits; give 1 to 1000")
    return int(text)


def add_applied(parser: argparse.ArgumentParser) -> None:
    """Add the applied wrench, as such, or as a force or a weight at a point; see `applied`."""
    ways: Any = parser.add_mutually_exclusive_group(required=True)
    add_wrench(ways, "--wrench", "applied force (f_x, f_y) and torque tau about the origin", None)
    rational = terminal.rational_argument
    text = "instead: a force (two numbers, three in space)"
    force = ("F_X", "F_Y [F_Z]")
    ways.add_argument("--force", nargs="+", metavar=force, type=rational, help=text)
    ways.add_argument(
        "--weight",
        metavar="W",
        type=rational,
        help="instead: the force (0, -W), in space (0, 0, -W)",
    )
    text = "where the force or weight acts (default: at the origin)"
    parser.add_argument("--at", nargs="+", metavar=("X", "Y [Z]"), type=rational, help=text)


def applied(arguments: argparse.Namespace, grasp: Grasp) -> RationalVector:
    """Return the wrench that `add_applied` has read, for a grasp."""
    from equilibrium.model.grasp import wrench_of

    if arguments.wrench is not None:
        if arguments.at is not None:
            raise GraspError("--at goes with --force or --weight; a wrench has its torque")
        return tuple(arguments.wrench)
    down = *[Fraction(0)] * (grasp.dimension - 1), -(arguments.weight or 0)
    return wrench_of(arguments.force or down, arguments.at, grasp.dimension)


def add_wrench(parser: Any, name: str, text: str, default: Any, required: bool = False) -> None:
    """Add three numbers, or six for a grasp in space; whoever reads them knows which."""
    parser.add_argument(
        name,
        nargs="+",
        required=required,
        default=default,
        metavar=("F_X", "F_Y ... TAU"),
        type=terminal.rational_argument,
        help=text,
    )


def add_number(
    parser: argparse.ArgumentParser, name: str, default: Any, text: str, metavar: str = "Q"
) -> None:
    """Add an exact number."""
    shown = text if default is None else f"{text} (default: {to_text(Fraction(default))})"
    value = None if default is None else Fraction(default)
    parser.add_argument(
        name, metavar=metavar, type=terminal.rational_argument, default=value, help=shown
    )


def add_count(
    parser: argparse.ArgumentParser, name: str, default: int, text: str, metavar: str = "N"
) -> None:
    """Add a number of things to do, or a seed."""
    text = f"{text} (default: {default})"
    count = terminal.count_argument
    parser.add_argument(name, type=count, default=default, metavar=metavar, help=text)


def read(arguments: argparse.Namespace) -> Grasp:
    """Return the grasp as its source has it; on stderr say what had to be rounded."""
    from equilibrium.inputs import read_any

    found = read_any(arguments.grasp, round_normals=arguments.round_normals)
    tell_rounding(found)
    return found.grasp


def tell_rounding(found: Conversion) -> None:
    """Say on stderr by how much numbers had to be changed, if any."""
    if not found.exact:
        point, angle = (
            float(max(map(abs, errors), default=0))
            for errors in (found.point_errors, found.angle_errors)
        )
        value = f", values by {float(found.value_error):.2g}" if found.value_error else ""
        text = f"rounded: points by {point:.2g}, normals by {angle:.2g} radians{value}"
        print(text, file=sys.stderr)


def grasp_of(arguments: argparse.Namespace) -> Grasp:
    """Return the grasp that the arguments name."""
    grasp = read(arguments)
    preload = getattr(arguments, "preload", None)
    return grasp if preload is None else grasp.with_preload(preload)


def show(
    arguments: argparse.Namespace,
    document: dict[str, Any],
    lines: Iterable[str],
    yes: bool | None = True,
    grasp: Grasp | None = None,
) -> int:
    """Print one JSON object or the lines, with the units of a grasp; return the exit code.

    Args:
        yes: None is undecided.
    """
    units = None if grasp is None else grasp.units
    if arguments.json:
        stated = {"units": units.to_dict()} if units and "grasp" not in document else {}
        terminal.print_json({**document, **stated})
    else:
        for line in [str(units), *lines] if units else lines:
            print(line)
    return terminal.UNDECIDED if yes is None else terminal.YES if yes else terminal.NO


def number(value: Fraction | int) -> str:
    """Return a number as --exact and --digits want it."""
    return _form.get()(value)


def bracket(arguments: argparse.Namespace, low: Fraction, high: Fraction) -> str:
    """Return a number of which only bounds are known: the digits that are certain, and the ends."""
    if arguments.exact:
        return f"between {to_text(low)} and {to_text(high)}"
    digits = arguments.digits or DIGITS
    start, end = (number_text(x, digits + 3, longest=24) for x in (low, high))
    ends = f"between {start} and {end}"
    certain = common_digits(low, high, digits)
    return ends if certain is None else f"{certain} ({ends})"


def vector(numbers: Iterable[Fraction | int]) -> str:
    """Return numbers in parentheses."""
    return f"({', '.join(map(number, numbers))})"
