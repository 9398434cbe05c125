"""Files: strict reading of JSON documents, built-in documents by name, and safe writing.

A document is a JSON object with ``"schema_version": 1``. Numbers in it are integers or strings
such as ``"7/3"`` and ``"-0.25"``; a float is refused, because its decimal text and its binary
value differ. Nothing from a file is ever evaluated. Every refusal is an `InputError` that says
where, what, and the rule.

Built-in documents are those that the packages add (`arrangement.console.plugins`).
"""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, BinaryIO, TypeAlias

from arrangement.console.plugins import import_object, registry_entries
from arrangement.console.writing import reason
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import integer, shown

from .content import content_kind

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable

#: What a document can be read from: a path, ``"-"`` (stdin), a built-in name, or a mapping.
Source: TypeAlias = "str | os.PathLike[str] | Mapping[str, Any]"

SCHEMA_VERSION = 1

_NAME = re.compile(r"[a-z0-9]+(?:-[a-z0-9]+)*")
#: Bytes that are read at once.
_PORTION = 1 << 20


def read_document(
    source: Source,
    kinds: Collection[str],
    *,
    kind: str = "bytes of a file",
    floats: Callable[[str], Any] | None = None,
    versions: Collection[int] = (SCHEMA_VERSION,),
) -> dict[str, Any]:
    """Read a JSON object that has a known ``schema_version`` and exactly one of the keys `kinds`.

    The caller checks the remaining keys with `check_keys`. A name such as ``paper-three-contacts``
    means the built-in document even when a file of that name exists; write ``./name`` for the file.

    Args:
        floats: reads a number such as 0.1 or 1e-3, for data whose conversion is the purpose; None
            refuses it.

    Raises:
        InputError: a file that cannot be read, is too long, is not UTF-8, is not strict JSON
             (duplicate keys, NaN, floats, deep nesting), or is not such a document.
    """
    if isinstance(source, Mapping):
        document: Any = dict(source)
        name = "the document"
    else:
        text, name = read_text(source, kind)
        document = parse_json(text, name, floats=floats)
    return check_document(document, kinds, name, versions)


def check_document(
    document: Any, kinds: Collection[str], name: str, versions: Collection[int] = (SCHEMA_VERSION,)
) -> dict[str, Any]:
    """Check that a JSON value is a document of exactly one of the kinds; return it."""
    if not isinstance(document, dict):
        raise InputError(f"{name} holds {kind_of(document)}; a document is a JSON object")
    _check_kind(document, kinds, name, versions)
    return document


def check_keys(
    mapping: Any,
    required: Iterable[str],
    optional: Iterable[str],
    where: str,
    remedies: Mapping[str, str] = MappingProxyType({}),
) -> Mapping[str, Any]:
    """Check that `mapping` is a mapping with all required keys and no unknown ones; return it.

    Args:
        remedies: of some unknown keys, what to write.
    """
    if not isinstance(mapping, Mapping):
        raise InputError(f"{where} is {kind_of(mapping)}; expected a JSON object")
    required = list(required)
    known = [*required, *optional]
    unknown = [shown(key) for key in mapping if key not in known]
    missing = [f'"{key}"' for key in required if key not in mapping]
    if unknown:
        first_keys = f"key{'s' * (len(unknown) > 1)} {', '.join(unknown[:4])}"
        lacks = f", and lacks {', '.join(missing)}" if missing else ""
        use = ". ".join(["", *dict.fromkeys(remedies[key] for key in mapping if key in remedies)])
        raise InputError(
            f"{where} has the unknown {first_keys}{lacks}; known keys are {', '.join(known)}{use}"
        )
    if missing:
        due = "they are" if missing[1:] else "it is"
        keys = f"key{'s' * (len(missing) > 1)} {', '.join(missing)}"
        raise InputError(f"{where} has no {keys}; {due} required")
    if not isinstance(mapping.get("description", ""), str):
        raise InputError(f"the description of {where} is not a text; write a string")
    return mapping


def check_all(*checks: Callable[[], object]) -> None:
    """Run checks, and raise one error of all that they refuse."""
    refused = []
    for check in checks:
        try:
            check()
        except InputError as error:
            refused.append(error)
    if refused:
        more = [f"{len(refused) - 5} more such"] * (len(refused) > 5)
        raise type(refused[0])("; ".join([*map(str, refused[:5]), *more]))


def check_list(value: Any, where: str, length: int | None = None) -> list[Any]:
    """Check that `value` is a list (of the given length); return it as a list."""
    if not isinstance(value, (list, tuple)):
        raise InputError(f"{where} is {kind_of(value)}; expected a list")
    if length is not None and len(value) != length:
        raise InputError(f"{where} has {len(value)} entries; expected {length}")
    return list(value)


def descriptions(kind: str) -> dict[str, str]:
    """Return the descriptions of the built-in documents of a kind by name."""
    documents = {name: json.loads(path.read_bytes()) for name, path in instances().items()}
    return {name: d.get("description", "") for name, d in documents.items() if kind in d}


def instances() -> dict[str, Traversable]:
    """Return every built-in document by name, in alphabetical order."""
    paths: dict[str, Traversable] = {}
    for place in registry_entries("instances").values():
        paths.update(import_object(place)())
    return dict(sorted(paths.items()))


def _built_in(name: str) -> Traversable | None:
    """Return the built-in document of a name, from the first package that has it."""
    tables = (import_object(place)() for place in registry_entries("instances").values())
    return next((table[name] for table in tables if name in table), None)


def _path_text(source: Any) -> str:
    if not isinstance(source, (str, os.PathLike)):
        raise InputError(
            f"the source is {kind_of(source)}; give a path, a built-in name or a mapping. "
            "Arrangement(normals, offsets) and equilibrium.inputs.from_float_data(points, normals, "
            "friction) take arrays"
        )
    return os.fsdecode(source)


def read_text(source: str | os.PathLike[str], kind: str = "bytes of a file") -> tuple[str, str]:
    """Return the UTF-8 text of stdin, a built-in document or a file, and its name for messages.

    Raises:
        InputError: it cannot be read, is longer than `budget.MAX_SIZES` says, or is not UTF-8.
    """
    name = "standard input" if (path := _path_text(source)) == "-" else shown(path)
    content = read_bytes(source, name, kind)
    try:
        return content.decode("utf-8-sig"), name
    except UnicodeDecodeError as error:
        where = f"not UTF-8 text (byte {error.start} is wrong)"
        known = content_kind(content)
        raise InputError(f"{name} is {where if 'UTF-8' in known else known}") from None


def read_bytes(source: str | os.PathLike[str], name: str, kind: str) -> bytes:
    """Return the content of stdin, a built-in document or a file, with a limit on its length."""
    try:
        if source == "-":
            if sys.stdin is None:
                raise InputError("standard input is closed; give a path or a built-in name")
            return _read_limited(sys.stdin.buffer, name, kind)
        if isinstance(source, str) and _NAME.fullmatch(source):
            built_in = _built_in(source)
            if built_in is not None:
                return built_in.read_bytes()
        with Path(source).open("rb") as stream:
            return _read_limited(stream, name, kind)
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        near = get_close_matches(str(source), instances(), 3)
        short = str(source).lower()
        if not near and len(short) > 1:  # "A3" means braid-a3
            near = [name for name in instances() if short in name.split("-")][:3]
        meant = f"; did you mean the built-in {' or '.join(near)}?" if near else ""
        if not re.search(r"[/.]", short):
            known = "prints names, `arrangement list --families` what `arrangement make` writes"
            meant += f" `list` {known}" if near else f"; `list` {known}"
        raise InputError(f"cannot read {name}: {reason(error)}{meant}") from None


def _read_limited(stream: BinaryIO, name: str, kind: str) -> bytes:
    """Return all bytes; `read(n)` would ask for n bytes of memory, however short the stream is."""
    content, most = bytearray(), budget.max_size(kind)
    while len(content) <= most and (part := stream.read(_PORTION)):
        content += part
    budget.check_size(len(content), kind, name)
    return bytes(content)


def parse_json(
    text: str, name: str, *, floats: Callable[[str], Any] | None = None, of_floats: str = ""
) -> Any:
    """Parse strict JSON: no duplicate keys, no floats unless wanted, no NaN, flat.

    Args:
        floats: reads one; None refuses all.
        of_floats: what converts them, for the refusal of one.
    """
    refused: list[str] = []
    try:
        value = json.loads(
            text,
            object_pairs_hook=_without_duplicates,
            parse_int=_parse_integer,
            parse_float=floats or refused.append,
            parse_constant=_refuse_constant,
        )
        _refuse_floats(refused, of_floats)
        return value
    except InputError as error:
        raise InputError(f"{name}: {error}") from None
    except json.JSONDecodeError as error:
        place = f"{error.msg} (line {error.lineno}, column {error.colno})"
        known = content_kind(text)
        is_other = text.lstrip()[:1] not in {*'{["'} or not known.startswith("a text")
        why = f", but {known}" if is_other else f": {place}"
        raise InputError(f"{name} is not valid JSON{why}") from None
    except RecursionError:
        raise InputError(f"{name} is nested too deeply; no document needs that") from None


def _without_duplicates(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    mapping: dict[str, Any] = {}
    for key, value in pairs:
        if key in mapping:
            raise InputError(f"the key {shown(key)} appears twice in one object; keep one")
        mapping[key] = value
    return mapping


def _parse_integer(text: str) -> int:
    if len(text) > budget.MAX_SIZES["characters of a number"]:
        budget.check_size(len(text), "characters of a number")
    return integer(text)


def _refuse_floats(texts: Sequence[str], of_floats: str) -> None:
    if texts:
        more = f" and {len(texts) - 3} more" if len(texts) > 3 else ""
        what = "number {} is a float" if len(texts) == 1 else "numbers {} are floats"
        raise InputError(
            f"the {what.format(', '.join(map(shown, texts[:3])) + more)}; write an integer or a "
            f'string such as "1/4", "-0.25"{of_floats and ". "}{of_floats}'
        )


def _refuse_constant(text: str) -> Any:
    raise InputError(f'{text} is not an exact number; write an integer or a string such as "1/4"')


def _check_kind(
    document: dict[str, Any], kinds: Collection[str], name: str, versions: Collection[int]
) -> None:
    """Check the version of the schema, and that the document is of exactly one of the kinds."""
    present = [kind for kind in kinds if kind in document]
    required = f"exactly one of the keys {', '.join(sorted(kinds))}"
    if len(kinds) == 1:
        required = f'the key "{min(kinds)}"'
    if "schema_version" not in document:
        also = f", and {required}" if len(present) != 1 else ""
        raise InputError(
            f'{name} has no key "schema_version"; add "schema_version": {max(versions)}{also}'
        )
    version = document["schema_version"]
    if type(version) is not int or version not in versions:
        raise InputError(
            f"{name} has schema_version {shown(version)}; this version reads {max(versions)}"
        )
    if len(present) != 1:
        text = " and ".join(present) if present else "none"
        raise InputError(f"{name} must have {required}; it has {text}")


def kind_of(value: Any) -> str:
    """Name what a JSON value is, with its content where that is short."""
    if isinstance(value, Mapping):
        return "an object"
    if isinstance(value, (list, tuple)):
        return "a list"
    return "null" if value is None else shown(value)
