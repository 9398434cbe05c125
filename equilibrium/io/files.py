"""Reading grasps and certificates from files, names or mappings; see `arrangement.io.files`."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.io.files import Source, read_document
from arrangement.io.writing import write_text_atomically
from equilibrium.certificate.regions_checker import Report, check
from equilibrium.certificate.regions_document import Certificate
from equilibrium.model.grasp import Grasp

#: Certificates list every face of the motion arrangement, so they may be large.
MAX_CERTIFICATE_BYTES = 512 * 2**20


def read_grasp(source: Source) -> Grasp:
    """Read a grasp from a path, ``"-"`` (stdin), a built-in name or a mapping.

    Raises:
        InputError: for anything that is not exactly a valid document.

    >>> len(read_grasp("paper-three-contacts"))
    3
    """
    return Grasp.from_dict(read_document(source, ("contacts",)))


def tangential_arrangement(document: Mapping[str, Any]) -> Arrangement:
    """Return the tangential planes of a grasp document: what a grasp means as an arrangement."""
    return Grasp.from_dict(document).tangential_arrangement()


def write_certificate(path: str | os.PathLike[str], certificate: Certificate) -> None:
    """Write a certificate as a JSON file, whole or not at all."""
    write_text_atomically(path, certificate.text + "\n")


def read_certificate(source: Source) -> dict[str, Any]:
    """Return the document of a certificate, strictly read but not yet checked."""
    return read_document(source, ("certificate",), max_bytes=MAX_CERTIFICATE_BYTES)


def verify(source: Source, *, rationals_only: bool = False) -> Report:
    """Check a certificate from a path, ``"-"`` (stdin) or a mapping; no solver is involved.

    Args:
        rationals_only: do every step in rationals; see `checker.check`.

    Raises:
        InputError: the document has no readable form.
    """
    return check(read_certificate(source), rationals_only=rationals_only)
