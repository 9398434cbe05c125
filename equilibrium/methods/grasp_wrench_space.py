"""The Grasp Wrench Space of Ferrari and Canny ([Ferrari1992]), exact.

It is the set of wrenches that contact forces inside their cones can give together when their
normal parts are bounded: by 1 in sum (norm "L1": the convex hull of the cone edges and the
origin) or by 1 each (norm "Linf": the Minkowski sum of one triangle for each contact). In the
plane a friction cone has two edges, so nothing is linearised. A wrench w is resisted, in the sense
of this method, when a multiple of the space holds ``-w``. Springs, preload and slip play no part:
this is the set of weakly stable loads.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import sqrt
from typing import Any, Literal

from arrangement.exact import RationalVector, dot, rational, rational_vector
from arrangement.linear import cross
from arrangement.linprog import Infeasible, Optimal, Row, minimize
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Contact, Grasp, read_wrench

from .hull import Hull, convex_hull, plane_hull

Norm = Literal["L1", "Linf"]
Forces = tuple[tuple[Fraction, Fraction], ...]


@dataclass(frozen=True)
class WrenchSpaceVerdict:
    """Whether bounded forces inside the cones can balance a wrench.

    Attributes:
        accepts: some multiple of the space holds the opposite wrench.
        least_force: the least such multiple: the least sum (L1) or least maximum (Linf) of normal
            forces; None if refused.
        forces: normal and tangential force at each contact that reach it; None if refused.
        separating_motion: if refused, a motion d with ``w . d = 1`` along which no force inside
            any cone does negative work.
    """

    accepts: bool
    least_force: Fraction | None
    forces: Forces | None
    separating_motion: RationalVector | None


@dataclass(frozen=True)
class GraspWrenchSpace:
    """The space of one grasp.

    Args:
        grasp: the contacts; only points, normals and friction count.
        norm: "L1" or "Linf" (see this module).
        torque_scale: a length that torques are divided by, above 0. `volume` and `epsilon_squared`
            mix forces and torques, so they depend on it, and on the origin of the frame; force
            closure and verdicts do not.

    >>> from equilibrium.model.grasp import Contact, Grasp
    >>> squeeze = [Contact([-1, 0], [1, 0], 1), Contact([1, 0], [-1, 0], 1)]
    >>> GraspWrenchSpace(Grasp(squeeze)).force_closure
    True
    """

    grasp: Grasp
    norm: Norm = "L1"
    torque_scale: Fraction = Fraction(1)

    def __post_init__(self) -> None:
        object.__setattr__(self, "torque_scale", rational(self.torque_scale, "torque_scale"))
        if self.norm not in ("L1", "Linf"):
            raise GraspError(f"norm is {self.norm!r}; it must be 'L1' or 'Linf'")
        if self.torque_scale <= 0:
            raise GraspError(f"torque_scale is {self.torque_scale}; it must be above 0")

    @cached_property
    def hull(self) -> Hull:
        """The space as an exact polytope, torques divided by `torque_scale`."""
        edges = [[self._scaled(edge) for edge in cone_edges(contact)] for contact in self.grasp]
        zero = (Fraction(0),) * 3
        if self.norm == "L1":
            return convex_hull([zero, *(edge for pair in edges for edge in pair)])
        hull = convex_hull([zero])
        for pair in edges:
            sums = product(hull.vertices, (zero, *pair))
            hull = convex_hull([tuple(map(sum, zip(*both, strict=True))) for both in sums])
        return hull

    @property
    def force_closure(self) -> bool:
        """Whether every wrench is resisted: the origin lies strictly inside."""
        return self.hull.has_inside((0, 0, 0))

    @property
    def epsilon_squared(self) -> Fraction:
        """The squared radius of the largest ball about the origin inside the space, exact."""
        if not self.force_closure:
            return Fraction(0)
        return min(f.offset**2 / Fraction(dot(f.normal, f.normal)) for f in self.hull.facets)

    @property
    def epsilon(self) -> float:
        """The quality measure of Ferrari and Canny: the root of `epsilon_squared`, rounded."""
        return sqrt(self.epsilon_squared)

    @property
    def volume(self) -> Fraction:
        """The exact volume of the space."""
        return self.hull.volume

    def verdict(self, wrench: Iterable[Any]) -> WrenchSpaceVerdict:
        """Return whether the method counts a wrench as resisted; one exact linear program."""
        load = read_wrench(wrench)
        columns = [edge for contact in self.grasp for edge in cone_edges(contact)]
        n, m = len(columns), len(self.grasp)
        # Variables: a factor for each cone edge, then the bound on single normal forces.
        rows: list[Row] = [_row(n, {j: 1}) for j in range(n + 1)]
        if self.norm == "Linf":
            rows += [_row(n, {2 * i: -1, 2 * i + 1: -1, n: 1}) for i in range(m)]
        balance: list[Row] = [[*(c[k] for c in columns), Fraction(0), load[k]] for k in range(3)]
        objective = [0] * n + [1] if self.norm == "Linf" else [1] * n + [0]
        answer = minimize(objective, rows, balance)
        if isinstance(answer, Optimal):
            parts = answer.point[:n]
            forces = tuple(
                (a + b, contact.friction * (a - b))
                for contact, a, b in zip(self.grasp, parts[::2], parts[1::2], strict=True)
            )
            return WrenchSpaceVerdict(True, answer.value, forces, None)
        assert isinstance(answer, Infeasible)
        motion = tuple(-z for z in answer.equality_multipliers)
        return WrenchSpaceVerdict(False, None, None, motion)

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
        o, a, b = (rational_vector(v, "plane") for v in (origin, first, second))
        normal = cross(a, b)
        if not any(normal):
            raise GraspError("first and second are parallel; give two that span a plane")
        resisted = [self._unscaled(vertex) for vertex in self.hull.vertices]
        heights = [dot(normal, v) - dot(normal, o) for v in resisted]
        cut = {v for v, h in zip(resisted, heights, strict=True) if h == 0}
        for p, hp in zip(resisted, heights, strict=True):
            for q, hq in zip(resisted, heights, strict=True):
                if hp > 0 > hq:
                    t = hp / (hp - hq)
                    cut.add(tuple(x + t * (y - x) for x, y in zip(p, q, strict=True)))
        corners = sorted({_coordinates(point, o, a, b) for point in cut})
        return tuple(corners[i] for i in plane_hull(corners))

    def _scaled(self, wrench: RationalVector) -> RationalVector:
        return (wrench[0], wrench[1], wrench[2] / self.torque_scale)

    def _unscaled(self, vertex: RationalVector) -> RationalVector:
        """Return the applied wrench that a point of the space balances."""
        return (-vertex[0], -vertex[1], -vertex[2] * self.torque_scale)


def cone_edges(contact: Contact) -> tuple[RationalVector, RationalVector]:
    """Return ``N + mu T`` and ``N - mu T``, the wrenches along the two edges of the cone."""
    pairs = list(zip(contact.normal_wrench, contact.tangential_wrench, strict=True))
    mu = contact.friction
    return tuple(n + mu * t for n, t in pairs), tuple(n - mu * t for n, t in pairs)


def _row(n: int, entries: dict[int, int]) -> list[int]:
    """Return a row over n factors, the bound and the constant."""
    return [entries.get(j, 0) for j in range(n + 2)]


def _coordinates(
    point: RationalVector, origin: RationalVector, first: RationalVector, second: RationalVector
) -> RationalVector:
    """Return (u, v) with ``point = origin + u first + v second``."""
    away = [x - y for x, y in zip(point, origin, strict=True)]
    normal = cross(first, second)
    square = dot(normal, normal)
    return (dot(cross(away, second), normal) / square, dot(cross(first, away), normal) / square)
