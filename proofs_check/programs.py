"""The paper's systems as it sets them up, in 3 + 2m unknowns, by exact linear programs.

One route of the claims on the printed equations; the other is `oracle`. The unknowns are the
motion and both force components of each contact, as in the section "Solution for a particular
slip state"; wrenches come from the grasp, and the simplex method decides.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import product

from arrangement.linprog import Infeasible, feasible_point
from arrangement.published import published_enumeration
from equilibrium.grasp import Contact, Grasp

from .oracle import Reading

States = tuple[str, ...]
_SLIP = {1: "slip+", -1: "slip-", 0: "stick"}


def listed_states(grasp: Grasp, *, detachment: bool, all_stick: bool) -> tuple[States, ...]:
    """Return the slip states of the published Steps 1 to 3, coincident planes merged.

    Args:
        grasp: its tangential planes are enumerated.
        detachment: let any of the contacts be detached instead.
        all_stick: add the state in which every contact sticks, if the steps leave it out.
    """
    signs = published_enumeration(grasp.tangential_arrangement(), merge=True).distinct_states
    slips = [tuple(_SLIP[s] for s in state) for state in signs]
    if all_stick:
        slips.append(("stick",) * len(grasp))
    if detachment:
        choices = (product(*((state, "detached") for state in states)) for states in slips)
        slips = [states for chosen in choices for states in chosen]
    return tuple(dict.fromkeys(slips))


def stable(
    grasp: Grasp, wrench: Sequence[Fraction], reading: Reading, states: Iterable[Sequence[str]]
) -> bool:
    """Return whether the system of some of the given states has a solution."""
    return any(_solvable(grasp, wrench, reading, chosen) for chosen in states)


def _solvable(
    grasp: Grasp, wrench: Sequence[Fraction], reading: Reading, states: Sequence[str]
) -> bool:
    m = len(grasp)
    size = 3 + 2 * m
    balance = [[*([Fraction(0)] * size), wrench[j]] for j in range(3)]
    equalities: list[list[Fraction]] = balance
    inequalities: list[list[Fraction]] = []
    for i, (contact, state) in enumerate(zip(grasp, states, strict=True)):
        normal, tangential = 3 + i, 3 + m + i
        for j in range(3):
            balance[j][normal] = contact.normal_wrench[j]
            balance[j][tangential] = contact.tangential_wrench[j]
        equal, at_least = _contact(contact, state, reading, normal, tangential, size)
        equalities = equalities + equal
        inequalities += at_least
    return not isinstance(feasible_point(size, inequalities, equalities), Infeasible)


def _contact(
    contact: Contact, state: str, reading: Reading, normal: int, tangential: int, size: int
) -> tuple[list[list[Fraction]], list[list[Fraction]]]:
    """Return the equalities and inequalities of one contact in one state."""
    preload = contact.preload if reading.preload else Fraction(0)
    stretch = _row(size, dict(enumerate(contact.normal_wrench)), Fraction(0))
    excess = [contact.stiffness * x for x in stretch]
    excess[-1] -= preload
    force = _row(size, {normal: Fraction(1)}, Fraction(0))
    if state == "detached":
        return [force, _row(size, {tangential: Fraction(1)}, Fraction(0))], [excess]
    spring = [a + b for a, b in zip(force, excess, strict=True)]
    slip = _row(size, dict(enumerate(contact.tangential_wrench)), Fraction(0))
    if state == "stick":
        cone = [
            _row(size, {normal: contact.friction, tangential: Fraction(way)}, Fraction(0))
            for way in (1, -1)
        ]
        return [spring, slip], [force, *cone]
    way = 1 if state == "slip+" else -1
    against = way if reading.friction_opposes else -way
    edge = {tangential: Fraction(1), normal: against * contact.friction}
    cell = [[way * x for x in slip]] if reading.cell_check else []
    return [spring, _row(size, edge, Fraction(0))], [force, *cell]


def _row(size: int, entries: dict[int, Fraction], constant: Fraction) -> list[Fraction]:
    row = [Fraction(0)] * size + [constant]
    for column, value in entries.items():
        row[column] = value
    return row
