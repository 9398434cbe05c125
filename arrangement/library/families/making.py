"""Families by name: one line on each, and the options of the command that makes their members."""

from __future__ import annotations

import argparse
import inspect
from collections.abc import Callable, Mapping

from arrangement.arrangement import Arrangement
from arrangement.io.writing import document_text

from . import classical, combinatorial, deformations, graphs, points, randoms
from .polygons import regular
from .root_systems import coxeter
from .simplicial import simplicial

#: Name on the command line -> function.
FAMILIES: Mapping[str, Callable[..., Arrangement]] = {
    function.__name__.replace("_", "-"): function
    for function in (
        *(classical.generic, classical.pencil, classical.near_pencil, classical.coordinate),
        *(classical.braid, classical.type_b, classical.type_d, coxeter),
        *(classical.h3, classical.h4, classical.perles, regular),
        *(deformations.shi, deformations.catalan, deformations.linial, deformations.semiorder),
        *(deformations.ish, deformations.ish_b),
        *(graphs.graphical, graphs.bigraphical, graphs.signed_graphical),
        *(combinatorial.resonance, combinatorial.threshold, combinatorial.threshold_functions),
        *(points.separations, points.discriminantal),
        *(randoms.random_integer, randoms.random_degenerate, randoms.random_sphere),
        simplicial,
    )
}


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
        family = families.add_parser(name, help=_summary(name), description=_summary(name))
        for parameter in _parameters(name):
            if parameter.annotation == "bool":
                family.add_argument(f"--{parameter.name}", action="store_true")
                continue
            needed = parameter.default is parameter.empty
            kinds = parameter.annotation.split(" | ")
            family.add_argument(
                f"--{parameter.name}",
                type=(_value if "int" in kinds else str) if "str" in kinds else int,
                required=needed,
                default=None if needed else parameter.default,
                metavar=_metavar(parameter),
                help=_help(parameter),
            )
        family.add_argument("-o", "--output", metavar="PATH", help="a file (default: print it)")


def document(arguments: argparse.Namespace) -> str:
    """Return the member that the options ask for, in file form with one plane a line."""
    values = {p.name: getattr(arguments, p.name) for p in _parameters(arguments.family)}
    given = ", ".join(f"{key} = {value}" for key, value in values.items())
    made = FAMILIES[arguments.family](**values).to_dict()
    made["description"] = f"{arguments.family}, {given}" if given else arguments.family
    return document_text(made)


def _parameters(name: str) -> list[inspect.Parameter]:
    return list(inspect.signature(FAMILIES[name]).parameters.values())


def _usage(parameter: inspect.Parameter) -> str:
    text = f"--{parameter.name}"
    if parameter.annotation != "bool":
        text += f" {_metavar(parameter)}"
    return text if parameter.default is parameter.empty else f"[{text}]"


def _metavar(parameter: inspect.Parameter) -> str:
    if "Graph" in parameter.annotation:
        return "N|TYPE|EDGES" if "int" in parameter.annotation else "EDGES"
    return parameter.name.upper()


def _help(parameter: inspect.Parameter) -> str:
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
