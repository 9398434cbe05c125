"""The program that is proved in Coq, which `make formal` builds: where it is, and what it says."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

from arrangement.errors import InputError

#: Beside the Python that runs, where `make formal` puts it, or on the PATH.
PROGRAM = "proved-checker"


def program() -> str | None:
    """Return where the program is, if it is built."""
    folders = [str(Path(sys.executable).parent), os.environ.get("PATH", os.defpath)]
    return shutil.which(PROGRAM, path=os.pathsep.join(folders))


def ask_proved(
    *arguments: str, text: str | None = None, error: type[InputError] = InputError
) -> tuple[str, str]:
    """Run the program on one file; return the word that it answers and what comes after it.

    Args:
        arguments: an option, and a path, or ``"-"`` (stdin).
        text: what it reads as stdin; if omitted, our own.
        error: what is raised.

    Raises:
        InputError: there is no such program, or it cannot read the file.
    """
    found = program()
    if found is None:
        raise error(
            f"the proved checker is not built: there is no program {PROGRAM}; run `make formal` in "
            "a checkout of the project, or omit --proved"
        )
    done = subprocess.run(
        [found, *arguments], input=text, stdout=subprocess.PIPE, text=True, errors="replace"
    )
    answer, _, rest = done.stdout.strip().partition(": ")
    if (done.returncode, answer) not in ((0, "accepted"), (0, "counted"), (1, "refused")):
        raise error(f"the proved checker cannot read {arguments[-1]!r}: {rest or answer}")
    return answer, rest
