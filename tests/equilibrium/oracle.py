"""Brute force that can afford five contacts: each of the 4^m contact states, decided exactly.

It shares no code with `equilibrium` and knows nothing of arrangements: no state is ruled out
beforehand. The conditions of each choice of states are those of the claims' second route. That
there is no solution is found by elimination; that there is one also by an exact linear program,
whose point is given.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

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
    united,
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
    return any(True for _ in solutions(grasp, wrench, bound, displacement))


def intervals(
    grasp: Grasp, direction: Sequence[Fraction], base: Sequence[Fraction]
) -> tuple[Interval, ...]:
    """Return all t >= 0 with base + t direction resisted, by exact linear programs."""
    question = asked(grasp, direction)
    systems = Systems(question, scaled=True)
    n = systems.size - 1
    scale = next(
        row[-2] / Fraction(x) for row, x in zip(systems.wrench, direction, strict=True) if x
    )
    factor = [0] * (n - 1) + [1]
    found = []
    for states in all_states(question):
        equal, least = systems.rows(states)
        *others, x, y, torque = equal
        balance = zip((x, y, torque), base, strict=True)
        equal = [*others, *((*row[:-1], row[-1] + scale * b) for row, b in balance)]
        rows = [*least, (*factor, 0)]
        low = programs.minimize(factor, rows, equal)
        if not isinstance(low, programs.Infeasible):
            high = programs.minimize([-x for x in factor], rows, equal)
            found.append((low.value, None if isinstance(high, programs.Unbounded) else -high.value))
    return united(found)


def satisfies(grasp: Grasp, wrench: tuple, motion: tuple, forces: tuple) -> bool:
    """Return whether the four conditions hold, straight from their definition."""
    return not violations(asked(grasp, wrench), motion, forces)
