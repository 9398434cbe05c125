"""Several bodies by brute force: each choice of contact states decided by elimination.

It shares no code with `equilibrium`: its rows are written here, from the plain numbers of a
document, and `oracle` eliminates.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from .oracle import project


def resisted(
    document: Mapping[str, Any],
    wrench: Mapping[str, Sequence[Any]],
    max_displacement: Fraction | None = None,
) -> bool:
    """Return whether some motion and forces obey the law, tried for each of up to 4^m states.

    Args:
        document: bodies and contacts.
        wrench: on bodies, by name; zero where none is given.
        max_displacement: of bodies relative to each other at a contact, for a motion to count.
    """
    names, contacts = document["bodies"], document["contacts"]
    n = 3 * len(names)
    rows = [body_rows(contact, names, n) for contact in contacts]
    # In integers: N and T times one number, forces times another, friction times a third.
    arm = _common(x for normal, tangent, *_ in rows for x in (*normal, *tangent))
    load = [Fraction(x) for name in names for x in wrench.get(name, (0, 0, 0))]
    rub = _common(mu for *_, mu, _, _ in rows)
    force = _common(
        [*(x * arm * rub for x in load), *(x for *_, k, q in rows for x in (k / arm, q))]
    )
    lines: list[tuple[Any, ...]] = []
    for normal, tangent, mu, k, q in rows:
        spring = [int(x) for x in (*(-k * x * force for x in normal), q * force)]
        arms = ([int(x * arm) for x in row] for row in (normal, tangent))
        lines.append((spring, *arms, int(mu * rub)))
    whole = [int(x * arm * force * rub) for x in load]
    ways = [
        ("detached", "slip+", "slip-", "stick") if mu else ("detached", "free") for *_, mu in lines
    ]
    bounds = [
        (*(sign * x * most.denominator for x in row), most.numerator * arm)
        for most in ([] if max_displacement is None else [max_displacement])
        for _, normal, tangent, _ in lines
        for row in (normal, tangent)
        for sign in (1, -1)
    ]
    return any(_holds(lines, states, whole, n, rub, bounds) for states in product(*ways))


def _common(numbers: Iterable[Fraction]) -> int:
    return math.lcm(*(x.denominator for x in numbers))


def body_rows(contact: Mapping[str, Any], names: Sequence[str], n: int) -> tuple[Any, ...]:
    """Return N and T in the numbers of all bodies; friction, stiffness and preload."""
    (x, y), (p, q) = (map(Fraction, contact[key]) for key in ("point", "normal"))
    rows = []
    for u, v in ((p, q), (-q, p)):
        row = [Fraction(0)] * n
        for name, sign in ((contact["body_a"], 1), (contact["body_b"], -1)):
            if name is not None:
                k = 3 * names.index(name)
                row[k : k + 3] = sign * u, sign * v, sign * (x * v - y * u)
        rows.append(row)
    values = [Fraction(contact.get(key, 1)) for key in ("friction", "stiffness")]
    return (*rows, *values, Fraction(contact.get("preload", 0)))


def _holds(
    lines: Sequence[Any],
    states: Sequence[str],
    load: list[int],
    n: int,
    rub: int,
    bounds: Sequence[tuple[int, ...]],
) -> bool:
    """Return whether one choice of states has a solution.

    Each sticking contact has an unknown besides the motion.
    """
    size = n + states.count("stick")
    equal: list[Any] = []
    least: list[Any] = [(*row[:-1], *[0] * (size - n), row[-1]) for row in bounds]
    balance = [[0] * size + [w] for w in load]
    extra = iter(range(n, size))
    zeros = [0] * (size - n)
    for (spring, normal, tangent, mu), state in zip(lines, states, strict=True):
        pressed = (*spring[:-1], *zeros, spring[-1])
        if state == "detached":
            least.append(tuple(-x for x in pressed))
            continue
        least.append(pressed)
        slip = (*tangent, *zeros, 0)
        if state == "stick":
            unknown = next(extra)
            equal.append(slip)
            for sign in (rub, -rub):
                row = [mu * x for x in pressed]
                row[unknown] += sign
                least.append(tuple(row))
            for row, b in zip(balance, tangent, strict=True):
                row[unknown] += rub * b
        elif state != "free":
            sign = 1 if state == "slip+" else -1
            mu *= -sign
            least.append(tuple(sign * x for x in slip))
        else:
            mu = 0
        for row, a, b in zip(balance, normal, tangent, strict=True):
            factor = rub * a + (0 if state == "stick" else mu * b)
            if factor:
                row[:] = [z + factor * x for z, x in zip(row, pressed, strict=True)]
    return project([*equal, *balance], least, keep=-1) is not None
