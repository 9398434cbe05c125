"""The checker that is proved in Coq: a program that `make formal` builds; no Python checks here."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

from arrangement.numbers.exact import shown
from equilibrium.model.errors import CertificateError

#: Beside the Python that runs, where `make formal` puts it, or on the PATH.
PROGRAM = "equilibrium-proved-checker"


def verify_proved(path: str | os.PathLike[str]) -> tuple[bool, str]:
    """Check a certificate with the proved checker.

    Args:
        path: of a file, or ``"-"`` (stdin).

    Returns:
        Whether it is valid, and its kind: "resisted" or "not resisted".

    Raises:
        CertificateError: the program is not built, or what it says of a file that it cannot read.
    """
    folders = [str(Path(sys.executable).parent), os.environ.get("PATH", os.defpath)]
    program = shutil.which(PROGRAM, path=os.pathsep.join(folders))
    if program is None:
        raise CertificateError(
            f"the proved checker is not built: there is no program {PROGRAM}; run `make formal` in "
            "a checkout of the project, or omit --proved"
        )
    name = os.fspath(path)
    named = name if name == "-" or not name.startswith("-") else f"./{name}"
    done = subprocess.run([program, named], stdout=subprocess.PIPE, text=True, errors="replace")
    answer, _, rest = done.stdout.strip().partition(": ")
    if (done.returncode, answer) not in ((0, "accepted"), (1, "refused")):
        raise CertificateError(f"the proved checker cannot read {shown(name)}: {rest or answer}")
    return answer == "accepted", rest
