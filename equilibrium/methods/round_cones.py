"""Whether forces inside the friction cones balance a wrench, proved either way.

In the plane a cone has two edges, and one linear program decides. In space cones are round. A
pyramid inside each gives exact forces; a pyramid around each gives, where it has none, a motion d
with ``w . d > 0`` along which no force of the cones does negative work: ``N . d >= 0`` and
``(N . d)^2 >= friction^2 |T d|^2`` for each contact. Loads between the finest two pyramids stay
undecided.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import Any, Literal, TypeAlias

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear.programs import (
    Infeasible,
    Optimal,
    Row,
    Unbounded,
    feasible_point,
    minimize,
)
from equilibrium.core.contact_rows import cone_edge, edge_directions, unit_row
from equilibrium.methods.method import Accepting
from equilibrium.methods.springs import Forces
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.grasp import Grasp

#: What is least of the normal forces: their sum, or the largest of them.
Norm: TypeAlias = Literal["L1", "Linf"]
#: Edges of the pyramids, tried in this order.
PYRAMIDS = (4, 8, 16, 32)


@dataclass(frozen=True)
class ConeVerdict(Accepting):
    """Whether forces inside the cones balance a wrench.

    Attributes:
        accepts: None where it is undecided, in space.
        forces: (normal, along the tangents) at each contact that do.
        separating_motion: if none do, a motion d with ``w . d > 0`` along which no force inside
            any cone does negative work.
        least_force: the least sum (L1) or least maximum (Linf) of normal forces that do, where a
            norm was stated.
    """

    accepts: bool | None
    forces: Forces | None = None
    separating_motion: RationalVector | None = None
    least_force: Fraction | None = None

    @property
    def words(self) -> str:
        """The answer in space."""
        if self.accepts is None:
            return "undecided: the load is at the boundary of what round cones give"
        return f"forces inside the round cones {'' if self.accepts else 'do not '}exist, proved"


def round_cones(grasp: Grasp, wrench: Iterable[Any]) -> ConeVerdict:
    """Decide with exact linear programs; neither yes nor no where pyramids are inconclusive.

    >>> from equilibrium import read_grasp
    >>> fingers = read_grasp("two-opposed-fingers")
    >>> round_cones(fingers, [0, 3, 4, 0, 0, 0]).accepts
    True
    >>> round_cones(fingers, [0, 0, 0, 1, 0, 0]).accepts
    False
    """
    return balanced(grasp, grasp.total_load(grasp.read_wrench(wrench)))


def balanced(grasp: Grasp, load: RationalVector) -> ConeVerdict:
    """Decide for all that forces inside the cones have to balance, with the pull of adhesion."""
    for pyramid in PYRAMIDS:
        inside = with_edges(grasp, load, [edge_directions(c, pyramid) for c in grasp])
        motion = inside.separating_motion
        if motion is None or separates(grasp, load, motion):
            return inside
        around = with_edges(grasp, load, [_corners(pyramid)] * len(grasp))
        if not around.accepts:
            return around
    return ConeVerdict(None)


def separates(grasp: Grasp, load: RationalVector, motion: RationalVector) -> bool:
    """Return whether a motion proves that no forces inside the round cones balance a load.

    The load, with all adhesion, does work on it, and no force of any cone negative work.
    """
    return dot(load, motion) > 0 and all(
        (push := dot(contact.normal_wrench, motion)) >= 0
        and push**2
        >= contact.friction**2 * sum(dot(t, motion) ** 2 for t in contact.tangential_wrenches)
        for contact in grasp
    )


def with_edges(
    grasp: Grasp,
    load: RationalVector,
    edges: Sequence[Sequence[RationalVector]],
    norm: Norm | None = None,
) -> ConeVerdict:
    """Decide for polyhedral cones with edges along these directions, in the frames of tangents.

    Args:
        norm: what the forces make least; if omitted, some forces are returned.
    """
    columns = [cone_edge(c, x) for c, along in zip(grasp, edges, strict=True) for x in along]
    # Variables: a factor for each cone edge, then the bound on single normal forces, if one.
    bounds = [Fraction(0)] * (norm == "Linf")
    n = len(columns) + len(bounds)
    rows = [unit_row(j, n) for j in range(n)]
    balance: list[Row] = [
        [*(column[i] for column in columns), *bounds, x] for i, x in enumerate(load)
    ]
    if bounds:
        owner = [i for i, group in enumerate(grasp.groups) for k in group for _ in edges[k]]
        for i in range(len(grasp.groups)):
            rows.append((*(Fraction(-(k == i)) for k in owner), Fraction(1), Fraction(0)))
    objective = [0] * len(columns) + [1] if bounds else [1] * n
    answer = minimize(objective, rows, balance) if norm else feasible_point(n, rows, balance)
    assert not isinstance(answer, Unbounded)
    if isinstance(answer, Infeasible):
        motion = tuple(-x for x in answer.equality_multipliers)
        return ConeVerdict(False, separating_motion=motion)
    point, least = (answer.point, answer.value) if isinstance(answer, Optimal) else (answer, None)
    parts, forces = iter(point), []
    for contact, along in zip(grasp, edges, strict=True):
        sizes = [next(parts) for _ in along]
        friction = (contact.friction * dot(sizes, axis) for axis in zip(*along, strict=True))
        forces.append((sum(sizes, Fraction(0)), *friction))
    return ConeVerdict(True, tuple(forces), least_force=least)


@cache
def _corners(pyramid: int) -> tuple[RationalVector, ...]:
    """Return the corners of a polygon around the unit circle.

    Two tangents of the circle, at unit vectors u and v, meet at ``(u + v) / (1 + u . v)``.
    """
    edges = pyramid_edges(pyramid)
    return tuple(
        tuple((x + y) / (1 + dot(u, v)) for x, y in zip(u, v, strict=True))
        for u, v in pairwise((*edges, edges[0]))
    )
