"""Inscribability of the dual of an arrangement, with evidence, and a table of small cases."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from arrangement.counts import region_count
from arrangement.errors import ArrangementError
from arrangement.exact import RationalVector
from arrangement.planes import Planes
from arrangement.polyhedra.dual import DualPolyhedron, dual_polyhedron

from .certificates import Certificate, PolyhedralGraph
from .points import sphere_points
from .search import decide


@dataclass(frozen=True)
class Inscribability:
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


@dataclass(frozen=True, slots=True)
class InscribabilityRow:
    """One line of the table: counts of the dual, and the answer with the kind of its proof."""

    name: str
    planes: int
    vertices: int
    edges: int
    simple: bool
    simplicial: bool
    inscribable: bool
    proof: str


def inscribability_table(arrangements: Mapping[str, Planes]) -> tuple[InscribabilityRow, ...]:
    """Return a row for each named arrangement; every certificate has been verified.

    An arrangement is simplicial if every region has three facets: ``2 E = 3 V``.
    """
    rows = []
    for name, arrangement in arrangements.items():
        dual = dual_polyhedron(arrangement)
        answer = inscribability(dual)
        answer.verify()
        v, e, _ = dual.f_vector
        rows.append(
            InscribabilityRow(
                name,
                len(arrangement.distinct),
                v,
                e,
                e == 2 * v - 4,
                2 * e == 3 * v,
                answer.inscribable,
                answer.certificate.kind,
            )
        )
    return tuple(rows)


def small_arrangements(planes: Iterable[int] = range(3, 9)) -> dict[str, Planes]:
    """Return generic and simplicial arrangements by name, by number of planes.

    Generic: the planes of the moment curve. (From 6 planes on there are further simple types.)
    Simplicial: near-pencils and the rational entries of Gruenbaum's catalogue.
    """
    from arrangement.library.families import generic, near_pencil, simplicial, simplicial_entries

    found: dict[str, Planes] = {}
    for m in planes:
        found[f"generic {m}"] = generic(m)
        if m > 3:
            found[f"near-pencil {m}"] = near_pencil(m)
        for size, number in simplicial_entries():
            if size == m:
                found[f"A({size},{number})"] = simplicial(size, number)
    return found
