"""The subcommand ``draw`` of both programs: its options are those of the registered views."""

from __future__ import annotations

import argparse
import re
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from arrangement.console import terminal
from arrangement.errors import InputError

from .output import LEGENDS, THEMES
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
_PRINTING = ("font_size", "text", "fragment", "theme", "legend", "columns", "frames")
#: Options of several values that are written one by one.
_FLAGS = {"wrenches": "wrench"}


def add_options(
    parser: argparse.ArgumentParser, drawings: Drawings, own: Collection[str] = ()
) -> None:
    """Add the options of all that can be drawn, but for those that the command has itself.

    The help explains those of the view, model or page that is named, or lists whose they are.
    """
    words = parser.words if isinstance(parser, terminal.Parser) else ()
    asked = _asked(words) if {"-h", "--help"} & {*words} else None
    subject = next(a.metavar for a in parser._actions if not a.option_strings)
    parser.usage = f"%(prog)s {subject} -o PATH [--view VIEW] [options]"
    if not asked:
        parser.epilog = "--view VIEW --help explains the options of a view, a page or a model."
    parser.add_argument(
        "-o",
        "--output",
        required=True,
        metavar="PATH",
        help=".svg, .pdf, .png, .tex (TikZ): a picture; .gif, .mp4: one that turns; .html: a page"
        + "; .stl, .glb, .obj: a model" * bool(drawings.models),
    )
    for kind, suffix in (("view", "picture"), ("model", "model")):
        if known := getattr(drawings, f"{kind}s"):
            text = f"of a {suffix}: {', '.join(known)} (default: the first)"
            text += "; several, as in sphere,dual, are panels of one sheet" * (kind == "view")
            parser.add_argument(f"--{kind}", metavar=kind.upper(), help=text)
    for name, metavar, text in (
        ("font-size", "LENGTH", "of a picture, of its larger letters, such as 8pt; lines follow"),
        ("text", "KIND", f"in .svg: {' or '.join(LETTERS)}"),
        ("theme", "NAME", f"of a picture: {', '.join(THEMES)}"),
        ("legend", "PLACE", f"of a picture: {', '.join(LEGENDS)}"),
    ):
        default = "7pt" if name == "font-size" else "the first"
        parser.add_argument(f"--{name}", metavar=metavar, help=f"{text} (default: {default})")
    parser.add_argument(
        "--fragment", action="store_true", default=None, help="in .tex: no document, for \\input"
    )
    for name, metavar, text in (
        ("columns", "K", "of panels (default: 2)"),
        ("frames", "K", "of a full turn in .gif, .mp4 (default: 36)"),
    ):
        parser.add_argument(f"--{name}", type=terminal.integer_argument, metavar=metavar, help=text)
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
                parser.growing.append(added)


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
    """Say what an option means for the views that are asked for, or else whose option it is."""
    if not asked:
        return f"of {', '.join(name for name, _ in uses)}"
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
