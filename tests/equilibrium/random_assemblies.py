"""Random assemblies, some of them at the boundary of what is resisted."""

import random
from fractions import Fraction
from typing import Any

from proofs_check.routes.bodies import body_rows

NORMALS = ((1, 0), (0, 1), (-1, 0), (0, -1), ("3/5", "4/5"), ("-4/5", "3/5"), ("5/13", "-12/13"))


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


def _balancing(
    rng: random.Random, names: list[str], contacts: list[dict[str, Any]]
) -> list[Fraction]:
    """What balances forces that obey the law, at a random motion or at none."""
    n = 3 * len(names)
    still = rng.random() < 0.3
    motion = [Fraction(0) if still else Fraction(rng.randint(-2, 2), 2) for _ in range(n)]
    total = [Fraction(0)] * n
    for contact in contacts:
        normal, tangent, mu, k, q = body_rows(contact, names, n)
        slip, moved = (sum(map(Fraction.__mul__, row, motion)) for row in (tangent, normal))
        pressed = max(Fraction(0), q - k * moved)
        share = Fraction(rng.randint(-2, 2), 2) if not slip else Fraction(-1 if slip > 0 else 1)
        total = [
            z - pressed * (a + mu * share * b)
            for z, a, b in zip(total, normal, tangent, strict=True)
        ]
    return total
