"""The Grasp Wrench Space of Ferrari and Canny ([Ferrari1992]), exact.

It is the set of wrenches that contact forces inside their cones can give together when their
normal parts are bounded: by 1 in sum (norm "L1": the convex hull of the cone edges and the
origin) or by 1 each (norm "Linf": the Minkowski sum of one triangle for each contact, of a pad one
hull). In the plane a friction cone has two edges, so nothing is linearised; in space a pyramid
inside the round cone takes its place, and the hull has six dimensions. A wrench w is resisted, in
the sense of this method, when a multiple of the space holds ``-w``. Springs, preload and slip play
no part: this is the set of weakly stable loads. Adhesion is a constant wrench besides w; it is no
part of the space, its volume and epsilon.

The linearised space lies inside that of the round cones, so what it holds is proved, and what it
misses is not: force closure is decided with round cones, see
`equilibrium.methods.force_closure`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import gcd, sqrt
from typing import Any

from arrangement.console.number_form import number
from arrangement.errors import OutOfReachError
from arrangement.hints import HintsMixin
from arrangement.numbers import budget
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    dot,
    primitive,
    rational,
    rational_vector,
    shown,
)
from arrangement.numbers.linear.polyhedron import Polyhedron, from_generators
from arrangement.numbers.linear.rank import cross
from equilibrium.core.contact_rows import edge_directions, friction_edges, sum_row
from equilibrium.methods.force_closure import force_closure
from equilibrium.methods.method import PLANE, SPACE, Method, Outcome, cut
from equilibrium.methods.round_cones import ConeVerdict, Norm, round_cones, with_edges
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.subject import check_subject
from equilibrium.wrench_sets.slice import polygon_cycle

#: In six dimensions the hull of more edges takes seconds and more.
MAX_EDGES_IN_HULL = 16


@dataclass(frozen=True)
class GraspWrenchSpace(HintsMixin):
    """The space of one grasp.

    Args:
        grasp: the contacts; only points, normals and friction count.
        norm: "L1" or "Linf" (see this module).
        pyramid: edges of the friction pyramids of a grasp in space, see `pyramid_edges`.
        length: a length that torques are divided by, above 0. `volume` and `epsilon_squared`
            mix forces and torques, so they depend on it, and on the origin of the frame; force
            closure and verdicts do not.

    >>> from equilibrium.model.contact import Contact
    >>> from equilibrium.model.grasp import Grasp
    >>> squeeze = [Contact([-1, 0], [1, 0], 1), Contact([1, 0], [-1, 0], 1)]
    >>> GraspWrenchSpace(Grasp(squeeze)).force_closure
    True
    """

    grasp: Grasp
    norm: Norm = "L1"
    length: Fraction = Fraction(1)
    pyramid: int = 4

    def __post_init__(self) -> None:
        check_subject(self.grasp)
        object.__setattr__(self, "length", rational(self.length, "length"))
        if self.norm not in ("L1", "Linf"):
            raise GraspError(f"norm is {self.norm!r}; it must be 'L1' or 'Linf'")
        if self.length <= 0:
            raise GraspError(f"length is {shown(self.length)}; it must be above 0")

    @cached_property
    def polytope(self) -> Polyhedron:
        """The space with torques divided by `length`; flat where the forces are.

        Raises:
            OutOfReachError: in space, of too many edges; `arrangement.limit` allows more.
        """
        many = len(self.grasp) * self.pyramid > MAX_EDGES_IN_HULL * budget.times()
        if self.grasp.dimension == 3 and many:
            raise OutOfReachError(
                f"the hull of {self.grasp.size_words} with {self.pyramid} edges each in six "
                f"dimensions takes too long; up to {MAX_EDGES_IN_HULL} edges in all are tried, and "
                "`solve --methods` decides whether one wrench is in it"
            )
        edges = [
            [self._scaled(edge) for c in points for edge in friction_edges(c, self.pyramid)]
            for points in self.grasp.parts
        ]
        zero = (Fraction(0),) * self.grasp.wrench_size
        if self.norm == "L1":
            return _hull([zero, *(edge for pair in edges for edge in pair)])
        hull = _hull([zero])
        for pair in edges:
            sums = product(hull.points, (zero, *pair))
            hull = _hull([sum_row(wrench, other, 1) for wrench, other in sums])
        return hull

    @property
    def facets(self) -> tuple[IntegerVector, ...]:
        """The conditions ``a . x + b >= 0`` of the facets; none where the space is flat."""
        return () if self.polytope.equalities else self.polytope.inequalities

    @property
    def force_closure(self) -> bool | None:
        """Whether forces inside the cones, in space the round ones, balance every wrench.

        None where that is undecided, in space; see `force_closure` for the proof.
        """
        return force_closure(self.grasp).accepts

    @property
    def surrounds_origin(self) -> bool:
        """Whether the origin lies strictly inside this space, in space the linearised one."""
        return bool(self.facets) and all(row[-1] > 0 for row in self.facets)

    @property
    def epsilon_squared(self) -> Fraction:
        """The squared radius of the largest ball about the origin inside the space, exact.

        In space it is that of the linearised space, and a lower bound for round cones.
        """
        if not self.surrounds_origin:
            return Fraction(0)
        return min(Fraction(row[-1] ** 2, dot(row[:-1], row[:-1])) for row in self.facets)

    @property
    def epsilon(self) -> float:
        """The quality measure of Ferrari and Canny: the root of `epsilon_squared`, rounded."""
        return sqrt(self.epsilon_squared)

    @property
    def volume(self) -> Fraction:
        """The exact volume of the space; 0 where it is flat.

        Raises:
            GraspError: a grasp in space.
        """
        self.grasp.require_plane()
        return self.polytope.volume

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form of epsilon, vertices and facets."""
        return {
            "epsilon_squared": self.epsilon_squared,
            "vertices": sorted(self.polytope.points),
            # (normal, constant) with the normal outward and of coprime integers.
            "facets": sorted([Fraction(-x, gcd(*row[:-1])) for x in row] for row in self.facets),
        }

    def lines(self) -> Iterator[str]:
        """Yield epsilon, volume and the number of facets in lines for people."""
        units = self.grasp.units
        # With torques divided by a length all axes are forces.
        force = f" {units.force}" if units else ""
        square, cube = (f"{force}^2", f"{force}^3") if units else ("", "")
        root = number(self.epsilon_squared) + square
        stuck = "; without adhesion" if any(self.grasp.adhesion_wrench) else ""
        yield f"epsilon          {self.epsilon:.6g}{force}  (its square is {root}{stuck})"
        length = f"{number(self.length)} {units.length}" if units else number(self.length)
        flat = self.grasp.dimension == 2
        what = "epsilon and volume depend" if flat else "epsilon depends"
        yield f"torques over     {length}  ({what} on it; --torque-length)"
        if flat:
            yield f"volume           {number(self.volume)}{cube}"
        yield f"facets           {len(self.facets)}"

    def verdict(self, wrench: Iterable[Any]) -> ConeVerdict:
        """Return whether the method counts a wrench as resisted; one exact linear program.

        Its `least_force` is the least multiple of the space that balances the wrench.
        """
        load = self.grasp.total_load(self.grasp.read_wrench(wrench))
        edges = [edge_directions(contact, self.pyramid) for contact in self.grasp]
        return with_edges(self.grasp, load, edges, self.norm)

    def slice(
        self,
        origin: Iterable[Any] = (0, 0, 0),
        first: Iterable[Any] = (1, 0, 0),
        second: Iterable[Any] = (0, 1, 0),
    ) -> tuple[RationalVector, ...]:
        """Return the resisted wrenches ``origin + u first + v second`` as an exact polygon.

        Returns:
            The corners (u, v) of ``{w : -w in the space}`` cut by the plane, counter-clockwise;
            two for a segment, one for a point, none if the plane misses it. The default plane
            holds the forces at zero torque, as in the paper's figure.
        """
        self.grasp.require_plane()
        o, a, b = (rational_vector(v, "plane") for v in (origin, first, second))
        if not any(cross(a, b)):
            raise GraspError("first and second are parallel; give two that span a plane")
        polygon = self.resisted.cut(o, (a, b))
        if polygon is None:
            return ()
        corners = polygon_cycle(polygon)
        least = corners.index(min(corners))
        return (*corners[least:], *corners[:least])

    @cached_property
    def resisted(self) -> Polyhedron:
        """The wrenches that forces within the bounds, and adhesion, balance."""
        self.grasp.require_plane()
        (a, b, c), s = self.grasp.adhesion_wrench, self.length
        return _hull([(-x - a, -y - b, -s * torque - c) for x, y, torque in self.polytope.points])

    def _scaled(self, wrench: RationalVector) -> RationalVector:
        forces = self.grasp.dimension
        return (*wrench[:forces], *(torque / self.length for torque in wrench[forces:]))


def _hull(points: Iterable[RationalVector]) -> Polyhedron:
    """Return the convex hull of finitely many points, at least one."""
    rays = [primitive((*p, Fraction(1))) for p in points]
    hull = from_generators(rays, (), len(rays[0]) - 1)
    assert hull is not None
    return hull


def _decide(grasp: Grasp, wrench: RationalVector, pyramid: int | None = None) -> Outcome:
    edges = pyramid or 4
    space = GraspWrenchSpace(grasp, pyramid=edges)
    verdict = space.verdict(wrench)
    accepts, remark = verdict.accepts, "no forces inside the cones balance it"
    if verdict.least_force is not None:
        remark = f"total normal force at least {number(verdict.least_force)}"
    if grasp.dimension == 2:
        return accepts, remark
    if edges * len(grasp) <= MAX_EDGES_IN_HULL:
        remark += f"; epsilon {space.epsilon:.4g}"
    remark = f"pyramids of {edges} edges: {remark}"
    if pyramid is not None:
        return accepts, remark
    round_verdict = round_cones(grasp, wrench)
    remark = f"{round_verdict.words}; {force_closure(grasp).words}; {remark}"
    return round_verdict.accepts, remark


#: Without a bound of the forces.
WRENCH_SPACE = Method(
    "wrench-space",
    "Grasp Wrench Space (Ferrari, Canny 1992)",
    "wrench space, unbounded",
    _decide,
    kinds=(PLANE, SPACE),
)
WRENCH_SPACE_L1 = Method(
    "wrench-space-L1",
    "Grasp Wrench Space, normal forces with sum at most 1",
    "wrench space, L1",
    find_region=cut(lambda grasp: [GraspWrenchSpace(grasp, "L1").resisted]),
)
WRENCH_SPACE_LINF = Method(
    "wrench-space-Linf",
    "Grasp Wrench Space, normal forces at most 1 each",
    "wrench space, L∞",
    find_region=cut(lambda grasp: [GraspWrenchSpace(grasp, "Linf").resisted]),
)
