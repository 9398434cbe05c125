"""The subcommand ``draw`` of both programs: its options are those of the registered views.

Several views may have one option; it is added once, and the help explains it for the view that is
named.
"""

from __future__ import annotations

import argparse
import re
import textwrap
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from functools import partial
from shutil import get_terminal_size
from typing import Any, NamedTuple

from arrangement.console import terminal
from arrangement.console.options.parser import Parser
from arrangement.console.options.signature import Option, options_of
from arrangement.drawing.views import OPTION_SYNONYMS
from arrangement.errors import InputError

from .views import KINDS, Drawings, Printing

#: The options that ``--help`` shows without a view.
_COMMON = {"output", "view", "model", "width", "font", "font_size", "theme", "legend", "camera"}


class _Use(NamedTuple):
    """An option of a view, model or page."""

    kind: str
    name: str
    option: Option


def add_options(
    parser: Parser,
    drawings: Drawings,
    own: Collection[str] = (),
    common: Collection[str] = (),
    more: Mapping[str, str] | None = None,
) -> None:
    """Add the options of all that can be drawn.

    The help explains those of the view, model or page that is named; without one it lists the
    views, and the options that most of them have.

    Args:
        own: flags of options that the command has itself.
        common: flags of options that the help lists without a view, besides those of all pictures.
        more: what else the options "output" and "model" take, for their help.
    """
    more = more or {}
    asked: set[str] | None = None
    if {"-h", "--help"} & {*parser.arguments}:
        lists = re.findall(r"--(?:view|model)[ =]([^ ]+)", " ".join(parser.arguments))
        asked = {name for names in lists for name in names.split(",")}
    before = {*parser._actions}
    subject = next(a.metavar for a in parser._actions if not a.option_strings)
    parser.usage = f"%(prog)s {subject} -o FILE.svg [--view VIEW] [options]"
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument(
        "-o",
        "--output",
        required=True,
        metavar="FILE.svg",
        help=".svg, .pdf, .png, .tex (TikZ): a picture; .gif, .mp4: an animation; .html: a page"
        + "; .stl, .glb, .obj: a model" * bool(drawings.models)
        + more.get("output", ""),
    )
    _add_target(parser, drawings, more)
    for option in options_of(Printing).values():
        option.add_to(parser)
    uses = _uses(drawings)
    for flag in uses:
        if flag not in own:
            _add(parser, uses[flag], asked)
    parser.words = {
        f"--{old.replace('_', '-')}": f"--{new}" for old, new in OPTION_SYNONYMS.items()
    }
    parser.strays["mm|cm|in|pt"] = "a length in one word, such as 10cm"
    added = {*parser._actions} - before
    if asked:
        width = get_terminal_size().columns - 2
        texts = [
            textwrap.fill(f"{title}: {text}", width)
            for title, text in _summaries(drawings)
            if {*title.split()} & asked
        ]
        parser.description = "\n".join(texts) or parser.description
    elif asked is not None:
        _list(parser, drawings, {x for x in added if x.dest not in {*_COMMON, *common}})


def _add_target(parser: Parser, drawings: Drawings, more: Mapping[str, str]) -> None:
    """Add which view or model to draw."""
    for kind, thing in (("view", "picture"), ("model", "model")):
        if known := [*drawings.entries(kind)]:
            text = f"the {thing}, such as {known[0]} (default: the first that fits the input)"
            if kind == "view":
                text += f"; several, as in {known[0]},{known[1]}, become panels of one figure"
            parser.add_argument(f"--{kind}", metavar=kind.upper(), help=text + more.get(kind, ""))
            parser.names[kind] = partial(list, known)


def _uses(drawings: Drawings) -> dict[str, list[_Use]]:
    """Return the options by their flags, each with all that have it."""
    uses: dict[str, list[_Use]] = {}
    for kind in KINDS:
        for name in drawings.entries(kind):
            for option in drawings.options(kind, name).values():
                uses.setdefault(option.flag, []).append(_Use(kind, name, option))
    return uses


def _add(parser: Parser, uses: list[_Use], asked: set[str] | None) -> None:
    """Add an option as the first view has it, or for several values if one of them takes several.

    A view that is not named decides later whether it needs the option, and by what default.
    """
    first = uses[0].option
    several = any(use.option.several for use in uses)
    changes: dict[str, Any] = {"help": _help(uses, asked), "default": None, "required": False}
    if first.syntax.words == 0:
        changes["action"] = argparse.BooleanOptionalAction
    replace(first, several=several).add_to(parser, **changes)


def _help(uses: list[_Use], asked: set[str] | None) -> str:
    """Return what an option means for the views that are asked for, or the first one that has it.

    A view may refer to another one, "as for `draw_sphere`", and that to a third.
    """
    if not asked:
        return uses[0].option.help
    known = {use.name: use.option.text for use in uses if use.kind == "view"}
    texts = [use.option.text for use in uses if use.name in asked]
    for _ in range(2):
        texts = [
            re.sub(r"as for `draw_(\w+)`", lambda x: known[x[1]].rstrip("."), text)
            for text in texts
        ]
    helps = dict.fromkeys(replace(uses[0].option, text=text).help for text in texts)
    return "; or: ".join(helps) or argparse.SUPPRESS


def _list(parser: Parser, drawings: Drawings, hidden: Collection[argparse.Action]) -> None:
    """List what can be drawn, and hide the options that few views have."""
    parser.description = (
        f"{parser.prog} --view VIEW --help describes a view and its options.\n\n"
        f"{parser.description}"
    )
    for action in hidden:
        action.help = argparse.SUPPRESS
    rows = [*_summaries(drawings)]
    edge = max(len(title) for title, _ in rows) + 4
    width = max(get_terminal_size().columns - 2, edge + 20)
    listed = [
        textwrap.fill(f"  {title:<{edge - 2}}{text}", width, subsequent_indent=" " * edge)
        for title, text in rows
    ]
    parser.epilog = "\n".join(["views, models and pages:", *listed, "", parser.epilog or ""])


def _summaries(drawings: Drawings) -> Iterator[tuple[str, str]]:
    """Yield each view, model and page with the first paragraph of its docstring."""
    for kind in KINDS:
        for name in drawings.entries(kind):
            yield name if kind == "view" else f"{kind} {name}", drawings.summary(kind, name)


def given_options(
    arguments: argparse.Namespace, drawings: Drawings, known: Drawings | None = None
) -> dict[str, Any]:
    """Return the options that were given, as the view, model or page takes them.

    Args:
        drawings: of the subject.
        known: all those whose options the parser has, if they are more.
    """
    model = getattr(arguments, "model", None)
    kind, name = drawings.target(arguments.output, arguments.view, model)
    taken = {option.flag: option for option in drawings.options(kind, name).values()}
    printing = {name: getattr(arguments, name) for name in options_of(Printing)}
    options = {name: value for name, value in printing.items() if value is not None}
    for flag, uses in _uses(known or drawings).items():
        value = getattr(arguments, flag.replace("-", "_"))
        if value is None:
            continue
        option = taken.get(flag)
        if option and not option.several and any(use.option.several for use in uses):
            if len(value) > 1:
                raise InputError(f"--{flag} is given {len(value)} times; {name} takes one")
            (value,) = value
        options[option.name if option else uses[0].option.name] = value
    return options


def write(
    arguments: argparse.Namespace, drawings: Drawings, subject: Any, options: Mapping[str, Any]
) -> int:
    """Write the file, and with ``--json`` say what it is."""
    model = getattr(arguments, "model", None)
    written = drawings.write(subject, arguments.output, arguments.view, model, **options)
    if arguments.json:
        terminal.print_json({"output": arguments.output, **written})
    return terminal.YES
