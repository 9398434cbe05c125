"""Inscribed zonotopes: lengths of the given normals that put all vertices on one sphere.

This is the strong form of a "yes". The two ends of an edge along n have equal distance from the
origin exactly if they are mirror images in the plane of n, that is ``n . (v + v') = 0``, which is
linear in the lengths. Then every vertex is on the right side of the walls of its region, hence
inside its region, and the dual with points of one sphere in the regions is convex. This can only
happen when the arrangement is simplicial (R. Manecke, R. Sanyal, Inscribable fans II: inscribed
zonotopes, simplicial arrangements, and reflection groups).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from arrangement.duals.zonohedron import DualPolyhedron, dual_polyhedron
from arrangement.errors import ArrangementError
from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear.programs import Infeasible, feasible_point
from arrangement.planes.planes import Planes


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
