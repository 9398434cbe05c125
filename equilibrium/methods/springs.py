"""What the methods with springs share: forces and balance as linear forms of the motion.

A form in the motion ``d = (x, y, r)`` is a tuple of four rationals, the constant last.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.exact import RationalVector, rational, rational_vector
from arrangement.linprog import Infeasible, Row, feasible_point
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Contact, Grasp

Form: TypeAlias = tuple[Fraction, ...]
Forces: TypeAlias = tuple[tuple[Fraction, Fraction], ...]

ZERO: Form = (Fraction(0),) * 4


def normal_form(contact: Contact) -> Form:
    """Return the force of the normal spring, ``preload - stiffness N . d``."""
    return (*(-contact.stiffness * x for x in contact.normal_wrench), contact.preload)


def tangential_form(contact: Contact, stiffness: Fraction, rest: Fraction) -> Form:
    """Return the force of a tangential spring, ``rest - stiffness T . d``."""
    return (*(-stiffness * x for x in contact.tangential_wrench), rest)


def balance_rows(
    grasp: Grasp, forces: Sequence[tuple[Form, Form]], wrench: RationalVector
) -> list[Row]:
    """Return the three rows ``sum (c_n N + c_t T) + w = 0`` in the motion."""
    rows: list[Row] = []
    for k in range(3):
        row = [Fraction(0)] * 3 + [wrench[k]]
        for contact, (normal, tangential) in zip(grasp, forces, strict=True):
            for form, direction in (
                (normal, contact.normal_wrench[k]),
                (tangential, contact.tangential_wrench[k]),
            ):
                row = [x + direction * y for x, y in zip(row, form, strict=True)]
        rows.append(row)
    return rows


def cone_rows(contact: Contact, normal: Form, tangential: Form) -> list[Row]:
    """Return ``c_n >= 0`` and ``|c_t| <= friction c_n`` as rows."""
    edge = [contact.friction * x for x in normal]
    return [
        normal,
        [a - b for a, b in zip(edge, tangential, strict=True)],
        [a + b for a, b in zip(edge, tangential, strict=True)],
    ]


def value(form: Form, motion: RationalVector) -> Fraction:
    """Return a form at a motion."""
    return sum((a * x for a, x in zip(form, motion, strict=False)), form[-1])


def tangential_stiffnesses(grasp: Grasp, given: Any) -> RationalVector:
    """Return a tangential stiffness for each contact: the normal one times a factor, or as given.

    Raises:
        GraspError: a wrong number of values, or one that is not above 0.
    """
    if isinstance(given, Iterable) and not isinstance(given, str):
        found = rational_vector(given, "tangential_stiffness")
        if len(found) != len(grasp):
            raise GraspError(f"{len(found)} tangential stiffnesses for {len(grasp)} contacts")
    else:
        factor = rational(given, "tangential_stiffness")
        found = tuple(factor * contact.stiffness for contact in grasp)
    for x in found:
        if x <= 0:
            raise GraspError(f"a tangential stiffness is {x}; it must be above 0")
    return found


def rest_forces(grasp: Grasp, given: Iterable[Any] | None) -> RationalVector:
    """Return the tangential force of each contact at d = 0; zeros if left out."""
    found = (Fraction(0),) * len(grasp) if given is None else rational_vector(given, "rest")
    if len(found) != len(grasp):
        raise GraspError(f"{len(found)} rest forces for {len(grasp)} contacts; give one for each")
    return found


def balancing_friction(grasp: Grasp) -> RationalVector | None:
    """Return tangential forces that balance the preloads at d = 0, if the cones allow it.

    Where several do, one corner of the set is returned. A grasp that was closed with its preloads
    and stood still has such forces; None says that no such grasp exists.

    >>> from equilibrium.io.files import read_grasp
    >>> [str(x) for x in balancing_friction(read_grasp("paper-three-contacts-preload-1"))]
    ['-1/2', '0', '1/2']
    """
    m = len(grasp)
    cones: list[Row] = []
    for i, contact in enumerate(grasp):
        for side in (1, -1):
            row = [Fraction(side * int(i == j)) for j in range(m)]
            cones.append([*row, contact.friction * contact.preload])
    balance: list[Row] = []
    for k in range(3):
        preload = sum((c.preload * c.normal_wrench[k] for c in grasp), Fraction(0))
        balance.append([*(c.tangential_wrench[k] for c in grasp), preload])
    point = _zero_or_point(m, cones, balance)
    return None if isinstance(point, Infeasible) else point


def _zero_or_point(m: int, cones: list[Row], balance: list[Row]) -> RationalVector | Infeasible:
    """Prefer no friction at all where that balances."""
    if all(row[-1] == 0 for row in balance):
        return (Fraction(0),) * m
    return feasible_point(m, cones, balance)
