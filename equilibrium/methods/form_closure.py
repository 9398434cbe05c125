"""Form closure by a linear program, after Liu ([Liu1999]).

A grasp has form closure when its contacts alone, without friction, stop every small motion:
equivalently the origin lies strictly inside the convex hull of the normal wrenches. Liu tests this
by ray shooting: with the centroid P of the wrenches, maximise ``-P . v`` over all v with
``(w_i - P) . v <= 1``. The optimum z says where the ray from P through the origin leaves the hull:
at the distance 1/z, counted in units of the distance to the origin. So the origin is strictly
inside exactly when ``z < 1``. In the plane the same test on the edges of the cones decides force
closure, see `equilibrium.methods.force_closure` for both.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from arrangement.numbers.exact import RationalVector, primitive
from arrangement.numbers.linear.cones import generators
from arrangement.numbers.linear.programs import Infeasible, Optimal, Row, feasible_point, minimize
from arrangement.numbers.linear.rank import rank
from equilibrium.core.contact_rows import friction_edges
from equilibrium.methods.method import PLANE, SPACE, Accepting, Method, Outcome
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp


@dataclass(frozen=True)
class FormClosure(Accepting):
    """Whether the contacts immobilise the object, with a proof either way.

    Attributes:
        accepts: True for closure (every wrench is resisted); None otherwise: then the
            method says nothing of a single wrench.
        ray_value: Liu's optimum z, None when the wrenches do not span space.
        multipliers: with closure, numbers >= 1 with ``sum_i multipliers[i] w_i = 0``; the wrenches
            then span all space with positive factors, as their rank is full.
        free_motion: without closure, a motion d != 0 with ``w_i . d >= 0`` for all i.
    """

    accepts: bool | None
    ray_value: Fraction | None
    multipliers: RationalVector | None
    free_motion: RationalVector | None


def form_closure(grasp: Grasp, *, friction: bool = False) -> FormClosure:
    """Decide form closure exactly; in the plane also force closure, `friction`.

    Raises:
        GraspError: `friction` in space, where cones have no edges; see `force_closure`.

    >>> from equilibrium.model.contact import Contact
    >>> from equilibrium.model.grasp import Grasp
    >>> corner = [Contact([0, 0], n, 0) for n in ([1, 0], [-1, 0], [0, 1], [0, -1])]
    >>> form_closure(Grasp(corner)).free_motion
    (Fraction(0, 1), Fraction(0, 1), Fraction(1, 1))
    """
    if friction:
        if grasp.dimension == 3:
            raise GraspError("friction cones are round in space; call force_closure(grasp)")
        wrenches = [edge for contact in grasp for edge in friction_edges(contact)]
    else:
        wrenches = [contact.normal_wrench for contact in grasp]
    value = _ray_value(wrenches)
    if value is None or value >= 1:
        return FormClosure(None, value, None, _free_motion(wrenches))
    return FormClosure(True, value, _multipliers(wrenches), None)


def _ray_value(wrenches: Sequence[RationalVector]) -> Fraction | None:
    """Return Liu's optimum z for wrenches that span space, else None.

    None as well when their hull is flat, which shows as an unbounded program.
    """
    if not wrenches or rank([primitive(w) for w in wrenches]) < len(wrenches[0]):
        return None
    number = len(wrenches)
    centroid = [sum(column, Fraction(0)) / number for column in zip(*wrenches, strict=True)]
    rows: list[Row] = [[*(p - x for x, p in zip(w, centroid, strict=True)), 1] for w in wrenches]
    answer = minimize(centroid, rows)
    return -answer.value if isinstance(answer, Optimal) else None


def _multipliers(wrenches: Sequence[RationalVector]) -> RationalVector:
    """Return numbers >= 1 whose combination of the wrenches vanishes."""
    n = len(wrenches)
    least = [[int(i == j) for j in range(n)] + [-1] for i in range(n)]
    balance: list[Row] = [[*column, 0] for column in zip(*wrenches, strict=True)]
    point = feasible_point(n, least, balance)
    assert not isinstance(point, Infeasible)
    return point


def _free_motion(wrenches: Sequence[RationalVector]) -> RationalVector:
    """Return d != 0 with ``w . d >= 0`` for all wrenches, which exists without closure."""
    rays, lines = generators(
        [primitive(w) for w in wrenches], [], len(wrenches[0]) if wrenches else 3
    )
    return tuple(map(Fraction, [*rays, *lines][0]))


def _decide(grasp: Grasp, _: RationalVector, pyramid: int | None = None) -> Outcome:
    del pyramid
    closed = form_closure(grasp).accepts
    return closed, "every wrench" if closed else "no form closure: nothing follows for one wrench"


FORM_CLOSURE = Method(
    "form-closure",
    "form closure (Liu 1999)",
    "form closure",
    _decide,
    kinds=(PLANE, SPACE),
)
