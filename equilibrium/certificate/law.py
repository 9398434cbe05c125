"""The law of contacts, evaluated at a motion and forces.

Written a second time on purpose, from the contact data alone: the checker must not inherit a
mistake of the solver.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from arrangement.exact import RationalVector, number_text
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp


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


def short(value: Fraction | int) -> str:
    """Return a rational for a message."""
    return number_text(value, digits=30, longest=60)


def _dot(left: RationalVector, right: RationalVector) -> Fraction:
    return sum((a * b for a, b in zip(left, right, strict=True)), Fraction(0))
