"""The law of contacts, evaluated at a motion and forces.

Written a second time on purpose, from the contact data alone: the checker must not inherit a
mistake of the solver.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from arrangement.numbers.exact import RationalVector, number_text
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from equilibrium.model.range import Range, turns_of


def frame(contact: Contact) -> tuple[RationalVector, ...]:
    """Return the wrenches of unit forces along the normal and the tangents: one, in space two."""
    if contact.dimension == 2:
        (x, y), (nx, ny) = contact.point, contact.normal
        return (nx, ny, x * ny - y * nx), (-ny, nx, x * nx + y * ny)
    along = contact.normal, contact.tangent, _cross(contact.normal, contact.tangent)
    return tuple((*force, *_cross(contact.point, force)) for force in along)


def _cross(left: RationalVector, right: RationalVector) -> RationalVector:
    (a, b, c), (x, y, z) = left, right
    return b * z - c * y, c * x - a * z, a * y - b * x


def law_problem(
    grasp: Grasp,
    wrench: RationalVector,
    motion: RationalVector,
    forces: Sequence[RationalVector],
    edges: Sequence[RationalVector] = (),
) -> str:
    """Return what is wrong with a motion and forces (normal, tangential); empty if they obey.

    Spring ``c_n = max(0, q - k N . d)``, cone ``|c_t| <= mu c_n``, dissipation: where s = T d is
    not 0, ``c_t = -mu c_n s / |s|``, balance ``sum (c_n N + c_t T) + w = 0``.

    Args:
        edges: of friction pyramids; none for cones, in space round ones.
    """
    total = list(wrench)
    for i, (contact, (normal, *friction)) in enumerate(zip(grasp, forces, strict=True), 1):
        wrenches = frame(contact)
        along, *slip = (_dot(row, motion) for row in wrenches)
        spring = max(Fraction(0), contact.preload - contact.stiffness * along)
        if normal != spring:
            return f"contact {i}: normal force {short(normal)}, its spring gives {short(spring)}"
        limit = contact.friction * normal
        given = f"contact {i}: friction {_shown(friction)} of at most {short(limit)}"
        if not _in_cone(friction, limit, edges):
            return given
        if not _does_most(friction, slip, limit, edges):
            return f"{given} while it slips by {_shown(slip)}"
        for force, row in zip((normal, *friction), wrenches, strict=True):
            total = [w + force * x for w, x in zip(total, row, strict=True)]
    return f"the forces add up to {_shown(total)}, not 0" if any(total) else ""


def _in_cone(
    friction: Sequence[Fraction], limit: Fraction, edges: Sequence[RationalVector]
) -> bool:
    """Return whether a friction force is in the disc, or in the polygon of the edges."""
    if not edges:
        return _dot(friction, friction) <= limit * limit
    sides = zip(outward(edges), edges, strict=True)
    return all(_dot(normal, friction) <= limit * _dot(normal, edge) for normal, edge in sides)


def outward(edges: Sequence[RationalVector]) -> list[RationalVector]:
    """Return for each edge the outward normal of the side of the polygon that starts there."""
    nexts = (*edges[1:], edges[0])
    return [(a + c, b + d) for (a, b), (c, d) in zip(edges, nexts, strict=True)]


def _does_most(
    friction: Sequence[Fraction],
    slip: Sequence[Fraction],
    limit: Fraction,
    edges: Sequence[RationalVector],
) -> bool:
    """Return whether no friction force of the cone does less work on a slip.

    In the disc that is ``-limit |s|``, done by one force alone; by all where there is no slip.
    """
    work = _dot(friction, slip)
    if edges:
        return work == -limit * max(_dot(edge, slip) for edge in edges)
    return work <= 0 and work * work == limit * limit * _dot(slip, slip)


def range_problem(within: Range, motion: RationalVector, forces: Sequence[RationalVector]) -> str:
    """Return which bound of the range a motion and forces (normal first) break, or nothing."""
    turns = tuple(turns_of(motion))
    turn, force = within.largest_turn, within.largest_force
    if turn is not None and _dot(turns, turns) > turn * turn:
        return f"the motion turns by more than the largest turn {short(turn)}"
    for i, (normal, *_) in enumerate(forces, 1):
        if force is not None and normal > force:
            return f"contact {i}: normal force {short(normal)}, the largest one is {short(force)}"
    return ""


def range_work(
    within: Range, turn: RationalVector, forces: Mapping[int, Fraction]
) -> tuple[str, Fraction]:
    """Return what the bounds take from the work of a leaf, for a motion with ``d_0 = 1``.

    In the range ``v Q - u . r >= 0`` for the rotation r if ``v >= |u|``, and ``rho (F - c_n) >= 0``
    if ``rho >= 0``. So they take ``v Q`` and all ``rho F``, and give ``u . r``, and rho more for
    each unit of a normal force. First comes what is wrong with them, if anything.
    """
    taken = Fraction(0)
    if turn:
        v, u = turn[0], turn[1:]
        if within.largest_turn is None:
            return "the question has no largest turn", taken
        if v < 0 or v * v < _dot(u, u):
            return "turn: v must be at least |u|", taken
        taken += v * within.largest_turn
    for i, rho in forces.items():
        if within.largest_force is None:
            return "the question has no largest force", taken
        if rho < 0:
            return f"contact {i + 1}: rho must be at least 0", taken
        taken += rho * within.largest_force
    return "", taken


def short(value: Fraction | int) -> str:
    """Return a rational for a message."""
    return number_text(value, digits=30, longest=60)


def _shown(values: Sequence[Fraction]) -> str:
    """Return one number, or more in parentheses, for a message."""
    return short(*values) if len(values) == 1 else f"({', '.join(map(short, values))})"


def _dot(left: Sequence[Fraction], right: Sequence[Fraction]) -> Fraction:
    return sum((a * b for a, b in zip(left, right, strict=True)), Fraction(0))
