"""The conditions of equilibrium as the checker of certificates sees them.

Written a second time on purpose, from the contact data alone: the checker must not inherit a
mistake of the solver. Nothing here is used by the solver, and nothing of the solver is used here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TypeAlias

from arrangement.exact import RationalVector, primitive
from arrangement.linear import determinant
from equilibrium.model.grasp import Contact, Grasp

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
            if not multiplier:
                continue
            if not any(form.values()):
                return "an empty condition has a multiplier"
            _add(total, form, multiplier)
        if total.pop("1", 0) != -1:
            return "the constants do not add up to -1"
        left = [name for name, coefficient in total.items() if coefficient]
        return f"the unknown {left[0]} does not cancel" if left else ""


def violation_problem(
    grasp: Grasp, wrench: RationalVector, states: Sequence[str], kind: str, contact: int
) -> str:
    """Return what is wrong with the claim that one condition fails at the only solution.

    The conditions are those of `determinants`, here with every number exact: of the
    contacts that stick on one tangential plane only the first has a tangential force, the sum.
    """
    groups: list[list[int]] = []
    for i in (i for i, state in enumerate(states) if state == "stick"):
        tangent = _moments(grasp.contacts[i])[1]
        for group in groups:
            if _parallel(tangent, _moments(grasp.contacts[group[0]])[1]):
                group.append(i)
                break
        else:
            groups.append([i])
    # The named contact comes first in its group: the claim speaks of its tangent.
    groups = [sorted(group, key=lambda i: i != contact) for group in groups]
    first = [group[0] for group in groups]
    equalities, failing = _sums(grasp, wrench, states, first)
    named = next((group for group in groups if contact in group), [])
    form = failing(kind, contact, named)
    unknowns = [*_MOTION, *(f"tangential force {i}" for i in first), "1"]
    rows = [primitive([row.get(name, Fraction(0)) for name in unknowns]) for row in equalities]
    inner = determinant([row[:-1] for row in rows])
    if not inner:
        return "the equalities do not have exactly one solution"
    last = primitive([form.get(name, Fraction(0)) for name in unknowns])
    whole = determinant([*rows, last])
    return "" if (inner > 0) != (whole > 0) and whole else f"the condition {kind} {contact} holds"


def _sums(
    grasp: Grasp, wrench: RationalVector, states: Sequence[str], first: Sequence[int]
) -> tuple[list[Form], Callable[[str, int, Sequence[int]], Form]]:
    """Return the equalities with one tangential force for each plane, and the named conditions."""
    balance: list[Form] = [{"1": component} for component in wrench]
    normals: list[Form] = []
    slips: list[Form] = []
    for i, (contact, state) in enumerate(zip(grasp, states, strict=True)):
        along_normal, along_tangent = _moments(contact)
        slips.append(dict(zip(_MOTION, along_tangent, strict=True)))
        spring = {n: -contact.stiffness * c for n, c in zip(_MOTION, along_normal, strict=True)}
        normals.append({**spring, "1": contact.preload})
        side = {"slip+": -1, "slip-": 1}.get(state, 0)
        for axis, form in enumerate(balance):
            if state != "detached":
                pull = along_normal[axis] + side * contact.friction * along_tangent[axis]
                _add(form, normals[i], pull)
            if i in first:
                form[f"tangential force {i}"] = along_tangent[axis]

    def failing(kind: str, contact: int, group: Sequence[int]) -> Form:
        if kind == "normal":
            return _times(normals[contact], Fraction(-1 if states[contact] == "detached" else 1))
        if kind == "slip":
            return _times(slips[contact], Fraction(1 if states[contact] == "slip+" else -1))
        total = {f"tangential force {contact}": Fraction(-1 if kind == "friction-" else 1)}
        for i in group:
            _add(total, normals[i], grasp.contacts[i].friction)
        return total

    return [*balance, *(slips[i] for i in first)], failing


def _parallel(left: RationalVector, right: RationalVector) -> bool:
    (a, b, c), (d, e, f) = left, right
    return a * e == b * d and b * f == c * e and a * f == c * d


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
