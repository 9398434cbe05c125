"""What to write in place of words that a program does not know.

Commands and options are listed, those nearest to the word first: by their names, then by the words
of their help. Each is a line to type, with the files, numbers and options that were typed.
"""

from __future__ import annotations

import argparse
import os
import re
from collections.abc import Callable, Iterator, Sequence
from difflib import SequenceMatcher
from functools import partial
from itertools import dropwhile, takewhile
from pathlib import Path
from shlex import join, quote
from typing import TYPE_CHECKING, Any, NamedTuple

from arrangement.console.plugins import import_object, registry_entries
from arrangement.numbers.exact import shown

from .values import count_argument, integer_argument

if TYPE_CHECKING:
    from .parser import Parser

#: Options of all commands, which are listed last.
_EVERYWHERE = {"help", "json", "limit", "traceback", "exact", "digits"}
#: Options that are listed with their help; of others the names follow.
_SHOWN = 12
#: Characters of a help text in a list.
_WIDTH = 130
#: How alike a misspelt word is to the one that is meant, as "jbos" and "jobs".
ALIKE = 0.75
#: How near something is whose name has the word, or all of its parts.
_NAMED = 2.4
_NUMBER = re.compile(r"[-+]?\.?[0-9]")
#: Of helps of options: what they have in common.
_VERBS = {"print", "read", "show", "write"}
#: What is a file, an equation or a statement, and no name.
_NO_NAME = re.compile(r"[./=<>\s]")


#: What stands for a file that `make` writes.
_MADE = "FILE.json"
_INTEGERS = (integer_argument, count_argument)
_LINES = ("--lines", "--planes", "--hyperplanes")


class Entry(NamedTuple):
    """What can be written, with its name, what it does, and how near it is to a word."""

    line: str
    name: str
    text: str
    score: float = 0.0


def _words(text: str | None) -> list[str]:
    """Return the words of a text; F_X is FX, too."""
    text = re.sub(r"(?<=\b[A-Z])_", "", text or "").lower()
    return [word for word in re.split(r"[\W_]+", text) if word]


def _in_name(word: str, known: str) -> float:
    """Return how near a word is to one of a name: the same, of the same stem, or misspelt."""
    if word == known:
        return 3.0
    shorter = min(len(word), len(known))
    shared = sum(1 for _ in takewhile(lambda i: word[i] == known[i], range(shorter)))
    is_stem = shared >= min(max(shorter, 3), max(4, 0.6 * shorter))
    return (
        2.7
        if is_stem
        else 2.4 * (shorter > 3 and SequenceMatcher(None, word, known).ratio() >= ALIKE)
    )


def _in_text(word: str, known: str) -> float:
    """Return 1 for the same word, less for one that has another ending, else 0."""
    short, long = sorted((word, known), key=len)
    is_ending = len(short) > 3 and long.startswith(short) and len(long) < len(short) + 4
    return 1.0 if word == known else 0.8 * is_ending


def nearness(word: str, name: str, text: str | None) -> float:
    """Return how near a word is to a name with its help: 10 for the name itself, 0 for nothing.

    Words of the help count the more, the earlier they stand in it.
    """
    parts, names = _words(word), _words(name)
    if parts == names:
        return 10.0
    if re.fullmatch("-[a-z]", word):
        return 1.5 * (len(names) == 1 and names[0].startswith(parts[0]))
    share = min(1.0, len(parts) / max(len(names), 1))
    near = [
        share * max((_in_name(part, known) for known in names), default=0.0)
        or max((_in_text(part, x) / (1 + i / 20) for i, x in enumerate(_words(text))), default=0.0)
        for part in parts
        if len(part) > 1 and not part.isdecimal()
    ]
    return sum(near) / max(len(near), 1) * (1.0 if all(near) else 0.3)


def _takes(action: argparse.Action, word: str) -> bool:
    """Return whether a word may be a value of an option."""
    try:
        action.type is None or action.type(word)  # type: ignore[operator]
    except (argparse.ArgumentTypeError, TypeError, ValueError):
        return False
    is_path = "." in word or not re.search(r"FILE|PATH|\.", str(action.metavar))
    return is_path and (action.choices is None or word in action.choices)


def _count(action: argparse.Action) -> tuple[int, float]:
    """Return how many values an option takes, at least and at most."""
    if isinstance(action.nargs, int):
        return action.nargs, action.nargs
    return {None: (1, 1), "?": (0, 1)}.get(action.nargs, (int(action.nargs == "+"), float("inf")))


def is_option(word: str) -> bool:
    """Return whether a word is an option, and not a negative number."""
    return word[:1] == "-" != word and not _NUMBER.match(word)


def usage(command: Parser, action: argparse.Action, values: Sequence[str] = ()) -> str:
    """Return an option with values, or with what stands for them."""
    least, most = _count(action)
    text = " ".join(action.metavar or ())
    if not isinstance(action.metavar, tuple):  # options that grow take more than it names
        text = command._get_formatter()._format_args(action, action.dest.upper())
    if least <= len(values) <= most and all(_takes(action, value) for value in values):
        text = join(values)
    return f"{action.option_strings[0]} {text}".strip()


class Typed:
    """Words that were typed behind a command: operands first, then options with their values.

    Attributes:
        operands: words that belong to no option.
        options: options of the command, with their values.
    """

    def __init__(self, command: Parser, words: Sequence[str]) -> None:
        self.operands: list[str] = []
        self.options: list[tuple[str, list[str]]] = []
        values, most = self.operands, float("inf")
        for word in words:
            flag, equals, value = word.partition("=")
            if equals and f"--{flag}" in command._option_string_actions:
                flag = f"--{flag}"
            if not is_option(flag):
                (values if len(values) < most else self.operands).append(word)
                continue
            action = command._option_string_actions.get(flag)
            values, most = [value] if equals else [], float("inf")
            if action is not None:
                most = float("inf") if action in command.variadic else _count(action)[1]
                self.options.append((flag, values))


def kinds(parser: Parser) -> dict[str, tuple[Parser, str]]:
    """Return the commands of a program, or the families of one, each with what it does."""
    parser.add_lazy_options()
    return {
        listed.dest: (action.choices[listed.dest], listed.help or "")
        for action in parser._actions
        if isinstance(action, argparse._SubParsersAction)
        for listed in action._choices_actions
    }


def _places(command: Parser) -> list[argparse.Action]:
    return [action for action in command._actions if not action.option_strings]


def line(command: Parser, words: Sequence[str], *more: str, foreign: bool = False) -> str:
    """Return a command with the words that it takes, and with what stands for those it needs.

    Operands fill the places of the command, then options that are missing; where a number is
    missing and nothing says which, it is 3.

    Args:
        more: options that are written besides.
        foreign: the words were typed behind another command, and need not be meant for its places.
    """
    command.add_lazy_options()
    typed, parts = Typed(command, words), [command.prog]
    operands = typed.operands
    for place in _places(command):
        many = place.nargs in ("*", "+")
        while operands and _fits(command, place, operands[0], foreign):
            parts.append(quote(operands.pop(0)))
            if not many:
                break
        else:
            if isinstance(place, argparse._SubParsersAction):
                ending = next(filter(None, (Path(word).suffix for word in words)), "")
                near = commands_of(command, ending, words)[:1] if ending else []
                return near[0].line if near and near[0].score else f"{command.prog} {place.metavar}"
            if place.nargs not in ("?", "*"):
                parts.append(str(place.metavar or place.dest))
    given = {flag for flag, _ in typed.options} | {text.split()[0] for text in more}
    parts += _missing(command, [] if foreign else operands, given)
    parts += [join([flag, *values]) for flag, values in typed.options]
    is_bare = not typed.options and _MADE not in words  # a file that is made may have a load
    parts += more or [command.usual] * (bool(command.usual) and is_bare)
    return " ".join(parts)


def _missing(command: Parser, operands: list[str], given: set[str]) -> Iterator[str]:
    """Yield options that are required, and others for operands that are numbers, with values."""
    for action in sorted(command._actions, key=lambda x: not x.required):
        if not action.option_strings or given & {*action.option_strings}:
            continue
        integer = "N" in str(action.metavar).split("|") or action.type in _INTEGERS
        is_text = not integer and _takes(action, "x")
        values = [x for x in operands if _takes(action, x) and not (is_text and x.isdecimal())]
        values = values[: max(_count(action)[0], 1)]
        if action.required or (integer and values and action.dest not in _EVERYWHERE):
            for value in values:
                operands.remove(value)
            yield usage(command, action, values or ["3"] * integer)


def _fits(command: Parser, place: argparse.Action, word: str, foreign: bool) -> bool:
    """Return whether a word is meant for a place of a command."""
    if isinstance(place, argparse._SubParsersAction):
        return word in place.choices
    is_known = place.dest in command.names and word in command.names[place.dest]()
    return not foreign or is_known or os.path.lexists(word) or _NO_NAME.search(word) is not None


def _best(command: Parser, word: str, words: Sequence[str], text: str) -> Entry:
    """Return a command, or its option that is nearer to a word."""
    command.add_lazy_options()
    best, flag = nearness(word, command.prog.rpartition(" ")[2], text), ""
    by_text = 0.0 if best else 0.75
    for action, score in _scores(command, word):
        least = 3.0 if best > 0.8 else _NAMED
        is_near = score >= least or (0 < by_text <= score <= 1 and word not in _VERBS)
        if score > best and is_near and action.dest not in _EVERYWHERE:
            best, flag, text = score, usage(command, action), _help(action)
    for dest, known in command.names.items():
        option = next((x for x in command._actions if x.dest == dest and x.option_strings), None)
        if option is not None and word in known() and best < 10:
            best, flag, text = 10, f"{option.option_strings[-1]} {word}", _help(option)
    return Entry(line(command, words, *[flag] * bool(flag), foreign=True), command.prog, text, best)


def _scores(command: Parser, word: str) -> Iterator[tuple[argparse.Action, float]]:
    """Yield the options of a command, each with how near it is to a word; usual ones come last."""
    is_program = bool(command.headings)
    actions = (x for x in command._actions if x.option_strings and (is_program or x.dest != "help"))
    for action in sorted(actions, key=lambda x: x.dest in _EVERYWHERE):
        other = [other for other, use in command.words.items() if use in action.option_strings]
        names = [*action.option_strings, *other]
        text = "" if action.dest in _EVERYWHERE else f"{action.help} {action.metavar}"
        yield action, max(nearness(word, name, text) for name in names)


def _help(action: argparse.Action) -> str:
    """Return the help of an option, cut at a word."""
    text = " ".join((action.help or "").replace("%%", "%").split())
    if action.help == argparse.SUPPRESS:
        return ""
    return text if len(text) <= _WIDTH else f"{text[:_WIDTH].rpartition(' ')[0]} ..."


def commands_of(program: Parser, word: str = "", words: Sequence[str] = ()) -> list[Entry]:
    """Return the commands of a program, or the families of one, the nearest to a word first."""
    entries = []
    for command, text in kinds(program).values():
        best = _best(command, word, words, text)
        for kind, about in kinds(command).values():
            near = nearness(word, kind.prog.rpartition(" ")[2], "")
            if near > max(1.3, best.score):
                best = Entry(line(kind, words, foreign=True), kind.prog, about, near)
        entries.append(best)
    return sorted(entries, key=lambda entry: -entry.score)


def _nearest(program: Parser, word: str, words: Sequence[str]) -> str:
    return commands_of(program, word, words)[0].line


def _siblings(program: str) -> Iterator[Parser]:
    """Yield the other programs that are installed."""
    for name, place in registry_entries("programs").items():
        if name != program.partition(" ")[0]:
            yield import_object(place)()


def unknown_command(program: Parser, word: str) -> tuple[str, list[Entry]]:
    """Return the answer to a word that is not a command, and the commands to list."""
    at = [*program.arguments].index(word)
    words = [*program.arguments[:at], *program.arguments[at + 1 :]]
    use, names = stray(program, word), list[str]()
    if not use and program.headings:
        main, _ = next(iter(kinds(program).values()))
        names = [x for place in _places(main)[:1] for x in main.names.get(place.dest, tuple)()]
        is_subject = re.search(r"[./=<>]", word) or word in names
        use = line(main, [word, *words]) if is_subject else ""
    if use:
        return f"{shown(word)} is not a command; write {use}", []
    for name in (x for x in [word, *words] if x not in names):
        if use := family(program, name, partial(_nearest, program, word if name != word else "")):
            return use, []
    start = f"there is no command {shown(word)}; expected one of these, the nearest first:"
    if _NO_NAME.search(word):
        words, word = [word, *words], Path(word).suffix or word
    entries = commands_of(program, word, words)
    for action, score in _scores(program, word) if program.headings else ():
        if score >= _NAMED:
            about = [name for name in words if name in kinds(program)]
            flag = " ".join([program.prog, *about, action.option_strings[-1]])
            entries.append(Entry(flag, action.dest, _help(action), score))
    for sibling in _siblings(program.prog) if program.headings else ():
        if word in (others := kinds(sibling)):
            command, text = others[word]
            entries.append(Entry(line(command, words, foreign=True), word, text, 0.5))
    return start, sorted(entries, key=lambda entry: -entry.score)


def _by_help(command: Parser, action: argparse.Action, name: str, values: Sequence[str]) -> str:
    """Return an option with a value that its help names: one of such as ..., or .tex (TikZ)."""
    text = action.help or ""
    word = re.escape(values[0] if values else name[2:])
    if not values and word and re.search(rf"such as [^;(]*\b{word}\b", text):
        return usage(command, action, [name[2:]])
    ending = re.search(rf"(?i)(\.\w+) \({word}\)|(\.{word})\b", text) if values and word else None
    if ending is None:
        return ""
    return re.sub(r"(?<=FILE)\.\w+$", ending[1] or ending[2], usage(command, action))


def unknown_option(command: Parser, word: str) -> tuple[str, list[Entry]]:
    """Return the answer to an option that a command does not have, and the options to list."""
    name, equals, value = word.partition("=")
    for known, (other, _) in kinds(command).items():
        other.add_lazy_options()
        if known in command.arguments and name in other._option_string_actions:
            words = [x for x in command.arguments if x != known]
            return f"{name} follows the command; write {line(other, words)}", []
    at = command.arguments.index(word)
    behind = [] if equals else [*takewhile(lambda x: not is_option(x), command.arguments[at + 1 :])]
    words = [*command.arguments[:at], *command.arguments[at + 1 + len(behind) :]]
    values = [value] if equals else behind
    about = (command.description or "").partition("\n\n")[0]
    entries = []
    for action, score in _scores(command, name):
        for value in values:
            ending = Path(value).suffix
            score += nearness(
                ending or value, "" if ending else action.option_strings[-1], action.help
            )
        text = usage(command, action, values if score else ())
        if use := _by_help(command, action, name, values):
            text, score = use, score + 3 * (not values)
        fits = bool(values) and text.endswith(join(values))
        entries.append(Entry(text, action.option_strings[-1], _help(action), score + 0.5 * fits))
    for place in _places(command):
        entries.append(
            Entry(
                str(place.metavar), str(place.metavar), _help(place), nearness(name, "", place.help)
            )
        )
    if values and nearness(name, "--output", "") > 1 and "-o" not in command._option_string_actions:
        text = f"{line(command, words)} > {quote(values[0])}"
        entries.append(Entry(text, "", "answers go to standard output", 10.0))
    if near := nearness(name, "", about):
        entries.append(Entry(line(command, words), "", about, near))
    lines = _families(command).get("generic")
    if lines and name in _LINES and [x.isdecimal() for x in values] == [True]:
        text = f"{values[0]} in general position; then {line(command, [_MADE, *words])}"
        entries.append(Entry(_made(lines, values), "", text, 10.0))
    entries.sort(key=lambda entry: -entry.score)
    if entries[0].score < 0.6:
        least = 2.7 if entries[0].score else 0.6
        entries = _elsewhere(command, name, [*words, *values], least) + entries
    start = f"{command.prog} has no option {shown(name)}"
    return f"{start}; expected one of these, the nearest first:", entries


def _elsewhere(command: Parser, name: str, words: Sequence[str], least: float) -> list[Entry]:
    """Return a command of the program that is near, or has an option that is, if there is one."""
    others = (other for other in command.commands.values() if other is not command)
    entries = (_best(other, name, words, other.description or "") for other in others)
    near = [entry for entry in entries if entry.score >= least]
    return sorted(near, key=lambda entry: -entry.score)[:1]


def missing(command: Parser, names: Sequence[str]) -> list[Entry]:
    """Return arguments and options of these names, as argparse writes them, to list."""
    entries = []
    for action in command._actions:
        name = "/".join(action.option_strings) or str(action.metavar)
        if name in names:
            text = usage(command, action) if action.option_strings else name
            entries.append(Entry(text, name, _help(action)))
    return entries


def rows(entries: Sequence[Entry]) -> Iterator[str]:
    """Yield lines of a list; of what does not fit into it only the names."""
    width = min(max((len(entry.line) for entry in entries[:_SHOWN]), default=0), 44) + 2
    for entry in entries[:_SHOWN]:
        yield f"  {entry.line:<{width}}  {entry.text}".rstrip()
    if rest := entries[_SHOWN:]:
        yield f"  others: {', '.join(entry.name.rpartition(' ')[2] for entry in rest)}"


def stray(parser: Parser, word: str) -> str:
    """Return what to write for a word for which there is no place, if that is known."""
    uses = (use for pattern, use in parser.strays.items() if re.fullmatch(pattern, word))
    return next(uses, "").replace("{}", quote(word))


def unexpected(command: Parser, word: str) -> tuple[str]:
    """Return the answer to a word for which a command has no place.

    Numbers may be meant for an option that takes so many, a word for the option of that name, and
    several files for a command each.
    """
    typed, places = Typed(command, command.arguments), _places(command)
    rest = [x for x in typed.operands if x not in typed.operands[: len(places)] or x == word]
    others = [x for x in command.arguments if x not in rest]
    numbers = [x for text in rest for x in re.split(r"[\s,]+", text) if _NUMBER.match(x)]
    takers = [x for x in command.variadic if x.nargs in (len(numbers), len(numbers) / 2)]
    takes = " ".join(str(place.metavar or place.dest) for place in places)
    use = f"{command.prog} takes {takes or 'options alone'}"
    if takers:
        use = f"write {line(command, others, join([takers[0].option_strings[0], *numbers]))}"
    elif known := stray(command, word):
        use = f"write {known}"
    elif action := command._option_string_actions.get(f"--{word}"):
        use = f"write {line(command, others, usage(command, action, rest[1:]))}"
    elif places and _fits(command, places[0], word, True):
        files = " ".join(map(quote, typed.operands))
        one = line(command, ["FILE", *(x for x in others if x not in typed.operands)])
        one = re.sub(r"( -o | --output )\S+?(?=\.\w+)", r"\1$f", one.replace(" FILE", " $f", 1))
        use += f"; write for f in {files}; do {one}; done"
    return (f"unexpected argument {shown(word)}; {use}",)


def _families(parser: Parser) -> dict[str, Parser]:
    make: Any = parser.commands.get("make")
    return {} if make is None else {name: known for name, (known, _) in kinds(make).items()}


def _made(known: Parser, operands: Sequence[str], given: Sequence[str] = ()) -> str:
    """Return what writes a member of a family: lines of the plane, where nothing says otherwise.

    Without the option ``--affine`` all planes pass through the origin.
    """
    known.add_lazy_options()
    more = []
    if "--affine" in known._option_string_actions and "--affine" not in given:
        more = [*["--d", "2"] * (len(operands) < 2 and "--d" not in given), "--affine"]
    return line(known, [*operands, *given, *more, "-o", _MADE])


def family(parser: Parser, word: str, then: Callable[[list[str]], str]) -> str:
    """Return the answer to a word that names a family, as ``shi(3)``, or ``shi 3`` in two.

    Args:
        then: the command that is meant, with the file and options that it may have.
    """
    match = re.fullmatch(r"([A-Za-z][\w-]*)(?:[:(](.*))?", word)
    known = _families(parser).get(match[1].lower().replace("_", "-")) if match else None
    if match is None or known is None:
        return ""
    after = parser.arguments[[*parser.arguments].index(word) + 1 :]
    numbers = re.findall(r"\b[A-Z]?[0-9]+\b", match[2] or "")  # and types, as B3
    own = {*known._option_string_actions} - {"-o", "--output", *parser._option_string_actions}
    typed = Typed(known, after)
    given = [x for flag, values in typed.options if flag in own for x in (flag, *values)]
    made = _made(known, [*numbers, *typed.operands], given)
    options = [*dropwhile(lambda x: not is_option(x), after)]
    for flag in given:
        options = [x for x in options if x.partition("=")[0] != flag]
    use = f"{shown(word)} is a family; write {made!r}, then {then([_MADE, *options])!r}"
    return use + " (without --affine, planes through the origin)" * ("--affine" in made)
