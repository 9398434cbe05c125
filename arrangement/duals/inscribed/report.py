"""The answer with its evidence, which the program that is proved in Coq can check too.

The theorems of that program are about the linear conditions: these weights satisfy them, or no real
weights do. That they decide is Rivin's theorem, which is not proved there, nor that the graph is
planar and 3-connected.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.console.number_form import ReprMixin
from arrangement.counts import region_count
from arrangement.duals.zonohedron import DualPolyhedron, dual_polyhedron
from arrangement.errors import ArrangementError
from arrangement.numbers.exact import RationalVector, to_text
from arrangement.planes.planes import Planes
from arrangement.planes.proved import ask_proved

from .certificates import (
    Certificate,
    FarkasCertificate,
    IndependentSetCertificate,
    PolyhedralGraph,
    WeightCertificate,
)
from .hull import sphere_points
from .search import decide


@dataclass(frozen=True, repr=False)
class Inscribability(ReprMixin):
    """Whether some convex polyhedron inscribed in a sphere has the graph of the dual; with proof.

    Attributes:
        arrangement: the planes.
        points: an exact point inside each region; region v is vertex v of the graph.
        certificate: weights, a Farkas certificate, or an independent set (see `certificates`).
    """

    arrangement: Planes
    points: tuple[RationalVector, ...]
    certificate: Certificate

    @property
    def inscribable(self) -> bool:
        """The answer."""
        return self.certificate.inscribable

    def __bool__(self) -> bool:
        return self.inscribable

    def verify(self, *, proved: bool = False) -> None:
        """Check that the graph is the adjacency graph of all regions, and then the certificate.

        The signs of the points show that the regions are distinct; their number, compared with
        Zaslavsky's theorem, that none is missing. Two regions are adjacent exactly if their signs
        differ in one class of coincident planes.

        Args:
            proved: let the program that is proved in Coq check the linear conditions, too.

        Raises:
            ArrangementError: what fails.
            InputError: `proved`, and the program is not built.
        """
        regions = {self.arrangement.signs_at(point): v for v, point in enumerate(self.points)}
        if any(0 in signs for signs in regions) or len(regions) < len(self.points):
            raise ArrangementError("a point is on a plane, or two points are in one region")
        if len(regions) != region_count(self.arrangement):
            raise ArrangementError("there is not one point for each region")
        edges = []
        for signs, v in regions.items():
            for members in self.arrangement.distinct:
                across = tuple(-s if i in members else s for i, s in enumerate(signs))
                if across in regions and v < regions[across]:
                    edges.append((v, regions[across]))
        if PolyhedralGraph.of(len(regions), edges) != self.certificate.graph:
            raise ArrangementError("the certificate is about another graph")
        self.certificate.verify()
        if proved and not proved_conditions(self.certificate):
            raise ArrangementError("the verified program refuses the certificate")


def inscribability(arrangement: Planes | DualPolyhedron) -> Inscribability:
    """Decide whether the dual's graph is that of a convex polyhedron inscribed in a sphere.

    "No" refutes the claim that points of the unit sphere can be chosen in the regions so that
    the dual with these vertices is convex. "Yes" gives an inscribed polyhedron with this graph; it
    says nothing about its vertices being in the regions (see `representative_hull`).

    Args:
        arrangement: central in R^3, of rank 3; or its dual polyhedron.

    Raises:
        InputError: another dimension or rank, or an affine arrangement.

    Complexity: see `decide`. Measured on two cores: 0.2 s for
    7 generic planes, 6 s for 15, 27 s for 21.
    Source: see `certificates`; the claim is [HaasHeger2018], section IV.A.

    >>> from arrangement import Arrangement
    >>> answer = inscribability(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]))
    >>> answer.inscribable, answer.certificate.kind
    (False, 'parity')
    """
    dual = arrangement if isinstance(arrangement, DualPolyhedron) else dual_polyhedron(arrangement)
    graph = PolyhedralGraph.of(len(dual.signs), dual.edges.tolist())
    return Inscribability(dual.arrangement, sphere_points(dual), decide(graph))


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
