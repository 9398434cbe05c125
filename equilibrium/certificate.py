"""Certificates of verdicts as documents; `equilibrium.checker` says what they mean."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.exact import RationalVector, to_text

from .checker import SCHEMA_VERSION, Point, Reason, Report, check, digest
from .grasp import Grasp


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
    content = {"motion": _texts(motion), "forces": [_texts(pair) for pair in forces]}
    return _certificate("stable", grasp, wrench, content)


def unstable_certificate(
    grasp: Grasp,
    wrench: RationalVector,
    regions: Iterable[tuple[Sequence[int], Point]],
    branches: Iterable[tuple[str, Reason]],
) -> Certificate:
    """Return the certificate that no equilibrium exists.

    Args:
        regions: the signs of each region of the motion arrangement, and a point inside.
        branches: the states, one letter for each contact, and the reason, for each choice of
            states that `equilibrium.coverage` asks for.
    """
    symbol = {1: "+", -1: "-"}
    content = {
        "regions": [
            ["".join([symbol[s] for s in signs]), *map(_integer_entry, point)]
            for signs, point in regions
        ],
        "branches": {
            states: reason
            if isinstance(reason, str)
            else {"inequalities": _texts(reason[0]), "equalities": _texts(reason[1])}
            for states, reason in branches
        },
    }
    return _certificate("unstable", grasp, wrench, content)


def _integer_entry(value: int) -> int | str:
    """Return an integer, as text when JSON readers refuse its length."""
    return value if value.bit_length() <= 4096 else to_text(value)


def _certificate(
    kind: str, grasp: Grasp, wrench: RationalVector, content: dict[str, Any]
) -> Certificate:
    document = {
        "schema_version": SCHEMA_VERSION,
        "certificate": kind,
        "grasp": grasp.to_dict(),
        "wrench": _texts(wrench),
        **content,
    }
    document["digest"] = digest(document)
    return Certificate(json.dumps(document))


def _texts(vector: Iterable[Fraction]) -> list[str]:
    return [to_text(x) for x in vector]
