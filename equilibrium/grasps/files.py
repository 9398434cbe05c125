"""Reading grasps and certificates from files, names or mappings; see
`arrangement.library.files.json_files`.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.console.proved_program import ask_proved
from arrangement.console.writing import write_text_atomically
from arrangement.library.files.json_files import Source, read_document
from equilibrium.certificate.checker import Question, Report, check
from equilibrium.certificate.document import Certificate
from equilibrium.certificate.reading import SCHEMA_VERSION
from equilibrium.model.errors import CertificateError
from equilibrium.model.grasp import Grasp

if TYPE_CHECKING:
    from arrangement import Arrangement


#: What takes floats, said where one is refused.
OF_FLOATS = (
    "Measured contacts are converted by `equilibrium make floats`, from a table (.csv) or from "
    "lists of points and normals"
)


def read_grasp(source: Source) -> Grasp:
    """Read a grasp from a path, ``"-"`` (stdin), a built-in name or a mapping.

    Raises:
        InputError: for anything that is not exactly a valid document.

    >>> len(read_grasp("paper-three-contacts"))
    3
    """
    return Grasp.from_dict(read_document(source, ("contacts",), of_floats=OF_FLOATS))


def tangential_arrangement(document: Mapping[str, Any]) -> Arrangement:
    """Return the tangential planes of a grasp document: what a grasp means as an arrangement."""
    return Grasp.from_dict(document).tangential_arrangement()


def write_certificate(path: str | os.PathLike[str], certificate: Certificate) -> None:
    """Write a certificate as a JSON file, whole or not at all."""
    write_text_atomically(path, certificate.text + "\n")


def read_certificate(source: Source) -> dict[str, Any]:
    """Return the document of a certificate, strictly read but not yet checked."""
    # Of old versions the checker says what they are.
    versions = range(1, SCHEMA_VERSION + 1)
    return read_document(source, ("certificate",), kind="bytes of a certificate", versions=versions)


def verify(
    source: Source,
    question: Question | None = None,
    pyramid: int | None = None,
    max_displacement: Fraction | None = None,
) -> Report:
    """Check a certificate from a path, ``"-"`` (stdin) or a mapping; no solver is involved.

    Args:
        question, pyramid, within: what it has to be about; see
            `equilibrium.certificate.checker.check`.

    Raises:
        InputError: the document has no readable form.
    """
    return check(read_certificate(source), question, pyramid, max_displacement)


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
