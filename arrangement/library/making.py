"""The command that makes members of families: its options are the parameters of their functions."""

from __future__ import annotations

import argparse
import inspect
from inspect import Parameter

from arrangement.console.terminal import times_argument
from arrangement.console.writing import document_text

from .families import FAMILIES


def described() -> dict[str, str]:
    """Return a line on each family: its options, and what it is."""
    return {
        name: f"{' '.join(_usage(p) for p in _parameters(name))}: {_summary(name)}"
        for name in FAMILIES
    }


def add_families(parser: argparse.ArgumentParser) -> None:
    """Add a subcommand for each family, with its parameters as options."""
    families = parser.add_subparsers(required=True, metavar="FAMILY", dest="family")
    for name in FAMILIES:
        made = families.add_parser(name, help=_summary(name), description=_summary(name))
        for parameter in _parameters(name):
            if parameter.annotation == "bool":
                made.add_argument(f"--{parameter.name}", action="store_true")
                continue
            needed = parameter.default is parameter.empty
            kinds = parameter.annotation.split(" | ")
            made.add_argument(
                f"--{parameter.name}",
                type=(_value if "int" in kinds else str) if "str" in kinds else int,
                required=needed,
                default=None if needed else parameter.default,
                metavar=_metavar(parameter),
                help=_help(parameter),
            )
        made.add_argument(
            "--limit", type=times_argument, default=argparse.SUPPRESS, metavar="TIMES"
        )
        made.add_argument("-o", "--output", metavar="PATH", help="a file (default: print it)")


def document(arguments: argparse.Namespace) -> str:
    """Return the member that the options ask for, in file form with one plane a line."""
    values = {p.name: getattr(arguments, p.name) for p in _parameters(arguments.family)}
    given = ", ".join(f"{key} = {value}" for key, value in values.items())
    made = FAMILIES[arguments.family](**values).to_dict()
    made["description"] = f"{arguments.family}, {given}" if given else arguments.family
    return document_text(made)


def _parameters(name: str) -> list[Parameter]:
    return list(inspect.signature(FAMILIES[name]).parameters.values())


def _usage(parameter: Parameter) -> str:
    text = f"--{parameter.name}"
    if parameter.annotation != "bool":
        text += f" {_metavar(parameter)}"
    return text if parameter.default is parameter.empty else f"[{text}]"


def _metavar(parameter: Parameter) -> str:
    if "Graph" in parameter.annotation:
        return "N|TYPE|EDGES" if "int" in parameter.annotation else "EDGES"
    return parameter.name.upper()


def _help(parameter: Parameter) -> str:
    if "Graph" in parameter.annotation:
        if "int" in parameter.annotation:
            return "a number, a type such as E6, or edges such as 1-2,2-3"
        return "edges such as 1-2,2-3; in a signed graph also 1+2 and 1"
    return "" if parameter.default is parameter.empty else f"(default {parameter.default})"


def _summary(name: str) -> str:
    """Return the first sentence of the docstring, without its verb."""
    first = (inspect.getdoc(FAMILIES[name]) or "").split("\n\n")[0].replace("\n", " ")
    return first.removeprefix("Return ").rstrip(".")


def _value(text: str) -> int | str:
    """Read a number n, or the name of a type, or a graph."""
    return int(text) if text.isascii() and text.isdigit() else text
