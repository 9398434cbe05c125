"""Refutations of inscribability, checked by the program that is proved in Coq.

Its theorem is about the linear conditions: no real weights satisfy them. That they are necessary is
Rivin's theorem, which is not proved there, nor that the graph is planar and 3-connected.
"""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

from arrangement.console.proved_program import ask_proved
from arrangement.errors import InputError
from arrangement.numbers.exact import to_text

from .certificates import Certificate, FarkasCertificate, IndependentSetCertificate


def proved_without_weights(certificate: Certificate) -> bool:
    """Return whether the program accepts that no weights satisfy Rivin's conditions.

    Raises:
        InputError: the program is not built, or the certificate has weights, which it does not
            check.
    """
    text = json.dumps(multipliers_document(certificate))
    return ask_proved("-", text=text) == ("accepted", "no weights")


def multipliers_document(certificate: Certificate) -> dict[str, Any]:
    """Return a refutation as the program reads it."""
    if isinstance(certificate, IndependentSetCertificate):
        certificate = _of_vertices(certificate)
    if not isinstance(certificate, FarkasCertificate):
        raise InputError(
            "the proved program checks that there are none, and these are weights; omit proved"
        )
    graph, nothing = certificate.graph, Fraction(0)
    bounds = certificate.lower_multipliers, certificate.upper_multipliers
    return {
        "schema_version": 1,
        "certificate": "no weights",
        "vertices": list(map(to_text, certificate.vertex_multipliers)),
        "edges": [[*e, *(to_text(given.get(e, nothing)) for given in bounds)] for e in graph.edges],
        "cutsets": [[sorted(side), to_text(factor)] for side, factor in certificate.cuts],
    }


def _of_vertices(certificate: IndependentSetCertificate) -> FarkasCertificate:
    """Return multipliers 1/2 in the set and -1/2 outside, and 1 for each edge outside."""
    graph, chosen = certificate.graph, certificate.vertices
    half = Fraction(1, 2)
    outside = {edge: Fraction(1) for edge in graph.edges if chosen.isdisjoint(edge)}
    factors = tuple(half if v in chosen else -half for v in range(graph.vertex_count))
    return FarkasCertificate(graph, factors, outside, {}, ())
