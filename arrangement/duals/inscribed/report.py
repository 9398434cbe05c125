"""Inscribability of the dual of an arrangement, with evidence."""

from __future__ import annotations

from dataclasses import dataclass

from arrangement.console.number_form import Shown
from arrangement.counts import region_count
from arrangement.duals.zonohedron import DualPolyhedron, dual_polyhedron
from arrangement.errors import ArrangementError
from arrangement.numbers.exact import RationalVector
from arrangement.planes.planes import Planes

from .certificates import Certificate, PolyhedralGraph
from .hull import sphere_points
from .search import decide


@dataclass(frozen=True, repr=False)
class Inscribability(Shown):
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

    def verify(self) -> None:
        """Check that the graph is the adjacency graph of all regions, and then the certificate.

        The signs of the points show that the regions are distinct; their number, compared with
        Zaslavsky's theorem, that none is missing. Two regions are adjacent exactly if their signs
        differ in one class of coincident planes.

        Raises:
            ArrangementError: what fails.
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
