"""Changes of a JSON document, whatever its schema: of leaves, of lists, of mappings."""

import copy
import re
from collections import defaultdict
from collections.abc import Callable, Iterator
from fractions import Fraction
from random import Random
from typing import Any

Path = tuple[str | int, ...]
_NUMBER = re.compile(r"-?\d+(/\d+)?\Z")
#: A mapping with more keys is a table: its keys are data, not names of fields.
LARGEST_RECORD = 8
STATES = ("detached", "slip+", "slip-", "stick")


def mutants(
    document: dict[str, Any], count: int, seed: int, first: int = 0
) -> Iterator[tuple[Path, str, Any]]:
    """Yield changed copies: where, which change, and the copy; kinds of fields in turn from one on.

    Places that differ only in list indices, or in the keys of a large table, are of one kind. No
    copy equals the document, and each is a mapping.
    """
    source = Random(f"mutants {seed}")
    kinds: defaultdict[tuple, list[Path]] = defaultdict(list)
    for kind, path, value in places(document):
        kinds[(*kind, _sort(value))].append(path)
    order = sorted(kinds)
    found = 0
    while found < count:
        kind = order[(first + found) % len(order)]
        path = source.choice(kinds[kind])
        copied = copy.deepcopy(document)
        inside = {"root": copied}
        parent: Any = inside
        for key in ("root", *path[:-1]) if path else ():
            parent = parent[key]
        key = path[-1] if path else "root"
        other = source.choice(kinds[kind])
        name, change = source.choice([("of another place", None), *_CHANGES[_sort(parent[key])]])
        parent[key] = _at(document, other) if change is None else change(parent[key], source)
        if inside["root"] != document and isinstance(inside["root"], dict):
            found += 1
            yield path, name, inside["root"]


def places(value: Any, kind: tuple = (), path: Path = ()) -> Iterator[tuple[tuple, Path, Any]]:
    """Yield every place of a document with its kind and value, the document itself first."""
    yield kind, path, value
    if isinstance(value, dict):
        for key, entry in value.items():
            named = (*kind, key) if len(value) <= LARGEST_RECORD else kind
            yield from places(entry, named, (*path, key))
    elif isinstance(value, list):
        for i, entry in enumerate(value):
            yield from places(entry, kind, (*path, i))


def _at(value: Any, path: Path) -> Any:
    for key in path:
        value = value[key]
    return copy.deepcopy(value)


def _sort(value: Any) -> str:
    if isinstance(value, dict):
        return "mapping"
    if isinstance(value, list):
        return "list"
    if isinstance(value, str):
        return "number" if _NUMBER.match(value) else "text"
    return "whole" if type(value) is int else "other"


def _digit(text: str, source: Random) -> str:
    at = source.choice([i for i, c in enumerate(text) if c.isdigit()])
    return f"{text[:at]}{source.choice('0123456789')}{text[at + 1 :]}"


def _sign(text: str, _: Random) -> str:
    return text[1:] if text.startswith("-") else f"-{text}"


def _letter(text: str, source: Random) -> str:
    if not text:
        return "+"
    at = source.randrange(len(text))
    known = sorted(set(text) | set("+-0d"))
    return f"{text[:at]}{source.choice(known)}{text[at + 1 :]}"


def _other_state(text: str, source: Random) -> str:
    return source.choice([s for s in (*STATES, "stable", "unstable") if s != text])


def _without(entries: list[Any], source: Random) -> list[Any]:
    at = source.randrange(len(entries)) if entries else 0
    return entries[:at] + entries[at + 1 :]


def _twice(entries: list[Any], source: Random) -> list[Any]:
    at = source.randrange(len(entries)) if entries else 0
    return entries[: at + 1] + copy.deepcopy(entries[at:])


def _key_changed(mapping: dict[str, Any], source: Random) -> dict[str, Any]:
    old = source.choice(sorted(mapping))
    return {_letter(key, source) if key == old else key: value for key, value in mapping.items()}


def _swapped(entries: list[Any], source: Random) -> list[Any]:
    moved = list(entries)
    if moved:
        i, j = (source.randrange(len(moved)) for _ in range(2))
        moved[i], moved[j] = moved[j], moved[i]
    return moved


def _overwritten(entries: list[Any], source: Random) -> list[Any]:
    moved = list(entries)
    if moved:
        i, j = (source.randrange(len(moved)) for _ in range(2))
        moved[i] = copy.deepcopy(moved[j])
    return moved


def _key_lost(mapping: dict[str, Any], source: Random) -> dict[str, Any]:
    lost = source.choice(sorted(mapping))
    return {key: value for key, value in mapping.items() if key != lost}


def _key_renamed(mapping: dict[str, Any], source: Random) -> dict[str, Any]:
    old = source.choice(sorted(mapping))
    return {f"{key}s" if key == old else key: value for key, value in mapping.items()}


def _values_exchanged(mapping: dict[str, Any], source: Random) -> dict[str, Any]:
    i, j = source.choice(sorted(mapping)), source.choice(sorted(mapping))
    return {**mapping, i: mapping[j], j: mapping[i]}


Change = Callable[[Any, Random], Any]
_CHANGES: dict[str, list[tuple[str, Change]]] = {
    "number": [
        ("digit", _digit),
        ("sign", _sign),
        ("plus 1/7", lambda text, _: str(Fraction(text) + Fraction(1, 7))),
        ("times 2", lambda text, _: str(2 * Fraction(text))),
        ("zero", lambda text, _: "0"),
        ("tiny", lambda text, _: str(Fraction(text) + Fraction(1, 10**30))),
        (
            "unreduced",
            lambda text, _: f"{Fraction(text).numerator * 3}/{3 * Fraction(text).denominator}",
        ),
        ("float", lambda text, _: float(Fraction(text))),
    ],
    "text": [("letter", _letter), ("state", _other_state), ("empty", lambda text, _: "")],
    "whole": [
        ("plus 1", lambda value, _: value + 1),
        ("minus 1", lambda value, _: value - 1),
        ("sign", lambda value, _: -value),
        ("text", lambda value, _: str(value)),
        ("truth", lambda value, _: bool(value)),
    ],
    "other": [("not", lambda value, _: not value), ("zero", lambda value, _: 0)],
    "list": [
        ("removed", _without),
        ("repeated", _twice),
        ("swapped", _swapped),
        ("overwritten", _overwritten),
        ("reversed", lambda entries, _: entries[::-1]),
        ("emptied", lambda entries, _: []),
        ("null", lambda entries, _: None),
    ],
    "mapping": [
        ("key lost", _key_lost),
        ("key renamed", _key_renamed),
        ("key changed", _key_changed),
        ("values exchanged", _values_exchanged),
        ("listed", lambda mapping, _: list(mapping.values())),
    ],
}
