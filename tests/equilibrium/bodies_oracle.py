"""Several bodies by brute force: each choice of contact states decided by elimination.

It shares no code with `equilibrium`: its rows are written here, from the plain numbers of a
document, and what is eliminated stands in `proofs_check.routes.oracle`.
"""

import math
import random
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from proofs_check.routes.oracle import project

Row = list[Fraction]
NORMALS = ((1, 0), (0, 1), (-1, 0), (0, -1), ("3/5", "4/5"), ("-4/5", "3/5"), ("5/13", "-12/13"))


def resisted(document: Mapping[str, Any], wrench: Mapping[str, Sequence[Any]]) -> bool:
    """Whether some motion and forces obey the law, tried for each of up to 4^m states."""
    names, contacts = document["bodies"], document["contacts"]
    n = 3 * len(names)
    rows = [_lines(contact, names, n) for contact in contacts]
    # In integers: N and T times one number, forces times another, friction times a third.
    arm = _common(x for normal, tangent, *_ in rows for x in (*normal, *tangent))
    load = [Fraction(x) for name in names for x in wrench.get(name, (0, 0, 0))]
    rub = _common(mu for *_, mu, _, _ in rows)
    force = _common(
        [*(x * arm * rub for x in load), *(x for *_, k, q in rows for x in (k / arm, q))]
    )
    lines = []
    for normal, tangent, mu, k, q in rows:
        spring = [int(x) for x in (*(-k * x * force for x in normal), q * force)]
        arms = ([int(x * arm) for x in row] for row in (normal, tangent))
        lines.append((spring, *arms, int(mu * rub)))
    whole = [int(x * arm * force * rub) for x in load]
    ways = [
        ("detached", "slip+", "slip-", "stick") if mu else ("detached", "free") for *_, mu in lines
    ]
    return any(_holds(lines, states, whole, n, rub) for states in product(*ways))


def _common(numbers: Iterable[Fraction]) -> int:
    return math.lcm(*(x.denominator for x in numbers))


def _lines(contact: Mapping[str, Any], names: Sequence[str], n: int) -> tuple[Any, ...]:
    """N and T in the numbers of all bodies; friction, stiffness and preload."""
    (x, y), (p, q) = (map(Fraction, contact[key]) for key in ("point", "normal"))
    found = []
    for u, v in ((p, q), (-q, p)):
        row = [Fraction(0)] * n
        for name, sign in ((contact["body_a"], 1), (contact["body_b"], -1)):
            if name is not None:
                k = 3 * names.index(name)
                row[k : k + 3] = sign * u, sign * v, sign * (x * v - y * u)
        found.append(row)
    values = [Fraction(contact.get(key, 1)) for key in ("friction", "stiffness")]
    return (*found, *values, Fraction(contact.get("preload", 0)))


def _holds(lines: Sequence[Any], states: Sequence[str], load: list[int], n: int, rub: int) -> bool:
    """Whether one choice of states has a solution; only sticking contacts have an unknown more."""
    size = n + states.count("stick")
    equal: list[Any] = []
    least: list[Any] = []
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


def random_question(seed: int, most: int = 4) -> tuple[dict[str, Any], dict[str, list[str]]]:
    """A random assembly of 1 to 4 bodies and up to `most` contacts, and wrenches on the bodies.

    Contacts coincide at times, have no friction or no preload, and bodies touch nothing. The
    wrenches balance forces of the law at times, or nearly.
    """
    rng = random.Random(seed)
    names = [f"body {k + 1}" for k in range(rng.randint(1, 4))]
    preload, smooth = rng.random() < 0.5, rng.random() < 0.2
    contacts: list[dict[str, Any]] = []
    for _ in range(rng.randint(1, most)):
        if contacts and rng.random() < 0.1:
            contacts.append(dict(rng.choice(contacts)))
            continue
        a, b = rng.sample([*names, None], 2)
        a, b = (b, a) if a is None else (a, b)
        contacts.append(
            {
                "body_a": a,
                "body_b": b,
                "point": [str(rng.randint(-3, 3)), str(rng.randint(-3, 3))],
                "normal": [str(x) for x in rng.choice(NORMALS)],
                "friction": "0" if smooth else rng.choice(["0", "1/4", "1/2", "1", "2"]),
                "stiffness": rng.choice(["1", "1", "2"]),
                "preload": rng.choice(["0", "1", "1/2"]) if preload else "0",
            }
        )
    load = _balancing(rng, names, contacts) if rng.random() < 0.7 else None
    load = load or [Fraction(rng.randint(-2, 2), rng.choice([1, 2])) for _ in range(3 * len(names))]
    if rng.random() < 0.2:
        load[rng.randrange(len(load))] += Fraction(rng.choice([-1, 1]), rng.choice([1, 10**9]))
    wrench = {name: [str(x) for x in load[3 * k :][:3]] for k, name in enumerate(names)}
    return {"bodies": names, "contacts": contacts}, wrench


def _balancing(rng: random.Random, names: list[str], contacts: list[dict[str, Any]]) -> Row:
    """What balances forces that obey the law, at a random motion or at none."""
    n = 3 * len(names)
    still = rng.random() < 0.3
    motion = [Fraction(0) if still else Fraction(rng.randint(-2, 2), 2) for _ in range(n)]
    total = [Fraction(0)] * n
    for contact in contacts:
        normal, tangent, mu, k, q = _lines(contact, names, n)
        slip, moved = (sum(map(Fraction.__mul__, row, motion)) for row in (tangent, normal))
        pressed = max(Fraction(0), q - k * moved)
        share = Fraction(rng.randint(-2, 2), 2) if not slip else Fraction(-1 if slip > 0 else 1)
        total = [
            z - pressed * (a + mu * share * b)
            for z, a, b in zip(total, normal, tangent, strict=True)
        ]
    return total
