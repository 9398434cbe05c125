"""What the leaves of a proof in space say, for people and for other loads.

This reads trees that `equilibrium.certificate.checker` has accepted.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple

from arrangement.exact import RationalVector, vector_text
from equilibrium.model.grasp import Grasp
from equilibrium.model.range import NO_RANGE, Range

from .law import range_work
from .reading import STATES, Leaf, read_node, read_plane


class SpatialLeaf(NamedTuple):
    """A leaf of a tree.

    Attributes:
        states: by contact, counted from 0, what is assumed of it, in words.
        motion: the virtual motion.
        least: contacts do at least that much work on it, whatever they do; ``sum alpha q``, less
            what bounds of the range take. The tree refutes a load w if ``motion . w + least > 0``
            for all leaves.
    """

    states: Mapping[int, str]
    motion: RationalVector
    least: Fraction


def spatial_leaves(grasp: Grasp, tree: Any, within: Range = NO_RANGE) -> Iterator[SpatialLeaf]:
    """Yield the leaves of a tree in the order of the document; none of one in the plane."""
    if read_plane(tree):
        return
    waiting: list[tuple[Any, dict[int, str], dict[int, tuple[RationalVector, ...]]]]
    waiting = [(tree, {}, {})]
    while waiting:
        content, states, sectors = waiting.pop()
        node = read_node(content, "tree", len(grasp), 3)
        if isinstance(node, Leaf):
            works = (row[0] * grasp.contacts[i].preload for i, row in node.multipliers.items())
            _, taken = range_work(within, node.turn, node.forces)
            yield SpatialLeaf(states, node.motion, sum(works, -taken))
            continue
        (i,), children = node.at, [child for _, child in node.children]
        parts: list[tuple[str, tuple[RationalVector, ...]]]
        if node.kind == "attachment":
            parts = [(name, ()) for name in STATES[node.kind]]
        elif node.kind == "faces":
            parts = [("sticks", ()), *((f"slips (part {j})", ()) for j in range(1, len(children)))]
        else:
            cut = sectors.get(i, ())
            around = [*cut[:1], *node.directions, *(cut[1:] or node.directions[:1])]
            pairs = [(f"slips between {vector_text(u)} and {vector_text(v)}", (u, v))
                     for u, v in pairwise(around)]  # fmt: skip
            parts = [*([] if cut else [("sticks", ())]), *pairs]
        found = [
            (child, {**states, i: words}, {**sectors, i: sector})
            for child, (words, sector) in zip(children, parts, strict=True)
        ]
        waiting += reversed(found)
