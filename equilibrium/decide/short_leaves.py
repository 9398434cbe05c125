"""Shorter numbers for the leaves of a planar proof, where the checker accepts them.

Farkas multipliers of an exact program are at a corner of their conditions and have long numbers.
Most leaves have room: the virtual motion rounded, alone or with its multipliers, is a leaf, too.
"""

from __future__ import annotations

from fractions import Fraction

from arrangement.numbers.exact import RationalVector
from equilibrium.certificate.leaf_rule import TreeQuestion
from equilibrium.certificate.reading import Place
from equilibrium.certificate.tree import placed_leaves
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Leaf, Tree, leaves_of, with_leaves

#: Numbers from this size on are rounded, to these shares of the largest one of a leaf.
_LONG = 10**12
_SHARES = (10**3, 10**5, 10**7, 10**9, 10**11)


def with_short_leaves(
    tree: Tree, grasp: Grasp, load: RationalVector, max_displacement: Fraction | None
) -> Tree:
    """Return a proof about a grasp in the plane with shorter numbers in leaves, where they do."""
    if not any(map(_is_long, leaves_of(tree))):
        return tree
    question = TreeQuestion.of(grasp, load, max_displacement=max_displacement)
    placed = placed_leaves(tree, question)
    shorter = {id(leaf): _shorter(leaf, place, question) for leaf, place in placed}
    changed: Tree = with_leaves(tree, lambda leaf: shorter[id(leaf)])
    return changed


def _is_long(leaf: Leaf) -> bool:
    return any(abs(x) >= _LONG for x in leaf.numbers)


def _shorter(leaf: Leaf, place: Place, question: TreeQuestion) -> Leaf:
    """Return a shorter leaf; the same if there is none, or it is short."""
    if leaf.displacements or not _is_long(leaf):
        return leaf
    size = max(map(abs, leaf.numbers))
    for share in _SHARES:
        rounded = leaf.with_numbers(round(Fraction(x) * share / size) for x in leaf.numbers)
        alone = Leaf(rounded.motion, {})
        factors = question.leaf_work(alone, place.region, place.states).factors
        rows = {}
        for i, (alpha, *h) in rounded.multipliers.items():
            # Rounding must not lift alpha above what the contact does.
            pair = factors[i]
            rows[i] = (alpha if pair is None else min(alpha, int(pair[0] // pair[1])), *h)
        for short in (alone, Leaf(alone.motion, rows)):
            if any(alone.motion) and not question.leaf_problem(short, place):
                return short.primitive()
    return leaf
