"""Brute force that can afford five contacts: each of the 4^m contact states, decided exactly.

It shares no code with `equilibrium` and knows nothing of arrangements: no state is ruled out
beforehand. The conditions of each choice of states are those of the claims' second route. Whether
there is a solution is found by elimination; a point of the solutions by an exact linear program.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from arrangement.numbers.linear import programs
from equilibrium import Grasp
from proofs_check.instances.domains import contact_numbers
from proofs_check.routes.oracle import (
    Interval,
    Question,
    Systems,
    all_states,
    dot,
    project,
    union,
    violations,
)

Vector = tuple[Fraction, ...]


@dataclass(frozen=True)
class Solution:
    """One solution of the conditions of one choice of states."""

    states: tuple[str, ...]
    motion: Vector
    forces: tuple[tuple[Fraction, Fraction], ...]


def asked(grasp: Grasp, wrench: Sequence[Fraction | int]) -> Question:
    return Question(tuple(map(contact_numbers, grasp)), tuple(map(Fraction, wrench)))


def solutions(
    grasp: Grasp,
    wrench: Sequence[Fraction],
    bound: Fraction | int | None = None,
    displacement: Fraction | int | None = None,
) -> Iterator[Solution]:
    """Yield one solution for each choice of states that has any.

    With a bound, only motions whose three components are at most that large count; with a largest
    displacement, those that move each contact point by at most that along normal and tangent.
    """
    question = asked(grasp, wrench)
    systems = Systems(question)
    n = systems.size - 1
    units = [tuple(Fraction(int(k == j)) for k in range(n)) for j in range(3)]
    box = [
        (*(side * x for x in unit), Fraction(bound))
        for unit in (units if bound is not None else ())
        for side in (1, -1)
    ]
    if displacement is not None:
        box += [
            (*(side * x for x in wrench_of_one), *[Fraction(0)] * (n - 3), Fraction(displacement))
            for touch in question.touches
            for wrench_of_one in (touch.normal, touch.tangential)
            for side in (1, -1)
        ]
    for states in all_states(question):
        equal, least = systems.rows(states)
        least += box
        if project(equal, least, keep=-1) is not None:
            point = programs.feasible_point(n, least, equal)
            assert not isinstance(point, programs.Infeasible)
            pressed = (
                Fraction(0) if state == "detached"
                else touch.preload - touch.stiffness * dot(touch.normal, point[:3])
                for touch, state in zip(question.touches, states, strict=True)
            )  # fmt: skip
            yield Solution(states, point[:3], tuple(zip(pressed, point[3:], strict=True)))


def is_stable(
    grasp: Grasp,
    wrench: Sequence[Fraction],
    bound: Fraction | int | None = None,
    displacement: Fraction | int | None = None,
) -> bool:
    """Return whether some choice of states has a solution; see `solutions` for the bounds."""
    if bound is not None:
        return any(True for _ in solutions(grasp, wrench, bound, displacement))
    systems = _systems(grasp)
    applied = systems.applied(wrench)
    more = [] if displacement is None else systems.moved_by_at_most(Fraction(displacement))
    for states in all_states(systems.question):
        equal, least = systems.rows(states, applied)
        rows = _in_free_variables(equal, [*least, *more], systems.size)
        if rows is not None and _feasible(rows[1]):
            return True
    return False


def intervals(
    grasp: Grasp, direction: Sequence[Fraction], base: Sequence[Fraction]
) -> tuple[Interval, ...]:
    """Return all t >= 0 with base + t direction resisted; t is the last variable."""
    systems = _systems(grasp)
    applied = systems.applied(direction, base)
    positive = (*[0] * systems.size, 1, 0)
    found = []
    for states in all_states(systems.question):
        equal, least = systems.rows(states, applied)
        least.append(positive)
        solved = _in_free_variables(equal, least, systems.size + 1)
        if solved is None:
            continue
        free, rows = solved
        if free != [systems.size]:
            rows = project(equal, least, keep=systems.size)
        if rows is not None:
            found += _interval(rows)
    return union(found)


def _interval(rows: Iterable[Sequence[int]]) -> list[Interval]:
    """Return the numbers t with ``a t + c >= 0`` for all rows (..., a, c), as an interval or none.

    One row says that t is at least 0.
    """
    low, high = Fraction(0), None
    for *_, a, c in rows:
        if a > 0:
            low = max(low, Fraction(-c, a))
        elif a:
            high = Fraction(c, -a) if high is None else min(high, Fraction(c, -a))
        elif c < 0:
            return []
    return [(low, high)] if high is None or low <= high else []


class _WholeSystems:
    """The systems of one grasp in integers, for any wrench.

    The variables are the motion, then the tangential force of each contact.
    """

    def __init__(self, grasp: Grasp) -> None:
        self.question = asked(grasp, (1, 1, 1))
        systems = Systems(self.question)
        self.size = systems.size - 1
        self.still = (0,) * systems.size
        self.scale = systems.wrench[0][-1]
        self.parts = [
            {
                state: (whole(part.equality), list(map(whole, part.inequalities)), part.force)
                for state, part in states.items()
            }
            for states in systems.parts
        ]

    def rows(
        self, states: Sequence[str], applied: Sequence[Sequence[int]]
    ) -> tuple[list[Sequence[int]], list[Sequence[int]]]:
        """Return equalities and inequalities, with what `applied` gave last."""
        more = len(applied[0]) - self.size - 1
        chosen = [part[state] for part, state in zip(self.parts, states, strict=True)]
        equal = [_wider(row, more) for row, _, _ in chosen]
        least = [_wider(row, more) for _, rows, _ in chosen for row in rows]
        forces = [force for *_, force in chosen if force]
        for j, load in enumerate(applied):
            shared = map(sum, zip(*(force[j] for force in forces), self.still, strict=True))
            row = _wider(list(shared), more)
            equal.append([self.unit * x + y for x, y in zip(row, load, strict=True)])
        return equal, least

    def applied(self, *wrenches: Sequence[Fraction | int]) -> list[list[int]]:
        """Return the columns of wrenches in each row of balance, the last one constant."""
        self.unit = math.lcm(*[Fraction(x).denominator for wrench in wrenches for x in wrench])
        scale = self.scale * self.unit
        return [
            [0] * self.size + [int(scale * Fraction(x)) for x in row]
            for row in zip(*wrenches, strict=True)
        ]

    def moved_by_at_most(self, most: Fraction) -> list[Sequence[int]]:
        """Return inequalities: each point moves at most so far along normal and tangent."""
        sides = (
            (row, side)
            for c in self.question.touches
            for row in (c.normal, c.tangential)
            for side in (1, -1)
        )
        friction = (0,) * (self.size - 3)
        return [whole([*(side * x for x in row), *friction, most]) for row, side in sides]


@lru_cache(maxsize=8)
def _systems(grasp: Grasp) -> _WholeSystems:
    return _WholeSystems(grasp)


def whole(row: Sequence[Fraction | int]) -> tuple[int, ...]:
    """Return a positive multiple in integers."""
    scale = math.lcm(*[x.denominator for x in row])
    return tuple([int(x * scale) for x in row])


def _wider(row: Sequence[int], more: int) -> tuple[int, ...]:
    """Return a row with further variables, of coefficient 0."""
    return (*row[:-1], *(0,) * more, row[-1])


def _in_free_variables(
    equal: Sequence[Sequence[int]], least: Sequence[Sequence[int]], n: int
) -> tuple[list[int], list[list[int]]] | None:
    """Solve equalities for as many variables as can be, the first ones.

    Fraction-free Gauss-Jordan elimination.

    Returns:
        The variables left, and the inequalities in them; None when equalities contradict.
    """
    rows, pivots, last = [list(row) for row in equal], list[int](), 1
    for j in range(n):
        r = len(pivots)
        k = next((k for k in range(r, len(rows)) if rows[k][j]), None)
        if k is None:
            continue
        rows[r], rows[k] = rows[k], rows[r]
        row, p = rows[r], rows[r][j]
        for i, other in enumerate(rows):
            if i != r:
                f = other[j]
                rows[i] = [(p * x - f * y) // last for x, y in zip(other, row, strict=True)]
        last = p
        pivots.append(j)
    if any(row[-1] for row in rows[len(pivots) :]):
        return None
    free = [j for j in range(n) if j not in pivots]
    sign = 1 if last > 0 else -1
    solved = list(zip(pivots, rows, strict=False))
    return free, [
        [sign * (last * row[j] - sum(row[k] * known[j] for k, known in solved)) for j in (*free, n)]
        for row in least
    ]


def _feasible(rows: list[list[int]]) -> bool:
    """Return whether inequalities have a solution."""
    if not rows or len(rows[0]) == 1:
        return all(row[-1] >= 0 for row in rows)
    return project([], rows, keep=-1) is not None


def satisfies(grasp: Grasp, wrench: tuple, motion: tuple, forces: tuple) -> bool:
    """Return whether the four conditions hold, straight from their definition."""
    return not violations(asked(grasp, wrench), motion, forces)
