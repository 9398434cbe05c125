"""Brute force on small grasps: every choice of contact states, by Fourier-Motzkin elimination.

This is the second route of the claims on grasps. It shares no code with the solver: it takes
numbers as they stand in a question, writes the model out afresh, and decides each of the 4^m
systems by eliminating variables one at a time, in integers, without any solver. Exact, exponential,
meant for m <= 4. Source of the elimination: A. Schrijver, Theory of Linear and Integer Programming
(1986), section 12.2; at most four variables are left after the equalities are used.

Signs: normals point into the object, the tangent is the normal rotated by +90 degrees, forces act
on the object, and ``forces + wrench = 0``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import Any, TypeAlias

#: Coefficients, then a constant: the linear form ``row . (x, 1)``.
Row: TypeAlias = tuple[Fraction, ...]
#: The same, as coprime integers.
Whole: TypeAlias = tuple[int, ...]


def project(
    equalities: Sequence[Sequence[Fraction | int]], inequalities: Sequence[Row], keep: int
) -> list[Whole] | None:
    """Eliminate all variables but number `keep` (-1 keeps none).

    Returns:
        The inequalities that remain, or None when there is no solution.
    """
    left = [_whole(row) for row in equalities]
    variables = range(len([*left, *inequalities][0]) - 1 if left or inequalities else 0)
    pivots = []
    for j in variables:
        pivot = next((row for row in left if row[j]), None) if j != keep else None
        if pivot is not None:
            left = [_cancel(row, pivot, j) for row in left if row is not pivot]
            pivots.append((j, pivot))
    rows = []
    for inequality in inequalities:
        row = _whole(inequality)
        for j, pivot in pivots:
            row = _cancel(row, pivot, j)
        if any(row[:-1]):
            rows.append(row)
        elif row[-1] < 0:
            return None
    rows += [way for row in left for way in (row, tuple([-x for x in row]))]
    for j in variables:
        if j != keep:
            rows = _eliminate(rows, j)
        if any(row[-1] < 0 and not any(row[:-1]) for row in rows):
            return None
    return [row for row in rows if any(row[:-1])]


def _eliminate(rows: Iterable[Whole], j: int) -> list[Whole]:
    """One step of Fourier-Motzkin elimination; equal rows are kept once."""
    groups: dict[int, list[Whole]] = {-1: [], 0: [], 1: []}
    for row in dict.fromkeys(rows):
        groups[(row[j] > 0) - (row[j] < 0)].append(row)
    pairs = (
        _reduce([a * -down[j] + b * up[j] for a, b in zip(up, down, strict=True)])
        for up, down in product(groups[1], groups[-1])
    )
    return list(dict.fromkeys([*groups[0], *pairs]))


def _cancel(row: Whole, pivot: Whole, j: int) -> Whole:
    """Return a positive multiple of the row minus the multiple of an equality that cancels j."""
    if not row[j]:
        return row
    p, r = abs(pivot[j]), row[j] if pivot[j] > 0 else -row[j]
    return _reduce([a * p - b * r for a, b in zip(row, pivot, strict=True)])


def _whole(row: Sequence[Fraction | int]) -> Whole:
    """Return a positive multiple with coprime integer entries."""
    scale = math.lcm(*[x.denominator for x in row])
    if scale == 1:
        return _reduce([x.numerator for x in row])
    return _reduce([x.numerator * (scale // x.denominator) for x in row])


def _reduce(row: Sequence[int]) -> Whole:
    divisor = math.gcd(*row)
    return tuple(row) if divisor <= 1 else tuple([x // divisor for x in row])


#: A closed interval of the line; None where it is unbounded.
Interval: TypeAlias = tuple[Fraction | None, Fraction | None]

ATTACHED = ("slip+", "slip-", "stick")
STATES = ("detached", *ATTACHED)


@dataclass(frozen=True)
class Touch:
    """One contact in numbers: wrenches of unit forces, stiffness, preload, friction."""

    normal: Row
    tangential: Row
    stiffness: Fraction
    preload: Fraction
    friction: Fraction


@dataclass(frozen=True)
class Question:
    """A grasp under a wrench.

    Attributes:
        contacts: (point x, point y, normal x, normal y, friction, stiffness, preload) of each.
        wrench: (f_x, f_y, tau).
    """

    contacts: tuple[Row, ...]
    wrench: Row

    @cached_property
    def touches(self) -> tuple[Touch, ...]:
        """The contacts with the wrenches of unit forces along their normals and tangents."""
        return tuple(
            Touch((a, b, x * b - y * a), (-b, a, x * a + y * b), k, q, mu)
            for x, y, a, b, mu, k, q in self.contacts
        )

    def to_dict(self) -> dict[str, Any]:
        """Return the file form of the grasp, with the wrench."""
        return {
            "schema_version": 1,
            "contacts": [
                {
                    "point": [str(x), str(y)],
                    "normal": [str(a), str(b)],
                    "friction": str(mu),
                    "stiffness": str(k),
                    "preload": str(q),
                }
                for x, y, a, b, mu, k, q in self.contacts
            ],
            "wrench": [str(x) for x in self.wrench],
        }


@dataclass(frozen=True)
class Reading:
    """Which of the conditions are meant; each one can be taken as the paper prints it.

    Attributes:
        detachment: a contact may let go (printed: the spring equation always holds).
        preload: the spring equation has a preload term (printed: none).
        friction_opposes: slip in + direction gives ``c_t = -mu c_n``. The printed signs, with
            Eqs. 1 and 4 in one frame, come out the other way round.
        cell_check: the motion must slip as the state says (printed: never checked).
    """

    detachment: bool = True
    preload: bool = True
    friction_opposes: bool = True
    cell_check: bool = True

    @property
    def states(self) -> tuple[str, ...]:
        """The states that a contact can be in."""
        return STATES if self.detachment else ATTACHED


MODEL = Reading()


def stable(
    question: Question, reading: Reading = MODEL, states: Iterable[Sequence[str]] | None = None
) -> bool:
    """Return whether some choice of states (all, or the given ones) has a solution."""
    listed = all_states(question, reading) if states is None else states
    systems = Systems(question, reading)
    return any(project(*systems.rows(chosen), keep=-1) is not None for chosen in listed)


def all_states(question: Question, reading: Reading = MODEL) -> Iterable[tuple[str, ...]]:
    """Return every choice of contact states, without regard to rigid motion."""
    return product(reading.states, repeat=len(question.contacts))


def violations(
    question: Question, motion: Sequence[Fraction], forces: Sequence[Sequence[Fraction]]
) -> tuple[str, ...]:
    """Return the conditions of the model that a motion with given forces breaks, by name."""
    broken = []
    total = list(question.wrench)
    for i, (touch, (normal, tangential)) in enumerate(
        zip(question.touches, forces, strict=True), 1
    ):
        spring = touch.preload - touch.stiffness * dot(touch.normal, motion)
        slip = dot(touch.tangential, motion)
        if normal != max(Fraction(0), spring):
            broken.append(f"spring of contact {i}")
        if abs(tangential) > touch.friction * normal:
            broken.append(f"cone of contact {i}")
        if slip and tangential != (-1 if slip > 0 else 1) * touch.friction * normal:
            broken.append(f"dissipation at contact {i}")
        for j in range(3):
            total[j] += normal * touch.normal[j] + tangential * touch.tangential[j]
    if any(total):
        broken.append("balance")
    return tuple(broken)


def resisted(question: Question, reading: Reading = MODEL) -> tuple[Interval, ...]:
    """Return all factors t for which the grasp holds t times the wrench, as closed intervals."""
    intervals = []
    systems = Systems(question, reading, scaled=True)
    for states in all_states(question, reading):
        equalities, inequalities = systems.rows(states)
        kept = 3 + len(question.contacts)
        rows = project(equalities, inequalities, kept)
        interval = None if rows is None else interval_of(rows, kept)
        if interval is not None:
            intervals.append(interval)
    return union(intervals)


def normal_forces(question: Question) -> tuple[tuple[Interval, ...], ...]:
    """Return for every contact all normal forces that occur in equilibria, as closed intervals."""
    m = len(question.contacts)
    forces: list[list[Interval]] = [[] for _ in range(m)]
    systems = Systems(question)
    for states in all_states(question):
        equalities, inequalities = systems.rows(states)
        if project(equalities, inequalities, keep=-1) is None:
            continue
        rows = [(*row[:-1], Fraction(0), row[-1]) for row in inequalities]
        for i, (touch, state) in enumerate(zip(question.touches, states, strict=True)):
            size = 3 + m + 2
            force = _times(_spring(touch, MODEL, size), 0 if state == "detached" else 1)
            named = _plus(force, _times(_unit(3 + m, size), -1))
            known = [(*row[:-1], Fraction(0), row[-1]) for row in equalities]
            remaining = project([*known, named], rows, keep=3 + m)
            interval = None if remaining is None else interval_of(remaining, 3 + m)
            forces[i] += [] if interval is None else [interval]
    return tuple(union(intervals) for intervals in forces)


@dataclass(frozen=True)
class _StateConditions:
    """What one contact in one state adds to a system: conditions, and its three force rows."""

    equality: Row
    inequalities: tuple[Row, ...]
    force: tuple[Sequence[Fraction | int], ...]


class Systems:
    """The linear systems of one question, for every choice of states.

    The variables are the motion, then the tangential force of each contact. With `scaled` there
    is one more, t, after these, and the wrench is t times the given one.
    """

    def __init__(self, question: Question, reading: Reading = MODEL, *, scaled: bool = False):
        self.size = 3 + len(question.contacts) + int(scaled) + 1
        place = -2 if scaled else -1
        unit = _unit(place % self.size, self.size)
        wrench = tuple(_times(unit, x) for x in question.wrench)
        parts = [
            {state: self._part(i, touch, state, reading) for state in reading.states}
            for i, touch in enumerate(question.touches)
        ]
        # Whole numbers: the rows of balance are added up for every choice of states.
        added = [wrench, *(part.force for ways in parts for part in ways.values())]
        scale = math.lcm(*[x.denominator for rows in added for row in rows for x in row])
        self.wrench = _scale(wrench, scale)
        self.parts = [
            {state: replace(part, force=_scale(part.force, scale)) for state, part in ways.items()}
            for ways in parts
        ]

    def rows(self, states: Sequence[str]) -> tuple[list[Sequence[Fraction | int]], list[Row]]:
        """Return equalities, those of the contacts first, and inequalities (``>= 0``)."""
        chosen = [parts[state] for parts, state in zip(self.parts, states, strict=True)]
        equalities: list[Sequence[Fraction | int]] = [part.equality for part in chosen]
        forces = [self.wrench, *(part.force for part in chosen if part.force)]
        equalities += [
            tuple(map(sum, zip(*rows, strict=True))) for rows in zip(*forces, strict=True)
        ]
        return equalities, [row for part in chosen for row in part.inequalities]

    def _part(self, i: int, touch: Touch, state: str, reading: Reading) -> _StateConditions:
        normal = _spring(touch, reading, self.size)
        tangential = _unit(3 + i, self.size)
        if state == "detached":
            return _StateConditions(tangential, (_times(normal, -1),), ())
        slip = (*touch.tangential, *[Fraction(0)] * (self.size - 3))
        equality, bounds = _friction(state, normal, tangential, slip, touch.friction, reading)
        force = tuple(
            _plus(_times(normal, touch.normal[j]), _times(tangential, touch.tangential[j]))
            for j in range(3)
        )
        return _StateConditions(equality, (normal, *bounds), force)


def _friction(
    state: str, normal: Row, tangential: Row, slip: Row, friction: Fraction, reading: Reading
) -> tuple[Row, list[Row]]:
    """Return the equality and the inequalities of friction in one state of an attached contact."""
    limit = _times(normal, friction)
    if state == "stick":
        return slip, [_plus(limit, tangential), _plus(limit, _times(tangential, -1))]
    way = 1 if state == "slip+" else -1
    against = way if reading.friction_opposes else -way
    return _plus(tangential, _times(limit, against)), (
        [_times(slip, way)] if reading.cell_check else []
    )


def _spring(touch: Touch, reading: Reading, size: int) -> Row:
    """Return the normal force ``q - k N . d`` as a linear form."""
    preload = touch.preload if reading.preload else Fraction(0)
    zeros = [Fraction(0)] * (size - 4)
    return (*(-touch.stiffness * x for x in touch.normal), *zeros, preload)


def interval_of(rows: Sequence[Whole], j: int) -> Interval | None:
    """Return the numbers t with ``row[j] t + constant >= 0`` for all rows, or None."""
    low: Fraction | None = None
    high: Fraction | None = None
    for row in rows:
        end = Fraction(-row[-1], row[j])
        if row[j] > 0:
            low = end if low is None else max(low, end)
        else:
            high = end if high is None else min(high, end)
    return None if low is not None and high is not None and low > high else (low, high)


def union(intervals: Iterable[Interval]) -> tuple[Interval, ...]:
    """Return the union as disjoint intervals in increasing order."""
    united: list[Interval] = []
    for low, high in sorted(intervals, key=lambda i: (i[0] is not None, i[0] or 0)):
        if united:
            last = united[-1]
            if last[1] is None or low is None or low <= last[1]:
                top = None if last[1] is None or high is None else max(last[1], high)
                united[-1] = (last[0], top)
                continue
        united.append((low, high))
    return tuple(united)


def dot(left: Sequence[Fraction], right: Sequence[Fraction]) -> Fraction:
    """Return the inner product."""
    return sum((a * b for a, b in zip(left, right, strict=True)), Fraction(0))


def _plus(left: Sequence[Fraction], right: Sequence[Fraction]) -> Row:
    return tuple([a + b if a and b else a or b for a, b in zip(left, right, strict=True)])


def _times(row: Sequence[Fraction], factor: Fraction | int) -> Row:
    return tuple([x * factor if x else x for x in row])


def _scale(rows: Iterable[Sequence[Fraction | int]], scale: int) -> tuple[Whole, ...]:
    return tuple(tuple([int(x * scale) for x in row]) for row in rows)


def _unit(j: int, size: int) -> Row:
    return tuple(Fraction(int(i == j)) for i in range(size))
