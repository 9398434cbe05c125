"""Certificates as documents; `equilibrium.certificate.regions_checker` says what they mean."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.exact import RationalVector, to_text
from equilibrium.model.grasp import Grasp

from .coverage import Rows
from .regions_checker import SCHEMA_VERSION, Reason, Report, canonical, check, digest_of


@dataclass(frozen=True)
class Certificate:
    """A proof of a verdict, as a document. `to_dict` gives a fresh copy."""

    text: str

    @property
    def kind(self) -> str:
        """Either "stable" or "unstable"."""
        return str(json.loads(self.text)["certificate"])

    def to_dict(self) -> dict[str, Any]:
        """Return the JSON document."""
        document: dict[str, Any] = json.loads(self.text)
        return document

    def verify(self) -> Report:
        """Check the certificate; see `check`."""
        return check(self.to_dict())


def stable_certificate(
    grasp: Grasp,
    wrench: RationalVector,
    motion: RationalVector,
    forces: Iterable[tuple[Fraction, Fraction]],
) -> Certificate:
    """Return the certificate of an equilibrium."""
    listed = [_texts(pair) for pair in forces]
    parts = {"motion": canonical(_texts(motion)), "forces": canonical(listed)}
    return _certificate("stable", grasp, wrench, parts)


def unstable_certificate(
    grasp: Grasp, wrench: RationalVector, regions: str, branches: Iterable[tuple[str, Reason]]
) -> Certificate:
    """Return the certificate that no equilibrium exists.

    Args:
        regions: as `regions_text` gives them.
        branches: the states, one letter for each contact, and the reason, for each choice of
            states that `equilibrium.certificate.coverage` asks for.
    """
    entries = (f'"{states}":{_reason_text(reason)}' for states, reason in sorted(branches))
    parts = {"regions": regions, "branches": "{" + ",".join(entries) + "}"}
    return _certificate("unstable", grasp, wrench, parts)


def regions_text(signs: Rows, points: Iterable[Sequence[int]]) -> str:
    """Return all regions of a motion arrangement as they stand in a certificate.

    Args:
        signs: one row over the planes for each region.
        points: integers X, Y, Z, W for the point (X, Y, Z) / W inside each.
    """
    letters = np.where(signs > 0, np.uint8(ord("+")), np.uint8(ord("-")))
    text, n = letters.tobytes().decode("ascii"), signs.shape[1]
    entries = (
        f'["{text[k * n : (k + 1) * n]}",{",".join(map(_integer_text, point))}]'
        for k, point in enumerate(points)
    )
    return "[" + ",".join(entries) + "]"


def _integer_text(value: int) -> str:
    """Return an integer as JSON: in quotes when readers would refuse its length."""
    return str(value) if value.bit_length() <= 4096 else f'"{to_text(value)}"'


def _reason_text(reason: Reason) -> str:
    if isinstance(reason, str):
        return f'"{reason}"'
    return canonical({"inequalities": _texts(reason[0]), "equalities": _texts(reason[1])})


def _certificate(
    kind: str, grasp: Grasp, wrench: RationalVector, parts: dict[str, str]
) -> Certificate:
    """Put a document together from its entries, each in canonical JSON."""
    entries = {
        "schema_version": canonical(SCHEMA_VERSION),
        "certificate": canonical(kind),
        "grasp": canonical(grasp.to_dict()),
        "wrench": canonical(_texts(wrench)),
        **parts,
    }
    entries["digest"] = canonical(digest_of(_joined(entries)))
    return Certificate(_joined(entries))


def _joined(entries: dict[str, str]) -> str:
    return "{" + ",".join(f'"{key}":{entries[key]}' for key in sorted(entries)) + "}"


def _texts(vector: Iterable[Fraction]) -> list[str]:
    return [to_text(x) for x in vector]
