"""Whether a certificate is a proof, decided a second time: fractions, recursion, no care for speed.

From the statement of what a leaf shows, for documents of readable form; nothing of the checker is
used. `work_at_motion` goes back behind the rows, to the law itself.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from equilibrium import Grasp
from proofs_check.routes.oracle import Touch, dot

from . import oracle

Vector = list[Fraction]
States = dict[int, str]
#: A leaf with its region and states.
Found = tuple[Any, list[Vector], States]

ORIGIN = [Fraction(1), Fraction(0), Fraction(0), Fraction(0)]


def is_proof(document: dict[str, Any]) -> bool:
    """Return whether a certificate of readable form proves what it says."""
    grasp, wrench = statement(document)
    if document["certificate"] == "resisted":
        forces = tuple(tuple(map(Fraction, pair)) for pair in document["forces"])
        return oracle.satisfies(grasp, wrench, tuple(map(Fraction, document["motion"])), forces)
    return all(leaf_holds(grasp, wrench, *found) for found in leaves(document["tree"]))


def statement(document: dict[str, Any]) -> tuple[Grasp, tuple[Fraction, ...]]:
    return Grasp.from_dict(document["grasp"]), tuple(map(Fraction, document["wrench"]))


def leaves(node: Any, region: list[Vector] | None = None, states: States | None = None) -> Iterator:
    """Yield every leaf of a tree with its region and its states."""
    region, states = region or half_space(), states or {}
    if not isinstance(node, Mapping) or "virtual_motion" in node:
        yield node, region, states
    elif "orthants" in node:
        assert len(region) == 7
        for child, signs in zip(node["orthants"], product((1, -1), repeat=3), strict=True):
            yield from leaves(child, [ORIGIN, *map(axis, (1, 2, 3), signs)], states)
    elif "edge" in node:
        assert len(region) == 4
        (j, k), (p, q) = node["edge"], map(Fraction, node.get("at", "11"))
        sums = [int(p * x + q * y) for x, y in zip(region[j], region[k], strict=True)]
        cut = [Fraction(x, math.gcd(*sums)) for x in sums]
        for child, old in zip(node["children"], (j, k), strict=True):
            yield from leaves(child, [cut if i == old else g for i, g in enumerate(region)], states)
    else:
        assert states.get(node["contact"]) == ("attached" if "slip" in node else None)
        for state, child in (node.get("slip") or node["attachment"]).items():
            yield from leaves(child, region, {**states, node["contact"]: state})


def half_space() -> list[Vector]:
    return [ORIGIN, *(axis(j, sign) for j in (1, 2, 3) for sign in (1, -1))]


def axis(j: int, sign: int) -> Vector:
    return [Fraction(sign * (i == j)) for i in range(4)]


def leaf_holds(
    grasp: Grasp, wrench: Sequence[Fraction], leaf: Any, region: list[Vector], states: States
) -> bool:
    given = leaf["multipliers"] if isinstance(leaf, Mapping) else {}
    virtual = [Fraction(x) for x in (leaf["virtual_motion"] if isinstance(leaf, Mapping) else leaf)]
    works = [[dot(virtual, wrench) * g[0] for g in region]]
    for i, touch in enumerate(oracle.asked(grasp, wrench).touches):
        work = _contact_work(touch, virtual, region, states.get(i, ""), given.get(str(i)))
        if work is None:
            return False
        works.append(work)
    totals = [sum(column, Fraction(0)) for column in zip(*works, strict=True)]
    return all(t > 0 or (t == 0 and g[0] == 0) for t, g in zip(totals, region, strict=True))


def _contact_work(
    touch: Touch, virtual: Vector, region: list[Vector], state: str, given: Any
) -> Vector | None:
    """Return the least work of a contact as the leaf bounds it, or None for a false bound."""
    spring, slip = zip(*(spring_and_slip(touch, g) for g in region), strict=True)
    directions = {"slip+": (1,), "slip-": (-1,)}.get(state, (1, -1))
    if state in ("", "attached"):
        directions = (1,) if min(slip) > 0 else (-1,) if max(slip) < 0 else (1, -1)
    kappa = min(_work(touch, virtual, sign) for sign in directions)
    if given is not None:
        alpha, h = ([Fraction(x) for x in given] + [Fraction(0)])[:2]
        fits = {
            "": 0 <= alpha <= kappa and h == 0,
            "detached": alpha >= 0 and h == 0,
            "attached": alpha <= kappa and h == 0,
            "stick": alpha <= kappa,
            "slip+": alpha <= kappa and h <= 0,
            "slip-": alpha <= kappa and h >= 0,
        }
        return (
            [alpha * e + h * s for e, s in zip(spring, slip, strict=True)] if fits[state] else None
        )
    if state == "detached":
        return [Fraction(0)] * len(region)
    if all(e >= 0 for e in spring):
        return [kappa * e for e in spring]
    return [min(kappa, Fraction(0)) * max(e, Fraction(0)) for e in spring]


def spring_and_slip(touch: Touch, g: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
    """Return the spring force (below 0 when detached) and the slip of a motion (d_0, d)."""
    scale, *motion = g
    spring = touch.preload * scale - touch.stiffness * dot(touch.normal, motion)
    return spring, dot(touch.tangential, motion)


def work_at_motion(
    grasp: Grasp, wrench: Sequence[Fraction], virtual: Vector, motion: Vector
) -> Fraction:
    """Return the least work on a virtual motion that load and contacts can do at a motion.

    Above 0 means that no forces which the law allows at this motion balance the load.
    """
    touches = oracle.asked(grasp, wrench).touches
    return dot(virtual, wrench) + sum(least_work(touch, virtual, motion) for touch in touches)


def least_work(touch: Touch, virtual: Sequence[Fraction], motion: Sequence[Fraction]) -> Fraction:
    """Return the least work of one contact."""
    spring, slip = spring_and_slip(touch, [Fraction(1), *motion])
    signs = (1,) if slip > 0 else (-1,) if slip < 0 else (1, -1)
    return max(spring, Fraction(0)) * min(_work(touch, virtual, sign) for sign in signs)


def _work(touch: Touch, virtual: Sequence[Fraction], sign: int) -> Fraction:
    """Return the work of a unit normal force with its friction, slipping to a side."""
    return dot(touch.normal, virtual) - sign * touch.friction * dot(touch.tangential, virtual)
