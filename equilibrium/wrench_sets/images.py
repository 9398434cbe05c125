"""The wrenches that are resisted with one choice of contact states: a convex polyhedron.

With the states fixed the motions d form a closed cell, given by the springs and the directions of
slip. The wrench is linear in d, except that a sticking contact may pull either way up to its limit,
which is linear in d too. So the resisted wrenches are the convex hull of the images of the cell's
vertices and rays, each with both extreme forces of every sticking contact. (Any force in between is
a mixture of the two at the same d, and the maps are linear.)
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import lcm

from arrangement.exact import IntegerVector, RationalVector, dot, primitive
from arrangement.linear import reduced
from arrangement.polyhedra.cones import generators
from arrangement.polyhedra.polyhedron import Polyhedron, from_generators
from equilibrium.model.grasp import Contact, Grasp
from equilibrium.solver.state_system import DIRECTION, States

#: Above this number, redundant images are removed before the next sticking contact.
_MANY = 40


def resisted_with(
    grasp: Grasp, states: States, plane: IntegerVector | None = None
) -> Polyhedron | None:
    """Return the wrenches that are resisted with these contact states; None when there are none.

    Args:
        plane: ``(a, b)``: leave out motions at which none of the wrenches has ``a . w + b = 0``.
            All wrenches of this plane remain, of others only some.
    """
    table, scale = _integers(grasp)
    inequalities, equalities = _reaching(table, scale, states, plane) if plane else ([], [])
    for contact, state in zip(table, states, strict=True):
        if state == "detached":
            inequalities.append(_opposite(contact.spring))
            continue
        inequalities.append(contact.spring)
        if state == "stick":
            equalities.append(contact.slip)
        else:
            inequalities.append(contact.slip if state == "slip+" else _opposite(contact.slip))
    # Along a line of the cell no touching spring may change, so the wrench does not either.
    rays, _ = generators(inequalities, equalities, 4, finite=True)
    images = {image for ray in rays for image in _images(table, scale, states, ray)}
    return from_generators(images, (), 3)


def _reaching(
    table: tuple[_Integers, ...], scale: int, states: States, plane: IntegerVector
) -> tuple[list[IntegerVector], list[IntegerVector]]:
    """Return the conditions on a motion that its wrenches reach a plane.

    At one motion ``a . w + b`` lies between two bounds, each linear: every sticking contact pulls
    one way or the other.
    """
    lowest, highest = [0, 0, 0, scale * plane[3]], [0, 0, 0, scale * plane[3]]
    for contact, state in zip(table, states, strict=True):
        if state != "detached":
            values = [dot(plane[:3], balance) for balance in contact.balances[state]]
            for j, x in enumerate(contact.spring):
                lowest[j] += min(values) * x
                highest[j] += max(values) * x
    if lowest == highest:
        return [], [tuple(lowest)] if any(lowest) else []
    return [_opposite(tuple(lowest)), tuple(highest)], []


@dataclass(frozen=True)
class _Integers:
    """One contact in integers.

    Attributes:
        spring: the homogeneous row of the normal force ``preload - stiffness N . d``, times a
            factor that is the same for all contacts.
        slip: a multiple of the homogeneous row ``T . d``.
        balances: for each state the extreme wrenches that balance a normal force of 1 with its
            tangential force, times a factor that is the same for all contacts.
    """

    spring: IntegerVector
    slip: IntegerVector
    balances: dict[str, tuple[IntegerVector, ...]]


@lru_cache(maxsize=16)
def _integers(grasp: Grasp) -> tuple[tuple[_Integers, ...], int]:
    """Return the contacts in integers, and the product of the two common factors."""
    springs = [_spring(contact) for contact in grasp]
    edges = [_edges(contact) for contact in grasp]
    first = lcm(*(x.denominator for row in springs for x in row))
    second = lcm(*(x.denominator for pair in edges for edge in pair for x in edge))
    table = []
    for contact, spring, pair in zip(grasp, springs, edges, strict=True):
        plus, minus = (tuple(int(x * second) for x in edge) for edge in pair)
        both = (plus, minus) if plus != minus else (plus,)
        slip = primitive((*contact.tangential_wrench, Fraction(0)))
        slipping = {name: (plus if side > 0 else minus,) for name, side in DIRECTION.items()}
        balances: dict[str, tuple[IntegerVector, ...]] = {"stick": both, **slipping}
        table.append(_Integers(tuple(int(x * first) for x in spring), slip, balances))
    return tuple(table), first * second


def _spring(contact: Contact) -> RationalVector:
    return (*(-contact.stiffness * x for x in contact.normal_wrench), contact.preload)


def _edges(contact: Contact) -> tuple[RationalVector, RationalVector]:
    """Return ``-(N + friction T)`` and ``-(N - friction T)``."""
    pairs = list(zip(contact.normal_wrench, contact.tangential_wrench, strict=True))
    plus = tuple(-(n + contact.friction * t) for n, t in pairs)
    return plus, tuple(-(n - contact.friction * t) for n, t in pairs)


def _images(
    table: tuple[_Integers, ...], scale: int, states: States, motion: IntegerVector
) -> Iterator[IntegerVector]:
    """Yield the homogeneous wrenches that balance the extreme forces at a homogeneous motion."""
    wrenches: list[IntegerVector] = [(0, 0, 0)]
    for contact, state in zip(table, states, strict=True):
        force = 0 if state == "detached" else dot(contact.spring, motion)
        if force == 0:
            continue
        wrenches = [
            (w[0] + force * b[0], w[1] + force * b[1], w[2] + force * b[2])
            for w in wrenches
            for b in contact.balances[state]
        ]
        if len(wrenches) > _MANY:
            wrenches = _extreme(wrenches)
    homogeneous = ((*wrench, scale * motion[3]) for wrench in wrenches)
    yield from (reduced(wrench) for wrench in homogeneous if any(wrench))


def _extreme(points: list[IntegerVector]) -> list[IntegerVector]:
    """Return the vertices of the convex hull of integer points."""
    facets, equalities = generators([(*point, 1) for point in points], (), 4)
    rays, _ = generators(facets, equalities, 4)
    return [ray[:3] for ray in rays]


def _opposite(row: IntegerVector) -> IntegerVector:
    return tuple(-x for x in row)
