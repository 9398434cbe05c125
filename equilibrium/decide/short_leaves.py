"""Shorter numbers for the leaves of a planar proof, where the checker accepts them.

Farkas multipliers of an exact program are at a corner of their conditions and have long numbers.
Most leaves have room: the virtual motion rounded, alone or with its multipliers, is a leaf, too.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import chain
from typing import Any

from arrangement.numbers.exact import RationalVector, primitive, to_text
from equilibrium.certificate.leaf_rule import TreeQuestion
from equilibrium.certificate.reading import STATES, Place
from equilibrium.certificate.tree import placed_leaves
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Leaf, Tree

#: Longer numbers are rounded, to these shares of the largest one of a leaf.
_LONG = re.compile("[0-9]{13}")
_SHARES = (10**3, 10**5, 10**7, 10**9, 10**11)


def with_short_leaves(
    tree: Tree, grasp: Grasp, load: RationalVector, max_displacement: Fraction | None
) -> Tree:
    """Return a proof about a grasp in the plane with shorter numbers in leaves, where they do."""
    if not _is_long(tree):
        return tree
    question = TreeQuestion.of(grasp, load, max_displacement=max_displacement)
    leaves = (_shorter(leaf, place, question) for leaf, place in placed_leaves(tree, question))
    shorter: Tree = _replaced(tree, leaves)
    return shorter


def _is_long(node: Any) -> bool:
    if isinstance(node, (Mapping, list)):
        return any(map(_is_long, node.values() if isinstance(node, Mapping) else node))
    return isinstance(node, str) and _LONG.search(node) is not None


def _shorter(leaf: Leaf, place: Place, question: TreeQuestion) -> Any:
    """Return the form of a shorter leaf; None if there is none, or it is short."""
    rows = [leaf.motion, *leaf.multipliers.values()]
    if leaf.displacements or not _is_long([to_text(x) for row in rows for x in row]):
        return None
    size = max(abs(x) for row in rows for x in row)
    for share in _SHARES:
        motion, *multipliers = [[round(x * share / size) for x in row] for row in rows]
        alone = Leaf(_whole(motion), {})
        factors = question.leaf_work(alone, place.region, place.states).factors
        given = {}
        for i, (alpha, *h) in zip(leaf.multipliers, multipliers, strict=True):
            # Rounding must not lift alpha above what the contact does.
            pair = factors[i]
            given[i] = [alpha if pair is None else min(alpha, int(pair[0] // pair[1])), *h]
        for short in (alone, Leaf(alone.motion, {i: _whole(x) for i, x in given.items()})):
            if any(motion) and not question.leaf_problem(short, place):
                return _form(short)
    return None


def _form(leaf: Leaf) -> Any:
    """Return a leaf as certificates write it."""
    rows = [leaf.motion, *leaf.multipliers.values()]
    texts = iter(map(to_text, primitive(list(chain(*rows)))))
    motion, *multipliers = [[next(texts) for _ in row] for row in rows]
    if not multipliers:
        return motion
    listed = zip(map(str, leaf.multipliers), multipliers, strict=True)
    return {"virtual_motion": motion, "multipliers": dict(listed)}


def _whole(row: list[int]) -> RationalVector:
    return tuple(map(Fraction, row))


def _replaced(node: Any, leaves: Iterator[Any]) -> Any:
    """Return a tree with other leaves, in its order; None keeps one."""
    if isinstance(node, list) or "virtual_motion" in node:
        return next(leaves) or node
    if "orthants" in node:
        return {"orthants": [_replaced(child, leaves) for child in node["orthants"]]}
    if "edge" in node:
        return {**node, "children": [_replaced(child, leaves) for child in node["children"]]}
    kind = next(kind for kind in STATES if kind in node)
    children = {state: _replaced(node[kind][state], leaves) for state in STATES[kind]}
    return {**node, kind: children}
