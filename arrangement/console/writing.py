"""Writing files whole or not at all."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from arrangement.errors import InputError
from arrangement.numbers.exact import shown


def write_text_atomically(path: str | os.PathLike[str], text: str) -> None:
    """Write a UTF-8 text file whole or not at all.

    The text goes to a temporary file in the same folder, which then takes the place of `path`; a
    reader never sees half a file, and an interrupted write leaves the old one. What is not an
    ordinary file (``/dev/stdout``) is written to directly.

    Raises:
        InputError: the place cannot be written.
    """
    try:
        content = text.encode("utf-8")
    except UnicodeEncodeError as error:
        raise InputError(f"cannot write {shown(str(path))}: {reason(error)}") from None
    write_bytes_atomically(path, content)


def write_bytes_atomically(path: str | os.PathLike[str], content: bytes) -> None:
    """Write a file whole or not at all, as `write_text_atomically` does."""
    try:
        target = Path(path).resolve()
        if target.is_symlink():  # a loop of links, which Python 3.13 resolves to one of them
            target.stat()
        if target.exists() and not target.is_file():
            target.write_bytes(content)
        else:
            _replace(target, content)
    except (OSError, ValueError, RuntimeError) as error:  # RuntimeError: such a loop before 3.13
        raise InputError(f"cannot write {shown(str(path))}: {reason(error)}") from None


def make_folder(path: str | os.PathLike[str]) -> None:
    """Make a folder, and those that it is in, where they are not there.

    Raises:
        InputError: it cannot be made.
    """
    try:
        Path(path).mkdir(parents=True, exist_ok=True)
    except (OSError, ValueError) as error:
        raise InputError(f"cannot write {shown(str(path))}: {reason(error)}") from None


def write_or_print(path: str | None, text: str) -> None:
    """Write a text to a file (`write_text_atomically`), or to stdout where there is none."""
    if path is None:
        print(text, end="")
    else:
        write_text_atomically(path, text)


def document_text(document: Mapping[str, Any]) -> str:
    """Return the file form of an arrangement (`to_dict`) as JSON, one plane a line."""
    rows = [f"    {json.dumps(row)}" for row in document["planes"]]
    rest = [f"  {json.dumps(k)}: {json.dumps(v)}" for k, v in document.items() if k != "planes"]
    planes = ",\n".join(rows)
    return "{\n" + ",\n".join([*rest, f'  "planes": [\n{planes}\n  ]']) + "\n}\n"


def reason(error: Exception) -> str:
    """Return what went wrong with a file, in the words of the system."""
    if isinstance(error, OSError) and error.strerror:
        return error.strerror
    return str(error)


def _replace(target: Path, content: bytes) -> None:
    """Write a new file beside `target` and let it take the place of `target`."""
    temporary = target.with_name(f".{os.urandom(8).hex()}.tmp")
    try:
        with temporary.open("xb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        if target.exists():
            temporary.chmod(target.stat().st_mode & 0o777)
        temporary.replace(target)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
