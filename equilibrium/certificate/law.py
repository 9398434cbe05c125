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


def unit_wrenches(contact: Contact) -> tuple[RationalVector, RationalVector]:
    """Return the wrenches N and T of unit forces along the normal and the tangent."""
    (x, y), (nx, ny) = contact.point, contact.normal
    return (nx, ny, x * ny - y * nx), (-ny, nx, x * nx + y * ny)


def law_problem(
    grasp: Grasp, wrench: RationalVector, motion: RationalVector, forces: Sequence[RationalVector]
) -> str:
    """Return what is wrong with a motion and forces (normal, tangential); empty if they obey.

    Spring ``c_n = max(0, q - k N . d)``, cone ``|c_t| <= mu c_n``, dissipation ``c_t = -mu c_n``
    where ``T . d > 0`` and ``mu c_n`` where ``T . d < 0``, balance ``sum (c_n N + c_t T) + w = 0``.
    """
    total = list(wrench)
    for i, (contact, (normal, tangential)) in enumerate(zip(grasp, forces, strict=True), 1):
        along_normal, along_tangent = unit_wrenches(contact)
        spring = max(Fraction(0), contact.preload - contact.stiffness * _dot(along_normal, motion))
        slip, limit = _dot(along_tangent, motion), contact.friction * normal
        if normal != spring:
            return f"contact {i}: normal force {short(normal)}, its spring gives {short(spring)}"
        given = f"contact {i}: friction {short(tangential)} of at most {short(limit)}"
        if abs(tangential) > limit:
            return given
        if slip and tangential != (-limit if slip > 0 else limit):
            return f"{given} while it slips by {short(slip)}"
        wrenches = zip(total, along_normal, along_tangent, strict=True)
        total = [w + normal * n + tangential * t for w, n, t in wrenches]
    return "" if not any(total) else f"the forces add up to ({', '.join(map(short, total))}), not 0"


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


def _dot(left: RationalVector, right: RationalVector) -> Fraction:
    return sum((a * b for a, b in zip(left, right, strict=True)), Fraction(0))
