"""The program that is proved in Coq, which `make formal` builds: where it is, and what it says."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from arrangement.console import progress
from arrangement.errors import InputError

#: Beside the Python that runs, where `make formal` puts it, or on the PATH.
PROGRAM = "proved-checker"


def program() -> str | None:
    """Return where the program is, if it is built."""
    folders = [str(Path(sys.executable).parent), os.environ.get("PATH", os.defpath)]
    return shutil.which(PROGRAM, path=os.pathsep.join(folders))


def ask_proved(
    *arguments: str,
    text: str | None = None,
    error: type[InputError] = InputError,
    seconds: float = 0,
) -> tuple[str, str]:
    """Run the program on one file; return the word that it answers and what comes after it.

    Args:
        arguments: an option, and a path, or ``"-"`` (stdin).
        text: what it reads as stdin; if omitted, our own.
        error: what is raised.
        seconds: that it may take, for the line with how many have passed.

    Raises:
        InputError: there is no such program, or it cannot read the file.
    """
    code, said = _run(arguments, text, error, seconds)
    answer, _, rest = said.strip().partition(": ")
    if (code, answer) not in ((0, "accepted"), (0, "counted"), (1, "refused")):
        raise error(f"the verified checker cannot read {arguments[-1]!r}: {rest or answer}")
    return answer, rest


def ask_proved_each(option: str, documents: Iterable[str]) -> list[str]:
    """Return what one run of the program counts in each of many documents, each of one line."""
    _, said = _run(("--lines", option, "-"), "\n".join(documents), InputError)
    return [line.removeprefix("counted: ") for line in said.splitlines()]


def _run(
    arguments: Iterable[str], text: str | None, error: type[InputError], seconds: float = 0
) -> tuple[int, str]:
    """Return exit code and output."""
    import subprocess  # slow to load, and few commands need it

    found = program()
    if found is None:
        raise error(
            f"the verified checker is not built: no program {PROGRAM}; run `make formal` in "
            "a checkout of the project, or omit --verified"
        )
    stdin = None if text is None else subprocess.PIPE
    with subprocess.Popen(
        [found, *arguments], stdin=stdin, stdout=subprocess.PIPE, text=True, errors="replace"
    ) as process:
        said = None
        try:
            for _ in progress.watched(range(round(seconds)), "seconds"):
                with suppress(subprocess.TimeoutExpired):
                    said, _ = process.communicate(text, timeout=1)
                    break
                text = None  # it has been sent
            if said is None:
                said, _ = process.communicate(text)
        except BaseException:
            process.kill()
            raise
    return process.returncode, said
