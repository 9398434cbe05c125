"""Leaves of a proof that nothing balances a load, each tested afresh in fractions.

This is the second route of the claims on proofs; it shares no code with the checker. On a cone the
spring force ``max(0, e)`` of a contact is at most its interpolation between the generators, and no
less where e keeps its sign; so the least work at the generators bounds that in between. Trees
that distinguish states are refused.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import product
from typing import Any

from .oracle import Question, Row, Touch, dot

Region = list[Row]


def leaf_count(question: Question, tree: Any) -> int:
    """Return the number of leaves of a tree.

    Raises:
        ValueError: a leaf does not hold, or a node splits states.
    """
    leaves = list(_leaves(tree, []))
    for motion, region in leaves:
        if not _holds(question, motion, region):
            raise ValueError(f"the virtual motion {motion} does not close its region")
    return len(leaves)


def _leaves(node: Any, region: Region) -> Iterator[tuple[Row, Region]]:
    """Yield every virtual motion with the generators (d_0, d) of its region."""
    if isinstance(node, list):
        axes = [_axis(0, 1), *(_axis(j, sign) for j in (1, 2, 3) for sign in (1, -1))]
        yield tuple(map(Fraction, node)), region or axes
    elif isinstance(node, Mapping) and "orthants" in node and not region:
        for child, signs in zip(node["orthants"], product((1, -1), repeat=3), strict=True):
            yield from _leaves(child, [_axis(0, 1), *map(_axis, (1, 2, 3), signs)])
    elif isinstance(node, Mapping) and "edge" in node and len(region) == 4:
        (j, k), (p, q) = node["edge"], map(Fraction, node.get("at", "11"))
        cut = tuple(p * x + q * y for x, y in zip(region[j], region[k], strict=True))
        if min(p, q) <= 0 or j == k:
            raise ValueError("an edge is cut between its ends")
        scale = math.gcd(*(x.numerator for x in cut))
        for child, old in zip(node["children"], (j, k), strict=True):
            part = [*region]
            part[old] = tuple(x / scale for x in cut)
            yield from _leaves(child, part)
    else:
        raise ValueError("the tree does not cut regions alone")


def _axis(j: int, sign: int) -> Row:
    return tuple(Fraction(sign * (i == j)) for i in range(4))


def _holds(question: Question, motion: Row, region: Region) -> bool:
    """Whether load and contacts together do work at every generator, whatever contacts do."""
    works = [g[0] * dot(motion, question.wrench) for g in region]
    for touch in question.touches:
        works = [x + y for x, y in zip(works, _least(touch, motion, region), strict=True)]
    return all(x > 0 or (not x and not g[0]) for x, g in zip(works, region, strict=True))


def _least(touch: Touch, motion: Row, region: Region) -> list[Fraction]:
    """Return at each generator a bound from below of the contact's work, convex in between."""
    springs = [touch.preload * g[0] - touch.stiffness * dot(touch.normal, g[1:]) for g in region]
    slips = [dot(touch.tangential, g[1:]) for g in region]
    ways = [s for s in (1, -1) if not all(s * x < 0 for x in slips)]
    along, across = dot(motion, touch.normal), touch.friction * dot(motion, touch.tangential)
    unit = min(along - s * across for s in ways)
    if unit > 0 and min(springs) < 0:
        return [Fraction(0)] * len(region)
    return [unit * max(Fraction(0), e) for e in springs]
