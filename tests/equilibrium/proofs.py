"""Whether a certificate is a true proof, decided without the checker of certificates.

Slow and plain: what the checker finds by counting faces is found here by asking, for every choice
of states, whether some motion has it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

from equilibrium import Grasp

from . import bruteforce, oracle

Vector = list[Fraction]
STATES = bruteforce.STATES


def is_true_proof(document: dict[str, Any]) -> bool:
    """Return whether a certificate of readable form proves what it says."""
    grasp, wrench = statement(document)
    if document["certificate"] == "stable":
        forces = tuple(tuple(_fractions(pair)) for pair in document["forces"])
        return oracle.satisfies(grasp, wrench, tuple(_fractions(document["motion"])), forces)
    refuted = set()
    for branch in document["branches"]:
        states = tuple(branch["states"])
        multipliers = (_fractions(branch[key]) for key in ("inequalities", "equalities"))
        if not _refutes(grasp, wrench, states, *multipliers):
            return False
        refuted.add(states)
    return refuted >= possible_states(grasp) and _is_true_list(grasp, document["faces"])


def statement(document: dict[str, Any]) -> tuple[Grasp, tuple[Fraction, ...]]:
    return Grasp.from_dict(document["grasp"]), tuple(_fractions(document["wrench"]))


@cache
def possible_states(grasp: Grasp) -> frozenset[tuple[str, ...]]:
    """Return the states of all motions: detached where no force is, else by the sign of slip.

    A strict system has a solution exactly when its cone does with "at least 1" for "more than 0".
    """
    forms = [_forms(contact) for contact in grasp]
    found = set()
    for states in product(STATES, repeat=len(grasp)):
        equal: list[Vector] = []
        least: list[Vector] = [[*[Fraction(0)] * 3, Fraction(1), Fraction(-1)]]
        for (gap, slip), state in zip(forms, states, strict=True):
            if state == "detached":
                least.append([*gap, Fraction(0)])
                continue
            least.append([*(-g for g in gap), Fraction(-1)])
            if state == "stick":
                equal.append([*slip, Fraction(0), Fraction(0)])
            else:
                sign = 1 if state == "slip+" else -1
                least.append([*(sign * s for s in slip), Fraction(0), Fraction(-1)])
        if _exists(equal, least, 4):
            found.add(states)
    return frozenset(found)


def _exists(equal: list[Vector], least: list[Vector], size: int) -> bool:
    equal = equal or [[Fraction(0)] * (size + 1)]
    rows, limits = ([_whole(row) for row in table] for table in (equal, least))
    return bruteforce._point(rows, limits, size) is not None


def _forms(contact: Any) -> tuple[Vector, Vector]:
    """Return ``stiffness gap - preload`` over (x, y, r, 1), and the slip over (x, y, r)."""
    (px, py), (nx, ny) = contact.point, contact.normal
    gap = [contact.stiffness * g for g in (nx, ny, px * ny - py * nx)]
    return [*gap, -contact.preload], [-ny, nx, px * nx + py * ny]


def _refutes(
    grasp: Grasp, wrench: Sequence[Fraction], states: tuple[str, ...], y: Vector, x: Vector
) -> bool:
    """Whether the multipliers combine the conditions of the states to -1, by substitution.

    A combination of affine functions is -1 everywhere when it is so at 0 and at the unit vectors.
    """
    if any(multiplier < 0 for multiplier in y) or set(states) - set(STATES):
        return False
    sticking = [i for i, state in enumerate(states) if state == "stick"]
    size = 3 + len(sticking)
    for j in range(-1, size):
        point = [Fraction(int(i == j)) for i in range(size)]
        equal, least = _values(grasp, wrench, states, point)
        if len(y) != len(least) or len(x) != len(equal):
            return False
        total = sum(map(math.prod, zip([*y, *x], [*least, *equal], strict=True)))
        if total != -1:
            return False
    return True


def _values(
    grasp: Grasp, wrench: Sequence[Fraction], states: tuple[str, ...], point: Vector
) -> tuple[Vector, Vector]:
    """Return the values of equalities and inequalities at a point, in the documented order."""
    motion, free = point[:3], iter(point[3:])
    balance, sticks, least = list(wrench), [], []
    for contact, state in zip(grasp, states, strict=True):
        gap, slip = _forms(contact)
        normal = -sum((g * d for g, d in zip(gap, motion, strict=False)), gap[3])
        moved = sum((s * d for s, d in zip(slip, motion, strict=True)), Fraction(0))
        if state == "detached":
            least.append(-normal)
            continue
        limit = contact.friction * normal
        if state == "stick":
            tangential = next(free)
            sticks.append(moved)
            least += [normal, limit - tangential, limit + tangential]
        else:
            sign = 1 if state == "slip+" else -1
            tangential = -sign * limit
            least += [normal, sign * moved]
        (px, py), (nx, ny) = contact.point, contact.normal
        fx, fy = normal * nx - tangential * ny, normal * ny + tangential * nx
        balance = [w + f for w, f in zip(balance, (fx, fy, px * fy - py * fx), strict=True)]
    return [*balance, *sticks], least


def _is_true_list(grasp: Grasp, faces: list[dict[str, Any]]) -> bool:
    """Whether the faces have the signs that their witnesses have, and none is listed twice."""
    listed = [face["signs"] for face in faces]
    return len(set(listed)) == len(listed) and all(
        face["signs"] == _signs(grasp, _fractions(face["witness"])) for face in faces
    )


def _signs(grasp: Grasp, motion: Vector) -> str:
    """Return the signs of all slips, then of all ``stiffness gap - preload``."""
    slips, gaps = [], []
    for contact in grasp:
        gap, slip = _forms(contact)
        slips.append(sum(s * d for s, d in zip(slip, motion, strict=True)))
        gaps.append(sum((g * d for g, d in zip(gap, motion, strict=False)), gap[3]))
    return "".join("0" if not v else "+" if v > 0 else "-" for v in (*slips, *gaps))


def _fractions(texts: Iterable[str]) -> Vector:
    return [Fraction(text) for text in texts]


def _whole(row: Vector) -> list[int]:
    scale = math.lcm(*(x.denominator for x in row))
    return [int(scale * x) for x in row]
