"""Options from functions: one for each parameter, as the signature and the docstring have it.

* The name of the parameter is that of the option, with dashes.
* Its type says how a value is written. `bool`, `int`, `float` and `str` have their usual syntax;
  other types bring theirs, as in ``Vector = Annotated[Sequence[object], Syntax(...)]``.
  ``Iterable[X]`` takes several values of type X; ``X | Y`` is written as X.
* Its default is that of the option; without one, the option is required.
* Its text stands in the section ``Args`` of the docstring.
"""

from __future__ import annotations

import argparse
import inspect
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace, UnionType
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

from arrangement.hints import argument_texts

from .parser import Parser
from .values import integer_argument, length_argument


@dataclass(frozen=True)
class Syntax:
    """How a value of a type is written on a command line.

    Attributes:
        read: from a word to a value.
        metavar: what stands for the value in the help; if omitted, the name in capitals.
        words: how many words make one value, if not one: a number, or "?", "*", "+".
        bare: the value of an option without words, where "?" allows that.
        flag: the name of the option, if another than that of the parameter.
        variadic: whether it takes more words where more numbers follow.
    """

    read: Callable[[str], Any] = str
    metavar: str | tuple[str, ...] | None = None
    words: int | str | None = None
    bare: object = None
    flag: str = ""
    variadic: bool = False


#: Of types that bring none; a `bool` takes no word.
USUAL_SYNTAX: Mapping[object, Syntax] = {
    str: Syntax(metavar="NAME"),
    int: Syntax(integer_argument, "K"),
    float: Syntax(length_argument, "N"),
    bool: Syntax(words=0),
}


@dataclass(frozen=True)
class Option:
    """A parameter of a function, as an option.

    Attributes:
        several: whether it takes several values.
        text: what the docstring says of it.
        required: whether it has no default.
    """

    name: str
    syntax: Syntax
    several: bool
    default: Any
    text: str
    required: bool

    @property
    def flag(self) -> str:
        """The option without its dashes in front."""
        return (self.syntax.flag or self.name).replace("_", "-")

    @property
    def help(self) -> str:
        """The text as argparse takes it."""
        return self.text.replace("`", "").replace("%", "%%").rstrip(".")

    def add_to(self, parser: Any, **changes: Any) -> argparse.Action:
        """Add the option to a parser, or to a group of one.

        Args:
            changes: of what is handed to `argparse.ArgumentParser.add_argument`.
        """
        syntax = self.syntax
        style: dict[str, Any] = {"help": self.help}
        style |= {"required": True} if self.required else {"default": self.default}
        if syntax.words == 0:
            style["action"] = "store_true"
        else:
            style |= {"type": syntax.read, "metavar": syntax.metavar or self.name.upper()}
        if syntax.words:
            style |= {"nargs": syntax.words, "const": syntax.bare}
        if self.several:
            style |= {"action": "append"} if syntax.words else {"action": "extend", "nargs": "+"}
            if isinstance(self.default, tuple):
                style["default"] = list(self.default)  # argparse appends to it
        added: argparse.Action = parser.add_argument(f"--{self.flag}", **style | changes)
        if syntax.variadic:
            # A group knows its parser.
            whole: Parser = getattr(parser, "_container", parser)
            whole.variadic[added] = added.nargs
        return added


@cache
def options_of(function: Callable[..., Any], keywords: bool = False) -> dict[str, Option]:
    """Return the options of a function by the names of its parameters.

    Args:
        keywords: only those of keyword-only parameters, without ``**options``.
    """
    texts = argument_texts(inspect.getdoc(function) or "")
    names = vars(sys.modules[inspect.unwrap(function).__module__])
    options = {}
    for name, parameter in inspect.signature(function).parameters.items():
        if keywords and parameter.kind is not parameter.KEYWORD_ONLY:
            continue
        hint = SimpleNamespace(__annotations__={name: parameter.annotation})
        kind, several = _kind(get_type_hints(hint, names, include_extras=True)[name])
        text, required = texts.get(name, ""), parameter.default is parameter.empty
        options[name] = Option(name, _syntax(kind), several, parameter.default, text, required)
    return options


def _kind(hint: Any) -> tuple[Any, bool]:
    """Return the type of one value, and whether there may be several."""
    if get_origin(hint) in (Union, UnionType):
        return _kind(get_args(hint)[0])
    return (get_args(hint)[0], True) if get_origin(hint) is Iterable else (hint, False)


def _syntax(kind: Any) -> Syntax:
    if get_origin(kind) is Annotated:
        return next(x for x in kind.__metadata__ if isinstance(x, Syntax))
    return USUAL_SYNTAX[kind]
