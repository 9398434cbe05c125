"""Answers with evidence: whether the dual, or a zonotope with these normals, can be inscribed."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from arrangement.console.number_form import Shown
from arrangement.counts import region_count
from arrangement.duals.zonohedron import DualPolyhedron, dual_polyhedron
from arrangement.errors import ArrangementError
from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear.programs import Infeasible, feasible_point
from arrangement.planes.planes import Planes

from .certificates import Certificate, PolyhedralGraph
from .hull import sphere_points
from .proved import proved_conditions
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
            raise ArrangementError("the proved program refuses the certificate")


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


@dataclass(frozen=True)
class InscribedZonotope:
    """Whether some lengths of the given normals give an inscribed zonotope; with its proof.

    Attributes:
        arrangement: the planes.
        lengths: positive factors of the normals, or None.
        multipliers: without lengths, a factor for each edge of the dual, so that the sum of the
            edge equations is a form in the lengths with coefficients <= 0, not all zero.
    """

    arrangement: Planes
    lengths: RationalVector | None
    multipliers: RationalVector | None

    def verify(self) -> None:
        """Check the vertices, or the sum of the equations.

        Raises:
            ArrangementError: what fails.
        """
        dual = dual_polyhedron(self.arrangement, self.lengths)
        dual.validate()
        if self.lengths is not None:
            if not dual.is_inscribed:
                raise ArrangementError("the vertices have different distances from the origin")
            return
        if self.multipliers is None or len(self.multipliers) != len(dual.edges):
            raise ArrangementError("there is not one multiplier for each edge")
        total = [Fraction(0)] * len(self.arrangement)
        for multiplier, row in zip(self.multipliers, _edge_equations(dual), strict=True):
            if multiplier:
                total = [t + multiplier * x for t, x in zip(total, row, strict=True)]
        if any(t > 0 for t in total) or not any(total):
            raise ArrangementError("the sum of the equations contradicts nothing")


def inscribed_zonotope(arrangement: Planes) -> InscribedZonotope:
    """Find lengths for which the dual of a rank 3 arrangement in R^3 is inscribed, or refute them.

    The answer depends on the normals themselves, not only on the combinatorial type.

    Raises:
        InputError: as for `dual_polyhedron`.

    Complexity: an exact linear program with m variables.

    >>> from arrangement.library.families import type_b
    >>> inscribed_zonotope(type_b(3)).lengths is not None
    True
    """
    dual = dual_polyhedron(arrangement)
    rows = _edge_equations(dual)
    place: dict[tuple[int, ...], int] = {}
    for e, row in enumerate(rows):
        opposite = tuple(-x for x in row)
        if any(row) and opposite not in place:
            place.setdefault(row, e)
    m = len(arrangement)
    at_least_one = [[*(int(i == j) for j in range(m)), -1] for i in range(m)]
    answer = feasible_point(m, at_least_one, [[*row, 0] for row in place])
    if not isinstance(answer, Infeasible):
        return InscribedZonotope(arrangement, answer, None)
    multipliers = [Fraction(0)] * len(rows)
    for e, x in zip(place.values(), answer.equality_multipliers, strict=True):
        multipliers[e] = x
    return InscribedZonotope(arrangement, None, tuple(multipliers))


def _edge_equations(dual: DualPolyhedron) -> tuple[tuple[int, ...], ...]:
    """Return for each edge the signs and products ``s_j (n_j . n)`` for the planes j not along it.

    With lengths ``l_j`` the ends of the edge are at equal distance exactly if the row times the
    lengths is zero.
    """
    planes = [plane[:3] for plane in dual.arrangement.integer_planes]
    products = [[dot(a, b) for b in planes] for a in planes]
    firsts = dual.arrangement.firsts
    labels = dual.arrangement.class_of
    return tuple(
        tuple(
            0 if labels[j] == label else s * products[firsts[label]][j]
            for j, s in enumerate(dual.signs[u].tolist())
        )
        for (u, _), label in zip(dual.edges.tolist(), dual.edge_classes.tolist(), strict=True)
    )
