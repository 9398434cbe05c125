"""Whether forces inside round friction cones balance a wrench in space, with a proof either way.

No springs and no dissipation. A pyramid inside each cone gives exact forces; a pyramid around each
gives, where it has none, a motion d with ``w . d > 0`` along which no force of the cones does
negative work: ``N . d >= 0`` and ``(N . d)^2 >= friction^2 |T d|^2`` for each contact. Both are
linear programs. Loads between the finest two pyramids stay undecided.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear.programs import Infeasible, Row, feasible_point
from equilibrium.methods.contact_laws.springs import Forces
from equilibrium.methods.method import Accepting
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.plane.contact_rows import cone_edge, unit_row

from .grasp_wrench_space import GraspWrenchSpace

#: Edges of the pyramids, tried in this order.
PYRAMIDS = (4, 8, 16, 32)


@dataclass(frozen=True)
class RoundConesVerdict(Accepting):
    """Whether forces inside round cones balance a wrench.

    Attributes:
        accepts: they exist; None where the pyramids do not tell.
        forces: at each contact normal and two tangential ones that do; else None.
        separating_motion: if refused, a motion as this module says.
    """

    accepts: bool | None
    forces: Forces | None = None
    separating_motion: RationalVector | None = None


def round_cones(grasp: Grasp, wrench: Iterable[Any]) -> RoundConesVerdict:
    """Decide with exact linear programs.

    >>> from equilibrium.grasps.files import read_grasp
    >>> fingers = read_grasp("two-opposed-fingers")
    >>> round_cones(fingers, [0, 3, 4, 0, 0, 0]).accepts
    True
    >>> round_cones(fingers, [0, 0, 0, 1, 0, 0]).accepts
    False
    """
    load = read_wrench(wrench, grasp.dimension)
    for pyramid in PYRAMIDS:
        inside = GraspWrenchSpace(grasp, pyramid=pyramid).verdict(load)
        if inside.accepts:
            return RoundConesVerdict(True, forces=inside.forces)
        for motion in (inside.separating_motion, _refused_around(grasp, load, pyramid)):
            if motion is not None and separates(grasp, load, motion):
                return RoundConesVerdict(False, separating_motion=motion)
    return RoundConesVerdict(None)


def separates(grasp: Grasp, wrench: RationalVector, motion: RationalVector) -> bool:
    """Return whether a motion proves that no forces inside the round cones balance the wrench."""
    return dot(wrench, motion) > 0 and all(
        (push := dot(contact.normal_wrench, motion)) >= 0
        and push**2
        >= contact.friction**2 * sum(dot(t, motion) ** 2 for t in contact.tangential_wrenches)
        for contact in grasp
    )


def _refused_around(grasp: Grasp, load: RationalVector, pyramid: int) -> RationalVector | None:
    """Return the motion that refuses the load to pyramids around the cones, if they refuse it."""
    edges = pyramid_edges(pyramid)
    # Two tangents of the unit circle, at unit vectors u and v, meet at (u + v) / (1 + u . v).
    corners = [
        tuple((x + y) / (1 + dot(u, v)) for x, y in zip(u, v, strict=True))
        for u, v in pairwise((*edges, edges[0]))
    ]
    columns = [cone_edge(contact, corner) for contact in grasp for corner in corners]
    n = len(columns)
    balance: list[Row] = [[*(c[i] for c in columns), x] for i, x in enumerate(load)]
    found = feasible_point(n, [unit_row(j, n) for j in range(n)], balance)
    if not isinstance(found, Infeasible):
        return None
    return tuple(-x for x in found.equality_multipliers)
