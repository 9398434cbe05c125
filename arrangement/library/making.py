"""Families by name: one line on each, and the options of the command that makes their members.

Names, options and lines are read from the text of the modules of `families`, which are imported
when a member is made, so that ``--help`` answers at once.
"""

from __future__ import annotations

import argparse
import ast
from collections.abc import Callable, Mapping
from functools import lru_cache
from importlib import import_module
from importlib.resources import files
from inspect import Parameter, cleandoc
from typing import TYPE_CHECKING

from arrangement.io.writing import document_text
from arrangement.terminal import times_argument

if TYPE_CHECKING:
    from arrangement.arrangement import Arrangement

_IN_MODULES = (
    ("classical", "generic pencil near_pencil coordinate braid type_b type_d"),
    ("root_systems", "coxeter"),
    ("classical", "h3 h4 perles"),
    ("polygons", "regular"),
    ("deformations", "shi catalan linial semiorder ish ish_b"),
    ("graphs", "graphical bigraphical signed_graphical"),
    ("combinatorial", "resonance threshold threshold_functions"),
    ("points", "separations discriminantal"),
    ("randoms", "random_integer random_degenerate random_sphere"),
    ("simplicial", "simplicial"),
)
#: Name on the command line -> module.
FAMILIES: Mapping[str, str] = {
    name.replace("_", "-"): module for module, names in _IN_MODULES for name in names.split()
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


def family(name: str) -> Callable[..., Arrangement]:
    """Return the function that makes the members of a family."""
    module = import_module(f"{__package__}.families.{FAMILIES[name]}")
    found: Callable[..., Arrangement] = getattr(module, name.replace("-", "_"))
    return found


def document(arguments: argparse.Namespace) -> str:
    """Return the member that the options ask for, in file form with one plane a line."""
    values = {p.name: getattr(arguments, p.name) for p in _parameters(arguments.family)}
    given = ", ".join(f"{key} = {value}" for key, value in values.items())
    made = family(arguments.family)(**values).to_dict()
    made["description"] = f"{arguments.family}, {given}" if given else arguments.family
    return document_text(made)


@lru_cache
def _functions(module: str) -> dict[str, ast.FunctionDef]:
    text = files(__package__).joinpath("families", f"{module}.py").read_text(encoding="utf-8")
    return {
        found.name: found for found in ast.parse(text).body if isinstance(found, ast.FunctionDef)
    }


def _function(name: str) -> ast.FunctionDef:
    return _functions(FAMILIES[name])[name.replace("-", "_")]


def _parameters(name: str) -> list[Parameter]:
    given = _function(name).args
    plain = [None] * (len(given.args) - len(given.defaults)) + list(given.defaults)
    pairs = zip(given.args + given.kwonlyargs, plain + list(given.kw_defaults), strict=True)
    return [
        Parameter(
            argument.arg,
            Parameter.KEYWORD_ONLY,
            default=Parameter.empty if default is None else ast.literal_eval(default),
            annotation=ast.unparse(argument.annotation) if argument.annotation else "",
        )
        for argument, default in pairs
    ]


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
    first = cleandoc(ast.get_docstring(_function(name)) or "").split("\n\n")[0].replace("\n", " ")
    return first.removeprefix("Return ").rstrip(".")


def _value(text: str) -> int | str:
    """Read a number n, or the name of a type, or a graph."""
    return int(text) if text.isascii() and text.isdigit() else text
