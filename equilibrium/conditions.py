"""The conditions of equilibrium as the checker of certificates sees them.

Written a second time on purpose, from the contact data alone: the checker must not inherit a
mistake of the solver. Nothing here is used by the solver, and nothing of the solver is used here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TypeAlias

from arrangement.exact import RationalVector

from .grasp import Contact, Grasp

#: A linear form: coefficients by name of the unknown; the constant has the name "1".
Form: TypeAlias = dict[str, Fraction]
Forces: TypeAlias = Sequence[Sequence[Fraction]]

_MOTION = ("x", "y", "r")
_AXES = ("force x", "force y", "torque")


def _moments(contact: Contact) -> tuple[RationalVector, RationalVector]:
    """Return the wrenches of a unit normal and a unit tangential force."""
    (px, py), (nx, ny) = contact.point, contact.normal
    return (nx, ny, px * ny - py * nx), (-ny, nx, px * nx + py * ny)


def motion_planes(grasp: Grasp) -> tuple[list[RationalVector], list[Fraction]]:
    """Return the planes ``T . d = 0``, then ``stiffness N . d = preload``: normals and offsets."""
    wrenches = [_moments(contact) for contact in grasp]
    springs = [
        tuple(contact.stiffness * x for x in along_normal)
        for contact, (along_normal, _) in zip(grasp, wrenches, strict=True)
    ]
    normals = [along_tangent for _, along_tangent in wrenches] + springs
    return normals, [Fraction(0)] * len(grasp) + [contact.preload for contact in grasp]


def label_of(signs: Sequence[int]) -> tuple[str, ...]:
    """Return the contact states of a sign vector over the planes of `motion_planes`."""
    half = len(signs) // 2
    return tuple(
        "detached" if gap >= 0 else {1: "slip+", 0: "stick", -1: "slip-"}[slip]
        for slip, gap in zip(signs[:half], signs[half:], strict=True)
    )


@dataclass(frozen=True)
class Conditions:
    """The four conditions for a motion and forces."""

    grasp: Grasp
    wrench: RationalVector

    def problems(self, motion: RationalVector, forces: Forces) -> dict[str, str]:
        """Return, for each condition by name, what is wrong with it (empty when it holds)."""
        contacts = [
            (i, contact, *_moments(contact), c_n, c_t)
            for i, (contact, (c_n, c_t)) in enumerate(zip(self.grasp, forces, strict=True))
        ]
        names = ("balance", "spring", "cone", "dissipation")
        found = dict.fromkeys(names, "")
        for axis, name in enumerate(_AXES):
            total = self.wrench[axis] + sum(
                c_n * along_n[axis] + c_t * along_t[axis]
                for _, _, along_n, along_t, c_n, c_t in contacts
            )
            if total:
                found["balance"] = f"the sum of {name} is {total}, not 0"
        for i, contact, along_n, along_t, c_n, c_t in contacts:
            gap = sum(a * b for a, b in zip(along_n, motion, strict=True))
            slip = sum(a * b for a, b in zip(along_t, motion, strict=True))
            due = max(Fraction(0), contact.preload - contact.stiffness * gap)
            limit = contact.friction * c_n
            if c_n != due:
                found["spring"] = f"contact {i} has normal force {c_n}, its spring gives {due}"
            if abs(c_t) > limit:
                found["cone"] = f"contact {i} has tangential force {c_t}, its limit is {limit}"
            if (slip > 0 and c_t != -limit) or (slip < 0 and c_t != limit):
                found["dissipation"] = f"contact {i} slips by {slip} and has {c_t} of {limit}"
        return found


@dataclass
class StateConditions:
    """The linear conditions of one choice of contact states."""

    equalities: list[Form] = field(default_factory=list)
    inequalities: list[Form] = field(default_factory=list)

    def refutation_problem(self, y: RationalVector, x: RationalVector) -> str:
        """Return what is wrong with multipliers that should combine the conditions to -1.

        A multiplier of a condition that is ``0 = 0`` or ``0 >= 0`` has to be zero, so that every
        number of a refutation matters.
        """
        if len(y) != len(self.inequalities) or len(x) != len(self.equalities):
            return f"{len(self.inequalities)} and {len(self.equalities)} multipliers are due"
        if any(multiplier < 0 for multiplier in y):
            return "a multiplier of an inequality is negative"
        total: Form = {}
        for multiplier, form in [*zip(y, self.inequalities), *zip(x, self.equalities)]:  # noqa: B905
            if multiplier and not any(form.values()):
                return "an empty condition has a multiplier"
            _add(total, form, multiplier)
        if total.pop("1", 0) != -1:
            return "the constants do not add up to -1"
        left = [name for name, coefficient in total.items() if coefficient]
        return f"the unknown {left[0]} does not cancel" if left else ""


def conditions_of(grasp: Grasp, wrench: RationalVector, states: Sequence[str]) -> StateConditions:
    """Return the conditions of a choice of states, in the order the certificate documents."""
    system = StateConditions()
    balance: list[Form] = [{"1": component} for component in wrench]
    sticking: list[Form] = []
    for i, (contact, state) in enumerate(zip(grasp, states, strict=True)):
        along_normal, along_tangent = _moments(contact)
        gap = {name: contact.stiffness * c for name, c in zip(_MOTION, along_normal, strict=True)}
        gap["1"] = -contact.preload
        slip = dict(zip(_MOTION, along_tangent, strict=True))
        if state == "detached":
            system.inequalities.append(gap)
            continue
        normal = _times(gap, Fraction(-1))
        system.inequalities.append(normal)
        tangential = {f"tangential force {i}": Fraction(1)}
        if state == "stick":
            sticking.append(slip)
            system.inequalities += list(_cone(normal, tangential, contact.friction))
        else:
            side = Fraction(1 if state == "slip+" else -1)
            system.inequalities.append(_times(slip, side))
            tangential = _times(normal, -side * contact.friction)
        for form, n, t in zip(balance, along_normal, along_tangent, strict=True):
            _add(form, normal, n)
            _add(form, tangential, t)
    system.equalities = [*balance, *sticking]
    return system


def _cone(normal: Form, tangential: Form, friction: Fraction) -> Iterator[Form]:
    """Yield ``friction c_n - c_t`` and ``friction c_n + c_t``."""
    for sign in (-1, 1):
        form = _times(normal, friction)
        _add(form, tangential, Fraction(sign))
        yield form


def _times(form: Form, factor: Fraction) -> Form:
    return {name: factor * coefficient for name, coefficient in form.items()}


def _add(total: Form, form: Form, factor: Fraction) -> None:
    for name, coefficient in form.items():
        total[name] = total.get(name, Fraction(0)) + factor * coefficient
