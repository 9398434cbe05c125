"""The parser of the programs, and what it does otherwise than argparse.

* ``-1/2`` and ``-0.25`` are values, not options (`_negative_number_matcher`).
* ``0,1,0`` and ``0, 1, 0`` are three numbers, where an option takes several (`_split_numbers`).
* An option that is given twice, or has an empty value, is refused (`_get_values`, `_refuse_empty`).
* Names that do not exist are answered with those that do, the nearest first (`_check_value`,
  `answers`), and what is missing with the whole line (`error`).
* Help that cannot be written is an error (`_print_message`).
* Options that take time to find out are added when their command is parsed (`lazy_options`).
* The help of a program lists its commands under headings (`format_help`).

argparse has no public hooks for the second to fifth of these; their methods override its own.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from functools import partial
from itertools import takewhile
from typing import Any, NoReturn

from arrangement.console.safe_text import error_text
from arrangement.numbers.exact import shown

from .answers import (
    ALIKE,
    Entry,
    commands_of,
    family,
    is_option,
    kinds,
    line,
    missing,
    rows,
    unexpected,
    unknown_command,
    unknown_option,
)
from .values import MAX_COUNT, rational_argument

_BAD_INPUT = 2
_NEGATIVE_NUMBER = re.compile(r"-\.?[0-9]")
_NUMBER = re.compile(r"[+-]?\.?[0-9]")


class Parser(argparse.ArgumentParser):
    """A parser of a program, or of one of its commands.

    That of a command names its function with ``set_defaults(command=function)``; the function takes
    the parsed arguments and returns an exit code (see `terminal.run`).

    Attributes:
        lazy_options: adds the options that take time to find out.
        variadic: options that take more numbers where more follow, each with the least number.
        arguments: the words that are parsed.
        strays: patterns of words for which there is no place, each with what to write, in which
            ``{}`` stands for the word.
        usual: an option that is written where a command needs one of several.
        words: other words for options, each with the name of the option.
        commands: of a program by name; each knows them all.
        headings: the commands of a program under headings of its help: names with what they do.
        names: for arguments and options, by their destination, a function that returns the names
            that a shell completes them with.
    """

    def __init__(self, **options: Any) -> None:
        options.setdefault("allow_abbrev", False)
        super().__init__(**options)
        self._negative_number_matcher = _NEGATIVE_NUMBER
        self.lazy_options: Callable[[], None] | None = None
        self.variadic: dict[argparse.Action, Any] = {}
        self.arguments: Sequence[str] = ()
        self.usual = ""
        self.words: Mapping[str, str] = {}
        self.commands: Mapping[str, Parser] = {}
        self.strays: dict[str, str] = {}
        self.headings: dict[str, list[tuple[str, str]]] = {}
        self.names: dict[str, Callable[[], Iterable[str]]] = {}
        #: Options with a value, in the order in which they are parsed.
        self._seen: list[argparse.Action] = []

    def add_subparsers(self, **options: Any) -> Any:
        """Return the commands, to which `add_command` adds one."""
        commands: Any = super().add_subparsers(**options)
        commands.program = self
        self.commands = commands.choices
        return commands

    def add_lazy_options(self) -> None:
        """Add the options that take time to find out, once."""
        lazy_options, self.lazy_options = self.lazy_options, None
        if lazy_options is not None:
            lazy_options()

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Parse, with all options; ``--help`` comes through here too."""
        self.arguments = words = sys.argv[1:] if args is None else args
        self._seen = []
        self.add_lazy_options()
        arguments, rest = super().parse_known_args(list(self._split_numbers(words)), namespace)
        for word in rest:
            self.error(*(unknown_option if is_option(word) else unexpected)(self, word))
        self._refuse_empty(arguments)
        return arguments, rest

    def _refuse_empty(self, arguments: argparse.Namespace) -> None:
        for action in self._actions:
            if getattr(arguments, action.dest, None) == "" and action.dest != "title":
                name = "/".join(action.option_strings) or action.metavar
                self.error(f"argument {name}: it is empty; give a name")

    def _split_numbers(self, words: Sequence[str]) -> Iterator[str]:
        """Yield the words, with numbers that are separated by commas as words of their own."""
        due = 0  # how many numbers the option before takes
        for i, word in enumerate(words):
            name, equals, value = word.partition("=")
            option = self._option_string_actions.get(name)
            if option is not None:
                if option in self.variadic:
                    values = [value, *words[i + 1 :]] if equals else words[i + 1 :]
                    option.nargs = max(self.variadic[option], _numbers(values))
                due = _numbers_after(option)
            if option is not None and due and equals and not re.match(r"-[^.0-9]", value):
                yield name
                word = value
            elif option is not None or not due:
                yield word
                continue
            parts = re.split(r"[\s,]+", word.strip(", ()[]"))
            if "," not in word and not all(map(_NUMBER.match, parts)):
                parts = [word]  # a name with a space
            due = max(due - len(parts), 0)
            yield from parts

    def _get_values(self, action: argparse.Action, arg_strings: list[str]) -> Any:
        """Refuse an option that is given again, whose last value would be taken, and ``-o=--``.

        argparse drops the ``--``, and goes on with no value.
        """
        if action.option_strings and action.nargs != 0:
            if "--" in arg_strings:
                raise argparse.ArgumentError(action, "it is '--'; expected a value")
            if action in self._seen and not isinstance(action, argparse._AppendAction):
                raise argparse.ArgumentError(action, "it is given twice; give it once")
            self._seen.append(action)
        for word in () if action.option_strings else arg_strings:
            known = self.names.get(action.dest)
            if known is None or os.path.lexists(word) or word in known():
                continue
            if f"--{word}" in self._option_string_actions:
                self.error(*unexpected(self, word))
            if use := family(self, word, partial(line, self)):
                self.error(use)
        return super()._get_values(action, arg_strings)

    def _match_argument(self, action: argparse.Action, arg_strings_pattern: str) -> int:
        """Name the values that an option takes where they are missing."""
        try:
            return super()._match_argument(action, arg_strings_pattern)
        except argparse.ArgumentError as error:
            name = "/".join(action.option_strings) or str(action.metavar)
            self.error(f"argument {name}: {error.message}:", missing(self, [name]))

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """Name the nearest choices of a misspelt one."""
        if action.choices is not None and value not in action.choices:
            if isinstance(action, argparse._SubParsersAction):
                self.error(*unknown_command(self, str(value)))
            known = list(action.choices)
            near = get_close_matches(value, known, 3, ALIKE)
            meant = f"; did you mean {' or '.join(near)}?" if near else ""
            text = f"there is no {shown(value)}; expected one of {', '.join(known)}{meant}"
            raise argparse.ArgumentError(action, text)

    def format_help(self) -> str:
        """Return the help; a program with headings lists its commands under them."""
        for option, least in self.variadic.items():
            option.nargs = least  # as many as it has names for
        if not self.headings:
            return super().format_help()
        parts = [f"usage: {self.prog} [--version] COMMAND ...", self.description or ""]
        for heading, listed in self.headings.items():
            parts.append("\n".join([f"{heading}:", *self._rows(listed)]))
        parts += [f"{self.prog} COMMAND --help describes a command.", self.epilog or ""]
        return "\n\n".join(parts) + "\n"

    def _rows(self, rows: Iterable[tuple[str, str]]) -> Iterator[str]:
        """Yield commands with what they do, a line each."""
        width = max(len(name) for rows in self.headings.values() for name, _ in rows) + 2
        return (f"  {name:<{width}}{text}" for name, text in rows)

    def _print_message(self, message: str, file: Any = None) -> None:
        """Print help; argparse hides that it cannot be written."""
        if message:
            print(message, end="", file=file or sys.stderr, flush=True)

    def error(self, message: str, listed: Sequence[Entry] = ()) -> NoReturn:
        """Print an error, and what is listed, a line each; exit with 2.

        Where something is missing, an option that is misspelt may be it.
        """
        if "required" in message:
            known = self._option_string_actions
            for word in filter(is_option, self.arguments):
                if word.partition("=")[0] not in known and word != "--":
                    self.error(*unknown_option(self, word))
            if kinds(self):
                message, listed = f"{message}; expected one of these:", commands_of(self)
            else:
                names = message.partition("required: ")[2].split(", ")
                message += f"; write {line(self, self.arguments)}, where:"
                listed = missing(self, names)
        see = "" if listed else f" (see {self.prog} --help)"
        text = "\n".join([f"error: {error_text(message)}{see}", *map(error_text, rows(listed))])
        self.exit(_BAD_INPUT, f"{text}\n")


def _numbers_after(option: argparse.Action) -> int:
    """Return how many numbers an option takes at most."""
    if option.nargs == "+" and (option.type is rational_argument or option.metavar == "NUMBER"):
        return MAX_COUNT  # points keep their commas
    numbers = isinstance(option.nargs, int) and option.type in (None, rational_argument)
    return option.nargs if numbers else 0  # type: ignore[return-value]


def _numbers(words: Sequence[str]) -> int:
    """Return how many numbers come first, in one word or several."""
    parts = (part for word in words for part in re.split(r"[\s,]+", word.strip(", ()[]")))
    return sum(1 for _ in takewhile(re.compile(r"[-+]?[.]?[0-9]").match, parts))


class Version(argparse.Action):
    """Print the version of the distribution, and of what computes exactly under it.

    Distributions are read only when they are asked for; none is imported.
    """

    def __init__(self, option_strings: Sequence[str], dest: str, **options: Any) -> None:
        text = "print the versions of the program and of what it computes with"
        super().__init__(option_strings, argparse.SUPPRESS, nargs=0, help=text)

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> NoReturn:
        """Print them, and end the program."""
        from importlib.metadata import PackageNotFoundError, version
        from platform import python_version

        from arrangement import __version__

        parts = [f"Python {python_version()}"]
        for name in ("numpy", "sympy", "python-flint"):
            try:
                parts.append(f"{name} {version(name)}")
            except PackageNotFoundError:
                parts.append(f"no {name}")
        print(f"{parser.prog} {__version__} ({', '.join(parts)})", flush=True)
        parser.exit(0)
