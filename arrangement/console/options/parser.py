"""The parser of the programs, and what it does otherwise than argparse.

* ``-1/2`` and ``-0.25`` are values, not options (`_negative_number_matcher`).
* ``0,1,0`` and ``0, 1, 0`` are three numbers, where an option takes several (`_split_numbers`).
* An option that is given twice, or has an empty value, is refused (`_get_values`, `_refuse_empty`).
* Names that are misspelt or were synonyms are answered with those that exist (`_check_value`,
  `_unknown`). Every error is one line, which the commands of a program follow if none is meant
  (`error`).
* Help that cannot be written is an error (`_print_message`).
* Options that take time to find out are added when their command is parsed (`lazy_options`).
* The help of a program lists its commands under headings (`format_help`).

argparse has no public hooks for the second to fifth of these; their methods override its own.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from itertools import dropwhile, takewhile
from pathlib import Path
from typing import Any, NoReturn

from arrangement.console.safe_text import error_text
from arrangement.numbers.exact import shown

from .values import MAX_COUNT, integer_argument, rational_argument

_BAD_INPUT = 2
#: Options of all commands, which no misspelt one is answered with.
_EVERYWHERE = {"help", "json", "limit", "traceback", "exact", "digits"}
#: Options that are listed where one is unknown.
_FEW = 40
#: The end of an error that the commands of a program follow.
_COMMANDS = "expected one of these commands:"
#: How alike a misspelt name is to the one that is meant, as "jbos" and "jobs"; "slides" and "list"
#: are less so.
_ALIKE = 0.75
#: The same for other words, of which there are many.
_CLOSE = 0.85
_NEGATIVE_NUMBER = re.compile(r"-\.?[0-9]")
_NUMBER = re.compile(r"[+-]?\.?[0-9]")
#: What stands for a file or a name in what to write.
_PLACE = re.compile(r"\b(?:CLAIM|FILE|GRASP|ID)\b(?!\.)")


class Parser(argparse.ArgumentParser):
    """A parser of a program, or of one of its commands.

    That of a command names its function with ``set_defaults(command=function)``; the function takes
    the parsed arguments and returns an exit code (see `terminal.run`).

    Attributes:
        lazy_options: adds the options that take time to find out.
        variadic: options that take at least so many numbers as their ``nargs``.
        arguments: the words that are parsed.
        strays: patterns of words for which there is no place, each with what to write, in which
            ``{}`` stands for the word.
        for_files: of a program, the command that takes a file or a built-in name, ``{}``.
        synonyms: other words for commands and options, each with what to write.
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
        self.variadic: list[argparse.Action] = []
        self.arguments: Sequence[str] = ()
        self.synonyms: Mapping[str, str] = {}
        self.commands: Mapping[str, Parser] = {}
        self.strays: dict[str, str] = {}
        self.for_files = ""
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
            self.error(self._unknown(word))
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
                    given = [value, *words[i + 1 :]] if equals else words[i + 1 :]
                    option.nargs = max(option.nargs, _numbers(given))  # type: ignore[type-var]
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
            if use := self._synonym(word) or self._made(word):
                self.error(use)
        return super()._get_values(action, arg_strings)

    def _match_argument(self, action: argparse.Action, arg_strings_pattern: str) -> int:
        """Name the values that an option takes where they are missing."""
        try:
            return super()._match_argument(action, arg_strings_pattern)
        except argparse.ArgumentError as error:
            values = self._get_formatter()._format_args(action, action.dest.upper())
            raise argparse.ArgumentError(action, f"{error.message}: {values}") from None

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """Name the nearest choices of a misspelt one."""
        if action.choices is not None and value not in action.choices:
            if isinstance(action, argparse._SubParsersAction):
                self._refuse_other_word(str(value), action.choices)
            known = list(action.choices)
            near, expected = _suggestion(value, known), f"expected one of {', '.join(known)}"
            if self.headings and not near:
                action, expected = None, _COMMANDS  # type: ignore[assignment]
            raise argparse.ArgumentError(action, f"there is no {shown(value)}; {expected}{near}")

    def _refuse_other_word(self, word: str, commands: Mapping[str, Parser]) -> None:
        """Refuse a word that is not a command, if it can be seen what is meant."""
        if use := self._synonym(word):
            answers = map(self._made, self.arguments) if _PLACE.search(use) else iter(())
            raise argparse.ArgumentError(None, next(filter(None, answers), use))
        use = self._stray(word)
        if not use and self.for_files:
            is_name = re.search(r"[./]", word) or word in self.names["file"]()
            use = self.for_files.replace("{}", shlex.quote(word)) if is_name else ""
        if not use and (made := self._made(word)):
            raise argparse.ArgumentError(None, made)
        if use := use or self._with_option(word):
            raise argparse.ArgumentError(None, f"{shown(word)} is not a command; write {use}")
        if use := self._synonym_of_part(word):
            raise argparse.ArgumentError(None, use)

    def _made(self, word: str) -> str:
        """Return the answer to a word that names a family, as ``shi(3)``, or ``shi 3`` in two."""
        match = re.fullmatch(r"([A-Za-z][\w-]*)(?:[:(](.*))?", word)
        if match is None or "make" not in self.commands:
            return ""
        self.commands["make"].add_lazy_options()
        name = match[1].lower().replace("_", "-")
        family = self.commands["make"].commands.get(name)
        if family is None:
            return ""
        family.add_lazy_options()
        words = [*self.arguments]
        after = words[words.index(word) + 1 :] if word in words else []
        typed = " ".join([match[2] or "", *takewhile(lambda x: x[:1] != "-", after)])
        numbers = re.findall(r"\b[A-Z]?[0-9]+\b", typed)  # and types, as B3
        options = [*dropwhile(lambda x: not x.startswith("-"), after)]
        options = [part for x in options for part in (x.split("=", 1) if x[:2] == "--" else [x])]
        parts = []
        for action in sorted(family._actions, key=lambda x: not x.required):
            usual = "N" in str(action.metavar).split("|") or action.type is integer_argument
            own = {*action.option_strings} - {"-o", *self._option_string_actions}
            if flag := next((x for x in options[:-1] if x in own), ""):
                at = options.index(flag)
                parts.append(f"{flag} {options[at + 1]}")
                del options[at : at + 2]
            elif action.required or (numbers and usual and action.dest not in _EVERYWHERE):
                is_taken = numbers and (usual or not numbers[0].isdecimal())
                value = numbers.pop(0) if is_taken else "3" * usual
                usage = family._usage(action) if action.option_strings else str(action.metavar)
                parts.append(f"{action.option_strings[0]} {value}" if value else usage)
        made = " ".join([family.prog, *parts, "-o FILE.json"])
        then = f"{self.for_files.partition('{}')[0]}FILE.json"
        if not self.for_files:
            missing = (x for x in self._actions if x.required and x.option_strings)
            rest = shlex.join(options) or " ".join(map(self._usage, missing))
            then = f"{self.prog} FILE.json {rest}".strip()
        return f"{shown(word)} is a family; write {made!r}, then {then!r}"

    def _with_option(self, word: str) -> str:
        """Return the command that has an option of this name, or one that may have this value."""
        flag = f"--{word.lstrip('-')}"
        for command in self.commands.values():
            command.add_lazy_options()
            takes_it = {dest for dest, known in command.names.items() if word in known()}
            for action in command._actions:
                if flag in action.option_strings:
                    return f"{command.prog} {command._places()} {command._usage(action)}"
                if action.option_strings and action.dest in takes_it:
                    return f"{command.prog} {command._places()} {action.option_strings[-1]} {word}"
        return ""

    def _places(self) -> str:
        """Return what the command takes besides options."""
        places = (x for x in self._actions if not x.option_strings)
        return " ".join(str(place.metavar or place.dest) for place in places)

    def _usage(self, action: argparse.Action) -> str:
        """Return an option with what stands for its values."""
        values = self._get_formatter()._format_args(action, action.dest.upper())
        return " ".join([action.option_strings[0], *[values] * (action.nargs != 0)])

    def _stray(self, word: str) -> str:
        """Return what to write for a word for which there is no place, if that is known."""
        uses = (use for pattern, use in self.strays.items() if re.fullmatch(pattern, word))
        return next(uses, "").replace("{}", shlex.quote(word))

    def _synonym(self, word: str) -> str:
        """Return the answer to another word for a command or an option."""
        use = self.synonyms.get(word.lower().replace("_", "-"), "")
        option = re.match(r"--[\w-]+", use)
        is_there = option is None or option[0] in self._option_string_actions
        return f"there is no {word!r}; write {self._filled(use)!r}" if use and is_there else ""

    def _filled(self, use: str) -> str:
        """Return what to write, with the file or name that was typed in its place."""
        files = (
            word
            for word in takewhile(lambda x: not x.startswith("-"), self.arguments)
            if Path(word).is_file() or any(word in known() for known in self.names.values())
        )
        file = next(files, "") if _PLACE.search(use) else ""
        return _PLACE.sub(lambda _: shlex.quote(file), use) if file else use

    def _synonym_of_part(self, word: str) -> str:
        """Return the answer to a part of a word, as ``--color-by`` has one."""
        before = "--" if word.startswith("--") else ""
        parts = re.split("[-_]+", word.strip("-"))
        alike = get_close_matches(word.lower(), self.synonyms, 1, _CLOSE)
        answers = map(self._synonym, [*(before + part for part in parts), *alike])
        return next(filter(None, answers), "")

    def _unknown(self, word: str) -> str:
        name = word.partition("=")[0]
        if use := self._synonym(name):
            return use
        if use := self._stray(word):
            return f"unexpected argument {shown(word)}; write {use}"
        if not word.startswith("-"):
            takes = self._places() or "options alone"
            return f"unexpected argument {shown(word)}; {self.prog} takes {takes}"
        if word.startswith("--") and (use := self._with_option(name)):
            return f"{self.prog} has no {name}; write {use}"
        own = [
            action.option_strings[-1]
            for action in self._actions
            if action.option_strings and action.dest not in _EVERYWHERE
        ]
        few = (
            f"; expected one of {', '.join(own)}"
            if self._subparsers is None and 0 < len(own) <= _FEW
            else ""
        )
        near = _suggestion(
            name.lstrip("-"), [x.lstrip("-") for x in self._option_string_actions], "--"
        )
        return (
            (near and f"unknown option {shown(word)}{near}")
            or self._synonym_of_part(name)
            or (f"unknown option {shown(word)}{few}")
        )

    def format_help(self) -> str:
        """Return the help; a program with headings lists its commands under them."""
        if not self.headings:
            return super().format_help()
        parts = [f"usage: {self.prog} [--version] COMMAND ...", self.description or ""]
        for heading, rows in self.headings.items():
            parts.append("\n".join([f"{heading}:", *self._rows(rows)]))
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

    def error(self, message: str) -> NoReturn:
        """Print one line with the error to stderr; exit with 2.

        Where something is missing, an option that is misspelt may be it.
        """
        options = (word.partition("=")[0] for word in self.arguments if word[:2] == "--" != word)
        misspelt = (word for word in options if word not in self._option_string_actions)
        if "required" in message and (word := next(misspelt, None)):
            message = self._unknown(word)
        for action in self._actions:
            if action.choices and message.endswith(f"required: {action.metavar}"):
                known = f"expected one of {', '.join(map(str, action.choices))}"
                message += f"; {_COMMANDS if self.headings else known}"
            elif message.endswith(f"required: {'/'.join(action.option_strings) or None}"):
                message += f"; write {self._usage(action)}"
            elif action.help and message.endswith(f"required: {action.metavar}"):
                message += f", {action.help % vars(action)}"
        if message.endswith(_COMMANDS):
            rows = (row for rows in self.headings.values() for row in self._rows(rows))
            self.exit(_BAD_INPUT, "\n".join([f"error: {error_text(message)}", *rows, ""]))
        self.exit(_BAD_INPUT, f"error: {error_text(message)} (see {self.prog} --help)\n")


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


def _suggestion(word: str, known: Iterable[str], before: str = "") -> str:
    near = [before + name for name in get_close_matches(word, known, 3, _ALIKE)]
    return f"; did you mean {' or '.join(near)}?" if near else ""


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
