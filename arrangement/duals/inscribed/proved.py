"""Certificates of inscribability, checked by the program that is proved in Coq.

Its theorems are about the linear conditions: these weights satisfy them, or no real weights do.
That they decide is Rivin's theorem, which is not proved there, nor that the graph is planar and
3-connected.
"""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

from arrangement.console.proved_program import ask_proved
from arrangement.numbers.exact import to_text

from .certificates import (
    Certificate,
    FarkasCertificate,
    IndependentSetCertificate,
    WeightCertificate,
)


def proved_conditions(certificate: Certificate) -> bool:
    """Return whether the program accepts that weights satisfy Rivin's conditions, or that none do.

    Raises:
        InputError: the program is not built.
    """
    document = conditions_document(certificate)
    return ask_proved("-", text=json.dumps(document)) == ("accepted", document["certificate"])


def conditions_document(certificate: Certificate) -> dict[str, Any]:
    """Return a certificate as the program reads it; an independent set as multipliers."""
    if isinstance(certificate, IndependentSetCertificate):
        certificate = _of_vertices(certificate)
    graph, nothing = certificate.graph, Fraction(0)
    if isinstance(certificate, WeightCertificate):
        weights = map(to_text, certificate.weights)
        return {
            "schema_version": 1,
            "certificate": "weights",
            "vertices": graph.vertex_count,
            "edges": [[*e, weight] for e, weight in zip(graph.edges, weights, strict=True)],
        }
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
