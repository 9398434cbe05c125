"""Certificates of grasps, checked by the program that is proved in Coq; no Python checks here."""

from __future__ import annotations

import os

from arrangement.console.proved_program import ask_proved
from equilibrium.model.errors import CertificateError


def verify_proved(path: str | os.PathLike[str]) -> tuple[bool, str]:
    """Check a certificate with the proved checker.

    Args:
        path: of a file, or ``"-"`` (stdin).

    Returns:
        Whether it is valid, and its kind: "resisted" or "not resisted".

    Raises:
        CertificateError: the program is not built, or what it says of a file that it cannot read.
    """
    name = os.fspath(path)
    named = name if name == "-" or not name.startswith("-") else f"./{name}"
    answer, kind = ask_proved(named, error=CertificateError)
    if kind not in ("resisted", "not resisted"):
        raise CertificateError(f"it is a certificate of {kind}, not of a grasp")
    return answer == "accepted", kind
