"""The subcommand ``draw`` of both programs: its options are those of the registered views."""

from __future__ import annotations

import argparse
import re
import textwrap
from collections.abc import Collection, Iterator, Mapping
from shutil import get_terminal_size
from typing import Any

from arrangement.console import terminal
from arrangement.errors import InputError

from .output import LEGENDS, RENAMED_OPTIONS, THEMES
from .registry import LENGTHS, LETTERS, Drawings, Option

_KINDS: dict[str, dict[str, Any]] = {
    "str": {"metavar": "NAME"},
    "Labels": {"metavar": "NAME"},
    "Choice": {"metavar": "NAME"},
    "AxisNames": {"nargs": "?", "const": True, "metavar": "NAMES"},
    "int": {"type": terminal.integer_argument, "metavar": "K"},
    "float": {"type": terminal.length_argument, "metavar": "N"},
    "length": {"metavar": "LENGTH"},
    "Exact": {"type": terminal.rational_argument, "metavar": "Q"},
    "Vector": {"type": terminal.rational_argument, "nargs": 3, "metavar": ("X", "Y", "Z")},
    "Wrench": {"type": terminal.rational_argument, "nargs": 3, "metavar": ("FX", "FY", "TAU")},
    "Corner": {"type": lambda text: text.split(","), "metavar": "X,Y"},
    "Equation": {"type": lambda text: text.split(","), "metavar": "A,B,..,E"},
    "bool": {"action": argparse.BooleanOptionalAction, "default": None},
}
#: Options of all pictures.
_PRINTING = ("font_size", "font", "text", "fragment", "theme", "legend", "columns", "frames")
#: The options that ``--help`` shows without a view.
_COMMON = {"output", "view", "model", "width", "font", "font_size", "theme", "legend", "camera"}
#: Options of several values that are written one by one.
_FLAGS = {"wrenches": "wrench"}


def add_options(
    parser: argparse.ArgumentParser, drawings: Drawings, own: Collection[str] = ()
) -> None:
    """Add the options of all that can be drawn, but for those that the command has itself.

    The help explains those of the view, model or page that is named; without one it lists the
    views, and the options that most of them have.
    """
    words = parser.arguments if isinstance(parser, terminal.Parser) else ()
    before = {*parser._actions}
    asked = _asked(words) if {"-h", "--help"} & {*words} else None
    subject = next(a.metavar for a in parser._actions if not a.option_strings)
    parser.usage = f"%(prog)s {subject} -o PATH [--view VIEW] [options]"
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument(
        "-o",
        "--output",
        required=True,
        metavar="PATH",
        help=".svg, .pdf, .png, .tex (TikZ): a picture; .gif, .mp4: one that turns; .html: a page"
        + "; .stl, .glb, .obj: a model" * bool(drawings.models),
    )
    _add_printing(parser, drawings)
    found: dict[str, list[tuple[str, Option]]] = {}
    for name, option in _every(drawings):
        found.setdefault(_flag(option), []).append((name, option))
    for flag, uses in found.items():
        if flag not in own:
            style = dict(_KINDS["length" if flag in LENGTHS else uses[0][1].kind])
            if any(option.many for _, option in uses):
                extend = {"action": "extend", "nargs": "+"}
                style |= {"action": "append"} if "nargs" in style else extend
            text = _help(uses, asked)
            added = parser.add_argument(f"--{flag.replace('_', '-')}", **style, help=text)
            if uses[0][1].kind == "Wrench" and isinstance(parser, terminal.Parser):
                parser.variadic.append(added)
    if isinstance(parser, terminal.Parser):
        names = {f"--{old}": f"--{new}" for old, new in RENAMED_OPTIONS.items() if new in found}
        parser.renamed = {**parser.renamed, **names}
    if asked is not None:
        _explain(parser, drawings, asked, {*parser._actions} - before)


def _add_printing(parser: argparse.ArgumentParser, drawings: Drawings) -> None:
    """Add what to draw, and the options of all pictures."""
    for kind, suffix in (("view", "picture"), ("model", "model")):
        if known := getattr(drawings, f"{kind}s"):
            first, second = [*known][:2]
            text = f"the {suffix}, such as {first} (default: the first that suits)"
            if kind == "view":
                text += f"; several, as in {first},{second}, are panels of one figure"
            parser.add_argument(f"--{kind}", metavar=kind.upper(), help=text)
    for name, metavar, text in (
        ("font", "NAME", "of .svg, .pdf, .png: an installed font (default: DejaVu Sans)"),
        (
            "font-size",
            "LENGTH",
            "size of the larger text, such as 8pt; lines follow (default: 7pt)",
        ),
        ("theme", "NAME", f"{', '.join(THEMES)} (default: the first)"),
        ("legend", "PLACE", f"{', '.join(LEGENDS)} (default: the first)"),
        ("text", "KIND", f"in .svg: {' or '.join(LETTERS)} (default: the first)"),
    ):
        parser.add_argument(f"--{name}", metavar=metavar, help=text)
    parser.add_argument(
        "--fragment", action="store_true", default=None, help="in .tex: no document, for \\input"
    )
    for name, metavar, text in (
        ("columns", "K", "of panels (default: 2)"),
        ("frames", "K", "of a full turn in .gif, .mp4 (default: 36)"),
    ):
        parser.add_argument(f"--{name}", type=terminal.integer_argument, metavar=metavar, help=text)


def _explain(
    parser: argparse.ArgumentParser,
    drawings: Drawings,
    asked: set[str],
    added: Collection[argparse.Action],
) -> None:
    """Describe what can be drawn, or what is asked for; hide the options that it does not need."""
    if asked:
        width = get_terminal_size().columns - 2
        texts = [
            textwrap.fill(f"{name}: {text}", width)
            for name, text in _summaries(drawings)
            if {*name.split()} & asked
        ]
        parser.description = "\n".join(texts) or parser.description
        return
    parser.description = (
        f"{parser.prog} --view VIEW --help describes a view and its options.\n\n"
        f"{parser.description}"
    )
    for action in added:
        if action.dest not in _COMMON and action.dest not in _FLAGS.values():
            action.help = argparse.SUPPRESS
    rows = [*_summaries(drawings)]
    edge = max(len(name) for name, _ in rows) + 4
    room, hung = max(get_terminal_size().columns - 2, edge + 20), " " * edge
    listed = "\n".join(
        textwrap.fill(text, room, initial_indent=f"  {name}".ljust(edge), subsequent_indent=hung)
        for name, text in rows
    )
    parser.epilog = f"views, models and pages:\n{listed}\n\n{parser.epilog}"


def _summaries(drawings: Drawings) -> Iterator[tuple[str, str]]:
    """Yield each view, model and page with the first line of its docstring."""
    for kind in ("view", "model", "page"):
        for name in getattr(drawings, f"{kind}s"):
            shown = name if kind == "view" else f"{kind} {name}"
            yield shown, drawings.summary(kind, name).rstrip(".")


def _every(drawings: Drawings) -> Iterator[tuple[str, Option]]:
    for kind in ("view", "model", "page"):
        for name in getattr(drawings, f"{kind}s"):
            shown = name if kind == "view" else f"{kind} {name}"
            yield from ((shown, option) for option in drawings.options(kind, name).values())


def _flag(option: Option) -> str:
    return _FLAGS.get(option.name, option.name)


def _asked(words: Collection[str]) -> set[str]:
    """Return the views, models and pages that are named on a command line."""
    found = re.findall(r"--(?:view|model)[ =]([^ ]+)", " ".join(words))
    return {name for names in found for name in names.split(",")}


def _help(uses: list[tuple[str, Option]], asked: set[str] | None) -> str:
    """Say what an option means for the views that are asked for, or the first one that has it."""
    if not asked:
        return uses[0][1].text.replace("%", "%%").rstrip(".")
    known = {name: option.text for name, option in uses}
    own = [text for name, text in known.items() if name.rpartition(" ")[2] in asked]
    for _ in range(2):  # a view may refer to another one, and that to a third
        own = [re.sub(r"as for `draw_(\w+)`", lambda x: known[x[1]].rstrip("."), t) for t in own]
    texts = dict.fromkeys(text.replace("`", "").replace("%", "%%").rstrip(".") for text in own)
    return "; or: ".join(texts) or argparse.SUPPRESS


def given_options(
    arguments: argparse.Namespace, drawings: Drawings, known: Drawings | None = None
) -> dict[str, Any]:
    """Return the options that were given, as the view, model or page takes them.

    Args:
        drawings: of the subject.
        known: all those whose options the parser has, if they are more.
    """
    known = known or drawings
    kind, name = drawings.target(
        arguments.output, arguments.view, getattr(arguments, "model", None)
    )
    takes = {_flag(option): option for option in drawings.options(kind, name).values()}
    printing = {key: getattr(arguments, key) for key in _PRINTING}
    options: dict[str, Any] = {key: x for key, x in printing.items() if x is not None}
    for flag in dict.fromkeys(_flag(option) for _, option in _every(known)):
        value = getattr(arguments, flag)
        if value is None:
            continue
        option = takes.get(flag)
        repeated = any(_flag(o) == flag and o.many for _, o in _every(known))
        if option is not None and repeated and not option.many:
            if len(value) > 1:
                raise InputError(f"--{flag} is given {len(value)} times; {name} takes one")
            (value,) = value
        options[flag if option is None else option.name] = value
    return options


def write(
    arguments: argparse.Namespace, drawings: Drawings, subject: Any, options: Mapping[str, Any]
) -> int:
    """Write the file, and with ``--json`` say what it is."""
    written = drawings.write(
        subject, arguments.output, arguments.view, getattr(arguments, "model", None), **options
    )
    if arguments.json:
        terminal.print_json({"output": arguments.output, **written})
    return terminal.YES
