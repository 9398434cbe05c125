"""What the leaves of a proof say, in the plane and in space.

The numbers are those of the rows of `equilibrium.certificate.checker`, which decides; this module
reads trees that it has accepted.

This reads trees that `equilibrium.certificate.checker` has accepted.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise, product
from typing import Any, NamedTuple

from arrangement.numbers.exact import IntegerVector, RationalVector, dot, vector_text
from equilibrium.model.grasp import Grasp
from equilibrium.model.range import NO_RANGE, Range

from .law import frame, range_work
from .reading import STATES, Leaf, read_node, read_plane

#: Generators of all homogeneous motions (d_0, x, y, r).
_AXES = tuple(
    tuple(sign * (j == axis) for j in range(4))
    for axis, sign in ((0, 1), *product((1, 2, 3), (1, -1)))
)


class ClosedPart(NamedTuple):
    """A part of the motions, closed by a leaf.

    Attributes:
        region: generators of its cone: four, or the seven of the half space.
        states: those of the contacts that are decided there.
    """

    region: tuple[IntegerVector, ...]
    states: Mapping[int, str]
    leaf: Leaf


class Works(NamedTuple):
    """What is done on the virtual motion of parts.

    Attributes:
        load: the work of the load.
        factors: for each contact its least work, as a factor of its normal force; None where it has
            no force.
        least: all contacts and the bounds of a range work at least that much; ``load + least > 0``.
    """

    load: Fraction
    factors: list[Fraction | None]
    least: Fraction


def parts(document: Mapping[str, Any]) -> Iterator[ClosedPart]:
    """Yield the parts of a valid certificate "not resisted", in the order of the document."""
    contacts = len(document["grasp"]["contacts"])
    waiting: list[tuple[Any, tuple[IntegerVector, ...], dict[int, str]]]
    waiting = [(document["tree"], _AXES, {})]
    while waiting:
        content, region, states = waiting.pop()
        node = read_node(content, "tree", contacts)
        if isinstance(node, Leaf):
            yield ClosedPart(region, states, node)
            continue
        if node.kind in STATES:
            cut = [(region, {**states, node.at[0]: name}) for name in STATES[node.kind]]
        elif node.kind == "edge":
            j, k, p, q = node.at
            sums = [p * x + q * y for x, y in zip(region[j], region[k], strict=True)]
            middle = tuple(x // math.gcd(*sums) for x in sums)
            cut = [((*region[:i], middle, *region[i + 1 :]), states) for i in (j, k)]
        else:
            corners = product(region[1:3], region[3:5], region[5:7])
            cut = [((region[0], *corner), states) for corner in corners]
        children = [child for _, child in node.children]
        waiting += [(child, *one) for child, one in zip(children, cut, strict=True)][::-1]


def works(
    grasp: Grasp, wrench: RationalVector, together: Sequence[ClosedPart], within: Range = NO_RANGE
) -> Works:
    """Return the works on the virtual motion of one part, or of several that share it."""
    each = [_works(grasp, wrench, part, within) for part in together]
    factors = [
        min((factor for factor in some if factor is not None), default=None)
        for some in zip(*(done.factors for done in each), strict=True)
    ]
    return Works(each[0].load, factors, min(done.least for done in each))


def _works(grasp: Grasp, wrench: RationalVector, part: ClosedPart, within: Range) -> Works:
    region, states, leaf = part
    load, factors = Fraction(dot(wrench, leaf.motion)), []
    u, (_, taken) = sum(leaf.turn[1:]), range_work(within, leaf.turn, leaf.forces)
    work = [(load - taken) * g[0] + u * g[3] for g in region]
    for i, contact in enumerate(grasp):
        normal, tangent = frame(contact)
        e = [contact.preload * g[0] - contact.stiffness * dot(normal, g[1:]) for g in region]
        s = [dot(tangent, g[1:]) for g in region]
        state, kappa = states.get(i), dot(leaf.motion, normal)
        rub = contact.friction * dot(leaf.motion, tangent)
        free = state in (None, "attached")
        way = (state == "slip+" or (free and min(s) > 0)) - (
            state == "slip-" or (free and max(s) < 0)
        )
        kappa += leaf.forces.get(i, 0) - (way * rub if way else abs(rub))
        idle = state == "detached" or (state is None and max(e) <= 0)
        factors.append(None if idle else kappa)
        row: Sequence[Any] = [0] * len(region)
        if i in leaf.multipliers:
            alpha, h = leaf.multipliers[i]
            row = [alpha * x + h * y for x, y in zip(e, s, strict=True)]
        elif not idle and (state or min(e) >= 0):
            row = [kappa * x for x in e]
        elif not idle and kappa < 0:
            row = [kappa * max(0, x) for x in e]
        work = [w + x for w, x in zip(work, row, strict=True)]
    least = min(w / g[0] for w, g in zip(work, region, strict=True) if g[0]) - load
    return Works(load, factors, least)


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
            pairs = [
                (f"slips between {vector_text(u)} and {vector_text(v)}", (u, v))
                for u, v in pairwise(around)
            ]
            parts = [*([] if cut else [("sticks", ())]), *pairs]
        found = [
            (child, {**states, i: words}, {**sectors, i: sector})
            for child, (words, sector) in zip(children, parts, strict=True)
        ]
        waiting += reversed(found)
